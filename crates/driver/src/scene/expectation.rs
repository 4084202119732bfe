//! What the results of a scene must be.

use super::root;
use crate::case::{Baseline, Case, Check, ClosedForm, FRACTURE_FACTS, Formula, Fracture, Limit};
use crate::diagnostic::{Faults, JsonPath, positive, suggest};

/// A check, resolved.
#[derive(Debug)]
pub struct Expectation<F> {
    /// Name in results.
    pub name: String,
    /// Index of the state it is made on.
    pub state: usize,
    /// What is compared.
    pub kind: ExpectationKind<F>,
}

/// Kinds of checks; `F` is what a family of models compares at all of its points.
#[derive(Debug)]
pub enum ExpectationKind<F> {
    /// A probe against a number.
    Value {
        /// Index of the probe.
        probe: usize,
        /// Expected value.
        expected: f64,
        /// Relative tolerance.
        tolerance: f64,
        /// Where the number comes from.
        source: String,
    },
    /// A bound on a probe.
    Limit {
        /// Index of the probe.
        probe: usize,
        /// What it keeps.
        bound: Bound,
        /// Why.
        why: String,
    },
    /// All points against a closed form or stored values.
    Points(F),
}

/// What a limit keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The largest magnitude.
    AtMost(f64),
    /// The smallest value, with its sign.
    AtLeast(f64),
}

/// A check that compares all points.
pub(super) enum PointsCheck<'a> {
    ClosedForm(&'a ClosedForm),
    Baseline(&'a Baseline),
    Formula(&'a Formula),
}

/// Checks of the case on its states and probes, both given by their names. `of_points` resolves a check that compares all
/// points, from its path and the index of its state.
pub(super) fn expectations<F>(
    case: &Case,
    states: &[&str],
    probes: &[&str],
    of_points: impl Fn(PointsCheck, &JsonPath, usize, &mut Faults) -> Option<F>,
    faults: &mut Faults,
) -> Vec<Expectation<F>> {
    let mut resolve = |(k, check): (usize, &Check)| {
        let path = root("checks").index(k).key(key(check));
        let (state, load_case) = state(check, states, &path, faults)?;
        let (name, kind) = match check {
            Check::Value(c) => {
                let probe = probe(case, probes, &c.probe, &path, faults)?;
                let (expected, tolerance, source) = (c.expected, c.tolerance, c.source.clone());
                (c.probe.clone(), ExpectationKind::Value { probe, expected, tolerance, source })
            }
            Check::Limit(c) => {
                let bound = bound(c, &path, faults);
                let (probe, bound) = (probe(case, probes, &c.probe, &path, faults)?, bound?);
                let sign = if matches!(bound, Bound::AtMost(_)) { "<=" } else { ">=" };
                let kind = ExpectationKind::Limit { probe, bound, why: c.why.clone() };
                (format!("{} {sign} {}", c.probe, c.why), kind)
            }
            Check::ClosedForm(c) => {
                let points = of_points(PointsCheck::ClosedForm(c), &path, state, faults)?;
                (format!("{} {}", c.field.name(), c.name), ExpectationKind::Points(points))
            }
            Check::Baseline(c) => {
                let points = of_points(PointsCheck::Baseline(c), &path, state, faults)?;
                (format!("{} {}", c.field.name(), c.file), ExpectationKind::Points(points))
            }
            Check::Formula(c) => {
                let points = of_points(PointsCheck::Formula(c), &path, state, faults)?;
                (format!("{} formula", c.field.name()), ExpectationKind::Points(points))
            }
        };
        let name = match load_case {
            Some(load_case) => format!("{name} [{load_case}]"),
            None => name,
        };
        Some(Expectation { name, state, kind })
    };
    case.checks.iter().enumerate().filter_map(&mut resolve).collect()
}

/// The bound of a limit.
fn bound(limit: &Limit, path: &JsonPath, faults: &mut Faults) -> Option<Bound> {
    let (message, hint) = match (limit.at_most, limit.at_least) {
        (Some(most), None) if most < 0.0 => {
            let message = format!("`at_most` must be greater than zero, found {most}");
            let hint = "it bounds the magnitude; `at_least` is a lower bound, with its sign";
            faults.error(path.key("at_most"), message).hint(hint);
            return None;
        }
        (Some(most), None) => {
            positive(most, "at_most", path.key("at_most"), faults);
            return Some(Bound::AtMost(most));
        }
        (None, Some(least)) => return Some(Bound::AtLeast(least)),
        (None, None) => (
            "a limit needs `at_most` or `at_least`",
            "`at_most` bounds the magnitude, `at_least` the value with its sign",
        ),
        (Some(_), Some(_)) => {
            ("`at_most` and `at_least` stand in one limit", "write a limit for each of them")
        }
    };
    faults.error(path.clone(), message).hint(hint);
    None
}

/// The key of a check in its case.
fn key(check: &Check) -> &'static str {
    match check {
        Check::ClosedForm(_) => "closed_form",
        Check::Value(_) => "value",
        Check::Limit(_) => "limit",
        Check::Baseline(_) => "baseline",
        Check::Formula(_) => "formula",
    }
}

/// Index of the state that a check is made on, with the load case that it names; faults of its tolerance, too.
fn state<'a>(
    check: &'a Check,
    states: &[&str],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(usize, Option<&'a String>)> {
    let (load_case, tolerance) = match check {
        Check::ClosedForm(c) => (&c.load_case, Some(c.tolerance)),
        Check::Value(c) => (&c.load_case, Some(c.tolerance)),
        Check::Limit(c) => (&c.load_case, None),
        Check::Baseline(c) => (&c.load_case, Some(c.tolerance)),
        Check::Formula(c) => (&c.load_case, Some(c.tolerance)),
    };
    if let Some(tolerance) = tolerance {
        positive(tolerance, "tolerance", path.key("tolerance"), faults);
    }
    let Some(name) = load_case else {
        return Some((states.len().checked_sub(1)?, None));
    };
    let found = states.iter().position(|s| s == name);
    if found.is_none() {
        faults
            .error(path.key("load_case"), format!("there is no load case or combination `{name}`"))
            .hint(suggest(name, states.iter().copied()));
    }
    Some((found?, Some(name)))
}

fn probe(case: &Case, probes: &[&str], name: &str, path: &JsonPath, faults: &mut Faults) -> Option<usize> {
    let found = probes.iter().position(|p| *p == name);
    // A probe or a fracture with a fault of its own is not missing.
    let is_fact = |fracture: &Fracture| {
        let mut of_directions = fracture.directions.iter().flat_map(|direction| direction.facts());
        FRACTURE_FACTS.contains(&name) || of_directions.any(|fact| fact == name)
    };
    let is_there = case.probes.iter().any(|p| p.name == name) || case.fracture.as_ref().is_some_and(is_fact);
    if found.is_none() && !is_there {
        // Facts of bodies that break are among them.
        let others = case.probes.iter().map(|p| p.name.as_str()).filter(|name| !probes.contains(name));
        let known: Vec<&str> = probes.iter().copied().chain(others).collect();
        faults.error(path.key("probe"), format!("there is no probe `{name}`")).hint(match &known[..] {
            [] => "the case has no `probes`: add one of this name".into(),
            known => suggest(name, known.iter().copied()),
        });
    }
    found
}
