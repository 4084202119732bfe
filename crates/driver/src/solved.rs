//! What a program reads from a solved case: its points, their volumes, and fields by name.

use crate::case::FieldName;
use crate::run::StateResult;
use crate::scene::Scene;
use crate::summary::Summary;
use std::borrow::Cow;
use thiserror::Error;

/// A solved scene. All lists of values are in the order of the points of the body: images in lines of symmetry and ghost
/// points have no part in them; points of a frame come member by member.
#[derive(Debug)]
pub struct Solved {
    /// The scene.
    pub scene: Scene,
    /// The record of the run.
    pub summary: Summary,
    /// Unknowns and fields of every state, in the order of `summary.states`. A body that breaks or softens has one per
    /// recorded equilibrium.
    pub states: Vec<StateResult>,
}

/// Why there are no values of a field.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FieldError {
    /// No such state.
    #[error("there is no state {state}: {states} are counted from 0")]
    State {
        /// The state that was asked for.
        state: usize,
        /// How many there are.
        states: usize,
    },
    /// No such field, or not on this body.
    #[error("there is no field `{name}`; there are {}", known.join(", "))]
    Field {
        /// The name that was asked for.
        name: String,
        /// The fields that there are.
        known: Vec<&'static str>,
    },
}

impl Solved {
    /// Values of a field at all points, one per point, in the units of the case. The names are those of probes and
    /// tables, such as `ux`, `von_mises` or `M`. A field that is zero by the nature of the body, such as `stress_zz` in
    /// plane stress, is answered with zeros though [`fields`](Self::fields) does not list it. Fields that the run did not
    /// recover are absent.
    ///
    /// # Errors
    /// [`FieldError`] where there is no such state or field; it lists the fields that there are.
    pub fn field(&self, state: usize, name: &str) -> Result<Cow<'_, [f64]>, FieldError> {
        let result = self.state(state)?;
        self.values(result, name)
            .ok_or_else(|| FieldError::Field { name: name.into(), known: self.names(result) })
    }

    /// Names of the fields of a state, in the order of tables.
    ///
    /// # Errors
    /// [`FieldError::State`] where there is no such state.
    pub fn fields(&self, state: usize) -> Result<Vec<&'static str>, FieldError> {
        Ok(self.names(self.state(state)?))
    }

    /// The unit of a field in the units of the case, such as `mm`; empty where it has none. `None` if there is no field of this name.
    pub fn unit(&self, name: &str) -> Option<&'static str> {
        let field: FieldName = serde_json::from_value(name.into()).ok()?;
        Some(field.about().unit.label(self.scene.case().units))
    }

    /// The unit of a probe in the units of the case; empty where it has none. `None` if there is no probe of this name.
    pub fn probe_unit(&self, name: &str) -> Option<&str> {
        self.summary.probes.iter().find(|probe| probe.name == name).map(|probe| &*probe.unit)
    }

    /// Positions `[x, y, z]` of all points, in the unit of length of the case; z is zero but in solids. A shell is unrolled: y runs
    /// around it.
    pub fn points(&self) -> Vec<[f64; 3]> {
        match &self.scene {
            Scene::Beam(scene) => {
                let beam = &scene.beam;
                beam.chains().iter().flat_map(|chain| chain.places()).map(|[x, y]| [x, y, 0.0]).collect()
            }
            Scene::Body(scene) => {
                let mut points = Vec::with_capacity(scene.body().points());
                scene.body().visit(|at| points.push(at));
                points
            }
            Scene::Plate(scene) => (0..scene.body.points()).map(|p| scene.body.position(p)).collect(),
        }
    }

    /// Volumes of all points, which add up to that of the body: of cells, which a border may cut, times the thickness, of
    /// whole rings in a body of revolution, of the parts of a beam. None where the case gives stiffnesses and no areas.
    pub fn volumes(&self) -> Option<Vec<f64>> {
        match &self.scene {
            Scene::Beam(scene) => {
                let mut volumes = Vec::new();
                for (chain, section) in scene.beam.chains().iter().zip(&scene.sections) {
                    let (area, from) = (section.area.as_ref()?, chain.line().from);
                    let part = |k: usize| chain.tributary(k);
                    volumes
                        .extend((0..chain.points).map(part).map(|(a, b)| area.integral(a - from, b - from)));
                }
                Some(volumes)
            }
            Scene::Body(scene) => Some(scene.real_points().map(|p| scene.model.volume(p)).collect()),
            Scene::Plate(scene) => {
                let nodes = scene.plate.nodes();
                Some((0..nodes.points()).map(|p| scene.volume(p)).collect())
            }
        }
    }

    fn state(&self, state: usize) -> Result<&StateResult, FieldError> {
        self.states.get(state).ok_or(FieldError::State { state, states: self.states.len() })
    }

    fn values<'a>(&self, result: &'a StateResult, name: &str) -> Option<Cow<'a, [f64]>> {
        let named = |field: &FieldName| field.name() == name;
        match (&self.scene, result) {
            (Scene::Beam(_), StateResult::Beam(result)) => {
                result.all_values(result.fields().iter().copied().find(named)?)
            }
            (Scene::Body(scene), StateResult::Body(result)) => {
                result.values(scene, FieldName::BODY.into_iter().find(named)?)
            }
            (Scene::Plate(_), StateResult::Plate(result)) => {
                result.values(FieldName::PLATE.into_iter().find(named)?)
            }
            _ => unreachable!("a scene has results of its own kind"),
        }
    }

    fn names(&self, result: &StateResult) -> Vec<&'static str> {
        match result {
            StateResult::Body(result) => result.fields().map(FieldName::name).collect(),
            StateResult::Plate(result) => result.fields().map(FieldName::name).collect(),
            StateResult::Beam(result) => {
                let fields = result.fields().iter().filter(|&&field| result.all_values(field).is_some());
                fields.map(|field| field.name()).collect()
            }
        }
    }
}
