//! Strains without stress of lines and members, whatever they come from.
//!
//! A line that would stretch by ε* and bend by κ* if nothing held it has the axial force −EA ε* and the moment −EI κ* where it is held
//! straight: the load is their reverse on both ends of the line, and section forces are those of all loads less those of this one.

use super::place::Layout;
use super::resolved_loads::ResolvedLoads;
use super::section::Resolved;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::{Grid, PointAction};

/// Strains without stress of a line, and the section forces of their load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenstrain {
    /// Number of the line.
    pub chain: usize,
    /// Axial force EA ε*, N, and moment EI κ*, N m.
    pub forces: [f64; 2],
    /// Strain ε* and curvature κ*, 1/m.
    pub strains: [f64; 2],
}

/// What messages call a load that gives a line such strains.
pub(super) struct Load {
    /// With its article.
    pub(super) name: &'static str,
    /// The line.
    pub(super) line: &'static str,
}

impl Eigenstrain {
    /// A multiple.
    pub(super) fn times(mut self, factor: f64) -> Self {
        self.forces.iter_mut().chain(&mut self.strains).for_each(|value| *value *= factor);
        self
    }
}

/// EA and EI of sections that are the same all along a line and do not couple them; EA is zero where it is not given and no key
/// stretches the line.
pub(super) fn stiffness(
    section: &Resolved,
    stretched_by: Option<&str>,
    load: &Load,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<[f64; 2]> {
    if let Some(key) = stretched_by.filter(|_| !section.has_axial) {
        faults
            .error(path.key(key), "`axial`, the stiffness EA against what stretches the line, is not given")
            .hint("give it with `bending` and `shear`, or a `section`");
        return None;
    }
    let stiffness = &section.stiffness;
    let plain = stiffness.axial.uniform().zip(stiffness.bending.uniform()).filter(|_| !stiffness.couples());
    if plain.is_none() {
        let message = format!("{} needs sections of one material that do not vary along the line", load.name);
        faults.error(path.clone(), message).hint("divide the body into members with sections of their own");
    }
    plain.map(|(axial, bending)| [axial, bending])
}

/// Adds strains without stress of a line.
pub(super) fn add(
    given: Eigenstrain,
    layout: &Layout,
    load: &Load,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    let line = &layout.lines[given.chain];
    if line.grid == Grid::Cells {
        let message = format!("{} needs points at its ends, and a grid of cells has none", load.line);
        faults.error(path.clone(), message).hint("use the grid `nodes`");
        return;
    }
    let [axial, moment] = given.forces;
    for (x, sign) in [(line.from, -1.0), (line.to(), 1.0)] {
        let (axial, moment) = (sign * axial, sign * moment);
        to.loads.point.push(PointAction { chain: given.chain, x, force: 0.0, moment, axial, spread: false });
    }
    to.eigenstrains.push(given);
}
