//! Measures and moduli of the bonds of a line: one per class where nothing varies, else one per bond.

use super::super::bond::{BeamBond, Flexibility, UniformBending, UniformSection};
use super::Line;
use crate::bonds::BondGeometry;
use crate::material::Compliance;
use crate::quadrature::GAUSS;
use crate::stiffness::Weights;

/// The bonds of a line.
#[derive(Clone, Debug)]
pub enum BondTable {
    /// Uniform grid and section: one bond per class.
    Uniform {
        /// What the bonds follow.
        model: UniformBending,
        /// One per class.
        classes: Vec<BeamBond>,
    },
    /// Every bond its own, class by class.
    Each {
        /// Bonds of all classes; those of a class stand at the numbers of their lower points.
        bonds: Vec<BeamBond>,
        /// Points of the line.
        count: usize,
    },
}

impl BondTable {
    /// Bonds of a line of which the sections are plain; ⟨ξ²⟩ = `moment` (ξ/n)².
    pub(super) fn of_section(
        section: UniformSection,
        weights: &Weights,
        moment: f64,
        position: impl Fn(usize) -> f64,
        spacing: Option<f64>,
    ) -> Self {
        let (classes, count) = (weights.classes(), weights.points());
        let bond = |step: usize, length: f64| section.bond(length, moment * (length / step as f64).powi(2));
        if let Some(spacing) = spacing {
            let class = |c: usize| bond(weights.step(c), weights.step(c) as f64 * spacing);
            let model = UniformBending { section, mean_square_length: moment * spacing * spacing };
            return Self::Uniform { model, classes: (0..classes).map(class).collect() };
        }
        let each = |c: usize, lower: usize| {
            let upper = (lower + weights.step(c)).min(count - 1);
            bond(weights.step(c), position(upper) - position(lower))
        };
        let bonds = (0..classes).flat_map(|c| (0..count).map(move |lower| (c, lower)));
        Self::Each { bonds: bonds.map(|(c, lower)| each(c, lower)).collect(), count }
    }

    /// Bonds as exact elements of their spans, from the flexibility of every cell.
    pub(super) fn of_flexibility(line: &Line, weights: &Weights, position: impl Fn(usize) -> f64) -> Self {
        let count = weights.points();
        let breaks = line.stiffness.breaks();
        let cells: Vec<(f64, Flexibility)> =
            (0..count - 1).map(|k| cell(line, &breaks, position(k), position(k + 1))).collect();
        let bond = |class: usize, lower: usize| {
            let upper = (lower + weights.step(class)).min(count - 1);
            let (a, b) = (position(lower), position(upper));
            let (mut whole, middle) = (Flexibility::default(), 0.5 * (a + b));
            cells[lower..upper].iter().for_each(|(at, part)| whole.join(part, at - middle));
            whole.bond(b - a)
        };
        let all = (0..weights.classes()).flat_map(|c| (0..count).map(move |lower| (c, lower)));
        Self::Each { bonds: all.map(|(c, lower)| bond(c, lower)).collect(), count }
    }

    /// The bond of a class at a lower point.
    #[inline]
    pub fn bond(&self, class: usize, lower: usize) -> &BeamBond {
        match self {
            Self::Uniform { classes, .. } => &classes[class],
            Self::Each { bonds, count } => &bonds[class * count + lower],
        }
    }

    /// Geometry of the classes of a uniform table.
    pub(in super::super) fn geometries(classes: &[BeamBond]) -> Vec<BondGeometry> {
        classes.iter().map(|b| BondGeometry { xi: [b.length, 0.0, 0.0] }).collect()
    }
}

/// Middle and flexibility of the cell `[a, b]`, integrated between the breaks of the stiffness.
fn cell(line: &Line, breaks: &[f64], a: f64, b: f64) -> (f64, Flexibility) {
    let middle = 0.5 * (a + b);
    let mut sum = Flexibility::default();
    for (from, to) in pieces(line, breaks, a, b) {
        for (z, g) in GAUSS {
            let x = from + z * (to - from);
            sum.add(&line.stiffness.compliance(x - line.from), x - middle, g * (to - from));
        }
    }
    (middle, sum)
}

/// The parts of `[a, b]` that Gauss' rule integrates to rounding: between breaks, and short enough for the compliance to
/// change little.
pub(in super::super) fn pieces(line: &Line, breaks: &[f64], a: f64, b: f64) -> Vec<(f64, f64)> {
    let first = breaks.partition_point(|s| line.from + s <= a);
    let inside = breaks[first..].iter().map(|s| line.from + s).take_while(|x| *x < b);
    let ends: Vec<f64> = std::iter::once(a).chain(inside).chain([b]).collect();
    let mut pieces = Vec::with_capacity(ends.len());
    ends.windows(2).for_each(|w| divide(line, w[0], w[1], 0, &mut pieces));
    pieces
}

/// Halves `[a, b]` until the compliance varies by less than a half: the pole of 1/EI is then so far off that eight points
/// leave only rounding.
fn divide(line: &Line, a: f64, b: f64, depth: u32, pieces: &mut Vec<(f64, f64)>) {
    // Halvings of a cell: beyond, its points coincide.
    const DEEPEST: u32 = 48;
    // Pieces of a cell: poles need some hundred, and a stiffness that is rounding would never end.
    const MOST: usize = 4096;
    let varies = || {
        // Just inside: at a jump the value on the other side does not count.
        let at =
            [0.001, 0.25, 0.5, 0.75, 0.999].map(|z| line.stiffness.compliance(a + z * (b - a) - line.from));
        let most = |f: fn(&Compliance) -> f64| {
            let values = at.map(|c| f(&c));
            let (low, high) =
                values.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(v.abs()), h.max(v.abs())));
            high > 1.5 * low
        };
        most(|c| c.bending) || most(|c| c.shear) || most(|c| c.axial)
    };
    if depth < DEEPEST && pieces.len() < MOST && line.stiffness.varies() && varies() {
        let middle = 0.5 * (a + b);
        divide(line, a, middle, depth + 1, pieces);
        divide(line, middle, b, depth + 1, pieces);
    } else {
        pieces.push((a, b));
    }
}
