//! What holds for every model and every set of constraints: tests of `peristat-assembly`, which need no other crate.
#![allow(clippy::float_cmp)]

mod beam_terms;
mod consistency;
mod constraints;
mod loose;
mod members;
mod orthotropic_terms;
mod plane_terms;
mod shell_terms;
mod smoothing;
mod state_terms;

use consistency::cases;
