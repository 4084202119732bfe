//! The bonds that pass triangles which are not whole, and what they leave to triangles.

use super::super::super::neighbourhood::Neighbourhood;
use super::blocks::Blocks;
use super::pieces::{Piece, pieces};
use crate::body::{Cell, minus, plus};
use std::cell::RefCell;
use std::collections::HashMap;

/// The bonds that pass triangles which are not whole.
pub(super) struct Missing<'a> {
    blocks: &'a Blocks<'a>,
    offsets: &'a [Cell],
    /// Offsets that have bonds, and the triangles that they pass.
    pub(super) paths: Vec<(usize, Vec<Piece>)>,
    known: RefCell<HashMap<(usize, Cell), bool>>,
}

impl<'a> Missing<'a> {
    pub(super) fn new<const M: usize>(blocks: &'a Blocks<'a>, neighbourhood: &'a Neighbourhood<M>) -> Self {
        let paths = neighbourhood.bonded().map(|k| (k, pieces(neighbourhood.offsets[k]))).collect();
        Self { blocks, offsets: &neighbourhood.offsets, paths, known: RefCell::default() }
    }

    /// Whether a bond passes a triangle that is not whole; in a body of revolution, a block that is not: what its bonds have of
    /// both its halves is right only together.
    fn is_missing(&self, path: usize, from: Cell) -> bool {
        if let Some(known) = self.known.borrow().get(&(path, from)) {
            return *known;
        }
        let passes = |piece: &Piece| {
            let block = plus(from, piece.block);
            match self.blocks.mirrors.revolved {
                true => !self.blocks.is_whole(block),
                false => self.blocks.parts(block)[piece.triangle] < 1.0,
            }
        };
        let is_missing = self.paths[path].1.iter().any(passes);
        self.known.borrow_mut().insert((path, from), is_missing);
        is_missing
    }

    /// How many of the two bonds of a path that begin or end at a cell are missing.
    pub(super) fn lacks(&self, path: usize, cell: Cell) -> u8 {
        let offset = self.offsets[self.paths[path].0];
        let ends = [cell, minus(cell, offset)];
        ends.into_iter().map(|from| u8::from(self.is_missing(path, from))).sum()
    }

    /// Calls `visit` with the offset and both ends of every bond that is missing and passes a block which is not whole.
    pub(super) fn for_each_gap(&self, at: Cell, visit: &mut dyn FnMut(usize, Cell, Cell)) {
        if self.blocks.is_whole(at) {
            return;
        }
        for (path, (k, pieces)) in self.paths.iter().enumerate() {
            for piece in pieces {
                let from = minus(at, piece.block);
                if self.is_missing(path, from) {
                    visit(*k, from, plus(from, self.offsets[*k]));
                }
            }
        }
    }

    /// What bonds leave to a triangle, by offset: all of its part if that is not whole, else what missing ones would have had. In a
    /// body of revolution a bond counts by the radius of its middle, and a part by that of its own.
    pub(super) fn of(&self, at: Cell, triangle: usize, part: f64) -> Vec<f64> {
        let is_left_all = match self.blocks.mirrors.revolved {
            true => !self.blocks.is_whole(at),
            false => part < 1.0,
        };
        let column = f64::from(at[0]);
        let whole = 0.25 * part * self.blocks.weight(column + self.blocks.centre(at, triangle)[0]);
        let of = |(path, (k, pieces)): (usize, &(usize, Vec<Piece>))| {
            let own = pieces.iter().filter(|piece| piece.triangle == triangle);
            let is_missing = |piece: &&Piece| self.is_missing(path, minus(at, piece.block));
            let middle = |piece: &Piece| 0.5 * f64::from(self.offsets[*k][0]) - f64::from(piece.block[0]);
            let share = |piece: &Piece| piece.share * self.blocks.weight(column + middle(piece));
            match is_left_all {
                true => whole,
                false => own.filter(is_missing).map(share).sum(),
            }
        };
        self.paths.iter().enumerate().map(of).collect()
    }
}
