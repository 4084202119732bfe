//! What all processes agree on.

use crate::run::RunError;
use peristat_solve::Ranks;

/// The result of this process if all have one; else its own error, or that of another in words.
///
/// # Errors
/// Some process has an error.
pub(crate) fn agree<T>(ranks: &dyn Ranks, result: Result<T, RunError>) -> Result<T, RunError> {
    let mut failed = [f64::from(u8::from(result.is_err()))];
    ranks.sum(&mut failed);
    match result {
        Ok(_) if failed[0] > 0.0 => Err(RunError::NotShared("what another process has no part of".into())),
        other => other,
    }
}
