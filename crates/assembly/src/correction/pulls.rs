//! Where stresses and tractions act on points.

use super::border::Border;
use super::grid::{Grid, Node};
use super::holes::HolePull;
use super::squares::{Face, Square, Squares, corners, shares};
use crate::quadrature::{GAUSS, GAUSS_3};
use std::collections::BTreeMap;

/// A known traction that acts on points.
#[derive(Clone, Debug)]
pub(super) struct Load {
    pub(super) sample: u32,
    pub(super) point: u32,
    /// Area along x and y, negative where an image acts against it, m².
    pub(super) areas: [f64; 2],
}

/// What acts on points, by what has the stress.
#[derive(Default)]
pub(super) struct Pulls {
    pub(super) of_squares: BTreeMap<u32, Vec<Pull>>,
    pub(super) of_holes: Vec<HolePull>,
}

/// A place at which the stress of a square acts on points.
#[derive(Clone)]
pub(super) struct Pull {
    pub(super) at: [f64; 2],
    /// Normal times area, m².
    pub(super) area: [f64; 2],
    /// Along which axes it acts.
    pub(super) acts: [bool; 2],
    pub(super) shares: Vec<(Node, f64)>,
}

impl Pulls {
    /// Adds a place at which a square has a stress, its own or that of the hole beside it.
    fn add(&mut self, k: u32, squares: &Squares, grid: &Grid, pull: Pull) {
        match squares.holes[k as usize] {
            Some(hole) => {
                let Pull { at, area, shares, .. } = pull;
                self.of_holes.push(HolePull { hole, at: grid.position(at), area, shares });
            }
            None => self.of_squares.entry(k).or_default().push(pull),
        }
    }
}

/// The stress of a square on all of its sides: the next ones move with the same points there.
pub(super) fn plain_pulls(square: Square, grid: &Grid, depth: f64) -> Vec<Pull> {
    let Some(nodes) = corners(grid, square) else { return Vec::new() };
    let mut pulls = Vec::new();
    for (axis, side) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        for (share, weight) in GAUSS_3 {
            let mut at = square.map(|low| f64::from(low) + share);
            at[axis] = f64::from(square[axis] + side);
            let mut area = [0.0; 2];
            // Towards the next square the stress of this one counts negative.
            area[axis] = if side == 1 { -1.0 } else { 1.0 } * weight * depth;
            pulls.push(Pull {
                at,
                area,
                acts: [true; 2],
                shares: nodes.into_iter().zip(shares(square, at)).collect(),
            });
        }
    }
    pulls
}

/// What the stresses on both sides of a face do.
pub(super) fn add_face(face: &Face, (squares, grid): (&Squares, &Grid), depth: f64, pulls: &mut Pulls) {
    let [from, to] = face.ends;
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let own = face.squares.map(|k| squares.all[k as usize]);
    let nodes = own.map(|square| corners(grid, square));
    let holes = face.squares.map(|k| squares.holes[k as usize]);
    let rule = if holes == [None; 2] { &GAUSS_3[..] } else { &GAUSS[..] };
    for (share, weight) in rule {
        let at = [0, 1].map(|k| from[k] + share * (to[k] - from[k]));
        let of = |k: usize| nodes[k].into_iter().flatten().zip(shares(own[k], at).map(|share| 0.5 * share));
        let all: Vec<(Node, f64)> = of(0).chain(of(1)).collect();
        if !all.iter().any(|(node, _)| node.is_real) {
            continue;
        }
        // A plain square has all of its sides already.
        let sides = face.squares.into_iter().zip([-1.0, 1.0]);
        for (k, sign) in sides.filter(|(k, _)| !squares.is_plain[*k as usize]) {
            let mut area = [0.0; 2];
            area[face.axis] = sign * weight * length * depth;
            pulls.add(k, squares, grid, Pull { at, area, acts: [true; 2], shares: all.clone() });
        }
    }
}

/// What the stresses beside the border do where its tractions are known, and what these do themselves. None where no square is near.
pub(super) fn add_border(
    (squares, grid): (&Squares, &Grid),
    border: &Border,
    thickness: f64,
    pulls: &mut Pulls,
) -> Option<Vec<Load>> {
    let mut loads = Vec::new();
    for mark in &border.marks {
        let Some(k) = squares.owner(mark.square()) else {
            if mark.signs == [1; 2] {
                return None;
            }
            continue;
        };
        // Fields of a hole are in balance with what acts on it.
        if squares.holes[k as usize].is_some() {
            continue;
        }
        let square = squares.all[k as usize];
        let Some(nodes) = corners(grid, square).filter(|nodes| nodes.iter().any(|node| node.is_real)) else {
            continue;
        };
        let area = border.samples[mark.sample as usize].length * thickness;
        let acts = mark.held.map(|held| !held);
        let all: Vec<(Node, f64)> = nodes.into_iter().zip(shares(square, mark.at)).collect();
        for (node, share) in all.iter().filter(|(node, _)| node.is_real) {
            let areas = [0, 1].map(|c| if acts[c] { f64::from(mark.signs[c]) * share * area } else { 0.0 });
            loads.push(Load { sample: mark.sample, point: node.number, areas });
        }
        pulls.of_squares.entry(k).or_default().push(Pull {
            at: mark.at,
            area: mark.normal.map(|n| -n * area),
            acts,
            shares: all,
        });
    }
    Some(loads)
}
