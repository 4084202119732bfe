//! What tells cases apart that have other results.

use super::Scene;

/// Keys of a case that change no equilibrium: words, and what is made of results.
const WORDS: [&str; 6] = ["$schema", "title", "about", "lines", "checks", "slow"];
/// Keys of `fracture` and `path` that say only how long to go on and what to write.
const EXTENT: [&str; 4] = ["stop_below", "max_solves", "max_steps", "record_every"];

impl Scene {
    /// A hash, as hexadecimal digits, of all that the equilibria and the columns of `history.csv` depend on: equal for two
    /// cases that differ in their titles, checks and lines, or in how far their bodies break or soften, only. Another version of
    /// this program has another one: it may find other equilibria.
    ///
    /// # Errors
    /// The case cannot be written as JSON.
    pub fn fingerprint(&self) -> serde_json::Result<String> {
        let mut hasher = blake3::Hasher::new();
        hasher.update(env!("CARGO_PKG_VERSION").as_bytes());
        hasher.update(self.essence()?.to_string().as_bytes());
        // A file may change while its name stays.
        if let Self::Body(scene) = self {
            if let Some(content) = scene.file() {
                hasher.update(content.as_bytes());
            }
            for factor in &scene.materials().factors {
                hasher.update(&factor.to_le_bytes());
            }
        }
        Ok(hasher.finalize().to_hex().to_string())
    }

    /// The case without what changes no equilibrium.
    fn essence(&self) -> serde_json::Result<serde_json::Value> {
        let mut case = serde_json::to_value(self.case())?;
        if let Some(case) = case.as_object_mut() {
            WORDS.iter().for_each(|key| drop(case.shift_remove(*key)));
            for part in ["fracture", "path"] {
                let Some(part) = case.get_mut(part).and_then(|part| part.as_object_mut()) else { continue };
                EXTENT.iter().for_each(|key| drop(part.shift_remove(*key)));
            }
        }
        Ok(case)
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;
    use std::path::Path;

    /// Fingerprint of a plate with some of its keys replaced.
    fn of(overrides: &[&str]) -> String {
        let text = crate::model::start("bond_plane").unwrap().to_string();
        let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
        let source =
            crate::case::from_text("case", text, &overrides, &crate::input::Folder::default()).unwrap();
        Scene::new(source.case, Path::new("."), "case", "", None).unwrap().fingerprint().unwrap()
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

    #[test]
    fn names_of_groups_in_a_mesh_count() {
        let cases = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/plate"));
        let folder = tempfile::tempdir().unwrap();
        let mesh = std::fs::read_to_string(cases.join("bracket.msh")).unwrap();
        let of = |mesh: &str| {
            std::fs::write(folder.path().join("bracket.msh"), mesh).unwrap();
            let source = crate::case::read(
                &cases.join("bracket.json"),
                &["checks=[]".into()],
                &crate::input::Folder::default(),
                None,
            )
            .unwrap();
            Scene::new(source.case, folder.path(), "case", "", None).unwrap().fingerprint().unwrap()
        };
        let first = of(&mesh);
        assert_eq!(first, of(&mesh));
        // The same points, held elsewhere.
        let swapped =
            mesh.replace("1 1 \"fixed\"", "1 1 \"loaded\"").replace("1 2 \"loaded\"", "1 2 \"fixed\"");
        assert_ne!(swapped, mesh);
        assert_ne!(first, of(&swapped));
    }
}
