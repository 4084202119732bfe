//! What a frame must be beside well-formed: names that tell things apart, joints that join, hinges that turn.

use super::frame_layout::path;
use crate::case::{Frame, MemberEnd};
use crate::diagnostic::{Faults, JsonPath};
use std::collections::{HashMap, HashSet};

/// Names must tell things apart, and be fit to be shown.
pub(super) fn unique(names: &[(&str, JsonPath)], what: &str, faults: &mut Faults) {
    let mut seen: HashMap<&str, ()> = HashMap::new();
    for (name, path) in names {
        if name.trim().is_empty() || name.chars().any(char::is_control) {
            faults.error(path.clone(), "a name must have letters, and no control characters");
        } else if seen.insert(name, ()).is_some() {
            faults.error(path.clone(), format!("there are two {what} `{name}`"));
        }
    }
}

/// Every joint must join something.
pub(super) fn check_joints(frame: &Frame, known: &HashMap<String, usize>, faults: &mut Faults) {
    let named: HashSet<&str> = frame.members.iter().flat_map(|m| [m.from.as_str(), m.to.as_str()]).collect();
    // A joint whose name is misspelt in a member has its fault there.
    if named.iter().any(|name| !known.contains_key(*name)) {
        return;
    }
    for (k, joint) in frame.joints.iter().enumerate().filter(|(_, j)| !named.contains(j.name.as_str())) {
        faults
            .error(
                path().key("joints").index(k),
                format!("no member begins or ends at the joint `{}`", joint.name),
            )
            .hint("remove it, or name it in a member");
    }
}

/// An end has one hinge. One where no other member ends does nothing, and does no harm.
pub(super) fn check_hinges(frame: &Frame, faults: &mut Faults) {
    for (k, member) in frame.members.iter().enumerate() {
        let at = path().key("members").index(k).key("hinges");
        for (h, hinge) in member.hinges.iter().enumerate() {
            if member.hinges[..h].contains(hinge) {
                faults.error(at.index(h), "this end has a hinge already").hint("remove one of them");
            }
        }
    }
}

/// A member that bears one axial force alone is a bar: bent ends would bear something where it is slack.
pub(super) fn check_one_way(frame: &Frame, faults: &mut Faults) {
    for (k, member) in frame.members.iter().enumerate().filter(|(_, m)| m.only.is_some()) {
        if ![MemberEnd::From, MemberEnd::To].iter().all(|end| member.hinges.contains(end)) {
            faults
                .error(
                    path().key("members").index(k).key("only"),
                    "a member that bears one kind of axial force is a bar, and this one lacks a hinge",
                )
                .hint(r#"give it `"hinges": ["from", "to"]`"#);
        }
    }
}

/// Joints at one place look joined and are not.
pub(super) fn warn_of_places(frame: &Frame, faults: &mut Faults) {
    let at = |k: usize| path().key("joints").index(k);
    let mut places: HashMap<[u64; 2], usize> = HashMap::new();
    for (k, joint) in frame.joints.iter().enumerate() {
        // Adding zero makes −0 the same place as 0.
        let place = [joint.x, joint.y].map(|v| (v + 0.0).to_bits());
        if let Some(&other) = places.get(&place) {
            let other = &frame.joints[other].name;
            faults
                .warning(at(k), format!("the joints `{}` and `{other}` are at the same place", joint.name))
                .hint("only members that name the same joint are joined");
        }
        places.entry(place).or_insert(k);
    }
}
