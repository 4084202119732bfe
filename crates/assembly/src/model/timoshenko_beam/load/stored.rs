//! Energy that loads store within bonds while their points are held. Displacements of the points add that of the bonds: strains without
//! a load between the points do no work on it. The weights of the bonds over a cell sum to one, so that both are that of the beam.

use super::{Along, Carried, Distributed, Inside, Intensity};
use crate::material::Compliance;
use std::ops::Range;

/// Bonds of a line, or of a half wave of its loads, from which on these are straight within a bond and the stiffness is that of its
/// middle: what bonds store by themselves is then less than a millionth, and this a millionth of it.
const FINE: f64 = 1e3;
/// Bonds that are not looked at one by one, if there is another way.
const MANY: usize = 256;

impl Inside<'_> {
    /// Energy of the loads within the bonds of the line, J.
    pub fn stored(&self, has_axial: bool) -> f64 {
        if self.carried.is_empty() {
            return 0.0;
        }
        let weights = self.chain.intact_weights();
        let of_class = |class: usize| {
            let bonds = 0..weights.points().saturating_sub(weights.step(class));
            if !bonds.is_empty() && self.are_alike() {
                return self.within(self.span(class, 0.0), has_axial) * weights.sum(class);
            }
            self.of_bonds(class, bonds, has_axial)
        };
        (0..weights.classes()).map(of_class).sum()
    }

    /// The same of the bonds of a class with lower points in a range, half by half while these are many.
    fn of_bonds(&self, class: usize, bonds: Range<usize>, has_axial: bool) -> f64 {
        let (chain, weights, count) = (self.chain, self.chain.intact_weights(), bonds.len());
        if count <= MANY {
            let span = |lower: usize| [lower, lower + weights.step(class)].map(|k| chain.position(k));
            return bonds
                .map(|lower| weights.weight(class, lower) * self.within(span(lower), has_axial))
                .sum();
        }
        if self.are_straight(class, &bonds) {
            // Of the second degree in the place of a bond: three tell the sum.
            let ends = [bonds.start, bonds.end - 1].map(|lower| lower as f64);
            let places = [ends[0], 0.5 * (ends[0] + ends[1]), ends[1]];
            let [first, middle, last] = places.map(|place| self.within(self.span(class, place), has_axial));
            let n = count as f64;
            let bow = (first - 2.0 * middle + last) * (n + 1.0) / (6.0 * (n - 1.0));
            return weights.of_class(class) * n * (middle + bow);
        }
        let half = bonds.start + count / 2;
        let of_half = |half: Range<usize>| self.over(class, &half).of_bonds(class, half, has_axial);
        of_half(bonds.start..half) + of_half(half..bonds.end)
    }

    /// What a bond of an even line spans; its lower point may be between two.
    fn span(&self, class: usize, lower: f64) -> [f64; 2] {
        let chain = self.chain;
        let start = chain.position(0) + lower * chain.spacing;
        [start, start + chain.weights.step(class) as f64 * chain.spacing]
    }

    /// Whether some bonds of a class are alike, on an even line under straight loads.
    fn are_straight(&self, class: usize, bonds: &Range<usize>) -> bool {
        let mut loads = self.carried.distributed.iter();
        self.chain.is_uniform()
            && loads.all(|load| matches!(load.intensity, Intensity::Linear { .. }))
            && self.chain.intact_weights().are_ordinary(bonds.clone())
            && self.breaks(self.reach(class, bonds)).next().is_none()
    }

    /// The part of a line that bonds of a class span.
    fn reach(&self, class: usize, bonds: &Range<usize>) -> [f64; 2] {
        [bonds.start, bonds.end - 1 + self.chain.weights.step(class)].map(|k| self.chain.position(k))
    }

    /// The same with the loads and breaks that such bonds see.
    fn over(&self, class: usize, bonds: &Range<usize>) -> Self {
        let [a, b] = self.reach(class, bonds);
        let (from, slack) = (self.chain.line().from, 1e-9 * (b - a));
        let sees = |x: f64| x > a - slack && x < b + slack;
        let distributed = self.carried.distributed.iter().filter(|load| load.from < b && load.to > a);
        let point = self.carried.point.iter().filter(|load| sees(load.x));
        Self {
            carried: Carried { distributed: distributed.copied().collect(), point: point.copied().collect() },
            chain: self.chain,
            breaks: self.breaks.iter().copied().filter(|s| sees(from + s)).collect(),
            plain: self.plain,
        }
    }

    /// Whether all bonds of a class carry the same.
    fn are_alike(&self) -> bool {
        let (chain, Carried { distributed, point }) = (self.chain, &self.carried);
        let [start, end] = [0, chain.points - 1].map(|k| chain.position(chain.ghosts[0] + k));
        let slack = 1e-9 * (end - start);
        let covers = |load: &&Distributed| load.from <= start + slack && load.to >= end - slack;
        chain.is_uniform()
            && point.is_empty()
            && distributed.iter().all(|load| load.constant().is_some() && covers(load))
    }

    /// Energy within a bond, its ends held.
    fn within(&self, span: [f64; 2], has_axial: bool) -> f64 {
        match self.straight(span) {
            Some((loads, section)) => of_straight(loads, 0.5 * (span[1] - span[0]), &section),
            None => self.element(span, [[0.0; 3]; 2], has_axial).energy(),
        }
    }

    /// The loads per length across and along a bond, the mean and half the rise of each, and its compliance, where all of these are
    /// straight or all but straight.
    fn straight(&self, [a, b]: [f64; 2]) -> Option<([[f64; 2]; 2], Compliance)> {
        let middle = 0.5 * (a + b);
        let section = self.plain.or_else(|| self.of_fine(middle, b - a))?;
        if self.breaks([a, b]).next().is_some() {
            return None;
        }
        let mut loads = [[0.0; 2]; 2];
        for load in self.carried.distributed.iter().filter(|load| load.from < middle && middle < load.to) {
            let row = match load.along {
                Along::Transverse => 0,
                Along::Axial => 1,
                Along::Rotation => return None,
            };
            let [left, right] = load.straight_over([a, b])?;
            loads[row][0] += 0.5 * (left + right);
            loads[row][1] += 0.5 * (right - left);
        }
        Some((loads, section))
    }

    /// The compliance of a bond that is short beside its line, where it varies and nothing couples.
    fn of_fine(&self, middle: f64, length: f64) -> Option<Compliance> {
        let line = self.chain.line();
        let is_fine = FINE * length <= line.length && !line.stiffness.couples();
        is_fine.then(|| line.stiffness.compliance(middle - line.from))
    }
}

impl Distributed {
    /// The values at both ends of a bond under it, where it is straight between them.
    fn straight_over(&self, ends: [f64; 2]) -> Option<[f64; 2]> {
        if let Some(value) = self.constant() {
            return Some([value; 2]);
        }
        let waves = match self.intensity {
            Intensity::Linear { .. } => 0,
            Intensity::Parabola { .. } => 1,
            Intensity::Sine { half_waves, .. } => half_waves,
        };
        let is_straight = FINE * f64::from(waves) * (ends[1] - ends[0]) <= self.to - self.from;
        is_straight.then(|| ends.map(|x| self.value(x)))
    }
}

/// Energy under straight loads per length of a bond of half the length h with held ends: `[mean, half the rise]` across and along it.
///
/// With ξ = s/h from the middle, the mean makes M = q h² (1/6 − ξ²/2) and V = q h ξ. The rise makes V = q h (v − ξ²/2) and
/// M = q h² (v ξ − ξ³/6), whose v makes the energy least. Along, they make N = p h ξ and p h (1/6 − ξ²/2).
fn of_straight([[q, dq], [p, dp]]: [[f64; 2]; 2], h: f64, section: &Compliance) -> f64 {
    let (shear, bending) = (section.shear, section.bending * h * h);
    let even = shear / 3.0 + bending / 45.0;
    let odd = shear / 20.0 + bending / 252.0
        - (shear / 3.0 + bending / 15.0).powi(2) / (4.0 * (shear + bending / 3.0));
    // The axial stiffness of what has no axial forces may not have been given.
    let along = if p == 0.0 && dp == 0.0 { 0.0 } else { section.axial * (p * p / 3.0 + dp * dp / 45.0) };
    h.powi(3) * (q * q * even + dq * dq * odd + along)
}
