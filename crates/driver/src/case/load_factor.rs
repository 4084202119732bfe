//! Formulas of the load factor: what has one is not proportional to it.

use super::{Amount, Amounts, Distributed, DistributedForce, Load};

/// What formulas call the load factor of a step.
pub(crate) const LOAD_FACTOR: &str = "load_factor";

/// Whether a formula knows the load factor.
fn knows_load_factor(formula: &str) -> bool {
    formula.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == LOAD_FACTOR)
}

impl Amount {
    /// Whether it is a formula of the load factor: then it is not proportional to that.
    pub(crate) fn knows_load_factor(&self) -> bool {
        matches!(self, Self::Formula(formula) if knows_load_factor(formula))
    }
}

impl Load {
    /// Whether a formula of it knows the load factor: then it is not proportional to that.
    pub(crate) fn knows_load_factor(&self) -> bool {
        let any = |amounts: &[&Option<Amount>]| {
            amounts.iter().any(|amount| amount.as_ref().is_some_and(Amount::knows_load_factor))
        };
        let all = |amounts: &Option<Amounts>| {
            amounts.as_ref().is_some_and(|amounts| amounts.0.iter().any(Amount::knows_load_factor))
        };
        match self {
            Self::Traction(load) => any(&[&load.pressure]) || all(&load.formula),
            Self::BodyForce(load) => all(&load.density),
            Self::Temperature(load) => any(&[&load.change, &load.difference]),
            Self::Line(load) => any(&[&load.force, &load.moment_n, &load.moment_t]),
            Self::Pressure(load) => load.formula.as_deref().is_some_and(knows_load_factor),
            Self::Distributed(load) => load.forces().any(
                |(_, force)| matches!(force, Some(DistributedForce::Formula(text)) if knows_load_factor(text)),
            ),
            Self::InitialStrain(load) => any(&load.components().map(|(_, amount)| amount)),
            Self::Point(_) | Self::Gravity(_) | Self::Spin(_) => false,
        }
    }
}

impl Distributed {
    /// Its values by keys.
    pub(crate) fn forces(&self) -> impl Iterator<Item = (&'static str, &Option<DistributedForce>)> {
        [
            ("force", &self.force),
            ("axial", &self.axial),
            ("force_x", &self.force_x),
            ("force_y", &self.force_y),
            ("moment", &self.moment),
        ]
        .into_iter()
    }
}
