//! The compact tension specimen, ASTM E399.

use super::SpecimenParts;
use super::plan::{Filled, Plan, disc, union};
use crate::case::{Amount, Bearing, CompactTension, RectangleBody, Rigid};
use crate::diagnostic::tidy;

/// How far pins reach beyond their rim where they pull, in spacings: points on it belong to them there, and elsewhere to the
/// plate. Five cells per quarter of the width have six such points per pin, which rounding would give to either.
const RIM: f64 = 1e-4;

/// What it stands for.
pub(crate) fn parts(given: &mut CompactTension, plan: &mut Plan) -> Option<SpecimenParts> {
    let (w, a, cells) = (given.width, given.crack_length, given.cells);
    if !plan.positive(&[("width", w), ("crack_length", a)]) {
        return None;
    }
    let height = *given.height.get_or_insert(1.2 * w);
    let back = *given.back.get_or_insert(0.25 * w);
    let radius = *given.pin_radius.get_or_insert(0.125 * w);
    let distance = *given.pin_distance.get_or_insert(0.275 * w);
    let bearing = *given.bearing.get_or_insert(60.0);
    let sizes = [("height", height), ("back", back), ("pin_radius", radius), ("pin_distance", distance)];
    if !plan.positive(&sizes) {
        return None;
    }
    let along = Filled { what: "the body along the crack", per_cell: 4.0 * (w + back) / w, between: None };
    let across = Filled { what: "the height", per_cell: 4.0 * height / w, between: Some("rows") };
    if !plan.filled(cells, &[along, across]) {
        return None;
    }
    let spacing = w / (4.0 * cells as f64);
    let horizon = (plan.horizon)(spacing);
    let is_whole = plan.tip(horizon, &[("the back face", w - a), ("the mouth", a + back)]);
    if !(pins(given, spacing, plan) && is_whole) {
        return None;
    }
    let pin = |region: &str, side: f64| Rigid {
        region: region.into(),
        centre: Some([0.0, side * distance].into()),
        ux: Some(Amount::Number(0.0)),
        uy: Some(Amount::Number(0.5 * side * given.opening)),
        bearing: Some(Bearing { direction: [0.0, side], half_angle: bearing }),
        ..Rigid::default()
    };
    let hole = |side: f64| disc([0.0, side * (distance + RIM * spacing)], radius - 0.1 * RIM * spacing);
    let zone = |side: f64| disc([0.0, side * distance], radius + horizon);
    Some(SpecimenParts {
        body: RectangleBody {
            from: [-back, -0.5 * height],
            size: [w + back, height],
            spacing,
            holes: Vec::new(),
        },
        crack: vec![[-back - spacing, 0.0], [a, 0.0]],
        regions: vec![
            ("upper_pin", hole(1.0)),
            ("lower_pin", hole(-1.0)),
            ("pins", union(["upper_pin", "lower_pin"])),
            ("around_upper_pin", zone(1.0)),
            ("around_lower_pin", zone(-1.0)),
            ("around_pins", union(["around_upper_pin", "around_lower_pin"])),
        ],
        rigid: vec![pin("upper_pin", 1.0), pin("lower_pin", -1.0)],
        supports: Vec::new(),
    })
}

/// Whether the pins have points, and body all around them.
fn pins(given: &CompactTension, spacing: f64, plan: &mut Plan) -> bool {
    let (Some(radius), Some(distance)) = (given.pin_radius, given.pin_distance) else { return false };
    let (Some(height), Some(back), Some(bearing)) = (given.height, given.back, given.bearing) else {
        return false;
    };
    let before = plan.faults.errors();
    if radius < spacing {
        let message =
            format!("a pin of radius {} is smaller than the spacing, {}", tidy(radius), tidy(spacing));
        plan.error("pin_radius", message).hint("use more `cells`, or larger pins");
    }
    let reached = [
        (distance - 0.5 * spacing, "the crack, and with it each other"),
        (0.5 * height - distance, "the edges at the top and at the bottom"),
        (back, "the mouth"),
        (given.width, "the back face"),
    ];
    for (_, what) in reached.iter().filter(|r| radius >= r.0) {
        let key = if what.contains("mouth") || what.contains("back") { "pin_radius" } else { "pin_distance" };
        plan.error(key, format!("the pins reach {what}")).hint(
            "`pin_distance` is from the crack to the centres of the pins; ASTM E399 has 0.275 W, and a `pin_radius` of W/8",
        );
    }
    if !(bearing > 0.0 && bearing <= 180.0) {
        plan.error("bearing", format!("`bearing` must be above 0 and at most 180 degrees, found {bearing}"))
            .hint("60 is a pin in its hole, 180 a pin that is glued all around");
    }
    plan.faults.errors() == before
}
