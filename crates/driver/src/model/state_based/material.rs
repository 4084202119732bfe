//! State-based families on bodies.

use super::super::material::isotropic_strain;
use super::super::{
    About, AnyBody, Asked, Critical, CriticalStretches, Material, MaterialSummary, Model, OnGround,
    OnLattice, OtherMaterial, Refusal, Resolved, Surface,
};
use super::{Families, critical, section, warn, words};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::{Cell, Outline, SquareLattice};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
use peristat_assembly::model::state_based::{
    BorderedState, Dilatation, Geometry, StateBased, StateEdges, StateMaterials, StateParameters,
};
use std::fmt::Debug;
use std::sync::Arc;

impl<K: Clone + Debug + Send + Sync + 'static> Material for Families<K> {
    fn about(&self) -> About {
        let of = &self.parameters;
        let (surface, thickness) = match of.geometry {
            Geometry::PlaneStress(thickness) | Geometry::PlaneStrain(thickness) => (Surface::Flat, thickness),
            Geometry::Axisymmetric => (Surface::Section, 1.0),
        };
        let calibration = calibration(of.edges);
        About {
            name: self.name,
            components: &["ux", "uy"],
            surface,
            thickness,
            horizon_ratio: of.horizon_ratio,
            calibration,
            edges: (of.edges == StateEdges::Border).then_some(Edges::Border),
            is_exact_at_edges: calibration == Calibration::Matched,
            ends_where_cut: self.ends_where_cut,
            has_families: true,
            partial_neighbours: 0.0,
        }
    }

    fn keys(&self) -> Model {
        (self.filled)(&self.parameters, &self.keys)
    }

    fn usual_horizon_ratio(&self) -> f64 {
        self.usual_horizon_ratio
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        vec![("youngs_modulus", self.parameters.youngs_modulus)]
    }

    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        if self.parameters.edges == StateEdges::Ghosts {
            let of = &self.parameters;
            return Ok(vec![("youngs_modulus", of.youngs_modulus), ("poisson_ratio", of.poisson_ratio)]);
        }
        Err(("families of several materials need the edges `ghosts`", "leave out `edges`".into()))
    }

    fn set_horizon_ratio(&mut self, horizon_ratio: f64) {
        self.parameters.horizon_ratio = horizon_ratio;
    }

    fn leave_border(&mut self, _: Edges) {
        if self.parameters.edges == StateEdges::Border {
            self.parameters.edges = StateEdges::Ghosts;
        }
    }

    fn unroll(&mut self) {
        if self.parameters.is_axisymmetric() {
            self.parameters.geometry = Geometry::PlaneStrain(1.0);
        }
    }

    /// Where a hole meets lines of symmetry, influences that do not fall to zero have left one negative eigenvalue.
    fn leaves_cut_border(&self, mirrors: &Mirrors) -> Option<(&'static str, &'static str)> {
        (!mirrors.is_none() && self.parameters.influence != Influence::Linear).then_some((
            "beside lines of symmetry only the influence `linear` follows it",
            "use the influence `linear`, the default, or model the whole body",
        ))
    }

    fn has_border(&self, lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
        BorderedState::has_border(&self.parameters, lattice, mirrors)
    }

    fn offsets(&self) -> Result<Vec<Cell>, Refusal> {
        Ok(StateBased::offsets(&self.parameters))
    }

    fn depth(&self) -> Result<i32, Refusal> {
        Ok(self.parameters.horizon_ratio.floor() as i32)
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let real = Arc::new(on.real.clone());
        if self.parameters.edges == StateEdges::Border {
            let body = BorderedState::on_lattice(&real, on.mirrors, self.parameters)?;
            return Ok(AnyBody::Two(Box::new(body)));
        }
        let offsets = self.offsets()?;
        let cut = |lattice: &SquareLattice| (on.cuts)(lattice, &offsets);
        let of = &self.parameters;
        let ratio = |other: &OtherMaterial| other.poisson_ratio.unwrap_or(of.poisson_ratio);
        let ratios: Vec<f64> = on.materials.others.iter().map(ratio).collect();
        let materials = StateMaterials::new(of, &ratios, &on.materials.numbers, &on.materials.factors);
        let body = StateBased::mixed(real, on.mirrors, *of, on.separated, &cut, materials.as_ref())?;
        Ok(AnyBody::Two(Box::new(body)))
    }

    fn holds_across(&self) -> bool {
        !matches!(self.parameters.geometry, Geometry::PlaneStress(_))
    }

    fn resists_eigenstrain(&self) -> Option<&'static str> {
        let is_complete = calibration(self.parameters.edges) == Calibration::Matched;
        (!is_complete)
            .then_some("families that edges leave incomplete would resist a strain that needs no stress")
    }

    fn shares_dilatations(&self) -> bool {
        self.parameters.dilatation == Dilatation::Blocks
    }

    fn strain_row(&self, axis: usize) -> [f64; 3] {
        let StateParameters { poisson_ratio: nu, geometry, .. } = self.parameters;
        match (geometry, axis) {
            (Geometry::PlaneStress(_), _) => isotropic_strain(axis, nu),
            (Geometry::PlaneStrain(_), _) => isotropic_strain(axis, nu / (1.0 - nu)),
            (Geometry::Axisymmetric, 0) => [1.0 - nu, -nu, 0.0],
            (Geometry::Axisymmetric, _) => isotropic_strain(axis, 2.0 * nu),
        }
    }

    fn touches_axis(
        &self,
        asked: &Asked,
        body: (Option<&Outline>, Option<&SquareLattice>),
        faults: &mut Faults,
    ) -> Option<bool> {
        if self.parameters.is_axisymmetric() {
            section::touches_axis(asked, body, faults)
        } else {
            Some(false)
        }
    }

    fn critical(
        &self,
        given: &mut Critical,
        _: &OnGround,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<CriticalStretches> {
        let stretch = critical::stretch(given, path, faults)?;
        Some(CriticalStretches::alike(stretch, self.offsets().ok().as_deref()))
    }

    fn warn(&self, on: &Resolved, faults: &mut Faults) {
        warn::warn(&self.parameters, self.name, on, faults);
    }

    fn summary(&self, on: &Resolved, ghosts: usize, units: Units) -> MaterialSummary {
        words::summary(&self.parameters, self.name, on, ghosts, units)
    }
}

/// Whether weights of a treatment of edges are exact.
fn calibration(edges: StateEdges) -> Calibration {
    match edges {
        StateEdges::Calibrated | StateEdges::None => Calibration::Published,
        StateEdges::Border | StateEdges::Ghosts | StateEdges::Moment | StateEdges::MomentPlus => {
            Calibration::Matched
        }
    }
}
