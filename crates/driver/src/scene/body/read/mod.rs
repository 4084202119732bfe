//! What is read of results.

pub(crate) mod checks;
pub(crate) mod edge_mean;
pub(crate) mod fields;
pub(crate) mod front;
pub(crate) mod intensities;
pub(crate) mod jump;
pub(crate) mod opening;
pub(crate) mod outputs;
pub(crate) mod probes;
pub(crate) mod reduced;
pub(crate) mod strengths;
