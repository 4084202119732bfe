//! What joins points: rigid bars between lines, and the joints of a frame.

use super::frame_layout::{self, EndOfMember, JointLayout};
use super::frame_place::{self, FramePlace};
use super::one_way::{OneWay, Origin, Part};
use super::place::{Layout, Place};
use crate::case::{At, Case, Link};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::timoshenko_beam::{PHI, U, W};

/// A rigid bar between two points.
#[derive(Clone, Debug)]
pub struct RigidBar {
    /// Line and real point of one end.
    pub from: (usize, usize),
    /// Line and real point of the other end.
    pub to: (usize, usize),
    /// Numbers of the points.
    pub points: [usize; 2],
    /// Signed length.
    pub length: f64,
    /// Where it stands in the case.
    pub path: JsonPath,
}

impl RigidBar {
    /// The same with the numbers of its points.
    pub(super) fn numbered(self, first: &[usize]) -> Self {
        Self { points: [first[self.from.0] + self.from.1, first[self.to.0] + self.to.1], ..self }
    }
}

/// Rigid bars of the case; a frame has none.
pub(super) fn bars(case: &Case, layout: &Layout, faults: &mut Faults) -> Vec<RigidBar> {
    let mut bars = Vec::new();
    if layout.frame.is_some() {
        return bars;
    }
    for (k, link) in case.links.iter().enumerate() {
        let Link::Rigid(link) = link;
        let path = root("links").index(k).key("rigid");
        let mut end = |at: &At, key: &str| {
            let path = path.key(key);
            match frame_place::find(at, layout, &path, "the end of the link", faults)? {
                FramePlace::On(Place::Point { chain, point }) => Some((chain, point)),
                FramePlace::On(Place::End { chain, .. } | Place::Between { chain, .. }) => {
                    let x = at.x.unwrap_or(0.0);
                    layout.needs_point(chain, x, &path.key("x"), "the end of the link", faults);
                    None
                }
                FramePlace::Joint(_) => None,
            }
        };
        let (Some(from), Some(to)) = (end(&link.from, "from"), end(&link.to, "to")) else {
            continue;
        };
        if from == to {
            faults.error(path, "a link joins a point to itself");
            continue;
        }
        let x = |(chain, point): (usize, usize)| layout.lines[chain].position(point);
        bars.push(RigidBar { from, to, points: [0; 2], length: x(to) - x(from), path });
    }
    bars
}

fn equation(terms: &[(usize, usize, f64)], origin: &str) -> Equation {
    let term = |&(component, point, c): &(usize, usize, f64)| (Unknown { component, point }, c);
    // What rounding leaves of a right angle is no share.
    let terms = terms.iter().filter(|t| t.2.abs() > 1e-15).map(term).collect();
    Equation { terms, value: 0.0, origin: origin.into() }
}

/// Equations of rigid bars, `w₂ = w₁ + length φ₁`, `φ₂ = φ₁` and, with axial unknowns, `u₂ = u₁`.
pub(super) fn bar_equations(bars: &[RigidBar], has_axial: bool) -> Vec<Equation> {
    let mut equations = Vec::new();
    for bar in bars {
        let ([a, b], origin) = (bar.points, bar.path.to_string());
        equations.push(equation(&[(W, b, 1.0), (W, a, -1.0), (PHI, a, -bar.length)], &origin));
        equations.push(equation(&[(PHI, b, 1.0), (PHI, a, -1.0)], &origin));
        if has_axial {
            equations.push(equation(&[(U, b, 1.0), (U, a, -1.0)], &origin));
        }
    }
    equations
}

/// Equations of joints: all ends move as the first one does and, unless they are hinged, turn as the first one that is not
/// hinged. Members that bear one axial force alone are held along themselves one way. `first` are the numbers of the first points of the
/// members.
pub(super) fn add_joint_equations(
    layout: &Layout,
    first: &[usize],
    has_axial: bool,
    equations: &mut Vec<Equation>,
    one_way: &mut Vec<OneWay>,
) {
    let Some(frame) = &layout.frame else { return };
    let point = |end: EndOfMember| {
        let (chain, k) = layout.end(end);
        first[chain] + k
    };
    let mut tie = |joint: &JointLayout, origin: &str| {
        let leader = joint.first();
        let (a, [c1, s1]) = (point(leader), frame.members[leader.member].direction);
        for &end in &joint.ends[1..] {
            let (b, [c2, s2]) = (point(end), frame.members[end.member].direction);
            // Cosine and sine of the angle from the first member to this one.
            let (cos, sin) = (c1 * c2 + s1 * s2, c1 * s2 - s1 * c2);
            if has_axial {
                let (member, along) = (end.member, [(U, b, 1.0), (U, a, -cos), (W, a, -sin)]);
                let only =
                    frame.members[member].only.filter(|_| frame.members[member].released == Some(end.side));
                let mut own = None;
                if let Some(sign) = only {
                    // At its start the force on a member in tension is against its axis.
                    let sign = if end.side == 1 { sign } else { -sign };
                    let (part, origin) = (Part::Equation(equations.len()), Origin::Member(member));
                    one_way.push(OneWay { part, sign, gap: 0.0, origin });
                    own = Some(frame_layout::path().key("members").index(member).to_string());
                }
                equations.push(equation(&along, own.as_deref().unwrap_or(origin)));
                equations.push(equation(&[(W, b, 1.0), (W, a, -cos), (U, a, sin)], origin));
            } else {
                equations.push(equation(&[(W, b, 1.0), (W, a, -cos)], origin));
            }
        }
        let mut turning = joint.ends.iter().filter(|end| !end.hinged);
        if let Some(&leader) = turning.next() {
            let a = point(leader);
            equations.extend(turning.map(|&end| equation(&[(PHI, point(end), 1.0), (PHI, a, -1.0)], origin)));
        }
    };
    for (k, joint) in frame.joints.iter().enumerate() {
        tie(joint, &frame_layout::path().key("joints").index(k).to_string());
    }
}
