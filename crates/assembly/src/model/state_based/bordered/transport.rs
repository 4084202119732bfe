//! What is left over in some places, handed to points that lack it.
//!
//! A place s has the volume `V_s` with the deviator `V_s d_s`, `d = (d_xx − d_yy, 2 d_xy)` for a tensor of trace two, and a
//! point k has the deviator `P_k` already. Wanted are the volumes `x_ks >= 0` that points take from places, so that places have
//! given all, `Σ_k x_ks = V_s`, and points are without a deviator, `P_k + Σ_s x_ks d_ks = 0`. Of all such volumes these are
//! the ones nearest to some that are wished for, `Σ x ln(x/wish)` least, by Newton's method on the multipliers of both
//! conditions. The solution is unique, so that what is symmetric has symmetric shares.

/// A place from which a point can take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// Index of the place.
    pub(super) place: u32,
    /// Deviator of the place as the point sees it.
    pub(super) deviator: [f64; 2],
    /// Volume that the point takes; before the solution, that it wishes for.
    pub(super) volume: f64,
}

/// Points and what they can take.
#[derive(Clone, Debug)]
pub(super) struct Transport {
    /// Of every point: behind its last edge.
    pub(super) ends: Vec<usize>,
    pub(super) edges: Vec<Edge>,
    /// Deviators that the points have.
    pub(super) deviators: Vec<[f64; 2]>,
    /// Volumes of the places.
    pub(super) volumes: Vec<f64>,
}

/// Largest deviator of a point that counts as none: cells. Rounding leaves 1e-15.
const NONE: f64 = 1e-14;
/// Steps of Newton's method at most; 4 to 7 are usual.
const STEPS: usize = 40;
/// Largest change of a logarithm in a step.
const LONGEST: f64 = 1.5;

type Vector = Vec<[f64; 2]>;

impl Transport {
    /// Finds the volumes; the largest deviator that a point is left with, cells.
    pub(super) fn solve(&mut self) -> f64 {
        let mut least = f64::INFINITY;
        for _ in 0..STEPS {
            let rest = self.rest();
            let left = rest.iter().flatten().fold(0.0, |most: f64, r| most.max(r.abs()));
            if left < NONE || (left >= 0.5 * least && left < 1e2 * NONE) {
                return left;
            }
            least = least.min(left);
            self.step(&rest);
        }
        least
    }

    /// What the points lack of being without a deviator, once places have given all.
    fn rest(&mut self) -> Vector {
        let mut given = vec![0.0; self.volumes.len()];
        self.edges.iter().for_each(|edge| given[edge.place as usize] += edge.volume);
        for edge in &mut self.edges {
            let place = edge.place as usize;
            edge.volume *= self.volumes[place] / given[place];
        }
        let mut rest: Vector = self.deviators.iter().map(|p| p.map(|p| -p)).collect();
        self.for_each(|point, edge| {
            (0..2).for_each(|c| rest[point][c] -= edge.volume * edge.deviator[c]);
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

    /// Changes the logarithms of the volumes by what both multipliers make.
    fn step(&mut self, rest: &Vector) {
        let of_points = self.multipliers(rest);
        let of_places = self.means(&of_points);
        let mut from = 0;
        for (point, &end) in self.ends.iter().enumerate() {
            for edge in &mut self.edges[from..end] {
                let change = dot(&of_points[point], &edge.deviator) - of_places[edge.place as usize];
                // Small changes are exact as they are.
                let factor = if change.abs() < 1e-3 { 1.0 + change } else { change.clamp(-LONGEST, LONGEST).exp() };
                edge.volume *= factor;
            }
            from = end;
        }
    }

    /// Means over what places give of the multipliers of the points.
    fn means(&self, of_points: &Vector) -> Vec<f64> {
        let mut sums = vec![0.0; self.volumes.len()];
        self.for_each(|point, edge| {
            sums[edge.place as usize] += edge.volume * dot(&of_points[point], &edge.deviator);
        });
        sums.iter().zip(&self.volumes).map(|(sum, volume)| sum / volume).collect()
    }

    /// How the deviators change with the multipliers of the points, places giving all.
    fn apply(&self, of_points: &Vector) -> Vector {
        let means = self.means(of_points);
        let mut found = vec![[0.0; 2]; of_points.len()];
        self.for_each(|point, edge| {
            let change = edge.volume * (dot(&of_points[point], &edge.deviator) - means[edge.place as usize]);
            (0..2).for_each(|c| found[point][c] += change * edge.deviator[c]);
        });
        found
    }

    /// The multipliers of the points that make some change of deviators: conjugate gradients.
    fn multipliers(&self, wanted: &Vector) -> Vector {
        /// Part of the residual that is left; Newton's method mends the rest.
        const LEFT: f64 = 1e-6;
        const MOST: usize = 500;
        let scales = self.scales();
        let scaled = |r: &Vector| -> Vector {
            r.iter().zip(&scales).map(|(r, s)| [r[0] / s[0], r[1] / s[1]]).collect()
        };
        let mut x = vec![[0.0; 2]; wanted.len()];
        let (mut r, mut z) = (wanted.clone(), scaled(wanted));
        let mut p = z.clone();
        let mut size = sum(&r, &z);
        let first = size;
        for _ in 0..MOST {
            if size <= LEFT * LEFT * first {
                break;
            }
            let a = self.apply(&p);
            let length = size / sum(&p, &a);
            add(&mut x, length, &p);
            add(&mut r, -length, &a);
            z = scaled(&r);
            let next = sum(&r, &z);
            let turn = next / size;
            p.iter_mut().zip(&z).for_each(|(p, z)| (0..2).for_each(|c| p[c] = z[c] + turn * p[c]));
            size = next;
        }
        x
    }

    /// What deviators change by with their own multipliers, about.
    fn scales(&self) -> Vector {
        let mut scales = vec![[f64::MIN_POSITIVE; 2]; self.ends.len()];
        self.for_each(|point, edge| {
            (0..2).for_each(|c| scales[point][c] += edge.volume * edge.deviator[c] * edge.deviator[c]);
        });
        scales
    }
}

fn dot(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn sum(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| dot(a, b)).sum()
}

fn add(to: &mut Vector, factor: f64, other: &Vector) {
    to.iter_mut().zip(other).for_each(|(t, o)| (0..2).for_each(|c| t[c] += factor * o[c]));
}
