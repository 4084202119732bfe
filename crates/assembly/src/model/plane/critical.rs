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

    /// By offset, of bonds between points of the first material.
    pub fn by_offset(&self) -> &[f64] {
        &self.by_offset
    }

    /// How many times further bonds between points of two materials stretch than those of [`Self::by_offset`].
    pub fn ratio_between(&self, [a, b]: [u32; 2]) -> f64 {
        self.materials.as_ref().map_or(1.0, |of| of.ratios[a as usize * of.count + b as usize])
    }

    /// How many times further a bond between two points, which `ends` finds, stretches than one of its offset.
    pub(in super::super) fn ratio(&self, ends: impl FnOnce() -> [usize; 2]) -> f64 {
        let Some(Materials { numbers, .. }) = &self.materials else { return 1.0 };
        self.ratio_between(ends().map(|point| numbers[point]))
    }
}
