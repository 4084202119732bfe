//! Forces and moments along lines on plates.

use super::border::Side;
use super::plate_loads::PlateLoads;
use super::site::Site;
use super::{statics, symmetry};
use crate::case::{Amount, LineLoad};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::PlateBending;

/// A piece of a loaded line: its points, the normal of the true edge, and how much of its length counts.
struct Piece {
    points: [u32; 2],
    normal: [f64; 2],
    share: f64,
}

/// Adds a load along a line.
pub(super) fn add(
    load: &LineLoad,
    (site, factor): (&Site, Option<f64>),
    plate: &PlateBending,
    path: &JsonPath,
    to: &mut PlateLoads,
    faults: &mut Faults,
) {
    let pieces = match (&load.edge, load.from, load.to) {
        (Some(name), None, None) => match site.sides(name) {
            Some(sides) => {
                for edge in site.ground.edges_of(name) {
                    symmetry::not_mirrored(site, &edge, &path.key("edge"), faults);
                }
                sides.iter().map(of_side).collect()
            }
            None => {
                faults
                    .error(path.key("edge"), format!("there is no edge `{}`", &**name))
                    .hint(crate::diagnostic::suggest(name, site.outline.border_names()));
                return;
            }
        },
        (None, Some(from), Some(end)) => match inside(site, from, end, path, faults) {
            Some(pieces) => pieces,
            None => return,
        },
        _ => {
            faults
                .error(path.clone(), "a line load needs its place: `edge`, or `from` and `to`")
                .hint(r#"for example { "line": { "edge": "right", "force": -100.0 } }"#);
            return;
        }
    };
    let is_edge = load.edge.is_some();
    for (key, given) in [("moment_n", &load.moment_n), ("moment_t", &load.moment_t)] {
        if given.is_some() && !is_edge {
            faults.error(path.key(key), format!("`{key}` is for edges")).hint("name an `edge`");
        }
    }
    let mut given = |key: &str, amount: &Option<Amount>| {
        amount.as_ref().and_then(|amount| Prescribed::new(amount, (2, factor), &path.key(key), faults))
    };
    let [force, normal, tangent] =
        [given("force", &load.force), given("moment_n", &load.moment_n), given("moment_t", &load.moment_t)];
    if factor.is_none()
        && [&force, &normal, &tangent].iter().all(|part| part.as_ref().is_none_or(Prescribed::is_zero))
    {
        faults.error(path.clone(), "this load is zero").hint("give `force`, or `moment_n` on an edge");
    }
    let at = |of: &Option<Prescribed>, [x, y]: [f64; 2]| match of {
        Some(of) => of.at([x, y, 0.0]).unwrap_or(f64::NAN),
        None => 0.0,
    };
    let value = |piece: usize, place: [f64; 2]| {
        let Piece { normal: [x, y], share, .. } = pieces[piece];
        let [f, m, t] = [&force, &normal, &tangent].map(|part| share * at(part, place));
        [f, m * x - t * y, m * y + t * x]
    };
    let segments: Vec<[u32; 2]> = pieces.iter().map(|piece| piece.points).collect();
    plate.add_line(&segments, value, &mut to.force);
    for (k, segment) in segments.iter().enumerate() {
        let [a, b] = segment.map(|p| site.nodes.place(p as usize));
        let middle = [0, 1].map(|c| 0.5 * (a[c] + b[c]));
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        statics::act(&mut to.asked, value(k, middle).map(|part| length * part), middle);
    }
    let is_formula = |of: &Option<Prescribed>| matches!(of, Some(Prescribed::Formula(_)));
    to.is_approximate |= [&force, &normal, &tangent].into_iter().any(is_formula);
}

/// A side of a cell counts with what it has of the length of the true edge.
fn of_side(side: &Side) -> Piece {
    let [x, y] = side.segment.outward;
    let share = (x * side.normal[0] + y * side.normal[1]).max(0.0);
    Piece { points: side.segment.points, normal: side.normal, share }
}

/// Pieces of a line along a row or a column from point to point.
fn inside(
    site: &Site,
    from: [f64; 2],
    to: [f64; 2],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<Piece>> {
    let cells = site.nodes.cells();
    let ends = [from, to].map(|place| cells.in_cells(place));
    let [start, end] = ends.map(|at| at.map(|x| x.round() as i32));
    let is_on_point = |at: [f64; 2]| at.iter().all(|x| (x - x.round()).abs() < 1e-6);
    let is_along = start[0] == end[0] || start[1] == end[1];
    if !ends.into_iter().all(is_on_point) || !is_along || start == end {
        faults
            .error(path.key("to"), "a line runs along x or y from one point of the lattice to another")
            .hint("its ends are whole multiples of the spacing from the corner of the plate");
        return None;
    }
    let step = [0, 1].map(|k| (end[k] - start[k]).signum());
    let count = (end[0] - start[0]).abs().max((end[1] - start[1]).abs());
    let node = |k: i32| [start[0] + k * step[0], start[1] + k * step[1]];
    let piece = |k: i32| {
        let [a, b] = [node(k), node(k + 1)];
        let lower = [a[0].min(b[0]), a[1].min(b[1])];
        let is_in = site.nodes.is_joined(lower, usize::from(step[0] == 0));
        let points = [site.nodes.number(a).filter(|_| is_in)? as u32, site.nodes.number(b)? as u32];
        Some(Piece { points, normal: [0.0; 2], share: 1.0 })
    };
    let pieces: Option<Vec<Piece>> = (0..count).map(piece).collect();
    if pieces.is_none() {
        faults.error(path.clone(), "this line leaves the plate").hint("give the parts that lie on it");
    }
    pieces
}
