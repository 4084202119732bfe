//! Cracks as bonds are cut by them: their tips and fronts recede where the body goes on beyond them.

use super::symmetry::Symmetry;
use peristat_assembly::body::{CRACK_SLACK, Crack, PointBody, Recess};

/// By how much of the horizon a front recedes, so that its crack acts as long as it is: see [`Crack::receded`].
const SHARE: f64 = 0.1;

/// What cracks end in.
pub(super) struct Around<'a> {
    pub(super) body: &'a PointBody,
    pub(super) symmetry: &'a Symmetry,
    /// Horizon, m.
    pub(super) horizon: f64,
}

impl Around<'_> {
    /// Some cracks with receded fronts.
    pub(super) fn receded(&self, cracks: &[Crack]) -> Vec<Crack> {
        let within = self.bounds();
        let of = |(own, crack): (usize, &Crack)| {
            let goes_on = |at: [f64; 3], ahead: [f64; 3]| self.goes_on((own, cracks), at, ahead);
            let step = self.body.spacing();
            crack.receded(&Recess { by: SHARE * self.horizon, step, within, goes_on: &goes_on })
        };
        cracks.iter().enumerate().map(of).collect()
    }

    /// Whether the body goes on for a spacing beyond a place of the border of a crack: it has no edge, mirror or other crack there.
    fn goes_on(&self, (own, cracks): (usize, &[Crack]), at: [f64; 3], ahead: [f64; 3]) -> bool {
        let step = self.body.spacing();
        let moved = |by: f64| [0, 1, 2].map(|k| at[k] + by * ahead[k]);
        let (back, next) = (moved(-CRACK_SLACK * step), moved(step));
        let ends_at_mirror = self.symmetry.at.iter().enumerate().any(|(side, plane)| {
            let (axis, outwards) = (side / 2, if side % 2 == 0 { -1.0 } else { 1.0 });
            plane.is_some_and(|plane| (at[axis] - plane).abs() <= 0.5 * step && outwards * ahead[axis] > 0.5)
        });
        let others = || cracks.iter().enumerate().filter(|other| other.0 != own);
        !ends_at_mirror
            && self.holds(next)
            && !others().any(|(_, other)| other.cuts(back, next, CRACK_SLACK * step))
    }

    /// Whether a place belongs to the body or to its image.
    fn holds(&self, at: [f64; 3]) -> bool {
        match &self.body {
            PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
                let cell = if lattice.is_plane() {
                    lattice.cell_at([at[0], at[1]])
                } else {
                    lattice.cell_around(at)
                };
                lattice.number(self.symmetry.mirrors.image(cell).0).is_some()
            }
            PointBody::Cloud(cloud) => {
                let near = |place: &[f64; 3]| {
                    (0..3).map(|k| (place[k] - at[k]).powi(2)).sum::<f64>() <= cloud.spacing().powi(2)
                };
                cloud.positions().iter().any(near)
            }
        }
    }

    /// Corners of a box that holds every bond, those to images too, m.
    fn bounds(&self) -> [[f64; 3]; 2] {
        let step = 2.0 * self.horizon;
        let places = (0..self.body.points()).map(|point| self.body.position(point));
        let [low, high] = places.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], at| {
            [[0, 1, 2].map(|k| low[k].min(at[k])), [0, 1, 2].map(|k| high[k].max(at[k]))]
        });
        [low.map(|x| x - step), high.map(|x| x + step)]
    }
}
