//! Critical stretches of bonds and the energy that a crack through a lattice releases.
//!
//! A straight crack of normal n through a lattice of spacing h cuts `|ξ·n|/h²` bonds of each half offset per length. At a
//! stretch s a bond keeps `½ a V s²`, `V = h² t`, so the crack releases `G = Σ ½ a s² |ξ·n|` per area if all bonds that it
//! cuts break at their critical stretch. This is exact for the lattice; formulas of the continuum differ from it.

use crate::body::Cell;

/// Energy release rate `G = Σ ½ a s² |ξ·n|`, J/m², of a crack through a lattice of a spacing, m.
///
/// `weights` (Pa) and `critical` stretches belong to the half `offsets`; the unit `normal` of the crack is in the axes of
/// the lattice.
pub fn energy_release_rate(
    weights: &[f64],
    offsets: &[Cell],
    spacing: f64,
    critical: &[f64],
    normal: [f64; 2],
) -> f64 {
    let cut = crossing(weights, offsets, spacing, normal);
    cut.zip(critical).map(|(crossing, s)| 0.5 * crossing * s * s).sum()
}

/// Critical stretch `s = √(2G/Σ a |ξ·n|)` with which a lattice of one class of bonds has the energy release rate `G`, J/m²;
/// zero if the crack cuts no bonds. The other arguments are those of [`energy_release_rate`].
pub fn critical_stretch(
    release_rate: f64,
    weights: &[f64],
    offsets: &[Cell],
    spacing: f64,
    normal: [f64; 2],
) -> f64 {
    let sum: f64 = crossing(weights, offsets, spacing, normal).sum();
    if sum > 0.0 { (2.0 * release_rate / sum).sqrt() } else { 0.0 }
}

/// The bonds that a crack between rows of a lattice cuts, by the rows that they pass.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossingBonds {
    /// Sums of weights, of bonds that pass one row, two, and so on.
    weights: Vec<f64>,
}

impl CrossingBonds {
    /// Those of half `offsets` with their `weights`.
    pub fn new(weights: &[f64], offsets: &[Cell]) -> Self {
        let most = offsets.iter().map(|step| step[1].unsigned_abs() as usize).max().unwrap_or(0);
        let mut by_rows = vec![0.0; most];
        for (weight, step) in weights.iter().zip(offsets).filter(|(_, step)| step[1] != 0) {
            by_rows[step[1].unsigned_abs() as usize - 1] += weight;
        }
        Self { weights: by_rows }
    }

    /// How many times the energy of one in the base material a crack takes along the interface of two others, at the same stretch of
    /// the bonds that it cuts: `Σ f a |ξ·n|/Σ a |ξ·n|`, with the modulus f of a bond through both, in series but no more than their
    /// mean, wherever along it the interface is. `moduli` are those of the two over that of the base.
    pub fn factor(&self, [first, second]: [f64; 2]) -> f64 {
        let (mut mixed, mut base) = (0.0, 0.0);
        for (rows, weight) in (1_u32..).zip(&self.weights) {
            for row in 0..rows {
                let part = (f64::from(row) + 0.5) / f64::from(rows);
                let series = 1.0 / (part / first + (1.0 - part) / second);
                mixed += weight * series.min(0.5 * (first + second));
                base += weight;
            }
        }
        if base > 0.0 { mixed / base } else { 1.0 }
    }
}

/// Critical stretch `s = √(4πG/(9Eδ))` of the continuum of central bonds in plane stress, with `G` in J/m², `E` in Pa, δ in m.
pub fn published_critical_stretch(release_rate: f64, youngs_modulus: f64, horizon: f64) -> f64 {
    (4.0 * std::f64::consts::PI * release_rate / (9.0 * youngs_modulus * horizon)).sqrt()
}

/// `a |ξ·n|` per half offset, N/m.
fn crossing<'a>(
    weights: &'a [f64],
    offsets: &'a [Cell],
    spacing: f64,
    [nx, ny]: [f64; 2],
) -> impl Iterator<Item = f64> + 'a {
    let across = move |[a, b, _]: Cell| spacing * (f64::from(a) * nx + f64::from(b) * ny).abs();
    weights.iter().zip(offsets).map(move |(weight, &step)| weight * across(step))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Energy of the bonds that cross the line between rows 0 and −1 of a lattice 40 cells wide, per length of crack and
    /// thickness, bond by bond.
    fn counted(weights: &[f64], offsets: &[Cell], spacing: f64, s: f64) -> f64 {
        let columns = 40;
        let mut energy = 0.0;
        for (weight, step) in weights.iter().zip(offsets) {
            let lower = (-9..9).filter(|j| *j < 0 && j + step[1] >= 0).count();
            energy += 0.5 * weight * spacing * spacing * s * s * (lower * columns) as f64;
        }
        energy / (columns as f64 * spacing)
    }

    const OFFSETS: [Cell; 6] = [[1, 0, 0], [0, 1, 0], [1, 1, 0], [-1, 1, 0], [2, 1, 0], [-1, 2, 0]];
    const WEIGHTS: [f64; 6] = [3.0e9, 2.0e9, 1.5e9, 1.0e9, 0.7e9, 0.4e9];

    #[test]
    fn a_straight_crack_releases_the_energy_of_its_bonds() {
        let (spacing, s) = (2.0e-3, 0.013);
        let found = energy_release_rate(&WEIGHTS, &OFFSETS, spacing, &[s; 6], [0.0, 1.0]);
        let expected = counted(&WEIGHTS, &OFFSETS, spacing, s);
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    }

    #[test]
    fn the_critical_stretch_releases_what_it_was_made_for() {
        let normal = [0.6, -0.8];
        let s = critical_stretch(250.0, &WEIGHTS, &OFFSETS, 1.0e-3, normal);
        let back = energy_release_rate(&WEIGHTS, &OFFSETS, 1.0e-3, &[s; 6], normal);
        assert!((back / 250.0 - 1.0).abs() < 1e-14);
        assert_eq!(critical_stretch(250.0, &[1.0], &[[1, 0, 0]], 1.0e-3, [0.0, 1.0]), 0.0);
    }

    #[test]
    fn a_fine_lattice_of_the_continuum_has_its_toughness() {
        // Weights c V ξ with c = 9E/(π t δ³), ν = 1/3, on a lattice of m = 40: 2.3e-4 below the continuum here.
        let (m, youngs, rate) = (40.0_f64, 70.0e9, 100.0);
        let all = (0..=40).flat_map(|b: i32| (-40..=40).map(move |a: i32| [a, b, 0]));
        let offsets: Vec<Cell> =
            all.filter(|s| (s[1] > 0 || s[0] > 0) && s[0] * s[0] + s[1] * s[1] <= 1600).collect();
        let length = |[a, b, _]: Cell| f64::from(a * a + b * b).sqrt();
        let c = 9.0 * youngs / (std::f64::consts::PI * m.powi(3));
        let weights: Vec<f64> = offsets.iter().map(|&s| c * length(s)).collect();
        let spacing = 1.0e-4;
        let discrete = critical_stretch(rate, &weights, &offsets, spacing, [0.0, 1.0]);
        let published = published_critical_stretch(rate, youngs, m * spacing);
        assert!((discrete / published - 1.0).abs() < 5e-4, "{}", discrete / published);
    }
}
