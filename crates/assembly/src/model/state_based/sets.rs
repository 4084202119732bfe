//! The weights of one family, by where its point is and which of its neighbours are there.

use super::super::bond_plane::Influence;
use super::super::plane::length;
use super::axis_table::AxisTable;
use super::moments::{correct, weighted_volume};
use super::weights::Set;
use super::{Axis, Measure, StateEdges, StateError, StateParameters};
use crate::body::{Cell, SquareLattice, plus};
use std::f64::consts::TAU;

/// What all families are made of.
pub(super) struct Maker<'a> {
    parameters: &'a StateParameters,
    lattice: &'a SquareLattice,
    offsets: &'a [Cell],
    /// Influence by offset.
    influence: Vec<f64>,
    table: Option<AxisTable>,
    /// Radius of the left side of column 0, spacings.
    corner: f64,
    /// Bonds that never were, by offset of the half and lower point, sorted.
    apart: &'a [(usize, usize)],
}

impl<'a> Maker<'a> {
    pub(super) fn new(
        parameters: &'a StateParameters,
        lattice: &'a SquareLattice,
        offsets: &'a [Cell],
        has_axis: bool,
    ) -> Result<Self, StateError> {
        let m = parameters.horizon_ratio;
        let influence: Vec<f64> =
            offsets.iter().map(|&o| Influence::at(parameters.influence, length(o) / m)).collect();
        let corner = lattice.corner()[0] / lattice.spacing();
        let mut maker = Self { parameters, lattice, offsets, influence, table: None, corner, apart: &[] };
        if has_axis && parameters.axis == Axis::Table {
            if parameters.measure != Measure::Section {
                return Err(StateError::AxisNeedsSection);
            }
            if parameters.edges != StateEdges::Ghosts {
                return Err(StateError::AxisNeedsGhosts);
            }
            let plain = maker.plain();
            let table = AxisTable::new(offsets, &plain.weights, plain.q);
            maker.table = Some(table.ok_or(StateError::NegativeAxis)?);
        }
        Ok(maker)
    }

    /// Radius of a column, spacings.
    fn radius(&self, column: i32) -> f64 {
        self.corner + f64::from(column) + 0.5
    }

    /// Column of the axis table that a point is in.
    fn table_column(&self, column: i32) -> Option<(usize, &AxisTable)> {
        let table = self.table.as_ref()?;
        let ring = self.radius(column).floor() as usize;
        (ring < table.radii.len()).then_some((ring, table))
    }

    /// What points have in common that share their weights: a class of columns, zero for all where the column does not
    /// matter, and which neighbours are there.
    pub(super) fn key(&self, point: usize) -> (i32, Vec<bool>) {
        let cell = self.lattice.cell(point);
        let column = cell[0];
        let class = match (self.parameters.measure, self.table_column(column)) {
            (Measure::Published, _) => 1 + column,
            (_, Some((ring, _))) => 1 + ring as i32,
            _ => 0,
        };
        let half = self.offsets.len() / 2;
        let is_apart = |k: usize, other: usize| {
            let bond = if k < half { (k, point) } else { (k - half, other) };
            self.apart.binary_search(&bond).is_ok()
        };
        let present = |(k, o): (usize, &Cell)| {
            self.lattice.number(plus(cell, *o)).is_some_and(|other| !is_apart(k, other))
        };
        (class, self.offsets.iter().enumerate().map(present).collect())
    }

    /// The same without some bonds.
    pub(super) fn without(self, apart: &'a [(usize, usize)]) -> Self {
        Self { apart, ..self }
    }

    fn corrects(&self) -> bool {
        !matches!(self.parameters.edges, StateEdges::Calibrated | StateEdges::None)
    }

    /// The family that has all neighbours, far from the axis.
    pub(super) fn plain(&self) -> Set {
        self.weighed(self.influence.clone())
    }

    /// A family of these weights, corrected as the treatment of edges asks.
    fn weighed(&self, mut weights: Vec<f64>) -> Set {
        let mut q = weighted_volume(self.offsets, &weights);
        if self.corrects() {
            correct(self.offsets, &mut weights, q);
        }
        if self.parameters.edges == StateEdges::None {
            q = self.continuum();
        }
        Set { weights, q, own: Vec::new() }
    }

    /// `∫ ω ξ² dA` over the disc of the horizon.
    fn continuum(&self) -> f64 {
        TAU * self.parameters.horizon_ratio.powi(4) * self.parameters.influence.third_moment()
    }

    pub(super) fn set(&self, (class, present): &(i32, Vec<bool>)) -> Set {
        if let Some((ring, table)) =
            self.table.as_ref().filter(|_| *class > 0).map(|table| ((class - 1) as usize, table))
        {
            let plain = self.plain();
            let own = table.weights[ring].iter().zip(present);
            let weights = own.map(|(w, present)| if *present { *w } else { 0.0 }).collect();
            return Set { weights, q: plain.q, own: Vec::new() };
        }
        let own = self.radius(class - 1);
        let mut weights = self.influence.clone();
        for (k, w) in weights.iter_mut().enumerate() {
            if !present[k] {
                *w = 0.0;
            }
            if self.parameters.measure == Measure::Published {
                // A ring across the axis has the volume of its image.
                *w *= (own + f64::from(self.offsets[k][0])).abs() / own;
            }
        }
        self.weighed(weights)
    }

    /// Volume of a point, or that of its energy.
    pub(super) fn volume(&self, point: usize, of_energy: bool) -> f64 {
        let part = self.lattice.fraction(point);
        if !self.parameters.is_axisymmetric() {
            return part;
        }
        let column = self.lattice.cell(point)[0];
        match self.table_column(column) {
            Some((ring, table)) if of_energy => part * table.radii[ring],
            _ => part * self.radius(column),
        }
    }
}
