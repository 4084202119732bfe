//! A plate as a model with two unknowns per point.

use super::super::plane::{
    BreakingModel, COMPONENTS, FindCuts, RIGID_MOTIONS, SofteningModel, Solvable, calibration_error,
    rigid_motion,
};
use super::{Body, BondPlane};
use crate::bonds::Point;
use crate::condition::Equation;
use crate::model::{Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;

impl Points for BondPlane {
    fn points(&self) -> usize {
        match &self.body {
            Body::Lattice(body) => body.lattice.points(),
            Body::Cloud(body) => body.sites.positions.len(),
        }
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = match &self.body {
            Body::Lattice(body) => body.lattice.place(point),
            Body::Cloud(body) => body.sites.positions[point],
        };
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<2> for BondPlane {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn calibration_error(&self) -> f64 {
        calibration_error(self, 2)
    }

    fn contrast(&self) -> f64 {
        self.contrast_of_points()
    }

    fn contrast_of_points(&self) -> f64 {
        match &self.body {
            Body::Lattice(body) => body.mixture().map_or(1.0, |mixture| mixture.contrast()),
            Body::Cloud(_) => 1.0,
        }
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        match &self.body {
            Body::Lattice(body) => body.terms(),
            Body::Cloud(body) => body.terms(),
        }
    }

    fn sizes(&self) -> ModelSizes {
        match &self.body {
            Body::Lattice(body) => body.sizes(),
            Body::Cloud(body) => body.sizes(),
        }
    }

    fn relations(&self) -> Vec<Equation> {
        match &self.body {
            Body::Lattice(body) => body.mirrors.relations(&body.lattice, &body.ghosts, |[x, y, _]| [x, y]),
            Body::Cloud(_) => Vec::new(),
        }
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        let [x, y, _] = rigid_motion(kind, self.position(point), centre);
        [x, y]
    }
}

impl Solvable<2> for BondPlane {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<2>>> {
        let Body::Lattice(body) = &self.body else { return None };
        let body = Body::Lattice(Box::new(body.coarser(cuts)?));
        Some(Box::new(Self { parameters: self.parameters, body }))
    }

    fn breaking(&self) -> Option<Box<dyn BreakingModel<2>>> {
        Some(Box::new(self.clone()))
    }

    fn softening(&self) -> Option<Box<dyn SofteningModel<2>>> {
        Some(Box::new(self.clone()))
    }
}
