//! Steps of Newton's method towards the multipliers of a transport.

use super::transport::{Both, Edge, Transport};

/// Stiffness of what has next to none, per that of the rest.
const FAINT: f64 = 1e-9;

impl Transport {
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
    pub(super) fn newton(&self, rest: &Both) -> Both {
        let mut sums = vec![0.0; self.volumes.len()];
        self.for_each_used(|_, edge| sums[edge.place as usize] += edge.wish);
        // A place from which nobody takes any more is offered as it was at first.
        sums.iter_mut().zip(&self.volumes).filter(|s| *s.0 == 0.0).for_each(|(sum, volume)| *sum = *volume);
        let mut wanted = rest.points.clone();
        self.for_each_used(|point, edge| {
            let place = edge.place as usize;
            let change = edge.wish * rest.places[place] / sums[place];
            (0..2).for_each(|c| wanted[point][c] -= change * edge.measured[c]);
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
            means[edge.place as usize] += edge.wish * dot(&points[point], &edge.measured);
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
            (0..2).for_each(|c| scales[point][c] += edge.wish * (FAINT + edge.measured[c].powi(2)));
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
            for ((a, p), (s, slack)) in a.iter_mut().zip(&p).zip(scales.iter().zip(&self.slacks)) {
                (0..2).for_each(|c| a[c] += (FAINT * s[c] + slack) * p[c]);
            }
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
            let change = edge.wish * (dot(&points[point], &edge.measured) - means[edge.place as usize]);
            (0..2).for_each(|c| found[point][c] += change * edge.measured[c]);
        });
        found
    }
}

pub(super) fn dot(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn sum(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    a.iter().zip(b).map(|(a, b)| dot(a, b)).sum()
}

pub(super) fn add(to: &mut [[f64; 2]], factor: f64, other: &[[f64; 2]]) {
    to.iter_mut().zip(other).for_each(|(t, o)| (0..2).for_each(|c| t[c] += factor * o[c]));
}
