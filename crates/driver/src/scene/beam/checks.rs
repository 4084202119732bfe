//! Checks of a beam at all of its points.

use super::baseline;
use super::facts::facts;
use super::foundation::Bed;
use super::links::RigidBar;
use super::probes::BeamProbe;
use super::state::State;
use super::supports::HeldPoint;
use crate::case::{Baseline, Case, ClosedForm, FieldName};
use crate::diagnostic::{Faults, JsonPath, suggest};
use crate::input::Folder;
use crate::reference::{self, Field, Solution};
use crate::scene::expectation::{self, PointsCheck};
use crate::scene::words;
use crate::scene::{Expectation, ExpectationKind};
use crate::units::Units;
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;

/// A comparison at all points of a beam.
#[derive(Debug)]
pub enum BeamComparison {
    /// With a closed form.
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
    /// With stored values.
    Baseline {
        /// Field that is compared.
        field: FieldName,
        /// Positions and values.
        stored: Vec<(f64, f64)>,
        /// Relative tolerance.
        tolerance: f64,
    },
}

impl Expectation<BeamComparison> {
    /// Whether it needs fields recovered from the bonds.
    pub fn is_recovered(&self, probes: &[BeamProbe]) -> bool {
        match &self.kind {
            ExpectationKind::Value { probe, .. } | ExpectationKind::Limit { probe, .. } => {
                probes.get(*probe).is_some_and(|p| p.field.is_recovered())
            }
            ExpectationKind::Points(BeamComparison::ClosedForm { field, .. }) => {
                matches!(field, Field::M | Field::V)
            }
            ExpectationKind::Points(BeamComparison::Baseline { field, .. }) => field.is_recovered(),
        }
    }
}

/// What the resolution of checks looks at.
pub(super) struct CheckedBeam<'a> {
    /// Names beside those of the probes that checks can ask for.
    pub(super) facts: &'a [&'a str],
    pub(super) on_frame: bool,
    /// The fields that points have.
    pub(super) fields: &'a [FieldName],
    pub(super) units: Units,
    pub(super) beam: &'a TimoshenkoBeam,
    pub(super) held: &'a [HeldPoint],
    pub(super) bars: &'a [RigidBar],
    pub(super) beds: &'a [Bed],
    pub(super) states: &'a [State],
    pub(super) folder: &'a Folder,
    pub(super) max_memory: Option<u64>,
}

/// Checks of the case.
pub(super) fn expectations(
    case: &Case,
    context: &CheckedBeam,
    probes: &[BeamProbe],
    faults: &mut Faults,
) -> Vec<Expectation<BeamComparison>> {
    let states: Vec<&str> = context.states.iter().map(|s| s.name.as_str()).collect();
    let probes: Vec<&str> =
        probes.iter().map(|p| p.name.as_str()).chain(context.facts.iter().copied()).collect();
    let compare = |check: PointsCheck, path: &JsonPath, state: usize, faults: &mut Faults| match check {
        PointsCheck::ClosedForm(c) => Some(BeamComparison::ClosedForm {
            reference: c.name.clone(),
            solution: closed_form(context, c, path, state, faults)?,
            field: c.field,
            tolerance: c.tolerance,
        }),
        PointsCheck::Baseline(c) => Some(BeamComparison::Baseline {
            field: c.field,
            stored: stored(context, c, path, faults)?,
            tolerance: c.tolerance,
        }),
        PointsCheck::Formula(_) => {
            faults.error(path.clone(), "formulas are for bodies in the plane").hint(
                "compare a beam with a closed form, see `peristat list references`, or a probe with a number",
            );
            None
        }
    };
    expectation::expectations(case, &states, &probes, compare, faults)
}

/// The stored values of a baseline of a field that points have.
fn stored(
    context: &CheckedBeam,
    check: &Baseline,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<(f64, f64)>> {
    if !context.fields.contains(&check.field) {
        faults
            .error(path.key("field"), format!("`{}` is no field of all points of a beam", check.field.name()))
            .hint(words::there_are(context.fields));
        return None;
    }
    baseline::stored(context, check, path, faults)
}

fn closed_form(
    context: &CheckedBeam,
    check: &ClosedForm,
    path: &JsonPath,
    state: usize,
    faults: &mut Faults,
) -> Option<Solution> {
    let Some(reference) = reference::find(&check.name) else {
        faults
            .error(path.key("name"), format!("there is no closed form `{}`", check.name))
            .hint(suggest(&check.name, reference::TABLE.iter().map(|r| r.name)));
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
