//! Relations of ghost points: what continues or mirrors a chain beyond its ends.

use super::super::end_treatment::EndKind;
use super::super::{PHI, W};
use super::{Chain, Grid};
use crate::condition::{Equation, Unknown};

impl Chain {
    /// Relations of the ghost points, for a chain whose first extended point has the number `first`.
    pub fn relations(&self, first: usize) -> Vec<Equation> {
        let mut equations = Vec::new();
        for side in 0..2 {
            let turns = self.line.supports[side].phi.is_some();
            for a in 1..=self.ghosts[side] {
                let inward = a - usize::from(self.line.grid == Grid::Cells);
                let (ghost, mirror, sign) = match side {
                    0 => (self.ghosts[0] - a, self.ghosts[0] + inward, -1.0),
                    _ => {
                        let last = self.ghosts[0] + self.points - 1;
                        (last + a, last - inward, 1.0)
                    }
                };
                // Signed distance of the ghost from the end.
                let offset = sign * 0.5 * (a + inward) as f64 * self.spacing;
                // u_ghost = parity u_mirror + Σ factor u_end
                let mut relate = |component, parity: f64, ends: &[(usize, f64)]| {
                    let unknown = |component, point| Unknown { component, point: first + point };
                    let mut terms = vec![(unknown(component, ghost), 1.0)];
                    if parity != 0.0 {
                        terms.push((unknown(component, mirror), -parity));
                    }
                    let mut value = 0.0;
                    for &(component, factor) in ends {
                        match self.end_point(side) {
                            Some(end) => terms.push((unknown(component, end), -factor)),
                            None => value += factor * self.end_value(side, component),
                        }
                    }
                    let origin = format!("the ghost points beyond x = {}", self.end_position(side));
                    equations.push(Equation { terms, value, origin });
                };
                match self.kinds[side] {
                    EndKind::Continued => {
                        relate(W, 0.0, &[(W, 1.0), (PHI, offset)]);
                        relate(PHI, 0.0, &[(PHI, 1.0)]);
                    }
                    _ if turns => {
                        relate(W, 1.0, &[(PHI, 2.0 * offset)]);
                        relate(PHI, -1.0, &[(PHI, 2.0)]);
                    }
                    _ => {
                        relate(W, -1.0, &[(W, 2.0)]);
                        relate(PHI, 1.0, &[]);
                    }
                }
            }
        }
        equations
    }

    /// The extended point on an end; a grid of cells has none.
    fn end_point(&self, side: usize) -> Option<usize> {
        let end = self.ghosts[0] + if side == 0 { 0 } else { self.points - 1 };
        (self.line.grid == Grid::Nodes).then_some(end)
    }

    /// The prescribed value of a component on an end.
    fn end_value(&self, side: usize, component: usize) -> f64 {
        let support = &self.line.supports[side];
        if component == W { support.w } else { support.phi }.unwrap_or(0.0)
    }

    fn end_position(&self, side: usize) -> f64 {
        self.line.from + if side == 0 { 0.0 } else { self.line.length }
    }
}
