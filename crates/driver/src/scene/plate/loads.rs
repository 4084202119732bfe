//! Loads of a plate on its points.

use super::plate_loads::PlateLoads;
use super::site::Site;
use super::thickness::Thickness;
use super::{foreign, gravity, line_load, point_load, pressure};
use crate::case::Load;
use crate::diagnostic::{Faults, root};
use crate::scene::Resultant;
use crate::scene::states::{self, Group};
use peristat_assembly::model::plate_bending::PlateBending;

/// All load cases.
pub(super) fn load_cases(
    site: &Site,
    (plate, thickness): (&PlateBending, &Thickness),
    faults: &mut Faults,
) -> Vec<PlateLoads> {
    let resolve = |group: &Group, faults: &mut Faults| {
        let mut to = PlateLoads {
            force: vec![0.0; 3 * site.nodes.points()],
            asked: Resultant::default(),
            is_approximate: false,
        };
        let at = (site, group.factor);
        for &(k, load) in &group.loads {
            let path = group.path.index(k);
            match load {
                Load::Pressure(load) => {
                    pressure::add(load, at, plate, &path.key("pressure"), &mut to, faults);
                }
                Load::Line(load) => line_load::add(load, at, plate, &path.key("line"), &mut to, faults),
                Load::Point(load) => point_load::add(load, site, &path.key("point"), &mut to, faults),
                Load::Gravity(load) => {
                    gravity::add(load, site, (plate, thickness), &path.key("gravity"), &mut to, faults);
                }
                other => foreign::refuse(other, &path, faults),
            }
        }
        if !to.force.iter().all(|f| f.is_finite()) {
            faults.error(group.path.clone(), "a formula of these loads has no value where it acts");
        }
        to
    };
    states::load_cases(site.case, resolve, faults)
}

/// A doubt where nothing acts.
pub(super) fn check_loaded(site: &Site, cases: &[PlateLoads], moves: bool, faults: &mut Faults) {
    let acts = |loads: &PlateLoads| loads.force.iter().any(|f| *f != 0.0);
    if !cases.iter().any(acts) && !moves && !faults.has_errors() {
        let key = if site.case.load_cases.is_empty() { "loads" } else { "load_cases" };
        faults
            .warning(root(key), "nothing acts on the plate: all results will be zero")
            .hint("give `loads`, or a support with a deflection that is not zero");
    }
}
