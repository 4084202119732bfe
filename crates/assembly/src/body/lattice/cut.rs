//! Areas of the cells of a lattice that borders cut, and the parts of blocks beside them.

use super::{Cell, Centres, SquareLattice, TriangleParts};
use std::ops::Range;

impl SquareLattice {
    /// The lattice with areas of cells, per that of a whole one; other cells are whole. Cells without points have no area.
    pub fn with_areas(mut self, areas: &[(Cell, f64)]) -> Self {
        let numbered = areas.iter().filter(|a| a.1 != 1.0);
        self.cut = numbered.filter_map(|&(cell, area)| Some((self.number(cell)? as u32, area))).collect();
        self.cut.sort_unstable_by_key(|c| c.0);
        self
    }

    /// The lattice with parts of the triangles of blocks, by their lower left cells, where a border cuts them. Of others all is
    /// in the body if their four points are, else nothing.
    pub fn with_blocks(mut self, mut blocks: Vec<(Cell, TriangleParts)>) -> Self {
        blocks.sort_unstable_by_key(|block| block.0);
        self.blocks = blocks;
        self.centres = Vec::new();
        self
    }

    /// The lattice with the centres of the parts of its [`blocks`](Self::blocks), in their order.
    ///
    /// # Panics
    /// There is not one for every block.
    pub fn with_centres(mut self, centres: Vec<Centres>) -> Self {
        assert_eq!(centres.len(), self.blocks.len(), "every block has its centres");
        self.centres = centres;
        self
    }

    /// The lattice with the blocks of another one, their centres, and its slots.
    pub(crate) fn with_blocks_of(self, other: &Self) -> Self {
        let (blocks, centres) = (other.blocks.clone(), other.centres.clone());
        Self { blocks, centres, slots: other.slots.clone(), ..self }
    }

    /// Centres of the parts of all blocks, in their order; none where they are not known.
    pub fn centres(&self) -> &[Centres] {
        &self.centres
    }

    /// The blocks that a border cuts, ascending by their lower left cells, with the parts of their triangles; none where all cells
    /// are whole.
    pub fn blocks(&self) -> &[(Cell, TriangleParts)] {
        &self.blocks
    }

    /// The lattice with whole cells.
    pub fn with_whole_cells(self) -> Self {
        Self { cut: Vec::new(), blocks: Vec::new(), centres: Vec::new(), ..self }
    }

    /// Points that have not the area of a cell, ascending, and their areas per that of a cell.
    pub fn cut_cells(&self) -> &[(u32, f64)] {
        &self.cut
    }

    /// Those of [`cut_cells`](Self::cut_cells) among consecutive points.
    pub fn cut_cells_of(&self, points: Range<usize>) -> &[(u32, f64)] {
        let before = |end: usize| self.cut.partition_point(|&(p, _)| (p as usize) < end);
        &self.cut[before(points.start)..before(points.end)]
    }

    /// Area of a point per that of a whole cell.
    pub fn fraction(&self, point: usize) -> f64 {
        let found = self.cut.binary_search_by_key(&point, |c| c.0 as usize);
        found.map_or(1.0, |index| self.cut[index].1)
    }

    /// Area of a point, m².
    pub fn area(&self, point: usize) -> f64 {
        self.fraction(point) * (self.spacing * self.spacing)
    }

    /// Volume of a point of a solid, m³.
    pub fn volume(&self, point: usize) -> f64 {
        self.fraction(point) * self.spacing.powi(3)
    }
}
