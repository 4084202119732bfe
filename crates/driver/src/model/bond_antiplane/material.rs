//! Bonds in antiplane shear on bodies.

use super::super::{
    About, AnyBody, Critical, CriticalStretches, Material, MaterialSummary, Model, OnGround, OnLattice,
    Refusal, Resolved, Surface,
};
use super::{Antiplane, NAME, ShearBonds, words};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::Cell;
use peristat_assembly::model::bond_antiplane::BondAntiplane;
use peristat_assembly::model::plane::{Calibration, Edges};
use std::sync::Arc;

impl Material for ShearBonds {
    fn about(&self) -> About {
        let of = &self.parameters;
        About {
            name: NAME,
            components: &["w"],
            surface: Surface::Flat,
            thickness: of.thickness,
            horizon_ratio: of.horizon_ratio,
            calibration: Calibration::Matched,
            edges: Some(of.edges),
            is_exact_at_edges: of.edges.is_exact(),
            ends_where_cut: false,
            has_families: false,
            partial_neighbours: 0.0,
        }
    }

    fn keys(&self) -> Model {
        Model::BondAntiplane(Antiplane { edges: Some(self.parameters.edges), ..self.keys.clone() })
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        if self.parameters.edges.is_exact() {
            return Ok(vec![("shear_modulus", self.parameters.shear_modulus)]);
        }
        Err(("several materials need the edges `border` or `overlay`", "leave out `edges`".into()))
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
        Ok(BondAntiplane::offsets(&self.parameters)?)
    }

    fn depth(&self) -> Result<i32, Refusal> {
        Ok(BondAntiplane::depth(&self.parameters)?)
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let lattice = Arc::new(on.mirrors.extended(on.real, self.depth()?));
        let cuts = (on.cuts)(&lattice, &self.offsets()?);
        let factors = on.materials.on_images(&lattice, (on.real, &on.mirrors));
        let body = BondAntiplane::mixed(lattice, on.mirrors, self.parameters, &cuts, factors)?;
        Ok(AnyBody::One(Box::new(body)))
    }

    fn resists_eigenstrain(&self) -> Option<&'static str> {
        Some("points that move across the plane only have no strain that needs no stress")
    }

    fn strain_row(&self, axis: usize) -> [f64; 3] {
        [0, 1, 2].map(|k| f64::from(u8::from(k == axis)))
    }

    fn critical(
        &self,
        _: &mut Critical,
        _: &OnGround,
        _: &JsonPath,
        _: &mut Faults,
    ) -> Option<CriticalStretches> {
        // The keys refuse `fracture`.
        None
    }

    fn summary(&self, _: &Resolved, _: usize, units: Units) -> MaterialSummary {
        words::summary(&self.parameters, units)
    }
}
