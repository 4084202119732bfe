//! Shell membranes: parameters, what bodies and keys they can have, pressures, and loads that no membrane bears.

use super::keys::PlaneKeys;
use super::loads::{Context, PlaneLoads};
use super::stress_field::StressField;
use super::{PlaneBonds, PlaneScene, body, model, root};
use crate::case::{Axis, Body, Case, LoadSharing, Model, Pressure, Shell};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use peristat_assembly::body::{PlaneBody, SquareLattice};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::shell_membrane::{
    EndConditions, Inextensional, ShellError, ShellMembrane, ShellParameters,
};
use std::collections::BTreeMap;

/// How far a Poisson ratio may be off: 0.333 is a third.
const POISSON_SLACK: f64 = 1e-3;

impl PlaneKeys for Shell {
    fn model(&self) -> Model {
        Model::ShellMembrane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn bonds(&mut self, case: &Case, _: bool, faults: &mut Faults) -> Option<PlaneBonds> {
        parameters(self, case, faults).map(PlaneBonds::Shell)
    }
}

/// The parameters of the case; the horizon ratio is to be set.
fn parameters(given: &Shell, case: &Case, faults: &mut Faults) -> Option<ShellParameters> {
    let path = root("model").key("shell_membrane");
    let mut fine = positive(given.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(given.thickness, "thickness", path.key("thickness"), faults);
    fine &= positive(given.radius, "radius", path.key("radius"), faults);
    if let Some(nu) = given.poisson_ratio.filter(|nu| (nu - 1.0 / 3.0).abs() > POISSON_SLACK) {
        faults
            .error(
                path.key("poisson_ratio"),
                format!("a shell membrane of central bonds has the Poisson ratio 1/3, found {}", tidy(nu)),
            )
            .hint("leave `poisson_ratio` out; another one needs a model with more than central bonds");
        fine = false;
    }
    refuse_keys(case, faults);
    check_body(given, case, &path, faults);
    fine.then_some(ShellParameters {
        youngs_modulus: given.youngs_modulus,
        thickness: given.thickness,
        radius: given.radius,
        horizon_ratio: 0.0,
        kinematics: given.kinematics,
        calibration: given.calibration,
        bending: given.bending,
    })
}

/// Faults of keys that have no meaning for shells.
fn refuse_keys(case: &Case, faults: &mut Faults) {
    let keys = [
        ("cracks", !case.cracks.is_empty(), "cracks need the model `bond_plane` or `beam_bond_orthotropic`"),
        ("fracture", case.fracture.is_some(), "the bonds of a shell membrane do not break"),
        ("path", case.path.is_some(), "the bonds of a shell membrane do not soften"),
        ("rigid", !case.rigid.is_empty(), "a region that is held is a support with `ux`, `uy` and `w`"),
    ];
    for (key, _, hint) in keys.iter().filter(|k| k.1) {
        faults.error(root(key), format!("`{key}` is for plates, not for shell membranes")).hint(*hint);
    }
}

/// Faults of a body that is no developed cylinder.
fn check_body(given: &Shell, case: &Case, path: &JsonPath, faults: &mut Faults) {
    let Body::Rectangle(rectangle) = &case.body else {
        faults
            .error(body::path(case), "a shell membrane needs a `rectangle`: its developed cylinder")
            .hint("its size is the length along the axis and the arc along the circumference");
        return;
    };
    if !rectangle.holes.is_empty() {
        faults.error(body::path(case).key("holes"), "a shell membrane has no holes");
    }
    let (arc, whole) = (rectangle.size[1], std::f64::consts::TAU * given.radius);
    // What is no number has a fault of its own.
    if !(arc > 0.0 && whole > 0.0 && rectangle.spacing > 0.0) {
        return;
    }
    let is_joined = case.periodic.iter().any(|p| p.along == Axis::Y);
    if let Some(k) = case.periodic.iter().position(|p| p.along == Axis::Y && p.stretches) {
        faults
            .error(
                root("periodic").index(k).key("stretches"),
                "a tube does not stretch along its circumference",
            )
            .hint("it grows wider by `w`: leave `stretches` out");
    }
    let [found, needed] = [arc, whole].map(tidy);
    if !is_joined && arc > whole * (1.0 + 1e-3) {
        faults
            .error(
                body::path(case).key("size").index(1),
                format!("the arc {found} is longer than the circumference {needed} of this radius"),
            )
            .hint("the second size is the arc along the circumference");
    }
    // A single row is its own image: nothing varies along the circumference.
    let is_row = arc < 1.5 * rectangle.spacing;
    if is_joined && !is_row && ShellMembrane::parts_of_circumference(given.radius, arc).is_none() {
        faults
            .error(
                path.key("radius"),
                format!(
                    "a tube of radius {} has the circumference {needed}, and the joined arc is {found}",
                    tidy(given.radius)
                ),
            )
            .hint(format!(
                "give the radius {}, or an arc that is a whole part of the circumference, or a single row",
                tidy(arc / std::f64::consts::TAU)
            ));
    }
}

/// A fault for a shell that cannot be made.
pub(super) fn refuse(error: &ShellError, faults: &mut Faults) {
    let path = match error {
        ShellError::ShortHorizon { .. } => root("horizon_ratio"),
        ShellError::NotRepresentable { .. } | ShellError::Around { .. } | ShellError::OutOfRange { .. } => {
            root("model").key("shell_membrane").key("radius")
        }
    };
    model::tell(&error.to_string(), path, faults);
}

/// Adds a pressure.
pub(super) fn pressure(
    load: &Pressure,
    context: &Context,
    path: &JsonPath,
    to: &mut PlaneLoads,
    faults: &mut Faults,
) {
    let (PlaneBonds::Shell(shell), PlaneBody::Lattice(lattice)) = (context.bonds, context.ground.body) else {
        faults
            .error(path.clone(), "a `pressure` on the body is for the model `shell_membrane`")
            .hint("in the plane a pressure acts on an edge or a hole: { \"traction\": { \"edge\": …, \"pressure\": … } }");
        return;
    };
    if load.value == 0.0 {
        faults.error(path.key("value"), "this load is zero");
    }
    let mirrors = context.symmetry.mirrors;
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
    let joined = ShellMembrane::closing_rows(&mirrors);
    let radius = ShellMembrane::closed_radius(shell.radius, lattice.spacing(), joined);
    let wave_number = f64::from(load.harmonic) / radius;
    match load.sharing.unwrap_or(usual) {
        LoadSharing::Consistent => {
            let hoop = load.value * radius / shell.thickness;
            to.stresses.push(StressField::hoop(hoop, wave_number));
            // What a stress that varies does along the circumference is taken back: its divergence.
            let force = |p: u32| {
                let s = context.ground.body.position(p as usize)[1];
                let divergence = -hoop * wave_number * (wave_number * s).sin();
                (p, [0.0, context.volume(p) * divergence])
            };
            if load.harmonic > 0 {
                to.forces.extend((0..context.ground.body.points() as u32).map(force));
            }
        }
        LoadSharing::Lumped => {
            let force = |p: u32| {
                let area = context.ground.body.area(p as usize);
                let s = context.ground.body.position(p as usize)[1];
                (p, load.value * area * (wave_number * s).cos())
            };
            to.across.extend((0..context.ground.body.points() as u32).map(force));
        }
    }
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

/// Adds a fault for every load case that a membrane cannot bear.
pub(super) fn check_bearable(scene: &PlaneScene, faults: &mut Faults) {
    let (PlaneBonds::Shell(parameters), Some((lattice, mirrors))) = (scene.bonds(), scene.model.lattice())
    else {
        return;
    };
    let left = Inextensional::new(parameters, (lattice, mirrors), ends(scene, lattice));
    for (k, loads) in scene.load_cases.iter().enumerate() {
        let mut force = vec![0.0; 3 * lattice.points()];
        loads.add_to(&*scene.model, 1.0, &mut force);
        if left.is_worked_on(&force) {
            let path = match scene.case.load_cases.is_empty() {
                true => root("loads"),
                false => root("load_cases").index(k),
            };
            faults
                .error(
                    path,
                    "a membrane whose ends are free cannot bear this load: it moves without any strain, and what a \
                     lattice answers depends on the spacing alone",
                )
                .hint(
                    "hold `uy` and `w` on both ends (diaphragms) or `ux`, `uy` and `w` on one, or take \"bending\": true",
                );
        }
    }
}

/// What supports hold on whole circumferences.
fn ends(scene: &PlaneScene, lattice: &SquareLattice) -> EndConditions {
    let PlaneBody::Lattice(real) = scene.body() else { return EndConditions::default() };
    let rows = real.rows().len();
    // Points that are held along u, and along v or w, per column.
    let mut counts: BTreeMap<i32, [usize; 3]> = BTreeMap::new();
    for hold in &scene.conditions.holds {
        for &point in &hold.points {
            let counts = counts.entry(lattice.cell(point as usize)[0]).or_default();
            (0..3).for_each(|c| counts[c] += usize::from(hold.direction[c].abs() == 1.0));
        }
    }
    let mut ends = EndConditions::default();
    for (column, counts) in counts {
        let x = lattice.place_of([column, real.rows().start, 0])[0];
        if counts[0] >= rows {
            ends.hold_axial();
        }
        if counts[1] >= rows || counts[2] >= rows {
            ends.hold_shape(x);
        }
    }
    ends
}

/// Adds a doubt about ends whose axial motion is prescribed: their outermost points are held, half a spacing inside, which is not
/// how one stress reaches the points. Measured 3.4 to 10 % of the force between two such ends of 20 columns.
pub(super) fn warn_of_held_ends(scene: &PlaneScene, faults: &mut Faults) {
    let held = scene.case.supports.iter().enumerate().find(|(_, support)| {
        let end = support.at.region.as_deref().is_some_and(|name| ["left", "right"].contains(&name));
        end && support.ux.is_some()
    });
    let Some((k, _)) = held else { return };
    faults
        .warning(
            root("supports").index(k).key("ux"),
            "ends of shells are held at their outermost points: forces between held ends are up to 10 % too large on 20 columns, stresses beside them up to a third",
        )
        .hint("load the end by a traction, use `symmetry`, or read stresses a horizon and more away from it");
}

/// Adds the doubts about a shell that can be solved.
pub(super) fn warn(parameters: &ShellParameters, uncorrected: usize, faults: &mut Faults) {
    if uncorrected > 0 {
        let s = if uncorrected == 1 { "" } else { "s" };
        faults
            .warning(
                root("body"),
                format!(
                    "{uncorrected} point{s} at corners: no bonds without negative stiffness are exact there"
                ),
            )
            .hint("corners of panels are a few percent off; closed tubes have none");
    }
    if parameters.calibration == Calibration::Published {
        faults
            .warning(
                root("model").key("shell_membrane").key("calibration"),
                "the published constant is wrong on a lattice and near ends: 5 to 10 % at the usual horizon, however small the spacing",
            )
            .hint("take the calibration `matched`, which is exact for every uniform strain");
    }
}
