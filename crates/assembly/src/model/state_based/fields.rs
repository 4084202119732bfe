//! Strains and stresses of the points of a state-based body.
//!
//! Of several materials a point tells the state that it sees, `g e` in place of e.
//!
//! `S_ab = (8/q) Σ w |ξ| n_a n_b e` makes the dilatation `ϑ = (S_xx + S_yy)/4` and the strains `E_ab = ½(S_ab − δ_ab ϑ)`; these
//! are exact for every uniform strain.

use super::super::plane::PlaneFields;
use super::blocks::Means;
use super::body::StateBody;
use super::{Dilatation, StateParameters};
use crate::body::{Cell, SquareLattice, plus};
use rayon::prelude::*;

/// What the family of a point tells of its state.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    /// `[E_xx, E_yy, E_xy]`.
    strain: [f64; 3],
    /// Strain across the section; zero but in bodies of revolution.
    across: f64,
    /// `Σ w e²/q`.
    bonds: f64,
}

impl State {
    fn dilatation(&self) -> f64 {
        self.strain[0] + self.strain[1] + self.across
    }
}

impl StateBody {
    fn state(&self, parameters: &StateParameters, point: usize, u: &[f64]) -> State {
        let Some(number) = self.families.set_of[point] else { return State::default() };
        let n = self.lattice.points();
        let set = &self.families.sets[number as usize];
        let cell = self.lattice.cell(point);
        let own = [u[point], u[n + point]];
        let (mut sums, mut squares) = ([0.0; 3], 0.0);
        for (k, (&step, &w)) in self.families.offsets.iter().zip(&set.weights).enumerate() {
            let Some(other) = self.lattice.number(plus(cell, step)).filter(|_| w != 0.0) else {
                continue;
            };
            let [x, y, _] = step.map(f64::from);
            let square = x * x + y * y;
            let along = x * (u[other] - own[0]) + y * (u[n + other] - own[1]);
            let stretch = set.own(k) * along / square;
            // e |ξ| n_a n_b = stretch ξ_a ξ_b.
            for (sum, product) in sums.iter_mut().zip([x * x, y * y, x * y]) {
                *sum += w * stretch * product;
            }
            squares += w * stretch * stretch * square;
        }
        let spacing = self.lattice.spacing();
        let [xx, yy, xy] = sums.map(|s| 8.0 / (set.q * spacing) * s);
        let half = 0.25 * (xx + yy);
        let across = match parameters.is_axisymmetric() {
            true => own[0] / self.lattice.place(point)[0],
            false => 0.0,
        };
        State {
            strain: [0.5 * (xx - half), 0.5 * (yy - half), 0.5 * xy],
            across,
            bonds: squares / (set.q * spacing * spacing),
        }
    }

    /// Means of the dilatation over the points of a material in every block, and what they are at the points; or those of the points.
    fn dilatations(&self, parameters: &StateParameters, states: &[State]) -> [Vec<f64>; 2] {
        let own: Vec<f64> = states.iter().map(State::dilatation).collect();
        if parameters.dilatation == Dilatation::Points {
            return [own.clone(), own];
        }
        let number = |p: usize| self.mixture.as_ref().map_or(0, |mixture| mixture.number(p));
        let block = |p: usize| (SquareLattice::parent(self.lattice.cell(p)), number(p));
        let means = Means::new((&self.lattice, self.mirrors), &block, &|p| self.families.energy[p], &own);
        let of: Vec<f64> = (0..states.len()).map(|p| means.of(block(p))).collect();
        // Next blocks may be on the other side of a crack.
        let is_whole = self.cuts.is_empty() && self.apart.is_empty();
        let at = |p: usize| if is_whole { means.at(p, block(p)) } else { of[p] };
        let at = (0..states.len()).map(at).collect();
        [of, at]
    }

    /// λ, μ and the bulk modulus of a point, Pa.
    pub(super) fn moduli(&self, parameters: &StateParameters) -> impl Fn(usize) -> [f64; 3] {
        move |point| {
            let own = self.mixture.as_ref().map_or(*parameters, |mixture| mixture.of(point));
            [own.lame(), own.shear_modulus(), own.bulk_modulus()]
        }
    }

    /// Stresses and energy densities; ghosts have those of their fits.
    pub(super) fn fields(&self, parameters: &StateParameters, u: &[f64]) -> PlaneFields {
        let n = self.lattice.points();
        let states: Vec<State> =
            (0..n).into_par_iter().with_min_len(1024).map(|p| self.state(parameters, p, u)).collect();
        let [means, at_points] = self.dilatations(parameters, &states);
        let moduli = self.moduli(parameters);
        let pressure = |p: usize| {
            let [_, shear, bulk] = moduli(p);
            bulk * at_points[p] - 2.0 / 3.0 * shear * states[p].dilatation()
        };
        let stress = |p: usize, strain: f64| pressure(p) + 2.0 * moduli(p)[1] * strain;
        let direct = |k: usize| -> Vec<f64> { (0..n).map(|p| stress(p, states[p].strain[k])).collect() };
        let energy = |p: usize| {
            let [lame, shear, bulk] = moduli(p);
            let State { strain, across: h, bonds } = states[p];
            let (theta, whole) = (strain[0] + strain[1], states[p].dilatation());
            let families = 0.5 * (lame - shear) * theta * theta
                + lame * theta * h
                + 0.5 * (lame + 2.0 * shear) * h * h
                + 0.5 * bulk * (means[p] * means[p] - whole * whole);
            families + 4.0 * shear * bonds
        };
        let shears = (0..n).map(|p| 2.0 * moduli(p)[1] * states[p].strain[2]).collect();
        let mut fields = PlaneFields {
            stress: [direct(0), direct(1), shears],
            energy_density: (0..n).map(energy).collect(),
            across: match parameters.is_axisymmetric() {
                true => (0..n).map(|p| stress(p, states[p].across)).collect(),
                false => Vec::new(),
            },
        };
        let [xx, yy, xy] = &mut fields.stress;
        for values in [xx, yy, xy, &mut fields.energy_density, &mut fields.across] {
            self.continue_to_ghosts(values);
        }
        fields
    }

    fn continue_to_ghosts(&self, values: &mut [f64]) {
        if values.is_empty() {
            return;
        }
        for (cell, fit) in &self.fits {
            let of = |(c, share): &(Cell, f64)| Some(share * values[self.lattice.number(*c)?]);
            if let Some(ghost) = self.lattice.number(*cell) {
                values[ghost] = fit.iter().filter_map(of).sum();
            }
        }
    }

    /// Hands forces on ghosts to the points of their fits.
    pub(super) fn fold(&self, force: &mut [f64]) {
        let n = self.lattice.points();
        for (cell, fit) in &self.fits {
            let Some(ghost) = self.lattice.number(*cell) else { continue };
            for plane in [0, n] {
                let held = std::mem::take(&mut force[plane + ghost]);
                for (real, share) in fit {
                    if let Some(point) = self.lattice.number(*real) {
                        force[plane + point] += share * held;
                    }
                }
            }
        }
    }
}
