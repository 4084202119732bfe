//! Tables as comma-separated values (RFC 4180, with line feeds).

use rayon::prelude::*;
use std::io;
use std::ops::Range;
use std::path::Path;

use super::atomic::replace;

/// Rows of a block that becomes text at once, and blocks that do so side by side.
const BLOCK: usize = 2048;
const AT_ONCE: usize = 16;

/// Writes columns of equal length below their headers.
///
/// Numbers are the shortest that read back to the same bits: `0.1`, `1e-7`, `NaN`, `inf`.
///
/// # Errors
/// What the file system reports.
///
/// # Panics
/// If the columns differ in length.
pub fn write(path: &Path, columns: &[(&str, &[f64])]) -> io::Result<()> {
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    for (header, values) in columns {
        assert_eq!(values.len(), rows, "column {header} has another length than the first");
    }
    replace(path, |file| {
        let headers: Vec<_> = columns.iter().map(|(header, _)| quoted(header)).collect();
        writeln!(file, "{}", headers.join(","))?;
        // Blocks become text at once, some at a time, so that the text never takes as much memory as the numbers.
        let blocks: Vec<usize> = (0..rows).step_by(BLOCK).collect();
        for blocks in blocks.chunks(AT_ONCE) {
            let texts: Vec<String> =
                blocks.par_iter().map(|&from| text(columns, from..rows.min(from + BLOCK))).collect();
            texts.iter().try_for_each(|text| file.write_all(text.as_bytes()))?;
        }
        Ok(())
    })
}

/// Writes rows of texts below their headers.
///
/// # Errors
/// What the file system reports.
pub fn write_rows(path: &Path, headers: &[&str], rows: &[Vec<String>]) -> io::Result<()> {
    let line = |cells: &mut dyn Iterator<Item = &str>| cells.map(quoted).collect::<Vec<_>>().join(",") + "\n";
    let mut text = line(&mut headers.iter().copied());
    rows.iter().for_each(|row| text += &line(&mut row.iter().map(String::as_str)));
    super::atomic::write_atomically(path, text.as_bytes())
}

/// The head of a column: its name, and its unit behind it, such as `uy [mm]`.
pub fn head(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.into() } else { format!("{name} [{unit}]") }
}

/// Rows as text.
fn text(columns: &[(&str, &[f64])], rows: Range<usize>) -> String {
    let mut text = String::with_capacity(rows.len() * columns.len() * 20);
    let mut digits = zmij::Buffer::new();
    for row in rows {
        for (position, (_, values)) in columns.iter().enumerate() {
            text.push_str(if position == 0 { "" } else { "," });
            text.push_str(digits.format(values[row]));
        }
        text.push('\n');
    }
    text
}

fn quoted(header: &str) -> String {
    if header.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", header.replace('"', "\"\""))
    } else {
        header.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(columns: &[(&str, &[f64])]) -> String {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        write(&path, columns).unwrap();
        std::fs::read_to_string(path).unwrap()
    }

    #[test]
    fn every_number_reads_back_to_the_same_bits() {
        let values = [0.1, -0.0, 1.0 / 3.0, 5e-324, f64::MAX, 1e-7, 123456789.0, f64::NAN, -f64::INFINITY];
        let text = written(&[("x", &values)]);
        let found: Vec<f64> = text.lines().skip(1).map(|line| line.parse().unwrap()).collect();
        assert_eq!(found.len(), values.len());
        for (found, expected) in found.iter().zip(values) {
            assert_eq!(found.to_bits(), expected.to_bits(), "{expected:?}");
        }
        assert!(text.lines().all(|line| line.len() < 25), "no number is written out in zeros\n{text}");
    }

    #[test]
    fn headers_are_quoted_where_they_must_be() {
        let text = written(&[("x", &[1.0]), ("w, tip", &[2.0]), ("a \"b\"", &[3.0])]);
        assert_eq!(text, "x,\"w, tip\",\"a \"\"b\"\"\"\n1.0,2.0,3.0\n");
    }

    #[test]
    #[should_panic(expected = "column b has another length")]
    fn columns_of_different_length_are_a_broken_contract() {
        written(&[("a", &[1.0]), ("b", &[])]);
    }
}
