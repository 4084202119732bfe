//! Displacements of all points against closed forms.

use super::BeamResult;
use crate::case::FieldName;
use crate::reference::{Field, Solution};
use crate::run::verdict::{BLOCK, Worst};
use crate::scene::beam::{BeamComparison, BeamScene};
use crate::scene::{Expectation, ExpectationKind};

/// Closed forms by name, with the worst of w and of φ, where a check asks for it.
#[derive(Debug, Default)]
pub(super) struct Compared<'a>(Vec<(&'a str, [Option<Worst>; 2])>);

/// Place of a displacement among the compared ones.
fn place(field: Field) -> Option<usize> {
    match field {
        Field::W => Some(0),
        Field::Phi => Some(1),
        Field::M | Field::V | Field::Energy => None,
    }
}

impl<'a> Compared<'a> {
    /// Compares the displacements that checks ask for. Those that share a closed form share its evaluation, which takes
    /// more time than the comparison.
    pub(super) fn new(
        scene: &BeamScene,
        checks: &[&'a Expectation<BeamComparison>],
        result: &BeamResult,
    ) -> Self {
        let mut asked: Vec<(&'a str, &Solution, [bool; 2])> = Vec::new();
        for check in checks {
            if let ExpectationKind::Points(BeamComparison::ClosedForm { reference, solution, field, .. }) =
                &check.kind
                && let Some(place) = place(*field)
            {
                let known = asked.iter().position(|a| a.0 == reference.as_str());
                let at = known.unwrap_or(asked.len());
                if known.is_none() {
                    asked.push((reference.as_str(), solution, [false; 2]));
                }
                asked[at].2[place] = true;
            }
        }
        let compare = |(reference, solution, asked)| (reference, compare(scene, solution, asked, result));
        Self(asked.into_iter().map(compare).collect())
    }

    /// The worst of a displacement against a closed form.
    pub(super) fn worst(&self, reference: &str, field: Field) -> Option<Worst> {
        self.0.iter().find(|c| c.0 == reference)?.1[place(field)?]
    }
}

/// The worst of w and φ on the first line, those that are asked for.
fn compare(
    scene: &BeamScene,
    solution: &Solution,
    asked: [bool; 2],
    result: &BeamResult,
) -> [Option<Worst>; 2] {
    let (line, from) = (&result.lines[0], scene.beam.chains()[0].line().from);
    let found = [FieldName::W, FieldName::Phi].map(|field| result.values(field, 0).unwrap_or_default());
    let mut worst = asked.map(|asked| asked.then_some(Worst::NONE));
    let (mut x, mut w, mut phi) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
    for start in (0..line.x.len()).step_by(BLOCK) {
        let count = BLOCK.min(line.x.len() - start);
        let x = &mut x[..count];
        line.x.fill(start, x);
        x.iter_mut().for_each(|x| *x -= from);
        (solution.displacements)(x, [&mut w[..count], &mut phi[..count]]);
        for (worst, (expected, found)) in worst.iter_mut().zip([&w, &phi].into_iter().zip(&found)) {
            if let Some(worst) = worst {
                worst.take(&expected[..count], &found[start..start + count]);
            }
        }
    }
    worst
}
