//! Runs that go on where they were interrupted.

use super::*;
use crate::Loaded;
use crate::case::{Critical, Fracture};
use crate::run::Advance;
use crate::run::fracture::{BreakRestart, Event};
use crate::run::{RestartFrom, RunOptions, StateResult, taking};
use std::time::{Duration, Instant};

/// A plate with a crack and a line, of which three steps stand for equilibria as it breaks, and their results.
fn plate(folder: &Path) -> (Loaded, Vec<StateResult>) {
    let text = r#"{
        "title": "plate", "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress", "thickness": 1.0 } },
        "body": { "rectangle": { "size": [8.0, 6.0], "spacing": 1.0 } },
        "cracks": [ { "path": [[0.0, 3.0], [2.0, 3.0]] } ],
        "supports": [ { "at": { "region": "bottom" }, "ux": 0.0, "uy": 0.0 } ],
        "loads": [ { "traction": { "edge": "top", "uniform": [0.0, 1.0] } } ],
        "steps": { "load_factors": [0.1, 0.3, 0.2] },
        "probes": [ { "name": "lift, \"top\"", "at": { "region": "top" }, "field": "uy" } ],
        "lines": [ { "name": "across", "from": [4.0, 1.0], "to": [4.0, 5.0], "points": 3 } ]
    }"#;
    let path = folder.join("plate.json");
    fs::write(&path, text).unwrap();
    let mut loaded = Loaded::read(&path, &[], None).unwrap_or_else(|e| panic!("{e}"));
    let mut states = Vec::new();
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    let mut keep = taking(|state| {
        states.push(state);
        Ok(())
    });
    loaded.run(&options, None, &mut keep).unwrap_or_else(|e| panic!("{e}"));
    drop(keep);
    let Scene::Body(scene) = &mut loaded.scene else { panic!("a plate is in the plane") };
    scene.case.fracture = Some(Fracture {
        critical: Critical { stretch: Some(0.1), ..Critical::default() },
        strategy: None,
        batch_threshold: None,
        increment: None,
        no_fail: Vec::new(),
        directions: Vec::new(),
        load: "lift".into(),
        stop_below: None,
        max_solves: None,
        record_every: None,
    });
    (loaded, states)
}

fn event(solve: usize) -> Event {
    Event { solve, load: [1.0, 0.3, 2.0][solve], load_factor: 0.1, ..Event::default() }
}

fn restart(scene: &Scene, recorded: &[StateResult]) -> Restart {
    let mut collector = Collector::default();
    recorded.iter().for_each(|state| collector.take(scene, state));
    Restart {
        case: scene.fingerprint().unwrap(),
        summaries: collector.save(),
        recorded: recorded.len(),
        from: RestartFrom::Break(Box::new(BreakRestart {
            events: (0..recorded.len()).map(event).collect(),
            ..BreakRestart::default()
        })),
    }
}

/// Writes the equilibria from one on up to another, with a restart after each.
fn go_on(results: &mut Results, scene: &Scene, states: &[StateResult], which: std::ops::Range<usize>) {
    for k in which {
        results.take(scene, &states[k]).unwrap();
        let restart = || restart(scene, &states[..=k]);
        results.advance(Advance::Break(&event(k)), Some(&restart), true).unwrap();
    }
}

/// A folder that is new or has been forced upon.
fn begin(folder: &Path, scene: &Scene) -> Results {
    Results::begin(&Claim::new(folder, true, None).unwrap(), scene, FieldFiles::default()).unwrap()
}

/// Names and contents of all files.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for part in ["", "fields", "plots"] {
        for name in names_in(&folder.join(part)).unwrap() {
            let path = folder.join(part).join(&name);
            if path.is_file() {
                found.push((format!("{part}/{name}"), fs::read(path).unwrap()));
            }
        }
    }
    found.sort();
    found
}

#[cfg(unix)]
#[test]
fn a_run_is_not_resumed_through_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let (loaded, states) = plate(folder.path());
    let (scene, out, aside) = (&loaded.scene, folder.path().join("out"), folder.path().join("aside"));
    go_on(&mut begin(&out, scene), scene, &states, 0..1);
    let (claim, found) = Results::interrupted(&out, scene).unwrap();
    for part in ["fields", "plots"] {
        fs::rename(out.join(part), &aside).unwrap();
        std::os::unix::fs::symlink(&aside, out.join(part)).unwrap();
        let error = Results::resume(&claim, scene, &found, FieldFiles::default()).unwrap_err();
        assert!(error.to_string().contains("is a link"), "{error}");
        fs::remove_file(out.join(part)).unwrap();
        fs::rename(&aside, out.join(part)).unwrap();
    }
    Results::resume(&claim, scene, &found, FieldFiles::default()).unwrap();
}

#[test]
fn a_run_of_which_a_field_was_changed_is_not_resumed() {
    let folder = tempfile::tempdir().unwrap();
    let (loaded, states) = plate(folder.path());
    let (scene, out) = (&loaded.scene, folder.path().join("out"));
    go_on(&mut begin(&out, scene), scene, &states, 0..1);
    // A second equilibrium after a resumption.
    let (claim, found) = Results::interrupted(&out, scene).unwrap();
    go_on(&mut Results::resume(&claim, scene, &found, FieldFiles::default()).unwrap(), scene, &states, 1..2);
    drop(claim);
    for file in ["step_000.csv", "step_000.vtu", "step_001.csv", "step_001.vtu"] {
        let path = out.join("fields").join(file);
        let whole = fs::read(&path).unwrap();
        let mut other = whole.clone();
        *other.last_mut().unwrap() ^= 1;
        for changed in [&other, &whole[1..], b"garbage"] {
            fs::write(&path, changed).unwrap();
            let error = Results::interrupted(&out, scene).unwrap_err().to_string();
            let said = format!("`fields/{file}` in {} has been changed", out.display());
            assert!(error.starts_with(&said) && error.contains("\nhint: "), "{error}");
        }
        fs::write(&path, whole).unwrap();
    }
    Results::interrupted(&out, scene).unwrap();
}

#[test]
fn a_resumed_run_leaves_the_same_files_as_one_that_was_not_interrupted() {
    let folder = tempfile::tempdir().unwrap();
    let (loaded, states) = plate(folder.path());
    let scene = &loaded.scene;
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    go_on(&mut begin(&whole, scene), scene, &states, 0..3);

    let mut first = begin(&parts, scene);
    go_on(&mut first, scene, &states, 0..1);
    // Two equilibria more, of which the restart knows nothing, and a file that was being written.
    first.due = Some(Instant::now() + Duration::from_secs(3600));
    for k in 1..3 {
        first.take(scene, &states[k]).unwrap();
        first.advance(Advance::Break(&event(k)), Some(&|| panic!("it is not due")), false).unwrap();
    }
    drop(first);
    fs::write(parts.join("fields/.abc.part"), "half").unwrap();
    fs::write(parts.join(".def.part"), "half").unwrap();
    assert!(parts.join("fields/step_002_across.csv").exists());
    let refused = Claim::new(&parts, false, None).unwrap_err().to_string();
    assert!(refused.contains("holds an unfinished run of `plate`\nhint: "), "{refused}");
    // What was edited is not believed.
    let history = fs::read_to_string(parts.join("history.csv")).unwrap();
    fs::write(parts.join("history.csv"), history.replace("0.3", "0.4")).unwrap();

    let (claim, found) = Results::interrupted(&parts, scene).unwrap();
    assert_eq!(found, restart(scene, &states[..1]));
    let running = Results::interrupted(&parts, scene).unwrap_err().to_string();
    assert!(running.contains("another peristat is writing into"), "{running}");
    let mut second = Results::resume(&claim, scene, &found, FieldFiles::default()).unwrap();
    assert!(!parts.join("fields/step_001.vtu").exists() && parts.join("fields/step_000.vtu").exists());
    go_on(&mut second, scene, &states, 1..3);
    assert!(contents(&whole) == contents(&parts));
}

#[test]
fn a_finished_run_has_its_curve_and_nothing_to_go_on_with() {
    let folder = tempfile::tempdir().unwrap();
    let (loaded, states) = plate(folder.path());
    let out = folder.path().join("out");
    let refused = |scene: &Scene| Results::interrupted(&out, scene).unwrap_err().to_string();
    assert!(refused(&loaded.scene).contains("out to resume\nhint: "));
    let mut results = begin(&out, &loaded.scene);
    assert!(refused(&loaded.scene).contains("out to resume\nhint: "));
    go_on(&mut results, &loaded.scene, &states, 0..3);
    let unbroken = Loaded::read(&folder.path().join("plate.json"), &[], None).unwrap();
    let summary = unbroken.run(&RunOptions::default(), None, &mut taking(|_| Ok(()))).unwrap();
    results.finish(&summary, loaded.scene.case()).unwrap();
    let plots = names_in(&out.join("plots")).unwrap();
    assert!(["load_curve.svg", "energy.svg"].iter().all(|name| plots.iter().any(|n| n == name)));
    assert!(out.join("curve.csv").exists() && !out.join("restart.bin").exists());
    assert!(refused(&loaded.scene).contains("is finished\nhint: add `--force` in place of"));
    assert!(
        refused(&unbroken.scene).starts_with("only a run with `fracture` or `path` can be resumed\nhint: ")
    );
}

#[test]
fn another_case_and_a_damaged_folder_are_refused_and_a_new_title_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let (mut loaded, states) = plate(folder.path());
    let out = folder.path().join("out");
    let mut results = begin(&out, &loaded.scene);
    go_on(&mut results, &loaded.scene, &states, 0..2);
    drop(results);
    let change = |loaded: &mut Loaded, change: &dyn Fn(&mut Fracture)| {
        let Scene::Body(scene) = &mut loaded.scene else { panic!("a plate is in the plane") };
        scene.case.title = "another".into();
        change(scene.case.fracture.as_mut().unwrap());
    };
    change(&mut loaded, &|f| (f.max_solves, f.record_every) = (Some(7), Some(1)));
    let (claim, restart) = Results::interrupted(&out, &loaded.scene).unwrap();
    Results::resume(&claim, &loaded.scene, &restart, FieldFiles::default()).unwrap();
    drop(claim);
    assert!(fs::read_to_string(out.join("case.json")).unwrap().contains("\"title\": \"another\""));

    let refused = |loaded: &Loaded| Results::interrupted(&out, &loaded.scene).unwrap_err().to_string();
    change(&mut loaded, &|f| f.critical.stretch = Some(0.2));
    assert!(
        refused(&loaded)
            .contains("is of another case, or the case or peristat has been changed since\nhint: ")
    );
    change(&mut loaded, &|f| f.critical.stretch = Some(0.1));
    for file in ["fields/step_001.csv", "fields/step_000.vtu"] {
        fs::remove_file(out.join(file)).unwrap();
        assert!(refused(&loaded).contains(&format!("out has lost `{file}`\nhint: ")));
    }
    fs::write(out.join("restart.bin"), "{}").unwrap();
    assert!(refused(&loaded).contains("restart.bin is not a restart of peristat\nhint: "));
}
