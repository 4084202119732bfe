//! Probes and checks of a case.

use super::At;
use crate::reference::Field;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A field that can be probed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum FieldName {
    /// Deflection, across the line or member; displacement of a shell outwards.
    #[serde(rename = "w")]
    W,
    /// Displacement along the line or member.
    #[serde(rename = "u")]
    U,
    /// Displacement along x, on a frame or in the plane.
    #[serde(rename = "ux")]
    Ux,
    /// Displacement along y, on a frame or in the plane.
    #[serde(rename = "uy")]
    Uy,
    /// Rotation, rad; in the plane that of a rigid region, or of a point where points turn.
    #[serde(rename = "phi")]
    Phi,
    /// Bending moment.
    M,
    /// Shear force.
    V,
    /// Axial force, tension positive.
    N,
    /// Normal stress at the extreme fibre on the side of +w.
    #[serde(rename = "stress_top")]
    StressTop,
    /// Normal stress at the extreme fibre on the side of −w.
    #[serde(rename = "stress_bottom")]
    StressBottom,
    /// Normal strain along x, in the plane.
    #[serde(rename = "strain_xx")]
    StrainXx,
    /// Normal strain along y, in the plane.
    #[serde(rename = "strain_yy")]
    StrainYy,
    /// Shear strain ε_xy, half the change of the right angle, in the plane.
    #[serde(rename = "strain_xy")]
    StrainXy,
    /// Normal stress along x, in the plane.
    #[serde(rename = "stress_xx")]
    StressXx,
    /// Normal stress along y, in the plane.
    #[serde(rename = "stress_yy")]
    StressYy,
    /// Shear stress, in the plane.
    #[serde(rename = "stress_xy")]
    StressXy,
    /// Normal stress across the plane: around the axis of a body of revolution; zero in plane stress and in shells.
    #[serde(rename = "stress_zz")]
    StressZz,
    /// Von Mises stress, in the plane.
    #[serde(rename = "von_mises")]
    VonMises,
    /// Opening of a crack at a position on it, in the plane: the displacement of its upper face less that of the lower one,
    /// normal to it, of a crack along y of the right one less the left one. Both faces are extrapolated from two rows.
    #[serde(rename = "opening")]
    Opening,
    /// Share of the neighbours' volume from which cracks cut a point off, 0 to 1, in the plane; zero where nothing is cut.
    #[serde(rename = "damage")]
    Damage,
    /// Strain energy density, per volume.
    #[serde(rename = "energy_density")]
    EnergyDensity,
    /// Force of the support at the point on the beam, or of those in the region of a shell, along w.
    #[serde(rename = "reaction_force")]
    ReactionForce,
    /// Force of the support at the point, or of those in the region, on the body, along x.
    #[serde(rename = "reaction_x")]
    ReactionX,
    /// Force of the support at the point, or of those in the region, on the body, along y.
    #[serde(rename = "reaction_y")]
    ReactionY,
    /// Moment of the support at the point on the beam, along phi; in the plane, where points turn, of all that holds the
    /// rotations of the points of the region.
    #[serde(rename = "reaction_moment")]
    ReactionMoment,
}

impl FieldName {
    /// The fields that every point of a line has, in the order of tables.
    const LINE: [Self; 7] =
        [Self::W, Self::Phi, Self::M, Self::V, Self::StressTop, Self::StressBottom, Self::EnergyDensity];

    /// The same where the line has axial unknowns.
    const STRETCHED: [Self; 9] = [
        Self::W,
        Self::Phi,
        Self::U,
        Self::M,
        Self::V,
        Self::N,
        Self::StressTop,
        Self::StressBottom,
        Self::EnergyDensity,
    ];

    /// The fields that every point of a frame has, in the order of tables.
    const FRAME: [Self; 11] = [
        Self::Ux,
        Self::Uy,
        Self::W,
        Self::U,
        Self::Phi,
        Self::N,
        Self::V,
        Self::M,
        Self::StressTop,
        Self::StressBottom,
        Self::EnergyDensity,
    ];

    /// The fields that points of bodies in the plane have, in the order of tables; `phi` where they turn, `w` in shells.
    pub const PLANE: [Self; 14] = [
        Self::Ux,
        Self::Uy,
        Self::W,
        Self::Phi,
        Self::StrainXx,
        Self::StrainYy,
        Self::StrainXy,
        Self::StressXx,
        Self::StressYy,
        Self::StressXy,
        Self::StressZz,
        Self::VonMises,
        Self::EnergyDensity,
        Self::Damage,
    ];

    /// The fields that every point of a beam has, in the order of tables.
    pub fn of_beam(on_frame: bool, has_axial: bool) -> &'static [Self] {
        match (on_frame, has_axial) {
            (true, _) => &Self::FRAME,
            (false, true) => &Self::STRETCHED,
            (false, false) => &Self::LINE,
        }
    }

    /// The name in case files.
    pub fn name(self) -> &'static str {
        match self {
            Self::W => "w",
            Self::U => "u",
            Self::Ux => "ux",
            Self::Uy => "uy",
            Self::Phi => "phi",
            Self::M => "M",
            Self::V => "V",
            Self::N => "N",
            Self::StressTop => "stress_top",
            Self::StressBottom => "stress_bottom",
            Self::StrainXx => "strain_xx",
            Self::StrainYy => "strain_yy",
            Self::StrainXy => "strain_xy",
            Self::StressXx => "stress_xx",
            Self::StressYy => "stress_yy",
            Self::StressXy => "stress_xy",
            Self::StressZz => "stress_zz",
            Self::VonMises => "von_mises",
            Self::Opening => "opening",
            Self::Damage => "damage",
            Self::EnergyDensity => "energy_density",
            Self::ReactionForce => "reaction_force",
            Self::ReactionX => "reaction_x",
            Self::ReactionY => "reaction_y",
            Self::ReactionMoment => "reaction_moment",
        }
    }

    /// Whether it is a force or moment of a support.
    pub fn is_reaction(self) -> bool {
        matches!(self, Self::ReactionForce | Self::ReactionX | Self::ReactionY | Self::ReactionMoment)
    }

    /// Whether it is recovered from the bonds, beyond the unknowns and reactions.
    pub fn is_recovered(self) -> bool {
        let is_displacement =
            matches!(self, Self::W | Self::U | Self::Ux | Self::Uy | Self::Phi | Self::Opening);
        !self.is_reaction() && !is_displacement
    }
}

/// A value to report.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name, unique.
    pub name: String,
    /// Where: a point of the grid, a joint, a place in the plane or a region. M, V and N are those to its right, at the right
    /// end those to its left; of a region it is the mean by volume, of reactions the sum.
    pub at: At,
    /// What.
    pub field: FieldName,
}

/// What a result must be. A check is made on the last load step, on `load_case` if that is given.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Check {
    /// Agreement with a closed form at all points.
    ClosedForm(ClosedForm),
    /// Agreement of a probe with a number.
    Value(Value),
    /// A bound on a probe.
    Limit(Limit),
    /// Agreement of all points with a stored file.
    Baseline(Baseline),
    /// Agreement of all points of a body in the plane with an expression in their coordinates.
    Formula(Formula),
}

/// Agreement with a closed form.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClosedForm {
    /// Name of the reference; `peristat list` has them all.
    pub name: String,
    /// Field that is compared.
    pub field: Field,
    /// Largest difference at any point, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with a number.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Value {
    /// Name of the probe.
    pub probe: String,
    /// Expected value.
    pub expected: f64,
    /// Largest difference relative to the expected value; absolute if that is zero.
    pub tolerance: f64,
    /// Where the number comes from.
    pub source: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// A bound on the magnitude of a probe, on both sides of it where the field jumps.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limit {
    /// Name of the probe.
    pub probe: String,
    /// Largest magnitude allowed.
    pub at_most: f64,
    /// Why, such as `L/250`.
    pub why: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with a stored file.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    /// CSV file with columns `x` (`s` for a frame, `x` and `y` in the plane) and the field, relative to the case, in its folder or below: a file of the folder `fields` of an earlier run will do.
    pub file: String,
    /// Field that is compared.
    pub field: FieldName,
    /// Largest difference at any point, relative to the largest stored value.
    pub tolerance: f64,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with an expression in x and y, at all points of a body in the plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Formula {
    /// Field that is compared.
    pub field: FieldName,
    /// The exact value at (x, y), such as `1e-3*x - 2*y^2`: + - * / ^, parentheses, pi, e, sqrt, exp, log, log10, sin, cos,
    /// tan, asin, acos, atan, atan2(y, x), sinh, cosh, tanh, abs, min, max. `-x^2` is −(x²); powers of powers need parentheses.
    pub is: String,
    /// Largest difference at any point, relative to the largest value of the formula.
    pub tolerance: f64,
    /// Where the formula comes from.
    pub source: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}
