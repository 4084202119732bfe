//! The models: what cases write of each, what it becomes, and what its results say of it.
//!
//! A model is a folder, its `keys` (what a case writes), `resolve` (the [`Material`] that they become, and why not) and `words`
//! (what the record of a run says of it), and one line of `models!`. From that line follow the key in cases and the schema,
//! the lists and starting cases of the command, and the tests that ask something of every model. Nothing else names a model.
//!
//! Models know nothing of cases and scenes: what they need of a case is in [`Asked`].

mod any_body;
mod asked;
mod axisymmetric;
mod beam_bond_orthotropic;
mod bond_antiplane;
mod bond_choice;
mod bond_plane;
mod bond_solid;
mod critical;
mod entry;
mod material;
mod material_summary;
mod mixture;
mod on;
mod plane_state;
mod plate_bending;
mod refusal;
mod sharing;
mod shell_membrane;
mod solid;
mod state_based;
mod state_plane;
mod state_solid;
mod timoshenko_beam;

pub use any_body::AnyBody;
pub(crate) use any_body::with_body;
pub use asked::{Asked, BodyKind, JoinedSides, Refused, USUAL_HORIZON_RATIO};
pub use axisymmetric::Axisymmetric;
pub use beam_bond_orthotropic::{LatticeRows, Orthotropic};
pub use bond_antiplane::Antiplane;
pub use bond_plane::{BilinearLaw, Plane, PlaneBondLaw};
pub use bond_solid::BondSolidKeys;
pub use critical::{Critical, CriticalFormula};
pub(crate) use critical::{foreign, needed};
pub use entry::{Entry, Growth, Start};
pub use material::{About, CriticalStretches, Material, SofteningBonds, Surface};
pub use material_summary::{Fact, MaterialSummary};
pub use mixture::{Mixture, OtherMaterial};
pub use on::{Fibres, HeldRegion, OnGround, OnLattice, Resolved};
pub use plane_state::PlaneState;
pub use plate_bending::Bending;
pub use refusal::{Place, Refusal};
pub use sharing::LoadSharing;
pub use shell_membrane::{HoopPressure, Pressure, Shell};
pub(crate) use state_based::admissible;
pub use state_plane::StatePlane;
pub use state_solid::StateSolidKeys;
pub use timoshenko_beam::{Beam, PowerLaw, Stiffness};

use crate::diagnostic::Faults;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;

/// The keys of a model of bodies that are more than lines, as a case writes them.
pub trait Keys: Debug + Send + Sync {
    /// They as the model of a case.
    fn model(&self) -> Model;

    /// Thickness.
    fn thickness(&self) -> f64;

    /// Whether bodies are solids.
    fn is_solid(&self) -> bool {
        false
    }

    /// Whether bodies are plates in bending, which have a scene of their own and no [`Material`].
    fn bends(&self) -> bool {
        false
    }

    /// Angle of the rows of the lattice from x, rad.
    fn lattice_angle(&self) -> f64 {
        0.0
    }

    /// Whether bodies can be listed points and meshes, too.
    fn takes_points(&self) -> bool {
        true
    }

    /// What bonds do beyond their elastic range.
    fn bond_law(&self) -> Option<&PlaneBondLaw> {
        None
    }

    /// Keys of a case that have no meaning for the model.
    fn refuses(&self) -> Vec<Refused> {
        Vec::new()
    }

    /// The model with the bonds that elastic bodies have by default.
    fn with_usual_bonds(&self) -> Model {
        self.model()
    }

    /// The material with its bonds, defaults filled in; the horizon ratio is to be set.
    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>>;
}

/// Makes the models of cases and their table: those of lines, then those of bodies in the plane.
macro_rules! models {
    (
        $(#[$about_lines:meta])* $lines:ident($lines_keys:ty) = $lines_module:ident,
        $($(#[$about:meta])* $variant:ident($keys:ty) = $module:ident,)+
    ) => {
        /// What the body is made of.
        #[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub enum Model {
            $(#[$about_lines])*
            $lines($lines_keys),
            $($(#[$about])* $variant($keys),)+
        }

        /// All models, in the order of lists.
        pub const TABLE: &[Entry] = &[$lines_module::ENTRY, $($module::ENTRY,)+];

        impl Model {
            /// What the command says of it.
            pub fn entry(&self) -> Entry {
                match self {
                    Self::$lines(_) => $lines_module::ENTRY,
                    $(Self::$variant(_) => $module::ENTRY,)+
                }
            }

            /// Its keys.
            ///
            /// # Errors
            /// Those of a beam.
            pub fn keys(&self) -> Result<&dyn Keys, &Beam> {
                match self {
                    Self::$lines(keys) => Err(keys),
                    $(Self::$variant(keys) => Ok(keys),)+
                }
            }
        }
    };
}

models! {
    /// Peridynamic Timoshenko beam: deflection, rotation and, where something moves along the axis, axial displacement.
    TimoshenkoBeam(Box<Beam>) = timoshenko_beam,
    /// Isotropic body in the plane of central bonds: displacements along x and y.
    BondPlane(Plane) = bond_plane,
    /// Orthotropic body in the plane of beam bonds: displacements along x and y, and rotations.
    BeamBondOrthotropic(Orthotropic) = beam_bond_orthotropic,
    /// Isotropic body in the plane of state-based families, any Poisson's ratio: displacements along x and y.
    StatePlane(StatePlane) = state_plane,
    /// Isotropic body of revolution of state-based families: displacements along the radius x and the axis y.
    Axisymmetric(Axisymmetric) = axisymmetric,
    /// Membrane of a cylindrical shell of central bonds: displacements along the axis, along the circumference and outwards.
    ShellMembrane(Shell) = shell_membrane,
    /// Isotropic plate of bonds in antiplane shear: displacements across the plane.
    BondAntiplane(Antiplane) = bond_antiplane,
    /// Isotropic plate in bending, with shear: deflections across the plane and two rotations.
    PlateBending(Bending) = plate_bending,
    /// Isotropic solid of central bonds: displacements along x, y and z.
    BondSolid(BondSolidKeys) = bond_solid,
    /// Isotropic solid of state-based families, any Poisson's ratio: displacements along x, y and z.
    StateSolid(StateSolidKeys) = state_solid,
}

impl Model {
    /// Its name in case files.
    pub fn name(&self) -> &'static str {
        self.entry().name
    }

    /// Whether its bonds soften.
    pub fn softens(&self) -> bool {
        self.keys().is_ok_and(|keys| keys.bond_law().is_some())
    }
}

/// A case to begin with, by its name.
pub fn start(name: &str) -> Option<&'static str> {
    starts().find(|start| start.name == name).map(|start| start.case)
}

/// All cases to begin with.
pub fn starts() -> impl Iterator<Item = Start> {
    TABLE.iter().flat_map(|entry| entry.starts).copied()
}

/// The models that hints name.
pub(crate) mod hints {
    /// For bodies in the plane, and their cracks.
    pub(crate) const PLANE: &str = "bond_plane";
    /// For bodies of several materials.
    const MIXTURES: [&str; 7] = [
        "bond_plane",
        "beam_bond_orthotropic",
        "bond_antiplane",
        "bond_solid",
        "state_plane",
        "axisymmetric",
        "state_solid",
    ];
    /// For bonds that soften.
    pub(crate) const SOFTENING: &str = "bond_plane";
    /// The models of bodies of several materials.
    pub(crate) fn mixtures() -> String {
        let [rest @ .., last] = MIXTURES.map(|name| format!("`{name}`"));
        format!("{} and {last}", rest.join(", "))
    }

    /// For thin cylinders.
    pub(crate) const SHELLS: &str = "shell_membrane";
    /// For bodies in space.
    pub(crate) const SOLIDS: [&str; 2] = ["bond_solid", "state_solid"];
    /// For plates in bending.
    pub(crate) const PLATES: &str = "plate_bending";
    /// For lines and frames.
    pub(crate) const LINES: &str = "timoshenko_beam";
}
