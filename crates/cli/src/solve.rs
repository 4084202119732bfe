//! `run` and `check`.

use super::args::{Global, Run};
use super::interrupt::Interrupt;
use super::progress::Progress;
use super::writing::Writing;
use super::{DONE, FAILED, USAGE, colored, complain, note, print, say};
use peristat::case;
use peristat::input::Folder;
use peristat::output::folder::below;
use peristat::results::{Claim, Results, stiffness};
use peristat::run::fracture::Restart;
use peristat::run::{RunOptions, sizes};
use peristat::summary::{Grids, Status, Summary};
use peristat::{Error, Loaded};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Reads a case and resolves it.
pub(super) fn load(case: &Path, overrides: &[String], global: &Global) -> Result<Loaded, Error> {
    let source = case::read(case, overrides, global.max_memory)?;
    Loaded::from_source(source, Folder::of(case, global.reach()), global.max_memory)
}

/// Solves a case into its results folder.
pub(super) fn run(arguments: &Run, global: &Global) -> Result<u8, Error> {
    let loaded = load(&arguments.case, &arguments.overrides, global)?;
    warn(&loaded, global);
    let folder = match &arguments.output {
        Some(folder) => folder.clone(),
        None => {
            below(Path::new(""), &Path::new("results").join(arguments.case.file_stem().unwrap_or_default()))?
        }
    };
    let (claim, restart) = match arguments.resume {
        true => {
            Results::interrupted(&folder, &loaded.scene).map(|(claim, restart)| (claim, Some(restart)))?
        }
        false => (Claim::new(&folder, arguments.force)?, None),
    };
    // Faults of the case come before the first file.
    sizes(&loaded.scene, &with_fields(global)).map_err(|e| loaded.explain(e))?;
    if let Some(file) = &arguments.write_matrix {
        if file.exists() && !arguments.force {
            let message = format!("{} exists\nhint: choose another file, or add `--force`", file.display());
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, message).into());
        }
        if claim.writes(file) {
            let message = format!(
                "the results would replace {}\nhint: choose another file for the matrix",
                file.display()
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message).into());
        }
        stiffness::write(&loaded, file)?;
    }
    let mut writing = Writing::new(&loaded.scene, claim);
    // What cannot be resumed is better killed by the first signal.
    if loaded.scene.case().fracture.is_some() {
        writing = writing.watched(Progress::new(global), Interrupt::listen(global.quiet)?);
    }
    let wanted = match (arguments.estimate, arguments.no_estimate) {
        (true, _) => Wanted::FromFiner,
        (_, true) => Wanted::Nothing,
        _ => Wanted::Cheap,
    };
    let summary = solve_into(&loaded, restart, writing, wanted, global)?;
    if !global.quiet {
        // Those of the case have been shown.
        let shown = loaded.warnings().map_or(0, |report| report.diagnostics.len());
        summary.warnings.iter().skip(shown).for_each(|text| note(&format!("warning: {text}\n\n")));
    }
    if global.json {
        say(&print::json(&summary))?;
    } else if !global.quiet {
        say(&print::summary(&summary, global.verbose))?;
        say(&format!("results in {}\n", folder.display()))?;
    }
    Ok(exit_code(&summary))
}

/// The estimate of discretisation errors that a run makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// None.
    Nothing,
    /// That of coarser grids, where it is cheap.
    Cheap,
    /// That of a finer grid, whatever it costs.
    FromFiner,
}

/// Solves a scene, from a restart if there is one, into its folder, and estimates its errors.
pub(super) fn solve_into(
    loaded: &Loaded,
    restart: Option<Restart>,
    mut writing: Writing,
    wanted: Wanted,
    global: &Global,
) -> Result<Summary, Error> {
    if let Some(restart) = &restart {
        writing.resume(restart)?;
    }
    let mut summary = loaded.run(&with_fields(global), restart, &mut writing)?;
    let begin = Instant::now();
    let estimated = match wanted {
        Wanted::Nothing => None,
        Wanted::Cheap => Some(loaded.estimate_cheaply(&summary, global.max_memory)),
        Wanted::FromFiner => Some(loaded.estimate(&summary, Grids::FinerAndCoarser, global.max_memory)),
    };
    match estimated {
        Some(Ok(estimates)) => summary.estimate = Some(estimates),
        Some(Err(reason)) => summary.no_estimate = Some(reason),
        None => {}
    }
    summary.timing_s.estimate = begin.elapsed().as_secs_f64();
    writing.finish(&summary)?;
    Ok(summary)
}

/// What a run with all its outputs is asked for.
fn with_fields(global: &Global) -> RunOptions {
    RunOptions { recover: true, max_memory: global.max_memory, compare: true }
}

/// Exit code of a finished run.
pub(super) fn exit_code(summary: &Summary) -> u8 {
    match summary.status {
        Status::Passed => DONE,
        Status::CheckFailed | Status::NotConverged => FAILED,
    }
}

/// Shows the warnings of a case.
pub(super) fn warn(loaded: &Loaded, global: &Global) {
    if let Some(report) = loaded.warnings().filter(|_| !global.quiet) {
        note(&format!("{}\n\n", report.render(colored(global)).trim_end()));
    }
}

/// Builds cases and says how large they are.
pub(super) fn check(cases: &[PathBuf], overrides: &[String], global: &Global) -> Result<u8, Error> {
    let mut code = DONE;
    let mut all = Vec::new();
    for path in cases {
        let estimated = load(path, overrides, global).and_then(|loaded| {
            warn(&loaded, global);
            sizes(&loaded.scene, &with_fields(global)).map_err(|e| loaded.explain(e))
        });
        match estimated {
            Ok(sizes) => all.push((path.display().to_string(), sizes)),
            Err(error) => {
                complain(&error, global);
                code = USAGE;
            }
        }
    }
    if global.json {
        let list: Vec<_> =
            all.iter().map(|(case, sizes)| serde_json::json!({ "case": case, "sizes": sizes })).collect();
        say(&format!("{:#}\n", serde_json::Value::from(list)))?;
    } else if !global.quiet && !all.is_empty() {
        say(&print::sizes(&all))?;
    }
    Ok(code)
}
