//! Every plane case of the gallery with the direct solver alone, and with multigrid: the same answers.

use crate::support::largest;
use peristat::Loaded;
use peristat::run::{RunOptions, StateResult, taking};
use peristat::scene::Scene;
use peristat::summary::Summary;
use std::fs;
use std::path::{Path, PathBuf};

fn cases() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("crates/driver");
    let folders = ["cases/plate", "cases/orthotropic"].map(|folder| root.join(folder));
    let entries = folders.into_iter().flat_map(|folder| fs::read_dir(folder).expect("a folder of plates"));
    let paths = entries.map(|e| e.expect("an entry").path());
    // Bodies that break keep a factor.
    let breaks = |p: &PathBuf| fs::read_to_string(p).expect("a case").contains("\"fracture\"");
    let is_plain = |p: &PathBuf| p.extension().is_some_and(|e| e == "json") && !breaks(p);
    let mut cases: Vec<PathBuf> = paths.filter(is_plain).collect();
    cases.sort();
    assert!(cases.len() > 15, "{cases:?}");
    cases
}

/// Displacements of all states and the record.
fn solve(case: &Path, solver: &str) -> (Vec<Vec<f64>>, Summary) {
    let loaded = Loaded::read(case, &[format!("solver={solver}")], None).unwrap_or_else(|e| panic!("{e}"));
    let options = RunOptions { recover: false, max_memory: None, compare: false };
    let mut all = Vec::new();
    let mut take = taking(|state| {
        if let StateResult::Body(result) = state {
            all.push(result.record.u);
        }
        Ok(())
    });
    let summary = loaded.run(&options, None, &mut take);
    drop(take);
    (all, summary.unwrap_or_else(|e| panic!("{e}")))
}

#[test]
fn every_plate_passes_with_the_direct_solver_and_multigrid_agrees() {
    let (mut cycles, mut worst) = (0, 0.0_f64);
    for case in cases() {
        let name = case.display();
        let (expected, summary) = solve(&case, "sparse");
        assert_eq!(summary.solver.method, "sparse_cholesky", "{name}");
        let failed: Vec<&str> =
            summary.checks.iter().filter(|c| !c.passed).map(|c| c.name.as_str()).collect();
        assert!(failed.is_empty(), "{name}: {failed:?}");
        let listed = Loaded::read(&case, &[], None).map(|l| match l.scene {
            Scene::Body(scene) => scene.outline().is_none(),
            Scene::Beam(_) | Scene::Plate(_) => panic!("{name} is no body in the plane"),
        });
        let solver = if listed.unwrap_or_else(|e| panic!("{e}")) { "pcg" } else { "multigrid" };
        let (found, other) = solve(&case, solver);
        cycles += usize::from(other.solver.method == "multigrid");
        for (a, b) in found.iter().zip(&expected) {
            let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
            let error = largest(&difference) / largest(b);
            worst = worst.max(error);
            assert!(error <= 1e-8, "{name}: {error} with {}", other.solver.method);
        }
    }
    assert!(cycles >= 7, "only {cycles} cases have coarser lattices");
}
