//! What a body is, before anything holds or loads it: its points, names, mirrors, cracks and material.

pub(crate) mod bearing;
pub(crate) mod body;
pub(crate) mod border_names;
pub(crate) mod boundary;
pub(crate) mod counts;
pub(crate) mod cracks;
mod drawn;
pub(crate) mod files;
pub(crate) mod foreign;
pub(crate) mod given_body;
pub(crate) mod ground;
pub(crate) mod held_angle;
pub(crate) mod holes;
pub(crate) mod interpolate;
pub(crate) mod model_inputs;
pub(crate) mod of_case;
pub(crate) mod periodic;
mod region_faults;
pub(crate) mod regions;
pub(crate) mod resultants;
pub(crate) mod size;
pub(crate) mod snap;
pub(crate) mod solid;
mod solid_file;
pub(crate) mod specimen;
pub(crate) mod symmetry;
pub(crate) mod tips;
