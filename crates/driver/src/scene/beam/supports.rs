//! Supports of a scene: which points and ends of lines they hold.

use super::frame_place::{self, FramePlace};
use super::holds::{Hold, holds};
use super::place::{Layout, Place};
use crate::case::{Case, Support, number};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath};
use crate::reference::End;
use peristat_assembly::model::timoshenko_beam::end_treatment::{EndKind, EndSupport};

/// A place that a support holds.
#[derive(Clone, Debug)]
pub struct HeldPoint {
    /// Position on its line.
    pub x: f64,
    /// Line, and real point on it where the support acts on a point.
    pub local: Option<(usize, usize)>,
    /// Number of the point; `None` where ghost points hold the end of a line.
    pub point: Option<usize>,
    /// What closed forms call it on a line.
    pub kind: End,
    /// Everything that is held on a point.
    pub holds: Vec<Hold>,
    /// What the user calls the place.
    pub name: String,
    /// Where it stands in the case.
    pub path: JsonPath,
}

impl HeldPoint {
    /// The same with the numbers of its points and the unknowns of its holds; `first` are the numbers of the first real
    /// points of the lines.
    pub(super) fn numbered(mut self, first: &[usize], layout: &Layout, has_axial: bool) -> Self {
        self.point = self.local.map(|(chain, k)| first[chain] + k);
        for hold in &mut self.holds {
            hold.point = first[hold.local.0] + hold.local.1;
            hold.terms = hold.motion.terms(layout.direction(hold.local.0), has_axial);
        }
        self
    }
}

const BEAM_EXAMPLE: &str = r#"a clamped end is { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, a simple support { "at": { "x": 0.0 }, "w": 0.0 }"#;
const FRAME_EXAMPLE: &str = r#"a clamp is { "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }; a pin gives `ux` and `uy`, a roller one of them"#;

/// Held points, and what holds the ends of every line.
pub(super) fn held(
    case: &Case,
    layout: &Layout,
    faults: &mut Faults,
) -> (Vec<HeldPoint>, Vec<[EndSupport; 2]>) {
    let mut ends = vec![[EndSupport::default(); 2]; layout.lines.len()];
    let mut held = Vec::new();
    if case.supports.is_empty() && case.foundation.is_empty() {
        let (message, hint) = match &layout.frame {
            None => ("nothing holds the beam: `supports` is empty", BEAM_EXAMPLE),
            Some(_) => ("nothing holds the frame: `supports` is empty", FRAME_EXAMPLE),
        };
        faults.error(root("supports"), message).hint(hint).in_solution_only();
    }
    for (k, support) in case.supports.iter().enumerate() {
        let path = root("supports").index(k);
        super::support_keys::check(support, layout.frame.is_some(), &path, faults);
        let found = frame_place::find(&support.at, layout, &path.key("at"), "the support", faults);
        let held_point = found.and_then(|spot| hold(support, spot, layout, &mut ends, &path, faults));
        held.extend(held_point);
    }
    (held, ends)
}

/// What a support holds at the place that was found for it.
fn hold(
    support: &Support,
    spot: FramePlace,
    layout: &Layout,
    ends: &mut [[EndSupport; 2]],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<HeldPoint> {
    let x = support.at.x.unwrap_or(0.0);
    let mut held = HeldPoint {
        x,
        local: None,
        point: None,
        kind: kind(support),
        holds: Vec::new(),
        name: layout.words(spot, x),
        path: path.clone(),
    };
    match spot {
        FramePlace::Joint(joint) => {
            let joint = &layout.frame.as_ref()?.joints[joint];
            let (first, turning) = (layout.end(joint.first()), joint.turning().map(|e| layout.end(e)));
            let turns = [("phi", support.phi.is_some()), ("phi_spring", support.phi_spring.is_some())];
            for (key, _) in turns.iter().filter(|(_, given)| *given && turning.is_none()) {
                let place = layout.example(joint.first());
                faults
                    .error(
                        path.key(*key),
                        format!(
                            "all members are hinged at the joint `{}`, so `{key}` holds nothing",
                            joint.name
                        ),
                    )
                    .hint(format!("to hold the rotation of one member give its end as the place: {place}"));
            }
            held.holds = holds(support, first, turning.unwrap_or(first));
            held.local = Some(first);
        }
        FramePlace::On(Place::Point { chain, point }) => {
            let last = layout.lines[chain].points() - 1;
            for (side, end) in [0, last].into_iter().enumerate() {
                if point == end {
                    hold_end(&mut ends[chain][side], support);
                }
            }
            held.holds = holds(support, (chain, point), (chain, point));
            held.local = Some((chain, point));
        }
        FramePlace::On(Place::End { chain, side }) if layout.treatment.name != "truncated" => {
            hold_end(&mut ends[chain][side], support);
            check_end(support, layout, &ends[chain][side], path, faults);
        }
        FramePlace::On(Place::End { chain, .. } | Place::Between { chain, .. }) => {
            layout.needs_point(chain, x, &path.key("at").key("x"), "the support", faults);
            return None;
        }
    }
    Some(held)
}

/// What closed forms call a support; they know no springs, no settlements and nothing that acts one way.
fn kind(support: &Support) -> End {
    let [w, phi] = [&support.w, &support.phi].map(|given| number(given.as_ref()));
    if support.only.is_some() {
        return End::Other;
    }
    match (w, phi, support.w_spring.or(support.phi_spring)) {
        (Some(0.0), Some(0.0), None) => End::Clamped,
        (Some(0.0), None, None) => End::Simple,
        (None, Some(0.0), None) => End::Guided,
        _ => End::Other,
    }
}

fn hold_end(end: &mut EndSupport, support: &Support) {
    end.w = number(support.w.as_ref()).or(end.w);
    end.phi = number(support.phi.as_ref()).or(end.phi);
}

/// What ghost points beyond an end cannot hold.
fn check_end(support: &Support, layout: &Layout, end: &EndSupport, path: &JsonPath, faults: &mut Faults) {
    let kind = (layout.treatment.end)(end);
    if kind == EndKind::Mirrored && support.w.is_some() && support.phi.is_some() {
        faults
            .error(path.clone(), "images prescribe the rotation of an end, and a grid of cells has no point there to hold its deflection")
            .hint("use the grid `nodes`, or the end treatment `ghost`");
    }
    if support.w_spring.is_some() || support.phi_spring.is_some() || support.ux_spring.is_some() {
        faults
            .error(path.clone(), "a spring needs a point, and a grid of cells has none on its end")
            .hint("use the grid `nodes`");
    }
    if support.only.is_some() {
        faults
            .error(
                path.key("only"),
                "a support that acts one way needs a point, and a grid of cells has none on its end",
            )
            .hint("use the grid `nodes`");
    }
    if support.ux.is_some() {
        faults
            .error(path.key("ux"), "`ux` needs a point, and a grid of cells has none on its end")
            .hint("use the grid `nodes`");
    }
}
