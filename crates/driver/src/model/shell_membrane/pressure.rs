//! Pressures on whole shells.

use super::super::LoadSharing;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::{Calibration, Mirrors};
use peristat_assembly::model::shell_membrane::{ShellMembrane, ShellParameters};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A pressure on a whole shell, or on a plate in bending.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pressure {
    /// Force per area, outwards, of a plate in bending along w; with `harmonic` its largest value.
    #[serde(default, skip_serializing_if = "is_nothing")]
    pub value: f64,
    /// The same on a plate in bending by a formula of the position, such as `"9810*(2 - y)"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formula: Option<String>,
    /// Name of the region of a plate in bending that it acts on, with all of the cells whose middles are in it; the whole plate if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Waves around the circumference: the pressure is `value` cos(n y/R); 0, the same all around, if not given.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub harmonic: u32,
    /// How it reaches the points: `consistent` with the calibration `matched` on tubes and between mirrors, else `lumped`, if
    /// not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sharing: Option<LoadSharing>,
}

/// A pressure on a cylinder, `value` cos(k s) at the arc s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoopPressure {
    /// Its largest value, Pa.
    pub value: f64,
    /// Wave number k, 1/m.
    pub wave_number: f64,
    /// Largest hoop stress of that value, Pa, where it acts by the stress that goes with it.
    pub hoop_stress: Option<f64>,
}

/// A pressure on a shell.
pub(super) fn resolve(
    load: &Pressure,
    shell: &ShellParameters,
    (lattice, mirrors): (&SquareLattice, &Mirrors),
    path: &JsonPath,
    faults: &mut Faults,
) -> HoopPressure {
    if load.value == 0.0 {
        faults.error(path.key("value"), "this load is zero");
    }
    // The hoop stress that goes with a pressure pulls at sides that are free.
    let goes_on = mirrors.joined[1] || mirrors.lines[1].iter().all(Option::is_some);
    let usual = match shell.calibration {
        Calibration::Matched if goes_on => LoadSharing::Consistent,
        _ => LoadSharing::Lumped,
    };
    if load.sharing == Some(LoadSharing::Consistent) && !goes_on {
        faults
            .error(path.key("sharing"), "a `consistent` pressure needs a tube, or sides that are mirrors")
            .hint("leave `sharing` out: on open panels it is `lumped`");
    }
    if mirrors.joined[1] {
        check_harmonic(load, shell, lattice, path, faults);
    }
    let around = std::f64::consts::TAU * shell.radius / lattice.spacing();
    if 4.0 * f64::from(load.harmonic) > around {
        faults
            .error(
                path.key("harmonic"),
                format!(
                    "{} waves need four points each, and there are {} around",
                    load.harmonic,
                    around.round()
                ),
            )
            .hint("use a smaller spacing");
    }
    let joined = ShellMembrane::closing_rows(mirrors);
    let radius = ShellMembrane::closed_radius(shell.radius, lattice.spacing(), joined);
    let wave_number = f64::from(load.harmonic) / radius;
    let is_consistent = load.sharing.unwrap_or(usual) == LoadSharing::Consistent;
    let hoop_stress = is_consistent.then_some(load.value * radius / shell.thickness);
    HoopPressure { value: load.value, wave_number, hoop_stress }
}

/// A fault for a wave that does not fit into a joined body.
fn check_harmonic(
    load: &Pressure,
    shell: &ShellParameters,
    lattice: &SquareLattice,
    path: &JsonPath,
    faults: &mut Faults,
) {
    let rows = lattice.rows().len();
    let parts = ShellMembrane::parts_of_circumference(shell.radius, rows as f64 * lattice.spacing());
    let fits = parts.is_some_and(|parts| load.harmonic.is_multiple_of(parts.round() as u32));
    if load.harmonic == 0 || (rows > 1 && fits) {
        return;
    }
    let message = match rows {
        1 => "a single row is the same all around, and this pressure is not".to_string(),
        _ => format!("{} waves do not fit into the part of the circumference that is joined", load.harmonic),
    };
    faults.error(path.key("harmonic"), message).hint("model the whole tube");
}

fn is_nothing(value: &f64) -> bool {
    *value == 0.0
}

fn is_zero(number: &u32) -> bool {
    *number == 0
}
