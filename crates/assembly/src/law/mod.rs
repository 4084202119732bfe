//! Laws of bonds with memory: what force a stretch takes, given what the bond has been through.
//!
//! A law knows one bond of unit modulus: forces are stretches, energies products of two stretches. A bond of length ξ and
//! stiffness k, N/m, has the axial force `k ξ f(s)`, N, and the energy `k ξ² ψ(s)`, J.

mod bilinear;
#[cfg(test)]
mod tests;

pub use bilinear::{Bilinear, BilinearError, Compression, History, Unloading};

/// Answer of a bond to a stretch, from its committed history; nothing is committed by asking.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// Force f.
    pub force: f64,
    /// `df/ds`; negative while the bond softens.
    pub tangent: f64,
    /// A slope that makes a quadratic majoriser of the energy at this stretch, >= 0.
    pub secant: f64,
    /// Incremental potential `∫ f ds` from the stretch of no force, along the way that dissipates: its derivative is the force.
    pub energy: f64,
}

/// The next stretches at which the slope of a piecewise linear law changes, and the slope in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Elastic slope.
    pub slope: f64,
    /// From this stretch on the bond flows in tension.
    pub upper: f64,
    /// Down from this stretch it flows in compression, or its elastic slope is another one.
    pub lower: f64,
    /// Whether it flows below `lower`.
    pub flows_below: bool,
    /// Up from this stretch, below `upper`, its elastic slope is another one.
    pub bend: f64,
}

/// Energies of a bond in a committed state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BondEnergy {
    /// What it gives back.
    pub stored: f64,
    /// What it does not.
    pub dissipated: f64,
}

/// A law of bonds with memory.
pub trait Law: Copy + Send + Sync + 'static {
    /// What a bond remembers; a virgin bond has the default.
    type History: Copy + Default + PartialEq + Send + Sync;

    /// Answer to a stretch.
    fn response(&self, stretch: f64, committed: &Self::History) -> Response;

    /// What the bond remembers after it has been stretched on.
    fn commit(&self, stretch: f64, committed: &Self::History) -> Self::History;

    /// Energies in a committed state.
    fn energies(&self, stretch: f64, committed: &Self::History) -> BondEnergy;

    /// The elastic piece around a stretch.
    fn piece(&self, stretch: f64, committed: &Self::History) -> Piece;

    /// Slope while the bond flows in tension, negative.
    fn softening_slope(&self) -> f64;

    /// Stretch from which a bond bears nothing for good if it flows in tension from now on.
    fn failure(&self, committed: &Self::History) -> f64;

    /// Energy per stretch that a bond dissipates while it softens.
    fn dissipation_rate(&self) -> f64;

    /// How far a bond has softened, 0 to 1.
    fn damage(&self, committed: &Self::History) -> f64;

    /// Whether a bond bears nothing for good.
    fn is_broken(&self, committed: &Self::History) -> bool;

    /// The history of a bond that bears nothing for good.
    fn broken(&self, committed: &Self::History) -> Self::History;
}
