//! Displacements of the same bonds in double-double arithmetic.

use super::dense::{over, solved};
use super::{Body, CRITICAL, Way};
use twofloat::TwoFloat;

/// Ratio of two strains of bonds below which it is doubtful whether they break together.
const APART: f64 = 1e-6;

/// A bond of the body.
#[derive(Clone, Copy, Debug)]
struct Bond {
    ends: [usize; 2],
    /// From the first end to the second.
    xi: [f64; 2],
    square: TwoFloat,
    /// Force over elongation, divided by the square of the length: k n nᵀ = k/ξ² ξ ξᵀ.
    stiffness: TwoFloat,
}

impl Bond {
    /// Elongation over length.
    fn stretch(&self, u: &[TwoFloat]) -> f64 {
        let [i, j] = self.ends;
        let along = |c: usize| (u[2 * j + c] - u[2 * i + c]) * self.xi[c];
        f64::from(over(along(0) + along(1), self.square))
    }
}

impl Body {
    /// Whether the crack crosses a bond.
    fn cuts(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let [x, tip] = self.tip;
        if (a[0] - x) * (b[0] - x) >= 0.0 {
            return false;
        }
        a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) < tip
    }

    /// The bonds; the micromodulus of plane stress is 9E/(π t δ³).
    fn bonds(&self) -> Vec<Bond> {
        let points = self.points();
        let micromodulus =
            over(over(TwoFloat::from(9.0), twofloat::consts::PI), TwoFloat::from(self.ratio).powi(3));
        let mut bonds = Vec::new();
        for (i, a) in points.iter().enumerate() {
            for (j, b) in points.iter().enumerate().skip(i + 1) {
                let xi = [b[0] - a[0], b[1] - a[1]];
                let square = TwoFloat::new_mul(xi[0], xi[0]) + TwoFloat::new_mul(xi[1], xi[1]);
                if f64::from(square) <= self.ratio * self.ratio * (1.0 + 1e-9) && !self.cuts(*a, *b) {
                    let stiffness = over(over(micromodulus, square.sqrt()), square);
                    bonds.push(Bond { ends: [i, j], xi, square, stiffness });
                }
            }
        }
        bonds
    }

    /// Load factor and displacements `[point][component]` under the load along y shared by the last column; the first one is
    /// held. None of a mechanism, and where it is not clear which bond breaks.
    pub(super) fn reference(&self) -> Option<(f64, Vec<[f64; 2]>)> {
        let mut bonds = self.bonds();
        let mut u = self.displacements(&bonds)?;
        let mut factor = 1.0;
        if let Way::Breaks(count) = self.way {
            for broken in 0..=count {
                let mut strained: Vec<(f64, usize)> = bonds
                    .iter()
                    .enumerate()
                    .filter(|(_, bond)| bond.ends.iter().all(|p| p % self.cells[0] != 0))
                    .map(|(k, bond)| (bond.stretch(&u), k))
                    .collect();
                strained.sort_by(|a, b| b.0.total_cmp(&a.0));
                let [(worst, bond), (next, _)] = strained[..2] else { return None };
                if worst <= 0.0 || next > worst * (1.0 - APART) {
                    return None;
                }
                factor = CRITICAL / worst;
                if broken < count {
                    bonds.remove(bond);
                    u = self.displacements(&bonds)?;
                }
            }
        }
        let times = |k: usize| factor * f64::from(u[k]);
        Some((factor, (0..u.len() / 2).map(|p| [times(2 * p), times(2 * p + 1)]).collect()))
    }

    fn displacements(&self, bonds: &[Bond]) -> Option<Vec<TwoFloat>> {
        let [nx, ny] = self.cells;
        let n = 2 * nx * ny;
        let mut matrix = vec![vec![TwoFloat::from(0.0); n]; n];
        for Bond { ends: [i, j], xi, stiffness, .. } in bonds {
            for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let value = *stiffness * xi[a] * xi[b];
                matrix[2 * i + a][2 * i + b] += value;
                matrix[2 * j + a][2 * j + b] += value;
                matrix[2 * i + a][2 * j + b] -= value;
                matrix[2 * j + a][2 * i + b] -= value;
            }
        }
        let mut rhs = vec![TwoFloat::from(0.0); n];
        for row in 0..ny {
            let last = row * nx + nx - 1;
            rhs[2 * last + 1] = over(TwoFloat::from(self.load), TwoFloat::from(ny as f64));
            for c in 0..2 {
                let held = 2 * row * nx + c;
                matrix[held] = vec![TwoFloat::from(0.0); n];
                matrix.iter_mut().for_each(|line| line[held] = TwoFloat::from(0.0));
                matrix[held][held] = TwoFloat::from(1.0);
                matrix[2 * last + c][2 * last + c] +=
                    over(TwoFloat::from(self.spring), TwoFloat::from(ny as f64));
            }
        }
        solved(matrix, rhs)
    }
}
