//! Moments on rigid regions of solids.

use super::context::LoadContext;
use super::sums::BodyLoads;
use crate::case::PointLoad;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::hold::rigid_keys::centroid;
use peristat_assembly::system::inverse_of;

/// Adds forces on the points of a rigid region that have a moment about x, y and z, N m, and no resultant: `w × r` from their
/// centroid. How a rigid region shares what acts on it makes no difference.
pub(crate) fn add(
    moment: [f64; 3],
    load: &PointLoad,
    points: &[u32],
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let rigid = &context.ground.case.rigid;
    if !rigid.iter().any(|rigid| load.at.region.as_deref() == Some(rigid.region.as_str())) {
        let key = ["moment_x", "moment_y", "moment_z"][moment.iter().position(|m| *m != 0.0).unwrap_or(0)];
        faults.error(path.key(key), format!("`{key}` acts on a rigid region, and this is none")).hint(
            "list the region under `rigid`; on others use two forces, or a `linear` traction on a face",
        );
        return;
    }
    (0..3).for_each(|axis| to.asked.add_moment(axis, moment[axis]));
    let body = context.ground.body;
    let centre = centroid(points, body);
    let arm = |point: u32| {
        let at = body.position(point as usize);
        [0, 1, 2].map(|k| at[k] - centre[k])
    };
    let mut inertia = [[0.0; 3]; 3];
    for arm in points.iter().map(|&p| arm(p)) {
        let squared: f64 = arm.iter().map(|a| a * a).sum();
        for (row, own) in inertia.iter_mut().zip(arm) {
            row.iter_mut().zip(arm).for_each(|(sum, other)| *sum -= own * other);
        }
        (0..3).for_each(|k| inertia[k][k] += squared);
    }
    // That of points on one line has no inverse; such a region was refused.
    let Some(inverse) = inverse_of(inertia, &[false; 3]) else { return };
    let spin = inverse.map(|row| (0..3).map(|k| row[k] * moment[k]).sum::<f64>());
    to.forces.extend(points.iter().map(|&p| {
        let arm = arm(p);
        let cross = |k: usize| {
            let [next, last] = [(k + 1) % 3, (k + 2) % 3];
            spin[next] * arm[last] - spin[last] * arm[next]
        };
        (p, [0, 1, 2].map(cross))
    }));
}
