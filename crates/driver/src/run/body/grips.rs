//! Whether a body that softens does so only where it is held.

use crate::diagnostic::{Faults, JsonPath};
use crate::run::path::SofteningBonds;
use crate::scene::body::BodyScene;
use peristat_assembly::law::Law;

/// Ends of the bonds that have softened.
pub(super) fn softened(bonds: &SofteningBonds<2>) -> Vec<[usize; 2]> {
    let all = bonds.list().iter().zip(bonds.history()).enumerate();
    let softened = all.filter(|(k, (_, history))| bonds.law(*k).damage(history) > 0.0);
    softened.map(|(_, (bond, _))| bond.points.map(|p| p as usize)).collect()
}

/// Warns where all bonds that have softened, given by their ends, lie within a horizon of what is held.
pub(super) fn tell(scene: &BodyScene, softened: &[[usize; 2]], warnings: &mut Faults) {
    // What holds most of a body, such as one whose points move along x alone, is no grip.
    let most = scene.model.points() / 2;
    let holds = scene.conditions.holds.iter().map(|h| &h.points);
    let groups = holds.chain(scene.conditions.rigid.iter().map(|r| &r.points)).filter(|g| g.len() <= most);
    let held: Vec<[f64; 2]> = groups.flatten().map(|&p| scene.model.place(p as usize)).collect();
    let reach = scene.horizon() * (1.0 + 1e-9);
    let is_near = |point: usize| {
        let [x, y] = scene.model.place(point);
        held.iter().any(|[a, b]| (a - x).hypot(b - y) <= reach)
    };
    if softened.is_empty() || softened.iter().any(|ends| !ends.iter().any(|&end| is_near(end))) {
        return;
    }
    warnings
        .warning(
            JsonPath::default().key("path"),
            "all damage lies within a horizon of what is held: the body fails in its grips, not by its own strength",
        )
        .hint("list regions a horizon deep and more around what is held under `no_damage`");
}
