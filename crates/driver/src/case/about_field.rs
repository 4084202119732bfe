//! What is known of a field of results: its unit, and what it follows from.

use super::Units;

/// What is known of a field, whatever body has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The name in case files and tables.
    pub name: &'static str,
    /// Its unit.
    pub unit: Unit,
    /// What it follows from.
    pub origin: Origin,
}

/// The unit of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A length.
    Length,
    /// Radians.
    Angle,
    /// None.
    One,
    /// A stress; a strain energy per volume is one, too.
    Stress,
    /// A force.
    Force,
    /// A force times a length.
    Moment,
    /// A difference of temperatures.
    Kelvin,
    /// One over a length.
    PerLength,
    /// A force over a length.
    ForcePerLength,
}

impl Unit {
    /// Its label in the units of a case.
    pub fn label(self, units: Units) -> &'static str {
        match self {
            Self::Length => units.length(),
            Self::Angle => "rad",
            Self::One => "",
            Self::Stress => units.stress(),
            Self::Force => units.force(),
            Self::Moment => units.moment(),
            Self::Kelvin => units.temperature(),
            Self::PerLength => units.per_length(),
            Self::ForcePerLength => units.force_per_length(),
        }
    }
}

impl Unit {
    /// The label of its product with a length to some power, such as `N mm` for a stress and a volume.
    pub fn times_length(self, power: i32, units: Units) -> String {
        let (force, own) = match self {
            Self::Length => ("", 1),
            Self::Angle => ("rad", 0),
            Self::One => ("", 0),
            Self::Stress => (units.force(), -2),
            Self::Force => (units.force(), 0),
            Self::Moment => (units.force(), 1),
            Self::Kelvin => (units.temperature(), 0),
            Self::PerLength => ("", -1),
            Self::ForcePerLength => (units.force(), -1),
        };
        let length = match (units.length(), power + own) {
            ("", _) | (_, 0) => return force.into(),
            (length, 1) => length.to_string(),
            (length, -1) => return format!("{force}/{length}"),
            (length, power) => {
                let digit = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(power.unsigned_abs() as usize).unwrap_or('?');
                format!("{length}{digit}")
            }
        };
        format!("{force} {length}").trim_start().into()
    }
}

/// What a field of a plate in bending is: components xx, yy and xy by their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlateOrigin {
    /// A curvature.
    Curvature(usize),
    /// A moment.
    Moment(usize),
    /// A principal moment: the larger one, or the smaller one.
    Principal(usize),
    /// The direction of the larger principal moment.
    Direction,
    /// A shear force, across sections normal to x or y.
    Shear(usize),
    /// A moment of design: along x and y on the side of −w, then on that of +w.
    Design(usize),
    /// What holds a line of points.
    HeldLine,
}

/// What a field follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// The unknown of this name, or in frames those of the members.
    Unknown,
    /// The bonds of a beam.
    Beam,
    /// The rotations and the bonds of a plate in bending.
    Plate(PlateOrigin),
    /// The component of the strains of this name, such as `xy`, and what multiplies it.
    Strain(&'static str, f64),
    /// The component of the stresses of this name; `zz` of bodies in the plane is that across it.
    Stress(&'static str),
    /// The stresses: von Mises.
    VonMises,
    /// The stresses: the principal one of this number, from the largest on.
    Principal(usize),
    /// The stresses: the direction of the larger principal one in the plane.
    PrincipalDirection,
    /// The stresses: half of the largest less the smallest principal one.
    MaxShear,
    /// The stresses: their mean.
    Hydrostatic,
    /// The stresses, turned into the axes of the fibres: along, across, shear.
    FibreStress(usize),
    /// The strains, turned into the axes of the fibres: along, across, half the shear.
    FibreStrain(usize),
    /// Stresses and strengths in the axes of the fibres.
    TsaiHill,
    /// The same.
    TsaiWu,
    /// The same, of the fibres.
    HashinFibre,
    /// The same, of the matrix.
    HashinMatrix,
    /// Stresses and strengths, with fibres or without.
    Utilisation,
    /// The energies of the bonds.
    Energy,
    /// The bonds that are cut.
    Damage,
    /// The loads: changes of temperature.
    Temperature,
    /// The material of a point.
    Material,
    /// The faces of a crack.
    Opening,
    /// What holds the unknown, or the motion of a rigid region, of this name.
    Reaction(&'static str),
    /// The rotation of a rigid region of a solid about this axis.
    Turn(usize),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_with_lengths_have_labels() {
        let of = |unit: Unit, power: i32| unit.times_length(power, Units::MillimetreNewtonMegapascal);
        assert_eq!([of(Unit::Length, 3), of(Unit::One, 3), of(Unit::Angle, 1)], ["mm⁴", "mm³", "rad mm"]);
        assert_eq!([of(Unit::Stress, 3), of(Unit::Stress, 1)], ["N mm", "N/mm"]);
        assert_eq!([of(Unit::Force, 1), of(Unit::Moment, 1)], ["N mm", "N mm²"]);
        assert_eq!(Unit::Stress.times_length(3, Units::Dimensionless), "");
    }
}
