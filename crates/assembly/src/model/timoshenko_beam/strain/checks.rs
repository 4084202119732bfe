//! What a pass over the strains tells of them.

use super::stiffness::Diagonal;
use super::sums::{dot, largest};

/// What a pass over the strains tells of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrainChecks {
    /// `max |r − K v| / √K_cc`, with r summed from the left: also statics, √J.
    pub residual: f64,
    /// `max |r| / √K_cc`, √J.
    pub action: f64,
    /// `max √K_cc |v|`, √J.
    pub strain: f64,
    /// Strain energy `½ vᵀ K v`, J.
    pub energy: f64,
    /// Half the work of loads and actions on the displacements, J.
    pub work: f64,
    /// Largest |w|, m, and |φ|, rad.
    pub largest: [f64; 2],
    /// Force, N, and moment about the last point, N m, that all loads and actions leave over, summed from the left.
    pub closure: [f64; 2],
}

impl StrainChecks {
    /// Takes rows `K v` with their right-hand sides and strains, θ first, and returns `vᵀ K v`. The rows are lost.
    #[inline(always)]
    pub(super) fn take(
        &mut self,
        diagonal: &Diagonal,
        rows: [&mut [f64]; 2],
        right: [&[f64]; 2],
        v: [&[f64]; 2],
    ) -> f64 {
        let energy = dot(rows[0], v[0]) + dot(rows[1], v[1]);
        for (p, row) in rows.into_iter().enumerate() {
            row.iter_mut().zip(right[p]).for_each(|(row, r)| *row = r - *row);
            match diagonal {
                Diagonal::Equal(diagonal) => {
                    let scale = diagonal[p].sqrt();
                    self.join(largest(row) / scale, largest(right[p]) / scale, largest(v[p]) * scale);
                }
                Diagonal::Each(diagonal) => {
                    for (k, diagonal) in diagonal.iter().enumerate() {
                        let scale = diagonal[p].sqrt();
                        self.join(row[k].abs() / scale, right[p][k].abs() / scale, v[p][k].abs() * scale);
                    }
                }
            }
        }
        energy
    }

    #[inline(always)]
    fn join(&mut self, residual: f64, action: f64, strain: f64) {
        self.residual = self.residual.max(residual);
        self.action = self.action.max(action);
        self.strain = self.strain.max(strain);
    }
}
