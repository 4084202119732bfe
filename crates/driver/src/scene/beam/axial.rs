//! Whether a scene has axial unknowns, and on which points of its lines something reads them.

use super::frame_layout::FrameLayout;
use super::holds::{How, Motion};
use super::links::RigidBar;
use super::model_path::beam_path;
use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use super::supports::HeldPoint;
use crate::case::{Body, Case, Solver};
use crate::diagnostic::Faults;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{Along, Axial, U};

/// Whether anything moves points along their lines. The members of a frame that is one straight line along x stay where
/// they are unless something pulls them or bending does.
pub(super) fn is_needed(
    layout: &Layout,
    held: &[HeldPoint],
    cases: &[ResolvedLoads],
    sections: &[&SectionStiffness],
) -> bool {
    let on_frame = layout.frame.is_some();
    let pulls = |c: &ResolvedLoads| {
        c.loads.point.iter().any(|p| p.axial != 0.0)
            || c.loads.distributed.iter().any(|d| d.along == Along::Axial)
    };
    let moves = |h: &HeldPoint| {
        h.holds.iter().any(|hold| match hold.motion {
            Motion::Rotation | Motion::Direction([0.0, _]) => false,
            // A straight frame that is only kept from moving along its axis does not.
            Motion::Direction(_) => !(on_frame && hold.how == How::Prescribed(0.0) && hold.is_along_x()),
        })
    };
    let bears_one_way = |frame: &FrameLayout| frame.members.iter().any(|member| member.only.is_some());
    layout.frame.as_ref().is_some_and(|frame| !frame.is_straight() || bears_one_way(frame))
        || cases.iter().any(pulls)
        || held.iter().any(moves)
        || sections.iter().any(|s| s.couples())
}

/// Adds faults where axial unknowns are needed and the case does not allow them.
pub(super) fn check(
    case: &Case,
    layout: &Layout,
    sections: &[Resolved],
    has_axial: bool,
    faults: &mut Faults,
) {
    if !has_axial {
        return;
    }
    if !layout.treatment.covers() && layout.frame.is_none() {
        faults
            .error(
                beam_path().key("end_treatment"),
                format!(
                    "displacements along the beam do not go with the end treatment `{}`",
                    layout.treatment.name
                ),
            )
            .hint("use a grid of `nodes` and `cover`; or remove the axial loads and supports");
    }
    let missing = sections.iter().position(|s| !s.has_axial);
    if let Some(line) = missing {
        let place = match (&case.body, &layout.frame) {
            (Body::Frame(frame), Some(_)) if frame.members[line].stiffness.is_some() => {
                super::frame_layout::path().key("members").index(line).key("stiffness")
            }
            _ => beam_path().key("stiffness"),
        };
        faults
            .error(place, "`axial` is missing: points of this body move along its lines")
            .hint("`axial` is EA, the axial stiffness");
    }
}

/// Where each line has axial unknowns that something reads.
pub(super) fn modes(
    layout: &Layout,
    held: &[HeldPoint],
    bars: &[RigidBar],
    cases: &[ResolvedLoads],
    sections: &[&SectionStiffness],
    case: &Case,
) -> Vec<Axial> {
    // A bar from end to end does not break bond by bond.
    if case.fracture.is_some() {
        return vec![Axial::Points; layout.lines.len()];
    }
    let mut modes = vec![Axial::Ends; layout.lines.len()];
    let inside = |(chain, point): (usize, usize)| point > 0 && point + 1 < layout.lines[chain].points();
    for hold in held.iter().flat_map(|h| &h.holds).filter(|hold| inside(hold.local)) {
        let along = hold.motion.terms(layout.direction(hold.local.0), true).iter().any(|t| t.0 == U);
        if along {
            modes[hold.local.0] = Axial::Points;
        }
    }
    for end in bars.iter().flat_map(|b| [b.from, b.to]).filter(|&end| inside(end)) {
        modes[end.0] = Axial::Points;
    }
    for loads in cases.iter().map(|c| &c.loads) {
        for p in loads.point.iter().filter(|p| p.axial != 0.0) {
            let line = &layout.lines[p.chain];
            let slack = 1e-6 * line.spacing();
            if p.x > line.from + slack && p.x < line.to() - slack {
                modes[p.chain] = Axial::Points;
            }
        }
        for d in loads.distributed.iter().filter(|d| d.along == Along::Axial) {
            modes[d.chain] = Axial::Points;
        }
    }
    for (mode, section) in modes.iter_mut().zip(sections) {
        // A bar from end to end is no band.
        if section.plain().is_none() || case.solver == Solver::Band {
            *mode = Axial::Points;
        }
    }
    modes
}
