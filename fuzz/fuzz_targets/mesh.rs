//! Bytes of a file that a case names: a mesh of Gmsh, or a list of points.
#![no_main]

#[path = "../../tests/properties/entry.rs"]
#[allow(dead_code)]
mod entry;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    entry::reads(bytes);
});
