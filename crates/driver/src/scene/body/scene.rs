//! A body in the plane, resolved.

use super::fail::elastic::Elastic;
use super::fail::fracture::BodyFracture;
use super::hold::conditions::Conditions;
use super::hold::supported::BodySupport;
use super::limit::LocalLimit;
use super::load::sums::BodyLoads;
use super::motions;
use super::read::checks::BodyComparison;
use super::read::fields;
use super::read::intensities::{self, Intensity};
use super::read::outputs::OutputLine;
use super::read::probes::BodyProbe;
use super::site::cracks::NamedCrack;
use super::site::model_inputs::ModelInputs;
use crate::case::{Case, FieldName, Solver, Units};
use crate::diagnostic::Faults;
use crate::model::{AnyBody, HeldRegion, Material, Mixture, OtherMaterial, Refusal, Resolved};
use crate::scene::expectation::Expectation;
use crate::scene::files::InputFile;
use crate::scene::path::PathScene;
use crate::scene::states::{self, Sum};
use peristat_assembly::body::{Cell, Crack, Outline, PointBody, SquareLattice};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::system::FreeMotion;
use std::ops::Range;

/// A body in the plane, resolved. Points have the numbers of the model, images in mirrors among them, wherever nothing
/// else is said.
#[derive(Debug)]
pub struct BodyScene {
    /// The case with its defaults filled in.
    pub case: Case,
    /// Files that it names.
    pub files: Vec<InputFile>,
    /// Units of all numbers.
    pub units: Units,
    /// The discretised body.
    pub model: AnyBody,
    /// Cracks.
    pub cracks: Vec<NamedCrack>,
    /// What holds the body, by points.
    pub conditions: Conditions,
    /// Supports, as they were written, with their equations and springs.
    pub supports: Vec<BodySupport>,
    /// The same as equations: those of supports, then those of rigid regions.
    pub equations: Vec<Equation>,
    /// Loads of every load case at a factor of one.
    pub load_cases: Vec<BodyLoads>,
    /// What is solved, in this order.
    pub states: Vec<BodyState>,
    /// How to solve.
    pub solver: Solver,
    /// Values to report: probes, then stress intensities.
    pub probes: Vec<BodyProbe>,
    /// Lines along which all fields are written.
    pub lines: Vec<OutputLine>,
    /// Stress intensities that are asked for.
    pub intensities: Vec<Intensity>,
    /// How it breaks.
    pub fracture: Option<BodyFracture>,
    /// How its bonds soften and how it is followed.
    pub path: Option<PathScene>,
    /// What the results must be.
    pub expectations: Vec<Expectation<BodyComparison>>,
    /// Faults that do not keep the case from running.
    pub warnings: Faults,
    /// Names of what checks know beside probes.
    pub facts: Vec<String>,
    pub(super) inputs: Box<ModelInputs>,
    pub(super) outline: Option<Box<Outline>>,
    pub(super) elastic: Option<Box<Elastic>>,
    /// What is known on its border, where the limit of local elasticity is asked for.
    pub(crate) limit: Option<Box<LocalLimit>>,
}

/// One right-hand side: a load step, a load case or a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyState {
    /// Name in results.
    pub name: String,
    /// Factor on the loads as written; 1 for load cases and combinations.
    pub load_factor: f64,
    /// Factor on prescribed motions.
    pub motion_factor: f64,
    /// Load cases by number, and their factors.
    pub terms: Vec<(usize, f64)>,
}

impl BodyState {
    /// The right-hand sides of a case.
    pub(in crate::scene) fn all(case: &Case, faults: &mut Faults) -> Vec<Self> {
        let state = |Sum { name, load_factor, terms }: Sum| Self {
            name,
            load_factor,
            motion_factor: if case.steps.is_some() { load_factor } else { 1.0 },
            terms,
        };
        states::sums(case, faults).into_iter().map(state).collect()
    }
}

impl BodyScene {
    /// Whether bonds can miss at points other than those of a plain edge.
    pub(super) fn can_have_loose_points(&self) -> bool {
        let turned = matches!(self.body(), PointBody::Lattice(lattice) if lattice.is_turned());
        let plain = |o: &Outline| o.is_rectangle() && o.holes().is_empty() && !turned;
        let whole = self.cracks.is_empty() && self.inputs.bearings.is_empty();
        !(whole && self.outline().is_some_and(plain))
    }

    /// The elastic body beside one that breaks or softens, where its bonds or edges would be others by default.
    pub(crate) fn elastic(&self) -> Option<Self> {
        let Elastic { case, folder, max_memory } = &**self.elastic.as_ref()?;
        Self::new(case.clone(), folder, *max_memory, Faults::default()).ok()
    }

    /// The fields that probes of some case with this model can ask for.
    pub(in crate::scene) fn askable(&self) -> Vec<FieldName> {
        fields::askable(&*self.model, self.material())
    }

    /// Whether bonds are cut or can fail.
    pub(crate) fn is_damaged(&self) -> bool {
        !self.cracks.is_empty() || self.case.is_traced()
    }

    /// The points without images, in the order of the body.
    pub fn real_points(&self) -> impl Iterator<Item = usize> + '_ {
        let ghosts = self.model.ghosts();
        (0..self.model.points()).filter(move |&p| ghosts.binary_search(&(p as u32)).is_err())
    }

    /// The paths of all cracks.
    pub fn crack_paths(&self) -> Vec<&Crack> {
        self.cracks.iter().map(|named| &named.crack).collect()
    }

    /// The points that are images in lines of symmetry.
    pub fn images(&self) -> impl Iterator<Item = usize> + '_ {
        let ghosts = self.model.ghosts().iter().map(|&ghost| ghost as usize);
        let lattice = self.model.lattice();
        ghosts.filter(move |&p| lattice.is_some_and(|(lattice, mirrors)| !mirrors.is_real(lattice.cell(p))))
    }

    /// The points without images, with numbers of their own.
    pub fn body(&self) -> &PointBody {
        &self.inputs.body
    }

    /// Its materials, by points without images.
    pub fn materials(&self) -> &Mixture {
        &self.inputs.materials
    }

    /// Number of the material of a point of the model, 0 for the base one; none of listed points.
    pub(crate) fn material_number(&self, point: usize) -> Option<u32> {
        let (lattice, mirrors) = self.model.lattice()?;
        let cell = lattice.cell(point);
        let cell = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
        let own = self.body().cells()?.number(cell)?;
        Some(self.materials().numbers.get(own).copied().unwrap_or(0))
    }

    /// The material of a point of the model; none of the base one.
    pub(crate) fn material_of(&self, point: usize) -> Option<&OtherMaterial> {
        let number = self.material_number(point)?.checked_sub(1)?;
        self.materials().others.get(number as usize)
    }

    /// The point nearest to a place that is no image.
    pub(crate) fn nearest(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let far = |p: usize| {
            let [a, b] = self.model.place(p);
            (a - x).hypot(b - y)
        };
        self.real_points().min_by(|&a, &b| far(a).total_cmp(&far(b)))
    }

    /// Hash of the file that lists the points, if there is one: it tells more of them than where they are.
    pub(in crate::scene) fn file(&self) -> Option<blake3::Hash> {
        self.inputs.file
    }

    /// The outline; listed points have none.
    pub fn outline(&self) -> Option<&Outline> {
        self.outline.as_deref()
    }

    /// Number in the model of a point of the body.
    pub fn number(&self, point: usize) -> usize {
        self.inputs.number(&*self.model, point as u32) as usize
    }

    /// A free motion of a model of the body in words.
    pub(crate) fn describe<const D: usize>(&self, model: &dyn Model<D>, motion: &FreeMotion) -> String {
        motions::describe(self, model, motion)
    }

    /// A part of the body that nothing holds at all, in words; none of the whole body.
    pub(crate) fn describe_loose<const D: usize>(
        &self,
        model: &dyn Model<D>,
        motion: &FreeMotion,
    ) -> Option<String> {
        motions::describe_loose(self, model, motion)
    }

    /// Horizon, m.
    pub fn horizon(&self) -> f64 {
        self.inputs.horizon
    }

    /// Side of a cell, or root of the mean area of listed points, in space of their mean volume, m.
    pub fn spacing(&self) -> f64 {
        self.inputs.body.spacing()
    }

    /// Cut bonds of a lattice, for [`Solvable::coarser`](peristat_assembly::model::plane::Solvable::coarser).
    pub fn cuts(&self, lattice: &SquareLattice, offsets: &[Cell]) -> Vec<(usize, usize)> {
        self.inputs.cuts(&self.cracks, lattice, offsets)
    }

    /// The model and the cracks with the tips of the crack of a stress intensity moved along it by some length, m, outwards
    /// if positive; `None` where that leaves no crack.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn with_moved_tips(
        &self,
        intensity: &Intensity,
        by: f64,
    ) -> Result<Option<(AnyBody, Vec<Crack>)>, Refusal> {
        let mut cracks: Vec<Crack> = self.cracks.iter().map(|c| c.crack.clone()).collect();
        match intensities::moved(&cracks[intensity.crack], intensity.tips, by) {
            Some(crack) => cracks[intensity.crack] = crack,
            None => return Ok(None),
        }
        Ok(Some((self.inputs.make(&cracks)?, cracks)))
    }

    /// The model of the part of the body that lies in ranges of columns, rows and layers of its lattice.
    ///
    /// # Errors
    /// [`Refusal`].
    pub(crate) fn part(&self, ranges: &[Range<i32>; 3]) -> Result<AnyBody, Refusal> {
        let cracks: Vec<Crack> = self.cracks.iter().map(|c| c.crack.clone()).collect();
        self.inputs.within(ranges).cut_by(&self.inputs.acting(&cracks))
    }

    /// The body as its model is given it; `held` are the regions that supports hold.
    pub(crate) fn resolved<'a>(&'a self, held: &'a [HeldRegion]) -> Resolved<'a> {
        Resolved {
            model: &*self.model,
            lattice: self.body().cells(),
            outline: self.outline(),
            mirrors: &self.inputs.symmetry.mirrors,
            spacing: self.spacing(),
            held,
        }
    }

    /// Material and bonds.
    pub fn material(&self) -> &dyn Material {
        &*self.inputs.material
    }
}
