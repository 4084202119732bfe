//! The pictures of a folder in the formats that a case asks for.

use crate::case::PictureFormat;
use crate::output::atomic::write_atomically;
use crate::output::plot::{pdf, png};
use std::fs;
use std::io;
use std::path::Path;

/// Writes every SVG file of a folder in some other formats, too; a body without pictures has no such folder.
///
/// # Errors
/// The folder cannot be read or written.
pub(crate) fn write_formats(plots: &Path, formats: &[PictureFormat]) -> io::Result<()> {
    if formats.is_empty() || !plots.is_dir() {
        return Ok(());
    }
    for entry in fs::read_dir(plots)? {
        let path = entry?.path();
        if path.extension().is_none_or(|ending| ending != "svg") {
            continue;
        }
        let svg = fs::read_to_string(&path)?;
        for format in formats {
            let bytes = match format {
                PictureFormat::Png => png(&svg)?,
                PictureFormat::Pdf => pdf(&svg)?,
            };
            write_atomically(&path.with_extension(format.extension()), &bytes)?;
        }
    }
    Ok(())
}

/// Whether a picture has such a name.
pub(crate) fn is_picture(name: &str) -> bool {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending);
    ending == Some("svg") || PictureFormat::ALL.iter().any(|format| ending == Some(format.extension()))
}
