//! The table of the suite.

use crate::stress::outcome::Outcome;
use crate::stress::row::Row;
use std::fmt::Write;

/// What one sweep of a model came to.
struct Line<'a> {
    model: &'a str,
    sweep: &'a str,
    rows: usize,
    refused: usize,
    doubted: usize,
    /// Largest error of an answer that is given, and what its certificate said.
    worst: [f64; 2],
    worst_at: &'a str,
    /// Largest error over its bound.
    closest: f64,
    /// Fewest digits of displacements of an answer that is given.
    digits: f64,
}

/// The page of the documentation.
pub(crate) fn page(solved: &[(Row, Outcome)]) -> String {
    let (models, sweeps) = (lines(solved, |_| ""), lines(solved, |row| row.sweep));
    let [refused, doubted] =
        [|l: &Line| l.refused, |l: &Line| l.doubted].map(|of| models.iter().map(of).sum::<usize>());
    let lies = solved.iter().filter(|(row, outcome)| outcome.lie(row.wish).is_some()).count();
    let mut text = format!(
        "<!-- Written by the stress suite: UPDATE_EXPECTED=1 cargo test --release --test verification -- --ignored stress:: -->\n\n\
         {} rows: {} answers, {refused} refused before they are solved, {doubted} refused by their certificate (exit code 1), \
         {lies} wrong by more than they say.\n\n",
        solved.len(),
        solved.len() - refused - doubted,
    );
    text.push_str("## Worst of every model\n\n| model | rows | refused | no digits | worst error | its bound | error over bound, worst | fewest digits |\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for line in &models {
        let _ = writeln!(text, "| {} | {} |", line.model, line.numbers());
    }
    text.push_str("\n## Every sweep\n\n| model | at its extremes | rows | refused | no digits | worst error | its bound | error over bound, worst | fewest digits | worst at |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---|\n");
    for line in &sweeps {
        let _ =
            writeln!(text, "| {} | {} | {} | {} |", line.model, line.sweep, line.numbers(), line.worst_at);
    }
    text.push_str("\n## Reasons of refusal\n\n");
    for (reason, count) in reasons(solved) {
        let _ = writeln!(text, "* {count}: {reason}");
    }
    text
}

/// One line for every model and what `part` says of its rows.
fn lines(solved: &[(Row, Outcome)], part: impl Fn(&Row) -> &'static str) -> Vec<Line<'_>> {
    let mut lines: Vec<Line> = Vec::new();
    for (row, outcome) in solved {
        let sweep = part(row);
        let known = lines.iter().position(|l| l.model == row.model && l.sweep == sweep);
        let k = known.unwrap_or_else(|| {
            lines.push(Line::new(row.model, sweep));
            lines.len() - 1
        });
        lines[k].take(row, outcome);
    }
    lines
}

impl<'a> Line<'a> {
    fn new(model: &'a str, sweep: &'a str) -> Self {
        Self {
            model,
            sweep,
            rows: 0,
            refused: 0,
            doubted: 0,
            worst: [0.0; 2],
            worst_at: "",
            closest: 0.0,
            digits: f64::INFINITY,
        }
    }

    /// Its numbers, as cells of a table.
    fn numbers(&self) -> String {
        let Self { rows, refused, doubted, worst: [error, bound], closest, digits, .. } = self;
        let digits = if digits.is_finite() { format!("{digits:.0}") } else { String::new() };
        format!("{rows} | {refused} | {doubted} | {error:.0e} | {bound:.0e} | {closest:.0e} | {digits}")
    }

    fn take(&mut self, row: &'a Row, outcome: &Outcome) {
        self.rows += 1;
        match outcome {
            Outcome::Refused(_) => self.refused += 1,
            Outcome::Told(told) if !told.given => self.doubted += 1,
            Outcome::Told(told) => {
                if let Some(first) = told.pairs.first().filter(|p| p.error >= self.worst[0]) {
                    (self.worst, self.worst_at) = ([first.error, first.bound], &row.at);
                }
                let ratios = told.pairs.iter().map(|p| p.error / p.bound);
                self.closest = ratios.fold(self.closest, f64::max);
                self.digits = self.digits.min(-told.certified.log10().floor() - 1.0);
            }
            Outcome::Lost(_) => {}
        }
    }
}

/// Reasons of refusal and how often they were given, numbers left out.
fn reasons(solved: &[(Row, Outcome)]) -> Vec<(String, usize)> {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for (_, outcome) in solved {
        let Outcome::Refused(reason) = outcome else { continue };
        let is_number = |word: &&str| !word.chars().any(|c| c.is_ascii_digit());
        let kind = reason.split(' ').filter(is_number).collect::<Vec<_>>().join(" ");
        match reasons.iter_mut().find(|r| r.0 == kind) {
            Some(known) => known.1 += 1,
            None => reasons.push((kind, 1)),
        }
    }
    reasons.sort_by_key(|r| std::cmp::Reverse(r.1));
    reasons
}
