//! The questions a reference asks of the facts.
//!
//! Each returns the value asked for, or the end of a sentence that says why the reference does not apply.

use std::fmt;

use super::foundation::words;
use super::{End, Facts, Load};

/// Two positions are the same if they differ by less than this part of the length.
const SAME_PLACE: f64 = 1e-9;

pub(super) fn mismatch<T>(needs: impl fmt::Display, has: impl fmt::Display) -> Result<T, String> {
    Err(format!("it needs {needs}, the scene has {has}"))
}

impl Facts {
    /// L, B = EI and S, the symbols of the formulas.
    pub(super) fn symbols(&self) -> (f64, f64, f64) {
        (self.length, self.bending_stiffness, self.shear_stiffness)
    }

    /// One span between these ends, no support between them.
    pub(super) fn ends_are(&self, left: End, right: End) -> Result<(), String> {
        self.supports_are(left, &[], right)
    }

    /// These ends, and simple supports at exactly these places between them.
    pub(super) fn supports_are(&self, left: End, between: &[f64], right: End) -> Result<(), String> {
        for (need, has, x) in [(left, self.ends[0], 0.0), (right, self.ends[1], self.length)] {
            if need != has {
                return mismatch(format_args!("{need} at x = {x}"), has);
            }
        }
        let missing = |list: &[f64], x: f64| !list.iter().any(|&y| self.same(x, y));
        if let Some(x) = between.iter().find(|&&x| missing(&self.interior_supports, x)) {
            return mismatch(format_args!("a simple support at x = {x}"), "none there");
        }
        match self.interior_supports.iter().find(|&&x| missing(between, x)) {
            Some(x) => mismatch("no other support between the ends", format_args!("one at x = {x}")),
            None => Ok(()),
        }
    }

    /// The force at x, if it is the only load.
    pub(super) fn only_force_at(&self, x: f64) -> Result<f64, String> {
        self.only(format_args!("one load, a force at x = {x}"), |load| match *load {
            Load::Force { x: at, value } if self.same(at, x) => Some(value),
            _ => None,
        })
    }

    /// The moment at x, if it is the only load.
    pub(super) fn only_moment_at(&self, x: f64) -> Result<f64, String> {
        self.only(format_args!("one load, a moment at x = {x}"), |load| match *load {
            Load::Moment { x: at, value } if self.same(at, x) => Some(value),
            _ => None,
        })
    }

    /// The force per length, if a uniform one is the only load.
    pub(super) fn only_uniform(&self) -> Result<f64, String> {
        self.only("one load, a uniform one", |load| match *load {
            Load::Uniform { value } => Some(value),
            _ => None,
        })
    }

    /// The moment per length, if a uniform one is the only load.
    pub(super) fn only_uniform_moment(&self) -> Result<f64, String> {
        self.only("one load, a uniform moment load", |load| match *load {
            Load::UniformMoment { value } => Some(value),
            _ => None,
        })
    }

    /// Amplitude and number of half waves, if a sine is the only load.
    pub(super) fn only_sine(&self) -> Result<(f64, u32), String> {
        self.only("one load, a sine of at least one half wave", |load| match *load {
            Load::Sine { amplitude, half_waves } if half_waves > 0 => Some((amplitude, half_waves)),
            _ => None,
        })
    }

    /// A uniform grid: the same spacing everywhere.
    pub(super) fn has_uniform_grid(&self) -> Result<(), String> {
        if self.uniform_grid { Ok(()) } else { mismatch("a uniform grid", "a graded one") }
    }

    /// Image ends: the beam goes on behind each end.
    pub(super) fn has_image_ends(&self) -> Result<(), String> {
        if self.image_ends { Ok(()) } else { mismatch("image ends", "another end treatment") }
    }

    /// Lumped loads: load times spacing on each point.
    pub(super) fn has_lumped_loads(&self) -> Result<(), String> {
        if self.lumped_loads { Ok(()) } else { mismatch("lumped loads", "consistent ones") }
    }

    /// The published bond law.
    pub(super) fn has_published_law(&self) -> Result<(), String> {
        if self.published_law { Ok(()) } else { mismatch("the published bond law", "another one") }
    }

    fn same(&self, x: f64, y: f64) -> bool {
        (x - y).abs() <= SAME_PLACE * self.length
    }

    fn only<T>(&self, needs: impl fmt::Display, pick: impl Fn(&Load) -> Option<T>) -> Result<T, String> {
        if let [load] = self.loads.as_slice()
            && let Some(found) = pick(load)
        {
            return Ok(found);
        }
        mismatch(needs, words(&self.loads))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(in super::super) fn cantilever() -> Facts {
        Facts {
            length: 2.0,
            bending_stiffness: 1.0,
            shear_stiffness: 1.0,
            ends: [End::Clamped, End::Free],
            interior_supports: vec![],
            loads: vec![Load::Force { x: 2.0, value: 3.0 }],
            spacing: 0.1,
            horizon: 0.3,
            uniform_grid: true,
            bonds: vec![],
            image_ends: false,
            lumped_loads: false,
            published_law: false,
        }
    }

    #[test]
    fn a_matching_scene_gives_its_load() {
        let facts = cantilever();
        assert_eq!(facts.ends_are(End::Clamped, End::Free), Ok(()));
        assert_eq!(facts.only_force_at(2.0 * (1.0 + 1e-15)), Ok(3.0));
    }

    #[test]
    fn a_wrong_end_is_named_with_its_place() {
        let mut facts = cantilever();
        facts.ends[0] = End::Simple;
        let message = facts.ends_are(End::Clamped, End::Free).unwrap_err();
        assert_eq!(message, "it needs a clamped end at x = 0, the scene has a simple support");
        facts.ends = [End::Clamped, End::Other];
        let message = facts.ends_are(End::Clamped, End::Free).unwrap_err();
        assert_eq!(
            message,
            "it needs a free end at x = 2, the scene has a sprung, moved or otherwise held end"
        );
    }

    #[test]
    fn supports_between_the_ends_are_compared_both_ways() {
        let mut facts = cantilever();
        let message = facts.supports_are(End::Clamped, &[1.0], End::Free).unwrap_err();
        assert_eq!(message, "it needs a simple support at x = 1, the scene has none there");
        facts.interior_supports = vec![1.0];
        assert_eq!(facts.supports_are(End::Clamped, &[1.0], End::Free), Ok(()));
        let message = facts.ends_are(End::Clamped, End::Free).unwrap_err();
        assert_eq!(message, "it needs no other support between the ends, the scene has one at x = 1");
    }

    #[test]
    fn a_wrong_load_is_named() {
        let mut facts = cantilever();
        let message = facts.only_uniform().unwrap_err();
        assert_eq!(message, "it needs one load, a uniform one, the scene has a force at x = 2");
        let message = facts.only_force_at(1.0).unwrap_err();
        assert_eq!(message, "it needs one load, a force at x = 1, the scene has a force at x = 2");
        facts.loads.push(Load::Other);
        let message = facts.only_force_at(2.0).unwrap_err();
        assert_eq!(message, "it needs one load, a force at x = 2, the scene has 2 loads");
        facts.loads.clear();
        let message = facts.only_moment_at(2.0).unwrap_err();
        assert_eq!(message, "it needs one load, a moment at x = 2, the scene has no load");
    }

    #[test]
    fn treatments_are_asked_for_by_name() {
        let facts = cantilever();
        let graded = Facts { uniform_grid: false, ..facts.clone() };
        assert_eq!(facts.has_uniform_grid(), Ok(()));
        let message = graded.has_uniform_grid().unwrap_err();
        assert_eq!(message, "it needs a uniform grid, the scene has a graded one");
        let message = facts.has_image_ends().unwrap_err();
        assert_eq!(message, "it needs image ends, the scene has another end treatment");
        let message = facts.has_lumped_loads().unwrap_err();
        assert_eq!(message, "it needs lumped loads, the scene has consistent ones");
        let message = facts.has_published_law().unwrap_err();
        assert_eq!(message, "it needs the published bond law, the scene has another one");
    }
}
