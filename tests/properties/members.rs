//! Members that vary: graded grids, varying and coupled sections, any direction, with and without axial unknowns.

use super::consistency::{Noise, check};
use super::loose::costs_nothing;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::material::{Profile, SectionStiffness};
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{
    Axial, BeamParameters, Line, PHI, TimoshenkoBeam, U, VolumeFactor, W, bond_law, end_treatment,
};
use peristat_assembly::stiffness::{Spring, Springs, Term};
use peristat_assembly::system::{System, free_motions};
use proptest::prelude::*;

fn parameters() -> BeamParameters {
    BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find("exact").expect("the law exists"),
        end_treatment: end_treatment::find("cover").expect("the treatment exists"),
    }
}

/// A member whose stiffness varies by `taper` along it and couples by a share of the largest coupling.
fn member(cells: usize, angle: f64, taper: f64, coupling: f64, graded: bool, noise: &mut Noise) -> Line {
    let length = 1.0 + noise.next().abs();
    let linear = |value: f64| Profile::Polynomial(vec![value, taper * value / length]);
    let (bending, axial) = (2.0, 50.0);
    let stiffness = SectionStiffness {
        bending: linear(bending),
        shear: linear(300.0),
        axial: linear(axial),
        coupling: linear(coupling * f64::sqrt(bending * axial)),
        area: 1.0,
    };
    let mut widths: Vec<f64> = (0..cells).map(|_| 1.0 + 0.9 * noise.next()).collect();
    let sum: f64 = widths.iter().sum();
    widths.iter_mut().for_each(|w| *w *= length / sum);
    let mut stations = vec![0.0];
    widths.iter().for_each(|w| stations.push(stations.last().expect("the start") + w));
    stations[cells] = length;
    Line {
        origin: [noise.next(), noise.next()],
        direction: [angle.cos(), angle.sin()],
        stations: graded.then_some(stations),
        ..Line::new(length, cells, stiffness)
    }
}

proptest! {
    #![proptest_config(super::cases(60))]

    #[test]
    fn members_are_consistent_with_two_and_three_unknowns(
        cells in 2_usize..40, angle in -3.1..3.1_f64, taper in -0.6..2.0_f64, coupling in -0.6..0.6_f64,
        graded in any::<bool>(), points in any::<bool>(), plain in 0_usize..3, split in 1_usize..39, seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let (taper, coupling) = match plain {
            0 => (0.0, 0.0),
            1 => (taper, 0.0),
            _ => (taper, coupling),
        };
        let mut first = member(cells, angle, taper, coupling, graded, &mut noise);
        first.axial = if points { Axial::Points } else { Axial::Ends };
        first.splits = if split < cells { vec![split] } else { Vec::new() };
        let second = member(7, 0.3, 0.0, 0.0, false, &mut noise);
        let flat = |line: &Line| Line { direction: [1.0, 0.0], ..line.clone() };
        let plane = TimoshenkoBeam::new(parameters(), vec![first.clone(), second.clone()]).expect("members");
        check::<3, _>(&plane, &Vec::new, seed);
        if coupling == 0.0 {
            let straight = TimoshenkoBeam::new(parameters(), vec![flat(&first), flat(&second)]).expect("members");
            check::<2, _>(&straight, &Vec::new, seed);
        }
    }

    #[test]
    fn bonds_of_a_varying_member_are_the_member_itself(
        cells in 3_usize..12, taper in -0.6..2.0_f64, coupling in -0.6..0.6_f64, seed in any::<u64>()
    ) {
        // Forces on the ends of a member do not depend on how many bonds span it.
        let mut noise = Noise(seed);
        let line = member(cells, 0.0, taper, coupling, true, &mut noise);
        let force = |ratio: f64, state: &[f64; 9]| {
            let line = Line { horizon_ratio: ratio, ..line.clone() };
            let beam = TimoshenkoBeam::new(parameters(), vec![line]).expect("a member");
            let system = System::<3>::new(&beam, Vec::new(), Vec::new()).expect("no contradiction");
            let n = beam.points();
            // The state of a member without loads: constant N and V.
            let u = loaded(&beam, state);
            let mut f = vec![0.0; 3 * n];
            system.force(&u, &mut f);
            f
        };
        let state: [f64; 9] = std::array::from_fn(|_| noise.next());
        let (one, many) = (force(1.0, &state), force(3.0, &state));
        let scale = one.iter().fold(0.0_f64, |a, f| a.max(f.abs()));
        for (a, b) in one.iter().zip(&many) {
            // Measured 9e-13.
            prop_assert!((a - b).abs() <= 1e-11 * scale, "{a} for {b}");
        }
    }
}

/// Displacements of a member that only its ends load: integrated with a hundred steps per cell would do, but the bonds of
/// horizon ratio one say it exactly.
fn loaded(beam: &TimoshenkoBeam, state: &[f64; 9]) -> Vec<f64> {
    let n = beam.points();
    let chain = &beam.chains()[0];
    let (normal, moment, shear) = (state[0], state[1], state[2]);
    let (mut w, mut phi, mut u) = (vec![state[3]], vec![state[4]], vec![state[5]]);
    let neighbours = Line { horizon_ratio: 1.0, ..chain.line().clone() };
    let cells = TimoshenkoBeam::new(parameters(), vec![neighbours]).expect("a member");
    for k in 0..n - 1 {
        let bond = cells.chains()[0].bonds.bond(0, k);
        let middle = 0.5 * (chain.position(k) + chain.position(k + 1));
        // Basic forces of the cell, and its deformation by the inverse of C = UᵀDU.
        let m = moment - shear * (middle - chain.position(0));
        let s = shear / bond.shear;
        let a = (normal - bond.shear_axial * shear) / bond.axial;
        let dphi = (m - bond.eccentricity * shear - bond.axial_bending * (a * bond.axial)) / bond.bending;
        let du = a - bond.axial_bending * dphi;
        let gamma = s - bond.eccentricity * dphi - bond.shear_axial * du;
        let last = phi[k];
        w.push(w[k] + gamma + bond.length * (last + 0.5 * dphi));
        phi.push(last + dphi);
        u.push(u[k] + du);
    }
    [w, phi, u].concat()
}

/// Two members at an angle, the second one from the end of the first.
#[test]
fn members_are_as_loose_as_statics_says() {
    let line = Line::new(2.0, 8, SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3));
    let second = Line { origin: [2.0, 0.0], direction: [0.6, 0.8], ..line.clone() };
    let frame = TimoshenkoBeam::new(parameters(), vec![line, second]).expect("a frame");
    let equation = |terms: &[(usize, usize, f64)]| Equation {
        terms: terms.iter().map(|&(component, point, c)| (Unknown { component, point }, c)).collect(),
        value: 0.0,
        origin: String::new(),
    };
    // Displacements along x and y: −s w + c u and c w + s u.
    let hinge = [
        equation(&[(U, 8, 1.0), (W, 9, 0.8), (U, 9, -0.6)]),
        equation(&[(W, 8, 1.0), (W, 9, -0.6), (U, 9, -0.8)]),
    ];
    let clamp = [W, PHI, U].map(|c| equation(&[(c, 0, 1.0)]));
    let roller = [equation(&[(W, 17, 0.6), (U, 17, 0.8)])];
    let count = |equations: &[&[Equation]], springs: Vec<Spring>| {
        let extra: Vec<Box<dyn Term<3>>> = vec![Box::new(Springs::new(18, springs))];
        let system = System::new(&frame, extra, equations.concat()).expect("no contradiction");
        let found = free_motions(&frame, &system);
        let parts = Model::<3>::connected(&frame);
        found
            .iter()
            .for_each(|m| costs_nothing(&frame, &system, &parts, m, system.constraints().equations()));
        found.len()
    };
    let turn = Spring::on(PHI, 12, 4.0);
    assert_eq!(count(&[], Vec::new()), 6);
    assert_eq!(count(&[], vec![turn]), 5);
    assert_eq!(count(&[&hinge], Vec::new()), 4);
    assert_eq!(count(&[&clamp], Vec::new()), 3);
    assert_eq!(count(&[&clamp, &hinge], Vec::new()), 1);
    assert_eq!(count(&[&clamp, &hinge], vec![turn]), 0);
    assert_eq!(count(&[&clamp, &hinge, &roller], Vec::new()), 0);
}
