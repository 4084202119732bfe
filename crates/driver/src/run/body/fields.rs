//! Results of one state of a body in the plane.

use super::eigenstrain::EigenStress;
use super::modes;
use super::of_stress::{Medium, component, of_stress};
use super::probed::Probed;
use super::reaction::{self, BodyReaction, MirrorReaction};
use crate::case::{FieldName, Origin};
use crate::run::{Corrections, Resultants, SolvedState, StateRecord};
use crate::scene::Resultant;
use crate::scene::body::{BodyScene, Eigenstrain, Has, HoleRing, Intensity, Says, of_points};
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::solid::TENSOR;
use peristat_assembly::recovery::hole::HoleFit;
use rayon::prelude::*;
use std::borrow::Cow;

/// Points whose values one thread makes at least.
const FEW: usize = 4096;

/// Fields recovered from the bonds, by points of the model; images have those of their points, shears with their signs.
#[derive(Clone, Debug)]
pub struct Recovered {
    /// The components that the model names, `[σ_xx, σ_yy, σ_xy]` in the plane.
    pub stress: Vec<Vec<f64>>,
    /// σ_zz, around the axis of a body of revolution; empty in others.
    pub across: Vec<f64>,
    /// Strain energy density.
    pub energy_density: Vec<f64>,
    /// Cut share of the family of every point; none without cracks.
    pub damage: Option<Vec<f64>>,
    /// What strains that need no stress would have.
    pub eigenstrain: Option<Box<EigenStress>>,
}

impl Recovered {
    /// What is recovered of displacements, with strains of the state that need no stress.
    fn new(
        (scene, model): (&BodyScene, &dyn BodyModel),
        eigenstrain: Option<&Eigenstrain>,
        u: &[f64],
    ) -> Self {
        let fields = model.recover(u);
        let mut found = Self {
            stress: fields.stress,
            across: fields.across,
            energy_density: fields.energy_density,
            damage: scene.is_damaged().then(|| model.damage()),
            eigenstrain: None,
        };
        if let Some(own) = eigenstrain {
            found.take_off(own, scene.material().surface(), model);
        }
        found.fill_images(scene);
        found
    }

    /// A field that follows from the stresses, as a sum over points that have the material of one.
    fn of_stress(
        &self,
        medium: Medium,
        origin: Origin,
        point: usize,
        sum: impl Fn(&[f64]) -> f64,
    ) -> Option<f64> {
        let stress = self.at(&sum);
        let across = match self.across.is_empty() {
            true => medium.model.across_at(point, stress),
            false => sum(&self.across),
        };
        let is_strain = matches!(origin, Origin::Strain(..) | Origin::FibreStrain(_));
        let (stress, across) = match &self.eigenstrain {
            Some(own) if is_strain => own.add_to(sum, (stress, across)),
            _ => (stress, across),
        };
        of_stress(origin, medium, (point, stress), across)
    }

    /// One number of every component of the stress; zeros behind the last.
    pub(super) fn at(&self, of: impl Fn(&[f64]) -> f64) -> [f64; TENSOR] {
        std::array::from_fn(|k| self.stress.get(k).map_or(0.0, |values| of(values)))
    }

    /// Gives images the values of their points.
    pub(super) fn fill_images(&mut self, scene: &BodyScene) {
        let Some((lattice, mirrors)) = scene.model.lattice() else { return };
        for &ghost in scene.model.ghosts() {
            let ghost = ghost as usize;
            let (cell, signs) = mirrors.image(lattice.cell(ghost));
            let Some(real) = lattice.number(cell) else { continue };
            for (values, name) in self.stress.iter_mut().zip(scene.model.tensor_components()) {
                let sign: f64 = name.bytes().map(|axis| signs[usize::from(axis - b'x')]).product();
                values[ghost] = sign * values[real];
            }
            self.energy_density[ghost] = self.energy_density[real];
            if !self.across.is_empty() {
                self.across[ghost] = self.across[real];
            }
            if let Some(damage) = &mut self.damage {
                damage[ghost] = damage[real];
            }
        }
    }
}

/// The result of one state of a body in the plane.
#[derive(Clone, Debug)]
pub struct BodyResult {
    /// State, unknowns (the planes of ux, uy and, where points turn, of multiples of phi, of shells of w) and certificate.
    pub record: StateRecord,
    /// Stresses and what follows from them, where they were asked for.
    pub recovered: Option<Recovered>,
    /// Forces of the supports and of rigid regions on the body, in the order of the case.
    pub reactions: Vec<BodyReaction>,
    /// Forces through lines of symmetry.
    pub mirrors: Vec<MirrorReaction>,
    /// Stress intensities, in the order of the case.
    pub intensities: Vec<f64>,
    /// Fields around the holes on which probes ask for stresses.
    pub(super) hole_fits: Vec<HoleFit>,
    /// How its displacements were corrected.
    pub corrections: Option<Corrections>,
    /// Displacement and stress where every probe is, of displacements that were corrected.
    pub(super) probed: Vec<Option<Probed>>,
    /// Neighbours on the lattice of the model whose bond has broken.
    pub(super) parted: Vec<[usize; 2]>,
    /// Number of points of the model.
    points: usize,
    /// The fields that its points have, but for those that are zero everywhere by the nature of the body.
    shown: Vec<FieldName>,
    /// Forces that hold the equations of the scene, in their order.
    pub(super) multipliers: Vec<f64>,
}

/// Those of the pairs of points of bonds that are neighbours along a row or a column; none of a cloud.
pub(super) fn parted(model: &dyn BodyModel, bonds: impl Iterator<Item = [usize; 2]>) -> Vec<[usize; 2]> {
    let Some((lattice, _)) = model.lattice() else { return Vec::new() };
    let are_neighbours = |ends: &[usize; 2]| {
        let [a, b] = ends.map(|point| lattice.cell(point));
        a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).sum::<u32>() == 1
    };
    bonds.filter(are_neighbours).collect()
}

/// Collects the result of a state; `intensities` are those of all states, by stress intensity, `rings` are around holes.
pub(super) fn collect(
    scene: &BodyScene,
    solved: SolvedState,
    (intensities, rings): (&[Vec<f64>], &[HoleRing]),
    recover: bool,
) -> BodyResult {
    let SolvedState { state: index, solution, certificate, load, .. } = solved;
    let state = &scene.states[index];
    let record = StateRecord {
        index,
        name: state.name.clone(),
        load_factor: state.load_factor,
        u: solution.u,
        certificate,
        facts: None,
    };
    let reported = |(own, k): (&Intensity, &Vec<f64>)| modes::reported(scene, own, k[index], &record.u);
    let intensities = scene.intensities.iter().zip(intensities).map(reported).collect();
    let forces = (solution.multipliers, load, scene.asked(state));
    let corrections = solution.corrections;
    let hole_fits = rings.iter().filter_map(|ring| ring.fit(scene, state, &record.u)).collect();
    BodyResult {
        hole_fits,
        corrections,
        ..BodyResult::new(
            (scene, &*scene.model, scene.eigenstrain(state)),
            record,
            forces,
            intensities,
            recover,
        )
    }
}

impl BodyResult {
    /// The result of a solution and its strains that need no stress, with the forces that hold the equations of the scene and the
    /// relations of its model, the loads, and their resultant as it was asked for.
    pub(super) fn new(
        (scene, model, eigenstrain): (&BodyScene, &dyn BodyModel, Option<Eigenstrain>),
        mut record: StateRecord,
        (mut multipliers, load, asked): (Vec<f64>, &[f64], Resultant),
        intensities: Vec<f64>,
        recover: bool,
    ) -> Self {
        // Bodies that break or soften have one load case.
        let (state, factor) = match scene.case.is_traced() {
            true => (&scene.states[0], record.load_factor),
            false => (&scene.states[record.index], 1.0),
        };
        let mut recovered = None;
        if recover || eigenstrain.is_some() {
            recovered = Some(Recovered::new((scene, model), eigenstrain.as_ref(), &record.u));
        }
        if let (Some(_), Some(recovered)) = (&eigenstrain, &recovered) {
            record.certificate.energy = recovered.energy(model);
        }
        let recovered = recovered.filter(|_| recover);
        // What stretches a body and its images without stress is no load: the body stretches itself.
        let stretching = eigenstrain.map(|own| own.load(model, load.len()));
        let others: Option<Vec<f64>> =
            stretching.as_ref().map(|own| load.iter().zip(own).map(|(all, own)| all - own).collect());
        let taken = scene.into_mirrors(state, factor);
        let mirrors = reaction::of_mirrors(scene, &multipliers, others.as_deref().unwrap_or(load), &taken);
        multipliers.truncate(scene.equations.len());
        let reactions = reaction::of_supports(scene, &multipliers, &record.u);
        let held = reaction::resultant(scene, &multipliers, &record.u, &mirrors);
        let counted = (scene.statical(), scene.inside(state));
        let mut applied = scene.resultant(load);
        stretching.iter().for_each(|own| applied.add_multiple(-1.0, &scene.resultant(own)));
        taken.iter().for_each(|&(_, force)| applied.add(force, [0.0; 3]));
        let resultants = Resultants::new(&asked, &applied, &held, counted);
        // Loads on parts that have come off act no more.
        let whole = !scene.case.is_traced() || record.index == 0;
        record.certificate.account(resultants, if whole { scene.slack(state) } else { f64::INFINITY });
        let says = Says::of(&scene.case, scene.material());
        Self {
            record,
            recovered,
            reactions,
            mirrors,
            intensities,
            hole_fits: Vec::new(),
            corrections: None,
            probed: Vec::new(),
            parted: Vec::new(),
            points: scene.model.points(),
            shown: FieldName::BODY
                .into_iter()
                .filter(|&field| of_points(field, model, scene.is_damaged(), says) == Has::Values)
                .collect(),
            multipliers,
        }
    }

    /// The fields that tables show, in their order: those that all points have, but for those that are zero everywhere by
    /// the nature of the body.
    pub fn fields(&self) -> impl Iterator<Item = FieldName> {
        self.shown.iter().copied().filter(|f| self.recovered.is_some() || !f.is_recovered())
    }

    /// Values that are kept, with the numbers that points have in the model, and what they are divided by.
    fn kept(&self, scene: &BodyScene, field: FieldName) -> Option<(&[f64], f64)> {
        let (n, recovered) = (self.points, self.recovered.as_ref());
        let values = match field.about().origin {
            Origin::Unknown => {
                let (k, component) = scene.model.component(field.name())?;
                return Some((&self.record.u[k * n..(k + 1) * n], component.scale));
            }
            Origin::Stress(name) => match component(&*scene.model, name) {
                Some(k) => &recovered?.stress[k],
                None => Some(&recovered?.across).filter(|across| name == "zz" && !across.is_empty())?,
            },
            Origin::Energy => &recovered?.energy_density,
            Origin::Damage => recovered?.damage.as_ref()?,
            Origin::Temperature => &recovered?.eigenstrain.as_ref()?.change,
            Origin::Strain(..)
            | Origin::VonMises
            | Origin::Principal(_)
            | Origin::PrincipalDirection
            | Origin::MaxShear
            | Origin::Hydrostatic
            | Origin::FibreStress(_)
            | Origin::FibreStrain(_)
            | Origin::TsaiHill
            | Origin::TsaiWu
            | Origin::HashinFibre
            | Origin::HashinMatrix
            | Origin::Utilisation
            | Origin::Beam
            | Origin::Plate(_)
            | Origin::Material
            | Origin::Opening
            | Origin::Reaction(_)
            | Origin::Turn(_) => {
                return None;
            }
        };
        Some((values, 1.0))
    }

    /// Neighbours of the body on its lattice whose bond has broken, images left out.
    pub fn parted(&self, scene: &BodyScene) -> Vec<[usize; 2]> {
        let ghosts = scene.model.ghosts();
        // Where a point stands among those of the body.
        let number = |point: usize| match ghosts.binary_search(&(point as u32)) {
            Ok(_) => None,
            Err(before) => Some(point - before),
        };
        self.parted.iter().filter_map(|&[a, b]| Some([number(a)?, number(b)?])).collect()
    }

    /// Values of a field at the points of the body, images left out.
    pub fn values(&self, scene: &BodyScene, field: FieldName) -> Option<Cow<'_, [f64]>> {
        let whole = scene.model.ghosts().is_empty();
        if let Some((kept, divisor)) = self.kept(scene, field) {
            return Some(match whole && divisor == 1.0 {
                true => kept.into(),
                false => scene.real_points().map(|p| kept[p] / divisor).collect(),
            });
        }
        if field == FieldName::Material {
            let numbers = &scene.materials().numbers;
            return (!numbers.is_empty()).then(|| numbers.iter().map(|number| f64::from(*number)).collect());
        }
        let recovered = self.recovered.as_ref()?;
        let origin = field.about().origin;
        // What no crack and no load has brought.
        if matches!(origin, Origin::Damage | Origin::Temperature) {
            return Some(vec![0.0; scene.body().points()].into());
        }
        let medium = Medium::of(scene);
        let at = |p: usize| recovered.of_stress(medium, origin, p, |values| values[p]);
        let values: Option<Vec<f64>> = match whole {
            true => (0..self.points).into_par_iter().with_min_len(FEW).map(at).collect(),
            false => scene.real_points().map(at).collect(),
        };
        values.map(Cow::from)
    }

    /// Value of a field as a sum over points. What is no linear function of the stresses is that of the summed stresses.
    pub fn value(&self, scene: &BodyScene, field: FieldName, weights: &[(u32, f64)]) -> Option<f64> {
        let sum = |values: &[f64]| weights.iter().map(|&(p, w)| w * values[p as usize]).sum::<f64>();
        if let Some((kept, divisor)) = self.kept(scene, field) {
            return Some(sum(kept) / divisor);
        }
        let heaviest = weights.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?.0 as usize;
        if field == FieldName::Material {
            return scene.material_number(heaviest).map(f64::from);
        }
        let recovered = self.recovered.as_ref()?;
        let origin = field.about().origin;
        if matches!(origin, Origin::Damage | Origin::Temperature) {
            return Some(0.0);
        }
        let medium = Medium::of(scene);
        match medium.is_by_point(origin) {
            true => {
                let at = |p: usize| recovered.of_stress(medium, origin, p, |values| values[p]);
                weights.iter().map(|&(p, w)| Some(w * at(p as usize)?)).sum()
            }
            false => recovered.of_stress(medium, origin, heaviest, sum),
        }
    }
}
