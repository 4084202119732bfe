//! A body with its bonds, whatever its dimension and its material.

use super::Points;
use super::plane::{BorderShares, Edges, Mirrors, PlaneModel};
use super::solid::{SolidModel, TENSOR};
use crate::body::SquareLattice;
use std::fmt::Debug;
use std::sync::Arc;

/// Fields of a state; images have zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyFields {
    /// Stresses, Pa, of every point, in the order of [`BodyModel::tensor_components`]; further planes are zero.
    pub stress: Vec<Vec<f64>>,
    /// Strain energy density, J/m³, of every point.
    pub energy_density: Vec<f64>,
    /// Stress across a section, Pa, of every point; empty where it follows from the others, or is one of them.
    pub across: Vec<f64>,
}

/// A body with its bonds.
pub trait BodyModel: Points + Debug + Send + Sync {
    /// Position of a point along x and y, m: all of it in the plane.
    fn place(&self, point: usize) -> [f64; 2] {
        let [x, y, _] = self.position(point);
        [x, y]
    }

    /// Volume of a point, m³; an image has none.
    fn volume(&self, point: usize) -> f64;

    /// The lattice, images included, and its mirrors; none of a cloud.
    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)>;

    /// Numbers of the points that are images, in order.
    fn ghosts(&self) -> &[u32];

    /// Which components of strain and stress the numbers of its fields are, as far as there are any.
    fn tensor_components(&self) -> &'static [&'static str] {
        &["xx", "yy", "xy"]
    }

    /// What is done about the bonds that points near edges lack; families have another treatment.
    fn edges(&self) -> Option<Edges> {
        None
    }

    /// Whether a border that cuts cells is completed as it runs, by the triangles that it cuts.
    fn follows_border(&self) -> bool {
        let is_cut = self.lattice().is_some_and(|(lattice, _)| !lattice.blocks().is_empty());
        is_cut && self.edges() == Some(Edges::Border)
    }

    /// How places on the border move, where bonds end on it.
    fn border_shares(&self) -> Option<BorderShares<'_>> {
        None
    }

    /// Number of triangles or tetrahedra that complete points.
    fn triangles(&self) -> usize;

    /// Number of elements that complete edges: triangles, or bonds that end on the border.
    fn completing(&self) -> usize {
        self.triangles()
    }

    /// Number of points that lack bonds for which the overlay found no triangle: they are too soft. Points by themselves
    /// or in a single straight row are such, and points whose triangles all are crossed by cracks.
    fn uncorrected(&self) -> usize;

    /// Cut share of the family volume of every point, 0 to 1.
    fn damage(&self) -> Vec<f64>;

    /// Whether a change of volume is so much dearer than one of shape that coarser lattices are no good preconditioners.
    fn hardly_compresses(&self) -> bool {
        false
    }

    /// Whether coarser lattices must keep all rows, since patterns that are fine across these and smooth along them are soft.
    fn needs_all_rows(&self) -> bool {
        false
    }

    /// Makes cut bonds of a lattice, by index of the offset and lower point, ones that never were: they are no damage.
    fn never_joined(&mut self, _bonds: &[(usize, usize)]) {}

    /// Prepares for bonds that break: what a border leaves to the cells that it cuts is taken apart by the directions of bonds.
    fn prepare_to_break(&mut self) {}

    /// Hands forces on points that follow others to these, images aside.
    fn fold(&self, _force: &mut [f64]) {}

    /// Strains of stresses, both in the order of [`tensor_components`](Self::tensor_components), shears as angles; `across` is the
    /// stress across a section, where that is none of them.
    fn strains_of(&self, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR];

    /// The same at a point, whose material may be another than the base one.
    fn strains_at(&self, _point: usize, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        self.strains_of(stress, across)
    }

    /// Stress across a section that belongs to stresses in it; zero where it is one of them.
    fn across_of(&self, _stress: [f64; TENSOR]) -> f64 {
        0.0
    }

    /// The same at a point, whose material may be another than the base one.
    fn across_at(&self, _point: usize, stress: [f64; TENSOR]) -> f64 {
        self.across_of(stress)
    }

    /// Stresses and energy densities of a state.
    fn recover(&self, u: &[f64]) -> BodyFields;

    /// It as a body in the plane, if it is one.
    fn as_plane(&self) -> Option<&dyn PlaneModel> {
        None
    }

    /// Why its bonds cannot break, where those of other bodies of its model can.
    fn unbreakable(&self) -> Option<&'static str> {
        None
    }

    /// It as a solid, if it is one.
    fn as_solid(&self) -> Option<&dyn SolidModel> {
        None
    }
}
