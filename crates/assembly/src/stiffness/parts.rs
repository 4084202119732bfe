//! Connected parts of a body.

use std::ops::RangeInclusive;

/// Points joined by whatever couples them.
#[derive(Clone, Debug)]
pub struct ConnectedParts {
    /// Per point: itself, or a lower point of the same part. Following them leads to the lowest one.
    lower: Vec<u32>,
}

/// The parts, numbered in the order of their first points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NumberedParts {
    /// First and last point of every part.
    spans: Vec<[usize; 2]>,
    /// First points of intervals that belong to one part, and the part.
    intervals: Vec<(u32, u32)>,
}

impl ConnectedParts {
    /// Every point by itself.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn new(points: usize) -> Self {
        let points = u32::try_from(points).expect("points are numbered by u32");
        Self { lower: (0..points).collect() }
    }

    /// Points `i` and `j` hang together.
    pub fn join(&mut self, i: usize, j: usize) {
        let (a, b) = (self.lowest(i as u32), self.lowest(j as u32));
        self.lower[a.max(b) as usize] = a.min(b);
    }

    /// All points of a range hang together.
    pub fn join_run(&mut self, range: RangeInclusive<usize>) {
        let (first, last) = (*range.start(), *range.end());
        let lowest = self.lowest(first as u32);
        let others = &mut self.lower[first + 1..=last];
        if others.iter().zip(first as u32 + 1..).all(|(lower, point)| *lower == point) {
            others.fill(lowest);
        } else {
            (first + 1..=last).for_each(|point| self.join(first, point));
        }
    }

    /// The lowest point of a part, on the way to which all others come closer to it.
    fn lowest(&mut self, mut point: u32) -> u32 {
        while self.lower[point as usize] != point {
            let next = self.lower[self.lower[point as usize] as usize];
            self.lower[point as usize] = next;
            point = next;
        }
        point
    }

    /// The parts.
    pub fn numbered(self) -> NumberedParts {
        let mut lower = self.lower;
        let (mut spans, mut intervals): (Vec<[usize; 2]>, Vec<(u32, u32)>) = (Vec::new(), Vec::new());
        let mut lowest = u32::MAX;
        for point in 0..lower.len() {
            // Those before lead to the lowest point at once.
            let own = lower[lower[point] as usize];
            lower[point] = own;
            if own == lowest {
                continue;
            }
            lowest = own;
            if let Some((_, before)) = intervals.last() {
                spans[*before as usize][1] = point - 1;
            }
            if own as usize == point {
                spans.push([point, point]);
            }
            let part = spans.partition_point(|span| span[0] < own as usize);
            intervals.push((point as u32, part as u32));
        }
        if let Some((_, last)) = intervals.last() {
            spans[*last as usize][1] = lower.len() - 1;
        }
        NumberedParts { spans, intervals }
    }
}

impl NumberedParts {
    /// First and last point of every part.
    pub fn spans(&self) -> &[[usize; 2]] {
        &self.spans
    }

    /// Part of a point.
    pub fn of(&self, point: usize) -> usize {
        let next = self.intervals.partition_point(|interval| interval.0 as usize <= point);
        self.intervals[next - 1].1 as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(parts: ConnectedParts, points: usize) -> Vec<usize> {
        let parts = parts.numbered();
        (0..points).map(|p| parts.of(p)).collect()
    }

    #[test]
    fn parts_are_numbered_by_their_first_point() {
        let mut parts = ConnectedParts::new(6);
        parts.join(5, 1);
        parts.join(2, 3);
        parts.join(3, 5);
        assert_eq!(parts.clone().numbered().spans(), [[0, 0], [1, 5], [4, 4]]);
        assert_eq!(labels(parts, 6), [0, 1, 1, 1, 2, 1]);
    }

    #[test]
    fn runs_that_share_a_point_are_one() {
        let mut parts = ConnectedParts::new(12);
        parts.join_run(6..=9);
        parts.join_run(1..=3);
        parts.join_run(3..=4);
        parts.join(8, 11);
        assert_eq!(labels(parts, 12), [0, 1, 1, 1, 1, 2, 3, 3, 3, 3, 4, 3]);
    }
}
