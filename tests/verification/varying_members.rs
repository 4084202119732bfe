//! Members whose section varies and couples stretching with bending: nodal values and section forces are those of the
//! local beam, under loads of every kind, whatever the horizon.

use crate::support::error;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::material::{Profile, SectionStiffness};
use peristat_assembly::model::Points;
use peristat_assembly::model::timoshenko_beam::{
    Along, Axial, BeamLoads, BeamParameters, Distributed, Intensity, Line, PHI, PointAction, TimoshenkoBeam,
    U, VolumeFactor, W, bond_law, end_treatment,
};
use peristat_assembly::system::System;
use peristat_solve::{Ordering, Preconditioner, SparseCholesky};

const LENGTH: f64 = 1.4;
/// Where a concentrated load acts between two points.
const SPOT: f64 = 0.77;

fn stiffness() -> SectionStiffness {
    SectionStiffness {
        bending: Profile::Polynomial(vec![2.0, 1.0, 0.5]),
        shear: Profile::Table(vec![[0.0, 40.0], [0.5, 60.0], [0.5, 90.0], [LENGTH, 50.0]]),
        axial: Profile::Polynomial(vec![30.0, -8.0]),
        coupling: Profile::Polynomial(vec![2.0, 1.5]),
        area: 1.0,
    }
}

fn loads() -> BeamLoads {
    let along = |along, start, end, from, to| Distributed {
        chain: 0,
        from,
        to,
        intensity: Intensity::Linear { start, end },
        along,
    };
    let wave = Intensity::Sine { amplitude: 3.0, half_waves: 2 };
    BeamLoads {
        distributed: vec![
            along(Along::Transverse, 1.0, -2.0, 0.3, 1.1),
            along(Along::Axial, 4.0, 4.0, 0.0, LENGTH),
            along(Along::Rotation, 0.5, 0.5, 0.2, 0.9),
            Distributed { chain: 0, from: 0.0, to: LENGTH, intensity: wave, along: Along::Transverse },
        ],
        point: vec![
            PointAction { chain: 0, x: SPOT, force: 1.5, moment: -0.4, axial: 2.0, spread: true },
            PointAction { chain: 0, x: LENGTH, force: -0.7, moment: 0.3, axial: 5.0, spread: false },
        ],
        lumped: false,
    }
}

/// Section forces N, V, M of the member clamped at its start, by statics.
fn section_forces(x: f64) -> [f64; 3] {
    // ∫_x^L and ∫_x^L (s − x) of a load that is straight from a at `from` to b at `to`.
    let straight = |a: f64, b: f64, from: f64, to: f64| {
        let start = x.max(from).min(to);
        let (span, at) = (to - start, a + (b - a) * (start - from) / (to - from));
        let sum = 0.5 * span * (at + b);
        (sum, sum * (start - x) + span * span * (at + 2.0 * b) / 6.0)
    };
    let (q, qx) = straight(1.0, -2.0, 0.3, 1.1);
    let k = 2.0 * std::f64::consts::PI / LENGTH;
    // 3 sin(k s): ∫_x^L and its moment about x.
    let wave = 3.0 * ((k * x).cos() - 1.0) / k;
    let wave_x = 3.0 * (-(LENGTH - x) / k - (k * x).sin() / (k * k));
    let before = |value: f64| if x < SPOT { value } else { 0.0 };
    let normal = 4.0 * (LENGTH - x) + before(2.0) + 5.0;
    let shear = q + wave + before(1.5) - 0.7;
    let moment = qx + wave_x + straight(0.5, 0.5, 0.2, 0.9).0 + before(1.5 * (SPOT - x) - 0.4)
        - 0.7 * (LENGTH - x)
        + 0.3;
    [normal, shear, moment]
}

/// Displacements (w, φ, u) at positions in order, by Gauss' rule on pieces without a jump.
fn displacements(positions: &[f64]) -> [Vec<f64>; 3] {
    // Three points on a thousandth: exact far below the tolerance.
    let gauss = [
        (0.5 - 0.6_f64.sqrt() / 2.0, 5.0 / 18.0),
        (0.5, 8.0 / 18.0),
        (0.5 + 0.6_f64.sqrt() / 2.0, 5.0 / 18.0),
    ];
    let section = stiffness();
    let mut values = [vec![0.0], vec![0.0], vec![0.0]];
    let (mut w, mut phi, mut u) = (0.0, 0.0, 0.0);
    for pair in positions.windows(2) {
        let mut breaks = vec![pair[0]];
        breaks.extend([0.2, 0.3, 0.5, SPOT, 0.9, 1.1].into_iter().filter(|b| *b > pair[0] && *b < pair[1]));
        breaks.push(pair[1]);
        for part in breaks.windows(2) {
            let steps = 1 + ((part[1] - part[0]) / LENGTH * 1000.0) as usize;
            let h = (part[1] - part[0]) / steps as f64;
            for step in 0..steps {
                let start = part[0] + step as f64 * h;
                let (mut dphi, mut dw, mut du) = (0.0, 0.0, 0.0);
                for (z, g) in gauss {
                    let x = start + z * h;
                    let ([n, v, m], c) = (section_forces(x), section.compliance(x));
                    let curvature = c.coupling * n + c.bending * m;
                    dphi += g * h * curvature;
                    du += g * h * (c.axial * n + c.coupling * m);
                    // w' = φ + V/S, and φ(x) = φ + ∫ κ: what is ahead of x counts with its lever.
                    dw += g * h * (c.shear * v + curvature * (1.0 - z) * h);
                }
                w += dw + phi * h;
                phi += dphi;
                u += du;
            }
        }
        for (list, value) in values.iter_mut().zip([w, phi, u]) {
            list.push(value);
        }
    }
    values
}

fn beam(ratio: f64, graded: bool) -> TimoshenkoBeam {
    let cells = 12;
    // Cells that grow by a quarter each.
    let stations: Vec<f64> =
        (0..=cells).map(|k| LENGTH * (1.25_f64.powi(k) - 1.0) / (1.25_f64.powi(cells) - 1.0)).collect();
    let line = Line {
        horizon_ratio: ratio,
        stations: graded.then_some(stations),
        axial: Axial::Points,
        ..Line::new(LENGTH, cells as usize, stiffness())
    };
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find("exact").expect("the law exists"),
        end_treatment: end_treatment::find("cover").expect("the treatment exists"),
    };
    TimoshenkoBeam::new(parameters, vec![line]).expect("a member")
}

#[test]
fn a_coupled_member_under_every_load_is_exact_at_its_points() {
    for (ratio, graded) in [(1.0, false), (3.0, false), (4.0, true)] {
        let beam = beam(ratio, graded);
        let n = beam.points();
        let clamp = [W, PHI, U].map(|component| Equation {
            terms: vec![(Unknown { component, point: 0 }, 1.0)],
            value: 0.0,
            origin: "clamp".into(),
        });
        let system = System::<3>::new(&beam, Vec::new(), clamp.to_vec()).expect("no contradiction");
        let k = system.assemble_sparse();
        let mut factor = SparseCholesky::analyse(&k, Ordering::MinimumDegree).expect("a pattern");
        factor.refactor(&k).expect("positive definite");
        let mut load = vec![0.0; 3 * n];
        loads().add_to(&beam, &mut load);
        let mut held = load.clone();
        system.constraints().restrict(&mut held);
        let mut u = vec![0.0; 3 * n];
        factor.apply(&held, &mut u);
        let positions: Vec<f64> = (0..n).map(|p| beam.position(p)[0]).collect();
        for (plane, expected) in u.chunks(n).zip(displacements(&positions)) {
            // Measured 4e-14.
            assert!(error(plane, &expected) <= 1e-12, "m = {ratio}: {:e}", error(plane, &expected));
        }
        // Section forces with the reaction of the clamp.
        let mut forces = vec![0.0; 3 * n];
        system.force(&u, &mut forces);
        let reaction = [0, n, 2 * n].map(|k| forces[k] - load[k]);
        let mut all = load;
        (0..3).for_each(|c| all[c * n] += reaction[c]);
        let fields = beam.section_forces(0, &all, None, &loads());
        let near = |k: usize, side: usize| positions[k + side] + if side == 0 { 1e-12 } else { -1e-12 };
        for (component, cells) in [&fields.axial, &fields.shear, &fields.moment].into_iter().enumerate() {
            let found: Vec<f64> = cells.iter().flatten().copied().collect();
            let expected: Vec<f64> = (0..n - 1)
                .flat_map(|k| [0, 1].map(|side| section_forces(near(k, side))[component]))
                .collect();
            // Measured 2.2e-12, of which the step aside takes most.
            let wrong = error(&found, &expected);
            assert!(wrong <= 1e-10, "m = {ratio}, force {component}: {wrong:e}");
        }
    }
}
