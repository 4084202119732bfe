//! What lies outside: files that a case names, and places that links in a results folder lead to.

use super::support::{files, json, names, root, run};
use std::fs;
use std::path::{Path, PathBuf};

const OUT: &str = "lies outside the folder of the case";

/// A folder with a case of the gallery in `case`, its file beside that folder, and the case naming it there.
fn apart(folder: &Path, kind: &str, case: &str, file: &str) {
    let gallery = root().join("cases").join(kind);
    fs::create_dir(folder.join("case")).unwrap();
    fs::copy(gallery.join(file), folder.join(file)).unwrap();
    let text = fs::read_to_string(gallery.join(case)).unwrap();
    let moved = text.replace(&format!("\"{file}\""), &format!("\"../{file}\""));
    assert_ne!(text, moved);
    fs::write(folder.join("case").join(case), moved).unwrap();
}

#[test]
fn files_outside_are_read_only_where_that_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    apart(folder.path(), "beam", "baseline.json", "baseline.csv");
    fs::write(
        folder.path().join("case/baseline.study.json"),
        r#"{ "title": "t", "case": "baseline.json", "refine": { "values": { "sizes": [2, 1], "set": { "title": ["a", "b"] } } } }"#,
    )
    .unwrap();
    let commands: [&[&str]; 4] = [
        &["run", "case/baseline.json", "-o", "out"],
        &["check", "case/baseline.json"],
        &["verify", "case/baseline.json"],
        &["study", "case/baseline.study.json", "-o", "studied"],
    ];
    for command in commands {
        let refused = run(folder.path(), command);
        assert_eq!(refused.code, 2, "{command:?}: {}", refused.stderr);
        assert!(refused.stderr.contains(OUT), "{command:?}: {}", refused.stderr);
        assert!(refused.stderr.contains("`--allow-outside`"), "{command:?}: {}", refused.stderr);
        assert!(command[0] != "run" || !folder.path().join("out").exists());
        let allowed = run(folder.path(), &[command, &["--allow-outside"]].concat());
        assert_eq!(allowed.code, 0, "{command:?}: {}", allowed.stderr);
    }
}

#[test]
fn a_library_lies_where_files_of_the_case_do_and_results_keep_it() {
    let folder = tempfile::tempdir().unwrap();
    apart(folder.path(), "frame", "library.json", "office.jsonc");
    let refused = run(folder.path(), &["run", "case/library.json", "-o", "out"]);
    assert_eq!(refused.code, 2);
    let message = format!("error: the library ../office.jsonc {OUT}\n");
    assert!(refused.stderr.starts_with(&message), "{}", refused.stderr);
    let allowed = run(folder.path(), &["run", "case/library.json", "-o", "out", "--allow-outside"]);
    assert_eq!(allowed.code, 0, "{}", allowed.stderr);
    let again = run(folder.path(), &["run", "out/case.json", "-o", "again"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    let fields = |of: &str| fs::read(folder.path().join(of).join("fields/step_000.csv")).unwrap();
    assert_eq!(fields("again"), fields("out"));
}

#[test]
fn the_case_of_a_study_lies_in_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("inner")).unwrap();
    fs::copy(root().join("cases/beam/cantilever.json"), folder.path().join("beam.json")).unwrap();
    let study = r#"{ "title": "t", "case": "../beam.json", "refine": { "delta_convergence": { "factors": [1, 2] } } }"#;
    fs::write(folder.path().join("inner/t.study.json"), study).unwrap();
    let refused = run(folder.path(), &["study", "inner/t.study.json", "-o", "out"]);
    assert_eq!(refused.code, 2);
    let message = format!("error: the case ../beam.json {OUT}\n  --> inner/t.study.json:1:25, at `case`");
    assert!(refused.stderr.starts_with(&message), "{}", refused.stderr);
    assert!(!folder.path().join("out").exists());
    let allowed = run(folder.path(), &["study", "inner/t.study.json", "-o", "out", "--allow-outside"]);
    assert_eq!(allowed.code, 0, "{}", allowed.stderr);
}

#[test]
fn results_hold_all_that_their_case_names_and_run_again_wherever_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    apart(folder.path(), "plate", "scattered_points.json", "scattered.csv");
    let first = run(folder.path(), &["run", "case/scattered_points.json", "-o", "out", "--allow-outside"]);
    assert_eq!(first.code, 0, "{}", first.stderr);
    assert_eq!(names(&path("out/inputs")), ["scattered.csv"]);
    assert_eq!(json(&path("out/case.json"))["body"]["points"]["file"], "inputs/scattered.csv");
    let fields = |of: &str| fs::read(path(of).join("fields/step_000.csv")).unwrap();
    let before = fields("out");
    fs::create_dir(path("elsewhere")).unwrap();
    fs::rename(path("out"), path("elsewhere/moved")).unwrap();
    fs::remove_file(path("scattered.csv")).unwrap();
    let again = run(folder.path(), &["run", "elsewhere/moved/case.json", "-o", "again"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    assert_eq!(fields("again"), before);
    assert_eq!(
        fs::read(path("again/case.json")).unwrap(),
        fs::read(path("elsewhere/moved/case.json")).unwrap()
    );
    // Into its own folder, whose files are removed on the way.
    assert_eq!(run(folder.path(), &["run", "again/case.json", "-o", "again", "--force"]).code, 0);
    assert_eq!(fields("again"), before);
    // A file of the user among those of the case is not lost.
    fs::write(path("again/inputs/mine.csv"), "mine").unwrap();
    let kept = run(folder.path(), &["run", "again/case.json", "-o", "again"]);
    assert_eq!(kept.code, 2);
    assert!(kept.stderr.contains("again holds `inputs/mine.csv`"), "{}", kept.stderr);
}

#[cfg(unix)]
mod links {
    use super::*;
    use peristat::results::MARK;
    use std::os::unix::fs::symlink;

    fn beam(folder: &Path) -> String {
        fs::copy(root().join("cases/beam/load_cases.json"), folder.join("beam.json")).unwrap();
        "beam.json".into()
    }

    /// A folder `aside` with a file and a folder, and what they hold.
    fn aside(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        fs::create_dir_all(folder.join("aside/folder")).unwrap();
        fs::write(folder.join("aside/file"), "untouched").unwrap();
        held(folder)
    }

    fn held(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        files(&folder.join("aside"), "").into_iter().map(|f| (f.clone(), fs::read(f).unwrap())).collect()
    }

    #[test]
    fn a_link_that_leads_out_is_outside() {
        let folder = tempfile::tempdir().unwrap();
        apart(folder.path(), "beam", "baseline.json", "baseline.csv");
        let case = folder.path().join("case");
        symlink("../baseline.csv", case.join("linked.csv")).unwrap();
        let text = fs::read_to_string(case.join("baseline.json")).unwrap();
        fs::write(case.join("baseline.json"), text.replace("../baseline.csv", "linked.csv")).unwrap();
        let refused = run(folder.path(), &["check", "case/baseline.json"]);
        assert_eq!(refused.code, 2);
        let message = "error: the baseline linked.csv is a link that leads out of the folder of the case\n";
        assert!(refused.stderr.starts_with(message), "{}", refused.stderr);
        assert_eq!(run(folder.path(), &["check", "case/baseline.json", "--allow-outside"]).code, 0);
    }

    #[test]
    fn nothing_is_written_through_links_in_a_results_folder() {
        let folder = tempfile::tempdir().unwrap();
        let case = beam(folder.path());
        let before = aside(folder.path());
        assert_eq!(run(folder.path(), &["run", &case, "-o", "out"]).code, 0);
        let out = folder.path().join("out");
        let own = names(&out);
        assert!(own.len() > 6, "{own:?}");
        for name in own.iter().map(String::as_str).chain(["inputs", "curve.csv"]) {
            let (path, is_folder) = (out.join(name), out.join(name).is_dir() || name == "inputs");
            let remove = if is_folder { fs::remove_dir_all } else { fs::remove_file };
            let _ = remove(path.clone());
            symlink(if is_folder { "../aside/folder" } else { "../aside/file" }, &path).unwrap();
            let outcome = run(folder.path(), &["run", &case, "-o", "out", "--force"]);
            assert_eq!(held(folder.path()), before, "{name}");
            if name == MARK {
                // It is locked, and never replaced.
                assert_eq!(outcome.code, 2, "{}", outcome.stderr);
                let said = "error: cannot write out: `.peristat` is a link";
                assert!(outcome.stderr.starts_with(said), "{}", outcome.stderr);
                fs::remove_file(&path).unwrap();
            } else {
                assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
                assert!(!path.is_symlink(), "{name}");
            }
        }
    }

    #[test]
    fn nothing_is_written_through_links_in_the_folder_of_a_study() {
        let folder = tempfile::tempdir().unwrap();
        let case = beam(folder.path());
        let before = aside(folder.path());
        let study = format!(
            r#"{{ "title": "t", "case": "{case}", "refine": {{ "delta_convergence": {{ "factors": [1, 2] }} }} }}"#
        );
        fs::write(folder.path().join("t.study.json"), study).unwrap();
        let arguments = ["study", "t.study.json", "-o", "out"];
        assert_eq!(run(folder.path(), &arguments).code, 0);
        let out = folder.path().join("out");
        for name in names(&out) {
            let (path, is_folder) = (out.join(&name), out.join(&name).is_dir());
            if is_folder {
                fs::remove_dir_all(&path).unwrap()
            } else {
                fs::remove_file(&path).unwrap()
            }
            symlink(if is_folder { "../aside/folder" } else { "../aside/file" }, &path).unwrap();
            let outcome = run(folder.path(), &arguments);
            assert_eq!(held(folder.path()), before, "{name}");
            if is_folder || name == MARK {
                assert_eq!(outcome.code, 2, "{name}: {}", outcome.stderr);
                assert!(outcome.stderr.contains("is a link"), "{name}: {}", outcome.stderr);
                fs::remove_file(&path).unwrap();
                assert_eq!(run(folder.path(), &[&arguments[..], &["--force"]].concat()).code, 0);
            } else {
                assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
                assert!(!path.is_symlink(), "{name}");
            }
        }
    }

    #[test]
    fn a_results_folder_is_a_link_only_where_it_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let case = beam(folder.path());
        let before = aside(folder.path());
        symlink("aside/folder", folder.path().join("results")).unwrap();
        let refused = run(folder.path(), &["run", &case]);
        assert_eq!(refused.code, 2);
        assert!(refused.stderr.starts_with("error: results is a link, "), "{}", refused.stderr);
        fs::create_dir(folder.path().join("verified")).unwrap();
        symlink("../aside/folder", folder.path().join("verified/beam")).unwrap();
        let refused = run(folder.path(), &["verify", &case, "-o", "verified"]);
        assert_eq!(refused.code, 2);
        assert!(refused.stderr.starts_with("error: verified/beam is a link, "), "{}", refused.stderr);
        assert_eq!(held(folder.path()), before);
        let named = run(folder.path(), &["run", &case, "-o", "results"]);
        assert_eq!(named.code, 0, "{}", named.stderr);
        assert!(folder.path().join("aside/folder/summary.json").exists());
    }

    #[test]
    fn verify_enters_no_linked_folder_and_reads_no_pipe() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        fs::create_dir(&inner).unwrap();
        beam(&inner);
        for name in ["a", "b", "c"] {
            symlink("..", inner.join(name)).unwrap();
        }
        let pipe = std::process::Command::new("mkfifo").arg(inner.join("pipe.json")).status().unwrap();
        assert!(pipe.success());
        let outcome = run(folder.path(), &["verify", "inner"]);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(outcome.stdout.contains("1 passed, 0 failed"), "{}", outcome.stdout);
    }
}
