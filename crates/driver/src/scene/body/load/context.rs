//! What loads are resolved on.

use crate::input::gmsh::Curve;
use crate::model::Material;
use crate::scene::body::hold::supports::Held;
use crate::scene::body::site::boundary::Stretch;
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::recipe::Recipe;
use crate::scene::body::site::symmetry::Symmetry;
use peristat_assembly::model::plane::PlaneModel;

/// What the resolution of loads looks at.
pub(crate) struct LoadContext<'a> {
    pub(crate) ground: &'a Ground<'a>,
    pub(crate) symmetry: &'a Symmetry,
    pub(crate) curves: &'a [Curve],
    pub(crate) material: &'a dyn Material,
    pub(crate) horizon: f64,
    pub(crate) held: &'a [Held],
    /// Paths of cracks, images left out.
    pub(crate) cracks: &'a [crate::scene::body::site::cracks::NamedCrack],
    /// What numbers the points of the body in the model.
    pub(crate) recipe: &'a Recipe,
    /// The discretised body, if it can be made.
    pub(crate) model: Option<&'a dyn PlaneModel>,
}

impl LoadContext<'_> {
    /// Volume of a point of the body, m³.
    pub(crate) fn volume(&self, point: u32) -> f64 {
        let body = self.ground.body;
        body.area(point as usize) * self.material.across(body.position(point as usize))
    }

    /// Area of stretches of a border, m².
    pub(crate) fn area(&self, stretches: &[Stretch]) -> f64 {
        stretches.iter().flat_map(Stretch::samples).map(|s| s.length * self.material.across(s.at)).sum()
    }

    /// What the divergence of a stress along the axis of a body of revolution has beside that in the plane: `S_xy/x`, N/m³.
    pub(crate) fn around_axis(&self, [_, _, shear]: [f64; 3], [x, _]: [f64; 2]) -> f64 {
        if self.material.is_revolved() { shear / x } else { 0.0 }
    }
}

/// Whether supports prescribe a component of a point of the body.
pub(crate) fn is_held(point: u32, component: usize, held: &[Held]) -> bool {
    held.iter().any(|h| {
        let direct = h.motions.iter().any(|m| m.0[component].abs() == 1.0);
        direct && h.points.binary_search(&point).is_ok()
    })
}
