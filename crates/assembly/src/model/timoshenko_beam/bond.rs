//! A bond of a beam in the axes of its member: measures and moduli.

use super::bond_law::{BondLaw, BondShear};
use crate::bonds::{BondGeometry, BondModel, Rows};
use crate::material::Compliance;

/// Measures of a bond of length ξ and their moduli, weight not included, for unknowns (w, φ) or (w, φ, u):
///
/// ```text
/// Δφ                       with  bending
/// ξγ + eccentricity Δφ + shear_axial Δu      with  shear,   ξγ = w_j − w_i − ξ (φ_i + φ_j)/2
/// Δu + axial_bending Δφ    with  axial
/// ```
///
/// A bond is the beam between its points, so its stiffness is the inverse of its flexibility, and any symmetric positive
/// definite matrix is `UᵀDU` with a unit triangular U: moduli on the diagonal, U in the measures. In a uniform section
/// all three shares are zero; the eccentricity is the distance of the elastic centre from the middle of the bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamBond {
    /// Length ξ, m.
    pub length: f64,
    /// Bending modulus, N m.
    pub bending: f64,
    /// Shear modulus, N/m.
    pub shear: f64,
    /// Axial modulus, N/m.
    pub axial: f64,
    /// Share of Δφ in the shear measure, m.
    pub eccentricity: f64,
    /// Share of Δu in the shear measure.
    pub shear_axial: f64,
    /// Share of Δφ in the axial measure, m.
    pub axial_bending: f64,
    /// Shear strain of the sections over the shear measure, the mean over the length where sections vary, 1/m.
    pub shear_strain: f64,
}

/// Integrals of the compliance over a span, by the distance s from its middle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Flexibility {
    /// `∫ bending (1, s, s²) ds`.
    pub(super) bending: [f64; 3],
    /// `∫ coupling (1, s) ds`.
    pub(super) coupling: [f64; 2],
    /// `∫ axial ds`.
    pub(super) axial: f64,
    /// `∫ shear ds`.
    pub(super) shear: f64,
}

impl Flexibility {
    /// Adds `width` times the compliance of the section at s.
    pub(super) fn add(&mut self, section: &Compliance, s: f64, width: f64) {
        for (power, sum) in self.bending.iter_mut().enumerate() {
            *sum += width * section.bending * s.powi(power as i32);
        }
        self.coupling[0] += width * section.coupling;
        self.coupling[1] += width * section.coupling * s;
        self.axial += width * section.axial;
        self.shear += width * section.shear;
    }

    /// Adds those of a part whose middle is at `d` from that of the whole.
    pub(super) fn join(&mut self, part: &Self, d: f64) {
        let [b0, b1, b2] = part.bending;
        self.bending[0] += b0;
        self.bending[1] += b1 + d * b0;
        self.bending[2] += b2 + 2.0 * d * b1 + d * d * b0;
        self.coupling[0] += part.coupling[0];
        self.coupling[1] += part.coupling[1] + d * part.coupling[0];
        self.axial += part.axial;
        self.shear += part.shear;
    }

    /// The bond whose end actions deform it by these integrals: `F = ∫ Hᵀ c H ds` with the section forces
    /// `N, M = M₀ − V s, V` of a bond without loads, inverted by eliminating Δφ first, then Δu.
    pub(super) fn bond(&self, length: f64) -> BeamBond {
        let [f0, f1, f2] = self.bending;
        // Entries of F in the order (γ, u, φ); the moment of a shear force falls with s.
        let (phi, u_phi, g_phi) = (f0, self.coupling[0], -f1);
        let (v_u, v_g) = (u_phi / phi, g_phi / phi);
        let u = self.axial - u_phi * v_u;
        let g_u = -self.coupling[1] - g_phi * v_u;
        let v_gu = if g_u == 0.0 { 0.0 } else { g_u / u };
        let shear = f2 + self.shear - g_phi * v_g - g_u * v_gu;
        BeamBond {
            length,
            bending: 1.0 / phi,
            shear: 1.0 / shear,
            axial: 1.0 / u,
            eccentricity: v_gu * v_u - v_g,
            shear_axial: -v_gu,
            axial_bending: -v_u,
            shear_strain: self.shear / (shear * length),
        }
    }
}

impl BeamBond {
    /// Measures `(Δφ, shear, axial)` of points whose unknowns differ by `(Δw, Δφ, Δu)`, with the sum of their rotations.
    pub(super) fn measures(&self, [dw, dphi, du]: [f64; 3], rotations: f64) -> [f64; 3] {
        let shear = dw - 0.5 * self.length * rotations + self.eccentricity * dphi + self.shear_axial * du;
        [dphi, shear, du + self.axial_bending * dphi]
    }

    /// Measures `(Δφ, shear)` for unknowns (w, φ).
    pub(super) fn rows2(&self) -> Rows<2, 2> {
        Rows { difference: [[0.0, 1.0], [1.0, self.eccentricity]], mean: [[0.0, 0.0], [0.0, -self.length]] }
    }

    /// Measures `(Δφ, shear)` for unknowns (w, φ, u) where axial force and bending do not couple.
    pub(super) fn rows3(&self) -> Rows<3, 2> {
        Rows {
            difference: [[0.0, 1.0, 0.0], [1.0, self.eccentricity, 0.0]],
            mean: [[0.0; 3], [0.0, -self.length, 0.0]],
        }
    }

    /// Measures `(Δφ, shear, axial)` for unknowns (w, φ, u).
    pub(super) fn coupled_rows(&self) -> Rows<3, 3> {
        Rows {
            difference: [
                [0.0, 1.0, 0.0],
                [1.0, self.eccentricity, self.shear_axial],
                [0.0, self.axial_bending, 1.0],
            ],
            mean: [[0.0; 3], [0.0, -self.length, 0.0], [0.0; 3]],
        }
    }
}

/// A section that does not vary, whose bonds follow a bond law.
#[derive(Clone, Copy, Debug)]
pub struct UniformSection {
    /// Bending stiffness EI, N m².
    pub bending_stiffness: f64,
    /// Shear stiffness S, N.
    pub shear_stiffness: f64,
    /// Axial stiffness EA, N.
    pub axial_stiffness: f64,
    /// Bond law.
    pub law: &'static BondLaw,
}

impl UniformSection {
    /// The bond of a length, `mean_square_length` being ⟨ξ²⟩ of its family, m².
    pub fn bond(&self, length: f64, mean_square_length: f64) -> BeamBond {
        let shear = (self.law.shear_stiffness)(&BondShear {
            bending_stiffness: self.bending_stiffness,
            shear_stiffness: self.shear_stiffness,
            length,
            mean_square_length,
        });
        BeamBond {
            length,
            bending: self.bending_stiffness / length,
            shear: shear / length,
            axial: self.axial_stiffness / length,
            eccentricity: 0.0,
            shear_axial: 0.0,
            axial_bending: 0.0,
            shear_strain: if self.law.is_element { shear / self.shear_stiffness } else { 1.0 } / length,
        }
    }
}

/// Bending and shear of the bonds of a uniform lattice, `(Δφ, ξγ)`, for a family of one ⟨ξ²⟩.
#[derive(Clone, Copy, Debug)]
pub struct UniformBending {
    /// The section.
    pub section: UniformSection,
    /// ⟨ξ²⟩ of the family, m².
    pub mean_square_length: f64,
}

impl UniformBending {
    fn bond(&self, bond: &BondGeometry) -> BeamBond {
        self.section.bond(bond.length(), self.mean_square_length)
    }
}

impl BondModel<2, 2> for UniformBending {
    const DIFFERENCE: [[bool; 2]; 2] = [[false, true], [true, false]];
    const MEAN: [[bool; 2]; 2] = [[false, false], [false, true]];

    fn rows(&self, bond: &BondGeometry) -> Rows<2, 2> {
        self.bond(bond).rows2()
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 2] {
        let bond = self.bond(bond);
        [bond.bending, bond.shear]
    }
}

impl BondModel<3, 2> for UniformBending {
    const DIFFERENCE: [[bool; 3]; 2] = [[false, true, false], [true, false, false]];
    const MEAN: [[bool; 3]; 2] = [[false; 3], [false, true, false]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 2> {
        self.bond(bond).rows3()
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 2] {
        BondModel::<2, 2>::moduli(self, bond)
    }
}

/// Stretch of the bonds of a uniform lattice, `Δu`.
#[derive(Clone, Copy, Debug)]
pub struct UniformStretch {
    /// Axial stiffness EA, N.
    pub axial_stiffness: f64,
}

impl BondModel<3, 1> for UniformStretch {
    const DIFFERENCE: [[bool; 3]; 1] = [[false, false, true]];
    const MEAN: [[bool; 3]; 1] = [[false; 3]];

    fn rows(&self, _: &BondGeometry) -> Rows<3, 1> {
        Rows { difference: [[0.0, 0.0, 1.0]], mean: [[0.0; 3]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        [self.axial_stiffness / bond.length()]
    }
}
