//! Matrix Market files.

use std::io::{self, Write};
use std::path::Path;

/// Writes the lower triangle of a symmetric matrix, given as `(row, column, value)` from zero, with comment lines.
///
/// # Errors
/// The file cannot be written.
pub fn write(
    path: &Path,
    order: usize,
    entries: &[(usize, usize, f64)],
    comments: &[String],
) -> io::Result<()> {
    super::atomic::replace(path, |out: &mut dyn Write| {
        writeln!(out, "%%MatrixMarket matrix coordinate real symmetric")?;
        for comment in comments {
            writeln!(out, "% {comment}")?;
        }
        let lower = entries.iter().filter(|(i, j, _)| i >= j);
        writeln!(out, "{order} {order} {}", lower.clone().count())?;
        for (i, j, value) in lower {
            writeln!(out, "{} {} {value:e}", i + 1, j + 1)?;
        }
        Ok(())
    })
}
