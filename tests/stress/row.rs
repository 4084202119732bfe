//! A row of the suite: a case, and what its probes must find.

use serde_json::{Value, json};

/// A quantity whose errors are relative to the largest of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Displacements, and rotations times a length.
    Displacement,
    /// Forces, moments over a length, stresses.
    Force,
}

/// What a probe must find.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    pub(crate) kind: Kind,
    /// What one of it counts: a length for rotations.
    pub(crate) unit: f64,
    pub(crate) expected: f64,
}

/// A case with its truth.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) model: &'static str,
    /// What is taken to its extremes.
    pub(crate) sweep: &'static str,
    /// Where on the way it is.
    pub(crate) at: String,
    pub(crate) case: Value,
    /// Names and texts of the files beside it.
    pub(crate) files: Vec<(&'static str, String)>,
    /// Probes of the case, in their order.
    pub(crate) truths: Vec<Truth>,
    /// Size of the body.
    pub(crate) cells: usize,
}

impl Row {
    pub(crate) fn new(
        model: &'static str,
        sweep: &'static str,
        at: String,
        case: Value,
        cells: usize,
    ) -> Self {
        let mut case = case;
        case["title"] = json!("stress");
        case["probes"] = json!([]);
        Self { model, sweep, at, case, files: Vec::new(), truths: Vec::new(), cells }
    }

    /// Adds a probe and what it must find.
    pub(crate) fn expect(mut self, at: Value, field: &str, kind: Kind, unit: f64, expected: f64) -> Self {
        let name = format!("p{}", self.truths.len());
        let probes = self.case["probes"].as_array_mut().expect("a list");
        probes.push(json!({ "name": name, "at": at, "field": field }));
        self.truths.push(Truth { kind, unit, expected });
        self
    }

    /// Adds displacements of a point in the plane.
    pub(crate) fn moved(self, at: [f64; 2], u: [f64; 2]) -> Self {
        let place = json!({ "x": at[0], "y": at[1] });
        self.expect(place.clone(), "ux", Kind::Displacement, 1.0, u[0]).expect(
            place,
            "uy",
            Kind::Displacement,
            1.0,
            u[1],
        )
    }

    pub(crate) fn name(&self) -> String {
        format!("{}, {}, {}", self.model, self.sweep, self.at)
    }
}

/// Powers of ten from one to another.
pub(crate) fn decades(from: i32, to: i32, step: usize) -> impl Iterator<Item = f64> {
    (from..=to).step_by(step).map(|k| 10_f64.powi(k))
}
