//! Going on with the folder of a run that was interrupted.

use super::any_curve::AnyCurve;
use super::being_written::{Results, history_row};
use super::claim::{Claim, MARK};
use super::files::{SUMMARY, is_finished, is_leftover, lost, names_in, step, step_name, sweep, write_case};
use super::kept::FieldFiles;
use super::report::Report;
use super::{report, restart};
use crate::output;
use crate::run::{ProbeResult, Restart};
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
        if !scene.case().is_traced() {
            let reason = "only a run with `fracture` or `path` can be resumed".to_string();
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
        if is_finished(folder) {
            return refuse(ErrorKind::AlreadyExists, format!("the run in {place} is finished"), ANEW);
        }
        let path = folder.join(restart::FILE);
        if !path.exists() {
            return nothing();
        }
        let (restart, digests, _) = restart::read(&path)?;
        if restart.case != scene.fingerprint()? {
            let reason = format!(
                "the run in {place} is of another case, or the case or peristat has been changed since"
            );
            let hint = "resume it with the `case.json` in that folder, or add `--force` in place of `--resume` to run the case anew";
            return refuse(ErrorKind::InvalidInput, reason, hint);
        }
        if let Some(file) = lost(folder, digests.iter().map(|(file, _)| file.clone())) {
            return refuse(ErrorKind::NotFound, format!("{place} has lost `{file}`"), ANEW);
        }
        if let Some((file, _)) = digests.iter().find(|(file, digest)| !digest.is_of(&folder.join(file))) {
            let reason = format!("`{file}` in {place} has been changed since it was written");
            return refuse(ErrorKind::InvalidData, reason, ANEW);
        }
        Ok((claim, restart))
    }

    /// Goes on with the folder of an [interrupted](Self::interrupted) run: what was written after its restart is removed.
    ///
    /// # Errors
    /// The folder cannot be read or written.
    pub fn resume(claim: &Claim, scene: &Scene, restart: &Restart, kept: FieldFiles) -> io::Result<Self> {
        let folder = claim.folder();
        let (_, digests, recorded) = restart::read(&folder.join(restart::FILE))?;
        // The partial report and summary.
        for name in [report::FILE, SUMMARY].map(|name| folder.join(name)) {
            if name.exists() {
                fs::remove_file(name)?;
            }
        }
        // Titles, checks and lines may have changed.
        write_case(folder, scene)?;
        // What is in the tables may have been edited: the restart knows.
        let known = Collector::restore(scene, &restart.summaries)?;
        let states: Vec<(f64, &[ProbeResult])> = known.history().collect();
        let row =
            |(index, (factor, probes)): (usize, &(f64, &[ProbeResult]))| history_row(index, *factor, probes);
        let history: Vec<Vec<f64>> = states.iter().enumerate().map(row).collect();
        let files: BTreeSet<String> = digests.iter().map(|(file, _)| file.clone()).collect();
        let steps = history.iter().enumerate().map(|(index, row)| step(scene, index, row[1]));
        let steps = steps.filter(|(_, grid)| files.contains(grid)).collect();
        remove_others(&folder.join("fields"), restart.recorded, &files)?;
        output::folder::make(&folder.join("plots"))?;
        sweep(folder)?;
        ["fields", "plots"].iter().try_for_each(|part| sweep(&folder.join(part)))?;
        // Lines may have been others.
        let results = Self {
            folder: folder.into(),
            kept,
            digests,
            files: files.into_iter().collect(),
            latest: Vec::new(),
            steps,
            history,
            envelope: None,
            curve: AnyCurve::resume(folder, scene.case(), &restart.from)?,
            report: Report::resume(scene, recorded),
            due: None,
        };
        results.write_collection()?;
        if let Some((_, probes)) = states.last() {
            results.write_history(probes)?;
        }
        Ok(results)
    }
}

/// Removes the files of all states but the first ones, of these the tables and grids of fields that the run does not go on with, and
/// what was being written.
fn remove_others(fields: &Path, recorded: usize, kept: &BTreeSet<String>) -> io::Result<()> {
    output::folder::make(fields)?;
    let states: BTreeSet<String> = (0..recorded).map(step_name).collect();
    for name in names_in(fields)? {
        let state = name.split(['.', '_', '-']).take(2).collect::<Vec<_>>().join("_");
        let is_line = name.split(['.', '_', '-']).count() > 3;
        let is_kept =
            if is_line { states.contains(&state) } else { kept.contains(&format!("fields/{name}")) };
        if is_leftover(&name) || (name.starts_with("step_") && !is_kept) {
            fs::remove_file(fields.join(name))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
