//! Solids as models: three unknowns per point, its displacements.

use super::super::plane::{
    BorderShares, BreakingModel, CALIBRATION, Edges, FindCuts, Mirrors, Mixture, Solvable, border_shares,
};
use super::body::SolidBody;
use super::{
    COMPONENTS, RIGID_MOTIONS, SolidEdges, SolidError, SolidFields, SolidMaterial, SolidModel, TENSOR,
    TENSOR_COMPONENTS, rigid_motion,
};
use crate::body::{Cell, SquareLattice};
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::{BodyFields, BodyModel, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::{ConnectedParts, NodedBonds, NumberedParts, Term};
use std::sync::Arc;

/// A solid on a lattice of cubes with the parameters of its material and its bonds.
#[derive(Clone, Debug)]
pub struct Solid<P> {
    parameters: P,
    pub(super) body: SolidBody,
}

impl<P: SolidMaterial> Solid<P> {
    /// One of each pair of opposite offsets to the neighbours of a point: the first number of a cut is an index into them.
    /// They hold those of all bonds and the possible edges of tetrahedra.
    ///
    /// # Errors
    /// [`SolidError`], all that speaks neither of clouds nor of bodies.
    pub fn offsets(parameters: &P) -> Result<Vec<Cell>, SolidError> {
        Ok(parameters.law()?.neighbourhood.offsets)
    }

    /// Rows, columns or layers of images that a lattice needs beyond a plane of symmetry: the depth of [`Mirrors::extended`].
    ///
    /// # Errors
    /// As [`offsets`](Self::offsets).
    pub fn depth(parameters: &P) -> Result<i32, SolidError> {
        let law = parameters.law()?;
        Ok(law.edges.depth(law.neighbourhood.reach()))
    }

    /// A lattice of points, images in `mirrors` among them ([`Mirrors::extended`] by [`depth`](Self::depth)). A cut is an
    /// index into [`offsets`](Self::offsets) and the lower point of a bond; images of cuts are cuts.
    ///
    /// # Errors
    /// [`SolidError`], all that does not speak of clouds.
    ///
    /// # Panics
    /// A cut has no such offset or point.
    pub fn on_lattice(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: P,
        cuts: &[(usize, usize)],
    ) -> Result<Self, SolidError> {
        Self::mixed(lattice, mirrors, parameters, cuts, Vec::new())
    }

    /// The same of several materials: `factors` are Young's moduli of the points over that of the parameters, > 0, images having
    /// those of their points; none where all are one. Bonds end on the border.
    ///
    /// # Errors
    /// [`SolidError`], all that does not speak of clouds.
    ///
    /// # Panics
    /// As [`on_lattice`](Self::on_lattice); or there is not one factor for every point.
    pub fn mixed(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: P,
        cuts: &[(usize, usize)],
        factors: Vec<f64>,
    ) -> Result<Self, SolidError> {
        assert!(factors.is_empty() || factors.len() == lattice.points(), "one factor per point");
        let body = SolidBody::new(lattice, mirrors, parameters.law()?, cuts, Mixture::new(factors))?;
        Ok(Self { parameters, body })
    }

    /// The parameters.
    pub fn parameters(&self) -> &P {
        &self.parameters
    }
}

impl<P> Points for Solid<P> {
    fn points(&self) -> usize {
        self.body.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        self.body.lattice.position(point)
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl<P> Model<3> for Solid<P> {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        self.body.terms()
    }

    /// Bonds alone, also those on the border: what else there is joins what they join.
    fn connected(&self) -> NumberedParts {
        let mut parts = ConnectedParts::new(self.points());
        self.body.bonds.join(&mut parts);
        self.body.border.iter().for_each(|border| border.bonds.join(&mut parts));
        parts.numbered()
    }

    fn sizes(&self) -> ModelSizes {
        let (body, overlay) = (&self.body, &self.body.overlay.families);
        let mut sizes = ModelSizes::of(&body.bonds, body.bonds.elements());
        if let Some(interface) = &body.interface {
            sizes = sizes.join(ModelSizes::of(&interface.families, 6 * interface.families.elements()));
        }
        let sizes = sizes.join(match &body.border {
            Some(border) => ModelSizes::of(&border.bonds, border.bonds.pairs()),
            None => ModelSizes::of(overlay, overlay.pairs()),
        });
        match &body.families {
            None => sizes,
            // Points that two bonds join are about eight times as many as those that one does.
            Some(families) => sizes
                .join(ModelSizes::of(families, 8 * body.law.neighbourhood.bonded().count() * self.points())),
        }
    }

    fn relations(&self) -> Vec<Equation> {
        self.body.mirrors.relations(&self.body.lattice, &self.body.ghosts, |signs| signs)
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        rigid_motion(kind, self.position(point), centre)
    }

    fn calibration_error(&self) -> f64 {
        let lattice = &self.body.lattice;
        let sides = [lattice.columns(), lattice.rows(), lattice.layers()].map(|side| side.len() as f64);
        CALIBRATION * sides.iter().fold(0.0, |a: f64, b| a.max(*b))
            / sides.iter().fold(f64::INFINITY, |a: f64, b| a.min(*b))
    }

    fn contrast(&self) -> f64 {
        self.body.law.material.contrast() * self.contrast_of_points()
    }

    fn contrast_of_points(&self) -> f64 {
        self.body.mixture().map_or(1.0, |mixture| mixture.contrast())
    }
}

impl<P: SolidMaterial> BodyModel for Solid<P> {
    fn volume(&self, point: usize) -> f64 {
        self.body.volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.body.lattice, &self.body.mirrors))
    }

    fn ghosts(&self) -> &[u32] {
        &self.body.ghosts
    }

    fn tensor_components(&self) -> &'static [&'static str] {
        &TENSOR_COMPONENTS
    }

    fn edges(&self) -> Option<Edges> {
        Some(self.body.law.edges.into())
    }

    fn border_shares(&self) -> Option<BorderShares<'_>> {
        let (body, cuts) = (&self.body, self.body.cuts.iter().copied().collect());
        let shares = || border_shares(&body.lattice, &body.mirrors, &body.law.neighbourhood, cuts);
        body.border.is_some().then(shares)
    }

    fn triangles(&self) -> usize {
        self.body.overlay.families.count()
    }

    fn completing(&self) -> usize {
        match &self.body.border {
            Some(border) => border.bonds.count(),
            None => self.body.overlay.families.count(),
        }
    }

    fn uncorrected(&self) -> usize {
        self.body.overlay.uncorrected
    }

    fn damage(&self) -> Vec<f64> {
        self.body.damage()
    }

    fn strains_of(&self, stress: [f64; TENSOR], _across: f64) -> [f64; TENSOR] {
        self.strain_of(stress)
    }

    fn strains_at(&self, point: usize, stress: [f64; TENSOR], _across: f64) -> [f64; TENSOR] {
        let factor = self.body.factor(point);
        self.strain_of(stress).map(|strain| strain / factor)
    }

    fn recover(&self, u: &[f64]) -> BodyFields {
        self.fields(u).into()
    }

    fn prepare_to_break(&mut self) {
        self.body.prepare_to_break();
    }

    fn unbreakable(&self) -> Option<&'static str> {
        self.body.unbreakable()
    }

    fn as_solid(&self) -> Option<&dyn SolidModel> {
        Some(self)
    }
}

impl<P: SolidMaterial> SolidModel for Solid<P> {
    fn faces(&self) -> SolidEdges {
        self.body.law.edges
    }

    fn bonds_of_a_point(&self) -> Vec<(Cell, f64)> {
        let (of, spacing) = (&self.body.law.neighbourhood, self.body.lattice.spacing());
        let stiffness = |step: &Cell, weight: &[f64; 1]| {
            let squared: f64 = step.iter().map(|k| f64::from(*k).powi(2)).sum();
            weight[0] * spacing / squared
        };
        of.offsets.iter().zip(&of.weights).map(|(step, weight)| (*step, stiffness(step, weight))).collect()
    }

    fn cut_bonds(&self) -> Vec<(Cell, usize)> {
        let of = &self.body.law.neighbourhood;
        let bonded = self.body.cuts.iter().filter(|cut| of.has_bonds(cut.0));
        bonded.map(|&(offset, lower)| (of.offsets[offset], lower)).collect()
    }

    fn bonds_on_border(&self) -> Option<&NodedBonds<3, 1>> {
        self.body.border.as_ref().map(|border| &*border.bonds)
    }

    fn stiffness(&self) -> Mat<TENSOR, TENSOR> {
        self.body.law.material.stiffness()
    }

    fn strain_of(&self, stress: [f64; TENSOR]) -> [f64; TENSOR] {
        self.body.law.material.strain(stress)
    }

    fn fields(&self, u: &[f64]) -> SolidFields {
        self.body.fields(u)
    }

    fn add_strain_work(&self, t: &mut [f64], force: &mut [f64]) {
        self.body.add_strain_work(t, force);
    }
}

impl<P: SolidMaterial> Solvable<3> for Solid<P> {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<3>>> {
        Some(Box::new(Self { parameters: self.parameters, body: self.body.coarser(cuts)? }))
    }

    fn breaking(&self) -> Option<Box<dyn BreakingModel<3>>> {
        self.body.breaks().then(|| Box::new(self.clone()) as Box<dyn BreakingModel<3>>)
    }
}
