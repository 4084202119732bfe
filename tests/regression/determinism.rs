//! The same case gives the same bytes, on any number of threads.

use super::support::{files, load, root, short, solve};
use peristat::summary::Summary;
use std::path::Path;

/// Cases that take as long as all the others together, and are solved like some of those.
const LONG: [&str; 11] = [
    "cases/axisymmetric/ring_crack.json",
    "cases/ductile/ct_2024_damage.json",
    "cases/ductile/ct_elastic_045.json",
    "cases/ductile/ct_elastic_055.json",
    "cases/ductile/notched_strip.json",
    "cases/ductile/panel.json",
    "cases/orthotropic/case_b_0.json",
    "cases/orthotropic/case_b_30_turned.json",
    "cases/orthotropic/case_b_45.json",
    "cases/orthotropic/case_b_90.json",
    "cases/plate/plate_with_hole_off_lines.json",
];

/// The record of a run on so many threads, but for times and memory.
fn text(threads: usize, case: &Path) -> String {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let mut summary: Summary = pool.install(|| solve(case));
    summary.timing_s = Default::default();
    summary.peak_memory_bytes = None;
    serde_json::to_string_pretty(&summary).unwrap()
}

/// Whatever is summed or found by threads side by side, not a bit may depend on how many there are: a body that softens
/// takes another path for less.
fn same_to_the_byte(folder: &str) {
    let mut cases = files(&root().join("cases").join(folder), ".json");
    cases.retain(|case| !LONG.contains(&&*short(case)) && !load(case).scene.case().slow);
    assert!(!cases.is_empty(), "cases/{folder} has no cases");
    for case in cases {
        let (one, two) = (text(1, &case), text(2, &case));
        let differing = one.lines().zip(two.lines()).find(|(a, b)| a != b);
        assert!(one == two, "{} differs from run to run: {differing:?}", short(&case));
    }
}

#[test]
fn beams_and_frames_are_the_same_to_the_byte() {
    ["beam", "frame"].into_iter().for_each(same_to_the_byte);
}

#[test]
fn plates_and_shells_are_the_same_to_the_byte() {
    ["plate", "shell", "axisymmetric"].into_iter().for_each(same_to_the_byte);
}

#[test]
fn orthotropic_plates_are_the_same_to_the_byte() {
    same_to_the_byte("orthotropic");
}

#[test]
fn crack_specimens_are_the_same_to_the_byte() {
    same_to_the_byte("ductile");
}

#[test]
fn the_long_ones_are_there() {
    assert!(LONG.iter().all(|case| root().join(case).exists()));
}
