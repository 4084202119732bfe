//! Bodies in the plane and in space and what is found on them, before any model.
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
mod hole;
mod joined;
mod lattice;
mod named;
mod neighbours;
mod outline;
mod parts;
mod polygon;
mod region;
mod rows;
mod select;
mod solid;
mod thin;
mod transfer;
mod turn;

pub use border::BorderPart;
pub(crate) use border::around;
pub(crate) use centres::middle;
pub use cloud::{Cloud, CloudError, Group};
pub use crack::{
    CRACK_SLACK, Crack, CrackError, CrackSurface, CrackSurfaceError, FrontPlace, Fronts, Recess, cut_bonds,
    cut_pairs,
};
pub use fill::{FillError, fitting_spacings};
pub use geometry::in_space;
pub use hole::{Hole, HoleError, Shape};
pub(crate) use joined::{Chains, parted_bonds};
pub use lattice::{Cell, Centres, Run, SquareLattice, TriangleParts, minus, plus};
pub use named::{BorderGroup, BorderMember};
pub use neighbours::Neighbours;
pub use outline::{Edge, Outline, OutlineError};
pub use polygon::{Polygon, PolygonError};
pub use region::{Region, RegionError, Regions};
pub use solid::{
    Cut, CutError, Face, Facet, Filled, Grid, GridError, Patch, SIDES, ShapeError, Side, SolidRegion,
    SolidShape, Surface, SurfaceError, Wall, WallKind, WallSide,
};
pub use transfer::{Interpolation, LevelTransfer, Transfer};

/// Positions this close to a border lie on it, in spacings.
pub const BORDER: f64 = 1e-9;

/// The points of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum PointBody {
    /// Squares of a plane.
    Lattice(SquareLattice),
    /// Cubes of a solid.
    Solid(SquareLattice),
    /// Listed points.
    Cloud(Cloud),
}

impl PointBody {
    /// Number of coordinates of a position: two in the plane, three in space.
    pub fn axes(&self) -> usize {
        match self {
            Self::Lattice(_) => 2,
            Self::Solid(_) => 3,
            Self::Cloud(cloud) => cloud.axes(),
        }
    }

    /// Whether it is a body in space.
    pub fn is_solid(&self) -> bool {
        self.axes() == 3
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        match self {
            Self::Lattice(lattice) | Self::Solid(lattice) => lattice.points(),
            Self::Cloud(cloud) => cloud.points(),
        }
    }

    /// Position of a point, m; z = 0 in the plane.
    pub fn position(&self, point: usize) -> [f64; 3] {
        match self {
            Self::Lattice(lattice) => in_space(lattice.place(point)),
            Self::Solid(lattice) => lattice.position(point),
            Self::Cloud(cloud) => cloud.positions()[point],
        }
    }

    /// Position of a point along x and y, m: all of it in the plane.
    pub fn place(&self, point: usize) -> [f64; 2] {
        match self {
            Self::Lattice(lattice) | Self::Solid(lattice) => lattice.place(point),
            Self::Cloud(cloud) => cloud.place(point),
        }
    }

    /// The cells; listed points are none.
    pub fn cells(&self) -> Option<&SquareLattice> {
        match self {
            Self::Lattice(lattice) | Self::Solid(lattice) => Some(lattice),
            Self::Cloud(_) => None,
        }
    }

    /// Visits the positions of all points, m, in their order: in a lattice by rows, which spares the search for each cell.
    pub fn visit(&self, mut visit: impl FnMut([f64; 3])) {
        match self {
            Self::Lattice(lattice) => {
                for run in lattice.runs() {
                    let at = |column: i32| in_space(lattice.place_of(run.cell(column)));
                    run.columns.clone().for_each(|column| visit(at(column)));
                }
            }
            Self::Solid(lattice) => {
                for run in lattice.runs() {
                    run.columns.clone().for_each(|column| visit(lattice.centre(run.cell(column))));
                }
            }
            Self::Cloud(cloud) => cloud.positions().iter().for_each(|at| visit(*at)),
        }
    }

    /// What a point weighs in a mean: its area, m², in the plane, its volume, m³, in space.
    pub fn measure(&self, point: usize) -> f64 {
        match self {
            Self::Lattice(lattice) => lattice.area(point),
            Self::Solid(lattice) => lattice.volume(point),
            Self::Cloud(cloud) => cloud.sizes()[point],
        }
    }

    /// Side of a cell, or of the mean area or volume of listed points, m.
    pub fn spacing(&self) -> f64 {
        match self {
            Self::Lattice(lattice) | Self::Solid(lattice) => lattice.spacing(),
            Self::Cloud(cloud) => cloud.spacing(),
        }
    }
}
