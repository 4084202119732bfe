//! The model `beam_bond_orthotropic` of a case.

use peristat_assembly::model::beam_bond_orthotropic::Start;
use peristat_assembly::model::plane::{Calibration, Edges};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A body in plane stress of beam bonds, whose points turn; direction 1 is that of the fibres.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orthotropic {
    /// Young's modulus along the fibres E1, >= E2; both are the same in an isotropic material.
    pub youngs_modulus_1: f64,
    /// Young's modulus across the fibres E2, > 0.
    pub youngs_modulus_2: f64,
    /// Poisson's ratio ν12: contraction across the fibres per stretch along them.
    pub poisson_ratio_12: f64,
    /// Shear modulus G12, greater than ν12 E2/(1 − ν12 ν21).
    pub shear_modulus_12: f64,
    /// Thickness, > 0; 1 if not given.
    #[serde(default = "one")]
    pub thickness: f64,
    /// Angle of the fibres from x, counter-clockwise, degrees, from −360 to 360.
    pub fibre_angle: f64,
    /// Where the stiffness of bonds comes from; `matched` if not given. Bodies of bonds as `published` are too soft in shear.
    #[serde(default)]
    pub calibration: Calibration,
    /// From where the calibration `matched` looks for bonds; `aligned` where bonds lie exactly on the fibres, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Start>,
    /// Along what the rows of the lattice run; `axes` if not given.
    #[serde(default)]
    pub lattice: LatticeRows,
    /// What is done about the bonds that points near edges lack; `border` with the calibration `matched`, `none` with
    /// `published`, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Edges>,
}

/// Along what the rows of a lattice run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LatticeRows {
    /// Along x: edges along x and y are smooth.
    #[default]
    Axes,
    /// Along the fibres: bonds lie exactly on them, whatever their angle.
    Fibre,
}

fn one() -> f64 {
    1.0
}
