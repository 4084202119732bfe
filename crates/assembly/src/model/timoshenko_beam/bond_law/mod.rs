//! Bond laws: the shear stiffness of a bond. The bending stiffness is EI in all of them.

crate::register! {
    /// All bond laws.
    BondLaw: published, corrected, exact
}

/// What a law may use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondShear {
    /// Bending stiffness EI, N m².
    pub bending_stiffness: f64,
    /// Shear stiffness S = κGA, N.
    pub shear_stiffness: f64,
    /// Length ξ of the bond, m.
    pub length: f64,
    /// Mean ⟨ξ²⟩ = Σ ξ³α / Σ ξα over the bonds of a family, m².
    pub mean_square_length: f64,
}

/// A bond law by name.
#[derive(Clone, Copy, Debug)]
pub struct BondLaw {
    /// Key in a case.
    pub name: &'static str,
    /// One line for lists.
    pub about: &'static str,
    /// Shear stiffness S_b of a bond, N.
    pub shear_stiffness: fn(&BondShear) -> f64,
    /// Whether a bond is the exact element of its span: the shear strain of its sections is then `V_b/(α S)`, not the
    /// `γ_b = V_b/(α S_b)` that bending is a part of.
    pub is_element: bool,
}

/// The law of a name.
pub fn find(name: &str) -> Option<&'static BondLaw> {
    TABLE.iter().find(|law| law.name == name)
}
