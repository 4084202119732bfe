//! Supports of several parts of a border: straight edges along the lattice are held on their lines one by one, all others together.

use super::held_edge::{EdgeShares, HeldEdge};
use super::supports::HeldSupport;
use crate::case::Names;
use crate::diagnostic::Faults;
use crate::model::Material;
use crate::scene::body::site::boundary::{self, is_left_out};
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::symmetry::Symmetry;
use peristat_assembly::body::{BorderMember, Edge, PointBody};
use std::collections::BTreeSet;

/// How edges of a body are held.
type Holding<'a> = (&'a Symmetry, &'a dyn Material, &'a EdgeShares<'a>);

/// A support by what its names call; springs are shared by all of its points.
pub(super) fn parts(
    whole: HeldSupport,
    names: &Names,
    ground: &Ground,
    holding: Holding,
) -> Vec<HeldSupport> {
    let (_, material, shares) = holding;
    let is_one = |name: &str| match ground.outline.and_then(|outline| outline.members(name)) {
        Some(members) => {
            members.len() == 1
                && ground.outline.is_some_and(|o| o.edge(name).is_some() || o.hole(name).is_some())
        }
        None => true,
    };
    if let [name] = names.each()
        && is_one(name)
    {
        return vec![whole.on(name, ground, material, shares)];
    }
    let (mut held, mut taken) = (Vec::new(), BTreeSet::new());
    for name in names.each() {
        let found = match is_one(name) {
            true => vec![(whole.along(points(name, ground), Vec::new()), Some(name.clone()))],
            false => group(&whole, name, ground, holding),
        };
        for (mut part, edge) in found {
            // A point in a corner is held once: what holds the points beside it along both edges says the rest.
            part.points.retain(|point| taken.insert(*point));
            held.push(match edge {
                Some(edge) => part.on(&edge, ground, material, shares),
                None => part,
            });
        }
    }
    // Springs alone, which know the points of the whole.
    if !whole.has_springs() {
        return held;
    }
    held.push(whole.springs_alone());
    held
}

fn points(name: &str, ground: &Ground) -> Vec<u32> {
    ground.region(name, &Default::default(), &mut Faults::default()).unwrap_or_default()
}

/// A support of a group of parts of the border, with the edges that are held on their lines.
fn group(
    whole: &HeldSupport,
    name: &str,
    ground: &Ground,
    (symmetry, material, shares): Holding,
) -> Vec<(HeldSupport, Option<String>)> {
    let (Some(outline), PointBody::Lattice(lattice)) = (ground.outline, ground.body) else {
        return Vec::new();
    };
    let members = outline.members(name).unwrap_or_default().into_iter();
    let members = members.filter(|member| !is_left_out(name, *member, ground, symmetry));
    let on_line = |member: &BorderMember| -> Option<Edge> {
        let edge = outline.straight(*member).filter(|edge| !edge.is_chord)?;
        let is_held = material.cylinder_radius().is_some() || HeldEdge::new(&edge, lattice, shares).is_some();
        is_held.then_some(edge)
    };
    let (straight, others): (Vec<BorderMember>, Vec<BorderMember>) =
        members.partition(|m| on_line(m).is_some());
    let edges = straight.iter().filter_map(on_line);
    let mut held: Vec<_> =
        edges.map(|edge| (whole.along(points(&edge.name, ground), Vec::new()), Some(edge.name))).collect();
    if !others.is_empty() {
        let border = others.iter().flat_map(|member| boundary::stretches_of(*member, ground)).collect();
        held.push((whole.along(points(name, ground), border), None));
    }
    held
}
