//! Running bodies that break.

mod event;

pub use event::{Event, Restart};
