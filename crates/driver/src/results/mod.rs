//! The folder of a run, written state by state; `summary.json` comes last and means that the run is finished. While a body
//! breaks, `restart.bin` is what the run can go on from.

mod any_curve;
mod beam;
mod being_written;
mod body;
mod claim;
mod curve;
mod digest;
mod envelope;
mod factor;
mod files;
mod inputs;
mod kept;
mod path_curve;
mod pictures;
mod plate;
mod report;
mod restart;
mod resume;
pub mod stiffness;
mod writing;

pub use being_written::{Results, finite};
pub(crate) use claim::plain;
pub use claim::{Claim, MARK};
pub(crate) use files::sweep;
pub use kept::{FieldFiles, FieldStates};
pub(crate) use pictures::{is_picture, write_formats};
pub use writing::Writing;
