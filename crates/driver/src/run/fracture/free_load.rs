//! What strains that need no stress do to a body that breaks, at the unit load: a bond takes its share of it with it.

/// The load of such strains, and the energy of the body where nothing moves: displacements u store `½ u·K u − f·u + E`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in super::super) struct FreeLoad {
    pub(in super::super) load: Vec<f64>,
    pub(in super::super) energy: f64,
}

impl FreeLoad {
    /// What of this another one lacks.
    pub(super) fn less(&self, other: &Self) -> Self {
        let load = self.load.iter().zip(&other.load).map(|(own, other)| own - other).collect();
        Self { load, energy: self.energy - other.energy }
    }

    /// What it adds to the product `½ Σ C s₀ s₁` of the measures of two states, which are less those at which elements are free.
    pub(super) fn product(&self, [u, v]: [&[f64]; 2]) -> f64 {
        let work: f64 = self.load.iter().zip(u.iter().zip(v)).map(|(f, (a, b))| f * (a + b)).sum();
        self.energy - 0.5 * work
    }

    /// What its strains do on the way to a state, as a work.
    pub(super) fn work(&self, u: &[f64]) -> f64 {
        self.energy - 0.5 * self.load.iter().zip(u).map(|(f, u)| f * u).sum::<f64>()
    }

    /// What it adds to the energy of a state.
    pub(super) fn stored(&self, u: &[f64]) -> f64 {
        self.product([u, u])
    }
}
