//! How far a solution is off its supports.

use peristat_assembly::model::timoshenko_beam::{ForceMethod, PHI, StrainSupport, W};

/// The largest gap at a support, relative to the largest displacement of its kind.
pub(super) fn supports(method: &ForceMethod, gaps: &[f64], displacements: [f64; 2]) -> f64 {
    let length = method.length();
    let supports = || method.supports().iter().zip(gaps);
    // Before the reactions to a settlement are known, nothing may move.
    let scale = |component: usize| {
        let own = supports().filter(|(s, _)| s.component == component).map(|(_, gap)| gap.abs());
        own.fold(displacements[component], f64::max)
    };
    let (w, phi) = (scale(W), scale(PHI));
    let all = w.max(length * phi);
    // A kind that hardly moves is measured by the other.
    let scales = [w.max(1e-3 * all), phi.max(1e-3 * all / length)];
    let of =
        |(s, gap): (&StrainSupport, &f64)| if *gap == 0.0 { 0.0 } else { gap.abs() / scales[s.component] };
    supports().map(of).fold(0.0, |a, b| if b.is_nan() { b } else { a.max(b) })
}

/// Forces that no support has taken, relative to all forces.
pub(super) fn forces(left_over: [f64; 2], sizes: [f64; 2]) -> f64 {
    let of = |k: usize| if left_over[k] == 0.0 { 0.0 } else { left_over[k].abs() / sizes[k] };
    of(0).max(of(1))
}
