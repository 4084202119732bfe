//! From a case of a body in the plane to its scene.

use super::doubts::{loose, warnings};
use super::fail::elastic::Elastic;
use super::fail::fracture::{self, BodyFracture};
use super::fail::path;
use super::hold::held_body::HeldBody;
use super::hold::{bearing_keys, rigid_keys, rigid_mirror, supported, supports};
use super::limit::LocalLimit;
use super::load::context::LoadContext;
use super::load::sums::BodyLoads;
use super::load::{joined_sides, load_cases};
use super::read::checks;
use super::read::fields::Says;
use super::read::front::{Beside, FrontFault, FrontJump};
use super::read::intensities::{self, Intensity};
use super::read::jump::Jump;
use super::read::outputs::{self, OutputLine};
use super::read::probes::{self, BodyProbe, Quantity};
use super::read::strengths;
use super::scene::{BodyScene, BodyState};
use super::site::ground::Ground;
use super::site::interpolate::Interpolation;
use super::site::model_inputs::ModelInputs;
use super::site::of_case::{self, horizon_key};
use super::site::{counts, cracks, foreign, given_body, materials, specimen, tips};
use crate::case::{Case, Fracture, PATH_FACTS, Path as CasePath, Tips};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::input::Folder;
use crate::model::{USUAL_HORIZON_RATIO, with_body};
use crate::scene::files;
use crate::scene::path::PathScene;
use crate::scene::solids_only;
use peristat_assembly::body::{Crack, PointBody, in_space};
use peristat_assembly::model::BodyModel;

impl BodyScene {
    /// Resolves a case of a body in the plane. `folder` is where files that the case names are looked for, `faults` are
    /// those found so far; `max_memory` is in bytes.
    ///
    /// # Errors
    /// All faults of the case.
    pub(crate) fn new(
        mut case: Case,
        folder: &Folder,
        max_memory: Option<u64>,
        mut faults: Faults,
    ) -> Result<Self, Faults> {
        let usual = case.model.keys().ok();
        let usual = usual.and_then(|keys| keys.resolve(&of_case::asked(&case), &mut Faults::default()));
        let usual = usual.map_or(USUAL_HORIZON_RATIO, |material| material.usual_horizon_ratio());
        let Some(expanded) = specimen::expand(&mut case, usual, &mut faults) else { return Err(faults) };
        let mut traced = (case.fracture.clone(), case.path.clone());
        let elastic = case.is_traced().then(|| Box::new(Elastic::new(&case, usual, folder, max_memory)));
        let scene = Self::checked(&expanded.case, &mut traced, folder, max_memory, &mut faults);
        expanded.relocate(&mut faults);
        let Some(mut scene) = scene.filter(|_| !faults.has_errors()) else { return Err(faults) };
        case.model = scene.material().keys();
        if case.horizon.is_none() {
            case.horizon_ratio = Some(scene.material().about().horizon_ratio);
        }
        (case.fracture, case.path) = traced;
        scene.elastic = elastic.filter(|elastic| elastic.differs_from(scene.material()));
        scene.files = files::keep(&mut case, folder, max_memory);
        (scene.case, scene.warnings) = (case, faults);
        Ok(scene)
    }

    /// The scene of a case without specimens, and its doubts; `None` where there are faults that leave no scene.
    fn checked(
        case: &Case,
        traced: &mut (Option<Fracture>, Option<CasePath>),
        folder: &Folder,
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        let resolved = Self::resolve(case, traced, folder, max_memory, faults);
        let scene = resolved.filter(|_| !faults.has_errors())?;
        if scene.outline.is_none() || scene.can_have_loose_points() {
            with_body!(&scene.model, body => loose::check(&scene, &**body, faults));
        }
        check_bearable(&scene, faults);
        warnings::collect(&scene, faults);
        Some(scene)
    }

    /// The scene without the faults; `None` if they leave nothing to build on. Fills in the defaults of the model and of its
    /// fracture.
    fn resolve(
        case: &Case,
        traced: &mut (Option<Fracture>, Option<CasePath>),
        folder: &Folder,
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        let keys = case.model.keys().ok()?;
        foreign::check(case, faults);
        if !keys.is_solid() {
            solids_only::refuse(case, faults);
        }
        of_case::check_refused(case, keys, faults);
        let given_body::GivenBody { mut inputs, outline, walls, parts, curves, cracks } =
            given_body::read(case, keys, folder, max_memory, faults)?;
        let ground = Ground::new(case, &inputs.body, (outline.as_ref(), &walls, &parts), faults);
        if !counts::fit(&ground, max_memory, faults) {
            return None;
        }
        inputs.materials = materials::mixture(&ground, &inputs, (folder, max_memory), faults);
        materials::warn(&inputs, faults);
        let held = supports::held(&ground, &inputs.symmetry, &*inputs.material, faults);
        let rigid = rigid_keys::rigid(&ground, &inputs.symmetry, faults);
        rigid_mirror::check(&rigid, &inputs, faults);
        inputs.bearings = bearing_keys::bearings(case, &rigid, faults);
        let paths: Vec<Crack> = cracks.iter().map(|c| c.crack.clone()).collect();
        let built = inputs.make(&paths);
        let built = built.map_err(|refusal| refusal.tell(case.model.name(), horizon_key(case), faults)).ok();
        let context = LoadContext {
            ground: &ground,
            symmetry: &inputs.symmetry,
            curves: &curves,
            material: &*inputs.material,
            horizon: inputs.horizon,
            held: &held,
            cracks: &cracks,
            inputs: &inputs,
            model: built.as_deref(),
            factor: None,
        };
        let load_cases = load_cases::load_cases(&context, faults);
        let moves = held.iter().flat_map(|h| &h.motions).any(|m| !m.1.is_zero())
            || rigid.iter().flat_map(|r| r.prescribed).flatten().any(|v| v != 0.0);
        load_cases::check_loaded(&ground, &load_cases, moves, faults);
        let states = BodyState::all(case, faults);
        cracks::check(&cracks, outline.as_ref(), (&inputs, built.is_some()), faults);
        let built = built?;
        let (conditions, supports) = supported::conditions(&held, rigid, &inputs, &*built, faults);
        let reach = reach(&*built, &inputs);
        let images = inputs.acting(&paths);
        let extended = built.lattice().filter(|_| !built.ghosts().is_empty());
        let extended = extended.map(|(lattice, _)| match lattice.is_plane() {
            true => PointBody::Lattice(lattice.as_ref().clone()),
            false => PointBody::Solid(lattice.as_ref().clone()),
        });
        let body = extended.as_ref().unwrap_or(&inputs.body);
        let site = HeldBody {
            ground: &ground,
            outline: outline.as_ref(),
            inputs: &inputs,
            model: &*built,
            cracks: &cracks,
            interpolation: &Interpolation { body, cracks: &images, reach },
            held: &held,
            conditions: &conditions,
            supports: &supports,
        };
        let limit = LocalLimit::resolve(&site, (&load_cases, &states), max_memory, faults);
        strengths::check(case, &*inputs.material, faults);
        let Readings { probes, lines, intensities } = Readings::new(&site, max_memory, faults);
        let names: Vec<&str> = probes.iter().map(|p| p.name.as_str()).collect();
        let Failure { fracture, path, facts } = Failure::new((&site, &load_cases), traced, &names, faults);
        let names: Vec<&str> = names.into_iter().chain(facts.iter().map(String::as_str)).collect();
        let number = |p: u32| inputs.number(&*built, p);
        let state_names: Vec<&str> = states.iter().map(|s| s.name.as_str()).collect();
        let expectations = checks::expectations(
            case,
            (&inputs.body, &*built, Says::of(case, &*inputs.material)),
            &state_names,
            &names,
            (folder, max_memory),
            faults,
        );
        Some(Self {
            case: case.clone(),
            files: Vec::new(),
            units: case.units,
            equations: conditions.equations(&|p| built.position(p)),
            load_cases: load_cases
                .into_iter()
                .map(|l| l.numbered(&number).with_ends(&joined_sides::forces(case, &*built)))
                .collect(),
            conditions,
            supports,
            states,
            solver: case.solver,
            cracks,
            probes,
            lines,
            intensities,
            fracture,
            path,
            facts,
            expectations,
            warnings: Faults::default(),
            model: built,
            inputs: Box::new(inputs),
            outline: outline.map(Box::new),
            elastic: None,
            limit: limit.map(Box::new),
        })
    }
}

/// Adds a fault for every load case that the body cannot bear.
fn check_bearable(scene: &BodyScene, faults: &mut Faults) {
    let held = scene.conditions.holds.iter().map(|held| (&held.points[..], held.direction));
    let loads = scene.load_cases.iter().enumerate().map(|(k, loads)| {
        let path = match scene.case.load_cases.is_empty() {
            true => root("loads"),
            false => root("load_cases").index(k),
        };
        let mut force = vec![0.0; scene.model.components().len() * scene.model.points()];
        loads.add_to(&*scene.model, 1.0, &mut force);
        (path, force)
    });
    let (mut held, mut loads) = (held, loads);
    scene.material().check_bearable(&scene.resolved(&[]), &mut held, &mut loads, faults);
}

/// How many rows and columns beside a point values are interpolated from: points beside a border that is followed do not see the
/// steps of the lattice.
fn reach(model: &dyn BodyModel, inputs: &ModelInputs) -> i32 {
    if model.follows_border() { 1 } else { (inputs.material.about().horizon_ratio + 1e-9).floor() as i32 }
}

/// What is read of the results.
struct Readings {
    probes: Vec<BodyProbe>,
    lines: Vec<OutputLine>,
    intensities: Vec<Intensity>,
}

impl Readings {
    fn new(site: &HeldBody, max_memory: Option<u64>, faults: &mut Faults) -> Self {
        let mut probes = probes::probes(site, faults);
        let number = |p: u32| site.inputs.number(site.model, p);
        let lines = outputs::lines(site.ground, site.interpolation, &number, max_memory, faults);
        let contains = |tip: [f64; 2]| {
            let at = JsonPath::default();
            let is_near = || site.ground.point_at(in_space(tip), &at, "", &mut Faults::default()).is_some();
            site.outline.map_or_else(is_near, |outline| outline.contains(tip))
        };
        let body = &site.inputs.body;
        let around = tips::Around {
            symmetry: &site.inputs.symmetry,
            spacing: body.spacing(),
            is_lattice: body.cells().is_some(),
        };
        let moves = [0, 1].iter().all(|&axis| site.model.along(axis).is_some());
        let is_plane = site.inputs.body.axes() == 2;
        let find = |ends: [[f64; 2]; 2]| {
            let at = JsonPath::default();
            let inside = |p: [f64; 3]| site.ground.point_at(p, &at, "", &mut Faults::default()).map(number);
            Jump::at(ends, site.inputs.horizon, site.interpolation, &inside)
        };
        let paths: Vec<Crack> = site.cracks.iter().map(|named| named.crack.clone()).collect();
        let find_front = |crack: usize, position: [f64; 3]| {
            let at = JsonPath::default();
            let inside = |p: [f64; 3]| site.ground.point_at(p, &at, "", &mut Faults::default()).map(number);
            let (horizon, symmetry) = (site.inputs.horizon, &site.inputs.symmetry);
            let surface = paths[crack].surface().ok_or(FrontFault::Far)?;
            let fronts = site.inputs.around().with_recess(crack, &paths, |recess| surface.fronts(recess));
            let beside = Beside { horizon, symmetry, on: site.interpolation, inside: &inside };
            FrontJump::at((surface, &fronts), position, &beside)
        };
        let find: Option<&intensities::FindJump> = if moves && is_plane { Some(&find) } else { None };
        let intensities = intensities::intensities(
            site.ground.case,
            site.cracks,
            &contains,
            &around,
            (find, &find_front),
            faults,
        );
        probes.extend(intensities.iter().enumerate().map(|(k, intensity)| BodyProbe {
            name: intensity.name.clone(),
            quantity: Quantity::StressIntensity(k, intensity.quantity),
            place: format!("{}crack `{}`", tips_in_words(intensity), site.cracks[intensity.crack].name),
            position: None,
        }));
        Self { probes, lines, intensities }
    }
}

/// Which tips move, or that it is of a place of the front, in words.
fn tips_in_words(intensity: &Intensity) -> &'static str {
    match intensity.tips {
        Some(Tips::Start) => "start of ",
        Some(Tips::End) => "end of ",
        Some(Tips::Both) => "both ends of ",
        None if intensity.front.is_some() => "front of ",
        None => "",
    }
}

/// How a body breaks or softens, and what checks can ask of that.
struct Failure {
    fracture: Option<BodyFracture>,
    path: Option<PathScene>,
    facts: Vec<String>,
}

impl Failure {
    fn new(
        (site, loads): (&HeldBody, &[BodyLoads]),
        (fracture, path): &mut (Option<Fracture>, Option<CasePath>),
        probes: &[&str],
        faults: &mut Faults,
    ) -> Self {
        let case = site.ground.case;
        let fracture = fracture.as_mut().and_then(|f| fracture::resolve(f, (site, loads), probes, faults));
        let path = path.as_mut().and_then(|p| path::resolve(p, site, probes, faults));
        if case.path.is_none() && case.model.softens() {
            faults
                .error(root("path"), "bonds that soften need `path`: how the loads and motions grow")
                .hint("for example \"path\": { \"load\": \"name of a reaction probe\" }");
        }
        let mut facts = fracture.as_ref().map_or(Vec::new(), BodyFracture::facts);
        if path.is_some() {
            facts.extend(PATH_FACTS.map(Into::into));
        }
        Self { fracture, path, facts }
    }
}
