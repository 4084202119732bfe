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

/// What must become of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wish {
    /// A right answer, or a refusal.
    Honest,
    /// A right answer.
    Answer,
    /// A refusal by message.
    Refusal,
}

/// What the reactions must add up to: minus the loads that are asked for. Components that go through mirrors and joined
/// sides, or around the axis of a ring, are none.
#[derive(Clone, Debug)]
pub(crate) struct Resultant {
    /// Force that is asked for.
    pub(crate) force: [Option<f64>; 2],
    /// Its moment about the origin.
    pub(crate) moment: Option<f64>,
    /// Sum of the magnitudes of what is asked for, and the length over which moments are compared with it.
    pub(crate) size: f64,
    pub(crate) length: f64,
    /// Error that is allowed, over the size.
    pub(crate) bound: f64,
    /// Where the supports of the case hold the body, in their order.
    pub(crate) places: Vec<[f64; 2]>,
}

/// Error of a resultant that is none, over its size.
pub(crate) const BALANCED: f64 = 1e-10;

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
    /// What must become of it.
    pub(crate) wish: Wish,
    /// Another case, of the same probes, whose answers are the truth instead.
    pub(crate) twin: Option<Value>,
    /// What the reactions must balance.
    pub(crate) resultant: Option<Resultant>,
    /// Error that is known of the model and stands in the guide, beside what the certificate says: of displacements and forces.
    pub(crate) known: [f64; 2],
    /// Whether all files of the results are written, too.
    pub(crate) is_written: bool,
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
        Self {
            model,
            sweep,
            at,
            case,
            files: Vec::new(),
            truths: Vec::new(),
            wish: Wish::Honest,
            twin: None,
            resultant: None,
            known: [0.0; 2],
            is_written: false,
            cells,
        }
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
