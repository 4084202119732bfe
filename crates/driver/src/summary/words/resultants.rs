//! Resultants of loads and reactions in words.

use super::{Listing, number};
use crate::case::Units;
use crate::run::{Resultants, Total};
use crate::summary::{Forces, StateSummary};

/// Loads as asked for and as applied, and reactions.
pub(super) fn table(found: &Resultants, state: &StateSummary, units: Units) -> Listing {
    let is_line = matches!(&state.forces, Forces::Beam(forces) if forces.members.is_empty() && forces.joint_reactions.is_empty());
    let moment = |axis: &str| units.label(&format!("moment about {axis}"), units.moment());
    let force = |axis: &str| units.label(&format!("force {axis}"), "N");
    let names = match is_line {
        true => [
            "along x".into(),
            "force".into(),
            String::new(),
            String::new(),
            String::new(),
            "moment about x = 0".into(),
        ],
        false => {
            let about_all = found.asked.moments().iter().flatten().count() > 1;
            let last = if about_all { "z" } else { "the origin" };
            [force("x"), force("y"), force("z"), moment("x"), moment("y"), moment(last)]
        }
    };
    let all = [("asked", &found.asked), ("applied", &found.applied), ("reactions", &found.reactions)];
    let size = |of: &dyn Fn(&Total) -> [Option<f64>; 3]| {
        let values = all.iter().flat_map(|(_, total)| of(total)).flatten();
        values.fold(0.0, |size: f64, value| size.max(value.abs()))
    };
    let (forces, moments) = (size(&Total::forces), size(&Total::moments));
    // What is rounding beside the largest force, or moment, reads as zero.
    let lines = |size: f64| move |value: f64| number(if value.abs() < 1e-11 * size { 0.0 } else { value });
    let row = |(name, total): (&str, &Total)| {
        let of_forces = total.forces().into_iter().flatten().map(lines(forces));
        let of_moments = total.moments().into_iter().flatten().map(lines(moments));
        std::iter::once(name.to_string()).chain(of_forces).chain(of_moments).collect()
    };
    let asked = found.asked.forces().into_iter().chain(found.asked.moments());
    let counted = names.iter().zip(asked).filter(|(_, part)| part.is_some());
    let header: Vec<&str> =
        std::iter::once("resultant").chain(counted.map(|(name, _)| name.as_str())).collect();
    Listing::whole(&header, all.into_iter().map(row).collect())
}
