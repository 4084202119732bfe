//! What the recovered stresses lack of equilibrium, as forces on points.
//!
//! `r_i = ∮ (t − σ_c n) φ_i ds + Σ ∫ ½ (σ_c' − σ_c) n (φ_i^c + φ_i^c') ds`, the second sum over the sides between squares c and
//! c', with φ bilinear in every square and beyond: a displacement that a polynomial of the fits is leaves nothing. As the shares
//! of a place are exact for linear displacements, r has the force and the moment of the tractions to rounding.

use super::border::Border;
use super::fits::{Fits, Fitted, State};
use super::grid::{Grid, Node};
use super::holes::{HolePull, HoleZone};
use super::pulls::{Load, Pull, Pulls, add_border, add_face, plain_pulls};
use super::squares::{Squares, corners};
use crate::body::Outline;
use nalgebra::{DMatrix, MatrixXx3};
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// A square whose stress acts on points.
#[derive(Clone, Debug)]
struct Acting {
    fitted: Fitted,
    /// Points, and which matrix makes their forces of the coefficients of the fit.
    points: Vec<u32>,
    matrix: u32,
}

/// Forces on points by displacements and tractions.
#[derive(Clone, Debug)]
pub(super) struct Residual {
    acting: Vec<Acting>,
    matrices: Vec<DMatrix<f64>>,
    loads: Vec<Load>,
    of_holes: Vec<HolePull>,
}

impl Residual {
    /// Of a body of some thickness, m. None where too little is known to tell a fit.
    pub(super) fn new(
        (grid, border, outline): (&Grid, &Border, &Outline),
        (thickness, zones): (f64, &[HoleZone]),
        fits: &mut Fits,
    ) -> Option<Self> {
        let squares = Squares::new(grid, border, zones);
        let mut pulls = Pulls::default();
        let depth = grid.spacing * thickness;
        for face in squares.faces(grid, border, outline) {
            add_face(&face, (&squares, grid), depth, &mut pulls);
        }
        let loads = add_border((&squares, grid), border, thickness, &mut pulls)?;
        let is_plain = |k: &u32| squares.is_plain[*k as usize];
        let is_used = |k: &u32| {
            let acts = |nodes: [Node; 4]| nodes.iter().any(|node| node.is_real);
            pulls.of_squares.contains_key(k)
                || (is_plain(k) && corners(grid, squares.all[*k as usize]).is_some_and(acts))
        };
        let used: Vec<u32> = (0..squares.all.len() as u32).filter(is_used).collect();
        let centre = |k: &u32| squares.all[*k as usize].map(|low| f64::from(low) + 0.5);
        let centres: Vec<[f64; 2]> = used.iter().map(centre).collect();
        let fitted = fits.add(&centres, grid, border)?;
        let unit = fits.basis.unit() / fits.radius(grid);
        let stress = |at: [f64; 2], centre: [f64; 2]| fits.basis.stresses(fits.relative(at, centre)) * unit;
        let matrix_of = |pulls: &[Pull], centre| summed(pulls, fits.basis.count(), &|at| stress(at, centre));
        let whole = |k: u32| {
            let nodes = corners(grid, squares.all[k as usize]).filter(|_| squares.is_plain[k as usize])?;
            nodes.iter().all(|node| node.is_real).then_some(nodes)
        };
        // Plain squares of points of the body have one matrix, the first of all.
        let mut matrices: Vec<DMatrix<f64>> = Vec::new();
        if let Some(k) = used.iter().find(|k| whole(**k).is_some()) {
            let pulls = plain_pulls(squares.all[*k as usize], grid, depth);
            matrices.push(matrix_of(&pulls, centre(k)).1);
        }
        let own = |(k, fitted): (u32, Fitted)| {
            if let Some(nodes) = whole(k) {
                let mut points = nodes.map(|node| node.number).to_vec();
                points.sort_unstable();
                return (fitted, points, None);
            }
            let plain = || plain_pulls(squares.all[k as usize], grid, depth);
            let own =
                pulls.of_squares.get(&k).map_or_else(|| Cow::Owned(plain()), |own| Cow::Borrowed(&own[..]));
            let (points, matrix) = matrix_of(&own, centre(&k));
            (fitted, points, Some(matrix))
        };
        let made: Vec<_> = used.par_iter().copied().zip(fitted).map(own).collect();
        let mut acting = Vec::with_capacity(made.len());
        for (fitted, points, matrix) in made {
            let number = matrix.map_or(0, |matrix| {
                matrices.push(matrix);
                matrices.len() as u32 - 1
            });
            acting.push(Acting { fitted, points, matrix: number });
        }
        Some(Self { acting, matrices, loads, of_holes: pulls.of_holes })
    }

    /// Forces of the known tractions on points, N, in two planes.
    pub(super) fn add_loads(&self, state: State, force: &mut [f64]) {
        for Load { sample, point, areas } in &self.loads {
            let traction = state.border[*sample as usize];
            (0..2).for_each(|c| force[c * state.points + *point as usize] += areas[c] * traction[c]);
        }
    }

    /// Adds what the stresses of the fits and of the fields around holes do to points, N, in two planes.
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
        self.of_holes.iter().for_each(|pull| pull.add(state.holes, state.points, force));
    }
}

/// Forces on points, two rows of each, by the coefficients of a fit.
fn summed(
    pulls: &[Pull],
    fields: usize,
    stress: &dyn Fn([f64; 2]) -> MatrixXx3<f64>,
) -> (Vec<u32>, DMatrix<f64>) {
    let nodes = pulls.iter().flat_map(|pull| &pull.shares).filter(|(node, _)| node.is_real);
    let points = BTreeSet::from_iter(nodes.map(|(node, _)| node.number));
    let points = Vec::from_iter(points);
    // One column per force, as all fields of one lie together.
    let mut matrix = DMatrix::zeros(fields, 2 * points.len());
    for pull in pulls {
        let (stress, [x, y]) = (stress(pull.at), pull.area);
        for c in (0..2).filter(|c| pull.acts[*c]) {
            let along = stress.column(2 * c) * x + stress.column(2 - c) * y;
            for (node, share) in pull.shares.iter().filter(|(node, _)| node.is_real) {
                let row = points.partition_point(|point| *point < node.number);
                matrix.column_mut(2 * row + c).axpy(*share, &along, 1.0);
            }
        }
    }
    (points, matrix.transpose())
}
