//! Pictures in the formats that a case asks for.

use super::support::{gallery, json, names, root, run};
use peristat::model::TABLE;
use resvg::tiny_skia::Pixmap;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// One case of the gallery per model, and those whose pictures are of other kinds: frames, listed points.
const DRAWN: [&str; 12] = [
    "beam/cantilever",
    "frame/portal",
    "plate/shear",
    "plate/scattered_points",
    "plate/state_tension",
    "orthotropic/off_axis_tension",
    "antiplane/uniform_shear",
    "shell/open_panel",
    "bending/strip",
    "axisymmetric/solid_bar",
    "solid/bent_bar",
    "solid/all_around",
];

const FORMATS: &str = r#"drawing.formats=["png","pdf"]"#;

fn pictures(folder: &Path, ending: &str) -> Vec<String> {
    let all = names(&folder.join("plots")).into_iter();
    all.filter_map(|name| name.strip_suffix(ending).map(String::from)).collect()
}

/// Width and height that follow a mark in the bytes of a file, `between` them.
fn size(bytes: &[u8], mark: &str, between: &str) -> [f64; 2] {
    let text = String::from_utf8_lossy(bytes);
    let (_, after) = text.split_once(mark).expect("the size is written");
    let (width, after) = after.split_once(between).expect("there are two numbers");
    let height: String = after.chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    [width, &height].map(|number| number.parse().expect("a number"))
}

/// Asserts that a PNG has two pixels for each of its SVG's, and ink over most of it, not in a line of its title alone.
fn assert_drawn(file: &Path, svg: [f64; 2]) {
    let picture = Pixmap::load_png(file).expect("a PNG");
    let size = [picture.width(), picture.height()].map(f64::from);
    assert!((0..2).all(|k| (size[k] - 2.0 * svg[k]).abs() <= 1.0), "{}: {size:?} of {svg:?}", file.display());
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    let mut colors = BTreeSet::new();
    for (k, pixel) in (0..).zip(picture.pixels()) {
        let rgb = [pixel.red(), pixel.green(), pixel.blue()];
        assert_eq!(pixel.alpha(), 255, "{}: the background is there", file.display());
        if rgb != [255; 3] {
            let at = [k % picture.width(), k / picture.width()].map(f64::from);
            (0..2).for_each(|c| (low[c], high[c]) = (low[c].min(at[c]), high[c].max(at[c])));
            colors.insert(rgb);
        }
    }
    // Most of the picture is drawn on, and smoothed edges alone have many colours.
    let part = [0, 1].map(|c| (high[c] - low[c]) / size[c]);
    assert!(
        part[0] > 0.5 && part[1] > 0.7 && colors.len() > 20,
        "{}: {part:?}, {}",
        file.display(),
        colors.len()
    );
}

/// Asserts that every SVG of a folder of results has its PNG and its PDF, which show as much.
fn assert_formats(out: &Path, what: &str) {
    let svg = pictures(out, ".svg");
    assert!(!svg.is_empty(), "{what}");
    assert_eq!((pictures(out, ".png"), pictures(out, ".pdf")), (svg.clone(), svg.clone()), "{what}");
    for name in &svg {
        let file = |ending: &str| out.join(format!("plots/{name}{ending}"));
        let read = |ending: &str| fs::read(file(ending)).unwrap();
        let own = size(&read(".svg"), "<svg width=\"", "\" height=\"");
        assert_drawn(&file(".png"), own);
        let page = size(&read(".pdf"), "/MediaBox [0 0 ", " ");
        assert!(read(".pdf").starts_with(b"%PDF"), "{what}: {name}");
        assert!(
            (page[0] * own[1] / (page[1] * own[0]) - 1.0).abs() < 1e-3,
            "{what}: {name}: {page:?} of {own:?}"
        );
    }
}

#[test]
fn every_model_draws_each_picture_in_all_formats() {
    let folder = tempfile::tempdir().unwrap();
    let mut models = BTreeSet::new();
    for case in DRAWN {
        let path = root().join(format!("cases/{case}.json"));
        models.extend(json(&path)["model"].as_object().unwrap().keys().cloned());
        let out = folder.path().join("out");
        let path = path.display().to_string();
        let arguments = ["run", &path, "-o", "out", "-q", "--fields", "none", "--force", "--set", FORMATS];
        let outcome = run(folder.path(), &arguments);
        assert_eq!(outcome.code, 0, "{case}: {}", outcome.stderr);
        assert_formats(&out, case);
    }
    let all: BTreeSet<String> = TABLE.iter().map(|model| model.name.into()).collect();
    assert_eq!(models, all);
}

#[test]
fn a_study_draws_each_diagram_in_all_formats() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(gallery("cantilever.json"), folder.path().join("cantilever.json")).unwrap();
    let study = r#"{ "title": "s", "case": "cantilever.json", "set": { "body.line.cells": 24 , "model.timoshenko_beam.bond_law": "published" },
                     "refine": { "delta_convergence": { "factors": [1, 2, 4] } } }"#;
    fs::write(folder.path().join("s.json"), study).unwrap();
    let outcome = run(folder.path(), &["study", "s.json", "-q", "--set", FORMATS]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_formats(&folder.path().join("results/s"), "study");
}

#[test]
fn formats_that_are_no_longer_asked_for_go() {
    let folder = tempfile::tempdir().unwrap();
    let run = |set: &str| {
        let path = gallery("cantilever.json");
        run(folder.path(), &["run", &path, "-o", "out", "-q", "--set", set]).code
    };
    let out = folder.path().join("out");
    assert_eq!(run(FORMATS), 0);
    let svg = pictures(&out, ".svg");
    assert_eq!(pictures(&out, ".pdf"), svg);
    assert_eq!(run(r#"drawing.formats=["png"]"#), 0);
    assert_eq!((pictures(&out, ".png"), pictures(&out, ".pdf")), (svg, vec![]));
}
