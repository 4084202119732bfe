//! Reactions of the supports of a strain form.

use peristat_assembly::model::timoshenko_beam::{ChainLoads, Resultant, StrainAction, StrainSupport};
use peristat_assembly::sum::Sum;

/// A reaction per support.
#[derive(Clone, Debug)]
pub(super) struct Reactions(Vec<Sum>);

impl Reactions {
    /// What the first `rigid` supports take of the loads on their own points: a load on a support moves nothing, to the
    /// last bit.
    pub(super) fn first(supports: &[StrainSupport], rigid: usize, loads: &ChainLoads) -> Self {
        let mut reactions = vec![Sum::default(); supports.len()];
        for (reaction, s) in reactions.iter_mut().zip(supports).take(rigid) {
            let mut force = [[0.0]; 2];
            let [w, phi] = &mut force;
            loads.add_block(s.point..s.point + 1, &mut [w, phi]);
            *reaction = Sum::of(-force[s.component][0]);
        }
        Self(reactions)
    }

    /// The values.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().map(|r| r.total())
    }

    /// The reactions as forces on the beam.
    pub(super) fn actions(&self, supports: &[StrainSupport]) -> Vec<StrainAction> {
        let action = |(s, &value): (&StrainSupport, &Sum)| StrainAction {
            point: s.point,
            component: s.component,
            value,
        };
        supports.iter().zip(&self.0).filter(|(_, r)| **r != Sum::default()).map(action).collect()
    }

    /// Adds corrections.
    pub(super) fn add(&mut self, more: &[f64]) {
        self.0.iter_mut().zip(more).for_each(|(sum, &x)| sum.add(x));
    }

    /// Lets rigid supports of the first point take what the other forces leave over: there they move nothing. Returns the
    /// rest.
    pub(super) fn balance(&mut self, supports: &[StrainSupport], resultant: Resultant) -> [f64; 2] {
        let mut left_over = resultant.sum;
        for (s, r) in supports.iter().zip(&mut self.0).filter(|(s, _)| s.point == 0 && s.compliance == 0.0) {
            r.add(-std::mem::take(&mut left_over[s.component]));
        }
        left_over
    }

    /// What rounding takes from all forces, and from all couples, as doubles.
    pub(super) fn rounding(&self, supports: &[StrainSupport]) -> [f64; 2] {
        let mut rounding = [0.0; 2];
        for (s, reaction) in supports.iter().zip(&self.0) {
            rounding[s.component] += reaction.parts()[1].abs();
        }
        rounding
    }

    /// Magnitudes of all forces, the reactions of the first point included.
    pub(super) fn sizes(&self, supports: &[StrainSupport], resultant: Resultant) -> [f64; 2] {
        let mut sizes = resultant.size;
        for (s, r) in supports.iter().zip(self.values()).filter(|(s, _)| s.point == 0) {
            sizes[s.component] += r.abs();
        }
        sizes
    }
}
