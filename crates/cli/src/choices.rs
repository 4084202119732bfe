//! What options and arguments may be.

use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser};
use peristat::model;
use peristat::results::FieldStates;

/// When to colour messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    /// On a terminal.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// States whose fields are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum States {
    /// Every load case, step or recorded state.
    All,
    /// The last one.
    Last,
    /// None.
    None,
}

impl From<States> for FieldStates {
    fn from(states: States) -> Self {
        match states {
            States::All => Self::All,
            States::Last => Self::Last,
            States::None => Self::Nothing,
        }
    }
}

/// Kinds of files of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Files {
    /// Tables and grids.
    Both,
    /// Grids, for ParaView.
    Vtu,
    /// Tables.
    Csv,
}

/// What can be listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Models with their bond laws and end treatments, calibrations and edge treatments.
    Models,
    /// Bodies: what a model can be the material of.
    Bodies,
    /// Sections of beams.
    Sections,
    /// Rolled steel sections by name.
    Profiles,
    /// Loads and supports.
    Loads,
    /// Fields that probes read.
    Fields,
    /// Keys of a probe.
    Probes,
    /// What results can be compared with.
    Checks,
    /// How bodies break: strategies and critical strains.
    Fracture,
    /// Bond laws that soften, and controls of paths.
    Path,
    /// Closed forms of beams for checks.
    References,
    /// Solvers.
    Solvers,
}

/// The cases to begin with.
pub(super) fn starts() -> PossibleValuesParser {
    let values = model::starts().map(|start| PossibleValue::new(start.name).help(start.about));
    values.collect::<Vec<_>>().into()
}

/// A replaced value of a case.
pub(super) fn assignment(text: &str) -> Result<String, String> {
    match text.contains('=') {
        true => Ok(text.into()),
        false => Err(format!("no `=` in it: write `--set {text}=VALUE`")),
    }
}

/// A size in bytes, with an optional unit.
pub(super) fn size(text: &str) -> Result<u64, String> {
    let text = text.trim();
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let number: f64 =
        text[..end].parse().map_err(|_| "a size is a number with a unit, such as 500MB".to_string())?;
    let factor = match text[end..].trim().to_ascii_lowercase().as_str() {
        "" | "b" => 1.0,
        "k" | "kb" => 1e3,
        "m" | "mb" => 1e6,
        "g" | "gb" => 1e9,
        "kib" => 1024.0,
        "mib" => 1024.0 * 1024.0,
        "gib" => 1024.0 * 1024.0 * 1024.0,
        other => {
            return Err(format!("`{other}` is no unit of memory: use B, kB, MB, GB, kiB, MiB or GiB"));
        }
    };
    Ok((number * factor) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_decimal_and_binary_units() {
        assert_eq!(size("1.5 GB"), Ok(1_500_000_000));
        assert_eq!(size("2kiB"), Ok(2048));
        assert_eq!(size("300"), Ok(300));
        assert!(size("3 apples").unwrap_err().contains("apples"));
        assert!(size("GB").is_err());
    }

    #[test]
    fn a_replaced_value_has_an_equals_sign() {
        assert_eq!(assignment("a.b=2"), Ok("a.b=2".into()));
        assert!(assignment("a.b").unwrap_err().contains("`--set a.b=VALUE`"));
    }
}
