//! Which cells of a plate have which section.

use super::{PlateNodes, PlateSection};

/// The sections of cells, as far as they are other than that of the whole plate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CellSections {
    /// Those beside the first.
    pub others: Vec<PlateSection>,
    /// Per cell 0 for the first section, else a place among the others, from 1 on; none where there are no others.
    pub numbers: Vec<u32>,
}

impl CellSections {
    /// Number of the section of a cell; none where there is no cell.
    pub fn number(&self, nodes: &PlateNodes, [column, row]: [i32; 2]) -> Option<usize> {
        let cell = nodes.cells().number([column, row, 0])?;
        Some(self.numbers.get(cell).map_or(0, |number| *number as usize))
    }

    /// Numbers of the sections of the cells about a point, and the parts of an area h² that these have.
    pub fn about(&self, nodes: &PlateNodes, point: usize) -> Vec<(usize, f64)> {
        let [i, j] = nodes.node(point);
        let mut found: Vec<(usize, f64)> = Vec::with_capacity(4);
        for number in nodes.cells_about([i, j]).filter_map(|cell| self.number(nodes, cell)) {
            match found.iter_mut().find(|known| known.0 == number) {
                Some(known) => known.1 += 0.25,
                None => found.push((number, 0.25)),
            }
        }
        found
    }

    /// Those of cells twice as large: each has the section of most of the cells in it, and of the stiffer one of two alike.
    pub(super) fn coarser(&self, fine: &PlateNodes, coarse: &PlateNodes, first: &PlateSection) -> Self {
        if self.others.is_empty() {
            return Self::default();
        }
        let bending =
            |number: usize| if number == 0 { first.bending } else { self.others[number - 1].bending };
        let number = |[column, row]: [i32; 2]| {
            let own = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[a, b]| [2 * column + a, 2 * row + b]);
            let found: Vec<usize> = own.into_iter().filter_map(|cell| self.number(fine, cell)).collect();
            let count = |number: usize| found.iter().filter(|own| **own == number).count();
            let more = |a: &&usize, b: &&usize| {
                count(**a).cmp(&count(**b)).then(bending(**a).total_cmp(&bending(**b)))
            };
            found.iter().max_by(more).map_or(0, |number| *number as u32)
        };
        Self { others: self.others.clone(), numbers: coarse.all_cells().map(number).collect() }
    }

    /// Whether a cell is there and has the section of a number.
    pub(super) fn has(&self, nodes: &PlateNodes, number: usize, cell: [i32; 2]) -> bool {
        self.number(nodes, cell) == Some(number)
    }
}
