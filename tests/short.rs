//! What takes seconds each: the command, the gallery and the rules of this repository, what holds for every body. One program
//! links the driver once for all of them.

mod cli;
mod properties;
mod regression;
