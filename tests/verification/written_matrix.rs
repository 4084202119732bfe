//! Rows of the written stiffness over the volume of a point are Eq. (12), term by term.

use crate::support::standard::{SECTIONS, Standard};
use peristat::Loaded;
use peristat::results::stiffness;
use std::collections::HashMap;
use std::fs;

/// Order and entries of a symmetric Matrix Market file, both triangles.
fn read(text: &str) -> (usize, HashMap<(usize, usize), f64>) {
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("%%MatrixMarket matrix coordinate real symmetric"));
    let mut lines = lines.filter(|l| !l.starts_with('%'));
    let sizes: Vec<usize> = lines
        .next()
        .expect("a line of sizes")
        .split_whitespace()
        .map(|v| v.parse().expect("a size"))
        .collect();
    assert_eq!(sizes[0], sizes[1], "square");
    let mut entries = HashMap::new();
    let mut count = 0;
    for line in lines {
        let mut words = line.split_whitespace();
        let mut index = || words.next().expect("an index").parse::<usize>().expect("a number") - 1;
        let (i, j) = (index(), index());
        let value: f64 = words.next().expect("a value").parse().expect("a number");
        assert!(i >= j, "only the lower triangle of a symmetric matrix is stored");
        entries.insert((i, j), value);
        entries.insert((j, i), value);
        count += 1;
    }
    assert_eq!(count, sizes[2], "as many entries as the header says");
    (sizes[0], entries)
}

#[test]
fn rows_of_the_written_matrix_are_equation_12_term_by_term() {
    let (section, cells, m) = (SECTIONS[1], 20_usize, 3_usize);
    let case = Standard::named("cantilever under a tip force").case(&section, "published", cells);
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    fs::write(at("case.json"), case.to_string()).expect("written");
    let loaded = Loaded::read(&at("case.json"), &[], None).expect("a case");
    stiffness::write(&loaded, &at("K.mtx")).expect("written");
    let (order, k) = read(&fs::read_to_string(at("K.mtx")).expect("written"));
    assert_eq!(order, 2 * (cells + 1));

    let ((bending, shear), area) = (section.stiffness(), 0.05 * section.height);
    let h = 1.0 / cells as f64;
    let (delta, volume) = (m as f64 * h, area * h);
    let c_b = 2.0 * bending / (delta * delta * area * area);
    let c_s = 2.0 * (shear / area) / (delta * delta * area);
    let mut checked = 0;
    for p in m..=cells - m {
        // Coefficients of (w_j, φ_j) in minus (12b) and minus (12a) at point p.
        let mut force = HashMap::new();
        let mut moment = HashMap::new();
        let mut add = |j: usize, wf: f64, pf: f64, wm: f64, pm: f64| {
            *force.entry(2 * j).or_insert(0.0) += wf;
            *force.entry(2 * j + 1).or_insert(0.0) += pf;
            *moment.entry(2 * j).or_insert(0.0) += wm;
            *moment.entry(2 * j + 1).or_insert(0.0) += pm;
        };
        for n in 1..=m {
            let v = volume * if n == m { 0.5 } else { 1.0 };
            let xi = n as f64 * h;
            for (j, s) in [(p + n, 1.0), (p - n, -1.0)] {
                add(
                    j,
                    -c_s / xi * v,
                    0.5 * c_s * s * v,
                    -0.5 * c_s * s * v,
                    (-c_b / xi + 0.25 * c_s * xi) * v,
                );
                add(p, c_s / xi * v, 0.5 * c_s * s * v, 0.5 * c_s * s * v, (c_b / xi + 0.25 * c_s * xi) * v);
            }
        }
        for (row, expected) in [(2 * p, force), (2 * p + 1, moment)] {
            let scale = expected.values().fold(0.0_f64, |a, v| a.max(v.abs()));
            for column in 0..order {
                let found = k.get(&(row, column)).copied().unwrap_or(0.0) / volume;
                let expected = expected.get(&column).copied().unwrap_or(0.0);
                // Measured 4e-16 of the largest coefficient of the row.
                let difference = (found - expected).abs() / scale;
                assert!(difference <= 1e-14, "row {row}, column {column}: {found} for {expected}");
                checked += 1;
            }
        }
    }
    assert_eq!(checked, 2 * (cells + 1 - 2 * m) * order, "all interior rows");
}
