//! What the fuzzer does with bytes; its targets in `fuzz` include this file.

use peristat::case;
use peristat::diagnostic::decode;
use peristat::input::Folder;
use peristat::input::{drawing, gmsh, points, solid};
use peristat::scene::Scene;
use peristat_assembly::body::Surface;
use std::path::Path;

/// Memory that a scene may need, bytes: what is larger is refused, so that an input takes little time.
const MEMORY: u64 = 300_000;

/// Whether bytes are a case that could be solved.
pub(crate) fn resolves(bytes: Vec<u8>) -> bool {
    let source =
        decode("case", bytes).and_then(|text| case::from_text("case", text, &[], &Folder::default()));
    let scene = source.and_then(|s| Scene::new(s.case, Path::new("nowhere"), "case", &s.text, Some(MEMORY)));
    scene.map_err(|report| report.render(false)).is_ok()
}

/// Whether bytes are a mesh, a drawing or a list of points.
pub(crate) fn reads(bytes: &[u8]) -> bool {
    if drawing::read(bytes, 0.01).is_ok() {
        return true;
    }
    let cloud = |axes: usize| points::read(bytes, axes).and_then(|points| points.cloud(1.0));
    gmsh::read(bytes).is_ok() || cloud(2).is_ok() || cloud(3).is_ok()
}

/// Whether bytes are a solid that cells fill; every side of a cell on its border is then in one wall.
pub(crate) fn fills(bytes: &[u8]) -> bool {
    let Ok(file) = solid::read(bytes) else { return false };
    let Ok(surface) = Surface::new(file.surface.facets, file.surface.names) else { return false };
    let [low, high] = surface.bounds();
    let largest = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let Ok(grid) = surface.grid(largest / 9.0) else { return false };
    let filled = surface.fill(&grid);
    let walls = surface.walls(&grid, &filled.lattice);
    let areas = walls.iter().flat_map(|wall| wall.areas(&filled.lattice));
    assert!(areas.map(|part| part.area).all(f64::is_finite), "an area that is no number");
    filled.lattice.points() > 0
}
