//! Reactions of the supports of a strain form.

use peristat_assembly::model::timoshenko_beam::{ChainLoads, Resultant, StrainAction, StrainSupport};

/// A reaction per support, each as a sum that is not rounded: the rounding of a reaction alone bends a redundant beam by
/// more than that of its displacements.
#[derive(Clone, Debug)]
pub(super) struct Reactions(Vec<[f64; 2]>);

impl Reactions {
    /// What the first `rigid` supports take of the loads on their own points: a load on a support moves nothing, to the
    /// last bit.
    pub(super) fn first(supports: &[StrainSupport], rigid: usize, loads: &ChainLoads) -> Self {
        let mut reactions = vec![[0.0; 2]; supports.len()];
        for (reaction, s) in reactions.iter_mut().zip(supports).take(rigid) {
            let mut force = [[0.0]; 2];
            let [w, phi] = &mut force;
            loads.add_block(s.point..s.point + 1, &mut [w, phi]);
            reaction[0] = -force[s.component][0];
        }
        Self(reactions)
    }

    /// The values.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().map(|r| r[0])
    }

    /// The reactions as forces on the beam.
    pub(super) fn actions(&self, supports: &[StrainSupport]) -> Vec<StrainAction> {
        let action = |(s, &value): (&StrainSupport, &[f64; 2])| StrainAction {
            point: s.point,
            component: s.component,
            value,
        };
        supports.iter().zip(&self.0).filter(|(_, r)| **r != [0.0; 2]).map(action).collect()
    }

    /// Adds corrections.
    pub(super) fn add(&mut self, more: &[f64]) {
        self.0.iter_mut().zip(more).for_each(|(sum, &x)| add(sum, x));
    }

    /// Lets supports of the first point take what the other forces leave over: there they strain nothing. Returns the rest.
    pub(super) fn balance(&mut self, supports: &[StrainSupport], resultant: Resultant) -> [f64; 2] {
        let mut left_over = resultant.sum;
        for (s, r) in supports.iter().zip(&mut self.0).filter(|(s, _)| s.point == 0) {
            add(r, -std::mem::take(&mut left_over[s.component]));
        }
        left_over
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

/// Adds to a sum that is not rounded (Knuth).
fn add(sum: &mut [f64; 2], x: f64) {
    let high = sum[0] + x;
    let taken = high - sum[0];
    sum[1] += (sum[0] - (high - taken)) + (x - taken);
    sum[0] = high;
}
