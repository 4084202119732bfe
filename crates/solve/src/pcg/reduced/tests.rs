use super::*;
use crate::plane::{Plane, left};
use crate::{LinearOperator, Pcg, PointGraph, Preconditioner, nested_dissection};
use sprs::CsMat;

struct Product<'a>(&'a CsMat<f64>);

impl LinearOperator for Product<'_> {
    fn size(&self) -> usize {
        self.0.rows()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        y.iter_mut().zip(left(self.0, x, &zeros)).for_each(|(y, left)| *y = -left);
    }
}

/// A plate whose pairs are all there, one whose pairs across the upper half of its middle are gone, and a factor of the first.
fn plates() -> ([CsMat<f64>; 2], DissectedCholesky) {
    let plane = Plane::new(Plane::lattice(24, |_| true), 2.0, |_, _| true);
    let crosses = |[p, q]: [usize; 2]| {
        let [a, b] = [p, q].map(|k| plane.positions[k]);
        (a[0] < 11.5) != (b[0] < 11.5) && a[1].min(b[1]) > 11.5
    };
    let mut weights = plane.pairs.iter().map(|pair| if crosses(*pair) { 0.0 } else { 1.0 });
    let cut = plane.weighted(2, || weights.next().unwrap());
    let whole = plane.matrix(2);
    let dissection = nested_dissection(&plane.positions, &PointGraph::from_matrix(&whole, 2));
    let mut factor = DissectedCholesky::analyse(&whole, &dissection, 2).unwrap();
    factor.refactor(&whole).unwrap();
    ([whole, cut], factor)
}

const OPTIONS: PcgOptions =
    PcgOptions { max_iterations: 60, residual_drop: 1e-12, energy_drop: 0.0, stagnation_window: 60 };

#[test]
fn iterates_among_a_few_unknowns_are_those_among_all() {
    let ([whole, cut], mut factor) = plates();
    let lost = &whole - &cut;
    let touched: Vec<usize> = {
        let mut is_touched = vec![false; whole.rows()];
        let entries = lost.iter().filter(|(value, _)| value.abs() > 1e-14);
        entries.for_each(|(_, (i, j))| [i, j].iter().for_each(|k| is_touched[*k] = true));
        (0..whole.rows()).filter(|k| is_touched[*k]).collect()
    };
    assert!(touched.len() > 50 && touched.len() < 200, "{}", touched.len());
    let mut b = vec![0.0; whole.rows()];
    touched.iter().for_each(|k| b[*k] = (*k as f64).cos());

    let mut expected = vec![0.0; b.len()];
    let of_all =
        Pcg::new(b.len()).solve(&Product(&cut), &mut factor, &mut b.clone(), &mut expected, &OPTIONS);

    let reach = factor.reach(touched.clone());
    let mut product = |p: &[f64], image: &mut [f64]| {
        let mut x = vec![0.0; b.len()];
        touched.iter().zip(p).for_each(|(k, p)| x[*k] = *p);
        let y = left(&lost, &x, &vec![0.0; x.len()]);
        touched.iter().zip(image).for_each(|(k, image)| *image = -y[*k]);
    };
    let mut residual: Vec<f64> = touched.iter().map(|k| b[*k]).collect();
    let mut x = vec![f64::NAN; b.len()];
    let report = ReducedPcg::new(&mut factor, &reach).solve(&mut product, &mut residual, &mut x, &OPTIONS);
    assert_eq!((report.status, report.iterations), (of_all.status, of_all.iterations));
    // Measured: 18, and the least eigenvalue is 0.33.
    assert!((8..40).contains(&report.iterations), "{}", report.iterations);
    assert!((report.least_eigenvalue / of_all.least_eigenvalue - 1.0).abs() < 1e-12);
    let size = |v: &[f64]| v.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let difference: Vec<f64> = x.iter().zip(&expected).map(|(a, b)| a - b).collect();
    assert!(size(&difference) < 1e-11 * size(&expected), "{:e}", size(&difference));
    // Measured: 6e-13, of entries up to one.
    assert!(size(&left(&cut, &x, &b)) < 1e-11, "{:e}", size(&left(&cut, &x, &b)));
}

#[test]
fn nothing_is_solved_by_nothing_and_what_is_not_definite_is_told() {
    let ([whole, _], mut factor) = plates();
    let reach = factor.reach(vec![3, 40]);
    let mut x = vec![f64::NAN; whole.rows()];
    let mut none = |_: &[f64], image: &mut [f64]| image.fill(0.0);
    let mut pcg = ReducedPcg::new(&mut factor, &reach);
    let report = pcg.solve(&mut none, &mut [0.0; 2], &mut x, &OPTIONS);
    assert_eq!((report.status, report.iterations), (PcgStatus::Converged, 0));
    assert!(x.iter().all(|x| *x == 0.0));
    // More is lost than there was.
    let mut more = |p: &[f64], image: &mut [f64]| image.iter_mut().zip(p).for_each(|(y, p)| *y = 1e3 * p);
    let report = pcg.solve(&mut more, &mut [1.0, 0.0], &mut x, &OPTIONS);
    assert_eq!(report.status, PcgStatus::IndefiniteOperator);
}

/// The factor is a preconditioner of all unknowns, too.
#[test]
fn without_loss_one_step_is_enough() {
    let ([whole, _], mut factor) = plates();
    let mut b = vec![0.0; whole.rows()];
    b[100] = 1.0;
    let mut expected = vec![0.0; b.len()];
    factor.apply(&b, &mut expected);
    let reach = factor.reach(vec![100]);
    let mut x = vec![f64::NAN; b.len()];
    let mut none = |_: &[f64], image: &mut [f64]| image.fill(0.0);
    let report = ReducedPcg::new(&mut factor, &reach).solve(&mut none, &mut [1.0], &mut x, &OPTIONS);
    assert_eq!(report.iterations, 1);
    assert!(x.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14));
}
