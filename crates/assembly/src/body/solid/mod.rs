//! Bodies in space: blocks with parts cut out of them and what closed surfaces bound, their faces, and the points of them that regions name.

mod cut;
mod region;
mod shape;
mod surface;
mod wall;

pub use cut::{Cut, CutError};
pub use region::SolidRegion;
pub use shape::{Face, SIDES, ShapeError, SolidShape};
pub use surface::{Facet, Filled, Grid, GridError, Patch, Surface, SurfaceError, WallSide};

pub use wall::{Side, Wall, WallKind};

pub(super) use region::select;
