//! Lines and points of a scene.

use super::loads::ResolvedLoads;
use super::material::{beam_path, positive};
use super::place::{Layout, LayoutLine};
use super::{HeldPoint, RigidBar, root};
use crate::case::{Case, Model};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, ChainError, Grid, Line, TimoshenkoBeam, VolumeFactor,
    end_treatment::{self, EndSupport},
};

/// Largest number of points: they are numbered by 32 bits.
const MOST_POINTS: usize = 2_000_000_000;

/// The lines with their horizons.
pub(super) fn layout(case: &Case, faults: &mut Faults) -> Option<Layout> {
    let Model::TimoshenkoBeam(beam) = &case.model;
    let treatment = end_treatment::find(beam.end_treatment.as_deref()?)?;
    let lines = case.body.lines();
    let several = matches!(case.body, crate::case::Body::Lines(_));
    let path = |k: usize| match several {
        true => root("body").key("lines").index(k),
        false => root("body").key("line"),
    };
    if lines.is_empty() {
        faults.error(root("body").key("lines"), "the body has no lines");
        return None;
    }
    let mut fine = true;
    for (k, line) in lines.iter().enumerate() {
        fine &= positive(line.length, "length", path(k).key("length"), faults);
        if line.cells == 0 || line.cells > MOST_POINTS {
            let limit = if line.cells == 0 { "at least 1".into() } else { format!("at most {MOST_POINTS}") };
            faults.error(path(k).key("cells"), format!("`cells` must be {limit}, found {}", line.cells));
            fine = false;
        } else if line.grid == Grid::Cells && line.cells < 2 {
            faults.error(path(k).key("cells"), "a grid of cells needs at least 2 of them to have a bond");
            fine = false;
        } else if fine && line.from + line.length / line.cells as f64 == line.from {
            faults.error(
                path(k).key("from"),
                "`from` is so large that neighbouring points have the same position",
            );
            fine = false;
        }
    }
    fine &= apart(lines, path, faults);
    if !fine {
        return None;
    }
    let lines = lines.iter().map(|line| {
        let spacing = line.length / line.cells as f64;
        let horizon_ratio = horizon_ratio(case, spacing, faults)?;
        let (from, length, cells, grid) = (line.from, line.length, line.cells, line.grid);
        Some(LayoutLine { from, length, cells, grid, horizon_ratio })
    });
    let lines: Vec<LayoutLine> = lines.collect::<Option<_>>()?;
    Some(Layout { lines, treatment })
}

/// Lines must not touch: a position says which one is meant.
fn apart(lines: &[crate::case::Line], path: impl Fn(usize) -> JsonPath, faults: &mut Faults) -> bool {
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|&a, &b| lines[a].from.total_cmp(&lines[b].from));
    let mut fine = true;
    for pair in order.windows(2) {
        let (a, b) = (&lines[pair[0]], &lines[pair[1]]);
        if a.from + a.length >= b.from {
            faults
                .error(
                    path(pair[1]),
                    format!(
                        "this line starts at x = {}, where another one ends at {}",
                        b.from,
                        a.from + a.length
                    ),
                )
                .hint("make lines that meet one line; leave a gap between lines that a link joins");
            fine = false;
        }
    }
    fine
}

fn horizon_ratio(case: &Case, spacing: f64, faults: &mut Faults) -> Option<f64> {
    let (ratio, key, found) = match (case.horizon_ratio, case.horizon) {
        (Some(_), Some(_)) => {
            faults
                .error(root("horizon"), "`horizon_ratio` and `horizon` are both given")
                .hint("the horizon is horizon_ratio times the spacing: remove one");
            return None;
        }
        (None, Some(horizon)) => (
            horizon / spacing,
            "horizon",
            format!("the horizon {horizon} is shorter than the spacing {spacing}"),
        ),
        (ratio, None) => {
            let ratio = ratio.unwrap_or(3.0);
            (ratio, "horizon_ratio", format!("`horizon_ratio` must be at least 1, found {ratio}"))
        }
    };
    if !ratio.is_finite() || ratio < 1.0 - 1e-9 {
        faults
            .error(root(key), format!("{found}, so no point has a bond"))
            .hint("use 3 spacings, the usual choice");
        return None;
    }
    if ratio > 2e3 {
        faults
            .error(root(key), format!("a horizon of {ratio} spacings has too many bonds per point"))
            .hint("the largest horizon ratio is 2000; more than 12 never pays");
        return None;
    }
    Some(ratio)
}

/// Points that no bond may span: interior supports, ends of links and point loads.
pub(super) fn splits(
    layout: &Layout,
    held: &[HeldPoint],
    bars: &[RigidBar],
    cases: &[ResolvedLoads],
) -> Vec<Vec<usize>> {
    let mut splits = vec![Vec::new(); layout.lines.len()];
    let held = held.iter().filter_map(|h| h.local);
    let bars = bars.iter().flat_map(|b| [b.from, b.to]);
    let loads = cases.iter().flat_map(|c| c.splits.iter().copied());
    for (chain, point) in held.chain(bars).chain(loads) {
        if point > 0 && point + 1 < layout.lines[chain].points() {
            splits[chain].push(point);
        }
    }
    for list in &mut splits {
        list.sort_unstable();
        list.dedup();
    }
    splits
}

/// The discretised beam.
pub(super) fn build(
    case: &Case,
    layout: &Layout,
    parameters: BeamParameters,
    stiffness: &SectionStiffness,
    splits: Vec<Vec<usize>>,
    ends: Vec<[EndSupport; 2]>,
    faults: &mut Faults,
) -> Option<TimoshenkoBeam> {
    let lines = layout.lines.iter().zip(splits).zip(ends).map(|((l, splits), supports)| Line {
        from: l.from,
        grid: l.grid,
        horizon_ratio: l.horizon_ratio,
        splits,
        supports,
        ..Line::new(l.length, l.cells, stiffness.clone())
    });
    let Model::TimoshenkoBeam(beam) = &case.model;
    match TimoshenkoBeam::new(parameters, lines.collect()) {
        Ok(beam) => Some(beam),
        Err(error @ ChainError::NegativeWeight { .. }) => {
            let hint = match beam.volume_factor {
                VolumeFactor::Full => {
                    "full volumes are too stiff for `cover` to correct: use `half_edge`, or the end treatment `ghost`"
                }
                VolumeFactor::HalfEdge => "use a whole `horizon_ratio`",
            };
            faults.error(beam_path().key("volume_factor"), error.to_string()).hint(hint);
            None
        }
    }
}
