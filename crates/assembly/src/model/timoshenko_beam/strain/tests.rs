use super::*;
use crate::material::{Profile, SectionStiffness};
use crate::model::timoshenko_beam::{
    Along, BeamLoads, BeamParameters, ChainLoads, Distributed, Intensity, Line, PHI, PointAction,
    VolumeFactor, W, bond_law, end_treatment,
};
use crate::model::{Model, Points};
use crate::stiffness::Survey;
use nalgebra::{DMatrix, DVector};

fn parameters(law: usize, treatment: &str) -> BeamParameters {
    BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: &bond_law::TABLE[law],
        end_treatment: end_treatment::find(treatment).unwrap(),
    }
}

/// EI = 2 and the shear stiffness of a steel rectangle of this slenderness, for a length of 1.
fn section(slenderness: f64) -> SectionStiffness {
    SectionStiffness::uniform(2.0, 2.0 * 3.85 * slenderness * slenderness, 1.0, 1.0)
}

fn uniform(law: usize, cells: usize, m: f64, slenderness: f64, splits: &[usize]) -> TimoshenkoBeam {
    let line =
        Line { horizon_ratio: m, splits: splits.to_vec(), ..Line::new(1.0, cells, section(slenderness)) };
    TimoshenkoBeam::new(parameters(law, "cover"), vec![line]).unwrap()
}

/// Cells that grow to five times the first, sections that taper: bonds are eccentric.
fn graded(law: usize, cells: usize, m: f64) -> TimoshenkoBeam {
    let x = |k: usize| k as f64 / cells as f64;
    let stations = (0..=cells).map(|k| x(k) * (1.0 + 2.0 * x(k)) / 3.0).collect();
    let mut stiffness = section(10.0);
    stiffness.bending = Profile::Polynomial(vec![2.0, 3.0, 1.0]);
    let line = Line { stations: Some(stations), horizon_ratio: m, ..Line::new(1.0, cells, stiffness) };
    TimoshenkoBeam::new(parameters(law, "cover"), vec![line]).unwrap()
}

/// The stiffness as a dense matrix in the order of the matrix.
fn dense(form: &StrainForm) -> DMatrix<f64> {
    let StrainBand { half_bandwidth, runs, values } = form.band();
    assert_eq!(runs.iter().sum::<usize>(), form.cells());
    let (order, width) = (2 * form.cells(), half_bandwidth + 1);
    let mut k = DMatrix::zeros(order, order);
    let cells =
        values.chunks(2 * width).zip(&runs).flat_map(|(columns, &run)| std::iter::repeat_n(columns, run));
    for (j, column) in cells.flat_map(|columns| columns.chunks(width)).enumerate() {
        for (i, value) in column.iter().enumerate().filter(|(i, _)| j + i < order) {
            k[(j + i, j)] = *value;
            k[(j, j + i)] = *value;
        }
    }
    k
}

fn right_hand_side(
    form: &StrainForm,
    loads: Option<&ChainLoads>,
    actions: &[StrainAction],
) -> (DVector<f64>, Resultant) {
    let mut r = DVector::zeros(2 * form.cells());
    let mut sums = FromRight::new(form, loads, actions);
    r.as_mut_slice().chunks_mut(2 * STRAIN_BLOCK).for_each(|block| sums.sweep(block));
    (r, sums.finish())
}

fn displacements(
    form: &StrainForm,
    v: &DVector<f64>,
    loads: Option<&ChainLoads>,
    actions: &[StrainAction],
    start: [f64; 2],
) -> (Vec<f64>, StrainChecks) {
    let n = form.cells() + 1;
    let mut u = vec![0.0; 2 * n];
    let mut sums = FromLeft::new(form, loads, actions, start);
    for first in (0..form.cells()).step_by(STRAIN_BLOCK) {
        let end = (first + STRAIN_BLOCK).min(form.cells());
        let (w, phi) = u.split_at_mut(n);
        let v = &v.as_slice()[2 * (form.cells() - end)..2 * (form.cells() - first)];
        sums.sweep(v, [&mut w[first..end], &mut phi[first..end]]);
    }
    let (last, checks) = sums.finish();
    (u[n - 1], u[2 * n - 1]) = (last[W], last[PHI]);
    (u, checks)
}

fn noise(k: usize) -> f64 {
    ((k as f64 * 12.9898).sin() * 43_758.545).fract()
}

/// Strains of any kind, the forces that go with them, and back.
fn forces_and_strains_agree(beam: &TimoshenkoBeam) {
    let form = StrainForm::new(beam).unwrap();
    let n = beam.points();
    let v = DVector::from_fn(2 * form.cells(), |k, _| noise(k) * if k % 2 == 0 { 1.0 } else { 0.1 });
    let (u, _) = displacements(&form, &v, None, &[], [0.3, -0.2]);
    let mut force = vec![0.0; 2 * n];
    let terms = Model::<2>::terms(beam);
    terms.iter().for_each(|t| t.add_force(&u, &mut force));
    let action = |k: usize| StrainAction { point: k % n, component: k / n, value: Sum::of(force[k]) };
    let actions: Vec<StrainAction> = (0..2 * n).map(action).collect();
    let (r, resultant) = right_hand_side(&form, None, &actions);
    let k = dense(&form);
    let kv = &k * &v;
    let error = (&r - &kv).amax() / r.amax();
    assert!(error < 2e-13, "{error}"); // 2e-14 at most
    (0..2).for_each(|k| assert!(resultant.sum[k].abs() < 1e-12 * resultant.size[k]));
    let (again, checks) = displacements(&form, &v, None, &actions, [0.3, -0.2]);
    // Actions between the cells are summed apart from them, which shows in the last bit.
    again.iter().zip(&u).for_each(|(a, b)| assert!((a - b).abs() < 1e-15));
    assert!(checks.residual < 1e-12 * checks.action, "{checks:?}");
    // Scales are those of a diagonal of ones.
    let most = |value: &dyn Fn(usize) -> f64| (0..v.len()).map(value).fold(0.0, f64::max);
    let action = most(&|i| r[i].abs() / k[(i, i)].sqrt());
    let strain = most(&|i| v[i].abs() * k[(i, i)].sqrt());
    assert!((checks.action / action - 1.0).abs() < 1e-12, "{checks:?} {action}");
    assert!((checks.strain / strain - 1.0).abs() < 1e-12, "{checks:?} {strain}");
    let energy = terms.iter().map(|t| t.survey(&u)).fold(Survey::EMPTY, Survey::join).energy;
    assert!(
        (checks.energy / energy - 1.0).abs() < 1e-12 && (checks.work / energy - 1.0).abs() < 1e-12,
        "{checks:?}"
    );
    assert_eq!(checks.largest[W], again[..n].iter().fold(0.0, |a: f64, w| a.max(w.abs())));
}

#[test]
fn strains_and_displacements_are_the_same_beam() {
    for law in 0..3 {
        for m in 1..=5 {
            for cells in [1, 2, 4, 9, 40] {
                forces_and_strains_agree(&uniform(law, cells, m as f64, 5.0, &[]));
                forces_and_strains_agree(&graded(law, cells, m as f64));
            }
            forces_and_strains_agree(&uniform(law, 30, m as f64 + 0.4, 5.0, &[11, 12]));
        }
    }
    let line = Line { horizon_ratio: 4.0, ..Line::new(1.0, 20, section(5.0)) };
    forces_and_strains_agree(&TimoshenkoBeam::new(parameters(1, "truncated"), vec![line]).unwrap());
}

#[test]
fn the_condition_number_depends_on_neither_cells_nor_slenderness() {
    // Measured: 1 at m = 1, 2.0 at 2, 3.8 at 3, 8.6 at 5, 18 at 8 for cells shorter than the section is high; half of it
    // and less for longer cells.
    for m in 1..=8 {
        for (slenderness, cells) in [(5.0, 60), (20.0, 120), (1e2, 60), (1e4, 120), (1e6, 60)] {
            let beam = uniform(2, cells, f64::from(m), slenderness, &[]);
            let k = dense(&StrainForm::new(&beam).unwrap());
            let scaled =
                DMatrix::from_fn(k.nrows(), k.nrows(), |i, j| k[(i, j)] / (k[(i, i)] * k[(j, j)]).sqrt());
            let eigenvalues = scaled.symmetric_eigenvalues();
            let condition = eigenvalues.max() / eigenvalues.min();
            assert!(
                condition < f64::from(m).powf(1.5) + 0.1,
                "m = {m}, slenderness {slenderness}: {condition}"
            );
        }
    }
}

#[test]
fn long_runs_are_one_group() {
    let beam = uniform(2, 100_000, 3.0, 20.0, &[30_000]);
    let band = StrainForm::new(&beam).unwrap().band();
    assert!(band.runs.len() < 20, "{:?}", band.runs);
    assert_eq!(band.runs.iter().sum::<usize>(), 100_000);
    assert_eq!(band.values.len(), band.runs.len() * 12);
}

#[test]
fn bodies_that_can_move_inside_have_no_strain_form() {
    let two = vec![Line::new(1.0, 4, section(5.0)), Line { from: 2.0, ..Line::new(1.0, 4, section(5.0)) }];
    let beam = TimoshenkoBeam::new(parameters(2, "cover"), two).unwrap();
    assert_eq!(StrainForm::new(&beam).unwrap_err(), NoStrainForm::Lines(2));
    let cells = Line { grid: Grid::Cells, ..Line::new(1.0, 4, section(5.0)) };
    let beam = TimoshenkoBeam::new(parameters(2, "truncated"), vec![cells]).unwrap();
    assert_eq!(StrainForm::new(&beam).unwrap_err(), NoStrainForm::Cells);
}

/// Solves with dense matrices, by the force method, and returns u, reactions and checks.
fn solve(
    form: &StrainForm,
    loads: &ChainLoads,
    supports: &[(StrainSupport, f64)],
) -> (Vec<f64>, Vec<f64>, StrainChecks) {
    let k = dense(form).cholesky().unwrap();
    let n = form.cells() + 1;
    let at = |u: &[f64], s: &StrainSupport| u[s.component * n + s.point];
    let held: Vec<StrainSupport> = supports.iter().map(|s| s.0).collect();
    let mut method = ForceMethod::new(form, held.clone());
    assert!((method.length() - 1.0).abs() < 1e-15);
    for (column, unit) in method.units() {
        let v = k.solve(&right_hand_side(form, None, &[unit]).0);
        let u = displacements(form, &v, None, &[unit], [0.0; 2]).0;
        method.set_flexibility(column, held.iter().map(|s| at(&u, s)).collect());
    }
    let (mut start, mut reactions) = ([0.0; 2], vec![0.0; held.len()]);
    let mut found = None;
    for _ in 0..3 {
        let act = |(s, &r): (&StrainSupport, &f64)| StrainAction {
            point: s.point,
            component: s.component,
            value: Sum::of(r),
        };
        let actions: Vec<StrainAction> = held.iter().zip(&reactions).map(act).collect();
        let (r, resultant) = right_hand_side(form, Some(loads), &actions);
        let (u, checks) = displacements(form, &k.solve(&r), Some(loads), &actions, start);
        let gap = |((s, motion), r): (&(StrainSupport, f64), &f64)| motion - at(&u, s) - s.compliance * r;
        let gaps: Vec<f64> = supports.iter().zip(&reactions).map(gap).collect();
        let more = method.solve(&gaps, resultant.sum).unwrap();
        found = Some((u, reactions.clone(), checks));
        (0..2).for_each(|k| start[k] += more.start[k]);
        reactions.iter_mut().zip(&more.reactions).for_each(|(r, m)| *r += m);
    }
    found.unwrap()
}

/// The same with a dense displacement matrix.
fn reference(beam: &TimoshenkoBeam, loads: &BeamLoads, supports: &[(StrainSupport, f64)]) -> Vec<f64> {
    let size = 2 * beam.points();
    let terms = Model::<2>::terms(beam);
    let mut k = DMatrix::zeros(size, size);
    for j in 0..size {
        let (mut u, mut f) = (vec![0.0; size], vec![0.0; size]);
        u[j] = 1.0;
        terms.iter().for_each(|t| t.add_force(&u, &mut f));
        k.set_column(j, &DVector::from_vec(f));
    }
    let mut f = vec![0.0; size];
    loads.add_to(beam, &mut f);
    let mut f = DVector::from_vec(f);
    for (s, motion) in supports {
        let row = s.component * beam.points() + s.point;
        if s.compliance > 0.0 {
            k[(row, row)] += 1.0 / s.compliance;
        } else {
            k.row_mut(row).fill(0.0);
            k[(row, row)] = 1.0;
            f[row] = *motion;
        }
    }
    k.lu().solve(&f).unwrap().as_slice().to_vec()
}

fn support(point: usize, component: usize) -> (StrainSupport, f64) {
    (StrainSupport { point, component, compliance: 0.0 }, 0.0)
}

#[test]
fn supports_springs_and_settlements_agree_with_displacements() {
    let cells = 24;
    let distributed = |from, to, along| Distributed {
        chain: 0,
        from,
        to,
        intensity: Intensity::Linear { start: 3.0, end: 7.0 },
        along,
    };
    let loads = BeamLoads {
        distributed: vec![distributed(0.0, 1.0, Along::Transverse), distributed(0.3, 0.7, Along::Rotation)],
        point: vec![PointAction { chain: 0, x: 1.0, force: 2.0, moment: -0.3, axial: 0.0, spread: false }],
        lumped: false,
    };
    let clamped = |point| [support(point, W), support(point, PHI)];
    let spring = |point, component, k: f64| (StrainSupport { point, component, compliance: 1.0 / k }, 0.0);
    let moved = |mut s: (StrainSupport, f64), by| {
        s.1 = by;
        s
    };
    let sets = [
        clamped(0).to_vec(),
        clamped(cells).to_vec(),
        [clamped(0), clamped(cells)].concat(),
        vec![support(0, W), support(cells, W)],
        vec![support(0, W), support(12, W), support(cells, W)],
        vec![support(12, W), support(12, PHI)],
        vec![support(0, PHI), support(cells, W)],
        vec![spring(0, W, 40.0), spring(cells, W, 3.0), spring(12, PHI, 0.5)],
        vec![moved(support(0, W), 0.4), moved(support(0, PHI), -0.3), support(12, W), spring(cells, W, 1e6)],
    ];
    for beam in
        [uniform(2, cells, 3.0, 5.0, &[12]), uniform(0, cells, 2.0, 5.0, &[12]), graded(1, cells, 4.0)]
    {
        let form = StrainForm::new(&beam).unwrap();
        let on_chain = loads.on_chain(&beam, 0);
        for supports in &sets {
            let (u, _, checks) = solve(&form, &on_chain, supports);
            let expected = reference(&beam, &loads, supports);
            let largest = expected.iter().fold(0.0, |a: f64, u| a.max(u.abs()));
            let error = u.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
            assert!(error < 2e-11, "{error} for {supports:?}");
            assert!(checks.residual < 1e-13 * checks.action, "{checks:?}");
        }
    }
}

#[test]
fn the_size_of_a_resultant_counts_what_cancels() {
    let spread = |along, start, end| {
        let intensity = Intensity::Linear { start, end };
        Distributed { chain: 0, from: 0.1, to: 0.9, intensity, along }
    };
    let distributed = vec![spread(Along::Transverse, 3.0, -5.0), spread(Along::Rotation, -1.0, 2.0)];
    let loads = BeamLoads { distributed, ..Default::default() };
    for beam in [uniform(2, 24, 3.0, 5.0, &[]), graded(2, 24, 3.0)] {
        let form = StrainForm::new(&beam).unwrap();
        let n = beam.points();
        let x = |p: usize| beam.position(p)[0];
        let action = StrainAction { point: 7, component: W, value: Sum::of(-2.0) };
        let resultant = right_hand_side(&form, Some(&loads.on_chain(&beam, 0)), &[action]).1;
        let mut f = vec![0.0; 2 * n];
        loads.add_to(&beam, &mut f);
        f[7] -= 2.0;
        // The load on the point of the action is counted apart from it.
        let doubled = (f[7] + 2.0).abs() + 2.0 - f[7].abs();
        let total = |of: &dyn Fn(usize) -> f64| (0..n).map(of).sum::<f64>();
        let sum = [total(&|p| f[p]), total(&|p| f[p] * x(p) + f[n + p])];
        let size = [
            total(&|p| f[p].abs()) + doubled,
            total(&|p| f[p].abs() * x(p) + f[n + p].abs()) + doubled * x(7),
        ];
        for k in 0..2 {
            // Measured: 2e-16.
            assert!((resultant.sum[k] - sum[k]).abs() < 1e-14 * size[k], "{resultant:?} {sum:?}");
            assert!((resultant.size[k] / size[k] - 1.0).abs() < 1e-14, "{resultant:?} {size:?}");
        }
    }
}

#[test]
fn many_blocks_sum_as_one() {
    // Against the closed form of a cantilever under a uniform load q = 1, law `exact`.
    for cells in [511, 512, 513, 1030] {
        let beam = uniform(2, cells, 3.0, 20.0, &[]);
        let form = StrainForm::new(&beam).unwrap();
        let intensity = Intensity::Linear { start: 1.0, end: 1.0 };
        let load = Distributed { chain: 0, from: 0.0, to: 1.0, intensity, along: Along::Transverse };
        let loads = BeamLoads { distributed: vec![load], ..Default::default() };
        let (u, reactions, checks) =
            solve(&form, &loads.on_chain(&beam, 0), &[support(0, W), support(0, PHI)]);
        let (b, s) = (2.0, 2.0 * 3.85 * 400.0);
        for (k, w) in u[..cells + 1].iter().enumerate() {
            let x = k as f64 / cells as f64;
            let exact = x * x * (6.0 - 4.0 * x + x * x) / (24.0 * b) + x * (1.0 - x / 2.0) / s;
            assert!((w - exact).abs() < 2e-15 * 0.0627, "{cells} cells, x = {x}: {}", (w - exact) / 0.0627);
        }
        assert!((reactions[0] + 1.0).abs() < 1e-15 && (reactions[1] + 0.5).abs() < 1e-15, "{reactions:?}");
        assert!(checks.residual < 2e-15 * checks.action, "{checks:?}");
        assert!((checks.energy / checks.work - 1.0).abs() < 1e-14, "{checks:?}");
    }
}

#[test]
fn no_eigenvalue_is_below_its_bound() {
    let irregular = |law, m| {
        let mut stations: Vec<f64> = (1..40).map(|k| noise(7 * k).abs()).collect();
        stations.extend([0.0, 1.0]);
        stations.sort_by(f64::total_cmp);
        let mut stiffness = section(5.0);
        stiffness.bending = Profile::Polynomial(vec![2.0, 3.0]);
        let line = Line { stations: Some(stations), horizon_ratio: m, ..Line::new(1.0, 40, stiffness) };
        TimoshenkoBeam::new(parameters(law, "cover"), vec![line]).unwrap()
    };
    for law in 0..3 {
        for m in [1.0, 3.0, 5.0] {
            let slender = [5.0, 1e2, 1e4, 1e6].map(|slenderness| uniform(law, 60, m, slenderness, &[20]));
            for beam in slender.into_iter().chain([irregular(law, m), graded(law, 30, m)]) {
                let form = StrainForm::new(&beam).unwrap();
                let k = dense(&form);
                let scaled =
                    DMatrix::from_fn(k.nrows(), k.nrows(), |i, j| k[(i, j)] / (k[(i, i)] * k[(j, j)]).sqrt());
                let (bound, least) = (form.least_eigenvalue(), scaled.symmetric_eigenvalues().min());
                // From 1 at m = 1 to 0.55 of it at m = 5, 0.08 where the law `published` begins to lock.
                assert!(
                    bound <= 1.000_001 * least && bound >= 0.05 * least,
                    "law {law}, m = {m}: {bound} for {least}"
                );
            }
        }
    }
}
