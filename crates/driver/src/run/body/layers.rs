//! Boundary layers at holes in bodies with fibres.
//!
//! Stresses of a pull along x are functions of x + iβy with the roots of β⁴ − (E₁/G − 2ν) β² + E₁/E₂ = 0 (Lekhnitskii). In
//! the plane (x, βy) a hole of radius R is an ellipse whose tip has the radius R/β: with stiff fibres, where β² is nearly
//! E₁/G, the stress at its border falls within R/β², a layer far thinner than the hole. Where the horizon smears it out the
//! concentration comes out too low: of holes with E₁/E₂ of 4 and 14 a layer of 1/4, 1/2, 1 and 2 horizons leaves about 45, 60, 73
//! and 87 % of it. The local limit has it from fields around the hole; without these polynomials would stand for the layer.

use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::model::Fibres;
use crate::run::RunError;
use crate::scene::body::{BodyScene, HoleRing};
use peristat_assembly::body::Shape;
use std::f64::consts::PI;

/// Horizons that a layer should have at least; a warning comes below one.
const ADVISED: f64 = 2.0;
/// Spacings that a layer has that polynomials of the local limit see: as many as they are fitted over.
const SEEN: f64 = 3.0;
/// What acts across the fibres may be this many times what acts along them before the layer is that of another pull.
const ACROSS: f64 = 2.0;

/// A hole with a layer too thin for the horizon.
#[derive(Clone, Copy, Debug)]
struct Layer {
    /// Index of the hole.
    hole: usize,
    /// Axis of the material along which the pull must be, 0 or 1.
    axis: usize,
    /// Thickness, m.
    thickness: f64,
}

/// The layers of a scene that are too thin.
#[derive(Debug)]
pub(super) struct Layers(Vec<Layer>);

impl Layers {
    /// Finds those of a body; without fibres it has none, and in the local limit none that the rings around holes tell.
    pub(super) fn of(scene: &BodyScene, rings: &[HoleRing]) -> Self {
        Self(match scene.limit {
            Some(_) => untold(scene, rings, SEEN * scene.spacing()),
            None => thinner(scene, scene.horizon()),
        })
    }

    /// Adds a warning for every layer of a state that its pull makes, and forgets it.
    pub(super) fn check(&mut self, scene: &BodyScene, u: &[f64], warnings: &mut Faults) {
        let Some(fibres) = scene.material().fibres().filter(|_| !self.0.is_empty()) else { return };
        let pull = pull(scene, &fibres, u);
        let acts =
            |layer: &Layer| ACROSS * pull[layer.axis] >= pull[1 - layer.axis] && pull[layer.axis] > 0.0;
        let (told, left) = self.0.iter().partition(|layer| acts(layer));
        self.0 = left;
        told.iter().for_each(|layer| tell(scene, layer, warnings));
    }
}

/// The layers of a body that are thinner than a length, m.
fn thinner(scene: &BodyScene, length: f64) -> Vec<Layer> {
    let (Some(fibres), Some(outline)) = (scene.material().fibres(), scene.outline()) else {
        return Vec::new();
    };
    let squares = squared_roots(&fibres);
    let radii = outline.holes().iter().enumerate().map(|(k, hole)| match &hole.shape {
        Shape::Circle { radius, .. } | Shape::Slot { radius, .. } => (k, *radius),
        // Where it is sharpest.
        Shape::Ellipse { half_axes: [a, b], .. } => (k, a.min(*b).powi(2) / a.max(*b)),
        // As round as a circle of its area, or sharper.
        Shape::Polygon(polygon) => (k, (polygon.area().abs() / PI).sqrt()),
    });
    let layers = radii.flat_map(|(hole, radius)| {
        [0, 1].map(|axis| Layer { hole, axis, thickness: radius / squares[axis] })
    });
    layers.filter(|layer| layer.thickness < length).collect()
}

/// The same without those that rings around holes tell.
fn untold(scene: &BodyScene, rings: &[HoleRing], length: f64) -> Vec<Layer> {
    let is_told = |layer: &Layer| rings.iter().any(|ring| ring.tells_layer(layer.hole));
    thinner(scene, length).into_iter().filter(|layer| !is_told(layer)).collect()
}

/// Looks for probes beside holes with layers that nothing of the local limit sees.
///
/// # Errors
/// A layer thinner than a spacing, at a hole with too few points around it for fields of its own.
pub(super) fn check_seen(scene: &BodyScene, rings: &[HoleRing]) -> Result<(), RunError> {
    let Some(outline) = scene.outline() else { return Ok(()) };
    let places = || scene.probes.iter().filter_map(|probe| probe.position);
    let is_asked = |layer: &Layer| {
        let shape = &outline.holes()[layer.hole].shape;
        places().any(|[x, y, _]| shape.distance([x, y]) < SEEN * scene.spacing())
    };
    let layers = untold(scene, rings, scene.spacing());
    let Some(layer) = layers.iter().find(|layer| is_asked(layer)) else { return Ok(()) };
    let (hole, pull, thickness) = words(scene, layer);
    let mut faults = Faults::default();
    faults
        .error(
            root("limit"),
            format!("`local` does not see the stress at {hole}: under a pull along {pull} it falls within {thickness} of the border, and there are too few points for fields around the hole"),
        )
        .hint("use a smaller spacing; round and elliptic holes have such fields where nothing is nearer than a fifth of the radius and the horizon");
    Err(RunError::Case(faults))
}

/// The larger β² of a pull along either axis of the material; the magnitude of complex ones.
fn squared_roots(fibres: &Fibres) -> [f64; 2] {
    let &Fibres { youngs_moduli: [e1, e2], poisson_ratio: nu, shear_modulus: g, .. } = fibres;
    [[e1, e2, nu], [e2, e1, nu * e2 / e1]].map(|[along, across, nu]| {
        let (half, product) = (0.5 * along / g - nu, along / across);
        let under = half * half - product;
        if under > 0.0 && half > 0.0 { half + under.sqrt() } else { product.sqrt() }
    })
}

/// Integrals of the magnitudes of the normal stresses along the two axes of the material.
fn pull(scene: &BodyScene, fibres: &Fibres, u: &[f64]) -> [f64; 2] {
    let stress = scene.model.recover(u).stress;
    let [xx, yy, xy] = &stress[..] else { return [0.0; 2] };
    let mut pull = [0.0; 2];
    for p in scene.real_points() {
        let own = scene.material_of(p).and_then(|material| material.fibre_angle);
        let (s, c) = own.map_or(fibres.angle, f64::to_radians).sin_cos();
        let shear = 2.0 * s * c * xy[p];
        let along = c * c * xx[p] + s * s * yy[p] + shear;
        let across = s * s * xx[p] + c * c * yy[p] - shear;
        let volume = scene.model.volume(p);
        pull[0] += volume * along.abs();
        pull[1] += volume * across.abs();
    }
    pull
}

/// The hole, the direction of the pull and the thickness of a layer.
fn words(scene: &BodyScene, layer: &Layer) -> (String, &'static str, String) {
    let hole = scene.outline().and_then(|o| o.holes()[layer.hole].name.as_deref());
    let hole = hole.map_or("a hole".to_string(), |name| format!("the hole `{name}`"));
    (hole, ["the fibres", "the direction across the fibres"][layer.axis], rounded(layer.thickness))
}

fn rounded(length: f64) -> String {
    tidy(format!("{length:.1e}").parse().unwrap_or(length))
}

fn tell(scene: &BodyScene, layer: &Layer, warnings: &mut Faults) {
    let (hole, pull, thickness) = words(scene, layer);
    let path = JsonPath::default().key("body");
    if scene.limit.is_some() {
        let text = format!(
            "under a pull along {pull} the stress at {hole} falls within {thickness} of its border, and the spacing is {}: without fields around the hole it is off, by 1 and 3 % where it falls within two spacings and one, by any amount within less",
            tidy(scene.spacing())
        );
        warnings.warning(path, text).hint("use a smaller spacing");
        return;
    }
    let horizon = tidy(scene.horizon());
    let spacing = rounded(layer.thickness / ADVISED * scene.spacing() / scene.horizon());
    warnings
        .warning(
            path,
            format!(
                "under a pull along {pull} the stress at {hole} falls within {thickness} of its border, and the horizon is {horizon}: at points its concentration comes out far too low"
            ),
        )
        .hint(format!("a spacing of {spacing} makes this layer {ADVISED} horizons thick, and leaves an error of some 13 %"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_those_of_lekhnitskii() {
        let of = |e1: f64, nu: f64, g: f64| {
            squared_roots(&Fibres {
                youngs_moduli: [e1, 1.0],
                poisson_ratio: nu,
                shear_modulus: g,
                angle: 0.0,
            })
        };
        // All directions alike: β = 1.
        of(1.0, 0.3, 1.0 / 2.6).iter().for_each(|b| assert!((b - 1.0).abs() < 1e-7, "{b}"));
        // β⁴ − 27.4 β² + 14 = 0; across, x⁴ − (2 − 0.6/14) x² + 1/14 = 0.
        let [along, across] = of(14.0, 0.3, 0.5);
        assert!((along * along - 27.4 * along + 14.0).abs() < 1e-12 && along > 13.7);
        assert!((across * across - (2.0 - 0.6 / 14.0) * across + 1.0 / 14.0).abs() < 1e-14);
        // Complex roots: of modulus √(E1/E2).
        assert!((of(14.0, 0.3, 2.0)[0] - 14.0_f64.sqrt()).abs() < 1e-14);
    }
}
