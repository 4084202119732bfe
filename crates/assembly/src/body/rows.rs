//! Sets of cells as ranges of columns per row.

use super::convex::Convex;
use super::geometry::Point;
use std::ops::Range;

/// Columns of a row between two positions, both counted, if centres have whole coordinates and columns are `0..columns`.
pub(super) fn columns_between([from, to]: [f64; 2], columns: i32) -> Range<i32> {
    let end = f64::from(columns);
    from.ceil().clamp(0.0, end) as i32..(to.floor() + 1.0).clamp(0.0, end) as i32
}

/// Cells of a grid, as ranges of columns per row.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    columns: i32,
    ranges: Vec<Vec<Range<i32>>>,
}

impl Rows {
    pub(super) fn new([columns, rows]: [i32; 2]) -> Self {
        Self { columns, ranges: vec![Vec::new(); rows as usize] }
    }

    /// Cells whose centres are in a closed polygon, borders aside: an even number of edges is crossed on the way out.
    ///
    /// Positions are in cells, centres have whole coordinates. A centre within rounding of the border falls to either side.
    pub(super) fn inside(size: [i32; 2], vertices: &[Point]) -> Self {
        let mut crossings = vec![Vec::new(); size[1] as usize];
        for (k, b) in vertices.iter().enumerate() {
            let a = vertices[(k + vertices.len() - 1) % vertices.len()];
            // A row crosses if exactly one end is at or below it.
            let [low, high] = [a[1].min(b[1]), a[1].max(b[1])].map(f64::ceil);
            for row in columns_between([low, high - 1.0], size[1]) {
                let t = (f64::from(row) - a[1]) / (b[1] - a[1]);
                crossings[row as usize].push(a[0] + t * (b[0] - a[0]));
            }
        }
        let mut rows = Self::new(size);
        for (found, ranges) in crossings.iter_mut().zip(&mut rows.ranges) {
            found.sort_by(f64::total_cmp);
            let pairs = found.chunks_exact(2).map(|p| columns_between([p[0], p[1]], size[0]));
            ranges.extend(pairs);
        }
        rows.merged()
    }

    /// Cells whose centres are within `slack` of the border of a polygon.
    pub(super) fn border(size: [i32; 2], vertices: &[Point], slack: f64) -> Self {
        let mut rows = Self::new(size);
        for (k, &to) in vertices.iter().enumerate() {
            let from = vertices[(k + vertices.len() - 1) % vertices.len()];
            rows.add(&Convex::Stadium { from, to, radius: slack });
        }
        rows.merged()
    }

    /// Cells whose centres are in a convex part of the plane.
    pub(super) fn within(size: [i32; 2], part: &Convex) -> Self {
        let mut rows = Self::new(size);
        rows.add(part);
        rows.merged()
    }

    fn add(&mut self, part: &Convex) {
        for row in columns_between(part.rows(), self.ranges.len() as i32) {
            if let Some(found) = part.row(f64::from(row)) {
                self.ranges[row as usize].push(columns_between(found, self.columns));
            }
        }
    }

    /// Ranges of a row from left to right, none empty, none touching.
    fn merged(mut self) -> Self {
        for ranges in &mut self.ranges {
            ranges.retain(|r| !r.is_empty());
            ranges.sort_by_key(|r| r.start);
            ranges.dedup_by(|next, last| {
                let joined = next.start <= last.end;
                if joined {
                    last.end = last.end.max(next.end);
                }
                joined
            });
        }
        self
    }

    pub(super) fn or(mut self, other: Self) -> Self {
        for (ranges, more) in self.ranges.iter_mut().zip(other.ranges) {
            ranges.extend(more);
        }
        self.merged()
    }

    pub(super) fn without(mut self, other: &Self) -> Self {
        for (ranges, removed) in self.ranges.iter_mut().zip(&other.ranges) {
            if removed.is_empty() {
                continue;
            }
            let mut left = Vec::with_capacity(ranges.len() + removed.len());
            for range in ranges.iter() {
                let mut from = range.start;
                for gap in removed.iter().filter(|g| g.end > range.start && g.start < range.end) {
                    left.push(from..gap.start);
                    from = gap.end;
                }
                left.push(from..range.end);
            }
            *ranges = left;
        }
        self.merged()
    }

    /// Whether the sets share a cell.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let shared = |(a, b): (&Vec<Range<i32>>, &Vec<Range<i32>>)| {
            a.iter().any(|r| b.iter().any(|s| r.start < s.end && s.start < r.end))
        };
        self.ranges.iter().zip(&other.ranges).any(shared)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.ranges.iter().all(Vec::is_empty)
    }

    pub(super) fn contains(&self, [column, row]: [i32; 2]) -> bool {
        self.ranges[row as usize].iter().any(|r| r.contains(&column))
    }
}
