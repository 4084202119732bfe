//! The models of bodies in the plane: what they are made of.

mod body;

pub use body::PlaneModelError;

use super::super::Resultant;
use super::orthotropic;
use peristat_assembly::model::beam_bond_orthotropic::OrthotropicParameters;
use peristat_assembly::model::bond_plane::{PlaneParameters, VolumeFactor};
use peristat_assembly::model::plane::{Calibration, Edges};
use peristat_assembly::model::shell_membrane::ShellParameters;
use peristat_assembly::model::state_based::{Geometry, StateEdges, StateParameters};
use std::f64::consts::TAU;

/// Material and bonds of a body in the plane.
#[derive(Clone, Copy, Debug)]
pub enum PlaneBonds {
    /// Central bonds.
    Central(PlaneParameters),
    /// Beam bonds on a lattice.
    Beams(OrthotropicParameters),
    /// State-based families on a lattice.
    State(StateParameters),
    /// Bonds of a developed cylinder.
    Shell(ShellParameters),
}

impl PlaneBonds {
    /// Name of the model in case files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Central(_) => "bond_plane",
            Self::Beams(_) => "beam_bond_orthotropic",
            Self::State(parameters) if parameters.is_axisymmetric() => "axisymmetric",
            Self::State(_) => "state_plane",
            Self::Shell(_) => "shell_membrane",
        }
    }

    /// Whether points have an unknown of a name beside `ux` and `uy`.
    pub fn has(&self, component: &str) -> bool {
        match self {
            Self::Central(_) | Self::State(_) => false,
            Self::Beams(_) => component == "phi",
            Self::Shell(_) => component == "w",
        }
    }

    /// The same on a lattice whose rows run at an angle to x, rad.
    pub fn with_lattice_angle(self, lattice_angle: f64) -> Self {
        match self {
            Self::Central(_) | Self::State(_) | Self::Shell(_) => self,
            Self::Beams(parameters) => Self::Beams(OrthotropicParameters { lattice_angle, ..parameters }),
        }
    }

    /// Horizon per spacing of a case that gives none.
    pub(super) fn usual_horizon_ratio(&self) -> f64 {
        match self {
            Self::Central(_) | Self::State(_) | Self::Shell(_) => 3.0,
            Self::Beams(parameters) => orthotropic::horizon_ratio(parameters),
        }
    }

    /// Horizon per spacing.
    pub fn horizon_ratio(&self) -> f64 {
        match self {
            Self::Central(parameters) => parameters.horizon_ratio,
            Self::Beams(parameters) => parameters.horizon_ratio,
            Self::State(parameters) => parameters.horizon_ratio,
            Self::Shell(parameters) => parameters.horizon_ratio,
        }
    }

    /// The same with another horizon.
    pub fn with_horizon_ratio(self, horizon_ratio: f64) -> Self {
        match self {
            Self::Central(parameters) => Self::Central(PlaneParameters { horizon_ratio, ..parameters }),
            Self::Beams(parameters) => Self::Beams(OrthotropicParameters { horizon_ratio, ..parameters }),
            Self::State(parameters) => Self::State(StateParameters { horizon_ratio, ..parameters }),
            Self::Shell(parameters) => Self::Shell(ShellParameters { horizon_ratio, ..parameters }),
        }
    }

    /// The same with other edges where bonds would end on the border.
    pub(super) fn without_border(self, edges: Edges) -> Self {
        match self {
            Self::Central(parameters) if parameters.edges == Edges::Border => {
                Self::Central(PlaneParameters { edges, ..parameters })
            }
            Self::Beams(parameters) if parameters.edges == Edges::Border => {
                Self::Beams(OrthotropicParameters { edges, ..parameters })
            }
            Self::State(parameters) if parameters.edges == StateEdges::Border => {
                Self::State(StateParameters { edges: StateEdges::Ghosts, ..parameters })
            }
            other => other,
        }
    }

    /// Treatment of edges; families have another one.
    pub fn edges(&self) -> Option<Edges> {
        match self {
            Self::Central(parameters) => Some(parameters.edges),
            Self::Beams(parameters) => Some(parameters.edges),
            Self::State(parameters) => (parameters.edges == StateEdges::Border).then_some(Edges::Border),
            // Every point has weights of its own.
            Self::Shell(_) => None,
        }
    }

    /// Whether points at edges have the stiffness of those inside for every uniform strain; then cells that a border cuts
    /// have their own areas.
    pub(super) fn is_exact_at_edges(&self) -> bool {
        match self {
            Self::Central(parameters) => parameters.edges.is_exact(),
            Self::Beams(parameters) => parameters.edges.is_exact(),
            Self::State(_) => self.calibration() == Calibration::Matched,
            // Their ends are where their points are.
            Self::Shell(_) => false,
        }
    }

    /// Where the stiffness of bonds comes from.
    pub fn calibration(&self) -> Calibration {
        match self {
            Self::Central(parameters) => parameters.calibration,
            Self::Beams(parameters) => parameters.calibration,
            Self::State(parameters) => match parameters.edges {
                StateEdges::Calibrated | StateEdges::None => Calibration::Published,
                StateEdges::Border | StateEdges::Ghosts | StateEdges::Moment | StateEdges::MomentPlus => {
                    Calibration::Matched
                }
            },
            Self::Shell(parameters) => parameters.calibration,
        }
    }

    /// Thickness.
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Central(parameters) => parameters.material.thickness,
            Self::Beams(parameters) => parameters.material.thickness,
            Self::State(parameters) => match parameters.geometry {
                Geometry::PlaneStress(thickness) | Geometry::PlaneStrain(thickness) => thickness,
                Geometry::Axisymmetric => 1.0,
            },
            Self::Shell(parameters) => parameters.thickness,
        }
    }

    /// Length of the body across the plane at a position, m: the thickness, or the way round the axis.
    pub fn across(&self, [x, _]: [f64; 2]) -> f64 {
        if self.is_revolved() { TAU * x } else { self.thickness() }
    }

    /// Adds a force, N, at a position to a resultant: what a shell has along its circumference turns it about its axis.
    pub(super) fn add_force(&self, to: &mut Resultant, force: [f64; 2], at: [f64; 2]) {
        match self {
            Self::Shell(shell) => {
                to.add([force[0], 0.0], [0.0; 2]);
                to.add_moment(shell.radius * force[1]);
            }
            _ => to.add(force, at),
        }
    }

    /// Whether the plane is a section of a body of revolution.
    pub fn is_revolved(&self) -> bool {
        matches!(self, Self::State(parameters) if parameters.is_axisymmetric())
    }

    /// The strain along x, 0, or y, 1, by the stresses `[σ_xx, σ_yy, σ_xy]`, times some modulus; in a body of revolution with
    /// a hoop stress of σ_xx.
    pub(super) fn strain_row(&self, axis: usize) -> [f64; 3] {
        let isotropic = |ratio: f64| if axis == 0 { [1.0, -ratio, 0.0] } else { [-ratio, 1.0, 0.0] };
        match self {
            Self::Central(_) | Self::Shell(_) => isotropic(1.0 / 3.0),
            Self::Beams(of) => {
                let row = of.material.compliance_at(of.fibre_angle)[axis];
                row.map(|c| c / row[axis])
            }
            Self::State(of) => {
                let nu = of.poisson_ratio;
                match (of.geometry, axis) {
                    (Geometry::PlaneStress(_), _) => isotropic(nu),
                    (Geometry::PlaneStrain(_), _) => isotropic(nu / (1.0 - nu)),
                    (Geometry::Axisymmetric, 0) => [1.0 - nu, -nu, 0.0],
                    (Geometry::Axisymmetric, _) => isotropic(2.0 * nu),
                }
            }
        }
    }

    /// The same material without a hoop: what the bonds of a straight edge are.
    pub(super) fn unrolled(self) -> Self {
        match self {
            Self::State(parameters) if parameters.is_axisymmetric() => {
                Self::State(StateParameters { geometry: Geometry::PlaneStrain(1.0), ..parameters })
            }
            other => other,
        }
    }

    /// Young's moduli, by the keys that give them.
    pub fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Central(parameters) => vec![("youngs_modulus", parameters.material.youngs_modulus)],
            Self::Beams(OrthotropicParameters { material, .. }) => vec![
                ("youngs_modulus_1", material.youngs_modulus_1),
                ("youngs_modulus_2", material.youngs_modulus_2),
            ],
            Self::State(parameters) => vec![("youngs_modulus", parameters.youngs_modulus)],
            Self::Shell(parameters) => vec![("youngs_modulus", parameters.youngs_modulus)],
        }
    }

    /// Radius of the cylinder whose developed surface the plane is, m; flat bodies and sections have none.
    pub fn cylinder_radius(&self) -> Option<f64> {
        match self {
            Self::Shell(shell) => Some(shell.radius),
            Self::Central(_) | Self::Beams(_) | Self::State(_) => None,
        }
    }

    /// Whether points feel the families of their neighbours, so that they are joined over two horizons.
    pub(crate) fn has_families(&self) -> bool {
        matches!(self, Self::State(_))
    }

    /// How far beyond the horizon the outermost neighbours may be, in spacings: some of them lie inside it in part only.
    pub(crate) fn partial_neighbours(&self) -> f64 {
        match self {
            Self::Central(of) if of.calibration == Calibration::Published => match of.volume_factor {
                VolumeFactor::Ramp | VolumeFactor::Area => 0.5,
                _ => 0.0,
            },
            _ => 0.0,
        }
    }
}
