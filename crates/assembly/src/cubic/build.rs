//! What points beside faces have instead of the block of a whole family.

use super::cells::{Cells, FOLLOWING, SOLID};
use super::stencil::Stencil;
use crate::bonds::Mat;
use std::collections::HashMap;

/// Bonds of points beside faces are at most this much stiffer at one end.
const MOST: f64 = 2.0;

/// The points of a level by what they have: numbers into a table, per place.
pub(super) struct Blocks {
    pub(super) of: Vec<u32>,
    pub(super) table: Vec<Block>,
}

/// What points of a kind have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Block {
    /// `D̂`.
    pub(super) stiffness: Mat<3, 3>,
    /// What stands in for the operator at the point when it is smoothed.
    pub(super) smoother: Mat<3, 3>,
    /// One for components that are free, zero for those that rest.
    pub(super) free: [f64; 3],
    /// Whether a component follows others.
    pub(super) follows: [bool; 3],
    /// `1/s`, zero for cells that are not of the body.
    pub(super) inverse_scale: f64,
}

/// Number of the cells that are not of the body.
const OUTSIDE: u32 = 0;
/// Number of the points that have all bonds.
pub(super) const WHOLE: u32 = 1;

/// Blocks of all points; with the bonds as they are, `are_bare`, or stiffer ones beside faces.
pub(super) fn blocks(cells: &Cells, stencil: &Stencil, are_bare: bool) -> Blocks {
    let grid = &cells.grid;
    let aways: Vec<isize> = stencil.steps.iter().map(|step| grid.away(*step)).collect();
    let reach = stencil.reach();
    let inner = Inner::new(cells, reach);
    let scale = scales(cells, stencil, &aways, &inner);
    let zero = [[0.0; 3]; 3];
    let outside =
        Block { stiffness: zero, smoother: zero, free: [0.0; 3], follows: [false; 3], inverse_scale: 0.0 };
    let all = stencil.whole();
    let whole =
        Block { stiffness: all, smoother: all, free: [1.0; 3], follows: [false; 3], inverse_scale: 1.0 };
    let mut blocks = Blocks { of: vec![OUTSIDE; grid.len()], table: vec![outside, whole] };
    let mut known: HashMap<([u32; 22], u8), u32> = HashMap::new();
    let deep = inner.shrunk(cells, reach);
    grid.for_each(|_, place| {
        if !cells.is_solid(place) {
            return;
        }
        let held = cells.state[place] & !SOLID;
        let spring = cells.springs.get(&place);
        if held == 0 && spring.is_none() && deep.has(place) {
            blocks.of[place] = WHOLE;
            return;
        }
        let own = f64::from(scale[place]);
        let (mut smoother, mut bare) = (zero, zero);
        for (away, block) in aways.iter().zip(&stencil.blocks) {
            let ends = [place.wrapping_add_signed(*away), place.wrapping_add_signed(-*away)];
            let scales = ends.map(|end| f64::from(scale[end]));
            add(&mut smoother, own * (scales[0] + scales[1]), block);
            add(&mut bare, scales.iter().filter(|scale| **scale > 0.0).count() as f64, block);
        }
        if let Some(spring) = spring {
            [&mut smoother, &mut bare].into_iter().for_each(|sum| add(sum, 1.0, spring));
        }
        let own = if are_bare { 1.0 } else { own };
        let scaled = smoother.map(|row| row.map(|k| k / (own * own)));
        let (stiffness, smoother) = if are_bare { (bare, smoother) } else { (scaled, scaled) };
        let free = [0, 1, 2].map(|c| if held & 1 << c == 0 { 1.0 } else { 0.0 });
        let follows = [0, 1, 2].map(|c| held & 1 << (FOLLOWING + c) != 0);
        let block = Block { stiffness, smoother, free, follows, inverse_scale: 1.0 / own };
        let number = known.entry((key(&block), held)).or_insert_with(|| {
            blocks.table.push(block);
            blocks.table.len() as u32 - 1
        });
        blocks.of[place] = *number;
    });
    blocks
}

/// `sum += factor · block`
fn add(sum: &mut Mat<3, 3>, factor: f64, block: &Mat<3, 3>) {
    (0..9).for_each(|k| sum[k / 3][k % 3] += factor * block[k / 3][k % 3]);
}

/// Blocks that agree in these bits are one.
fn key(block: &Block) -> [u32; 22] {
    let mats = block.stiffness.as_flattened().iter().chain(block.smoother.as_flattened());
    let numbers = mats.chain(&block.free).chain([&block.inverse_scale]);
    let mut key = [0; 22];
    key.iter_mut().zip(numbers).for_each(|(key, number)| *key = (*number as f32).to_bits());
    key
}

/// Per place: s, zero outside. A point whose bonds are a part of those of a whole family has the root of its inverse.
fn scales(cells: &Cells, stencil: &Stencil, aways: &[isize], inner: &Inner) -> Vec<f32> {
    let mut scale = vec![0.0; cells.grid.len()];
    let all: f64 = 2.0 * stencil.shares.iter().sum::<f64>();
    cells.grid.for_each(|_, place| {
        if !cells.is_solid(place) {
            return;
        }
        if inner.has(place) {
            scale[place] = 1.0;
            return;
        }
        let mut own = 0.0;
        for (away, share) in aways.iter().zip(&stencil.shares) {
            let ends = [place.wrapping_add_signed(*away), place.wrapping_add_signed(-*away)];
            own += share * ends.into_iter().filter(|&end| cells.is_solid(end)).count() as f64;
        }
        scale[place] = if own > 0.0 { (all / own).sqrt().min(MOST) as f32 } else { MOST as f32 };
    });
    cells.grid.mirror(&mut scale, |scale, _| scale);
    scale
}

/// Points around which all cells of a cube belong to the body.
struct Inner(Vec<bool>);

impl Inner {
    fn new(cells: &Cells, reach: usize) -> Self {
        Self(cells.state.iter().map(|state| state & SOLID != 0).collect()).shrunk(cells, reach)
    }

    fn has(&self, place: usize) -> bool {
        self.0[place]
    }

    /// Those around which all points of a cube are such ones.
    fn shrunk(&self, cells: &Cells, reach: usize) -> Self {
        let grid = &cells.grid;
        let mut inner = self.0.clone();
        for stride in grid.strides {
            let before = inner.clone();
            grid.for_each(|_, place| {
                inner[place] = (0..=2 * reach).all(|k| before[place + k * stride - reach * stride]);
            });
            grid.mirror(&mut inner, |is_inner, _| is_inner);
        }
        Self(inner)
    }
}
