//! Products in the numbers of a level.

use super::System;
use crate::stiffness::{TakeForces, Term};
use peristat_vector::Lanes;

/// What a level computes with: numbers of 64 bits, or of 32 where a few digits do.
pub trait InPrecision: Lanes {
    /// Hands the forces of a term to `take`; `false` if the term does not go from point to point in these numbers.
    fn sweep<const D: usize>(
        term: &dyn Term<D>,
        u: &[Self],
        out: &mut [Self],
        take: TakeForces<'_, D, Self>,
    ) -> bool;

    /// Writes the product with the constrained stiffness over `y`, by way of 64 bits.
    fn multiply<const D: usize>(system: &System<D>, x: &[Self], y: &mut [Self]);
}

impl InPrecision for f64 {
    fn sweep<const D: usize>(
        term: &dyn Term<D>,
        u: &[f64],
        out: &mut [f64],
        take: TakeForces<'_, D>,
    ) -> bool {
        term.sweep(u, out, take)
    }

    fn multiply<const D: usize>(system: &System<D>, x: &[f64], y: &mut [f64]) {
        system.product(x, y);
    }
}

impl InPrecision for f32 {
    fn sweep<const D: usize>(
        term: &dyn Term<D>,
        u: &[f32],
        out: &mut [f32],
        take: TakeForces<'_, D, f32>,
    ) -> bool {
        term.sweep_in_single(u, out, take)
    }

    fn multiply<const D: usize>(system: &System<D>, x: &[f32], y: &mut [f32]) {
        let x: Vec<f64> = x.iter().map(|x| f64::from(*x)).collect();
        let mut product = vec![0.0; y.len()];
        system.product(&x, &mut product);
        y.iter_mut().zip(&product).for_each(|(y, product)| *y = *product as f32);
    }
}
