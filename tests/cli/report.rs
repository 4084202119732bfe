//! `report.html` of a run, as a browser shows it.

use super::browser::Browser;
use super::support::{json, root, run};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Solves a case of the gallery into `out`; its folder.
pub(super) fn solved(folder: &Path, case: &str, more: &[&str]) -> PathBuf {
    let case = root().join("cases").join(case).display().to_string();
    let mut arguments = vec!["run", &case, "-o", "out", "-q", "--force"];
    arguments.extend(more);
    let outcome = run(folder, &arguments);
    assert!(outcome.stderr.is_empty(), "{}", outcome.stderr);
    folder.join("out")
}

/// A number as the page writes it: `−2.5×10⁻⁶`.
pub(super) fn parsed(text: &str) -> f64 {
    let plain = text.chars().map(|c| match c {
        '−' | '⁻' => '-',
        '×' => 'e',
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        c @ '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10).unwrap(),
        c => c,
    });
    let plain: String = plain.collect();
    plain.replace("e10", "e").parse().unwrap_or_else(|_| panic!("`{text}` is no number"))
}

/// Columns of a table of the run by name, without units.
pub(super) fn columns(file: &Path) -> Vec<(String, Vec<f64>)> {
    let text = fs::read_to_string(file).unwrap();
    let names = text
        .lines()
        .next()
        .unwrap()
        .split(',')
        .map(|head| head.split(" [").next().unwrap_or(head).to_string());
    let mut columns: Vec<(String, Vec<f64>)> = names.map(|name| (name, Vec::new())).collect();
    for line in text.lines().skip(1) {
        columns.iter_mut().zip(line.split(',')).for_each(|(c, cell)| c.1.push(cell.parse().unwrap()));
    }
    columns
}

pub(super) fn column<'a>(columns: &'a [(String, Vec<f64>)], name: &str) -> &'a [f64] {
    &columns.iter().find(|c| c.0 == name).unwrap().1
}

/// Opens a report in a window of some width.
pub(super) fn open(browser: &mut Browser, out: &Path, width: u32) {
    browser.resize(width, 900);
    browser.open(&out.join("report.html"));
    assert_no_faults(browser);
    let asked = browser.told(&["Network.requestWillBeSent"]);
    let asked: HashSet<&str> = asked.iter().filter_map(|r| r["request"]["url"].as_str()).collect();
    assert_eq!(asked.len(), 1, "the page asks for {asked:?}");
    assert!(asked.iter().all(|url| url.ends_with("/out/report.html")), "{asked:?}");
}

/// The page told nothing; what a driver of graphics says of its speed is no fault of it.
pub(super) fn assert_no_faults(browser: &Browser) {
    let faults = browser.told(&["Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"]);
    let of_page = faults.into_iter().filter(|fault| fault["entry"]["source"] != "rendering");
    assert_eq!(of_page.collect::<Vec<_>>(), Vec::<&Value>::new());
}

/// Every canvas that is shown has more than a few colours.
pub(super) fn assert_drawn(browser: &mut Browser) {
    let counts = browser.value(
        "[...document.querySelectorAll('canvas')].filter(c => c.offsetWidth).map(c => {
            const pixels = new Uint32Array(c.getContext('2d').getImageData(0, 0, c.width, c.height).data.buffer);
            return new Set(pixels).size;
        })",
    );
    let counts: Vec<u64> = counts.as_array().unwrap().iter().map(|c| c.as_u64().unwrap()).collect();
    assert!(!counts.is_empty() && counts.iter().all(|&count| count > 8), "{counts:?}");
}

/// Words beside the pointer, with the pointer at parts of the width and height of a figure's canvas.
pub(super) fn hovered(browser: &mut Browser, figure: &str, [across, down]: [f64; 2]) -> Vec<String> {
    let canvas = format!("document.querySelector('{figure} canvas')");
    browser.value(&format!("{canvas}.scrollIntoView({{ block: 'center', behavior: 'instant' }})"));
    let at = browser
        .value(&format!("(b => [b.left, b.top, b.width, b.height])({canvas}.getBoundingClientRect())"));
    let [left, top, width, height] = [0, 1, 2, 3].map(|k| at[k].as_f64().unwrap());
    browser.point(left + across * width, top + down * height);
    let tip = format!("document.querySelector('{figure} .tip')");
    browser.wait(&format!("!{tip}.hidden"));
    let lines = browser.value(&format!("[...{tip}.children].map(line => line.textContent)"));
    lines.as_array().unwrap().iter().map(|line| line.as_str().unwrap().to_string()).collect()
}

/// Colours of an image that the browser draws itself, and its size.
fn screenshot(browser: &mut Browser) -> (u64, [u64; 2]) {
    let picture = browser.call("Page.captureScreenshot", json!({ "format": "png" }));
    let data = picture["data"].as_str().unwrap().to_string();
    let bytes = STANDARD.decode(&data).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let size = [16, 20].map(|k| u64::from(u32::from_be_bytes(bytes[k..k + 4].try_into().unwrap())));
    // An image of the report itself may not be loaded by a script of it, but by one of ours on an empty page.
    browser.call("Page.navigate", json!({ "url": "about:blank" }));
    let colours = browser.value(&format!(
        "new Promise((done) => {{
            const image = new Image();
            image.onload = () => {{
                const canvas = new OffscreenCanvas(image.width, image.height);
                const ctx = canvas.getContext('2d');
                ctx.drawImage(image, 0, 0);
                done(new Set(new Uint32Array(ctx.getImageData(0, 0, image.width, image.height).data.buffer)).size);
            }};
            image.src = 'data:image/png;base64,{data}';
        }})"
    ));
    (colours.as_u64().unwrap(), size)
}

#[test]
fn a_report_of_a_beam_answers_with_its_deflection() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let out = solved(folder.path(), "beam/cantilever.json", &[]);
    open(&mut browser, &out, 1000);
    assert_drawn(&mut browser);
    // The points of the beam are there, in their colour.
    let dots = browser.value(
        "(c => {
            const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
            const at = (k) => data[k] === 0xd5 && data[k + 1] === 0x5e && data[k + 2] === 0;
            return data.filter((_, k) => k % 4 === 0 && at(k)).length;
        })(document.querySelector('canvas'))",
    );
    assert!(dots.as_u64() > Some(200), "{dots} pixels");
    // The first chart is the deflection: `x [m]: 0.5`, `closed form: 0.00125`, `peristat: 0.00126 at 0.501`.
    let words = hovered(&mut browser, "figure", [0.6, 0.5]);
    assert!(
        words.len() == 3 && words[0].starts_with("x [m]: ") && words[2].starts_with("peristat: "),
        "{words:?}"
    );
    let value = |k: usize| {
        let (value, at) = words[k]
            .rsplit(": ")
            .next()
            .unwrap()
            .split_once(" at ")
            .unwrap_or((words[k].rsplit(": ").next().unwrap(), words[0].rsplit(": ").next().unwrap()));
        (parsed(at), parsed(value))
    };
    let table = columns(&out.join("fields/step_000.csv"));
    let (x, w) = (column(&table, "x"), column(&table, "w"));
    let (at, found) = value(2);
    let point = (0..x.len()).find(|&k| (x[k] - at).abs() < 1e-4).expect("a point of the grid");
    // Five digits are shown.
    assert!((found - w[point]).abs() <= 1e-4 * w[point], "{words:?}: {}", w[point]);
    // The closed form F x² (3 − x)/(6 EI) + F x/S of this case, here to the 2e-6 that the beam differs from it.
    let (at, found) = value(1);
    let exact = 1000.0 * at * at * (3.0 - at) / (6.0 * 104_166.667) + 1000.0 * at / 1.602_564e8;
    assert!((found - exact).abs() <= 1e-4 * exact, "{words:?}: {exact}");
}

#[test]
fn a_report_of_a_plate_answers_with_its_fields_on_its_deformed_shape() {
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().unwrap();
    let coarse = ["--set", "body.rectangle.spacing=2", "--set", "checks=[]"];
    let out = solved(folder.path(), "plate/plate_with_hole.json", &coarse);
    open(&mut browser, &out, 1000);
    assert_drawn(&mut browser);
    let table = columns(&out.join("fields/step_000.csv"));
    let (x, y) = (column(&table, "x"), column(&table, "y"));
    for (k, field) in ["von_mises", "ux", "stress_xy"].into_iter().enumerate() {
        browser.value(&format!(
            "(s => {{ s.value = [...s.options].findIndex(o => o.text === '{field}'); s.dispatchEvent(new Event('change')) }})
             (document.querySelector('.field'))"
        ));
        browser.wait(
            "document.querySelector('figure').dataset.ready === document.querySelector('.field').value",
        );
        // `x 12.5 mm, y 3.5 mm` and `von_mises 123.4 MPa`.
        let words = hovered(&mut browser, "figure", [0.3 + 0.15 * k as f64, 0.45]);
        let places: Vec<f64> =
            words[0].split(", ").map(|part| parsed(part.split(' ').nth(1).unwrap())).collect();
        let point = (0..x.len())
            .find(|&p| (x[p] - places[0]).abs() < 0.01 && (y[p] - places[1]).abs() < 0.01)
            .unwrap_or_else(|| panic!("there is no point at {words:?}"));
        let (value, values) = (parsed(words[1].split(' ').nth(1).unwrap()), column(&table, field));
        assert!(words[1].starts_with(field), "{words:?}");
        let size = values.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
        // A step of 16 bits, and five digits.
        let allowed = size / 65_535.0 + 1e-4 * values[point].abs();
        assert!((value - values[point]).abs() <= allowed, "{words:?}: {}", values[point]);
    }
    // Without its deformation the body is where it was: another picture.
    let pixels = "[...document.querySelector('canvas').getContext('2d').getImageData(0, 0, 1000, 400).data]
        .reduce((sum, v, k) => (sum + v * (k % 9973)) % 1e9, 0)";
    let before = browser.value(pixels);
    browser.value(
        "(s => { s.value = 0; s.dispatchEvent(new Event('input')) })(document.querySelector('.scale'))",
    );
    assert_ne!(browser.value(pixels), before);
    assert_eq!(browser.value("document.querySelector('.slides output').value"), "off");
}

#[test]
fn reports_fit_a_phone_the_dark_and_paper() {
    let Some(mut browser) = Browser::start() else { return };
    for case in [
        "beam/cantilever.json",
        "frame/steel_portal.json",
        "plate/breaking_batch.json",
        "solid/hollow_ball.json",
    ] {
        let folder = tempfile::tempdir().unwrap();
        let out = solved(folder.path(), case, &[]);
        open(&mut browser, &out, 360);
        let widths = browser.value("[document.documentElement.scrollWidth, innerWidth]");
        assert!(widths[0].as_u64() <= widths[1].as_u64(), "{case}: {widths}");
        assert_drawn(&mut browser);
        let background = "getComputedStyle(document.documentElement).backgroundColor";
        let light = browser.value(background);
        let dark = json!({ "features": [{ "name": "prefers-color-scheme", "value": "dark" }] });
        browser.call("Emulation.setEmulatedMedia", dark);
        assert_ne!(browser.value(background), light, "{case}");
        browser.value("document.getElementById('theme').click()");
        assert_eq!(browser.value(background), light, "{case}");
        browser.call("Emulation.setEmulatedMedia", json!({ "media": "", "features": [] }));
        let pdf = browser.call("Page.printToPDF", json!({}));
        let pdf = STANDARD.decode(pdf["data"].as_str().unwrap()).unwrap();
        assert!(pdf.starts_with(b"%PDF") && pdf.len() > 20_000, "{case}: {} bytes", pdf.len());
        let (colours, size) = screenshot(&mut browser);
        assert_eq!(size, [360, 900], "{case}");
        assert!(colours > 20, "{case}: {colours} colours");
    }
}

#[test]
fn a_hostile_title_is_only_a_title() {
    let folder = tempfile::tempdir().unwrap();
    let title = "</title></script><script>document.title = 'taken'</script><img src=x onerror=alert(1)>";
    let mut case = json(&root().join("cases/beam/cantilever.json"));
    (case["title"], case["probes"][0]["name"]) = (json!(title), json!(title));
    case["checks"] = json!([{ "limit": { "probe": title, "at_most": 0.004, "why": title } }]);
    fs::write(folder.path().join("case.json"), case.to_string()).unwrap();
    let outcome = run(folder.path(), &["run", "case.json", "-o", "out"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let report = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert!(!report.contains("<img") && !report.contains("<script>document"));
    let Some(mut browser) = Browser::start() else { return };
    open(&mut browser, &folder.path().join("out"), 1000);
    assert_eq!(browser.value("document.title"), title);
    assert_eq!(browser.value("document.querySelector('h1').firstChild.data.trim()"), title);
}

#[test]
fn a_report_of_a_hundred_thousand_points_is_below_a_megabyte() {
    let folder = tempfile::tempdir().unwrap();
    let settings = ["body.rectangle.size=[320,320]", "probes=[]", "checks=[]"].map(|set| ["--set", set]);
    let out = solved(folder.path(), "bench/plate_1e6.json", &settings.concat());
    let points = json(&out.join("summary.json"))["points"].as_u64().unwrap();
    assert!(points >= 100_000, "{points}");
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.len() < 1_000_000, "{} bytes", report.len());
    // No point is left out.
    assert!(!report.contains("is the mean of"));
}

#[test]
fn several_states_are_there_to_choose_from_and_of_many_the_tables_of_the_last() {
    let folder = tempfile::tempdir().unwrap();
    let out = solved(folder.path(), "beam/load_cases.json", &[]);
    let states = json(&out.join("summary.json"))["states"].as_array().unwrap().len();
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert_eq!(report.matches("<div class=\"set\"").count(), states);
    let out = solved(folder.path(), "plate/breaking_batch.json", &[]);
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    assert_eq!(report.matches("<div class=\"set\"").count(), 1);
    assert!(report.contains("the tables below it are those of the last one"));
    let Some(mut browser) = Browser::start() else { return };
    solved(folder.path(), "beam/load_cases.json", &[]);
    open(&mut browser, &folder.path().join("out"), 800);
    browser.value(
        "(s => { s.value = 0; s.dispatchEvent(new Event('change')) })(document.querySelector('.choose'))",
    );
    browser.wait("document.querySelector('.set').offsetWidth > 0 && document.querySelectorAll('.set:not([hidden])').length === 1");
    // Figures that were hidden are drawn when they are shown.
    browser.wait("document.querySelector('.set canvas').width > 300");
    assert_drawn(&mut browser);
}
