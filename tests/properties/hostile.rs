//! Whatever a case says, it is solved with finite numbers or refused with a message, within bounds of time and memory.

use super::entry::fills;
use super::mutate::{Random, mutate};
use super::small_cases::{MODELS, small_case};
use peristat::Loaded;
use peristat::case::{self, Case};
use peristat::diagnostic::decode;
use peristat::input::{Folder, Reach, drawing, gmsh, points};
use peristat::results::{Claim, FieldFiles, Results, finite};
use peristat::run::{Advance, Restart, RunOptions, Sink, StateResult};
use peristat::scene::Scene;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{LazyLock, mpsc};
use std::thread;
use std::time::Duration;

/// Memory that a case may need, bytes.
const MEMORY: u64 = 48_000_000;
/// Memory that this process may take in the end, bytes: it runs several cases side by side, and keeps what it has had.
const PEAK: u64 = 2_000_000_000;
/// Time after which a case hangs. Measured 4 s for the slowest one.
const HANG: Duration = Duration::from_secs(120);

/// A sink that does as the command does: it refuses what is not finite, and may write it.
struct Checking<'a> {
    scene: &'a Scene,
    folder: Option<&'a Path>,
    results: Option<Results>,
}

impl Checking<'_> {
    fn results(&mut self) -> io::Result<Option<&mut Results>> {
        if let (Some(folder), None) = (self.folder, &self.results) {
            let claim = Claim::new(folder, true, None)?;
            self.results = Some(Results::begin(&claim, self.scene, FieldFiles::default())?);
        }
        Ok(self.results.as_mut())
    }
}

impl Sink for Checking<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        if !finite(&result) {
            return Err(io::ErrorKind::InvalidData.into());
        }
        let scene = self.scene;
        self.results()?.map_or(Ok(()), |results| results.take(scene, &result))
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.results()?.map_or(Ok(()), |results| results.advance(event, restart, false))
    }
}

/// A `null` in a record, where a number is not finite. Checks find nothing where a body does not break, say.
fn null(value: &Value, place: &str) -> Option<String> {
    match value {
        Value::Null
            if place.starts_with(".checks[") && (place.ends_with(".found") || place.ends_with(".error")) =>
        {
            None
        }
        Value::Null => Some(place.into()),
        Value::Array(list) => list.iter().enumerate().find_map(|(k, v)| null(v, &format!("{place}[{k}]"))),
        Value::Object(map) => map.iter().find_map(|(key, v)| null(v, &format!("{place}.{key}"))),
        _ => None,
    }
}

/// Reads, builds and solves a case; whether it has a result.
fn solve(bytes: Vec<u8>, folder: &Path, output: Option<&Path>) -> bool {
    let folder = Folder::new(folder, Reach::Inside);
    let source = decode("case", bytes).and_then(|text| case::from_text("case", text, &[], &folder));
    let Ok(source) = source.map_err(|report| report.render(false)) else { return false };
    let loaded = Loaded::from_source(source, folder, Some(MEMORY));
    let Ok(loaded) = loaded.map_err(|error| error.to_string()) else { return false };
    let mut sink = Checking { scene: &loaded.scene, folder: output, results: None };
    let options = RunOptions { recover: true, max_memory: Some(MEMORY), compare: true };
    match loaded.run(&options, None, &mut sink) {
        Ok(summary) => {
            let record = serde_json::to_value(&summary).expect("a record is JSON");
            assert_eq!(null(&record, ""), None, "a number is not finite");
            if let Some(results) = sink.results {
                results.finish(&summary, loaded.scene.case()).expect("results are written");
            }
            true
        }
        Err(error) => {
            let _ = error.to_string();
            false
        }
    }
}

/// The same in a thread of its own: what is wrong if it panics, hangs or takes too much memory.
fn attempt(bytes: &[u8], folder: &Path, writes: bool) -> Result<bool, TestCaseError> {
    let (send, receive) = mpsc::channel();
    let (own, folder) = (bytes.to_vec(), folder.to_path_buf());
    thread::spawn(move || {
        let output = writes.then(|| tempfile::tempdir().expect("a folder for results"));
        let path = output.as_ref().map(|o| o.path().join("out"));
        let _ = send.send(catch_unwind(AssertUnwindSafe(|| solve(own, &folder, path.as_deref()))));
    });
    let fail = |what: &str| Err(TestCaseError::fail(format!("{what}\n{}", String::from_utf8_lossy(bytes))));
    match receive.recv_timeout(HANG) {
        Ok(Ok(_)) if peak() > PEAK => fail("takes too much memory"),
        Ok(Ok(solved)) => Ok(solved),
        Ok(Err(_)) => fail("panics"),
        Err(_) => fail("hangs"),
    }
}

/// Largest memory of this process so far, bytes; zero where the system does not tell.
fn peak() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|l| l.split_whitespace().next()?.parse::<u64>().ok())
        .map_or(0, |kilobytes| 1024 * kilobytes)
}

/// Cases of the gallery that take little, with their folders.
pub(crate) static GALLERY: LazyLock<Vec<(PathBuf, Value)>> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut found = Vec::new();
    for folder in ["beam", "frame", "plate", "orthotropic", "axisymmetric", "shell", "ductile"] {
        let mut files: Vec<PathBuf> = fs::read_dir(root.join(folder))
            .expect("a folder")
            .map(|entry| entry.expect("an entry").path())
            .collect();
        files.sort();
        for file in files.iter().filter(|f| f.extension().is_some_and(|e| e == "json")) {
            let text = fs::read_to_string(file).expect("a case");
            let case: Value = serde_json::from_str(&text).expect("JSON");
            if text.len() < 8000 && case["slow"] != true {
                found.push((root.join(folder), case));
            }
        }
    }
    assert!(found.len() > 100, "found only {} cases", found.len());
    found
});

/// The case with few equilibria, where it breaks or softens: one more takes as long as the one before.
fn cut_short(mut case: Value) -> Value {
    for (block, key) in [("fracture", "max_solves"), ("path", "max_steps")] {
        if let Some(keys) = case.get_mut(block).and_then(Value::as_object_mut)
            && keys.get(key).is_none_or(|most| most.as_u64().is_some_and(|most| most > 6))
        {
            keys.insert(key.into(), json!(6));
        }
    }
    case
}

/// Changes of the bytes of a file.
fn mangle(text: &[u8], seed: u64) -> Vec<u8> {
    const TOKENS: [&str; 12] = [
        "0",
        "-1",
        "1e308",
        "nan",
        "inf",
        "18446744073709551615",
        "-9223372036854775808",
        "\n",
        ",",
        " ",
        "$End",
        "\u{feff}",
    ];
    let (mut bytes, mut random) = (text.to_vec(), Random(seed));
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(5) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => bytes[at..end].iter_mut().for_each(|b| *b ^= 1 << random.below(8)),
            3 => drop(bytes.splice(at..end, TOKENS[random.below(TOKENS.len())].bytes())),
            _ => {
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
        }
    }
    bytes
}

/// JSON of any shape, with keys and texts of cases.
fn any_json() -> impl Strategy<Value = Value> {
    let schema = schemars::schema_for!(Case).to_value();
    let mut words = vec![String::new(), "x".into()];
    vocabulary(&schema, &mut words);
    let word = move || proptest::sample::select(words.clone());
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        (-9_i64..9).prop_map(Value::from),
        word().prop_map(Value::from),
    ];
    leaf.prop_recursive(6, 120, 8, move |inner| {
        prop_oneof![
            proptest::collection::vec(inner.clone(), 0..5).prop_map(Value::from),
            proptest::collection::vec((word(), inner), 0..8)
                .prop_map(|members| Value::Object(members.into_iter().collect())),
        ]
    })
}

/// Keys and named values of a schema.
fn vocabulary(schema: &Value, words: &mut Vec<String>) {
    match schema {
        Value::Object(map) => {
            words.extend(
                map.get("properties").and_then(Value::as_object).into_iter().flat_map(|p| p.keys().cloned()),
            );
            words.extend(map.get("const").and_then(Value::as_str).map(Into::into));
            map.values().for_each(|inner| vocabulary(inner, words));
        }
        Value::Array(list) => list.iter().for_each(|inner| vocabulary(inner, words)),
        _ => {}
    }
}

/// Small cases that were refused, and those that were solved.
static SMALL: [AtomicUsize; 2] = [AtomicUsize::new(0), AtomicUsize::new(0)];

/// A folder without files that a case could name.
fn nowhere() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

proptest! {
    #![proptest_config(super::given_cases(400))]

    #[test]
    fn bytes_are_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(!attempt(&bytes, nowhere(), false)?);
    }

    #[test]
    fn json_of_any_shape_is_refused(value in any_json()) {
        prop_assert!(!attempt(value.to_string().as_bytes(), nowhere(), false)?, "it is solved");
    }

    #[test]
    fn a_case_with_any_bytes_changed_is_solved_or_refused(k in any::<prop::sample::Index>(), seed: u64) {
        let (folder, case) = k.get(&GALLERY[..]);
        let text = serde_json::to_string_pretty(&cut_short(case.clone())).expect("JSON");
        attempt(&mangle(text.as_bytes(), seed), folder, false)?;
    }

    #[test]
    fn a_case_with_any_values_changed_is_solved_or_refused(
        k in any::<prop::sample::Index>(), other in any::<prop::sample::Index>(), times in 1..5, seed: u64
    ) {
        let ((folder, case), (_, donor)) = (k.get(&GALLERY[..]), other.get(&GALLERY[..]));
        let (mut case, mut random) = (case.clone(), Random(seed));
        (0..times).for_each(|_| mutate(&mut case, donor, &mut random));
        attempt(cut_short(case).to_string().as_bytes(), folder, seed % 8 == 0)?;
    }

    #[test]
    fn a_small_case_of_any_model_is_solved_and_written(model in 0..MODELS, seed: u64) {
        let case = small_case(model, &mut Random(seed));
        let solved = attempt(case.to_string().as_bytes(), nowhere(), seed % 4 == 0)?;
        SMALL[usize::from(solved)].fetch_add(1, Ordering::Relaxed);
        let [refused, solved] = [0, 1].map(|k| SMALL[k].load(Ordering::Relaxed));
        // Measured 4 %.
        prop_assert!(refused <= 10 + solved / 3, "{refused} were refused, {solved} solved");
    }

    #[test]
    fn a_mesh_and_a_list_of_points_with_any_bytes_changed_are_read_or_refused(seed: u64) {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/plate");
        let read = |file: &str| fs::read(cases.join(file)).expect("a file");
        let _ = gmsh::read(&mangle(&read("bracket.msh"), seed));
        for (axes, list) in [(2, "scattered.csv"), (3, "../solid/scattered_bar.csv")] {
            let _ = points::read(&mangle(&read(list), seed), axes).and_then(|points| points.cloud(1.0));
        }
    }

    #[test]
    fn a_drawing_with_any_bytes_changed_is_read_or_refused(seed: u64, spacing in 1e-4..10.0_f64) {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/plate");
        for file in ["lug.dxf", "gusset.svg", "link.msh"] {
            let bytes = fs::read(cases.join(file)).expect("a file");
            if let Ok(found) = drawing::read(&mangle(&bytes, seed), 0.01 * spacing) {
                prop_assert!(found.border.vertices.iter().flatten().all(|x| x.is_finite()));
            }
        }
    }

    #[test]
    fn a_solid_with_any_bytes_changed_is_filled_or_refused(seed: u64) {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        for file in ["solid/bar.msh", "solid/slope.stl", "invalid/solid_cut_off.stl", "invalid/solid_shell.stl"] {
            fills(&mangle(&fs::read(cases.join(file)).expect("a file"), seed));
        }
    }
}
