//! Outlines of the case and of drawings, with arcs and names.

use super::files;
use crate::case::{ArcTo, CircleHole, Hole, OutlineBody, PolygonHole, Vertex};
use crate::diagnostic::{Faults, JsonPath, positive, suggest, tidy};
use crate::input::Folder;
use crate::input::drawing::curve::Arc;
use crate::input::drawing::{Drawing, DrawnHole};
use crate::input::gmsh::Part;
use peristat_assembly::body::{
    BORDER, BorderMember, Group, Outline, OutlineError, Polygon, PolygonError, SquareLattice,
};

/// How far chords are from their curve at most, spacings: an arc of radius R loses a third of it over R of its length, and a disc four times
/// that of its area.
const DEVIATION: f64 = 1e-4;
/// Radii of both ends of an arc differ by less than this part.
const SAME: f64 = 1e-6;

/// What an outline is made of.
pub(super) struct Plan {
    pub(super) vertices: Vec<[f64; 2]>,
    /// How many edges each side has.
    pub(super) sides: Vec<usize>,
    /// Those of the drawing come first.
    pub(super) holes: Vec<Hole>,
    /// How many holes are those of the drawing.
    pub(super) drawn: usize,
    names: Vec<(String, Vec<BorderMember>)>,
    parts: Vec<Part>,
    pub(super) file: Option<blake3::Hash>,
}

/// What a case gives of an outline, with its faults.
pub(super) fn plan(
    given: &OutlineBody,
    folder: &Folder,
    path: &JsonPath,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Plan> {
    let scale = given.scale.unwrap_or(1.0);
    let is_fine = positive(scale, "scale", path.key("scale"), faults);
    if given.file.is_none() && given.scale.is_some() {
        faults.error(path.key("scale"), "`scale` is for lengths of a file").hint("remove it");
    }
    // A spacing that is none has a fault of its own.
    let spacing = if given.spacing > 0.0 { given.spacing } else { 1.0 };
    match (&given.file, given.vertices.is_empty()) {
        (Some(file), true) if is_fine => {
            let deviation = DEVIATION * spacing / scale;
            let (drawing, hash) = files::drawing(folder, file, deviation, max_memory, path, faults)?;
            Some(Plan { file: Some(hash), ..Plan::of_drawing(drawing.scaled(scale), &given.holes) })
        }
        (Some(_), true) => None,
        (Some(_), false) => {
            faults
                .error(path.key("vertices"), "`vertices` and `file` are both given")
                .hint("remove one of them");
            None
        }
        (None, true) => {
            faults
                .error(path.clone(), "the outline has no `vertices` and no `file`")
                .hint(r#"give "vertices": [[0, 0], [1, 0], [1, 1]], or "file" with a drawing"#);
            None
        }
        (None, false) => {
            let (vertices, sides) = with_arcs(&given.vertices, DEVIATION * spacing, path, faults)?;
            let holes = given.holes.clone();
            Some(Plan { vertices, sides, holes, drawn: 0, names: Vec::new(), parts: Vec::new(), file: None })
        }
    }
}

impl Plan {
    fn of_drawing(drawing: Drawing, more: &[Hole]) -> Self {
        let Drawing { border, holes, names, parts } = drawing;
        let name = |k: usize| {
            let is_it = |(_, members): &&(String, Vec<BorderMember>)| members[..] == [BorderMember::Hole(k)];
            names.iter().find(is_it).map(|(name, _)| name.clone())
        };
        let hole = |(k, hole): (usize, DrawnHole)| match hole {
            DrawnHole::Circle { centre, radius } => {
                Hole::Circle(CircleHole { name: name(k), centre, radius })
            }
            DrawnHole::Loop(hole) => Hole::Polygon(PolygonHole { name: name(k), vertices: hole.vertices }),
        };
        let mut holes: Vec<Hole> = holes.into_iter().enumerate().map(hole).collect();
        let drawn = holes.len();
        holes.extend(more.iter().cloned());
        let names = names.into_iter().filter(|(_, members)| !matches!(members[..], [BorderMember::Hole(_)]));
        let names = names.collect();
        Self { vertices: border.vertices, sides: border.sides, holes, drawn, names, parts, file: None }
    }

    /// Gives an outline the names of the drawing, and those of the case.
    pub(super) fn name(
        &self,
        given: &OutlineBody,
        outline: &mut Outline,
        path: &JsonPath,
        faults: &mut Faults,
    ) {
        for (name, members) in &self.names {
            outline.name(name, members.clone());
        }
        for (name, parts) in &given.edges {
            let place = path.key("edges").key(name);
            if outline.members(name).is_some() {
                faults
                    .error(place, format!("the name `{name}` is that of an edge or a hole"))
                    .hint("give these another name");
                continue;
            }
            let mut members = Vec::new();
            for (k, part) in parts.each().iter().enumerate() {
                match outline.members(part) {
                    Some(found) => members.extend(found),
                    None => {
                        let place = if parts.is_list() { place.index(k) } else { place.clone() };
                        faults
                            .error(place, format!("there is no edge or hole `{part}`"))
                            .hint(suggest(part, outline.border_names()));
                    }
                }
            }
            outline.name(name, members);
        }
    }

    /// Points of the named parts of a mesh.
    pub(super) fn groups(&self, lattice: &SquareLattice) -> Vec<Group> {
        self.parts
            .iter()
            .map(|part| Group { name: part.name.clone(), points: points(part, lattice) })
            .collect()
    }
}

/// A fault of an outline by the numbers of its sides.
pub(super) fn by_sides(error: OutlineError, sides: &[usize]) -> OutlineError {
    let side = |edge: usize| {
        let mut ends = sides.iter().scan(0, |end, count| {
            *end += count;
            Some(*end)
        });
        ends.position(|end| edge <= end).map_or(edge, |k| k + 1)
    };
    match error {
        OutlineError::Polygon(PolygonError::Crosses { first, second }) => {
            PolygonError::Crosses { first: side(first), second: side(second) }.into()
        }
        OutlineError::Polygon(PolygonError::Repeated { vertex, next }) => {
            PolygonError::Repeated { vertex: side(vertex), next: side(next) }.into()
        }
        other => other,
    }
}

/// Points whose places are in elements of a part, sides included.
fn points(part: &Part, lattice: &SquareLattice) -> Vec<u32> {
    let mut found = Vec::new();
    let slack = BORDER * lattice.spacing();
    for corners in &part.elements {
        let Ok(element) = Polygon::new(corners.clone()) else { continue };
        let [low, high] = element.bounds();
        // Turned rows have other cells at the corners of a box.
        let ends = [low, [high[0], low[1]], high, [low[0], high[1]]].map(|at| lattice.cell_at(at));
        let range = |k: usize| {
            let along = ends.map(|cell| cell[k]);
            along.iter().min().copied().unwrap_or(0) - 1..=along.iter().max().copied().unwrap_or(0) + 1
        };
        let cells = range(1).flat_map(|row| range(0).map(move |column| [column, row, 0]));
        let inside = |at: [f64; 2]| {
            let near = [[0.0, 0.0], [slack, 0.0], [-slack, 0.0], [0.0, slack], [0.0, -slack]];
            near.iter().any(|d| element.contains([at[0] + d[0], at[1] + d[1]]))
        };
        let numbers = cells.filter_map(|cell| lattice.number(cell));
        found.extend(numbers.filter(|p| inside(lattice.place(*p))).map(|p| p as u32));
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Vertices with those of the chords of arcs, and how many edges each side has.
fn with_arcs(
    given: &[Vertex],
    deviation: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(Vec<[f64; 2]>, Vec<usize>)> {
    let (mut vertices, mut sides, mut is_fine) = (Vec::new(), Vec::new(), true);
    for (k, vertex) in given.iter().enumerate() {
        let next = (k + 1) % given.len();
        vertices.push(vertex.at());
        let Vertex::Arc(to) = &given[next] else {
            sides.push(1);
            continue;
        };
        match arc(vertex.at(), to, &path.key("vertices").index(next), faults) {
            Some(arc) => {
                let chords = arc.chords(deviation);
                vertices.extend(&chords[1..chords.len() - 1]);
                sides.push(chords.len() - 1);
            }
            None => is_fine = false,
        }
    }
    is_fine.then_some((vertices, sides))
}

/// The arc from a vertex to the next one.
fn arc(from: [f64; 2], to: &ArcTo, path: &JsonPath, faults: &mut Faults) -> Option<Arc> {
    let numbers = [Some(from), Some(to.arc_to), to.through, to.centre];
    if !numbers.iter().flatten().flatten().all(|x| x.is_finite()) {
        faults.error(path.clone(), "a coordinate of this arc is not finite");
        return None;
    }
    match (to.through, to.centre) {
        (Some(through), None) => {
            if to.clockwise {
                let message = "`clockwise` goes with `centre`: `through` says how the arc runs";
                faults.error(path.key("clockwise"), message).hint("remove it");
            }
            let arc = Arc::through(from, through, to.arc_to);
            if arc.is_none() {
                faults
                    .error(path.key("through"), "this position is on a line with the ends of the arc")
                    .hint("give one that the arc passes between its ends, or a plain vertex for a straight edge");
            }
            arc
        }
        (None, Some(centre)) => {
            let [start, end] = [from, to.arc_to].map(|p| (p[0] - centre[0]).hypot(p[1] - centre[1]));
            if start.max(end) == 0.0 || (start - end).abs() > SAME * start.max(end) {
                let [start, end] = [start, end].map(tidy);
                faults
                    .error(
                        path.key("centre"),
                        format!("the centre of this arc is {start} from its start and {end} from its end"),
                    )
                    .hint("give a centre as far from both, or a position `through` which the arc runs");
                return None;
            }
            if from == to.arc_to {
                faults
                    .error(path.key("arc_to"), "this arc ends where it starts")
                    .hint("give a circle as two arcs");
                return None;
            }
            Some(Arc::around(centre, from, to.arc_to, to.clockwise))
        }
        (both, _) => {
            let message = if both.is_some() {
                "`through` and `centre` are both given"
            } else {
                "this arc has neither `through` nor `centre`"
            };
            faults.error(path.clone(), message).hint("give one of `through` and `centre`");
            None
        }
    }
}
