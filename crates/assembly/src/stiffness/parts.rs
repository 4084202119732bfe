//! Connected parts of a body.

use std::ops::RangeInclusive;

/// Points joined by whatever couples them. What it stores grows with the gaps between runs of joined neighbours, not with
/// the number of points.
#[derive(Clone, Debug)]
pub struct ConnectedParts {
    points: usize,
    /// Runs of points each joined to the next, first and last.
    runs: Vec<[u32; 2]>,
    /// Other joined points, the lower one first.
    pairs: Vec<[u32; 2]>,
    /// Pairs that may pile up before those inside runs are dropped.
    room: usize,
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
        assert!(u32::try_from(points).is_ok(), "points are numbered by u32");
        Self { points, runs: Vec::new(), pairs: Vec::new(), room: 4096 }
    }

    /// Points `i` and `j` hang together.
    pub fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (i.min(j), i.max(j));
        if j - i <= 1 {
            self.join_run(i..=j);
        } else if !self.runs.last().is_some_and(|run| run[0] as usize <= i && j <= run[1] as usize) {
            self.pairs.push([i as u32, j as u32]);
            if self.pairs.len() > self.room {
                self.tidy();
                self.room = 4096.max(2 * self.pairs.len());
            }
        }
    }

    /// All points of a range hang together.
    pub fn join_run(&mut self, range: RangeInclusive<usize>) {
        let [first, last] = [*range.start() as u32, *range.end() as u32];
        match self.runs.last_mut() {
            Some(run) if run[0] <= first && first <= run[1] => run[1] = run[1].max(last),
            _ => self.runs.push([first, last]),
        }
    }

    /// Merges runs that share points and drops pairs inside them.
    fn tidy(&mut self) {
        self.runs.sort_unstable();
        let mut merged: Vec<[u32; 2]> = Vec::new();
        for &[first, last] in &self.runs {
            match merged.last_mut() {
                Some(run) if first <= run[1] => run[1] = run[1].max(last),
                _ => merged.push([first, last]),
            }
        }
        self.runs = merged;
        let run_of = |point: u32| {
            let next = self.runs.partition_point(|run| run[0] <= point);
            next.checked_sub(1).filter(|&k| point <= self.runs[k][1])
        };
        self.pairs.retain(|&[i, j]| run_of(i).is_none() || run_of(i) != run_of(j));
        self.pairs.sort_unstable();
        self.pairs.dedup();
    }

    /// The parts.
    pub fn numbered(mut self) -> NumberedParts {
        self.tidy();
        // Runs and the single points between them.
        let mut firsts: Vec<u32> = Vec::new();
        let mut next = 0;
        for &[first, last] in &self.runs {
            firsts.extend(next..=first);
            next = last + 1;
        }
        firsts.extend(next..self.points as u32);
        let interval_of = |point: u32| firsts.partition_point(|&first| first <= point) - 1;
        let mut parent: Vec<usize> = (0..firsts.len()).collect();
        for &[i, j] in &self.pairs {
            let (a, b) = (root(&mut parent, interval_of(i)), root(&mut parent, interval_of(j)));
            parent[a.max(b)] = a.min(b);
        }
        let (mut spans, mut labels): (Vec<[usize; 2]>, Vec<u32>) = (Vec::new(), Vec::new());
        for (k, &first) in firsts.iter().enumerate() {
            let last = firsts.get(k + 1).map_or(self.points, |&next| next as usize) - 1;
            let top = root(&mut parent, k);
            if top == k {
                labels.push(spans.len() as u32);
                spans.push([first as usize, last]);
            } else {
                labels.push(labels[top]);
                spans[labels[top] as usize][1] = last;
            }
        }
        NumberedParts { spans, intervals: firsts.into_iter().zip(labels).collect() }
    }
}

/// The first interval of a part, which is below all others of it.
fn root(parent: &mut [usize], of: usize) -> usize {
    let mut k = of;
    while parent[k] != k {
        parent[k] = parent[parent[k]];
        k = parent[k];
    }
    k
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

    #[test]
    fn pairs_inside_runs_do_not_pile_up() {
        let n = 100_000;
        let mut parts = ConnectedParts::new(n);
        for i in 0..n {
            (1..4).filter(|step| i + step < n).for_each(|step| parts.join(i, i + step));
        }
        assert!(parts.pairs.len() <= 4096, "{}", parts.pairs.len());
        assert_eq!(parts.numbered().spans(), [[0, n - 1]]);
    }
}
