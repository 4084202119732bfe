//! Results of one state of a plate.

use super::along_lines::{AlongLines, along_lines};
use super::of_moments::{of_moments, stresses};
use super::reaction::{self, PlateReaction};
use crate::case::{FieldName, Origin, PlateOrigin};
use crate::run::fracture::Facts;
use crate::run::{Resultants, SolvedState, StateRecord};
use crate::scene::body::BodyState;
use crate::scene::plate::Thickness;
use crate::scene::{PlateScene, Resultant};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, PlateBending, PlateFields, W};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The result of one state of a plate in bending.
#[derive(Clone, Debug)]
pub struct PlateResult {
    /// State, unknowns (the planes of w, φ_x and φ_y) and certificate.
    pub record: StateRecord,
    /// Curvatures, moments and shear forces, where they were asked for.
    pub recovered: Option<PlateFields>,
    /// Forces of the supports on the plate, in the order of the case, lines of symmetry last.
    pub reactions: Vec<PlateReaction>,
    /// The same along lines that supports hold, per length, and at their ends.
    pub along_lines: AlongLines,
    /// Part of the bonds of every point that has broken; nothing of a plate that does not break.
    pub damage: Vec<f64>,
    /// Forces that hold the equations of the scene, in their order.
    pub(super) multipliers: Vec<f64>,
    points: usize,
    thickness: Arc<Thickness>,
}

/// Curvatures, moments and shear forces of a state, with what goes on behind lines of symmetry.
fn recovered((scene, plate): (&PlateScene, &PlateBending), state: &BodyState, u: &[f64]) -> PlateFields {
    let mirrors = scene.supports.iter().filter(|support| support.is_mirror);
    let terms = mirrors.flat_map(|mirror| &scene.equations[mirror.equations.clone()]).flat_map(|e| &e.terms);
    let on: BTreeSet<(usize, usize)> = terms.map(|(held, _)| (held.point, held.component)).collect();
    let of_term =
        |&(case, factor): &(usize, f64)| scene.load_cases[case].free.iter().map(move |free| (factor, free));
    let free: Vec<_> = state.terms.iter().flat_map(of_term).collect();
    plate.fields(u, &free, &|point| [PHI_X, PHI_Y].map(|across| on.contains(&(point, across))))
}

/// What an equilibrium is, beside its unknowns.
pub(super) struct Equilibrium {
    /// Name of its record.
    pub(super) name: String,
    /// Factor on the loads as written.
    pub(super) load_factor: f64,
    /// Facts of a plate that breaks.
    pub(super) facts: Option<Facts>,
}

/// Collects the result of a state.
pub(super) fn collect(scene: &PlateScene, solved: SolvedState, recover: bool) -> PlateResult {
    let state = &scene.states[solved.state];
    let (name, load_factor) = (state.name.clone(), state.load_factor);
    of_plate((scene, &scene.plate), solved, Equilibrium { name, load_factor, facts: None }, recover)
}

/// The result of an equilibrium of the plate of a scene, some of whose bonds may have broken.
pub(super) fn of_plate(
    (scene, plate): (&PlateScene, &PlateBending),
    solved: SolvedState,
    Equilibrium { name, load_factor, facts }: Equilibrium,
    recover: bool,
) -> PlateResult {
    let SolvedState { state: index, load, solution, mut certificate } = solved;
    // A plate that breaks has one load case.
    let state = &scene.states[if facts.is_some() { 0 } else { index }];
    let u = solution.u;
    let n = scene.plate.nodes().points();
    let springs = scene.springs.iter().flat_map(|spring| spring.forces(n, &u)).map(|(k, f)| (k, -f));
    let held = scene.resultant(solution.held.iter().copied().chain(springs));
    let mut asked = Resultant::default();
    asked.add_multiple(if facts.is_some() { load_factor } else { 1.0 }, &scene.asked(state));
    let mut applied = scene.resultant(load.iter().copied().enumerate());
    // What curves a plate without moments is no load: the plate bends itself.
    let heat = scene.heat(state);
    applied.add_multiple(-1.0, &scene.resultant(heat.forces().enumerate()));
    let is_heated = heat.forces().next().is_some();
    let fields = (recover || is_heated).then(|| recovered((scene, plate), state, &u));
    if let Some(fields) = fields.as_ref().filter(|_| is_heated) {
        certificate.energy = scene.energy(fields);
    }
    // Loads on parts that have come off act no more.
    let asked = if facts.is_none() || index == 0 { asked } else { applied };
    let resultants = Resultants::new(&asked, &applied, &held, (scene.statical(), [false; 3]));
    certificate.account(resultants, scene.slack(state));
    let damage = if facts.is_some() { plate.damage() } else { Vec::new() };
    PlateResult {
        reactions: reaction::of_supports(scene, &solution.multipliers, &u),
        along_lines: along_lines(scene, &solution.multipliers, &u),
        recovered: fields.filter(|_| recover),
        multipliers: solution.multipliers,
        damage,
        points: n,
        thickness: scene.thickness.clone(),
        record: StateRecord { index, name, load_factor, u, certificate, facts },
    }
}

/// The component of the unknowns that is a field.
pub(super) fn plane(field: FieldName) -> Option<usize> {
    match field {
        FieldName::W => Some(W),
        FieldName::PhiX => Some(PHI_X),
        FieldName::PhiY => Some(PHI_Y),
        _ => None,
    }
}

impl PlateResult {
    /// The fields that tables show, in their order.
    pub fn fields(&self) -> impl Iterator<Item = FieldName> {
        let is_there = |field: &FieldName| match field {
            FieldName::Damage => !self.damage.is_empty(),
            _ => self.recovered.is_some() || !field.is_recovered(),
        };
        FieldName::PLATE.into_iter().filter(is_there)
    }

    /// The unknowns that are a field.
    fn unknowns(&self, field: FieldName) -> Option<&[f64]> {
        let plane = plane(field)?;
        Some(&self.record.u[plane * self.points..(plane + 1) * self.points])
    }

    /// Values of a field at all points; `None` where it was not recovered or does not exist.
    pub fn values(&self, field: FieldName) -> Option<Cow<'_, [f64]>> {
        if let Some(values) = self.unknowns(field) {
            return Some(values.into());
        }
        (0..self.points as u32).map(|point| self.value(field, &[(point, 1.0)])).collect()
    }

    /// Value of a field as a sum over points; what follows from moments is that of the summed moments.
    pub fn value(&self, field: FieldName, weights: &[(u32, f64)]) -> Option<f64> {
        if let Some(values) = self.unknowns(field) {
            return Some(weights.iter().map(|&(p, w)| w * values[p as usize]).sum());
        }
        let sum = |of: &dyn Fn(usize) -> f64| weights.iter().map(|&(p, w)| w * of(p as usize)).sum::<f64>();
        if field == FieldName::Damage {
            // Zero where nothing breaks.
            return Some(sum(&|p| self.damage.get(p).copied().unwrap_or(0.0)));
        }
        let recovered = self.recovered.as_ref()?;
        match field.about().origin {
            Origin::Plate(PlateOrigin::Curvature(k)) => Some(sum(&|p| recovered.curvature[p][k])),
            Origin::Plate(PlateOrigin::Shear(k)) => Some(sum(&|p| recovered.shear[p][k])),
            origin => {
                let (mut moment, mut stress) = ([0.0; 3], [0.0; 3]);
                for &(point, weight) in weights {
                    let own = recovered.moment[point as usize];
                    // Of points: on a step those of the thinner side are the larger ones.
                    let of_own = stresses(own, self.thickness.at(point as usize));
                    for k in 0..3 {
                        moment[k] += weight * own[k];
                        stress[k] += weight * of_own[k];
                    }
                }
                of_moments(origin, moment, stress)
            }
        }
    }
}
