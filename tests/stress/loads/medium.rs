//! The models in the plane that bear tractions on all their edges.

use super::asked::Across;
use serde_json::{Value, json};

/// Mass per volume.
pub(super) const DENSITY: f64 = 0.5;

/// A model as a case writes it.
#[derive(Clone, Debug)]
pub(super) struct Medium {
    pub(super) model: &'static str,
    /// What is chosen of it.
    pub(super) name: &'static str,
    pub(super) keys: Value,
    pub(super) across: Across,
    /// Whether the rows of the lattice run along its fibres.
    pub(super) is_turned: bool,
    /// Whether mirrors along x and y leave it as it is.
    pub(super) is_symmetric: bool,
    /// Inner radius of a body of revolution, spacings.
    pub(super) inner: f64,
}

const THICKNESS: f64 = 2.0;

impl Medium {
    fn new(model: &'static str, name: &'static str, keys: Value) -> Self {
        Self {
            model,
            name,
            keys,
            across: Across::Thickness(THICKNESS),
            is_turned: false,
            is_symmetric: true,
            inner: 2.0,
        }
    }

    fn fibres(name: &'static str, degrees: f64, is_turned: bool) -> Self {
        let keys = json!({
            "youngs_modulus_1": 105_000.0, "youngs_modulus_2": 8400.0, "poisson_ratio_12": 0.32, "shear_modulus_12": 4000.0,
            "thickness": THICKNESS, "fibre_angle": degrees, "lattice": if is_turned { "fibre" } else { "axes" }
        });
        Self { is_turned, is_symmetric: degrees == 0.0, ..Self::new("beam_bond_orthotropic", name, keys) }
    }

    fn revolved(name: &'static str, inner: f64, poisson_ratio: f64) -> Self {
        let keys = json!({ "youngs_modulus": 70_000.0, "poisson_ratio": poisson_ratio });
        Self { across: Across::Ring, inner, ..Self::new("axisymmetric", name, keys) }
    }

    /// Whether it is of revolution.
    pub(super) fn is_revolved(&self) -> bool {
        self.across == Across::Ring
    }

    /// Whether its points turn.
    pub(super) fn turns(&self) -> bool {
        self.model == "beam_bond_orthotropic"
    }

    /// The start of a case.
    pub(super) fn case(&self, body: &Value) -> Value {
        json!({ "model": { self.model: self.keys }, "density": DENSITY, "body": body, "supports": [], "rigid": [], "loads": [] })
    }
}

/// All of them.
pub(super) fn media() -> Vec<Medium> {
    let plane = |state: &str| json!({ "youngs_modulus": 70_000.0, "state": state, "thickness": THICKNESS });
    let state = |state: &str, nu: f64| {
        let mut keys = plane(state);
        keys["poisson_ratio"] = json!(nu);
        keys
    };
    let mut published = plane("plane_stress");
    published["calibration"] = json!("published");
    vec![
        Medium::new("bond_plane", "plane stress", plane("plane_stress")),
        Medium::new("bond_plane", "plane strain", plane("plane_strain")),
        Medium::new("bond_plane", "published", published),
        Medium::new("state_plane", "plane stress", state("plane_stress", 0.3)),
        Medium::new("state_plane", "plane strain, nu = 0.49", state("plane_strain", 0.49)),
        Medium::fibres("fibres at 0°", 0.0, false),
        Medium::fibres("fibres at 30°", 30.0, false),
        Medium::fibres("fibres at 45°", 45.0, false),
        Medium::fibres("rows along fibres at 30°", 30.0, true),
        Medium::revolved("ring", 4.0, 0.3),
        Medium::revolved("about its axis", 0.0, 0.3),
        Medium::revolved("ring, nu = 0.499", 4.0, 0.499),
    ]
}
