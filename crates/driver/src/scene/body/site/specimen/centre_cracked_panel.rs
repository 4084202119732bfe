//! The panel with a crack in its middle.

use super::SpecimenParts;
use super::plan::{Filled, Plan};
use crate::case::{Amount, At, CentreCrackedPanel, RectangleBody, Support};

/// What it stands for; `alone` where nothing else holds it.
pub(crate) fn parts(given: &mut CentreCrackedPanel, alone: bool, plan: &mut Plan) -> Option<SpecimenParts> {
    let (w, height, length) = (given.width, given.height, given.crack_length);
    if !plan.positive(&[("width", w), ("height", height), ("crack_length", length)]) {
        return None;
    }
    let along = Filled { what: "the width", per_cell: 1.0, between: None };
    let across = Filled { what: "the height", per_cell: height / w, between: Some("rows") };
    if !plan.filled(given.cells, &[along, across]) {
        return None;
    }
    let spacing = w / given.cells as f64;
    let horizon = (plan.horizon)(spacing);
    let sides = ("the side of the panel", 0.5 * (w - length));
    if !plan.tip(horizon, &[sides, ("the other tip", length), ("the end of the panel", 0.5 * height)]) {
        return None;
    }
    Some(SpecimenParts {
        body: RectangleBody {
            from: [-0.5 * w, -0.5 * height],
            size: [w, height],
            spacing,
            holes: Vec::new(),
        },
        crack: vec![[-0.5 * length, 0.0], [0.5 * length, 0.0]],
        regions: Vec::new(),
        rigid: Vec::new(),
        supports: supports(given, alone, spacing),
    })
}

/// Ends that move, or three displacements without which the panel could move as a rigid body: no force is in them.
fn supports(given: &CentreCrackedPanel, alone: bool, spacing: f64) -> Vec<Support> {
    let at = |x: f64, y: f64| At { x: Some(x), y: Some(y), ..At::default() };
    let edge = |name: &str| At { region: Some(name.into()), ..At::default() };
    let right = 0.5 * (given.width - spacing);
    match given.opening {
        Some(opening) => vec![
            support(edge("bottom"), None, Some(-0.5 * opening)),
            support(edge("top"), None, Some(0.5 * opening)),
            support(at(right, 0.5 * spacing), Some(0.0), None),
        ],
        None if alone => vec![
            support(at(right, 0.5 * spacing), Some(0.0), Some(0.0)),
            support(at(right, -0.5 * spacing), Some(0.0), None),
        ],
        None => Vec::new(),
    }
}

fn support(at: At, ux: Option<f64>, uy: Option<f64>) -> Support {
    Support {
        at,
        w: None,
        ux: ux.map(Amount::Number),
        uy: uy.map(Amount::Number),
        uz: None,
        phi: None,
        phi_x: None,
        phi_y: None,
        phi_n: None,
        phi_t: None,
        inclined: None,
        w_spring: None,
        ux_spring: None,
        uy_spring: None,
        uz_spring: None,
        phi_spring: None,
        phi_n_spring: None,
        only: None,
        gap: None,
    }
}
