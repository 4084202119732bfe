//! `--open`: the report in a viewer, which may not be there.
#![cfg(target_os = "linux")]

use super::support::{gallery, peristat, root};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

/// Runs the command where only these programs can be found: exit code, and what it said.
fn open(folder: &Path, arguments: &[&str], programs: &Path) -> (Option<i32>, String) {
    let output = peristat(folder).args(arguments).env("PATH", programs).output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn a_report_is_shown_and_a_missing_viewer_is_no_fault() {
    let folder = tempfile::tempdir().unwrap();
    let (programs, shown) = (folder.path().join("bin"), folder.path().join("shown"));
    fs::create_dir(&programs).unwrap();
    let case = gallery("cantilever.json");
    let run = ["run", &case, "-q", "-o", "out", "--force", "--open"];
    let (code, told) = open(folder.path(), &run, &programs);
    assert_eq!(code, Some(0));
    assert!(told.starts_with("notice: out/report.html cannot be shown: "), "{told}");

    let viewer = programs.join("xdg-open");
    fs::write(&viewer, format!("#!/bin/sh\necho \"$1\" >> {}\n", shown.display())).unwrap();
    fs::set_permissions(&viewer, fs::Permissions::from_mode(0o755)).unwrap();
    let study = root().join("cases/beam_orders.study.json").display().to_string();
    let study = ["study", &study, "-q", "-o", "many", "--open"];
    for (arguments, report) in [(&run[..], "out/report.html"), (&study, "many/report.html")] {
        assert_eq!(open(folder.path(), arguments, &programs), (Some(0), String::new()));
        let text = || fs::read_to_string(&shown).unwrap_or_default();
        // It runs on its own.
        (0..500).take_while(|_| !text().contains(report)).for_each(|_| sleep(Duration::from_millis(10)));
        assert!(text().lines().any(|line| line == report), "{}", text());
    }
}
