//! Force and moment of what acts on a body.

use peristat_assembly::sum::Sum;

/// Force along x and y and moment, counter-clockwise about the origin, with the sums of their magnitudes. On a line y is the
/// direction of w; on a shell the moment is about its axis; in a body of revolution only the force along y means anything.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    parts: [Sum; 3],
    /// Magnitudes of the forces, and of those times their distances from the origin.
    sizes: [f64; 2],
}

impl Resultant {
    /// Adds a force, N, at a position, m.
    pub fn add(&mut self, force: [f64; 2], at: [f64; 2]) {
        (0..2).for_each(|k| self.parts[k].add(force[k]));
        self.parts[2].add_product(at[0], force[1]);
        self.parts[2].add_product(-at[1], force[0]);
        let size = force[0].hypot(force[1]);
        self.sizes[0] += size;
        self.sizes[1] += size * at[0].hypot(at[1]);
    }

    /// Adds a couple, N m.
    pub fn add_moment(&mut self, moment: f64) {
        self.parts[2].add(moment);
        self.sizes[1] += moment.abs();
    }

    /// Adds a multiple of another one.
    pub fn add_multiple(&mut self, factor: f64, other: &Self) {
        self.parts.iter_mut().zip(other.parts).for_each(|(sum, part)| sum.add_multiple(factor, part));
        self.sizes.iter_mut().zip(other.sizes).for_each(|(size, more)| *size += factor.abs() * more);
    }

    /// Force along x and y, N.
    pub fn force(&self) -> [f64; 2] {
        [self.parts[0].total(), self.parts[1].total()]
    }

    /// Moment about the origin, N m.
    pub fn moment(&self) -> f64 {
        self.parts[2].total()
    }

    /// Sums of the magnitudes of forces, N, and of moments, N m: what rounding is measured by.
    pub fn sizes(&self) -> [f64; 2] {
        self.sizes
    }
}

#[cfg(test)]
mod tests {
    use super::Resultant;

    #[test]
    fn forces_turn_about_the_origin() {
        let mut found = Resultant::default();
        found.add([3.0, 0.0], [0.0, 2.0]);
        found.add([0.0, 1.0], [5.0, 0.0]);
        found.add_moment(0.5);
        assert_eq!((found.force(), found.moment(), found.sizes()), ([3.0, 1.0], -0.5, [4.0, 11.5]));
        let mut twice = found;
        twice.add_multiple(-2.0, &found);
        assert_eq!((twice.force(), twice.moment(), twice.sizes()), ([-3.0, -1.0], 0.5, [12.0, 34.5]));
    }
}
