//! The numbers of small cases of the gallery, of every list the first two, so small and so large that squares of them fit no
//! double: the case becomes a scene or is refused, and that soon.

use super::entry::resolves;
use super::hostile::GALLERY;
use super::mutate::Random;
use serde_json::{Value, json};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Small or large enough that a square, or a product of three, is zero or infinite.
const EXTREMES: [f64; 8] = [1e-308, 1e-200, 1e-150, 1e-110, 1e110, 1e150, 1e200, 1e308];
/// Time after which a case hangs. Measured 0.4 s for the slowest one.
const HANG: Duration = Duration::from_secs(60);

/// Pointers to the numbers of a value, the first two of a list.
fn numbers(value: &Value, pointer: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(pointer.into()),
        Value::Object(map) => {
            map.iter().for_each(|(key, inner)| numbers(inner, &format!("{pointer}/{key}"), found));
        }
        Value::Array(list) => {
            let few = list.iter().take(2).enumerate();
            few.for_each(|(k, inner)| numbers(inner, &format!("{pointer}/{k}"), found));
        }
        _ => {}
    }
}

#[test]
fn no_extreme_number_hangs() {
    let (send, receive) = mpsc::channel();
    let tries = thread::spawn(move || {
        let mut random = Random(1);
        for (_, case) in GALLERY.iter() {
            let mut found = Vec::new();
            numbers(case, "", &mut found);
            for pointer in found {
                for extreme in EXTREMES {
                    let mut changed = case.clone();
                    let sign = random.pick(&[1.0, 1.0, 1.0, -1.0]);
                    *changed.pointer_mut(&pointer).expect("a number") = json!(sign * extreme);
                    let text = changed.to_string();
                    send.send(text.clone()).expect("someone listens");
                    resolves(text.into_bytes());
                }
            }
        }
    });
    let (mut count, mut last) = (0, String::new());
    loop {
        match receive.recv_timeout(HANG) {
            Ok(text) => (count, last) = (count + 1, text),
            Err(mpsc::RecvTimeoutError::Timeout) => panic!("hangs:\n{last}"),
            Err(mpsc::RecvTimeoutError::Disconnected) => break,
        }
    }
    assert!(tries.join().is_ok(), "panics:\n{last}");
    // Measured 31000.
    assert!(count > 20_000, "tried {count}, the last of them:\n{last}");
}
