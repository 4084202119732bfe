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
        let mut lowest = self.lowest(first as u32);
        for point in first + 1..=last {
            if self.lower[point] as usize == point {
                self.lower[point] = lowest;
            } else {
                self.join(first, point);
                lowest = self.lowest(first as u32);
            }
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
        let mut parts = NumberedParts { spans: Vec::new(), intervals: Vec::new() };
        let mut labels = self.lower;
        for point in 0..labels.len() {
            // Lower points have the numbers of their parts already.
            let label = match labels[point] as usize {
                lower if lower == point => {
                    parts.spans.push([point, point]);
                    parts.spans.len() as u32 - 1
                }
                lower => labels[lower],
            };
            labels[point] = label;
            parts.spans[label as usize][1] = point;
            if parts.intervals.last().is_none_or(|interval| interval.1 != label) {
                parts.intervals.push((point as u32, label));
            }
        }
        parts
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
