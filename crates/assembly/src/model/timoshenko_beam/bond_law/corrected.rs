//! Eq. (12) with one corrected shear micromodulus.

use super::BondLaw;

/// `1/S_b = 1/S + ⟨ξ²⟩/(12 EI)`, the same for every bond: `c_s` of Eq. (13b) divided by
/// `1 + S δ²(1 + 1/m²)/(24 EI)`.
pub(super) const ENTRY: BondLaw = BondLaw {
    name: "corrected",
    about: "Eq. (12) with one corrected shear micromodulus; third order, free of locking",
    shear_stiffness: |bond| {
        1.0 / (1.0 / bond.shear_stiffness + bond.mean_square_length / (12.0 * bond.bending_stiffness))
    },
    is_element: false,
};
