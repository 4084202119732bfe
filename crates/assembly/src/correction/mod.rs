//! The local limit of a body in the plane by defect correction.
//!
//! Fits of the displacements ([`trefftz`](crate::recovery::trefftz)) know the stress anywhere to the fourth order. What they lack
//! of equilibrium with the tractions on the true border, and among each other, is a load; the bonds, which know all motions
//! but none of them so well, say what displacement it is the load of, and the sum of both is nearer to the solution of local
//! elasticity. Bonds are a preconditioner then (Stetter 1978): what is found no longer depends on them.

mod border;
mod fits;
mod grid;
mod holes;
mod pulls;
mod residual;
mod squares;
#[cfg(test)]
mod tests;
mod weight;

pub use border::{BorderPiece, Sample};
pub use fits::State;
pub use holes::HoleZone;

use crate::body::Outline;
use crate::model::plane::PlaneModel;
use crate::recovery::hole::{Field, HoleFit};
use border::Border;
use fits::{Fits, Fitted};
use grid::Grid;
use rayon::prelude::*;
use residual::Residual;
use weight::Weight;

/// How far from the border displacements are replaced by those of fits, which are smooth, in horizons.
const BAND: f64 = 2.0;

/// What the fits are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitting {
    /// Degree of the polynomials.
    pub degree: i32,
    /// How far they see, in spacings.
    pub reach: f64,
}

/// What bounds a body, lines of symmetry left out.
#[derive(Clone, Copy, Debug)]
pub struct Bounds<'a> {
    /// Where there is a body.
    pub outline: &'a Outline,
    /// Its border.
    pub pieces: &'a [BorderPiece],
    /// Holes that have fields of their own.
    pub holes: &'a [HoleZone],
    /// Where stresses are infinite, m.
    pub singular: &'a [[f64; 2]],
}

/// A body whose displacements are corrected.
#[derive(Clone, Debug)]
pub struct Correction {
    grid: Grid,
    border: Border,
    holes: Vec<HoleZone>,
    fits: Fits,
    residual: Residual,
    weight: Weight,
    band: Vec<(u32, Fitted)>,
    /// Points that have the fields of a hole, by its number.
    in_holes: Vec<(u32, [f64; 2], u32)>,
}

/// Fits around positions of a body at which its fields are read.
#[derive(Clone, Debug)]
pub struct Reading {
    fits: Fits,
    at: Vec<(Fitted, [f64; 2])>,
}

impl Correction {
    /// Of a body on a lattice along the axes with its horizon over the spacing. None without a lattice, and where too little is
    /// known around some place to tell a fit.
    pub fn new(model: &dyn PlaneModel, bounds: Bounds, horizon_ratio: f64, fitting: Fitting) -> Option<Self> {
        let (lattice, mirrors) = model.lattice()?;
        let grid = Grid::new(lattice, mirrors);
        let border = Border::new(bounds.pieces, &grid);
        let singular = bounds.singular.iter().flat_map(|at| grid.images(grid.place(*at)));
        let singular = singular.map(|(at, _)| at).collect();
        let mut fits = Fits::new(&model.stiffness(), fitting.degree, fitting.reach, singular);
        let body = (&grid, &border, bounds.outline);
        let residual = Residual::new(body, (model.thickness(), bounds.holes), &mut fits)?;
        let weight = Weight::new(&model.stiffness(), grid.symmetric_origin())?;
        let depth = BAND * horizon_ratio;
        let (mut beside, mut in_holes) = (Vec::new(), Vec::new());
        for (number, place) in grid.real() {
            let place = place.map(f64::from);
            let position = grid.position(place);
            match HoleZone::at(bounds.holes, position) {
                Some(hole) => in_holes.push((number, position, hole)),
                None if !fits.is_rough(place) && !border.near(place, depth).is_empty() => {
                    beside.push((number, place))
                }
                None => {}
            }
        }
        let places: Vec<[f64; 2]> = beside.iter().map(|p| p.1).collect();
        let fitted = fits.add(&places, &grid, &border)?;
        let band = beside.into_iter().map(|p| p.0).zip(fitted).collect();
        let holes = bounds.holes.to_vec();
        Some(Self { grid, border, holes, fits, residual, weight, band, in_holes })
    }

    /// Places on the border at which tractions or displacements are to be known.
    pub fn samples(&self) -> &[Sample] {
        &self.border.samples
    }

    /// What displacements lack of equilibrium: forces, N, in two planes.
    pub fn residual(&self, state: State) -> Vec<f64> {
        let mut force = vec![0.0; 2 * state.points];
        self.without_weight(state, |state| {
            self.residual.add_loads(state, &mut force);
            self.residual.add_stresses(&self.fits, &self.border, state, &mut force);
        });
        force
    }

    /// Replaces displacements beside the border by those of the fits around the points.
    pub fn smooth(&self, state: State) -> Vec<f64> {
        let mut smooth = state.u.to_vec();
        self.without_weight(state, |inner| {
            let moved = |(_, at): &(u32, Fitted)| self.field(&self.fits, at, inner).displacement;
            let all: Vec<[f64; 2]> = self.band.par_iter().with_min_len(64).map(moved).collect();
            for ((point, at), [x, y]) in self.band.iter().zip(all) {
                let own = self.weight.field(state.weight, self.grid.position(at.around.centre)).displacement;
                smooth[*point as usize] = x + own[0];
                smooth[state.points + *point as usize] = y + own[1];
            }
        });
        for (point, position, hole) in &self.in_holes {
            let Some(fit) = state.holes.get(*hole as usize) else { continue };
            let u = fit.at(*position).displacement;
            (0..2).for_each(|c| smooth[c * state.points + *point as usize] = u[c]);
        }
        smooth
    }

    /// What reads displacement, rotation and stress at positions of the body, m. None where too little is known around one to tell a fit.
    pub fn reading(&self, positions: Vec<[f64; 2]>) -> Option<Reading> {
        let mut fits = self.fits.clone();
        let places: Vec<[f64; 2]> = positions.iter().map(|at| self.grid.place(*at)).collect();
        let fitted = fits.add(&places, &self.grid, &self.border)?;
        Some(Reading { fits, at: fitted.into_iter().zip(positions).collect() })
    }

    /// Displacement, rotation and stress at the positions of a reading.
    pub fn read(&self, reading: &Reading, state: State) -> Vec<Field> {
        let mut found = Vec::new();
        self.without_weight(state, |inner| {
            let of = |(at, position): &(Fitted, [f64; 2])| {
                if let Some(fit) = self.hole(*position, state) {
                    return fit.at(*position);
                }
                let mut field = self.field(&reading.fits, at, inner);
                field.add_multiple(1.0, &self.weight.field(state.weight, *position));
                field
            };
            found = reading.at.par_iter().with_min_len(64).map(of).collect();
        });
        found
    }

    /// What the polynomials at the positions of a reading miss of the displacements, relative to those that strain the body there; none
    /// where the fields of a hole stand for them, and beside infinite stresses, where they see no more than determines them.
    pub fn misfits(&self, reading: &Reading, state: State) -> Vec<Option<f64>> {
        let mut found = Vec::new();
        self.without_weight(state, |inner| {
            let around = (&self.grid, &self.border);
            let of = |(at, position): &(Fitted, [f64; 2])| {
                let is_told = self.hole(*position, state).is_none() && !self.fits.is_rough(at.around.centre);
                is_told.then(|| reading.fits.misfit(at, around, [inner, state]))
            };
            found = reading.at.par_iter().with_min_len(64).map(of).collect();
        });
        found
    }

    /// The fields of a hole that a position has.
    fn hole<'a>(&self, position: [f64; 2], state: State<'a>) -> Option<&'a HoleFit> {
        HoleZone::at(&self.holes, position).and_then(|k| state.holes.get(k as usize))
    }

    /// The polynomials of a fit in its centre.
    fn field(&self, fits: &Fits, at: &Fitted, state: State) -> Field {
        let values = fits.at_centre.tr_mul(&fits.coefficients(at, &self.border, state));
        let radius = fits.radius(&self.grid);
        let stress = |k: usize| values[k] * (fits.basis.unit() / radius);
        Field {
            displacement: [values[0], values[1]],
            rotation: values[2] / radius,
            stress: [stress(3), stress(4), stress(5)],
        }
    }

    /// Works on a state less the field of the force on every point.
    fn without_weight(&self, state: State, work: impl FnOnce(State)) {
        if state.weight == [0.0; 2] {
            return work(state);
        }
        let mut u = state.u.to_vec();
        for (number, place) in self.grid.real() {
            let own = self.weight.field(state.weight, self.grid.position(place.map(f64::from))).displacement;
            (0..2).for_each(|c| u[c * state.points + number as usize] -= own[c]);
        }
        let held = self.border.held();
        let less = |((known, sample), held): ((&[f64; 2], &Sample), [bool; 2])| {
            let Field { displacement, stress: [xx, yy, xy], .. } = self.weight.field(state.weight, sample.at);
            let [x, y] = sample.normal;
            let traction = [xx * x + xy * y, xy * x + yy * y];
            [0, 1].map(|k| known[k] - if held[k] { displacement[k] } else { traction[k] })
        };
        let border: Vec<[f64; 2]> =
            state.border.iter().zip(&self.border.samples).zip(held).map(less).collect();
        work(State { u: &u, border: &border, ..state });
    }
}
