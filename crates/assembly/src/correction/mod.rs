//! The local limit of a body in the plane by defect correction.
//!
//! Fits of the displacements ([`trefftz`](crate::recovery::trefftz)) know the stress anywhere to the fourth order. What they lack
//! of equilibrium with the tractions on the true border, and among each other, is a load; the bonds, which know all motions
//! but none of them so well, say what displacement it is the load of, and the sum of both is nearer to the solution of local
//! elasticity. Bonds are a preconditioner then (Stetter 1978): what is found no longer depends on them.

mod border;
mod fits;
mod grid;
mod residual;
mod squares;
#[cfg(test)]
mod tests;

pub use border::{BorderPiece, Sample};
pub use fits::State;

use crate::body::Outline;
use crate::model::plane::PlaneModel;
use crate::recovery::hole::Field;
use border::Border;
use fits::{Fits, Fitted};
use grid::Grid;
use rayon::prelude::*;
use residual::Residual;

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

/// A body whose displacements are corrected.
#[derive(Clone, Debug)]
pub struct Correction {
    grid: Grid,
    border: Border,
    fits: Fits,
    residual: Residual,
    band: Vec<(u32, Fitted)>,
}

impl Correction {
    /// Of a body on a lattice along the axes, with its border, lines of symmetry left out, and the horizon over the spacing.
    /// None without a lattice, and where too little is known around some place to tell a fit.
    pub fn new(
        model: &dyn PlaneModel,
        outline: &Outline,
        pieces: &[BorderPiece],
        horizon_ratio: f64,
        fitting: Fitting,
    ) -> Option<Self> {
        let (lattice, mirrors) = model.lattice()?;
        let grid = Grid::new(lattice, mirrors);
        let border = Border::new(pieces, &grid);
        let mut fits = Fits::new(&model.stiffness(), fitting.degree, fitting.reach);
        let residual = Residual::new((&grid, &border, outline), model.thickness(), &mut fits)?;
        let depth = BAND * horizon_ratio;
        let is_beside = |place: [f64; 2]| !border.near(place, depth).is_empty();
        let beside: Vec<(u32, [f64; 2])> = grid
            .real()
            .map(|(number, place)| (number, place.map(f64::from)))
            .filter(|p| is_beside(p.1))
            .collect();
        let places: Vec<[f64; 2]> = beside.iter().map(|p| p.1).collect();
        let fitted = fits.add(&places, &grid, &border)?;
        let band = beside.into_iter().map(|p| p.0).zip(fitted).collect();
        Some(Self { grid, border, fits, residual, band })
    }

    /// Places on the border at which tractions or displacements are to be known.
    pub fn samples(&self) -> &[Sample] {
        &self.border.samples
    }

    /// Forces of the tractions, N, in two planes.
    pub fn load(&self, state: State) -> Vec<f64> {
        let mut force = vec![0.0; 2 * state.points];
        self.residual.add_loads(state, &mut force);
        force
    }

    /// What displacements lack of equilibrium: forces, N, in two planes.
    pub fn residual(&self, state: State) -> Vec<f64> {
        let mut force = self.load(state);
        self.residual.add_stresses(&self.fits, &self.border, state, &mut force);
        force
    }

    /// Replaces displacements beside the border by those of the fits around the points.
    pub fn smooth(&self, state: State) -> Vec<f64> {
        let mut smooth = state.u.to_vec();
        let moved = |(_, at): &(u32, Fitted)| self.field(at, [0.0; 2], state).displacement;
        let all: Vec<[f64; 2]> = self.band.par_iter().with_min_len(64).map(moved).collect();
        for ((point, _), u) in self.band.iter().zip(all) {
            (0..2).for_each(|c| smooth[c * state.points + *point as usize] = u[c]);
        }
        smooth
    }

    /// Displacement and stress at a position of the body, m. None where too little is known around it.
    pub fn at(&self, position: [f64; 2], state: State) -> Option<Field> {
        let mut fits = self.fits.clone();
        let at = fits.add(&[self.grid.place(position)], &self.grid, &self.border)?;
        Some(Self::field_of(&fits, &self.grid, &self.border, &at[0], [0.0; 2], state))
    }

    /// The same at every point of the body, with its number.
    pub fn fields(&self, state: State) -> Vec<(usize, Field)> {
        let places: Vec<(u32, [i32; 2])> = self.grid.real().collect();
        let mut fits = self.fits.clone();
        let centres: Vec<[f64; 2]> = places.iter().map(|(_, place)| place.map(f64::from)).collect();
        let Some(fitted) = fits.add(&centres, &self.grid, &self.border) else { return Vec::new() };
        let of = |((number, _), at): (&(u32, [i32; 2]), Fitted)| {
            (*number as usize, Self::field_of(&fits, &self.grid, &self.border, &at, [0.0; 2], state))
        };
        places.par_iter().zip(fitted).with_min_len(64).map(of).collect()
    }

    fn field(&self, at: &Fitted, relative: [f64; 2], state: State) -> Field {
        Self::field_of(&self.fits, &self.grid, &self.border, at, relative, state)
    }

    fn field_of(
        fits: &Fits,
        grid: &Grid,
        border: &Border,
        at: &Fitted,
        relative: [f64; 2],
        state: State,
    ) -> Field {
        let coefficients = fits.coefficients(at, border, state);
        let u = fits.basis.displacements(relative) * &coefficients;
        let stress = fits.basis.stresses(relative) * &coefficients * (fits.basis.unit() / fits.radius(grid));
        Field { displacement: [u[0], u[1]], stress: [stress[0], stress[1], stress[2]] }
    }
}
