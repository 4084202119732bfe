//! Materials of regions beside the base one, which the keys of a model give.

use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::Mirrors;

/// A material of some points of a body, as far as it is other than the base one.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherMaterial {
    /// Name.
    pub name: String,
    /// Young's modulus.
    pub youngs_modulus: Option<f64>,
    /// Poisson's ratio.
    pub poisson_ratio: Option<f64>,
    /// Shear modulus.
    pub shear_modulus: Option<f64>,
    /// Strain per kelvin.
    pub thermal_expansion: Option<f64>,
}

impl OtherMaterial {
    /// What it gives, by keys.
    pub fn keys(&self) -> [(&'static str, Option<f64>); 3] {
        [
            ("youngs_modulus", self.youngs_modulus),
            ("poisson_ratio", self.poisson_ratio),
            ("shear_modulus", self.shear_modulus),
        ]
    }
}

/// The materials of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mixture {
    /// Those beside the base one.
    pub others: Vec<OtherMaterial>,
    /// Per point without images: 0 for the base material, else a place among the others, from 1 on. None where all are of the
    /// base material.
    pub numbers: Vec<u32>,
}

impl Mixture {
    /// Whether all points are of the base material.
    pub fn is_one(&self) -> bool {
        self.numbers.is_empty()
    }

    /// The material of a point without images; none of the base one.
    pub fn of(&self, point: usize) -> Option<&OtherMaterial> {
        let number = self.numbers.get(point)?.checked_sub(1)?;
        self.others.get(number as usize)
    }

    /// A number of every point of a lattice with images of a real one, that of its material; none where all points are of the
    /// base material.
    pub fn on_images(
        &self,
        lattice: &SquareLattice,
        (real, mirrors): (&SquareLattice, &Mirrors),
        number: impl Fn(Option<&OtherMaterial>) -> f64,
    ) -> Vec<f64> {
        if self.is_one() {
            return Vec::new();
        }
        let of = |point: usize| {
            let cell = lattice.cell(point);
            let cell = if mirrors.is_none() { cell } else { mirrors.image(cell).0 };
            number(real.number(cell).and_then(|own| self.of(own)))
        };
        (0..lattice.points()).map(of).collect()
    }
}
