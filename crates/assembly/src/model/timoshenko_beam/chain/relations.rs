//! Relations of ghost points: what continues or mirrors a chain beyond its ends.

use super::super::end_treatment::{EndKind, EndSupport};
use super::{Chain, Grid};
use crate::condition::{Equation, Unknown};

impl Chain {
    /// Relations of the ghost points, for a chain whose first extended point has the number `first`.
    pub fn relations(&self, first: usize) -> Vec<Equation> {
        let mut equations = Vec::new();
        let (w, phi) = (0, 1);
        for side in 0..2 {
            let EndSupport { w: w0, phi: phi0 } = self.line.supports[side];
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
                let unknown = |component, point| Unknown { component, point: first + point };
                let mut relate = |component, parity: Option<f64>, value: f64| {
                    let mut terms = vec![(unknown(component, ghost), 1.0)];
                    terms.extend(parity.map(|p| (unknown(component, mirror), -p)));
                    let origin = format!("the ghost points beyond x = {}", self.end_position(side));
                    equations.push(Equation { terms, value, origin });
                };
                match (self.kinds[side], w0, phi0) {
                    (EndKind::Continued, Some(w0), Some(phi0)) => {
                        relate(w, None, w0 + offset * phi0);
                        relate(phi, None, phi0);
                    }
                    (_, _, Some(phi0)) => {
                        relate(w, Some(1.0), 2.0 * offset * phi0);
                        relate(phi, Some(-1.0), 2.0 * phi0);
                    }
                    (_, w0, None) => {
                        relate(w, Some(-1.0), 2.0 * w0.unwrap_or(0.0));
                        relate(phi, Some(1.0), 0.0);
                    }
                }
            }
        }
        equations
    }

    fn end_position(&self, side: usize) -> f64 {
        self.line.from + if side == 0 { 0.0 } else { self.line.length }
    }
}
