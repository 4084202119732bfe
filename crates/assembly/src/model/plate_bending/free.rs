//! Curvatures that need no moments: those of a temperature that differs over the thickness, or there from the beginning.
//!
//! A bond is free of force at the measures that it has where the plate along it curves by `n·κ*·n`, linearly from end to end and as far
//! as it lies in cells that have κ*: a curvature that varies along a bond is a shear to it. A triangle is free of moment at the mean of the
//! corners of its cell. Where κ* is the same everywhere no moment is left but rounding, whatever the edges and the steps.

use super::bond::{PieceBond, moduli};
use super::cover::{self, Crossed, PieceEnd};
use super::nodes::{Inside, PlateNodes};
use super::part::Part;
use super::weights::Weighted;
use super::{PHI_X, PHI_Y, PlateBending, W};

/// A curvature that some cells would have if nothing held them. There is one unit per section and one value per point.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeCurvature {
    /// Numbers of the cells that have it, ascending; all if not given.
    pub cells: Option<Vec<u32>>,
    /// `[κ_xx, κ_yy, κ_xy]` of the sections by number, the base first, 1/m.
    pub units: Vec<[f64; 3]>,
    /// How many such units, at every point.
    pub values: Vec<f64>,
}

impl FreeCurvature {
    /// Whether a cell of the plate has it.
    pub(super) fn is_in(&self, nodes: &PlateNodes, [column, row]: [i32; 2]) -> bool {
        let Some(cells) = &self.cells else { return true };
        let number = nodes.cells().number([column, row, 0]);
        number.is_some_and(|number| cells.binary_search(&(number as u32)).is_ok())
    }
}

/// A component of a curvature in a direction.
fn along([xx, yy, xy]: [f64; 3], [x, y]: [f64; 2]) -> f64 {
    x * x * xx + y * y * yy + 2.0 * x * y * xy
}

/// Measures at which a bond of a length is free of force, of the curvatures `κ_i` and `κ_j` along it at its ends, linear between them
/// where it has them: `κ_b = ∫ κ ds` and `γ_b = ξ ∫ (½ − s) κ ds`, as for the deflection and the slope that follow from κ.
fn measures([i, j]: [f64; 2], [whole, first, second]: [f64; 3], length: f64) -> [f64; 2] {
    let bending = i * (whole - first) + j * first;
    let shear = i * (0.5 * whole - 1.5 * first + second) + j * (0.5 * first - second);
    [bending, length * shear]
}

/// `∫ sᵏ ds` of a bond that has the curvature from end to end.
const ALL: [f64; 3] = [1.0, 0.5, 1.0 / 3.0];

impl PlateBending {
    /// Hands the load of a curvature that needs no moments to `add`, force by force on the number of an unknown: it does the work of the
    /// moments `M(κ*)` with curvatures.
    pub fn add_free_curvature(&self, free: &FreeCurvature, add: &mut dyn FnMut(usize, f64)) {
        let (nodes, n) = (self.nodes(), self.nodes().points());
        for (number, part) in self.parts().iter().enumerate() {
            let of_part = |cell: [i32; 2]| self.sections().has(nodes, number, cell);
            let area = nodes.spacing().powi(2);
            let moduli_of = |offset: &Weighted| {
                let [x, y, _] = nodes.lattice().vector(offset.step);
                moduli(&part.parameters, offset, x.hypot(y)).map(|modulus| area * modulus)
            };
            let moduli: Vec<[f64; 2]> = part.offsets.iter().map(moduli_of).collect();
            self.each_free((part, number), free, |bond| {
                let [moment, shear] =
                    [0, 1].map(|m| bond.factors[m] * moduli[bond.offset][m] * bond.measures[m]);
                let [i, j] = bond.ends;
                add(W * n + j, shear / bond.length);
                add(W * n + i, -shear / bond.length);
                for (c, n_c) in [PHI_X, PHI_Y].into_iter().zip(bond.direction) {
                    add(c * n + j, n_c * (moment / bond.length - 0.5 * shear));
                    add(c * n + i, -n_c * (moment / bond.length + 0.5 * shear));
                }
            });
            self.add_pieces((part, &of_part), (free, free.units[number]), add);
            if let Some(triangles) = part.triangles() {
                triangles.add_free(nodes, free, free.units[number], add);
            }
        }
    }

    /// Calls `visit` with every whole bond of the part with a section, and what it is free at.
    pub(super) fn each_free(
        &self,
        (part, number): (&Part, usize),
        free: &FreeCurvature,
        mut visit: impl FnMut(FreeBond),
    ) {
        let (nodes, unit) = (self.nodes(), free.units[number]);
        let bends = |cell: [i32; 2]| free.is_in(nodes, cell);
        let of_part = |cell: [i32; 2]| self.sections().has(nodes, number, cell);
        let of_offset = |offset: &Weighted| {
            let [x, y, _] = nodes.lattice().vector(offset.step);
            let length = x.hypot(y);
            ([x / length, y / length], length, Crossed::new(offset.step))
        };
        let of_offsets: Vec<_> = part.offsets.iter().map(of_offset).collect();
        part.bonds.for_each_bond(|offset, ends, factors| {
            let (direction, length, crossed) = &of_offsets[offset];
            let moments = match free.cells {
                Some(_) => crossed.moments((&bends, &of_part), nodes.node(ends[0]), [0.0, 1.0]),
                None => ALL,
            };
            let bent = ends.map(|point| along(unit, *direction) * free.values[point]);
            let (direction, length, measures) = (*direction, *length, measures(bent, moments, *length));
            visit(FreeBond { offset, ends, factors, direction, length, measures });
        });
    }

    /// Adds the load of pieces of bonds.
    fn add_pieces(
        &self,
        (part, of_part): (&Part, Inside),
        (free, unit): (&FreeCurvature, [f64; 3]),
        add: &mut dyn FnMut(usize, f64),
    ) {
        if part.pieces() == 0 {
            return;
        }
        let (nodes, n) = (self.nodes(), self.nodes().points());
        let bends = |cell: [i32; 2]| free.is_in(nodes, cell);
        let steps: Vec<_> = part.offsets.iter().map(|offset| offset.step).collect();
        let crossed: Vec<_> = steps.iter().map(|step| Crossed::new(*step)).collect();
        for piece in cover::pieces(nodes, of_part, &steps) {
            let offset = &part.offsets[piece.offset];
            let [x, y, _] = nodes.lattice().vector(offset.step);
            let length = x.hypot(y);
            let moments = match free.cells {
                Some(_) => crossed[piece.offset].moments((&bends, of_part), piece.node, piece.range),
                None => ALL,
            };
            let bent = piece.ends.map(|PieceEnd { points, fraction }| {
                let [a, b] = points.map(|point| free.values[point]);
                along(unit, [x / length, y / length]) * ((1.0 - fraction) * a + fraction * b)
            });
            let bond = PieceBond::new(nodes, &part.parameters, offset, &piece);
            bond.add_actions(measures(bent, moments, piece.part() * length), n, add);
        }
    }

    /// Moments `[M_xx, M_yy, M_xy]` to subtract at a point, N: those of κ* in the sections of the cells about it, averaged over these
    /// cells.
    pub(super) fn moments_of(&self, free: &FreeCurvature, point: usize) -> [f64; 3] {
        let nodes = self.nodes();
        let (mut sum, mut cells) = ([0.0; 3], 0.0);
        for cell in nodes.cells_about(nodes.node(point)) {
            let Some(number) = self.sections().number(nodes, cell) else { continue };
            cells += 1.0;
            if free.is_in(nodes, cell) {
                let own = self.parts()[number].parameters.section.moments(free.units[number]);
                sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += free.values[point] * own);
            }
        }
        sum.map(|moment| moment / cells)
    }
}

/// A whole bond with what it is free at.
pub(super) struct FreeBond {
    pub(super) offset: usize,
    pub(super) ends: [usize; 2],
    /// Parts of the bond that are in the body, by measure.
    pub(super) factors: [f64; 2],
    pub(super) direction: [f64; 2],
    pub(super) length: f64,
    /// `κ_b`, 1/m, and `γ_b`.
    pub(super) measures: [f64; 2],
}
