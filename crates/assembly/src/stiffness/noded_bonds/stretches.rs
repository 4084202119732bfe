//! Elements that follow each other: what one hangs on is what the one before it hangs on, moved on by the same steps.

/// Where the elements of a stretch hang on one of their places: a number, and how much it grows from one to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Walk {
    pub(super) first: u32,
    pub(super) step: i32,
}

impl Walk {
    /// The number of the k-th element.
    pub(super) fn at(&self, k: usize) -> usize {
        (i64::from(self.first) + k as i64 * i64::from(self.step)) as usize
    }
}

/// Elements of one kind that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stretch {
    pub(super) kind: u32,
    pub(super) count: u32,
    /// Place of its first walk.
    begin: u32,
}

/// Elements of many kinds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Stretches {
    all: Vec<Stretch>,
    walks: Vec<Walk>,
}

impl Stretches {
    /// Adds the elements of a kind: their numbers one after the other, `width` of each.
    pub(super) fn add(&mut self, kind: usize, width: usize, numbers: &[u32]) {
        let mut elements = numbers.chunks_exact(width).peekable();
        while let Some(first) = elements.next() {
            let begin = self.walks.len();
            let steps = |a: &[u32], b: &[u32], k: usize| (i64::from(b[k]) - i64::from(a[k])) as i32;
            let next = elements.peek().copied();
            let walk =
                |k: usize| Walk { first: first[k], step: next.map_or(1, |next| steps(first, next, k)) };
            self.walks.extend((0..width).map(walk));
            let (mut count, mut last) = (1, first);
            let follows = |last: &[u32], next: &[u32], walks: &[Walk]| {
                walks.iter().enumerate().all(|(k, walk)| steps(last, next, k) == walk.step)
            };
            while let Some(next) = elements.next_if(|next| follows(last, next, &self.walks[begin..])) {
                (count, last) = (count + 1, next);
            }
            self.all.push(Stretch { kind: kind as u32, count, begin: begin as u32 });
        }
    }

    /// Gives back what it does not need.
    pub(super) fn shrink(&mut self) {
        self.all.shrink_to_fit();
        self.walks.shrink_to_fit();
    }

    /// All stretches.
    pub(super) fn all(&self) -> &[Stretch] {
        &self.all
    }

    /// The `width` walks of a stretch.
    pub(super) fn walks(&self, stretch: &Stretch, width: usize) -> &[Walk] {
        &self.walks[stretch.begin as usize..][..width]
    }

    /// Numbers that are stored.
    pub(super) fn stored(&self) -> usize {
        2 * self.walks.len() + 2 * self.all.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_come_back_from_few_walks() {
        let mut numbers = Vec::new();
        (0..10).for_each(|k| numbers.extend([5 + k, 40 - 2 * k]));
        (0..3).for_each(|k| numbers.extend([70 + k, 3 * k]));
        let mut stretches = Stretches::default();
        stretches.add(4, 2, &numbers);
        let mut found = Vec::new();
        for stretch in stretches.all() {
            let walks = stretches.walks(stretch, 2);
            (0..stretch.count as usize)
                .for_each(|k| found.extend(walks.iter().map(|walk| walk.at(k) as u32)));
        }
        assert_eq!(found, numbers);
        assert!(stretches.all().len() <= 3, "{stretches:?}");
    }
}
