//! Bodies in space: blocks with parts cut out of them, their faces, and the points of them that regions name.

mod region;
mod shape;

pub use region::SolidRegion;
pub use shape::{Cut, CutError, Face, SIDES, ShapeError, SolidShape};

pub(super) use region::select;
