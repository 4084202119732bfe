//! The questions of a reference whose beam lies on a foundation: which one, and what else loads the beam.

use super::questions::mismatch;
use super::{Facts, Load};

impl Facts {
    /// The force at x and the stiffness of the foundation, if there is nothing else.
    pub(super) fn only_force_at_on_foundation(&self, x: f64) -> Result<(f64, f64), String> {
        self.on_foundation(|facts| facts.only_force_at(x))
    }

    /// Amplitude and number of half waves of a sine and the stiffness of the foundation, if there is nothing
    /// else.
    pub(super) fn only_sine_on_foundation(&self) -> Result<((f64, u32), f64), String> {
        self.on_foundation(Self::only_sine)
    }

    /// The answer for the loads without the foundation, and the stiffness of the foundation.
    fn on_foundation<T>(&self, ask: impl Fn(&Self) -> Result<T, String>) -> Result<(T, f64), String> {
        let (foundations, others) = split(&self.loads);
        let stiffness = match foundations.as_slice() {
            [] => return mismatch("a foundation", "none"),
            [stiffness] if *stiffness > 0.0 => *stiffness,
            [stiffness] => {
                return mismatch("a foundation that pushes back", format_args!("one of {stiffness} N/m²"));
            }
            many => return mismatch("one foundation", many.len()),
        };
        ask(&Self { loads: others, ..self.clone() })
            .map(|answer| (answer, stiffness))
            .map_err(|message| message + " on a foundation")
    }
}

/// The stiffness of each foundation, and the other loads.
fn split(loads: &[Load]) -> (Vec<f64>, Vec<Load>) {
    let (mut foundations, mut others) = (Vec::new(), Vec::new());
    for load in loads {
        match *load {
            Load::Foundation { stiffness } => foundations.push(stiffness),
            other => others.push(other),
        }
    }
    (foundations, others)
}

/// The loads in a few words.
pub(super) fn words(loads: &[Load]) -> String {
    let (foundations, others) = split(loads);
    let others = match others.as_slice() {
        [] => "no load".to_owned(),
        [load] => load.to_string(),
        many => format!("{} loads", many.len()),
    };
    if foundations.is_empty() { others } else { format!("{others} on a foundation") }
}

#[cfg(test)]
mod tests {
    use super::super::questions::tests::cantilever;
    use super::*;

    #[test]
    fn a_foundation_is_not_overlooked() {
        let mut facts = cantilever();
        facts.loads.push(Load::Foundation { stiffness: 5.0 });
        let message = facts.only_force_at(2.0).unwrap_err();
        assert_eq!(
            message,
            "it needs one load, a force at x = 2, the scene has a force at x = 2 on a foundation"
        );
        assert_eq!(facts.only_force_at_on_foundation(2.0), Ok((3.0, 5.0)));
        let message = facts.only_force_at_on_foundation(1.0).unwrap_err();
        assert_eq!(
            message,
            "it needs one load, a force at x = 1, the scene has a force at x = 2 on a foundation"
        );
        facts.loads.remove(0);
        let message = facts.only_sine_on_foundation().unwrap_err();
        let expected =
            "it needs one load, a sine of at least one half wave, the scene has no load on a foundation";
        assert_eq!(message, expected);
    }

    #[test]
    fn a_missing_or_useless_foundation_is_named() {
        let mut facts = cantilever();
        let message = facts.only_force_at_on_foundation(2.0).unwrap_err();
        assert_eq!(message, "it needs a foundation, the scene has none");
        facts.loads.push(Load::Foundation { stiffness: 0.0 });
        let message = facts.only_force_at_on_foundation(2.0).unwrap_err();
        assert_eq!(message, "it needs a foundation that pushes back, the scene has one of 0 N/m²");
        facts.loads.push(Load::Foundation { stiffness: 5.0 });
        let message = facts.only_force_at_on_foundation(2.0).unwrap_err();
        assert_eq!(message, "it needs one foundation, the scene has 2");
    }
}
