//! Names that are not known here, and what they may mean.

use super::Diagnostic;
use super::excerpt::quote;
use super::path::JsonPath;
use super::words::{did_you_mean, meant};

/// The diagnostic of a name that is not among those that are allowed.
pub(super) fn misspelt(noun: &str, name: &str, allowed: &[&str]) -> Diagnostic {
    let plain = in_our_words(&name.to_lowercase().replace([' ', '-'], "_"));
    let mut diagnostic = Diagnostic::error(JsonPath::default(), format!("unknown {noun} {}", quote(name)));
    let components = components(&plain, allowed);
    let meant = if components.is_empty() { meant(&plain, allowed) } else { components };
    diagnostic.hint(match did_you_mean(&meant) {
        _ if OF_TIME.contains(&plain.as_str()) && !allowed.contains(&plain.as_str()) => {
            "nothing depends on time: loads rise by `steps`, `fracture` or `path`".to_string()
        }
        _ if written_otherwise(&plain, allowed).is_some() => {
            written_otherwise(&plain, allowed).unwrap_or_default().to_string()
        }
        Some(question) if meant.len() > 1 && meant[0].starts_with("principal_stress") => {
            format!("{question} The largest is 1, the smallest 3")
        }
        Some(question) => question,
        None if allowed.is_empty() => "nothing is allowed here".to_string(),
        None => format!("allowed here: `{}`", allowed.join("`, `")),
    });
    diagnostic
}

/// Vectors whose components are keys or fields of their own.
const VECTORS: [(&[&str], &[&str]); 2] = [
    (&["displacement", "displacements", "deflection", "u", "disp"], &["ux", "uy", "uz", "w"]),
    (&["rotation", "rotations", "slope", "theta"], &["phi", "phi_x", "phi_y", "phi_z"]),
];

/// The components of a vector that are allowed here.
fn components<'a>(name: &str, allowed: &[&'a str]) -> Vec<&'a str> {
    let known = VECTORS.iter().find(|(words, _)| words.contains(&name) && !allowed.contains(&name));
    let ours = known.map_or(&[][..], |(_, ours)| ours).iter();
    ours.filter_map(|ours| allowed.iter().copied().find(|allowed| allowed == ours)).collect()
}

/// What dynamics has and statics has not.
const OF_TIME: [&str; 8] =
    ["time", "dt", "time_step", "duration", "end_time", "velocity", "damping", "initial_velocity"];

/// What other programs write in another way: their words, a key that stands where they do, and what to write.
const OTHERWISE: [(&[&str], &str, &str); 5] = [
    (
        &["edges", "face", "faces", "side", "boundary"],
        "inward",
        r#"an edge or a face is the region of its name, such as `"region": "left"`"#,
    ),
    (
        &["fix", "fixed", "clamp", "clamped", "dof", "dofs", "constraint", "type", "value", "values"],
        "ux_spring",
        r#"a support names what it prescribes, such as `"ux": 0.0, "uy": 0.0`"#,
    ),
    (
        &["box", "cuboid", "cube", "brick", "prism"],
        "single_edge_bend",
        "a body in space is a `block`, with the model of a solid; one in the plane is a `rectangle`",
    ),
    (
        &["quantities", "quantity", "probes", "outputs"],
        "refine",
        "the quantities of a study are the probes of its case, and its energy: leave this key out",
    ),
    (
        &["force", "forces", "point_force", "point_load", "nodal", "concentrated"],
        "traction",
        "a force at a place is a `point`, one per area of an edge or a face a `traction`, one per volume a `body_force`",
    ),
];

/// What to write in place of a word of other programs.
fn written_otherwise(name: &str, allowed: &[&str]) -> Option<&'static str> {
    let here = |key: &str| allowed.contains(&key) && !allowed.contains(&name);
    OTHERWISE.iter().find(|(words, key, _)| words.contains(&name) && here(key)).map(|(.., hint)| *hint)
}

/// What other programs call stresses and strains.
const OTHER_WORDS: [(&str, &str); 6] = [
    ("sigma", "stress"),
    ("tau", "stress"),
    ("epsilon", "strain"),
    ("eps", "strain"),
    ("gamma", "strain"),
    ("mises", "von_mises"),
];

/// A name such as `sigma_xx` with our word for its symbol.
fn in_our_words(name: &str) -> String {
    let known = OTHER_WORDS.iter().find_map(|(word, ours)| Some((name.strip_prefix(word)?, ours)));
    match known {
        Some(("", ours)) => (*ours).to_string(),
        Some((component, ours)) => format!("{ours}_{}", component.trim_start_matches('_')),
        None => name.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::misspelt;

    #[test]
    fn what_depends_on_time_is_told_so() {
        for name in ["time", "Time-Step", "velocity"] {
            let hint = misspelt("key", name, &["title", "units"]).hint.unwrap_or_default();
            assert!(hint.contains("nothing depends on time"), "{name}: {hint}");
        }
    }

    #[test]
    fn words_of_other_programs_are_told_what_to_write() {
        let at = ["x", "y", "region", "inward"];
        let support = ["at", "ux", "uy", "ux_spring"];
        let loads = ["point", "traction", "pressure"];
        for (name, allowed, ours) in [
            ("face", &at[..], r#""region": "left""#),
            ("fixed", &support, r#""ux": 0.0"#),
            ("Force", &loads, "a `point`"),
        ] {
            let hint = misspelt("key", name, allowed).hint.unwrap_or_default();
            assert!(hint.contains(ours), "{name}: {hint}");
        }
    }

    #[test]
    fn symbols_are_offered_our_words() {
        let known = ["strain_xx", "strain_xy", "stress_xx", "stress_xy", "von_mises"];
        for (name, ours) in [
            ("sigma_xx", "stress_xx"),
            ("Sigma-XX", "stress_xx"),
            ("sigmaxx", "stress_xx"),
            ("tau_xy", "stress_xy"),
            ("eps_xx", "strain_xx"),
            ("epsilon_xy", "strain_xy"),
            ("mises", "von_mises"),
        ] {
            let diagnostic = misspelt("value", name, &known);
            assert_eq!(diagnostic.hint, Some(format!("did you mean `{ours}`?")), "{name}");
        }
    }

    #[test]
    fn components_of_a_vector_are_offered_where_they_are_allowed() {
        let hint = |name: &str, known: &[&str]| misspelt("value", name, known).hint.unwrap_or_default();
        assert_eq!(hint("displacement", &["stress_xx", "ux", "uy"]), "did you mean `ux` or `uy`?");
        assert_eq!(hint("deflection", &["M", "w", "phi"]), "did you mean `w`?");
        assert!(hint("displacement", &["length", "cells"]).starts_with("allowed here"));
    }
}
