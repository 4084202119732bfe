//! A scene: a case with every default resolved and every fault found. The rest of the program sees only this.

mod baseline;
mod body;
mod checks;
mod facts;
mod loads;
mod material;
mod numbers;
mod place;
mod problem;
mod supports;
mod warnings;

pub use checks::{Expectation, ExpectationKind, ProbePoint};
pub use place::Place;
pub use supports::{HeldPoint, RigidBar};

use crate::case::{Case, Check, Solver, Units};
use crate::diagnostic::{Faults, JsonPath, Report};
use peristat_assembly::condition::Equation;
use peristat_assembly::material::SectionProperties;
use peristat_assembly::model::timoshenko_beam::{BeamLoads, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use std::path::Path;

/// A beam problem, resolved.
#[derive(Debug)]
pub struct Scene {
    /// The case with its defaults filled in.
    pub case: Case,
    /// Units of all numbers.
    pub units: Units,
    /// The discretised beam.
    pub beam: TimoshenkoBeam,
    /// Section, κ included.
    pub section: SectionProperties,
    /// Points that something holds.
    pub held: Vec<HeldPoint>,
    /// Rigid bars.
    pub bars: Vec<RigidBar>,
    /// Equations of supports and links.
    pub equations: Vec<Equation>,
    /// Springs of supports.
    pub springs: Vec<Spring>,
    /// What is solved, in this order.
    pub states: Vec<State>,
    /// Whether the states are combinations and load cases, so that an envelope makes sense.
    pub has_envelope: bool,
    /// How to solve.
    pub solver: Solver,
    /// Values to report.
    pub probes: Vec<ProbePoint>,
    /// What the results must be.
    pub expectations: Vec<Expectation>,
    /// Faults that do not keep the case from running.
    pub warnings: Faults,
}

/// One right-hand side: a load step, a load case or a combination.
#[derive(Clone, Debug)]
pub struct State {
    /// Name in results.
    pub name: String,
    /// Factor on the loads as written; 1 for load cases and combinations.
    pub load_factor: f64,
    /// Factor on prescribed motions.
    pub motion_factor: f64,
    /// The loads, factors included.
    pub loads: BeamLoads,
}

/// Path of a key at the root of a case.
fn root(key: &str) -> JsonPath {
    JsonPath::default().key(key)
}

/// Names the files of a case by their full paths, so that the case can be run again from another folder.
fn keep_baselines(case: &mut Case, folder: &Path) {
    for check in &mut case.checks {
        if let Check::Baseline(baseline) = check
            && let Ok(path) = folder.join(&baseline.file).canonicalize()
        {
            baseline.file = path.display().to_string();
        }
    }
}

impl Scene {
    /// Resolves a case. `folder` is where files that the case names are looked for, `file` and `text` are for messages.
    ///
    /// # Errors
    /// All faults of the case in one [`Report`].
    pub fn new(mut case: Case, folder: &Path, file: &str, text: &str) -> Result<Self, Report> {
        let mut faults = Faults::default();
        let resolved = Self::resolve(&mut case, folder, &mut faults);
        match resolved {
            Some(scene) if !faults.has_errors() => {
                keep_baselines(&mut case, folder);
                Ok(Self { warnings: faults, case, ..scene })
            }
            _ => Err(faults.into_report(file, text)),
        }
    }

    /// The scene without the faults; `None` if they leave nothing to build on.
    fn resolve(case: &mut Case, folder: &Path, faults: &mut Faults) -> Option<Self> {
        numbers::check(case, faults);
        if case.title.chars().any(char::is_control) {
            faults.error(root("title"), "`title` must not hold control characters such as line ends");
        }
        let material = material::material(case, faults);
        let layout = body::layout(case, faults)?;
        let (held, springs, ends) = supports::held(case, &layout, faults);
        let bars = supports::bars(case, &layout, faults);
        let cases = loads::load_cases(case, &layout, faults);
        let splits = body::splits(&layout, &held, &bars, &cases);
        let (parameters, stiffness, section) = material?;
        if faults.has_errors() {
            return None;
        }
        let beam = body::build(case, &layout, parameters, &stiffness, splits, ends, faults)?;
        let numbers: Vec<usize> = (0..beam.chains().len()).map(|c| beam.first_real(c)).collect();
        let held: Vec<HeldPoint> = held.into_iter().map(|h| h.numbered(&numbers)).collect();
        let bars: Vec<RigidBar> = bars.into_iter().map(|b| b.numbered(&numbers)).collect();
        let states = loads::states(case, cases, faults);
        warnings::collect(case, &layout, &beam, &section, faults);
        let probes = checks::probes(case, &layout, &numbers, &held, &section, faults);
        let expectations = checks::expectations(
            &checks::Context {
                case,
                beam: &beam,
                held: &held,
                bars: &bars,
                states: &states,
                probes: &probes,
                folder,
            },
            faults,
        );
        Some(Self {
            case: case.clone(),
            units: case.units,
            equations: supports::equations(&held, &bars),
            springs: supports::numbered_springs(springs, &numbers),
            has_envelope: !case.load_cases.is_empty(),
            solver: case.solver,
            beam,
            section,
            held,
            bars,
            states,
            probes,
            expectations,
            warnings: Faults::default(),
        })
    }
}
