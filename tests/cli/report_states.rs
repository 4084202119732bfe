//! The states of a plate that breaks, softens or is loaded in steps, in `report.html`, as a browser shows them.

use super::browser::Browser;
use super::report::{assert_drawn, assert_no_faults, column, columns, hovered, open, parsed, solved};
use super::support::json;
use serde_json::Value;
use std::fs;
use std::path::Path;

const MAP: &str = "document.querySelector('figure[data-kind=map]')";

/// What the page has as numbers for its map.
fn data(out: &Path) -> Value {
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    let (_, map) = report.split_once("<figure data-kind=\"map\">").expect("there is a map");
    let (_, data) = map.split_once("<script type=\"application/json\">").unwrap();
    serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap()
}

/// A strip of which every equilibrium is written.
fn strip(folder: &Path) -> std::path::PathBuf {
    solved(folder, "plate/breaking_batch.json", &["--set", "fracture.record_every=1"])
}

/// Chooses a state by the slider.
fn show(browser: &mut Browser, state: usize) {
    browser.value(&format!(
        "(s => {{ s.value = {state}; s.dispatchEvent(new Event('input')) }})({MAP}.querySelector('.state'))"
    ));
    browser.wait(&format!("{MAP}.dataset.state === '{state}'"));
}

fn press(browser: &mut Browser, key: &str) {
    browser.value(&format!(
        "{MAP}.querySelector('canvas').dispatchEvent(new KeyboardEvent('keydown', {{ key: '{key}' }}))"
    ));
}

/// A number that differs where pictures do.
fn picture(browser: &mut Browser, figure: &str) -> Value {
    browser.value(&format!(
        "(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.reduce((sum, v, k) => (sum + v * (k % 9973)) % 1e9, 0))
         (document.querySelector('{figure} canvas'))"
    ))
}

#[test]
fn the_map_of_a_plate_that_breaks_has_all_states_on_one_scale() {
    let folder = tempfile::tempdir().unwrap();
    let out = strip(folder.path());
    let states = json(&out.join("summary.json"))["states"].as_array().unwrap().len();
    let data = data(&out);
    assert!(states > 50);
    assert_eq!(data["before"].as_array().unwrap().len(), states - 1);
    // The colour bar ends at the extremes of all states.
    for field in data["fields"].as_array().unwrap().iter().filter(|f| f["name"] != "displacement") {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for state in 0..states {
            let table = columns(&out.join(format!("fields/step_{state:03}.csv")));
            let values = column(&table, field["name"].as_str().unwrap());
            values.iter().for_each(|v| (low, high) = (low.min(*v), high.max(*v)));
        }
        assert_eq!(
            (field["range"][0].as_f64(), field["range"][1].as_f64()),
            (Some(low), Some(high)),
            "{field}"
        );
    }
    // The crack has run through all of the ligament, never before it was there.
    let grown = data["grown"].as_array().unwrap();
    let columns = |until: usize| {
        let upper = |side: &&Value| side[1] == 1 && side[2].as_u64() <= Some(until as u64);
        grown.iter().filter(upper).count()
    };
    assert!(columns(0) == 0 && columns(states / 2) < columns(states - 1), "{grown:?}");
    assert!(columns(states - 1) >= 12, "{grown:?}");
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains(&format!("The map has all {states} states")));
    let plot = fs::read_to_string(out.join("plots/damage.svg")).unwrap();
    assert!(plot.matches("<path").count() + plot.matches("<polyline").count() > columns(states - 1));
}

#[test]
fn readers_go_through_the_states_by_slider_keys_and_film() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let out = strip(folder.path());
    for width in [1280, 400] {
        open(&mut browser, &out, width);
        let inside = browser.value(&format!(
            "[document.documentElement.scrollWidth <= innerWidth, ...['.state', '.play', '.told'].map(name => {{
                const box = {MAP}.querySelector(name).getBoundingClientRect();
                return box.width > 20 && box.left >= 0 && box.right <= innerWidth;
            }})].every(Boolean)"
        ));
        assert_eq!(inside, true, "{width} pixels");
        let last = browser.value(&format!("Number({MAP}.querySelector('.state').max)"));
        let last = last.as_f64().unwrap() as usize;
        let end = [
            picture(&mut browser, "figure[data-kind=map]"),
            picture(&mut browser, "figure[data-kind=chart]"),
        ];
        show(&mut browser, 40);
        let middle = [
            picture(&mut browser, "figure[data-kind=map]"),
            picture(&mut browser, "figure[data-kind=chart]"),
        ];
        // The curve has a ring where the state is.
        assert!(end[0] != middle[0] && end[1] != middle[1], "{end:?} {middle:?}");
        let told = browser.value(&format!("{MAP}.querySelector('.told').value"));
        assert!(told.as_str().unwrap().starts_with("equilibrium 40, load factor "), "{told}");
        assert_drawn(&mut browser);
        press(&mut browser, "ArrowRight");
        browser.wait(&format!("{MAP}.dataset.state === '41'"));
        press(&mut browser, "Home");
        browser.wait(&format!("{MAP}.dataset.state === '0'"));
        browser.value(&format!("{MAP}.querySelector('.play').click()"));
        browser.wait(&format!("Number({MAP}.dataset.state) > 2"));
        browser.value(&format!("{MAP}.querySelector('.play').click()"));
        press(&mut browser, "End");
        browser.wait(&format!("{MAP}.dataset.state === '{last}'"));
        assert_eq!(picture(&mut browser, "figure[data-kind=map]"), end[0], "back at the last state");
        assert_no_faults(&browser);
    }
}

#[test]
fn an_earlier_state_answers_with_its_values() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let out = strip(folder.path());
    open(&mut browser, &out, 1000);
    for (k, state) in [0, 40, 70].into_iter().enumerate() {
        show(&mut browser, state);
        let words = hovered(&mut browser, "figure[data-kind=map]", [0.48 + 0.02 * k as f64, 0.7]);
        let place: Vec<f64> =
            words[0].split(", ").map(|part| parsed(part.split(' ').nth(1).unwrap())).collect();
        let table = columns(&out.join(format!("fields/step_{state:03}.csv")));
        let (x, y, damage) = (column(&table, "x"), column(&table, "y"), column(&table, "damage"));
        let point = (0..x.len())
            .find(|&p| (x[p] - place[0]).abs() < 1e-9 && (y[p] - place[1]).abs() < 1e-9)
            .unwrap_or_else(|| panic!("there is no point at {words:?}"));
        let value = parsed(words[1].split(' ').nth(1).unwrap());
        let most = damage.iter().copied().fold(0.0, f64::max);
        // A step of 8 bits, told with its digits.
        assert!((value - damage[point]).abs() <= 0.01 * most, "{state}: {words:?}, {}", damage[point]);
    }
}

#[test]
fn load_steps_share_their_map_and_softening_bonds_part_cells() {
    let folder = tempfile::tempdir().unwrap();
    let out = solved(folder.path(), "ductile/panel.json", &[]);
    assert!(!data(&out)["grown"].as_array().unwrap().is_empty());
    let out = solved(folder.path(), "plate/stretched_in_steps.json", &[]);
    let states = json(&out.join("summary.json"))["states"].as_array().unwrap().len();
    assert_eq!(data(&out)["before"].as_array().unwrap().len(), states - 1);
    let Some(mut browser) = Browser::start() else { return };
    open(&mut browser, &out, 800);
    // The map and the list of tables follow each other.
    show(&mut browser, 0);
    assert_eq!(browser.value("document.querySelector('.choose').value"), "0");
    assert_eq!(browser.value("document.querySelector('.set').hidden"), false);
    browser.value(
        "(s => { s.value = 1; s.dispatchEvent(new Event('change')) })(document.querySelector('.choose'))",
    );
    browser.wait(&format!("{MAP}.dataset.state === '1'"));
    assert_no_faults(&browser);
}

#[test]
fn tables_that_are_cut_off_say_so() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let out = solved(folder.path(), "plate/breaking_batch.json", &[]);
    let hint = "document.querySelector('.more')";
    open(&mut browser, &out, 400);
    browser.wait(&format!("!{hint}.hidden"));
    browser.value("document.querySelector('.scroll').scrollLeft = 10000");
    browser.wait(&format!("{hint}.hidden"));
    open(&mut browser, &out, 1280);
    browser.wait(&format!("{hint}.hidden"));
}
