//! State-based bodies as models: two unknowns per point, the displacements along x and y.

use super::super::plane::{
    BreakingModel, COMPONENTS, FindCuts, Mirrors, RIGID_MOTIONS, Solvable, calibration_error, rigid_motion,
};
use super::body::{StateBody, cell_volume};
use super::ghosts::Separated;
use super::materials::{Mixture, StateMaterials};
use super::weights::offsets;
use super::{StateEdges, StateError, StateParameters};
use crate::body::{Cell, SquareLattice};
use crate::bonds::Point;
use crate::condition::{Equation, Unknown};
use crate::model::{Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;
use std::sync::Arc;

/// A state-based body in the plane, or one of revolution, whose section the points are.
#[derive(Clone, Debug)]
pub struct StateBased {
    pub(super) parameters: StateParameters,
    pub(super) body: StateBody,
}

impl StateBased {
    /// One of each pair of opposite offsets to the neighbours of a point: the first number of a cut is an index into them.
    pub fn offsets(parameters: &StateParameters) -> Vec<Cell> {
        offsets(parameters)
    }

    /// A body of one material on the cells of a lattice without images. `cut` tells which bonds of the lattice with ghosts and images
    /// something cuts, by index into [`offsets`](Self::offsets) and lower point; `separated` whether it stands between cells.
    ///
    /// # Errors
    /// [`StateError`].
    pub fn on_lattice(
        real: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: StateParameters,
        separated: &Separated,
        cut: &dyn Fn(&SquareLattice) -> Vec<(usize, usize)>,
    ) -> Result<Self, StateError> {
        Self::mixed(real, mirrors, parameters, separated, cut, None)
    }

    /// The same of several materials, where there are such, of which the parameters are those of the first.
    ///
    /// # Errors
    /// [`StateError`].
    pub fn mixed(
        real: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: StateParameters,
        separated: &Separated,
        cut: &dyn Fn(&SquareLattice) -> Vec<(usize, usize)>,
        materials: Option<&Arc<StateMaterials>>,
    ) -> Result<Self, StateError> {
        if parameters.edges == StateEdges::Border {
            return Err(StateError::NoBorder);
        }
        if materials.is_some() && parameters.edges != StateEdges::Ghosts {
            return Err(StateError::MaterialsNeedGhosts);
        }
        let body = StateBody::new(&parameters, real, mirrors, separated, cut, materials)?;
        Ok(Self { parameters, body })
    }

    /// The material of a point.
    pub(super) fn material(&self, point: usize) -> StateParameters {
        self.body.mixture.as_ref().map_or(self.parameters, |mixture| mixture.of(point))
    }

    /// All materials, with the Young's modulus of the base one.
    pub(super) fn materials(&self) -> &[StateParameters] {
        match &self.body.mixture {
            Some(mixture) => &mixture.materials.of,
            None => std::slice::from_ref(&self.parameters),
        }
    }

    /// The parameters.
    pub fn parameters(&self) -> &StateParameters {
        &self.parameters
    }

    pub(super) fn true_volume(&self, point: usize) -> f64 {
        cell_volume(&self.parameters, self.body.lattice.spacing()) * self.body.families.volume[point]
    }
}

impl Points for StateBased {
    fn points(&self) -> usize {
        self.body.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.body.lattice.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<2> for StateBased {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        // A body of revolution moves along its axis alone.
        if self.parameters.is_axisymmetric() { &RIGID_MOTIONS[1..2] } else { &RIGID_MOTIONS }
    }

    fn calibration_error(&self) -> f64 {
        // Next to an axis weights are found with fewer digits, measured.
        if self.parameters.is_axisymmetric() { 3e-12 } else { calibration_error(self, 2) }
    }

    fn contrast(&self) -> f64 {
        let own = self.materials().iter().map(StateParameters::contrast);
        self.contrast_of_points() * own.fold(1.0, f64::max)
    }

    fn contrast_of_points(&self) -> f64 {
        self.body.mixture.as_ref().map_or(1.0, Mixture::contrast)
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        vec![Box::new(self.body.term.clone())]
    }

    fn sizes(&self) -> ModelSizes {
        let term = &self.body.term;
        let neighbours = self.body.families.offsets.len();
        // Points that two bonds join are about four times as many as those that one does.
        let coupled = if term.has_families() { 2 * neighbours } else { neighbours / 2 };
        ModelSizes {
            reach: term.reach(),
            elements: term.elements(),
            entries: 4 * coupled * self.points(),
            bytes: size_of::<f64>() * term.stored_factors(),
        }
    }

    fn relations(&self) -> Vec<Equation> {
        let body = &self.body;
        let fit = |ghost: u32| body.fits.get(&body.lattice.cell(ghost as usize));
        let is_image = |ghost: u32| !body.mirrors.is_real(body.lattice.cell(ghost as usize));
        let images: Vec<u32> = body.ghosts.iter().copied().filter(|&ghost| is_image(ghost)).collect();
        let mut of_images =
            body.mirrors.relations::<2>(&body.lattice, &images, |[x, y, _]| [x, y]).into_iter();
        let of = |&ghost: &u32| {
            if is_image(ghost) {
                return of_images.by_ref().take(2).collect::<Vec<_>>();
            }
            // A ghost without a fit has gone with the bonds of its points, and rests.
            let fit = fit(ghost).map_or(&[][..], Vec::as_slice);
            let component = |component: usize| {
                let mut terms = vec![(Unknown { component, point: ghost as usize }, 1.0)];
                terms.extend(fit.iter().filter_map(|&(cell, share)| {
                    Some((Unknown { component, point: body.lattice.number(cell)? }, -share))
                }));
                Equation { terms, value: 0.0, origin: String::from("edges") }
            };
            [0, 1].map(component).to_vec()
        };
        body.ghosts.iter().flat_map(of).collect()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        let kind = if self.parameters.is_axisymmetric() { 1 } else { kind };
        let [x, y, _] = rigid_motion(kind, self.position(point), centre);
        [x, y]
    }
}

impl Solvable<2> for StateBased {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<2>>> {
        let (parameters, body) = (&self.parameters, &self.body);
        let real = Arc::new(body.real.coarser());
        // The axis comes back by itself.
        let mut mirrors = body.mirrors.coarser()?;
        if self.parameters.is_axisymmetric() {
            mirrors.lines[0][0] = None;
        }
        let half = offsets(parameters);
        let cut = |lattice: &SquareLattice| cuts(lattice, &half);
        let materials = body.mixture.as_ref().map(|mixture| mixture.materials.coarser(&body.real, &real));
        let made = Self::mixed(real, mirrors, *parameters, &|_, _| false, &cut, materials.as_ref());
        Some(Box::new(made.ok()?))
    }

    fn breaking(&self) -> Option<Box<dyn BreakingModel<2>>> {
        Some(Box::new(self.clone()))
    }
}
