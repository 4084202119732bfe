//! Signals at any moment of a run, and users who take its folder apart: what has a summary is whole, and what has none goes
//! on or is run again.

use super::fracture::{assert_same, case as breaking, solve, spawn, wait_for_rows};
use super::support::{files, gallery, json, root};
use serde_json::{Value, json};
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::Instant;

/// Whether the run in a folder says that it is finished; what such a folder holds must be whole.
pub(crate) fn is_finished(out: &Path) -> bool {
    if !out.join("summary.json").exists() {
        return false;
    }
    let summary = json(&out.join("summary.json"));
    let is_interrupted = summary["status"] == "interrupted";
    let text = |file: &Path| fs::read_to_string(file).unwrap();
    for table in files(out, ".csv") {
        let text = text(&table);
        let mut rows =
            text.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect());
        let first: Vec<f64> = rows.next().unwrap();
        assert!(
            text.ends_with('\n') && rows.all(|row: Vec<f64>| row.len() == first.len()),
            "{}",
            table.display()
        );
    }
    for (ending, last) in
        [(".vtu", "</VTKFile>\n"), (".pvd", "</VTKFile>\n"), (".svg", "</svg>\n"), (".html", "</html>\n")]
    {
        let found = files(out, ending);
        // Plots come with the last state.
        assert!(!found.is_empty() || is_interrupted, "no {ending}");
        // Grids hold bytes behind their text.
        let ends = |file: &Path| fs::read(file).unwrap().ends_with(last.as_bytes());
        assert!(found.iter().all(|file| ends(file)), "{ending} in {}", out.display());
    }
    let states = summary["states"].as_array().unwrap().len();
    if is_interrupted && states == 0 {
        return false;
    }
    let collection = text(&out.join("fields.pvd"));
    let named: Vec<&str> =
        collection.split("file=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert!(named.iter().all(|file| out.join(file).exists()), "{collection}");
    assert_eq!((named.len(), text(&out.join("history.csv")).lines().count()), (states, states + 1));
    json(&out.join("case.json"));
    // One that was killed before it removed what it goes on from does the last of its work again.
    !is_interrupted && !out.join("restart.bin").exists()
}

fn send(signal: &str, pid: u32) {
    // It may have ended.
    let _ = Command::new("kill").args(["-s", signal, &pid.to_string()]).stderr(Stdio::null()).status();
}

fn number(signal: &str) -> i32 {
    match signal {
        "INT" => 2,
        "KILL" => 9,
        "TERM" => 15,
        other => panic!("{other}"),
    }
}

/// Ends runs of a case at moments all over its time, and has every one finished.
fn ended_at_any_moment(case: &Value) {
    const MOMENTS: u32 = 12;
    let folder = tempfile::tempdir().unwrap();
    let mut timed = |_| {
        let begin = Instant::now();
        let whole = solve(folder.path(), case, &["-o", "whole", "--force"]);
        assert_eq!(whole.code, 0, "{}\n{}", whole.stdout, whole.stderr);
        begin.elapsed()
    };
    let time = (0..2).map(&mut timed).min().unwrap();
    let (out, whole) = (folder.path().join("out"), folder.path().join("whole"));
    assert!(is_finished(&whole));
    let goes_on = case.get("fracture").is_some() || case.get("steps").is_some();
    let mut unfinished = 0;
    for moment in 0..MOMENTS {
        let signal = ["INT", "KILL", "TERM"][moment as usize % 3];
        let mut child = spawn(folder.path());
        sleep(time * moment / MOMENTS);
        send(signal, child.id());
        let status = child.wait().unwrap();
        assert_ended(status, signal, goes_on);
        let finished = out.exists() && is_finished(&out);
        assert!(finished || !status.success(), "{signal}: a run that succeeds has a summary");
        unfinished += u32::from(!finished);
        // With `--resume` or `--force`, as there is something to go on with.
        if !finished {
            let last = spawn(folder.path()).wait_with_output().unwrap();
            assert!(last.status.success(), "{signal}: {}", String::from_utf8_lossy(&last.stderr));
        }
        assert!(is_finished(&out));
        assert_same(&out, &whole);
        fs::remove_dir_all(&out).unwrap();
    }
    assert!(unfinished >= 2, "only {unfinished} of {MOMENTS} runs were ended");
}

fn assert_ended(status: ExitStatus, signal: &str, goes_on: bool) {
    let by_signal = status.signal() == Some(number(signal));
    // A run over many states ends by itself, once it listens.
    let by_itself = goes_on && signal != "KILL" && status.code() == Some(130);
    assert!(status.success() || by_signal || by_itself, "{signal}: {status:?}");
}

/// A case of the gallery without what it is checked against.
fn of_gallery(path: &str, cells: (&str, Value)) -> Value {
    let mut case = json(&root().join("cases").join(path));
    case["checks"] = json!([]);
    *case.pointer_mut(cells.0).unwrap() = cells.1;
    case
}

#[test]
fn a_plate_that_is_ended_at_any_moment_is_whole_or_has_no_summary() {
    ended_at_any_moment(&of_gallery("plate/bending_strip.json", ("/title", json!("strip"))));
}

#[test]
fn so_is_a_beam_in_load_steps() {
    ended_at_any_moment(&of_gallery("beam/load_steps.json", ("/body/line/cells", json!(8000))));
}

#[test]
fn so_is_a_body_that_breaks() {
    ended_at_any_moment(&breaking());
}

#[test]
fn a_run_that_was_killed_behind_its_summary_ends_it_again() {
    let folder = tempfile::tempdir().unwrap();
    let (out, restart) = (folder.path().join("out"), folder.path().join("out/restart.bin"));
    assert_eq!(solve(folder.path(), &breaking(), &["-o", "whole"]).code, 0);
    let mut child = spawn(folder.path());
    wait_for_rows(folder.path(), &mut child, 20);
    child.kill().unwrap();
    child.wait().unwrap();
    let kept = fs::read(&restart).unwrap();
    assert!(spawn(folder.path()).wait().unwrap().success());
    assert!(is_finished(&out));
    fs::write(&restart, kept).unwrap();
    assert!(!is_finished(&out));
    assert!(spawn(folder.path()).wait().unwrap().success());
    assert!(is_finished(&out));
    assert_same(&out, &folder.path().join("whole"));
}

/// A run of the body that breaks of which something is removed as it goes on; what it said.
fn robbed(what: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("breaking.json"), breaking().to_string()).unwrap();
    let mut child = spawn(folder.path());
    wait_for_rows(folder.path(), &mut child, 3);
    // Nothing is written meanwhile.
    send("STOP", child.id());
    let path = folder.path().join(what);
    assert!(path.exists() && !folder.path().join("out/summary.json").exists(), "{what}");
    if path.is_dir() {
        fs::remove_dir_all(&path).unwrap()
    } else {
        fs::remove_file(&path).unwrap()
    }
    send("CONT", child.id());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(2), "{what}");
    assert!(!folder.path().join("out/summary.json").exists(), "{what}");
    String::from_utf8(ended.stderr).unwrap()
}

#[test]
fn a_run_that_loses_files_as_it_goes_on_does_not_look_finished() {
    for what in ["out", "out/fields"] {
        let told = robbed(what);
        assert!(told.contains("error: cannot write out: No such file or directory"), "{what}: {told}");
    }
    for what in ["out/fields/step_000.vtu", "out/curve.csv", "out/case.json"] {
        let told = robbed(what);
        let file = what.strip_prefix("out/").unwrap();
        let message = format!("error: cannot write out: `{file}` was removed while the run went on\nhint: ");
        assert!(told.contains(&message), "{what}: {told}");
    }
}

#[test]
fn an_interrupted_run_goes_on_from_what_it_knows_and_not_from_edited_tables() {
    let folder = tempfile::tempdir().unwrap();
    let told = super::fracture::interrupted(folder.path(), &breaking(), 15);
    assert!(told.contains("--resume"), "{told}");
    let out = folder.path().join("out");
    let history = fs::read_to_string(out.join("history.csv")).unwrap();
    assert!(history.lines().count() > 1);
    fs::write(out.join("history.csv"), history.replacen("0,", "7,", 1)).unwrap();
    fs::remove_file(out.join("curve.csv")).unwrap();
    let grids = fs::read(out.join("fields/step_000.vtu")).unwrap();
    fs::remove_dir_all(out.join("fields")).unwrap();
    let refused = solve(folder.path(), &breaking(), &["-o", "out", "--resume"]);
    let message = "error: out has lost `fields/step_000.csv`\n\
                   hint: add `--force` in place of `--resume` to run the case anew\n";
    assert_eq!((refused.code, refused.stderr.as_str()), (2, message));
    // Another run gives the fields back.
    fs::create_dir(out.join("fields")).unwrap();
    for file in files(&folder.path().join("whole/fields"), "") {
        fs::copy(&file, out.join("fields").join(file.file_name().unwrap())).unwrap();
    }
    assert_eq!(fs::read(out.join("fields/step_000.vtu")).unwrap(), grids);
    let resumed = solve(folder.path(), &breaking(), &["-o", "out", "--resume"]);
    assert_eq!(resumed.code, 0, "{}", resumed.stderr);
    assert_same(&out, &folder.path().join("whole"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_reader_without_room_is_told_and_the_results_are_there() {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_peristat"))
        .current_dir(folder.path())
        .args(["run", &gallery("cantilever.json"), "-o", "out"])
        .stdout(fs::OpenOptions::new().write(true).open("/dev/full").unwrap())
        .output()
        .unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && told.starts_with("error: No space left"), "{told}");
    assert!(is_finished(&folder.path().join("out")));
}

#[test]
fn no_clock_that_can_be_set_is_read() {
    for crate_name in ["assembly", "solve", "driver"] {
        let sources = files(&root().join("crates").join(crate_name).join("src"), ".rs");
        assert!(sources.len() > 10);
        for source in sources {
            let text = fs::read_to_string(&source).unwrap();
            for clock in ["SystemTime", "UNIX_EPOCH", "chrono", "modified()"] {
                assert!(!text.contains(clock), "{} reads {clock}", source.display());
            }
        }
    }
}
