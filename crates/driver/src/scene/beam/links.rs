//! What joins points: rigid bars, and the joints of a frame with the arms of its members.

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
    /// Lines and real points that turn as the ends do: hinged ends of joints do not.
    turning: [(usize, usize); 2],
    /// Numbers of the points: those that move, and those that turn.
    points: [[usize; 2]; 2],
    /// Directions of the lines of the ends.
    directions: [[f64; 2]; 2],
    /// From one end to the other.
    arm: [f64; 2],
    /// Where it stands in the case.
    pub path: JsonPath,
}

impl RigidBar {
    /// The same with the numbers of its points.
    pub(super) fn numbered(self, first: &[usize]) -> Self {
        let number = |(chain, point): (usize, usize)| first[chain] + point;
        Self { points: [[self.from, self.to].map(number), self.turning.map(number)], ..self }
    }
}

/// Points that move and turn at an end of a bar, with a fault where there are none.
fn end(at: &At, layout: &Layout, path: &JsonPath, faults: &mut Faults) -> Option<[(usize, usize); 2]> {
    match frame_place::find(at, layout, path, "the end of the link", faults)? {
        FramePlace::On(Place::Point { chain, point }) => Some([(chain, point); 2]),
        FramePlace::On(Place::End { chain, .. } | Place::Between { chain, .. }) => {
            let x = at.x.unwrap_or(0.0);
            layout.needs_point(chain, x, &path.key("x"), "the end of the link", faults);
            None
        }
        FramePlace::Joint(joint) => {
            let joint = &layout.frame.as_ref()?.joints[joint];
            let Some(turning) = joint.turning() else {
                let place = layout.example(joint.first());
                faults
                    .error(
                        path.clone(),
                        format!(
                            "all members are hinged at the joint `{}`: no rotation turns the link",
                            joint.name
                        ),
                    )
                    .hint(format!("to join the end of one member give it as the place: {place}"));
                return None;
            };
            Some([joint.first(), turning].map(|end| layout.end(end)))
        }
    }
}

/// Rigid bars of the case.
pub(super) fn bars(case: &Case, layout: &Layout, faults: &mut Faults) -> Vec<RigidBar> {
    let mut bars = Vec::new();
    for (k, link) in case.links.iter().enumerate() {
        let Link::Rigid(link) = link;
        let path = root("links").index(k).key("rigid");
        let from = end(&link.from, layout, &path.key("from"), faults);
        let to = end(&link.to, layout, &path.key("to"), faults);
        let (Some([from, first]), Some([to, second])) = (from, to) else { continue };
        if from == to {
            faults.error(path, "a link joins a point to itself");
            continue;
        }
        let directions = [from, to].map(|end| layout.direction(end.0));
        let place = |(chain, point): (usize, usize)| {
            let (x, [c, s], [x0, y0]) =
                (layout.lines[chain].position(point), layout.direction(chain), layout.origin(chain));
            [x0 + c * x, y0 + s * x]
        };
        let (a, b) = (place(from), place(to));
        let (turning, arm) = ([first, second], [b[0] - a[0], b[1] - a[1]]);
        bars.push(RigidBar { from, to, turning, points: [[0; 2]; 2], directions, arm, path });
    }
    bars
}

/// An equation without what rounding leaves of a right angle, which is no share.
fn equation(terms: &[(usize, usize, f64)], origin: &str) -> Equation {
    let term = |&(component, point, c): &(usize, usize, f64)| (Unknown { component, point }, c);
    let terms = terms.iter().filter(|t| t.2.abs() > 1e-15).map(term).collect();
    Equation { terms, value: 0.0, origin: origin.into() }
}

/// A point b on a line that moves as an arm from a point a does, which turns by the rotation of a third point:
/// `u_b = u_a + φ (−r_y, r_x)`.
struct Tie {
    /// Numbers of the points a and b, and directions of their lines.
    points: [usize; 2],
    directions: [[f64; 2]; 2],
    /// Number of the point whose rotation it is.
    turning: usize,
    /// The arm.
    arm: [f64; 2],
}

impl Tie {
    /// Terms of the equations across and along the line of b; without axial unknowns there is none along it.
    fn terms(&self, has_axial: bool) -> [[(usize, usize, f64); 4]; 2] {
        let ([a, b], [[c1, s1], [c, s]], [x, y]) = (self.points, self.directions, self.arm);
        // Cosine and sine of the angle from the line of a to that of b.
        let (cos, sin) = (c1 * c + s1 * s, c1 * s - s1 * c);
        let turn = [x * c + y * s, x * s - y * c].map(|share| (PHI, self.turning, -share));
        let across = [(W, b, 1.0), (W, a, -cos), (U, a, if has_axial { sin } else { 0.0 }), turn[0]];
        [across, [(U, b, 1.0), (U, a, -cos), (W, a, -sin), turn[1]]]
    }
}

/// Equations of rigid bars: the second end moves as part of the first, and turns as it does.
pub(super) fn bar_equations(bars: &[RigidBar], has_axial: bool) -> Vec<Equation> {
    let mut equations = Vec::new();
    for bar in bars {
        let ([points, [first, second]], origin) = (bar.points, bar.path.to_string());
        let tie = Tie { points, directions: bar.directions, turning: first, arm: bar.arm };
        let [across, along] = tie.terms(has_axial);
        equations.push(equation(&across, &origin));
        equations.push(equation(&[(PHI, second, 1.0), (PHI, first, -1.0)], &origin));
        if has_axial {
            equations.push(equation(&along, &origin));
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
        let turning = point(joint.turning().unwrap_or(leader));
        for &end in &joint.ends[1..] {
            let member = &frame.members[end.member];
            let directions = [leader.member, end.member].map(|k| frame.members[k].direction);
            let points = [point(leader), point(end)];
            let tie = Tie { points, directions, turning, arm: member.offsets[end.side] };
            let [across, along] = tie.terms(has_axial);
            if has_axial {
                let only = member.only.filter(|_| member.released == Some(end.side));
                let mut own = None;
                if let Some(sign) = only {
                    // At its start the force on a member in tension is against its axis.
                    let sign = if end.side == 1 { sign } else { -sign };
                    let (part, origin) = (Part::Equation(equations.len()), Origin::Member(end.member));
                    one_way.push(OneWay { part, sign, gap: 0.0, origin });
                    own = Some(frame_layout::path().key("members").index(end.member).to_string());
                }
                equations.push(equation(&along, own.as_deref().unwrap_or(origin)));
            }
            equations.push(equation(&across, origin));
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
