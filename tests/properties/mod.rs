//! What holds for every beam that is run, and for a model that the program does not ship.
#![allow(clippy::float_cmp)]

mod axial_bar;
mod consistency;
mod corpus;
mod entry;
mod every_model;
mod extremes;
mod hostile;
mod loose;
mod mutate;
mod random_beam;
mod random_beams;
mod small_cases;
mod smoothing;

use consistency::cases;
use proptest::test_runner::Config;

/// As many random cases as `PROPTEST_CASES` says, new ones in every run; without it this number, always the same ones.
fn given_cases(number: u32) -> Config {
    match std::env::var_os("PROPTEST_CASES") {
        Some(_) => Config { failure_persistence: None, ..Config::default() },
        None => cases(number),
    }
}
