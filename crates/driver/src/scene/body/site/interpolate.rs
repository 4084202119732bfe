//! Values at any position as sums over points.

use super::{fit, listed};
use peristat_assembly::body::{CRACK_SLACK, Cell, Crack, PointBody, SquareLattice, in_space};

/// How far points are in each direction that are fitted, spacings.
const AROUND: f64 = 2.0;

/// Points and their shares; the shares sum to one.
pub type Weights = Vec<(u32, f64)>;

/// What values are interpolated on.
pub(crate) struct Interpolation<'a> {
    /// The points; images in mirrors are among them.
    pub(crate) body: &'a PointBody,
    /// Cracks and their images.
    pub(crate) cracks: &'a [Crack],
    /// How far apart points are whose values are continued to an edge, spacings: the horizon, where points see the steps of the edge.
    pub(crate) reach: i32,
}

impl Interpolation<'_> {
    /// Weights at a position in the body: linear along each axis between the four points of a lattice around it, eight of a solid,
    /// or next to it near an edge; linear in a triangle or a tetrahedron of listed points. Where cracks leave no such points on the side of
    /// the position, those around it that are on it are fitted, or the nearest of them is taken. `nearest` is that of all.
    pub(crate) fn at(&self, at: [f64; 3], nearest: u32) -> Weights {
        let position = [at[0], at[1]];
        let found = match self.body {
            PointBody::Solid(lattice) => self.trilinear(lattice, at),
            PointBody::Lattice(lattice) => self.bilinear(lattice, position),
            PointBody::Cloud(cloud) => listed::weights(cloud, self.body, at, &|point| self.sees(at, point)),
        };
        found.or_else(|| self.beside_crack(at)).unwrap_or_else(|| vec![(nearest, 1.0)])
    }

    /// Weights of the points around a position that it sees; `None` where it sees all.
    fn beside_crack(&self, at: [f64; 3]) -> Option<Weights> {
        if self.cracks.is_empty() {
            return None;
        }
        let near = |point: usize| -> Option<(u32, [f64; 3])> {
            let place = self.body.position(point);
            let step = [0, 1, 2].map(|k| (place[k] - at[k]) / self.body.spacing());
            step.iter().all(|s| s.abs() <= AROUND).then_some((point as u32, step))
        };
        let all: Vec<(u32, [f64; 3])> = (0..self.body.points()).filter_map(near).collect();
        let is_seen = |near: &&(u32, [f64; 3])| self.sees(at, self.body.position(near.0 as usize));
        let seen: Vec<(u32, [f64; 3])> = all.iter().filter(is_seen).copied().collect();
        if seen.len() == all.len() {
            return None;
        }
        let far = |step: &[f64; 3]| step.iter().map(|s| s * s).sum::<f64>();
        let alone = || {
            let nearest = seen.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
            nearest.map(|(point, _)| vec![(*point, 1.0)])
        };
        fit::linear(&seen).or_else(alone)
    }

    fn sees(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        let slack = CRACK_SLACK * self.body.spacing();
        !self.cracks.iter().any(|c| c.cuts(a, b, slack))
    }

    fn bilinear(&self, lattice: &SquareLattice, position: [f64; 2]) -> Option<Weights> {
        let at = lattice.in_cells(position).map(|x| x - 0.5);
        let low = at.map(f64::floor);
        // Beyond the outermost points lies half a cell at most; where an edge runs obliquely to the rows, more.
        let (steps, most): (&[f64], f64) = match lattice.is_turned() {
            false => (&[0.0, -1.0, 1.0], 1.0),
            true => (&[0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0], 3.0),
        };
        let mut blocks: Vec<[f64; 2]> =
            steps.iter().flat_map(|a| steps.iter().map(move |b| [low[0] + a, low[1] + b])).collect();
        blocks.retain(|b| (0..2).all(|k| (at[k] - b[k] - 0.5).abs() <= most + 1e-6));
        let far = |b: &[f64; 2]| (at[0] - b[0] - 0.5).hypot(at[1] - b[1] - 0.5);
        blocks.sort_by(|a, b| far(a).total_cmp(&far(b)));
        blocks.into_iter().find_map(|block| {
            let share = [0, 1].map(|k| at[k] - block[k]);
            let corner = |[i, j]: [usize; 2]| {
                let cell: Cell = [block[0] as i32 + i as i32, block[1] as i32 + j as i32, 0];
                let point = lattice.number(cell)?;
                let seen = self.sees(in_space(position), lattice.centre(cell));
                let along = |k: usize, side: usize| if side == 1 { share[k] } else { 1.0 - share[k] };
                seen.then_some((point as u32, along(0, i) * along(1, j)))
            };
            let corners: Option<Weights> = [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().map(corner).collect();
            corners.map(|all| all.into_iter().filter(|w| w.1 != 0.0).collect())
        })
    }

    /// Weights at a position on an edge: a parabola through three points on each of the two lattice lines beside it that go
    /// inward, one, two and three times `reach` behind the first. On narrow bodies
    /// the three are closer together; `None` where no line has three points behind the first, and on a turned lattice,
    /// whose lines do not go inward.
    pub(crate) fn inward(&self, position: [f64; 2], inward: [i8; 2]) -> Option<Weights> {
        let PointBody::Lattice(lattice) = self.body else { return None };
        if lattice.is_turned() {
            return None;
        }
        let axis = usize::from(inward[0] == 0);
        let sign = i32::from(inward[axis]);
        let at = lattice.in_cells(position).map(|x| x - 0.5);
        let across = at[1 - axis];
        let low = across.floor();
        let line = |column: f64| {
            let cell: Cell = [column as i32, column as i32, 0];
            self.row(lattice, cell, (axis, sign), at[axis])
        };
        // The two lines around the position, or beside it next to another edge, or the one that there is.
        let pair = |first: f64| {
            let share = across - first;
            let both = [(first, 1.0 - share), (first + 1.0, share)];
            both.into_iter()
                .filter(|l| l.1.abs() > 1e-9)
                .map(|(at, share)| Some((line(at)?, share)))
                .collect()
        };
        let pairs = [low, low + 1.0, low - 1.0];
        let alone = || [low, low + 1.0].into_iter().find_map(|at| Some(vec![(line(at)?, 1.0)]));
        let found: Vec<(Weights, f64)> = pairs.into_iter().find_map(pair).or_else(alone)?;
        Some(
            found
                .iter()
                .flat_map(|(weights, share)| weights.iter().map(move |w| (w.0, w.1 * share)))
                .collect(),
        )
    }

    /// The parabola of [`Self::inward`] along the row of a cell that runs inward, by an axis and a sign, from a place on the row, in
    /// spacings from the first centre.
    pub(crate) fn row(
        &self,
        lattice: &SquareLattice,
        row: Cell,
        (axis, sign): (usize, i32),
        at: f64,
    ) -> Option<Weights> {
        let number = |k: i32| {
            let mut cell = row;
            cell[axis] = k;
            lattice.number(cell)
        };
        let start = if sign > 0 { (at - 1e-6).ceil() } else { (at + 1e-6).floor() } as i32;
        let first = (0..3).map(|k| start + sign * k).find(|&k| number(k).is_some())?;
        let distance = |k: i32| f64::from(sign) * (f64::from(k) - at);
        let exists = |step: &i32| (1..=3).all(|k| number(first + sign * k * step).is_some());
        let step = (1..=self.reach).rev().find(exists)?;
        let cells = [1, 2, 3].map(|k| first + sign * k * step);
        let weight = |k: usize| {
            let others = (0..3).filter(|j| *j != k);
            let share = |j: usize| distance(cells[j]) / (distance(cells[j]) - distance(cells[k]));
            others.map(share).product::<f64>()
        };
        (0..3).map(|k| Some((number(cells[k])? as u32, weight(k)))).collect()
    }

    /// Weights of the eight points around a position in a solid, or of the block of points that is nearest to it, on its side of
    /// cracks.
    fn trilinear(&self, lattice: &SquareLattice, at: [f64; 3]) -> Option<Weights> {
        let corner = lattice.corner();
        let position = at;
        let at = [0, 1, 2].map(|k| (at[k] - corner[k]) / lattice.spacing() - 0.5);
        let low = at.map(f64::floor);
        let steps = || [0.0, -1.0, 1.0].into_iter();
        let all = steps().flat_map(|a| steps().flat_map(move |b| steps().map(move |c| [a, b, c])));
        let far = |block: &[f64; 3]| (0..3).map(|k| (at[k] - block[k] - 0.5).powi(2)).sum::<f64>();
        let mut blocks: Vec<[f64; 3]> = all.map(|step| [0, 1, 2].map(|k| low[k] + step[k])).collect();
        blocks.retain(|block| (0..3).all(|k| (at[k] - block[k] - 0.5).abs() <= 1.0 + 1e-6));
        blocks.sort_by(|a, b| far(a).total_cmp(&far(b)));
        blocks.into_iter().find_map(|block| {
            let weight = |corner: usize| {
                let side = |k: usize| corner >> k & 1;
                let cell = [0, 1, 2].map(|k| block[k] as i32 + side(k) as i32);
                let share = |k: usize| if side(k) == 1 { at[k] - block[k] } else { 1.0 - at[k] + block[k] };
                let is_seen = self.cracks.is_empty() || self.sees(position, lattice.centre(cell));
                let number = lattice.number(cell).filter(|_| is_seen)?;
                Some((number as u32, share(0) * share(1) * share(2)))
            };
            let corners: Option<Weights> = (0..8).map(weight).collect();
            corners.map(|all| all.into_iter().filter(|w| w.1 != 0.0).collect())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(body: &PointBody, weights: &Weights, field: impl Fn([f64; 2]) -> f64) -> f64 {
        weights.iter().map(|w| w.1 * field(body.place(w.0 as usize))).sum()
    }

    #[test]
    fn linear_fields_are_exact_everywhere_and_parabolas_inwards_from_edges() {
        let body = PointBody::Lattice(SquareLattice::rectangle(0.1, [1.0, 2.0], [10, 6]));
        let interpolation = Interpolation { body: &body, cracks: &[], reach: 3 };
        let field = |[x, y]: [f64; 2]| 3.0 * x - 2.0 * y + 0.5 * x * y;
        for position in [[1.0, 2.0], [1.33, 2.21], [2.0, 2.3], [1.55, 2.55], [1.5, 2.6]] {
            let found = value(&body, &interpolation.at(in_space(position), 0), field);
            assert!((found - field(position)).abs() < 1e-13, "{position:?}");
        }
        let field = |[x, y]: [f64; 2]| x * x - 3.0 * x + 2.0 * y + 1.0;
        for (position, inward) in [([1.0, 2.3], [1, 0]), ([2.0, 2.33], [-1, 0]), ([2.0, 2.0], [-1, 0])] {
            let found = value(&body, &interpolation.inward(position, inward).unwrap(), field);
            assert!((found - field(position)).abs() < 1e-12, "{position:?} {found}");
        }
        assert_eq!(interpolation.inward([3.0, 2.3], [1, 0]), None);
    }

    #[test]
    fn linear_fields_are_exact_between_turned_rows() {
        let outline = peristat_assembly::body::Outline::rectangle([1.0, 2.0], [1.03, 0.61]).unwrap();
        let field = |[x, y]: [f64; 2]| 3.0 * x - 2.0 * y + 0.5;
        for angle in [0.1, 0.4, std::f64::consts::FRAC_PI_4, 1.2] {
            let body = PointBody::Lattice(outline.fill_turned(0.05, angle).unwrap());
            let interpolation = Interpolation { body: &body, cracks: &[], reach: 3 };
            // Inside, on edges and in all corners.
            for k in 0..441 {
                let along = |k: i32, length: f64| f64::from(k) / 20.0 * length;
                let position = [1.0 + along(k % 21, 1.03), 2.0 + along(k / 21, 0.61)];
                let found = value(&body, &interpolation.at(in_space(position), 0), field);
                assert!((found - field(position)).abs() < 1e-13, "{angle} {position:?}");
            }
            assert_eq!(interpolation.inward([1.0, 2.3], [1, 0]), None);
        }
    }

    #[test]
    fn linear_fields_are_exact_in_solids() {
        let lattice = SquareLattice::cuboid(0.1, [1.0, 2.0, 3.0], [5, 3, 4]);
        let body = PointBody::Solid(lattice);
        let interpolation = Interpolation { body: &body, cracks: &[], reach: 3 };
        let field = |[x, y, z]: [f64; 3]| 3.0 * x - 2.0 * y + 0.5 * z + x * y * z;
        for at in [[1.0, 2.0, 3.0], [1.5, 2.3, 3.4], [1.21, 2.17, 3.32], [1.25, 2.15, 3.25]] {
            let weights = interpolation.at(at, 0);
            let found: f64 = weights.iter().map(|w| w.1 * field(body.position(w.0 as usize))).sum();
            assert!((found - field(at)).abs() < 1e-12, "{at:?} {found}");
        }
    }

    /// A field that is linear on both sides of a slanted crack, and jumps.
    #[test]
    fn beside_slanted_cracks_values_are_those_of_the_own_side() {
        let crack = || Crack::new(vec![[1.03, 1.02], [9.03, 8.12]]).expect("a crack");
        let side = |[x, y]: [f64; 2]| (y - 1.02) * 8.0 - (x - 1.03) * 7.1;
        let field = |at: [f64; 2]| at[0] - 2.0 * at[1] + if side(at) > 0.0 { 100.0 } else { 0.0 };
        let body = PointBody::Lattice(SquareLattice::rectangle(0.5, [0.0; 2], [20, 20]));
        let cracks = [crack()];
        let interpolation = Interpolation { body: &body, cracks: &cracks, reach: 3 };
        for k in 0..60 {
            let along = 2.0 + 0.1 * f64::from(k);
            for off in [0.02, -0.02, 0.1, -0.1, 0.3, -0.3] {
                let position = [along, 1.02 + (along - 1.03) * 7.1 / 8.0 + off];
                let far = |p: &usize| {
                    body.place(*p).iter().zip(position).map(|(a, b)| (a - b).powi(2)).sum::<f64>()
                };
                let nearest = (0..body.points()).min_by(|a, b| far(a).total_cmp(&far(b))).expect("a point");
                let found = value(&body, &interpolation.at(in_space(position), nearest as u32), field);
                // Measured: 2e-13, of values around 100.
                assert!((found - field(position)).abs() < 2e-12, "{position:?} {off}: {found}");
            }
        }
    }

    #[test]
    fn where_too_few_points_are_seen_the_nearest_of_them_is_taken() {
        // Both cracks leave one row of points between them.
        let body = PointBody::Lattice(SquareLattice::rectangle(1.0, [0.0; 2], [6, 6]));
        let crack = |y: f64| Crack::new(vec![[-1.0, y], [7.0, y]]).expect("a crack");
        let cracks = [crack(2.0), crack(3.0)];
        let interpolation = Interpolation { body: &body, cracks: &cracks, reach: 3 };
        let weights = interpolation.at([2.4, 2.05, 0.0], 8);
        let number = (0..body.points()).find(|p| body.place(*p) == [2.5, 2.5]).expect("a point");
        assert_eq!(weights, vec![(number as u32, 1.0)]);
    }

    #[test]
    fn nothing_is_taken_from_behind_a_crack() {
        let body = PointBody::Lattice(SquareLattice::rectangle(1.0, [0.0; 2], [4, 4]));
        let crack = peristat_assembly::body::Crack::new(vec![[-1.0, 2.0], [5.0, 2.0]]).unwrap();
        let interpolation = Interpolation { body: &body, cracks: &[crack], reach: 3 };
        let weights = interpolation.at([1.7, 1.9, 0.0], 0);
        assert!(weights.iter().all(|w| body.place(w.0 as usize)[1] < 2.0));
        assert!((value(&body, &weights, |p| p[1]) - 1.9).abs() < 1e-14);
    }
}
