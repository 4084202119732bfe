//! The gallery is run, and the rules that no compiler checks are kept.
#![allow(clippy::unwrap_used, reason = "helpers of tests are tests")]

mod conventions;
mod coverage;
mod determinism;
mod gallery;
mod imports;
mod modules;
mod support;
mod tables;
