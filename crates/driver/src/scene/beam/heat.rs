//! Changes of temperature of lines and members.
//!
//! A section that is warmer by T at its axis and by D more on the side of +w than on that of −w stretches by αT and bends by −αD/h
//! without a section force. Held straight it has the axial force −EAαT and the moment EIαD/h: the load is their reverse on both
//! ends of the line, and section forces are those of all loads less those of this one.

use super::extent::{self, GivenExtent, Words};
use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use crate::case::{Amount, Case, Expansion, Temperature, number};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::expansion;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{Grid, PointAction};

/// What messages say of what becomes warmer.
const WORDS: Words = Words {
    what: "temperature",
    on_a_line: "all of a line becomes warmer",
    of_a_line: "all of a line becomes warmer",
    of_a_member: "of a frame name the member that becomes warmer",
};

/// Section forces that heat has given to a line, and the strains without stress that they belong to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineHeat {
    /// Number of the line.
    pub chain: usize,
    /// Axial force EAαT, N, and moment −EIαD/h, N m.
    pub forces: [f64; 2],
    /// Strain αT and curvature −αD/h, 1/m.
    pub strains: [f64; 2],
}

impl LineHeat {
    /// A multiple.
    pub(super) fn times(mut self, factor: f64) -> Self {
        self.forces.iter_mut().chain(&mut self.strains).for_each(|value| *value *= factor);
        self
    }
}

/// Adds a change of temperature.
pub(super) fn add(
    load: &Temperature,
    (case, layout): (&Case, &Layout),
    sections: Option<&[Resolved]>,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if load.region.is_some() {
        faults
            .error(path.key("region"), "`region` is for bodies")
            .hint("of a frame name the `member` that becomes warmer; all of a line does");
    }
    if case.fracture.is_some() {
        faults.error(path.clone(), "beams that break have no `temperature`").hint("remove `fracture`");
    }
    let given = GivenExtent { member: load.member.as_deref(), from: None, to: None };
    let extent = extent::find(&given, layout, path, &WORDS, faults);
    let Some(Expansion::Alike(alpha)) = expansion::of(case, false, path, faults) else { return };
    let Some(change) = change(load, path, faults) else { return };
    let difference = load.difference.unwrap_or(0.0);
    if change == 0.0 && difference == 0.0 {
        faults.error(path.clone(), "this load is zero").hint("give `change`, `difference`, or both");
    }
    let (Some(extent), Some(sections)) = (extent, sections) else { return };
    let section = &sections[extent.chain];
    if change != 0.0 && !section.has_axial {
        faults
            .error(
                path.key("change"),
                "`axial`, the stiffness EA against what stretches the line, is not given",
            )
            .hint("give it with `bending` and `shear`, or a `section`");
        return;
    }
    let Some(stiffness) = plain(&section.stiffness, path, faults) else { return };
    let mut heat = LineHeat { chain: extent.chain, forces: [0.0; 2], strains: [alpha * change, 0.0] };
    if difference != 0.0 {
        let Some(height) = section.section.height.as_ref().and_then(|height| height.uniform()) else {
            faults
                .error(path.key("difference"), "the height of the section is not known")
                .hint("give a `section`, which has one, in place of the stiffness");
            return;
        };
        heat.strains[1] = -alpha * difference / height;
    }
    heat.forces = [0, 1].map(|k| stiffness[k] * heat.strains[k]);
    let line = &layout.lines[extent.chain];
    if line.grid == Grid::Cells {
        faults
            .error(
                path.clone(),
                "a line that becomes warmer needs points at its ends, and a grid of cells has none",
            )
            .hint("use the grid `nodes`");
        return;
    }
    let [axial, moment] = heat.forces;
    for (x, sign) in [(line.from, -1.0), (line.to(), 1.0)] {
        let (axial, moment) = (sign * axial, sign * moment);
        to.loads.point.push(PointAction { chain: extent.chain, x, force: 0.0, moment, axial, spread: false });
    }
    to.heat.push(heat);
}

/// Kelvin at the axis.
fn change(load: &Temperature, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    if matches!(load.change, Some(Amount::Formula(_))) {
        faults
            .error(path.key("change"), "formulas are for bodies: a line is as warm all along")
            .hint("give a number, and members of their own where the temperature differs");
        return None;
    }
    Some(number(load.change.as_ref()).unwrap_or(0.0))
}

/// EA and EI of sections that are the same all along a line and do not couple them; EA is zero where it is not given.
fn plain(section: &SectionStiffness, path: &JsonPath, faults: &mut Faults) -> Option<[f64; 2]> {
    let plain = section.axial.uniform().zip(section.bending.uniform()).filter(|_| !section.couples());
    if plain.is_none() {
        faults
            .error(
                path.clone(),
                "a `temperature` needs sections of one material that do not vary along the line",
            )
            .hint("divide the body into members with sections of their own");
    }
    plain.map(|(axial, bending)| [axial, bending])
}
