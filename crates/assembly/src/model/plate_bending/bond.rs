//! Bonds of a plate: whole ones of the lattice, and pieces whose ends are on edges between points.

use super::cover::{Piece, PieceEnd};
use super::nodes::PlateNodes;
use super::weights::Weighted;
use super::{PHI_X, PHI_Y, PlateParameters, W};
use crate::bonds::{BondGeometry, BondModel, Mat, Rows};
use crate::stiffness::Family;

/// Measures: `κ_b = n·(φ_j − φ_i)/ξ`, 1/m, and `γ_b = (w_j − w_i)/ξ − n·(φ_i + φ_j)/2`. Moduli: the area h² of a cell, m²; the
/// weights of an offset are the rest, N m and N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateBond {
    /// Area of a cell, m².
    pub area: f64,
}

impl BondModel<3, 2> for PlateBond {
    const DIFFERENCE: [[bool; 3]; 2] = [[false, true, true], [true, false, false]];
    const MEAN: [[bool; 3]; 2] = [[false; 3], [false, true, true]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 2> {
        let xi = bond.length();
        let [x, y] = [bond.xi[0] / xi, bond.xi[1] / xi];
        Rows { difference: [[0.0, x / xi, y / xi], [1.0 / xi, 0.0, 0.0]], mean: [[0.0; 3], [0.0, -x, -y]] }
    }

    fn moduli(&self, _bond: &BondGeometry) -> [f64; 2] {
        [self.area; 2]
    }
}

/// Moduli of a bond of an offset, or of a piece of it, for the whole area of a cell: bending, N m, and shear, N/m.
pub(super) fn moduli(parameters: &PlateParameters, offset: &Weighted, length: f64) -> [f64; 2] {
    let bending = 4.0 * parameters.section.common() * offset.bending;
    [bending, parameters.shear(offset.shear, length)]
}

/// What a point adds to the two measures of a piece.
type Member = (usize, Mat<2, 3>);

/// A piece with its points, and what they add to its measures.
pub(super) struct PieceBond {
    members: Vec<Member>,
    modulus: Mat<2, 2>,
}

impl PieceBond {
    /// The measures of a piece of the bond at an offset: at an end between two points A and B of an edge, a part f of the way
    /// along, `φ = (1 − f) φ_A + f φ_B` and `w = (1 − f) w_A + f w_B − ½ f (1 − f) (x_B − x_A)·(φ_B − φ_A)`, which is exact for
    /// every quadratic w with its gradient and for every linear w with the same rotation everywhere.
    pub(super) fn new(
        nodes: &PlateNodes,
        parameters: &PlateParameters,
        offset: &Weighted,
        piece: &Piece,
    ) -> Self {
        let [x, y, _] = nodes.lattice().vector(offset.step);
        let whole = x.hypot(y);
        let (length, n) = (piece.part() * whole, [x / whole, y / whole]);
        let mut members: Vec<Member> = Vec::with_capacity(4);
        for (end, sign) in piece.ends.iter().zip([-1.0, 1.0]) {
            add_end(nodes, end, sign / length, n, &mut members);
        }
        let factor = nodes.spacing() * nodes.spacing() * piece.weight * piece.part();
        let [bending, shear] = moduli(parameters, offset, length).map(|modulus| factor * modulus);
        Self { members, modulus: [[bending, 0.0], [0.0, shear]] }
    }

    /// Hands what is conjugate to its measures at some values of these to `add`, as forces on the unknowns of `n` points.
    pub(super) fn add_actions(&self, measures: [f64; 2], n: usize, add: &mut dyn FnMut(usize, f64)) {
        for (point, rows) in &self.members {
            for c in [W, PHI_X, PHI_Y] {
                let of = |m: usize| self.modulus[m][m] * measures[m] * rows[m][c];
                add(c * n + point, of(0) + of(1));
            }
        }
    }

    /// Number of points beside the first.
    pub(super) fn others(&self) -> usize {
        self.members.len() - 1
    }

    /// The piece as a family with as many others as it has.
    pub(super) fn family<const E: usize>(&self) -> Family<3, 2, E> {
        let (first, others) = (self.members[0], &self.members[1..]);
        let own = |m: usize, c: usize| self.members.iter().map(|member| member.1[m][c]).sum::<f64>();
        let mut own: Mat<2, 3> = std::array::from_fn(|m| std::array::from_fn(|c| own(m, c)));
        // Uniform rotations do not bend, and uniform deflections do not shear, to the last bit.
        own[0] = [0.0; 3];
        own[1][W] = 0.0;
        Family {
            point: first.0 as u32,
            others: std::array::from_fn(|e| others[e].0 as u32),
            rows: std::array::from_fn(|e| others[e].1),
            own,
            modulus: self.modulus,
        }
    }
}

/// Adds what an end of a piece does to its measures; `slope` is 1 over the length, negative at the first end.
fn add_end(nodes: &PlateNodes, end: &PieceEnd, slope: f64, n: [f64; 2], members: &mut Vec<Member>) {
    let mut add = |point: usize, rows: Mat<2, 3>| match members.iter_mut().find(|m| m.0 == point) {
        Some(member) => crate::bonds::add(&mut member.1, &rows),
        None => members.push((point, rows)),
    };
    let f = end.fraction;
    let [a, b] = end.points.map(|point| nodes.place(point));
    let bow = 0.5 * f * (1.0 - f) * slope;
    let bow = [bow * (b[0] - a[0]), bow * (b[1] - a[1])];
    for (point, share, sign) in [(end.points[0], 1.0 - f, 1.0), (end.points[1], f, -1.0)] {
        if share == 0.0 {
            continue;
        }
        let mut rows = [[0.0; 3]; 2];
        rows[1][W] = share * slope;
        for (k, c) in [PHI_X, PHI_Y].into_iter().enumerate() {
            rows[0][c] = share * slope * n[k];
            rows[1][c] = sign * bow[k] - 0.5 * share * n[k];
        }
        add(point, rows);
    }
}
