//! End treatments: what happens to the bonds that an end of the beam cuts off.

crate::register! {
    /// All end treatments.
    EndTreatment: cover, truncated, ghost, image
}

/// What holds an end; prescribed values for a load factor of one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndSupport {
    /// Prescribed deflection, m.
    pub w: Option<f64>,
    /// Prescribed rotation, rad.
    pub phi: Option<f64>,
}

/// How a chain ends on one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndKind {
    /// The bond between neighbours is topped up until the weights of the bonds that cross its cell sum to one.
    Covered,
    /// Bonds are missing; an end point on the end has half a volume.
    Truncated,
    /// Ghost points mirror the beam, w even and φ odd at a prescribed rotation, else w odd and φ even; the energy of
    /// bonds that cross the end is shared with the mirror image.
    Mirrored,
    /// Ghost points continue the clamped end rigidly and their bonds count in full.
    Continued,
}

/// An end treatment by name.
#[derive(Clone, Copy, Debug)]
pub struct EndTreatment {
    /// Key in a case.
    pub name: &'static str,
    /// One line for lists.
    pub about: &'static str,
    /// Whether a chain is split at interior supports and point loads.
    pub splits: bool,
    /// What an end with such a support becomes.
    pub end: fn(&EndSupport) -> EndKind,
}

impl EndTreatment {
    /// Whether the weights of the bonds that cross any cell always sum to one, so that loads can be bond-consistent.
    pub fn covers(&self) -> bool {
        self.splits
    }
}

/// The treatment of a name.
pub fn find(name: &str) -> Option<&'static EndTreatment> {
    TABLE.iter().find(|treatment| treatment.name == name)
}
