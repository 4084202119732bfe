//! Bytes of a case, up to the scene that would be solved.
#![no_main]

#[path = "../../tests/properties/entry.rs"]
#[allow(dead_code)]
mod entry;
#[path = "../../tests/properties/mutate.rs"]
mod mutate;

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use mutate::{Random, mutate};
use serde_json::Value;

fuzz_target!(|bytes: &[u8]| {
    entry::resolves(bytes.to_vec());
});

// Most changes of single bytes leave no JSON: every other change is one of values.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let parsed = (seed % 2 == 0).then(|| serde_json::from_slice::<Value>(&data[..size]).ok());
    let Some(Some(mut value)) = parsed else { return fuzzer_mutate(data, size, max_size) };
    let (donor, mut random) = (value.clone(), Random(u64::from(seed)));
    for _ in 0..=random.below(3) {
        mutate(&mut value, &donor, &mut random);
    }
    let text = value.to_string();
    if text.len() > max_size.min(data.len()) {
        return fuzzer_mutate(data, size, max_size);
    }
    data[..text.len()].copy_from_slice(text.as_bytes());
    text.len()
});
