//! A plate as a model with two unknowns per point.

use super::super::plane::{PlaneModel, calibration_error};
use super::{Body, BondPlane};
use crate::bonds::Point;
use crate::condition::Equation;
use crate::model::{Model, ModelSizes};
use crate::stiffness::Term;

impl Model<2> for BondPlane {
    fn unknowns(&self) -> [&'static str; 2] {
        ["ux", "uy"]
    }
    fn rigid_motions(&self) -> &'static [&'static str] {
        &["translation along x", "translation along y", "rotation about z"]
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
        calibration_error(self)
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
            Body::Lattice(body) => body.mirrors.relations(&body.lattice, &body.ghosts, |signs| signs),
            Body::Cloud(_) => Vec::new(),
        }
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        let [x, y] = self.place(point);
        match kind {
            0 => [1.0, 0.0],
            1 => [0.0, 1.0],
            _ => [centre[1] - y, x - centre[0]],
        }
    }
}
