//! A solid in `report.html`, as a browser shows it.

use super::browser::Browser;
use super::report::{assert_drawn, assert_no_faults, column, columns, hovered, open, parsed, solved};
use super::support::root;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::json;
use std::fs;
use std::path::Path;

/// The canvas of the figure.
const CANVAS: &str = "document.querySelector('figure canvas')";

/// Keeps what is seen of the body, above the colour bar, and tells the number of this picture.
fn keep(browser: &mut Browser) -> usize {
    let number = browser.value(&format!(
        "(c => (window.kept ??= []).push(c.getContext('2d').getImageData(0, 0, c.width, c.height - 70).data) - 1)({CANVAS})"
    ));
    number.as_u64().unwrap() as usize
}

/// Part of the bytes of two pictures that differ.
fn difference(browser: &mut Browser, a: usize, b: usize) -> f64 {
    let share = format!("kept[{a}].filter((v, k) => v !== kept[{b}][k]).length / kept[{a}].length");
    browser.value(&share).as_f64().unwrap()
}

/// Between 5e-4, which a software renderer made different at most in 30 times the same picture, and 9.6e-2 of the two most similar ones.
const SAME: f64 = 5e-3;

fn assert_all_differ(browser: &mut Browser, pictures: &[usize]) {
    for &a in pictures {
        for &b in pictures.iter().take_while(|&&b| b < a) {
            let found = difference(browser, a, b);
            assert!(found > SAME, "pictures {a} and {b} of {pictures:?} differ by {found:e}");
        }
    }
}

fn assert_same(browser: &mut Browser, a: usize, b: usize) {
    let found = difference(browser, a, b);
    assert!(found < SAME, "pictures {a} and {b} differ by {found:e}");
}

/// Chooses a value of a control, as its event tells.
fn set(browser: &mut Browser, control: &str, value: &str, event: &str) {
    browser.value(&format!(
        "(n => {{ n.value = '{value}'; n.dispatchEvent(new Event('{event}')) }})(document.querySelector('{control}'))"
    ));
}

fn choose(browser: &mut Browser, field: &str) {
    let number = browser.value(&format!(
        "String([...document.querySelector('.field').options].findIndex(o => o.text === '{field}'))"
    ));
    let number = number.as_str().unwrap().to_string();
    set(browser, ".field", &number, "change");
    browser.wait(&format!("document.querySelector('figure').dataset.ready === '{number}'"));
}

fn click(browser: &mut Browser, button: &str) {
    browser.value(&format!("document.querySelector('button{button}').click()"));
}

/// The point that the words beside the pointer name, and that their value is the one of the table: to half a step of 16 bits, and to
/// five digits.
fn assert_told(words: &[String], table: &[(String, Vec<f64>)], field: &str) -> [f64; 3] {
    let place: Vec<f64> = words[0].split(", ").map(|part| parsed(part.split(' ').nth(1).unwrap())).collect();
    let axes = ["x", "y", "z"].map(|name| column(table, name));
    let is_there = |&p: &usize| (0..3).all(|k| (axes[k][p] - place[k]).abs() < 1e-9);
    let point = (0..axes[0].len()).find(is_there).unwrap_or_else(|| panic!("there is no point at {words:?}"));
    assert!(words[1].starts_with(&format!("{field} ")), "{words:?}");
    let (value, values) = (parsed(words[1].split(' ').nth(1).unwrap()), column(table, field));
    let [low, high] = [f64::min, f64::max].map(|of| values.iter().copied().reduce(of).unwrap());
    let allowed = (high - low) / 65_535.0 + 1e-4 * values[point].abs();
    assert!((value - values[point]).abs() <= allowed, "{words:?}: {}", values[point]);
    [place[0], place[1], place[2]]
}

fn ball(browser: &mut Browser, folder: &Path) -> Vec<(String, Vec<f64>)> {
    let out = solved(folder, "solid/hollow_ball.json", &[]);
    open(browser, &out, 1000);
    columns(&out.join("fields/step_000.csv"))
}

#[test]
fn a_report_of_a_solid_turns_and_comes_back() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    ball(&mut browser, folder.path());
    assert_drawn(&mut browser);
    browser.value(&format!("{CANVAS}.scrollIntoView({{ block: 'center', behavior: 'instant' }})"));
    let at = browser
        .value(&format!("(b => [b.left + b.width / 2, b.top + 200])({CANVAS}.getBoundingClientRect())"));
    let [x, y] = [0, 1].map(|k| at[k].as_f64().unwrap());
    // Not the same from any side, as the stress of a ball is.
    choose(&mut browser, "ux");
    let first = keep(&mut browser);
    let mut seen = vec![first];
    // By the pointer, by keys, by the wheel, by the deformation, and by each of the standard views.
    browser.drag([x, y], [x + 60.0, y + 30.0]);
    seen.push(keep(&mut browser));
    for key in ["ArrowLeft", "ArrowUp", "+"] {
        browser.value(&format!("{CANVAS}.dispatchEvent(new KeyboardEvent('keydown', {{ key: '{key}' }}))"));
        seen.push(keep(&mut browser));
    }
    let wheel = json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": -120 });
    browser.call("Input.dispatchMouseEvent", wheel);
    seen.push(keep(&mut browser));
    for view in ["front", "back", "left", "right", "top", "bottom"] {
        click(&mut browser, &format!("[value={view}]"));
        seen.push(keep(&mut browser));
    }
    set(&mut browser, ".scale", "0", "input");
    assert_eq!(browser.value("document.querySelector('.slides output').value"), "off");
    seen.push(keep(&mut browser));
    assert_all_differ(&mut browser, &seen);
    set(&mut browser, ".scale", "1", "input");
    browser.value(&format!("{CANVAS}.dispatchEvent(new KeyboardEvent('keydown', {{ key: 'Home' }}))"));
    let last = keep(&mut browser);
    assert_same(&mut browser, last, first);
    assert_no_faults(&browser);
}

#[test]
fn a_report_of_a_solid_answers_on_its_surface_and_inside() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let table = ball(&mut browser, folder.path());
    let mut seen = Vec::new();
    for (k, field) in ["von_mises", "ux", "stress_xy"].into_iter().enumerate() {
        choose(&mut browser, field);
        seen.push(keep(&mut browser));
        let words = hovered(&mut browser, "figure", [0.45 + 0.04 * k as f64, 0.45]);
        assert_told(&words, &table, field);
    }
    // From in front a pointer on the body reads its layer at z = 11.5 or on a stair below; where it is cut at 6, that at 5.5.
    click(&mut browser, "[value=front]");
    set(&mut browser, ".across", "2", "change");
    assert_eq!(browser.value("document.querySelector('.depth').nextElementSibling.value"), "z 6 mm");
    for part in [[0.5, 0.45], [0.42, 0.6], [0.45, 0.5]] {
        let words = hovered(&mut browser, "figure", part);
        assert_eq!(assert_told(&words, &table, "stress_xy")[2], 5.5, "{words:?}");
    }
    seen.push(keep(&mut browser));
    // The other half, seen from behind, shows the other side of the cut.
    click(&mut browser, ".flip");
    click(&mut browser, "[value=back]");
    let words = hovered(&mut browser, "figure", [0.5, 0.45]);
    assert_eq!(assert_told(&words, &table, "stress_xy")[2], 6.5, "{words:?}");
    seen.push(keep(&mut browser));
    assert_all_differ(&mut browser, &seen);
    // Without a pointer the middle is read.
    set(&mut browser, ".across", "", "change");
    browser.value("document.querySelector('.tip').hidden = true");
    browser.value(&format!("{CANVAS}.dispatchEvent(new KeyboardEvent('keydown', {{ key: 'Enter' }}))"));
    assert_eq!(browser.value("document.querySelector('.tip').hidden"), false);
    assert_no_faults(&browser);
}

#[test]
fn a_report_of_a_solid_is_drawn_without_webgl() {
    let Some(mut browser) = Browser::start() else { return };
    let without = "const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
            return kind.startsWith('webgl') ? null : get.call(this, kind, ...more);
        };";
    browser.call("Page.addScriptToEvaluateOnNewDocument", json!({ "source": without }));
    let folder = tempfile::tempdir().unwrap();
    let table = ball(&mut browser, folder.path());
    assert_eq!(browser.value("document.querySelector('.slow').hidden"), false);
    assert_drawn(&mut browser);
    let words = hovered(&mut browser, "figure", [0.5, 0.45]);
    assert_told(&words, &table, "von_mises");
    assert_no_faults(&browser);
}

#[test]
fn states_of_a_solid_are_seen_from_one_place() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let out = solved(folder.path(), "solid/hollow_block.json", &[]);
    open(&mut browser, &out, 1000);
    assert_drawn(&mut browser);
    let press = |key: &str| {
        format!(
            "[...document.querySelectorAll('canvas')].find(c => c.offsetWidth)
                .dispatchEvent(new KeyboardEvent('keydown', {{ key: '{key}' }}))"
        )
    };
    browser.value(&press("ArrowLeft"));
    set(&mut browser, ".choose", "0", "change");
    browser.wait("document.querySelectorAll('.set:not([hidden])').length === 1 && 'ready' in document.querySelector('figure').dataset");
    assert_drawn(&mut browser);
    browser.wait(&format!("{CANVAS}.width > 900"));
    let turned = keep(&mut browser);
    browser.value(&press("Home"));
    let all = keep(&mut browser);
    browser.value(&press("ArrowLeft"));
    let again = keep(&mut browser);
    assert_all_differ(&mut browser, &[turned, all]);
    assert_same(&mut browser, turned, again);
    assert_no_faults(&browser);
}

#[test]
#[ignore = "writes docs/images/solid_report.png"]
fn the_picture_of_the_gallery() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let fine = ["--set", "body.block.spacing=0.25", "--no-estimate"];
    let out = solved(folder.path(), "solid/hollow_ball.json", &fine);
    open(&mut browser, &out, 940);
    set(&mut browser, ".across", "0", "change");
    set(&mut browser, ".depth", "16", "input");
    for key in ["ArrowRight", "ArrowUp"] {
        browser.value(&format!("{CANVAS}.dispatchEvent(new KeyboardEvent('keydown', {{ key: '{key}' }}))"));
    }
    let at = browser.value("(b => [b.left + scrollX - 12, b.top + scrollY - 12, b.width + 24, b.height])(document.querySelector('figure').getBoundingClientRect())");
    let clip = json!({ "x": at[0], "y": at[1], "width": at[2], "height": at[3], "scale": 1 });
    let picture = browser.call(
        "Page.captureScreenshot",
        json!({ "format": "png", "clip": clip, "captureBeyondViewport": true }),
    );
    let bytes = STANDARD.decode(picture["data"].as_str().unwrap()).unwrap();
    fs::write(root().join("docs/images/solid_report.png"), bytes).unwrap();
}
