//! The model `beam_bond_orthotropic`: plates of beam bonds with fibres at any angle.

mod critical;
mod keys;
mod material;
mod resolve;
mod words;

pub use keys::{LatticeRows, Orthotropic};

use super::entry::plain;
use super::{Entry, Growth, Place, Refusal, Start};
use peristat_assembly::model::beam_bond_orthotropic::{OrthotropicError, OrthotropicParameters};
use peristat_assembly::model::plane::Calibration;

/// Name in case files.
const NAME: &str = "beam_bond_orthotropic";

/// Horizon ratio with which bonds of a lattice represent stiff fibres at any angle.
const OBLIQUE: f64 = 3.2;

/// Beam bonds and the keys that they come from.
#[derive(Clone, Debug)]
struct BeamBonds {
    keys: Orthotropic,
    parameters: OrthotropicParameters,
    /// Angles of the fibres of other laminae, degrees.
    angles: Vec<f64>,
}

impl BeamBonds {
    /// The lamina of points with fibres at an angle from x, degrees: zero that of the model.
    fn lamina(&self, angle: Option<f64>) -> u8 {
        let own = angle.and_then(|angle| self.angles.iter().position(|other| are_alike(*other, angle)));
        own.map_or(0, |place| place as u8 + 1)
    }

    /// Angles of the fibres of other laminae, rad.
    fn angles(&self) -> Vec<f64> {
        self.angles.iter().map(|angle| angle.to_radians()).collect()
    }
}

/// Whether fibres at two angles, degrees, are the same.
fn are_alike(a: f64, b: f64) -> bool {
    (a - b) % 180.0 == 0.0
}

/// Why bonds of a calibration cannot be made.
fn refusal(error: &OrthotropicError, calibration: Calibration) -> Refusal {
    let at = match error {
        OrthotropicError::NotPositive { .. } | OrthotropicError::Exchanged { .. } => "youngs_modulus_1",
        OrthotropicError::NotFinite { .. }
        | OrthotropicError::NotDefinite { .. }
        | OrthotropicError::NegativeMatrixShear { .. } => "poisson_ratio_12",
        OrthotropicError::ShearTooSoft { .. } | OrthotropicError::NegativeFibreShear { .. } => {
            "shear_modulus_12"
        }
        OrthotropicError::NoNeighbours { .. } | OrthotropicError::NotRepresentable { .. } => {
            return Refusal::new(error, Place::Horizon);
        }
        OrthotropicError::NoFibreBonds { .. } => return no_fibre_bonds(error, calibration),
        OrthotropicError::StartNeedsMatched => "start",
        OrthotropicError::OverlayNeedsMatched => "edges",
        OrthotropicError::FibreReleaseTooSmall { .. } => return Refusal::new(error, Place::Critical),
    };
    Refusal::new(error, Place::Key(at))
}

/// What needs bonds along the fibres, where there are none.
fn no_fibre_bonds(error: &OrthotropicError, calibration: Calibration) -> Refusal {
    let (key, other) = match calibration {
        Calibration::Published => ("calibration", "the calibration `matched`"),
        Calibration::Matched => ("start", "the start `oblique`"),
    };
    let hint =
        format!(r#""lattice": "fibre" turns the lattice with the fibres; {other} needs no bonds along them"#);
    Refusal { hint: Some(hint), ..Refusal::new(error, Place::Key(key)) }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 4] = [
    (
        "start aligned",
        "bonds that lie exactly on the fibres carry what the fibres add (default where there are such bonds)",
    ),
    (
        "start oblique",
        "the closer bonds are to the fibres, the more of it they carry: elasticity at any angle",
    ),
    ("lattice axes", "rows of the lattice along x (default)"),
    ("lattice fibre", "rows of the lattice along the fibres, so that bonds lie on them whatever their angle"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "orthotropic plate of beam bonds, plane stress, fibres at any angle: rectangle, outline; points turn; calibrations and edges as bond_plane",
    bodies: &[("plate with fibres: deflections, cracks", "beam_bond_orthotropic")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a plate of fibres with a hole", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
