//! Scenes of bodies in the plane.

mod any_body;
mod asked;
mod bearing;
mod body;
mod bonds;
mod boundary;
mod checks;
mod clamped;
mod conditions;
mod counts;
mod cracks;
mod critical;
mod elastic;
mod fading;
mod fields;
mod files;
mod foreign;
mod formula;
mod fracture;
mod gaps;
mod given;
mod ground;
mod held_angle;
mod held_border;
mod held_corner;
mod held_edge;
mod interpolate;
mod levels;
mod loads;
mod loose;
mod lump;
mod material;
mod model;
mod motions;
mod on_border;
mod opening;
mod orthotropic;
mod outputs;
mod parts;
mod path;
mod periodic;
mod probes;
mod problem;
mod profile;
mod rigid_mirror;
mod round;
mod shell;
mod size;
mod snap;
mod specimen;
mod state_based;
mod statics;
mod stress_field;
mod support_keys;
mod supported;
mod supports;
mod symmetry;
#[cfg(test)]
mod tests;
mod tips;
mod traction;
mod uniform_stress;
mod warnings;

pub use any_body::AnyBody;
pub(crate) use any_body::with_body;
pub use bonds::{PlaneBonds, PlaneModelError};
pub use checks::PlaneComparison;
pub use conditions::{Conditions, HeldPoints, RIGID_KEYS, RigidPoints};
pub use cracks::NamedCrack;
pub(crate) use fields::{Has, of_points};
pub use fracture::PlaneFracture;
pub(super) use given::Given;
pub use held_edge::HeldEdge;
pub use interpolate::Weights;
pub use loads::PlaneLoads;
pub use outputs::{Intensity, LinePoint, OutputLine};
pub use probes::{PlaneProbe, Quantity};
pub use problem::PlaneProblem;
pub use supported::PlaneSupport;

use super::path::PathScene;
use super::states::{self, Sum};
use super::{Expectation, InputFile, root};
use crate::case::{Case, Fracture, Path as CasePath, Solver, Units};
use crate::diagnostic::{Faults, JsonPath};
use crate::input::Folder;
use crate::run::path::PATH_FACTS;
use elastic::Elastic;
use ground::Ground;
use interpolate::Interpolation;
use model::Recipe;
use peristat_assembly::body::{Cell, Crack, Outline, PlaneBody, SquareLattice};
use peristat_assembly::condition::Equation;
use supports::Held;

/// A body in the plane, resolved. Points have the numbers of the model, images in mirrors among them, wherever nothing
/// else is said.
#[derive(Debug)]
pub struct PlaneScene {
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
    pub supports: Vec<PlaneSupport>,
    /// The same as equations: those of supports, then those of rigid regions.
    pub equations: Vec<Equation>,
    /// Loads of every load case at a factor of one.
    pub load_cases: Vec<PlaneLoads>,
    /// What is solved, in this order.
    pub states: Vec<PlaneState>,
    /// How to solve.
    pub solver: Solver,
    /// Values to report: probes, then stress intensities.
    pub probes: Vec<PlaneProbe>,
    /// Lines along which all fields are written.
    pub lines: Vec<OutputLine>,
    /// Stress intensities that are asked for.
    pub intensities: Vec<Intensity>,
    /// How it breaks.
    pub fracture: Option<PlaneFracture>,
    /// How its bonds soften and how it is followed.
    pub path: Option<PathScene>,
    /// What the results must be.
    pub expectations: Vec<Expectation<PlaneComparison>>,
    /// Faults that do not keep the case from running.
    pub warnings: Faults,
    /// Names of what checks know beside probes.
    pub facts: Vec<String>,
    recipe: Box<Recipe>,
    outline: Option<Box<Outline>>,
    elastic: Option<Box<Elastic>>,
}

/// One right-hand side: a load step, a load case or a combination.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneState {
    /// Name in results.
    pub name: String,
    /// Factor on the loads as written; 1 for load cases and combinations.
    pub load_factor: f64,
    /// Factor on prescribed motions.
    pub motion_factor: f64,
    /// Load cases by number, and their factors.
    pub terms: Vec<(usize, f64)>,
}

impl PlaneScene {
    /// Resolves a case of a body in the plane. `folder` is where files that the case names are looked for, `faults` are
    /// those found so far; `max_memory` is in bytes.
    ///
    /// # Errors
    /// All faults of the case.
    pub(super) fn new(
        mut case: Case,
        mut model: Given,
        folder: &Folder,
        max_memory: Option<u64>,
        mut faults: Faults,
    ) -> Result<Self, Faults> {
        let usual = model.clone().bonds(&case, false, &mut Faults::default());
        let usual = usual.map_or(3.0, |bonds| bonds.usual_horizon_ratio());
        let Some(expanded) = specimen::expand(&mut case, usual, &mut faults) else { return Err(faults) };
        let mut traced = (case.fracture.clone(), case.path.clone());
        let elastic = case.is_traced().then(|| Box::new(Elastic::new(&case, &model, folder, max_memory)));
        let filled = (&mut model, &mut traced);
        let scene = Self::checked(&expanded.case, filled, folder, max_memory, &mut faults);
        expanded.relocate(&mut faults);
        let Some(mut scene) = scene.filter(|_| !faults.has_errors()) else { return Err(faults) };
        model.settle(scene.bonds(), &mut case);
        case.model = model.into();
        (case.fracture, case.path) = traced;
        scene.elastic = elastic.filter(|elastic| elastic.differs_from(scene.bonds()));
        scene.files = super::files::keep(&mut case, folder, max_memory);
        (scene.case, scene.warnings) = (case, faults);
        Ok(scene)
    }

    /// The scene of a case without specimens, and its doubts; `None` where there are faults that leave no scene.
    fn checked(
        case: &Case,
        filled: (&mut Given, &mut (Option<Fracture>, Option<CasePath>)),
        folder: &Folder,
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        let resolved = Self::resolve(case, filled, folder, max_memory, faults);
        let scene = resolved.filter(|_| !faults.has_errors())?;
        if scene.outline.is_none() || scene.can_have_loose_points() {
            with_body!(&scene.model, body => loose::check(&scene, &**body, faults));
        }
        shell::check_bearable(&scene, faults);
        warnings::collect(&scene, faults);
        Some(scene)
    }

    /// The scene without the faults; `None` if they leave nothing to build on. Fills in the defaults of the model and of its
    /// fracture.
    fn resolve(
        case: &Case,
        (model, traced): (&mut Given, &mut (Option<Fracture>, Option<CasePath>)),
        folder: &Folder,
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        foreign::check(case, faults);
        let parts::Parts { mut recipe, outline, curves, cracks } =
            parts::parts(case, model, folder, max_memory, faults)?;
        let ground = Ground::new(case, &recipe.body, outline.as_ref(), faults);
        if !counts::fit(&ground, max_memory, faults) {
            return None;
        }
        let held = supports::held(&ground, &recipe.symmetry, &recipe.bonds, faults);
        let rigid = supports::rigid(&ground, &recipe.symmetry, faults);
        rigid_mirror::check(&rigid, &recipe, faults);
        recipe.bearings = bearing::bearings(case, &rigid, faults);
        let paths: Vec<Crack> = cracks.iter().map(|c| c.crack.clone()).collect();
        let built = recipe.make(&paths).map_err(|error| model::refuse(&error, case, faults)).ok();
        let context = loads::Context {
            ground: &ground,
            symmetry: &recipe.symmetry,
            curves: &curves,
            bonds: &recipe.bonds,
            horizon: recipe.horizon,
            held: &held,
            cracks: &cracks,
            recipe: &recipe,
            model: built.as_deref(),
        };
        let load_cases = loads::load_cases(&context, faults);
        let moves = held.iter().flat_map(|h| &h.motions).any(|m| m.1 != 0.0)
            || rigid.iter().flat_map(|r| r.prescribed).flatten().any(|v| v != 0.0);
        loads::check_loaded(&ground, &load_cases, moves, faults);
        let states = states(case, faults);
        cracks::check(
            &cracks,
            &recipe.body,
            outline.as_ref(),
            &|crack| built.is_none() || recipe.is_cut_by(crack),
            faults,
        );
        let built = built?;
        let (conditions, supports) = supported::conditions(&held, rigid, &recipe, &*built);
        // Points beside a border that is followed do not see the steps of the lattice.
        let reach = match built.follows_border() {
            true => 1,
            false => (recipe.bonds.horizon_ratio() + 1e-9).floor() as i32,
        };
        let number = |p: u32| recipe.number(&*built, p);
        let images = recipe.symmetry.with_images(&paths);
        let extended = built.lattice().filter(|_| !built.ghosts().is_empty());
        let extended = extended.map(|(lattice, _)| PlaneBody::Lattice(lattice.as_ref().clone()));
        let body = extended.as_ref().unwrap_or(&recipe.body);
        let interpolation = Interpolation { body, cracks: &images, reach };
        let context = probes::Context {
            ground: &ground,
            recipe: &recipe,
            model: &*built,
            interpolation: &interpolation,
            held: &held,
            conditions: &conditions,
        };
        let mut probes = probes::probes(&context, faults);
        let lines = outputs::lines(&ground, &interpolation, &number, max_memory, faults);
        let contains = |tip: [f64; 2]| {
            let at = JsonPath::default();
            let is_near = || ground.point_at(tip, &at, "", &mut Faults::default()).is_some();
            outline.as_ref().map_or_else(is_near, |o| o.contains(tip))
        };
        let around = tips::Around { symmetry: &recipe.symmetry, spacing: recipe.body.spacing() };
        let intensities = outputs::intensities(case, &cracks, &contains, &around, faults);
        probes.extend(intensities.iter().enumerate().map(|(k, intensity)| PlaneProbe {
            name: intensity.name.clone(),
            quantity: Quantity::StressIntensity(k),
            place: format!("crack `{}`", cracks[intensity.crack].name),
            position: None,
        }));
        let mut names: Vec<&str> = probes.iter().map(|p| p.name.as_str()).collect();
        let context = fracture::Context {
            ground: &ground,
            recipe: &recipe,
            model: &*built,
            conditions: &conditions,
            probes: &names,
        };
        let breaks = traced.0.as_mut().and_then(|f| fracture::resolve(f, &context, faults));
        let context =
            path::Context { ground: &ground, recipe: &recipe, conditions: &conditions, probes: &names };
        let followed = traced.1.as_mut().and_then(|p| path::resolve(p, &context, faults));
        if case.path.is_none() && path::law_of(case).is_some() {
            faults
                .error(root("path"), "bonds that soften need `path`: how the loads and motions grow")
                .hint("for example \"path\": { \"load\": \"name of a reaction probe\" }");
        }
        let mut facts = breaks.as_ref().map_or(Vec::new(), PlaneFracture::facts);
        if followed.is_some() {
            facts.extend(PATH_FACTS.map(Into::into));
        }
        names.extend(facts.iter().map(String::as_str));
        let state_names: Vec<&str> = states.iter().map(|s| s.name.as_str()).collect();
        let expectations = checks::expectations(
            case,
            (&recipe.body, &*built),
            &state_names,
            &names,
            (folder, max_memory),
            faults,
        );
        Some(Self {
            case: case.clone(),
            files: Vec::new(),
            units: case.units,
            equations: conditions.equations(&|p| built.place(p)),
            load_cases: load_cases
                .into_iter()
                .map(|l| l.numbered(&number).with_ends(&periodic::forces(case, &*built)))
                .collect(),
            conditions,
            supports,
            states,
            solver: case.solver,
            cracks,
            probes,
            lines,
            intensities,
            fracture: breaks,
            path: followed,
            facts: facts.clone(),
            expectations,
            warnings: Faults::default(),
            model: built,
            recipe: Box::new(recipe),
            outline: outline.map(Box::new),
            elastic: None,
        })
    }

    /// Whether bonds can miss at points other than those of a plain edge.
    fn can_have_loose_points(&self) -> bool {
        let turned = matches!(self.body(), PlaneBody::Lattice(lattice) if lattice.is_turned());
        let plain = |o: &Outline| o.is_rectangle() && o.holes().is_empty() && !turned;
        let whole = self.cracks.is_empty() && self.recipe.bearings.is_empty();
        !(whole && self.outline().is_some_and(plain))
    }

    /// The elastic body beside one that breaks or softens, where its bonds or edges would be others by default.
    pub(crate) fn elastic(&self) -> Option<Self> {
        self.elastic.as_ref()?.scene()
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

    /// The points that are images in lines of symmetry.
    pub fn images(&self) -> impl Iterator<Item = usize> + '_ {
        let ghosts = self.model.ghosts().iter().map(|&ghost| ghost as usize);
        let lattice = self.model.lattice();
        ghosts.filter(move |&p| lattice.is_some_and(|(lattice, mirrors)| !mirrors.is_real(lattice.cell(p))))
    }

    /// The points without images, with numbers of their own.
    pub fn body(&self) -> &PlaneBody {
        &self.recipe.body
    }

    /// Hash of the file that lists the points, if there is one: it tells more of them than where they are.
    pub(super) fn file(&self) -> Option<blake3::Hash> {
        self.recipe.file
    }

    /// The outline; listed points have none.
    pub fn outline(&self) -> Option<&Outline> {
        self.outline.as_deref()
    }

    /// Number in the model of a point of the body.
    pub fn number(&self, point: usize) -> usize {
        self.recipe.number(&*self.model, point as u32) as usize
    }

    /// Horizon, m.
    pub fn horizon(&self) -> f64 {
        self.recipe.horizon
    }

    /// Side of a cell, or root of the mean area of listed points, m.
    pub fn spacing(&self) -> f64 {
        self.recipe.body.spacing()
    }

    /// Cut bonds of a lattice, for [`PlaneModel::coarser`](peristat_assembly::model::plane::PlaneModel::coarser).
    pub fn cuts(&self, lattice: &SquareLattice, offsets: &[Cell]) -> Vec<(usize, usize)> {
        self.recipe.cuts(&self.cracks, lattice, offsets)
    }

    /// The model and the cracks with the tips of the crack of a stress intensity moved along it by some length, m, outwards
    /// if positive; `None` where that leaves no crack.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn with_moved_tips(
        &self,
        intensity: &Intensity,
        by: f64,
    ) -> Result<Option<(AnyBody, Vec<Crack>)>, PlaneModelError> {
        let mut cracks: Vec<Crack> = self.cracks.iter().map(|c| c.crack.clone()).collect();
        match outputs::moved(&cracks[intensity.crack], intensity.tips, by) {
            Some(crack) => cracks[intensity.crack] = crack,
            None => return Ok(None),
        }
        Ok(Some((self.recipe.make(&cracks)?, cracks)))
    }

    /// Material and bonds.
    pub fn bonds(&self) -> &PlaneBonds {
        &self.recipe.bonds
    }
}

/// The right-hand sides.
fn states(case: &Case, faults: &mut Faults) -> Vec<PlaneState> {
    let state = |Sum { name, load_factor, terms }: Sum| PlaneState {
        name,
        load_factor,
        motion_factor: if case.steps.is_some() { load_factor } else { 1.0 },
        terms,
    };
    states::sums(case, faults).into_iter().map(state).collect()
}
