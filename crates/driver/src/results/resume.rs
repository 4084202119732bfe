//! Going on with the folder of a run that was interrupted.

use super::curve::Curve;
use super::report::Report;
use super::{
    AnyCurve, HISTORY, MARK, Results, is_leftover, names_in, restart, step, step_name, sweep, write_case,
};
use crate::run::fracture::Restart;
use crate::scene::Scene;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

impl Results {
    /// What a folder holds of a run of this scene that was interrupted, and what to go on from. Nothing is written yet.
    ///
    /// # Errors
    /// There is nothing to go on with, the run is finished or of another case, or a file is damaged; each with a hint.
    pub fn interrupted(folder: &Path, scene: &Scene) -> io::Result<Restart> {
        let refuse =
            |kind, reason: String, hint: &str| Err(io::Error::new(kind, format!("{reason}\nhint: {hint}")));
        let place = folder.display();
        if scene.case().fracture.is_none() {
            let reason = "only a run with `fracture` can be resumed".to_string();
            return refuse(ErrorKind::InvalidInput, reason, "leave out `--resume` to run the case");
        }
        if folder.join("summary.json").exists() {
            let reason = format!("the run in {place} is finished");
            return refuse(ErrorKind::AlreadyExists, reason, "leave out `--resume` to run the case anew");
        }
        let path = folder.join(restart::FILE);
        if !folder.join(MARK).exists() || !path.exists() {
            let reason = format!("there is no run in {place} to resume");
            let hint = "leave out `--resume` to begin one, or name its folder with `-o`";
            return refuse(ErrorKind::NotFound, reason, hint);
        }
        let restart = restart::read(&path)?;
        if restart.case != scene.fingerprint()? {
            let reason = format!(
                "the run in {place} is of another case, or the case or peristat has been changed since"
            );
            let hint =
                "resume it with the `case.json` in that folder, or leave out `--resume` to run the case anew";
            return refuse(ErrorKind::InvalidInput, reason, hint);
        }
        if history(folder)?.len() < restart.recorded {
            let reason = format!("{place}/history.csv lacks rows that were written");
            return refuse(ErrorKind::InvalidData, reason, "leave out `--resume` to run the case anew");
        }
        Ok(restart)
    }

    /// Goes on with the folder of an [interrupted](Self::interrupted) run: what was written after its restart is removed.
    ///
    /// # Errors
    /// The folder cannot be read or written.
    pub fn resume(folder: &Path, scene: &Scene, restart: &Restart) -> io::Result<Self> {
        // Titles, checks and lines may have changed.
        write_case(folder, scene)?;
        let mut history = history(folder)?;
        history.truncate(restart.recorded);
        let steps = history.iter().enumerate().map(|(index, row)| step(scene, index, row[1])).collect();
        remove_later(&folder.join("fields"), restart.recorded)?;
        fs::create_dir_all(folder.join("plots"))?;
        sweep(folder)?;
        ["fields", "plots"].iter().try_for_each(|part| sweep(&folder.join(part)))?;
        let results = Self {
            folder: folder.into(),
            steps,
            history,
            envelope: None,
            curve: Some(AnyCurve::Break(Curve::begin(folder, &restart.events)?)),
            report: Report::new(scene),
            due: None,
        };
        results.write_collection()?;
        Ok(results)
    }
}

/// Removes the files of all states but the first ones, and those that were being written.
fn remove_later(fields: &Path, recorded: usize) -> io::Result<()> {
    fs::create_dir_all(fields)?;
    let kept: BTreeSet<String> = (0..recorded).map(step_name).collect();
    for name in names_in(fields)? {
        let state = name.split(['.', '_']).take(2).collect::<Vec<_>>().join("_");
        if is_leftover(&name) || (name.starts_with("step_") && !kept.contains(&state)) {
            fs::remove_file(fields.join(name))?;
        }
    }
    Ok(())
}

/// Rows of `history.csv`; none if there is no such file yet.
fn history(folder: &Path) -> io::Result<Vec<Vec<f64>>> {
    let path = folder.join("history.csv");
    let text = match fs::read_to_string(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        text => text?,
    };
    let row = |line: &str| -> Option<Vec<f64>> {
        let row: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        row.ok().filter(|row| row.len() >= HISTORY.len())
    };
    let rows: Option<Vec<Vec<f64>>> = text.lines().skip(1).map(row).collect();
    let alike = rows.filter(|rows| rows.iter().all(|row| row.len() == rows[0].len()));
    alike.ok_or_else(|| {
        io::Error::new(ErrorKind::InvalidData, format!("{} is no table of numbers", path.display()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Loaded;
    use crate::case::{Critical, Fracture};
    use crate::run::Advance;
    use crate::run::fracture::Event;
    use crate::run::{RunOptions, StateResult, taking};
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
        let options = RunOptions { recover: true, max_memory: None };
        let mut keep = taking(|state| {
            states.push(state);
            Ok(())
        });
        loaded.run(&options, None, &mut keep).unwrap_or_else(|e| panic!("{e}"));
        drop(keep);
        let Scene::Plane(scene) = &mut loaded.scene else { panic!("a plate is in the plane") };
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

    fn restart(scene: &Scene, recorded: usize) -> Restart {
        let events = (0..recorded).map(event).collect();
        Restart { case: scene.fingerprint().unwrap(), events, recorded, ..Restart::default() }
    }

    /// Writes the equilibria from one on up to another, with a restart after each.
    fn go_on(results: &mut Results, scene: &Scene, states: &[StateResult], which: std::ops::Range<usize>) {
        for k in which {
            results.take(scene, &states[k]).unwrap();
            results.advance(Advance::Break(&event(k)), Some(&|| restart(scene, k + 1)), true).unwrap();
        }
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

    #[test]
    fn a_resumed_run_leaves_the_same_files_as_one_that_was_not_interrupted() {
        let folder = tempfile::tempdir().unwrap();
        let (loaded, states) = plate(folder.path());
        let scene = &loaded.scene;
        let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
        go_on(&mut Results::begin(&whole, scene).unwrap(), scene, &states, 0..3);

        let mut first = Results::begin(&parts, scene).unwrap();
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
        super::super::admit(&parts, false).unwrap();

        let found = Results::interrupted(&parts, scene).unwrap();
        assert_eq!(found, restart(scene, 1));
        let mut second = Results::resume(&parts, scene, &found).unwrap();
        assert!(!parts.join("fields/step_001.vtu").exists() && parts.join("fields/step_000.vtu").exists());
        go_on(&mut second, scene, &states, 1..3);
        assert!(contents(&whole) == contents(&parts));
        assert_eq!(history(&parts).unwrap().len(), 3);
    }

    #[test]
    fn a_finished_run_has_its_curve_and_nothing_to_go_on_with() {
        let folder = tempfile::tempdir().unwrap();
        let (loaded, states) = plate(folder.path());
        let out = folder.path().join("out");
        let refused = |scene: &Scene| Results::interrupted(&out, scene).unwrap_err().to_string();
        assert!(refused(&loaded.scene).contains("out to resume\nhint: "));
        let mut results = Results::begin(&out, &loaded.scene).unwrap();
        assert!(refused(&loaded.scene).contains("out to resume\nhint: "));
        go_on(&mut results, &loaded.scene, &states, 0..3);
        let unbroken = Loaded::read(&folder.path().join("plate.json"), &[], None).unwrap();
        let summary = unbroken.run(&RunOptions::default(), None, &mut taking(|_| Ok(()))).unwrap();
        results.finish(&summary, loaded.scene.case()).unwrap();
        let plots = names_in(&out.join("plots")).unwrap();
        assert!(["load_curve.svg", "energy.svg"].iter().all(|name| plots.iter().any(|n| n == name)));
        assert!(out.join("curve.csv").exists() && !out.join("restart.bin").exists());
        assert!(
            refused(&loaded.scene).ends_with("is finished\nhint: leave out `--resume` to run the case anew")
        );
        assert!(refused(&unbroken.scene).starts_with("only a run with `fracture` can be resumed\nhint: "));
    }

    #[test]
    fn another_case_and_a_damaged_folder_are_refused_and_a_new_title_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let (mut loaded, states) = plate(folder.path());
        let out = folder.path().join("out");
        let mut results = Results::begin(&out, &loaded.scene).unwrap();
        go_on(&mut results, &loaded.scene, &states, 0..2);
        drop(results);
        let change = |loaded: &mut Loaded, change: &dyn Fn(&mut Fracture)| {
            let Scene::Plane(scene) = &mut loaded.scene else { panic!("a plate is in the plane") };
            scene.case.title = "another".into();
            change(scene.case.fracture.as_mut().unwrap());
        };
        change(&mut loaded, &|f| (f.max_solves, f.record_every) = (Some(7), Some(1)));
        let restart = Results::interrupted(&out, &loaded.scene).unwrap();
        Results::resume(&out, &loaded.scene, &restart).unwrap();
        assert!(fs::read_to_string(out.join("case.json")).unwrap().contains("\"title\": \"another\""));

        let refused = |loaded: &Loaded| Results::interrupted(&out, &loaded.scene).unwrap_err().to_string();
        change(&mut loaded, &|f| f.critical.stretch = Some(0.2));
        assert!(
            refused(&loaded)
                .contains("is of another case, or the case or peristat has been changed since\nhint: ")
        );
        change(&mut loaded, &|f| f.critical.stretch = Some(0.1));
        let table = fs::read_to_string(out.join("history.csv")).unwrap();
        let header_and_first: Vec<&str> = table.lines().take(2).collect();
        fs::write(out.join("history.csv"), header_and_first.join("\n")).unwrap();
        assert!(refused(&loaded).contains("history.csv lacks rows that were written\nhint: "));
        fs::write(out.join("history.csv"), "step\nx\n").unwrap();
        assert!(refused(&loaded).contains("history.csv is no table of numbers"));
        fs::write(out.join("restart.bin"), "{}").unwrap();
        assert!(refused(&loaded).contains("restart.bin is not a restart of peristat\nhint: "));
    }
}
