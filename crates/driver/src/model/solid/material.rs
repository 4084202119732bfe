//! The bonds of solids on bodies.

use super::super::{
    About, AnyBody, Critical, CriticalStretches, Material, MaterialSummary, Model, OnGround, OnLattice,
    Refusal, Resolved, Surface,
};
use super::critical;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::units::Units;
use peristat_assembly::body::{Cell, Cloud, SquareLattice};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::toughness::CrossingBonds;
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
use peristat_assembly::model::solid::toughness::crossing_bonds;
use peristat_assembly::model::solid::{Solid, SolidEdges, SolidMaterial, SolidModel};
use std::fmt::Debug;
use std::sync::Arc;

/// What a model of solids has of its own.
pub(in super::super) trait SolidParameters: SolidMaterial {
    /// Its keys.
    type Keys: Clone + Debug + Send + Sync + 'static;
    /// Its name in case files.
    const NAME: &'static str;
    /// Whether points feel the families of their neighbours.
    const HAS_FAMILIES: bool;

    /// Keys with the edges that were taken, as the model of a case.
    fn model(&self, keys: Self::Keys, edges: SolidEdges) -> Model;

    /// Young's modulus.
    fn youngs_modulus(&self) -> f64;

    /// Bulk modulus.
    fn bulk_modulus(&self) -> f64;

    /// Shear modulus.
    fn shear_modulus(&self) -> f64;

    /// How the stiffness of bonds depends on their length.
    fn influence(&self) -> Influence;

    /// Horizon per spacing.
    fn horizon_ratio(&mut self) -> &mut f64;

    /// What is done about faces.
    fn edges(&mut self) -> &mut SolidEdges;

    /// Where the stiffness comes from.
    fn calibration(&self) -> Calibration;

    /// Listed points with a horizon, m, and what separates two positions.
    ///
    /// # Errors
    /// [`Refusal`]: it needs a lattice, if it does not say else.
    fn on_points(
        &self,
        _cloud: &Cloud,
        _horizon: f64,
        _cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<AnyBody, Refusal> {
        Err(Refusal::needs_lattice(Self::NAME))
    }

    /// What the record of a run says of it.
    fn summary(&self, units: Units) -> MaterialSummary;
}

/// Bonds of a solid, and the keys that they come from.
#[derive(Clone, Debug)]
pub(in super::super) struct SolidBonds<P: SolidParameters> {
    pub(in super::super) keys: P::Keys,
    pub(in super::super) parameters: P,
    pub(in super::super) usual_horizon_ratio: f64,
}

impl<P: SolidParameters> SolidBonds<P> {
    fn edges(&self) -> SolidEdges {
        let mut parameters = self.parameters;
        *parameters.edges()
    }
}

/// Spacings per horizon up to which families beside faces are stretched as those inside, to a half of a per cent.
const WELL_STRETCHED: f64 = 2.0 + 1e-9;

/// Bulk over shear modulus from which stresses are doubtful: a Poisson's ratio of 0.48.
const DOUBTFUL: f64 = 24.0;
/// Error of the stresses of a bar that is bent, eight cells high, per bulk over shear modulus; of the largest stress.
const ERROR: f64 = 0.00174;

impl<P: SolidParameters> SolidBonds<P> {
    /// Adds a warning where bonds at faces reach farther than they are stretched alike.
    fn warn_of_first_breaks(&self, faults: &mut Faults) {
        let About { horizon_ratio, name, .. } = self.about();
        if horizon_ratio > WELL_STRETCHED {
            faults
                .warning(
                    root("fracture"),
                    "bonds beside faces are stretched farther than those inside: under one stress the first one breaks 11 % early with three spacings per horizon, 31 % with four",
                )
                .hint(format!("leave `horizon_ratio` out: with two spacings it is 0.5 %, and with {name} a longer reach brings little"));
        }
    }

    /// Adds a warning where the material hardly changes its volume.
    fn warn_of_volumes(&self, solid: &dyn SolidModel, faults: &mut Faults) {
        let stiffness = solid.stiffness();
        let (lame, shear) = (stiffness[0][1], stiffness[3][3]);
        let bulk_per_shear = lame / shear + 2.0 / 3.0;
        if bulk_per_shear < DOUBTFUL {
            return;
        }
        let percent = 100.0 * ERROR * bulk_per_shear;
        faults
            .warning(
                root("model").key(self.about().name).key("poisson_ratio"),
                format!(
                    "the material hardly changes its volume: in a bar that is bent, eight cells high, stresses are off by {percent:.0} % of the largest"
                ),
            )
            .hint("half the spacing leaves a fourth of that; displacements are better");
    }
}

impl<P: SolidParameters> Material for SolidBonds<P> {
    fn about(&self) -> About {
        let mut of = self.parameters;
        let edges = *of.edges();
        About {
            name: P::NAME,
            components: &["ux", "uy", "uz"],
            surface: Surface::Solid,
            thickness: 1.0,
            horizon_ratio: *of.horizon_ratio(),
            calibration: of.calibration(),
            edges: Some(match edges {
                SolidEdges::Border => Edges::Border,
                SolidEdges::Overlay => Edges::Overlay,
                SolidEdges::None => Edges::None,
            }),
            is_exact_at_edges: edges.is_exact(),
            ends_where_cut: false,
            has_families: P::HAS_FAMILIES,
            partial_neighbours: 0.0,
        }
    }

    fn keys(&self) -> Model {
        self.parameters.model(self.keys.clone(), self.edges())
    }

    fn usual_horizon_ratio(&self) -> f64 {
        self.usual_horizon_ratio
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        vec![("youngs_modulus", self.parameters.youngs_modulus())]
    }

    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        if self.edges() == SolidEdges::Border {
            return Ok(self.youngs_moduli());
        }
        Err(("several materials need the edges `border`", "leave out `edges` and `calibration`".into()))
    }

    fn set_horizon_ratio(&mut self, horizon_ratio: f64) {
        *self.parameters.horizon_ratio() = horizon_ratio;
    }

    fn leave_border(&mut self, edges: Edges) {
        if self.edges() == SolidEdges::Border {
            *self.parameters.edges() =
                if edges == Edges::None { SolidEdges::None } else { SolidEdges::Overlay };
        }
    }

    /// The body itself finds out whether bonds can end on its border.
    fn has_border(&self, _lattice: &SquareLattice, _mirrors: &Mirrors) -> bool {
        true
    }

    fn offsets(&self) -> Result<Vec<Cell>, Refusal> {
        Ok(Solid::offsets(&self.parameters)?)
    }

    fn depth(&self) -> Result<i32, Refusal> {
        Ok(Solid::depth(&self.parameters)?)
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let lattice = Arc::new(on.mirrors.extended(on.real, self.depth()?));
        let cuts = (on.cuts)(&lattice, &self.offsets()?);
        let factors = on.materials.on_images(&lattice, (on.real, &on.mirrors));
        Ok(AnyBody::Three(Box::new(Solid::mixed(lattice, on.mirrors, self.parameters, &cuts, factors)?)))
    }

    fn on_points(
        &self,
        cloud: &Cloud,
        horizon: f64,
        cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<AnyBody, Refusal> {
        self.parameters.on_points(cloud, horizon, cut)
    }

    fn resists_eigenstrain(&self) -> Option<&'static str> {
        (P::HAS_FAMILIES && !self.edges().is_exact())
            .then_some("families that faces leave incomplete would resist a strain that needs no stress")
    }

    fn strain_row(&self, _axis: usize) -> [f64; 3] {
        [0.0; 3]
    }

    fn critical(
        &self,
        given: &mut Critical,
        on: &OnGround,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<CriticalStretches> {
        if P::HAS_FAMILIES && self.edges() == SolidEdges::Border {
            self.warn_of_first_breaks(faults);
        }
        critical::stretches(given, self.parameters, on, path, faults)
    }

    /// None where points feel changes of volume: tetrahedra beside interfaces would keep theirs across a crack.
    fn crossing_bonds(&self) -> Option<CrossingBonds> {
        if P::HAS_FAMILIES { None } else { crossing_bonds(&self.parameters).ok() }
    }

    fn warn(&self, on: &Resolved, faults: &mut Faults) {
        let made = on.model.as_solid().map(|solid| solid.faces());
        // Listed points have no border where bonds could end.
        let lacks_border = on.lattice.is_some() && made != Some(SolidEdges::Border);
        if self.edges() == SolidEdges::Border && lacks_border {
            faults
                .warning(
                    root("model").key(self.about().name).key("edges"),
                    "parts of this body are one cell thick, so that no bonds end on its border: tetrahedra complete its points, and stresses beside loaded edges are wrong by tenths",
                )
                .hint("use a smaller spacing: two cells are enough");
        }
        if let Some(solid) = on.model.as_solid() {
            self.warn_of_volumes(solid, faults);
        }
    }

    fn summary(&self, _: &Resolved, _: usize, units: Units) -> MaterialSummary {
        self.parameters.summary(units)
    }
}
