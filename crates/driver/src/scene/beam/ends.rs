//! Which end of a member stands for its joint, and where members that bear one axial force alone leave theirs.
//!
//! The first end of a joint moves as the joint does: one on it that stays there. A slack member is one whose end may move along it: the equation that holds this end to its joint acts one way, and its force is the
//! axial force at this end.

use super::frame_layout::{EndOfMember, JointLayout, MemberLayout, path};
use crate::diagnostic::Faults;

/// Puts ends that stand for their joints before the others.
pub(super) fn arrange(joints: &mut [JointLayout], members: &mut [MemberLayout], faults: &mut Faults) {
    release(joints, members, faults);
    let has_arm = |end: &EndOfMember| members[end.member].offsets[end.side] != [0.0; 2];
    for joint in joints {
        joint.ends.sort_by_key(|end| (members[end.member].released == Some(end.side), has_arm(end)));
        let offset = |end: &EndOfMember| {
            path().key("members").index(end.member).key("offsets").key(["from", "to"][end.side])
        };
        let first = joint.first();
        if has_arm(&first) {
            faults
                .error(offset(&first), format!("no member ends at the joint `{}` itself", joint.name))
                .hint("move the joint to where a member ends, and join others to it by a rigid link or by `offsets`");
        }
        if joint.turning().is_none() {
            for end in joint.ends.iter().filter(|end| has_arm(end)) {
                faults
                    .error(
                        offset(end),
                        format!(
                            "all members are hinged at the joint `{}`: nothing turns this arm",
                            joint.name
                        ),
                    )
                    .hint("remove a hinge, so that a member turns with the joint");
            }
        }
    }
}

/// Chooses ends that leave their joints, `to` where another end stays there.
fn release(joints: &[JointLayout], members: &mut [MemberLayout], faults: &mut Faults) {
    let mut stay: Vec<usize> = joints.iter().map(|joint| joint.ends.len()).collect();
    for (k, member) in members.iter_mut().enumerate().filter(|(_, member)| member.only.is_some()) {
        member.released = [1, 0].into_iter().find(|&side| stay[member.joints[side]] > 1);
        match member.released {
            Some(side) => stay[member.joints[side]] -= 1,
            None => {
                let [from, to] = member.joints.map(|joint| &joints[joint].name);
                faults
                    .error(
                        path().key("members").index(k).key("only"),
                        format!("at neither joint, `{from}` or `{to}`, is there an end that stays where this member is slack"),
                    )
                    .hint("leave `only` out, and look at the sign of its N");
            }
        }
    }
}
