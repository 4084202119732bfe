//! The same case gives the same bytes.

use crate::support::{files, root, short, solve};
use peristat::summary::Summary;

fn text(mut summary: Summary) -> String {
    summary.timing_s = Default::default();
    summary.peak_memory_bytes = None;
    serde_json::to_string_pretty(&summary).unwrap()
}

#[test]
fn a_summary_is_the_same_to_the_byte_but_for_times_and_memory() {
    let folders = ["cases/beam", "cases/frame", "cases/plate", "cases/orthotropic", "cases/shell"];
    for case in folders.iter().flat_map(|folder| files(&root().join(folder), ".json")) {
        assert!(text(solve(&case)) == text(solve(&case)), "{} differs from run to run", short(&case));
    }
}
