//! Bodies in space by the closed surfaces around them: what is checked of a surface, the cells inside it, and the sides of cells that
//! stand for parts of it.

mod closed;
mod crossings;
mod distance;
mod facets;
mod grid;
mod nearest;
mod patch;
mod rows;
mod walls;

#[cfg(test)]
mod tests;

pub use closed::SurfaceError;
pub use facets::{Facet, Surface};
pub use grid::{Filled, Grid, GridError};
pub use patch::{Patch, WallSide};
