//! Points with areas or volumes in no particular arrangement.

use super::geometry::{distance_in_space, in_space};
use super::neighbours::{self, Neighbours};
use thiserror::Error;

/// Why lists make no cloud. Points count from zero.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CloudError {
    /// No points, or more than can be numbered.
    #[error("a cloud has between 1 and {} points, found {found}", u32::MAX)]
    Number {
        /// How many there are.
        found: usize,
    },
    /// Not one area or volume per point.
    #[error("{positions} positions, but {sizes} areas or volumes")]
    Lengths {
        /// How many positions there are.
        positions: usize,
        /// How many areas or volumes there are.
        sizes: usize,
    },
    /// A coordinate is infinite or no number.
    #[error("the position of point {point} is not finite")]
    NotFinite {
        /// Which point.
        point: usize,
    },
    /// An area or a volume is not above zero.
    #[error("the area or volume of point {point} must be above zero, found {found}")]
    Size {
        /// Which point.
        point: usize,
        /// Its area or volume.
        found: f64,
    },
    /// Two points are closer than 1e-9 of the spacing.
    #[error("points {first} and {second} are at the same place")]
    Coincident {
        /// The lower number.
        first: usize,
        /// The higher number.
        second: usize,
    },
    /// A group names a point that does not exist.
    #[error("group `{group}` has a point {point}, but there are only {points}")]
    NoSuchPoint {
        /// The name of the group.
        group: String,
        /// The number in the group.
        point: u32,
        /// How many points there are.
        points: usize,
    },
    /// Two groups have one name.
    #[error("there are two groups of the name `{name}`")]
    SameName {
        /// The name.
        name: String,
    },
}

/// Named points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// Numbers of its points, ascending, none twice.
    pub points: Vec<u32>,
}

/// Points of a plane with areas, or of space with volumes, in the order in which they were listed.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    axes: usize,
    positions: Vec<[f64; 3]>,
    sizes: Vec<f64>,
    groups: Vec<Group>,
    spacing: f64,
}

/// Points this close coincide, in spacings.
const COINCIDENT: f64 = 1e-9;

impl Cloud {
    /// Points of the plane at `positions` (m) with `areas` (m²), one each, and groups of them; numbers in groups may come in any
    /// order.
    ///
    /// # Errors
    /// [`CloudError`].
    pub fn in_plane(
        positions: Vec<[f64; 2]>,
        areas: Vec<f64>,
        groups: Vec<Group>,
    ) -> Result<Self, CloudError> {
        Self::new(2, positions.into_iter().map(in_space).collect(), areas, groups)
    }

    /// Points of space at `positions` (m) with `volumes` (m³), otherwise as [`in_plane`](Self::in_plane).
    ///
    /// # Errors
    /// [`CloudError`].
    pub fn in_space(
        positions: Vec<[f64; 3]>,
        volumes: Vec<f64>,
        groups: Vec<Group>,
    ) -> Result<Self, CloudError> {
        Self::new(3, positions, volumes, groups)
    }

    fn new(
        axes: usize,
        positions: Vec<[f64; 3]>,
        sizes: Vec<f64>,
        groups: Vec<Group>,
    ) -> Result<Self, CloudError> {
        let found = positions.len();
        if found == 0 || u32::try_from(found).is_err() {
            return Err(CloudError::Number { found });
        }
        if sizes.len() != found {
            return Err(CloudError::Lengths { positions: found, sizes: sizes.len() });
        }
        if let Some(point) = positions.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return Err(CloudError::NotFinite { point });
        }
        if let Some(point) = sizes.iter().position(|size| !(*size > 0.0 && size.is_finite())) {
            return Err(CloudError::Size { point, found: sizes[point] });
        }
        let mean = sizes.iter().map(|size| size / found as f64).sum::<f64>();
        let spacing = if axes == 3 { mean.cbrt() } else { mean.sqrt() };
        if let Some([first, second]) = coincident(&positions, axes, COINCIDENT * spacing) {
            return Err(CloudError::Coincident { first, second });
        }
        Ok(Self { axes, positions, sizes, groups: checked(groups, found)?, spacing })
    }

    /// Number of coordinates of a position: two in the plane, three in space.
    pub fn axes(&self) -> usize {
        self.axes
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.positions.len()
    }

    /// Positions, m; z = 0 in the plane.
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// Position of a point along x and y, m: all of it in the plane.
    pub fn place(&self, point: usize) -> [f64; 2] {
        let [x, y, _] = self.positions[point];
        [x, y]
    }

    /// Areas, m², in the plane; volumes, m³, in space.
    pub fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    /// Named groups of points.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The group of a name.
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups.iter().find(|g| g.name == name)
    }

    /// Square root of the mean area, or cube root of the mean volume, m.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// The mean of the distances of points to their nearest neighbours, m, and the standard deviation over it, which is zero on a
    /// lattice; none where no point has a neighbour within `radius`, m. Those without one do not count.
    ///
    /// # Panics
    /// As [`neighbours`](Self::neighbours).
    pub fn nearest_distances(&self, radius: f64) -> Option<[f64; 2]> {
        let neighbours = self.neighbours(radius);
        let distance = |a: usize, b: u32| {
            let (a, b) = (self.positions[a], self.positions[b as usize]);
            (0..3).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt()
        };
        let nearest = |p: usize| neighbours.of(p).iter().map(|&q| distance(p, q)).reduce(f64::min);
        let all: Vec<f64> = (0..self.points()).filter_map(nearest).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let variance = all.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / all.len() as f64;
        (!all.is_empty()).then(|| [mean, variance.sqrt() / mean])
    }

    /// Side of the square or the cube that a point stands for, over the [spacing](Self::spacing).
    pub fn width(&self, point: usize) -> f64 {
        self.sizes[point].powf(1.0 / self.axes as f64) / self.spacing
    }

    /// Neighbours at a distance of at most `radius` (m): exactly `radius` counts, so one that shall include a known
    /// distance needs some slack.
    ///
    /// # Panics
    /// A radius that is not above zero.
    pub fn neighbours(&self, radius: f64) -> Neighbours {
        assert!(radius > 0.0, "a radius is above zero");
        Neighbours::within(&self.positions, radius)
    }

    /// About how many pairs of [neighbours](Self::neighbours) there are, found without making them: 0.4 to 1.1 of the true
    /// number.
    ///
    /// # Panics
    /// A radius that is not above zero.
    pub fn about_pairs(&self, radius: f64) -> f64 {
        assert!(radius > 0.0, "a radius is above zero");
        neighbours::about(&self.positions, self.axes, radius)
    }
}

/// Groups of some of so many points, their numbers in order.
fn checked(mut groups: Vec<Group>, points: usize) -> Result<Vec<Group>, CloudError> {
    for k in 0..groups.len() {
        let (before, rest) = groups.split_at_mut(k);
        let group = &mut rest[0];
        if before.iter().any(|g| g.name == group.name) {
            return Err(CloudError::SameName { name: group.name.clone() });
        }
        group.points.sort_unstable();
        group.points.dedup();
        if let Some(&point) = group.points.last().filter(|p| **p as usize >= points) {
            return Err(CloudError::NoSuchPoint { group: group.name.clone(), point, points });
        }
    }
    Ok(groups)
}

/// Two points within a small distance. Such points are in one of the strips of twice the distance, or in one of the same
/// strips moved by half; in a strip they follow each other closely along y. In space strips along x and y make columns, which
/// run along z.
fn coincident(positions: &[[f64; 3]], axes: usize, within: f64) -> Option<[usize; 2]> {
    let along = axes - 1;
    for moved in 0..1 << along {
        let strip = |p: &[f64; 3], k: usize| {
            let shift = if moved >> k & 1 == 1 { 0.5 } else { 0.0 };
            if k < along { (p[k] / (2.0 * within) + shift).floor() } else { 0.0 }
        };
        let place = |(k, p): (usize, &[f64; 3])| ([strip(p, 0), strip(p, 1)], p[along], k);
        let mut order: Vec<([f64; 2], f64, usize)> = positions.iter().enumerate().map(place).collect();
        order.sort_unstable_by(|(a, x, i), (b, y, j)| {
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(x.total_cmp(y)).then(i.cmp(j))
        });
        for (place, a) in order.iter().enumerate() {
            let near = order[place + 1..].iter().take_while(|b| b.0 == a.0 && b.1 - a.1 <= within);
            for b in near {
                if distance_in_space(positions[a.2], positions[b.2]) <= within {
                    return Some([a.2.min(b.2), a.2.max(b.2)]);
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests;
