//! Coarser levels of a problem.

use peristat_assembly::body::LevelTransfer;
use peristat_assembly::cubic::CubicLevels;
use peristat_assembly::system::System;
use peristat_solve::LinePlace;

/// The coarser levels of a problem.
pub enum Coarser<const D: usize> {
    /// The same body and conditions at twice the spacing, again and again.
    Models(CoarserModels<D>),
    /// Cubes with one stencil, which stand in for the finest level, too.
    Cubes(CubicLevels),
    /// The places of the unknowns, none of those that are held or follow others: levels are coarser along lines only.
    Lines(Vec<Option<LinePlace>>),
}

/// Models of coarser bodies.
pub struct CoarserModels<const D: usize> {
    /// Systems, the finest of them first.
    pub systems: Vec<System<D>>,
    /// Interpolation to every level that has a coarser one, the finest level of all first.
    pub transfers: Vec<Box<dyn LevelTransfer>>,
    /// Whether the coarsest one can move as a body: supports that are close to each other fall together there.
    pub is_loose: bool,
    /// Whether the finest level of all has other elements than these, so that its eigenvalues are its own.
    pub is_unlike: bool,
    /// Whether every level is visited once: corrections of coarser ones may overshoot, where their supports are further out.
    pub visits_once: bool,
    /// Whether bending is so soft that numbers of 32 bits would round what resists it.
    pub is_soft: bool,
    /// Points of the finest level of all, beside a border that cuts cells, that are smoothed together.
    pub beside_border: Vec<usize>,
}
