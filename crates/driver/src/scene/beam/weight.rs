//! The weight of a beam.

use super::place::Layout;
use super::point_load::shares;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use crate::case::{Case, Gravity};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::mass;
use peristat_assembly::model::timoshenko_beam::{Along, Distributed, Intensity};

/// Adds the weight of all lines or members.
pub(super) fn add(
    load: &Gravity,
    (case, layout): (&Case, &Layout),
    sections: Option<&[Resolved]>,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if load.region.is_some() {
        faults
            .error(path.key("region"), "`region` is for bodies in the plane")
            .hint("all of a beam is heavy");
    }
    let (along, count) = load.along.parts();
    if count != 2 {
        let s = if count == 1 { "" } else { "s" };
        faults
            .error(
                path.key("along"),
                format!("`along` has {count} number{s}, and directions of beams have 2, x and y"),
            )
            .hint("[0, -1] is downwards, against w of a line");
        return;
    }
    let Some([x, y, _]) = mass::weight(case, load, along, path, faults) else { return };
    for (chain, section) in sections.unwrap_or_default().iter().enumerate() {
        let Some(area) = &section.section.area else {
            faults
                .error(path.clone(), "the area of the section is not known, and with it the weight")
                .hint("give its `area` with the stiffness, or the weight per length as a `distributed` load");
            return;
        };
        let line = &layout.lines[chain];
        let [across, axial] = shares(layout.direction(chain), [x, y]);
        for (share, along) in [(across, Along::Transverse), (axial, Along::Axial)] {
            if share == 0.0 {
                continue;
            }
            // The sides of a tapered section are straight, so that its area is of degree two.
            let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| share * area.value(part * line.length));
            let intensity = match area.uniform() {
                Some(_) => Intensity::Linear { start, end },
                None => Intensity::Parabola { start, middle, end },
            };
            to.loads.distributed.push(Distributed {
                chain,
                from: line.from,
                to: line.to(),
                intensity,
                along,
            });
        }
    }
}
