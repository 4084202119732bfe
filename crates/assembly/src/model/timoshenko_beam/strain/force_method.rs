//! Supports of a cantilever that is clamped at its first point and moves as a whole: the force method.

use super::{StrainAction, StrainForm};
use crate::model::timoshenko_beam::{PHI, W};
use crate::sum::Sum;
use nalgebra::{DMatrix, DVector};

/// A support of one displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainSupport {
    /// Point.
    pub point: usize,
    /// What it holds, [`W`] or [`PHI`].
    pub component: usize,
    /// Displacement per reaction, m/N or rad/(N m): 0 for a rigid support, 1/k for a spring.
    pub compliance: f64,
}

/// The equations of the start `a = (w_0, φ_0)` and the reactions λ:
///
/// ```text
/// C a + (D + diag(compliance)) λ = motion − u        Cᵀ λ = −(Σ F, Σ C + Σ x F)
/// ```
///
/// with rows `C_p = (1, x_p)` for w and `(0, 1)` for φ, and D the displacements at the supports of the cantilever under
/// unit reactions.
#[derive(Clone, Debug)]
pub struct ForceMethod {
    supports: Vec<StrainSupport>,
    /// Distances of the supports from the first point.
    arms: Vec<f64>,
    length: f64,
    /// D by columns.
    flexibility: Vec<Vec<f64>>,
}

/// Start and reactions, or corrections of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Redundants {
    /// (w_0, φ_0).
    pub start: [f64; 2],
    /// Reactions on the beam, in the order of the supports.
    pub reactions: Vec<f64>,
}

impl ForceMethod {
    /// The equations of some supports, without flexibility yet.
    pub fn new(form: &StrainForm, supports: Vec<StrainSupport>) -> Self {
        let arms = supports.iter().map(|s| form.distance(s.point)).collect();
        let flexibility = vec![vec![0.0; supports.len()]; supports.len()];
        Self { arms, length: form.distance(form.cells()), flexibility, supports }
    }

    /// The supports.
    pub fn supports(&self) -> &[StrainSupport] {
        &self.supports
    }

    /// Length of the beam, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Unit reactions whose displacements at the supports are wanted, with the index of their support. On the first point
    /// a reaction moves nothing.
    pub fn units(&self) -> Vec<(usize, StrainAction)> {
        let supports = self.supports.iter().enumerate().filter(|(_, s)| s.point > 0);
        let unit =
            |s: &StrainSupport| StrainAction { point: s.point, component: s.component, value: Sum::of(1.0) };
        supports.map(|(k, s)| (k, unit(s))).collect()
    }

    /// Sets the displacements at all supports under the unit reaction of one.
    pub fn set_flexibility(&mut self, support: usize, displacements: Vec<f64>) {
        self.flexibility[support] = displacements;
    }

    /// Length that turns rotations into displacements.
    fn scale(&self, component: usize) -> f64 {
        if component == PHI { self.length } else { 1.0 }
    }

    /// Largest displacement under a unit reaction, rotations and moments in units of the length, m/N; 0 if no support is
    /// off the first point.
    pub fn largest_flexibility(&self) -> f64 {
        let own = |(k, s): (usize, &StrainSupport)| self.scale(s.component).powi(2) * self.flexibility[k][k];
        self.supports.iter().enumerate().map(own).fold(0.0, f64::max)
    }

    /// Start and reactions for `gaps` (motion − u) and a resultant of all forces about the first point; `None` if nothing
    /// determines them.
    pub fn solve(&self, gaps: &[f64], resultant: [f64; 2]) -> Option<Redundants> {
        let n = self.supports.len();
        let compliance = |s: &StrainSupport| self.scale(s.component).powi(2) * s.compliance;
        let largest = self.supports.iter().map(compliance).fold(0.0, f64::max);
        // Reactions in units that make flexibilities about one.
        let unit = [self.largest_flexibility(), largest, 1.0].into_iter().find(|&f| f > 0.0)?;
        let mut rows = vec![vec![0.0; n + 3]; n + 2];
        for (p, support) in self.supports.iter().enumerate() {
            let scale = self.scale(support.component);
            let rigid = if support.component == W { [1.0, self.arms[p] / self.length] } else { [0.0, 1.0] };
            for k in 0..2 {
                rows[p][k] = rigid[k];
                rows[n + k][2 + p] = rigid[k];
            }
            for (q, other) in self.supports.iter().enumerate() {
                rows[p][2 + q] = scale * self.scale(other.component) * self.flexibility[q][p] / unit;
            }
            rows[p][2 + p] += compliance(support) / unit;
            rows[p][n + 2] = scale * gaps[p];
        }
        rows[n][n + 2] = -resultant[0] * unit;
        rows[n + 1][n + 2] = -resultant[1] / self.length * unit;
        let x = eliminate(&rows)?;
        let reaction = |(s, x): (&StrainSupport, &f64)| self.scale(s.component) * x / unit;
        Some(Redundants {
            start: [x[0], x[1] / self.length],
            reactions: self.supports.iter().zip(&x[2..]).map(reaction).collect(),
        })
    }
}

/// Solves with rows scaled to one; the last column is the right-hand side. `None` if the rows are dependent.
fn eliminate(rows: &[Vec<f64>]) -> Option<Vec<f64>> {
    let n = rows.len();
    let scales: Vec<f64> =
        rows.iter().map(|row| row[..n].iter().fold(0.0, |a: f64, x| a.max(x.abs()))).collect();
    let matrix = DMatrix::from_fn(n, n, |r, c| rows[r][c] / scales[r]);
    let right = DVector::from_fn(n, |r, _| rows[r][n] / scales[r]);
    let x = matrix.lu().solve(&right)?;
    // A row of zeros leaves what is not a number.
    x.iter().all(|v| v.is_finite()).then(|| x.as_slice().to_vec())
}
