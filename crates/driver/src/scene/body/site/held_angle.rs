//! Edges that are held beside a re-entrant corner.
//!
//! The force that a re-entrant corner needs goes by half into the block across it, which the rows of the held edge cannot
//! supply: with bonds that end on the border one stress would be off by a fifth and more there.

use crate::case::{At, Case, Names};
use peristat_assembly::body::{Edge, Outline};

/// How little an edge turns back at a corner that is straight on, as a cosine.
const STRAIGHT: f64 = 1e-9;

/// Whether a place is an edge, or has it among others.
pub(crate) fn is_at(at: &At, edge: &Edge, outline: &Outline) -> bool {
    let names = at.region.iter().flat_map(Names::each);
    names.into_iter().any(|name| outline.calls(name, edge))
}

/// Whether a support holds an edge that ends in a re-entrant corner.
pub(crate) fn is_held(case: &Case, outline: &Outline) -> bool {
    let is_held = |edge: &Edge| case.supports.iter().any(|s| is_at(&s.at, edge, outline));
    let edges = outline.edges();
    let re_entrant = |(a, b): (&Edge, &Edge)| {
        let forwards = if a.to == b.from {
            [0, 1].map(|k| a.to[k] - a.from[k])
        } else {
            [0, 1].map(|k| a.from[k] - a.to[k])
        };
        let length = forwards[0].hypot(forwards[1]);
        forwards[0] * b.normal[0] + forwards[1] * b.normal[1] < -STRAIGHT * length
    };
    let meets = |a: &Edge, b: &Edge| a.to == b.from || a.from == b.to;
    edges
        .iter()
        .filter(|edge| is_held(edge))
        .any(|held| edges.iter().filter(|other| meets(held, other)).any(|other| re_entrant((held, other))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn held(edge: &str) -> bool {
        let case = json!({
            "title": "a", "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [4.0, 2.0], "spacing": 1.0 } },
            "supports": [{ "at": { "region": edge }, "ux": 0.0 }]
        });
        let case: Case = serde_json::from_value(case).unwrap();
        let angle = [[0.0, 0.0], [12.0, 0.0], [12.0, 4.0], [4.0, 4.0], [4.0, 9.0], [0.0, 9.0]];
        is_held(&case, &Outline::polygon(angle.to_vec()).unwrap())
    }

    #[test]
    fn the_two_edges_of_the_inner_corner_are_told() {
        let words: Vec<bool> = (1..=6).map(|k| held(&format!("edge_{k}"))).collect();
        assert_eq!(words, [false, false, true, true, false, false]);
    }
}
