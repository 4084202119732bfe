//! Lines and points of a scene.

use super::line::{MOST_POINTS, layout_line};
use super::links::RigidBar;
use super::model_path::beam_path;
use super::place::{Layout, LayoutLine};
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use super::size::{self, is_special};
use super::supports::HeldPoint;
use crate::case::Case;
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath, positive};
use crate::model::Beam;
use peristat_assembly::model::timoshenko_beam::{
    Axial, BeamParameters, ChainError, Grid, Line, TimoshenkoBeam, VolumeFactor,
    end_treatment::{self, EndSupport},
};

/// The lines with their horizons.
pub(super) fn layout(
    case: &Case,
    model: &Beam,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Layout> {
    let graded: usize = match &case.body {
        crate::case::Body::Frame(frame) => {
            let members = frame.members.iter().filter(|m| m.grading.is_some());
            members.fold(0, |sum, member| sum.saturating_add(member.cells))
        }
        body => {
            let lines = body.lines().iter().filter(|line| line.grading.is_some());
            lines.fold(0, |sum, line| sum.saturating_add(line.cells))
        }
    };
    if !size::check_graded(graded, max_memory, faults) {
        return None;
    }
    let treatment = end_treatment::find(model.end_treatment.as_deref()?)?;
    if let crate::case::Body::Frame(frame) = &case.body {
        return super::frame::layout(case, frame, treatment, faults);
    }
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
        } else if line.grid == Grid::Cells && line.grading.is_some() {
            faults
                .error(path(k).key("grading"), "a graded grid has its points on the ends of its cells")
                .hint("use the grid `nodes`");
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
    // Every line is looked at: all faults come in one report.
    let lines: Vec<Option<LayoutLine>> =
        lines.iter().enumerate().map(|(k, line)| layout_line(case, line, &path(k), faults)).collect();
    let lines: Option<Vec<LayoutLine>> = lines.into_iter().collect();
    Some(Layout { lines: lines?, treatment, frame: None })
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
    layout: &Layout,
    parameters: BeamParameters,
    sections: &[Resolved],
    splits: Vec<Vec<usize>>,
    ends: Vec<[EndSupport; 2]>,
    axial: Vec<Axial>,
    faults: &mut Faults,
) -> Option<TimoshenkoBeam> {
    let given = layout.lines.iter().zip(sections).zip(splits).zip(ends.into_iter().zip(axial)).enumerate();
    let lines = given.map(|(k, (((l, section), splits), (supports, axial)))| Line {
        from: l.from,
        grid: l.grid,
        stations: l.stations.clone(),
        horizon_ratio: l.horizon_ratio,
        splits,
        supports,
        origin: layout.origin(k),
        direction: layout.direction(k),
        axial,
        ..Line::new(l.length, l.cells, section.stiffness.clone())
    });
    let needs_cover = layout.frame.is_some() || layout.lines.iter().zip(sections).any(is_special);
    match TimoshenkoBeam::new(parameters, lines.collect()) {
        Ok(beam) => Some(beam),
        Err(error @ ChainError::NegativeWeight { .. }) => {
            let hint = match parameters.volume_factor {
                VolumeFactor::Full if needs_cover => "full volumes are too stiff to correct: use `half_edge`",
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
