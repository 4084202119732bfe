//! The literal constants of Eq. (12).

use super::BondLaw;

/// `S_b = S`. Bonds of different length cannot all follow a varying curvature without shear, so the beam locks where
/// the horizon is longer than about three section heights.
pub(super) const ENTRY: BondLaw = BondLaw {
    name: "published",
    about: "the constants of Eq. (12); second order, locks when the horizon exceeds 3 section heights",
    shear_stiffness: |bond| bond.shear_stiffness,
    is_element: false,
};
