//! Weights of the bonds of a lattice: one per class, and the exceptions.

use std::ops::Range;

/// Points per chunk: the inner loops run over one chunk of one class.
pub(super) const CHUNK: usize = 64;
/// Marks a chunk all of whose bonds have factor one.
const PLAIN: u32 = u32::MAX;

/// A bond whose weight differs from that of its class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Override {
    /// Index of the class.
    pub class: usize,
    /// Lower point, counted from the first lattice point.
    pub lower: usize,
    /// Multiplies the weight of the class; zero where there is no bond.
    pub factor: f64,
}

/// Weights α of the bonds `(p, p + step)` of a lattice, one class per step.
///
/// Factors are stored only for the chunks of 64 points that hold an exception (ends, splits, broken bonds): the interior of a lattice
/// stores nothing per bond.
#[derive(Clone, Debug)]
pub struct Weights {
    count: usize,
    classes: Vec<(usize, f64)>,
    /// Per chunk: start of its factors `[class][lower point]`, or [`PLAIN`].
    chunks: Vec<u32>,
    factors: Vec<f64>,
    /// Per chunk with factors, in their order: a bit for every lower point that has one other than 1.
    exceptions: Vec<u64>,
}

impl Weights {
    /// Weights of the classes `(step, weight)` of a lattice of `count` points. Bonds that would leave the lattice do not
    /// exist and need no override.
    pub fn new(count: usize, classes: Vec<(usize, f64)>, overrides: &[Override]) -> Self {
        let chunks = vec![PLAIN; count.div_ceil(CHUNK)];
        let mut weights = Self { count, classes, chunks, factors: Vec::new(), exceptions: Vec::new() };
        overrides.iter().filter(|o| o.lower < count).for_each(|o| weights.change(*o));
        weights
    }

    /// Gives a bond another factor.
    ///
    /// # Panics
    /// The lower point is beyond the lattice, or there is no such class.
    pub fn change(&mut self, Override { class, lower, factor }: Override) {
        let chunk = &mut self.chunks[lower / CHUNK];
        if *chunk == PLAIN {
            *chunk = self.factors.len() as u32;
            self.factors.resize(self.factors.len() + self.classes.len() * CHUNK, 1.0);
            self.exceptions.push(0);
        }
        let (start, place) = (*chunk as usize, lower % CHUNK);
        self.factors[start + class * CHUNK + place] = factor;
        let is_exception =
            self.factors[start + place..].iter().step_by(CHUNK).take(self.classes.len()).any(|f| *f != 1.0);
        let bits = &mut self.exceptions[start / (self.classes.len() * CHUNK)];
        *bits = *bits & !(1 << place) | u64::from(is_exception) << place;
    }

    /// Points of the lattice.
    pub fn points(&self) -> usize {
        self.count
    }

    /// Number of classes.
    pub fn classes(&self) -> usize {
        self.classes.len()
    }

    /// Difference of the point numbers of the bonds of a class, >= 1.
    #[inline]
    pub fn step(&self, class: usize) -> usize {
        self.classes[class].0
    }

    /// Largest step.
    pub fn reach(&self) -> usize {
        self.classes.iter().map(|c| c.0).max().unwrap_or(0)
    }

    /// Weight of the ordinary bonds of a class.
    pub fn of_class(&self, class: usize) -> f64 {
        self.classes[class].1
    }

    /// Weight of the bond of a class at a lower point; zero where it does not exist.
    #[inline]
    pub fn weight(&self, class: usize, lower: usize) -> f64 {
        let (step, weight) = self.classes[class];
        if lower + step < self.count { weight * self.factor(class, lower) } else { 0.0 }
    }

    /// Sum of the weights of the bonds of a class.
    pub fn sum(&self, class: usize) -> f64 {
        let (step, weight) = self.classes[class];
        let bonds = self.count.saturating_sub(step);
        let of_chunk = |first: usize| {
            let end = (first + CHUNK).min(bonds);
            match self.chunks[first / CHUNK] {
                PLAIN => (end - first) as f64,
                _ => (first..end).map(|lower| self.factor(class, lower)).sum(),
            }
        };
        weight * (0..bonds).step_by(CHUNK).map(of_chunk).sum::<f64>()
    }

    /// Weight of the bond of a class at a lower point, which exists, over that of the class.
    #[inline]
    pub(super) fn factor(&self, class: usize, lower: usize) -> f64 {
        match self.chunks[lower / CHUNK] {
            PLAIN => 1.0,
            start => self.factors[start as usize + class * CHUNK + lower % CHUNK],
        }
    }

    /// Whether all bonds with lower points in a range exist and have the weight of their class.
    pub fn are_ordinary(&self, lower: Range<usize>) -> bool {
        if lower.is_empty() {
            return true;
        }
        let size = self.classes.len() * CHUNK;
        lower.end + self.reach() <= self.count
            && (lower.start / CHUNK..(lower.end - 1) / CHUNK + 1).all(|chunk| {
                let first = chunk * CHUNK;
                let [from, to] = [lower.start.max(first) - first, lower.end.min(first + CHUNK) - first];
                match self.chunks[chunk] {
                    PLAIN => true,
                    start => {
                        self.exceptions[start as usize / size]
                            & (u64::MAX << from)
                            & (u64::MAX >> (CHUNK - to))
                            == 0
                    }
                }
            })
    }

    /// Number of chunks.
    pub(super) fn chunks(&self) -> usize {
        self.chunks.len()
    }

    /// Whether no bond with its lower point in a chunk is an exception.
    pub(super) fn is_plain(&self, chunk: usize) -> bool {
        self.chunks[chunk] == PLAIN
    }

    /// Lower points of one class in one chunk, and their factors if the chunk has any.
    #[inline(always)]
    pub(super) fn bonds_of(&self, class: usize, chunk: usize) -> (Range<usize>, Option<&[f64]>) {
        let last = self.count.saturating_sub(self.classes[class].0);
        let begin = (chunk * CHUNK).min(last);
        let end = (begin + CHUNK).min(last);
        let factors = (self.chunks[chunk] != PLAIN)
            .then(|| &self.factors[self.chunks[chunk] as usize + class * CHUNK..][..CHUNK]);
        (begin..end, factors)
    }

    /// Number of bonds.
    pub fn bonds(&self) -> usize {
        let inside: usize = self.classes.iter().map(|c| self.count.saturating_sub(c.0)).sum();
        let absent = (0..self.chunks.len())
            .filter(|&chunk| self.chunks[chunk] != PLAIN)
            .flat_map(|chunk| (0..self.classes.len()).map(move |index| (chunk, index)))
            .flat_map(|(chunk, index)| self.bonds_of(index, chunk).0.map(move |p| (index, p)))
            .filter(|&(index, p)| self.weight(index, p) == 0.0)
            .count();
        inside - absent
    }

    /// Numbers stored for exceptions.
    pub fn stored_factors(&self) -> usize {
        self.factors.len()
    }
}

#[cfg(test)]
mod tests {
    use super::{Override, Weights};

    #[test]
    fn bonds_are_ordinary_where_none_is_an_exception() {
        let places = [(0, 2), (1, 63), (1, 64), (0, 130), (1, 130), (0, 190)];
        let change = |factor: f64| places.map(|(class, lower)| Override { class, lower, factor });
        let mut weights = Weights::new(200, vec![(1, 0.4), (3, 0.3)], &change(0.5));
        let check = |weights: &Weights| {
            for start in 0..200 {
                for end in start + 1..200 {
                    let exists = end + 3 <= 200;
                    let whole =
                        (0..2).all(|class| (start..end).all(|lower| weights.factor(class, lower) == 1.0));
                    assert_eq!(weights.are_ordinary(start..end), exists && whole, "{start}..{end}");
                }
            }
        };
        check(&weights);
        // One of the two at the point 130 stays.
        change(1.0).into_iter().filter(|o| (o.class, o.lower) != (0, 130)).for_each(|o| weights.change(o));
        check(&weights);
        assert!(weights.are_ordinary(0..130) && !weights.are_ordinary(0..131));
    }
}
