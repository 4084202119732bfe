//! Probes of the mean of a field on an edge or a face, half a spacing outside of its points.

use crate::case::{FieldName, Probe};
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::site::interpolate::Weights;
use peristat_assembly::body::{PointBody, SquareLattice};

/// A row of points that ends on the edge.
struct Row {
    /// Its outermost point in the model.
    point: usize,
    /// Where it ends, m.
    end: [f64; 3],
    /// What it stands for of the edge, m or m².
    size: f64,
}

/// A straight edge or a flat face, as the rows that end on it.
struct Rows {
    /// The axis of the rows.
    axis: usize,
    /// Whether the body lies below it along this axis.
    is_high: bool,
    all: Vec<Row>,
}

/// What a probe reads that names an edge: the mean over all rows that end on it, each extrapolated to its end.
pub(super) fn resolve(
    probe: &Probe,
    site: &HeldBody,
    at: &JsonPath,
    faults: &mut Faults,
) -> Option<(Weights, String)> {
    let name = probe.at.edge.as_deref()?;
    let path = at.key("edge");
    let is_alone = probe.at == crate::case::At { edge: probe.at.edge.clone(), ..Default::default() };
    if !is_alone {
        faults.error(path, "`edge` names a place, and there is another one").hint(site.ground.place_hint());
        return None;
    }
    let Some((rows, lattice)) = rows(name, site).zip(lattice(site)) else {
        refuse(name, site, path, faults);
        return None;
    };
    let whole: f64 = rows.all.iter().map(|row| row.size).sum();
    let mut mean = Weights::new();
    for row in &rows.all {
        let Some(weights) = on_row(row, &rows, lattice, probe, site) else {
            faults
                .error(
                    path,
                    format!("rows behind `{name}` have less than four points, too few to extrapolate"),
                )
                .hint("use a smaller spacing, or name the points by `region`");
            return None;
        };
        mean.extend(weights.into_iter().map(|(point, share)| (point, share * row.size / whole)));
    }
    let words = format!("mean on the edge `{name}`, extrapolated");
    Some((mean, words))
}

/// Whether rows of points end half a spacing inside something of this name.
pub(super) fn ends_rows(name: &str, site: &HeldBody) -> bool {
    rows(name, site).is_some()
}

/// The lattice of the model.
fn lattice<'a>(site: &HeldBody<'a>) -> Option<&'a SquareLattice> {
    match site.interpolation.body {
        PointBody::Lattice(lattice) | PointBody::Solid(lattice) => Some(lattice),
        PointBody::Cloud(_) => None,
    }
}

/// The rows that end on an edge or a face of this name.
fn rows(name: &str, site: &HeldBody) -> Option<Rows> {
    let model = |point: usize| site.inputs.number(site.model, point as u32) as usize;
    match site.ground.body {
        PointBody::Lattice(lattice) if !lattice.is_turned() => {
            let outline = site.outline?;
            let [member] = outline.members(name)?[..] else { return None };
            let edge = outline.straight(member)?;
            let axis = edge.normal.iter().position(|n| (n.abs() - 1.0).abs() < 1e-9)?;
            let is_high = edge.normal[axis] > 0.0;
            let named = &JsonPath::default();
            let points = site.ground.region(name, named, &mut Faults::default())?;
            let row = |&p: &u32| {
                let mut end = lattice.position(p as usize);
                end[axis] = edge.from[axis];
                Row { point: model(p as usize), end, size: lattice.spacing() }
            };
            Some(Rows { axis, is_high, all: points.iter().map(row).collect() })
        }
        PointBody::Solid(lattice) => {
            let wall = site.ground.walls.iter().find(|wall| wall.name == name)?;
            let face = wall.face()?;
            let row = |side: peristat_assembly::body::Side| Row {
                point: model(side.point),
                end: side.middle(lattice),
                size: lattice.spacing().powi(2),
            };
            let all = wall.sides(lattice).into_iter().map(row).collect();
            Some(Rows { axis: face.axis, is_high: face.is_high, all })
        }
        _ => None,
    }
}

/// Points and shares of the value at the end of a row: those that move the border where bonds end on it, else a parabola.
fn on_row(
    row: &Row,
    rows: &Rows,
    lattice: &SquareLattice,
    probe: &Probe,
    site: &HeldBody,
) -> Option<Weights> {
    let sign = if rows.is_high { -1 } else { 1 };
    let mut out = [0.0; 3];
    out[rows.axis] = -f64::from(sign);
    if let Some(weights) = of_border(row.end, out, probe.field, site) {
        return Some(weights);
    }
    let cell = lattice.cell(row.point);
    let beyond = (row.end[rows.axis] - lattice.position(row.point)[rows.axis]) / lattice.spacing();
    let end = f64::from(cell[rows.axis]) + beyond;
    site.interpolation.row(lattice, cell, (rows.axis, sign), end)
}

/// Points that move a place on the border, where bonds end on it, and their shares.
pub(super) fn of_border(
    position: [f64; 3],
    out: [f64; 3],
    field: FieldName,
    site: &HeldBody,
) -> Option<Weights> {
    if field.is_recovered() {
        return None;
    }
    let shares = site.model.border_shares()?(position, out)?;
    Some(shares.into_iter().map(|(point, share)| (point as u32, share)).collect())
}

/// A name of nothing that has rows.
fn refuse(name: &str, site: &HeldBody, path: JsonPath, faults: &mut Faults) {
    let is_known = site.ground.own_name(name).is_some();
    if is_known {
        faults
            .error(path, format!("`{name}` is no straight edge along the rows of a lattice and no flat face"))
            .hint(format!("for the mean of its points write {{ \"region\": \"{name}\" }}"));
    } else {
        faults.error(path, format!("there is no edge `{name}`")).hint(suggest(name, site.ground.names()));
    }
}
