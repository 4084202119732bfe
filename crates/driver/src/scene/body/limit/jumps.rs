//! Corners at which what is known of the border contradicts itself, so that the stress jumps there.
//!
//! At the end of a side two numbers are known of the displacement gradient: along each axis a traction, or how a displacement that
//! is prescribed goes on along the side. Both sides of a corner tell four numbers of four, but they tell the same one twice where
//! two free edges are at right angles (σ_xy), or where one of them is held along itself (σ_xx = ν σ_yy). If these differ, the stress
//! depends on the angle at which the corner is approached, and no polynomial does.

use super::LocalLimit;
use super::corners::{End, pairs};
use crate::diagnostic::{Faults, root, tidy};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::scene::BodyState;
use nalgebra::{Matrix4, Vector4};
use peristat_assembly::correction::Sample;

/// Part of the largest stress on the border by which it may jump: loads of four digits do. Where a roller meets a free edge under a
/// pressure it jumps by a quarter: 20 rows are 6e-4 off after corrections, 4e-3 without; by 6 % under an even shear, 2e-4 and 1e-3.
const LITTLE: f64 = 1e-3;
/// Step by which a displacement is differentiated along a side, in parts of its length.
const STEP: f64 = 1e-3;
/// Places on every side at which the largest stress is looked for.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];
/// Singular values of what is known of a corner that are smaller are zero.
const NONE: f64 = 1e-9;

/// Adds a warning for the largest jump.
pub(super) fn check(limit: &LocalLimit, site: &HeldBody, states: &[BodyState], faults: &mut Faults) {
    let Some(stiffness) = site.model.as_plane().map(|model| model.stiffness()) else { return };
    let spacing = site.ground.body.spacing();
    let corners: Vec<[End; 2]> =
        pairs(&limit.pieces, spacing).chain(on_lines(limit, site, spacing)).collect();
    let mut worst: Option<(f64, [f64; 2])> = None;
    for state in states {
        let known = Known { limit, state, stiffness };
        let size = known.size();
        for ends in &corners {
            let jump = known.jump(ends) / size;
            if jump > LITTLE && worst.is_none_or(|(most, _)| jump > most) {
                worst = Some((jump, ends[0].at));
            }
        }
    }
    let Some((jump, at)) = worst else { return };
    let ([x, y], percent) = (at.map(tidy), tidy((1e3 * jump).round() / 10.0));
    faults
        .warning(
            root("limit"),
            format!("stresses jump at ({x}, {y}), by {percent} % of the largest on the border: what is known of its two sides contradicts itself, and corrections leave an error of the second order in the spacing"),
        )
        .hint("give the sides tractions that agree there, such as a `parabolic` one, which is zero at the ends of an edge; read stresses some spacings away");
}

/// What is known of the border in a state.
struct Known<'a> {
    limit: &'a LocalLimit,
    state: &'a BodyState,
    stiffness: [[f64; 3]; 3],
}

impl Known<'_> {
    /// The largest of what is known, over the first stiffness.
    fn size(&self) -> f64 {
        let pieces = self.limit.pieces.iter().enumerate();
        let ends = pieces.flat_map(|(k, piece)| PLACES.map(|share| End::new((k, piece), share)));
        ends.flat_map(|end| self.values(&end)).fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()))
    }

    /// What is known at an end along x and along y: a traction over the first stiffness, or the derivative of a displacement.
    fn values(&self, end: &End) -> [f64; 2] {
        let Some(k) = end.piece else { return [0.0; 2] };
        let part = self.limit.pieces[k].part;
        let inwards = if end.share > 0.5 { -STEP } else { STEP };
        let sample = |steps: f64| {
            let share = end.share + steps * inwards;
            Sample { piece: k, share, at: part.at(share), normal: part.normal(share), length: 0.0 }
        };
        let [here, next, last] = [0.0, 1.0, 2.0].map(|steps| self.limit.known_at(self.state, &sample(steps)));
        let slope = |c: usize| (4.0 * next[c] - 3.0 * here[c] - last[c]) / (2.0 * STEP * part.length());
        [0, 1].map(|c| if end.held[c] { slope(c) } else { here[c] / self.stiffness[0][0] })
    }

    /// By how much what is known on both sides of a corner contradicts itself.
    fn jump(&self, ends: &[End; 2]) -> f64 {
        let values = [self.values(&ends[0]), self.values(&ends[1])];
        if ends[0].is_continued_by(&ends[1]) {
            return turned_difference(values, [ends[0].normal, ends[1].normal]);
        }
        let rows = [0, 1].map(|k| self.rows(&ends[k]));
        let matrix = Matrix4::from_fn(|r, c| rows[r / 2][r % 2][c]);
        let known = Vector4::from_fn(|r, _| values[r / 2][r % 2]);
        let found = matrix.svd(true, true).solve(&known, NONE);
        found.map_or(0.0, |gradient| (matrix * gradient - known).norm())
    }

    /// What `∂u_x/∂x, ∂u_x/∂y, ∂u_y/∂x, ∂u_y/∂y` say of what is known at an end.
    fn rows(&self, end: &End) -> [[f64; 4]; 2] {
        let ([x, y], [along_x, along_y], unit) = (end.normal, end.along, self.stiffness[0][0]);
        // σ_xx, σ_yy, σ_xy of ε_xx, γ, γ, ε_yy.
        let stress = |r: usize| [0, 2, 2, 1].map(|k| self.stiffness[r][k] / unit);
        let [xx, yy, xy] = [0, 1, 2].map(stress);
        let sum = |a: [f64; 4], b: [f64; 4]| std::array::from_fn(|k| x * a[k] + y * b[k]);
        let traction = [sum(xx, xy), sum(xy, yy)];
        let slope = [[along_x, along_y, 0.0, 0.0], [0.0, 0.0, along_x, along_y]];
        [0, 1].map(|c| if end.held[c] { slope[c] } else { traction[c] })
    }
}

/// The difference of tractions on two sides of a border that goes on smoothly, along the axes or along the normals.
fn turned_difference([a, b]: [[f64; 2]; 2], normals: [[f64; 2]; 2]) -> f64 {
    let own = |[x, y]: [f64; 2], [n, m]: [f64; 2]| [x * n + y * m, y * n - x * m];
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    apart(a, b).min(apart(own(a, normals[0]), own(b, normals[1])))
}

/// Corners of sides with lines of symmetry, where nothing moves across and no shear acts.
fn on_lines<'a>(
    limit: &'a LocalLimit,
    site: &'a HeldBody,
    spacing: f64,
) -> impl Iterator<Item = [End; 2]> + 'a {
    let pieces = limit.pieces.iter().enumerate();
    let ends = pieces.flat_map(|piece| [0.0, 1.0].map(|share| End::new(piece, share)));
    let lines = site.inputs.symmetry.at[..4].iter().enumerate();
    let lines: Vec<(usize, f64)> = lines.filter_map(|(side, at)| Some((side / 2, (*at)?))).collect();
    ends.flat_map(move |end| {
        let near =
            lines.clone().into_iter().filter(move |(axis, at)| (end.at[*axis] - at).abs() <= spacing * 1e-6);
        near.map(move |(axis, _)| [end, End::of_line(axis, end.at)])
    })
}
