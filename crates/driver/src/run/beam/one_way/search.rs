//! Which parts act: sets of them that are tried one after the other, none twice.

use std::collections::HashSet;

/// Sets at most: what changes one by one comes to its end, but may take long.
const MOST: usize = 1000;

/// The sets that were tried.
#[derive(Debug, Default)]
pub(super) struct Search {
    seen: HashSet<Vec<bool>>,
    tried: usize,
    /// Whether only the first wrong part changes: that never comes back to a set where the parts determine the forces on them
    /// (Murty's rule of least indices), while changing all of them at once is faster and may.
    one_by_one: bool,
}

impl Search {
    /// The next set after one of which some parts are wrong; none if the search goes round in circles.
    pub(super) fn next(&mut self, acts: &[bool], wrong: &[usize]) -> Option<Vec<bool>> {
        self.tried += 1;
        if self.tried >= MOST {
            return None;
        }
        self.seen.insert(acts.to_vec());
        let changed = |which: &[usize]| {
            let mut next = acts.to_vec();
            which.iter().for_each(|&k| next[k] = !next[k]);
            next
        };
        if !self.one_by_one {
            let next = changed(wrong);
            if !self.seen.contains(&next) {
                return Some(next);
            }
            self.one_by_one = true;
            self.seen = HashSet::from([acts.to_vec()]);
        }
        let next = changed(&wrong[..1]);
        (!self.seen.contains(&next)).then_some(next)
    }
}

#[cfg(test)]
mod tests {
    use super::Search;

    /// The states of three parts of which one set is right: what is wrong with a set, by numbers that go round if all change at once.
    fn run(wrong: impl Fn(&[bool]) -> Vec<usize>) -> Option<(Vec<bool>, usize)> {
        let (mut search, mut acts) = (Search::default(), vec![true; 3]);
        for tried in 1.. {
            let found = wrong(&acts);
            if found.is_empty() {
                return Some((acts, tried));
            }
            acts = search.next(&acts, &found)?;
        }
        None
    }

    #[test]
    fn what_goes_round_together_ends_one_by_one() {
        // All and none go to and fro; one by one the way leads through the others.
        let wrong = |acts: &[bool]| match acts {
            [false, true, true] => Vec::new(),
            [true, false, false] => vec![1],
            [true, true, false] => vec![2],
            _ => vec![0, 1, 2],
        };
        assert_eq!(run(wrong), Some((vec![false, true, true], 6)));
    }

    #[test]
    fn circles_end() {
        // Nothing is right: the first part goes to and fro.
        assert_eq!(run(|_| vec![0]), None);
    }
}
