//! Lattice trapping: what a lattice adds to the toughness of its bonds.
//!
//! A crack in a lattice breaks one bond after the other, and each holds it back until it breaks. If the bonds that it cuts
//! keep just Griffith's energy, a long crack therefore grows at a larger motion than Griffith's, however fine the grid is.
//! The excess depends on the bonds and, from three spacings per horizon on, hardly on the direction.
//!
//! Measured on ribbons between grips, whose energy release rate does not depend on the length of the crack: 60 × 20
//! spacings (72 × 30 from m = 5 on), the largest motion on the way of a crack at 0°, 45° and 30° to the rows, bonds broken
//! one by one; with five spacings at 0° and 45°. Plane stress and plane strain have the same.
//!
//! | m | `constant` | `inverse` | `linear` | `isotropic`, `constant` |
//! |---|---|---|---|---|
//! | 2 | 1.96, 1.50, 1.47 | 1.98, 1.52, 1.64 | 1.62, 1.73, 1.69 | 2.27, 1.70, 2.5 or more |
//! | 3 | 1.24, 1.21, 1.16 | 1.20, 1.24, 1.21 | 1.27, 1.31, 1.25 | 1.46, 1.24, 1.24 |
//! | 4 | 1.14, 1.11, 1.08 | 1.16, 1.09, 1.10 | 1.21, 1.12, 1.15 | 1.13, 1.14, 1.13 |
//! | 5 | 1.07, 1.07 | 1.18, 1.03 | 1.11, 1.03 | 1.09, 1.05 |
//!
//! At 30° the place of the crack between the rows matters: the nearest bonds with `constant` and m = 3 have 1.31 at that of the last
//! column.

use super::{Influence, PlaneParameters, Weights};

/// Horizon ratios of the table.
const RATIOS: [f64; 4] = [2.0, 3.0, 4.0, 5.0];

/// Motion at which a long crack grows over Griffith's where bonds break at the stretch of
/// [`critical_stretch`](super::critical_stretch): means over directions of the table above, between its ratios on straight
/// lines and beyond them as at its end. Directions differ from it by up to 20 % at
/// m = 2, else by up to 7 %, with the influence `constant` by 4 %, with isotropic weights and m = 3 by 11 %.
pub(super) fn trapping(parameters: &PlaneParameters) -> f64 {
    let horizon_ratio = parameters.horizon_ratio;
    let means = match (parameters.weights, parameters.influence) {
        (Weights::Isotropic, _) => [2.16, 1.31, 1.13, 1.07],
        (Weights::Nearest, Influence::Constant) => [1.64, 1.20, 1.11, 1.07],
        (Weights::Nearest, Influence::Inverse) => [1.71, 1.21, 1.12, 1.10],
        (Weights::Nearest, Influence::Linear) => [1.68, 1.28, 1.16, 1.07],
    };
    let after = RATIOS.partition_point(|ratio| *ratio <= horizon_ratio).clamp(1, RATIOS.len() - 1);
    let (from, to) = (RATIOS[after - 1], RATIOS[after]);
    let part = ((horizon_ratio - from) / (to - from)).clamp(0.0, 1.0);
    means[after - 1] + part * (means[after] - means[after - 1])
}
