//! The contact pressure of Hertz on a flat face: its integrals over the sides of cells, in closed form.

use crate::case::{ContactCentre, Hertz};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use nalgebra::Vector3;
use peristat_assembly::body::{Face, SquareLattice, WallSide};
use std::f64::consts::{FRAC_PI_4, TAU};

/// How far beside its face the middle of a contact may be, spacings; cells of a surface from a file may end half of one beside it.
pub(super) const SLACK: [f64; 2] = [1e-6, 0.5 + 1e-6];

/// Part of a side below which an integral over it is rounding.
const ROUNDING: f64 = 1e-13;

/// A circular contact on a flat face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contact {
    /// The axes in the face.
    axes: [usize; 2],
    /// Its middle along them, m.
    middle: [f64; 2],
    /// Its radius, m.
    radius: f64,
    /// Largest pressure, Pa.
    peak: f64,
}

impl Contact {
    /// The contact that a case asks for on a face.
    pub(super) fn on_face(
        load: &Hertz,
        (face, name): (Face, &str),
        (spacing, slack): (f64, f64),
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Self> {
        if !positive(load.radius, "radius", path.key("radius"), faults)
            || !is_wide_enough(load.radius, spacing, path, faults)
        {
            return None;
        }
        let Some(ContactCentre::At(at)) = load.centre else {
            let place = if load.centre.is_some() { path.key("centre") } else { path.clone() };
            let message = format!("the middle of a contact on the face `{name}` is a point of it");
            faults.error(place, message).hint("give `centre` as three numbers, `[x, y, z]`");
            return None;
        };
        if (at[face.axis] - face.at).abs() > slack * spacing {
            let along = ["x", "y", "z"][face.axis];
            let message = format!(
                "the middle of the contact is not on the face `{name}`, where {along} = {}: it has {along} = {}",
                tidy(face.at),
                tidy(at[face.axis])
            );
            faults.error(path.key("centre"), message);
            return None;
        }
        let axes = [(face.axis + 1) % 3, (face.axis + 2) % 3];
        Some(Self { axes, middle: axes.map(|axis| at[axis]), radius: load.radius, peak: load.peak })
    }

    /// Where the pressure on a side acts and its force, N; none where it does not reach. A side that stands for a part of a face, as
    /// those along the outline of a surface from a file, bears that part.
    pub(super) fn on(&self, own: &WallSide, lattice: &SquareLattice) -> Option<([f64; 3], [f64; 3])> {
        let (mut at, half) = (own.side.middle(lattice), 0.5 * lattice.spacing());
        let place = |k: usize, end: f64| (at[self.axes[k]] + end * half - self.middle[k]) / self.radius;
        let [whole, first, second] = integrals([0, 1].map(|k| [-1.0, 1.0].map(|end| place(k, end))));
        // Beside the contact integrals are rounding.
        if whole <= ROUNDING * (2.0 * half / self.radius).powi(2) {
            return None;
        }
        let force = self.peak * self.radius * self.radius * whole;
        for (k, moment) in [first, second].into_iter().enumerate() {
            let middle = at[self.axes[k]];
            let place = self.middle[k] + self.radius * moment / whole;
            at[self.axes[k]] = place.clamp(middle - half, middle + half);
        }
        let per_area = force / lattice.spacing().powi(2);
        Some((at, own.outwards.map(|a| -per_area * a)))
    }

    /// The part of it that acts on sides, over what does where the body goes on behind planes through its middle.
    pub(super) fn part_on(&self, sides: &[WallSide], lattice: &SquareLattice, goes_on: &[Face]) -> f64 {
        let through = goes_on.iter().filter(|plane| {
            let along = self.axes.iter().position(|&axis| axis == plane.axis);
            along.is_some_and(|k| (self.middle[k] - plane.at).abs() <= SLACK[0] * lattice.spacing())
        });
        let whole = TAU / 3.0 * self.radius * self.radius * self.peak * 0.5_f64.powi(through.count() as i32);
        let acts = |own: &WallSide| self.on(own, lattice).map(|(_, force)| Vector3::from(force).norm());
        sides.iter().filter_map(acts).sum::<f64>() / whole.abs()
    }

    /// Whether nothing acts.
    pub(super) fn is_zero(&self) -> bool {
        self.peak == 0.0
    }
}

/// Whether points feel the shape of a contact.
pub(super) fn is_wide_enough(radius: f64, spacing: f64, path: &JsonPath, faults: &mut Faults) -> bool {
    if radius < spacing {
        faults
            .error(path.key("radius"), "the contact is narrower than two spacings: points hardly feel it")
            .hint("use a smaller spacing, ten over the radius, or a `point` load");
        return false;
    }
    if radius < 4.0 * spacing {
        let message = format!("the contact is {} spacings wide at most", tidy(2.0 * radius / spacing));
        faults
            .warning(path.key("radius"), message)
            .hint("stresses near it need ten spacings or more over its radius");
    }
    true
}

/// `∫∫ (1, x, y) √(1 − x² − y²)` over the part of a rectangle that lies in the unit circle.
fn integrals([[left, right], [low, high]]: [[f64; 2]; 2]) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (x, y, sign) in [(right, high, 1.0), (left, high, -1.0), (right, low, -1.0), (left, low, 1.0)] {
        let of = from_middle(x.abs().min(1.0), y.abs().min(1.0));
        // What is even along an axis is odd as an integral from the middle.
        let signs = [x.signum() * y.signum(), y.signum(), x.signum()];
        (0..3).for_each(|k| sums[k] += sign * signs[k] * of[k]);
    }
    sums
}

/// The same from the middle to x and y, 0 to 1.
fn from_middle(x: f64, y: f64) -> [f64; 3] {
    let squared = 1.0 - x * x - y * y;
    let whole = if squared > 0.0 {
        beneath(x, y, squared.sqrt())
    } else {
        // Up to where the circle leaves y, and beyond, where it is the border: `∫ π/4 (1 − x²)`.
        let leaves = (1.0 - y * y).sqrt();
        let beyond = |x: f64| FRAC_PI_4 * (x - x.powi(3) / 3.0);
        beneath(leaves, y, 0.0) + beyond(x) - beyond(leaves)
    };
    // `∫ x √(1 − x² − y²) dx = ((1 − y²)^(3/2) − (1 − x² − y²)^(3/2))/3`.
    let moment = |x: f64, y: f64| (of_power(1.0, y) - of_power((1.0 - x * x).sqrt(), y)) / 3.0;
    [whole, moment(x, y), moment(y, x)]
}

/// Volume beneath the unit sphere over a rectangle from the middle to x and y inside of the circle, where it has the height z.
fn beneath(x: f64, y: f64, z: f64) -> f64 {
    let along = |a: f64, b: f64| a * (3.0 - a * a) * b.atan2(z);
    (2.0 * x * y * z + along(x, y) + along(y, x) - 2.0 * (x * y).atan2(z)) / 6.0
}

/// `∫ (a² − t²)^(3/2) dt` from 0 to t, or to a.
fn of_power(a: f64, t: f64) -> f64 {
    if a <= 0.0 {
        return 0.0;
    }
    let t = t.min(a);
    // Where it is rounding, its errors in both terms cancel.
    let root = (a * a - t * t).max(0.0).sqrt();
    (t * (5.0 * a * a - 2.0 * t * t) * root + 3.0 * a.powi(4) * t.atan2(root)) / 8.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn squares_of_any_size_have_the_integrals_of_the_circle() {
        // 2π/3, and zero moments, whatever the grid and wherever it starts.
        for (cells, start) in [(3, -1.5), (5, -1.37), (17, -1.01), (40, -1.003)] {
            let side = 2.0 * 1.6 / f64::from(cells);
            let mut sums = [0.0; 3];
            for i in 0..cells {
                for j in 0..cells {
                    let range = |k: i32, by: f64| [0, 1].map(|e| by * start + f64::from(k + e) * side);
                    let own = integrals([range(i, 1.0), range(j, 1.1)]);
                    (0..3).for_each(|k| sums[k] += own[k]);
                }
            }
            assert!((sums[0] - 2.0 * PI / 3.0).abs() < 1e-12, "{cells}: {sums:?}");
            assert!(sums[1].abs() < 1e-12 && sums[2].abs() < 1e-12, "{cells}: {sums:?}");
        }
    }

    #[test]
    fn a_square_inside_has_the_integral_of_the_midpoint_rule() {
        let (n, mut sums) = (2000, [0.0; 3]);
        let place = |k: i32, low: f64, side: f64| low + (f64::from(k) + 0.5) * side / f64::from(n);
        for i in 0..n {
            for j in 0..n {
                let (x, y) = (place(i, 0.5, 0.6), place(j, -0.3, 0.6));
                let value = (1.0 - x * x - y * y).max(0.0).sqrt() * 0.36 / f64::from(n * n);
                (0..3).for_each(|k| sums[k] += [1.0, x, y][k] * value);
            }
        }
        let exact = integrals([[0.5, 1.1], [-0.3, 0.3]]);
        // The midpoint rule is off by 1e-6 along the rim.
        assert!((0..3).all(|k| (sums[k] - exact[k]).abs() < 1e-6), "{sums:?} {exact:?}");
    }
}
