//! A lattice in boxes with about the same number of points, one per process.

use peristat_assembly::body::{Cell, SquareLattice};
use std::ops::Range;

/// Boxes by halves of halves of the lattice, across its longest side each time. They fill all space.
pub(super) struct Boxes {
    root: Node,
    ranges: Vec<[Range<i32>; 3]>,
}

enum Node {
    One(usize),
    /// Cells below `at` along an axis, and all others.
    Halves {
        axis: usize,
        at: i32,
        halves: Box<[Node; 2]>,
    },
}

impl Boxes {
    /// So many boxes; none where one of them would have no point.
    pub(super) fn new(lattice: &SquareLattice, count: usize) -> Option<Self> {
        let whole = [lattice.columns(), lattice.rows(), lattice.layers()];
        let mut ranges = Vec::new();
        let root = split(lattice, whole, count, &mut ranges)?;
        Some(Self { root, ranges })
    }

    /// The process that owns a cell.
    pub(super) fn owner(&self, cell: Cell) -> usize {
        let mut node = &self.root;
        loop {
            match node {
                Node::One(process) => return *process,
                Node::Halves { axis, at, halves } => node = &halves[usize::from(cell[*axis] >= *at)],
            }
        }
    }

    /// The box of a process, `width` cells wider on every side.
    pub(super) fn widened(&self, process: usize, width: i32) -> [Range<i32>; 3] {
        self.ranges[process].clone().map(|range| range.start - width..range.end + width)
    }
}

/// Splits a box for so many processes, and adds the ranges of each.
fn split(
    lattice: &SquareLattice,
    own: [Range<i32>; 3],
    count: usize,
    ranges: &mut Vec<[Range<i32>; 3]>,
) -> Option<Node> {
    let axis = (0..3).max_by_key(|&axis| own[axis].len())?;
    let along = counts(lattice, &own, axis);
    let total: usize = along.iter().sum();
    if total < count {
        return None;
    }
    if count == 1 {
        ranges.push(own);
        return Some(Node::One(ranges.len() - 1));
    }
    let below = count / 2;
    let (mut sum, mut length) = (0, 0);
    while length < along.len() - 1 && (sum + along[length] / 2) * count < total * below {
        sum += along[length];
        length += 1;
    }
    let at = own[axis].start + length as i32;
    let half = |range: Range<i32>| {
        let mut half = own.clone();
        half[axis] = range;
        half
    };
    let low = split(lattice, half(own[axis].start..at), below, ranges)?;
    let high = split(lattice, half(at..own[axis].end), count - below, ranges)?;
    Some(Node::Halves { axis, at, halves: Box::new([low, high]) })
}

/// Points of a box by their places along an axis.
fn counts(lattice: &SquareLattice, own: &[Range<i32>; 3], axis: usize) -> Vec<usize> {
    let mut counts = vec![0; own[axis].len()];
    for run in lattice.runs().iter().filter(|run| own[1].contains(&run.row) && own[2].contains(&run.layer)) {
        let (from, to) = (run.columns.start.max(own[0].start), run.columns.end.min(own[0].end));
        if from >= to {
            continue;
        }
        match axis {
            0 => (from..to).for_each(|column| counts[(column - own[0].start) as usize] += 1),
            _ => counts[(run.cell(from)[axis] - own[axis].start) as usize] += (to - from) as usize,
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_has_one_owner_and_boxes_are_about_as_large() {
        let hole = |[i, j, _]: Cell| (i - 10).pow(2) + (j - 8).pow(2) < 20;
        let lattice = SquareLattice::new(1.0, [0.0; 3], [0..41, 0..17, 0..5], |cell| !hole(cell));
        for count in 1..=9 {
            let boxes = Boxes::new(&lattice, count).unwrap();
            let mut owned = vec![0; count];
            for point in 0..lattice.points() {
                let cell = lattice.cell(point);
                let owner = boxes.owner(cell);
                owned[owner] += 1;
                let inside =
                    |k: usize| boxes.widened(k, 0).iter().zip(cell).all(|(range, k)| range.contains(&k));
                assert_eq!((0..count).filter(|&k| inside(k)).collect::<Vec<_>>(), [owner]);
            }
            let mean = lattice.points() as f64 / count as f64;
            assert!(owned.iter().all(|&k| (k as f64 / mean - 1.0).abs() < 0.15), "{count}: {owned:?}");
        }
    }

    #[test]
    fn no_process_is_left_without_a_point() {
        let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [3, 1]);
        assert!(Boxes::new(&lattice, 3).is_some() && Boxes::new(&lattice, 4).is_none());
    }
}
