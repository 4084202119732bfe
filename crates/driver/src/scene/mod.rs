//! A scene: a case with every default resolved and every fault found. The rest of the program sees only this.

mod axial;
mod baseline;
mod body;
mod checks;
mod distributed_load;
mod extent;
mod facts;
mod foundation;
mod frame;
mod frame_checks;
mod grading;
mod holds;
mod links;
mod loads;
mod material;
mod motions;
mod numbers;
mod place;
mod point_load;
mod probes;
mod problem;
mod profile;
mod section;
mod size;
mod spot;
mod support_keys;
mod supports;
mod warnings;
mod words;

pub use checks::{Expectation, ExpectationKind};
pub use frame::{EndOfMember, FrameLayout, JointLayout, MemberLayout};
pub use holds::{Hold, How, Motion};
pub use links::RigidBar;
pub use place::Place;
pub use probes::ProbePoint;
pub use section::SectionAlong;
pub use supports::HeldPoint;

use crate::case::{Case, Check, Solver, Units};
use crate::diagnostic::{Faults, JsonPath, Report};
use peristat_assembly::condition::Equation;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{BeamLoads, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use std::ops::Range;
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
    /// Joints and members, where the lines are those of a frame.
    pub frame: Option<FrameLayout>,
    /// Whether points have displacements along their lines.
    pub has_axial: bool,
    /// Sections of the lines.
    pub sections: Vec<SectionAlong>,
    /// Points that something holds.
    pub held: Vec<HeldPoint>,
    /// Rigid bars.
    pub bars: Vec<RigidBar>,
    /// Equations of supports, links and joints, in this order.
    pub equations: Vec<Equation>,
    /// Springs to the ground: those of supports, then those of foundations.
    pub springs: Vec<Spring>,
    /// Which of the springs are those of foundations.
    pub bedding: Range<usize>,
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

/// Path of the beam in a case.
pub(super) fn beam_path() -> JsonPath {
    root("model").key("timoshenko_beam")
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

fn check_title(title: &str, faults: &mut Faults) {
    if title.chars().any(char::is_control) {
        faults.error(root("title"), "`title` must not hold control characters such as line ends");
    }
}

/// Equations of supports, links and joints; `first` are the numbers of the first real points of the lines.
fn equations(
    held: &[HeldPoint],
    bars: &[RigidBar],
    layout: &place::Layout,
    first: &[usize],
    has_axial: bool,
) -> Vec<Equation> {
    [
        holds::equations(held),
        links::bar_equations(bars, has_axial),
        links::joint_equations(layout, first, has_axial),
    ]
    .concat()
}

impl Scene {
    /// Resolves a case. `folder` is where files that the case names are looked for, `file` and `text` are for messages;
    /// `max_memory` is in bytes, without it there is what the machine has.
    ///
    /// # Errors
    /// All faults of the case in one [`Report`].
    pub fn new(
        mut case: Case,
        folder: &Path,
        file: &str,
        text: &str,
        max_memory: Option<u64>,
    ) -> Result<Self, Report> {
        let mut faults = Faults::default();
        let resolved = Self::resolve(&mut case, folder, max_memory, &mut faults);
        match resolved {
            Some(scene) if !faults.has_errors() => {
                keep_baselines(&mut case, folder);
                Ok(Self { warnings: faults, case, ..scene })
            }
            _ => Err(faults.into_report(file, text)),
        }
    }

    /// The scene without the faults; `None` if they leave nothing to build on.
    fn resolve(case: &mut Case, folder: &Path, max_memory: Option<u64>, faults: &mut Faults) -> Option<Self> {
        numbers::check(case, faults);
        check_title(&case.title, faults);
        let material = material::material(case, faults);
        let layout = body::layout(case, faults)?;
        let (held, ends) = supports::held(case, &layout, faults);
        let beds = foundation::beds(case, &layout, faults);
        let bars = links::bars(case, &layout, faults);
        let cases = loads::load_cases(case, &layout, faults);
        let splits = body::splits(&layout, &held, &bars, &cases);
        let (parameters, resolved) = material?;
        let stiffness: Vec<&SectionStiffness> = resolved.iter().map(|r| &r.stiffness).collect();
        let has_axial = axial::is_needed(&layout, &held, &cases, &stiffness);
        axial::check(case, &layout, &resolved, has_axial, faults);
        size::check(&layout, &resolved, max_memory, faults);
        if faults.has_errors() {
            return None;
        }
        let axial = axial::modes(&layout, &held, &bars, &cases, &stiffness, case.solver);
        let beam = body::build(&layout, parameters, &resolved, splits, ends, axial, faults)?;
        let sections: Vec<SectionAlong> = resolved.into_iter().map(|r| r.section).collect();
        let numbers: Vec<usize> = (0..beam.chains().len()).map(|c| beam.first_real(c)).collect();
        let held: Vec<HeldPoint> =
            held.into_iter().map(|h| h.numbered(&numbers, &layout, has_axial)).collect();
        let bars: Vec<RigidBar> = bars.into_iter().map(|b| b.numbered(&numbers)).collect();
        let states = loads::states(case, cases, faults);
        warnings::collect(case, &layout, &beam, &sections, &beds, faults);
        let context = probes::Context {
            case,
            layout: &layout,
            first: &numbers,
            held: &held,
            sections: &sections,
            has_axial,
        };
        let probes = probes::probes(&context, faults);
        let context = checks::Context {
            case,
            on_frame: layout.frame.is_some(),
            beam: &beam,
            held: &held,
            bars: &bars,
            beds: &beds,
            states: &states,
            probes: &probes,
            folder,
        };
        let expectations = checks::expectations(&context, faults);
        let (supports, bedding) = (holds::springs(&held), foundation::springs(&beds, &beam));
        Some(Self {
            case: case.clone(),
            units: case.units,
            equations: equations(&held, &bars, &layout, &numbers, has_axial),
            bedding: supports.len()..supports.len() + bedding.len(),
            springs: [supports, bedding].concat(),
            has_axial,
            frame: layout.frame,
            has_envelope: !case.load_cases.is_empty(),
            solver: case.solver,
            beam,
            sections,
            held,
            bars,
            states,
            probes,
            expectations,
            warnings: Faults::default(),
        })
    }
}
