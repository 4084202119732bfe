//! What holds for every model, every set of constraints and every beam.
#![allow(clippy::float_cmp)]

mod axial_bar;
mod beam_terms;
mod consistency;
mod constraints;
mod members;
mod orthotropic_terms;
mod plane_terms;
mod random_beam;
mod random_beams;
mod shell_terms;
mod state_terms;

use proptest::test_runner::{Config, RngSeed};

/// A number of random cases, the same ones in every run.
fn cases(number: u32) -> Config {
    Config { cases: number, rng_seed: RngSeed::Fixed(20), failure_persistence: None, ..Config::default() }
}
