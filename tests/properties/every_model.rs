//! What is asked of every model, of the cases that `peristat new` prints for it.

use peristat::model::{TABLE, starts};
use peristat::{Solved, solve_text};
use serde_json::{Value, json};

fn solved(name: &str, case: &Value) -> Solved {
    solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn written(case: &str) -> Value {
    serde_json::from_str(case).expect("a starting case is JSON")
}

/// Largest difference of the probes of two runs over the largest of their values.
fn difference(a: &Solved, b: &Solved, factor: f64) -> f64 {
    let pairs = a.summary.probes.iter().zip(&b.summary.probes);
    pairs
        .map(|(a, b)| (factor * a.value - b.value).abs() / b.value.abs().max(f64::MIN_POSITIVE))
        .fold(0.0, f64::max)
}

#[test]
fn every_model_has_a_case_to_begin_with_that_passes() {
    for entry in TABLE {
        assert!(!entry.starts.is_empty() && !entry.about.is_empty(), "{}", entry.name);
        for start in entry.starts {
            let found = solved(start.name, &written(start.case));
            assert!(
                !found.summary.checks.is_empty() && found.summary.checks.iter().all(|c| c.passed),
                "{}",
                start.name
            );
            let model = &written(start.case)["model"];
            assert!(model.get(entry.name).is_some(), "{}: {model}", start.name);
        }
    }
}

#[test]
fn loads_as_asked_act_and_are_held() {
    for start in starts() {
        let found = solved(start.name, &written(start.case));
        for state in &found.summary.states {
            let resultants = state.certificate.resultants.as_ref().expect("resultants");
            // 6e-15 measured at the most.
            assert!(resultants.difference < 1e-11, "{}: {resultants:?}", start.name);
            let pairs = resultants.applied.forces().into_iter().zip(resultants.reactions.forces());
            let pairs: Vec<[f64; 2]> = pairs.filter_map(|(a, b)| Some([a?, b?])).collect();
            let size = pairs.iter().fold(0.0, |size: f64, [applied, _]| size.max(applied.abs()));
            // 1e-11 measured at the most; of a pressure inside of a tube rounding is left, 1e-10 N.
            let is_held = |[applied, held]: &[f64; 2]| (applied + held).abs() <= 1e-9 * size.max(1.0);
            assert!(pairs.iter().all(is_held), "{}: {pairs:?}", start.name);
        }
    }
}

/// All numbers of loads times a factor, places and counts aside.
fn multiply(value: &mut Value, factor: f64) {
    const KEPT: [&str; 8] = ["at", "from", "to", "depth", "centre", "radius", "harmonic", "half_waves"];
    match value {
        Value::Number(number) => *value = json!(factor * number.as_f64().expect("a number")),
        Value::Array(values) => values.iter_mut().for_each(|v| multiply(v, factor)),
        Value::Object(map) => {
            map.iter_mut().filter(|(key, _)| !KEPT.contains(&&***key)).for_each(|(_, v)| multiply(v, factor));
        }
        _ => {}
    }
}

#[test]
fn half_the_load_is_half_the_answer() {
    for start in starts() {
        let mut case = written(start.case);
        let whole = solved(start.name, &case);
        for key in ["loads", "load_cases"] {
            case.get_mut(key).into_iter().for_each(|loads| multiply(loads, 0.5));
        }
        let half = solved(start.name, &case);
        // A half is exact in binary numbers: 2e-12 measured at the most, by iterations.
        let off = difference(&whole, &half, 0.5);
        assert!(off < 1e-9, "{}: {off}", start.name);
    }
}

#[test]
fn a_case_with_its_defaults_filled_in_has_the_same_answer() {
    for start in starts() {
        let first = solved(start.name, &written(start.case));
        let filled = serde_json::to_value(first.scene.case()).expect("a case is JSON");
        let second = solved(start.name, &filled);
        assert_eq!(difference(&first, &second, 1.0), 0.0, "{}", start.name);
    }
}

#[test]
fn keys_without_a_meaning_are_refused_with_a_hint() {
    let example = |key: &str| match key {
        "cracks" => json!([{ "path": [[1.0, 1.0], [2.0, 1.0]] }]),
        "fracture" => json!({ "critical": { "stretch": 0.1 }, "load": "nothing" }),
        "path" => json!({ "load": "nothing" }),
        "periodic" => json!([{ "along": "x" }]),
        "rigid" => json!([{ "region": "left" }]),
        "rigid.bearing" => {
            json!([{ "region": "left", "bearing": { "direction": [0.0, 1.0], "half_angle": 60.0 } }])
        }
        "stress_intensity" => json!([{ "name": "K", "crack": 1, "tips": "end" }]),
        other => panic!("no example of `{other}`"),
    };
    let mut count = 0;
    for start in starts() {
        let case = written(start.case);
        let model: peristat::model::Model = serde_json::from_value(case["model"].clone()).expect("a model");
        let Ok(keys) = model.keys() else { continue };
        for refused in keys.refuses() {
            let mut case = case.clone();
            case[refused.key.split('.').next().expect("a key")] = example(refused.key);
            let error = solve_text(&case.to_string()).err().map(|e| e.to_string()).unwrap_or_default();
            assert!(
                error.contains(refused.message) && error.contains(refused.hint),
                "{}: {error}",
                start.name
            );
            count += 1;
        }
    }
    assert!(count >= 10, "{count}");
}
