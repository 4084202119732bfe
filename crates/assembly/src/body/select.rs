//! Points of a body in convex parts of the plane, and nearest to a position.

use super::cloud::Cloud;
use super::convex::Convex;
use super::geometry::{Point, distance};
use super::lattice::SquareLattice;
use super::{BORDER, PointBody};

/// Numbers of the points in a part of the plane, ascending.
pub(super) fn points_in(body: &PointBody, part: &Convex) -> Vec<u32> {
    match body {
        // Parts of the plane are none of solids.
        _ if body.is_solid() => Vec::new(),
        PointBody::Lattice(lattice) | PointBody::Solid(lattice) => on_lattice(lattice, part),
        PointBody::Cloud(cloud) => {
            let inside = |k: &u32| part.contains(cloud.place(*k as usize));
            (0..cloud.points() as u32).filter(inside).collect()
        }
    }
}

fn on_lattice(lattice: &SquareLattice, part: &Convex) -> Vec<u32> {
    let (rows, columns) = (lattice.rows(), lattice.columns());
    let part = lattice.inner_part(part);
    let start = lattice.inner_corner();
    let first = |k: usize, x: f64| ((x - start[k]) / lattice.spacing() - 0.5).ceil();
    let behind = |k: usize, x: f64| ((x - start[k]) / lattice.spacing() - 0.5).floor() + 1.0;
    // Conversions to integers saturate.
    let [low, high] = part.rows();
    let mut found = Vec::new();
    for row in rows.start.max(first(1, low) as i32)..rows.end.min(behind(1, high) as i32) {
        let Some([from, to]) = part.row(lattice.inner_centre([0, row, 0])[1]) else { continue };
        let from = columns.start.max(first(0, from) as i32);
        let to = columns.end.min(behind(0, to) as i32);
        for run in lattice.runs_of(row, 0) {
            let (from, to) = (from.max(run.columns.start), to.min(run.columns.end));
            if from < to {
                let number = run.number(from) as u32;
                found.extend(number..number + (to - from) as u32);
            }
        }
    }
    found
}

/// The points nearest to a position: more than one if they are equally far, within [`BORDER`].
pub(super) fn nearest(body: &PointBody, to: Point) -> Vec<u32> {
    let least = match body {
        PointBody::Lattice(lattice) | PointBody::Solid(lattice) => nearest_cell(lattice, to),
        PointBody::Cloud(cloud) => nearest_listed(cloud, to),
    };
    let radius = least + BORDER * body.spacing();
    points_in(body, &Convex::Stadium { from: to, to, radius })
}

/// Least distance of a position from a point: in every run the column nearest to it counts.
fn nearest_cell(lattice: &SquareLattice, to: Point) -> f64 {
    let [column, ..] = lattice.cell_at(to);
    let near = lattice.runs().iter().map(|run| {
        let column = column.clamp(run.columns.start, run.columns.end - 1);
        distance(lattice.place_of(run.cell(column)), to)
    });
    near.fold(f64::INFINITY, f64::min)
}

fn nearest_listed(cloud: &Cloud, to: Point) -> f64 {
    (0..cloud.points()).map(|p| distance(cloud.place(p), to)).fold(f64::INFINITY, f64::min)
}
