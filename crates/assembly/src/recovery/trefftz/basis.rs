//! Polynomials in equilibrium.

use nalgebra::{DMatrix, DVector, MatrixXx2, MatrixXx3};

/// Singular values of the divergence that are smaller, relative to the largest, are zero: the next ones are 0.05 and more.
const NONE: f64 = 1e-10;

/// Displacements that are polynomials and whose stresses have no divergence: an orthonormal basis, in a place relative to a
/// centre over a radius. Rotations are per radius, stresses also per stiffness, the first entry of the matrix.
#[derive(Clone, Debug)]
pub struct Basis {
    powers: Vec<[i32; 2]>,
    /// Coefficients of the powers in ux and uy, one column per field.
    displacement: DMatrix<f64>,
    by_power: Tables,
    unit: f64,
}

/// Coefficients with one column per power, in which all fields of a component lie together: as a place needs them.
#[derive(Clone, Debug)]
struct Tables {
    /// Of ux and uy.
    displacements: DMatrix<f64>,
    rotations: DMatrix<f64>,
    /// Of σ_xx, σ_yy and σ_xy.
    stresses: DMatrix<f64>,
}

impl Basis {
    /// Up to a degree, for a material of this stiffness, Pa, from strains `[ε_xx, ε_yy, γ_xy]` to stresses.
    pub fn new(stiffness: &[[f64; 3]; 3], degree: i32) -> Self {
        let powers: Vec<[i32; 2]> = (0..=degree).flat_map(|d| (0..=d).map(move |b| [d - b, b])).collect();
        let unit = stiffness[0][0];
        let all = DMatrix::identity(2 * powers.len(), 2 * powers.len());
        let divergence = divergence(&powers, &stresses(&powers, &all, stiffness, unit));
        // With rows of zeros it is square, and has all of its singular vectors.
        let square = divergence.resize_vertically(2 * powers.len(), 0.0);
        let svd = square.svd(false, true);
        let least = NONE * svd.singular_values.max();
        let vectors = svd.v_t.unwrap_or_else(|| all.clone());
        let free = (0..vectors.nrows()).filter(|k| svd.singular_values[*k] <= least);
        let columns: Vec<DVector<f64>> = free.map(|k| vectors.row(k).transpose()).collect();
        let displacement = DMatrix::from_columns(&columns);
        let stress = stresses(&powers, &displacement, stiffness, unit);
        let n = powers.len();
        let rotation = 0.5 * (derived(&powers, &displacement, n, 0) - derived(&powers, &displacement, 0, 1));
        // Derivatives have no power of the highest degree.
        let lower = n - degree as usize - 1;
        let by_power = Tables {
            displacements: by_power(&displacement, 2, n),
            rotations: by_power(&rotation, 1, lower),
            stresses: by_power(&stress, 3, lower),
        };
        Self { powers, displacement, by_power, unit }
    }

    /// Number of fields.
    pub fn count(&self) -> usize {
        self.displacement.ncols()
    }

    /// Its fields up to a lower degree: their coefficients, one column each.
    pub fn lower(&self, stiffness: &[[f64; 3]; 3], degree: i32) -> DMatrix<f64> {
        let low = Self::new(stiffness, degree);
        let (n, few) = (self.powers.len(), low.powers.len());
        // Powers are in the order of their degree, and columns are orthonormal.
        let shared = |component: usize| {
            let own = self.displacement.rows(component * n, few);
            own.tr_mul(&low.displacement.rows(component * few, few))
        };
        shared(0) + shared(1)
    }

    /// The stiffness that stresses are per, Pa.
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// Displacements of all fields at a place, one column each along x and y.
    pub fn displacements(&self, at: [f64; 2]) -> MatrixXx2<f64> {
        MatrixXx2::from_vec(self.values(&self.by_power.displacements, at))
    }

    /// Rotations `½ (∂u_y/∂x − ∂u_x/∂y)` of all fields at a place.
    pub fn rotations(&self, at: [f64; 2]) -> DVector<f64> {
        DVector::from_vec(self.values(&self.by_power.rotations, at))
    }

    /// Stresses of all fields at a place, one column each of σ_xx, σ_yy, σ_xy.
    pub fn stresses(&self, at: [f64; 2]) -> MatrixXx3<f64> {
        MatrixXx3::from_vec(self.values(&self.by_power.stresses, at))
    }

    /// What a table says at a place.
    fn values(&self, table: &DMatrix<f64>, [x, y]: [f64; 2]) -> Vec<f64> {
        let mut powers: Vec<f64> = Vec::with_capacity(self.powers.len());
        let mut values = vec![0.0; table.nrows()];
        for ([a, b], column) in self.powers.iter().zip(table.as_slice().chunks_exact(table.nrows())) {
            // The powers of a degree follow from those of the degree below, which come just before them.
            let (degree, k) = ((a + b) as usize, powers.len());
            let power = match (a, b) {
                (0, 0) => 1.0,
                (0, _) => y * powers[k - degree - 1],
                _ => x * powers[k - degree],
            };
            powers.push(power);
            values.iter_mut().zip(column).for_each(|(value, c)| *value += power * c);
        }
        values
    }
}

/// The first powers of coefficients that have one column per field and the powers of a component below each other: one column
/// per power, with the fields of a component below each other.
fn by_power(of: &DMatrix<f64>, components: usize, first: usize) -> DMatrix<f64> {
    let (n, count) = (of.nrows() / components, of.ncols());
    DMatrix::from_fn(components * count, first, |k, power| of[(k / count * n + power, k % count)])
}

/// The derivative of polynomials along an axis: those of a component are rows from `first`.
fn derived(powers: &[[i32; 2]], of: &DMatrix<f64>, first: usize, axis: usize) -> DMatrix<f64> {
    let mut derivative = DMatrix::zeros(powers.len(), of.ncols());
    for (k, power) in powers.iter().enumerate().filter(|(_, power)| power[axis] > 0) {
        let mut lower = *power;
        lower[axis] -= 1;
        if let Some(to) = powers.iter().position(|p| *p == lower) {
            let mut row = derivative.row_mut(to);
            row += f64::from(power[axis]) * of.row(first + k);
        }
    }
    derivative
}

/// Stresses of displacements, per `unit`.
fn stresses(powers: &[[i32; 2]], of: &DMatrix<f64>, stiffness: &[[f64; 3]; 3], unit: f64) -> DMatrix<f64> {
    let n = powers.len();
    let shear = derived(powers, of, 0, 1) + derived(powers, of, n, 0);
    let strains = [derived(powers, of, 0, 0), derived(powers, of, n, 1), shear];
    let mut stress = DMatrix::zeros(3 * n, of.ncols());
    for (r, row) in stiffness.iter().enumerate() {
        for (share, strain) in row.iter().zip(&strains) {
            let mut rows = stress.rows_mut(r * n, n);
            rows += *share / unit * strain;
        }
    }
    stress
}

/// The divergence of stresses.
fn divergence(powers: &[[i32; 2]], of: &DMatrix<f64>) -> DMatrix<f64> {
    let n = powers.len();
    let mut all = DMatrix::zeros(2 * n, of.ncols());
    all.rows_mut(0, n).copy_from(&(derived(powers, of, 0, 0) + derived(powers, of, 2 * n, 1)));
    all.rows_mut(n, n).copy_from(&(derived(powers, of, 2 * n, 0) + derived(powers, of, n, 1)));
    all
}
