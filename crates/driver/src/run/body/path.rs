//! Bodies in the plane whose bonds soften.

use super::fields::{BodyResult, Recovered, parted};
use super::modes::ALONG_X;
use super::{crack_front, grips, verdict};
use crate::run::body::BodyProblem;
use crate::run::fracture::Facts;
use crate::run::path::{PathPoint, SofteningBody, SofteningBonds};
use crate::run::{Problem, SolvedState, StateRecord, StateResult};
use crate::scene::Resultant;
use crate::scene::path::PathScene;
use peristat_assembly::law::{Bilinear, Law};
use peristat_assembly::model::plane::SofteningModel;
use peristat_assembly::stiffness::{BondAnswers, HistoryBonds};

/// A body in the plane whose bonds soften.
pub(super) struct SofteningPlane<'a> {
    pub(super) problem: BodyProblem<'a, dyn SofteningModel<2>>,
    pub(super) path: &'a PathScene,
    pub(super) recover: bool,
    /// Stress intensity of the elastic body at a load factor of one.
    pub(super) intensity: Option<f64>,
    /// Load and work of the elastic body at a load factor of one.
    pub(super) elastic: [f64; 2],
    pub(super) front: Option<crack_front::Front>,
    /// Ends of the bonds that have softened in the last state.
    pub(super) softened: Vec<[usize; 2]>,
}

/// Laws of the bonds: those of the material, and of bonds that stay elastic.
const SOFTENS: usize = 0;
const ELASTIC: usize = 1;

/// Laws whose failure stretches differ by no more than this part are one: the lengths of parts of bonds are rounded.
const SAME: f64 = 1e-9;

impl SofteningBody<2> for SofteningPlane<'_> {
    fn problem(&self) -> &dyn Problem<2> {
        &self.problem
    }

    fn path(&self) -> &PathScene {
        self.path
    }

    fn bonds(&self) -> SofteningBonds<2> {
        let model = &self.problem.model;
        let mut region = vec![None; model.points()];
        for (k, rigid) in self.problem.scene.conditions.rigid.iter().enumerate() {
            rigid.points.iter().for_each(|&p| region[p as usize] = Some(k));
        }
        // Bonds inside a rigid region have no strain.
        let law = |points: &[u32]| {
            let first = region[points[0] as usize];
            let is_rigid = first.is_some() && points.iter().all(|&p| region[p as usize] == first);
            let is_exempt = points.iter().any(|&p| self.path.exempt[p as usize]);
            (!is_rigid).then_some(if is_exempt { ELASTIC } else { SOFTENS })
        };
        let between = model.history_bonds(&|points| law(&points.map(|p| p as u32)));
        let mut laws = vec![self.path.law, Bilinear::elastic()];
        let ended = model.ended_bonds(&mut |points, part| {
            Some(match law(points)? {
                SOFTENS => of_part(&mut laws, &self.path.law.of_part(part)),
                elastic => elastic,
            })
        });
        HistoryBonds::new(model.points(), self.path.kinematics, laws, between).with_ended(ended)
    }

    fn probes(&self, u: &[f64], multipliers: &[f64]) -> Vec<f64> {
        let scene = self.problem.scene;
        let value = |probe: &crate::scene::body::BodyProbe| {
            verdict::mechanical(scene, &probe.quantity, u, multipliers).unwrap_or(f64::NAN)
        };
        scene.probes.iter().map(value).collect()
    }

    fn set_elastic(&mut self, load: f64, work: f64) {
        self.elastic = [load, work];
    }

    fn measure(&self, bonds: &SofteningBonds<2>, point: &mut PathPoint) {
        point.crack_growth = self.front.as_ref().map(|front| front.growth(bonds));
        let [load, work] = self.elastic;
        if let Some(intensity) = self.intensity.filter(|_| load != 0.0 && work > 0.0) {
            let model = &self.problem.model;
            point.stress_intensity = Some(intensity * point.load / load);
            // J = W (dC/da)/(C t), with the compliance C of the elastic body: K²/E' as long as it is one.
            let stiffness = 1.0 / model.strains_of(ALONG_X, 0.0)[0];
            point.j_integral = Some(intensity * intensity / stiffness * point.work / work);
        }
    }

    fn result(
        &mut self,
        solved: SolvedState,
        name: String,
        load_factor: f64,
        facts: Facts,
        (bonds, answers): (&SofteningBonds<2>, &BondAnswers<2>),
    ) -> StateResult {
        self.softened = grips::softened(bonds);
        let SolvedState { state: index, solution, certificate, load, .. } = solved;
        let record = StateRecord { index, name, load_factor, u: solution.u, certificate, facts: Some(facts) };
        let (scene, model) = (self.problem.scene, &*self.problem.model);
        let mut asked = Resultant::default();
        asked.add_multiple(load_factor, &scene.asked(&scene.states[0]));
        let mut result = BodyResult::new(
            (scene, model, None),
            record,
            (solution.multipliers, load, asked),
            Vec::new(),
            false,
        );
        if self.recover {
            result.recovered = Some(recovered(model, bonds, answers));
        }
        let list = bonds.list().iter().zip(bonds.history()).enumerate();
        let broken = list.filter(|(k, (_, history))| bonds.law(*k).is_broken(history));
        result.parted = parted(model, broken.map(|(_, (bond, _))| bond.points.map(|p| p as usize)));
        StateResult::Body(result)
    }
}

/// Index of a law among some, which it joins if it is none of them: parts of bonds come in few lengths.
fn of_part(laws: &mut Vec<Bilinear>, law: &Bilinear) -> usize {
    let is_same = |l: &Bilinear| (l.failure_stretch() / law.failure_stretch() - 1.0).abs() < SAME;
    laws.iter().position(is_same).unwrap_or_else(|| {
        laws.push(*law);
        laws.len() - 1
    })
}

/// Stresses by the forces of the bonds, `σ = (1/V) ½ Σ N ξ n nᵀ`, energy densities and damage. What ends on the border
/// stands for whole bonds of the points beside it.
fn recovered(
    model: &dyn SofteningModel<2>,
    bonds: &SofteningBonds<2>,
    answers: &BondAnswers<2>,
) -> Recovered {
    let n = model.points();
    let (mut stress, mut energy_density) = ([vec![0.0; n], vec![0.0; n], vec![0.0; n]], vec![0.0; n]);
    for (k, (bond, answer)) in bonds.list().iter().zip(&answers.bonds).enumerate() {
        let [x, y] = answer.direction;
        let moment = 0.5 * answer.force * bond.length;
        let energy = bonds.law(k).energies(answer.elongation / bond.length, &bonds.history()[k]);
        let stored = 0.5 * bond.stiffness * bond.length * bond.length * energy.stored;
        for (point, part) in bonds.families(k) {
            let volume = part * model.stress_volume(point);
            for (plane, product) in stress.iter_mut().zip([x * x, y * y, x * y]) {
                plane[point] += moment * product / volume;
            }
            energy_density[point] += stored / volume;
        }
    }
    // What cracks have cut from the start is no bond any more.
    let cut = model.damage();
    let damage = bonds.damage().into_iter().zip(cut).map(|(d, cut)| cut + (1.0 - cut) * d).collect();
    Recovered {
        stress: stress.into(),
        across: Vec::new(),
        energy_density,
        damage: Some(damage),
        eigenstrain: None,
    }
}
