//! Points outside a body that complete the families at its edges: affine fits of the points inside.
//!
//! A ghost at `x_g` belongs to the nearest point `i`; the fit of least squares over the points y near it, with weights
//! `exp(−|y|²/(1.5 h)²)`, is `u_g = Σ c_y u_y`. Of points in a single row only what the row tells is used: the smallest
//! affine fit. So a linear displacement goes on beyond an edge, and ghosts carry no energy of their own.

use super::super::plane::Mirrors;
use crate::body::{Cell, SquareLattice, plus};
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;

/// How far the points of a fit are from its middle at most, spacings.
const FIT: f64 = 2.3;
/// Where the weight of a point of the fit has fallen to 1/e, spacings.
const FADE: f64 = 1.5;
/// How many spacings farther they may be where those do not tell how the body turns.
const WIDEST: i32 = 6;
/// Singular values below this part of the largest one count as zero.
const RANK: f64 = 1e-12;

/// Real points and their shares in a ghost.
pub(super) type Fit = Vec<(Cell, f64)>;

/// Whether something separates two cells.
pub(super) type Separated<'a> = dyn Fn(Cell, Cell) -> bool + 'a;

/// The cells outside a lattice that families reach, none of them beyond a line of `mirrors`.
pub(super) fn outside(real: &SquareLattice, mirrors: &Mirrors, offsets: &[Cell]) -> Vec<Cell> {
    let mut cells: Vec<Cell> = Vec::new();
    let reach = offsets.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
    for run in real.runs() {
        let inner = |row: i32| {
            let wide = run.columns.start - reach..run.columns.end + reach;
            real.runs_of(row, run.layer)
                .iter()
                .any(|r| r.columns.start <= wide.start && wide.end <= r.columns.end)
        };
        let is_inside = (run.row - reach..=run.row + reach).all(inner);
        if is_inside {
            continue;
        }
        for column in run.columns.clone() {
            let beyond = offsets.iter().map(|o| plus(run.cell(column), *o));
            cells.extend(beyond.filter(|&c| mirrors.is_real(c) && real.number(c).is_none()));
        }
        if cells.len() > 1 << 20 {
            cells.sort_unstable();
            cells.dedup();
        }
    }
    cells.sort_unstable();
    cells.dedup();
    cells
}

/// The fit of every ghost. A fit takes no point that is separated from its middle, and none of a foreign material where those of its
/// own tell how the body turns.
pub(super) fn fits(
    real: &SquareLattice,
    ghosts: &[Cell],
    separated: &Separated,
    foreign: &Separated,
) -> BTreeMap<Cell, Fit> {
    let fit = |&ghost: &Cell| Some((ghost, affine(real, ghost, nearest(real, ghost)?, (separated, foreign))));
    ghosts.iter().filter_map(fit).collect()
}

/// The cell of the body that is nearest to another, of several the first by row and column.
pub(super) fn nearest(real: &SquareLattice, [column, row, layer]: Cell) -> Option<Cell> {
    let rows = real.rows();
    let mut best: Option<(i64, Cell)> = None;
    let far = (rows.end - row).abs().max((row - rows.start).abs());
    for step in 0..=far {
        let square = i64::from(step) * i64::from(step);
        if best.is_some_and(|b| b.0 < square) {
            break;
        }
        for other in if step == 0 { vec![row] } else { vec![row - step, row + step] } {
            for run in real.runs_of(other, layer) {
                let at = column.clamp(run.columns.start, run.columns.end - 1);
                let across = i64::from(at - column);
                let found = (square + across * across, run.cell(at));
                if best.is_none_or(|b| (found.0, found.1[1], found.1[0]) < (b.0, b.1[1], b.1[0])) {
                    best = Some(found);
                }
            }
        }
    }
    best.map(|b| b.1)
}

/// Shares of the points near `middle` in a ghost. Where those nearest stand in one row, as in a ligament one cell wide, farther ones
/// are taken, too, as far as it takes: a fit that does not know how the body turns would resist it.
fn affine(
    real: &SquareLattice,
    ghost: Cell,
    middle: Cell,
    (separated, foreign): (&Separated, &Separated),
) -> Fit {
    let of_all = |wider: i32| of_points_within(real, ghost, middle, (separated, wider));
    let stays = |a: Cell, b: Cell| separated(a, b) || foreign(a, b);
    let of_own = |wider: i32| of_points_within(real, ghost, middle, (&stays, wider));
    let whole = |(fit, is_whole): (Fit, bool)| is_whole.then_some(fit);
    let own = (0..=WIDEST).find_map(|wider| whole(of_own(wider)));
    own.or_else(|| (0..=WIDEST).find_map(|wider| whole(of_all(wider)))).unwrap_or_else(|| of_all(0).0)
}

/// The fit to the points near `middle`, some steps wider than usual, and whether they tell all of it.
fn of_points_within(
    real: &SquareLattice,
    ghost: Cell,
    middle: Cell,
    (separated, wider): (&Separated, i32),
) -> (Fit, bool) {
    let far = FIT + f64::from(wider);
    let fade = FADE * far / FIT;
    let most = far.floor() as i32;
    let near = (-most..=most).flat_map(|b| (-most..=most).map(move |a| [a, b, 0]));
    let near = near.filter(|[a, b, _]| f64::from(a * a + b * b) <= far * far);
    let cells: Vec<(Cell, Vector3<f64>, f64)> = near
        .map(|step| (plus(middle, step), [f64::from(step[0]), f64::from(step[1])]))
        .filter(|(cell, _)| real.number(*cell).is_some() && !separated(middle, *cell))
        .map(|(cell, [x, y])| (cell, Vector3::new(1.0, x, y), (-(x * x + y * y) / (fade * fade)).exp()))
        .collect();
    let mut gram = Matrix3::zeros();
    for (_, row, weight) in &cells {
        gram += *weight * row * row.transpose();
    }
    let svd = gram.svd(true, true);
    let (least, most) = (svd.singular_values.min(), svd.singular_values.max());
    let at = Vector3::new(1.0, f64::from(ghost[0] - middle[0]), f64::from(ghost[1] - middle[1]));
    let shares = svd.solve(&at, RANK * most).unwrap_or_else(|_| Vector3::zeros());
    let fit = cells.into_iter().map(|(cell, row, weight)| (cell, weight * shares.dot(&row))).collect();
    (fit, least > RANK * most)
}

/// Bonds from ghosts, images of them among those, to points from which the nearest point of the ghost is separated.
pub(super) fn parted_ghosts(
    (real, lattice, mirrors): (&SquareLattice, &SquareLattice, &Mirrors),
    ghosts: &BTreeMap<Cell, Fit>,
    half: &[Cell],
    separated: &Separated,
) -> Vec<(usize, usize)> {
    let mut parted = Vec::new();
    if ghosts.is_empty() {
        return parted;
    }
    let is_point = |cell: Cell| real.number(mirrors.image(cell).0).is_some();
    for own in 0..lattice.points() {
        let cell = lattice.cell(own);
        let (ghost, signs) = mirrors.image(cell);
        if real.number(ghost).is_some() {
            continue;
        }
        let Some(middle) = ghosts.get(&ghost).and_then(|_| nearest(real, ghost)) else { continue };
        for (k, &step) in half.iter().enumerate() {
            for up in [true, false] {
                let step = if up { step } else { step.map(|k| -k) };
                let other = lattice.number(plus(cell, step)).filter(|_| is_point(plus(cell, step)));
                // An image sees what its ghost sees, mirrored.
                let seen = plus(ghost, [0, 1, 2].map(|k| signs[k] as i32 * step[k]));
                if let Some(other) = other.filter(|_| separated(middle, seen)) {
                    parted.push((k, if up { own } else { other }));
                }
            }
        }
    }
    parted
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: fn(Cell, Cell) -> bool = |_, _| false;

    fn ring() -> Vec<Cell> {
        (-3..=3).flat_map(|b| (-3..=3).map(move |a| [a, b, 0])).filter(|c| *c != [0; 3]).collect()
    }

    #[test]
    fn linear_displacements_go_on_beyond_edges_and_corners() {
        let real = SquareLattice::plane(1.0, [0.0; 2], 0..8, 0..7, |c| c != [4, 3]);
        let ghosts = outside(&real, &Mirrors::NONE, &ring());
        assert_eq!(ghosts.len(), 14 * 13 - 55);
        let fits = fits(&real, &ghosts, &NONE, &NONE);
        for (ghost, fit) in &fits {
            let sum = |of: &dyn Fn(Cell) -> f64| fit.iter().map(|(c, share)| share * of(*c)).sum::<f64>();
            assert!((sum(&|_| 1.0) - 1.0).abs() < 1e-13);
            for k in 0..2 {
                assert!((sum(&|c| f64::from(c[k])) - f64::from(ghost[k])).abs() < 1e-12, "{ghost:?}");
            }
        }
    }

    #[test]
    fn a_single_row_is_continued_along_itself() {
        let real = SquareLattice::rectangle(1.0, [0.0; 2], [9, 1]);
        let fit = affine(&real, [-2, 0, 0], nearest(&real, [-2, 0, 0]).unwrap(), (&NONE, &NONE));
        assert!(fit.iter().all(|(cell, _)| cell[1] == 0));
        let linear: f64 = fit.iter().map(|(c, share)| share * f64::from(c[0])).sum();
        assert!((linear + 2.0).abs() < 1e-13);
    }

    /// A ligament of one row between two blocks.
    #[test]
    fn a_ligament_of_one_row_turns_with_the_body() {
        let inside = |[i, j]: [i32; 2]| j == 3 || !(5..12).contains(&i);
        let real = SquareLattice::plane(1.0, [0.0; 2], 0..17, 0..7, inside);
        let ghosts = outside(&real, &Mirrors::NONE, &ring());
        for (ghost, fit) in &fits(&real, &ghosts, &NONE, &NONE) {
            for k in 0..2 {
                let linear: f64 = fit.iter().map(|(c, share)| share * f64::from(c[k])).sum();
                assert!((linear - f64::from(ghost[k])).abs() < 1e-9, "{ghost:?} {k}: {linear}");
            }
        }
    }

    #[test]
    fn no_cell_beyond_a_mirror_is_a_ghost_and_no_fit_crosses_a_crack() {
        let real = SquareLattice::rectangle(1.0, [0.0; 2], [6, 6]);
        let mirrors = Mirrors::in_plane([Some(0), None], [None; 2]);
        assert!(outside(&real, &mirrors, &ring()).iter().all(|c| c[0] >= 0));
        let apart = |a: Cell, b: Cell| (a[1] < 3) != (b[1] < 3);
        let fit = affine(&real, [6, 3, 0], [5, 3, 0], (&apart, &NONE));
        assert!(fit.iter().all(|(cell, _)| cell[1] >= 3));
    }
}
