//! Diagrams of lines over lines, pictures of frames and maps of bodies in the plane, as SVG made to stand in a report or a README as they are, and as PNG and PDF.

mod diagram;
mod draw;
mod formats;
mod log_log;
mod map;
mod marks;
mod patch;
mod picture;
mod scale;
mod thin;

pub use diagram::{Diagram, Series, Style, render, write};
pub use formats::{pdf, png};
pub use log_log::{LogLog, PowerLine, render_log_log, write_log_log};
pub use map::{Map, render_map, write_map};
pub use marks::Isoline;
pub use patch::{Light, Patch};
pub use picture::{Label, Look, Picture, Shape, write_picture};
pub(crate) use scale::{levels, short};
pub(crate) use thin::thin;
