//! A shear stiffness per bond length that makes nodal values exact.

use super::BondLaw;

/// `1/S_b = 1/S + ξ²/(12 EI)`: every bond is the exact Timoshenko element of its own span.
pub(super) const ENTRY: BondLaw = BondLaw {
    name: "exact",
    about: "one shear micromodulus per bond length; nodal values equal the local closed form to rounding (default)",
    shear_stiffness: |bond| {
        1.0 / (1.0 / bond.shear_stiffness + bond.length.powi(2) / (12.0 * bond.bending_stiffness))
    },
    is_element: true,
};
