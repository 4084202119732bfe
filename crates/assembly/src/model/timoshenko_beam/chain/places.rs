//! Which part of a line belongs to which point.

use super::{Chain, Grid, Line};

impl Chain {
    /// Positions of the real points in the plane, m.
    pub fn places(&self) -> impl Iterator<Item = [f64; 2]> {
        let Line { origin, direction, .. } = &self.line;
        let along = (0..self.points).map(|k| self.position(self.ghosts[0] + k));
        along.map(|x| [0, 1].map(|k| origin[k] + x * direction[k]))
    }

    /// The real point nearest to a coordinate.
    pub fn nearest(&self, x: f64) -> usize {
        let last = self.points - 1;
        let below = match &self.line.stations {
            Some(stations) => {
                let next = stations.partition_point(|s| self.line.from + s <= x);
                next.saturating_sub(1)
            }
            None => (((x - self.origin) / self.spacing).max(0.0) as usize).min(last),
        };
        let at = |k: usize| (self.position(self.ghosts[0] + k) - x).abs();
        if below < last && at(below + 1) < at(below) { below + 1 } else { below }
    }

    /// The part of the line that belongs to a real point.
    pub fn tributary(&self, k: usize) -> (f64, f64) {
        let at = |k: usize| self.position(self.ghosts[0] + k);
        let x = at(k);
        if self.line.grid == Grid::Cells {
            return (x - 0.5 * self.spacing, x + 0.5 * self.spacing);
        }
        let left = if k == 0 { x } else { 0.5 * (at(k - 1) + x) };
        (left, if k + 1 == self.points { x } else { 0.5 * (x + at(k + 1)) })
    }

    /// The part of `[from, to]` that belongs to a real point, and the position of the point if that is its whole part: the
    /// literature then takes the value there, and of less the integral. `None` if there is no such part.
    pub fn share(&self, k: usize, [from, to]: [f64; 2]) -> Option<([f64; 2], Option<f64>)> {
        let (a, b) = self.tributary(k);
        let slack = 1e-9 * (b - a);
        let whole = from <= a + slack && to >= b - slack;
        let part = [a.max(from), b.min(to)];
        (part[1] > part[0]).then(|| (part, whole.then(|| self.position(self.ghosts[0] + k))))
    }
}
