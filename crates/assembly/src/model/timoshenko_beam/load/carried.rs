//! The loads of a line that its bonds carry.

use super::{BeamLoads, Distributed, Intensity, PointAction};
use crate::model::timoshenko_beam::Chain;
use std::borrow::Cow;

/// Loads that bonds carry.
#[derive(Debug)]
pub(super) struct Carried<'a> {
    pub(super) distributed: Vec<&'a Distributed>,
    pub(super) point: Vec<&'a PointAction>,
}

impl<'a> Carried<'a> {
    /// Those of a line.
    pub(super) fn of(loads: &'a BeamLoads, chain: usize) -> Self {
        Self {
            distributed: loads.distributed.iter().filter(|l| !loads.lumped && l.chain == chain).collect(),
            point: loads.point.iter().filter(|p| p.spread && p.chain == chain).collect(),
        }
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.distributed.is_empty() && self.point.is_empty()
    }

    /// Whether all loads are straight or parabolas.
    pub(super) fn are_polynomials(&self) -> bool {
        !self.distributed.iter().any(|load| matches!(load.intensity, Intensity::Sine { .. }))
    }

    /// `[∫ q, ∫ (b − x) q − ∫ c, ∫ p]` of all loads inside `[a, b]`, m, with the concentrated loads at `b` only if `with_end`:
    /// N, N m and N. What these take from V, add to M and take from N between two sections.
    pub(super) fn resultant(&self, a: f64, b: f64, with_end: bool) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for load in &self.distributed {
            let part = load.resultant(a, b);
            (0..3).for_each(|k| sum[k] += part[k]);
        }
        let slack = 1e-9 * (b - a);
        let points = self.concentrated([a + slack, if with_end { b + slack } else { b - slack }], b);
        [0, 1, 2].map(|k| sum[k] + points[k])
    }

    /// The distributed loads over `[a, b]`, m, and others that do not act there.
    pub(super) fn over(&self, a: f64, b: f64) -> Over<'_> {
        // So few are not worth a list.
        const FEW: usize = 4;
        if self.distributed.len() <= FEW {
            return Over(Cow::Borrowed(&self.distributed));
        }
        Over(self.distributed.iter().filter(|load| load.from < b && load.to > a).copied().collect())
    }

    /// The resultant, as of [`Self::resultant`], at the section `x` of the concentrated loads between `a` and `b`, m.
    pub(super) fn concentrated(&self, [a, b]: [f64; 2], x: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for p in self.point.iter().filter(|p| p.x > a && p.x < b) {
            sum[0] += p.force;
            sum[1] += p.force * (x - p.x) - p.moment;
            sum[2] += p.axial;
        }
        sum
    }

    /// Distances from the start of a line at which its stiffness or these loads are not smooth, in order.
    pub(super) fn breaks(&self, chain: &Chain) -> Vec<f64> {
        // Section forces jump under concentrated loads, and bend where distributed ones begin and end.
        let ends = self.distributed.iter().flat_map(|l| [l.from, l.to]);
        let places = self.point.iter().map(|p| p.x).chain(ends).map(|x| x - chain.line().from);
        let mut breaks: Vec<f64> = chain.line().stiffness.breaks().into_iter().chain(places).collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}

/// Distributed loads over a part of a line.
#[derive(Debug)]
pub(super) struct Over<'a>(Cow<'a, [&'a Distributed]>);

impl Over<'_> {
    /// The resultant, as of [`Carried::resultant`], at the section `b` from that at `a` before it, m.
    pub(super) fn add_to(&self, [force, lever, axial]: [f64; 3], a: f64, b: f64) -> [f64; 3] {
        let mut sum = [force, lever + force * (b - a), axial];
        for load in self.0.iter() {
            let part = load.resultant(a, b);
            (0..3).for_each(|k| sum[k] += part[k]);
        }
        sum
    }
}
