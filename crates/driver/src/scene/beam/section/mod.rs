//! Stiffness of the sections of a line, and what else is known of them.

mod given;
mod power_law;
mod shape;
mod taper;

use crate::diagnostic::{Faults, JsonPath, positive};
use crate::model::Beam;
use crate::scene::numbers;
use crate::units::Units;
use peristat_assembly::material::{Profile, SectionStiffness};

/// What is known of the sections of a line, by the distance from its start.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionAlong {
    /// Area A.
    pub area: Option<Profile>,
    /// Second moment of area I; none where bending stresses are not `M z / I`.
    pub second_moment: Option<Profile>,
    /// Height; the extreme fibres are at plus and minus half of it.
    pub height: Option<Profile>,
    /// Shear correction factor κ.
    pub kappa: Option<f64>,
}

impl SectionAlong {
    /// Stress per moment at the extreme fibre on the side of −w, at a distance from the start; on a jump that on the
    /// side of `towards`.
    pub fn stress_per_moment(&self, s: f64, towards: f64) -> Option<f64> {
        let value = |profile: &Profile| profile.beside(s, towards);
        Some(0.5 * value(self.height.as_ref()?) / value(self.second_moment.as_ref()?))
    }

    /// Whether a moment makes the same stress everywhere.
    pub fn has_uniform_stress(&self) -> bool {
        [&self.height, &self.second_moment].into_iter().flatten().all(|p| p.uniform().is_some())
    }

    /// Whether its area is the same everywhere.
    pub fn has_uniform_area(&self) -> bool {
        self.area.as_ref().is_none_or(|area| area.uniform().is_some())
    }

    /// Whether bending stresses are known.
    pub fn has_stress(&self) -> bool {
        self.height.is_some() && self.second_moment.is_some()
    }
}

/// The sections of a line.
#[derive(Clone, Debug)]
pub(super) struct Resolved {
    /// Stiffness.
    pub(super) stiffness: SectionStiffness,
    /// The rest.
    pub(super) section: SectionAlong,
    /// Whether the axial stiffness was given; otherwise it must not be read.
    pub(super) has_axial: bool,
}

impl Resolved {
    /// What makes its bonds differ from each other or need more than a bond law, in words.
    pub(super) fn peculiarity(&self) -> Option<&'static str> {
        match (self.stiffness.couples(), self.stiffness.plain()) {
            (true, _) => Some("couples axial force and bending"),
            (false, None) => Some("varies along the line"),
            (false, Some(_)) => None,
        }
    }
}

/// The sections of a line of a length; `path` is that of the beam, `own` that of what says its section: the beam, or a
/// member with a section of its own.
pub(super) fn stiffness(
    beam: &Beam,
    units: Units,
    length: f64,
    path: &JsonPath,
    own: &JsonPath,
    faults: &mut Faults,
) -> Option<Resolved> {
    if !is_unambiguous(beam, own, faults) {
        return None;
    }
    let resolved = match (&beam.section, &beam.stiffness, &beam.power_law) {
        (_, Some(stiffness), _) => given::resolve(stiffness, length, &own.key("stiffness"), faults),
        (_, _, Some(law)) => power_law::resolve(beam, law, path, own, faults),
        (Some(section), ..) => shape::resolve(beam, units, *section, length, [path, own], faults),
        (None, None, None) => {
            faults
                .error(own.clone(), "`section` is missing")
                .hint("give `section` with `youngs_modulus`; or EI and κGA as `stiffness`; or a graded section as `power_law`");
            None
        }
    }?;
    let [bending, shear] = [&resolved.stiffness.bending, &resolved.stiffness.shear].map(|p| p.value(0.0));
    if !faults.has_errors() && !numbers::fit(bending, shear) {
        faults
            .error(own.clone(), "the stiffnesses EI and κGA do not fit into double precision")
            .hint(format!("EI = {bending:e}, κGA = {shear:e}; choose units in which they are moderate"));
        return None;
    }
    Some(resolved)
}

/// Whether the beam says in one way what its sections are.
fn is_unambiguous(beam: &Beam, path: &JsonPath, faults: &mut Faults) -> bool {
    let shape = [
        ("youngs_modulus", beam.youngs_modulus.is_some()),
        ("shear_modulus", beam.shear_modulus.is_some()),
        ("section", beam.section.is_some()),
        ("end_section", beam.end_section.is_some()),
    ];
    let material = [
        ("poisson_ratio", beam.poisson_ratio.is_some()),
        ("shear_correction", beam.shear_correction.is_some()),
        ("power_law", beam.power_law.is_some()),
    ];
    let (key, others, all) = if beam.stiffness.is_some() {
        let others: Vec<_> = shape.into_iter().chain(material).collect();
        ("stiffness", others, "all that the beam needs of its sections")
    } else if beam.power_law.is_some() {
        ("power_law", shape.to_vec(), "the shape and the moduli of the section")
    } else {
        return true;
    };
    let given: Vec<String> =
        others.iter().filter(|(_, given)| *given).map(|(key, _)| format!("`{key}`")).collect();
    if !given.is_empty() {
        faults
            .error(path.key(key), format!("`{key}` is given together with {}", given.join(", ")))
            .hint(format!("`{key}` says {all}: remove one or the other"));
    }
    given.is_empty()
}

/// A profile times a number.
fn scaled(profile: &Profile, factor: f64) -> Profile {
    match profile {
        Profile::Uniform(value) => Profile::Uniform(factor * value),
        Profile::Polynomial(c) => Profile::Polynomial(c.iter().map(|c| factor * c).collect()),
        Profile::Table(pairs) => Profile::Table(pairs.iter().map(|[s, v]| [*s, factor * v]).collect()),
    }
}

/// G of the material: given, or from E and Poisson's ratio.
fn shear_modulus(beam: &Beam, e: Option<f64>, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    match (beam.poisson_ratio, beam.shear_modulus) {
        (Some(_), Some(_)) => {
            faults
                .error(path.key("shear_modulus"), "`poisson_ratio` and `shear_modulus` are both given")
                .hint("for an isotropic material one follows from the other: remove one");
            None
        }
        (None, None) => {
            let fault = faults.error(path.clone(), "`poisson_ratio` is missing");
            if beam.power_law.is_none() {
                fault.hint("give `poisson_ratio`, or `shear_modulus` for a material that is not isotropic");
            }
            None
        }
        (Some(nu), None) if nu > -1.0 && nu <= 0.5 => e.map(|e| e / (2.0 * (1.0 + nu))),
        (Some(nu), None) => {
            faults
                .error(
                    path.key("poisson_ratio"),
                    format!("`poisson_ratio` must be above -1 and at most 0.5, found {nu}"),
                )
                .hint("steel has 0.3, aluminium 0.33, concrete 0.2");
            None
        }
        (None, Some(g)) => positive(g, "shear_modulus", path.key("shear_modulus"), faults).then_some(g),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stress_on_a_jump_is_that_of_the_side_that_is_looked_at() {
        let section = SectionAlong {
            area: None,
            second_moment: Some(Profile::Table(vec![[0.0, 4.0], [0.5, 4.0], [0.5, 1.0], [1.0, 1.0]])),
            height: Some(Profile::Uniform(2.0)),
            kappa: None,
        };
        let at = |s: f64, towards: f64| section.stress_per_moment(s, towards);
        assert_eq!([at(0.5, 0.4), at(0.5, 0.6), at(1.0, 0.5)], [Some(0.25), Some(1.0), Some(1.0)]);
    }
}
