use super::*;
use crate::body::plus;
use crate::stiffness::Term;

/// All next neighbours, rows of the dilatation of a lattice of unit spacing in the plane, and a hole.
fn families(mean_modulus: f64, [rows, layers]: [i32; 2]) -> (GridFamilies, usize) {
    let lattice = SquareLattice::new(1.0, [0.0; 3], [0..14, 0..rows, 0..layers], |c| c != [5, 6, 0]);
    let up = if layers > 1 { 1 } else { 0 };
    let all = (-up..=up).flat_map(|c| (-1..=1).flat_map(move |b| (-1..=1).map(move |a| [a, b, c])));
    let steps: Vec<Cell> = all.filter(|s| *s != [0; 3]).collect();
    let rows = |scale: f64| steps.iter().map(|s| [0, 1].map(|k| scale * f64::from(s[k]))).collect();
    let n = lattice.points();
    let inner = |p: usize| steps.iter().all(|s| lattice.number(plus(lattice.cell(p), *s)).is_some());
    let set_of = (0..n).map(|p| inner(p).then_some(u32::from(lattice.cell(p)[0] < 4))).collect();
    let family = GridFamily {
        steps: steps.clone(),
        sets: vec![rows(1.0 / 6.0), rows(0.2)],
        set_of,
        volume: (0..n).map(|p| 1.0 + 0.01 * p as f64).collect(),
        own: (0..n).map(|p| 1.0 / (1.0 + p as f64)).collect(),
        modulus: [[2.0, 0.5], [0.5, 3.0]],
        mean_modulus,
    };
    (GridFamilies::new(Arc::new(lattice), family), n)
}

fn motion(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / f64::from(1 << 30) - 1.0
    };
    (0..2 * n).map(|_| next()).collect()
}

#[test]
fn the_assembled_matrix_is_the_product() {
    for (mean_modulus, size) in [(0.0, [40, 1]), (7.0, [40, 1]), (0.0, [9, 11]), (7.0, [9, 11])] {
        let (families, n) = families(mean_modulus, size);
        let u = motion(n, 3);
        let mut force = vec![0.0; 2 * n];
        families.add_force(&u, &mut force);
        let terms: Vec<Box<dyn Term<2>>> = vec![Box::new(families.clone())];
        let mut matrix = BlockMatrix::sparse(n, &terms);
        families.add_tangent(&mut matrix);
        let matrix = matrix.to_csr(|point, component| component * n + point);
        let size = force.iter().fold(0.0, |a: f64, f| a.max(f.abs()));
        for (row, f) in matrix.outer_iterator().zip(&force) {
            let product: f64 = row.iter().map(|(column, k)| k * u[column]).sum();
            assert!((product - f).abs() < 1e-13 * size, "{product} {f}");
        }
        // The energy is half the work.
        let work: f64 = u.iter().zip(&force).map(|(u, f)| u * f).sum();
        assert!((2.0 * families.survey(&u).energy / work - 1.0).abs() < 1e-12);
        let mut blocks = vec![[[0.0; 2]; 2]; n];
        families.add_diagonal(&mut blocks);
        for p in 0..n {
            let found = matrix.get(p, p).copied().unwrap_or(0.0);
            assert!((blocks[p][0][0] - found).abs() < 1e-12 * size.max(1.0));
        }
    }
}
