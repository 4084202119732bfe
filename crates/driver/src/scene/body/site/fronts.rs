//! Cracks as bonds are cut by them: their tips and fronts recede where the body goes on beyond them.

use super::symmetry::Symmetry;
use peristat_assembly::body::{CRACK_SLACK, Crack, PointBody, Recess};

/// By how much of the horizon a front recedes, so that its crack acts as long as it is: see [`Crack::receded`].
const SHARE: f64 = 0.1;

/// What cracks end in.
#[derive(Clone, Copy)]
pub(crate) struct Around<'a> {
    pub(crate) body: &'a PointBody,
    pub(crate) symmetry: &'a Symmetry,
    /// Horizon, m.
    pub(crate) horizon: f64,
}

impl Around<'_> {
    /// Some cracks as they cut bonds: with receded fronts.
    pub(super) fn receded(&self, cracks: &[Crack]) -> Vec<Crack> {
        let of = |own: usize| self.with_recess(own, cracks, |recess| cracks[own].receded(recess));
        (0..cracks.len()).map(of).collect()
    }

    /// What `find` gives with the recess of one of some cracks, by its number.
    pub(crate) fn with_recess<T>(&self, own: usize, cracks: &[Crack], find: impl Fn(&Recess) -> T) -> T {
        let by = SHARE * self.horizon;
        let whole = &cracks[own];
        let images = |cracks: &[Crack]| self.symmetry.with_images(cracks);
        let mut others = images(&[&cracks[..own], &cracks[own + 1..]].concat());
        // The first one is the crack itself.
        others.extend(images(std::slice::from_ref(whole)).into_iter().skip(1));
        let step = self.body.spacing();
        let goes_on = |at: [f64; 3], ahead: [f64; 3]| {
            let moved = |by: f64| [0, 1, 2].map(|k| at[k] + by * ahead[k]);
            self.holds(moved(step))
                && !meets_itself(whole, moved, step)
                && !others.iter().any(|other| is_met(other, moved, (by, step)))
        };
        find(&Recess { by, step, within: self.bounds(), goes_on: &goes_on })
    }

    /// Whether a place belongs to the body or to its image.
    fn holds(&self, at: [f64; 3]) -> bool {
        match &self.body {
            PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
                let is_plane = lattice.is_plane();
                let cell = if is_plane { lattice.cell_at([at[0], at[1]]) } else { lattice.cell_around(at) };
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

    /// Corners of a box that holds every bond of a solid, those to images too, m. Cracks in the plane need none.
    fn bounds(&self) -> [[f64; 3]; 2] {
        let (h, reach) = (self.body.spacing(), 2.0 * self.horizon);
        let [low, high] = match &self.body {
            PointBody::Lattice(_) => [[0.0; 3]; 2],
            PointBody::Solid(lattice) => {
                let ranges = [lattice.columns(), lattice.rows(), lattice.layers()];
                let at = |k: usize, cell: i32| lattice.corner()[k] + f64::from(cell) * h;
                [[0, 1, 2].map(|k| at(k, ranges[k].start)), [0, 1, 2].map(|k| at(k, ranges[k].end))]
            }
            PointBody::Cloud(cloud) => {
                let ends = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
                cloud.positions().iter().fold(ends, |[low, high], at| {
                    [[0, 1, 2].map(|k| low[k].min(at[k])), [0, 1, 2].map(|k| high[k].max(at[k]))]
                })
            }
        };
        // Images of fronts behind mirrors recede as they do.
        let at = self.symmetry.at;
        let image = |plane: Option<f64>, from: f64| plane.map_or(from, |plane| 2.0 * plane - from);
        let lows = [0, 1, 2].map(|k| low[k].min(image(at[2 * k], high[k])) - reach);
        let highs = [0, 1, 2].map(|k| high[k].max(image(at[2 * k + 1], low[k])) + reach);
        [lows, highs]
    }
}

/// Whether another crack, or an image, goes on where one ends, or crosses it within what it would recede by. `moved` gives places ahead of its end, m.
fn is_met(other: &Crack, moved: impl Fn(f64) -> [f64; 3], (by, step): (f64, f64)) -> bool {
    let slack = CRACK_SLACK * step;
    let touches = |at: [f64; 3]| other.cuts(at, at, slack);
    let (back, beyond) = (moved(-by), moved(3.0 * slack));
    // One that lies beside it all the way ends there, too.
    let is_along = touches(back) && touches(moved(0.0));
    other.cuts(beyond, moved(step), slack) || (!is_along && other.cuts(back, beyond, slack))
}

/// Whether a crack goes on where one of its parts ends: there it is no end.
fn meets_itself(own: &Crack, moved: impl Fn(f64) -> [f64; 3], step: f64) -> bool {
    let slack = CRACK_SLACK * step;
    let (end, beyond, next) = (moved(0.0), moved(3.0 * slack), moved(step));
    let is_end = |at: &[f64; 2]| (at[0] - end[0]).hypot(at[1] - end[1]) <= slack;
    let rest = own.vertices().windows(2).filter(|part| !part.iter().any(is_end));
    let mut rest = rest.filter_map(|part| Crack::new(part.to_vec()).ok());
    own.cuts(beyond, next, slack) || rest.any(|part| part.cuts(end, next, slack))
}
