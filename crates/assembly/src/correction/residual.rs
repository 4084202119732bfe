//! What the recovered stresses lack of equilibrium, as forces on points.
//!
//! `r_i = ∮ (t − σ_c n) φ_i ds + Σ ∫ ½ (σ_c' − σ_c) n (φ_i^c + φ_i^c') ds`, the second sum over the sides between squares c and
//! c', with φ bilinear in every square and beyond: a displacement that a polynomial of the fits is leaves nothing. As the shares
//! of a place are exact for linear displacements, r has the force and the moment of the tractions to rounding.

use super::border::Border;
use super::fits::{Fits, Fitted, State};
use super::grid::{Grid, Node};
use super::squares::{Face, Square, Squares, corners, shares};
use crate::body::Outline;
use nalgebra::{DMatrix, Matrix3xX, RowDVector};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Gauss' rule of three points on (−1, 1), for degree five.
const RULE: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// A square whose stress acts on points.
#[derive(Clone, Debug)]
struct Acting {
    fitted: Fitted,
    /// Points, and which matrix makes their forces of the coefficients of the fit.
    points: Vec<u32>,
    matrix: u32,
}

/// A known traction that acts on points.
#[derive(Clone, Debug)]
struct Load {
    sample: u32,
    point: u32,
    /// Area along x and y, negative where an image acts against it, m².
    areas: [f64; 2],
}

/// Forces on points by displacements and tractions.
#[derive(Clone, Debug)]
pub(super) struct Residual {
    acting: Vec<Acting>,
    matrices: Vec<DMatrix<f64>>,
    loads: Vec<Load>,
}

/// A place at which the stress of a square acts on points.
struct Pull {
    at: [f64; 2],
    /// Normal times area, m².
    area: [f64; 2],
    /// Along which axes it acts.
    acts: [bool; 2],
    shares: Vec<(Node, f64)>,
}

impl Residual {
    /// Of a body of some thickness, m. None where too little is known to tell a fit.
    pub(super) fn new(
        (grid, border, outline): (&Grid, &Border, &Outline),
        thickness: f64,
        fits: &mut Fits,
    ) -> Option<Self> {
        let squares = Squares::new(grid, border);
        let mut pulls: BTreeMap<u32, Vec<Pull>> = BTreeMap::new();
        let depth = grid.spacing * thickness;
        for face in squares.faces(grid, border, outline) {
            add_face(&face, (&squares, grid), depth, &mut pulls);
        }
        let loads = add_border((&squares, grid), border, thickness, &mut pulls);
        let is_plain = |k: &u32| squares.is_plain[*k as usize];
        let is_used = |k: &u32| {
            let acts = |nodes: [Node; 4]| nodes.iter().any(|node| node.is_real);
            pulls.contains_key(k)
                || (is_plain(k) && corners(grid, squares.all[*k as usize]).is_some_and(acts))
        };
        let used: Vec<u32> = (0..squares.all.len() as u32).filter(is_used).collect();
        let centre = |k: &u32| squares.all[*k as usize].map(|low| f64::from(low) + 0.5);
        let centres: Vec<[f64; 2]> = used.iter().map(centre).collect();
        let fitted = fits.add(&centres, grid, border)?;
        let unit = fits.basis.unit() / fits.radius(grid);
        let stress = |at: [f64; 2], centre: [f64; 2]| fits.basis.stresses(fits.relative(at, centre)) * unit;
        let own = |(k, fitted): (u32, Fitted)| {
            let square = squares.all[k as usize];
            let plain = if is_plain(&k) { plain_pulls(square, grid, depth) } else { Vec::new() };
            let all = plain.iter().chain(pulls.get(&k).into_iter().flatten());
            let centre = fitted.around.centre;
            let (points, matrix) = summed(all, fits.basis.count(), &|at| stress(at, centre));
            (fitted, points, matrix, is_plain(&k) && !pulls.contains_key(&k))
        };
        let made: Vec<_> = used.into_par_iter().zip(fitted).map(own).collect();
        Some(Self::of(made, loads))
    }

    /// Plain squares share one matrix.
    fn of(made: Vec<(Fitted, Vec<u32>, DMatrix<f64>, bool)>, loads: Vec<Load>) -> Self {
        let (mut matrices, mut plain): (Vec<DMatrix<f64>>, Option<u32>) = (Vec::new(), None);
        let mut acting = Vec::with_capacity(made.len());
        for (fitted, points, matrix, is_plain) in made {
            let is_shared = is_plain && points.len() == 4;
            let number = match plain.filter(|_| is_shared) {
                Some(number) => number,
                None => {
                    matrices.push(matrix);
                    matrices.len() as u32 - 1
                }
            };
            if is_shared {
                plain = Some(number);
            }
            acting.push(Acting { fitted, points, matrix: number });
        }
        Self { acting, matrices, loads }
    }

    /// Forces of the known tractions on points, N, in two planes.
    pub(super) fn add_loads(&self, state: State, force: &mut [f64]) {
        for Load { sample, point, areas } in &self.loads {
            let traction = state.border[*sample as usize];
            (0..2).for_each(|c| force[c * state.points + *point as usize] += areas[c] * traction[c]);
        }
    }

    /// Adds what the stresses of the fits do to points, N, in two planes.
    pub(super) fn add_stresses(&self, fits: &Fits, border: &Border, state: State, force: &mut [f64]) {
        let of = |own: &Acting| {
            &self.matrices[own.matrix as usize] * fits.coefficients(&own.fitted, border, state)
        };
        let forces: Vec<_> = self.acting.par_iter().with_min_len(64).map(of).collect();
        for (own, on) in self.acting.iter().zip(&forces) {
            for (k, point) in own.points.iter().enumerate() {
                (0..2).for_each(|c| force[c * state.points + *point as usize] += on[2 * k + c]);
            }
        }
    }
}

/// Forces on points, two rows of each, by the coefficients of a fit.
fn summed<'a>(
    pulls: impl Iterator<Item = &'a Pull>,
    fields: usize,
    stress: &dyn Fn([f64; 2]) -> Matrix3xX<f64>,
) -> (Vec<u32>, DMatrix<f64>) {
    let mut rows: BTreeMap<u32, [RowDVector<f64>; 2]> = BTreeMap::new();
    for pull in pulls {
        let (s, [x, y]) = (stress(pull.at), pull.area);
        let along = [s.row(0) * x + s.row(2) * y, s.row(2) * x + s.row(1) * y];
        for (node, share) in pull.shares.iter().filter(|(node, _)| node.is_real) {
            let own = rows.entry(node.number).or_insert_with(|| [0, 1].map(|_| RowDVector::zeros(fields)));
            for c in (0..2).filter(|c| pull.acts[*c]) {
                own[c] += &along[c] * *share;
            }
        }
    }
    let points: Vec<u32> = rows.keys().copied().collect();
    let all: Vec<RowDVector<f64>> = rows.into_values().flatten().collect();
    let matrix = if all.is_empty() { DMatrix::zeros(0, fields) } else { DMatrix::from_rows(&all) };
    (points, matrix)
}

/// The stress of a square on all of its sides: the next ones move with the same points there.
fn plain_pulls(square: Square, grid: &Grid, depth: f64) -> Vec<Pull> {
    let Some(nodes) = corners(grid, square) else { return Vec::new() };
    let mut pulls = Vec::new();
    for (axis, side) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        for (share, weight) in RULE {
            let mut at = square.map(|low| f64::from(low) + 0.5 + 0.5 * share);
            at[axis] = f64::from(square[axis] + side);
            let mut area = [0.0; 2];
            // Towards the next square the stress of this one counts negative.
            area[axis] = if side == 1 { -0.5 } else { 0.5 } * weight * depth;
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
fn add_face(
    face: &Face,
    (squares, grid): (&Squares, &Grid),
    depth: f64,
    pulls: &mut BTreeMap<u32, Vec<Pull>>,
) {
    let [from, to] = face.ends;
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let own = face.squares.map(|k| squares.all[k as usize]);
    let nodes = own.map(|square| corners(grid, square));
    for (share, weight) in RULE {
        let at = [0, 1].map(|k| from[k] + 0.5 * (1.0 + share) * (to[k] - from[k]));
        let of = |k: usize| nodes[k].into_iter().flatten().zip(shares(own[k], at).map(|share| 0.5 * share));
        let all: Vec<(Node, f64)> = of(0).chain(of(1)).collect();
        if !all.iter().any(|(node, _)| node.is_real) {
            continue;
        }
        // A plain square has all of its sides already.
        let sides = face.squares.into_iter().zip([-1.0, 1.0]);
        for (k, sign) in sides.filter(|(k, _)| !squares.is_plain[*k as usize]) {
            let mut area = [0.0; 2];
            area[face.axis] = 0.5 * sign * weight * length * depth;
            pulls.entry(k).or_default().push(Pull { at, area, acts: [true; 2], shares: all.clone() });
        }
    }
}

/// What the stresses beside the border do where its tractions are known, and what these do themselves.
fn add_border(
    (squares, grid): (&Squares, &Grid),
    border: &Border,
    thickness: f64,
    pulls: &mut BTreeMap<u32, Vec<Pull>>,
) -> Vec<Load> {
    let mut loads = Vec::new();
    for mark in &border.marks {
        let Some(k) = squares.owner(mark.square()) else { continue };
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
        pulls.entry(k).or_default().push(Pull {
            at: mark.at,
            area: mark.normal.map(|n| -n * area),
            acts,
            shares: all,
        });
    }
    loads
}
