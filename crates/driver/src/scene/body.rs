//! Material and geometry of a scene.

use super::loads::ResolvedLoads;
use super::place::{Frame, FrameLine};
use super::{HeldPoint, RigidBar, root};
use crate::case::{Beam, Case, Model};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::material::{SectionError, SectionProperties};
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, ChainError, Grid, Line, TimoshenkoBeam, VolumeFactor, bond_law,
    end_treatment::{self, EndSupport, EndTreatment},
};

/// Largest number of points: they are numbered by 32 bits.
const MOST_POINTS: usize = 2_000_000_000;

/// Path of the beam in a case.
pub(super) fn beam_path() -> JsonPath {
    root("model").key("timoshenko_beam")
}

/// A number that must be finite and greater than zero.
pub(super) fn positive(value: f64, name: &str, path: JsonPath, faults: &mut Faults) -> bool {
    let fine = value > 0.0 && value.is_finite();
    if !fine {
        faults.error(path, format!("`{name}` must be greater than zero, found {value}"));
    }
    fine
}

/// The name nearest to `name`, for a hint.
pub(super) fn suggest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let nearest = known.iter().map(|k| (strsim::jaro_winkler(name, k), k)).max_by(|a, b| a.0.total_cmp(&b.0));
    match nearest {
        Some((likeness, nearest)) if likeness > 0.75 => format!("did you mean `{nearest}`?"),
        Some(_) => format!("known are {}", known.join(", ")),
        None => "there are none".into(),
    }
}

/// Stiffnesses and section, filling in the defaults of the case.
pub(super) fn material(case: &mut Case, faults: &mut Faults) -> Option<(BeamParameters, SectionProperties)> {
    let path = beam_path();
    let grids: Vec<Grid> = case.body.lines().iter().map(|l| l.grid).collect();
    let Model::TimoshenkoBeam(beam) = &mut case.model;
    let e = beam.youngs_modulus;
    let mut fine = positive(e, "youngs_modulus", path.key("youngs_modulus"), faults);
    let shear = shear_modulus(beam, &path, faults);
    let law = bond_law::find(&beam.bond_law);
    if law.is_none() {
        faults
            .error(path.key("bond_law"), format!("there is no bond law `{}`", beam.bond_law))
            .hint(suggest(&beam.bond_law, bond_law::TABLE.iter().map(|l| l.name)));
    }
    let treatment = treatment(beam, &grids, &path, faults);
    let nu = beam.poisson_ratio.or(shear.map(|g| e / (2.0 * g) - 1.0)).unwrap_or(0.0);
    let section = match beam.section.properties(beam.shear_correction, nu) {
        Ok(section) => Some(section),
        Err(error) => {
            section_fault(beam, &error, &path, faults);
            None
        }
    };
    fine &= law.is_some() && treatment.is_some();
    let (section, g, law, end_treatment) = (section?, shear?, law?, treatment?);
    let parameters = BeamParameters {
        bending_stiffness: e * section.second_moment,
        shear_stiffness: section.kappa * g * section.area,
        area: section.area,
        volume_factor: beam.volume_factor,
        bond_law: law,
        end_treatment,
    };
    let product = parameters.bending_stiffness * parameters.shear_stiffness;
    if fine && !faults.has_errors() && !(product.is_normal() && parameters.bending_stiffness.is_normal()) {
        faults.error(path.clone(), "the stiffnesses EI and κGA do not fit into double precision").hint(
            format!(
                "EI = {:e}, κGA = {:e}; choose units in which they are moderate",
                parameters.bending_stiffness, parameters.shear_stiffness
            ),
        );
    }
    fine.then_some((parameters, section))
}

fn shear_modulus(beam: &Beam, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    match (beam.poisson_ratio, beam.shear_modulus) {
        (Some(_), Some(_)) => {
            faults
                .error(path.key("shear_modulus"), "`poisson_ratio` and `shear_modulus` are both given")
                .hint("for an isotropic material one follows from the other: remove one");
            None
        }
        (None, None) => {
            faults
                .error(path.clone(), "`poisson_ratio` is missing")
                .hint("give `poisson_ratio`, or `shear_modulus` for a material that is not isotropic");
            None
        }
        (Some(nu), None) if nu > -1.0 && nu <= 0.5 => Some(beam.youngs_modulus / (2.0 * (1.0 + nu))),
        (Some(nu), None) => {
            faults
                .error(
                    path.key("poisson_ratio"),
                    format!("`poisson_ratio` must be above -1 and at most 0.5, found {nu}"),
                )
                .hint("steel has 0.3, aluminium 0.33, concrete 0.2");
            None
        }
        (None, Some(g)) => positive(g, "shear_modulus", path.key("shear_modulus"), faults).then_some(g),
    }
}

fn section_fault(beam: &Beam, error: &SectionError, path: &JsonPath, faults: &mut Faults) {
    let shape = serde_json::to_value(beam.section).ok();
    let shape = shape.as_ref().and_then(|v| v.as_object()?.keys().next().cloned()).unwrap_or_default();
    let place = match error {
        SectionError::NotPositive { name: "shear_correction", .. } | SectionError::NoCowper => {
            path.key("shear_correction")
        }
        SectionError::NotPositive { name, .. } | SectionError::DoesNotFit { name, .. } => {
            path.key("section").key(shape).key(*name)
        }
    };
    let fault = faults.error(place, error.to_string());
    if *error == SectionError::NoCowper {
        fault.hint("leave `shear_correction` out: the section gives its own `kappa`");
    }
}

fn treatment(
    beam: &mut Beam,
    grids: &[Grid],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<&'static EndTreatment> {
    let on_cells = grids.contains(&Grid::Cells);
    let default = if on_cells { "ghost" } else { "cover" };
    let name = beam.end_treatment.get_or_insert_with(|| default.into());
    let Some(treatment) = end_treatment::find(name) else {
        faults
            .error(path.key("end_treatment"), format!("there is no end treatment `{name}`"))
            .hint(suggest(name, end_treatment::TABLE.iter().map(|t| t.name)));
        return None;
    };
    if on_cells && treatment.covers() {
        faults
            .error(
                path.key("end_treatment"),
                "the end treatment `cover` needs points on the ends of the beam",
            )
            .hint("use the grid `nodes`, or the treatment `ghost` or `image` with `cells`");
        return None;
    }
    Some(treatment)
}

/// The lines with their horizons.
pub(super) fn frame(case: &Case, faults: &mut Faults) -> Option<Frame> {
    let Model::TimoshenkoBeam(beam) = &case.model;
    let treatment = end_treatment::find(beam.end_treatment.as_deref()?)?;
    let lines = case.body.lines();
    let several = matches!(case.body, crate::case::Body::Lines(_));
    let path = |k: usize| match several {
        true => root("body").key("lines").index(k),
        false => root("body").key("line"),
    };
    if lines.is_empty() {
        faults.error(root("body").key("lines"), "the body has no lines");
        return None;
    }
    let mut fine = true;
    for (k, line) in lines.iter().enumerate() {
        fine &= positive(line.length, "length", path(k).key("length"), faults);
        if line.cells == 0 || line.cells > MOST_POINTS {
            let limit = if line.cells == 0 { "at least 1".into() } else { format!("at most {MOST_POINTS}") };
            faults.error(path(k).key("cells"), format!("`cells` must be {limit}, found {}", line.cells));
            fine = false;
        } else if line.grid == Grid::Cells && line.cells < 2 {
            faults.error(path(k).key("cells"), "a grid of cells needs at least 2 of them to have a bond");
            fine = false;
        } else if fine && line.from + line.length / line.cells as f64 == line.from {
            faults.error(
                path(k).key("from"),
                "`from` is so large that neighbouring points have the same position",
            );
            fine = false;
        }
    }
    fine &= apart(lines, path, faults);
    if !fine {
        return None;
    }
    let lines = lines.iter().map(|line| {
        let spacing = line.length / line.cells as f64;
        let horizon_ratio = horizon_ratio(case, spacing, faults)?;
        let (from, length, cells, grid) = (line.from, line.length, line.cells, line.grid);
        Some(FrameLine { from, length, cells, grid, horizon_ratio })
    });
    let lines: Vec<FrameLine> = lines.collect::<Option<_>>()?;
    Some(Frame { lines, treatment })
}

/// Lines must not touch: a position says which one is meant.
fn apart(lines: &[crate::case::Line], path: impl Fn(usize) -> JsonPath, faults: &mut Faults) -> bool {
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|&a, &b| lines[a].from.total_cmp(&lines[b].from));
    let mut fine = true;
    for pair in order.windows(2) {
        let (a, b) = (&lines[pair[0]], &lines[pair[1]]);
        if a.from + a.length >= b.from {
            faults
                .error(
                    path(pair[1]),
                    format!(
                        "this line starts at x = {}, where another one ends at {}",
                        b.from,
                        a.from + a.length
                    ),
                )
                .hint("make lines that meet one line; leave a gap between lines that a link joins");
            fine = false;
        }
    }
    fine
}

fn horizon_ratio(case: &Case, spacing: f64, faults: &mut Faults) -> Option<f64> {
    let (ratio, key, found) = match (case.horizon_ratio, case.horizon) {
        (Some(_), Some(_)) => {
            faults
                .error(root("horizon"), "`horizon_ratio` and `horizon` are both given")
                .hint("the horizon is horizon_ratio times the spacing: remove one");
            return None;
        }
        (None, Some(horizon)) => (
            horizon / spacing,
            "horizon",
            format!("the horizon {horizon} is shorter than the spacing {spacing}"),
        ),
        (ratio, None) => {
            let ratio = ratio.unwrap_or(3.0);
            (ratio, "horizon_ratio", format!("`horizon_ratio` must be at least 1, found {ratio}"))
        }
    };
    if !ratio.is_finite() || ratio < 1.0 - 1e-9 {
        faults
            .error(root(key), format!("{found}, so no point has a bond"))
            .hint("use 3 spacings, the usual choice");
        return None;
    }
    if ratio > 2e3 {
        faults
            .error(root(key), format!("a horizon of {ratio} spacings has too many bonds per point"))
            .hint("the largest horizon ratio is 2000; more than 12 never pays");
        return None;
    }
    Some(ratio)
}

/// Points that no bond may span: interior supports, ends of links and point loads.
pub(super) fn splits(
    frame: &Frame,
    held: &[HeldPoint],
    bars: &[RigidBar],
    cases: &[ResolvedLoads],
) -> Vec<Vec<usize>> {
    let mut splits = vec![Vec::new(); frame.lines.len()];
    let held = held.iter().filter_map(|h| h.local);
    let bars = bars.iter().flat_map(|b| [b.from, b.to]);
    let loads = cases.iter().flat_map(|c| c.splits.iter().copied());
    for (chain, point) in held.chain(bars).chain(loads) {
        if point > 0 && point + 1 < frame.lines[chain].points() {
            splits[chain].push(point);
        }
    }
    for list in &mut splits {
        list.sort_unstable();
        list.dedup();
    }
    splits
}

/// The discretised beam.
pub(super) fn build(
    case: &Case,
    frame: &Frame,
    parameters: BeamParameters,
    splits: Vec<Vec<usize>>,
    ends: Vec<[EndSupport; 2]>,
    faults: &mut Faults,
) -> Option<TimoshenkoBeam> {
    let lines = frame.lines.iter().zip(splits).zip(ends).map(|((l, splits), supports)| Line {
        from: l.from,
        length: l.length,
        cells: l.cells,
        grid: l.grid,
        horizon_ratio: l.horizon_ratio,
        splits,
        supports,
    });
    let Model::TimoshenkoBeam(beam) = &case.model;
    match TimoshenkoBeam::new(parameters, lines.collect()) {
        Ok(beam) => Some(beam),
        Err(error @ ChainError::NegativeWeight { .. }) => {
            let hint = match beam.volume_factor {
                VolumeFactor::Full => {
                    "full volumes are too stiff for `cover` to correct: use `half_edge`, or the end treatment `ghost`"
                }
                VolumeFactor::HalfEdge => "use a whole `horizon_ratio`",
            };
            faults.error(beam_path().key("volume_factor"), error.to_string()).hint(hint);
            None
        }
    }
}
