//! Numbers that a case prescribes at places.

use super::formula::Formula;
use crate::case::{Amount, Steps};
use crate::diagnostic::{Faults, JsonPath};

/// A number that is the same everywhere, or a formula of the position.
#[derive(Clone, Debug)]
pub(crate) enum Prescribed {
    Number(f64),
    Formula(Box<Formula>),
}

impl Prescribed {
    /// What is given, in the first `axes` coordinates and at a load factor, where formulas may know it; `path` is where it is given. A
    /// formula without coordinates is its number.
    pub(crate) fn new(
        given: &Amount,
        (axes, factor): (usize, Option<f64>),
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Self> {
        let text = match given {
            Amount::Number(value) => return Some(Self::Number(*value)),
            Amount::Formula(text) => text,
        };
        let found = Formula::new(text, axes, factor).and_then(|formula| match formula.is_constant() {
            true => formula.at([0.0; 3]).map(Self::Number),
            false => Ok(Self::Formula(Box::new(formula))),
        });
        found
            .map_err(|reason| {
                let hint = match given.knows_load_factor() && factor.is_none() {
                    true => "stiffness does not know it; for loads and motions give \"steps\": { \"load_factors\": [0.5, 1] }: load cases, and bodies that break or soften, grow in proportion",
                    false => "for example `1e-3*x - 2*y^2`, in x and y, and z of a solid",
                };
                faults.error(path.clone(), reason).hint(hint);
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

/// A motion that a support prescribes: one that grows with the load factor, or what it is in every step.
#[derive(Clone, Debug)]
pub(crate) enum Motion {
    /// At a factor of one.
    Proportional(Prescribed),
    /// Per step its load factor and what is prescribed then.
    BySteps(Vec<(f64, Prescribed)>),
}

impl Motion {
    /// What is given, in the first `axes` coordinates; `path` is where it is given.
    pub(crate) fn new(
        given: &Amount,
        axes: usize,
        steps: Option<&Steps>,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<Self> {
        let Some(steps) = steps.filter(|_| given.knows_load_factor()) else {
            return Prescribed::new(given, (axes, None), path, faults).map(Self::Proportional);
        };
        let step =
            |&factor: &f64| Some((factor, Prescribed::new(given, (axes, Some(factor)), path, faults)?));
        steps.load_factors.iter().map(step).collect::<Option<_>>().map(Self::BySteps)
    }

    /// Whether nothing moves.
    pub(crate) fn is_zero(&self) -> bool {
        match self {
            Self::Proportional(given) => given.is_zero(),
            Self::BySteps(steps) => steps.iter().all(|(_, given)| given.is_zero()),
        }
    }

    /// Of the values of every step what stands for all of them where structure is all that counts: at a factor of one, by the last
    /// step whose factor is not zero, so that motions which agree in every step do so, whether they are proportional or not.
    pub(crate) fn standing(&self, values: &[f64]) -> f64 {
        let last = values.last().copied().unwrap_or(0.0);
        match self {
            Self::Proportional(_) => last,
            Self::BySteps(steps) => {
                let mut steps = steps.iter().zip(values).rev();
                steps
                    .find(|((factor, _), _)| *factor != 0.0)
                    .map_or(last, |((factor, _), value)| value / factor)
            }
        }
    }

    /// What is prescribed at a place, if that is proportional at a factor of one, else in every step; with the other of two the
    /// steps of which they are.
    ///
    /// # Errors
    /// A formula has no value there.
    pub(crate) fn values(&self, place: [f64; 3], other: Option<&Self>) -> Result<Vec<f64>, String> {
        match (self, other) {
            (Self::Proportional(given), Some(Self::BySteps(steps))) => {
                steps.iter().map(|(factor, _)| Ok(factor * given.at(place)?)).collect()
            }
            (Self::Proportional(given), _) => Ok(vec![given.at(place)?]),
            (Self::BySteps(steps), _) => steps.iter().map(|(_, given)| given.at(place)).collect(),
        }
    }
}
