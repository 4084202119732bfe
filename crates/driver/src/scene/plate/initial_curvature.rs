//! Curvatures that plates have from the beginning.

use super::loads::{self, Made};
use super::plate_loads::PlateLoads;
use super::pressure;
use super::site::Site;
use crate::case::InitialStrain;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::FreeCurvature;

/// The components, as `[κ_xx, κ_yy, κ_xy]`.
const COMPONENTS: [(&str, [f64; 3]); 3] =
    [("xx", [1.0, 0.0, 0.0]), ("yy", [0.0, 1.0, 0.0]), ("xy", [0.0, 0.0, 1.0])];

/// Adds an initial curvature.
pub(super) fn add(
    load: &InitialStrain,
    (site, factor): (&Site, Option<f64>),
    made: &Made,
    path: &JsonPath,
    to: &mut PlateLoads,
    faults: &mut Faults,
) {
    let before = faults.errors();
    for key in load.of_lines() {
        faults
            .error(path.key(key), format!("`{key}` is for lines and members"))
            .hint("a plate in bending has the curvatures `xx`, `yy` and `xy`, of a `region` or all of it");
    }
    let Some(cells) = pressure::inside(load.region.as_ref(), site, path, faults) else { return };
    let mut is_zero = true;
    for (name, amount) in load.components() {
        let (Some(amount), path) = (amount, path.key(name)) else { continue };
        let Some((_, unit)) = COMPONENTS.into_iter().find(|component| component.0 == name) else {
            faults
                .error(path, format!("a plate in bending has no curvature `{name}`"))
                .hint("its curvatures are `xx`, `yy` and `xy`");
            continue;
        };
        let Some(given) = Prescribed::new(amount, (2, factor), &path, faults) else { continue };
        if given.is_zero() {
            continue;
        }
        is_zero = false;
        let units = vec![unit; made.thickness.of_sections.len()];
        let values = loads::values(&given, (site, &cells), &path, faults);
        to.bend(FreeCurvature { cells: cells.clone().numbers(), units, values }, made.plate);
    }
    if is_zero && factor.is_none() && faults.errors() == before {
        faults.error(path.clone(), "this load is zero").hint("give curvatures, such as `\"xx\": 1e-3`");
    }
}
