//! Resultants of loads and reactions in words.

use super::{Listing, number};
use crate::case::Units;
use crate::run::{Resultants, Total};
use crate::summary::{Forces, StateSummary};

/// Loads as asked for and as applied, and reactions.
pub(super) fn table(found: &Resultants, state: &StateSummary, units: Units) -> Listing {
    let is_line = matches!(&state.forces, Forces::Beam(forces) if forces.members.is_empty() && forces.joint_reactions.is_empty());
    let names = match is_line {
        true => ["along x".into(), "force".into(), "moment about x = 0".into()],
        false => [
            units.label("force x", "N"),
            units.label("force y", "N"),
            units.label("moment about the origin", units.moment()),
        ],
    };
    let all = [("asked", &found.asked), ("applied", &found.applied), ("reactions", &found.reactions)];
    let sizes = [0, 1, 2].map(|k| {
        let values = all.iter().filter_map(|(_, total)| total.parts()[k]);
        values.fold(0.0, |size: f64, value| size.max(value.abs()))
    });
    let forces = sizes[0].max(sizes[1]);
    // What is rounding beside the largest force, or moment, reads as zero.
    let row = |(name, total): (&str, &Total)| {
        let parts = total.parts().into_iter().zip([forces, forces, sizes[2]]);
        let values = parts.filter_map(|(part, size)| {
            part.map(|value| number(if value.abs() < 1e-11 * size { 0.0 } else { value }))
        });
        std::iter::once(name.to_string()).chain(values).collect()
    };
    let counted = names.iter().zip(found.asked.parts()).filter(|(_, part)| part.is_some());
    let header: Vec<&str> =
        std::iter::once("resultant").chain(counted.map(|(name, _)| name.as_str())).collect();
    Listing::whole(&header, all.into_iter().map(row).collect())
}
