//! What completes the families of points beside faces on the finest level: the bonds of the model that end on its border.

use super::border_rows::{BorderRows, SLACK};
use super::grid::Grid;
use crate::stiffness::NodedBonds;
use std::array::from_fn;

/// Points beside a border that follow each other in fewer columns are numbered across these.
const SHORT: u32 = 8;

/// The bonds on the border of a solid, for points of a grid.
#[derive(Clone, Debug)]
pub(super) struct Border {
    rows: BorderRows,
    /// Places of the points that these move with, then come the nodes.
    places: Vec<u32>,
    /// Per node: where the points end that it moves with; their numbers and shares.
    node_ends: Vec<u32>,
    node_points: Vec<(u32, f32)>,
    /// Images among the points: their numbers, those of what they are images of, and the signs of their displacements.
    images: Vec<(u32, u32, [f32; 3])>,
}

/// A point of a solid as a place of the grid: its own, that of what it is an image of, and the signs of its displacements.
pub(super) type PlaceOf<'a> = &'a dyn Fn(u32) -> (u32, u32, [f64; 3]);

impl Border {
    /// Those of a solid, whose stiffnesses are divided by `unit`, N/m.
    pub(super) fn new((bonds, unit): (&NodedBonds<3, 1>, f64), grid: &Grid, place_of: PlaceOf<'_>) -> Self {
        let members = bonds.members();
        let mut places: Vec<u32> = members
            .iter()
            .flat_map(|&point| {
                let (own, real, _) = place_of(point);
                [own, real]
            })
            .collect();
        order(&mut places, grid);
        let mut number_of = vec![0; grid.len()];
        places.iter().enumerate().for_each(|(k, place)| number_of[*place as usize] = k as u32);
        let number = |place: u32| number_of[place as usize];
        let image = |&point: &u32| {
            let (own, real, signs) = place_of(point);
            (own != real).then(|| (number(own), number(real), signs.map(|s| s as f32)))
        };
        let images = members.iter().filter_map(image).collect();
        let (mut node_ends, mut node_points) = (Vec::new(), Vec::new());
        for place in bonds.places() {
            node_points
                .extend(place.iter().map(|(point, share)| (number(place_of(*point).0), *share as f32)));
            node_ends.push(node_points.len() as u32);
        }
        let points = places.len() as u32;
        let row = |id: u32, is_node: bool| if is_node { points + id } else { number(place_of(id).0) };
        let rows = BorderRows::new(bonds, unit, (places.len() + node_ends.len(), row));
        Self { rows, places, node_ends, node_points, images }
    }

    /// Calls `take` with the places of all points beside the border, and with their forces.
    pub(super) fn for_each_force(&self, grid: &Grid, v: &[f32], mut take: impl FnMut(usize, [f32; 3])) {
        let points = self.places.len();
        let len = points + self.node_ends.len() + SLACK;
        let mut u = vec![0.0; 3 * len];
        for (u, plane) in u.chunks_exact_mut(len).zip(v.chunks_exact(grid.len())) {
            let (of_points, of_nodes) = u.split_at_mut(points);
            of_points.iter_mut().zip(&self.places).for_each(|(u, place)| *u = plane[*place as usize]);
            self.each_node().zip(of_nodes).for_each(|(node, u)| {
                *u = node.iter().map(|(point, share)| share * of_points[*point as usize]).sum();
            });
        }
        let mut forces = vec![0.0; 3 * len];
        let mut planes = forces.chunks_exact_mut(len);
        self.rows.apply(from_fn(|c| &u[c * len..][..len]), from_fn(|_| planes.next().unwrap_or_default()));
        for forces in forces.chunks_exact_mut(len) {
            let (of_points, of_nodes) = forces.split_at_mut(points);
            self.each_node().zip(of_nodes).for_each(|(node, force)| {
                node.iter().for_each(|(point, share)| of_points[*point as usize] += share * *force);
            });
        }
        for &(image, real, signs) in &self.images {
            for (c, sign) in signs.iter().enumerate() {
                forces[c * len + real as usize] += sign * forces[c * len + image as usize];
            }
        }
        for (k, &place) in self.places.iter().enumerate() {
            take(place as usize, from_fn(|c| forces[c * len + k]));
        }
    }

    /// What every node moves with.
    fn each_node(&self) -> impl Iterator<Item = &[(u32, f32)]> {
        let begins = std::iter::once(&0).chain(&self.node_ends);
        begins.zip(&self.node_ends).map(|(begin, end)| &self.node_points[*begin as usize..*end as usize])
    }
}

/// Puts places into the order in which most of those that are alike follow each other: along the columns, but where few columns
/// are beside the border, along the rows.
fn order(places: &mut Vec<u32>, grid: &Grid) {
    places.sort_unstable();
    places.dedup();
    let column = |place: u32| place % grid.strides[1] as u32;
    let runs = places.chunk_by(|a, b| a + 1 == *b);
    let mut keys: Vec<(u32, u32)> = runs
        .flat_map(|run| {
            let is_short = (run.len() as u32) < SHORT;
            run.iter().map(move |place| (if is_short { 1 + column(*place) } else { 0 }, *place))
        })
        .collect();
    keys.sort_unstable();
    places.iter_mut().zip(keys).for_each(|(place, key)| *place = key.1);
}
