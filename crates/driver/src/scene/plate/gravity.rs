//! Weight of plates: a pressure of density times thickness.

use super::plate_loads::PlateLoads;
use super::pressure;
use super::site::Site;
use super::thickness::Thickness;
use crate::case::{Gravity, RegionMaterial};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::mass;
use peristat_assembly::model::plate_bending::PlateBending;

/// Adds the weight of a plate, or of a region of it.
pub(super) fn add(
    load: &Gravity,
    site: &Site,
    (plate, thickness): (&PlateBending, &Thickness),
    path: &JsonPath,
    to: &mut PlateLoads,
    faults: &mut Faults,
) {
    let (along, count) = load.along.parts();
    if count != 3 || along[..2] != [0.0; 2] {
        faults
            .error(path.key("along"), "weight along the plane of a plate in bending stretches it, and does not bend it")
            .hint(
                "give [0, 0, -1], across the plane against w; on a slope give as `acceleration` the part of it across the plane",
            );
        return;
    }
    let is_other = |given: &RegionMaterial| given.youngs_modulus.is_some() || given.poisson_ratio.is_some();
    if let Some((name, _)) = site.case.materials.iter().find(|(_, given)| is_other(given)) {
        faults
            .error(path.clone(), format!("the `density` is that of `model`, and `{name}` is of another material"))
            .hint("give its weight as a `pressure` on its region, and that of the rest by `gravity` on another one");
        return;
    }
    let Some([_, _, weight]) = mass::weight(site.case, load, along, path, faults) else { return };
    let Some(inside) = pressure::inside(load.region.as_ref(), site, path, faults) else { return };
    let (nodes, sections) = (site.nodes, plate.sections());
    for (number, t) in thickness.of_sections.iter().enumerate() {
        let of_section =
            |cell: [i32; 2]| inside.has(site, cell) && sections.number(nodes, cell) == Some(number);
        plate.add_pressure(of_section, |_| weight * t, &mut to.force);
        let area = nodes.spacing() * nodes.spacing();
        for cell in nodes.all_cells().filter(|&cell| of_section(cell)) {
            let middle = nodes.cells().place_of([cell[0], cell[1], 0]);
            to.asked.add([0.0, 0.0, weight * t * area], [middle[0], middle[1], 0.0]);
        }
    }
}
