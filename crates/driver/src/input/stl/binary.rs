//! Binary STL: 80 bytes of anything, the number of triangles, and 50 bytes for each.

use super::super::ReadError;
use super::super::surface::Triangles;
use peristat_assembly::body::Facet;

/// Bytes before the triangles.
const HEADER: usize = 84;
/// Bytes of a triangle: its normal, its corners, and two more.
const TRIANGLE: usize = 50;

/// The number of triangles that a file says; none if it is too short to say one.
pub(super) fn count(bytes: &[u8]) -> Option<u32> {
    let count = bytes.get(HEADER - 4..HEADER)?;
    Some(u32::from_le_bytes(count.try_into().ok()?))
}

/// Length of a file of so many triangles.
pub(super) fn length(count: u32) -> u64 {
    HEADER as u64 + u64::from(count) * TRIANGLE as u64
}

/// The triangles of a file of the right length.
pub(super) fn triangles(bytes: &[u8]) -> Triangles {
    let each = bytes[HEADER..].chunks_exact(TRIANGLE);
    let facet = |bytes: &[u8]| {
        let number = |k: usize| {
            let at = 12 + 4 * k;
            decimal(f32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]))
        };
        let corner = |c: usize| [0, 1, 2].map(|k| number(3 * c + k));
        Facet { corners: [0, 1, 2].map(corner), name: None }
    };
    Triangles { facets: each.map(facet).collect(), names: Vec::new() }
}

/// The shortest number that single precision rounds to this one: 0.1 is 0.1, as whoever drew the body wrote it.
fn decimal(x: f32) -> f64 {
    x.to_string().parse().unwrap_or(f64::NAN)
}

/// Why a file is none.
pub(super) fn refused(bytes: &[u8], count: Option<u32>) -> ReadError {
    const FORMATS: &str = "export the part as STL, binary or ASCII, or mesh it by Gmsh";
    let Some(count) = count else {
        return ReadError::whole(format!("is no STL file: {} bytes are too few", bytes.len())).hint(FORMATS);
    };
    if bytes.is_ascii() && super::is_printed(bytes) {
        return ReadError::whole("is neither an STL file nor a mesh of Gmsh: it begins with other text")
            .hint(FORMATS);
    }
    let found = (bytes.len() - HEADER) as f64 / TRIANGLE as f64;
    let message =
        format!("says that it has {count} triangles, and has bytes for {}", (10.0 * found).round() / 10.0);
    ReadError::whole(message).hint(match found < f64::from(count) {
        true => "the file is cut off: export or copy it again",
        false => "its number of triangles is wrong, or something stands behind the last one: export it again",
    })
}
