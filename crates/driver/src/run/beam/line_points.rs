//! Positions of the points of a line.

use peristat_assembly::model::timoshenko_beam::Chain;
use std::ops::Deref;
use std::sync::OnceLock;

/// Positions of the real points of a line. As a slice they are put together when somebody asks for them: on an even grid
/// most of what is done with a result can do without.
#[derive(Clone, Debug)]
pub struct LinePoints {
    count: usize,
    first: f64,
    /// Distance of neighbours on an even grid.
    spacing: Option<f64>,
    all: OnceLock<Vec<f64>>,
}

impl LinePoints {
    /// Positions of the real points of a chain.
    pub(super) fn new(chain: &Chain) -> Self {
        let line = chain.line();
        let points = Self {
            count: chain.points,
            first: line.origin(),
            spacing: line.stations.is_none().then(|| line.spacing()),
            all: OnceLock::new(),
        };
        if points.spacing.is_none() {
            points.all.get_or_init(|| (0..chain.points).map(|k| chain.position(k)).collect());
        }
        points
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Position of a point.
    pub fn at(&self, point: usize) -> f64 {
        match self.spacing {
            Some(spacing) => self.first + point as f64 * spacing,
            None => self[point],
        }
    }

    /// Positions of the points from `start` on.
    pub(super) fn fill(&self, start: usize, x: &mut [f64]) {
        match self.spacing {
            Some(spacing) => {
                x.iter_mut().enumerate().for_each(|(k, x)| *x = self.first + (start + k) as f64 * spacing);
            }
            None => x.copy_from_slice(&self[start..start + x.len()]),
        }
    }
}

impl Deref for LinePoints {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        self.all.get_or_init(|| (0..self.count).map(|k| self.at(k)).collect())
    }
}
