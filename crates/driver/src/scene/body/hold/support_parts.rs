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

/// How edges of a body are held.
type Holding<'a> = (&'a Symmetry, &'a dyn Material, &'a EdgeShares<'a>);

/// A support by what its names call; springs are shared by all of its points.
pub(super) fn parts(whole: HeldSupport, names: &Names, ground: &Ground, holding: Holding) -> Vec<HeldSupport> {
    let (_, material, shares) = holding;
    let is_one = |name: &str| match ground.outline.and_then(|outline| outline.members(name)) {
        Some(members) => members.len() == 1 && ground.outline.is_some_and(|o| o.edge(name).is_some() || o.hole(name).is_some()),
        None => true,
    };
    if let [name] = names.each()
        && is_one(name)
    {
        return vec![whole.on(name, ground, material, shares)];
    }
    let mut held = Vec::new();
    for name in names.each() {
        match is_one(name) {
            true => held.push(whole.along(points(name, ground), Vec::new()).on(name, ground, material, shares)),
            false => held.extend(group(&whole, name, ground, holding)),
        }
    }
    // Springs alone, which know the points of the whole.
    if !whole.springs.is_empty() {
        held.push(whole.springs_alone());
    }
    held
}

fn points(name: &str, ground: &Ground) -> Vec<u32> {
    ground.region(name, &Default::default(), &mut Faults::default()).unwrap_or_default()
}

/// A support of a group of parts of the border.
fn group(whole: &HeldSupport, name: &str, ground: &Ground, (symmetry, material, shares): Holding) -> Vec<HeldSupport> {
    let (Some(outline), PointBody::Lattice(lattice)) = (ground.outline, ground.body) else { return Vec::new() };
    let members = outline.members(name).unwrap_or_default().into_iter();
    let members = members.filter(|member| !is_left_out(name, *member, ground, symmetry));
    let on_line = |member: &BorderMember| -> Option<Edge> {
        let edge = outline.straight(*member).filter(|edge| !edge.is_chord)?;
        let is_held = material.cylinder_radius().is_some() || HeldEdge::new(&edge, lattice, shares).is_some();
        is_held.then_some(edge)
    };
    let (straight, others): (Vec<BorderMember>, Vec<BorderMember>) = members.partition(|m| on_line(m).is_some());
    let mut held = Vec::new();
    let mut taken: Vec<u32> = Vec::new();
    for edge in straight.iter().filter_map(on_line) {
        let own = points(&edge.name, ground);
        taken.extend(&own);
        held.push(whole.along(own, Vec::new()).on(&edge.name, ground, material, shares));
    }
    if !others.is_empty() {
        taken.sort_unstable();
        let own = points(name, ground).into_iter().filter(|p| taken.binary_search(p).is_err()).collect();
        let border = others.iter().flat_map(|member| boundary::stretches_of(*member, ground)).collect();
        held.push(whole.along(own, border));
    }
    held
}
