//! Bodies in space as files have them.

use peristat_assembly::body::Facet;

/// A surface of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// Its triangles.
    pub facets: Vec<Facet>,
    /// Names of its parts.
    pub names: Vec<String>,
}

/// A body in space.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidFile {
    /// The surface around it, with the names of its parts.
    pub surface: Triangles,
    /// Parts of the body that have names, by the surfaces around them.
    pub parts: Vec<(String, Vec<Facet>)>,
}

impl SolidFile {
    /// The same, as many times as large.
    pub fn scaled(mut self, scale: f64) -> Self {
        let parts = self.parts.iter_mut().flat_map(|part| &mut part.1);
        for corner in self.surface.facets.iter_mut().chain(parts).flat_map(|facet| &mut facet.corners) {
            *corner = corner.map(|x| scale * x);
        }
        self
    }
}
