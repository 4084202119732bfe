//! A second model, defined here and nowhere in the program: a peridynamic bar under axial load.
//!
//! Its energy is `Σ ½ α EA/ξ (u_j − u_i)²`: one unknown per point, one measure per bond. It says that in [`AxialBond`]
//! and gets operator, assembly, constraints, reactions and free motions from the program; the end correction and the
//! weights are those of any chain.

use super::consistency::{Noise, check};
use peristat_assembly::bonds::{BondGeometry, BondModel, Point, Rows};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Chain, Line, VolumeFactor, bond_law, end_treatment,
};
use peristat_assembly::model::{Component, Model, Points, RigidMotion};
use peristat_assembly::stiffness::{Lattice, LatticeBonds, Override, Spring, Springs, Term, Weights};
use peristat_assembly::system::{System, free_motions};
use peristat_solve::{BandCholesky, BandMatrix, Preconditioner};
use proptest::prelude::*;

/// A bond that resists its elongation.
#[derive(Clone)]
struct AxialBond {
    /// EA, N.
    stiffness: f64,
}

impl BondModel<1, 1> for AxialBond {
    const DIFFERENCE: [[bool; 1]; 1] = [[true]];
    const MEAN: [[bool; 1]; 1] = [[false]];

    fn rows(&self, _: &BondGeometry) -> Rows<1, 1> {
        Rows { difference: [[1.0]], mean: [[0.0]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        [self.stiffness / bond.length()]
    }
}

/// A straight bar of length 1.
struct AxialBar {
    chain: Chain,
    bonds: LatticeBonds<1, 1, AxialBond>,
}

impl AxialBar {
    /// A bar of some cells and horizon ratio with EA = `stiffness`. `factors` may weaken bonds.
    fn new(cells: usize, horizon_ratio: f64, stiffness: f64, factors: &[Override]) -> Self {
        let section = SectionStiffness::uniform(1.0, 1.0, stiffness, 1.0);
        let parameters = BeamParameters {
            volume_factor: VolumeFactor::HalfEdge,
            bond_law: bond_law::find("exact").expect("the law exists"),
            end_treatment: end_treatment::find("cover").expect("the treatment exists"),
        };
        let line = Line { horizon_ratio, ..Line::new(1.0, cells, section) };
        let chain = Chain::new(line, &parameters).expect("a chain");
        let own = &chain.weights;
        let classes: Vec<(usize, f64)> = (0..own.classes()).map(|c| (own.step(c), own.of_class(c))).collect();
        let exception = |class: usize, lower: usize| Override {
            class,
            lower,
            factor: own.weight(class, lower) / own.of_class(class),
        };
        let pairs = (0..own.classes()).flat_map(|class| (0..=cells).map(move |lower| (class, lower)));
        let mut overrides: Vec<Override> = pairs.map(|(class, lower)| exception(class, lower)).collect();
        overrides.extend(factors);
        let geometry =
            |&(step, _): &(usize, f64)| BondGeometry { xi: [step as f64 * chain.spacing, 0.0, 0.0] };
        let geometries: Vec<BondGeometry> = classes.iter().map(geometry).collect();
        let lattice = Lattice { points: cells + 1, first: 0, count: cells + 1 };
        let weights = Weights::new(cells + 1, classes, &overrides);
        let bonds = LatticeBonds::new(lattice, &AxialBond { stiffness }, &geometries, weights);
        Self { chain, bonds }
    }
}

impl Points for AxialBar {
    fn points(&self) -> usize {
        self.chain.points
    }

    fn position(&self, point: usize) -> Point {
        [self.chain.position(point), 0.0, 0.0]
    }

    fn components(&self) -> &[Component] {
        const { &[Component::displacement("u", 0)] }
    }
}

impl Model<1> for AxialBar {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        const { &[RigidMotion::translation("translation along x", "")] }
    }

    fn terms(&self) -> Vec<Box<dyn Term<1>>> {
        vec![Box::new(self.bonds.clone())]
    }

    fn relations(&self) -> Vec<Equation> {
        Vec::new()
    }

    fn rigid_motion(&self, _: usize, _: usize, _: Point) -> [f64; 1] {
        [1.0]
    }
}

fn prescribe(point: usize, value: f64) -> Equation {
    Equation { terms: vec![(Unknown { component: 0, point }, 1.0)], value, origin: format!("point {point}") }
}

/// Displacements under nodal loads, and the forces that the constraints then exert.
fn solve(system: &System<1>, load: &[f64]) -> [Vec<f64>; 2] {
    let (half_bandwidth, values) = system.assemble_band();
    let order = system.size();
    let matrix = BandMatrix { order, half_bandwidth, values };
    let mut factor = BandCholesky::factor(matrix, 1).expect("positive definite");
    let (mut u, mut force) = (vec![0.0; order], vec![0.0; order]);
    system.constraints().expand(1.0, &mut u);
    let mut correction = vec![0.0; order];
    for _ in 0..3 {
        system.force(&u, &mut force);
        let mut residual: Vec<f64> = load.iter().zip(&force).map(|(l, f)| l - f).collect();
        system.constraints().restrict(&mut residual);
        factor.apply(&residual, &mut correction);
        u.iter_mut().zip(&correction).for_each(|(u, d)| *u += d);
    }
    system.force(&u, &mut force);
    let held = force.iter().zip(load).map(|(f, l)| f - l).collect();
    [u, held]
}

#[test]
fn a_bar_under_an_end_force_stretches_as_hooke_says() {
    for horizon_ratio in [1.0, 2.0, 3.0, 3.015, 6.0] {
        let bar = AxialBar::new(90, horizon_ratio, 7.0, &[]);
        let system = System::new(&bar, Vec::new(), vec![prescribe(0, 0.01)]).expect("no contradiction");
        let mut load = vec![0.0; 91];
        load[90] = 0.5;
        let [u, held] = solve(&system, &load);
        for (point, u) in u.iter().enumerate() {
            let expected = 0.01 + 0.5 * point as f64 / 90.0 / 7.0;
            // Measured 1e-15.
            assert!((u - expected).abs() <= 1e-13, "m = {horizon_ratio}, point {point}: {u} for {expected}");
        }
        assert!((held[0] + 0.5).abs() <= 1e-12, "the reaction is {}", held[0]);
    }
}

#[test]
fn a_loose_bar_is_reported_with_its_motion() {
    let bar = AxialBar::new(10, 3.0, 1.0, &[]);
    let loose = System::new(&bar, Vec::new(), Vec::new()).expect("no contradiction");
    let motions = free_motions(&bar, &loose);
    assert_eq!(motions.len(), 1);
    assert_eq!(motions[0].parts, vec![[0, 10]]);
    assert_eq!(motions[0].moves[0].amounts, [1.0]);
    let held = System::new(&bar, Vec::new(), vec![prescribe(4, 0.0)]).expect("no contradiction");
    assert!(free_motions(&bar, &held).is_empty());
}

proptest! {
    #![proptest_config(super::cases(60))]

    #[test]
    fn a_bar_is_consistent_intact_and_damaged(
        cells in 1_usize..200, ratio in 1.0..7.0_f64, broken in 0_usize..40, spring in any::<bool>(), seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let reach = AxialBar::new(cells, ratio, 1.0, &[]).chain.weights.classes();
        let factors: Vec<Override> = (0..broken)
            .map(|_| Override {
                class: noise.index(reach),
                lower: noise.index(cells + 1),
                factor: noise.next().max(0.0),
            })
            .collect();
        let bar = AxialBar::new(cells, ratio, 3.0, &factors);
        let extra = || -> Vec<Box<dyn Term<1>>> {
            let spring_at = Spring::on(0, cells / 2, 0.3);
            if spring { vec![Box::new(Springs::new(cells + 1, vec![spring_at]))] } else { Vec::new() }
        };
        check(&bar, &extra, seed);
    }
}
