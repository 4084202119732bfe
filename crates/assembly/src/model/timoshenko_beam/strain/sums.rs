//! What the sums of loads and displacements have in common.

/// Cells whose contributions are added to each other before they are added to a running sum: their rounding is relative
/// to the few of them, and they do not wait for the sum.
pub(super) const FEW: usize = 8;

/// Sum of `a[k] b[k]` in lanes.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut lanes = [0.0; LANES];
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    for (a, b) in a.iter().zip(b) {
        (0..LANES).for_each(|l| lanes[l] += a[l] * b[l]);
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    lanes.iter().sum::<f64>() + rest
}

/// Largest magnitude; what is not a number is passed over.
#[inline(always)]
pub(super) fn largest(v: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut most = [0.0_f64; LANES];
    let (chunks, rest) = v.as_chunks::<LANES>();
    for chunk in chunks {
        (0..LANES).for_each(|l| most[l] = if chunk[l].abs() > most[l] { chunk[l].abs() } else { most[l] });
    }
    rest.iter().chain(&most).fold(0.0, |most, x| if x.abs() > most { x.abs() } else { most })
}
