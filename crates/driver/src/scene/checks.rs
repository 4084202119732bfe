//! Checks of a scene.

use super::facts::facts;
use super::foundation::Bed;
use super::{HeldPoint, ProbePoint, RigidBar, State, root};
use crate::case::{Case, Check, FieldName};
use crate::diagnostic::{Faults, JsonPath};
use crate::reference::{self, Field, Solution};
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;
use std::path::Path;

/// A check, resolved.
#[derive(Debug)]
pub struct Expectation {
    /// Name in results.
    pub name: String,
    /// Index of the state it is made on.
    pub state: usize,
    /// What is compared.
    pub kind: ExpectationKind,
}

/// Kinds of checks.
#[derive(Debug)]
pub enum ExpectationKind {
    /// All points against a closed form.
    ClosedForm {
        /// Name of the reference.
        reference: String,
        /// The solution.
        solution: Solution,
        /// Field that is compared.
        field: Field,
        /// Relative tolerance.
        tolerance: f64,
    },
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
    /// A bound on the magnitude of a probe.
    Limit {
        /// Index of the probe.
        probe: usize,
        /// Largest magnitude.
        at_most: f64,
        /// Why.
        why: String,
    },
    /// All points against stored values.
    Baseline {
        /// Field that is compared.
        field: FieldName,
        /// Positions and values.
        stored: Vec<(f64, f64)>,
        /// Relative tolerance.
        tolerance: f64,
    },
}

impl Expectation {
    /// Whether it needs fields recovered from the bonds.
    pub fn is_recovered(&self, probes: &[ProbePoint]) -> bool {
        match &self.kind {
            ExpectationKind::ClosedForm { field, .. } => matches!(field, Field::M | Field::V),
            ExpectationKind::Value { probe, .. } | ExpectationKind::Limit { probe, .. } => {
                probes[*probe].field.is_recovered()
            }
            ExpectationKind::Baseline { field, .. } => field.is_recovered(),
        }
    }
}

/// What the resolution of checks looks at.
pub(super) struct Context<'a> {
    pub(super) case: &'a Case,
    pub(super) on_frame: bool,
    pub(super) beam: &'a TimoshenkoBeam,
    pub(super) held: &'a [HeldPoint],
    pub(super) bars: &'a [RigidBar],
    pub(super) beds: &'a [Bed],
    pub(super) states: &'a [State],
    pub(super) probes: &'a [ProbePoint],
    pub(super) folder: &'a Path,
}

/// Checks of the case.
pub(super) fn expectations(context: &Context, faults: &mut Faults) -> Vec<Expectation> {
    let each = context.case.checks.iter().enumerate();
    each.filter_map(|(k, check)| expectation(context, check, root("checks").index(k), faults)).collect()
}

fn expectation(context: &Context, check: &Check, path: JsonPath, faults: &mut Faults) -> Option<Expectation> {
    let (key, load_case, tolerance) = match check {
        Check::ClosedForm(c) => ("closed_form", &c.load_case, Some(c.tolerance)),
        Check::Value(c) => ("value", &c.load_case, Some(c.tolerance)),
        Check::Limit(c) => ("limit", &c.load_case, None),
        Check::Baseline(c) => ("baseline", &c.load_case, Some(c.tolerance)),
    };
    let path = path.key(key);
    if let Some(tolerance) = tolerance {
        super::numbers::positive(tolerance, "tolerance", path.key("tolerance"), faults);
    }
    let state = match load_case {
        None => context.states.len().checked_sub(1),
        Some(name) => {
            let found = context.states.iter().position(|s| s.name == *name);
            if found.is_none() {
                faults
                    .error(path.key("load_case"), format!("there is no load case or combination `{name}`"))
                    .hint(super::words::suggest(name, context.states.iter().map(|s| s.name.as_str())));
            }
            found
        }
    }?;
    let (name, kind) = match check {
        Check::ClosedForm(c) => {
            let solution = closed_form(context, c, &path, state, faults)?;
            let (reference, field, tolerance) = (c.name.clone(), c.field, c.tolerance);
            let kind = ExpectationKind::ClosedForm { reference, solution, field, tolerance };
            (format!("{} {}", c.field.name(), c.name), kind)
        }
        Check::Value(c) => {
            let probe = probe(context, &c.probe, &path, faults)?;
            let (expected, tolerance, source) = (c.expected, c.tolerance, c.source.clone());
            (c.probe.clone(), ExpectationKind::Value { probe, expected, tolerance, source })
        }
        Check::Limit(c) => {
            super::numbers::positive(c.at_most, "at_most", path.key("at_most"), faults);
            let probe = probe(context, &c.probe, &path, faults)?;
            (
                format!("{} <= {}", c.probe, c.why),
                ExpectationKind::Limit { probe, at_most: c.at_most, why: c.why.clone() },
            )
        }
        Check::Baseline(c) => {
            let stored = super::baseline::stored(context, c, &path, faults)?;
            let kind = ExpectationKind::Baseline { field: c.field, stored, tolerance: c.tolerance };
            (format!("{} {}", c.field.name(), c.file), kind)
        }
    };
    let name = match load_case {
        Some(load_case) => format!("{name} [{load_case}]"),
        None => name,
    };
    Some(Expectation { name, state, kind })
}

fn closed_form(
    context: &Context,
    check: &crate::case::ClosedForm,
    path: &JsonPath,
    state: usize,
    faults: &mut Faults,
) -> Option<Solution> {
    let Some(reference) = reference::find(&check.name) else {
        faults
            .error(path.key("name"), format!("there is no closed form `{}`", check.name))
            .hint(super::words::suggest(&check.name, reference::TABLE.iter().map(|r| r.name)));
        return None;
    };
    if context.on_frame {
        faults
            .error(path.key("name"), "closed forms are for a body of one line, not for a frame")
            .hint("compare a probe with a number by a `value` check");
        return None;
    }
    let state = &context.states[state];
    let facts = match facts(context.beam, context.held, context.bars, context.beds, state) {
        Ok(facts) => facts,
        Err(reason) => {
            faults
                .error(path.key("name"), format!("closed forms are for {reason}"))
                .hint("compare a probe with a number by a `value` check");
            return None;
        }
    };
    match (reference.build)(&facts) {
        Ok(solution)
            if check.field == Field::Energy && solution.energy.is_none()
                || check.field != Field::Energy && !solution.fields.contains(&check.field) =>
        {
            let known: Vec<&str> = solution.fields.iter().map(|f| f.name()).collect();
            faults
                .error(path.key("field"), format!("`{}` does not give `{}`", check.name, check.field.name()))
                .hint(format!("it gives {}", known.join(", ")));
            None
        }
        Ok(solution) => Some(solution),
        Err(mismatch) => {
            faults
                .error(path.key("name"), format!("`{}` does not fit this case: {mismatch}", check.name))
                .hint("`peristat list references` says what each is for");
            None
        }
    }
}

fn probe(context: &Context, name: &str, path: &JsonPath, faults: &mut Faults) -> Option<usize> {
    let found = context.probes.iter().position(|p| p.name == name);
    // A probe with a fault of its own is not missing.
    if found.is_none() && !context.case.probes.iter().any(|p| p.name == name) {
        faults.error(path.key("probe"), format!("there is no probe `{name}`")).hint(
            match context.case.probes.as_slice() {
                [] => "the case has no `probes`: add one of this name".into(),
                probes => super::words::suggest(name, probes.iter().map(|p| p.name.as_str())),
            },
        );
    }
    found
}
