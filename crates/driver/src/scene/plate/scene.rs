//! From a case of a plate in bending to its scene.

use super::border::Border;
use super::fracture::PlateFracture;
use super::held_line::{self, HeldLine};
use super::loads::{self, Made};
use super::materials::{self, PlateMaterial};
use super::plate_loads::PlateLoads;
use super::probes::{self, PlateProbe};
use super::restraints::PlateSupport;
use super::site::Site;
use super::supports;
use super::thickness::Thickness;
use super::{foreign, foundation, fracture, symmetry, warnings};
use crate::case::{Case, FieldName, Model, Solver, Units};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::input::Folder;
use crate::scene::body::site::body;
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::interpolate::Interpolation;
use crate::scene::body::site::of_case::horizon_key;
use crate::scene::body::{BodyComparison, BodyState, OutputLine, compare, lines};
use crate::scene::expectation::{self, Expectation, PointsCheck};
use crate::scene::files::{self, InputFile};
use crate::scene::{horizon, words};
use peristat_assembly::body::{Outline, PointBody, SquareLattice};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::plate_bending::{PlateBending, PlateError};
use peristat_assembly::stiffness::Spring;
use std::sync::Arc;

/// The usual horizon per spacing: bonds to the eight next points are the most accurate, and the cheapest.
const USUAL_RATIO: f64 = 1.5;
/// The largest one: bonds and their pieces grow with its square.
const MOST_RATIO: f64 = 10.0;

/// A plate in bending, resolved.
#[derive(Debug)]
pub struct PlateScene {
    /// The case with its defaults filled in.
    pub case: Case,
    /// Files that it names.
    pub files: Vec<InputFile>,
    /// Units of all numbers.
    pub units: Units,
    /// The plate with its bonds.
    pub plate: PlateBending,
    /// Regions that are thicker or thinner, or of another material.
    pub materials: Vec<PlateMaterial>,
    /// How thick it is.
    pub thickness: Arc<Thickness>,
    /// Whether it has a corner that turns into it.
    pub turns_inward: bool,
    /// Its points as a body.
    pub body: PointBody,
    /// What holds it, lines of symmetry last.
    pub supports: Vec<PlateSupport>,
    /// Lines of points that they hold, along which reactions are per length.
    pub held_lines: Vec<HeldLine>,
    /// Equations of the supports.
    pub equations: Vec<Equation>,
    /// Per equation what it prescribes in every load step, where that is not in proportion to the load factor; else nothing.
    pub by_step: Vec<Vec<f64>>,
    /// Springs of the supports, then those of the foundation.
    pub springs: Vec<Spring>,
    /// Load cases.
    pub load_cases: Vec<PlateLoads>,
    /// How its bonds break, if they do.
    pub fracture: Option<PlateFracture>,
    /// What is solved, in this order.
    pub states: Vec<BodyState>,
    /// How to solve.
    pub solver: Solver,
    /// Values to report.
    pub probes: Vec<PlateProbe>,
    /// Lines along which fields are written.
    pub lines: Vec<OutputLine>,
    /// What the results must be.
    pub expectations: Vec<Expectation<BodyComparison>>,
    /// Faults that do not keep the case from running.
    pub warnings: Faults,
}

impl PlateScene {
    /// The fields that probes can ask for.
    pub(crate) fn askable() -> Vec<FieldName> {
        probes::askable()
    }

    /// Resolves a case of a plate. `folder` is where files that the case names are looked for, `faults` are those found so far;
    /// `max_memory` is in bytes.
    ///
    /// # Errors
    /// All faults of the case.
    pub(crate) fn new(
        mut case: Case,
        folder: &Folder,
        max_memory: Option<u64>,
        mut faults: Faults,
    ) -> Result<Self, Faults> {
        let resolved = Self::resolve(&case, folder, max_memory, &mut faults);
        let Some(scene) = resolved.filter(|_| !faults.has_errors()) else { return Err(faults) };
        if case.horizon.is_none() {
            case.horizon_ratio = Some(scene.plate.parameters().horizon_ratio);
        }
        case.fracture.clone_from(&scene.case.fracture);
        let files = files::keep(&mut case, folder, max_memory);
        Ok(Self { case, files, warnings: faults, ..scene })
    }

    fn resolve(case: &Case, folder: &Folder, max_memory: Option<u64>, faults: &mut Faults) -> Option<Self> {
        let Model::PlateBending(keys) = &case.model else { return None };
        foreign::check(case, faults);
        let built = body::build(case, keys, folder, max_memory, faults);
        let spacing = built.as_ref().map_or(1.0, |built| built.body.spacing());
        let ratio = horizon::horizon_ratio(case, spacing, USUAL_RATIO, faults)?;
        if ratio > MOST_RATIO {
            faults
                .error(
                    root(horizon_key(case)),
                    format!("a horizon of {ratio} spacings has too many bonds per point"),
                )
                .hint(format!(
                    "the largest horizon ratio of plates in bending is {MOST_RATIO}; 1.5 is the most accurate"
                ));
        }
        fracture::check(case, ratio, faults);
        let parameters = keys.parameters(ratio, faults);
        let body::Built { body: given, outline, parts, .. } = built?;
        let (PointBody::Lattice(cells), Some(outline)) = (given, outline) else { return None };
        let parameters = parameters.filter(|_| !faults.has_errors())?;
        let cells = Arc::new(inside(&cells, &outline));
        let of_cells = PointBody::Lattice((*cells).clone());
        let on_cells = Ground::new(case, &of_cells, (Some(&outline), &[], &parts), &mut Faults::default());
        let on = (&on_cells, &*cells);
        let (materials, sections) = materials::of(case, keys, on, (ratio, max_memory), faults);
        if faults.has_errors() {
            return None;
        }
        let plate = PlateBending::of_sections(cells.clone(), parameters, sections);
        let plate = plate.map_err(|error| refuse(&error, case, faults)).ok()?;
        let thickness = Thickness::new(keys.thickness, &materials, &plate);
        let nodes = plate.nodes();
        let points = PointBody::Lattice((**nodes.lattice()).clone());
        let site = Site {
            case,
            outline: &outline,
            nodes,
            ground: &Ground::new(case, &points, (Some(&outline), &[], &parts), faults),
            cells: &on_cells,
            border: &Border::new(&outline, nodes),
        };
        let mut held = supports::held(&site, faults);
        symmetry::hold(&site, &mut held, faults);
        let made = Made { plate: &plate, thickness: &thickness, materials: &materials };
        let load_cases = loads::load_cases(&site, &made, faults);
        loads::check_loaded(&site, &load_cases, held.moves(), faults);
        let held_lines = held_line::lines(&site, &held);
        let probes = probes::probes(&site, (&held, &held_lines), faults);
        let interpolation = Interpolation { body: &points, cracks: &[], reach: 1 };
        let lines = lines(site.ground, &interpolation, &|p| p, max_memory, faults);
        let states = BodyState::all(case, faults);
        let mut breaks = case.fracture.clone();
        let made = (&plate, &thickness);
        let fracture = breaks.as_mut().and_then(|f| fracture::resolve(f, (&site, &probes), made, faults));
        let known: Vec<&str> = probes.iter().map(|probe| probe.name.as_str()).collect();
        let known: Vec<&str> =
            known.into_iter().chain(fracture::facts(fracture.as_ref()).iter().copied()).collect();
        let expectations = expectations(case, &points, (&states, &known), (folder, max_memory), faults);
        held.springs.extend(foundation::springs(&site, faults));
        warnings::collect(&site, (&parameters, thickness.least()), faults);
        Some(Self {
            case: Case { fracture: breaks, ..case.clone() },
            files: Vec::new(),
            units: case.units,
            materials,
            thickness: Arc::new(thickness),
            turns_inward: outline.turns_inward(),
            supports: held.supports,
            held_lines,
            equations: held.equations,
            by_step: held.by_step,
            springs: held.springs,
            load_cases,
            fracture,
            states,
            solver: case.solver,
            probes,
            lines,
            expectations,
            warnings: Faults::default(),
            body: points,
            plate,
        })
    }
}

/// The cells whose middles lie in the body, all of them whole.
fn inside(cells: &SquareLattice, outline: &Outline) -> SquareLattice {
    if cells.cut_cells().is_empty() {
        return cells.clone();
    }
    let [x, y, _] = cells.corner();
    let is_in =
        |[i, j]: [i32; 2]| cells.number([i, j, 0]).is_some() && outline.contains(cells.place_of([i, j, 0]));
    SquareLattice::plane(cells.spacing(), [x, y], cells.columns(), cells.rows(), is_in)
}

fn refuse(error: &PlateError, case: &Case, faults: &mut Faults) {
    let path = match error {
        PlateError::Lattice => root("body"),
        PlateError::NotIsotropic { .. } | PlateError::NegativeShear { .. } => root(horizon_key(case)),
    };
    faults.error(path, error.to_string());
}

/// Checks of the case.
fn expectations(
    case: &Case,
    body: &PointBody,
    (states, probes): (&[BodyState], &[&str]),
    (folder, max_memory): (&Folder, Option<u64>),
    faults: &mut Faults,
) -> Vec<Expectation<BodyComparison>> {
    let states: Vec<&str> = states.iter().map(|state| state.name.as_str()).collect();
    let is_field = |field: FieldName, path: &JsonPath, faults: &mut Faults| {
        let is_there = FieldName::PLATE.contains(&field);
        if !is_there {
            faults
                .error(path.key("field"), format!("`{}` is no field of all points of a plate", field.name()))
                .hint(words::there_are(&FieldName::PLATE));
        }
        is_there
    };
    let compare = |check: PointsCheck, path: &JsonPath, _: usize, faults: &mut Faults| {
        compare(check, body, (is_field, case.units), (folder, max_memory), path, faults)
    };
    expectation::expectations(case, &states, probes, compare, faults)
}
