//! The loads of a line that its bonds carry.

use super::{BeamLoads, Distributed, Intensity, PointAction};
use crate::model::timoshenko_beam::Chain;

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
        for p in &self.point {
            if p.x > a + slack && p.x < if with_end { b + slack } else { b - slack } {
                sum[0] += p.force;
                sum[1] += p.force * (b - p.x) - p.moment;
                sum[2] += p.axial;
            }
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
