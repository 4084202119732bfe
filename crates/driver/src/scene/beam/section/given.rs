//! Sections of which the stiffness is given by numbers.

use super::super::profile;
use super::{Resolved, SectionAlong, scaled};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use crate::model::Stiffness;
use peristat_assembly::material::{Profile, SectionStiffness};

/// Sections of which the stiffness is given.
pub(super) fn resolve(
    given: &Stiffness,
    length: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Resolved> {
    let mut fine = true;
    let named =
        [("bending", Some(&given.bending)), ("shear", Some(&given.shear)), ("axial", given.axial.as_ref())];
    for (key, value) in named {
        let Some(value) = value else { continue };
        fine &= profile::is_well_formed(value, &path.key(key), faults)
            && profile::is_positive(value, key, length, &path.key(key), faults);
    }
    for (key, value) in [("area", given.area), ("height", given.height)] {
        fine &= value.is_none_or(|value| positive(value, key, path.key(key), faults));
    }
    if let Some(coupling) = &given.coupling {
        fine &= profile::is_well_formed(coupling, &path.key("coupling"), faults)
            && can_couple(given, coupling, length, path, faults);
    }
    if !fine {
        return None;
    }
    let stiffness = SectionStiffness {
        bending: given.bending.clone(),
        shear: given.shear.clone(),
        // Nothing reads the axial stiffness of a line without axial unknowns.
        axial: given.axial.clone().unwrap_or(Profile::Uniform(1.0)),
        coupling: given.coupling.clone().unwrap_or(Profile::Uniform(0.0)),
        area: given.area.unwrap_or(1.0),
    };
    // One material: E = EA/A everywhere.
    let modulus = given.axial.as_ref().and_then(Profile::uniform).zip(given.area).map(|(ea, a)| ea / a);
    let modulus = modulus.filter(|_| !stiffness.couples());
    let section = SectionAlong {
        area: given.area.map(Profile::Uniform),
        second_moment: modulus.map(|e| scaled(&given.bending, 1.0 / e)),
        height: given.height.map(Profile::Uniform),
        kappa: None,
    };
    Some(Resolved { stiffness, section, has_axial: given.axial.is_some() })
}

/// Whether a coupling leaves the section a positive energy: `B² < EA EI`.
fn can_couple(
    given: &Stiffness,
    coupling: &Profile,
    length: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let Some(axial) = &given.axial else {
        faults
            .error(path.key("coupling"), "`coupling` needs `axial`")
            .hint("axial force and bending couple as [[axial, coupling], [coupling, bending]]");
        return false;
    };
    let beyond = |s: &f64| coupling.value(*s).powi(2) >= axial.value(*s) * given.bending.value(*s);
    let at = profile::places(&[axial, coupling, &given.bending], length).into_iter().find(beyond);
    if let Some(s) = at {
        let uniform = [axial, coupling, &given.bending].iter().all(|p| p.uniform().is_some());
        let place = if uniform { String::new() } else { format!(" at {} from the start", tidy(s)) };
        let product = axial.value(s) * given.bending.value(s);
        let [square, product] = [coupling.value(s).powi(2), product].map(tidy);
        faults
            .error(
                path.key("coupling"),
                format!(
                    "`coupling`² must be below `axial` times `bending`, found {square} and {product}{place}"
                ),
            )
            .hint("otherwise the section would give energy when it is stretched and bent");
    }
    at.is_none()
}
