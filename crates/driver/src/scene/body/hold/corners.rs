//! Corners of two edges that supports hold.

use super::held_points::HeldPoints;
use crate::scene::prescribed::Motion;
use peristat_assembly::bonds::Point;
use peristat_assembly::model::BodyModel;
use std::array::from_fn;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// What holds the border beside a point.
#[derive(Debug)]
struct Holding {
    place: Point,
    given: Motion,
    origin: String,
}

/// What holds the borders beside points, by points and the bits of directions.
#[derive(Debug, Default)]
pub(super) struct HeldCorners(BTreeMap<(u32, [u64; 3]), Holding>);

/// Part by which values at a corner may differ.
const SLACK: f64 = 1e-9;

impl HeldCorners {
    /// Leaves out points whose edge another hold has held along the same direction: what both hold of the points beside a
    /// corner says the rest, and to hold it twice is no more than to the rounding of both. Points whose corner is held
    /// elsewhere stay, and the origins of what holds it there are returned.
    pub(super) fn leave(
        &mut self,
        held: &mut HeldPoints,
        given: &Motion,
        model: &dyn BodyModel,
    ) -> Vec<String> {
        if !held.is_on_border() {
            return Vec::new();
        }
        let direction = held.direction.map(f64::to_bits);
        let mut others = Vec::new();
        let mut keep = |point: u32, place: Point| {
            let own = Holding { place, given: given.clone(), origin: held.origin.clone() };
            match self.0.entry((point, direction)) {
                Entry::Vacant(vacant) => {
                    vacant.insert(own);
                    true
                }
                Entry::Occupied(other) if agree(other.get(), &own, model.position(point as usize)) => false,
                Entry::Occupied(other) => {
                    others.push(other.get().origin.clone());
                    true
                }
            }
        };
        let places = held.places(model);
        let kept: Vec<bool> = held.points.iter().zip(places).map(|(&p, place)| keep(p, place)).collect();
        held.retain(&kept);
        others
    }
}

/// Whether two edges hold the corner beside a point at the same value: that is where both are, as far from the point as either.
fn agree(one: &Holding, other: &Holding, point: Point) -> bool {
    let corner = from_fn(|k| {
        let [a, b] = [one.place[k], other.place[k]];
        if (a - point[k]).abs() > (b - point[k]).abs() { a } else { b }
    });
    let is_near = |(a, b): (f64, f64)| a == b || (a - b).abs() <= SLACK * a.abs().max(b.abs());
    match (one.given.values(corner, Some(&other.given)), other.given.values(corner, Some(&one.given))) {
        (Ok(a), Ok(b)) => a.into_iter().zip(b).all(is_near),
        // Where a formula has no value in the corner itself, it says nothing against the other one.
        _ => true,
    }
}
