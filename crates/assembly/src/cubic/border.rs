//! What completes the families of points beside faces on the finest level: the bonds of the model that end on its border.

use super::grid::Grid;
use crate::stiffness::NodedBonds;
use std::collections::HashMap;

/// The bonds on the border of a solid, for points of a grid.
#[derive(Clone, Debug)]
pub(super) struct Border {
    bonds: NodedBonds<3, 1, f32>,
    /// Places of the points that these move with, ascending.
    places: Vec<u32>,
    /// Images among them: their numbers, those of what they are images of, and the signs of their displacements.
    images: Vec<(u32, u32, [f32; 3])>,
}

/// A point of a solid as a place of the grid: its own, that of what it is an image of, and the signs of its displacements.
pub(super) type PlaceOf<'a> = &'a dyn Fn(u32) -> (u32, u32, [f64; 3]);

impl Border {
    /// Those of a solid, whose stiffnesses are divided by `unit`, N/m.
    pub(super) fn new(bonds: &NodedBonds<3, 1>, unit: f64, place_of: PlaceOf<'_>) -> Self {
        let members = bonds.members();
        let mut places: Vec<u32> = members
            .iter()
            .flat_map(|&point| {
                let (own, real, _) = place_of(point);
                [own, real]
            })
            .collect();
        places.sort_unstable();
        places.dedup();
        let number = |place: u32| places.partition_point(|p| *p < place) as u32;
        let of: HashMap<u32, u32> = members.iter().map(|&point| (point, number(place_of(point).0))).collect();
        let image = |&point: &u32| {
            let (own, real, signs) = place_of(point);
            (own != real).then(|| (number(own), number(real), signs.map(|s| s as f32)))
        };
        let images = members.iter().filter_map(image).collect();
        let bonds = bonds.renumbered(places.len(), &|point| of[&point], 1.0 / unit);
        Self { bonds, places, images }
    }

    /// Calls `take` with the places of all points beside the border, and with their forces.
    pub(super) fn for_each_force(&self, grid: &Grid, v: &[f32], mut take: impl FnMut(usize, [f32; 3])) {
        let n = self.places.len();
        let mut u = Vec::with_capacity(3 * n);
        for plane in v.chunks_exact(grid.len()) {
            u.extend(self.places.iter().map(|&place| plane[place as usize]));
        }
        let mut forces = vec![0.0; 3 * n];
        self.bonds.add_forces(&u, &mut forces);
        for &(image, real, signs) in &self.images {
            for (c, sign) in signs.iter().enumerate() {
                forces[c * n + real as usize] += sign * forces[c * n + image as usize];
            }
        }
        for (k, &place) in self.places.iter().enumerate() {
            take(place as usize, [forces[k], forces[n + k], forces[2 * n + k]]);
        }
    }
}
