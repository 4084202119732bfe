//! The command `peristat` as a user meets it: exit codes, messages, files.
#![allow(clippy::unwrap_used, reason = "helpers of tests are tests")]

mod commands;
mod fracture;
mod hostile_input;
mod memory;
mod meshio;
mod messages;
mod numbers;
mod plane_folder;
mod readme;
mod results_folder;
mod schema;
mod support;
mod verify;
