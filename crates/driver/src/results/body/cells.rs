//! Cells of a grid of points: quads where four points of a lattice are next to each other and no crack runs between them, and
//! hexahedra between eight points of a solid.

use crate::scene::body::BodyScene;
use peristat_assembly::body::{Cell, Crack, PointBody, SquareLattice, cut_bonds, plus};
use std::collections::BTreeSet;

/// Cells of the points of a body, images left out.
#[derive(Debug, Default, PartialEq)]
pub(super) struct GridCells {
    /// Four points each, around.
    pub(super) quads: Vec<u32>,
    /// Eight points each: four around, then those above them.
    pub(super) hexahedra: Vec<u32>,
    /// Points that are in none.
    pub(super) vertices: Vec<u32>,
}

/// Sides and diagonals of a quad, from its points.
const STEPS: [Cell; 4] = [[1, 0, 0], [0, 1, 0], [1, 1, 0], [-1, 1, 0]];

/// Cells of the body of a scene.
pub(super) fn cells(scene: &BodyScene) -> GridCells {
    match scene.body() {
        PointBody::Lattice(lattice) => {
            let cracks: Vec<Crack> = scene.cracks.iter().map(|c| c.crack.clone()).collect();
            on_lattice(lattice, &cracks)
        }
        PointBody::Solid(lattice) => in_solid(lattice),
        PointBody::Cloud(cloud) => {
            GridCells { vertices: (0..cloud.points() as u32).collect(), ..GridCells::default() }
        }
    }
}

fn on_lattice(lattice: &SquareLattice, cracks: &[Crack]) -> GridCells {
    let torn = torn(lattice, cracks);
    let mut cells = GridCells::default();
    let mut in_quad = vec![false; lattice.points()];
    for run in lattice.runs() {
        let own = run.columns.start..run.columns.end - 1;
        // Quads with a point above their first one; those of a stretch follow each other.
        lattice.shifted(run.line(), &own, [0, 1, 0], |columns, first| {
            for (column, above) in columns.zip(first..) {
                let point = run.number(column);
                let has_fourth = lattice.number(plus(run.cell(column), [1, 1, 0])).is_some();
                if has_fourth && !torn.contains(&run.cell(column)) {
                    let quad = [point, point + 1, above + 1, above];
                    quad.iter().for_each(|&p| in_quad[p] = true);
                    cells.quads.extend(quad.map(|p| p as u32));
                }
            }
        });
    }
    cells.vertices = (0..lattice.points()).filter(|&p| !in_quad[p]).map(|p| p as u32).collect();
    cells
}

/// Corners of a hexahedron from the first, in the order of its points.
const CORNERS: [Cell; 8] =
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];

fn in_solid(lattice: &SquareLattice) -> GridCells {
    let mut cells = GridCells::default();
    let mut is_in = vec![false; lattice.points()];
    for point in 0..lattice.points() {
        let first = lattice.cell(point);
        let corner = |step: Cell| lattice.number(plus(first, step));
        // Most have none or all: those along x and above tell soon.
        let corners: Option<Vec<usize>> = CORNERS.into_iter().rev().map(corner).collect();
        let Some(mut corners) = corners else { continue };
        corners.reverse();
        corners.iter().for_each(|&p| is_in[p] = true);
        cells.hexahedra.extend(corners.into_iter().map(|p| p as u32));
    }
    cells.vertices = (0..lattice.points()).filter(|&p| !is_in[p]).map(|p| p as u32).collect();
    cells
}

/// First cells of quads that a crack meets: it cuts a side or a diagonal.
fn torn(lattice: &SquareLattice, cracks: &[Crack]) -> BTreeSet<Cell> {
    let mut torn = BTreeSet::new();
    for (step, point) in cut_bonds(lattice, &STEPS, cracks) {
        let cell = lattice.cell(point);
        let first: &[Cell] = match STEPS[step] {
            [1, 0, _] => &[[0; 3], [0, -1, 0]],
            [0, 1, _] => &[[0; 3], [-1, 0, 0]],
            [-1, 1, _] => &[[-1, 0, 0]],
            _ => &[[0; 3]],
        };
        torn.extend(first.iter().map(|step| plus(cell, *step)));
    }
    torn
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quads_are_missing_at_holes_and_no_point_is_lost() {
        // 5 × 4 cells without the two in the middle, and one cell that hangs on a corner.
        let inside = |c: [i32; 2]| if c[0] > 4 { c == [5, 3] } else { c != [2, 1] && c != [2, 2] };
        let lattice = SquareLattice::plane(1.0, [0.0; 2], 0..6, 0..4, inside);
        let cells = on_lattice(&lattice, &[]);
        // Of 4 × 3 quads those with a missing corner are left out: 2 columns of 3; the outer cell has no quad.
        assert_eq!(cells.quads.len(), 4 * (12 - 6));
        assert_eq!(cells.vertices.len(), 3);
        assert_eq!(&cells.quads[..4], &[0, 1, 6, 5]);
        for quad in cells.quads.as_chunks::<4>().0 {
            let [a, b, c, d] = quad.map(|p| lattice.cell(p as usize));
            assert_eq!([b, c, d], [[1, 0, 0], [1, 1, 0], [0, 1, 0]].map(|step| plus(a, step)));
        }
    }

    #[test]
    fn quads_have_the_sides_of_turned_cells() {
        let lattice = SquareLattice::rectangle(0.5, [0.0; 2], [6, 4]).turned(0.4, [1.0, 2.0]);
        let cells = on_lattice(&lattice, &[]);
        assert_eq!(cells.quads.len(), 4 * 15);
        for quad in cells.quads.as_chunks::<4>().0 {
            let at = quad.map(|p| lattice.position(p as usize));
            for k in 0..4 {
                let (a, b) = (at[k], at[(k + 1) % 4]);
                assert!(((a[0] - b[0]).hypot(a[1] - b[1]) - 0.5).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn no_quad_lies_across_a_crack() {
        let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [6, 6]);
        let crack = Crack::new(vec![[-1.0, 3.0], [3.0, 3.0]]).unwrap();
        let cells = on_lattice(&lattice, &[crack]);
        // Between the rows at 2.5 and 3.5 the quads from x = 0.5 to 3.5 are torn, the last one by the tip.
        assert_eq!(cells.quads.len() / 4, 25 - 3);
        assert!(cells.vertices.is_empty());
        let slanted = Crack::new(vec![[1.0, 1.0], [5.0, 4.0]]).unwrap();
        for quad in on_lattice(&lattice, std::slice::from_ref(&slanted)).quads.as_chunks::<4>().0 {
            let at = quad.map(|p| lattice.position(p as usize));
            assert!(!(0..4).any(|k| (0..k).any(|l| slanted.cuts(at[k], at[l], 1e-6))));
        }
    }
}
