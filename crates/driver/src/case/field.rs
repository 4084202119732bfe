//! Fields of results and their names.

use super::about_field::{Field, Origin, PlateOrigin, Unit};
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
    /// Displacement along z, of a solid.
    #[serde(rename = "uz")]
    Uz,
    /// Rotation, rad; in the plane that of a rigid region, or of a point where points turn.
    #[serde(rename = "phi")]
    Phi,
    /// Rotation of a rigid region of a solid about x, rad; of a plate in bending the slope of w along x where shear is rigid.
    #[serde(rename = "phi_x")]
    PhiX,
    /// Rotation of a rigid region of a solid about y, rad; of a plate in bending the slope of w along y where shear is rigid.
    #[serde(rename = "phi_y")]
    PhiY,
    /// Rotation of a rigid region of a solid about z, rad.
    #[serde(rename = "phi_z")]
    PhiZ,
    /// Bending moment.
    M,
    /// Shear force.
    V,
    /// Axial force, tension positive.
    N,
    /// Curvature ∂φ_x/∂x of a plate in bending.
    #[serde(rename = "curvature_xx")]
    CurvatureXx,
    /// Curvature ∂φ_y/∂y of a plate in bending.
    #[serde(rename = "curvature_yy")]
    CurvatureYy,
    /// Twist of a plate in bending, (∂φ_x/∂y + ∂φ_y/∂x)/2.
    #[serde(rename = "curvature_xy")]
    CurvatureXy,
    /// Moment per width of a plate in bending, of stresses along x; positive, it shortens the side of +w.
    #[serde(rename = "M_xx")]
    MomentXx,
    /// The same of stresses along y.
    #[serde(rename = "M_yy")]
    MomentYy,
    /// Twisting moment per width of a plate in bending.
    #[serde(rename = "M_xy")]
    MomentXy,
    /// Larger principal moment per width of a plate in bending.
    #[serde(rename = "M_1")]
    PrincipalMoment1,
    /// Smaller principal moment per width of a plate in bending.
    #[serde(rename = "M_2")]
    PrincipalMoment2,
    /// Angle from the x axis to the direction of the larger principal moment, rad, above −π/2 and at most π/2.
    #[serde(rename = "M_direction")]
    MomentDirection,
    /// Shear force per width of a plate in bending, across sections normal to x.
    #[serde(rename = "V_x")]
    ShearX,
    /// The same across sections normal to y.
    #[serde(rename = "V_y")]
    ShearY,
    /// Moment per width for which reinforcement along x on the side of −w is designed, by Wood and Armer; zero where none is needed.
    #[serde(rename = "design_x_bottom")]
    DesignXBottom,
    /// The same along y on the side of −w.
    #[serde(rename = "design_y_bottom")]
    DesignYBottom,
    /// The same along x on the side of +w, by its magnitude.
    #[serde(rename = "design_x_top")]
    DesignXTop,
    /// The same along y on the side of +w, by its magnitude.
    #[serde(rename = "design_y_top")]
    DesignYTop,
    /// Normal stress at the extreme fibre on the side of +w.
    #[serde(rename = "stress_top")]
    StressTop,
    /// Normal stress at the extreme fibre on the side of −w.
    #[serde(rename = "stress_bottom")]
    StressBottom,
    /// Normal strain along x.
    #[serde(rename = "strain_xx")]
    StrainXx,
    /// Normal strain along y.
    #[serde(rename = "strain_yy")]
    StrainYy,
    /// Normal strain along z, of a solid.
    #[serde(rename = "strain_zz")]
    StrainZz,
    /// Shear strain ε_xy, half the change of the right angle.
    #[serde(rename = "strain_xy")]
    StrainXy,
    /// Shear strain ε_xz, half the change of the right angle, of solids and where points move across the plane.
    #[serde(rename = "strain_xz")]
    StrainXz,
    /// Shear strain ε_yz, half the change of the right angle, of solids and where points move across the plane.
    #[serde(rename = "strain_yz")]
    StrainYz,
    /// Normal stress along x.
    #[serde(rename = "stress_xx")]
    StressXx,
    /// Normal stress along y.
    #[serde(rename = "stress_yy")]
    StressYy,
    /// Shear stress σ_xy.
    #[serde(rename = "stress_xy")]
    StressXy,
    /// Shear stress σ_xz, of solids and where points move across the plane.
    #[serde(rename = "stress_xz")]
    StressXz,
    /// Shear stress σ_yz, of solids and where points move across the plane.
    #[serde(rename = "stress_yz")]
    StressYz,
    /// Normal stress along z, across the plane: around the axis of a body of revolution; zero in plane stress and in shells.
    #[serde(rename = "stress_zz")]
    StressZz,
    /// Von Mises stress.
    #[serde(rename = "von_mises")]
    VonMises,
    /// Largest principal stress of the three-dimensional stress, that across the plane included.
    #[serde(rename = "principal_stress_1")]
    PrincipalStress1,
    /// Middle principal stress.
    #[serde(rename = "principal_stress_2")]
    PrincipalStress2,
    /// Smallest principal stress, the largest compression.
    #[serde(rename = "principal_stress_3")]
    PrincipalStress3,
    /// Angle from the x axis to the direction of the larger principal stress in the plane, rad, above −π/2 and at most π/2.
    #[serde(rename = "principal_direction")]
    PrincipalDirection,
    /// Largest shear stress on any plane through the point: half of the largest less the smallest principal stress.
    #[serde(rename = "max_shear")]
    MaxShear,
    /// Mean of the three normal stresses, tension positive.
    #[serde(rename = "hydrostatic")]
    Hydrostatic,
    /// Normal stress along the fibres.
    #[serde(rename = "stress_11")]
    Stress11,
    /// Normal stress across the fibres.
    #[serde(rename = "stress_22")]
    Stress22,
    /// Shear stress along and across the fibres.
    #[serde(rename = "stress_12")]
    Stress12,
    /// Normal strain along the fibres.
    #[serde(rename = "strain_11")]
    Strain11,
    /// Normal strain across the fibres.
    #[serde(rename = "strain_22")]
    Strain22,
    /// Shear strain ε_12, half the change of the right angle between the fibres and what is across.
    #[serde(rename = "strain_12")]
    Strain12,
    /// Index of Tsai and Hill, 1 where fibres or matrix fail; needs `strengths`, as those that follow.
    #[serde(rename = "tsai_hill")]
    TsaiHill,
    /// Index of Tsai and Wu, 1 at failure.
    #[serde(rename = "tsai_wu")]
    TsaiWu,
    /// Index of Hashin for the fibres, 1 at failure.
    #[serde(rename = "hashin_fibre")]
    HashinFibre,
    /// Index of Hashin for the matrix, 1 at failure.
    #[serde(rename = "hashin_matrix")]
    HashinMatrix,
    /// Share of the strength that is used, proportional to the load: von Mises stress over `yield_stress`, with fibres by the criterion of Tsai and Wu.
    #[serde(rename = "utilisation")]
    Utilisation,
    /// Opening of a crack at a position on it, in the plane: the displacement of its upper face less that of the lower one,
    /// normal to it, of a crack along y of the right one less the left one. Both faces are extrapolated from two rows.
    #[serde(rename = "opening")]
    Opening,
    /// Share of the neighbours' volume from which cracks cut a point off, 0 to 1, in the plane; of a plate in bending that of its bonds;
    /// zero where nothing is cut.
    #[serde(rename = "damage")]
    Damage,
    /// Change of temperature, kelvin, where a load changes it.
    #[serde(rename = "temperature")]
    Temperature,
    /// Number of the material of a point: 0 for that of `model`, then 1, 2 and so on for `materials` by their names.
    #[serde(rename = "material")]
    Material,
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
    /// Force of the supports in the region on a solid, along z.
    #[serde(rename = "reaction_z")]
    ReactionZ,
    /// Moment of the support at the point on the beam, along phi; in the plane, where points turn, of all that holds the
    /// rotations of the points of the region.
    #[serde(rename = "reaction_moment")]
    ReactionMoment,
    /// Moment of what holds a rigid region of a solid, about x through its centre.
    #[serde(rename = "reaction_moment_x")]
    ReactionMomentX,
    /// Moment of what holds a rigid region of a solid, about y through its centre.
    #[serde(rename = "reaction_moment_y")]
    ReactionMomentY,
    /// Moment of what holds a rigid region of a solid, about z through its centre.
    #[serde(rename = "reaction_moment_z")]
    ReactionMomentZ,
    /// Force of a support on a plate in bending per length of a straight edge or of a line inside, along w: Kirchhoff's effective one,
    /// which has the twisting moment of a hard support in it. With `of`, or at a place on the line.
    #[serde(rename = "reaction_per_length")]
    ReactionPerLength,
    /// Moment of a support on a plate in bending per length, which bends it across an edge: M_nn there.
    #[serde(rename = "reaction_moment_per_length")]
    ReactionMomentPerLength,
    /// Force of supports on a plate in bending at a corner or another end of a line that is held, along w, beside what is along
    /// the line; the sum of those in a region.
    #[serde(rename = "corner_force")]
    CornerForce,
}

impl FieldName {
    /// What is known of it.
    pub const fn about(self) -> Field {
        use {Origin::*, Unit::*};
        let (name, unit, origin) = match self {
            Self::W => ("w", Length, Unknown),
            Self::U => ("u", Length, Unknown),
            Self::Ux => ("ux", Length, Unknown),
            Self::Uy => ("uy", Length, Unknown),
            Self::Uz => ("uz", Length, Unknown),
            Self::Phi => ("phi", Angle, Unknown),
            Self::PhiX => ("phi_x", Angle, Turn(0)),
            Self::PhiY => ("phi_y", Angle, Turn(1)),
            Self::PhiZ => ("phi_z", Angle, Turn(2)),
            Self::M => ("M", Moment, Beam),
            Self::V => ("V", Force, Beam),
            Self::N => ("N", Force, Beam),
            Self::CurvatureXx => ("curvature_xx", PerLength, Plate(PlateOrigin::Curvature(0))),
            Self::CurvatureYy => ("curvature_yy", PerLength, Plate(PlateOrigin::Curvature(1))),
            Self::CurvatureXy => ("curvature_xy", PerLength, Plate(PlateOrigin::Curvature(2))),
            // A moment per width is a force.
            Self::MomentXx => ("M_xx", Force, Plate(PlateOrigin::Moment(0))),
            Self::MomentYy => ("M_yy", Force, Plate(PlateOrigin::Moment(1))),
            Self::MomentXy => ("M_xy", Force, Plate(PlateOrigin::Moment(2))),
            Self::PrincipalMoment1 => ("M_1", Force, Plate(PlateOrigin::Principal(0))),
            Self::PrincipalMoment2 => ("M_2", Force, Plate(PlateOrigin::Principal(1))),
            Self::MomentDirection => ("M_direction", Angle, Plate(PlateOrigin::Direction)),
            Self::ShearX => ("V_x", ForcePerLength, Plate(PlateOrigin::Shear(0))),
            Self::ShearY => ("V_y", ForcePerLength, Plate(PlateOrigin::Shear(1))),
            Self::DesignXBottom => ("design_x_bottom", Force, Plate(PlateOrigin::Design(0))),
            Self::DesignYBottom => ("design_y_bottom", Force, Plate(PlateOrigin::Design(1))),
            Self::DesignXTop => ("design_x_top", Force, Plate(PlateOrigin::Design(2))),
            Self::DesignYTop => ("design_y_top", Force, Plate(PlateOrigin::Design(3))),
            Self::StressTop => ("stress_top", Unit::Stress, Beam),
            Self::StressBottom => ("stress_bottom", Unit::Stress, Beam),
            Self::StrainXx => ("strain_xx", One, Strain("xx", 1.0)),
            Self::StrainYy => ("strain_yy", One, Strain("yy", 1.0)),
            Self::StrainZz => ("strain_zz", One, Strain("zz", 1.0)),
            // ε_xy is half of γ_xy.
            Self::StrainXy => ("strain_xy", One, Strain("xy", 0.5)),
            Self::StrainXz => ("strain_xz", One, Strain("xz", 0.5)),
            Self::StrainYz => ("strain_yz", One, Strain("yz", 0.5)),
            Self::StressXx => ("stress_xx", Unit::Stress, Origin::Stress("xx")),
            Self::StressYy => ("stress_yy", Unit::Stress, Origin::Stress("yy")),
            Self::StressXy => ("stress_xy", Unit::Stress, Origin::Stress("xy")),
            Self::StressXz => ("stress_xz", Unit::Stress, Origin::Stress("xz")),
            Self::StressYz => ("stress_yz", Unit::Stress, Origin::Stress("yz")),
            Self::StressZz => ("stress_zz", Unit::Stress, Origin::Stress("zz")),
            Self::VonMises => ("von_mises", Unit::Stress, VonMises),
            Self::PrincipalStress1 => ("principal_stress_1", Unit::Stress, Principal(0)),
            Self::PrincipalStress2 => ("principal_stress_2", Unit::Stress, Principal(1)),
            Self::PrincipalStress3 => ("principal_stress_3", Unit::Stress, Principal(2)),
            Self::PrincipalDirection => ("principal_direction", Angle, PrincipalDirection),
            Self::MaxShear => ("max_shear", Unit::Stress, MaxShear),
            Self::Hydrostatic => ("hydrostatic", Unit::Stress, Hydrostatic),
            Self::Stress11 => ("stress_11", Unit::Stress, FibreStress(0)),
            Self::Stress22 => ("stress_22", Unit::Stress, FibreStress(1)),
            Self::Stress12 => ("stress_12", Unit::Stress, FibreStress(2)),
            Self::Strain11 => ("strain_11", One, FibreStrain(0)),
            Self::Strain22 => ("strain_22", One, FibreStrain(1)),
            Self::Strain12 => ("strain_12", One, FibreStrain(2)),
            Self::TsaiHill => ("tsai_hill", One, TsaiHill),
            Self::TsaiWu => ("tsai_wu", One, TsaiWu),
            Self::HashinFibre => ("hashin_fibre", One, HashinFibre),
            Self::HashinMatrix => ("hashin_matrix", One, HashinMatrix),
            Self::Utilisation => ("utilisation", One, Utilisation),
            Self::Opening => ("opening", Length, Opening),
            Self::Damage => ("damage", One, Damage),
            Self::Temperature => ("temperature", Kelvin, Temperature),
            Self::Material => ("material", One, Material),
            Self::EnergyDensity => ("energy_density", Unit::Stress, Energy),
            Self::ReactionForce => ("reaction_force", Force, Reaction("w")),
            Self::ReactionX => ("reaction_x", Force, Reaction("ux")),
            Self::ReactionY => ("reaction_y", Force, Reaction("uy")),
            Self::ReactionZ => ("reaction_z", Force, Reaction("uz")),
            Self::ReactionMoment => ("reaction_moment", Moment, Reaction("phi")),
            Self::ReactionMomentX => ("reaction_moment_x", Moment, Reaction("phi_x")),
            Self::ReactionMomentY => ("reaction_moment_y", Moment, Reaction("phi_y")),
            Self::ReactionMomentZ => ("reaction_moment_z", Moment, Reaction("phi_z")),
            Self::ReactionPerLength => ("reaction_per_length", ForcePerLength, Plate(PlateOrigin::HeldLine)),
            Self::ReactionMomentPerLength => {
                ("reaction_moment_per_length", Force, Plate(PlateOrigin::HeldLine))
            }
            Self::CornerForce => ("corner_force", Force, Plate(PlateOrigin::HeldLine)),
        };
        Field { name, unit, origin }
    }

    /// The name in case files.
    pub const fn name(self) -> &'static str {
        self.about().name
    }

    /// Whether it is a force or moment of a support.
    pub fn is_reaction(self) -> bool {
        matches!(self.about().origin, Origin::Reaction(_))
    }

    /// Whether it is recovered from the bonds, beyond the unknowns and reactions.
    pub fn is_recovered(self) -> bool {
        use Origin::{Material, Opening, Plate, Reaction, Turn, Unknown};
        let origin = self.about().origin;
        !matches!(origin, Reaction(_) | Unknown | Opening | Turn(_) | Material | Plate(PlateOrigin::HeldLine))
    }
}
