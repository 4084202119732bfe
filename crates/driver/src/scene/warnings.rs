//! Doubts about a case that can be run.

use super::material::beam_path;
use super::place::Layout;
use super::root;
use crate::case::{Case, Model, Units};
use crate::diagnostic::Faults;
use peristat_assembly::material::SectionProperties;
use peristat_assembly::model::timoshenko_beam::{TimoshenkoBeam, VolumeFactor};

/// Adds all warnings on a scene.
pub(super) fn collect(
    case: &Case,
    layout: &Layout,
    beam: &TimoshenkoBeam,
    section: &SectionProperties,
    faults: &mut Faults,
) {
    let Model::TimoshenkoBeam(model) = &case.model;
    let horizon_key = if case.horizon.is_some() { "horizon" } else { "horizon_ratio" };
    for (line, chain) in layout.lines.iter().zip(beam.chains()) {
        let horizon = line.horizon_ratio * line.spacing();
        if horizon > line.length * (1.0 + 1e-9) {
            faults
                .warning(
                    root(horizon_key),
                    format!("the horizon {horizon} is longer than the beam, {}", line.length),
                )
                .hint("use more cells or a shorter horizon");
        }
        let classes = chain.weights.classes();
        let moment: f64 = (0..classes).map(|k| (k + 1) as f64 * chain.weights.of_class(k)).sum();
        let fits = classes as f64 + 1.0 > line.horizon_ratio.ceil();
        if !layout.treatment.covers()
            && fits
            && model.volume_factor == VolumeFactor::HalfEdge
            && (moment - 1.0).abs() > 1e-3
        {
            faults
                .warning(
                    root(horizon_key),
                    format!(
                        "the bonds of {} spacings make the beam {:.1} % too soft at any spacing",
                        line.horizon_ratio,
                        100.0 * (1.0 - moment)
                    ),
                )
                .hint("use a whole horizon ratio, or the end treatment `cover`, which makes up for it");
        }
        if let Some(height) = section.height
            && model.bond_law == "published"
            && classes > 1
            && horizon > 3.0 * height
        {
            faults
                .warning(
                    beam_path().key("bond_law"),
                    format!(
                        "the horizon is {:.3} section heights; beyond 3 the law `published` locks",
                        horizon / height
                    ),
                )
                .hint(
                    "the deflection is too small whatever the spacing: use `corrected`, or a shorter horizon",
                );
        }
    }
    if model.volume_factor == VolumeFactor::Full && beam.chains().iter().any(|c| c.weights.classes() > 1) {
        faults
            .warning(
                beam_path().key("volume_factor"),
                "full volumes make the beam too stiff by one over the horizon ratio, at any spacing",
            )
            .hint("`half_edge` is right; `full` is for comparison with the literature");
    }
    let (e, units) = (model.youngs_modulus, case.units);
    let (low, high) = match units {
        Units::MetreNewtonPascal => (1e5, 2e12),
        Units::MillimetreNewtonMegapascal => (1e-1, 2e6),
    };
    if !(low..=high).contains(&e) {
        faults
            .warning(
                beam_path().key("youngs_modulus"),
                format!("{e} {} is an unusual Young's modulus", units.stress()),
            )
            .hint("steel has 2.1e11 Pa or 2.1e5 MPa; `units` only labels, it converts nothing");
    }
}
