//! Stiffness of a section, which may vary along its member.

use super::Profile;

/// Stiffness of the sections of a member: `N = EA u' + B φ'`, `M = B u' + EI φ'`, `V = S (w' − φ)`.
///
/// B couples axial force and bending where the reference axis is not the neutral one: `B = −∫ E z dA` with z towards
/// +w, for functionally graded sections (A₁₁, B₁₁, D₁₁ of laminate theory).
#[derive(Clone, Debug, PartialEq)]
pub struct SectionStiffness {
    /// Bending stiffness EI about the reference axis, N m², > 0.
    pub bending: Profile,
    /// Shear stiffness S = κGA, N, > 0.
    pub shear: Profile,
    /// Axial stiffness EA, N, > 0 where a member has axial unknowns.
    pub axial: Profile,
    /// Coupling B, N m; `B² < EA EI`.
    pub coupling: Profile,
    /// Area A, m², > 0; only energy densities depend on it.
    pub area: f64,
}

/// Compliance of one section: `u' = axial N + coupling M`, `φ' = coupling N + bending M`, `w' − φ = shear V`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compliance {
    /// 1/N.
    pub axial: f64,
    /// 1/(N m).
    pub coupling: f64,
    /// 1/(N m²).
    pub bending: f64,
    /// 1/N.
    pub shear: f64,
}

impl SectionStiffness {
    /// The same section everywhere: EI, S, EA and the area.
    pub fn uniform(bending: f64, shear: f64, axial: f64, area: f64) -> Self {
        let [bending, shear, axial, coupling] = [bending, shear, axial, 0.0].map(Profile::Uniform);
        Self { bending, shear, axial, coupling, area }
    }

    fn profiles(&self) -> [&Profile; 4] {
        [&self.bending, &self.shear, &self.axial, &self.coupling]
    }

    /// EI and S, where no stiffness varies and nothing couples.
    pub fn plain(&self) -> Option<(f64, f64)> {
        let (bending, shear) = (self.bending.uniform()?, self.shear.uniform()?);
        (!self.varies() && !self.couples()).then_some((bending, shear))
    }

    /// Whether some stiffness varies along the member.
    pub fn varies(&self) -> bool {
        self.profiles().iter().any(|p| p.uniform().is_none())
    }

    /// Whether axial force and bending are coupled.
    pub fn couples(&self) -> bool {
        self.coupling.uniform() != Some(0.0)
    }

    /// Distances from the start at which some stiffness has a kink or a jump, in order.
    pub fn breaks(&self) -> Vec<f64> {
        let mut all: Vec<f64> =
            self.profiles().iter().flat_map(|p| p.breaks().iter().map(|pair| pair[0])).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Compliance of the section at a distance from the start.
    pub fn compliance(&self, s: f64) -> Compliance {
        self.compliance_by(|profile| profile.value(s))
    }

    /// The same; on a jump that on the side of `towards`.
    pub fn compliance_beside(&self, s: f64, towards: f64) -> Compliance {
        self.compliance_by(|profile| profile.beside(s, towards))
    }

    fn compliance_by(&self, value: impl Fn(&Profile) -> f64) -> Compliance {
        let [d, a, b] = [&self.bending, &self.axial, &self.coupling].map(&value);
        let shear = 1.0 / value(&self.shear);
        if b == 0.0 {
            return Compliance { axial: 1.0 / a, coupling: 0.0, bending: 1.0 / d, shear };
        }
        let determinant = a * d - b * b;
        Compliance { axial: d / determinant, coupling: -b / determinant, bending: a / determinant, shear }
    }
}
