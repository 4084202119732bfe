//! Where members that bear one axial force alone leave their joints.
//!
//! A slack member is one whose end may move along it: the equation that holds this end to its joint acts one way, and its force is the
//! axial force at this end. The joint moves as another end does, which stays.

use super::frame_layout::{JointLayout, MemberLayout, path};
use crate::diagnostic::Faults;

/// Chooses these ends, `to` where another end stays there, and puts them behind the others of their joints.
pub(super) fn release(joints: &mut [JointLayout], members: &mut [MemberLayout], faults: &mut Faults) {
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
    for joint in joints {
        joint.ends.sort_by_key(|end| members[end.member].released == Some(end.side));
    }
}
