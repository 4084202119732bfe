//! What holds for every model, every set of constraints and every beam.
#![allow(clippy::float_cmp)]

mod axial_bar;
mod beam_terms;
mod consistency;
mod constraints;
mod corpus;
mod entry;
mod hostile;
mod members;
mod mutate;
mod orthotropic_terms;
mod plane_terms;
mod random_beam;
mod random_beams;
mod shell_terms;
mod small_cases;
mod state_terms;

use proptest::test_runner::{Config, RngSeed};

/// A number of random cases, the same ones in every run.
fn cases(number: u32) -> Config {
    Config { cases: number, rng_seed: RngSeed::Fixed(20), failure_persistence: None, ..Config::default() }
}

/// As many random cases as `PROPTEST_CASES` says, new ones in every run; without it this number, always the same ones.
fn given_cases(number: u32) -> Config {
    match std::env::var_os("PROPTEST_CASES") {
        Some(_) => Config { failure_persistence: None, ..Config::default() },
        None => cases(number),
    }
}
