//! What a solid is made of, whatever its points.

use super::super::bond_plane::{VolumeFactor, cell_in_disc, radial_part};
use super::super::plane::{Calibration, Edges, Neighbourhood, length};
use super::Isotropic;
use crate::body::Cell;
use crate::quadrature::GAUSS;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use thiserror::Error;

/// What is done about the bonds that points near faces of a solid lack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SolidEdges {
    /// Bonds that leave the body end on its border, which moves with the points beside it: every uniform stress without shear is
    /// in equilibrium at every face, edge and corner, and shear but for corners. Of solids whose points feel changes of volume only
    /// the stiffness is exact. It is the overlay where cells are cut, and where single rows or layers stand alone.
    #[default]
    Border,
    /// Tetrahedra with the stiffness of the missing bonds: every point has the right stiffness for every uniform strain.
    Overlay,
    /// Nothing: points near faces are too soft.
    None,
}

impl SolidEdges {
    /// Rows, columns or layers of images beyond a plane of symmetry that bonds of some reach need.
    pub(super) fn depth(self, reach: i32) -> i32 {
        // Bonds through the plane may end on the border, which moves with the next but one layer, too.
        if self == Self::Border { reach + 2 } else { reach }
    }

    /// Whether points near faces have exactly the stiffness of the material, if the others have.
    pub fn is_exact(self) -> bool {
        matches!(self, Self::Border | Self::Overlay)
    }
}

impl From<SolidEdges> for Edges {
    fn from(edges: SolidEdges) -> Self {
        match edges {
            SolidEdges::Border => Self::Border,
            SolidEdges::Overlay => Self::Overlay,
            SolidEdges::None => Self::None,
        }
    }
}

/// Why a solid cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SolidError {
    /// No non-negative stiffnesses of the bonds give the moduli of the material.
    #[error(
        "bonds of at most {horizon_ratio} spacings cannot have the moduli of the material exactly; \
         increase the horizon ratio"
    )]
    NotRepresentable {
        /// Horizon per spacing.
        horizon_ratio: f64,
        /// What remains of the moduli, relative to C11 or to the weighted volume.
        residual: f64,
    },
    /// The horizon reaches no other point.
    #[error("a horizon of {horizon_ratio} spacings reaches no other point; increase the horizon ratio")]
    NoNeighbours {
        /// Horizon per spacing.
        horizon_ratio: f64,
    },
    /// What completes faces adds what exact families lack.
    #[error(
        "edges `border` and `overlay` need the calibration `matched`: bonds as published do not have exact moduli"
    )]
    EdgesNeedMatched,
    /// A layer of points does not resist bending, nor do rows.
    #[error(
        "the body is one point thick; a solid needs two points in every direction, so refine the lattice"
    )]
    TooThin,
    /// Several materials where bonds cannot end on the border.
    #[error(
        "solids of several materials need whole cells, at least two thick, and bonds that end on the border"
    )]
    MaterialsNeedBorder,
    /// Points of a cloud have no cells.
    #[error("the volume factor `area` needs the cells of a lattice; `ramp` needs none")]
    AreaNeedsCells,
    /// Two points of a cloud coincide.
    #[error("points {first} and {second} have the same position")]
    Coincident {
        /// The lower number.
        first: usize,
        /// The other one.
        second: usize,
    },
    /// Poisson's ratio is that of no stable material.
    #[error("a Poisson ratio of {poisson_ratio} is not between -1 and 1/2")]
    PoissonRatio {
        /// What was given.
        poisson_ratio: f64,
    },
}

/// What the dilatation of a point is, and what it does work with.
#[derive(Clone, Debug)]
pub(in super::super) struct Dilatation {
    /// `3 w/q` per offset, spacings⁻²: `ϑ = Σ (3 w/q) |ξ| e` over all neighbours, lengths in spacings.
    pub(in super::super) shares: Vec<f64>,
    /// The modulus A, Pa.
    pub(in super::super) modulus: f64,
}

/// The offsets of a solid with the weights of their bonds, and its dilatation.
#[derive(Clone, Debug)]
pub struct SolidLaw {
    pub(in super::super) neighbourhood: Neighbourhood<1>,
    pub(in super::super) dilatation: Option<Dilatation>,
    pub(in super::super) material: Isotropic,
    pub(in super::super) edges: SolidEdges,
}

/// Parameters of a solid that say what it is made of.
pub trait SolidMaterial: Copy + Debug + Send + Sync + 'static {
    /// Its law.
    ///
    /// # Errors
    /// [`SolidError`], all that speaks neither of clouds nor of bodies.
    fn law(&self) -> Result<SolidLaw, SolidError>;
}

/// Offsets of all bonds that can exist, spacings.
pub(in super::super) fn reach_of(calibration: Calibration, factor: VolumeFactor, horizon_ratio: f64) -> f64 {
    let beyond = match (calibration, factor) {
        (Calibration::Published, VolumeFactor::Ramp) => 0.5,
        // Half a diagonal of a cell.
        (Calibration::Published, VolumeFactor::Area) => 0.87,
        _ => 0.0,
    };
    horizon_ratio + beyond
}

/// Part of the volume of the neighbour at an offset inside a horizon of `m` spacings; the factor `area` is the overlap of its
/// cell with the ball.
pub(in super::super) fn part(factor: VolumeFactor, m: f64, step: Cell) -> f64 {
    if factor != VolumeFactor::Area {
        return radial_part(factor, length(step), m, 1.0);
    }
    // One order, so that offsets that are images of each other have the same part.
    let mut step = step.map(i32::abs);
    step.sort_unstable();
    let [a, b, c] = step.map(f64::from);
    let least = [a, b, c].map(|k| (k - 0.5).max(0.0));
    if least.iter().map(|k| k * k).sum::<f64>() >= m * m {
        return 0.0;
    }
    /// Slices of a cell; the sum is exact to 1e-6 of a cell.
    const SLICES: usize = 16;
    let slice = |k: usize| {
        let of = |(at, weight): (f64, f64)| {
            let height = c - 0.5 + (k as f64 + at) / SLICES as f64;
            weight * cell_in_disc([step[0], step[1], 0], (m * m - height * height).max(0.0).sqrt())
        };
        GAUSS.into_iter().map(of).sum::<f64>() / SLICES as f64
    };
    (0..SLICES).map(slice).sum()
}
