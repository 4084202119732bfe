//! What the record of a run says of a state.

use super::beam::BeamForces;
use super::body::BodyForces;
use super::extremes::Extremes;
use super::plate_forces::PlateForces;
use crate::run::Certificate;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// One state without its fields. `F` is the kind of its forces where it is known, so that they are read as such.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StateSummary<F = Forces> {
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Extreme values by field.
    pub extremes: BTreeMap<Cow<'static, str>, Extremes>,
    /// Forces, of the body and of what holds it.
    #[serde(flatten)]
    pub forces: F,
    /// Certificate.
    pub certificate: Certificate,
}

/// Forces of a state.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Forces {
    /// Of a beam or frame.
    Beam(BeamForces),
    /// Of a body in the plane.
    Body(BodyForces),
    /// Of a plate in bending.
    Plate(PlateForces),
}
