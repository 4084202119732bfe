//! Loads of a plate on its points.

use super::materials::PlateMaterial;
use super::plate_loads::{Heat, PlateLoads};
use super::pressure::Loaded;
use super::site::Site;
use super::thickness::Thickness;
use super::{foreign, gravity, heat, initial_curvature, line_load, point_load, pressure};
use crate::case::Load;
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::scene::Resultant;
use crate::scene::prescribed::Prescribed;
use crate::scene::states::{self, Group};
use peristat_assembly::model::plate_bending::PlateBending;

/// A plate as it is made.
pub(super) struct Made<'a> {
    pub(super) plate: &'a PlateBending,
    pub(super) thickness: &'a Thickness,
    pub(super) materials: &'a [PlateMaterial],
}

/// All load cases.
pub(super) fn load_cases(site: &Site, made: &Made, faults: &mut Faults) -> Vec<PlateLoads> {
    let resolve = |group: &Group, faults: &mut Faults| {
        let mut to = PlateLoads {
            force: vec![0.0; 3 * site.nodes.points()],
            asked: Resultant::default(),
            is_approximate: false,
            free: Vec::new(),
            heat: Heat::default(),
        };
        let at = (site, group.factor);
        for &(k, load) in &group.loads {
            let path = group.path.index(k);
            match load {
                Load::Pressure(load) => {
                    pressure::add(load, at, made.plate, &path.key("pressure"), &mut to, faults);
                }
                Load::Line(load) => line_load::add(load, at, made.plate, &path.key("line"), &mut to, faults),
                Load::Point(load) => point_load::add(load, site, &path.key("point"), &mut to, faults),
                Load::Gravity(load) => {
                    gravity::add(
                        load,
                        site,
                        (made.plate, made.thickness),
                        &path.key("gravity"),
                        &mut to,
                        faults,
                    );
                }
                Load::Temperature(load) => {
                    heat::add(load, at, made, &path.key("temperature"), &mut to, faults);
                }
                Load::InitialStrain(load) => {
                    initial_curvature::add(load, at, made, &path.key("initial_strain"), &mut to, faults);
                }
                other => foreign::refuse(other, &path, faults),
            }
        }
        if !to.force.iter().copied().chain(to.heat.forces()).all(f64::is_finite) {
            faults.error(group.path.clone(), "a formula of these loads has no value where it acts");
        }
        to
    };
    states::load_cases(site.case, resolve, faults)
}

/// A doubt where nothing acts.
pub(super) fn check_loaded(site: &Site, cases: &[PlateLoads], moves: bool, faults: &mut Faults) {
    let acts = |loads: &PlateLoads| !loads.free.is_empty() || loads.force.iter().any(|f| *f != 0.0);
    if !cases.iter().any(acts) && !moves && !faults.has_errors() {
        let key = if site.case.load_cases.is_empty() { "loads" } else { "load_cases" };
        faults
            .warning(root(key), "nothing acts on the plate: all results will be zero")
            .hint("give `loads`, or a support with a deflection that is not zero");
    }
}

/// Values at the points; a fault where a formula has none at a corner of the cells that it is for. Elsewhere it may have none: zero.
pub(super) fn values(
    given: &Prescribed,
    (site, cells): (&Site, &Loaded),
    path: &JsonPath,
    faults: &mut Faults,
) -> Vec<f64> {
    let mut is_asked = vec![false; site.nodes.points()];
    let asked = site.nodes.all_cells().filter(|&cell| cells.has(site, cell));
    let corners = asked.filter_map(|cell| site.nodes.corners(cell)).flatten();
    corners.for_each(|point| is_asked[point] = true);
    let mut values = vec![0.0; site.nodes.points()];
    for (point, value) in values.iter_mut().enumerate() {
        let [x, y] = site.nodes.place(point);
        match given.at([x, y, 0.0]) {
            Ok(found) => *value = found,
            Err(reason) if is_asked[point] => {
                faults.error(path.clone(), reason);
                break;
            }
            Err(_) => {}
        }
    }
    if let (Prescribed::Formula(_), false) = (given, faults.has_errors()) {
        doubt_coarse(given, &values, (site, cells), path, faults);
    }
    values
}

/// A doubt about values at the points that miss what a formula has between them.
fn doubt_coarse(
    given: &Prescribed,
    values: &[f64],
    (site, cells): (&Site, &Loaded),
    path: &JsonPath,
    faults: &mut Faults,
) {
    let (mut off, mut size) = (0.0, 0.0);
    for cell in site.nodes.all_cells().filter(|&cell| cells.has(site, cell)) {
        let inside: f64 = pressure::places(site, cell).map(|at| given.at(at).unwrap_or(0.0)).sum();
        let corners = site.nodes.corners(cell).into_iter().flatten();
        off += (inside - corners.map(|point| values[point]).sum::<f64>()).abs();
        size += pressure::places(site, cell).map(|at| given.at(at).unwrap_or(0.0).abs()).sum::<f64>();
    }
    if off > pressure::COARSE * size {
        let message = format!(
            "the formula is taken at the points, and differs between them by {} of its values",
            tidy(off / size)
        );
        faults
            .warning(path.clone(), message)
            .hint("use a smaller spacing, or regions that end between cells");
    }
}
