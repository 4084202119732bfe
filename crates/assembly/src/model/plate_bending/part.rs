//! The bonds, pieces and triangles of cells that have one section.
//!
//! A plate of several sections is the sum of plates that share the points between them. Each has the line cover of its own cells:
//! a bond of next points along a step of the thickness counts a half with the section of either side, and longer ones are cut there.
//! So every part bends alike up to the step, as if it ended there, and at the points between them deflection and rotations are
//! the same.

use super::bond::{PieceBond, PlateBond, moduli};
use super::cover;
use super::curvature::{Triangles, triangles};
use super::nodes::{Inside, PlateNodes};
use super::weights::{Weighted, weights};
use super::{PlateError, PlateParameters};
use crate::stiffness::{Families, GridBonds, Offset, Term};
use std::sync::Arc;

/// What the cells of one section have of the energy of a plate.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) parameters: PlateParameters,
    pub(super) offsets: Vec<Weighted>,
    pub(super) bonds: Arc<GridBonds<3, 2, PlateBond>>,
    pieces: Pieces,
    triangles: Option<Arc<Triangles>>,
}

/// Pieces of bonds by their number of points: two, three and four.
#[derive(Clone, Debug)]
struct Pieces {
    of_two: Arc<Families<3, 2, 1>>,
    of_three: Arc<Families<3, 2, 2>>,
    of_four: Arc<Families<3, 2, 3>>,
}

impl Part {
    /// Of the cells that are `inside`.
    ///
    /// # Errors
    /// [`PlateError`].
    pub(super) fn new(
        nodes: &PlateNodes,
        parameters: PlateParameters,
        inside: Inside,
    ) -> Result<Self, PlateError> {
        let h = nodes.spacing();
        let offsets = weights(&parameters, h)?;
        let lattice = nodes.lattice();
        let of_offset = |offset: &Weighted| {
            let [x, y, _] = lattice.vector(offset.step);
            Offset { step: offset.step, weights: moduli(&parameters, offset, x.hypot(y)) }
        };
        let whole: Vec<Offset<2>> = offsets.iter().map(of_offset).collect();
        let part = |offset: usize, [lower, _]: [usize; 2]| {
            cover::whole(inside, nodes.node(lower), offsets[offset].step)
        };
        let bonds = GridBonds::with_factors(lattice.clone(), &PlateBond { area: h * h }, &whole, part);
        let pieces = Pieces::new((nodes, inside), &parameters, &offsets);
        let triangles = triangles((nodes, inside), &parameters.section).map(Arc::new);
        Ok(Self { parameters, bonds: Arc::new(bonds), pieces, triangles, offsets })
    }

    /// Number of pieces of bonds that leave the cells.
    pub(super) fn pieces(&self) -> usize {
        let Pieces { of_two, of_three, of_four } = &self.pieces;
        of_two.list().len() + of_three.list().len() + of_four.list().len()
    }

    /// What bonds lack.
    pub(super) fn triangles(&self) -> Option<&Triangles> {
        self.triangles.as_deref()
    }

    /// Takes a bond between next points out, and the triangles beside it: its ends, and the part of it that was in the body; none if there
    /// is no such bond.
    pub(super) fn cut_bond(
        &mut self,
        nodes: &PlateNodes,
        (offset, lower): (usize, usize),
    ) -> Option<([usize; 2], f64)> {
        let bond = self.bonds.bond(offset, lower)?;
        let [x, y, _] = nodes.lattice().vector(self.offsets[offset].step);
        let [whole, _] = moduli(&self.parameters, &self.offsets[offset], x.hypot(y));
        let factor = bond.moduli[0] / (whole * nodes.spacing().powi(2));
        Arc::make_mut(&mut self.bonds).break_bonds([(offset, lower)]);
        let ends = bond.points.map(|point| point as usize);
        if let Some(triangles) = &mut self.triangles {
            Arc::make_mut(triangles).tear(nodes, ends);
        }
        Some((ends, factor))
    }

    pub(super) fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        let Pieces { of_two, of_three, of_four } = &self.pieces;
        let mut terms: Vec<Box<dyn Term<3>>> = vec![Box::new(self.bonds.clone())];
        if !of_two.list().is_empty() {
            terms.push(Box::new(of_two.clone()));
        }
        if !of_three.list().is_empty() {
            terms.push(Box::new(of_three.clone()));
        }
        if !of_four.list().is_empty() {
            terms.push(Box::new(of_four.clone()));
        }
        terms.extend(self.triangles.iter().map(|t| Box::new(t.clone()) as Box<dyn Term<3>>));
        terms
    }
}

impl Pieces {
    fn new(
        (nodes, inside): (&PlateNodes, Inside),
        parameters: &PlateParameters,
        offsets: &[Weighted],
    ) -> Self {
        let steps: Vec<_> = offsets.iter().map(|offset| offset.step).collect();
        let (mut of_two, mut of_three, mut of_four) = (Vec::new(), Vec::new(), Vec::new());
        for piece in cover::pieces(nodes, inside, &steps) {
            let bond = PieceBond::new(nodes, parameters, &offsets[piece.offset], &piece);
            match bond.others() {
                1 => of_two.push(bond.family()),
                2 => of_three.push(bond.family()),
                _ => of_four.push(bond.family()),
            }
        }
        let points = nodes.points();
        Self {
            of_two: Arc::new(Families::new(points, of_two)),
            of_three: Arc::new(Families::new(points, of_three)),
            of_four: Arc::new(Families::new(points, of_four)),
        }
    }
}
