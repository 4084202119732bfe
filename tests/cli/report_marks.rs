//! Isolines and arrows on the map of a report.

use super::browser::Browser;
use super::report::{assert_drawn, assert_no_faults, open, parsed, solved};
use serde_json::{Value, json};

const MAP: &str = "document.querySelector('figure[data-kind=map]')";
const SCRIPTS: [&str; 2] = [
    include_str!("../../crates/driver/src/output/report/number.js"),
    include_str!("../../crates/driver/src/output/report/marks.js"),
];

/// Chooses a field by its name.
fn choose(browser: &mut Browser, field: &str) {
    browser.value(&format!(
        "(s => {{ s.value = [...s.options].findIndex(o => o.text === '{field}'); s.dispatchEvent(new Event('change')) }})({MAP}.querySelector('.field'))"
    ));
    browser.wait(&format!("{MAP}.dataset.ready === {MAP}.querySelector('.field').value"));
}

/// Values of the isolines that are shown, and the number of arrows.
fn shown(browser: &mut Browser) -> (Vec<f64>, usize) {
    let told = browser.value(&format!("[{MAP}.dataset.isolines, Number({MAP}.dataset.arrows)]"));
    let lines = told[0].as_str().unwrap().split_whitespace().map(parsed).collect();
    (lines, told[1].as_u64().unwrap() as usize)
}

fn picture(browser: &mut Browser) -> Value {
    browser.value(&format!(
        "(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.reduce((sum, v, k) => (sum + v * (k % 9973)) % 1e9, 0))
         ({MAP}.querySelector('canvas'))"
    ))
}

fn slide(browser: &mut Browser, to: f64) {
    browser.value(&format!(
        "(s => {{ s.value = {to}; s.dispatchEvent(new Event('input')) }})({MAP}.querySelector('.scale'))"
    ));
}

#[test]
fn isolines_lie_where_a_field_has_their_values_and_arrows_along_principal_axes() {
    let Some(mut browser) = Browser::start() else { return };
    // x + 2 y on a unit square, and pure shear at its first corner.
    let found = browser.value(&format!(
        "(() => {{ {} const places = (k) => [[0, 0], [1, 0], [1, 1], [0, 1]][k];
            return [isolines([[0, 1, 2, 3]], [0, 1, 3, 2], places, [0, 3], 3),
                    principal({{ own: [0], room: 1 }}, [[0], [0], [5]], places)]; }})()",
        SCRIPTS.concat()
    ));
    let lines = found[0].as_array().unwrap();
    assert_eq!(lines.iter().map(|line| line["value"].as_f64().unwrap()).collect::<Vec<_>>(), [1.0, 2.0]);
    for line in lines {
        let pieces = line["pieces"].as_array().unwrap();
        assert_eq!(pieces.len(), 2, "{line}");
        for end in pieces.iter().flat_map(|piece| piece.as_array().unwrap()) {
            let value = end[0].as_f64().unwrap() + 2.0 * end[1].as_f64().unwrap();
            assert!((value - line["value"].as_f64().unwrap()).abs() < 1e-14, "{line}");
        }
    }
    // 0.47 of the room under 45°: outwards along (1, 1), inwards along (−1, 1).
    let half = 0.47 / 2.0_f64.sqrt();
    let expected = [
        [[0.0, 0.0], [half, half]],
        [[0.0, 0.0], [-half, -half]],
        [[-half, half], [0.0, 0.0]],
        [[half, -half], [0.0, 0.0]],
    ];
    for (arrow, ends) in found[1].as_array().unwrap().iter().zip(expected) {
        for (k, c) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            assert!((arrow[k][c].as_f64().unwrap() - ends[k][c]).abs() < 1e-14, "{arrow} {ends:?}");
        }
    }
}

#[test]
fn marks_follow_the_field_the_state_the_slider_and_the_dark() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let drawing = r#"drawing={ "isolines": 6, "arrows": "principal_stress" }"#;
    let out = solved(folder.path(), "plate/stretched_in_steps.json", &["--set", drawing]);
    for width in [1280, 400] {
        open(&mut browser, &out, width);
        choose(&mut browser, "ux");
        let (lines, arrows) = shown(&mut browser);
        assert!((3..=12).contains(&lines.len()) && arrows == 0, "{lines:?}, {arrows}");
        // Half of the last state's displacements: fewer isolines of the values of all states.
        let last = picture(&mut browser);
        browser.value(&format!(
            "(s => {{ s.value = 0; s.dispatchEvent(new Event('input')) }})({MAP}.querySelector('.state'))"
        ));
        browser.wait(&format!("{MAP}.dataset.state === '0'"));
        assert!(shown(&mut browser).0.len() < lines.len(), "{:?}", shown(&mut browser));
        assert_ne!(picture(&mut browser), last);
        choose(&mut browser, "von_mises");
        let (_, arrows) = shown(&mut browser);
        assert!(arrows > 100, "{arrows}");
        let moved = picture(&mut browser);
        slide(&mut browser, 0.0);
        assert_eq!(shown(&mut browser).1, arrows);
        assert_ne!(picture(&mut browser), moved);
        let light = picture(&mut browser);
        browser.value("document.getElementById('theme').click()");
        assert_ne!(picture(&mut browser), light);
        assert_drawn(&mut browser);
        browser.value("document.getElementById('theme').click()");
        assert_no_faults(&browser);
    }
}

#[test]
fn arrows_of_displacements_are_on_displacements_and_there_at_rest() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let plain = solved(folder.path(), "plate/cantilever.json", &["--set", "drawing={}"]);
    open(&mut browser, &plain, 800);
    choose(&mut browser, "uy");
    slide(&mut browser, 0.0);
    assert_eq!(shown(&mut browser), (vec![], 0));
    let without = picture(&mut browser);
    let out = solved(folder.path(), "plate/cantilever.json", &[]);
    open(&mut browser, &out, 800);
    choose(&mut browser, "von_mises");
    assert_eq!(shown(&mut browser).1, 0);
    choose(&mut browser, "uy");
    // Every fourth of 80 × 40 cells, both ways.
    assert_eq!(shown(&mut browser), (vec![], 20 * 10));
    slide(&mut browser, 0.0);
    assert_ne!(picture(&mut browser), without);
    assert_eq!(shown(&mut browser).1, 200);
    assert_eq!(json!(browser.value(&format!("{MAP}.textContent.includes('where points have moved')"))), true);
}
