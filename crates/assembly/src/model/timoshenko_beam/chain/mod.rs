//! One straight chain of points: which bonds it has, with which weight.

mod layout;
mod places;
mod relations;
mod table;
#[cfg(test)]
mod tests;

pub use table::BondTable;
pub(super) use table::pieces;

use super::BeamParameters;
use super::bond::UniformSection;
use super::end_treatment::{EndKind, EndSupport, EndTreatment};
use super::weights::bond_weights;
use crate::material::SectionStiffness;
use crate::stiffness::{Override, Weights};
use layout::Layout;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Where the points of a line lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Grid {
    /// `cells + 1` points with one on each end.
    #[default]
    Nodes,
    /// One point in the middle of each cell.
    Cells,
}

/// Which points of a line have axial unknowns that something reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axial {
    /// The two end points: between them the line stretches as one bar.
    #[default]
    Ends,
    /// All points: an axial load or support acts inside, or bending and stretching couple.
    Points,
}

/// A straight line, as given. Its own coordinate x runs from `from` to `from + length`.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Coordinate of its start, m.
    pub from: f64,
    /// Length, m.
    pub length: f64,
    /// Number of cells.
    pub cells: usize,
    /// Where the points lie.
    pub grid: Grid,
    /// Distances of the `cells + 1` points from the start, growing from 0 to the length; `None` if they are equally
    /// spaced. Only with [`Grid::Nodes`] and covered ends.
    pub stations: Option<Vec<f64>>,
    /// Horizon over spacing, δ/h, >= 1; on a graded grid the number of neighbours on each side.
    pub horizon_ratio: f64,
    /// Points, counted from the start, that no bond may span.
    pub splits: Vec<usize>,
    /// What holds the two ends.
    pub supports: [EndSupport; 2],
    /// Stiffness of its sections, by the distance from the start.
    pub stiffness: SectionStiffness,
    /// Position in the plane of the coordinate x = 0, m.
    pub origin: [f64; 2],
    /// Unit vector in which x grows; w grows to its left.
    pub direction: [f64; 2],
    /// Where axial unknowns are read, in a body that has them.
    pub axial: Axial,
}

/// A chain that cannot be built.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ChainError {
    /// The correction would need a bond with a negative weight.
    #[error(
        "the bonds between neighbours would need the weight {weight:.4}, and a stiffness must not be negative"
    )]
    NegativeWeight {
        /// The weight.
        weight: f64,
    },
}

/// A line with its bonds and ghost points.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Real points.
    pub points: usize,
    /// Ghost points beyond the left and the right end.
    pub ghosts: [usize; 2],
    /// Coordinate of the first real point, m.
    pub origin: f64,
    /// Distance of neighbours, m; their mean distance on a graded grid.
    pub spacing: f64,
    /// Weights α of the bonds over 1, 2, … cells, zero where they are broken; points are counted from the first ghost.
    pub weights: Weights,
    /// Measures and moduli of the bonds.
    pub bonds: BondTable,
    line: Line,
    kinds: [EndKind; 2],
    /// Weights before the first bond broke.
    intact: Option<Box<Weights>>,
}

impl Line {
    /// A line along the axis of a uniform grid: from 0, horizon ratio 3, free ends.
    pub fn new(length: f64, cells: usize, stiffness: SectionStiffness) -> Self {
        Self {
            from: 0.0,
            length,
            cells,
            grid: Grid::Nodes,
            stations: None,
            horizon_ratio: 3.0,
            splits: Vec::new(),
            supports: [EndSupport::default(); 2],
            stiffness,
            origin: [0.0; 2],
            direction: [1.0, 0.0],
            axial: Axial::Ends,
        }
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        match self.grid {
            Grid::Nodes => self.cells + 1,
            Grid::Cells => self.cells,
        }
    }

    /// Distance of neighbours, m; their mean distance on a graded grid.
    pub fn spacing(&self) -> f64 {
        self.length / self.cells as f64
    }

    /// Coordinate of the first point, m.
    pub fn origin(&self) -> f64 {
        match self.grid {
            Grid::Nodes => self.from,
            Grid::Cells => self.from + 0.5 * self.spacing(),
        }
    }
}

impl Chain {
    /// Bonds of a line.
    ///
    /// # Errors
    /// [`ChainError`] where a weight would be negative.
    pub fn new(line: Line, parameters: &BeamParameters) -> Result<Self, ChainError> {
        let BeamParameters { volume_factor, end_treatment: treatment, bond_law } = *parameters;
        let points = line.points();
        let all = bond_weights(line.horizon_ratio, volume_factor);
        let reach = all.len().min(points - 1);
        let kinds = [0, 1].map(|side| (treatment.end)(&line.supports[side]));
        let ghosts = kinds.map(|kind| match (kind, line.grid) {
            (EndKind::Covered | EndKind::Truncated, _) => 0,
            (_, Grid::Nodes) => reach - 1,
            (_, Grid::Cells) => reach,
        });
        let layout = Layout { line: &line, points, ghosts, kinds, splits: treatment.splits };
        let weights = layout.weights(&all)?;
        let position = |point: usize| position(&line, ghosts[0], point);
        let bonds = match line.stiffness.plain() {
            Some((bending_stiffness, shear_stiffness)) => {
                let axial_stiffness = line.stiffness.axial.value(0.0);
                let section =
                    UniformSection { bending_stiffness, shear_stiffness, axial_stiffness, law: bond_law };
                let spacing = line.stations.is_none().then(|| line.spacing());
                BondTable::of_section(section, &weights, mean_square(&all, treatment), position, spacing)
            }
            None => BondTable::of_flexibility(&line, &weights, position),
        };
        let (origin, spacing) = (line.origin(), line.spacing());
        Ok(Self { points, ghosts, origin, spacing, weights, bonds, line, kinds, intact: None })
    }

    /// How the two ends are treated.
    pub fn ends(&self) -> [EndKind; 2] {
        self.kinds
    }

    /// Weights with all bonds: loads are shared by them whatever breaks, for the loads themselves stay.
    pub fn intact_weights(&self) -> &Weights {
        self.intact.as_deref().unwrap_or(&self.weights)
    }

    /// Removes a bond, with what it made up for.
    pub(super) fn break_bond(&mut self, class: usize, lower: usize) {
        self.intact.get_or_insert_with(|| Box::new(self.weights.clone()));
        self.weights.change(Override { class, lower, factor: 0.0 });
    }

    /// Points with ghosts.
    pub fn extended(&self) -> usize {
        self.ghosts[0] + self.points + self.ghosts[1]
    }

    /// Coordinate of an extended point, m.
    pub fn position(&self, point: usize) -> f64 {
        position(&self.line, self.ghosts[0], point)
    }

    /// Visits the coordinates of `count` extended points from `first` on, with their places among these.
    #[inline(always)]
    pub fn positions(&self, first: usize, count: usize, mut visit: impl FnMut(usize, f64)) {
        match &self.line.stations {
            Some(stations) => {
                let stations = stations[first..][..count].iter().enumerate();
                stations.for_each(|(k, x)| visit(k, self.line.from + x));
            }
            None => {
                let (origin, spacing) = (self.line.origin(), self.line.spacing());
                (0..count).for_each(|k| {
                    visit(k, origin + ((first + k) as f64 - self.ghosts[0] as f64) * spacing);
                });
            }
        }
    }

    /// Whether the line, in a body with axial unknowns, has them only on its ends.
    pub fn stretches_as_bar(&self) -> bool {
        self.line.axial == Axial::Ends && self.is_uniform() && self.ghosts == [0; 2]
    }

    /// Whether all cells have one length and all sections one stiffness.
    pub fn is_uniform(&self) -> bool {
        matches!(self.bonds, BondTable::Uniform { .. })
    }

    /// The line as given.
    pub fn line(&self) -> &Line {
        &self.line
    }
}

/// Coordinate of an extended point of a line with so many ghosts before it.
fn position(line: &Line, ghosts: usize, point: usize) -> f64 {
    match &line.stations {
        Some(stations) => line.from + stations[point],
        None => line.origin() + (point as f64 - ghosts as f64) * line.spacing(),
    }
}

/// ⟨ξ²⟩ of a family of an unbounded chain over the square of the spacing. It belongs to a full family, also where the
/// beam is shorter than the horizon.
fn mean_square(weights: &[f64], treatment: &EndTreatment) -> f64 {
    let moment = |power: i32| -> f64 {
        weights.iter().enumerate().map(|(k, a)| ((k + 1) as f64).powi(power) * a).sum()
    };
    // What covers add to the bonds between neighbours, where the ratio is not whole.
    let lack = if treatment.covers() { 1.0 - moment(1) } else { 0.0 };
    (moment(3) + lack) / (moment(1) + lack)
}
