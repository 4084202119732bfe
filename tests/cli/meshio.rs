//! Another program reads the fields. `PERISTAT_PYTHON` names a Python that has meshio.

use super::support::{gallery, python_with, run};
use std::process::Command;

/// Prints the sizes of a mesh and some of its values, a number per line.
const READ: &str = r#"
import sys, meshio
mesh = meshio.read(sys.argv[1])
w = mesh.point_data["w"]
print(len(mesh.points))
print(sum(len(block.data) for block in mesh.cells if block.type == "line"))
print(repr(float(mesh.points[-1][0])))
print(repr(float(w.ravel()[-1])))
print(repr(float(mesh.point_data["displacement"][-1][1])))
print(" ".join(sorted(mesh.point_data)))
"#;

#[test]
fn meshio_reads_the_fields() {
    let Some(python) = python_with("meshio") else { return };
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["run", &gallery("rigid_link.json"), "-o", "out", "--json"]);
    let summary: serde_json::Value = serde_json::from_str(&outcome.stdout).unwrap();
    let output = Command::new(&python)
        .args(["-c", READ, "out/fields/step_000.vtu"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    // Lines of 40 and 25 cells; the link is no cell.
    assert_eq!(lines[..3], ["67", "65", "2.5"]);
    let tip = summary["probes"][0]["value"].as_f64().unwrap();
    assert_eq!([lines[3], lines[4]].map(|v| v.parse::<f64>().unwrap()), [tip, tip]);
    assert_eq!(lines[5], "M V displacement energy_density phi stress_bottom stress_top w");
}
