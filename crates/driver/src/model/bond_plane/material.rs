//! Central bonds on bodies.

use super::super::material::isotropic_strain;
use super::super::{
    About, AnyBody, Critical, CriticalStretches, Material, MaterialSummary, Model, OnGround, OnLattice,
    Refusal, Resolved, SofteningBonds, Surface,
};
use super::{Central, Plane, critical, soften, words};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::{Cell, Cloud, in_space};
use peristat_assembly::model::bond_plane::{BondPlane, PlaneState, VolumeFactor, crossing_bonds};
use peristat_assembly::model::plane::toughness::CrossingBonds;
use peristat_assembly::model::plane::{Calibration, Edges};
use std::sync::Arc;

impl Material for Central {
    fn about(&self) -> About {
        let of = &self.parameters;
        let partial = of.calibration == Calibration::Published
            && matches!(of.volume_factor, VolumeFactor::Ramp | VolumeFactor::Area);
        About {
            name: "bond_plane",
            components: &["ux", "uy"],
            surface: Surface::Flat,
            thickness: of.material.thickness,
            horizon_ratio: of.horizon_ratio,
            calibration: of.calibration,
            edges: Some(of.edges),
            is_exact_at_edges: of.edges.is_exact(),
            ends_where_cut: false,
            has_families: false,
            partial_neighbours: if partial { 0.5 } else { 0.0 },
        }
    }

    fn keys(&self) -> Model {
        Model::BondPlane(Plane { edges: Some(self.parameters.edges), ..self.keys.clone() })
    }

    fn usual_horizon_ratio(&self) -> f64 {
        self.usual_horizon_ratio
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        vec![("youngs_modulus", self.parameters.material.youngs_modulus)]
    }

    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        if self.parameters.edges.is_exact() {
            return Ok(self.youngs_moduli());
        }
        let hint = "leave out `edges` and `calibration`".into();
        Err(("several materials need the edges `border` or `overlay`", hint))
    }

    fn set_horizon_ratio(&mut self, horizon_ratio: f64) {
        self.parameters.horizon_ratio = horizon_ratio;
    }

    fn leave_border(&mut self, edges: Edges) {
        if self.parameters.edges == Edges::Border {
            self.parameters.edges = edges;
        }
    }

    fn offsets(&self) -> Result<Vec<Cell>, Refusal> {
        Ok(BondPlane::offsets(&self.parameters)?)
    }

    fn depth(&self) -> Result<i32, Refusal> {
        Ok(BondPlane::depth(&self.parameters)?)
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let lattice = Arc::new(on.mirrors.extended(on.real, self.depth()?));
        let cuts = (on.cuts)(&lattice, &self.offsets()?);
        let factors = on.materials.on_images(&lattice, (on.real, &on.mirrors));
        let body = BondPlane::mixed(lattice, on.mirrors, self.parameters, &cuts, factors)?;
        Ok(AnyBody::Two(Box::new(body)))
    }

    fn on_points(
        &self,
        cloud: &Cloud,
        horizon: f64,
        cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<AnyBody, Refusal> {
        let positions = (0..cloud.points()).map(|point| cloud.place(point)).collect();
        let cut = |a, b| cut(in_space(a), in_space(b));
        let areas = cloud.sizes().to_vec();
        let body = BondPlane::on_cloud(positions, areas, horizon, self.parameters, &cut)?;
        Ok(AnyBody::Two(Box::new(body)))
    }

    fn holds_across(&self) -> bool {
        self.parameters.material.state == PlaneState::Strain
    }

    fn strain_row(&self, axis: usize) -> [f64; 3] {
        isotropic_strain(axis, 1.0 / 3.0)
    }

    fn critical(
        &self,
        given: &mut Critical,
        on: &OnGround,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<CriticalStretches> {
        let stretch = critical::stretch(given, &self.parameters, on, path, faults)?;
        Some(CriticalStretches::alike(stretch, self.offsets().ok().as_deref()))
    }

    fn crossing_bonds(&self) -> Option<CrossingBonds> {
        crossing_bonds(&self.parameters).ok()
    }

    fn soften(&self, on: &OnGround, faults: &mut Faults) -> Option<SofteningBonds> {
        soften::bonds(self.keys.bond_law.as_ref()?, &self.parameters, on, faults)
    }

    fn summary(&self, _: &Resolved, _: usize, units: Units) -> MaterialSummary {
        words::summary(&self.parameters, units)
    }
}
