//! Bytes of a solid that a case names: an STL file, or tetrahedra of Gmsh.
#![no_main]

#[path = "../../tests/properties/entry.rs"]
#[allow(dead_code)]
mod entry;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    entry::fills(bytes);
});
