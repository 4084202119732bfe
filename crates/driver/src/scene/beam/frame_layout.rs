//! Joints and members of a frame.

use crate::diagnostic::{JsonPath, root};

/// Part of a length below which a difference of coordinates is their rounding: levels 0.3 and 0.1 + 0.2 are one.
pub(super) const ROUNDING: f64 = 1e-12;

/// Joints and members of a frame; member k is line k of the body.
#[derive(Clone, Debug)]
pub struct FrameLayout {
    /// The joints, in the order of the case.
    pub joints: Vec<JointLayout>,
    /// The members, in the order of the case.
    pub members: Vec<MemberLayout>,
}

/// A joint.
#[derive(Clone, Debug)]
pub struct JointLayout {
    /// Name.
    pub name: String,
    /// Position in the plane.
    pub position: [f64; 2],
    /// The ends of members that meet in it; those beside it, and then those that may leave it, come last.
    pub ends: Vec<EndOfMember>,
}

/// An end of a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EndOfMember {
    /// Member.
    pub member: usize,
    /// 0 at `from`, 1 at `to`.
    pub side: usize,
    /// Whether it turns freely in its joint.
    pub hinged: bool,
}

/// A member.
#[derive(Clone, Debug)]
pub struct MemberLayout {
    /// Name.
    pub name: String,
    /// Joints at `from` and `to`.
    pub joints: [usize; 2],
    /// Unit vector from `from` to `to`.
    pub direction: [f64; 2],
    /// From its joints to its ends.
    pub offsets: [[f64; 2]; 2],
    /// Sign of the only axial force that it bears.
    pub only: Option<f64>,
    /// The end that leaves its joint along the member where that is slack: 0 at `from`, 1 at `to`.
    pub released: Option<usize>,
}

impl JointLayout {
    /// The end whose displacements are those of the joint.
    pub fn first(&self) -> EndOfMember {
        self.ends[0]
    }

    /// The end whose rotation is that of the joint; `None` if all ends are hinged.
    pub fn turning(&self) -> Option<EndOfMember> {
        self.ends.iter().copied().find(|end| !end.hinged)
    }
}

impl FrameLayout {
    /// Where a member begins, or ends, in the plane.
    pub fn end(&self, member: &MemberLayout, side: usize) -> [f64; 2] {
        let (joint, offset) = (self.joints[member.joints[side]].position, member.offsets[side]);
        [joint[0] + offset[0], joint[1] + offset[1]]
    }

    /// Whether all members lie on one straight line along x, so that axial and transverse motions have nothing to do
    /// with each other.
    pub fn is_straight(&self) -> bool {
        let farthest = |k: usize| {
            let first = self.joints[0].position[k];
            self.joints.iter().map(|j| (j.position[k] - first).abs()).fold(0.0, f64::max)
        };
        self.members.iter().all(|m| m.direction[1] == 0.0 && m.offsets == [[0.0; 2]; 2])
            && farthest(1) <= ROUNDING * farthest(0)
    }
}

/// Path of the frame in a case.
pub(super) fn path() -> JsonPath {
    root("body").key("frame")
}
