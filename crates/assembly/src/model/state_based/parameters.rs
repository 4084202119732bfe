//! Material, family and treatments of state-based bodies.

use super::super::bond_plane::Influence;
use crate::bonds::Mat;
use serde::{Deserialize, Serialize};

/// What the plane of the points is a section of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// A plate, m thick, without stress across it.
    PlaneStress(f64),
    /// A slice, m thick, of a body without strain across it.
    PlaneStrain(f64),
    /// A body of revolution: x is the radius, y the axis. Volumes, forces and energies are those of the whole ring.
    Axisymmetric,
}

/// What is done about the bonds that families near edges lack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum StateEdges {
    /// Points outside, moved by affine fits of those inside, complete every family; its weights are those of a full one.
    #[default]
    Ghosts,
    /// Bonds that leave the body end on its border, or give what they have to the triangles that it cuts: every uniform stress
    /// is in equilibrium. In a body of revolution this holds but for corners of its whole blocks and for what bonds of several
    /// rows leave along long borders. With cracks, and in bodies that break, it is `ghosts`.
    Border,
    /// Weights that are exact for every uniform strain in what is left of a family; where some would be negative the point
    /// gives its energy to the next one.
    MomentPlus,
    /// The same, and refused where some weight would be negative.
    Moment,
    /// The weighted volume is that of the neighbours that are there.
    Calibrated,
    /// Nothing: the weighted volume is that of the continuum.
    None,
}

/// What the neighbours of a point count by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Their areas in the section.
    #[default]
    Section,
    /// The volumes of their rings, `2π r A`, as published (Lu, Oterkus and Oterkus 2020, Eq. 13).
    Published,
}

/// What points next to the axis have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Images across the axis, and weights and radii with which a uniform stress is in equilibrium.
    #[default]
    Table,
    /// Images across the axis alone: the hoop strain of the first points is up to 70 % wrong.
    Images,
    /// No images: families end at the axis.
    Truncated,
}

/// How a change of volume is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Dilatation {
    /// By every point.
    Points,
    /// As a mean over blocks of two by two points (B-bar): nothing locks as ν comes near 1/2.
    Blocks,
}

/// Material and families of a state-based body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateParameters {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// What the points are a section of.
    pub geometry: Geometry,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Weight over length.
    pub influence: Influence,
    /// Treatment of edges.
    pub edges: StateEdges,
    /// What neighbours count by.
    pub measure: Measure,
    /// Treatment of the axis.
    pub axis: Axis,
    /// How changes of volume are measured.
    pub dilatation: Dilatation,
}

impl StateParameters {
    /// Whether the points are a section of a body of revolution.
    pub fn is_axisymmetric(&self) -> bool {
        self.geometry == Geometry::Axisymmetric
    }

    /// Shear modulus μ, Pa.
    pub fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + self.poisson_ratio)
    }

    /// Lamé's λ between the strains that the section has, Pa: `E ν/(1 − ν²)` in plane stress.
    pub fn lame(&self) -> f64 {
        let (e, nu) = (self.youngs_modulus, self.poisson_ratio);
        match self.geometry {
            // 1 − ν² would lose what is left of 1 + ν where that vanishes.
            Geometry::PlaneStress(_) => e * nu / ((1.0 + nu) * (1.0 - nu)),
            _ => e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        }
    }

    /// Modulus of a change of volume without one of shape, Pa: `λ + 2μ/3`.
    pub fn bulk_modulus(&self) -> f64 {
        self.lame() + 2.0 / 3.0 * self.shear_modulus()
    }

    /// Root of the ratio of the moduli of changes of volume, or of area in the plane, and of shape, the larger over the smaller.
    pub(super) fn contrast(&self) -> f64 {
        let shape = self.shear_modulus();
        let volume = if self.is_axisymmetric() { self.bulk_modulus() } else { self.lame() + shape };
        (shape / volume).max(volume / shape).sqrt()
    }

    /// From strains `[ε_xx, ε_yy, γ_xy]` without a strain across the section to stresses, Pa.
    pub fn stiffness(&self) -> Mat<3, 3> {
        let (lame, shear) = (self.lame(), self.shear_modulus());
        let direct = lame + 2.0 * shear;
        [[direct, lame, 0.0], [lame, direct, 0.0], [0.0, 0.0, shear]]
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` of stresses in the section, without a strain across it.
    pub(super) fn strain(&self, [xx, yy, xy]: [f64; 3]) -> [f64; 3] {
        let [[a, b, _], _, [_, _, shear]] = self.stiffness();
        let determinant = a * a - b * b;
        [(a * xx - b * yy) / determinant, (a * yy - b * xx) / determinant, xy / shear]
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` of stresses in the section and, in a body of revolution, of that across it.
    pub(super) fn strain_with(&self, stress: [f64; 3], across: f64) -> [f64; 3] {
        if !self.is_axisymmetric() {
            return self.strain(stress);
        }
        let (e, nu) = (self.youngs_modulus, self.poisson_ratio);
        let [xx, yy, xy] = stress;
        [(xx - nu * (yy + across)) / e, (yy - nu * (xx + across)) / e, xy / self.shear_modulus()]
    }

    /// Stress across the section that belongs to stresses in it.
    pub(super) fn stress_across(&self, [x, y, _]: [f64; 3]) -> f64 {
        match self.geometry {
            Geometry::PlaneStrain(_) => self.poisson_ratio * (x + y),
            _ => 0.0,
        }
    }

    /// Whether a change of volume is so much dearer than one of shape that coarser lattices are no good preconditioners.
    pub(super) fn hardly_compresses(&self) -> bool {
        // Bulk over shear modulus: 33 multigrid iterations at ν = 0.49, a ratio of 50, more than 200 at ν = 0.4999.
        const MOST: f64 = 60.0;
        self.bulk_modulus() > MOST * self.shear_modulus()
    }

    /// Whether families have energy beside that of their bonds: not where `λ = μ`.
    pub fn has_families(&self) -> bool {
        // What rounding leaves of λ − μ in plane stress at ν = 1/3.
        let least = 1e-12 * self.shear_modulus();
        let is_plain = self.family_modulus().as_flattened().iter().all(|c| c.abs() < least);
        !is_plain || self.dilatation == Dilatation::Blocks
    }

    /// From the section's dilatation and the hoop strain to what they do work with beside the bonds, Pa: the part of
    /// `W = ½(λ−μ)ϑ² + λ ϑ h + ½(λ+2μ)h² + (4μ/q) Σ w e²` that bonds have not.
    pub(super) fn whole_modulus(&self) -> Mat<2, 2> {
        let (lame, shear) = (self.lame(), self.shear_modulus());
        match self.is_axisymmetric() {
            true => [[lame - shear, lame], [lame, lame + 2.0 * shear]],
            false => [[lame - shear, 0.0], [0.0; 2]],
        }
    }

    /// The same without what means over blocks have of it.
    pub(super) fn family_modulus(&self) -> Mat<2, 2> {
        let mut modulus = self.whole_modulus();
        if self.dilatation == Dilatation::Blocks {
            let bulk = self.bulk_modulus();
            let measures = if self.is_axisymmetric() { 2 } else { 1 };
            modulus[..measures]
                .iter_mut()
                .for_each(|row| row[..measures].iter_mut().for_each(|c| *c -= bulk));
        }
        modulus
    }
}
