//! Points with areas in no particular arrangement.

use super::geometry::{Point, distance};
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
    /// Not one area per point.
    #[error("{positions} positions, but {areas} areas")]
    Lengths {
        /// How many positions there are.
        positions: usize,
        /// How many areas there are.
        areas: usize,
    },
    /// A coordinate is infinite or no number.
    #[error("the position of point {point} is not finite")]
    NotFinite {
        /// Which point.
        point: usize,
    },
    /// An area is not above zero.
    #[error("the area of point {point} must be above zero, found {found}")]
    Area {
        /// Which point.
        point: usize,
        /// Its area.
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

/// Points with areas, in the order in which they were listed.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    positions: Vec<Point>,
    areas: Vec<f64>,
    groups: Vec<Group>,
    spacing: f64,
}

/// Points this close coincide, in spacings.
const COINCIDENT: f64 = 1e-9;

impl Cloud {
    /// Points at `positions` (m) with `areas` (m²), one each, and groups of them; numbers in groups may come in any order.
    ///
    /// # Errors
    /// [`CloudError`].
    pub fn new(
        positions: Vec<[f64; 2]>,
        areas: Vec<f64>,
        mut groups: Vec<Group>,
    ) -> Result<Self, CloudError> {
        let found = positions.len();
        if found == 0 || u32::try_from(found).is_err() {
            return Err(CloudError::Number { found });
        }
        if areas.len() != found {
            return Err(CloudError::Lengths { positions: found, areas: areas.len() });
        }
        if let Some(point) = positions.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
            return Err(CloudError::NotFinite { point });
        }
        if let Some(point) = areas.iter().position(|a| !(*a > 0.0 && a.is_finite())) {
            return Err(CloudError::Area { point, found: areas[point] });
        }
        let spacing = (areas.iter().map(|a| a / found as f64).sum::<f64>()).sqrt();
        if let Some([first, second]) = coincident(&positions, COINCIDENT * spacing) {
            return Err(CloudError::Coincident { first, second });
        }
        for k in 0..groups.len() {
            let (before, rest) = groups.split_at_mut(k);
            let group = &mut rest[0];
            if before.iter().any(|g| g.name == group.name) {
                return Err(CloudError::SameName { name: group.name.clone() });
            }
            group.points.sort_unstable();
            group.points.dedup();
            if let Some(&point) = group.points.last().filter(|p| **p as usize >= found) {
                return Err(CloudError::NoSuchPoint { group: group.name.clone(), point, points: found });
            }
        }
        Ok(Self { positions, areas, groups, spacing })
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.positions.len()
    }

    /// Positions, m.
    pub fn positions(&self) -> &[[f64; 2]] {
        &self.positions
    }

    /// Areas, m².
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Named groups of points.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The group of a name.
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups.iter().find(|g| g.name == name)
    }

    /// Root of the mean area, m.
    pub fn spacing(&self) -> f64 {
        self.spacing
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
        neighbours::about(&self.positions, radius)
    }
}

/// Two points within a small distance. Such points are in one of the strips of twice the distance, or in one of the same
/// strips moved by half; in a strip they follow each other closely along y.
fn coincident(positions: &[Point], within: f64) -> Option<[usize; 2]> {
    for shift in [0.0, 0.5] {
        let strip = |p: &Point| (p[0] / (2.0 * within) + shift).floor();
        let mut order: Vec<(f64, f64, usize)> =
            positions.iter().enumerate().map(|(k, p)| (strip(p), p[1], k)).collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        for (place, a) in order.iter().enumerate() {
            let near = order[place + 1..].iter().take_while(|b| b.0 == a.0 && b.1 - a.1 <= within);
            for b in near {
                if distance(positions[a.2], positions[b.2]) <= within {
                    return Some([a.2.min(b.2), a.2.max(b.2)]);
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(positions: &[Point], areas: &[f64]) -> CloudError {
        Cloud::new(positions.to_vec(), areas.to_vec(), Vec::new()).unwrap_err()
    }

    #[test]
    fn lists_are_checked() {
        assert_eq!(fault(&[], &[]), CloudError::Number { found: 0 });
        assert_eq!(fault(&[[0.0; 2]], &[]), CloudError::Lengths { positions: 1, areas: 0 });
        assert_eq!(fault(&[[0.0, f64::INFINITY]], &[1.0]), CloudError::NotFinite { point: 0 });
        assert_eq!(fault(&[[0.0; 2], [1.0; 2]], &[1.0, 0.0]), CloudError::Area { point: 1, found: 0.0 });
        let group = |name: &str, points: &[u32]| Group { name: name.into(), points: points.to_vec() };
        let with = |groups: Vec<Group>| Cloud::new(vec![[0.0; 2], [1.0; 2]], vec![2.0; 2], groups);
        assert!(matches!(with(vec![group("a", &[0, 2])]), Err(CloudError::NoSuchPoint { point: 2, .. })));
        assert!(matches!(with(vec![group("a", &[]), group("a", &[])]), Err(CloudError::SameName { .. })));
        let cloud = with(vec![group("a", &[1, 0, 1])]).unwrap();
        assert_eq!(cloud.group("a").unwrap().points, [0, 1]);
        assert_eq!(cloud.spacing(), 2.0f64.sqrt());
    }

    /// Points of a regular grid, which share their coordinates with many others, and one that is nearly a copy.
    #[test]
    fn copies_are_found_on_either_side_of_any_strip() {
        let grid = (0..40).flat_map(|i| (0..40).map(move |j| [f64::from(i) * 0.7, f64::from(j) * 0.7]));
        let grid: Vec<Point> = grid.collect();
        let areas = vec![0.49; grid.len() + 1];
        assert!(Cloud::new(grid.clone(), areas[1..].to_vec(), Vec::new()).is_ok());
        for (k, by) in [(0, [0.0, 0.0]), (777, [5e-10, 0.0]), (800, [-5e-10, 1e-10]), (1599, [0.0, -6e-10])] {
            let mut points = grid.clone();
            points.push([grid[k][0] + by[0], grid[k][1] + by[1]]);
            assert_eq!(fault(&points, &areas), CloudError::Coincident { first: k, second: 1600 });
        }
    }
}
