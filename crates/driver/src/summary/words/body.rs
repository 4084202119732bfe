//! Bodies in words: the model and the forces of what holds it.

use super::{Fact, Listing, MOST_ROWS, number};
use crate::case::Units;
use crate::run::body::{BodyReaction, MirrorReaction};
use crate::summary::{BodyForces, BodySummary, Forces, StateSummary, ValueSummary};
use peristat_assembly::model::plane::Edges;

/// Model, material, horizon and edges.
pub(super) fn model(m: &BodySummary, units: Units) -> Vec<Fact> {
    let mut lines = m.material.facts.clone();
    let mut line = |key: &str, text: String| lines.push((key.to_string(), text));
    for other in &m.materials {
        let s = if other.points == 1 { "" } else { "s" };
        let own = [("E", other.youngs_modulus), ("G", other.shear_modulus)].into_iter();
        let text = |value: ValueSummary| match value {
            ValueSummary::One(value) => number(value),
            ValueSummary::Between([least, greatest]) => format!("{} to {}", number(least), number(greatest)),
        };
        let stress = |value: ValueSummary| units.quantity(&text(value), units.stress());
        let mut own: String =
            own.filter_map(|(k, value)| Some(format!(", {k} = {}", stress(value?)))).collect();
        own.extend(other.stiffness_factor.map(|factor| format!(", moduli times {}", text(factor))));
        own.extend(other.fibre_angle.map(|angle| format!(", fibres at {}°", number(angle))));
        own.extend(other.poisson_ratio.map(|nu| format!(", ν = {}", number(nu))));
        own.extend(other.critical_stretch.map(|own| format!(", breaks at a stretch of {}", text(own))));
        own.extend(other.interface_stretch.map(|own| format!(", its interface at {}", text(own))));
        line("material", format!("{}, {}: {} point{s}{own}", other.number, other.name, other.points));
    }
    let length = |value: f64| units.quantity(&number(value), units.length());
    let influence = m.material.influence;
    let (ratio, horizon) = (number(m.horizon_ratio), length(m.horizon_ratio * m.spacing));
    let kind = if m.lattice { "" } else { " of listed points" };
    line("horizon", format!("{ratio} spacings{kind} = {horizon}{influence}"));
    let edges = match m.edges {
        Some(Edges::Border) if m.cut_triangles > 0 => {
            format!("{} triangles have what bonds leave along the true border", m.cut_triangles)
        }
        Some(Edges::Border) if m.cut_springs > 0 => {
            format!("{} springs have what bonds leave along the true border", m.cut_springs)
        }
        Some(Edges::Border) => "bonds end on the border, which moves with the points beside it".into(),
        Some(Edges::Overlay) => {
            let what = match (m.is_solid, m.lattice) {
                (true, true) => "points have tetrahedra that",
                (true, false) => "tetrahedra",
                (false, _) => "triangles",
            };
            format!("{} {what} replace missing bonds", m.triangles)
        }
        Some(Edges::Volume) => "bonds are stiffened by the missing volume".into(),
        Some(Edges::Energy) => "bonds are stiffened by the missing energy".into(),
        Some(Edges::None) | None => {
            m.material.edges.clone().unwrap_or_else(|| "missing bonds are not replaced".into())
        }
    };
    let bare = match m.uncorrected_points {
        0 => String::new(),
        1 => ", 1 point has none".into(),
        points => format!(", {points} points have none"),
    };
    line("edges", edges + &bare);
    if m.images > 0 {
        line("images", format!("{} points are images", m.images));
    }
    if m.cracks > 0 {
        let s = if m.cracks == 1 { "" } else { "s" };
        // One in a mirror cuts bonds to images alone.
        let cut =
            m.cut_bonds.filter(|cut| *cut > 0).map_or(String::new(), |cut| format!(", {cut} bonds cut"));
        line("cracks", format!("{} crack{s}{cut}", m.cracks));
    }
    lines
}

/// Forces of supports, rigid regions and lines of symmetry.
pub(super) fn forces(forces: &BodyForces, units: Units) -> Vec<Listing> {
    let of_supports =
        forces.reactions.iter().flat_map(|r| [r.force_x, r.force_y, r.force_w.or(r.force_z).unwrap_or(0.0)]);
    let size =
        of_supports.chain(forces.mirrors.iter().map(|m| m.force)).fold(0.0, |a: f64, f| a.max(f.abs()));
    // What is rounding beside the largest force reads as zero.
    let force = |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let of_moments = forces.reactions.iter().flat_map(|r| [r.moment_x, r.moment_y, r.moment]);
    let turn_size = of_moments.flatten().fold(0.0, |a: f64, m| a.max(m.abs()));
    let moment = |value: f64| number(if value.abs() < 1e-11 * turn_size { 0.0 } else { value });
    let any = |of: fn(&BodyReaction) -> Option<f64>| forces.reactions.iter().any(|r| of(r).is_some());
    let has_z = forces.mirrors.iter().any(is_across_z) || any(|r| r.force_z);
    let turns = any(|r| r.moment) || any(|r| r.moment_x) || any(|r| r.moment_y);
    // A column after those of two forces, and whether it has forces.
    type Column = (&'static str, bool, fn(&BodyReaction) -> Option<f64>);
    let mut columns: Vec<Column> = Vec::new();
    match (has_z, any(|r| r.force_w)) {
        (true, _) => columns.push(("force z", true, |r| r.force_z)),
        (_, true) => columns.push(("force w", true, |r| r.force_w)),
        _ => {}
    }
    match (has_z, turns) {
        (_, false) => {}
        (true, true) => columns.extend::<[Column; 3]>([
            ("moment x", false, |r| r.moment_x),
            ("moment y", false, |r| r.moment_y),
            ("moment z", false, |r| r.moment),
        ]),
        (false, true) => columns.push(("moment", false, |r| r.moment)),
    }
    let row = |r: &BodyReaction| {
        let place = match r.centre.map(|centre| centre.parts()) {
            Some((at, count)) => {
                let numbers: Vec<String> = at[..count.min(3)].iter().map(|x| number(*x)).collect();
                format!("{} about ({})", r.place, numbers.join(", "))
            }
            None => r.place.clone(),
        };
        let mut cells = vec![place, force(r.force_x), force(r.force_y)];
        cells.extend(columns.iter().map(|(_, is_force, of)| {
            of(r).map_or(String::new(), |value| if *is_force { force(value) } else { moment(value) })
        }));
        cells
    };
    let mut rows: Vec<Vec<String>> = forces.reactions.iter().take(MOST_ROWS).map(row).collect();
    for mirror in &forces.mirrors {
        let across = force(mirror.force);
        let mut cells = vec![format!("symmetry `{}`", mirror.side)];
        cells.resize(3 + columns.len(), String::new());
        let column = match &*mirror.side {
            "left" | "right" => 1,
            "bottom" | "top" => 2,
            _ => 3,
        };
        cells[column] = across;
        rows.push(cells);
    }
    let [x, y] = ["force x", "force y"].map(|name| units.label(name, "N"));
    let further = columns
        .iter()
        .map(|(name, is_force, _)| units.label(name, if *is_force { "N" } else { units.moment() }));
    let header: Vec<String> = ["support".into(), x, y].into_iter().chain(further).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let count = forces.reactions.len() + forces.mirrors.len();
    Listing::new(&header, rows, count, "supports").into_iter().collect()
}

/// Whether a plane of symmetry takes forces along z.
fn is_across_z(mirror: &MirrorReaction) -> bool {
    matches!(&*mirror.side, "back" | "front")
}

/// Whose solution the states are, where it is not that of the bonds: what the least corrected one has.
pub(super) fn limit(states: &[StateSummary]) -> Option<String> {
    let of = |state: &'_ StateSummary| match &state.forces {
        Forces::Body(forces) => forces.corrections.clone(),
        _ => None,
    };
    let last = |sizes: &[f64]| sizes.last().copied().unwrap_or(f64::INFINITY);
    let all = states.iter().filter_map(of);
    let worst = all.max_by(|a, b| last(&a.sizes).total_cmp(&last(&b.sizes)))?;
    let s = if worst.sizes.len() == 1 { "" } else { "s" };
    let mut text = format!("local elasticity, by {} correction{s}", worst.sizes.len());
    if let Some(size) = worst.sizes.last() {
        text += &format!(", the last one {size:.1e} of the largest displacement");
    }
    if worst.stalled {
        text += "; a further one was not smaller by half, and was left out";
    }
    Some(text)
}
