//! Whether conditions, loads and values of all points fit into memory, before they are collected: a few letters of a case name
//! a region, as often as they like, and every time all of its points are meant.

use super::ground::Ground;
use crate::case::{Check, Load, Support};
use crate::diagnostic::{Faults, root};
use crate::memory;
use std::collections::HashMap;

// Bytes, measured on squares of 3600 and 10000 points with 100 to 1000 of each.
/// Of a prescribed motion of a point with its equation.
const MOTION: f64 = 380.0;
/// Of a spring on a point.
const SPRING: f64 = 150.0;
/// Of a force on a point.
const FORCE: f64 = size_of::<(u32, [f64; 3])>() as f64;
/// Of a point of a probe.
const SHARE: f64 = size_of::<(u32, f64)>() as f64;
/// Of a value that is expected at a point.
const VALUE: f64 = size_of::<f64>() as f64;

/// Whether all that the case says of points fits into memory; a fault if not.
pub(crate) fn fit(ground: &Ground, max_memory: Option<u64>, faults: &mut Faults) -> bool {
    let case = ground.case;
    let mut known: HashMap<&str, f64> = HashMap::new();
    let mut points = |name: &str| -> f64 {
        match ground.own_name(name) {
            Some(own) => *known.entry(own).or_insert_with(|| ground.count(own) as f64),
            None => 0.0,
        }
    };
    let mut at = |region: Option<&str>| region.map_or(1.0, &mut points);
    let supports: f64 = case.supports.iter().map(|s| at(s.at.region.as_deref()) * of_support(s)).sum();
    let mut of_load = |load: &Load| match load {
        Load::Point(load) => at(load.at.region.as_deref()),
        Load::BodyForce(load) => load.region.as_ref().map_or(0.0, |_| at(load.region.as_deref())),
        Load::Gravity(load) => load.region.as_ref().map_or(0.0, |_| at(load.region.as_deref())),
        // Every point has a force of its own.
        Load::Spin(load) => {
            load.region.as_ref().map_or(ground.body.points() as f64, |_| at(load.region.as_deref()))
        }
        Load::Traction(load) => at(load.border().map(|(_, name)| name)),
        // What the points of the model have is counted with the model.
        Load::Distributed(_)
        | Load::Line(_)
        | Load::Pressure(_)
        | Load::Temperature(_)
        | Load::InitialStrain(_) => 0.0,
    };
    let loads: f64 = case.loads.iter().map(&mut of_load).sum();
    let cases: f64 = case.load_cases.iter().flat_map(|c| &c.loads).map(&mut of_load).sum();
    // Loads that know the load factor are those of every step.
    let by_step = case.loads.iter().filter(|load| load.knows_load_factor()).count();
    let steps = case.steps.as_ref().map_or(0, |steps| steps.load_factors.len());
    let stepped = (by_step * steps * ground.body.points()) as f64;
    let probes: f64 = case.probes.iter().map(|p| at(p.at.region.as_deref())).sum();
    let compared = case.checks.iter().filter(|c| matches!(c, Check::Baseline(_) | Check::Formula(_)));
    let values = (compared.count() * ground.body.points()) as f64;
    let all = [
        ("supports", supports, "points that supports hold"),
        ("loads", FORCE * loads, "points that loads act on"),
        ("load_cases", FORCE * cases, "points that loads act on"),
        ("steps", FORCE * stepped, "points that loads act on in every step"),
        ("probes", SHARE * probes, "points of probes"),
        ("checks", VALUE * values, "values at all points"),
    ];
    all.iter().all(|&(key, bytes, what)| {
        let hint = "use fewer of them, or smaller regions";
        memory::fits(bytes, (what, hint), max_memory, root(key), faults)
    })
}

/// Memory of what a support does to a point, bytes.
fn of_support(support: &Support) -> f64 {
    let motions =
        [&support.ux, &support.uy, &support.uz, &support.phi, &support.w].into_iter().flatten().count()
            + usize::from(support.inclined.is_some());
    let springs = [support.ux_spring, support.uy_spring, support.uz_spring].iter().flatten().count();
    MOTION * motions as f64 + SPRING * springs as f64
}
