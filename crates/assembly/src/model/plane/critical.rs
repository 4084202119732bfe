//! At which stretches the bonds of a body in the plane break.

/// Critical stretches of bonds: by the offset of a bond, and in bodies of several materials by those of its ends.
///
/// A bond fails in tension alone: where its stretch, the elongation over its length, reaches the critical one.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalStretch {
    by_offset: Vec<f64>,
    materials: Option<Materials>,
}

/// The materials of points, and how many times further than in the first one bonds between them stretch.
#[derive(Clone, Debug, PartialEq)]
struct Materials {
    numbers: Vec<u32>,
    count: usize,
    ratios: Vec<f64>,
}

impl CriticalStretch {
    /// One per offset, infinite where none break; of a cloud there is one.
    pub fn new(by_offset: Vec<f64>) -> Self {
        Self { by_offset, materials: None }
    }

    /// That of a body whose points are of several materials, by their numbers. `ratios` has a row and a column per material: how many
    /// times further bonds between points of both stretch than those of [`Self::new`].
    ///
    /// # Panics
    /// The table is not square, or a number is beyond it.
    #[must_use]
    pub fn of_materials(self, numbers: Vec<u32>, ratios: Vec<Vec<f64>>) -> Self {
        let count = ratios.len();
        assert!(ratios.iter().all(|row| row.len() == count), "a ratio for every pair");
        assert!(numbers.iter().all(|number| (*number as usize) < count), "a row for every material");
        Self { materials: Some(Materials { numbers, count, ratios: ratios.concat() }), ..self }
    }

    /// Whether the materials of points matter.
    pub(in super::super) fn has_materials(&self) -> bool {
        self.materials.is_some()
    }

    /// By offset, of bonds between points of the first material.
    pub fn by_offset(&self) -> &[f64] {
        &self.by_offset
    }

    /// How many times further bonds between points of two materials stretch than those of [`Self::by_offset`].
    pub fn ratio_between(&self, [a, b]: [u32; 2]) -> f64 {
        self.materials.as_ref().map_or(1.0, |of| of.ratios[a as usize * of.count + b as usize])
    }

    /// How many times further a bond along some points, from one of its ends to the other, stretches than one of its offset: as the
    /// weakest interface that it passes, and the weakest material that it passes through from one side to the other, have it.
    pub(in super::super) fn ratio(&self, along: impl IntoIterator<Item = usize>) -> f64 {
        let Some(Materials { numbers, .. }) = &self.materials else { return 1.0 };
        let mut passed = along.into_iter().map(|point| numbers[point]);
        let Some(first) = passed.next() else { return 1.0 };
        let (mut last, mut weakest) = (first, None::<f64>);
        for number in passed {
            if number != last {
                let interface = self.ratio_between([last, number]);
                let own = if last == first { interface } else { self.ratio_between([last; 2]) };
                weakest = Some(weakest.unwrap_or(interface).min(interface).min(own));
                last = number;
            }
        }
        weakest.unwrap_or_else(|| self.ratio_between([first; 2]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bonds_are_as_weak_as_what_they_pass() {
        // Points 0 of the first material, 1 of glue, 2 of a third one; both are weak, and so is the interface of the glue.
        let ratios = vec![vec![1.0, 0.3, 0.9], vec![0.3, 0.2, 0.4], vec![0.9, 0.4, 0.8]];
        let critical = CriticalStretch::new(vec![1.0]).of_materials(vec![0, 1, 2], ratios);
        let rows: [(&[usize], f64); 7] = [
            (&[0, 0], 1.0),
            (&[1, 1, 1], 0.2),
            (&[0, 0, 1], 0.3),
            (&[2, 0], 0.9),
            (&[0, 1, 0], 0.2),
            (&[0, 2, 0], 0.8),
            (&[0, 1, 2], 0.2),
        ];
        for (along, expected) in rows {
            let back = along.iter().rev().copied();
            assert_eq!(critical.ratio(along.iter().copied()), expected, "{along:?}");
            assert_eq!(critical.ratio(back), expected, "{along:?}");
        }
        assert_eq!(CriticalStretch::new(vec![1.0]).ratio([0, 1]), 1.0);
    }
}
