//! What the records of a study say together: errors, orders and limits of every quantity of every series.

use super::file::{Refine, Study};
use super::order::{self, Fit, Limit};
use super::plan::{Plan, Task};
use super::record::{Measured, Record};
use super::settings::includes;
use serde::Serialize;
use serde_json::{Map, Value};

/// One discretisation of a series.
#[derive(Clone, Debug, Serialize)]
pub struct Level {
    /// Number of the task.
    pub task: usize,
    /// Size that orders are of; none without a refinement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<f64>,
    /// What the task found.
    #[serde(flatten)]
    pub record: Record,
}

/// A quantity over the levels of a series.
#[derive(Clone, Debug, Serialize)]
pub struct Quantity {
    /// Name.
    pub name: String,
    /// Unit of its values; empty if it has none.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub unit: String,
    /// Values, of probes and energies.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub values: Vec<f64>,
    /// Exact value, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<f64>,
    /// Errors against the exact value or, where it is not known, the extrapolated one, relative to it or, where it is zero, to
    /// the largest value of the series; none without either.
    pub errors: Vec<f64>,
    /// Orders from level to level.
    pub orders: Vec<Option<f64>>,
    /// Order by least squares.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<Fit>,
    /// Limit of the values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<Limit>,
    /// Relative error of the extrapolated value, where the exact one is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extrapolated_error: Option<f64>,
}

/// The levels of a refinement, all else being the same.
#[derive(Clone, Debug, Serialize)]
pub struct Series {
    /// Values that are varied, by their paths.
    pub settings: Map<String, Value>,
    /// Levels that are solved, coarse to fine.
    pub levels: Vec<Level>,
    /// Quantities.
    pub quantities: Vec<Quantity>,
}

impl Series {
    /// The settings in words.
    pub fn title(&self) -> String {
        let short = |path: &String| path.rsplit('.').next().unwrap_or(path).to_string();
        let all = self.settings.iter().map(|(path, value)| format!("{} {}", short(path), words(value)));
        all.collect::<Vec<_>>().join(", ")
    }

    fn new(study: &Study, tasks: &[Task], records: &[Option<Record>]) -> Self {
        let level = |task: &Task| {
            let record = records[task.number - 1].clone()?;
            Some(Level { task: task.number, size: task.size, record })
        };
        let levels: Vec<Level> = tasks.iter().filter_map(level).collect();
        let settings = tasks[0].settings.clone();
        let quantities = quantities(study, &settings, &levels);
        Self { settings, levels, quantities }
    }
}

/// A value without the marks of JSON.
fn words(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Object(keys) => {
            keys.iter().map(|(key, value)| format!("{key} {}", words(value))).collect::<Vec<_>>().join(" ")
        }
        other => other.to_string(),
    }
}

/// Every quantity that all levels have.
fn quantities(study: &Study, settings: &Map<String, Value>, levels: &[Level]) -> Vec<Quantity> {
    let Some(first) = levels.first() else { return Vec::new() };
    // What jumps, as bodies that break or soften do, has no order.
    let steady = levels.iter().filter(|level| !level.record.traced);
    let sizes: Vec<f64> = steady.filter_map(|level| level.size).collect();
    let column = |name: &str, of: fn(&Record) -> &Vec<Measured>| -> Option<Vec<f64>> {
        levels.iter().map(|l| of(&l.record).iter().find(|m| m.name == name).map(|m| m.value)).collect()
    };
    let errors = first.record.errors.iter().filter_map(|m| {
        let errors = column(&m.name, |record| &record.errors)?;
        Some(Quantity::new(m, &sizes, Vec::new(), None, errors))
    });
    let values = first.record.values.iter().filter_map(|m| {
        let values = column(&m.name, |record| &record.values)?;
        let exact = study.exact.iter().find(|e| e.quantity == m.name && includes(settings, &e.r#where));
        Some(Quantity::of_values(m, &sizes, values, exact.map(|e| e.value)))
    });
    errors.chain(values).collect()
}

impl Quantity {
    fn new(of: &Measured, sizes: &[f64], values: Vec<f64>, exact: Option<f64>, errors: Vec<f64>) -> Self {
        let refined = sizes.len() == errors.len();
        Self {
            name: of.name.clone(),
            unit: of.unit.clone(),
            values,
            exact,
            orders: if refined { order::between(sizes, &errors) } else { Vec::new() },
            fit: if refined { order::fit(sizes, &errors) } else { None },
            errors,
            limit: None,
            extrapolated_error: None,
        }
    }

    fn of_values(of: &Measured, sizes: &[f64], values: Vec<f64>, exact: Option<f64>) -> Self {
        let limit = (sizes.len() == values.len()).then(|| order::limit(sizes, &values));
        let reference = exact.or(limit.as_ref().and_then(Limit::value));
        let largest = values.iter().fold(0.0, |a: f64, v| a.max(v.abs()));
        let error = |value: f64, reference: f64| {
            let scale = if reference == 0.0 { largest } else { reference.abs() };
            if value == reference { 0.0 } else { (value - reference).abs() / scale }
        };
        let errors = reference.map_or(Vec::new(), |r| values.iter().map(|v| error(*v, r)).collect());
        let mut quantity = Self::new(of, sizes, values, exact, errors);
        if exact.is_none() {
            // Differences from a value that was extrapolated from them tell nothing about the last of them.
            quantity.fit = None;
            quantity.orders = orders_of_values(sizes, &quantity.values);
        }
        quantity.extrapolated_error =
            exact.zip(limit.as_ref().and_then(Limit::value)).map(|(e, v)| error(v, e));
        quantity.limit = limit;
        quantity
    }

    /// Whether its errors are against something known.
    pub fn is_known(&self) -> bool {
        self.exact.is_some() || self.values.is_empty()
    }

    /// Order over the last refinement.
    pub fn last_order(&self) -> Option<f64> {
        *self.orders.last()?
    }
}

/// Orders of every three successive values; the first two levels have none.
fn orders_of_values(sizes: &[f64], values: &[f64]) -> Vec<Option<f64>> {
    if sizes.len() != values.len() || values.len() < 2 {
        return Vec::new();
    }
    let three = |k: usize| {
        let finest = values[k + 2].abs();
        let settled = (values[k + 1] - values[k + 2]).abs() <= order::ROUNDING * finest;
        let h = [sizes[k], sizes[k + 1], sizes[k + 2]];
        let q = [values[k], values[k + 1], values[k + 2]];
        if settled { None } else { order::of_three(h, q).ok() }
    };
    std::iter::once(None).chain((0..values.len() - 2).map(three)).collect()
}

/// Whether an expectation of the study is met.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// What was expected.
    pub expected: String,
    /// What was found.
    pub found: String,
    /// Whether it is met.
    pub passed: bool,
}

/// Everything a study found.
#[derive(Clone, Debug, Serialize)]
pub struct Findings {
    /// Title of the study.
    pub title: String,
    /// What the sizes of its levels are, which orders are of: `horizon`, `spacing` or `size`.
    pub size: &'static str,
    /// Number of tasks.
    pub tasks: usize,
    /// What differs from what the study asks for, each once.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
    /// Numbers of the tasks that have no result.
    pub missing: Vec<usize>,
    /// Numbers of the tasks with a state that did not converge.
    pub not_converged: Vec<usize>,
    /// Series.
    pub series: Vec<Series>,
    /// Expectations.
    pub expectations: Vec<Outcome>,
    /// Version of peristat.
    pub version: &'static str,
}

impl Findings {
    /// What the records of the tasks of a plan, in their order, say together.
    pub fn new(plan: &Plan, records: &[Option<Record>]) -> Self {
        let series: Vec<Series> =
            plan.series().map(|tasks| Series::new(&plan.study, tasks, records)).collect();
        let numbers = |is: &dyn Fn(&Option<Record>) -> bool| -> Vec<usize> {
            (1..).zip(records).filter(|(_, record)| is(record)).map(|(number, _)| number).collect()
        };
        Self {
            title: plan.study.title.clone(),
            size: match plan.study.refine {
                Some(Refine::MConvergence(_)) => "spacing",
                Some(Refine::Values(_)) => "size",
                Some(Refine::DeltaConvergence(_) | Refine::JointConvergence(_)) | None => "horizon",
            },
            tasks: plan.tasks.len(),
            remarks: plan.remarks(),
            missing: numbers(&|record| record.is_none()),
            not_converged: numbers(&|record| record.as_ref().is_some_and(|r| !r.converged)),
            expectations: super::expect::outcomes(&plan.study, &series),
            series,
            version: env!("CARGO_PKG_VERSION"),
        }
    }

    /// Whether every task has a converged result and every expectation is met.
    pub fn passed(&self) -> bool {
        self.missing.is_empty()
            && self.not_converged.is_empty()
            && self.expectations.iter().all(|outcome| outcome.passed)
    }
}
