//! Every load of every model on every border: the reactions must balance the force and the moment that are asked for.

mod asked;
mod bodies;
mod forces;
mod hold;
mod lines;
mod medium;
mod notches;
mod repeated;
mod shells;
mod traction;

use crate::stress::row::{BALANCED, Resultant, Row, Wish};
use asked::{Across, Asked, Edge};
use bodies::Body;
use hold::{Hold, holds};
use medium::{Medium, media};
use serde_json::{Value, json};
use traction::{Course, SHARINGS, Sharing, TRACTIONS, Way, traction};

pub(crate) fn rows() -> Vec<Row> {
    let media = media();
    let of = |medium: &Medium| {
        [
            edges(medium),
            slanted(medium),
            around_holes(medium),
            beside_holes(medium),
            notches::rows(medium),
            repeated::rows(medium),
            forces::rows(medium),
        ]
        .concat()
    };
    media.iter().flat_map(of).chain(shells::rows()).chain(lines::rows()).collect()
}

/// Where a body begins.
fn origin(medium: &Medium) -> [f64; 2] {
    [medium.inner, 1.0]
}

/// A body under loads, held in some way.
struct Loaded<'a> {
    medium: &'a Medium,
    body: &'a Body,
    hold: &'a Hold,
}

impl Loaded<'_> {
    fn row(&self, sweep: &'static str, what: &str, loads: Value, asked: &Asked) -> Row {
        let Self { medium, body, hold } = self;
        let mut case = medium.case(&body.case);
        case["supports"] = json!(hold.supports);
        case["rigid"] = json!(hold.rigid);
        case["loads"] = loads;
        let at = format!("{}, {}, {what}, held by {}", medium.name, body.name, hold.name);
        let mut row = Row::new(medium.model, sweep, at, case, body.cells);
        let is_ring = medium.is_revolved();
        row.wish = hold.wish;
        row.resultant = Some(Resultant {
            // A ring has neither a force along its radius nor a moment as a whole.
            force: [(!is_ring).then_some(asked.force[0]), Some(asked.force[1])],
            moment: (hold.tells_moment && !is_ring).then_some(asked.moment),
            size: asked.size,
            length: body.length(),
            bound: BALANCED,
            places: hold.places.clone(),
        });
        row
    }
}

/// Whether a traction can be asked for: what is consistent needs an edge along the lattice.
fn is_asked(medium: &Medium, sharing: Sharing, is_slanted: bool) -> bool {
    let is_free = medium.is_turned || is_slanted;
    !(is_free && sharing == Sharing::Consistent)
}

/// Whether an edge is the axis of a body of revolution.
fn is_axis(medium: &Medium, edge: &Edge) -> bool {
    medium.is_revolved() && edge.from[0] == 0.0 && edge.to[0] == 0.0
}

/// Every traction on every edge of a rectangle, in every sharing; ways to hold it take turns.
fn edges(medium: &Medium) -> Vec<Row> {
    on_edges(medium, &bodies::rectangle(origin(medium)), "asked and applied: tractions on edges")
}

/// The same on the edges of a pentagon.
fn slanted(medium: &Medium) -> Vec<Row> {
    on_edges(medium, &bodies::pentagon(origin(medium)), "asked and applied: tractions on slanted edges")
}

fn on_edges(medium: &Medium, body: &Body, sweep: &'static str) -> Vec<Row> {
    let mut rows = Vec::new();
    for edge in body.edges.iter().filter(|e| !is_axis(medium, e)) {
        let holds = holds(medium, body, edge.name);
        let is_slanted = edge.normal[0] * edge.normal[1] != 0.0;
        let all = TRACTIONS.into_iter().flat_map(|t| SHARINGS.map(|s| (t, s)));
        for ((course, way), sharing) in all.filter(|(_, s)| is_asked(medium, *s, is_slanted)) {
            let hold = &holds[rows.len() % holds.len()];
            let (load, asked) = traction(edge, (course, way), sharing, medium.across);
            let what = format!("{}, {course:?}, {way:?}, {sharing:?}", edge.name);
            let mut row = Loaded { medium, body, hold }.row(sweep, &what, json!([load]), &asked);
            // Where the body grows wider behind its edge, a shear cannot be consistent.
            if sharing == Sharing::Consistent && way == Way::Along && body.edges.len() != 4 {
                row.wish = Wish::Honest;
            }
            rows.push(row);
        }
    }
    rows
}

/// Tractions on holes.
fn around_holes(medium: &Medium) -> Vec<Row> {
    let (body, holes) = bodies::perforated(origin(medium));
    let holds = holds(medium, &body, "right");
    let mut rows = Vec::new();
    for hole in holes {
        for (key, value) in [
            ("uniform", json!([3.0, 0.0])),
            ("uniform", json!([0.0, -2.0])),
            ("total", json!([20.0, 50.0])),
            ("pressure", json!(4.0)),
        ] {
            let vector = || [0, 1].map(|k| value[k].as_f64().expect("a number"));
            let asked = match key {
                "uniform" => hole.uniform(vector(), medium.across),
                "total" => hole.total(vector()),
                _ => hole.pressure(4.0, medium.across),
            };
            let is_round = key == "pressure" && hole.name != "square";
            for sharing in SHARINGS {
                if sharing != Sharing::Consistent || is_round {
                    let mut load = json!({ "edge": hole.name, key: value });
                    sharing.write(&mut load);
                    let what = format!("{}, {key} {value}, {sharing:?}", hole.name);
                    let hold = &holds[rows.len() % holds.len()];
                    let sweep = "asked and applied: tractions on holes";
                    let row = Loaded { medium, body: &body, hold }.row(
                        sweep,
                        &what,
                        json!([{ "traction": load }]),
                        &asked,
                    );
                    rows.push(row);
                }
            }
        }
    }
    rows
}

/// Tractions on edges whose stress meets holes on its way.
fn beside_holes(medium: &Medium) -> Vec<Row> {
    let (body, _) = bodies::perforated(origin(medium));
    let mut rows = Vec::new();
    for edge in body.edges.iter().filter(|e| !is_axis(medium, e)) {
        let holds = holds(medium, &body, edge.name);
        for (t, sharing) in
            [(Course::Uniform, Way::Along), (Course::Linear, Way::Out), (Course::Parabolic, Way::Along)]
                .into_iter()
                .flat_map(|t| [Sharing::Usual, Sharing::Depth(9.0)].map(|s| (t, s)))
        {
            let hold = &holds[rows.len() % holds.len()];
            let (load, asked) = traction(edge, t, sharing, medium.across);
            let what = format!("{}, {t:?}, {sharing:?}", edge.name);
            let sweep = "asked and applied: tractions on edges";
            rows.push(Loaded { medium, body: &body, hold }.row(sweep, &what, json!([load]), &asked));
        }
    }
    rows
}
