//! Bodies in the plane and what is found on them, before any model.
//!
//! An [`Outline`] says where material is, a [`SquareLattice`] or a [`Cloud`] holds its points, a [`Region`] selects some
//! of them and a [`Crack`] cuts bonds between them. Wherever a position may lie on a border, the border counts, within a
//! distance far below the spacing and far above rounding ([`BORDER`], [`CRACK_SLACK`]): what belongs to a body, to a
//! region or to a crack does not depend on how a coordinate was rounded, and mirrored bodies have mirrored points.

mod border;
mod centres;
mod cloud;
mod convex;
mod cover;
mod crack;
mod fill;
mod geometry;
mod lattice;
mod neighbours;
mod outline;
mod parts;
mod polygon;
mod region;
mod rows;
mod select;
mod transfer;
mod turn;

pub use border::BorderPart;
pub(crate) use centres::middle;
pub use cloud::{Cloud, CloudError, Group};
pub use crack::{CRACK_SLACK, Crack, CrackError, cut_bonds, cut_pairs};
pub use fill::FillError;
pub use geometry::in_space;
pub use lattice::{Cell, Centres, Parts, Run, SquareLattice, minus, plus};
pub use neighbours::Neighbours;
pub use outline::{Edge, Hole, HoleError, Outline, OutlineError, Shape};
pub use polygon::{Polygon, PolygonError};
pub use region::{Region, RegionError, Regions};
pub use transfer::Transfer;

/// Positions this close to a border lie on it, in spacings.
pub const BORDER: f64 = 1e-9;

/// The points of a body in the plane.
#[derive(Clone, Debug, PartialEq)]
pub enum PlaneBody {
    /// Cells of a square lattice.
    Lattice(SquareLattice),
    /// Listed points.
    Cloud(Cloud),
}

impl PlaneBody {
    /// Number of points.
    pub fn points(&self) -> usize {
        match self {
            Self::Lattice(lattice) => lattice.points(),
            Self::Cloud(cloud) => cloud.points(),
        }
    }

    /// Position of a point, m.
    pub fn position(&self, point: usize) -> [f64; 2] {
        match self {
            Self::Lattice(lattice) => lattice.place(point),
            Self::Cloud(cloud) => cloud.positions()[point],
        }
    }

    /// Visits the positions of all points, m, in their order: in a lattice by rows, which spares the search for each cell.
    pub fn visit(&self, mut visit: impl FnMut([f64; 2])) {
        match self {
            Self::Lattice(lattice) => {
                for run in lattice.runs() {
                    run.columns.clone().for_each(|column| visit(lattice.place_of(run.cell(column))));
                }
            }
            Self::Cloud(cloud) => cloud.positions().iter().for_each(|at| visit(*at)),
        }
    }

    /// Area of a point, m².
    pub fn area(&self, point: usize) -> f64 {
        match self {
            Self::Lattice(lattice) => lattice.area(point),
            Self::Cloud(cloud) => cloud.areas()[point],
        }
    }

    /// Side of a cell, or of the mean area of listed points, m.
    pub fn spacing(&self) -> f64 {
        match self {
            Self::Lattice(lattice) => lattice.spacing(),
            Self::Cloud(cloud) => cloud.spacing(),
        }
    }
}
