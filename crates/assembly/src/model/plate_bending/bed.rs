//! Winkler foundations under plates.

use super::{EdgeSegment, PHI_X, PHI_Y, PlateNodes, W};
use crate::stiffness::Spring;

/// A bed under a plate: where the part of it that belongs to a point pushes back.
///
/// A bed answers a deflection as a pressure `k w` loads the plate: by its area at every point, and by couples `k w h²/12` per length
/// of the edges, so that a uniform pressure sinks a free plate evenly. Symmetric, and positive whatever the stiffness, is
/// `½ k A (w + d·φ)²` with the arm d from the point into the body and the stiffness k there: for stiffnesses and deflections that
/// change along straight lines forces and moments are exact to `h⁴`.
pub struct Bed<'a> {
    nodes: &'a PlateNodes,
    /// From every point to where its part pushes back, m.
    arms: Vec<[f64; 2]>,
}

impl<'a> Bed<'a> {
    /// Under a plate with these free edges.
    pub fn new(nodes: &'a PlateNodes, edges: impl IntoIterator<Item = EdgeSegment>) -> Self {
        let couple = nodes.spacing().powi(3) / 24.0;
        let mut arms = vec![[0.0; 2]; nodes.points()];
        for edge in edges {
            for point in edge.points.map(|p| p as usize) {
                (0..2).for_each(|k| arms[point][k] -= couple * edge.outward[k] / nodes.area(point));
            }
        }
        Self { nodes, arms }
    }

    /// How many points there are.
    pub fn points(&self) -> usize {
        self.arms.len()
    }

    /// Where the part of a point pushes back, m.
    pub fn place(&self, point: usize) -> [f64; 2] {
        let ([x, y], [dx, dy]) = (self.nodes.place(point), self.arms[point]);
        [x + dx, y + dy]
    }

    /// The springs of a bed with a stiffness at the place of every point, force per area and deflection, N/m³.
    pub fn springs(&self, stiffness: &[f64]) -> Vec<Spring> {
        let resisting = stiffness.iter().enumerate().filter(|(_, stiffness)| **stiffness > 0.0);
        resisting
            .flat_map(|(point, k)| springs(point, k * self.nodes.area(point), self.arms[point]))
            .collect()
    }
}

/// The springs of a point. In a corner each of two has half of the bed, and twice its arm.
fn springs(point: usize, stiffness: f64, arms: [f64; 2]) -> Vec<Spring> {
    let turning = [PHI_X, PHI_Y].into_iter().zip(arms).filter(|(_, arm)| *arm != 0.0);
    let turning: Vec<(usize, f64)> = turning.collect();
    if turning.is_empty() {
        return vec![Spring::on(W, point, stiffness)];
    }
    let count = turning.len() as f64;
    let spring = |(component, arm): (usize, f64)| Spring {
        point,
        shares: [(W, 1.0), (component, count * arm)],
        stiffness: stiffness / count,
    };
    turning.into_iter().map(spring).collect()
}
