//! What models are given of the body that they are on.

use super::Mixture;
use crate::diagnostic::JsonPath;
use peristat_assembly::body::{Cell, Outline, SquareLattice};
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::plane::{FindCuts, Mirrors};

/// A lattice to fill with bonds.
pub struct OnLattice<'a> {
    /// The cells of the body, without images.
    pub real: &'a SquareLattice,
    /// Its lines of symmetry and joined sides.
    pub mirrors: Mirrors,
    /// The materials of these cells.
    pub materials: &'a Mixture,
    /// Finds the cut bonds on the lattice with images, given the offsets, by index of the offset and lower point.
    pub cuts: &'a FindCuts<'a>,
    /// Whether something stands between two cells.
    pub separated: &'a (dyn Fn(Cell, Cell) -> bool + 'a),
}

/// What the strength of bonds depends on beside themselves.
#[derive(Clone, Copy, Debug)]
pub struct OnGround {
    /// Whether points fill a lattice.
    pub is_lattice: bool,
    /// Side of a cell, or root of the mean area of listed points, in space of their mean volume, m.
    pub spacing: f64,
    /// Horizon, m.
    pub horizon: f64,
    /// The key that gives it.
    pub horizon_key: &'static str,
}

/// A body that is made.
pub struct Resolved<'a> {
    /// The body.
    pub model: &'a dyn BodyModel,
    /// Its cells without images; none of listed points.
    pub lattice: Option<&'a SquareLattice>,
    /// Its outline; none of listed points.
    pub outline: Option<&'a Outline>,
    /// Its lines of symmetry and joined sides.
    pub mirrors: &'a Mirrors,
    /// Side of a cell, or root of the mean area of listed points, in space of their mean volume, m.
    pub spacing: f64,
    /// Regions that supports hold or move.
    pub held: &'a [HeldRegion],
}

/// A region that a support holds or moves.
#[derive(Clone, Debug)]
pub struct HeldRegion {
    /// Name of the region.
    pub region: Option<String>,
    /// The support.
    pub path: JsonPath,
    /// Components that it prescribes, by name.
    pub components: Vec<&'static str>,
}

/// Directions of an orthotropic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fibres {
    /// Young's moduli along and across the fibres.
    pub youngs_moduli: [f64; 2],
    /// Contraction across the fibres per stretch along them.
    pub poisson_ratio: f64,
    /// Shear modulus.
    pub shear_modulus: f64,
    /// Angle of the fibres from x, rad.
    pub angle: f64,
}
