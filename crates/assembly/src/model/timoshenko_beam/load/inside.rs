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
    pub(super) carried: Carried<'a>,
    pub(super) chain: &'a Chain,
    /// Distances from the start at which the stiffness or the loads are not smooth, or waves of loads turn, in order.
    pub(super) breaks: Vec<f64>,
    /// The compliance, where nothing varies or couples.
    pub(super) plain: Option<Compliance>,
}

impl<'a> Inside<'a> {
    /// Of a line with its number.
    pub fn new(loads: &'a BeamLoads, number: usize, chain: &'a Chain) -> Self {
        let carried = Carried::of(loads, number);
        let mut breaks = carried.breaks(chain);
        let waves = carried.distributed.iter().flat_map(|load| load.zeros_of_waves());
        breaks.extend(waves.map(|x| x - chain.line().from));
        breaks.sort_by(f64::total_cmp);
        let stiffness = &chain.line().stiffness;
        let plain = stiffness.plain().map(|_| stiffness.compliance(0.0));
        Self { carried, chain, breaks, plain }
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
        let section = self.plain.filter(|_| self.breaks([a, b]).next().is_none());
        let is_smooth = section.is_some();
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

    /// Its energy, J.
    pub(super) fn energy(&self) -> f64 {
        let [a, b] = self.span;
        let density = |_: f64, c: &Compliance, [n, m, v]: [f64; 3]| {
            let axial = if self.has_axial { n * (c.axial * n + 2.0 * c.coupling * m) } else { 0.0 };
            [0.5 * (c.bending * m * m + c.shear * v * v + axial)]
        };
        let [energy] = self.integrate(&GAUSS, &self.parts([a, b]), self.forces, true, density);
        energy
    }

    /// The parts of what lies between two positions in which the stiffness and the loads are smooth.
    fn parts(&self, [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
        pieces(self.inside.chain.line(), &self.inside.breaks, from, to)
    }

    /// `(∫ ε, ∫ κ, ∫ γ − κ (s − s_m))` from the start to `x` under the closing forces, and maybe the loads.
    fn deformations(&self, x: f64, forces: [f64; 3], loaded: bool) -> [f64; 3] {
        let loaded = loaded && !self.inside.carried.is_empty();
        let [a, b] = self.span;
        let middle = 0.5 * (a + b);
        let rates = |s: f64, c: &Compliance, [n, m, v]: [f64; 3]| {
            let curvature = c.bending * m + c.coupling * n;
            let stretch = if self.has_axial { c.coupling * m + c.axial * n } else { 0.0 };
            [stretch, curvature, c.shear * v - curvature * (s - middle)]
        };
        let Some(section) = self.section else {
            return self.integrate(&GAUSS, &self.parts([a, x]), forces, loaded, rates);
        };
        let closed = self.of_forces(x, forces, &section);
        if !loaded {
            return closed;
        }
        // The moments of straight loads and parabolas have at most the fourth degree.
        let rule: &[(f64, f64)] = if self.inside.carried.are_polynomials() { &GAUSS_3 } else { &GAUSS };
        let of_loads = self.integrate(rule, &[(a, x)], [0.0; 3], true, rates);
        [0, 1, 2].map(|k| closed[k] + of_loads[k])
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

    /// Integrates what is given of a position, its compliance and its section forces `(N, M, V)`. Under closing forces, and maybe the
    /// loads, these are, with the middle s_m: M(s) = M − V (s − s_m) + ∫ (s − t) q − ∫ c, V(s) = V − ∫ q, N(s) = N − ∫ p.
    fn integrate<const N: usize>(
        &self,
        rule: &[(f64, f64)],
        parts: &[(f64, f64)],
        [n, m, v]: [f64; 3],
        loaded: bool,
        of: impl Fn(f64, &Compliance, [f64; 3]) -> [f64; N],
    ) -> [f64; N] {
        let (line, [a, b]) = (self.inside.chain.line(), self.span);
        let middle = 0.5 * (a + b);
        let (mut sum, mut before) = ([0.0; N], [0.0; 3]);
        for &(from, to) in parts {
            let carried = &self.inside.carried;
            let over = carried.over(from, to);
            // Concentrated loads are at ends of parts, up to rounding.
            let points = carried.concentrated([a + 1e-9 * (b - a), 0.5 * (from + to)], from);
            let start = [0, 1, 2].map(|k| before[k] + points[k]);
            for &(z, g) in rule {
                let (s, width) = (from + z * (to - from), g * (to - from));
                let c = self.section.unwrap_or_else(|| line.stiffness.compliance(s - line.from));
                let [q, lever, p] = if loaded { over.add_to(start, from, s) } else { [0.0; 3] };
                let rates = of(s, &c, [n - p, m - v * (s - middle) + lever, v - q]);
                (0..N).for_each(|k| sum[k] += width * rates[k]);
            }
            before = over.add_to(before, from, to);
        }
        sum
    }
}
