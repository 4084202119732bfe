//! Files that a case names, as its results keep them.

use crate::case::Case;
use crate::diagnostic::{Faults, JsonPath};
use crate::input::{Folder, Refusal};
use std::path::Path;

/// Folder of these files beside the `case.json` of results.
pub const INPUTS: &str = "inputs";

/// A file that a case names.
#[derive(Clone, Debug)]
pub struct InputFile {
    /// Its name in [`INPUTS`].
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// What a baseline is.
pub(super) const BASELINE: &str =
    "the path is relative to the case; `fields/step_000.csv` of an earlier run is a baseline";

/// The text of a baseline of the check at `path`.
pub(super) fn text(
    folder: &Folder,
    file: &str,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<String> {
    let text = folder.read(file, max_memory).and_then(|bytes| {
        String::from_utf8(bytes).map_err(|_| Refusal { reason: "is no text".into(), hint: None })
    });
    let refuse = |refusal: Refusal| {
        let fault = faults.error(path.key("file"), format!("the baseline {file} {}", refusal.reason));
        fault.hint(refusal.hint.unwrap_or(BASELINE));
    };
    text.map_err(refuse).ok()
}

/// The number of a column in the head of a table, where names may have their unit behind them, such as `uy [mm]`; `unit` is that of
/// the case, empty if there is none.
pub(super) fn column(heads: &[&str], name: &str, unit: &str) -> Result<usize, String> {
    let behind = |head: &&str| Some(head.strip_prefix(name)?.trim_start().to_string());
    let is_unit = |rest: &String| rest.is_empty() || rest.starts_with('[');
    let found = heads.iter().map(behind).enumerate().find_map(|(k, rest)| Some((k, rest.filter(is_unit)?)));
    let (number, given) = found.ok_or_else(|| format!("has no column `{name}`"))?;
    if given.is_empty() || given == format!("[{unit}]") {
        return Ok(number);
    }
    let own = if unit.is_empty() { "no unit".into() } else { format!("[{unit}]") };
    Err(format!("has `{name}` in {given}, and the case in {own}"))
}

/// Files of a case, which then names them as its results do: results need nothing that lies outside of them to be run again.
pub(super) fn keep(case: &mut Case, folder: &Folder, max_memory: Option<u64>) -> Vec<InputFile> {
    let mut kept: Vec<InputFile> = Vec::new();
    for file in case.files_mut() {
        let Ok(bytes) = folder.read(file, max_memory) else { continue };
        let plain = Path::new(&*file).file_name().unwrap_or_default().to_string_lossy().into_owned();
        let numbered = (2..).map(|k| format!("{k}_{plain}"));
        let mut names = std::iter::once(plain.clone()).chain(numbered);
        // Equal names may be of files in two folders, equal files have one name; some systems do not tell A from a.
        let free = names.find_map(|name| {
            let taken = kept.iter().find(|k| k.name.eq_ignore_ascii_case(&name));
            taken.is_none_or(|k| k.bytes == bytes).then(|| (taken.map(|k| k.name.clone()), name))
        });
        let Some((same, name)) = free else { continue };
        *file = format!("{INPUTS}/{}", same.as_ref().unwrap_or(&name));
        if same.is_none() {
            kept.push(InputFile { name, bytes });
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn files_of_one_name_are_told_apart_and_equal_ones_are_kept_once() {
        let folder = tempfile::tempdir().unwrap();
        for (file, text) in [("a.csv", "1"), ("b/a.csv", "2"), ("c/a.csv", "1"), ("b/A.csv", "3")] {
            let path = folder.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        let check =
            |file: &str| serde_json::json!({ "baseline": { "file": file, "field": "w", "tolerance": 1 } });
        let checks = ["a.csv", "b/a.csv", "c/a.csv", "./b/a.csv", "b/A.csv", "none.csv"].map(check);
        let text = crate::model::start("timoshenko_beam").unwrap().to_string();
        let set = [format!("checks={}", serde_json::Value::from(checks.to_vec()))];
        let mut case = crate::case::from_text("case", text, &set, &Folder::default()).unwrap().case;
        let kept = keep(&mut case, &folder.path().into(), None);
        let names: Vec<String> = case.files_mut().into_iter().map(|f| f.clone()).collect();
        let expected = [
            "inputs/a.csv",
            "inputs/2_a.csv",
            "inputs/a.csv",
            "inputs/2_a.csv",
            "inputs/3_A.csv",
            "none.csv",
        ];
        assert_eq!(names, expected);
        let kept: Vec<(&str, &[u8])> = kept.iter().map(|k| (k.name.as_str(), &k.bytes[..])).collect();
        assert_eq!(kept, [("a.csv", &b"1"[..]), ("2_a.csv", b"2"), ("3_A.csv", b"3")]);
    }
}
