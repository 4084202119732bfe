//! Tables of measurements: `bench/all.sh` finds each by the markers around it, and by them whether it is older than the code.

use super::support::root;
use std::fs;

/// Names and hashes of the tables of a document, and what is wrong with its markers.
fn tables(text: &str) -> Result<Vec<(&str, &str)>, String> {
    let (mut found, mut open) = (Vec::new(), None);
    for line in text.lines() {
        let Some(words) = line.strip_prefix("<!-- ").and_then(|l| l.strip_suffix(" -->")) else { continue };
        if let Some((name, hash)) = words.strip_prefix("table ").and_then(|w| w.split_once(": kernels ")) {
            if open.replace(name).is_some() {
                return Err(format!("table {name} begins in another one"));
            }
            found.push((name, hash));
        } else if let Some(name) = words.strip_prefix("end of ")
            && open.take() != Some(name)
        {
            return Err(format!("table {name} ends where it did not begin"));
        }
    }
    open.map_or(Ok(found), |name| Err(format!("table {name} has no end")))
}

#[test]
fn every_measured_table_can_be_found_and_dated() {
    let script = fs::read_to_string(root().join("bench/all.py")).unwrap();
    let mut count = 0;
    for document in ["bench/README.md", "bench/edges.md", "bench/defaults.md"] {
        let text = fs::read_to_string(root().join(document)).unwrap();
        for (name, hash) in tables(&text).unwrap_or_else(|fault| panic!("{document}: {fault}")) {
            assert!(
                script.contains(&format!("    \"{name}\": (")),
                "bench/all.py does not know table {name}"
            );
            let is_hash = hash.len() == 12 && hash.bytes().all(|b| b.is_ascii_hexdigit());
            assert!(is_hash || hash == "unknown", "{document}: `{hash}` is no hash of table {name}");
            count += 1;
        }
    }
    assert_eq!(count, script.matches("\": ([").count(), "one table per entry of bench/all.py");
}

#[test]
fn markers_that_do_not_match_are_faults() {
    let good = "<!-- table a: kernels unknown -->\n| x |\n<!-- end of a -->\n";
    assert_eq!(tables(good), Ok(vec![("a", "unknown")]));
    assert!(tables(&good.replace("end of a", "end of b")).is_err());
    assert!(tables(&good.replace("<!-- end of a -->\n", "")).is_err());
    assert!(tables(&good.replace("| x |", "<!-- table b: kernels unknown -->")).is_err());
}
