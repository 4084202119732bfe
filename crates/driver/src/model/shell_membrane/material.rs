//! Bonds of developed cylinders on bodies.

use super::super::material::isotropic_strain;
use super::super::{
    About, AnyBody, Critical, CriticalStretches, Material, MaterialSummary, Model, OnGround, OnLattice,
    Refusal, Resolved, Surface,
};
use super::{HoopPressure, NAME, Pressure, ShellBonds, bearable, pressure, warn, words};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::{Cell, SquareLattice};
use peristat_assembly::model::plane::{Edges, Mirrors};
use peristat_assembly::model::shell_membrane::ShellMembrane;
use std::sync::Arc;

impl Material for ShellBonds {
    fn about(&self) -> About {
        let of = &self.parameters;
        About {
            name: NAME,
            components: &["ux", "uy", "w"],
            surface: Surface::Cylinder(of.radius),
            thickness: of.thickness,
            horizon_ratio: of.horizon_ratio,
            calibration: of.calibration,
            // Every point has weights of its own.
            edges: None,
            // Their ends are exact as cylinders have them: see `ends_on_border`.
            is_exact_at_edges: false,
            ends_where_cut: false,
            has_families: false,
            partial_neighbours: 0.0,
        }
    }

    fn keys(&self) -> Model {
        Model::ShellMembrane(self.keys.clone())
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        vec![("youngs_modulus", self.parameters.youngs_modulus)]
    }

    fn set_horizon_ratio(&mut self, horizon_ratio: f64) {
        self.parameters.horizon_ratio = horizon_ratio;
    }

    fn leave_border(&mut self, _: Edges) {}

    fn offsets(&self) -> Result<Vec<Cell>, Refusal> {
        Ok(ShellMembrane::offsets(&self.parameters)?)
    }

    fn depth(&self) -> Result<i32, Refusal> {
        Ok(ShellMembrane::depth(&self.parameters)?)
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let lattice = Arc::new(on.mirrors.extended(on.real, self.depth()?));
        let body = ShellMembrane::on_lattice(lattice, on.mirrors, self.parameters)?;
        Ok(AnyBody::Three(Box::new(body)))
    }

    fn ends_on_border(&self, real: &SquareLattice) -> bool {
        ShellMembrane::has_border(&self.parameters, real)
    }

    fn resists_eigenstrain(&self) -> Option<&'static str> {
        self.keys
            .bending
            .then_some("a shell that resists bending would resist a strain that needs no stress, too")
    }

    fn strain_row(&self, axis: usize) -> [f64; 3] {
        isotropic_strain(axis, 1.0 / 3.0)
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

    fn pressure(
        &self,
        load: &Pressure,
        lattice: &SquareLattice,
        mirrors: &Mirrors,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<HoopPressure> {
        Some(pressure::resolve(load, &self.parameters, (lattice, mirrors), path, faults))
    }

    fn check_bearable(
        &self,
        on: &Resolved,
        held: &mut dyn Iterator<Item = (&[u32], [f64; 3])>,
        loads: &mut dyn Iterator<Item = (JsonPath, Vec<f64>)>,
        faults: &mut Faults,
    ) {
        bearable::check(&self.parameters, on, held, loads, faults);
    }

    fn warn(&self, on: &Resolved, faults: &mut Faults) {
        warn::warn(&self.parameters, on, faults);
    }

    fn summary(&self, _: &Resolved, _: usize, units: Units) -> MaterialSummary {
        words::summary(&self.parameters, units)
    }
}
