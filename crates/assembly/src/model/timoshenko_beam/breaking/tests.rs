//! Bonds of beams that break: energies, ratios, numbers, loads, and a beam cut in two.

use super::super::*;
use super::*;
use crate::material::{Profile, SectionStiffness};
use crate::model::{Model, Points};
use crate::stiffness::BlockMatrix;
use nalgebra::{DMatrix, DVector};

const LENGTH: f64 = 1.0;

fn parameters(law: &str) -> BeamParameters {
    BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find(law).unwrap(),
        end_treatment: end_treatment::find("cover").unwrap(),
    }
}

/// EI = 1 and the shear stiffness of a steel rectangle a twentieth of its length high.
fn section() -> SectionStiffness {
    SectionStiffness::uniform(1.0, 1538.46, 700.0, 0.3)
}

fn uniform(law: &str, cells: usize, m: f64) -> TimoshenkoBeam {
    let axial = Axial::Points;
    let line = Line { horizon_ratio: m, axial, ..Line::new(LENGTH, cells, section()) };
    TimoshenkoBeam::new(parameters(law), vec![line]).unwrap()
}

/// A uniform line of three chunks with a split, and a graded one whose section tapers and couples.
fn mixed(law: &str) -> TimoshenkoBeam {
    let axial = Axial::Points;
    let plain = Line { splits: vec![70], axial, ..Line::new(LENGTH, 140, section()) };
    let mut stiffness = section();
    stiffness.bending = Profile::Polynomial(vec![1.0, 1.5, 0.5]);
    stiffness.coupling = Profile::Uniform(if law == "exact" { 9.0 } else { 0.0 });
    let stations = Some((0..=20).map(|k| f64::from(k * (k + 30)) / 1000.0).collect());
    let graded = Line { from: 2.0, stations, horizon_ratio: 4.0, ..Line::new(LENGTH, 20, stiffness) };
    TimoshenkoBeam::new(parameters(law), vec![plain, Line { axial, ..graded }]).unwrap()
}

fn random(size: usize) -> Vec<f64> {
    (0..size).map(|i| ((i * 7919 % 1013) as f64) / 1013.0 - 0.5).collect()
}

fn energy<const D: usize>(terms: &[Box<dyn Term<D>>], u: &[f64]) -> f64 {
    terms.iter().map(|t| t.survey(u).energy).sum()
}

fn force<const D: usize>(beam: &TimoshenkoBeam, u: &[f64]) -> Vec<f64>
where
    TimoshenkoBeam: Model<D>,
{
    let mut force = vec![0.0; u.len()];
    Model::<D>::terms(beam).iter().for_each(|t| t.add_force(u, &mut force));
    force
}

/// One pair for all lines.
fn critical(beam: &TimoshenkoBeam, curvature: f64, shear_strain: f64) -> CriticalStrains {
    CriticalStrains(vec![CriticalStrain { curvature, shear_strain }; beam.chains().len()])
}

fn ratios(beam: &TimoshenkoBeam, u: &[f64], critical: &CriticalStrains) -> Vec<(u64, f64)> {
    let mut all = Vec::new();
    beam.ratios(u, critical, &mut |bond, ratio| all.push((bond, ratio)));
    all
}

/// Bonds that cross the cell between a point and the next.
fn across(beam: &TimoshenkoBeam, cell: usize) -> Vec<u64> {
    let all = ratios(beam, &random(2 * beam.points()), &critical(beam, 1.0, 1.0));
    let crosses = |bond: &u64| {
        let [i, j] = beam.ends_of(*bond);
        i <= cell && cell < j
    };
    all.into_iter().map(|(bond, _)| bond).filter(crosses).collect()
}

fn energies_drop_by_those_of_the_parts<const D: usize>(mut beam: TimoshenkoBeam)
where
    TimoshenkoBeam: Breakable<D>,
{
    let u = random(D * beam.points());
    let bonds: Vec<u64> = ratios(&beam, &u, &critical(&beam, 1.0, 1.0)).into_iter().map(|r| r.0).collect();
    let whole = energy(&Model::<D>::terms(&beam), &u);
    let elements = Model::<D>::sizes(&beam).elements;
    for batch in bonds.chunks(41) {
        let before = energy(&Model::<D>::terms(&beam), &u);
        let part = energy(&Breakable::<D>::part(&beam, batch), &u);
        Breakable::<D>::break_bonds(&mut beam, batch);
        let after = energy(&Model::<D>::terms(&beam), &u);
        // Measured: 3.9e-16.
        assert!((before - part - after).abs() < 1e-13 * whole, "{before} - {part} - {after}");
        // What is gone has no energy, and cannot go again.
        assert_eq!(energy(&Breakable::<D>::part(&beam, batch), &u), 0.0);
        Breakable::<D>::break_bonds(&mut beam, batch);
        assert_eq!(energy(&Model::<D>::terms(&beam), &u), after);
    }
    assert!(elements >= bonds.len());
    assert_eq!(Model::<D>::sizes(&beam).elements, 0);
    assert_eq!(energy(&Model::<D>::terms(&beam), &u), 0.0);
}

#[test]
fn energies_drop_by_those_of_the_broken_bonds() {
    energies_drop_by_those_of_the_parts::<2>(mixed("exact"));
    energies_drop_by_those_of_the_parts::<3>(mixed("exact"));
    energies_drop_by_those_of_the_parts::<3>(uniform("published", 9, 3.0));
}

#[test]
fn ratios_grow_in_proportion_and_keep_their_numbers() {
    let mut beam = mixed("exact");
    let u = random(3 * beam.points());
    let critical = critical(&beam, 3.0, 0.2);
    let before = ratios(&beam, &u, &critical);
    assert_eq!(before.len(), Model::<2>::sizes(&beam).elements);
    let doubled: Vec<f64> = u.iter().map(|u| -2.0 * u).collect();
    for (one, two) in before.iter().zip(ratios(&beam, &doubled, &critical)) {
        assert_eq!((one.0, 2.0 * one.1), two);
        assert!(one.0 < Breakable::<2>::bond_numbers(&beam));
    }
    let mut numbers: Vec<u64> = before.iter().map(|r| r.0).collect();
    numbers.sort_unstable();
    numbers.dedup();
    assert_eq!(numbers.len(), before.len());
    let batch: Vec<u64> = numbers.iter().step_by(7).copied().collect();
    Breakable::<2>::break_bonds(&mut beam, &batch);
    let rest: Vec<(u64, f64)> = before.into_iter().filter(|r| !batch.contains(&r.0)).collect();
    assert_eq!(ratios(&beam, &u, &critical), rest);
}

fn parts_act_on_the_ends_of_their_bonds<const D: usize>(beam: &TimoshenkoBeam)
where
    TimoshenkoBeam: Breakable<D>,
{
    let n = beam.points();
    let u = random(D * n);
    for (bond, _) in ratios(beam, &u, &critical(beam, 1.0, 1.0)) {
        let mut force = vec![0.0; D * n];
        Breakable::<D>::part(beam, &[bond]).iter().for_each(|t| t.add_force(&u, &mut force));
        let moved: Vec<usize> = (0..n).filter(|p| (0..D).any(|k| force[k * n + p] != 0.0)).collect();
        assert_eq!(moved, Breakable::<D>::ends(beam, bond), "{bond}");
    }
}

#[test]
fn bonds_act_on_their_ends() {
    parts_act_on_the_ends_of_their_bonds::<2>(&mixed("exact"));
    parts_act_on_the_ends_of_their_bonds::<3>(&mixed("exact"));
}

#[test]
fn bonds_are_strained_as_the_beam_is() {
    let (moment, force) = (2.0, 5.0);
    for law in ["exact", "corrected", "published"] {
        let beam = uniform(law, 30, 3.0);
        let n = beam.points();
        let x = |p: usize| beam.position(p)[0];
        let plane = |w: &dyn Fn(f64) -> f64, phi: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (0..n).map(|p| w(x(p))).chain((0..n).map(|p| phi(x(p)))).collect()
        };
        // Uniform bending: EI = 1.
        let u = plane(&|x| moment * x * x / 2.0, &|x| moment * x);
        for (_, ratio) in ratios(&beam, &u, &critical(&beam, 4.0, 1e-3)) {
            assert!((ratio - moment / 4.0).abs() < 1e-10, "{law} {ratio}");
        }
        let shear = 1538.46;
        if law != "exact" {
            // Shear without bending: γ_b.
            for (_, ratio) in ratios(&beam, &plane(&|x| 0.1 * x, &|_| 0.0), &critical(&beam, 1.0, 0.2)) {
                assert!((ratio - 0.5).abs() < 1e-13, "{law} {ratio}");
            }
            continue;
        }
        // A cantilever with a force on its tip: the shear strain of every section is F/S, of every bond too.
        let u = plane(&|x| force * (x * x * (3.0 - x) / 6.0 + x / shear), &|x| force * x * (2.0 - x) / 2.0);
        for (bond, ratio) in ratios(&beam, &u, &critical(&beam, f64::INFINITY, 0.01)) {
            assert!((ratio / (force / shear / 0.01) - 1.0).abs() < 1e-9, "{bond} {ratio}");
        }
        for (bond, ratio) in ratios(&beam, &u, &critical(&beam, 0.5, f64::INFINITY)) {
            let middle: f64 = beam.ends_of(bond).map(x).iter().sum::<f64>() / 2.0;
            assert!((ratio - force * (1.0 - middle) / 0.5).abs() < 1e-11, "{bond} {ratio}");
        }
    }
    let unbroken = uniform("exact", 30, 3.0);
    let never = critical(&unbroken, f64::INFINITY, f64::INFINITY);
    assert!(ratios(&unbroken, &random(2 * unbroken.points()), &never).is_empty());
}

#[test]
fn a_section_that_varies_shears_by_its_mean_compliance() {
    // S = 1000 (1 + x): under a constant force the mean strain of [a, b] is F ln((1 + b)/(1 + a))/(1000 (b - a)).
    let mut stiffness = section();
    stiffness.shear = Profile::Polynomial(vec![1000.0, 1000.0]);
    let line = Line { axial: Axial::Points, ..Line::new(LENGTH, 10, stiffness) };
    let beam = TimoshenkoBeam::new(parameters("exact"), vec![line]).unwrap();
    let n = beam.points();
    let place = |p: usize| beam.position(p)[0];
    let w = |x: f64| x * x * (3.0 - x) / 6.0 + x.ln_1p() / 1000.0;
    let phi = |x: f64| x * (2.0 - x) / 2.0;
    let u: Vec<f64> = (0..n).map(|p| w(place(p))).chain((0..n).map(|p| phi(place(p)))).collect();
    for (bond, ratio) in ratios(&beam, &u, &critical(&beam, f64::INFINITY, 1.0)) {
        let [a, b] = beam.ends_of(bond).map(place);
        let mean = ((1.0 + b) / (1.0 + a)).ln() / (1000.0 * (b - a));
        assert!((ratio / mean - 1.0).abs() < 1e-9, "{bond} {ratio}");
    }
}

#[test]
fn what_is_far_from_a_break_does_not_change_in_the_last_bit() {
    let mut beam = mixed("exact");
    let u = random(3 * beam.points());
    let before = [force::<2>(&beam, &u[..2 * beam.points()]), force::<3>(&beam, &u)];
    let gone: Vec<u64> =
        ratios(&beam, &u, &critical(&beam, 1.0, 1.0)).iter().map(|r| r.0).step_by(97).collect();
    let ends: Vec<usize> = gone.iter().flat_map(|&bond| beam.ends_of(bond)).collect();
    Breakable::<3>::break_bonds(&mut beam, &gone);
    let after = [force::<2>(&beam, &u[..2 * beam.points()]), force::<3>(&beam, &u)];
    let mut changed = 0;
    for (before, after) in before.iter().zip(&after) {
        for (k, (b, a)) in before.iter().zip(after).enumerate() {
            assert!(b == a || ends.contains(&(k % beam.points())), "{k}: {b} {a}");
            changed += usize::from(b != a);
        }
    }
    assert!(changed > gone.len());
}

#[test]
fn a_section_holds_its_energy_release_rate_at_the_critical_strains() {
    // l_c over δ: 3/4, 19/27 and 146/216.
    for (m, share) in [(2.0, 0.75), (3.0, 0.703_703_7), (6.0, 0.675_925_9)] {
        let beam = uniform("published", 60, m);
        let chain = &beam.chains()[0];
        assert!((chain.energy_length().unwrap() / (m / 60.0) - share).abs() < 1e-7);
        let rate = 50.0;
        let CriticalStrain { curvature, shear_strain } = CriticalStrain::of_energy(rate, chain).unwrap();
        let n = beam.points();
        let x: Vec<f64> = (0..n).map(|p| beam.position(p)[0]).collect();
        let bent: Vec<f64> =
            x.iter().map(|x| curvature * x * x / 2.0).chain(x.iter().map(|x| curvature * x)).collect();
        let sheared: Vec<f64> =
            x.iter().map(|x| shear_strain * x).chain(std::iter::repeat_n(0.0, n)).collect();
        let bonds = across(&beam, 30);
        for u in [bent, sheared] {
            let held = energy(&Breakable::<2>::part(&beam, &bonds), &u);
            assert!((held / (rate * 0.3) - 1.0).abs() < 1e-12, "{m} {held}");
        }
    }
    let graded = &mixed("exact").chains;
    assert!(CriticalStrain::of_energy(1.0, &graded[0]).is_some());
    assert!(CriticalStrain::of_energy(1.0, &graded[1]).is_none());
}

#[test]
fn loads_stay_when_bonds_break() {
    let mut beam = mixed("exact");
    let distributed = |chain: usize, from: f64| Distributed {
        chain,
        from: from + 0.1,
        to: from + 0.83,
        intensity: Intensity::Linear { start: 1.0, end: 3.0 },
        along: Along::Transverse,
    };
    let loads =
        BeamLoads { distributed: vec![distributed(0, 0.0), distributed(1, 2.0)], ..BeamLoads::default() };
    let forces = |beam: &TimoshenkoBeam| {
        let mut f = vec![0.0; 2 * beam.points()];
        loads.add_to(beam, &mut f);
        f
    };
    let before = forces(&beam);
    let u = random(2 * beam.points());
    let gone: Vec<u64> =
        ratios(&beam, &u, &critical(&beam, 1.0, 1.0)).iter().map(|r| r.0).step_by(5).collect();
    Breakable::<2>::break_bonds(&mut beam, &gone);
    assert_eq!(forces(&beam), before);
}

/// Displacements of a beam clamped at both ends.
fn solve(beam: &TimoshenkoBeam, f: &[f64]) -> Vec<f64> {
    let n = beam.points();
    let terms = Model::<2>::terms(beam);
    let mut tangent = BlockMatrix::sparse(n, &terms);
    terms.iter().for_each(|t| t.add_tangent(&mut tangent));
    let mut k = DMatrix::zeros(2 * n, 2 * n);
    tangent.for_each_entry(|[i, r], [j, c], value| {
        k[(r * n + i, c * n + j)] = value;
        k[(c * n + j, r * n + i)] = value;
    });
    let mut f = DVector::from_column_slice(f);
    for held in [0, n - 1, n, 2 * n - 1] {
        k.row_mut(held).fill(0.0);
        k.column_mut(held).fill(0.0);
        k[(held, held)] = 1.0;
        f[held] = 0.0;
    }
    k.cholesky().expect("two clamps hold both halves").solve(&f).as_slice().to_vec()
}

#[test]
fn a_beam_broken_in_the_middle_is_two_cantilevers() {
    let (q, shear) = (1.0, 1538.46);
    // Measured to two digits with an independent NumPy implementation: of second order.
    for (cells, expected, digit) in
        [(25, 2.4e-3, 1e-4), (51, 5.3e-4, 1e-5), (101, 1.3e-4, 1e-5), (201, 3.4e-5, 1e-6)]
    {
        let mut beam = uniform("exact", cells, 3.0);
        let n = beam.points();
        let load = Distributed {
            chain: 0,
            from: 0.0,
            to: LENGTH,
            intensity: Intensity::Linear { start: q, end: q },
            along: Along::Transverse,
        };
        let loads = BeamLoads { distributed: vec![load], ..BeamLoads::default() };
        let mut f = vec![0.0; 2 * n];
        loads.add_to(&beam, &mut f);
        let bonds = across(&beam, cells / 2);
        assert_eq!(bonds.len(), 6);
        Breakable::<2>::break_bonds(&mut beam, &bonds);
        assert_eq!(Model::<2>::connected(&beam).spans().len(), 2);
        let u = solve(&beam, &f);
        let (h, a) = (LENGTH / cells as f64, LENGTH / cells as f64 * (cells / 2) as f64);
        // A cantilever with its load, and half of the load on the broken cell on its tip.
        let tip = q * (a.powi(4) / 8.0 + a * a / (2.0 * shear) + h / 2.0 * (a.powi(3) / 3.0 + a / shear));
        for point in [cells / 2, cells / 2 + 1] {
            let error = (u[point] / tip - 1.0).abs();
            assert!((error - expected).abs() < 0.51 * digit, "{cells}: {error:e}");
        }
        // Section forces are those of the load as given, although bonds that shared it are gone.
        let internal = force::<2>(&beam, &u);
        let mut all = f.clone();
        [0, n - 1, n, 2 * n - 1].into_iter().for_each(|k| all[k] = internal[k]);
        for (cell, v) in beam.section_forces(0, &all, None, &loads).shear.iter().enumerate() {
            let exact = [0, 1].map(|side| q * (LENGTH / 2.0 - (cell + side) as f64 * h));
            (0..2).for_each(|side| assert!((v[side] - exact[side]).abs() < 1e-9, "{cell}: {v:?} {exact:?}"));
        }
    }
}

#[test]
#[should_panic(expected = "the image of a bond would not break with it")]
fn bonds_with_images_do_not_break() {
    let parameters =
        BeamParameters { end_treatment: end_treatment::find("ghost").unwrap(), ..parameters("exact") };
    let held = end_treatment::EndSupport { w: Some(0.0), phi: Some(0.0) };
    let line = Line { supports: [held; 2], ..Line::new(LENGTH, 9, section()) };
    let mut beam = TimoshenkoBeam::new(parameters, vec![line]).unwrap();
    Breakable::<2>::break_bonds(&mut beam, &[5]);
}

#[test]
#[should_panic(expected = "a bar from end to end does not break bond by bond")]
fn bars_do_not_break() {
    let mut beam = TimoshenkoBeam::new(parameters("exact"), vec![Line::new(LENGTH, 9, section())]).unwrap();
    Breakable::<3>::break_bonds(&mut beam, &[5]);
}
