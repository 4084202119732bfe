//! What is left over in some places, handed to points that lack it.
//!
//! A place s has the volume `V_s` with the deviator `V_s d_s`, `d = (d_xx − d_yy, 2 d_xy)` for a tensor of trace two. Wanted are
//! the volumes `x_ks >= 0` that points take from places, so that places have given all, `Σ_k x_ks = V_s`, and points are
//! without a deviator, `Σ_s x_ks d_ks = 0`. Of all such volumes these are the ones nearest to some wishes w, with the least
//! `Σ (x − w)²/w`: `x = w max(0, 1 + a_k·d_ks + b_s)` with the multipliers a and b of both conditions, which Newton's method
//! finds. The solution is unique, so that what is symmetric has symmetric shares.

/// A place from which a point can take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// Index of the place.
    pub(super) place: u32,
    /// Deviator of the place as the point sees it.
    pub(super) deviator: [f64; 2],
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
    /// Volumes of the places.
    pub(super) volumes: Vec<f64>,
}

/// Largest deviator of a point, and rest of a place, that counts as none: cells. Rounding leaves 1e-15.
const NONE: f64 = 1e-13;
/// Stiffness of what has next to none, per that of the rest.
const FAINT: f64 = 1e-9;
/// Steps of Newton's method at most; 2 to 5 are usual.
const STEPS: usize = 60;

/// How often a step is halved at most.
const HALVED: i32 = 20;

/// Values of points and of places.
#[derive(Clone, Debug)]
struct Both {
    points: Vec<[f64; 2]>,
    places: Vec<f64>,
}

impl Transport {
    /// Finds the volumes; the largest deviator that a point is left with, cells.
    pub(super) fn solve(&mut self) -> f64 {
        self.scale_wishes();
        let mut at = Both { points: vec![[0.0; 2]; self.ends.len()], places: vec![0.0; self.volumes.len()] };
        let mut height = self.take(&at);
        for _ in 0..STEPS {
            let rest = self.rest();
            if rest.largest() < NONE {
                break;
            }
            let step = self.newton(&rest);
            // Steps that are too long are halved; close to the solution only rounding tells heights apart.
            for halved in 0..=HALVED {
                let mut next = at.clone();
                next.add(0.5_f64.powi(halved), &step);
                let found = self.take(&next);
                if found <= height + 1e-14 * height.abs() || halved == HALVED {
                    (at, height) = (next, found);
                    break;
                }
            }
        }
        self.give_all();
        self.rest().largest()
    }

    /// Makes the wishes for a place sum to its volume.
    fn scale_wishes(&mut self) {
        let mut wished = vec![0.0; self.volumes.len()];
        self.edges.iter().for_each(|edge| wished[edge.place as usize] += edge.wish);
        for edge in &mut self.edges {
            edge.wish *= self.volumes[edge.place as usize] / wished[edge.place as usize];
        }
    }

    /// Takes the volumes of some multipliers; the value of the dual function, which they make least.
    fn take(&mut self, at: &Both) -> f64 {
        let mut height = -self.volumes.iter().zip(&at.places).map(|(v, b)| v * b).sum::<f64>();
        let mut from = 0;
        for (point, &end) in self.ends.iter().enumerate() {
            for edge in &mut self.edges[from..end] {
                let part = 1.0 + dot(&at.points[point], &edge.deviator) + at.places[edge.place as usize];
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
    fn rest(&self) -> Both {
        let mut rest = Both { points: vec![[0.0; 2]; self.ends.len()], places: self.volumes.clone() };
        self.for_each(|point, edge| {
            (0..2).for_each(|c| rest.points[point][c] -= edge.volume * edge.deviator[c]);
            rest.places[edge.place as usize] -= edge.volume;
        });
        rest
    }

    fn for_each(&self, mut visit: impl FnMut(usize, &Edge)) {
        let mut from = 0;
        for (point, &end) in self.ends.iter().enumerate() {
            self.edges[from..end].iter().for_each(|edge| visit(point, edge));
            from = end;
        }
    }

    /// Calls `visit` with the edges whose volumes are above zero: these alone change.
    fn for_each_used(&self, mut visit: impl FnMut(usize, &Edge)) {
        self.for_each(|point, edge| {
            if edge.volume > 0.0 {
                visit(point, edge);
            }
        });
    }

    /// The change of the multipliers that makes some change of deviators and volumes: those of places follow from those of
    /// points, which conjugate gradients find.
    fn newton(&self, rest: &Both) -> Both {
        let mut sums = vec![0.0; self.volumes.len()];
        self.for_each_used(|_, edge| sums[edge.place as usize] += edge.wish);
        // A place from which nobody takes any more is offered as it was at first.
        sums.iter_mut().zip(&self.volumes).filter(|s| *s.0 == 0.0).for_each(|(sum, volume)| *sum = *volume);
        let mut wanted = rest.points.clone();
        self.for_each_used(|point, edge| {
            let place = edge.place as usize;
            let change = edge.wish * rest.places[place] / sums[place];
            (0..2).for_each(|c| wanted[point][c] -= change * edge.deviator[c]);
        });
        let points = self.multipliers(&wanted, &sums);
        let means = self.means(&points, &sums);
        let places = (0..sums.len()).map(|s| rest.places[s] / sums[s] - means[s]).collect();
        Both { points, places }
    }

    /// Means over what places give of the multipliers of points.
    fn means(&self, points: &[[f64; 2]], sums: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; sums.len()];
        self.for_each_used(|point, edge| {
            means[edge.place as usize] += edge.wish * dot(&points[point], &edge.deviator);
        });
        means.iter().zip(sums).map(|(mean, sum)| mean / sum).collect()
    }

    /// The multipliers of points that change their deviators as wanted, while places give as much as before.
    fn multipliers(&self, wanted: &[[f64; 2]], sums: &[f64]) -> Vec<[f64; 2]> {
        /// Part of the rest that is left; the next step of Newton's method mends it.
        const LEFT: f64 = 1e-8;
        const MOST: usize = 500;
        // Where all deviators are along one axis the multiplier of the other means nothing.
        let mut scales = vec![[f64::MIN_POSITIVE; 2]; self.ends.len()];
        self.for_each(|point, edge| {
            (0..2).for_each(|c| scales[point][c] += edge.wish * (FAINT + edge.deviator[c].powi(2)));
        });
        let scaled = |r: &[[f64; 2]]| -> Vec<[f64; 2]> {
            r.iter().zip(&scales).map(|(r, s)| [r[0] / s[0], r[1] / s[1]]).collect()
        };
        let mut x = vec![[0.0; 2]; wanted.len()];
        let (mut r, mut p) = (wanted.to_vec(), scaled(wanted));
        let mut size = sum(&r, &p);
        let first = size;
        for _ in 0..MOST {
            if size <= LEFT * LEFT * first {
                break;
            }
            let mut a = self.apply(&p, sums);
            // One multiplier for all points is as good as none: places meet it.
            a.iter_mut().zip(&p).zip(&scales).for_each(|((a, p), s)| {
                (0..2).for_each(|c| a[c] += FAINT * s[c] * p[c]);
            });
            let length = size / sum(&p, &a);
            add(&mut x, length, &p);
            add(&mut r, -length, &a);
            let z = scaled(&r);
            let next = sum(&r, &z);
            let turn = next / size;
            p.iter_mut().zip(&z).for_each(|(p, z)| (0..2).for_each(|c| p[c] = z[c] + turn * p[c]));
            size = next;
        }
        x
    }

    fn apply(&self, points: &[[f64; 2]], sums: &[f64]) -> Vec<[f64; 2]> {
        let means = self.means(points, sums);
        let mut found = vec![[0.0; 2]; points.len()];
        self.for_each_used(|point, edge| {
            let change = edge.wish * (dot(&points[point], &edge.deviator) - means[edge.place as usize]);
            (0..2).for_each(|c| found[point][c] += change * edge.deviator[c]);
        });
        found
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

fn dot(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn sum(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    a.iter().zip(b).map(|(a, b)| dot(a, b)).sum()
}

fn add(to: &mut [[f64; 2]], factor: f64, other: &[[f64; 2]]) {
    to.iter_mut().zip(other).for_each(|(t, o)| (0..2).for_each(|c| t[c] += factor * o[c]));
}
