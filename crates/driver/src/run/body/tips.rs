//! How the faces of cracks part at the tips whose stress intensities are asked for.
//!
//! `√(E' G)` has neither sign nor mode: faces that overlap, or slide along each other, are reported.

use crate::case;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::BodyScene;

/// Sliding over opening above which a tip is no longer one of mode I: 4 % of G.
const MIXED: f64 = 0.2;
/// Overlap over sliding below which it is rounding, or the slant of the lattice.
const CLOSED: f64 = 0.05;

/// Points on both sides of a crack just behind a tip.
#[derive(Clone, Copy, Debug)]
struct Faces {
    /// Index of the stress intensity.
    intensity: usize,
    /// The point on the side of the normal, and that on the other one.
    points: [usize; 2],
    /// Unit normal of the crack.
    normal: [f64; 2],
}

/// The tips of all stress intensities of a scene.
#[derive(Debug)]
pub(super) struct Tips(Vec<Faces>);

impl Tips {
    /// Finds the points next to the tips, images in mirrors among them.
    pub(super) fn of(scene: &BodyScene) -> Self {
        let mut all = Vec::new();
        // Faces that move across the plane slide alone.
        let moves = [0, 1].iter().all(|&axis| scene.model.along(axis).is_some());
        for (k, intensity) in scene.intensities.iter().enumerate().filter(|_| moves) {
            let vertices = scene.cracks[intensity.crack].crack.vertices();
            if vertices.is_empty() {
                continue;
            }
            if intensity.tips != Some(case::Tips::End) {
                all.extend(faces(scene, k, vertices[0], vertices[1]));
            }
            if intensity.tips != Some(case::Tips::Start) {
                all.extend(faces(scene, k, vertices[vertices.len() - 1], vertices[vertices.len() - 2]));
            }
        }
        Self(all)
    }

    /// Adds a warning for every stress intensity of a state whose tips close or slide.
    pub(super) fn check(&self, scene: &BodyScene, state: usize, u: &[f64], warnings: &mut Faults) {
        for k in 0..scene.intensities.len() {
            let parts = self.0.iter().filter(|f| f.intensity == k).map(|f| f.part(scene.model.points(), u));
            let (mut closes, mut slides) = (false, false);
            for [opening, sliding] in parts {
                closes |= opening < -CLOSED * sliding.abs();
                slides |= sliding.abs() > MIXED * opening.abs();
            }
            let path = JsonPath::default().key("stress_intensity").index(k);
            let (name, state) = (&scene.intensities[k].name, &scene.states[state].name);
            if closes {
                let message = format!(
                    "the faces of the crack overlap at a tip of `{name}` in `{state}`: they would touch, and its value is no stress intensity"
                );
                warnings
                    .warning(path, message)
                    .hint("peristat knows no contact: cracks need loads that open them");
            } else if slides {
                let message = format!(
                    "the faces of the crack slide at a tip of `{name}` in `{state}`: its value is √(E' G) of both modes, not K_I"
                );
                warnings.warning(path, message).hint("√(E' G) = √(K_I² + K_II²)");
            }
        }
    }
}

impl Faces {
    /// Opening and sliding.
    fn part(&self, points: usize, u: &[f64]) -> [f64; 2] {
        let (n, [above, below], [x, y]) = (points, self.points, self.normal);
        let d = [u[above] - u[below], u[n + above] - u[n + below]];
        [d[0] * x + d[1] * y, d[1] * x - d[0] * y]
    }
}

/// The points half a spacing beside the crack and one behind its tip, nearest to that.
fn faces(scene: &BodyScene, intensity: usize, tip: [f64; 2], before: [f64; 2]) -> Option<Faces> {
    let d = [tip[0] - before[0], tip[1] - before[1]];
    let length = d[0].hypot(d[1]);
    let (tangent, h) = (d.map(|d| d / length), scene.spacing());
    let normal = [-tangent[1], tangent[0]];
    let beside = |side: f64| {
        let at = [0, 1].map(|k| tip[k] - h * tangent[k] + side * 0.6 * h * normal[k]);
        let key = |p: usize| {
            let [x, y] = scene.model.place(p);
            // Only points on this side.
            let off = side * ((x - tip[0]) * normal[0] + (y - tip[1]) * normal[1]);
            (off > 0.0).then(|| (x - at[0]).hypot(y - at[1])).filter(|far| *far < 2.0 * h)
        };
        let near = (0..scene.model.points()).filter_map(|p| Some((key(p)?, p)));
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, p)| p)
    };
    Some(Faces { intensity, points: [beside(1.0)?, beside(-1.0)?], normal })
}
