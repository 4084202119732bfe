//! Forces and moments at places of a body.

use super::context::{LoadContext, is_held};
use super::rigid_moment;
use super::sums::BodyLoads;
use crate::case::PointLoad;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::site::ground::NamedPoints;
use crate::scene::body::site::interpolate::{Interpolation, Weights};
use crate::scene::body::site::resultants;
use crate::scene::words;
use peristat_assembly::body::Crack;

/// A force, or a moment, at a place.
pub(crate) fn resolve(
    load: &PointLoad,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let (points_turn, deflects) = (context.material.has("phi"), context.material.has("w"));
    let is_flat = context.material.has("ux");
    let is_solid = context.material.has("uz");
    let foreign = [
        (
            "force",
            load.force != 0.0 && !deflects,
            if is_solid { "use `force_x`, `force_y` and `force_z`" } else { "use `force_x` and `force_y`" },
        ),
        ("force_x", load.force_x != 0.0 && !is_flat, "points move across the plane: use `force`"),
        ("force_y", load.force_y != 0.0 && !is_flat, "points move across the plane: use `force`"),
        ("axial", load.axial != 0.0, "use `force_x` and `force_y`"),
        (
            "moment",
            load.moment != 0.0 && !points_turn,
            match is_solid {
                true => "list a region under `rigid`, and give `moment_x`, `moment_y` or `moment_z` on it",
                false => "points do not turn: use two forces, or a `linear` traction on an edge",
            },
        ),
        ("spread", load.spread, "give a region as the place to spread a force"),
    ];
    for (key, _, hint) in foreign.iter().filter(|f| f.1) {
        faults.error(path.key(*key), format!("`{key}` is for beams")).hint(*hint);
    }
    let force = [load.force_x, load.force_y, if is_solid { load.force_z } else { load.force }];
    let couple = [load.moment_x, load.moment_y, load.moment_z];
    let is_of_solids = load.force_z != 0.0 || couple != [0.0; 3];
    if force == [0.0; 3] && load.moment == 0.0 && !is_of_solids && !foreign.iter().any(|f| f.1) {
        let keys = match (points_turn, deflects) {
            (true, _) => "give `force_x`, `force_y` or `moment`",
            (_, true) if is_flat => "give `force_x`, `force_y` or `force`",
            (_, true) => "give `force`",
            _ if is_solid => {
                "give `force_x`, `force_y` or `force_z`; on a rigid region `moment_x`, `moment_y` or `moment_z`"
            }
            _ => "give `force_x` or `force_y`",
        };
        faults.error(path.clone(), "this load is zero").hint(keys);
    }
    let at = path.key("at");
    if load.at.inward.is_some() {
        faults.error(at.key("inward"), "`inward` is for probes").hint(context.ground.place_hint());
    }
    for edge in load.at.region.iter().flat_map(|names| context.ground.edges_of(names)) {
        crate::scene::body::hold::supports::not_mirrored(
            Some(&edge),
            &at.key("region"),
            context.symmetry,
            faults,
        );
    }
    let Some(spot) = context.ground.spot(&load.at, &at, "the load", faults) else { return };
    let acts = force != [0.0; 3];
    let is_fixed = |c: usize| force[c] == 0.0 || spot.points.iter().all(|p| is_held(*p, c, context.held));
    let is_fixed = acts && (0..3).all(is_fixed);
    let shares = shares(load, &spot, is_fixed, context);
    let at_place = place(load, &shares, context, &at, faults);
    resultants::add_force(context.material, &mut to.asked, force, at_place);
    if points_turn {
        to.asked.add_moment(2, load.moment);
    }
    if is_fixed {
        faults
            .warning(at, format!("supports hold {} against this force: it deforms nothing", spot.words))
            .hint("it only adds to the reaction of the support");
    }
    if acts {
        to.forces.extend(shares.iter().map(|&(p, share)| (p, force.map(|f| share * f))));
    }
    if is_solid && couple != [0.0; 3] {
        rigid_moment::add(couple, load, &spot.points, context, path, to, faults);
    }
    if load.moment != 0.0 {
        to.moments.extend(shares.iter().map(|&(p, share)| (p, share * load.moment)));
    }
}

/// Where a force acts: at the position that is given, or in the middle of a region. A doubt where no points around the position
/// can share it.
fn place(
    load: &PointLoad,
    shares: &Weights,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> [f64; 3] {
    let body = context.ground.body;
    let middle =
        [0, 1, 2].map(|k| shares.iter().map(|&(p, s)| s * body.position(p as usize)[k]).sum::<f64>());
    let (Some(x), Some(y)) = (load.at.x, load.at.y) else { return middle };
    let at = [x, y, load.at.z.unwrap_or(0.0)];
    let moved = (0..3).map(|k| (at[k] - middle[k]).powi(2)).sum::<f64>().sqrt();
    if moved < 1e-9 * body.spacing() {
        return at;
    }
    if moved > 1e-3 * body.spacing() {
        let middle = words::place(middle, body);
        faults
            .warning(path.clone(), format!("the load acts on the point at {middle}"))
            .hint("give the position of that point, or a region");
    }
    middle
}

/// Points and their shares of a force at a place: those of a region alike; at a position those with which values are
/// interpolated there, so that the force has its moment. A point that is held takes it alone.
fn shares(load: &PointLoad, spot: &NamedPoints, is_fixed: bool, context: &LoadContext) -> Weights {
    match (load.at.x, load.at.y, &spot.points[..]) {
        (Some(x), Some(y), &[nearest]) if !is_fixed => {
            let cracks: Vec<Crack> = context.cracks.iter().map(|c| c.crack.clone()).collect();
            let interpolation = Interpolation { body: context.ground.body, cracks: &cracks, reach: 1 };
            interpolation.at([x, y, load.at.z.unwrap_or(0.0)], nearest)
        }
        (.., points) => points.iter().map(|&p| (p, 1.0 / points.len() as f64)).collect(),
    }
}
