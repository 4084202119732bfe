//! The beam passes the checks of every model: all laws, end treatments and grids, intact and with random factors.

use super::consistency::{Noise, check};
use peristat_assembly::bonds::{BondGeometry, Point};
use peristat_assembly::condition::Equation;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::end_treatment::EndSupport;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Grid, Line, TimoshenkoBeam, UniformBending, UniformSection, VolumeFactor, bond_law,
    end_treatment,
};
use peristat_assembly::model::{Breakable, Component, Model, Points, RigidMotion};
use peristat_assembly::stiffness::{Lattice, LatticeBonds, Override, Spring, Springs, Term, Weights};
use proptest::prelude::*;

fn parameters(law: usize, treatment: usize) -> BeamParameters {
    BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: &bond_law::TABLE[law % bond_law::TABLE.len()],
        end_treatment: &end_treatment::TABLE[treatment % end_treatment::TABLE.len()],
    }
}

/// Lattices of beam bonds on the same points, whose factors a test chooses.
struct Damaged(usize, Vec<LatticeBonds<2, 2, UniformBending>>);

impl Points for Damaged {
    fn points(&self) -> usize {
        self.0
    }

    fn position(&self, point: usize) -> Point {
        [0.1 * point as f64, 0.0, 0.0]
    }

    fn components(&self) -> &[Component] {
        const { &[Component::displacement("w", 1), Component::rotation("phi", 1.0)] }
    }
}

impl Model<2> for Damaged {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        const { &[RigidMotion::translation("translation along w", ""), RigidMotion::rotation("rotation", "")] }
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        self.1.iter().map(|bonds| Box::new(bonds.clone()) as Box<dyn Term<2>>).collect()
    }

    fn relations(&self) -> Vec<Equation> {
        Vec::new()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        [[1.0, 0.0], [self.position(point)[0] - centre[0], 1.0]][kind]
    }
}

/// A lattice that starts at point `first` of a larger body.
fn damaged(law: usize, first: usize, count: usize, weights: &[f64], factors: &[Override]) -> Damaged {
    let section = UniformSection {
        bending_stiffness: 2.0,
        shear_stiffness: 300.0,
        axial_stiffness: 1.0,
        law: &bond_law::TABLE[law % bond_law::TABLE.len()],
    };
    let model = UniformBending { section, mean_square_length: 0.03 };
    let geometry = |k: usize| BondGeometry { xi: [0.1 * k as f64, 0.0, 0.0] };
    let geometries: Vec<_> = (1..=weights.len()).map(geometry).collect();
    let classes = weights.iter().enumerate().map(|(k, &weight)| (k + 1, weight)).collect();
    let points = first + count + 2;
    let lattice = Lattice { points, first, count };
    let weights = Weights::new(count, classes, factors);
    Damaged(points, vec![LatticeBonds::new(lattice, &model, &geometries, weights)])
}

proptest! {
    #![proptest_config(super::cases(100))]

    #[test]
    fn a_beam_is_consistent_for_every_law_and_treatment(
        law in 0_usize..3, treatment in 0_usize..4, cells in 8_usize..140, ratio in 1.0..6.0_f64,
        on_cells in any::<bool>(), held in prop::array::uniform2(0_usize..4), split in 1_usize..139,
        spring in any::<bool>(), broken in 0_usize..30, seed in any::<u64>()
    ) {
        let parameters = parameters(law, treatment);
        let splits = if parameters.end_treatment.splits { vec![split.min(cells - 1)] } else { Vec::new() };
        let on_cells = on_cells && !parameters.end_treatment.covers();
        let supports = held.map(|h| EndSupport {
            w: (h % 2 == 1).then_some(0.0),
            phi: (h / 2 == 1).then_some(0.0),
        });
        let ratio = if seed % 2 == 0 { ratio.round() } else { ratio };
        let stiffness = SectionStiffness::uniform(2.0, 300.0, 50.0, 1.0);
        let line = |from: f64| Line {
            from,
            grid: if on_cells { Grid::Cells } else { Grid::Nodes },
            horizon_ratio: ratio,
            splits: splits.clone(),
            supports,
            ..Line::new(0.1 * cells as f64, cells, stiffness.clone())
        };
        // A second, shorter line makes the lattice of the first one a part of the body.
        let second = Line { cells: 8, length: 0.8, splits: Vec::new(), ..line(100.0) };
        let beam = TimoshenkoBeam::new(parameters, vec![line(0.0), second]);
        prop_assume!(beam.is_ok());
        let mut beam = beam.expect("assumed");
        // Bonds with images do not break.
        if beam.chains().iter().all(|c| c.ghosts == [0; 2]) {
            let (mut noise, numbers) = (Noise(seed), Breakable::<2>::bond_numbers(&beam) as usize);
            let bonds: Vec<u64> = (0..broken).map(|_| noise.index(numbers) as u64).collect();
            Breakable::<2>::break_bonds(&mut beam, &bonds);
        }
        let extra = || -> Vec<Box<dyn Term<2>>> {
            // The last one resists a sum of both unknowns.
            let between = Spring { point: 3, shares: [(0, 0.6), (1, -0.8)], stiffness: 1.0 };
            let springs = vec![Spring::on(0, 3, 20.0), Spring::on(1, cells / 2, 5.0), between];
            if spring { vec![Box::new(Springs::new(beam.points(), springs))] } else { Vec::new() }
        };
        check::<2, _>(&beam, &extra, seed);
    }

    #[test]
    fn random_factors_keep_a_lattice_consistent(
        law in 0_usize..3, first in 0_usize..5, count in 1_usize..200, reach in 1_usize..7,
        changed in 0_usize..60, twice in any::<bool>(), seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let weights: Vec<f64> = (0..reach).map(|_| 0.1 + noise.next().abs()).collect();
        let factors: Vec<Override> = (0..changed)
            .map(|_| Override {
                class: noise.index(reach),
                lower: noise.index(count),
                factor: 2.0 * noise.next().max(0.0),
            })
            .collect();
        let mut body = damaged(law, first, count, &weights, &factors);
        if twice {
            body.1.extend(damaged(law + 1, first, count, &weights[..1], &[]).1);
        }
        check(&body, &Vec::new, seed);
    }
}

#[test]
fn factors_are_stored_for_the_chunks_that_need_them_only() {
    let weights = [0.4, 0.3, 0.2];
    let stored = |factors: &[Override]| {
        let terms = damaged(0, 0, 10_000, &weights, factors).terms();
        terms.iter().map(|t| t.stored_factors()).sum::<usize>()
    };
    let broken = |lower| Override { class: 1, lower, factor: 0.0 };
    assert_eq!(stored(&[]), 0);
    // Two chunks of 64 points and three classes.
    assert_eq!(stored(&[broken(5), broken(7), broken(5_000)]), 2 * 64 * 3);
}
