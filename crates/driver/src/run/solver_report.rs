//! What was taken to solve, and why.

/// What was taken to solve, and why.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct SolverReport {
    /// `strain_form`; or `band_cholesky`, `sparse_cholesky`, `multigrid` or `block_jacobi`, finished by conjugate gradients.
    pub method: String,
    /// Why.
    pub reason: String,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Conjugate-gradient iterations per state; empty where there are none.
    pub iterations: Vec<usize>,
    /// States for which double precision did not do, and residuals in twice the precision were taken.
    #[serde(skip_serializing_if = "is_zero")]
    pub refined: usize,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}
