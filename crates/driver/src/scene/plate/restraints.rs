//! What holds a plate: supports and lines of symmetry with their equations and springs.

use super::border::Side;
use peristat_assembly::condition::Equation;
use peristat_assembly::stiffness::Spring;
use std::ops::Range;

/// What holds a plate at a place.
#[derive(Clone, Debug)]
pub struct PlateSupport {
    /// What the user calls the place.
    pub name: String,
    /// Which of the equations of the scene are its.
    pub equations: Range<usize>,
    /// Which of the springs of the scene are its.
    pub springs: Range<usize>,
    /// Whether it is a line of symmetry, behind which the other half holds the plate.
    pub is_mirror: bool,
}

/// Where a support is.
pub(super) struct Place {
    /// What the user calls it.
    pub(super) name: String,
    pub(super) points: Vec<u32>,
    /// Sides of cells on the edge that is held.
    pub(super) sides: Vec<Side>,
    pub(super) is_mirror: bool,
}

/// All that supports make.
#[derive(Default)]
pub(super) struct Restraints {
    pub(super) supports: Vec<PlateSupport>,
    /// The sides of cells that each of them holds.
    pub(super) sides: Vec<Vec<Side>>,
    /// The points that each of them holds.
    pub(super) points: Vec<Vec<u32>>,
    pub(super) equations: Vec<Equation>,
    /// Per equation what it prescribes in every load step, where that is not in proportion to the load factor; else nothing.
    pub(super) by_step: Vec<Vec<f64>>,
    pub(super) springs: Vec<Spring>,
}

impl Restraints {
    /// Takes the equations and springs of one support.
    pub(super) fn take(&mut self, place: Place, equations: Vec<(Equation, Vec<f64>)>, springs: Vec<Spring>) {
        let Place { name, points, sides, is_mirror } = place;
        self.sides.push(sides);
        self.points.push(points);
        let [first, from] = [self.equations.len(), self.springs.len()];
        for (equation, by_step) in equations {
            self.equations.push(equation);
            self.by_step.push(by_step);
        }
        self.springs.extend(springs);
        let (equations, springs) = (first..self.equations.len(), from..self.springs.len());
        self.supports.push(PlateSupport { name, equations, springs, is_mirror });
    }

    /// Whether something that it prescribes is not zero.
    pub(super) fn moves(&self) -> bool {
        let values = self.equations.iter().map(|equation| equation.value);
        values.chain(self.by_step.iter().flatten().copied()).any(|value| value != 0.0)
    }
}
