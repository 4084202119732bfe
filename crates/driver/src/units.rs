//! Numbers with their units, as people read them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// A label for consistent units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Units {
    /// Metre, newton, pascal.
    #[default]
    #[serde(rename = "m-N-Pa")]
    MetreNewtonPascal,
    /// Millimetre, newton, megapascal.
    #[serde(rename = "mm-N-MPa")]
    MillimetreNewtonMegapascal,
    /// None: numbers without units. Nothing is said about how plausible moduli, strains and displacements are.
    #[serde(rename = "none")]
    Dimensionless,
}

impl Units {
    /// Its name in a case.
    pub fn name(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "m-N-Pa",
            Self::MillimetreNewtonMegapascal => "mm-N-MPa",
            Self::Dimensionless => "none",
        }
    }

    /// Unit of length.
    pub fn length(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "m",
            Self::MillimetreNewtonMegapascal => "mm",
            Self::Dimensionless => "",
        }
    }

    /// A millimetre in its unit of length; none of numbers without units.
    pub fn millimetre(self) -> Option<f64> {
        match self {
            Self::MetreNewtonPascal => Some(1e-3),
            Self::MillimetreNewtonMegapascal => Some(1.0),
            Self::Dimensionless => None,
        }
    }

    /// Unit of force.
    pub fn force(self) -> &'static str {
        if self == Self::Dimensionless { "" } else { "N" }
    }

    /// Unit of stress.
    pub fn stress(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "Pa",
            Self::MillimetreNewtonMegapascal => "MPa",
            Self::Dimensionless => "",
        }
    }

    /// Unit of moment and of energy.
    pub fn moment(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "N m",
            Self::MillimetreNewtonMegapascal => "N mm",
            Self::Dimensionless => "",
        }
    }

    /// Unit of curvature.
    pub fn per_length(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "1/m",
            Self::MillimetreNewtonMegapascal => "1/mm",
            Self::Dimensionless => "",
        }
    }

    /// Unit of a force along a line.
    pub fn force_per_length(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "N/m",
            Self::MillimetreNewtonMegapascal => "N/mm",
            Self::Dimensionless => "",
        }
    }

    /// Unit of stress intensity.
    pub fn stress_intensity(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "Pa √m",
            Self::MillimetreNewtonMegapascal => "MPa √mm",
            Self::Dimensionless => "",
        }
    }

    /// A name with a unit behind it, such as `shear force V [N]`.
    pub fn label(self, name: &str, unit: &str) -> String {
        if self == Self::Dimensionless { name.into() } else { format!("{name} [{unit}]") }
    }

    /// A number with a unit behind it, such as `0.0025 m²`.
    pub fn quantity(self, number: &str, unit: &str) -> String {
        if self == Self::Dimensionless { number.into() } else { format!("{number} {unit}") }
    }

    /// Label of a difference of temperatures.
    pub fn temperature(self) -> &'static str {
        if self == Self::Dimensionless { "" } else { "K" }
    }

    /// Unit of mass per volume.
    pub fn density(self) -> &'static str {
        match self {
            Self::MetreNewtonPascal => "kg/m³",
            Self::MillimetreNewtonMegapascal => "t/mm³",
            Self::Dimensionless => "",
        }
    }

    /// Standard acceleration of gravity; none of numbers without units.
    pub fn gravity(self) -> Option<f64> {
        match self {
            Self::MetreNewtonPascal => Some(9.806_65),
            Self::MillimetreNewtonMegapascal => Some(9_806.65),
            Self::Dimensionless => None,
        }
    }

    /// Densities between which solids lie, from foams to heavy metals; none of numbers without units.
    pub fn usual_densities(self) -> Option<RangeInclusive<f64>> {
        match self {
            Self::MetreNewtonPascal => Some(1.0..=3e4),
            Self::MillimetreNewtonMegapascal => Some(1e-12..=3e-8),
            Self::Dimensionless => None,
        }
    }

    /// Young's moduli between which materials lie; none of numbers without units.
    pub fn usual_moduli(self) -> Option<RangeInclusive<f64>> {
        match self {
            Self::MetreNewtonPascal => Some(4e5..=2e12),
            Self::MillimetreNewtonMegapascal => Some(4e-1..=2e6),
            Self::Dimensionless => None,
        }
    }
}

/// A number with six digits, the way engineers write it.
pub fn number(value: f64) -> String {
    match value.abs() {
        // Such as the load at the first break of a body that does not break.
        size if !size.is_finite() => "none".into(),
        0.0 => "0".into(),
        size if (1e-3..1e6).contains(&size) => {
            let digits = (5 - size.log10().floor() as i32).max(0) as usize;
            let text = format!("{value:.digits$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
        }
        _ => {
            let text = format!("{value:.5e}");
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
            format!("{mantissa}e{exponent}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_six_digits() {
        let text = [0.0, 1.0, -0.003_206_24, 123_456.7, 2e11, 5.208_333_333e-7, f64::NAN].map(number);
        assert_eq!(text, ["0", "1", "-0.00320624", "123457", "2e11", "5.20833e-7", "none"]);
    }
}
