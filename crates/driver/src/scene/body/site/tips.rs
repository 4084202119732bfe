//! What is next to the tip of a crack.

use super::cracks::NamedCrack;
use super::symmetry::Symmetry;
use peristat_assembly::body::{CRACK_SLACK, Crack, in_space};

/// What tips are looked at in.
pub(crate) struct Around<'a> {
    /// Mirrors.
    pub(crate) symmetry: &'a Symmetry,
    /// Spacing, m: how far tips move.
    pub(crate) spacing: f64,
    /// Whether points fill a lattice.
    pub(crate) is_lattice: bool,
}

/// What a tip lies on or would grow into; `before` is the next vertex of its crack.
pub(crate) fn met(
    tip: [f64; 2],
    before: [f64; 2],
    own: usize,
    cracks: &[NamedCrack],
    around: &Around,
) -> Option<String> {
    let slack = CRACK_SLACK * around.spacing;
    let d = [tip[0] - before[0], tip[1] - before[1]];
    let length = d[0].hypot(d[1]);
    let moved = |by: f64| [0, 1].map(|k| tip[k] + by / length * d[k]);
    let (back, ahead) = (moved(-around.spacing.min(length)), moved(around.spacing));
    for (_, other) in cracks.iter().enumerate().filter(|c| c.0 != own) {
        if other.crack.cuts(in_space(back), in_space(ahead), slack) {
            return Some(format!("lies on the crack `{}`, or within a spacing of it", other.name));
        }
    }
    let vertices = cracks[own].crack.vertices();
    let crosses = vertices.windows(2).filter(|w| !w.contains(&tip)).any(|w| {
        let part = Crack::new(w.to_vec());
        part.is_ok_and(|part| part.cuts(in_space(tip), in_space(ahead), slack))
    });
    if crosses || (vertices.len() > 2 && vertices.first() == vertices.last()) {
        return Some("lies on the crack itself".into());
    }
    let [left, right, below, above, ..] = around.symmetry.at;
    let mirrored = [(0, left), (0, right), (1, below), (1, above)].into_iter().any(|(axis, at)| {
        at.is_some_and(|at| (tip[axis] - at).abs() <= slack && (back[axis] - at).abs() > slack)
    });
    mirrored.then(|| "lies on a mirror, where its image goes on".into())
}
