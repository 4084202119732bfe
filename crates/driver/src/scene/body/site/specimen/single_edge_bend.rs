//! The bend specimen with an edge crack, on three rollers.

use super::SpecimenParts;
use super::plan::{Filled, Plan, disc, union};
use crate::case::{Amount, RectangleBody, Rigid, SingleEdgeBend};
use crate::diagnostic::tidy;

/// Least radius of a roller, in spacings: half a disc of it has two points at least.
const LEAST: f64 = 1.5;

/// What it stands for.
pub(crate) fn parts(given: &mut SingleEdgeBend, plan: &mut Plan) -> Option<SpecimenParts> {
    let (w, a, cells) = (given.width, given.crack_length, given.cells);
    if !plan.positive(&[("width", w), ("crack_length", a)]) {
        return None;
    }
    let span = *given.span.get_or_insert(4.0 * w);
    let length = *given.length.get_or_insert(4.5 * w);
    let radius = *given.roller_radius.get_or_insert(0.05 * w);
    if !plan.positive(&[("span", span), ("length", length), ("roller_radius", radius)]) {
        return None;
    }
    let across = Filled { what: "the width", per_cell: 1.0, between: None };
    let along = Filled { what: "the length", per_cell: length / w, between: Some("columns") };
    if !plan.filled(cells, &[across, along]) {
        return None;
    }
    let spacing = w / cells as f64;
    let horizon = (plan.horizon)(spacing);
    let is_whole = plan.tip(horizon, &[("the top", w - a), ("the bottom", a)]);
    if !(rollers(span, length, radius, spacing, plan) && is_whole) {
        return None;
    }
    let centres = [[-0.5 * span, 0.0], [0.5 * span, 0.0], [0.0, w]];
    // The supports slide along x and the load roller does not: by symmetry nothing pushes it, and the body stays where it is.
    let roller = |region: &str, centre: [f64; 2], ux: Option<f64>, uy: f64| Rigid {
        region: region.into(),
        centre: Some(centre.into()),
        ux: ux.map(Amount::Number),
        uy: Some(Amount::Number(uy)),
        ..Rigid::default()
    };
    let around = radius + horizon;
    Some(SpecimenParts {
        body: RectangleBody { from: [-0.5 * length, 0.0], size: [length, w], spacing, holes: Vec::new() },
        crack: vec![[0.0, -spacing], [0.0, a]],
        regions: vec![
            ("left_roller", disc(centres[0], radius)),
            ("right_roller", disc(centres[1], radius)),
            ("load_roller", disc(centres[2], radius)),
            ("rollers", union(["left_roller", "right_roller", "load_roller"])),
            ("around_left_roller", disc(centres[0], around)),
            ("around_right_roller", disc(centres[1], around)),
            ("around_load_roller", disc(centres[2], around)),
            ("around_rollers", union(["around_left_roller", "around_right_roller", "around_load_roller"])),
        ],
        rigid: vec![
            roller("left_roller", centres[0], None, 0.0),
            roller("right_roller", centres[1], None, 0.0),
            roller("load_roller", centres[2], Some(0.0), -given.deflection),
        ],
        supports: Vec::new(),
    })
}

/// Whether the rollers have points and are on the body, apart from the crack.
fn rollers(span: f64, length: f64, radius: f64, spacing: f64, plan: &mut Plan) -> bool {
    let before = plan.faults.errors();
    if radius < LEAST * spacing {
        let message = format!(
            "a roller of radius {} is smaller than one and a half spacings, {}",
            tidy(radius),
            tidy(LEAST * spacing)
        );
        plan.error("roller_radius", message).hint("use more `cells`, or larger rollers");
    }
    if 0.5 * (length - span) < radius {
        plan.error("span", "the supports reach beyond the ends of the body")
            .hint("use a smaller `span` or a greater `length`");
    }
    if 0.5 * span - radius < 2.0 * spacing {
        plan.error("span", "the supports reach the crack").hint("the span of ASTM E399 is 4 W");
    }
    plan.faults.errors() == before
}
