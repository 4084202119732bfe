//! Temperatures that differ over the thickness.
//!
//! A plate whose top is warmer by D than its bottom has the curvature `−αD/t` in all directions without moments.

use super::loads::{self, Made};
use super::plate_loads::PlateLoads;
use super::pressure;
use super::site::Site;
use crate::case::Temperature;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::expansion;
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::FreeCurvature;

/// Adds a temperature.
pub(super) fn add(
    load: &Temperature,
    (site, factor): (&Site, Option<f64>),
    made: &Made,
    path: &JsonPath,
    to: &mut PlateLoads,
    faults: &mut Faults,
) {
    if load.member.is_some() {
        faults.error(path.key("member"), "`member` is for frames").hint("name a `region`, or leave it out");
    }
    if load.change.is_some() {
        faults
            .error(
                path.key("change"),
                "a plate in bending that is as warm at the top as at the bottom does not bend",
            )
            .hint("give the `difference` of the top, the side of +w, against the bottom");
        return;
    }
    let Some(given) = &load.difference else {
        faults
            .error(path.clone(), "`difference` is missing")
            .hint("kelvin by which the top, the side of +w, becomes warmer than the bottom");
        return;
    };
    let alpha = expansion::of(site.case, false, path, faults);
    let Some(difference) = Prescribed::new(given, (2, factor), &path.key("difference"), faults) else {
        return;
    };
    if difference.is_zero() && factor.is_none() {
        faults.error(path.clone(), "this load is zero").hint("give another `difference`");
    }
    let cells = pressure::inside(load.region.as_ref(), site, path, faults);
    let (Some(alpha), Some(cells)) = (alpha, cells) else { return };
    let alpha = alpha.along_and_across()[0];
    let own = made.materials.iter().map(|material| material.thermal_expansion.unwrap_or(alpha));
    let expansions = [alpha].into_iter().chain(own).zip(&made.thickness.of_sections);
    let units = expansions.map(|(alpha, t)| [-alpha / t, -alpha / t, 0.0]).collect();
    let values = loads::values(&difference, (site, &cells), &path.key("difference"), faults);
    to.bend(FreeCurvature { cells: cells.numbers(), units, values }, made.plate);
}
