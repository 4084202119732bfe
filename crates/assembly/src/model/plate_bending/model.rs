//! A plate in bending as a model with three unknowns per point.

use super::bond::{PieceBond, PlateBond, moduli};
use super::cover;
use super::curvature::{Triangles, triangles};
use super::nodes::PlateNodes;
use super::weights::{Weighted, weights};
use super::{PlateError, PlateParameters};
use crate::body::SquareLattice;
use crate::bonds::Point;
use crate::condition::Equation;
use crate::model::{Component, Model, Points, RigidMotion};
use crate::stiffness::{Families, GridBonds, Offset, Term};
use std::sync::Arc;

/// A plate in bending.
#[derive(Clone, Debug)]
pub struct PlateBending {
    parameters: PlateParameters,
    nodes: PlateNodes,
    offsets: Vec<Weighted>,
    bonds: Arc<GridBonds<3, 2, PlateBond>>,
    /// Pieces of bonds by their number of points: two, three and four.
    pieces: Pieces,
    triangles: Option<Arc<Triangles>>,
}

/// Pieces of bonds by their number of points.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    pub(super) of_two: Arc<Families<3, 2, 1>>,
    pub(super) of_three: Arc<Families<3, 2, 2>>,
    pub(super) of_four: Arc<Families<3, 2, 3>>,
}

const COMPONENTS: [Component; 3] =
    [Component::displacement("w", 2), Component::rotation("phi_x", 1.0), Component::rotation("phi_y", 1.0)];

const RIGID_MOTIONS: [RigidMotion; 3] = [
    RigidMotion::translation("translation along z", "move across its plane"),
    RigidMotion::rotation("tilt along x", "tilt along x about {centre}"),
    RigidMotion::rotation("tilt along y", "tilt along y about {centre}"),
];

impl PlateBending {
    /// The plate of some square cells.
    ///
    /// # Errors
    /// [`PlateError`].
    pub fn new(cells: Arc<SquareLattice>, parameters: PlateParameters) -> Result<Self, PlateError> {
        let nodes = PlateNodes::new(cells)?;
        let h = nodes.spacing();
        let offsets = weights(&parameters, h)?;
        let lattice = nodes.lattice();
        let of_offset = |offset: &Weighted| {
            let [x, y, _] = lattice.vector(offset.step);
            Offset { step: offset.step, weights: moduli(&parameters, offset, x.hypot(y)) }
        };
        let whole: Vec<Offset<2>> = offsets.iter().map(of_offset).collect();
        let part = |offset: usize, [lower, _]: [usize; 2]| {
            cover::whole(&nodes, nodes.node(lower), offsets[offset].step)
        };
        let bonds = GridBonds::with_factors(lattice.clone(), &PlateBond { area: h * h }, &whole, part);
        let pieces = Pieces::new(&nodes, &parameters, &offsets);
        let triangles = triangles(&nodes, &parameters.section).map(Arc::new);
        Ok(Self { parameters, bonds: Arc::new(bonds), pieces, triangles, offsets, nodes })
    }

    /// Its parameters.
    pub fn parameters(&self) -> &PlateParameters {
        &self.parameters
    }

    /// Its points and cells.
    pub fn nodes(&self) -> &PlateNodes {
        &self.nodes
    }

    /// Number of bonds that are whole, or half along an edge.
    pub fn bonds(&self) -> usize {
        self.bonds.elements()
    }

    /// Number of pieces of bonds that leave the body.
    pub fn pieces(&self) -> usize {
        self.pieces.count()
    }

    pub(super) fn offsets(&self) -> &[Weighted] {
        &self.offsets
    }

    pub(super) fn whole_bonds(&self) -> &GridBonds<3, 2, PlateBond> {
        &self.bonds
    }
}

impl Pieces {
    fn new(nodes: &PlateNodes, parameters: &PlateParameters, offsets: &[Weighted]) -> Self {
        let steps: Vec<_> = offsets.iter().map(|offset| offset.step).collect();
        let (mut of_two, mut of_three, mut of_four) = (Vec::new(), Vec::new(), Vec::new());
        for piece in cover::pieces(nodes, &steps) {
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

    fn count(&self) -> usize {
        self.of_two.list().len() + self.of_three.list().len() + self.of_four.list().len()
    }
}

impl Points for PlateBending {
    fn points(&self) -> usize {
        self.nodes.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.nodes.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<3> for PlateBending {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
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

    fn relations(&self) -> Vec<Equation> {
        Vec::new()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        let [x, y] = self.nodes.place(point);
        match kind {
            0 => [1.0, 0.0, 0.0],
            1 => [x - centre[0], 1.0, 0.0],
            _ => [y - centre[1], 0.0, 1.0],
        }
    }
}
