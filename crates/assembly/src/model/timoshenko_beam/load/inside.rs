//! What lies between two neighbouring points of a line: statics, and displacements by the force method.

use super::{Along, BeamLoads, Carried, Intensity};
use crate::material::Compliance;
use crate::model::timoshenko_beam::Chain;
use crate::model::timoshenko_beam::chain::pieces;
use crate::quadrature::{GAUSS, GAUSS_3};
use nalgebra::{Matrix3, Vector3};

/// The inside of the cells of a line under the loads that its bonds carry.
#[derive(Debug)]
pub struct Inside<'a> {
    carried: Carried<'a>,
    chain: &'a Chain,
    /// Distances from the start at which the stiffness or the loads are not smooth, or waves of loads turn, in order.
    breaks: Vec<f64>,
}

impl<'a> Inside<'a> {
    /// Of a line with its number.
    pub fn new(loads: &'a BeamLoads, number: usize, chain: &'a Chain) -> Self {
        let carried = Carried::of(loads, number);
        let mut breaks = carried.breaks(chain);
        let waves = carried.distributed.iter().flat_map(|load| load.zeros_of_waves());
        breaks.extend(waves.map(|x| x - chain.line().from));
        breaks.sort_by(f64::total_cmp);
        Self { carried, chain, breaks }
    }

    /// Whether what is spread across the line is known to act in one direction all over `[a, b]`, m, where it has no breaks.
    pub fn pushes_one_way(&self, [a, b]: [f64; 2]) -> bool {
        let across = self.carried.distributed.iter().filter(|load| load.along == Along::Transverse);
        let mut signs = [false; 2];
        for load in across.filter(|load| load.from < b && load.to > a) {
            let values = match load.intensity {
                Intensity::Parabola { .. } => return false,
                Intensity::Sine { .. } => [load.value(0.5 * (a + b)); 2],
                Intensity::Linear { .. } => [a.max(load.from), b.min(load.to)].map(|x| load.value(x)),
            };
            values.into_iter().for_each(|q| signs = [signs[0] || q < 0.0, signs[1] || q > 0.0]);
        }
        signs != [true; 2]
    }

    /// `[∫ q, ∫ (b − x) q − ∫ c, ∫ p]` of the loads inside `[a, b]`, m, with the concentrated ones at `b` only if `with_end`:
    /// N, N m and N. What these take from V, add to M and take from N between two sections that have no point between them.
    pub fn carried(&self, [a, b]: [f64; 2], with_end: bool) -> [f64; 3] {
        self.carried.resultant(a, b, with_end)
    }

    /// Positions between `a` and `b` at which the stiffness or the loads are not smooth, or waves of loads turn, m.
    pub fn breaks(&self, [a, b]: [f64; 2]) -> impl Iterator<Item = f64> + '_ {
        // Ends of loads and points agree up to rounding.
        let (from, slack) = (self.chain.line().from, 1e-9 * (b - a));
        self.breaks.iter().map(move |s| from + s).filter(move |x| *x > a + slack && *x < b - slack)
    }

    /// The exact element on `[a, b]` whose ends have `(w, φ, u)`; without axial unknowns `u` is zero and no force acts along it.
    pub fn element(&self, [a, b]: [f64; 2], ends: [[f64; 3]; 2], has_axial: bool) -> Element<'_> {
        let [left, right] = ends;
        let line = self.chain.line();
        let is_smooth = line.stiffness.plain().is_some() && self.breaks([a, b]).next().is_none();
        let section = is_smooth.then(|| line.stiffness.compliance(a - line.from));
        let mut element =
            Element { inside: self, span: [a, b], start: left, forces: [0.0; 3], has_axial, section };
        let chord = right[0] - left[0] - 0.5 * (b - a) * (left[1] + right[1]);
        let asked = Vector3::new(right[2] - left[2], right[1] - left[1], chord);
        let mut closing = asked - Vector3::from(element.deformations(b, [0.0; 3], true));
        let column = |k: usize| {
            let unit = std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
            Vector3::from(element.deformations(b, unit, false))
        };
        let mut flexibility = Matrix3::from_columns(&[0, 1, 2].map(column));
        if !has_axial {
            (flexibility[(0, 0)], closing[0]) = (1.0, 0.0);
        }
        element.forces = match is_smooth {
            true => [0, 1, 2].map(|k| closing[k] / flexibility[(k, k)]),
            // A flexibility is positive: one that is not has lost all digits, and its element is straight.
            false => flexibility.lu().solve(&closing).map_or([0.0; 3], Into::into),
        };
        element
    }
}

/// An exact Timoshenko element under the loads inside it.
#[derive(Debug)]
pub struct Element<'a> {
    inside: &'a Inside<'a>,
    span: [f64; 2],
    /// `(w, φ, u)` at its start.
    start: [f64; 3],
    /// `(N, M, V)` that close it: M in its middle, without the loads.
    forces: [f64; 3],
    has_axial: bool,
    /// The compliance, where nothing varies or couples and the loads are smooth.
    section: Option<Compliance>,
}

impl Element<'_> {
    /// `(w, φ, u)` at a position inside, m.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let [a, b] = self.span;
        let [stretch, turn, chord] = self.deformations(x, self.forces, true);
        let [w, phi, u] = self.start;
        [w + phi * (x - a) + (x - 0.5 * (a + b)) * turn + chord, phi + turn, u + stretch]
    }

    /// `(∫ ε, ∫ κ, ∫ γ − κ (s − s_m))` from the start to `x` under the closing forces, and maybe the loads: with the middle
    /// s_m, M(s) = M − V (s − s_m) + ∫ (s − t) q − ∫ c, V(s) = V − ∫ q, N(s) = N − ∫ p.
    fn deformations(&self, x: f64, forces: [f64; 3], loaded: bool) -> [f64; 3] {
        let loaded = loaded && !self.inside.carried.is_empty();
        match self.section {
            Some(section) => {
                let closed = self.of_forces(x, forces, &section);
                let of_loads =
                    if loaded { self.integrate(&[(self.span[0], x)], [0.0; 3], true) } else { [0.0; 3] };
                [0, 1, 2].map(|k| closed[k] + of_loads[k])
            }
            None => {
                let inside = self.inside;
                let parts = pieces(inside.chain.line(), &inside.breaks, self.span[0], x);
                self.integrate(&parts, forces, loaded)
            }
        }
    }

    /// Deformations under the closing forces alone, of one section.
    fn of_forces(&self, x: f64, [n, m, v]: [f64; 3], section: &Compliance) -> [f64; 3] {
        let [a, b] = self.span;
        let (d, half) = (x - a, 0.5 * (b - a));
        // Integrals of (s − s_m) and of its square.
        let (first, second) = (0.5 * d * d - half * d, ((d - half).powi(3) + half.powi(3)) / 3.0);
        let stretch = if self.has_axial { section.axial * n * d } else { 0.0 };
        let turn = section.bending * (m * d - v * first);
        [stretch, turn, section.shear * v * d - section.bending * (m * first - v * second)]
    }

    fn integrate(&self, parts: &[(f64, f64)], [n, m, v]: [f64; 3], loaded: bool) -> [f64; 3] {
        let (line, [a, b]) = (self.inside.chain.line(), self.span);
        let middle = 0.5 * (a + b);
        // Of one section, the moments of straight loads and parabolas have at most the fourth degree.
        let few = self.section.is_some() && self.inside.carried.are_polynomials();
        let rule: &[(f64, f64)] = if few { &GAUSS_3 } else { &GAUSS };
        let mut sum = [0.0; 3];
        for &(from, to) in parts {
            for &(z, g) in rule {
                let (s, width) = (from + z * (to - from), g * (to - from));
                let c = self.section.unwrap_or_else(|| line.stiffness.compliance(s - line.from));
                let [q, lever, p] = if loaded { self.inside.carried([a, s], true) } else { [0.0; 3] };
                let (axial, moment, shear) = (n - p, m - v * (s - middle) + lever, v - q);
                let curvature = c.bending * moment + c.coupling * axial;
                if self.has_axial {
                    sum[0] += width * (c.coupling * moment + c.axial * axial);
                }
                sum[1] += width * curvature;
                sum[2] += width * (c.shear * shear - curvature * (s - middle));
            }
        }
        sum
    }
}
