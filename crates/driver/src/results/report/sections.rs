//! The parts of a report, from the top: what decides, what was found, what it rests on, and what it took.

use super::super::any_curve::AnyCurve;
use super::{chart, over_displacement};
use crate::case::Case;
use crate::output::report::{Bar, Block, Cell, Chart, Column, Map, Section, Table, Tone, number, typeset};
use crate::run::Certificate;
use crate::summary::words::{self, Fact, Listing};
use crate::summary::{StateSummary, Status, Summary};

/// Probed values of all states that are listed, at most; of more those of the last state.
const MOST_PROBES: usize = 60;

/// Figures of states.
pub(super) struct Found {
    /// All states of a body in the plane.
    pub(super) map: Option<Map>,
    /// Every how many states the map shows one.
    pub(super) stride: usize,
    /// Other figures of states by their number.
    pub(super) states: Vec<(usize, Vec<Block>)>,
}

/// What the equilibria are drawn as; `rows` are those of the states among them.
pub(super) fn curves(case: &Case, curve: &AnyCurve, history: &[Vec<f64>], rows: &[usize]) -> Vec<Chart> {
    let charts = curve.diagrams(case).into_iter().map(|diagram| {
        let points = diagram.series.first().map_or(&[][..], |series| &series.points);
        // A curve may begin before the first equilibrium, where nothing acts.
        let before = points.len().checked_sub(curve.rows());
        // A path that gets stuck reports its last state before it records it.
        let last = curve.rows().saturating_sub(1);
        let mark = |row: &usize| before.and_then(|before| points.get(before + row.min(&last)).copied());
        let marks = rows.iter().map_while(mark).collect();
        Chart { marks, ..chart("", diagram) }
    });
    charts.chain(over_displacement::chart(case, history, !rows.is_empty())).collect()
}

/// All sections.
pub(super) fn all(summary: &Summary, case: &Case, curves: Vec<Chart>, figures: Found) -> Vec<Section> {
    let mut all = vec![checks(summary)];
    all.push(Section::new("Model", vec![facts(words::model(summary))]));
    if let Some(told) = words::course(summary) {
        let curves = curves.into_iter().map(Block::Chart);
        let title = if summary.path.is_some() { "Path" } else { "Breaking" };
        all.push(Section::new(title, curves.chain([facts(told)]).collect()));
    }
    all.push(Section::new("Results", results(summary, figures)));
    all.extend(probes(summary));
    all.push(Section::new("Certificate of the discrete solution", certificate(summary)));
    if let Some((sentence, table)) = words::estimates(summary) {
        let table = table.into_iter().flat_map(listed);
        all.push(Section::new(
            "Error of the grid",
            std::iter::once(Block::Text(sentence)).chain(table).collect(),
        ));
    }
    all.push(Section::new("Time and work", work(summary)));
    let text = serde_json::to_string_pretty(case).unwrap_or_default();
    all.push(Section { title: "Case".into(), blocks: vec![Block::Code(text)], folded: true });
    all
}

fn facts(facts: Vec<Fact>) -> Block {
    Block::Facts(facts.into_iter().map(|(name, text)| (name, typeset(&text))).collect())
}

/// A table of the record. Columns of numbers stand to the right; names keep their digits.
fn table(listing: Listing) -> Table {
    let is_number = |cell: &str| cell.is_empty() || cell.parse::<f64>().is_ok();
    let numbers = |k: usize| k > 0 && listing.rows.iter().all(|row| is_number(&row[k]));
    let columns = listing.header.iter().enumerate();
    let columns = columns.map(|(k, title)| Column { title: title.clone(), numbers: numbers(k) }).collect();
    let set = |(k, cell): (usize, &String)| match cell.parse::<f64>() {
        Ok(value) if k > 0 => number(value).into(),
        _ if k > 0 && cell.starts_with('(') => typeset(cell).into(),
        _ => cell.as_str().into(),
    };
    let rows = listing.rows.iter().map(|row| row.iter().enumerate().map(set).collect()).collect();
    Table { title: String::new(), columns, rows }
}

/// A table, and where the rest of it is.
fn listed(listing: Listing) -> Vec<Block> {
    let more = listing.more.clone().map(Block::Text);
    std::iter::once(Block::Table(table(listing))).chain(more).collect()
}

/// The checks, warnings, and whether the numbers can be used at all.
fn checks(summary: &Summary) -> Section {
    let mut blocks = Vec::new();
    if summary.status == Status::NotConverged {
        let text = "Not converged: the certificate shows how far it is. Do not use these numbers.";
        blocks.push(Block::Notice(Tone::Bad, text.into()));
    }
    if let Some(how_far) = &summary.interrupted {
        let text = format!("Interrupted {how_far}: all that is shown is of the run so far.");
        blocks.push(Block::Notice(Tone::Bad, text));
    }
    if summary.checks.is_empty() {
        blocks.push(Block::Text("The case has no checks.".into()));
    } else {
        let mut table = table(words::checks(&summary.checks));
        // The outcome stands second, where narrow windows show it.
        let outcome = table.columns.len() - 1;
        table.columns[1..=outcome].rotate_right(1);
        table.columns.push(Column::words("against"));
        for (row, check) in table.rows.iter_mut().zip(&summary.checks) {
            // Not rounded to one digit, so that an error can be distinguished from its tolerance.
            row[outcome - 1] = number(check.tolerance).into();
            row[outcome].tone = if check.passed { Tone::Good } else { Tone::Bad };
            row[1..=outcome].rotate_right(1);
            row.push(check.source.as_str().into());
        }
        blocks.push(Block::Table(table));
    }
    blocks.extend(summary.warnings.iter().map(|text| Block::Notice(Tone::Plain, format!("Warning: {text}"))));
    Section::new("Checks", blocks)
}

/// The figures and tables of states, and their envelope.
fn results(summary: &Summary, Found { map, stride, states: figures }: Found) -> Vec<Block> {
    let mut blocks = Vec::new();
    let (shown, states) = (figures.len(), summary.states.len());
    let of_map = match stride {
        1 => format!("The map has all {states} states"),
        _ => format!(
            "Of {states} states the map has one in {stride}, and the last one, so that the page stays small"
        ),
    };
    let told = match (&map, shown < states) {
        (None, false) => None,
        (None, true) => Some(format!("Of {states} states this is the last one; `fields` has all of them.")),
        (Some(_), false) => (stride > 1).then(|| format!("{of_map}; `fields` has all of them.")),
        (Some(_), true) => Some(format!(
            "{of_map}; the tables below it are those of the last one. `fields` has all of them."
        )),
    };
    blocks.extend(told.map(Block::Text));
    blocks.extend(map.map(Block::Map));
    let sets = figures.into_iter().filter_map(|(index, mut set)| {
        let state = summary.states.get(index)?;
        set.extend(listed(words::extremes(state)));
        set.extend(words::forces(state, summary.units).into_iter().flat_map(listed));
        Some((state.name.clone(), set))
    });
    blocks.push(Block::Choice("State".into(), sets.collect()));
    if let Some(envelope) = words::envelope(summary) {
        blocks.push(Block::Text("Smallest and largest values over all load cases and combinations:".into()));
        blocks.push(Block::Table(table(envelope)));
    }
    blocks
}

fn probes(summary: &Summary) -> Option<Section> {
    let last = summary.states.last()?;
    let is_traced = summary.fracture.is_some() || summary.path.is_some();
    let only_last = is_traced || summary.probes.len() > MOST_PROBES;
    let kept = summary.probes.iter().filter(|p| !only_last || p.state == last.name);
    let mut blocks = listed(words::probes(kept, &words::number));
    if only_last && summary.states.len() > 1 {
        blocks.push(Block::Text("Those of the last state; `history.csv` has all of them.".into()));
    }
    (!summary.probes.is_empty()).then(|| Section::new("Probes", blocks))
}

/// What makes the numbers credible, in words and numbers.
fn certificate(summary: &Summary) -> Vec<Block> {
    let states = &summary.states;
    let largest = |of: &dyn Fn(&Certificate) -> f64| {
        // A number that is none is the worst of all.
        states.iter().map(|s| of(&s.certificate)).fold(0.0, |a: f64, b| if b.is_nan() { b } else { a.max(b) })
    };
    let row = |name: String, value: f64, meaning: &str| -> Vec<Cell> {
        vec![name.into(), typeset(&format!("{value:.1e}")).into(), meaning.into()]
    };
    let correction = match summary.path {
        Some(_) => ("equilibrium", "forces out of balance, over the reference force"),
        None => ("next correction", "what one more solve would change, over the largest unknown"),
    };
    let mut rows = vec![
        row(
            "error".into(),
            largest(&|c| c.error),
            "bound on the error of displacements by rounding and iteration",
        ),
        row(
            "error of strains".into(),
            largest(&|c| c.strain_error),
            "the same of strains, stresses and forces",
        ),
        row(correction.0.into(), largest(&|c| c.next_correction), correction.1),
        row(
            "residual".into(),
            largest(&|c| c.residual),
            "largest force out of balance, over the largest of a bond",
        ),
    ];
    let motions = states.last().map_or(&[][..], |s| &s.certificate.balance);
    rows.extend(motions.iter().enumerate().map(|(k, b)| {
        let value = largest(&|c| c.balance.get(k).map_or(0.0, |b| b.relative));
        row(format!("balance of {}", b.motion), value, "loads against reactions, over the sum of their sizes")
    }));
    rows.push(row(
        "energy".into(),
        largest(&|c| c.energy_balance),
        "stored energy against the work of what acts",
    ));
    let columns = vec![Column::words("number"), Column::numbers("value"), Column::words("what it is")];
    let table = Table { title: String::new(), columns, rows };
    vec![Block::Text(outcome(states)), Block::Table(table)]
}

/// Whether states converged, in a sentence.
fn outcome(states: &[StateSummary]) -> String {
    let lost = states.iter().filter(|s| !s.certificate.converged).count();
    match (lost, states.len()) {
        (0, 1) => "Converged: the answer satisfies the equations, as far as these numbers say.".into(),
        (0, n) => format!("All {n} states converged. The worst of all states:"),
        (_, 1) => "Not converged.".into(),
        (lost, n) => format!("{lost} of {n} states did not converge. The worst of all states:"),
    }
}

/// Where the time went, and how much of what was done and spared.
fn work(summary: &Summary) -> Vec<Block> {
    let t = &summary.timing_s;
    let stages = [
        ("assemble", t.assemble),
        ("factor", t.factor),
        ("solve", t.solve),
        ("certify", t.certify),
        ("record", t.record),
        ("estimate", t.estimate),
    ];
    let bar = |(name, value): (&str, f64)| Bar { name: name.into(), value, text: seconds(value) };
    let c = &summary.counters;
    let mut told: Vec<Fact> = vec![
        ("factorisations".into(), c.factorisations.to_string()),
        ("right-hand sides".into(), c.right_hand_sides.to_string()),
        ("PCG iterations".into(), c.pcg_iterations.to_string()),
        ("bond evaluations".into(), number(c.bond_evaluations as f64)),
    ];
    if let Some(bytes) = summary.peak_memory_bytes {
        told.push(("memory".into(), format!("{} MB at most", number((bytes as f64 / 1e5).round() / 10.0))));
    }
    let mut blocks = vec![Block::Bars(stages.map(bar).into()), Block::Facts(told)];
    if !summary.skipped.is_empty() {
        blocks.push(Block::Text("What this case was spared:".into()));
        blocks.push(Block::List(summary.skipped.iter().map(|text| typeset(text)).collect()));
    }
    blocks
}

fn seconds(value: f64) -> String {
    if value < 0.1 { format!("{:.1} ms", 1e3 * value) } else { format!("{value:.2} s") }
}
