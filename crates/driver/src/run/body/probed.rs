//! What probes find in the local limit, and how far it can be trusted.
//!
//! Polynomials of the fourth degree over three spacings leave a part of the displacements where stresses vary over less. At holes
//! near an edge or each other and at notches, the error of a stress was mostly between a third of that part and three times it.

use super::BodyResult;
use super::of_stress::{Medium, of_stress};
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::body::{BodyProbe, BodyScene, Quantity};
use peristat_assembly::recovery::hole::Field;

/// A fit that misses a larger part of the displacements gives a warning.
const LARGE: f64 = 0.03;
/// Stresses below this part of the largest are small: a misfit there gives no warning.
const SMALL: f64 = 0.01;

/// What is found where a probe is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probed {
    field: Field,
    /// What polynomials miss there, relative to the displacements that strain the body; none where nothing tells.
    misfit: Option<f64>,
    /// Whether the stress is small beside the largest that acts on the body or that a probe finds.
    is_small: bool,
}

impl Probed {
    /// What fits say, what they miss, and the largest traction on the body, Pa.
    pub(super) fn all(fields: Vec<Field>, misfits: &[Option<f64>], traction: f64) -> Vec<Self> {
        let norm = |[xx, yy, xy]: [f64; 3]| (xx * xx + yy * yy + 2.0 * xy * xy).sqrt();
        let largest = fields.iter().map(|field| norm(field.stress)).fold(traction, f64::max);
        let of = |(field, &misfit): (Field, &Option<f64>)| {
            // What is missed may be most of it.
            let at_most = norm(field.stress) * (1.0 + misfit.unwrap_or(0.0));
            let is_small = at_most <= SMALL * largest;
            Self { field, misfit, is_small }
        };
        fields.into_iter().zip(misfits).map(of).collect()
    }
}

/// What a probe, by its number, finds at its place of corrected displacements, and for stresses the misfit.
pub(super) fn read(
    scene: &BodyScene,
    result: &BodyResult,
    (k, probe): (usize, &BodyProbe),
) -> Option<(f64, Option<f64>)> {
    let Quantity::Field { field, .. } = &probe.quantity else { return None };
    let Probed { field: Field { displacement, rotation, stress }, misfit, .. } = (*result.probed.get(k)?)?;
    if let Some((component, about)) = scene.model.component(field.name()) {
        let value = if about.is_rotation { Some(&rotation) } else { displacement.get(component) };
        return value.map(|value| (*value, None));
    }
    let stress = [stress[0], stress[1], stress[2], 0.0, 0.0, 0.0];
    let across = scene.model.across_of(stress);
    Some((of_stress(field.about().origin, Medium::of(scene), (0, stress), across)?, misfit))
}

/// What polynomials miss at most of all states, by probe, where the stress is not small.
#[derive(Debug)]
pub(super) struct Doubts(Vec<f64>);

impl Doubts {
    pub(super) fn of(scene: &BodyScene) -> Self {
        Self(vec![0.0; scene.probes.len()])
    }

    /// Takes a state in.
    pub(super) fn see(&mut self, result: &BodyResult) {
        for (worst, probed) in self.0.iter_mut().zip(&result.probed) {
            let misfit = probed.filter(|probed| !probed.is_small).and_then(|probed| probed.misfit);
            *worst = misfit.unwrap_or(0.0).max(*worst);
        }
    }

    /// Adds a warning for every probe of a stress that polynomials cannot tell.
    pub(super) fn warn(&self, scene: &BodyScene, warnings: &mut Faults) {
        for (probe, misfit) in scene.probes.iter().zip(&self.0) {
            if *misfit <= LARGE || !probe.is_recovered() {
                continue;
            }
            let percent = tidy((1000.0 * misfit).round() / 10.0);
            warnings
                .warning(
                    JsonPath::default().key("probes"),
                    format!(
                        "the stress at the probe `{}` is uncertain: the polynomials around it miss {percent} % of the displacements",
                        probe.name
                    ),
                )
                .hint("use a smaller spacing; around round and elliptic holes with nothing else near, fields of the hole tell the stress");
        }
    }
}
