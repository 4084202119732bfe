//! The unknowns of a station, solved together.

use super::LinePlace;
use super::matrix::Matrix;
use crate::{FactorError, Ordering, Preconditioner, SparseCholesky};
use rayon::prelude::*;
use sprs::CsMat;
use std::ops::Range;
use std::sync::Mutex;

/// Unknowns whose stations a factor takes together, about: enough for a thread to be worth its start.
const TOGETHER: usize = 4096;

/// Factors of the parts of a matrix that join the unknowns of one station, some stations each, and how many unknowns these have.
pub(super) struct StationFactors(Vec<(usize, Mutex<Part>)>);

/// Some stations that follow each other.
struct Part {
    factor: SparseCholesky,
    solution: Vec<f64>,
}

impl StationFactors {
    /// Those of a matrix whose unknowns are in the order of their stations.
    ///
    /// # Errors
    /// [`FactorError`] if a part is not positive definite.
    pub(super) fn new(matrix: &Matrix, places: &[Option<LinePlace>]) -> Result<Self, FactorError> {
        let station = |unknown: usize| places[unknown].map(|place| place.station);
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for unknown in 0..matrix.rows() {
            match ranges.last_mut() {
                Some(range) if range.len() < TOGETHER || station(unknown) == station(unknown - 1) => {
                    range.end = unknown + 1;
                }
                _ => ranges.push(unknown..unknown + 1),
            }
        }
        let part = |range: &Range<usize>| {
            let (mut pointers, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
            for row in range.clone() {
                let own =
                    matrix.row(row).filter(|(column, _)| *column <= row && station(*column) == station(row));
                own.for_each(|(column, value)| {
                    indices.push(column - range.start);
                    values.push(value);
                });
                pointers.push(indices.len());
            }
            let lower = CsMat::new((range.len(), range.len()), pointers, indices, values);
            let mut factor = SparseCholesky::analyse(&lower, Ordering::MinimumDegree)?;
            factor.refactor(&lower)?;
            Ok((range.len(), Mutex::new(Part { factor, solution: vec![0.0; range.len()] })))
        };
        Ok(Self(ranges.par_iter().map(part).collect::<Result<_, FactorError>>()?))
    }

    /// Entries of the factors.
    pub(super) fn entries(&self) -> usize {
        self.0.iter().map(|(_, part)| part.lock().expect("no holder of the lock panics").factor.fill()).sum()
    }

    /// `x += scale M⁻¹ r`
    pub(super) fn add(&self, scale: f64, r: &[f64], x: &mut [f64]) {
        let (mut pieces, mut rest) = (Vec::with_capacity(self.0.len()), (r, x));
        for (size, part) in &self.0 {
            let ((r, later_r), (x, later_x)) = (rest.0.split_at(*size), rest.1.split_at_mut(*size));
            pieces.push((part, r, x));
            rest = (later_r, later_x);
        }
        pieces.into_par_iter().for_each(|(part, r, x)| {
            let mut part = part.lock().expect("no holder of the lock panics");
            let Part { factor, solution } = &mut *part;
            factor.apply(r, solution);
            x.iter_mut().zip(&*solution).for_each(|(x, z)| *x += scale * z);
        });
    }
}
