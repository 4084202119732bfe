//! What a reference is and what it answers.

use std::fmt;
use std::sync::Arc;

use super::Facts;

/// Source of the local references.
pub(super) const TIMOSHENKO_BEAM: &str = "static beam equations of S. P. Timoshenko, Philosophical Magazine 41 (1921) 744-746, integrated in closed form";

/// Source of the references on a foundation.
pub(super) const FOUNDATION_BEAM: &str = "foundation of M. Hetényi, Beams on Elastic Foundation, University of Michigan Press (1946), under the beam \
     of S. P. Timoshenko, Philosophical Magazine 41 (1921) 744-746, integrated in closed form";

/// Source of the nonlocal references.
pub(super) const PUBLISHED_BEAM: &str = "bond energy of Z. Yang, E. Oterkus, S. Oterkus, Procedia Structural Integrity 28 (2020) 464-471, \
     solved in closed form for a sine";

/// A closed-form solution under its name.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    /// The name a case writes, the same as that of the file.
    pub name: &'static str,
    /// One line for `peristat list`.
    pub about: &'static str,
    /// Where the formula comes from.
    pub source: &'static str,
    /// The solution for a scene, or what the scene has that the reference does not, as the end of a sentence:
    /// "it needs a clamped end at x = 0, the scene has a simple support".
    pub build: fn(&Facts) -> Result<Solution, String>,
}

/// The answer of a reference for one scene.
pub struct Solution {
    /// State of the section at x, m from the left end, 0 <= x <= L.
    pub at: Box<dyn Fn(f64) -> State + Send + Sync>,
    /// Deflections and rotations at many x at once, into slices of the same length.
    pub displacements: Box<Displacements>,
    /// Strain energy of the whole beam and of the foundation under it, J. Supports do no work, so this is
    /// half the work of the loads (Clapeyron).
    pub energy: Option<f64>,
    /// Which of w, phi, M and V the reference gives.
    pub fields: &'static [Field],
}

/// Deflections and rotations at many x.
pub type Displacements = dyn Fn(&[f64], [&mut [f64]; 2]) + Send + Sync;

/// Deflection, rotation and section forces at one x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Deflection w, m.
    pub w: f64,
    /// Rotation phi, rad.
    pub phi: f64,
    /// Bending moment M, N m; not a number where the reference does not give it.
    pub moment: f64,
    /// Shear force V, N; not a number where the reference does not give it.
    pub shear: f64,
}

/// A quantity that a check may compare with a reference.
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
pub enum Field {
    /// Deflection, m.
    #[serde(rename = "w")]
    W,
    /// Rotation of the section, rad.
    #[serde(rename = "phi")]
    Phi,
    /// Bending moment, N m.
    #[serde(rename = "M")]
    M,
    /// Shear force, N.
    #[serde(rename = "V")]
    V,
    /// Strain energy of the whole beam, J.
    #[serde(rename = "energy")]
    Energy,
}

impl Field {
    /// The name a case writes.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::W => "w",
            Self::Phi => "phi",
            Self::M => "M",
            Self::V => "V",
            Self::Energy => "energy",
        }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Debug for Solution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Solution")
            .field("energy", &self.energy)
            .field("fields", &self.fields)
            .finish_non_exhaustive()
    }
}

impl Solution {
    /// The value of a field at x, or nothing if the reference does not give it. The energy is the same at
    /// every x.
    #[must_use]
    pub fn value(&self, field: Field, x: f64) -> Option<f64> {
        if field == Field::Energy {
            return self.energy;
        }
        if !self.fields.contains(&field) {
            return None;
        }
        let state = (self.at)(x);
        Some(match field {
            Field::W => state.w,
            Field::Phi => state.phi,
            Field::M => state.moment,
            Field::V | Field::Energy => state.shear,
        })
    }

    /// A local solution: all four fields and the energy.
    pub(super) fn local(energy: f64, at: impl Fn(f64) -> State + Send + Sync + 'static) -> Self {
        Self::new(energy, at, &[Field::W, Field::Phi, Field::M, Field::V])
    }

    /// A nonlocal solution: deflection, rotation and energy. Its section forces are sums over the bonds of a
    /// cut.
    pub(super) fn nonlocal(energy: f64, at: impl Fn(f64) -> (f64, f64) + Send + Sync + 'static) -> Self {
        let at = move |x| {
            let (w, phi) = at(x);
            State { w, phi, moment: f64::NAN, shear: f64::NAN }
        };
        Self::new(energy, at, &[Field::W, Field::Phi])
    }

    fn new(energy: f64, at: impl Fn(f64) -> State + Send + Sync + 'static, fields: &'static [Field]) -> Self {
        let at = Arc::new(at);
        let of_one = Arc::clone(&at);
        // The formula is compiled into the loop: a call per point would take longer than its evaluation.
        let displacements = move |x: &[f64], [w, phi]: [&mut [f64]; 2]| {
            for ((x, w), phi) in x.iter().zip(w).zip(phi) {
                let state = at(*x);
                (*w, *phi) = (state.w, state.phi);
            }
        };
        Self {
            at: Box::new(move |x| of_one(x)),
            displacements: Box::new(displacements),
            energy: Some(energy),
            fields,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_has_one_name_in_cases_and_messages() {
        for field in [Field::W, Field::Phi, Field::M, Field::V, Field::Energy] {
            let written = serde_json::to_string(&field).unwrap();
            assert_eq!(written, format!("\"{field}\""));
            assert_eq!(serde_json::from_str::<Field>(&written).unwrap(), field);
        }
    }

    #[test]
    fn a_nonlocal_solution_keeps_its_section_forces_to_itself() {
        let solution = Solution::nonlocal(3.0, |x| (x, 2.0 * x));
        assert_eq!(solution.value(Field::W, 0.5), Some(0.5));
        assert_eq!(solution.value(Field::Phi, 0.5), Some(1.0));
        assert_eq!(solution.value(Field::M, 0.5), None);
        assert_eq!(solution.value(Field::V, 0.5), None);
        assert_eq!(solution.value(Field::Energy, 0.5), Some(3.0));
    }
}
