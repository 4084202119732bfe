//! How far a run has come: a line on a terminal that is kept up to date, or a line now and then.

use super::args::Global;
use super::note;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use peristat::run::Advance;
use peristat::run::fracture::Event;
use peristat::run::path::PathPoint;
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

/// Time between two lines where there is no terminal: a log of hours stays short.
const SELDOM: Duration = Duration::from_secs(60);
/// The same where more is asked for.
const OFTEN: Duration = Duration::from_secs(10);
/// Time between two turns of the mark that shows that a long solve is alive.
const TICK: Duration = Duration::from_millis(200);

/// Shows how far a run has come.
#[derive(Debug, Default)]
pub(super) enum Progress {
    /// Shows nothing.
    #[default]
    Silent,
    /// A line on stderr now and then.
    Lines {
        /// The last line, or the start.
        last: Instant,
        /// Time from one to the next.
        pause: Duration,
    },
    /// A line on the terminal with a mark that turns. How many equilibria there will be is not known, so that there is no
    /// bar to fill.
    Terminal(ProgressBar),
}

/// A bar over tasks, on a terminal only.
pub(super) fn of_tasks(global: &Global, count: usize) -> ProgressBar {
    if global.quiet || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    ProgressBar::with_draw_target(Some(count as u64), ProgressDrawTarget::stderr())
}

impl Progress {
    /// As it was asked for, on stderr.
    pub(super) fn new(global: &Global) -> Self {
        Self::choose(global, io::stderr().is_terminal())
    }

    fn choose(global: &Global, terminal: bool) -> Self {
        match (terminal, global.quiet, global.verbose) {
            (_, true, _) => Self::Silent,
            (false, false, verbose) => {
                Self::Lines { last: Instant::now(), pause: if verbose { OFTEN } else { SELDOM } }
            }
            (true, false, _) => {
                let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {wide_msg}") {
                    bar.set_style(style);
                }
                bar.enable_steady_tick(TICK);
                Self::Terminal(bar)
            }
        }
    }

    /// An equilibrium was found.
    pub(super) fn advance(&mut self, event: Advance<'_>) {
        match self {
            Self::Silent => {}
            Self::Lines { last, pause } => {
                if last.elapsed() >= *pause {
                    *last = Instant::now();
                    note(&format!("{}\n", line(event)));
                }
            }
            Self::Terminal(bar) => bar.set_message(line(event)),
        }
    }
}

impl Drop for Progress {
    /// Leaves a terminal as if nothing had been shown, whatever ended the run.
    fn drop(&mut self) {
        if let Self::Terminal(bar) = self {
            bar.finish_and_clear();
        }
    }
}

/// An equilibrium in a line.
fn line(event: Advance<'_>) -> String {
    match event {
        Advance::Break(event) => of_break(event),
        Advance::Path(point) => of_path(point),
    }
}

fn of_path(point: &PathPoint) -> String {
    let PathPoint { step, load_factor, load, softened, broken, .. } = point;
    format!(
        "step {step}: load factor {load_factor:.4e}, load {load:.4e}, {softened} bonds soften, {broken} failed"
    )
}

fn of_break(event: &Event) -> String {
    let Event { step, solve, load_factor, load, broken, island_points, .. } = event;
    let off = if *island_points > 0 { format!(", {island_points} points off") } else { String::new() };
    format!(
        "step {step}, solve {solve}: load factor {load_factor:.4e}, load {load:.4e}, {broken} bonds broken{off}"
    )
}

#[cfg(test)]
mod tests {
    use super::super::args::Arguments;
    use super::*;
    use clap::Parser;

    fn chosen(flags: &[&str], terminal: bool) -> Progress {
        let arguments = ["peristat", "list"].iter().chain(flags);
        Progress::choose(&Arguments::try_parse_from(arguments).unwrap().global, terminal)
    }

    #[test]
    fn a_log_has_a_line_a_minute_and_more_if_asked_for() {
        assert!(matches!(chosen(&[], false), Progress::Lines { pause: SELDOM, .. }));
        assert!(matches!(chosen(&["-q"], false), Progress::Silent));
        assert!(matches!(chosen(&["-q"], true), Progress::Silent));
        assert!(matches!(chosen(&["-v"], false), Progress::Lines { pause: OFTEN, .. }));
        assert!(matches!(chosen(&[], true), Progress::Terminal(_)));
        assert!(matches!(Progress::default(), Progress::Silent));
    }

    #[test]
    fn lines_come_after_a_pause() {
        let mut progress = chosen(&["-v"], false);
        let Progress::Lines { last: before, pause } = progress else { panic!("{progress:?}") };
        progress.advance(Advance::Break(&Event::default()));
        assert!(matches!(progress, Progress::Lines { last, .. } if last == before));
        progress = Progress::Lines { last: before.checked_sub(pause).unwrap(), pause };
        progress.advance(Advance::Break(&Event::default()));
        assert!(matches!(progress, Progress::Lines { last, .. } if last > before));
    }

    #[test]
    fn a_line_says_where_the_run_is() {
        let event =
            Event { step: 3, solve: 41, load_factor: 1.5, load: -2e4, broken: 12, ..Event::default() };
        assert_eq!(
            of_break(&event),
            "step 3, solve 41: load factor 1.5000e0, load -2.0000e4, 12 bonds broken"
        );
        assert!(of_break(&Event { island_points: 5, ..event }).ends_with("12 bonds broken, 5 points off"));
    }
}
