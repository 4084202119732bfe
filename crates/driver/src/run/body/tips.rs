//! How the faces of cracks part at the tips whose stress intensities are asked for.
//!
//! `√(E' G)` has neither sign nor mode: faces that overlap, or slide along each other, are reported.

use super::modes;
use crate::case::{self, TipQuantity};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::BodyScene;
use peristat_assembly::model::BodyModel;

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
    normal: [f64; 3],
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
            if intensity.front.is_some() {
                continue;
            }
            if let Some(surface) = scene.cracks[intensity.crack].crack.surface() {
                let places = surface.behind_front(scene.spacing());
                all.extend(places.into_iter().filter_map(|(at, normal)| beside(scene, k, at, normal)));
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
            let parts = self.0.iter().filter(|f| f.intensity == k).map(|f| f.part(&*scene.model, u));
            let (mut closes, mut slides) = (false, false);
            for [opening, sliding] in parts {
                closes |= opening < -CLOSED * sliding.abs();
                slides |= sliding.abs() > MIXED * opening.abs();
            }
            if let Some(front) = &scene.intensities[k].front {
                let [opening, across, along] = modes::of_front(scene, front, u);
                closes = opening < -CLOSED * across.hypot(along);
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
            } else if slides && scene.intensities[k].quantity == TipQuantity::K {
                let message = format!(
                    "the faces of the crack slide at a tip of `{name}` in `{state}`: its value is √(E' G) of both modes, not K_I"
                );
                warnings.warning(path, message).hint("√(E' G) = √(K_I² + K_II²): `quantity` asks for them");
            }
        }
    }
}

impl Faces {
    /// Opening and sliding.
    fn part(&self, model: &dyn BodyModel, u: &[f64]) -> [f64; 2] {
        let [above, below] = self.points;
        let d = [0, 1, 2].map(|axis| {
            let plane = model.along(axis).map(|plane| plane * model.points());
            plane.map_or(0.0, |plane| u[plane + above] - u[plane + below])
        });
        let opening: f64 = (0..3).map(|k| d[k] * self.normal[k]).sum();
        let sliding: f64 = (0..3).map(|k| (d[k] - opening * self.normal[k]).powi(2)).sum();
        [opening, sliding.sqrt()]
    }
}

/// The points half a spacing beside the crack and one behind its tip, nearest to that.
fn faces(scene: &BodyScene, intensity: usize, tip: [f64; 2], before: [f64; 2]) -> Option<Faces> {
    let d = [tip[0] - before[0], tip[1] - before[1]];
    let length = d[0].hypot(d[1]);
    let (tangent, h) = (d.map(|d| d / length), scene.spacing());
    let at = [tip[0] - h * tangent[0], tip[1] - h * tangent[1], 0.0];
    beside(scene, intensity, at, [-tangent[1], tangent[0], 0.0])
}

/// The points half a spacing beside a crack, nearest to a place in it.
fn beside(scene: &BodyScene, intensity: usize, place: [f64; 3], normal: [f64; 3]) -> Option<Faces> {
    let h = scene.spacing();
    let nearest = |side: f64| {
        let at = [0, 1, 2].map(|k| place[k] + side * 0.6 * h * normal[k]);
        let key = |p: usize| {
            let position = scene.model.position(p);
            // Only points on this side.
            let off = side * (0..3).map(|k| (position[k] - place[k]) * normal[k]).sum::<f64>();
            let far = (0..3).map(|k| (position[k] - at[k]).powi(2)).sum::<f64>().sqrt();
            (off > 0.0 && far < 2.0 * h).then_some(far)
        };
        let near = (0..scene.model.points()).filter_map(|p| Some((key(p)?, p)));
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, p)| p)
    };
    Some(Faces { intensity, points: [nearest(1.0)?, nearest(-1.0)?], normal })
}
