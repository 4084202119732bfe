//! What other grids, or the exact beam, tell of the error of every quantity of a run.

use super::grid_error::{self, GridError};
use super::record::{Quantity, quantities};
use crate::summary::{Estimate, Summary};
use std::collections::HashMap;

/// Share of the largest error in a field that a value has at least where two grids only, which may agree in it by chance,
/// are known.
const SHARE: f64 = 0.1;
/// Share of the largest relative error in a state that a value has at least which goes by no order of a method.
const AKIN: f64 = 0.6;
/// Values below this share of the largest one of their field are rounding: nothing is relative to them.
const VANISHED: f64 = 1e-9;

/// The values of another grid.
pub(super) struct Other {
    /// Spacing over that of the run.
    pub(super) multiple: f64,
    values: HashMap<String, f64>,
}

impl Other {
    /// Those of a run.
    pub(super) fn new(multiple: f64, summary: &Summary) -> Self {
        // Of values with the same name, a probe and the energy, the first one counts.
        let values = quantities(summary).into_iter().rev().map(|q| (q.name, q.value)).collect();
        Self { multiple, values }
    }
}

/// The estimates of all quantities that the other grids have, too; none is below the distance from an exact beam that errs
/// with its foundation only. Whether the body has corners that turn into it is what orders are believed by.
pub(super) fn of_quantities(
    all: &[Quantity],
    others: &[Other],
    exact: Option<&HashMap<String, f64>>,
    turns_inward: bool,
) -> Vec<Estimate> {
    let found: Vec<(&Quantity, GridError)> =
        all.iter().filter_map(|own| Some((own, of_quantity(own, others, turns_inward)?))).collect();
    let floors = Floors::new(&found);
    let raised = found.iter().map(|(own, found)| {
        let (least, basis) = floors.of(own, found, others.len());
        let told = match least > found.error {
            true => estimate(own, &GridError { error: least, basis: basis.into(), ..found.clone() }),
            false => estimate(own, found),
        };
        let known = exact.and_then(|exact| exact.get(&own.name)).map(|value| from_exact(own, *value));
        known.filter(|known| known.error > told.error).unwrap_or(told)
    });
    raised.collect()
}

/// What errors are at least where grids may agree by chance.
struct Floors<'a> {
    /// The largest error by field.
    of_field: HashMap<&'a str, f64>,
    /// The largest reliable error by state, over the largest value of its field.
    of_state: HashMap<usize, f64>,
}

impl<'a> Floors<'a> {
    fn new(found: &[(&'a Quantity, GridError)]) -> Self {
        let (mut of_field, mut of_state) = (HashMap::<&str, f64>::new(), HashMap::<usize, f64>::new());
        for (own, found) in found {
            let largest = of_field.entry(&own.field).or_default();
            *largest = largest.max(found.error);
            if found.reliable && own.scale > 0.0 {
                let largest = of_state.entry(own.state).or_default();
                *largest = largest.max(found.error / own.scale);
            }
        }
        Self { of_field, of_state }
    }

    /// The least error of a quantity, and in words what it is, with so many other grids.
    fn of(&self, own: &Quantity, found: &GridError, others: usize) -> (f64, &'static str) {
        if found.settled {
            (0.0, "")
        } else if others < 2 {
            (SHARE * self.of_field[&*own.field], "0.1 of the largest in the field")
        } else if found.by_chance {
            let akin = self.of_state.get(&own.state).unwrap_or(&0.0);
            (AKIN * akin * own.scale, "0.6 of the largest relative one of the state")
        } else {
            (0.0, "")
        }
    }
}

/// The error of a quantity that the exact beam knows.
pub(super) fn from_exact(own: &Quantity, exact: f64) -> Estimate {
    let error = (own.value - exact).abs();
    let settled = error <= own.rounding;
    let basis = if settled { "that of the exact beam" } else { "distance from the exact beam" }.into();
    estimate(own, &GridError { error, order: None, settled, reliable: true, by_chance: false, basis })
}

fn of_quantity(own: &Quantity, others: &[Other], turns_inward: bool) -> Option<GridError> {
    let find = |other: &Other| Some((other.multiple, *other.values.get(&own.name)?));
    let mut grids = others.iter().map(find).collect::<Option<Vec<(f64, f64)>>>()?;
    grids.push((1.0, own.value));
    Some(grid_error::of(grids, own.rounding, turns_inward))
}

/// What a run says of the error of a quantity.
fn estimate(own: &Quantity, found: &GridError) -> Estimate {
    let unreliable = if found.reliable { "" } else { "not reliable, " };
    Estimate {
        name: own.name.clone(),
        value: own.value,
        error: found.error,
        relative: (own.value.abs() > VANISHED * own.scale).then(|| found.error / own.value.abs()),
        order: found.order,
        settled: found.settled,
        reliable: found.reliable,
        basis: format!("{unreliable}{}", found.basis),
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::ROUNDING;
    use super::*;

    fn quantity(name: &str, value: f64, state: usize) -> Quantity {
        Quantity {
            name: name.into(),
            unit: String::new(),
            field: name.into(),
            state,
            value,
            scale: value.abs(),
            rounding: ROUNDING * value.abs(),
        }
    }

    /// Estimates of 1 + 0.1 h² and of a value on which the two finer grids agree but for 1e-6, in the states of those.
    fn estimates_of(states: [usize; 2]) -> Vec<Estimate> {
        let all = [quantity("power", 1.1, states[0]), quantity("chance", 10.0, states[1])];
        let other = |multiple: f64, power: f64, chance: f64| Other {
            multiple,
            values: [("power".to_string(), power), ("chance".to_string(), chance)].into(),
        };
        of_quantities(&all, &[other(2.0, 1.4, 10.000001), other(4.0, 2.6, 10.01)], None, false)
    }

    #[test]
    fn what_agrees_by_chance_has_a_share_of_the_largest_relative_error_of_its_state() {
        let [power, chance] = &estimates_of([0, 0])[..] else { panic!("two") };
        assert!((power.error - 0.1).abs() < 1e-12, "{power:?}");
        assert!((chance.error - 0.6 * 0.1 / 1.1 * 10.0).abs() < 1e-12, "{chance:?}");
        let [_, alone] = &estimates_of([0, 1])[..] else { panic!("two") };
        assert!(alone.error < 1e-3, "{alone:?}");
    }
}
