//! A beam as a model with two or three unknowns per point.

use super::{TimoshenkoBeam, U};
use crate::bonds::Point;
use crate::condition::Equation;
use crate::model::{Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;

impl TimoshenkoBeam {
    /// Relations of the ghost points.
    fn ghost_relations(&self) -> Vec<Equation> {
        self.chains.iter().zip(&self.first).flat_map(|(chain, &first)| chain.relations(first)).collect()
    }

    /// (w, φ, u) of a point under a unit translation along x (0), along y (1), or a rotation about a centre (2).
    fn plane_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        let mut motion = [[0.0; 3]];
        self.plane_motions(kind, point, centre, &mut motion);
        motion[0]
    }

    /// The same of consecutive points, line by line; of as many unknowns as are asked for.
    fn plane_motions<const D: usize>(&self, kind: usize, first: usize, centre: Point, out: &mut [[f64; D]]) {
        let mut point = first;
        let mut rest = out;
        while !rest.is_empty() {
            let number = self.chain_of(point);
            let (chain, from) = (&self.chains[number], point - self.first[number]);
            let (own, others) = rest.split_at_mut(rest.len().min(chain.extended() - from));
            let (line, [c, s]) = (chain.line(), chain.line().direction);
            chain.positions(from, own.len(), |k, along| {
                let [x, y] = [0, 1].map(|axis| line.origin[axis] + along * line.direction[axis]);
                let (motion, turn) = match kind {
                    0 => ([1.0, 0.0], 0.0),
                    1 => ([0.0, 1.0], 0.0),
                    _ => ([centre[1] - y, x - centre[0]], 1.0),
                };
                let all = [c * motion[1] - s * motion[0], turn, c * motion[0] + s * motion[1]];
                own[k] = std::array::from_fn(|component| all[component]);
            });
            point += own.len();
            rest = others;
        }
    }
}

/// The unknowns of a point; those of a beam that does not stretch are the first two.
const COMPONENTS: [Component; 3] =
    [Component::displacement("w", 1), Component::rotation("phi", 1.0), Component::displacement("u", 0)];

const ON_A_LINE: [RigidMotion; 2] = [
    RigidMotion::translation("translation along w", "move along w"),
    RigidMotion::rotation("rotation", "turn about {centre}"),
];

const IN_A_PLANE: [RigidMotion; 3] = [
    RigidMotion::translation("translation along x", "move along {direction}"),
    RigidMotion::translation("translation along y", "move along {direction}"),
    RigidMotion::rotation("rotation", "turn about {centre}"),
];

impl Points for TimoshenkoBeam {
    fn points(&self) -> usize {
        self.points
    }

    fn position(&self, point: usize) -> Point {
        let chain = self.chain_of(point);
        let (line, x) = (self.chains[chain].line(), self.chains[chain].position(point - self.first[chain]));
        [line.origin[0] + x * line.direction[0], line.origin[1] + x * line.direction[1], 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<2> for TimoshenkoBeam {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &ON_A_LINE
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        self.bending_terms()
    }

    fn sizes(&self) -> ModelSizes {
        self.term_sizes::<2>()
    }

    fn relations(&self) -> Vec<Equation> {
        self.ghost_relations()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        let [w, phi, _] = self.plane_motion(kind + 1, point, centre);
        [w, phi]
    }

    fn rigid_motions_from(&self, kind: usize, first: usize, centre: Point, out: &mut [[f64; 2]]) {
        self.plane_motions(kind + 1, first, centre, out);
    }
}

impl Model<3> for TimoshenkoBeam {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &IN_A_PLANE
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        self.frame_terms()
    }

    fn sizes(&self) -> ModelSizes {
        self.term_sizes::<3>()
    }

    fn relations(&self) -> Vec<Equation> {
        self.ghost_relations()
    }

    fn idle(&self) -> usize {
        // Displacements along a bar between its ends.
        let bars = self.chains.iter().filter(|chain| chain.stretches_as_bar());
        bars.map(|chain| chain.points.saturating_sub(2)).sum()
    }

    fn is_idle(&self, component: usize, point: usize) -> bool {
        let line = self.chain_of(point);
        let (chain, first) = (&self.chains[line], self.first[line]);
        component == U
            && chain.stretches_as_bar()
            && (first + 1..first + chain.points.saturating_sub(1)).contains(&point)
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        self.plane_motion(kind, point, centre)
    }

    fn rigid_motions_from(&self, kind: usize, first: usize, centre: Point, out: &mut [[f64; 3]]) {
        self.plane_motions(kind, first, centre, out);
    }
}
