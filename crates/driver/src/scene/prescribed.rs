//! Numbers that a case prescribes at places.

use super::formula::Formula;
use crate::case::Amount;
use crate::diagnostic::{Faults, JsonPath};

/// A number that is the same everywhere, or a formula of the position.
#[derive(Clone, Debug)]
pub(crate) enum Prescribed {
    Number(f64),
    Formula(Box<Formula>),
}

impl Prescribed {
    /// What is given, in the first `axes` coordinates; `path` is where it is given. A formula without coordinates is its number.
    pub(crate) fn new(given: &Amount, axes: usize, path: &JsonPath, faults: &mut Faults) -> Option<Self> {
        let text = match given {
            Amount::Number(value) => return Some(Self::Number(*value)),
            Amount::Formula(text) => text,
        };
        let found = Formula::new(text, axes).and_then(|formula| match formula.is_constant() {
            true => formula.at([0.0; 3]).map(Self::Number),
            false => Ok(Self::Formula(Box::new(formula))),
        });
        found
            .map_err(|reason| {
                faults
                    .error(path.clone(), reason)
                    .hint("for example `1e-3*x - 2*y^2`, in x and y, and z of a solid");
            })
            .ok()
    }

    /// Whether it is zero everywhere.
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self, Self::Number(value) if *value == 0.0)
    }

    /// Its value at a position.
    ///
    /// # Errors
    /// The formula has none there.
    pub(crate) fn at(&self, place: [f64; 3]) -> Result<f64, String> {
        match self {
            Self::Number(value) => Ok(*value),
            Self::Formula(formula) => formula.at(place),
        }
    }
}

/// Numbers along x, y and z that a case prescribes at places.
pub(crate) type Along = [Prescribed; 3];

/// Their numbers, where none is a formula.
pub(crate) fn numbers(given: &Along) -> Option<[f64; 3]> {
    let mut values = [0.0; 3];
    for (value, given) in values.iter_mut().zip(given) {
        let Prescribed::Number(number) = given else { return None };
        *value = *number;
    }
    Some(values)
}

/// Their values at a position.
///
/// # Errors
/// A formula has none there.
pub(crate) fn along(given: &Along, place: [f64; 3]) -> Result<[f64; 3], String> {
    let mut values = [0.0; 3];
    for (value, given) in values.iter_mut().zip(given) {
        *value = given.at(place)?;
    }
    Ok(values)
}
