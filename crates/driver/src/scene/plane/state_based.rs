//! Material and families of state-based bodies.

use super::bonds::PlaneBonds;
use super::keys::PlaneKeys;
use super::model::tell;
use super::{PlaneScene, root};
use crate::case::{Axisymmetric, Case, Model, PlaneState, StatePlane};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use peristat_assembly::body::{Outline, PlaneBody, SquareLattice};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateEdges, StateError, StateParameters,
};

/// Poisson's ratio above which bodies lock unless changes of volume are means over blocks.
const LOCKS: f64 = 0.45;

impl PlaneKeys for StatePlane {
    fn model(&self) -> Model {
        Model::StatePlane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn take_usual_bonds(&mut self) {
        self.edges = None;
    }

    fn bonds(&mut self, case: &Case, _: bool, faults: &mut Faults) -> Option<PlaneBonds> {
        in_plane(self, case, faults).map(PlaneBonds::State)
    }

    fn settle(&mut self, bonds: &PlaneBonds, _: &mut Case) {
        if let PlaneBonds::State(parameters) = bonds {
            self.edges = Some(parameters.edges);
        }
    }
}

impl PlaneKeys for Axisymmetric {
    fn model(&self) -> Model {
        Model::Axisymmetric(self.clone())
    }

    fn thickness(&self) -> f64 {
        1.0
    }

    fn take_usual_bonds(&mut self) {
        (self.edges, self.measure, self.axis) = (None, Measure::default(), None);
    }

    fn bonds(&mut self, _: &Case, _: bool, faults: &mut Faults) -> Option<PlaneBonds> {
        revolved(self, faults).map(PlaneBonds::State)
    }

    fn settle(&mut self, bonds: &PlaneBonds, _: &mut Case) {
        let PlaneBonds::State(parameters) = bonds else { return };
        self.edges = Some(parameters.edges);
        self.axis = (parameters.edges != StateEdges::Border).then_some(parameters.axis);
    }
}

/// The parameters of a body in the plane, filling in the defaults of the case; the horizon ratio is to be set.
fn in_plane(model: &mut StatePlane, case: &Case, faults: &mut Faults) -> Option<StateParameters> {
    let path = root("model").key("state_plane");
    if let Some(k) = case.rigid.iter().position(|r| r.bearing.is_some()) {
        faults
            .error(root("rigid").index(k).key("bearing"), "families do not know of bearings")
            .hint("leave `bearing` out, or use the model `bond_plane`");
    }
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(model.thickness, "thickness", path.key("thickness"), faults);
    fine &= admissible(model.poisson_ratio, &path, faults);
    let geometry = match model.state {
        PlaneState::PlaneStress => Geometry::PlaneStress(model.thickness),
        PlaneState::PlaneStrain => Geometry::PlaneStrain(model.thickness),
    };
    let usual = match model.state {
        PlaneState::PlaneStrain if model.poisson_ratio > LOCKS => Dilatation::Blocks,
        _ => Dilatation::Points,
    };
    let breaks = case.fracture.is_some() || !case.cracks.is_empty();
    let edges = if breaks { StateEdges::Ghosts } else { StateEdges::Border };
    fine.then(|| StateParameters {
        youngs_modulus: model.youngs_modulus,
        poisson_ratio: model.poisson_ratio,
        geometry,
        horizon_ratio: 0.0,
        influence: *model.influence.get_or_insert(Influence::Linear),
        edges: model.edges.unwrap_or(edges),
        measure: Measure::Section,
        axis: Axis::Images,
        dilatation: *model.dilatation.get_or_insert(usual),
    })
}

/// The same of a body of revolution.
fn revolved(model: &mut Axisymmetric, faults: &mut Faults) -> Option<StateParameters> {
    let path = root("model").key("axisymmetric");
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= admissible(model.poisson_ratio, &path, faults);
    let of_ghosts = [("axis", model.axis.is_some()), ("measure", model.measure != Measure::Section)];
    let of_ghosts = of_ghosts.into_iter().find(|(_, is_given)| *is_given).map(|(key, _)| key);
    if let (Some(StateEdges::Border), Some(key)) = (model.edges, of_ghosts) {
        faults
            .error(
                path.key(key),
                "a body that is completed along its border ends on its axis, and counts by areas",
            )
            .hint(format!("leave `{key}` out, or use the edges `ghosts`"));
        fine = false;
    }
    let edges = model.edges.unwrap_or_default();
    let is_full =
        matches!(edges, StateEdges::Border | StateEdges::Ghosts) && model.measure == Measure::Section;
    let axis = if is_full { Axis::Table } else { Axis::Images };
    let blocks = if model.poisson_ratio > LOCKS { Dilatation::Blocks } else { Dilatation::Points };
    fine.then(|| StateParameters {
        youngs_modulus: model.youngs_modulus,
        poisson_ratio: model.poisson_ratio,
        geometry: Geometry::Axisymmetric,
        horizon_ratio: 0.0,
        influence: *model.influence.get_or_insert(Influence::Linear),
        edges,
        measure: model.measure,
        axis: model.axis.unwrap_or(axis),
        dilatation: *model.dilatation.get_or_insert(blocks),
    })
}

fn admissible(nu: f64, path: &JsonPath, faults: &mut Faults) -> bool {
    let fine = -1.0 < nu && nu < 0.5;
    if !fine {
        faults
            .error(
                path.key("poisson_ratio"),
                format!("Poisson's ratio must lie between -1 and 1/2, found {}", tidy(nu)),
            )
            .hint("for a material that keeps its volume take 0.4999: it does not lock");
    }
    fine
}

/// What a body of revolution must be beside a body in the plane; whether it touches its axis, `None` if it cannot be one.
pub(super) fn check_revolved(
    case: &Case,
    (outline, lattice): (Option<&Outline>, Option<&SquareLattice>),
    faults: &mut Faults,
) -> Option<bool> {
    if !case.rigid.is_empty() {
        faults
            .error(root("rigid"), "a rigid region of a body of revolution can move along its axis alone")
            .hint("hold or move the region by a support with \"ux\": 0 and `uy`");
    }
    if !case.stress_intensity.is_empty() {
        faults
            .error(root("stress_intensity"), "stress intensities are of bodies in the plane")
            .hint("remove `stress_intensity`");
    }
    for (at, side) in case.symmetry.iter().enumerate().filter(|s| matches!(s.1.as_str(), "left" | "right")) {
        let hint = match side.as_str() {
            "left" => "a body that begins at x = 0 has its axis there without being told",
            _ => "hold `ux` of the edge: a smooth rigid wall",
        };
        faults
            .error(
                root("symmetry").index(at),
                format!(
                    "the {side} side of a body of revolution is no mirror: what is behind it has other radii"
                ),
            )
            .hint(hint);
    }
    let joined = case.periodic.iter().position(|p| p.along == crate::case::Axis::X);
    if let Some(at) = joined {
        faults
            .error(
                root("periodic").index(at).key("along"),
                "the sides along x of a body of revolution are its inside and its outside",
            )
            .hint("join its bottom and its top: \"along\": \"y\"");
        return None;
    }
    let (Some(outline), Some(lattice)) = (outline, lattice) else { return Some(false) };
    let left = outline.bounds()[0][0];
    let slack = 1e-6 * lattice.spacing();
    if left < -slack {
        faults
            .error(
                root("body"),
                format!("x is the radius of a body of revolution, and this one reaches to {}", tidy(left)),
            )
            .hint("draw the half of the section with x >= 0");
        return None;
    }
    let first = lattice.corner()[0] + f64::from(lattice.columns().start) * lattice.spacing();
    if left <= slack && first > slack {
        faults
            .error(root("body"), "holes take away all of the body that touches its axis")
            .hint(format!("draw the body from x = {} on", tidy(first)));
        return None;
    }
    Some(left <= slack)
}

/// A fault for a body that cannot be made.
pub(super) fn refuse(error: &StateError, case: &Case, faults: &mut Faults) {
    let model = root("model").key(case.model.name());
    let path = match error {
        StateError::NoNeighbours(_) => root("horizon_ratio"),
        StateError::NegativeWeights(_) => model.key("edges"),
        StateError::NegativeAxis => model.key("influence"),
        StateError::AxisNeedsGhosts | StateError::AxisNeedsSection => model.key("axis"),
        StateError::OffAxis => root("body"),
        StateError::NoBorder => model.key("edges"),
    };
    tell(&error.to_string(), path, faults);
}

/// Doubts about families.
pub(super) fn warn(parameters: &StateParameters, scene: &PlaneScene, faults: &mut Faults) {
    let model = root("model").key(scene.bonds().name());
    let touches_axis = scene.outline().is_some_and(|o| o.bounds()[0][0].abs() < 1e-6 * scene.spacing());
    if parameters.is_axisymmetric() && touches_axis && parameters.axis != Axis::Table {
        let how = if parameters.axis == Axis::Images { "up to 70 %" } else { "about 17 %" };
        faults
            .warning(
                model.key("axis"),
                format!("within a horizon of the axis strains are {how} wrong, however fine the lattice"),
            )
            .hint("use \"axis\": \"table\" with the edges `ghosts`");
    }
    if matches!(parameters.edges, StateEdges::None | StateEdges::Calibrated) {
        faults
            .warning(model.key("edges"), "families of these edges have moduli that are percents off")
            .hint("it is kept for comparison with the literature: use the edges `ghosts`");
    }
    if parameters.poisson_ratio > LOCKS
        && parameters.dilatation == Dilatation::Points
        && !matches!(parameters.geometry, Geometry::PlaneStress(_))
    {
        faults
            .warning(model.key("dilatation"), "with `points` a body that hardly changes its volume locks")
            .hint("use `blocks`");
    }
    warn_of_single_rows(parameters, scene, faults);
}

/// A single row has no neighbours across it that could tell its width: it is held to what it was.
fn warn_of_single_rows(parameters: &StateParameters, scene: &PlaneScene, faults: &mut Faults) {
    let (PlaneBody::Lattice(lattice), nu) = (scene.body(), parameters.poisson_ratio) else { return };
    let stiffer = match parameters.geometry {
        Geometry::PlaneStress(_) => 1.0 / (1.0 - nu * nu),
        Geometry::PlaneStrain(_) => (1.0 - nu) * (1.0 - nu) / (1.0 - 2.0 * nu),
        Geometry::Axisymmetric => return,
    };
    let lines = scene.recipe.symmetry.mirrors.lines;
    let is_single = |across: usize| {
        let extent = [lattice.columns(), lattice.rows()][across].len();
        extent == 1 && lines[across].iter().all(Option::is_none)
    };
    if stiffer > 1.001 && (0..2).any(is_single) {
        let path = root("body");
        let message =
            format!("a single row keeps its width: it is {:.1} % too stiff", 100.0 * (stiffer - 1.0));
        faults.warning(path, message).hint("use a smaller spacing: two rows contract as they should");
    }
}
