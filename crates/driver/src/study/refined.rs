//! Steps of a refinement, and the cases that they make of the base case: whole cells wherever the body needs them.

use super::file::Refine;
use crate::case::{Case, Check};
use crate::diagnostic::{JsonPath, tidy};
use serde_json::Value;

/// How far a factor may be above the one that is asked for, relative: beyond that the study would not be the one that was meant.
const NEAR: f64 = 0.25;
/// What differs by less is the same.
const SAME: f64 = 1e-9;

/// One step of a refinement, as a study asks for it.
#[derive(Clone, Debug, Default)]
pub(super) struct Step {
    /// Size that orders are of.
    size: f64,
    factor: Option<f64>,
    ratio: Option<f64>,
    /// Overrides that the study gives itself.
    given: Vec<String>,
}

/// One step, as the body allows it.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// Size that orders are of; none without a refinement.
    pub(super) size: Option<f64>,
    /// Overrides of the base case.
    pub(super) overrides: Vec<String>,
    /// What differs from what was asked for.
    pub(super) remarks: Vec<String>,
    /// The spacing of the base case over that of the level, where the study does not give it.
    pub(super) factor: Option<f64>,
}

impl Level {
    /// The only level of a series that is not refined.
    pub(super) fn alone(overrides: Vec<String>) -> Self {
        Self { size: None, overrides, remarks: Vec::new(), factor: None }
    }
}

/// Why a step has no case.
#[derive(Clone, Debug)]
pub(super) struct Unfit {
    pub(super) message: String,
    pub(super) hint: Option<String>,
}

impl From<String> for Unfit {
    fn from(message: String) -> Self {
        Self { message, hint: None }
    }
}

/// Steps of a refinement, coarse to fine.
pub(super) fn steps(refine: &Refine) -> Vec<Step> {
    let factor = |f: &f64| Step { size: f.recip(), factor: Some(*f), ..Step::default() };
    let ratio = |m: &f64| Step { size: m.recip(), ratio: Some(*m), ..Step::default() };
    match refine {
        Refine::DeltaConvergence(r) => r.factors.iter().map(factor).collect(),
        Refine::MConvergence(r) => r.ratios.iter().map(ratio).collect(),
        Refine::JointConvergence(r) => {
            let both = r.factors.iter().zip(&r.ratios);
            both.map(|(f, m)| Step { ratio: Some(*m), ..factor(f) }).collect()
        }
        Refine::Values(r) => {
            let given = |k: usize| {
                let of = |(path, values): (&String, &Value)| {
                    format!("{path}={}", values.get(k).unwrap_or(&Value::Null))
                };
                r.set.iter().map(of).collect()
            };
            let all = r.sizes.iter().enumerate();
            all.map(|(k, size)| Step { size: *size, given: given(k), ..Step::default() }).collect()
        }
    }
}

/// The levels of a refinement of a case, the horizon of which is `ratio` spacings.
///
/// # Errors
/// Per level why it has no case.
pub(super) fn levels(refine: &Refine, case: &Case, ratio: f64) -> Vec<Result<Level, Unfit>> {
    let mut coarser = None;
    let mut level = |step: &Step| {
        let level = step.fit(case, ratio)?;
        if let (Some(before), Some(own)) = (coarser, level.factor)
            && own <= before * (1.0 + SAME)
        {
            return Err(step.unfit("takes the spacing of the value before it", case, ratio));
        }
        coarser = level.factor;
        Ok(level)
    };
    steps(refine).iter().map(&mut level).collect()
}

impl Step {
    /// The factor of the spacing, if the horizon of the base case is `ratio` spacings.
    fn asked(&self, ratio: f64) -> Option<f64> {
        match (self.factor, self.ratio) {
            (factor, None) => factor,
            (factor, Some(own)) => Some(factor.unwrap_or(1.0) * own / ratio),
        }
    }

    /// The value that a factor of the spacing makes of the one that is asked for: a horizon ratio, or the factor itself.
    fn value(&self, factor: f64, ratio: f64) -> f64 {
        if self.ratio.is_some() { factor * ratio / self.factor.unwrap_or(1.0) } else { factor }
    }

    /// The value that is asked for, in words.
    fn words(&self) -> (&'static str, f64) {
        match (self.ratio, self.factor) {
            (Some(ratio), _) => ("horizon ratio", ratio),
            (None, factor) => ("factor", factor.unwrap_or(1.0)),
        }
    }

    /// The level with the next spacing, not above the one asked for, that leaves no part of a cell.
    fn fit(&self, case: &Case, ratio: f64) -> Result<Level, Unfit> {
        let Some(asked) = self.asked(ratio) else {
            return Ok(Level { size: Some(self.size), ..Level::alone(self.given.clone()) });
        };
        let whole = next(case, asked)?;
        let mut found = whole;
        while case.cracks_run_through_points(found) && found <= asked * (1.0 + NEAR) {
            found = next(case, found * (1.0 + 1e-6))?;
        }
        if found > asked * (1.0 + NEAR) {
            let is_whole = whole <= asked * (1.0 + NEAR);
            let wrong = if is_whole { "puts a crack on a row of points" } else { "leaves a part of a cell" };
            return Err(self.unfit(wrong, case, ratio));
        }
        let is_asked = (found - asked).abs() <= SAME * asked;
        let factor = if is_asked { asked } else { found };
        let value = if is_asked { self.words().1 } else { self.value(factor, ratio) };
        let mut overrides = match self.ratio {
            None => case.refined(factor)?,
            Some(_) => {
                let mut own = case.with_spacing_over(factor)?;
                own.push(match case.horizon {
                    Some(horizon) => (
                        JsonPath::default().key("horizon"),
                        Value::from(horizon / self.factor.unwrap_or(1.0)),
                    ),
                    None => (JsonPath::default().key("horizon_ratio"), Value::from(value)),
                });
                own
            }
        };
        let mut remarks = Vec::new();
        if !is_asked {
            let (what, wanted) = self.words();
            let why = match found > whole {
                true => "the body is whole cells, between whose points cracks run",
                false => "the body is whole cells",
            };
            remarks.push(format!(
                "{what} {} in place of {}: the next one at which {why}",
                short(value),
                tidy(wanted)
            ));
        }
        if case.checks.iter().any(|check| matches!(check, Check::Baseline(_))) {
            let others = case.checks.iter().filter(|check| !matches!(check, Check::Baseline(_)));
            let others = serde_json::to_value(others.collect::<Vec<_>>()).map_err(|e| e.to_string())?;
            overrides.push((JsonPath::default().key("checks"), others));
            remarks
                .push("checks against a `baseline` are left out: its points are those of one spacing".into());
        }
        // Horizons of a joint refinement are those that were asked for, whatever the spacing.
        let size =
            if self.factor.is_some() && self.ratio.is_some() || is_asked { self.size } else { value.recip() };
        let overrides = overrides.into_iter().map(|(path, value)| format!("{path}={value}")).collect();
        Ok(Level { size: Some(size), overrides, remarks, factor: Some(factor) })
    }

    /// That the value asked for does something wrong, and which ones fit.
    fn unfit(&self, wrong: &str, case: &Case, ratio: f64) -> Unfit {
        let (what, wanted) = self.words();
        let fitting = self.asked(ratio).and_then(|asked| case.fitting_factors(asked).ok());
        let fitting = fitting.into_iter().flatten().flatten();
        let values: Vec<String> = fitting.map(|factor| short(self.value(factor, ratio))).collect();
        let hint = match &values[..] {
            [one] => format!("the nearest {what} that fits is {one}"),
            all => format!("the nearest values that fit are {}", all.join(" and ")),
        };
        Unfit { message: format!("the {what} {} {wrong}", tidy(wanted)), hint: Some(hint) }
    }
}

/// The first factor not below one at which the body is whole cells.
fn next(case: &Case, factor: f64) -> Result<f64, Unfit> {
    // Where none fits, the body itself has a fault, which its case tells.
    Ok(case.fitting_factors(factor)?[0].filter(|found| found.is_finite()).unwrap_or(factor))
}

/// A number with the digits that a reader needs.
fn short(value: f64) -> String {
    tidy((value * 1e6).round() / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::from_text;
    use crate::study::MConvergence;

    fn of(set: &[&str], ratios: &[f64]) -> Vec<Result<Level, Unfit>> {
        let text = crate::model::start("bond_plane").unwrap();
        let set: Vec<String> = set.iter().map(ToString::to_string).collect();
        let case = from_text("case", text.into(), &set, &crate::input::Folder::default()).unwrap().case;
        levels(&Refine::MConvergence(MConvergence { ratios: ratios.into() }), &case, 3.0)
    }

    #[test]
    fn spacings_that_leave_parts_of_cells_give_way_to_the_next_finer_ones() {
        let set = ["body.rectangle={\"size\": [20, 8], \"spacing\": 1}", "checks=[]"];
        let levels: Vec<Level> = of(&set, &[2.0, 3.0, 4.0]).into_iter().map(Result::unwrap).collect();
        // 4 mm over 3, 4 and 6 are the spacings that divide both sides, next to 1.5, 1 and 0.75.
        for (level, number) in levels.iter().zip([3.0, 4.0, 6.0]) {
            assert!((level.factor.unwrap() - number / 4.0).abs() < 1e-12, "{level:?}");
            assert!((level.size.unwrap() - 4.0 / (3.0 * number)).abs() < 1e-12, "{level:?}");
        }
        let remarks: Vec<usize> = levels.iter().map(|level| level.remarks.len()).collect();
        assert_eq!(remarks, [1, 0, 1]);
    }

    #[test]
    fn cracks_keep_between_rows_of_points() {
        // Ratios are multiples of 0.15; with an odd number of rows the crack in the middle would be on one of them.
        let set = [
            "body.rectangle={\"size\": [20, 20], \"spacing\": 1}",
            "checks=[]",
            "cracks=[{\"path\": [[-1, 10], [5, 10]]}]",
        ];
        let levels: Vec<Level> = of(&set, &[2.1, 2.2, 3.0]).into_iter().map(Result::unwrap).collect();
        let cells: Vec<f64> = levels.iter().map(|level| 20.0 * level.factor.unwrap()).collect();
        assert!(cells.iter().zip([14.0, 16.0, 20.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{cells:?}");
        assert!(levels[1].remarks[0].ends_with("whole cells, between whose points cracks run"), "{levels:?}");
        assert!(levels[0].remarks.is_empty());
        // Three rows, with a spacing of 5 mm by default; four are too far off.
        let far = of(&[set[0], set[1], set[2], "body.rectangle.spacing=5"], &[2.25, 6.0]);
        assert_eq!(
            far[0].as_ref().unwrap_err().message,
            "the horizon ratio 2.25 puts a crack on a row of points"
        );
    }

    #[test]
    fn what_is_far_from_what_was_asked_for_is_refused_with_what_fits() {
        // Spacings are 20 mm over whole numbers: ratios are multiples of 0.15.
        let set = ["body.rectangle={\"size\": [20, 20], \"spacing\": 1}", "checks=[]"];
        let found = of(&set, &[0.3, 1.0, 1.04]);
        assert!(found[0].is_ok(), "{found:?}");
        let refused = found[2].as_ref().unwrap_err();
        assert!(refused.message.contains("1.04 takes the spacing of the value before it"), "{refused:?}");
        assert_eq!(refused.hint.as_deref(), Some("the nearest values that fit are 1.05 and 0.9"));
        let far = of(&["body.rectangle={\"size\": [40, 2], \"spacing\": 1}", "checks=[]"], &[2.0, 3.0]);
        let refused = far[0].as_ref().unwrap_err();
        assert_eq!(refused.message, "the horizon ratio 2 leaves a part of a cell");
        assert_eq!(refused.hint.as_deref(), Some("the nearest values that fit are 3 and 1.5"));
    }
}
