//! At which stretches the bonds of a lattice break.

use super::toughness::CrossingBonds;

/// Critical stretches of bonds: by the offset of a bond, and in bodies of several materials by what it passes.
///
/// A bond fails in tension alone: where its stretch, the elongation over its length beyond that at which it is free of force, reaches
/// the critical one.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalStretch {
    by_offset: Vec<f64>,
    materials: Option<ToughMaterials>,
    free: Option<Vec<f64>>,
}

/// How tough a material or an interface is, against the base material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Toughness {
    /// Its bonds break at so many times the stretch, whatever their modulus.
    Stretch(f64),
    /// A crack takes so many times the energy, whatever the modulus.
    Energy(f64),
}

impl Toughness {
    /// How many times the energy a crack takes where bonds have a modulus over that of the base material.
    fn energy(self, modulus: f64) -> f64 {
        match self {
            Self::Stretch(ratio) => ratio * ratio * modulus,
            Self::Energy(energy) => energy,
        }
    }

    /// How many times the stretch bonds of that modulus break at.
    fn ratio(self, modulus: f64) -> f64 {
        match self {
            Self::Stretch(ratio) => ratio,
            Self::Energy(energy) => (energy / modulus).sqrt(),
        }
    }
}

/// The materials of points, and how tough they and their interfaces are.
#[derive(Clone, Debug, PartialEq)]
pub struct ToughMaterials {
    /// Numbers of the materials of points.
    pub numbers: Vec<u32>,
    /// Moduli of points over that of the base material.
    pub moduli: Vec<f64>,
    /// By number of a material.
    pub own: Vec<Toughness>,
    /// The same: what its interfaces are given. That of two materials is as tough as the weaker of what both are given, and where
    /// nothing is, a crack takes the energy of the weaker material.
    pub interfaces: Vec<Option<Toughness>>,
    /// The bonds that a crack along an interface cuts.
    pub crossing: CrossingBonds,
}

impl ToughMaterials {
    /// How many times the stretch of the base material the bonds between points of two materials break at, the moduli of these
    /// beside their interface being given.
    fn between(&self, [(a, first), (b, second)]: [(u32, f64); 2]) -> f64 {
        let [a, b] = [a as usize, b as usize];
        let modulus = self.crossing.factor([first, second]);
        let given = [a, b].into_iter().filter_map(|side| self.interfaces[side]);
        let given = given.map(|own| own.ratio(modulus)).reduce(f64::min);
        let weaker = || self.own[a].energy(first).min(self.own[b].energy(second));
        given.unwrap_or_else(|| Toughness::Energy(weaker()).ratio(modulus))
    }

    /// The same of a bond through points, from one of its ends to the other; within a material by its `modulus`.
    fn along(&self, points: impl IntoIterator<Item = usize>, modulus: impl FnOnce() -> f64) -> f64 {
        let mut passed = points.into_iter().map(|point| (self.numbers[point], self.moduli[point]));
        let Some(first) = passed.next() else { return 1.0 };
        let (mut last, mut weakest) = (first, None::<f64>);
        for next in passed {
            if next.0 != last.0 {
                let interface = self.between([last, next]);
                let own = if last.0 == first.0 { interface } else { self.own[last.0 as usize].ratio(last.1) };
                weakest = Some(weakest.unwrap_or(interface).min(interface).min(own));
            }
            last = next;
        }
        weakest.unwrap_or_else(|| self.own[first.0 as usize].ratio(modulus()))
    }
}

impl CriticalStretch {
    /// One per offset, infinite where none break; of a cloud there is one.
    pub fn new(by_offset: Vec<f64>) -> Self {
        Self { by_offset, materials: None, free: None }
    }

    /// That of a body of several materials, of which the first one has those of [`Self::new`].
    ///
    /// # Panics
    /// There is not one modulus per point, or not one toughness and interface for every material.
    #[must_use]
    pub fn of_materials(self, materials: ToughMaterials) -> Self {
        let ToughMaterials { numbers, moduli, own, interfaces, .. } = &materials;
        let count = own.len();
        assert!(numbers.len() == moduli.len(), "a modulus for every point");
        assert!(numbers.iter().all(|number| (*number as usize) < count), "a toughness for every material");
        assert!(interfaces.len() == count, "an interface for every material, given or not");
        Self { materials: Some(materials), ..self }
    }

    /// The same of a body whose points stretch by strains without stress, three planes, at the unit load.
    #[must_use]
    pub fn beyond(self, free: Vec<f64>) -> Self {
        Self { free: Some(free), ..self }
    }

    /// Strains of the points that need no stress, where there are any.
    pub fn free(&self) -> Option<&[f64]> {
        self.free.as_deref()
    }

    /// Whether the materials of points matter.
    pub(in super::super) fn has_materials(&self) -> bool {
        self.materials.is_some()
    }

    /// By offset, of bonds between points of the first material.
    pub fn by_offset(&self) -> &[f64] {
        &self.by_offset
    }

    /// How many times further bonds of a material stretch than those of [`Self::by_offset`], at a modulus over that of the base
    /// material.
    pub fn ratio_within(&self, number: u32, modulus: f64) -> f64 {
        self.materials.as_ref().map_or(1.0, |of| of.own[number as usize].ratio(modulus))
    }

    /// The same of bonds between two materials, whose moduli are given.
    pub fn ratio_between(&self, sides: [(u32, f64); 2]) -> f64 {
        self.materials.as_ref().map_or(1.0, |of| of.between(sides))
    }

    /// How many times further a bond along some points, from one of its ends to the other, stretches than one of its offset: as the
    /// weakest interface that it passes, and the weakest material that it passes through from one side to the other, have it; within a
    /// material by its `modulus` over that of the base material.
    pub(in super::super) fn ratio(
        &self,
        along: impl IntoIterator<Item = usize>,
        modulus: impl FnOnce() -> f64,
    ) -> f64 {
        self.materials.as_ref().map_or(1.0, |of| of.along(along, modulus))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Toughness::{Energy, Stretch};

    fn of(moduli: [f64; 3], own: [Toughness; 3], interfaces: [Option<Toughness>; 3]) -> CriticalStretch {
        let crossing = CrossingBonds::new(&[1.0], &[[0, 1, 0]]);
        let (numbers, moduli, own) = (vec![0, 1, 2], moduli.to_vec(), own.to_vec());
        let interfaces = interfaces.to_vec();
        CriticalStretch::new(vec![1.0]).of_materials(ToughMaterials {
            numbers,
            moduli,
            own,
            interfaces,
            crossing,
        })
    }

    #[test]
    fn bonds_are_as_weak_as_what_they_pass() {
        // Points 0 of the first material, 1 of glue, 2 of a third one; both are weak, and so is the interface of the glue.
        let own = [Stretch(1.0), Stretch(0.2), Stretch(0.9)];
        let critical = of([1.0; 3], own, [None, Some(Stretch(0.3)), Some(Stretch(0.95))]);
        let rows: [(&[usize], f64); 7] = [
            (&[0, 0], 1.0),
            (&[1, 1, 1], 0.2),
            (&[0, 0, 1], 0.3),
            (&[2, 0], 0.95),
            (&[0, 1, 0], 0.2),
            (&[0, 2, 0], 0.9),
            (&[0, 1, 2], 0.2),
        ];
        for (along, expected) in rows {
            let back = along.iter().rev().copied();
            assert_eq!(critical.ratio(along.iter().copied(), || 1.0), expected, "{along:?}");
            assert_eq!(critical.ratio(back, || 1.0), expected, "{along:?}");
        }
        assert_eq!(CriticalStretch::new(vec![1.0]).ratio([0, 1], || 1.0), 1.0);
    }

    #[test]
    fn a_crack_takes_its_energy_at_any_modulus() {
        // In series 1/(0.5/4 + 0.5/2) = 8/3; the weaker energy is 2.
        let critical = of([1.0, 4.0, 2.0], [Energy(1.0), Energy(3.0), Stretch(1.0)], [None; 3]);
        assert!((critical.ratio([1, 1], || 12.0) - 0.5).abs() < 1e-15);
        assert!((critical.ratio([1, 2], || 0.0) - (2.0 / (8.0 / 3.0_f64)).sqrt()).abs() < 1e-15);
        assert_eq!(critical.ratio([2, 2], || 7.0), 1.0);
    }
}
