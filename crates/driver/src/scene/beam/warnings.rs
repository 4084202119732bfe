//! Doubts about a case that can be run.

use super::foundation::Bed;
use super::model_path::beam_path;
use super::place::{Layout, LayoutLine};
use super::profile;
use crate::case::{Case, Units};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::model::Beam;
use peristat_assembly::model::timoshenko_beam::{Chain, TimoshenkoBeam, VolumeFactor};

/// Adds all warnings on a scene.
pub(super) fn collect(
    case: &Case,
    model: &Beam,
    layout: &Layout,
    beam: &TimoshenkoBeam,
    beds: &[Bed],
    faults: &mut Faults,
) {
    let horizon = root(if case.horizon.is_some() { "horizon" } else { "horizon_ratio" });
    // Exact elements over any span add up to the line, until the first one breaks.
    let adds_up = beam.parameters().bond_law.is_element;
    if !adds_up || !layout.treatment.covers() || case.fracture.is_some() {
        short_lines(layout, &horizon, faults);
    }
    if !layout.treatment.covers() && model.volume_factor == VolumeFactor::HalfEdge {
        for (line, chain) in layout.lines.iter().zip(beam.chains()) {
            softness(line, chain, &horizon, faults);
        }
    }
    for (k, bed) in beds.iter().enumerate() {
        foundation(bed, &root("foundation").index(k), layout, beam, faults);
    }
    if model.volume_factor == VolumeFactor::Full && beam.chains().iter().any(|c| c.weights.classes() > 1) {
        faults
            .warning(
                beam_path().key("volume_factor"),
                "full volumes make the beam too stiff by one over the horizon ratio, at any spacing",
            )
            .hint("`half_edge` is right; `full` is for comparison with the literature");
    }
    moduli(model, case.units, faults);
}

/// Lines that are shorter than their horizon.
fn short_lines(layout: &Layout, path: &JsonPath, faults: &mut Faults) {
    let horizon = |line: &LayoutLine| line.horizon_ratio * line.spacing();
    let short = |(_, line): &(usize, &LayoutLine)| horizon(line) > line.length * (1.0 + 1e-9);
    // A frame may have many short members: the first one stands for all.
    let most = if layout.frame.is_some() { 1 } else { layout.lines.len() };
    for (k, line) in layout.lines.iter().enumerate().filter(short).take(most) {
        let whole = match &layout.frame {
            Some(frame) => format!("member `{}`", frame.members[k].name),
            None => "beam".into(),
        };
        let message = match &line.stations {
            None => format!(
                "the horizon {} is longer than the {whole}, {}",
                tidy(horizon(line)),
                tidy(line.length)
            ),
            Some(_) => format!("{} neighbours are more than the {} cells", line.horizon_ratio, line.cells),
        };
        faults.warning(path.clone(), message).hint("use more cells or a shorter horizon");
    }
}

/// Bonds that do not add up to the stiffness of the section, which no cover makes up for.
fn softness(line: &LayoutLine, chain: &Chain, path: &JsonPath, faults: &mut Faults) {
    let classes = chain.weights.classes();
    let moment: f64 = (0..classes).map(|k| (k + 1) as f64 * chain.weights.of_class(k)).sum();
    let fits = classes as f64 + 1.0 > line.horizon_ratio.ceil();
    if fits && (moment - 1.0).abs() > 1e-3 {
        faults
            .warning(
                path.clone(),
                format!(
                    "the bonds of {} spacings make the beam {:.1} % too soft at any spacing",
                    line.horizon_ratio,
                    100.0 * (1.0 - moment)
                ),
            )
            .hint("use a whole horizon ratio, or the end treatment `cover`, which makes up for it");
    }
}

/// Cells that are longer than what the beam bends over on a foundation.
fn foundation(bed: &Bed, path: &JsonPath, layout: &Layout, beam: &TimoshenkoBeam, faults: &mut Faults) {
    let bending = beam.chains()[bed.chain].line().stiffness.bending.value(0.0);
    let highest = profile::highest(&bed.stiffness, bed.extent[1] - bed.extent[0]);
    let reach = (4.0 * bending / highest).powf(0.25);
    let cell = layout.lines[bed.chain].spacing();
    if cell > reach {
        faults
            .warning(
                path.clone(),
                format!(
                    "on this foundation the beam bends over {}, and its cells have {}",
                    tidy(reach),
                    tidy(cell)
                ),
            )
            .hint("use cells of a fifth of that: springs on points err with the square of the cell");
    }
}

/// Young's moduli that no material has in these units.
fn moduli(model: &Beam, units: Units, faults: &mut Faults) {
    let Some(usual) = units.usual_moduli() else { return };
    let (law, path) = (model.power_law.as_ref(), beam_path());
    let moduli = [
        (model.youngs_modulus, path.key("youngs_modulus")),
        (law.map(|l| l.bottom_modulus), path.key("power_law").key("bottom_modulus")),
        (law.map(|l| l.top_modulus), path.key("power_law").key("top_modulus")),
    ];
    for (e, path) in moduli {
        if let Some(e) = e.filter(|e| !usual.contains(e)) {
            faults
                .warning(path, format!("{e} {} is an unusual Young's modulus", units.stress()))
                .hint("steel has 2.1e11 Pa or 2.1e5 MPa; `units` only labels, it converts nothing, and \"none\" is for numbers without units");
        }
    }
}
