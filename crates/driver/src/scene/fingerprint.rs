//! What tells cases apart that have other results.

use super::Scene;
use crate::case::Body;
use peristat_assembly::body::PlaneBody;

/// Keys of a case that change no equilibrium: words, and what is made of results.
const WORDS: [&str; 6] = ["$schema", "title", "about", "lines", "checks", "slow"];
/// Keys of `fracture` that say only how long to go on and what to write.
const EXTENT: [&str; 3] = ["stop_below", "max_solves", "record_every"];

impl Scene {
    /// A hash, as hexadecimal digits, of all that the equilibria and the columns of `history.csv` depend on: equal for two
    /// cases that differ in their titles, checks and lines, or in how long their bodies break, only.
    pub fn fingerprint(&self) -> String {
        let mut hasher = blake3::Hasher::new();
        hasher.update(self.essence().to_string().as_bytes());
        // Files may change while their names stay.
        if let (Self::Plane(scene), Body::Points(_) | Body::Mesh(_)) = (self, &self.case().body)
            && let PlaneBody::Cloud(cloud) = scene.body()
        {
            let positions = cloud.positions().iter().flatten();
            positions.chain(cloud.areas()).for_each(|x| {
                hasher.update(&x.to_le_bytes());
            });
        }
        hasher.finalize().to_hex().to_string()
    }

    /// The case without what changes no equilibrium.
    fn essence(&self) -> serde_json::Value {
        // Keys of a case are strings and its numbers have been read from JSON.
        let mut case = serde_json::to_value(self.case()).unwrap_or_default();
        if let Some(case) = case.as_object_mut() {
            WORDS.iter().for_each(|key| drop(case.shift_remove(*key)));
            if let Some(fracture) = case.get_mut("fracture").and_then(|f| f.as_object_mut()) {
                EXTENT.iter().for_each(|key| drop(fracture.shift_remove(*key)));
            }
        }
        case
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;
    use std::path::Path;

    /// Fingerprint of a plate with some of its keys replaced.
    fn of(overrides: &[&str]) -> String {
        let text = include_str!("../cli/new_bond_plane.json").to_string();
        let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
        let source = crate::case::from_text("case", text, &overrides).unwrap();
        Scene::new(source.case, Path::new("."), "case", "", None).unwrap().fingerprint()
    }

    #[test]
    fn words_do_not_count_and_numbers_do() {
        let plain = of(&[]);
        assert_eq!(plain.len(), 64);
        assert_eq!(plain, of(&[]));
        assert_eq!(plain, of(&["title=another"]));
        assert_eq!(plain, of(&["slow=true"]));
        assert_ne!(plain, of(&["horizon_ratio=3.0000000000000004"]));
        assert_ne!(plain, of(&["solver=sparse"]));
    }
}
