//! Bearings as cases give them.

use super::rigid::RigidPoints;
use crate::case::Case;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::site::bearing::Bearing;

/// Bearings of the case; `rigid` are its regions by numbers of the body.
pub(crate) fn bearings(case: &Case, rigid: &[RigidPoints], faults: &mut Faults) -> Vec<Bearing> {
    let mut bearings = Vec::new();
    for (k, given) in case.rigid.iter().enumerate() {
        let Some(bearing) = given.bearing else { continue };
        let path = root("rigid").index(k);
        let found = resolve(bearing.direction, bearing.half_angle, &path.key("bearing"), faults);
        let origin = path.to_string();
        let region = rigid.iter().find(|r| r.origin == origin);
        if let (Some((direction, cosine)), Some(region)) = (found, region) {
            bearings.push(Bearing {
                points: region.points.clone(),
                centre: [region.centre[0], region.centre[1]],
                direction,
                cosine,
            });
        }
    }
    bearings
}

/// Direction and cosine of the half angle; none where the region bears all around.
fn resolve(
    direction: [f64; 2],
    half_angle: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<([f64; 2], f64)> {
    let length = direction[0].hypot(direction[1]);
    if length == 0.0 {
        faults
            .error(path.key("direction"), "`direction` has no length")
            .hint("it is where the region presses: [0, 1] is upwards");
        return None;
    }
    if !(half_angle > 0.0 && half_angle <= 180.0) {
        faults
            .error(
                path.key("half_angle"),
                format!("`half_angle` must be above 0 and at most 180 degrees, found {half_angle}"),
            )
            .hint("60 is a pin in its hole, 180 a pin that is glued all around");
        return None;
    }
    (half_angle < 180.0).then(|| (direction.map(|d| d / length), half_angle.to_radians().cos()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_around_is_no_bearing_and_directions_have_any_length() {
        let of = |angle: f64| resolve([0.0, 2.0], angle, &JsonPath::default(), &mut Faults::default());
        assert!(of(180.0).is_none());
        // cos 60 degrees.
        let (direction, cosine) = of(60.0).unwrap();
        assert!(direction == [0.0, 1.0] && (cosine - 0.5).abs() < 1e-15);
    }
}
