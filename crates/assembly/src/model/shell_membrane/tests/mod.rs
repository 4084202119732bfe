//! Shell membranes against closed forms and against an independent Python implementation.

mod bending;
mod ends;
mod patch;
mod published_case;
mod solvability;
mod spectrum;
mod tubes;
mod waves;
