//! Force and moment of what acts on a body.

use peristat_assembly::sum::Sum;

/// Difference of the loads as asked and as applied, relative to their magnitudes, that is rounding: the gallery has 1e-14, and
/// a million points 1e-13.
pub(crate) const ASKED: f64 = 1e-10;

/// Force and moment about the origin, with the sums of their magnitudes. On a line y is the direction of w; on a shell the moment
/// about its axis is the third one; in a body of revolution only the force along y means anything.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    force: [Sum; 3],
    moment: [Sum; 3],
    /// Magnitudes of the forces, and of those times their distances from the origin.
    sizes: [f64; 2],
}

/// Which parts of resultants mean anything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counted {
    /// Forces along x, y and z.
    pub force: [bool; 3],
    /// Moments about x, y and z.
    pub moment: [bool; 3],
}

impl Resultant {
    /// Adds a force, N, at a position, m.
    pub fn add(&mut self, force: [f64; 3], at: [f64; 3]) {
        for k in (0..3).filter(|k| force[*k] != 0.0) {
            let [next, last] = [(k + 1) % 3, (k + 2) % 3];
            self.force[k].add(force[k]);
            self.moment[next].add_product(at[last], force[k]);
            self.moment[last].add_product(-at[next], force[k]);
        }
        let size = length(force);
        self.sizes[0] += size;
        self.sizes[1] += size * length(at);
    }

    /// Adds a couple about an axis, N m.
    pub fn add_moment(&mut self, axis: usize, moment: f64) {
        self.moment[axis].add(moment);
        self.sizes[1] += moment.abs();
    }

    /// Adds a multiple of another one.
    pub fn add_multiple(&mut self, factor: f64, other: &Self) {
        self.force.iter_mut().zip(other.force).for_each(|(sum, part)| sum.add_multiple(factor, part));
        self.moment.iter_mut().zip(other.moment).for_each(|(sum, part)| sum.add_multiple(factor, part));
        self.sizes.iter_mut().zip(other.sizes).for_each(|(size, more)| *size += factor.abs() * more);
    }

    /// Force, N.
    pub fn force(&self) -> [f64; 3] {
        self.force.map(|sum| sum.total())
    }

    /// Moment about the origin, N m.
    pub fn moment(&self) -> [f64; 3] {
        self.moment.map(|sum| sum.total())
    }

    /// Sums of the magnitudes of forces, N, and of moments, N m: what rounding is measured by.
    pub fn sizes(&self) -> [f64; 2] {
        self.sizes
    }
}

/// Length of a vector. Most lie along an axis, and a root takes longer than all the rest of a sum.
fn length([x, y, z]: [f64; 3]) -> f64 {
    let hypot = |a: f64, b: f64| if a == 0.0 || b == 0.0 { (a + b).abs() } else { a.hypot(b) };
    hypot(hypot(x, y), z)
}

#[cfg(test)]
mod tests {
    use super::Resultant;

    #[test]
    fn forces_turn_about_the_origin() {
        let mut found = Resultant::default();
        found.add([3.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
        found.add([0.0, 1.0, 0.0], [5.0, 0.0, 0.0]);
        found.add_moment(2, 0.5);
        let moment = [0.0, 0.0, -0.5];
        assert_eq!((found.force(), found.moment(), found.sizes()), ([3.0, 1.0, 0.0], moment, [4.0, 11.5]));
        let mut twice = found;
        twice.add_multiple(-2.0, &found);
        let moment = [0.0, 0.0, 0.5];
        assert_eq!((twice.force(), twice.moment(), twice.sizes()), ([-3.0, -1.0, 0.0], moment, [12.0, 34.5]));
        // Two forces along z at x = 1 and y = 1.
        let mut across = Resultant::default();
        across.add([0.0, 0.0, 2.0], [1.0, 0.0, 0.0]);
        across.add([0.0, 0.0, 2.0], [0.0, 1.0, 0.0]);
        assert_eq!((across.force(), across.moment()), ([0.0, 0.0, 4.0], [2.0, -2.0, 0.0]));
    }
}
