//! What follows from the moments of a point.

use crate::case::{Origin, PlateOrigin};
use std::f64::consts::FRAC_PI_2;

/// Stresses on the side of +w, which positive moments compress, in a plate of a thickness: `σ = −6 M/t²`.
pub(super) fn stresses(moment: [f64; 3], thickness: f64) -> [f64; 3] {
    moment.map(|m| -6.0 * m / (thickness * thickness))
}

/// A field that follows from moments `[M_xx, M_yy, M_xy]` per width and stresses; none if it is another one.
pub(super) fn of_moments(origin: Origin, moment: [f64; 3], stress: [f64; 3]) -> Option<f64> {
    let [xx, yy, xy] = moment;
    Some(match origin {
        Origin::Plate(PlateOrigin::Moment(k)) => moment[k],
        Origin::Plate(PlateOrigin::Principal(k)) => principal(moment)[k],
        Origin::Plate(PlateOrigin::Direction) => {
            let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
            if angle <= -FRAC_PI_2 { FRAC_PI_2 } else { angle }
        }
        Origin::Plate(PlateOrigin::Design(k)) => {
            let sign = if k < 2 { 1.0 } else { -1.0 };
            wood_armer([sign * xx, sign * yy], xy.abs())[k % 2]
        }
        Origin::Stress("xx") => stress[0],
        Origin::Stress("yy") => stress[1],
        Origin::Stress("xy") => stress[2],
        Origin::VonMises => {
            let [x, y, s] = stress;
            (x * x - x * y + y * y + 3.0 * s * s).sqrt()
        }
        _ => return None,
    })
}

/// The larger and the smaller principal moment.
fn principal([xx, yy, xy]: [f64; 3]) -> [f64; 2] {
    let (middle, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    [middle + radius, middle - radius]
}

/// Moments for which reinforcement along x and y is designed that is stretched by positive moments (R. H. Wood, Concrete 2 (1968)
/// 69-76): `M_x + |M_xy|` and `M_y + |M_xy|`; where one of them is not positive none is needed, and the other is
/// `M + M_xy²/|M|` of the two.
fn wood_armer([x, y]: [f64; 2], twist: f64) -> [f64; 2] {
    match (x + twist > 0.0, y + twist > 0.0) {
        (true, true) => [x + twist, y + twist],
        (true, false) => [(x + twist * twist / y.abs()).max(0.0), 0.0],
        (false, true) => [0.0, (y + twist * twist / x.abs()).max(0.0)],
        (false, false) => [0.0; 2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_of_design_are_those_of_wood() {
        // Sagging in both directions, in one, and hogging.
        assert_eq!(wood_armer([10.0, 4.0], 3.0), [13.0, 7.0]);
        assert_eq!(wood_armer([10.0, -6.0], 3.0), [11.5, 0.0]);
        assert_eq!(wood_armer([-6.0, 10.0], 3.0), [0.0, 11.5]);
        assert_eq!(wood_armer([-6.0, -8.0], 3.0), [0.0, 0.0]);
        assert_eq!(wood_armer([0.0, 0.0], 2.0), [2.0, 2.0]);
    }

    #[test]
    fn principal_moments_and_stresses_follow_from_moments() {
        const MOMENT: [f64; 3] = [3.0, 1.0, 1.0];
        let of = |origin| of_moments(origin, MOMENT, stresses(MOMENT, 2.0)).unwrap();
        let root = 2.0_f64.sqrt();
        assert!((of(Origin::Plate(PlateOrigin::Principal(0))) - 2.0 - root).abs() < 1e-15);
        assert!((of(Origin::Plate(PlateOrigin::Principal(1))) - 2.0 + root).abs() < 1e-15);
        assert!((of(Origin::Plate(PlateOrigin::Direction)) - std::f64::consts::FRAC_PI_8).abs() < 1e-15);
        assert_eq!(of(Origin::Stress("xx")), -4.5);
        assert!((of(Origin::VonMises) - 1.5 * 10.0_f64.sqrt()).abs() < 1e-14);
        assert_eq!(of_moments(Origin::Energy, [0.0; 3], [0.0; 3]), None);
    }
}
