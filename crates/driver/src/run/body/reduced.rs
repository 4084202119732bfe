//! What is made of a field over a region or the whole of a body.

use super::BodyResult;
use crate::case::{FieldName, Reduction};
use crate::run::reducer::{Reduced, Reducer};
use crate::scene::body::BodyScene;

/// What is made of a field at some points of the body, or at all; the place is a point. None where the field was not
/// recovered.
pub(super) fn read(
    scene: &BodyScene,
    result: &BodyResult,
    field: FieldName,
    of: Reduction,
    points: Option<&[u32]>,
) -> Option<Reduced<usize>> {
    let mut reducer = Reducer::new(of);
    let mut take = |value: f64, point: usize| {
        reducer.take(value, point, |point| scene.model.volume(scene.number(point)));
    };
    match points {
        None => {
            let values = result.values(scene, field)?;
            values.iter().enumerate().for_each(|(point, value)| take(*value, point));
        }
        Some(points) => {
            for point in points.iter().map(|&p| p as usize) {
                take(result.value(scene, field, &[(scene.number(point) as u32, 1.0)])?, point);
            }
        }
    }
    reducer.found()
}
