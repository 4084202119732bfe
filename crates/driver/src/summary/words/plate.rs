//! Plates in bending in words: the model and the forces of what holds it.

use super::{Fact, Listing, MOST_ROWS, number};
use crate::case::Units;
use crate::summary::{PlateForces, PlateRegion, PlateSummary};
use peristat_assembly::model::plate_bending::ShearLaw;

/// Model, material, stiffness, horizon and edges.
pub(super) fn model(m: &PlateSummary, units: Units) -> Vec<Fact> {
    let length = |value: f64| units.quantity(&number(value), units.length());
    let law = match m.shear_law {
        ShearLaw::Corrected => "shear as corrected",
        ShearLaw::Published => "shear as published",
    };
    let e = units.quantity(&number(m.youngs_modulus), units.stress());
    let [d, s] = [(m.bending_stiffness, units.moment()), (m.shear_stiffness, units.force_per_length())]
        .map(|(value, unit)| units.quantity(&number(value), unit));
    let region = |region: &PlateRegion| {
        let e = units.quantity(&number(region.youngs_modulus), units.stress());
        let d = units.quantity(&number(region.bending_stiffness), units.moment());
        let (nu, t) = (number(region.poisson_ratio), length(region.thickness));
        let expansion = region.thermal_expansion.map(|alpha| format!(", expansion {}/K", number(alpha)));
        let expansion = expansion.unwrap_or_default();
        (
            "material".to_string(),
            format!("{}: E = {e}, ν = {nu}, thickness {t}, D = {d}{expansion}", region.name),
        )
    };
    let edges = match m.pieces {
        0 => "points lie on the edges, and half of a bond along one counts".to_string(),
        pieces => format!("points lie on the edges, {pieces} pieces of bonds end there"),
    };
    let mut facts: Vec<Fact> = [
        ("model", format!("{}, {law}", m.name)),
        ("material", format!("E = {e}, ν = {}, thickness {}", number(m.poisson_ratio), length(m.thickness))),
        ("stiffness", format!("D = {d}, κGt = {s}")),
        (
            "horizon",
            format!("{} spacings = {}", number(m.horizon_ratio), length(m.horizon_ratio * m.spacing)),
        ),
        ("edges", edges),
    ]
    .map(|(key, text)| (key.to_string(), text))
    .into();
    let places = m.materials.iter().map(region);
    facts.splice(2..2, places);
    facts
}

/// Forces of supports and lines of symmetry; along straight lines and at their ends.
pub(super) fn forces(forces: &PlateForces, units: Units) -> Vec<Listing> {
    let size = |of: fn(&crate::run::plate::PlateReaction) -> f64| {
        forces.reactions.iter().fold(0.0, |most: f64, r| most.max(of(r).abs()))
    };
    let (force, turn) = (size(|r| r.force), size(|r| r.moment_x).max(size(|r| r.moment_y)));
    // What is rounding beside the largest reads as zero.
    let clean = |value: f64, size: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let rows = forces.reactions.iter().take(MOST_ROWS).map(|r| {
        vec![r.place.clone(), clean(r.force, force), clean(r.moment_x, turn), clean(r.moment_y, turn)]
    });
    let header = [
        "support".to_string(),
        units.label("force", units.force()),
        units.label("moment x", units.moment()),
        units.label("moment y", units.moment()),
    ];
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let supports = Listing::new(&header, rows.collect(), forces.reactions.len(), "supports");
    [supports, held_lines(forces, units, force), corners(forces, units, force)]
        .into_iter()
        .flatten()
        .collect()
}

/// Forces along straight lines, and their extremes per length.
fn held_lines(forces: &PlateForces, units: Units, size: f64) -> Option<Listing> {
    let per_length = |k: usize| {
        let label = if k == 0 { "smallest per length" } else { "largest per length" };
        units.label(label, units.force_per_length())
    };
    let header = ["held along".into(), units.label("force", units.force()), per_length(0), "at".into()];
    let header: Vec<String> = header.into_iter().chain([per_length(1), "at".into()]).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let clean = |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let rows = forces.held_lines.iter().take(MOST_ROWS).map(|line| {
        let mut row = vec![line.place.clone(), clean(line.force)];
        for at in &line.range {
            row.push(clean(at.value));
            row.push(format!("({}, {})", number(at.x), number(at.y.unwrap_or_default())));
        }
        row
    });
    Listing::new(&header, rows.collect(), forces.held_lines.len(), "lines")
}

/// Forces at the ends of lines.
fn corners(forces: &PlateForces, units: Units, size: f64) -> Option<Listing> {
    let force = units.label("force", units.force());
    let clean = |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let rows = forces
        .corner_forces
        .iter()
        .take(MOST_ROWS)
        .map(|corner| vec![format!("({}, {})", number(corner.x), number(corner.y)), clean(corner.force)]);
    Listing::new(&["corner", &force], rows.collect(), forces.corner_forces.len(), "corners")
}
