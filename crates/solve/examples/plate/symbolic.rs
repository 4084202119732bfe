//! Number of entries of a factor, counted exactly.

use peristat_solve::PointGraph;

/// Entries of L and operations of the factorisation when points are eliminated in an order, each with
/// `components` unknowns (points without neighbours not counted).
pub(crate) fn fill(graph: &PointGraph, order: &[usize], components: usize) -> (f64, f64) {
    let n = order.len();
    let mut place = vec![0; n];
    for (k, p) in order.iter().enumerate() {
        place[*p] = k;
    }
    let (mut parent, mut count, mut seen) = (vec![n; n], vec![0_usize; n], vec![n; n]);
    for k in 0..n {
        seen[k] = k;
        for q in graph.neighbours(order[k]) {
            let mut i = place[*q as usize];
            while i < k && seen[i] != k {
                if parent[i] == n {
                    parent[i] = k;
                }
                count[i] += 1;
                seen[i] = k;
                i = parent[i];
            }
        }
    }
    let coupled = (0..n).filter(|k| !graph.neighbours(order[*k]).is_empty());
    coupled.fold((0.0, 0.0), |(entries, work), k| {
        let columns = (1..=components).map(|c| (count[k] * components + c) as f64);
        (entries + columns.clone().sum::<f64>(), work + columns.map(|c| c * c).sum::<f64>())
    })
}
