//! DXF in ASCII: lines, polylines with bulges, arcs, circles and ellipses of the model; layers are their names.
//!
//! The library at hand reads all of the format and keeps no lines for faults.
//!
//! Source of the format: Autodesk, DXF reference, "ENTITIES section".

use super::super::ReadError;
use super::curve::{Arc, Ellipse};
use super::pairs::{Pair, Pairs};
use super::strokes::{Circle, Stroke, Strokes};

/// Entities that bound bodies, and are not read.
const REFUSED: [(&str, &str); 4] = [
    ("SPLINE", "convert splines to polylines of arcs, or export the drawing as SVG"),
    ("INSERT", "explode blocks before the export"),
    ("MLINE", "explode multilines before the export"),
    ("REGION", "explode regions to lines and arcs before the export"),
];

/// Bit of a vertex that controls a fitted curve and is not on it.
const FRAME: i64 = 16;
/// Bits of polylines that are curves or meshes in space.
const IN_SPACE: i64 = 8 | 16 | 64;

/// Entities that lie in a plane of their own, by the groups of the heights of their ends.
const FLAT: [(&str, &[i32]); 6] = [
    ("LINE", &[30, 31]),
    ("CIRCLE", &[]),
    ("ARC", &[]),
    ("ELLIPSE", &[31]),
    ("LWPOLYLINE", &[]),
    ("POLYLINE", &[]),
];

/// An entity with its groups.
struct Entity<'a> {
    kind: &'a str,
    line: usize,
    groups: Vec<Pair<'a>>,
}

/// Reads the lines of a drawing.
pub(super) fn read(bytes: &[u8], deviation: f64) -> Result<Strokes, ReadError> {
    let mut strokes = Strokes::default();
    let mut open: Option<Polyline> = None;
    for entity in entities(bytes)? {
        if let Some((_, hint)) = REFUSED.iter().find(|(kind, _)| *kind == entity.kind) {
            return Err(
                ReadError::at(entity.line, format!("entities `{}` are not read", entity.kind)).hint(hint)
            );
        }
        entity.check_is_flat()?;
        match entity.kind {
            "LINE" => {
                let points = vec![entity.point(10, 20)?, entity.point(11, 21)?];
                strokes.add(entity.stroke(points))?;
            }
            "CIRCLE" => {
                let centre = entity.flipped(entity.point(10, 20)?);
                let (radius, names, line) = (entity.need(40)?, entity.layer(), entity.line);
                strokes.add_circle(Circle { centre, radius, names, line })?;
            }
            "ARC" => {
                let [start, end] = [entity.need(50)?.to_radians(), entity.need(51)?.to_radians()];
                let sweep = Some((end - start).rem_euclid(std::f64::consts::TAU)).filter(|s| *s > 0.0);
                let sweep = sweep.unwrap_or(std::f64::consts::TAU);
                let arc = Arc { centre: entity.point(10, 20)?, radius: entity.need(40)?, start, sweep };
                let points = arc.chords(deviation).into_iter().map(|p| entity.flipped(p)).collect();
                strokes.add(entity.stroke(points))?;
            }
            "ELLIPSE" => strokes.add(entity.stroke(entity.ellipse()?.chords(deviation)))?,
            "LWPOLYLINE" => entity.polyline()?.add(&entity, deviation, &mut strokes)?,
            "POLYLINE" => open = Some(Polyline { is_closed: entity.bits(70) & 1 != 0, vertices: Vec::new() }),
            "VERTEX" => {
                let polyline = open.as_mut().filter(|_| entity.bits(70) & FRAME == 0);
                if let Some(polyline) = polyline {
                    polyline.vertices.push((entity.point(10, 20)?, entity.get(42)?.unwrap_or(0.0)));
                }
            }
            "SEQEND" => {
                if let Some(polyline) = open.take() {
                    polyline.add(&entity, deviation, &mut strokes)?;
                }
            }
            _ => {}
        }
    }
    Ok(strokes)
}

/// The entities of the model.
fn entities(bytes: &[u8]) -> Result<Vec<Entity<'_>>, ReadError> {
    let mut pairs = Pairs::new(bytes);
    let (mut found, mut is_named, mut is_inside, mut has_section) =
        (Vec::<Entity>::new(), false, false, false);
    while let Some(pair) = pairs.next()? {
        match (pair.code, pair.value) {
            (0, "SECTION") => is_named = true,
            (2, name) if is_named => {
                (is_inside, is_named) = (name == "ENTITIES", false);
                has_section |= is_inside;
            }
            (0, "ENDSEC") => is_inside = false,
            (0, kind) if is_inside => found.push(Entity { kind, line: pair.line, groups: Vec::new() }),
            _ if is_inside => {
                if let Some(entity) = found.last_mut() {
                    entity.groups.push(pair);
                }
            }
            _ => {}
        }
    }
    let missing =
        || ReadError::whole("has no section `ENTITIES`").hint("export the drawing again, as DXF in ASCII");
    // Lines of the paper are no part of the model.
    found.retain(|entity| entity.bits(67) == 0);
    if has_section { Ok(found) } else { Err(missing()) }
}

impl Entity<'_> {
    fn get(&self, code: i32) -> Result<Option<f64>, ReadError> {
        self.groups.iter().find(|group| group.code == code).map(Pair::real).transpose()
    }

    fn need(&self, code: i32) -> Result<f64, ReadError> {
        let missing = || ReadError::at(self.line, format!("the {} has no group {code}", self.kind));
        self.get(code)?.ok_or_else(missing)
    }

    fn bits(&self, code: i32) -> i64 {
        self.groups.iter().find(|group| group.code == code).map_or(0, Pair::bits)
    }

    fn point(&self, x: i32, y: i32) -> Result<[f64; 2], ReadError> {
        Ok([self.need(x)?, self.need(y)?])
    }

    /// A fault for a curve out of the plane of the drawing, whose projection would be another one.
    fn check_is_flat(&self) -> Result<(), ReadError> {
        let Some((_, heights)) = FLAT.iter().find(|(kind, _)| *kind == self.kind) else { return Ok(()) };
        let values = |codes: &[i32]| -> Result<Vec<f64>, ReadError> {
            codes.iter().map(|code| Ok(self.get(*code)?.unwrap_or(0.0))).collect()
        };
        // The axis in units of its length: coordinates are rounded to a few digits.
        let is_upright = values(&[210, 220])?.iter().all(|x| x.abs() <= 1e-6);
        let ends = values(heights)?;
        let is_level = match self.kind {
            "ELLIPSE" => ends.iter().all(|z| *z == 0.0),
            "POLYLINE" => self.bits(70) & IN_SPACE == 0,
            _ => ends.windows(2).all(|z| z[0] == z[1]),
        };
        if is_upright && is_level {
            return Ok(());
        }
        let what = format!("the {} leaves the plane z = constant", self.kind);
        Err(ReadError::at(self.line, what).hint("flatten the drawing before the export"))
    }

    /// The name of its layer.
    fn layer(&self) -> Vec<String> {
        let layer = self.groups.iter().find(|group| group.code == 8 && !group.value.is_empty());
        layer.map(|group| group.value.to_string()).into_iter().collect()
    }

    /// A position of an entity that is seen from below where its axis says so.
    fn flipped(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let is_below = self.get(230).ok().flatten().is_some_and(|z| z < 0.0);
        if is_below { [-x, y] } else { [x, y] }
    }

    fn stroke(&self, points: Vec<[f64; 2]>) -> Stroke {
        Stroke { points, names: self.layer(), line: self.line, curve: None }
    }

    fn ellipse(&self) -> Result<Ellipse, ReadError> {
        let [x, y] = self.point(11, 21)?;
        let (start, end) = (self.get(41)?.unwrap_or(0.0), self.get(42)?.unwrap_or(std::f64::consts::TAU));
        let sign = self.get(230)?.filter(|z| *z < 0.0).map_or(1.0, |_| -1.0);
        let sweep = Some((end - start).rem_euclid(std::f64::consts::TAU)).filter(|s| *s > 1e-9);
        let sweep = sweep.unwrap_or(std::f64::consts::TAU);
        let (centre, radius) = (self.point(10, 20)?, x.hypot(y));
        let arc = Arc { centre, radius, start, sweep };
        Ok(Ellipse { arc, across: sign * radius * self.need(40)?, turn: y.atan2(x) })
    }

    fn polyline(&self) -> Result<Polyline, ReadError> {
        let mut vertices: Vec<([f64; 2], f64)> = Vec::new();
        for group in &self.groups {
            let last = vertices.last_mut();
            match (group.code, last) {
                (10, _) => vertices.push(([group.real()?, 0.0], 0.0)),
                (20, Some(vertex)) => vertex.0[1] = group.real()?,
                (42, Some(vertex)) => vertex.1 = group.real()?,
                _ => {}
            }
        }
        Ok(Polyline { is_closed: self.bits(70) & 1 != 0, vertices })
    }
}

/// Vertices with the bulges of what starts there.
struct Polyline {
    is_closed: bool,
    vertices: Vec<([f64; 2], f64)>,
}

impl Polyline {
    fn add(&self, entity: &Entity, deviation: f64, to: &mut Strokes) -> Result<(), ReadError> {
        let count = if self.is_closed { self.vertices.len() } else { self.vertices.len().saturating_sub(1) };
        for k in 0..count {
            let ((from, bulge), (end, _)) = (self.vertices[k], self.vertices[(k + 1) % self.vertices.len()]);
            let mut points = match bulge == 0.0 || from == end {
                true => vec![from, end],
                false => Arc::bulge(from, end, bulge).chords(deviation),
            };
            let last = points.len() - 1;
            (points[0], points[last]) = (from, end);
            to.add(entity.stroke(points.into_iter().map(|p| entity.flipped(p)).collect()))?;
        }
        Ok(())
    }
}
