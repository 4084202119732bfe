//! The case that a run leaves in its folder says all that the run took.

use super::support::{json, run};
use serde_json::json;
use std::fs;

#[test]
fn laminae_that_start_at_other_bonds_run_again_from_their_results() {
    // Bonds lie on fibres at 0 degrees and none on those at 30: each takes its own start.
    for (base, other) in [(0, 30), (30, 0)] {
        let case = json!({
            "title": "laminae", "units": "mm-N-MPa",
            "model": { "beam_bond_orthotropic": {
                "youngs_modulus_1": 38600, "youngs_modulus_2": 8270, "poisson_ratio_12": 0.26,
                "shear_modulus_12": 4140, "fibre_angle": base
            } },
            "body": { "rectangle": { "size": [12, 8], "spacing": 1 } },
            "regions": { "part": { "box": { "from": [6, 0], "to": [12, 8] } } },
            "materials": { "other": { "at": "part", "fibre_angle": other } },
            "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 } ],
            "loads": [ { "traction": { "edge": "right", "uniform": [10, 1] } } ],
            "probes": [ { "name": "u", "at": { "x": 11.5, "y": 7.5 }, "field": "ux" } ]
        });
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("first.json"), case.to_string()).unwrap();
        let value = |file: &str, out: &str| {
            let ended = run(folder.path(), &["run", file, "-o", out]);
            assert_eq!(ended.code, 0, "{}", ended.stderr);
            json(&folder.path().join(out).join("summary.json"))["probes"][0]["value"].clone()
        };
        let first = value("first.json", "first");
        fs::copy(folder.path().join("first/case.json"), folder.path().join("second.json")).unwrap();
        assert_eq!(value("second.json", "second"), first);
    }
}
