//! Bodies of shell membranes.

use super::super::plane::{Calibration, Mirrors, at, halved, near_points};
use super::ends::Ends;
use super::family::{ShellFamilies, offsets, steps};
use super::{Curvature, ShellBond, ShellEnds, ShellError, ShellParameters};
use crate::body::{Cell, SquareLattice};
use crate::stiffness::{Exception, GridBonds, Offset};
use std::sync::Arc;

/// The membrane of a cylinder, developed: x along the axis, y along the circumference.
#[derive(Clone, Debug)]
pub struct ShellMembrane {
    pub(super) parameters: ShellParameters,
    pub(super) lattice: Arc<SquareLattice>,
    pub(super) mirrors: Mirrors,
    /// Images of real points.
    pub(super) ghosts: Vec<u32>,
    pub(super) families: Arc<ShellFamilies>,
    /// Bonds as their energy counts: half across a line of symmetry or a joined side, not beyond it.
    pub(super) bonds: Arc<GridBonds<3, 1, ShellBond>>,
    /// Bonds that end on the border.
    pub(super) ends: Option<Ends>,
    pub(super) curvature: Option<Arc<Curvature>>,
}

/// How far the arc of a tube may be from its circumference, relative.
const ROUNDED: f64 = 1e-3;

impl ShellMembrane {
    /// One of each pair of opposite offsets to the neighbours of a point.
    ///
    /// # Errors
    /// [`ShellError::ShortHorizon`].
    pub fn offsets(parameters: &ShellParameters) -> Result<Vec<Cell>, ShellError> {
        let horizon_ratio = parameters.horizon_ratio;
        if horizon_ratio < 2.0 - 1e-9 {
            return Err(ShellError::ShortHorizon { horizon_ratio });
        }
        Ok(steps(horizon_ratio))
    }

    /// Rows or columns of images that a lattice needs beyond a line of symmetry or a joined side.
    ///
    /// # Errors
    /// As [`offsets`](Self::offsets).
    pub fn depth(parameters: &ShellParameters) -> Result<i32, ShellError> {
        Ok(Self::offsets(parameters)?.into_iter().flatten().map(i32::abs).max().unwrap_or(0))
    }

    /// Whether an arc, m, with joined ends is a whole part `1/n` of the circumference, or its rounding; the number n.
    pub fn parts_of_circumference(radius: f64, arc: f64) -> Option<f64> {
        let whole = std::f64::consts::TAU * radius;
        let parts = (whole / arc).round();
        (parts >= 1.0 && (parts * arc / whole - 1.0).abs() <= ROUNDED).then_some(parts)
    }

    /// Rows after which a body comes back to itself: between joined sides, or twice those between two mirrors.
    pub fn closing_rows(mirrors: &Mirrors) -> Option<i32> {
        let [low, high] = mirrors.lines[1];
        let rows = high? - low?;
        Some(if mirrors.joined[1] { rows } else { 2 * rows })
    }

    /// The radius, m, with which some joined rows close: that of the parameters but for the rounding of a circumference. A
    /// single row closes with any.
    pub fn closed_radius(radius: f64, spacing: f64, joined_rows: Option<i32>) -> f64 {
        let arc = joined_rows.filter(|rows| *rows > 1).map(|rows| spacing * f64::from(rows));
        let whole = arc.and_then(|arc| {
            // Between two mirrors there can be whole turns, too.
            let turns = (arc / (std::f64::consts::TAU * radius)).round();
            match Self::parts_of_circumference(radius, arc) {
                Some(parts) => Some(arc * parts),
                None if turns >= 1.0 => {
                    Self::parts_of_circumference(radius, arc / turns).map(|parts| arc / turns * parts)
                }
                None => None,
            }
        });
        whole.map_or(radius, |whole| whole / std::f64::consts::TAU)
    }

    /// A body on a lattice, images in `mirrors` among its points ([`Mirrors::extended`]). Its radius is the
    /// [`closed_radius`](Self::closed_radius).
    ///
    /// # Errors
    /// [`ShellError`].
    pub fn on_lattice(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: ShellParameters,
    ) -> Result<Self, ShellError> {
        Self::offsets(&parameters)?;
        Self::with_any_horizon(lattice, mirrors, parameters)
    }

    /// The same with horizons that are too short, too.
    pub(super) fn with_any_horizon(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: ShellParameters,
    ) -> Result<Self, ShellError> {
        let spacing = lattice.spacing();
        let radius = Self::closed_radius(parameters.radius, spacing, Self::closing_rows(&mirrors));
        let parameters = ShellParameters { radius, ..parameters };
        let ShellParameters { youngs_modulus, thickness, kinematics, .. } = parameters;
        let modulus = 6.0 * youngs_modulus * thickness * spacing * spacing;
        let bond = ShellBond { radius, kinematics, modulus };
        let offsets = offsets(&parameters, &bond, spacing)?;
        let has_border = Self::has_border(&parameters, &mirrors.real(&lattice));
        let families =
            ShellFamilies::new((&lattice, &mirrors), (parameters.calibration, has_border), &bond, offsets);
        let ghosts = mirrors.ghosts(&lattice);
        let bonds = grid(&lattice, &mirrors, &ghosts, &families, &bond);
        let curvature =
            parameters.bending.then(|| Arc::new(Curvature::new(&lattice, &mirrors, &parameters, &families)));
        let ends = has_border.then(|| Ends::new((&lattice, &mirrors), &families, &bond));
        let (families, bonds) = (Arc::new(families), Arc::new(bonds));
        Ok(Self { parameters, lattice, mirrors, ghosts, families, bonds, ends, curvature })
    }

    /// Whether bonds end on the border of a lattice of real cells: two columns tell how it moves.
    pub fn has_border(parameters: &ShellParameters, real: &SquareLattice) -> bool {
        parameters.ends == ShellEnds::Border
            && parameters.calibration == Calibration::Matched
            && real.columns().len() >= 2
    }

    /// Whether the sides along the axis are free.
    pub(super) fn has_free_sides(&self) -> bool {
        !self.mirrors.joined[1] && self.mirrors.lines[1].contains(&None)
    }

    /// The parameters, with the radius that closes.
    pub fn parameters(&self) -> &ShellParameters {
        &self.parameters
    }

    /// Area of a real point, m².
    pub(super) fn cell_area(&self) -> f64 {
        self.lattice.spacing().powi(2)
    }

    /// Numbers of the real points.
    pub(super) fn real_points(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.lattice.points()).filter(|&p| !self.is_ghost(p))
    }
}

/// The bonds: the energy `½ 3 E h A r_ij e²` of either end, so that their factor is the mean weight of both per that of a
/// full family.
fn grid(
    lattice: &Arc<SquareLattice>,
    mirrors: &Mirrors,
    ghosts: &[u32],
    families: &ShellFamilies,
    bond: &ShellBond,
) -> GridBonds<3, 1, ShellBond> {
    let special = |point: usize| {
        let real = lattice.number(mirrors.image(lattice.cell(point)).0)?;
        families.special.get(&(real as u32)).map(|weights| (weights, mirrors.image(lattice.cell(point)).1))
    };
    let mut exceptions = Vec::new();
    for point in near_points(lattice, families.reach()) {
        if special(point).is_none() {
            continue;
        }
        let cell = lattice.cell(point);
        for (k, offset) in families.offsets.iter().enumerate() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(cell, offset.step, up)) else { continue };
                // A bond between two such points is met twice.
                if up || special(other).is_none() {
                    let of = |p: usize, up: bool| match special(p) {
                        Some((weights, signs)) => families.seen(weights, k, up, signs),
                        None => offset.weight,
                    };
                    let factor = 0.5 * (of(point, up) + of(other, !up)) / offset.weight;
                    exceptions.push(Exception { offset: k, lower: if up { point } else { other }, factor });
                }
            }
        }
    }
    exceptions.extend(halved(lattice, mirrors, &families.neighbourhood(), ghosts));
    let offsets: Vec<Offset<1>> =
        families.offsets.iter().map(|o| Offset { step: o.step, weights: [o.weight] }).collect();
    GridBonds::new(lattice.clone(), bond, &offsets, &exceptions)
}
