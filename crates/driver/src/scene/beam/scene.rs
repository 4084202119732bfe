//! From a case of a beam or a frame to its scene.

use super::checks::BeamComparison;
use super::frame_layout::FrameLayout;
use super::links::RigidBar;
use super::one_way::OneWay;
use super::probes::BeamProbe;
use super::section::SectionAlong;
use super::state::State;
use super::supports::HeldPoint;
use super::{
    axial, body, checks, foreign, foundation, fracture, holds, links, loads, material, probes, size,
    supports, warnings,
};
use crate::case::{Case, Check, FieldName, Fracture, Model, Solver, Units};
use crate::diagnostic::Faults;
use crate::input::Folder;
use crate::model::Beam;
use crate::scene::expectation::Expectation;
use crate::scene::files::{self, InputFile};
use crate::scene::fracture::FractureScene;
use crate::scene::solids_only;
use peristat_assembly::condition::Equation;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{CriticalStrains, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use std::ops::Range;

/// A beam or a frame of beams, resolved.
#[derive(Debug)]
pub struct BeamScene {
    /// The case with its defaults filled in.
    pub case: Case,
    /// Files that it names.
    pub files: Vec<InputFile>,
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
    /// Equations and springs that act one way.
    pub one_way: Vec<OneWay>,
    /// What is solved, in this order.
    pub states: Vec<State>,
    /// How to solve.
    pub solver: Solver,
    /// Values to report.
    pub probes: Vec<BeamProbe>,
    /// How it breaks, if it does.
    pub fracture: Option<FractureScene<CriticalStrains>>,
    /// What the results must be.
    pub expectations: Vec<Expectation<BeamComparison>>,
    /// Faults that do not keep the case from running.
    pub warnings: Faults,
}

impl BeamScene {
    /// The fields that probes of some line or frame can ask for.
    pub(in crate::scene) fn askable() -> Vec<FieldName> {
        probes::askable()
    }

    /// Horizon over spacing of the first line.
    pub(in crate::scene) fn horizon_ratio(&self) -> f64 {
        self.beam.chains()[0].line().horizon_ratio
    }

    /// Resolves a case of a beam. `folder` is where files that the case names are looked for, `faults` are those found so
    /// far; `max_memory` is in bytes.
    ///
    /// # Errors
    /// All faults of the case.
    pub(in crate::scene) fn new(
        mut case: Case,
        mut model: Beam,
        folder: &Folder,
        max_memory: Option<u64>,
        mut faults: Faults,
    ) -> Result<Self, Faults> {
        let mut fracture = case.fracture.clone();
        let filled = (&mut model, &mut fracture);
        let resolved = Self::resolve(&case, filled, folder, max_memory, &mut faults);
        match resolved {
            Some(scene) if !faults.has_errors() => {
                case.model = Model::TimoshenkoBeam(Box::new(model));
                case.fracture = fracture;
                let files = files::keep(&mut case, folder, max_memory);
                Ok(Self { warnings: faults, case, files, ..scene })
            }
            _ => Err(faults),
        }
    }

    /// The scene without the faults; `None` if they leave nothing to build on. Fills in the defaults of the model and of its
    /// fracture.
    fn resolve(
        case: &Case,
        (model, fracture): (&mut Beam, &mut Option<Fracture>),
        folder: &Folder,
        max_memory: Option<u64>,
        faults: &mut Faults,
    ) -> Option<Self> {
        solids_only::refuse(case, faults);
        if !foreign::check(case, faults) {
            return None;
        }
        let material = material::material(case, model, faults);
        let layout = body::layout(case, model, max_memory, faults)?;
        fracture::check(case, &layout, faults);
        let (held, ends) = supports::held(case, &layout, faults);
        let beds = foundation::beds(case, &layout, faults);
        let bars = links::bars(case, &layout, faults);
        let sections = material.as_ref().map(|(_, sections)| &sections[..]);
        let cases = loads::load_cases(case, model, &layout, sections, faults);
        let splits = body::splits(&layout, &held, &bars, &cases);
        let (parameters, resolved) = material?;
        let stiffness: Vec<&SectionStiffness> = resolved.iter().map(|r| &r.stiffness).collect();
        let has_axial = axial::is_needed(&layout, &held, &cases, &stiffness);
        axial::check(case, &layout, &resolved, has_axial, faults);
        size::check(&layout, &resolved, max_memory, faults);
        let baselines = case.checks.iter().filter(|check| matches!(check, Check::Baseline(_))).count();
        size::check_baselines(baselines, &layout, max_memory, faults);
        size::check_springs(foundation::count(&beds, &layout), max_memory, faults);
        if faults.has_errors() {
            return None;
        }
        let axial = axial::modes(&layout, &held, &bars, &cases, &stiffness, case);
        let beam = body::build(&layout, parameters, &resolved, splits, ends, axial, faults)?;
        let sections: Vec<SectionAlong> = resolved.into_iter().map(|r| r.section).collect();
        let numbers: Vec<usize> = (0..beam.chains().len()).map(|c| beam.first_real(c)).collect();
        let held: Vec<HeldPoint> =
            held.into_iter().map(|h| h.numbered(&numbers, &layout, has_axial)).collect();
        let bars: Vec<RigidBar> = bars.into_iter().map(|b| b.numbered(&numbers)).collect();
        let states = loads::states(case, &cases, max_memory, faults)?;
        warnings::collect(case, model, &layout, &beam, &beds, faults);
        let context = probes::ProbedBeam {
            model,
            layout: &layout,
            first: &numbers,
            held: &held,
            sections: &sections,
            has_axial,
            breaks: case.fracture.is_some(),
        };
        let probes = probes::probes(case, &context, faults);
        let context = fracture::BreakingBeam { beam: &beam, sections: &sections, probes: &probes };
        let breaks = fracture.as_mut().and_then(|f| fracture::resolve(f, &context, faults));
        let context = checks::CheckedBeam {
            units: case.units,
            facts: fracture::facts(breaks.as_ref()),
            on_frame: layout.frame.is_some(),
            fields: FieldName::of_beam(layout.frame.is_some(), has_axial),
            beam: &beam,
            held: &held,
            bars: &bars,
            beds: &beds,
            states: &states,
            folder,
            max_memory,
        };
        let expectations = checks::expectations(case, &context, &probes, faults);
        let (mut springs, mut one_way) = (holds::springs(&held), holds::one_way(&held));
        let supports = springs.len();
        foundation::add_springs(&beds, &beam, &mut springs, &mut one_way);
        let mut equations = [holds::equations(&held), links::bar_equations(&bars, has_axial)].concat();
        links::add_joint_equations(&layout, &numbers, has_axial, &mut equations, &mut one_way);
        Some(Self {
            case: case.clone(),
            files: Vec::new(),
            units: case.units,
            equations,
            bedding: supports..springs.len(),
            springs,
            one_way,
            has_axial,
            frame: layout.frame,
            solver: case.solver,
            beam,
            sections,
            held,
            bars,
            states,
            probes,
            fracture: breaks,
            expectations,
            warnings: Faults::default(),
        })
    }
}
