//! What is left over in some places, handed to points that lack it.
//!
//! A place s has the volume `V_s` with the deviator `V_s d_s`, `d = (d_xx − d_yy, 2 d_xy)` for a tensor of trace two. Wanted are
//! the volumes `x_ks >= 0` that points take from places, so that places have given all, `Σ_k x_ks = V_s`, and points are
//! without a deviator, `Σ_s x_ks d_ks = 0`. Of all such volumes these are the ones nearest to some wishes w, with the least
//! `Σ (x − w)²/w`: `x = w max(0, 1 + a_k·d_ks + b_s)` with the multipliers a and b of both conditions, which Newton's method
//! finds. The solution is unique, so that what is symmetric has symmetric shares. In place of a deviator of zero points can want
//! other sums, such as volumes of their own.

use super::newton::{add, dot};

/// A place from which a point can take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// Index of the place.
    pub(super) place: u32,
    /// Deviator of the place as the point sees it, or what else is wanted of it.
    pub(super) measured: [f64; 2],
    /// What the point wishes for, in parts of a place.
    pub(super) wish: f64,
    /// Volume that the point takes.
    pub(super) volume: f64,
}

/// Points and what they can take.
#[derive(Clone, Debug)]
pub(super) struct Transport {
    /// Of every point: behind its last edge.
    pub(super) ends: Vec<usize>,
    pub(super) edges: Vec<Edge>,
    /// What points are to have of what is measured.
    pub(super) wanted: Vec<[f64; 2]>,
    /// Volumes of the places.
    pub(super) volumes: Vec<f64>,
    /// How much of what is wanted a point gives up per multiplier, as a part of its wishes; zero where all is to be met.
    pub(super) slack: f64,
    /// The same per point.
    pub(super) slacks: Vec<f64>,
}

/// Largest deviator of a point, and rest of a place, that counts as none: cells. Rounding leaves 1e-15.
const NONE: f64 = 1e-13;
/// Steps of Newton's method at most; 2 to 5 are usual.
const STEPS: usize = 60;

/// Steps in a row that do not halve the rest before it is what can be reached.
const IDLE: usize = 8;

/// How often a step is halved at most.
const HALVED: i32 = 20;

/// Values of points and of places.
#[derive(Clone, Debug)]
pub(super) struct Both {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) places: Vec<f64>,
}

impl Transport {
    /// Finds the volumes; the largest deviator that a point is left with, cells.
    pub(super) fn solve(&mut self) -> f64 {
        self.scale_wishes();
        let mut at = Both { points: vec![[0.0; 2]; self.ends.len()], places: vec![0.0; self.volumes.len()] };
        let mut height = self.take(&at);
        let (mut least, mut idle) = (f64::INFINITY, 0);
        for _ in 0..STEPS {
            let rest = self.rest(&at);
            idle = if rest.largest() < 0.5 * least { 0 } else { idle + 1 };
            least = least.min(rest.largest());
            if least < NONE || idle > IDLE {
                break;
            }
            let step = self.newton(&rest);
            // Steps that are too long are halved; close to the solution rounding hides how heights differ, and rests tell.
            for halved in 0..=HALVED {
                let mut next = at.clone();
                next.add(0.5_f64.powi(halved), &step);
                let found = self.take(&next);
                if found <= height || self.rest(&next).largest() < rest.largest() || halved == HALVED {
                    (at, height) = (next, found);
                    break;
                }
            }
        }
        self.give_all();
        self.rest(&at).largest()
    }

    /// Makes the wishes for a place sum to its volume.
    fn scale_wishes(&mut self) {
        let mut wished = vec![0.0; self.volumes.len()];
        self.edges.iter().for_each(|edge| wished[edge.place as usize] += edge.wish);
        for edge in &mut self.edges {
            edge.wish *= self.volumes[edge.place as usize] / wished[edge.place as usize];
        }
        let mut slacks = vec![0.0; self.ends.len()];
        self.for_each(|point, edge| slacks[point] += self.slack * edge.wish);
        self.slacks = slacks;
    }

    /// Takes the volumes of some multipliers; the value of the dual function, which they make least.
    fn take(&mut self, at: &Both) -> f64 {
        let mut height = -self.volumes.iter().zip(&at.places).map(|(v, b)| v * b).sum::<f64>();
        for (point, a) in at.points.iter().enumerate() {
            height += 0.5 * self.slacks[point] * dot(a, a) - dot(a, &self.wanted[point]);
        }
        let mut from = 0;
        for (point, &end) in self.ends.iter().enumerate() {
            for edge in &mut self.edges[from..end] {
                let part = 1.0 + dot(&at.points[point], &edge.measured) + at.places[edge.place as usize];
                edge.volume = edge.wish * part.max(0.0);
                height += 0.5 * edge.volume * part.max(0.0);
            }
            from = end;
        }
        height
    }

    /// Makes what rounding has left of the places nothing.
    fn give_all(&mut self) {
        let mut given = vec![0.0; self.volumes.len()];
        self.edges.iter().for_each(|edge| given[edge.place as usize] += edge.volume);
        for edge in self.edges.iter_mut().filter(|edge| edge.volume > 0.0) {
            edge.volume *= self.volumes[edge.place as usize] / given[edge.place as usize];
        }
    }

    /// What points lack of being without a deviator, and places have left.
    fn rest(&self, at: &Both) -> Both {
        let mut rest = Both { points: self.wanted.clone(), places: self.volumes.clone() };
        for (point, a) in at.points.iter().enumerate() {
            (0..2).for_each(|c| rest.points[point][c] -= self.slacks[point] * a[c]);
        }
        self.for_each(|point, edge| {
            (0..2).for_each(|c| rest.points[point][c] -= edge.volume * edge.measured[c]);
            rest.places[edge.place as usize] -= edge.volume;
        });
        rest
    }

    pub(super) fn for_each(&self, mut visit: impl FnMut(usize, &Edge)) {
        let mut from = 0;
        for (point, &end) in self.ends.iter().enumerate() {
            self.edges[from..end].iter().for_each(|edge| visit(point, edge));
            from = end;
        }
    }
}

impl Both {
    fn largest(&self) -> f64 {
        self.points.iter().flatten().chain(&self.places).fold(0.0, |most, r| most.max(r.abs()))
    }

    fn add(&mut self, factor: f64, other: &Self) {
        add(&mut self.points, factor, &other.points);
        self.places.iter_mut().zip(&other.places).for_each(|(t, o)| *t += factor * o);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(place: u32, measured: [f64; 2], wish: f64) -> Edge {
        Edge { place, measured, wish, volume: 0.0 }
    }

    /// Two points mirror each other, with a place of all directions in the middle and one of its own on either side.
    #[test]
    fn places_give_all_and_points_have_all_directions() {
        let own = |place: u32, sign: f64| {
            vec![
                edge(0, [1.0, 0.0], 1.0),
                edge(place, [-0.5, sign], 1.0),
                edge(3 - place, [-0.5, -sign], 0.2),
            ]
        };
        let edges = [own(1, 1.0), own(2, -1.0)].concat();
        let mut transport = Transport {
            ends: vec![3, 6],
            edges,
            wanted: vec![[0.0; 2]; 2],
            volumes: vec![0.5; 3],
            slack: 0.0,
            slacks: Vec::new(),
        };
        assert!(transport.solve() < 1e-13);
        let volumes: Vec<f64> = transport.edges.iter().map(|edge| edge.volume).collect();
        (0..3).for_each(|k| assert!((volumes[k] - volumes[3 + k]).abs() < 1e-13, "{volumes:?}"));
        for (found, expected) in volumes[..3].iter().zip([0.25, 0.25, 0.25]) {
            assert!((found - expected).abs() < 1e-13, "{volumes:?}");
        }
    }

    #[test]
    fn what_cannot_be_met_is_told() {
        let edges = vec![edge(0, [1.0, 0.0], 1.0), edge(1, [1.0, 0.5], 1.0)];
        let mut transport = Transport {
            ends: vec![2],
            edges,
            wanted: vec![[0.0; 2]],
            volumes: vec![0.5, 0.5],
            slack: 0.0,
            slacks: Vec::new(),
        };
        assert!(transport.solve() > 0.1);
    }
}
