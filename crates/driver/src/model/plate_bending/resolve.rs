//! What the keys become.

use super::super::{Asked, Keys, Material, Model};
use super::{Bending, NAME};
use crate::diagnostic::{Faults, JsonPath, positive, root};
use peristat_assembly::model::plate_bending::{PlateParameters, PlateSection};

impl Bending {
    /// The stiffness of the plate, with a horizon per spacing; adds the faults of the keys.
    pub(crate) fn parameters(&self, horizon_ratio: f64, faults: &mut Faults) -> Option<PlateParameters> {
        self.parameters_at(&root("model").key(NAME), horizon_ratio, faults)
    }

    /// The same of keys that the case writes at a path.
    pub(crate) fn parameters_at(
        &self,
        path: &JsonPath,
        horizon_ratio: f64,
        faults: &mut Faults,
    ) -> Option<PlateParameters> {
        let mut fine = positive(self.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
        fine &= positive(self.thickness, "thickness", path.key("thickness"), faults);
        fine &= positive(self.shear_correction, "shear_correction", path.key("shear_correction"), faults);
        if self.shear_correction > 1.0 {
            faults
                .error(
                    path.key("shear_correction"),
                    format!("`shear_correction` must be at most 1, found {}", self.shear_correction),
                )
                .hint("a homogeneous plate has 5/6, the default");
            fine = false;
        }
        if !(self.poisson_ratio > -1.0 && self.poisson_ratio < 0.5) {
            faults.error(
                path.key("poisson_ratio"),
                format!("`poisson_ratio` must be between -1 and 1/2, found {}", self.poisson_ratio),
            );
            fine = false;
        }
        let section = self.section();
        fine.then_some(PlateParameters { section, horizon_ratio, shear_law: self.shear_law })
    }

    /// Its stiffness.
    pub(crate) fn section(&self) -> PlateSection {
        PlateSection::homogeneous(
            self.youngs_modulus,
            self.poisson_ratio,
            self.thickness,
            self.shear_correction,
        )
    }

    /// A plate that is all as a region of this one, of which Young's modulus, Poisson's ratio and thickness may be given.
    pub(crate) fn of_region(
        &self,
        youngs_modulus: Option<f64>,
        poisson_ratio: Option<f64>,
        thickness: Option<f64>,
    ) -> Self {
        Self {
            youngs_modulus: youngs_modulus.unwrap_or(self.youngs_modulus),
            poisson_ratio: poisson_ratio.unwrap_or(self.poisson_ratio),
            thickness: thickness.unwrap_or(self.thickness),
            ..self.clone()
        }
    }
}

impl Keys for Bending {
    fn model(&self) -> Model {
        Model::PlateBending(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn bends(&self) -> bool {
        true
    }

    fn takes_points(&self) -> bool {
        false
    }

    fn resolve(&self, _asked: &Asked, _faults: &mut Faults) -> Option<Box<dyn Material>> {
        None
    }
}
