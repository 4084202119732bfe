//! Loads as they were asked for, as they act, and what holds the body against them.

use super::measures::{ratio, worst};
use crate::scene::{Counted, Resultant};
use serde::{Deserialize, Serialize};

/// Force and moment; parts that mean nothing, such as the radial force of a ring, are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Total {
    /// Force along x, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_x: Option<f64>,
    /// Force along y, N; of a line that along w.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_y: Option<f64>,
    /// Force along z, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force_z: Option<f64>,
    /// Moment about x, N m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_x: Option<f64>,
    /// Moment about y, N m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_y: Option<f64>,
    /// Moment about z through the origin, counter-clockwise, of a shell about its axis, N m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
}

/// Resultants of what acts on a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Resultants {
    /// Of the loads, from the case and the true geometry of the body.
    pub asked: Total,
    /// Of the loads as forces on points.
    pub applied: Total,
    /// Of supports, springs and lines of symmetry.
    pub reactions: Total,
    /// Largest difference of the first two over the sum of the magnitudes.
    pub difference: f64,
}

impl Total {
    fn new(resultant: &Resultant, counted: Counted) -> Self {
        let part = |value: f64, counts: bool| counts.then_some(value);
        let all = |values: [f64; 3], counts: [bool; 3]| [0, 1, 2].map(|k| part(values[k], counts[k]));
        let [force_x, force_y, force_z] = all(resultant.force(), counted.force);
        let [moment_x, moment_y, moment] = all(resultant.moment(), counted.moment);
        Self { force_x, force_y, force_z, moment_x, moment_y, moment }
    }

    /// Forces along x, y and z.
    pub fn forces(&self) -> [Option<f64>; 3] {
        [self.force_x, self.force_y, self.force_z]
    }

    /// Moments about x, y and z.
    pub fn moments(&self) -> [Option<f64>; 3] {
        [self.moment_x, self.moment_y, self.moment]
    }
}

impl Resultants {
    /// Resultants of loads as asked and as applied, and of reactions; `counted` are the parts that mean anything, `inside` the
    /// axes along which the applied ones do more inside the body, which is not compared.
    pub(super) fn new(
        asked: &Resultant,
        applied: &Resultant,
        reactions: &Resultant,
        (counted, inside): (Counted, [bool; 3]),
    ) -> Self {
        let [forces, moments] = [0, 1].map(|k| asked.sizes()[k].max(applied.sizes()[k]));
        let off = |wanted: [f64; 3], found: [f64; 3], size: f64| {
            [0, 1, 2].map(|k| ratio((wanted[k] - found[k]).abs(), size))
        };
        let of_forces = off(asked.force(), applied.force(), forces).into_iter().zip(counted.force);
        let of_forces = of_forces.zip(inside).map(|((off, counts), inside)| (off, counts && !inside));
        let of_moments = off(asked.moment(), applied.moment(), moments).into_iter().zip(counted.moment);
        let relative = of_forces.chain(of_moments).filter(|(_, counts)| *counts).map(|(off, _)| off);
        Self {
            asked: Total::new(asked, counted),
            applied: Total::new(applied, counted),
            reactions: Total::new(reactions, counted),
            difference: worst(relative).min(f64::MAX),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of([x, y]: [f64; 2]) -> Resultant {
        let mut found = Resultant::default();
        found.add([x, y, 0.0], [2.0, 0.0, 0.0]);
        found
    }

    /// Of forces along x and y and the moment about z.
    fn counting([x, y, turn]: [bool; 3]) -> Counted {
        Counted { force: [x, y, false], moment: [false, false, turn] }
    }

    #[test]
    fn only_parts_that_count_are_compared() {
        let [asked, applied] = [of([3.0, 4.0]), of([3.0, 5.0])];
        let all = Resultants::new(&asked, &applied, &of([0.0; 2]), (counting([true; 3]), [false; 3]));
        // 1 of |(3, 5)|, and 2 of 2·|(3, 5)|.
        assert!((all.difference - 1.0 / 34.0_f64.sqrt()).abs() < 1e-15);
        let along_x =
            Resultants::new(&asked, &applied, &of([0.0; 2]), (counting([true, false, false]), [false; 3]));
        assert_eq!((along_x.difference, along_x.applied.forces()), (0.0, [Some(3.0), None, None]));
    }
}
