//! Which fields points have, in the order of tables.

use super::FieldName;

impl FieldName {
    /// The fields that every point of a line has, in the order of tables.
    pub(super) const LINE: [Self; 7] =
        [Self::W, Self::Phi, Self::M, Self::V, Self::StressTop, Self::StressBottom, Self::EnergyDensity];

    /// The same where the line has axial unknowns.
    pub(super) const STRETCHED: [Self; 9] = [
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
    pub(super) const FRAME: [Self; 11] = [
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

    /// The fields that every point of a plate in bending has, in the order of tables. Stresses are those on the side of +w; on the
    /// other side they are opposite. `damage` is zero where none break.
    pub const PLATE: [Self; 23] = [
        Self::W,
        Self::PhiX,
        Self::PhiY,
        Self::CurvatureXx,
        Self::CurvatureYy,
        Self::CurvatureXy,
        Self::MomentXx,
        Self::MomentYy,
        Self::MomentXy,
        Self::PrincipalMoment1,
        Self::PrincipalMoment2,
        Self::MomentDirection,
        Self::ShearX,
        Self::ShearY,
        Self::DesignXBottom,
        Self::DesignYBottom,
        Self::DesignXTop,
        Self::DesignYTop,
        Self::StressXx,
        Self::StressYy,
        Self::StressXy,
        Self::VonMises,
        Self::Damage,
    ];

    /// The fields that points of bodies have, in the order of tables; `phi` where they turn, `w` where they move across the plane.
    /// Those that follow from the stresses of a point behind `von_mises` are found on demand, and no table has them.
    pub const BODY: [Self; 39] = [
        Self::Ux,
        Self::Uy,
        Self::Uz,
        Self::W,
        Self::Phi,
        Self::StrainXx,
        Self::StrainYy,
        Self::StrainZz,
        Self::StrainXy,
        Self::StrainXz,
        Self::StrainYz,
        Self::StressXx,
        Self::StressYy,
        Self::StressXy,
        Self::StressXz,
        Self::StressYz,
        Self::StressZz,
        Self::VonMises,
        Self::PrincipalStress1,
        Self::PrincipalStress2,
        Self::PrincipalStress3,
        Self::PrincipalDirection,
        Self::MaxShear,
        Self::Hydrostatic,
        Self::Stress11,
        Self::Stress22,
        Self::Stress12,
        Self::Strain11,
        Self::Strain22,
        Self::Strain12,
        Self::TsaiHill,
        Self::TsaiWu,
        Self::HashinFibre,
        Self::HashinMatrix,
        Self::Utilisation,
        Self::EnergyDensity,
        Self::Damage,
        Self::Temperature,
        Self::Material,
    ];

    /// The fields that every point of a beam has, in the order of tables.
    pub fn of_beam(on_frame: bool, has_axial: bool) -> &'static [Self] {
        match (on_frame, has_axial) {
            (true, _) => &Self::FRAME,
            (false, true) => &Self::STRETCHED,
            (false, false) => &Self::LINE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_case_files() {
        for field in FieldName::FRAME.into_iter().chain(FieldName::BODY).chain(FieldName::PLATE) {
            assert_eq!(serde_json::to_value(field).unwrap(), field.name());
        }
    }
}
