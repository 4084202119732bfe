//! Bonds of a body that is a cloud of points.
//!
//! No weights are exact at every point of any cloud. So every point has a scale g, the largest with which its bonds are
//! nowhere stiffer than the material, `C − g M >= 0` with the moment M of its bonds; a bond takes the smaller scale of its
//! ends, and the overlay gives every point what it lacks of C.

mod breaking;
mod neighbours;
mod stiffness;
mod triangles;

use super::super::plane::{Calibration, Edges};
use super::calibration::published::{micromodulus, radial_part};
use super::{BondPlaneError, PlaneParameters, VolumeFactor};
use crate::bonds::Rows;
use crate::model::ModelSizes;
use crate::stiffness::{Bond, Bonds, Families, Term};
use std::sync::Arc;

/// A cloud with its bonds.
#[derive(Clone, Debug)]
pub(super) struct CloudBody {
    pub(super) positions: Vec<[f64; 2]>,
    pub(super) areas: Vec<f64>,
    pub(super) bonds: Arc<Bonds<2, 1>>,
    pub(super) triangles: Arc<Families<2, 3, 2>>,
    pub(super) uncorrected: usize,
    /// Area of the whole family of every point that counts, and of its cut part.
    family: Vec<f64>,
    lost: Vec<f64>,
    horizon: f64,
    volume_factor: VolumeFactor,
}

/// Two neighbours and the bond between them.
#[derive(Clone, Copy, Debug)]
struct Pair {
    points: [u32; 2],
    /// Unit vector from the first to the second.
    direction: [f64; 2],
    /// Distance, m.
    length: f64,
    /// Part of their volumes that counts.
    part: f64,
    /// N/m.
    stiffness: f64,
}

impl Pair {
    fn ends(&self) -> [usize; 2] {
        self.points.map(|p| p as usize)
    }

    /// `N = (n_x², n_y², n_x n_y)`.
    fn product(&self) -> [f64; 3] {
        product(self.direction)
    }
}

fn product([x, y]: [f64; 2]) -> [f64; 3] {
    [x * x, y * y, x * y]
}

impl CloudBody {
    /// Terms of the energy.
    pub(super) fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        let mut terms: Vec<Box<dyn Term<2>>> = vec![Box::new(self.bonds.clone())];
        if !self.triangles.list().is_empty() {
            terms.push(Box::new(self.triangles.clone()));
        }
        terms
    }

    /// Their sizes.
    pub(super) fn sizes(&self) -> ModelSizes {
        let bonds = ModelSizes::of(&self.bonds, self.bonds.elements());
        bonds.join(ModelSizes::of(&self.triangles, 3 * self.triangles.elements()))
    }

    pub(super) fn new(
        positions: Vec<[f64; 2]>,
        areas: Vec<f64>,
        horizon: f64,
        parameters: &PlaneParameters,
        cut: &dyn Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Result<Self, BondPlaneError> {
        let (mut pairs, volumes) = pairs(&positions, &areas, horizon, parameters)?;
        if parameters.calibration == Calibration::Matched {
            stiffness::scale(&mut pairs, &volumes, &parameters.material.stiffness());
        }
        stiffness::treat(&mut pairs, &volumes, horizon, parameters);
        let n = positions.len();
        let triangles = match parameters.edges {
            Edges::Border | Edges::Overlay => {
                let deficits = stiffness::deficits(&pairs, &volumes, &parameters.material.stiffness());
                triangles::overlay(&positions, &pairs, &deficits, &volumes, cut)
            }
            _ => triangles::Overlay::default(),
        };
        let is_cut = |pair: &Pair| {
            let [i, j] = pair.ends();
            cut(positions[i], positions[j])
        };
        let (mut family, mut lost) = (vec![0.0; n], vec![0.0; n]);
        let mut intact = Vec::with_capacity(pairs.len());
        for pair in &pairs {
            let broken = is_cut(pair);
            for (end, other) in [(0, 1), (1, 0)] {
                let part = pair.part * areas[pair.ends()[other]];
                family[pair.ends()[end]] += part;
                lost[pair.ends()[end]] += if broken { part } else { 0.0 };
            }
            if !broken {
                intact.push(Bond {
                    points: pair.points,
                    rows: Rows { difference: [pair.direction], mean: [[0.0; 2]] },
                    moduli: [pair.stiffness],
                });
            }
        }
        Ok(Self {
            positions,
            areas,
            bonds: Arc::new(Bonds::new(n, intact.into_iter())),
            triangles: Arc::new(Families::new(n, triangles.triangles)),
            uncorrected: triangles.uncorrected,
            family,
            lost,
            horizon,
            volume_factor: effective_factor(parameters),
        })
    }

    /// Distance of the points of a bond, m.
    pub(super) fn length(&self, bond: &Bond<2, 1>) -> f64 {
        let [a, b] = bond.points.map(|p| self.positions[p as usize]);
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    /// Volume of a point, m³.
    pub(super) fn volume(&self, point: usize, thickness: f64) -> f64 {
        self.areas[point] * thickness
    }

    /// Cut shares of the family volumes of all points.
    pub(super) fn damage(&self) -> Vec<f64> {
        let share = |(lost, family): (&f64, &f64)| if *lost > 0.0 { lost / family } else { 0.0 };
        self.lost.iter().zip(&self.family).map(share).collect()
    }

    /// Part of their volumes that counts in the bond of two points.
    fn part_of(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (self.positions[i], self.positions[j]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        part(self.volume_factor, length, self.horizon, [i, j].map(|p| self.areas[p].sqrt()))
    }

    /// Stresses and energy densities from the bonds alone: four planes.
    pub(super) fn sums(&self, u: &[f64], thickness: f64) -> Vec<f64> {
        let n = self.positions.len();
        let mut sums = vec![0.0; 4 * n];
        for bond in self.bonds.list() {
            let (products, half) = (product(bond.rows.difference[0]), 0.5 * self.length(bond));
            let ([e], [force]) = bond.response(n, u);
            for p in bond.points.map(|p| p as usize) {
                let volume = self.areas[p] * thickness;
                (0..3).for_each(|q| sums[q * n + p] += half * products[q] * force / volume);
                sums[3 * n + p] += 0.25 * e * force / volume;
            }
        }
        sums
    }

    /// Adds the forces of the bonds that do the work `Σ t·V σ`.
    pub(super) fn add_work(&self, t: &[f64], force: &mut [f64]) {
        let n = self.positions.len();
        for bond in self.bonds.list() {
            let [i, j] = bond.points.map(|p| p as usize);
            let products = product(bond.rows.difference[0]);
            let both: f64 = (0..3).map(|q| products[q] * (t[q * n + i] + t[q * n + j])).sum();
            let action = 0.5 * self.length(bond) * bond.moduli[0] * both;
            for c in 0..2 {
                force[c * n + i] -= bond.rows.difference[0][c] * action;
                force[c * n + j] += bond.rows.difference[0][c] * action;
            }
        }
    }
}

/// Neighbours with `k = c ω β V_i V_j/ξ` and the volumes of all points.
fn pairs(
    positions: &[[f64; 2]],
    areas: &[f64],
    horizon: f64,
    parameters: &PlaneParameters,
) -> Result<(Vec<Pair>, Vec<f64>), BondPlaneError> {
    let published = parameters.calibration == Calibration::Published;
    if published && parameters.edges.is_exact() {
        return Err(BondPlaneError::OverlayNeedsMatched);
    }
    if published && parameters.volume_factor == VolumeFactor::Area {
        return Err(BondPlaneError::AreaNeedsCells);
    }
    let factor = effective_factor(parameters);
    let widths: Vec<f64> = areas.iter().map(|a| a.sqrt()).collect();
    let beyond = match factor {
        VolumeFactor::Ramp => 0.5 * widths.iter().copied().fold(0.0, f64::max),
        _ => 0.0,
    };
    let volumes: Vec<f64> = areas.iter().map(|a| a * parameters.material.thickness).collect();
    let c = micromodulus(parameters, horizon);
    let mut pairs = Vec::new();
    for [i, j] in neighbours::within(positions, (horizon + beyond) * (1.0 + 1e-9))? {
        let (a, b) = (positions[i as usize], positions[j as usize]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let part = part(factor, length, horizon, [i, j].map(|p| widths[p as usize]));
        let influence = parameters.influence.at((length / horizon).min(1.0));
        let stiffness = c * influence * part * volumes[i as usize] * volumes[j as usize] / length;
        if stiffness > 0.0 {
            let direction = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
            pairs.push(Pair { points: [i, j], direction, length, part, stiffness });
        }
    }
    Ok((pairs, volumes))
}

/// The volume factors of the calibration `published`; other bonds need none.
fn effective_factor(parameters: &PlaneParameters) -> VolumeFactor {
    match parameters.calibration {
        Calibration::Published => parameters.volume_factor,
        Calibration::Matched => VolumeFactor::Full,
    }
}

/// Part of their volumes that counts in the bond of two points of some widths.
fn part(factor: VolumeFactor, length: f64, horizon: f64, widths: [f64; 2]) -> f64 {
    let [a, b] = widths.map(|width| radial_part(factor, length, horizon, width));
    0.5 * (a + b)
}
