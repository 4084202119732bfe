//! How far a crack has grown, from the damage of the bonds that cross the line ahead of its tip.

use crate::run::path::SofteningBonds;
use crate::scene::body::BodyScene;
use peristat_assembly::law::Law;

/// Damage of the bonds across a piece of the line, above which the crack has passed it.
const CRACKED: f64 = 0.5;

/// The line ahead of the tip of a crack, in pieces as long as the spacing.
#[derive(Clone, Debug)]
pub(super) struct Front {
    piece: f64,
    /// Of every piece, the bonds that cross it.
    crossing: Vec<Vec<u32>>,
}

impl Front {
    /// The line ahead of the first crack that has one tip in the body; none if there is no such crack.
    pub(super) fn new(scene: &BodyScene, bonds: &SofteningBonds<2>) -> Option<Self> {
        let piece = scene.spacing();
        let is_inside = |at: [f64; 2]| scene.outline().is_some_and(|o| o.contains(at));
        let found = scene.cracks.iter().find_map(|c| {
            let vertices = c.crack.vertices();
            let inside = [vertices[0], vertices[vertices.len() - 1]].map(is_inside);
            (inside[0] != inside[1]).then(|| {
                let mut path = vertices.to_vec();
                if inside[0] {
                    path.reverse();
                }
                path
            })
        })?;
        let [before, tip] = [found[found.len() - 2], found[found.len() - 1]];
        let last = [tip[0] - before[0], tip[1] - before[1]];
        let size = last[0].hypot(last[1]);
        let along = last.map(|v| v / size);
        let place = |p: u32| {
            let at = scene.model.place(p as usize);
            let d = [at[0] - tip[0], at[1] - tip[1]];
            [d[0] * along[0] + d[1] * along[1], d[1] * along[0] - d[0] * along[1]]
        };
        let mut crossing: Vec<Vec<u32>> = Vec::new();
        for (k, bond) in bonds.list().iter().enumerate() {
            let [a, b] = bond.points.map(place);
            if (a[1] < 0.0) == (b[1] < 0.0) {
                continue;
            }
            let at = a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]);
            if at > 0.0 {
                let number = (at / piece) as usize;
                if crossing.len() <= number {
                    crossing.resize(number + 1, Vec::new());
                }
                crossing[number].push(k as u32);
            }
        }
        Some(Self { piece, crossing })
    }

    /// How far the crack has grown: to where half of the stiffness across its line is gone, m.
    pub(super) fn growth(&self, bonds: &SofteningBonds<2>) -> f64 {
        let mut before = 1.0;
        for (number, crossing) in self.crossing.iter().enumerate() {
            let (mut sum, mut weight) = (0.0, 0.0);
            for &k in crossing {
                let (k, stiffness) = (k as usize, bonds.list()[k as usize].stiffness);
                sum += stiffness * bonds.law(k).damage(&bonds.history()[k]);
                weight += stiffness;
            }
            let here = if weight > 0.0 { sum / weight } else { before };
            if here < CRACKED {
                // Damage counts in the middle of a piece, and is whole at the tip.
                let from = if number == 0 { 0.0 } else { number as f64 - 0.5 };
                let part = if before > here { (before - CRACKED) / (before - here) } else { 0.0 };
                let step = if number == 0 { 0.5 } else { 1.0 };
                let grown = if number == 0 && here == 0.0 { 0.0 } else { from + part * step };
                return self.piece * grown;
            }
            before = here;
        }
        self.piece * self.crossing.len() as f64
    }
}
