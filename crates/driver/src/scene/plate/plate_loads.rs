//! A load case of a plate.

use crate::scene::Resultant;

/// A load case.
#[derive(Clone, Debug)]
pub struct PlateLoads {
    /// Forces and moments on the unknowns, component by component.
    pub force: Vec<f64>,
    /// Resultant as the case asks for it.
    pub asked: Resultant,
    /// Whether something follows a formula, or the steps of a border that cuts cells: its integrals are approximate.
    pub is_approximate: bool,
}
