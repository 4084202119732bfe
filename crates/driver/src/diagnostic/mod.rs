//! Faults of case files, worded so that the reader can mend them.
//!
//! A [`Diagnostic`] is a reason, a place and a hint. The place is a [`JsonPath`], because the code that
//! finds a fault (a negative length, a probe outside the body) knows the meaning of a value and not where
//! it stands; [`locate`] finds the bytes of that path in the text, [`Report::render`] draws the line with a
//! caret, and [`parse`] turns the messages of `serde` into the same form. A [`Report`] holds every fault of
//! one file at once. Nothing here prints.

mod check;
mod comments;
mod data;
mod excerpt;
mod fault;
mod json;
pub mod locate;
mod misspelt;
mod mistaken;
mod parse;
mod path;
mod record;
mod render;
mod syntax;
mod words;

pub(crate) use check::{fibre_angle, positive, root};
pub(crate) use comments::without_comments;
pub use excerpt::{clip, quote};
pub use fault::{Diagnostic, Faults, Report, Severity};
pub(crate) use mistaken::{case_for_study, study_for_case};
pub use parse::{decode, parse};
pub use path::{JsonPath, PathError, Segment};
pub use record::FaultRecord;
pub(crate) use words::{suggest, tidy};
