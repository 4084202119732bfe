//! Cantilevers under loads of every kind, free at the start and clamped at the end: statics gives their section forces,
//! integrals of these give their displacements, and exact bonds meet both in every point.

use super::*;
use crate::material::{Profile, SectionStiffness};
use crate::model::Model;
use crate::stiffness::BlockMatrix;
use nalgebra::{DMatrix, DVector};

/// Two lines in one body, so that no line starts at point zero by chance: a uniform one, and one of growing cells whose
/// stiffness tapers, jumps and couples.
fn beams() -> TimoshenkoBeam {
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find("exact").unwrap(),
        end_treatment: end_treatment::find("cover").unwrap(),
    };
    let section = SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3);
    let even = Line { from: 0.7, axial: Axial::Points, ..Line::new(2.0, 12, section.clone()) };
    let stiffness = SectionStiffness {
        bending: Profile::Polynomial(vec![2.0, 0.5, 0.25]),
        shear: Profile::Table(vec![[0.0, 30.0], [0.9, 20.0], [0.9, 40.0], [2.0, 35.0]]),
        coupling: Profile::Uniform(0.8),
        ..section
    };
    let stations = Some((0..=10).map(|k| f64::from(k * (k + 10)) / 100.0).collect());
    let graded = Line { from: -0.4, stations, axial: Axial::Points, ..Line::new(2.0, 10, stiffness) };
    TimoshenkoBeam::new(parameters, vec![even, graded]).unwrap()
}

/// Loads of every kind on a line, each alone and then all at once.
fn load_cases(chain: usize, from: f64) -> Vec<BeamLoads> {
    let spread = |a: f64, b: f64, along: Along, intensity: Intensity| Distributed {
        chain,
        from: from + a,
        to: from + b,
        intensity,
        along,
    };
    let linear = |start: f64, end: f64| Intensity::Linear { start, end };
    let distributed = vec![
        spread(0.0, 2.0, Along::Transverse, linear(1.5, 1.5)),
        spread(0.0, 2.0, Along::Transverse, linear(1.0, -2.0)),
        spread(0.31, 1.47, Along::Transverse, linear(0.4, 2.0)),
        spread(0.1, 1.8, Along::Transverse, Intensity::Parabola { start: 0.5, middle: 2.0, end: -1.0 }),
        spread(0.2, 1.9, Along::Transverse, Intensity::Sine { amplitude: 3.0, half_waves: 3 }),
        spread(0.13, 1.6, Along::Rotation, linear(0.7, -0.2)),
        spread(0.05, 2.0, Along::Axial, linear(1.0, 0.6)),
        // Cells far enough from the ends of these are all alike.
        spread(0.13, 1.85, Along::Transverse, linear(0.9, 0.9)),
        spread(0.1, 2.0, Along::Rotation, linear(0.7, 0.7)),
        spread(0.0, 1.7, Along::Axial, linear(1.0, 1.0)),
    ];
    let point = |x: f64, force: f64, moment: f64, axial: f64| PointAction {
        chain,
        x: from + x,
        force,
        moment,
        axial,
        spread: true,
    };
    let point = vec![
        point(0.37, 1.3, 0.0, 0.0),
        point(1.234, 0.0, 0.9, 0.0),
        point(0.88, 0.0, 0.0, -0.7),
        // On a point of both lines.
        point(2.0 / 3.0, -0.6, 0.4, 0.5),
        point(0.56, -0.6, 0.4, 0.5),
        PointAction { spread: false, ..point(0.0, 0.8, -0.3, 0.2) },
    ];
    let of_one = |l: &Distributed| BeamLoads { distributed: vec![*l], ..BeamLoads::default() };
    let of_point = |p: &PointAction| BeamLoads { point: vec![*p], ..BeamLoads::default() };
    let mut all: Vec<BeamLoads> = distributed.iter().map(of_one).chain(point.iter().map(of_point)).collect();
    all.push(BeamLoads { distributed, point, lumped: false });
    all
}

/// `[M, V, N]` that the loads left of `x` leave there; concentrated ones at `x` only if `with_end`.
fn section_forces(loads: &BeamLoads, x: f64, with_end: bool) -> [f64; 3] {
    let [mut m, mut v, mut n] = [0.0; 3];
    for load in &loads.distributed {
        let (length, t) = (load.to - load.from, (x - load.from).clamp(0.0, load.to - load.from));
        // The load up to t and its integral.
        let (sum, first) = match load.intensity {
            Intensity::Linear { start, end } => {
                let slope = (end - start) / length;
                (start * t + slope * t * t / 2.0, start * t * t / 2.0 + slope * t.powi(3) / 6.0)
            }
            Intensity::Parabola { start, middle, end } => {
                // q = start + b z + c z² of the place z on (0, 1).
                let (b, c) = (4.0 * middle - 3.0 * start - end, 2.0 * (start - 2.0 * middle + end));
                let z = t / length;
                (
                    length * z * (start + b * z / 2.0 + c * z * z / 3.0),
                    length * length * z * z * (start / 2.0 + b * z / 6.0 + c * z * z / 12.0),
                )
            }
            Intensity::Sine { amplitude, half_waves } => {
                let wave = f64::from(half_waves) * std::f64::consts::PI / length;
                (
                    amplitude / wave * (1.0 - (wave * t).cos()),
                    amplitude / wave * (t - (wave * t).sin() / wave),
                )
            }
        };
        match load.along {
            Along::Transverse => {
                v -= sum;
                m += first + sum * (x - load.to).max(0.0);
            }
            Along::Rotation => m -= sum,
            Along::Axial => n -= sum,
        }
    }
    for p in &loads.point {
        if p.x < x - 1e-9 || (with_end && p.x < x + 1e-9) {
            v -= p.force;
            m += p.force * (x - p.x) - p.moment;
            n -= p.axial;
        }
    }
    [m, v, n]
}

/// `(w, φ, u)` at `x` of a line clamped at its end.
fn displacement(line: &Line, loads: &BeamLoads, x: f64) -> [f64; 3] {
    let end = line.from + line.length;
    let ends = loads.distributed.iter().flat_map(|l| [l.from, l.to]);
    let jumps = loads.point.iter().map(|p| p.x).chain([line.from + 0.9]).chain(ends);
    let mut cuts: Vec<f64> = jumps.filter(|c| *c > x && *c < end).chain([x, end]).collect();
    cuts.sort_by(f64::total_cmp);
    let mut sum = [0.0; 3];
    for piece in cuts.windows(2) {
        let parts = 32;
        let width = (piece[1] - piece[0]) / f64::from(parts);
        for part in 0..parts {
            // Gauss' rule of three points.
            for (z, g) in [(-0.6_f64.sqrt(), 5.0 / 18.0), (0.0, 4.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 18.0)] {
                let s = piece[0] + (f64::from(part) + 0.5 + 0.5 * z) * width;
                let [m, v, n] = section_forces(loads, s, false);
                let of = |profile: &Profile| profile.value(s - line.from);
                let k = &line.stiffness;
                let (ei, shear, ea, b) = (of(&k.bending), of(&k.shear), of(&k.axial), of(&k.coupling));
                let determinant = ea * ei - b * b;
                let (curvature, strain) = ((ea * m - b * n) / determinant, (ei * n - b * m) / determinant);
                sum[W] += g * width * (curvature * (s - x) - v / shear);
                sum[PHI] -= g * width * curvature;
                sum[U] -= g * width * strain;
            }
        }
    }
    sum
}

/// Nodal forces, and the displacements under them with the last point of every line clamped.
fn solved(beam: &TimoshenkoBeam, loads: &BeamLoads) -> [Vec<f64>; 2] {
    let n = beam.points();
    let terms = Model::<3>::terms(beam);
    let mut tangent = BlockMatrix::<3>::sparse(n, &terms);
    terms.iter().for_each(|t| t.add_tangent(&mut tangent));
    let k = tangent.to_csr(|point, component| component * n + point);
    let clamped: Vec<usize> =
        (0..beam.chains().len()).map(|c| beam.first(c) + beam.chains()[c].points - 1).collect();
    let free: Vec<usize> = (0..3 * n).filter(|i| !clamped.contains(&(i % n))).collect();
    let entry = |i: usize, j: usize| k.get(free[i], free[j]).copied().unwrap_or(0.0);
    let k = DMatrix::from_fn(free.len(), free.len(), entry);
    let mut force = vec![0.0; 3 * n];
    loads.add_to(beam, &mut force);
    let solution = k.cholesky().unwrap().solve(&DVector::from_fn(free.len(), |i, _| force[free[i]]));
    let mut u = vec![0.0; 3 * n];
    free.iter().zip(solution.iter()).for_each(|(&i, v)| u[i] = *v);
    [force, u]
}

fn largest(v: impl IntoIterator<Item = f64>) -> f64 {
    v.into_iter().fold(0.0, |a, x| if x.is_nan() { f64::INFINITY } else { a.max(x.abs()) })
}

fn assert_sections(beam: &TimoshenkoBeam, chain: usize, found: &SectionForces, loads: &BeamLoads) {
    let c = &beam.chains()[chain];
    assert_eq!([found.moment.len(), found.shear.len(), found.axial.len()], [c.points - 1; 3]);
    for cell in 0..c.points - 1 {
        for side in 0..2 {
            let expected = section_forces(loads, c.position(cell + side), side == 0);
            let values = [found.moment[cell][side], found.shear[cell][side], found.axial[cell][side]];
            for (value, expected) in values.iter().zip(expected) {
                // Measured 3e-15.
                assert!((value - expected).abs() < 1e-13, "{loads:?} {cell} {side}: {value} for {expected}");
            }
        }
    }
}

#[test]
fn exact_bonds_meet_statics_and_its_integrals_in_every_point() {
    let beam = beams();
    let n = beam.points();
    for (number, chain) in beam.chains().iter().enumerate() {
        for loads in load_cases(number, chain.line().from) {
            let [force, u] = solved(&beam, &loads);
            let first = beam.first(number);
            let exact: Vec<[f64; 3]> =
                (0..chain.points).map(|k| displacement(chain.line(), &loads, chain.position(k))).collect();
            let scale = largest(exact.iter().flatten().copied());
            for (k, exact) in exact.iter().enumerate() {
                for c in 0..3 {
                    let value = u[c * n + first + k];
                    // Measured 1.2e-13.
                    assert!(
                        (value - exact[c]).abs() < 2e-12 * scale,
                        "{loads:?} {c} {k}: {value} for {}",
                        exact[c]
                    );
                }
            }
            let others = (0..3 * n).filter(|i| !(first..first + chain.points).contains(&(i % n)));
            assert_eq!(largest(others.map(|i| u[i].abs() + force[i].abs())), 0.0);
            assert_sections(&beam, number, &beam.section_forces(number, &force, None, &loads), &loads);
            let density = beam.energy_density(number, &u);
            // Points take the mean of their cells; the cells hold all that the loads have done.
            let (mut energy, mut cell) = (0.0, 0.0);
            for k in 0..chain.points - 1 {
                cell = if k == 0 { density[0] } else { 2.0 * density[k] - cell };
                energy += cell * chain.line().stiffness.area * (chain.position(k + 1) - chain.position(k));
            }
            let work: f64 = 0.5 * u.iter().zip(&force).map(|(u, f)| u * f).sum::<f64>();
            // Measured 8e-14.
            assert!((energy - work).abs() < 1e-12 * work, "{energy} {work}");
        }
    }
}

#[test]
fn lumped_loads_keep_their_sum_and_their_section_forces() {
    let beam = beams();
    let n = beam.points();
    let line = beam.chains()[0].line().clone();
    let along = |along: Along, value: f64| Distributed {
        chain: 0,
        from: line.from,
        to: line.from + line.length,
        intensity: Intensity::Linear { start: value, end: value },
        along,
    };
    let distributed =
        vec![along(Along::Transverse, 1.5), along(Along::Rotation, 0.7), along(Along::Axial, -0.4)];
    let loads = BeamLoads { distributed, point: Vec::new(), lumped: true };
    let mut force = vec![0.0; 3 * n];
    loads.add_to(&beam, &mut force);
    for (component, value) in [(W, 1.5), (PHI, 0.7), (U, -0.4)] {
        let h = line.spacing();
        for k in 0..beam.chains()[0].points {
            let share = if k == 0 || k == 12 { 0.5 * h } else { h };
            assert!((force[component * n + k] - value * share).abs() < 1e-15);
        }
    }
    let forces = beam.section_forces(0, &force, Some(&force), &loads);
    assert_sections(&beam, 0, &forces, &loads);
    assert_eq!(forces.at(12), (forces.moment[11][1], forces.shear[11][1], forces.axial[11][1]));
}

#[test]
fn bars_stretch_evenly_between_their_ends() {
    let parameters = *beams().parameters();
    let section = SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3);
    let line = |axial, cells| Line { axial, ..Line::new(2.0, cells, section.clone()) };
    let beam = TimoshenkoBeam::new(parameters, vec![line(Axial::Points, 4), line(Axial::Ends, 5)]).unwrap();
    let n = beam.points();
    let mut u: Vec<f64> = (0..3 * n).map(|k| ((k * k) % 17) as f64).collect();
    let before = u.clone();
    beam.fill_axial(&mut u);
    let bar = 2 * n + 5..3 * n;
    assert_eq!(u[..bar.start], before[..bar.start]);
    let (start, end) = (before[bar.start], before[bar.end - 1]);
    for (k, found) in u[bar].iter().enumerate() {
        assert!((found - (start + (end - start) * k as f64 / 5.0)).abs() < 1e-14, "{k}: {found}");
    }
}
