//! Concentrated loads of a scene.

use super::frame_place::{self, FramePlace};
use super::place::{Layout, Place};
use super::resolved_loads::ResolvedLoads;
use crate::case::PointLoad;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::PointAction;

/// Resolves a concentrated load.
pub(super) fn add(
    load: &PointLoad,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    let forces = [load.force, load.axial, load.force_x, load.force_y, load.moment];
    if load.force_z == 0.0 && forces.iter().all(|f| *f == 0.0) {
        let hint = match (&layout.frame, &load.at.joint) {
            (None, _) => "give `force`, `moment` or `axial`",
            (Some(_), Some(_)) => "give `force_x`, `force_y` or `moment`",
            (Some(_), None) => "give `force`, `axial`, `force_x`, `force_y` or `moment`",
        };
        faults.error(path.clone(), "this load is zero").hint(hint);
    }
    match frame_place::find(&load.at, layout, &path.key("at"), "the load", faults) {
        Some(FramePlace::Joint(joint)) => on_joint(load, joint, layout, path, to, faults),
        Some(FramePlace::On(place)) => on_line(load, place, layout, path, to, faults),
        None => {}
    }
}

/// Shares of a force in the plane across and along a line of this direction.
pub(super) fn shares([c, s]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [c * y - s * x, c * x + s * y]
}

fn on_joint(
    load: &PointLoad,
    joint: usize,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    let Some(frame) = &layout.frame else { return };
    let joint = &frame.joints[joint];
    for (key, value) in [("force", load.force), ("axial", load.axial)] {
        if value != 0.0 {
            faults
                .error(path.key(key), format!("`{key}` is for members: a joint has no direction of its own"))
                .hint("use `force_x` and `force_y`");
        }
    }
    if load.spread {
        faults
            .error(path.key("spread"), "a load on a joint has no bonds across it that could share it")
            .hint("remove `spread`");
    }
    let mut act = |(chain, point): (usize, usize), [force, axial]: [f64; 2], moment: f64| {
        let x = layout.lines[chain].position(point);
        to.loads.point.push(PointAction { chain, x, force, moment, axial, spread: false });
    };
    if load.force_x != 0.0 || load.force_y != 0.0 {
        let end = layout.end(joint.first());
        act(end, shares(layout.direction(end.0), [load.force_x, load.force_y]), 0.0);
    }
    if load.moment != 0.0 {
        match joint.turning() {
            Some(end) => act(layout.end(end), [0.0; 2], load.moment),
            None => {
                let place = layout.example(joint.first());
                faults
                    .error(
                        path.key("moment"),
                        format!(
                            "all members are hinged at the joint `{}`: nothing takes a moment",
                            joint.name
                        ),
                    )
                    .hint(format!("to load the end of one member give it as the place: {place}"));
            }
        }
    }
}

fn on_line(
    load: &PointLoad,
    place: Place,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if layout.frame.is_none() {
        for (key, value, use_instead) in
            [("force_x", load.force_x, "axial"), ("force_y", load.force_y, "force")]
        {
            if value != 0.0 {
                faults
                    .error(path.key(key), format!("`{key}` is for frames"))
                    .hint(format!("on a line use `{use_instead}`"));
            }
        }
    }
    let at = load.at.x.unwrap_or(0.0);
    let covers = layout.treatment.covers();
    let (chain, x, spread) = match place {
        Place::Point { chain, point } => {
            let inside = point > 0 && point + 1 < layout.lines[chain].points();
            if load.spread && !covers {
                faults
                    .error(
                        path.key("spread"),
                        "a spread load needs bonds whose weights sum to one across every cell",
                    )
                    .hint("use the end treatment `cover`");
            }
            if inside && !load.spread && covers {
                to.splits.push((chain, point));
            }
            (chain, layout.lines[chain].position(point), load.spread && inside)
        }
        Place::Between { chain, x } if covers => (chain, x, true),
        // The literature puts a load at the end of a grid of cells on the last point.
        Place::End { chain, .. } => (chain, at, false),
        Place::Between { chain, x } => {
            layout.needs_point(chain, x, &path.key("at").key("x"), "the load", faults);
            return;
        }
    };
    let [across, along] = shares(layout.direction(chain), [load.force_x, load.force_y]);
    let (force, axial) = (load.force + across, load.axial + along);
    to.loads.point.push(PointAction { chain, x, force, moment: load.moment, axial, spread });
}
