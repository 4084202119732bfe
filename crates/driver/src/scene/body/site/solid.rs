//! The points of a block with cuts, and its walls.

use super::body::{BuiltSolid, PER_POINT, resolves};
use crate::case::{BallCut, Body, BoreCut, Case, SolidCut};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::memory;
use crate::model::Keys;
use peristat_assembly::body::{Cut, CutError, PointBody, ShapeError, SolidShape};

/// The body of a case whose model is one of solids.
pub(crate) fn build(
    (case, keys): (&Case, &dyn Keys),
    path: &JsonPath,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<(PointBody, BuiltSolid)> {
    let Body::Block(given) = &case.body else {
        let name = case.model.name();
        if matches!(case.body, Body::Points(_)) {
            let message = format!("the model `{name}` takes no listed points");
            faults.error(path.clone(), message).hint("listed points are for solids of central bonds");
            return None;
        }
        let bodies = if keys.takes_points() { "`block`, `solid` or `points`" } else { "`block` or `solid`" };
        let hint = format!("take {bodies}; `rectangle` and `outline` are for bodies in the plane");
        faults.error(root("body"), format!("the model `{name}` needs a body in space")).hint(hint);
        return None;
    };
    let mut shape = match SolidShape::block(given.from, given.size) {
        Ok(shape) => shape,
        Err(error) => {
            let place = match error {
                ShapeError::Size { axis, .. } => path.key("size").index(axis),
                _ => path.key("from"),
            };
            faults.error(place, error.to_string());
            return None;
        }
    };
    for (k, cut) in given.cuts.iter().enumerate() {
        let path = path.key("cuts").index(k);
        let name = cut.name().cloned();
        let (key, cut) = of_case(cut);
        if let Some(name) = name.as_ref().filter(|name| shape.walls().iter().any(|wall| wall.name == **name))
        {
            faults
                .error(path.key(key).key("name"), format!("the name `{name}` is taken"))
                .hint("every cut has a name of its own, which is that of no face");
            return None;
        }
        if let Err(error) = shape.cut(name, cut) {
            let path = path.key(key);
            let place = match error {
                CutError::Radius { .. } => path.key("radius"),
                CutError::Size { axis, .. } => path.key("size").index(axis),
                CutError::NotFinite => path,
            };
            faults.error(place, error.to_string());
            return None;
        }
    }
    let bounds = shape.bounds();
    if !resolves(bounds, given.spacing, &path.key("from"), faults) {
        return None;
    }
    let filled = shape.cells(given.spacing).and_then(|cells| {
        let points: f64 = cells.map(f64::from).iter().product();
        let what = format!("{points:e} points");
        let fits = memory::fits(
            points * PER_POINT,
            (&what, "use a larger spacing"),
            max_memory,
            path.key("spacing"),
            faults,
        );
        Ok(if fits { Some(shape.fill(given.spacing)?) } else { None })
    });
    match filled {
        Ok(lattice) => {
            let sides = shape.faces().map(|face| Some(face.at));
            let solid = BuiltSolid { walls: shape.walls(), sides, parts: Vec::new() };
            Some((PointBody::Solid(lattice?), solid))
        }
        Err(error) => {
            unfilled(&error, path, faults);
            None
        }
    }
}

/// A cut as the mechanics knows it, with its key.
fn of_case(cut: &SolidCut) -> (&'static str, Cut) {
    let ball = |b: &BallCut, outside| Cut::Ball { centre: b.centre, radius: b.radius, outside };
    let bore = |b: &BoreCut, outside| Cut::Bore {
        axis: b.along.number(),
        centre: b.centre,
        radius: b.radius,
        outside,
    };
    match cut {
        SolidCut::Block(b) => {
            ("block", Cut::Block { from: b.from, to: [0, 1, 2].map(|k| b.from[k] + b.size[k]) })
        }
        SolidCut::Ball(b) => ("ball", ball(b, false)),
        SolidCut::Bore(b) => ("bore", bore(b, false)),
        SolidCut::OutsideBall(b) => ("outside_ball", ball(b, true)),
        SolidCut::OutsideCylinder(b) => ("outside_cylinder", bore(b, true)),
    }
}

/// A fault for a shape that cells do not fill.
fn unfilled(error: &ShapeError, path: &JsonPath, faults: &mut Faults) {
    let spacing = path.key("spacing");
    match error {
        ShapeError::NotWhole { cells, fitting } => {
            let [a, b, c] = cells.map(tidy);
            let message = format!("the block is {a} × {b} × {c} cells, which are not whole numbers");
            let numbers: Vec<String> = fitting.iter().map(|s| tidy(*s)).collect();
            faults.error(path.key("size"), message).hint(match &numbers[..] {
                [] => "all sides must be whole multiples of the spacing".to_string(),
                [one] => format!("the nearest spacing that fits is {one}"),
                _ => format!("the nearest spacings that fit are {}", numbers.join(" and ")),
            });
        }
        ShapeError::TooManyCells { .. } => {
            faults.error(spacing, error.to_string()).hint(format!("at most {} fit into the block", u32::MAX));
        }
        ShapeError::NoCellInCut { cut } => {
            faults
                .error(path.key("cuts").index(*cut), error.to_string())
                .hint("use a smaller spacing; a cut needs several cells to be one");
        }
        ShapeError::NoPoints => {
            faults.error(path.key("cuts"), "nothing is left of the block").hint("cut less out of it");
        }
        ShapeError::Spacing { .. } | ShapeError::Size { .. } | ShapeError::Corner => {
            faults.error(spacing, error.to_string());
        }
    }
}
