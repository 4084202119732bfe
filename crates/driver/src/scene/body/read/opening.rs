//! Openings of cracks between the rows of a lattice, as sums of displacements.

use super::probes::Quantity;
use crate::case::Probe;
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::site::interpolate::{Interpolation, Weights};
use crate::scene::words;
use peristat_assembly::body::{Cell, Crack, PointBody, SquareLattice};

/// Farthest point of a row from the place, in spacings: that next to the mouth is half a spacing away, its neighbour one
/// and a half.
const FARTHEST: f64 = 2.5;
/// Coordinates closer than this are the same, in spacings.
const SAME: f64 = 1e-6;

/// What to do where a crack does not run along the lattice.
const BY_HAND: &str = "take the difference of `ux` or `uy` of two points beside the crack instead";

/// What a probe of an opening reports, and what the user calls the place.
pub(crate) fn resolve(
    probe: &Probe,
    site: &HeldBody,
    at: &JsonPath,
    faults: &mut Faults,
) -> Option<(Quantity, String)> {
    let ground = site.ground;
    if ground.region_name(&probe.at, at, faults)?.is_some() {
        faults
            .error(at.key("region"), "`opening` is that of a crack at a position on it")
            .hint(r#"write { "x": 1.0, "y": 0.5 }"#);
        return None;
    }
    if probe.at.inward.is_some() {
        faults
            .error(at.key("inward"), "`opening` is extrapolated to the faces of its crack already")
            .hint("leave `inward` out");
        return None;
    }
    let position = ground.position(&probe.at, at, faults)?;
    let words = words::place(position, ground.body);
    let [x, y, _] = position;
    Some((opening([x, y], site.interpolation, at, faults)?, words))
}

/// The opening at a position of the crack nearest to it.
fn opening(position: [f64; 2], on: &Interpolation, path: &JsonPath, faults: &mut Faults) -> Option<Quantity> {
    let lattice = match on.body {
        PointBody::Lattice(lattice) if !lattice.is_turned() => lattice,
        _ => {
            faults
                .error(
                    path.clone(),
                    "`opening` is read from the rows of a lattice along x and y, and there are none",
                )
                .hint(BY_HAND);
            return None;
        }
    };
    let [x, y] = position.map(tidy);
    let Some((segment, foot)) = nearest(on.cracks, position) else {
        faults
            .error(path.clone(), "`opening` is that of a crack, and there is none")
            .hint("list it in `cracks`");
        return None;
    };
    let h = lattice.spacing();
    if (foot[0] - position[0]).hypot(foot[1] - position[1]) > (0.5 + SAME) * h {
        let [a, b] = foot.map(tidy);
        faults
            .error(path.clone(), format!("no crack is within half a spacing of ({x}, {y})"))
            .hint(format!("the nearest place on a crack is ({a}, {b})"));
        return None;
    }
    let ends = segment.map(|end| lattice.in_cells(end));
    let Some(axis) = [0, 1].into_iter().find(|&axis| (ends[1][axis] - ends[0][axis]).abs() < SAME) else {
        faults
            .error(
                path.clone(),
                format!("the crack at ({x}, {y}) runs along neither rows nor columns of points"),
            )
            .hint(BY_HAND);
        return None;
    };
    // Centres of cells are at whole numbers.
    let (plane, along) = (ends[0][axis] - 0.5, lattice.in_cells(position)[1 - axis] - 0.5);
    if (plane - plane.round()).abs() < SAME {
        let rows = ["column", "row"][axis];
        faults
            .error(
                path.clone(),
                format!("the crack at ({x}, {y}) runs through a {rows} of points, which are on neither face"),
            )
            .hint("move it by half a spacing");
        return None;
    }
    let found = faces(lattice, axis, plane, along);
    if found.is_none() {
        faults
            .error(
                path.clone(),
                format!("the crack at ({x}, {y}) has no two rows of two points on each of its sides"),
            )
            .hint("place the probe on the crack, where it is in the body or opens its edge");
    }
    Some(Quantity::Opening { component: axis, weights: found? })
}

/// The segment of cracks that is nearest to a position, and its place nearest to it.
fn nearest(cracks: &[Crack], at: [f64; 2]) -> Option<([[f64; 2]; 2], [f64; 2])> {
    let foot = |w: &[[f64; 2]]| {
        let (a, d) = (w[0], [w[1][0] - w[0][0], w[1][1] - w[0][1]]);
        let share = ((at[0] - a[0]) * d[0] + (at[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        let share = share.clamp(0.0, 1.0);
        ([w[0], w[1]], [0, 1].map(|k| a[k] + share * d[k]))
    };
    let far = |foot: &[f64; 2]| (foot[0] - at[0]).hypot(foot[1] - at[1]);
    let feet = cracks.iter().flat_map(|crack| crack.vertices().windows(2).map(foot));
    feet.min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)))
}

/// The displacement across a crack of its upper or right face less that of the other one: each is extrapolated to the crack
/// from the two rows next to it, and each row to the place from its two nearest points. The crack is at `plane` on an axis,
/// the place at `along` on the other one, in spacings from the centre of cell `[0, 0]`.
fn faces(lattice: &SquareLattice, axis: usize, plane: f64, along: f64) -> Option<Weights> {
    let below = plane.floor() as i32;
    let mut weights = Weights::new();
    for (first, step, sign) in [(below + 1, 1, 1.0), (below, -1, -1.0)] {
        let distance = (f64::from(first) - plane).abs();
        for (row, share) in [(first, 1.0 + distance), (first + step, -distance)] {
            let line = in_row(lattice, axis, row, along)?;
            weights.extend(line.into_iter().map(|(point, w)| (point, sign * share * w)));
        }
    }
    Some(weights)
}

/// The two points of a row that are nearest to a place, and the shares with which they extrapolate to it.
fn in_row(lattice: &SquareLattice, axis: usize, row: i32, along: f64) -> Option<[(u32, f64); 2]> {
    let cell = |k: i32| -> Cell { if axis == 0 { [row, k, 0] } else { [k, row, 0] } };
    let reach = (along - FARTHEST).ceil() as i32..=(along + FARTHEST).floor() as i32;
    let mut near: Vec<(f64, u32)> =
        reach.filter_map(|k| Some((f64::from(k), lattice.number(cell(k))? as u32))).collect();
    near.sort_by(|a, b| (a.0 - along).abs().total_cmp(&(b.0 - along).abs()));
    let [(a, first), (b, second), ..] = near[..] else { return None };
    let share = (along - a) / (b - a);
    Some([(first, 1.0 - share), (second, share)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Opening of a crack through a body of 8 × 6 cells of 0.5 in a field of displacements.
    fn of(path: [[f64; 2]; 2], position: [f64; 2], field: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
        let lattice = SquareLattice::rectangle(0.5, [1.0, 2.0], [8, 6]);
        let body = PointBody::Lattice(lattice.clone());
        let cracks = [Crack::new(path.into()).unwrap()];
        let on = Interpolation { body: &body, cracks: &cracks, reach: 3 };
        let mut faults = Faults::default();
        let found = opening(position, &on, &JsonPath::default(), &mut faults);
        let Some(Quantity::Opening { component, weights }) = found else { panic!("{faults:?}") };
        weights.iter().map(|&(p, w)| w * field(lattice.place(p as usize))[component]).sum()
    }

    #[test]
    fn faces_of_linear_displacements_part_exactly() {
        // Above the crack uy = 3 x + 2 y + 1, below x - y: at (x, 3.5) it opens by 2 x + 3 · 3.5 + 1.
        let field = |[x, y]: [f64; 2]| [9.0, if y > 3.5 { 3.0 * x + 2.0 * y + 1.0 } else { x - y }];
        for x in [1.0, 0.9, 1.3, 2.5, 4.75, 5.0] {
            let found = of([[0.5, 3.5], [5.0, 3.5]], [x, 3.5], field);
            assert!((found - (2.0 * x + 11.5)).abs() < 1e-12, "{x} {found}");
        }
        // A crack along y that is not midway between its columns, and a place beside it.
        let field = |[x, y]: [f64; 2]| [if x > 3.1 { 2.0 * x + y } else { x - y }, 9.0];
        let found = of([[3.1, 1.0], [3.1, 6.0]], [3.2, 2.6], field);
        assert!((found - (3.1 + 2.0 * 2.6)).abs() < 1e-12, "{found}");
    }

    #[test]
    fn a_rigid_motion_opens_nothing() {
        let field = |[x, y]: [f64; 2]| [0.3 - 0.1 * y, 0.7 + 0.1 * x];
        assert!(of([[0.5, 3.5], [4.0, 3.5]], [1.0, 3.5], field).abs() < 1e-14);
    }
}
