//! Probes and checks on results: values against what they should be.

use super::scan;
use crate::case::{FieldName, Reduction};
use crate::scene::body::BodyComparison;
use crate::scene::{Bound, Expectation, ExpectationKind};
use crate::units::Units;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A probed value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbeResult {
    /// Name of the probe.
    pub name: String,
    /// Name of the state.
    pub state: String,
    /// Position of the point that answered on its line, or the first coordinate of a place on a body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<f64>,
    /// The second coordinate of a place on a body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<f64>,
    /// The third coordinate of a place in a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<f64>,
    /// Joint, or member and position, on a frame; region or crack in the plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
    /// Name of the field, or `stress_intensity`.
    pub field: Cow<'static, str>,
    /// What is made of the values of many points; an extreme is at the position.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<Reduction>,
    /// Value.
    pub value: f64,
    /// Its unit in the units of the case: that of the field, of an integral that of the field times a volume, along beams times a
    /// length; empty where it has none.
    #[serde(default, skip_serializing_if = "str::is_empty")]
    pub unit: Cow<'static, str>,
    /// Volume that a mean or an integral is taken over, of beams a length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extent: Option<f64>,
    /// Of a stress on a hole, and in the local limit anywhere, what of the displacements around it the fields miss that give the
    /// value, as a share.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub misfit: Option<f64>,
}

/// The unit of a field that a probe reads; an integral is over lengths to some power.
pub(super) fn unit(field: FieldName, of: Option<Reduction>, power: i32, units: Units) -> Cow<'static, str> {
    let unit = field.about().unit;
    match of {
        Some(Reduction::Integral) => unit.times_length(power, units).into(),
        _ => unit.label(units).into(),
    }
}

/// The outcome of one check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CheckResult {
    /// Name.
    pub name: String,
    /// `closed_form`, `value`, `limit`, `baseline` or `formula`.
    pub kind: &'static str,
    /// What was expected: a number, or the largest magnitude of a reference.
    pub expected: f64,
    /// What was found, at the worst point where several are compared.
    pub found: f64,
    /// Error, relative to `expected` unless that is zero; for `at_most` of a limit the magnitude over it, for `at_least` what
    /// is missing.
    pub error: f64,
    /// Root of the mean square of the differences over all points, relative to that of the reference, where all points are
    /// compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub l2_error: Option<f64>,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Whether it passes.
    pub passed: bool,
    /// Why it fails where the numbers do not tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// Where the expectation comes from.
    pub source: String,
}

/// Points that are compared at once.
pub(super) const BLOCK: usize = 256;

/// The worst of several comparisons.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worst {
    pub(super) expected: f64,
    pub(super) found: f64,
    pub(super) difference: f64,
    /// Largest expected magnitude.
    pub(super) scale: f64,
    /// Sums of squares of the differences and of the expected values, and how many there are.
    pub(super) squares: [f64; 2],
    pub(super) count: usize,
}

impl Worst {
    /// Of no comparison yet.
    pub(super) const NONE: Self =
        Self { expected: 0.0, found: 0.0, difference: -1.0, scale: 0.0, squares: [0.0; 2], count: 0 };

    /// Of some values.
    pub(super) fn of(expected: &[f64], found: &[f64]) -> Self {
        let mut worst = Self::NONE;
        for (expected, found) in expected.chunks(BLOCK).zip(found.chunks(BLOCK)) {
            worst.take(expected, found);
        }
        worst
    }

    /// Takes at most [`BLOCK`] more values. What is not a number is worst of all.
    pub(super) fn take(&mut self, expected: &[f64], found: &[f64]) {
        let mut differences = [0.0; BLOCK];
        let differences = &mut differences[..expected.len()];
        differences.iter_mut().zip(expected).zip(found).for_each(|((d, e), f)| *d = (f - e).abs());
        self.scale = self.scale.max(scan::largest(expected));
        self.squares[0] += scan::squares(differences);
        self.squares[1] += scan::squares(expected);
        self.count += expected.len();
        if scan::largest(differences) <= self.difference {
            return;
        }
        for (k, &difference) in differences.iter().enumerate() {
            if difference > self.difference || (difference.is_nan() && !self.difference.is_nan()) {
                *self = Self { expected: expected[k], found: found[k], difference, ..*self };
            }
        }
    }
}

impl Worst {
    /// Root of the mean square of several differences over that of the reference; none where that vanishes or the squares
    /// do not fit into a double.
    fn l2_error(&self) -> Option<f64> {
        let error = (self.squares[0] / self.squares[1]).sqrt();
        (self.count > 1 && self.squares[1].is_normal() && error.is_finite()).then_some(error)
    }
}

impl CheckResult {
    /// Of a comparison.
    pub(super) fn of(
        name: &str,
        kind: &'static str,
        worst: Worst,
        tolerance: f64,
        source: impl Into<String>,
    ) -> Self {
        let error = if worst.scale > 0.0 { worst.difference / worst.scale } else { worst.difference };
        // A missing value is not a number, no comparison at all a negative one: neither must pass.
        let passed = (0.0..=tolerance).contains(&error);
        let (name, source) = (name.into(), source.into());
        Self {
            name,
            kind,
            expected: worst.expected,
            found: worst.found,
            error,
            l2_error: worst.l2_error(),
            tolerance,
            passed,
            remark: None,
            source,
        }
    }

    /// Of a bound and the values on both sides of a place.
    fn of_limit(name: &str, sides: [f64; 2], bound: Bound, why: &str) -> Self {
        let [right, left] = sides;
        let (expected, found, error, tolerance) = match bound {
            Bound::AtMost(most) => {
                let found = if left.abs() > right.abs() { left } else { right };
                (most, found, found.abs() / most, 1.0)
            }
            Bound::AtLeast(least) => {
                let found = if left < right { left } else { right };
                let size = if least == 0.0 { 1.0 } else { least.abs() };
                // Not by `max`, to which what is not a number is nothing.
                let missing = if found >= least { 0.0 } else { (least - found) / size };
                (least, found, missing, 0.0)
            }
        };
        Self {
            name: name.into(),
            kind: "limit",
            expected,
            found,
            error,
            l2_error: None,
            tolerance,
            passed: error <= tolerance,
            remark: None,
            source: why.into(),
        }
    }
}

/// What a check finds. `probed` gives the value of a probe, `sides` those to its right and left, for where it jumps: a bound
/// that one side exceeds is not kept. They are not numbers where there is none. `of_points` compares all points.
pub(super) fn check<F>(
    expectation: &Expectation<F>,
    probed: impl Fn(usize) -> f64,
    sides: impl Fn(usize) -> [f64; 2],
    of_points: impl Fn(&F) -> CheckResult,
) -> CheckResult {
    let name = &expectation.name;
    match &expectation.kind {
        ExpectationKind::Value { probe, expected, tolerance, source } => {
            let worst = Worst::of(&[*expected], &[probed(*probe)]);
            CheckResult::of(name, "value", worst, *tolerance, source)
        }
        ExpectationKind::Limit { probe, bound, why } => {
            CheckResult::of_limit(name, sides(*probe), *bound, why)
        }
        ExpectationKind::Points(points) => of_points(points),
    }
}

/// Outcome of a check of all points by its name, with the values that were found there.
pub(super) fn compared(name: &str, points: &BodyComparison, found: &[f64]) -> CheckResult {
    let worst = match found.len() == points.expected.len() {
        true => Worst::of(&points.expected, found),
        false => Worst { difference: f64::NAN, scale: 1.0, ..Worst::NONE },
    };
    CheckResult::of(name, points.kind, worst, points.tolerance, &*points.source)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lower_bound_is_on_the_value_with_its_sign_and_on_both_sides_of_a_jump() {
        let of = |sides, bound| {
            let check = CheckResult::of_limit("a", sides, bound, "");
            (check.passed, check.found)
        };
        for (value, least, passed) in [
            (-0.01, -0.013, true),
            (-0.02, -0.013, false),
            (1.0, -0.013, true),
            (0.0, 0.0, true),
            (0.4, 0.5, false),
        ] {
            assert_eq!(of([value; 2], Bound::AtLeast(least)), (passed, value), "{value} >= {least}");
        }
        assert_eq!(of([3.0, -2.0], Bound::AtLeast(-1.0)), (false, -2.0));
        assert_eq!(of([3.0, -4.0], Bound::AtMost(3.5)), (false, -4.0));
        assert!(!of([f64::NAN; 2], Bound::AtLeast(-1.0)).0 && !of([f64::NAN; 2], Bound::AtMost(1.0)).0);
    }
}
