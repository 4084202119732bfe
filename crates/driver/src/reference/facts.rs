//! What a reference may know about a scene.

use std::fmt;

/// A scene as a reference sees it: one uniform straight beam. The driver fills this from the resolved scene,
/// and gives [`End::Other`] or [`Load::Other`] to whatever these types cannot say, so that no reference
/// mistakes the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// Length L of the one line, m.
    pub length: f64,
    /// Bending stiffness EI, N m².
    pub bending_stiffness: f64,
    /// Shear stiffness S = kappa G A, N.
    pub shear_stiffness: f64,
    /// Support of the left and of the right end.
    pub ends: [End; 2],
    /// Simple supports between the ends, m from the left end.
    pub interior_supports: Vec<f64>,
    /// All loads, a foundation under the beam among them.
    pub loads: Vec<Load>,
    /// Spacing of the points, m; that of a graded grid means nothing to a reference.
    pub spacing: f64,
    /// Whether all points of the line are one spacing apart.
    pub uniform_grid: bool,
    /// Horizon, m.
    pub horizon: f64,
    /// Bonds of 1, 2, … m spacings.
    pub bonds: Vec<BondClass>,
    /// Whether the beam goes on as its image behind each end.
    pub image_ends: bool,
    /// Whether a load per length acts as load times spacing on each point.
    pub lumped_loads: bool,
    /// Whether every bond has the shear stiffness of the beam, as the model was published.
    pub published_law: bool,
}

/// The bonds of one length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondClass {
    /// Weight alpha_n, dimensionless; the sum of n alpha_n is 1.
    pub weight: f64,
    /// Shear stiffness S_n of the bond law, N.
    pub shear_stiffness: f64,
}

/// How an end of the beam is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// w = 0 and phi = 0.
    Clamped,
    /// w = 0.
    Simple,
    /// phi = 0.
    Guided,
    /// Not held.
    Free,
    /// Sprung, moved or held in another way.
    Other,
}

/// A load, positive along +w or +phi. Positions are m from the left end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// A point force.
    Force {
        /// Where, m.
        x: f64,
        /// N.
        value: f64,
    },
    /// A point moment.
    Moment {
        /// Where, m.
        x: f64,
        /// N m.
        value: f64,
    },
    /// A constant force per length over the whole beam.
    Uniform {
        /// N/m.
        value: f64,
    },
    /// A constant moment per length over the whole beam.
    UniformMoment {
        /// N m/m.
        value: f64,
    },
    /// q0 sin(n pi x / L) over the whole beam.
    Sine {
        /// q0, N/m.
        amplitude: f64,
        /// n.
        half_waves: u32,
    },
    /// A Winkler foundation under the whole beam, which pushes back with stiffness times w per length.
    Foundation {
        /// k_f, N/m².
        stiffness: f64,
    },
    /// Any other load.
    Other,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Clamped => "a clamped end",
            Self::Simple => "a simple support",
            Self::Guided => "a guided end",
            Self::Free => "a free end",
            Self::Other => "a sprung, moved or otherwise held end",
        })
    }
}

impl fmt::Display for Load {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Force { x, .. } => write!(f, "a force at x = {x}"),
            Self::Moment { x, .. } => write!(f, "a moment at x = {x}"),
            Self::Uniform { .. } => f.write_str("a uniform load"),
            Self::UniformMoment { .. } => f.write_str("a uniform moment load"),
            Self::Sine { .. } => f.write_str("a sine load"),
            Self::Foundation { .. } => f.write_str("a foundation"),
            Self::Other => f.write_str("another kind of load"),
        }
    }
}
