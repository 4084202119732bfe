//! The material of a body with its bonds: what a model makes of its keys.

use super::{
    AnyBody, Asked, Critical, Fibres, HoopPressure, MaterialSummary, Model, OnGround, OnLattice, Pressure,
    Refusal, Resolved, USUAL_HORIZON_RATIO, hints,
};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::{Cell, Cloud, Outline, SquareLattice};
use peristat_assembly::law::Bilinear;
use peristat_assembly::model::plane::toughness::CrossingBonds;
use peristat_assembly::model::plane::{Calibration, CriticalStretch, Edges, Mirrors, has_border};
use peristat_assembly::stiffness::Kinematics;
use std::f64::consts::TAU;
use std::fmt::Debug;

/// What the plane of a body stands for, if it is in one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// A plate or a slice.
    Flat,
    /// Half of a section of a body of revolution: x is the radius, y the axis.
    Section,
    /// The developed surface of a cylinder of this radius, m: x is the axis, y the arc.
    Cylinder(f64),
    /// Nothing: the body is a solid.
    Solid,
}

impl Surface {
    /// The side of its lattice that is an axis of revolution, by number: the lower one along x of a section.
    pub fn axis(self) -> Option<usize> {
        (self == Self::Section).then_some(0)
    }

    /// Components of a force that have a resultant: a ring has none along its radius, and no moment.
    pub fn resultant(self) -> [bool; 3] {
        if self == Self::Section { [false, true, false] } else { [true; 3] }
    }
}

/// What is known of a material and its bonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct About {
    /// Name of the model in case files.
    pub name: &'static str,
    /// The unknowns of a point by name.
    pub components: &'static [&'static str],
    /// What the plane stands for.
    pub surface: Surface,
    /// Thickness.
    pub thickness: f64,
    /// Horizon per spacing.
    pub horizon_ratio: f64,
    /// Where the stiffness of bonds comes from.
    pub calibration: Calibration,
    /// What is done about the bonds that points near edges lack, where it is one of these.
    pub edges: Option<Edges>,
    /// Whether points at edges have the stiffness of those inside for every uniform strain; then cells that a border cuts
    /// have their own areas.
    pub is_exact_at_edges: bool,
    /// Whether nothing was asked of edges, and bonds end on the border only where it cuts cells.
    pub ends_where_cut: bool,
    /// Whether points feel the families of their neighbours, so that they are joined over two horizons.
    pub has_families: bool,
    /// How far beyond the horizon the outermost neighbours may be, in spacings: some of them lie inside it in part only.
    pub partial_neighbours: f64,
}

/// Stretches at which bonds break.
#[derive(Clone, Debug)]
pub struct CriticalStretches {
    /// By offset.
    pub by_offset: CriticalStretch,
    /// Per offset, whether its bonds lie along the fibres; empty if there are none.
    pub fibres: Vec<bool>,
}

impl CriticalStretches {
    /// One for all of some offsets; bonds of listed points have it, too.
    pub(super) fn alike(stretch: f64, offsets: Option<&[Cell]>) -> Self {
        let count = offsets.map_or(1, <[Cell]>::len);
        Self { by_offset: CriticalStretch::new(vec![stretch; count]), fibres: Vec::new() }
    }
}

/// Bonds that yield and soften.
#[derive(Clone, Copy, Debug)]
pub struct SofteningBonds {
    /// Their law.
    pub law: Bilinear,
    /// Which elongation a displacement gives them.
    pub kinematics: Kinematics,
    /// Energy of a crack one spacing long, J.
    pub crack_energy: f64,
}

/// A material and its bonds on bodies in the plane.
pub trait Material: Debug + Send + Sync {
    /// What is known of it.
    fn about(&self) -> About;

    /// The keys that give it, with the defaults that it took.
    fn keys(&self) -> Model;

    /// Horizon per spacing of a case that gives none.
    fn usual_horizon_ratio(&self) -> f64 {
        USUAL_HORIZON_RATIO
    }

    /// The same by itself.
    fn boxed(&self) -> Box<dyn Material>;

    /// Young's moduli, by the keys that give them.
    fn youngs_moduli(&self) -> Vec<(&'static str, f64)>;

    /// Keys that materials of regions can give, with their values in the base material; else why there are none, and what to do
    /// about it.
    ///
    /// # Errors
    /// The reason and a hint.
    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        let hint = format!("several materials are known to the models {}", hints::mixtures());
        Err(("bodies of this model have one material", hint))
    }

    /// Takes another horizon per spacing.
    fn set_horizon_ratio(&mut self, horizon_ratio: f64);

    /// Takes a lattice whose rows run at an angle to x, rad.
    fn set_lattice_angle(&mut self, _angle: f64) {}

    /// Takes other edges where bonds would end on the border.
    fn leave_border(&mut self, edges: Edges);

    /// Takes the hoop away: what the bonds of a straight edge are.
    fn unroll(&mut self) {}

    /// Whether bonds can end on the border of a lattice.
    fn has_border(&self, lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
        has_border(lattice, mirrors, self.about().horizon_ratio as i32)
    }

    /// Why a border that cuts cells is not followed beside lines of symmetry, and what to do about it, where it could be elsewhere.
    fn leaves_cut_border(&self, _mirrors: &Mirrors) -> Option<(&'static str, &'static str)> {
        None
    }

    /// Offsets to the neighbours of a point on a lattice.
    ///
    /// # Errors
    /// [`Refusal`].
    fn offsets(&self) -> Result<Vec<Cell>, Refusal>;

    /// Rows or columns of images that a lattice needs beyond a line of symmetry.
    ///
    /// # Errors
    /// [`Refusal`].
    fn depth(&self) -> Result<i32, Refusal>;

    /// A body on the cells of a lattice.
    ///
    /// # Errors
    /// [`Refusal`].
    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal>;

    /// A body of listed points with a horizon, m; `cut` tells whether something separates two positions.
    ///
    /// # Errors
    /// [`Refusal`].
    fn on_points(
        &self,
        _cloud: &Cloud,
        _horizon: f64,
        _cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<AnyBody, Refusal> {
        Err(Refusal::needs_lattice(self.about().name))
    }

    /// Whether a developed cylinder on a lattice of real cells ends on the border of both of its ends, not at its points.
    fn ends_on_border(&self, _real: &SquareLattice) -> bool {
        false
    }

    /// The strain along x, 0, or y, 1, by the stresses `[σ_xx, σ_yy, σ_xy]`, times some modulus; in a body of revolution with
    /// a hoop stress of σ_xx.
    fn strain_row(&self, axis: usize) -> [f64; 3];

    /// Whether nothing moves across the plane, so that there is a stress; in a body of revolution it is the hoop stress.
    fn holds_across(&self) -> bool {
        false
    }

    /// Why strains that need no stress in it would have some all the same, where they would.
    fn resists_eigenstrain(&self) -> Option<&'static str> {
        None
    }

    /// Whether points share the changes of volume of blocks: where strains vary, stresses alternate from point to point.
    fn shares_dilatations(&self) -> bool {
        false
    }

    /// Directions of the material, where they are not alike.
    fn fibres(&self) -> Option<Fibres> {
        None
    }

    /// Whether the body touches an axis that it turns about; faults of a body that the model cannot have, and `None` where it
    /// cannot be made.
    fn touches_axis(
        &self,
        _asked: &Asked,
        _body: (Option<&Outline>, Option<&SquareLattice>),
        _faults: &mut Faults,
    ) -> Option<bool> {
        Some(false)
    }

    /// Stretches at which bonds break, with the defaults of `given` filled in; `path` is where they are given.
    fn critical(
        &self,
        given: &mut Critical,
        on: &OnGround,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<CriticalStretches>;

    /// The bonds that a crack along an interface between rows cuts; none where bodies of several materials do not break.
    fn crossing_bonds(&self) -> Option<CrossingBonds> {
        None
    }

    /// Bonds that soften by the law in the keys.
    fn soften(&self, _on: &OnGround, _faults: &mut Faults) -> Option<SofteningBonds> {
        None
    }

    /// What a pressure on a whole cylinder is; none on other bodies.
    fn pressure(
        &self,
        _load: &Pressure,
        _lattice: &SquareLattice,
        _mirrors: &Mirrors,
        _path: &JsonPath,
        _faults: &mut Faults,
    ) -> Option<HoopPressure> {
        None
    }

    /// Adds a fault for every load that the body cannot bear. `held` are points with the direction along which they are held,
    /// `loads` places in the case with the forces there.
    fn check_bearable(
        &self,
        _on: &Resolved,
        _held: &mut dyn Iterator<Item = (&[u32], [f64; 3])>,
        _loads: &mut dyn Iterator<Item = (JsonPath, Vec<f64>)>,
        _faults: &mut Faults,
    ) {
    }

    /// Adds the doubts about a body that can be solved.
    fn warn(&self, _on: &Resolved, _faults: &mut Faults) {}

    /// What the record of a run says of it; `ghosts` is the number of points outside that follow those inside.
    fn summary(&self, on: &Resolved, ghosts: usize, units: Units) -> MaterialSummary;
}

impl Clone for Box<dyn Material> {
    fn clone(&self) -> Self {
        self.boxed()
    }
}

impl dyn Material + '_ {
    /// Whether points have an unknown.
    pub fn has(&self, component: &str) -> bool {
        self.about().components.contains(&component)
    }

    /// What the plane of the body stands for.
    pub fn surface(&self) -> Surface {
        self.about().surface
    }

    /// Radius of the cylinder whose developed surface the plane is, m.
    pub fn cylinder_radius(&self) -> Option<f64> {
        match self.surface() {
            Surface::Cylinder(radius) => Some(radius),
            Surface::Flat | Surface::Section | Surface::Solid => None,
        }
    }

    /// Length of the body across the plane at a position, m: the thickness, or the way round the axis.
    pub fn across(&self, [x, _]: [f64; 2]) -> f64 {
        if self.surface() == Surface::Section { TAU * x } else { self.about().thickness }
    }
}

/// The strain along an axis of an isotropic material by the stresses, times Young's modulus.
pub(super) fn isotropic_strain(axis: usize, poisson_ratio: f64) -> [f64; 3] {
    if axis == 0 { [1.0, -poisson_ratio, 0.0] } else { [-poisson_ratio, 1.0, 0.0] }
}
