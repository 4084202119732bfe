//! Loads as they were asked for, as they act, and what holds the body against them.

use super::certificate::{ratio, worst};
use crate::scene::Resultant;
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
    /// Moment, counter-clockwise about the origin, of a shell about its axis, N m.
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
    fn new(resultant: &Resultant, counted: [bool; 3]) -> Self {
        let [x, y] = resultant.force();
        let part = |k: usize, value: f64| counted[k].then_some(value);
        Self { force_x: part(0, x), force_y: part(1, y), moment: part(2, resultant.moment()) }
    }

    /// Force along x, along y, and moment.
    pub fn parts(&self) -> [Option<f64>; 3] {
        [self.force_x, self.force_y, self.moment]
    }
}

impl Resultants {
    /// Resultants of loads as asked and as applied, and of reactions; `counted` are the parts that mean anything, `inside` the
    /// axes along which the applied ones do more inside the body, which is not compared.
    pub(super) fn new(
        asked: &Resultant,
        applied: &Resultant,
        reactions: &Resultant,
        (counted, inside): ([bool; 3], [bool; 2]),
    ) -> Self {
        let [forces, moments] = [0, 1].map(|k| asked.sizes()[k].max(applied.sizes()[k]));
        let (wanted, found) = (asked.force(), applied.force());
        let off = [wanted[0] - found[0], wanted[1] - found[1], asked.moment() - applied.moment()];
        let compared = [counted[0] && !inside[0], counted[1] && !inside[1], counted[2]];
        let relative = off.into_iter().zip([forces, forces, moments]).zip(compared);
        let relative = relative.filter(|(_, counts)| *counts).map(|((off, size), _)| ratio(off.abs(), size));
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

    fn of(force: [f64; 2]) -> Resultant {
        let mut found = Resultant::default();
        found.add(force, [2.0, 0.0]);
        found
    }

    #[test]
    fn only_parts_that_count_are_compared() {
        let [asked, applied] = [of([3.0, 4.0]), of([3.0, 5.0])];
        let all = Resultants::new(&asked, &applied, &of([0.0; 2]), ([true; 3], [false; 2]));
        // 1 of |(3, 5)|, and 2 of 2·|(3, 5)|.
        assert!((all.difference - 1.0 / 34.0_f64.sqrt()).abs() < 1e-15);
        let along_x = Resultants::new(&asked, &applied, &of([0.0; 2]), ([true, false, false], [false; 2]));
        assert_eq!((along_x.difference, along_x.applied.parts()), (0.0, [Some(3.0), None, None]));
    }
}
