//! Beam bonds on bodies.

use super::super::{
    About, AnyBody, Critical, CriticalStretches, Fibres, Material, MaterialSummary, Model, OnGround,
    OnLattice, Refusal, Resolved, Surface,
};
use super::{BeamBonds, NAME, Orthotropic, critical, refusal, resolve, words};
use crate::diagnostic::{Faults, JsonPath};
use crate::units::Units;
use peristat_assembly::body::Cell;
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamBondOrthotropic, BeamNeighbourhood, Laminae, OrthotropicError, crossing_bonds,
};
use peristat_assembly::model::plane::Edges;
use peristat_assembly::model::plane::toughness::CrossingBonds;
use std::sync::Arc;

impl BeamBonds {
    fn refusal(&self) -> impl Fn(OrthotropicError) -> Refusal {
        let calibration = self.parameters.calibration;
        move |error| refusal(&error, calibration)
    }
}

impl Material for BeamBonds {
    fn about(&self) -> About {
        let of = &self.parameters;
        About {
            name: NAME,
            components: &["ux", "uy", "phi"],
            surface: Surface::Flat,
            thickness: of.material.thickness,
            horizon_ratio: of.horizon_ratio,
            calibration: of.calibration,
            edges: Some(of.edges),
            is_exact_at_edges: of.edges.is_exact(),
            ends_where_cut: false,
            has_families: false,
            partial_neighbours: 0.0,
        }
    }

    fn keys(&self) -> Model {
        // Laminae may start at other ones than the model: what each takes without a word it takes again.
        let start = if self.angles.is_empty() { resolve::start(&self.parameters) } else { self.keys.start };
        Model::BeamBondOrthotropic(Orthotropic { start, ..self.keys.clone() })
    }

    fn usual_horizon_ratio(&self) -> f64 {
        resolve::horizon_ratio(&self.parameters, &self.angles())
    }

    fn boxed(&self) -> Box<dyn Material> {
        Box::new(self.clone())
    }

    fn youngs_moduli(&self) -> Vec<(&'static str, f64)> {
        let material = &self.parameters.material;
        vec![("youngs_modulus_1", material.youngs_modulus_1), ("youngs_modulus_2", material.youngs_modulus_2)]
    }

    fn other_materials(&self) -> Result<Vec<(&'static str, f64)>, (&'static str, String)> {
        if self.parameters.edges.is_exact() {
            return Ok(vec![("stiffness_factor", 1.0), ("fibre_angle", self.keys.fibre_angle)]);
        }
        let hint = "leave out `edges` and `calibration`".into();
        Err(("several materials need the edges `border` or `overlay`", hint))
    }

    fn set_horizon_ratio(&mut self, horizon_ratio: f64) {
        self.parameters.horizon_ratio = horizon_ratio;
    }

    fn set_lattice_angle(&mut self, angle: f64) {
        self.parameters.lattice_angle = angle;
    }

    fn leave_border(&mut self, edges: Edges) {
        if self.parameters.edges == Edges::Border {
            self.parameters.edges = edges;
        }
    }

    fn offsets(&self) -> Result<Vec<Cell>, Refusal> {
        BeamBondOrthotropic::offsets(&self.parameters, &self.angles()).map_err(self.refusal())
    }

    fn depth(&self) -> Result<i32, Refusal> {
        BeamBondOrthotropic::depth(&self.parameters, &self.angles()).map_err(self.refusal())
    }

    fn on_lattice(&self, on: &OnLattice) -> Result<AnyBody, Refusal> {
        let lattice = Arc::new(on.mirrors.extended(on.real, self.depth()?));
        let cuts = (on.cuts)(&lattice, &self.offsets()?);
        let (real, materials) = ((on.real, &on.mirrors), on.materials);
        let lamina = |own: Option<usize>| self.lamina(own.and_then(|own| materials.fibre_angle(own)));
        let laminae = Laminae { angles: self.angles(), of: materials.each(&lattice, real, lamina) };
        let parts = (materials.on_images(&lattice, real), laminae);
        let body = BeamBondOrthotropic::mixed(lattice, on.mirrors, self.parameters, &cuts, parts);
        Ok(AnyBody::Three(Box::new(body.map_err(self.refusal())?)))
    }

    fn strain_row(&self, axis: usize) -> [f64; 3] {
        let row = self.parameters.material.compliance_at(self.parameters.fibre_angle)[axis];
        row.map(|c| c / row[axis])
    }

    fn fibres(&self) -> Option<Fibres> {
        let of = &self.parameters.material;
        Some(Fibres {
            youngs_moduli: [of.youngs_modulus_1, of.youngs_modulus_2],
            poisson_ratio: of.poisson_ratio_12,
            shear_modulus: of.shear_modulus_12,
            angle: self.parameters.fibre_angle,
        })
    }

    fn critical(
        &self,
        given: &mut Critical,
        on: &OnGround,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<CriticalStretches> {
        critical::stretches(given, &self.parameters, on, path, faults)
    }

    fn crossing_bonds(&self) -> Option<CrossingBonds> {
        Some(crossing_bonds(&BeamNeighbourhood::new(&self.parameters).ok()?))
    }

    fn warn(&self, _: &Resolved, faults: &mut Faults) {
        resolve::warn(&self.parameters, faults);
    }

    fn summary(&self, _: &Resolved, _: usize, units: Units) -> MaterialSummary {
        words::summary(&self.parameters, units)
    }
}
