//! Whether an answer is one that its model can give. A linear model answers in proportion to the loads, however large they
//! are: strains and rotations that are not small, displacements beyond the body and stresses that no material bears are
//! told, at the worst place of all states.

use super::words::{number, place};
use super::{Located, StateSummary};
use crate::case::{Model, Units};
use crate::run::StateResult;
use crate::run::beam::BeamResult;
use crate::run::body::{Steepest, steepest};
use crate::scene::Scene;
use crate::scene::body::BodyScene;
use peristat_assembly::body::in_space;
use peristat_assembly::stiffness::Kinematics;
use serde::{Deserialize, Serialize};

/// Strain up to which a model of small strains is trusted.
const SMALL_STRAIN: f64 = 0.05;
/// Rotation up to which a model of small rotations is trusted, degrees.
const SMALL_ROTATION: f64 = 5.0;
/// Young's modulus over the largest stress that a material might bear.
const STIFF: f64 = 20.0;

/// What is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Kind {
    Displacement,
    Rotation,
    Strain,
    Stress,
}

/// The worst that was seen of a kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Worst {
    kind: Kind,
    value: f64,
    limit: f64,
    place: String,
    state: String,
}

/// What the states so far raise doubts about.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Doubts {
    worst: Vec<Worst>,
    /// Length of the diagonal around the body, once it was needed.
    size: Option<f64>,
}

impl Doubts {
    /// Looks at a state.
    pub(super) fn take(&mut self, scene: &Scene, result: &StateResult, state: &StateSummary) {
        match (scene, result) {
            (Scene::Beam(beam), StateResult::Beam(result)) if beam.units != Units::Dimensionless => {
                self.take_beam(scene, result, state);
            }
            (Scene::Body(plane), StateResult::Body(result)) if plane.units != Units::Dimensionless => {
                self.take_displacement(state, &["ux", "uy", "w"], || size_of_plane(plane));
                if plane.path.as_ref().is_none_or(|path| path.kinematics == Kinematics::Linear) {
                    self.take_gradients(state, steepest(plane, result));
                }
                let moduli = plane.material().youngs_moduli().into_iter().map(|(_, modulus)| modulus);
                // Materials that are given by other moduli have strains to go by.
                if let Some(most) = moduli.reduce(f64::max) {
                    let most = most * plane.materials().stiffest();
                    self.take_extreme(Kind::Stress, most / STIFF, 1.0, state, &["von_mises"]);
                }
            }
            _ => {}
        }
    }

    fn take_beam(&mut self, scene: &Scene, result: &BeamResult, state: &StateSummary) {
        self.take_displacement(state, &["w", "u", "ux", "uy"], || size_of_beam(result));
        self.take_extreme(Kind::Rotation, SMALL_ROTATION, 1f64.to_degrees(), state, &["phi"]);
        if let Model::TimoshenkoBeam(beam) = &scene.case().model
            && let Some(e) = beam.youngs_modulus
            // The section of the largest stress need not be of the material of the model.
            && scene.case().materials.is_empty()
        {
            self.take_extreme(Kind::Strain, SMALL_STRAIN, e.recip(), state, &["stress_top", "stress_bottom"]);
        }
    }

    fn take_displacement(&mut self, state: &StateSummary, fields: &[&str], size: impl Fn() -> f64) {
        let limit = *self.size.get_or_insert_with(size);
        self.take_extreme(Kind::Displacement, limit, 1.0, state, fields);
    }

    /// Strain and rotation between points of a lattice, else the components of the strain, if they are known.
    fn take_gradients(&mut self, state: &StateSummary, found: Steepest) {
        let located =
            |(value, [x, y]): (f64, [f64; 2])| Located { value, x, y: Some(y), z: None, member: None };
        match found.strain {
            Some(strain) => self.keep(Kind::Strain, SMALL_STRAIN, 1.0, state, &located(strain)),
            None => {
                let components = ["strain_xx", "strain_yy", "strain_xy", "strain_xz", "strain_yz"];
                self.take_extreme(Kind::Strain, SMALL_STRAIN, 1.0, state, &components);
            }
        }
        if let Some(rotation) = found.rotation {
            self.keep(Kind::Rotation, SMALL_ROTATION, 1f64.to_degrees(), state, &located(rotation));
        }
    }

    /// Takes the largest magnitude of some fields, times a factor.
    fn take_extreme(&mut self, kind: Kind, limit: f64, factor: f64, state: &StateSummary, fields: &[&str]) {
        let ends = fields.iter().filter_map(|field| state.extremes.get(*field));
        let ends = ends.flat_map(|e| [&e.smallest, &e.largest]);
        if let Some(most) = ends.max_by(|a, b| a.value.abs().total_cmp(&b.value.abs())) {
            self.keep(kind, limit, factor, state, most);
        }
    }

    fn keep(&mut self, kind: Kind, limit: f64, factor: f64, state: &StateSummary, at: &Located) {
        let value = factor * at.value.abs();
        if value.is_nan() || value <= limit {
            return;
        }
        let before = self.worst.iter_mut().find(|worst| worst.kind == kind);
        if before.as_ref().is_some_and(|worst| worst.value >= value) {
            return;
        }
        let new = Worst { kind, value, limit, place: place(at), state: state.name.clone() };
        match before {
            Some(worst) => *worst = new,
            None => self.worst.push(new),
        }
    }

    /// A warning of each kind. Strains that are too large say more than the stresses that go with them.
    pub(super) fn warnings(&self) -> impl Iterator<Item = String> + '_ {
        let strains = self.worst.iter().any(|worst| worst.kind == Kind::Strain);
        self.worst.iter().filter(move |worst| worst.kind != Kind::Stress || !strains).map(Worst::text)
    }
}

impl Worst {
    fn text(&self) -> String {
        let (value, limit) = (number(self.value), number(self.limit));
        let what = match self.kind {
            Kind::Displacement => format!("a displacement of {value} is larger than the body, {limit}"),
            Kind::Rotation => {
                format!("a rotation of {value}° is not small, as the model takes it: below {limit}°")
            }
            Kind::Strain => format!(
                "a strain of {} % is not small, as the model takes it: below {} %",
                number(100.0 * self.value),
                number(100.0 * self.limit)
            ),
            Kind::Stress => format!("a stress of {value} is above a twentieth of Young's modulus, {limit}"),
        };
        format!(
            "{}, at {}: {what}\nhint: check the units of loads, moduli and lengths; a linear answer grows with its loads, however large they are",
            self.state, self.place
        )
    }
}

/// Length of the diagonal of the box around points.
fn diagonal(points: impl Iterator<Item = [f64; 3]>) -> f64 {
    let start = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    let [low, high] = points.fold(start, |[low, high], point| {
        [[0, 1, 2].map(|k| low[k].min(point[k])), [0, 1, 2].map(|k| high[k].max(point[k]))]
    });
    (high[0] - low[0]).hypot(high[1] - low[1]).hypot(high[2] - low[2])
}

fn size_of_plane(scene: &BodyScene) -> f64 {
    diagonal((0..scene.body().points()).map(|point| scene.body().position(point))) + scene.spacing()
}

fn size_of_beam(result: &BeamResult) -> f64 {
    diagonal(
        result.lines.iter().flat_map(|line| [0, line.x.len() - 1].map(|end| in_space(line.position(end)))),
    )
}
