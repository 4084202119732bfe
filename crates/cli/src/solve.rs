//! `run` and `check`.

use super::args::{Global, Run};
use super::interrupt::Interrupt;
use super::progress::Progress;
use super::watched::Watched;
use super::{DONE, FAILED, INTERRUPTED, USAGE, colored, complain, note, print, say, viewer};
use peristat::case::{self, Case};
use peristat::input::Folder;
use peristat::output::folder::below;
use peristat::results::{Claim, Results, Writing, stiffness};
use peristat::run::fracture::{Forecast, forecast};
use peristat::run::{Restart, RunOptions, sizes};
use peristat::study::EstimateEffort;
use peristat::summary::{Status, Summary};
use peristat::{Error, Loaded};
use std::io;
use std::path::{Path, PathBuf};

/// Reads a case and resolves it.
pub(super) fn load(case: &Path, overrides: &[String], global: &Global) -> Result<Loaded, Error> {
    let folder = Folder::of(case, global.reach());
    let source = case::read(case, overrides, &folder, global.max_memory)?;
    Loaded::from_source(source, folder, global.max_memory)
}

/// Solves a case into its results folder.
pub(super) fn run(arguments: &Run, global: &Global) -> Result<u8, Error> {
    let loaded = load(&arguments.case, &arguments.overrides, global)?;
    run_loaded(&loaded, arguments, global, &|options, restart, watched| loaded.run(options, restart, watched))
}

/// What solves a case.
type Solve<'a> = dyn Fn(&RunOptions, Option<Restart>, &mut Watched) -> Result<Summary, Error> + 'a;

/// Solves a case that is read by `solve` into its results folder.
pub(super) fn run_loaded(
    loaded: &Loaded,
    arguments: &Run,
    global: &Global,
    solve: &Solve,
) -> Result<u8, Error> {
    warn(loaded, global);
    let folder = match &arguments.output {
        Some(folder) => folder.clone(),
        None => {
            below(Path::new(""), &Path::new("results").join(arguments.case.file_stem().unwrap_or_default()))?
        }
    };
    let case = arguments.case.canonicalize().ok();
    let (claim, restart) = match arguments.resume {
        true => {
            Results::interrupted(&folder, &loaded.scene).map(|(claim, restart)| (claim, Some(restart)))?
        }
        false => (Claim::new(&folder, arguments.force, case.as_deref())?, None),
    };
    // Faults of the case come before the first file.
    sizes(&loaded.scene, &with_fields(global)).map_err(|e| loaded.explain(e))?;
    if let Some(file) = &arguments.write_matrix {
        write_matrix(loaded, file, arguments.force, &claim)?;
    }
    let writing = Writing::new(&loaded.scene, claim).with_fields(arguments.field_files());
    let case = loaded.scene.case();
    let progress = if case.is_traced() { Progress::new(global) } else { Progress::Silent };
    // What has nothing to show on the way is better killed by the first signal.
    let interrupt = match case.is_traced() || loaded.scene.states() > 1 {
        true => Interrupt::listen(global.quiet)?,
        false => Interrupt::default(),
    };
    let mut watched = Watched { writing, progress, interrupt };
    if let Some(restart) = &restart {
        watched.writing.resume(restart)?;
    }
    let mut summary = solve(&with_fields(global), restart, &mut watched)?.measured();
    if summary.status == Status::Interrupted {
        watched.writing.finish(&summary)?;
        return interrupted(loaded, &summary, &folder, global);
    }
    loaded.add_estimate(&mut summary, effort(arguments), global.max_memory);
    watched.writing.finish(&summary)?;
    tell(loaded, &summary, &folder, global)?;
    if arguments.open {
        viewer::show(&folder);
    }
    Ok(exit_code(&summary))
}

/// Writes the matrix of a case where that replaces nothing.
fn write_matrix(loaded: &Loaded, file: &Path, force: bool, claim: &Claim) -> Result<(), Error> {
    if file.exists() && !force {
        let message = format!("{} exists\nhint: choose another file, or add `--force`", file.display());
        return Err(io::Error::new(io::ErrorKind::AlreadyExists, message).into());
    }
    if claim.writes(file) {
        let message =
            format!("the results would replace {}\nhint: choose another file for the matrix", file.display());
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message).into());
    }
    stiffness::write(loaded, file)
}

/// Tells of a run that is done.
fn tell(loaded: &Loaded, summary: &Summary, folder: &Path, global: &Global) -> Result<(), Error> {
    if !global.quiet {
        // Those of the case have been shown.
        let shown = loaded.warnings().map_or(0, |report| report.diagnostics.len());
        summary.warnings.iter().skip(shown).for_each(|text| note(&format!("warning: {text}\n\n")));
    }
    if global.json {
        say(&print::json(summary))?;
    } else if !global.quiet {
        say(&print::summary(summary, global.verbose))?;
        say(&format!("results in {}\n", folder.display()))?;
    }
    Ok(())
}

/// How much the run may spend on estimates of its errors.
fn effort(arguments: &Run) -> EstimateEffort {
    match (arguments.estimate, arguments.no_estimate) {
        (true, _) => EstimateEffort::FromFiner,
        (_, true) => EstimateEffort::Nothing,
        _ => EstimateEffort::Cheap,
    }
}

/// Tells of a run that was interrupted what there is of it.
fn interrupted(loaded: &Loaded, summary: &Summary, folder: &Path, global: &Global) -> Result<u8, Error> {
    if global.json {
        say(&print::json(summary))?;
    } else if !global.quiet {
        say(&format!(
            "interrupted {}, results so far in {}\n",
            summary.interrupted.as_deref().unwrap_or_default(),
            folder.display()
        ))?;
    }
    note(match loaded.scene.case().is_traced() {
        true => "interrupted\nhint: the same command with `--resume` goes on from here\n",
        false => "interrupted\n",
    });
    Ok(INTERRUPTED)
}

/// What a run with all its outputs is asked for.
pub(super) fn with_fields(global: &Global) -> RunOptions {
    RunOptions { recover: true, max_memory: global.max_memory, compare: true }
}

/// Exit code of a finished run.
fn exit_code(summary: &Summary) -> u8 {
    match summary.status {
        Status::Passed => DONE,
        Status::CheckFailed | Status::NotConverged => FAILED,
        Status::Interrupted => INTERRUPTED,
    }
}

/// Shows the warnings of a case.
fn warn(loaded: &Loaded, global: &Global) {
    if let Some(report) = loaded.warnings().filter(|_| !global.quiet) {
        note(&format!("{}\n\n", report.render(colored(global)).trim_end()));
    }
}

/// How many equilibria a body that breaks or softens may take, and the key that bounds them: how many it will is known only
/// with them.
fn bound(case: &Case) -> Option<(usize, &'static str)> {
    let breaks = case.fracture.as_ref().and_then(|f| Some((f.max_solves?, "fracture.max_solves")));
    breaks.or_else(|| case.path.as_ref().and_then(|p| Some((p.max_steps?, "path.max_steps"))))
}

/// A forecast in words.
fn about(forecast: Forecast) -> String {
    let rounded = |value: f64| format!("{value:.0e}").parse::<f64>().unwrap_or(value);
    let (equilibria, seconds) = (rounded(forecast.equilibria as f64), forecast.seconds);
    let time = match seconds {
        _ if seconds < 1.0 => "less than a second".into(),
        _ if seconds < 100.0 => format!("{} s", rounded(seconds)),
        _ if seconds < 6000.0 => format!("{} min", rounded(seconds / 60.0)),
        _ => format!("{} h", rounded(seconds / 3600.0)),
    };
    format!(
        "1 equilibrium if no bond breaks, about {equilibria} in {time} if a crack goes through, both to a factor of three; "
    )
}

/// Builds cases and says how large they are.
pub(super) fn check(cases: &[PathBuf], overrides: &[String], global: &Global) -> Result<u8, Error> {
    let mut code = DONE;
    let mut all = Vec::new();
    for path in cases {
        let estimated = load(path, overrides, global).and_then(|loaded| {
            warn(&loaded, global);
            let sizes = sizes(&loaded.scene, &with_fields(global)).map_err(|e| loaded.explain(e))?;
            let course = bound(loaded.scene.case()).map(|bound| (bound, forecast(&loaded.scene, &sizes)));
            Ok((sizes, course))
        });
        if estimated.is_err() {
            code = USAGE;
        }
        all.push((path.display().to_string(), estimated));
    }
    if global.json {
        let list = all.iter().map(|(case, found)| match found {
            Ok((sizes, Some(((most, _), forecast)))) => {
                serde_json::json!({ "case": case, "sizes": sizes, "equilibria_at_most": most, "forecast": forecast })
            }
            Ok((sizes, None)) => serde_json::json!({ "case": case, "sizes": sizes }),
            Err(error) => {
                serde_json::json!({ "case": case, "error": error.text(), "faults": error.records() })
            }
        });
        say(&format!("{:#}\n", serde_json::Value::from(list.collect::<Vec<_>>())))?;
        return Ok(code);
    }
    let (mut built, mut bounds) = (Vec::new(), String::new());
    for (case, found) in all {
        match found {
            Ok((sizes, course)) => {
                if let Some(((most, key), forecast)) = course {
                    let about = forecast.map_or(String::new(), about);
                    bounds += &format!("{case}: {about}at most {most} equilibria, by `{key}`\n");
                }
                built.push((case, sizes));
            }
            Err(error) => complain(&error, global),
        }
    }
    if !global.quiet && !built.is_empty() {
        say(&format!("{}{bounds}", print::sizes(&built)))?;
    }
    Ok(code)
}
