//! What the fuzzer does with bytes; its targets in `fuzz` include this file.

use peristat::case;
use peristat::diagnostic::decode;
use peristat::input::{gmsh, points};
use peristat::scene::Scene;
use std::path::Path;

/// Memory that a scene may need, bytes: what is larger is refused, so that an input takes little time.
const MEMORY: u64 = 300_000;

/// Whether bytes are a case that could be solved.
pub(crate) fn resolves(bytes: Vec<u8>) -> bool {
    let source = decode("case", bytes).and_then(|text| case::from_text("case", text, &[]));
    let scene = source.and_then(|s| Scene::new(s.case, Path::new("nowhere"), "case", &s.text, Some(MEMORY)));
    scene.map_err(|report| report.render(false)).is_ok()
}

/// Whether bytes are a mesh or a list of points.
pub(crate) fn reads(bytes: &[u8]) -> bool {
    let cloud = points::read(bytes).and_then(|points| points.cloud(1.0));
    gmsh::read(bytes).is_ok() || cloud.is_ok()
}
