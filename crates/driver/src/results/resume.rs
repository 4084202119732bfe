//! Going on with the folder of a run that was interrupted.

use super::curve::Curve;
use super::digest::Digest;
use super::report::Report;
use super::{
    AnyCurve, Claim, MARK, Results, fields, history_row, is_leftover, lost, names_in, restart, step,
    step_name, sweep, write_case,
};
use crate::output;
use crate::run::ProbeResult;
use crate::run::fracture::Restart;
use crate::scene::Scene;
use crate::summary::Collector;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// What helps where nothing can be resumed.
const ANEW: &str = "add `--force` in place of `--resume` to run the case anew";

impl Results {
    /// What a folder holds of a run of this scene that was interrupted, and what to go on from. Nothing is written yet.
    ///
    /// # Errors
    /// There is nothing to go on with, the run goes on, is finished or of another case, or a file is damaged or gone; each
    /// with a hint.
    pub fn interrupted(folder: &Path, scene: &Scene) -> io::Result<(Claim, Restart)> {
        let refuse =
            |kind, reason: String, hint: &str| Err(io::Error::new(kind, format!("{reason}\nhint: {hint}")));
        let place = folder.display();
        if scene.case().fracture.is_none() {
            let reason = "only a run with `fracture` can be resumed".to_string();
            return refuse(ErrorKind::InvalidInput, reason, "leave out `--resume` to run the case");
        }
        let nothing = || {
            let reason = format!("there is no run in {place} to resume");
            let hint = "leave out `--resume` to begin one, or name its folder with `-o`";
            refuse(ErrorKind::NotFound, reason, hint)
        };
        if !folder.join(MARK).exists() {
            return nothing();
        }
        let claim = Claim::again(folder)?;
        if folder.join("summary.json").exists() {
            return refuse(ErrorKind::AlreadyExists, format!("the run in {place} is finished"), ANEW);
        }
        let path = folder.join(restart::FILE);
        if !path.exists() {
            return nothing();
        }
        let (restart, digests) = restart::read(&path)?;
        if restart.case != scene.fingerprint()? {
            let reason = format!(
                "the run in {place} is of another case, or the case or peristat has been changed since"
            );
            let hint = "resume it with the `case.json` in that folder, or add `--force` in place of `--resume` to run the case anew";
            return refuse(ErrorKind::InvalidInput, reason, hint);
        }
        let files = || (0..restart.recorded).flat_map(fields);
        if let Some(file) = lost(folder, files()) {
            return refuse(ErrorKind::NotFound, format!("{place} has lost `{file}`"), ANEW);
        }
        let changed = files().enumerate().find(|(k, file)| {
            let digest = digests.get(*k);
            digest.is_none_or(|digest| !digest.is_of(&folder.join(file)))
        });
        if let Some((_, file)) = changed {
            let reason = format!("`{file}` in {place} has been changed since it was written");
            return refuse(ErrorKind::InvalidData, reason, ANEW);
        }
        Ok((claim, restart))
    }

    /// Goes on with the folder of an [interrupted](Self::interrupted) run: what was written after its restart is removed.
    ///
    /// # Errors
    /// The folder cannot be read or written.
    pub fn resume(claim: &Claim, scene: &Scene, restart: &Restart) -> io::Result<Self> {
        let folder = claim.folder();
        // Titles, checks and lines may have changed.
        write_case(folder, scene)?;
        // What is in the tables may have been edited: the restart knows.
        let known = Collector::restore(scene, &restart.summaries)?;
        let states: Vec<(f64, &[ProbeResult])> = known.history().collect();
        let row =
            |(index, (factor, probes)): (usize, &(f64, &[ProbeResult]))| history_row(index, *factor, probes);
        let history: Vec<Vec<f64>> = states.iter().enumerate().map(row).collect();
        let steps = history.iter().enumerate().map(|(index, row)| step(scene, index, row[1])).collect();
        remove_later(&folder.join("fields"), restart.recorded)?;
        output::folder::make(&folder.join("plots"))?;
        sweep(folder)?;
        ["fields", "plots"].iter().try_for_each(|part| sweep(&folder.join(part)))?;
        // Lines may have been others.
        let files: Vec<String> = (0..restart.recorded).flat_map(fields).collect();
        let digests = files.iter().map(|file| Digest::of(&folder.join(file)));
        let results = Self {
            folder: folder.into(),
            digests: digests.collect::<io::Result<_>>()?,
            files,
            steps,
            history,
            envelope: None,
            curve: Some(AnyCurve::Break(Curve::begin(folder, &restart.events)?)),
            report: Report::new(scene),
            due: None,
        };
        results.write_collection()?;
        if let Some((_, probes)) = states.last() {
            results.write_history(probes)?;
        }
        Ok(results)
    }
}

/// Removes the files of all states but the first ones, and those that were being written.
fn remove_later(fields: &Path, recorded: usize) -> io::Result<()> {
    output::folder::make(fields)?;
    let kept: BTreeSet<String> = (0..recorded).map(step_name).collect();
    for name in names_in(fields)? {
        let state = name.split(['.', '_']).take(2).collect::<Vec<_>>().join("_");
        if is_leftover(&name) || (name.starts_with("step_") && !kept.contains(&state)) {
            fs::remove_file(fields.join(name))?;
        }
    }
    Ok(())
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
            events: (0..recorded.len()).map(event).collect(),
            recorded: recorded.len(),
            summaries: collector.save(),
            ..Restart::default()
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
        Results::begin(&Claim::new(folder, true).unwrap(), scene).unwrap()
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
            let error = Results::resume(&claim, scene, &found).unwrap_err();
            assert!(error.to_string().contains("is a link"), "{error}");
            fs::remove_file(out.join(part)).unwrap();
            fs::rename(&aside, out.join(part)).unwrap();
        }
        Results::resume(&claim, scene, &found).unwrap();
    }

    #[test]
    fn a_run_of_which_a_field_was_changed_is_not_resumed() {
        let folder = tempfile::tempdir().unwrap();
        let (loaded, states) = plate(folder.path());
        let (scene, out) = (&loaded.scene, folder.path().join("out"));
        go_on(&mut begin(&out, scene), scene, &states, 0..1);
        // A second equilibrium after a resumption.
        let (claim, found) = Results::interrupted(&out, scene).unwrap();
        go_on(&mut Results::resume(&claim, scene, &found).unwrap(), scene, &states, 1..2);
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
        let refused = Claim::new(&parts, false).unwrap_err().to_string();
        assert!(refused.contains("holds an unfinished run of `plate`\nhint: "), "{refused}");
        // What was edited is not believed.
        let history = fs::read_to_string(parts.join("history.csv")).unwrap();
        fs::write(parts.join("history.csv"), history.replace("0.3", "0.4")).unwrap();

        let (claim, found) = Results::interrupted(&parts, scene).unwrap();
        assert_eq!(found, restart(scene, &states[..1]));
        let running = Results::interrupted(&parts, scene).unwrap_err().to_string();
        assert!(running.contains("another peristat is writing into"), "{running}");
        let mut second = Results::resume(&claim, scene, &found).unwrap();
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
        assert!(refused(&unbroken.scene).starts_with("only a run with `fracture` can be resumed\nhint: "));
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
        Results::resume(&claim, &loaded.scene, &restart).unwrap();
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
}
