//! A series of [`super::vtu`] files over time, as a ParaView collection.

use std::io;
use std::path::Path;

use super::{atomic, xml};

/// Writes a collection of pairs of a time and a file, relative to the folder of `path`.
///
/// # Errors
/// What the file system reports.
pub fn write(path: &Path, steps: &[(f64, &str)]) -> io::Result<()> {
    atomic::replace(path, |out| {
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        writeln!(out, "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">")?;
        writeln!(out, "  <Collection>")?;
        for (time, file) in steps {
            // A collection is read on other systems than the one that wrote it.
            let file = xml(&file.replace('\\', "/"));
            writeln!(out, "    <DataSet timestep=\"{time:?}\" part=\"0\" file=\"{file}\"/>")?;
        }
        writeln!(out, "  </Collection>\n</VTKFile>")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_has_its_time_and_its_escaped_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.pvd");
        write(&path, &[(0.0, "fields/step_0.vtu"), (1e-7, "a&b\\1.vtu")]).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let steps: Vec<_> = text.lines().filter(|line| line.contains("DataSet")).map(str::trim).collect();
        assert_eq!(
            steps,
            [
                "<DataSet timestep=\"0.0\" part=\"0\" file=\"fields/step_0.vtu\"/>",
                "<DataSet timestep=\"1e-7\" part=\"0\" file=\"a&amp;b/1.vtu\"/>",
            ]
        );
        assert!(text.ends_with("</VTKFile>\n"));
    }
}
