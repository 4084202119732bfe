//! Doubts about bodies of state-based families.

use super::super::Resolved;
use super::LOCKS;
use crate::diagnostic::{Faults, root};
use peristat_assembly::model::state_based::{Axis, Dilatation, Geometry, StateEdges, StateParameters};

/// Doubts about families.
pub(super) fn warn(parameters: &StateParameters, name: &str, on: &Resolved, faults: &mut Faults) {
    let model = root("model").key(name);
    let touches_axis = on.outline.is_some_and(|o| o.bounds()[0][0].abs() < 1e-6 * on.spacing);
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
    warn_of_single_rows(parameters, on, faults);
}

/// A single row has no neighbours across it that could tell its width: it is held to what it was.
fn warn_of_single_rows(parameters: &StateParameters, on: &Resolved, faults: &mut Faults) {
    let (Some(lattice), nu) = (on.lattice, parameters.poisson_ratio) else { return };
    let stiffer = match parameters.geometry {
        Geometry::PlaneStress(_) => 1.0 / (1.0 - nu * nu),
        Geometry::PlaneStrain(_) => (1.0 - nu) * (1.0 - nu) / (1.0 - 2.0 * nu),
        Geometry::Axisymmetric => return,
    };
    let lines = on.mirrors.lines;
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
