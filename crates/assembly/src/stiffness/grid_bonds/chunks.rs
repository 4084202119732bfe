//! Points in chunks: stretches of at most 64 points of one row, their neighbours, and the factors of exceptional bonds.

use crate::body::{Cell, SquareLattice};
use std::ops::Range;

/// Points per chunk: the inner loops run over one chunk of one offset.
pub(super) const CHUNK: usize = 64;
/// Chunks that one thread takes at a time: fixed, so that sums over them do not depend on the number of threads.
const PART: usize = 64;
/// No place in a table.
const NONE: u32 = u32::MAX;

/// A bond whose stiffness differs from that of its offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exception {
    /// Index of the offset.
    pub offset: usize,
    /// Lower point.
    pub lower: usize,
    /// Multiplies the moduli; zero where the bond is cut.
    pub factor: f64,
}

/// Consecutive points of one row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chunk {
    pub(super) first: u32,
    /// Row and layer.
    pub(super) line: [i32; 2],
    pub(super) from: i32,
    pub(super) width: u32,
    /// Which table has the moduli of the bonds of its points.
    table: u8,
    /// Place of its factors in the table, where some are not one.
    factors: u32,
    /// Whether every measure of a bond has a factor.
    is_spread: bool,
    /// What it has beside it, where that is simple.
    pub(super) beside: Option<Beside>,
    /// Whether its points have all neighbours within the reach.
    pub(super) is_inner: bool,
}

/// Lines beside a chunk that all go as far beyond its ends, as far as bonds reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    /// Cells before the first column and behind the last one.
    pub(super) clip: [i32; 2],
    /// Place of the lines in the table.
    begin: u32,
}

impl Chunk {
    pub(super) fn columns(&self) -> Range<i32> {
        self.from..self.from + self.width as i32
    }

    /// Whether no bond of its points is an exception.
    pub(super) fn is_plain(&self) -> bool {
        self.factors == NONE
    }

    /// Which table has the moduli of the bonds of its points.
    pub(super) fn table(&self) -> usize {
        usize::from(self.table)
    }
}

/// The chunks of a lattice.
#[derive(Clone, Debug)]
pub(super) struct Chunks {
    all: Vec<Chunk>,
    /// Largest offset, rows or columns.
    reach: i32,
    /// Largest offset, layers; none in a plane.
    layers: i32,
    /// Place of the own line among those within the reach.
    middle: usize,
    offsets: usize,
    /// Measures of a bond.
    measures: usize,
    /// Per chunk with simple lines beside it, layer `-layers..=layers` and row `-reach..=reach`: number of the point in the chunk's
    /// first column; none where there is no such line.
    lines: Vec<u32>,
    /// Per exceptional chunk, `[offset][upwards or downwards][point]`: factors of the bonds of its points as the lower
    /// and as the upper one. Where every measure of a bond has one, `[offset][upwards or downwards][measure][point]`.
    factors: Vec<f64>,
}

impl Chunks {
    pub(super) fn new(lattice: &SquareLattice, (steps, measures): (&[Cell], usize)) -> Self {
        let reach = steps.iter().flat_map(|[a, b, _]| [a.abs(), b.abs()]).max().unwrap_or(0);
        let layers = steps.iter().map(|step| step[2].abs()).max().unwrap_or(0);
        let mut chunks = Self {
            all: Vec::new(),
            reach,
            layers,
            middle: (layers * (2 * reach + 1) + reach) as usize,
            lines: Vec::new(),
            offsets: steps.len(),
            measures,
            factors: Vec::new(),
        };
        for run in lattice.runs() {
            for from in run.columns.clone().step_by(CHUNK) {
                let width = (run.columns.end - from).min(CHUNK as i32);
                let columns = from..from + width;
                let beside = chunks.beside(lattice, run.line(), &columns);
                let is_inner = beside.is_some_and(|beside| chunks.are_all(&beside));
                chunks.all.push(Chunk {
                    first: run.number(from) as u32,
                    line: run.line(),
                    from,
                    width: width as u32,
                    table: 0,
                    factors: NONE,
                    is_spread: false,
                    beside,
                    is_inner,
                });
            }
        }
        chunks
    }

    /// Enters the lines beside a chunk into the table if each of them is not there or goes as far as the others.
    fn beside(&mut self, lattice: &SquareLattice, line: [i32; 2], columns: &Range<i32>) -> Option<Beside> {
        let wide = columns.start - self.reach..columns.end + self.reach;
        let begin = self.lines.len();
        let mut clip: Option<[i32; 2]> = None;
        for step in self.lines() {
            let mut found: Vec<(Range<i32>, usize)> = Vec::new();
            lattice.shifted(line, &wide, step, |range, first| found.push((range, first)));
            let own = match &found[..] {
                [] => None,
                [(range, _)] => Some([columns.start - range.start, range.end - columns.end]),
                _ => Some([-1; 2]),
            };
            let differs =
                own.is_some_and(|own| own.iter().any(|k| *k < 0) || clip.is_some_and(|clip| clip != own));
            if differs {
                self.lines.truncate(begin);
                return None;
            }
            clip = clip.or(own);
            let number =
                |(range, first): &(Range<i32>, usize)| *first as u32 + (columns.start - range.start) as u32;
            self.lines.push(found.first().map_or(NONE, number));
        }
        Some(Beside { clip: clip?, begin: begin as u32 })
    }

    /// Whether there are lines within the whole reach, all of them.
    fn are_all(&self, beside: &Beside) -> bool {
        let lines = &self.lines[beside.begin as usize..];
        beside.clip == [self.reach; 2] && lines.iter().take(self.lines().count()).all(|line| *line != NONE)
    }

    /// Numbers of the points in the first column of a chunk at an offset, upwards and downwards, from the lines beside it.
    #[inline(always)]
    pub(super) fn lines_at(&self, beside: &Beside, [_, across, layer]: Cell) -> [Option<usize>; 2] {
        let away = (layer * (2 * self.reach + 1) + across) as isize;
        let middle = beside.begin as usize + self.middle;
        [away, -away].map(|away| {
            let number = self.lines[middle.wrapping_add_signed(away)];
            (number != NONE).then_some(number as usize)
        })
    }

    /// Steps to the lines within the reach.
    pub(super) fn lines(&self) -> impl Iterator<Item = Cell> + use<> {
        let (reach, layers) = (self.reach, self.layers);
        (-layers..=layers).flat_map(move |layer| (-reach..=reach).map(move |row| [0, row, layer]))
    }

    pub(super) fn multiply(&mut self, plane: usize, point: usize, factor: f64) {
        let index = self.index_of(point);
        let chunk = &mut self.all[index];
        if chunk.factors == NONE {
            chunk.factors = self.factors.len() as u32;
            self.factors.resize(self.factors.len() + 2 * self.offsets * CHUNK, 1.0);
        }
        let (chunk, k) = (self.all[index], point - self.all[index].first as usize);
        let planes = if chunk.is_spread { self.measures } else { 1 };
        for plane in plane * planes..(plane + 1) * planes {
            self.factors[chunk.factors as usize + plane * CHUNK + k] *= factor;
        }
    }

    /// Gives chunks the tables of their points, `of` every one; those of several get a factor for every measure of a bond.
    pub(super) fn take_tables<const M: usize>(&mut self, of: &[u8], tables: &[&[[f64; M]]]) {
        for index in 0..self.all.len() {
            let (first, width) = (self.all[index].first as usize, self.all[index].width as usize);
            let Some(own) = of.get(first..first + width) else { return };
            self.all[index].table = own[0];
            if own.iter().any(|table| *table != own[0]) {
                self.spread(index, own, tables);
            }
        }
    }

    /// Gives every measure of the bonds of a chunk a factor: the weight in the table of its point. The moduli of the chunk are then
    /// those of unit weights, which follow `tables`.
    fn spread<const M: usize>(&mut self, index: usize, of: &[u8], tables: &[&[[f64; M]]]) {
        let chunk = &mut self.all[index];
        (chunk.factors, chunk.is_spread, chunk.table) = (self.factors.len() as u32, true, tables.len() as u8);
        for plane in 0..2 * self.offsets * M {
            let (offset, measure) = (plane / (2 * M), plane % M);
            let weight = |table: &u8| tables[usize::from(*table)][offset][measure];
            let unused = std::iter::repeat_n(1.0, CHUNK - of.len());
            self.factors.extend(of.iter().map(weight).chain(unused));
        }
    }

    /// Gives the bond of an offset upwards (0) or downwards (1) from a point weights of its own; before any bond of the chunk gets a
    /// factor for all measures.
    pub(super) fn weigh<const M: usize>(
        &mut self,
        (plane, point): (usize, usize),
        weights: [f64; M],
        (of, tables): (&[u8], &[&[[f64; M]]]),
    ) {
        let index = self.index_of(point);
        let (first, width) = (self.all[index].first as usize, self.all[index].width as usize);
        if self.all[index].factors == NONE {
            self.spread(index, &of[first..first + width], tables);
        }
        let chunk = &self.all[index];
        debug_assert!(chunk.is_spread, "no bond of the chunk has a factor for all");
        let start = chunk.factors as usize + point - first;
        for (plane, weight) in (plane * M..).zip(weights) {
            self.factors[start + plane * CHUNK] = weight;
        }
    }

    fn index_of(&self, point: usize) -> usize {
        self.all.partition_point(|c| c.first as usize <= point) - 1
    }

    /// Chunk of a point and its place there.
    pub(super) fn of(&self, point: usize) -> (&Chunk, usize) {
        let chunk = &self.all[self.index_of(point)];
        (chunk, point - chunk.first as usize)
    }

    pub(super) fn all(&self) -> &[Chunk] {
        &self.all
    }

    /// Parts of the chunks that one thread takes at a time.
    pub(super) fn parts(&self) -> std::slice::Chunks<'_, Chunk> {
        self.all.chunks(PART)
    }

    /// Factor of a measure of the bond of an offset whose lower point is the k-th of a chunk.
    pub(super) fn factor(&self, chunk: &Chunk, (offset, measure): (usize, usize), k: usize) -> f64 {
        self.factors_of(chunk, (offset, 0), measure).map_or(1.0, |factors| factors[k])
    }

    /// Factors of a measure of the bonds of an offset, upwards (0) or downwards (1) from the points of a chunk.
    #[inline(always)]
    pub(super) fn factors_of(
        &self,
        chunk: &Chunk,
        (offset, side): (usize, usize),
        measure: usize,
    ) -> Option<&[f64; CHUNK]> {
        if chunk.factors == NONE {
            return None;
        }
        let plane = 2 * offset + side;
        let plane = if chunk.is_spread { plane * self.measures + measure } else { plane };
        self.factors[chunk.factors as usize + plane * CHUNK..].first_chunk()
    }

    /// Largest offset, rows or columns.
    pub(super) fn reach(&self) -> i32 {
        self.reach
    }

    pub(super) fn stored_factors(&self) -> usize {
        self.factors.len()
    }
}
