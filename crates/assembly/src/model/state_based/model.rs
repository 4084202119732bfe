//! State-based bodies as models: two unknowns per point, the displacements along x and y.

use super::super::plane::{Mirrors, PlaneModel, calibration_error};
use super::body::{StateBody, cell_volume};
use super::ghosts::Separated;
use super::weights::offsets;
use super::{StateEdges, StateError, StateParameters};
use crate::body::{Cell, SquareLattice};
use crate::bonds::Point;
use crate::condition::{Equation, Unknown};
use crate::model::{Model, ModelSizes};
use crate::stiffness::Term;
use std::sync::Arc;

/// A state-based body in the plane, or one of revolution, whose section the points are.
#[derive(Clone, Debug)]
pub struct StateBased<const REVOLVED: bool> {
    pub(super) parameters: StateParameters,
    pub(super) body: StateBody,
}

impl<const REVOLVED: bool> StateBased<REVOLVED> {
    /// One of each pair of opposite offsets to the neighbours of a point: the first number of a cut is an index into them.
    pub fn offsets(parameters: &StateParameters) -> Vec<Cell> {
        offsets(parameters)
    }

    /// A body on the cells of a lattice without images. `cut` tells which bonds of the lattice with ghosts and images
    /// something cuts, by index into [`offsets`](Self::offsets) and lower point; `separated` whether it stands between cells.
    ///
    /// # Errors
    /// [`StateError`].
    ///
    /// # Panics
    /// The parameters are those of the other kind of body.
    pub fn on_lattice(
        real: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: StateParameters,
        separated: &Separated,
        cut: &dyn Fn(&SquareLattice) -> Vec<(usize, usize)>,
    ) -> Result<Self, StateError> {
        assert_eq!(parameters.is_axisymmetric(), REVOLVED, "parameters of the other kind of body");
        if parameters.edges == StateEdges::Border {
            return Err(StateError::NoBorder);
        }
        let body = StateBody::new(&parameters, real, mirrors, separated, cut)?;
        Ok(Self { parameters, body })
    }

    /// The parameters.
    pub fn parameters(&self) -> &StateParameters {
        &self.parameters
    }

    /// Whether points feel more than their bonds: not where `λ = μ`.
    pub fn has_families(&self) -> bool {
        self.body.term.has_families()
    }

    pub(super) fn true_volume(&self, point: usize) -> f64 {
        cell_volume(&self.parameters, self.body.lattice.spacing()) * self.body.families.volume[point]
    }
}

impl<const REVOLVED: bool> Model<2> for StateBased<REVOLVED> {
    fn unknowns(&self) -> [&'static str; 2] {
        ["ux", "uy"]
    }
    fn rigid_motions(&self) -> &'static [&'static str] {
        match REVOLVED {
            true => &["translation along y"],
            false => &["translation along x", "translation along y", "rotation about z"],
        }
    }
    fn is_displacement(&self) -> [bool; 2] {
        [true, true]
    }

    fn points(&self) -> usize {
        self.point_count()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.place(point);
        [x, y, 0.0]
    }

    fn calibration_error(&self) -> f64 {
        // Next to an axis weights are found with fewer digits, measured.
        if REVOLVED { 3e-12 } else { calibration_error(self) }
    }

    fn contrast(&self) -> f64 {
        self.parameters.contrast()
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
            entries: 4 * coupled * self.point_count(),
            bytes: size_of::<f64>() * term.stored_factors(),
        }
    }

    fn relations(&self) -> Vec<Equation> {
        let body = &self.body;
        let fit = |ghost: u32| body.fits.get(&body.lattice.cell(ghost as usize));
        let is_image = |ghost: u32| !body.mirrors.is_real(body.lattice.cell(ghost as usize));
        let images: Vec<u32> = body.ghosts.iter().copied().filter(|&ghost| is_image(ghost)).collect();
        let mut of_images = body.mirrors.relations::<2>(&body.lattice, &images, |signs| signs).into_iter();
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
        let [x, y] = self.place(point);
        match if REVOLVED { 1 } else { kind } {
            0 => [1.0, 0.0],
            1 => [0.0, 1.0],
            _ => [centre[1] - y, x - centre[0]],
        }
    }
}
