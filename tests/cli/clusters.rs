//! The scripts of `docs/examples` that run a study on many machines, on this one. `PERISTAT_PYTHON` names a Python that has
//! dask.

use super::support::{python_with, root, run};
use std::env;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A study of three small tasks, and what the paths of a shell have to be to find the command.
fn study(folder: &Path) -> std::ffi::OsString {
    fs::copy(root().join("cases/beam/cantilever.json"), folder.join("cantilever.json")).unwrap();
    let study = r#"{ "title": "Cantilever: order of the published law", "case": "cantilever.json",
        "set": { "body.line.cells": 12, "model.timoshenko_beam.bond_law": "published" },
        "refine": { "delta_convergence": { "factors": [1, 2, 4] } }, 
        "exact": [ { "quantity": "tip", "value": 0.00320624, "source": "F L^3/(3 EI) + F L/(kappa G A)" } ],
        "expect": [ { "quantity": "tip", "order": 2, "within": 0.5 } ] }"#;
    fs::write(folder.join("orders.json"), study).unwrap();
    let own = Path::new(env!("CARGO_BIN_EXE_peristat")).parent().unwrap().to_path_buf();
    let others = env::var_os("PATH").unwrap_or_default();
    env::join_paths([folder.to_path_buf(), own].into_iter().chain(env::split_paths(&others))).unwrap()
}

/// Asserts that a script succeeded and that all tasks of the study are done and collected.
fn collected(output: &Output, folder: &Path) {
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}\n{}", String::from_utf8_lossy(&output.stdout));
    assert_eq!(fs::read_dir(folder.join("out/tasks")).unwrap().count(), 3);
    assert!(folder.join("out/study.csv").exists(), "{errors}");
    let again = run(folder, &["study", "orders.json", "-o", "out", "--collect"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
}

#[test]
fn dask_runs_a_study() {
    let Some(python) = python_with("dask.distributed") else { return };
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    let script = root().join("docs/examples/dask_study.py");
    let path = study(folder);
    let output = Command::new(&python)
        .arg(script)
        .args(["orders.json", "-o", "out", "--workers", "2"])
        .current_dir(folder)
        .env("PATH", path)
        .output()
        .unwrap();
    collected(&output, folder);
}

/// Stands for the command of Slurm: runs what it is given at once.
const SBATCH: &str = r#"#!/bin/sh
for argument; do
    case $argument in --array=1-*) elements=${argument#--array=1-} ;; esac
    script=$argument
done
if [ -z "${elements:-}" ]; then exec "$script" >> slurm.log; fi
for element in $(seq "$elements"); do
    SLURM_ARRAY_TASK_ID=$element "$script" >> slurm.log || exit 1
done
echo 1
"#;

#[test]
fn slurm_runs_a_study() {
    for tasks_per_job in ["1", "2"] {
        let temporary = tempfile::tempdir().unwrap();
        let folder = temporary.path();
        let sbatch: PathBuf = folder.join("sbatch");
        fs::write(&sbatch, SBATCH).unwrap();
        fs::set_permissions(&sbatch, fs::Permissions::from_mode(0o755)).unwrap();
        let path = study(folder);
        let output = Command::new(root().join("docs/examples/slurm_array.sh"))
            .args(["orders.json", "out"])
            .current_dir(folder)
            .env("PATH", path)
            .env("TASKS_PER_JOB", tasks_per_job)
            .output()
            .unwrap();
        collected(&output, folder);
    }
}
