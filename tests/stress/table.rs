//! The table of the suite.

use crate::outcome::Outcome;
use crate::row::Row;
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
    /// Fewest digits of an answer that is given.
    digits: f64,
}

/// The page of the documentation.
pub(crate) fn page(solved: &[(Row, Outcome)]) -> String {
    let lines = lines(solved);
    let mut text = String::from(HEAD);
    let refused: usize = lines.iter().map(|l| l.refused).sum();
    let doubted: usize = lines.iter().map(|l| l.doubted).sum();
    let _ = writeln!(
        text,
        "{} rows: {} answers given, {refused} refused as input, {doubted} refused by their certificate, {} wrong by more than they say.\n",
        solved.len(),
        solved.len() - refused - doubted,
        solved.iter().filter(|(_, outcome)| outcome.lie().is_some()).count(),
    );
    text.push_str("| model | at its extremes | rows | refused | no digits | worst error | its bound | error / bound, worst | fewest digits | worst at |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---|\n");
    for line in &lines {
        let Line { model, sweep, rows, refused, doubted, worst: [error, bound], worst_at, .. } = line;
        let _ = writeln!(
            text,
            "| {model} | {sweep} | {rows} | {refused} | {doubted} | {error:.0e} | {bound:.0e} | {:.0e} | {:.0} | {worst_at} |",
            line.closest, line.digits
        );
    }
    text.push_str("\nReasons of refusal\n\n");
    for (reason, count) in reasons(solved) {
        let _ = writeln!(text, "* {count}: {reason}");
    }
    text
}

const HEAD: &str = "<!-- Written by the stress suite. -->\n\n";

fn lines(solved: &[(Row, Outcome)]) -> Vec<Line<'_>> {
    let mut lines: Vec<Line> = Vec::new();
    for (row, outcome) in solved {
        let known = lines.iter().position(|l| l.model == row.model && l.sweep == row.sweep);
        let k = known.unwrap_or_else(|| {
            lines.push(Line::new(row));
            lines.len() - 1
        });
        lines[k].take(row, outcome);
    }
    lines
}

impl<'a> Line<'a> {
    fn new(row: &'a Row) -> Self {
        Self {
            model: row.model,
            sweep: row.sweep,
            rows: 0,
            refused: 0,
            doubted: 0,
            worst: [0.0; 2],
            worst_at: "",
            closest: 0.0,
            digits: f64::INFINITY,
        }
    }

    fn take(&mut self, row: &'a Row, outcome: &Outcome) {
        self.rows += 1;
        match outcome {
            Outcome::Refused(_) => self.refused += 1,
            Outcome::Told(told) if !told.given => self.doubted += 1,
            Outcome::Told(told) => {
                if told.errors[0] >= self.worst[0] {
                    (self.worst, self.worst_at) = ([told.errors[0], told.bounds[0]], &row.at);
                }
                let ratios = told.errors.iter().zip(told.bounds).map(|(error, bound)| error / bound);
                self.closest = ratios.fold(self.closest, f64::max);
                self.digits = self.digits.min(-told.bounds[0].log10().floor() - 1.0);
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
