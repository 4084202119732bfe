//! The command `peristat` as a user meets it: exit codes, messages, files.
#![allow(clippy::unwrap_used, reason = "helpers of tests are tests")]

mod book;
mod browser;
mod clusters;
mod commands;
mod completions;
mod disk;
mod faults;
mod field_files;
mod fracture;
mod hostile_input;
mod interrupted;
mod language_server;
mod limits;
mod links;
mod manual;
mod memory;
mod meshio;
mod messages;
mod model_tables;
mod numbers;
mod outside;
mod pictures;
mod plane_folder;
mod readme;
mod report;
mod report_states;
mod results_folder;
mod schema;
mod solid_report;
mod study;
mod support;
mod tidy;
mod together;
mod verify;
mod viewer;
