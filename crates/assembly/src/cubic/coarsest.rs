//! The matrix of the coarsest level.

use super::level::CubicLevel;
use sprs::{CsMat, TriMat};

/// No unknown.
const NONE: u32 = u32::MAX;

/// The lower triangle of the matrix of the coarsest level, and how its vectors hold its unknowns.
#[derive(Clone, Debug)]
pub struct CoarsestMatrix {
    /// Per unit of the levels.
    pub matrix: CsMat<f64>,
    /// Entries of vectors that are unknowns, in order.
    pub entries: Vec<u32>,
    /// Entries that are images of unknowns: the unknown, and the sign.
    pub images: Vec<(u32, u32, f32)>,
}

pub(super) fn assemble(level: &CubicLevel) -> CoarsestMatrix {
    let grid = level.grid();
    let mut entries = Vec::new();
    let mut unknown = [0, 1, 2].map(|_| vec![NONE; grid.len()]);
    let mut signs = [0, 1, 2].map(|_| vec![1.0; grid.len()]);
    grid.for_each(|_, place| {
        let free = level.block(place).1;
        for c in (0..3).filter(|&c| free[c] == 1.0) {
            unknown[c][place] = entries.len() as u32;
            entries.push((c * grid.len() + place) as u32);
        }
    });
    for c in 0..3 {
        grid.mirror(&mut unknown[c], |unknown, _| unknown);
        grid.mirror(&mut signs[c], |sign: f64, axis| if axis == c { -sign } else { sign });
    }
    let size = entries.len();
    let mut matrix = TriMat::new((size, size));
    let mut add = |row: u32, column: u32, value: f64| {
        if row != NONE && column != NONE && row >= column {
            matrix.add_triplet(row as usize, column as usize, value);
        }
    };
    grid.for_each(|_, place| {
        let stiffness = level.block(place).0;
        for c in 0..3 {
            for d in 0..3 {
                add(unknown[c][place], unknown[d][place], f64::from(stiffness[c][d]));
            }
        }
        for (step, block) in level.stencil.steps.iter().zip(&level.stencil.blocks) {
            let away = grid.away(*step);
            for other in [place.wrapping_add_signed(away), place.wrapping_add_signed(-away)] {
                for c in 0..3 {
                    for d in 0..3 {
                        add(unknown[c][place], unknown[d][other], -block[c][d] * signs[d][other]);
                    }
                }
            }
        }
    });
    for gap in level.gaps.list() {
        let block = &level.stencil.blocks[gap.step];
        let scale = |at: usize| f64::from(level.inverse_scale[at]);
        let [p, q] = gap.ends;
        for c in 0..3 {
            for d in 0..3 {
                add(unknown[c][p], unknown[d][p], -block[c][d] * scale(p) / scale(q));
                add(unknown[c][q], unknown[d][q], -block[c][d] * scale(q) / scale(p));
                add(unknown[c][p], unknown[d][q], block[c][d]);
                add(unknown[c][q], unknown[d][p], block[c][d]);
            }
        }
    }
    let mut images = Vec::new();
    for c in 0..3 {
        let own = |place: usize| {
            entries.get(unknown[c][place] as usize) == Some(&((c * grid.len() + place) as u32))
        };
        let is_image = |place: &usize| unknown[c][*place] != NONE && !own(*place);
        let image =
            |place: usize| ((c * grid.len() + place) as u32, unknown[c][place], signs[c][place] as f32);
        images.extend((0..grid.len()).filter(is_image).map(image));
    }
    CoarsestMatrix { matrix: matrix.to_csr(), entries, images }
}
