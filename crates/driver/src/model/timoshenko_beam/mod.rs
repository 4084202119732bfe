//! The model `timoshenko_beam`: beams along lines, and frames. `scene::beam` resolves it: its bodies are lines.

mod keys;
mod section;

pub use keys::Beam;
pub use section::{PowerLaw, Stiffness};

use super::{Entry, Growth, Start};
use peristat_assembly::model::timoshenko_beam::{bond_law, end_treatment};

/// What can be chosen: the bond laws and end treatments that there are.
fn options() -> Vec<(String, &'static str)> {
    let laws = bond_law::TABLE.iter().map(|law| (format!("bond_law {}", law.name), law.about));
    let ends = end_treatment::TABLE.iter().map(|end| (format!("end_treatment {}", end.name), end.about));
    laws.chain(ends).collect()
}

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: "timoshenko_beam",
    about: "peridynamic Timoshenko beam: sections rectangle, circle, tube, i, general, tapered, by stiffness, power_law",
    bodies: &[
        ("straight beam, tapered or graded, on an elastic foundation", "timoshenko_beam"),
        ("plane frame, truss", "frames"),
    ],
    options,
    starts: &[
        Start { name: "timoshenko_beam", about: "a cantilever", case: include_str!("start.json") },
        Start {
            name: "plane_frame",
            about: "a portal: joints and members",
            case: include_str!("frame.json"),
        },
    ],
    growth: Growth::Lines,
};
