//! Rectangles whose modulus varies over their height.

use super::{Resolved, SectionAlong, shear_modulus};
use crate::diagnostic::{Faults, JsonPath, positive};
use crate::model::{Beam, PowerLaw};
use peristat_assembly::material::{Profile, SectionStiffness, ShearCorrection};

/// Shear correction factor of a rectangle.
const RECTANGLE: f64 = 5.0 / 6.0;

/// A rectangle with a modulus that varies over its height: A₁₁, B₁₁ and D₁₁ about mid-height.
pub(super) fn resolve(
    beam: &Beam,
    law: &PowerLaw,
    path: &JsonPath,
    own: &JsonPath,
    faults: &mut Faults,
) -> Option<Resolved> {
    let place = own.key("power_law");
    let dimensions = [
        ("width", law.width),
        ("height", law.height),
        ("bottom_modulus", law.bottom_modulus),
        ("top_modulus", law.top_modulus),
    ];
    let mut fine = true;
    for (key, value) in dimensions {
        fine &= positive(value, key, place.key(key), faults);
    }
    if law.exponent.is_nan() || law.exponent < 0.0 {
        faults.error(
            place.key("exponent"),
            format!("`exponent` must be zero or greater, found {}", law.exponent),
        );
        fine = false;
    }
    let kappa = match beam.shear_correction.unwrap_or_default() {
        ShearCorrection::Classical => Some(RECTANGLE),
        ShearCorrection::Value(value) => {
            positive(value, "shear_correction", path.key("shear_correction"), faults).then_some(value)
        }
        ShearCorrection::Cowper => {
            faults
                .error(
                    path.key("shear_correction"),
                    "`cowper` has no formula for a section of varying modulus",
                )
                .hint("leave `shear_correction` out for 5/6, or give a value");
            None
        }
    };
    // The ratio of the moduli G and E is that of a section of one material.
    let shear_per_young = shear_modulus(beam, Some(1.0), path, faults);
    let (kappa, shear_per_young) = (kappa?, shear_per_young?);
    if !fine {
        return None;
    }
    let PowerLaw { width: b, height: h, bottom_modulus: bottom, top_modulus: top, exponent: p } = *law;
    let (area, step) = (b * h, top - bottom);
    let axial = area * (bottom + step / (p + 1.0));
    let first = area * h * step * p / (2.0 * (p + 1.0) * (p + 2.0));
    let share = (p * p + p + 2.0) / (4.0 * (p + 1.0) * (p + 2.0) * (p + 3.0));
    let second = area * h * h * (bottom / 12.0 + step * share);
    let [bending, shear, axial, coupling] =
        [second, kappa * shear_per_young * axial, axial, -first].map(Profile::Uniform);
    let section = SectionAlong {
        area: Some(Profile::Uniform(area)),
        second_moment: None,
        height: Some(Profile::Uniform(h)),
        kappa: Some(kappa),
    };
    let stiffness = SectionStiffness { bending, shear, axial, coupling, area };
    Some(Resolved { stiffness, section, has_axial: true })
}
