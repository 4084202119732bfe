//! Materials of regions beside the base one, which the keys of a model give.

use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::Mirrors;

/// A material of some points of a body, as far as it is other than the base one.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherMaterial {
    /// Name.
    pub name: String,
    /// The least and the greatest Young's modulus of its points.
    pub youngs_modulus: Option<[f64; 2]>,
    /// Poisson's ratio.
    pub poisson_ratio: Option<f64>,
    /// The least and the greatest shear modulus of its points.
    pub shear_modulus: Option<[f64; 2]>,
    /// The least and the greatest factor on all moduli of its points.
    pub stiffness_factor: Option<[f64; 2]>,
    /// Angle of its fibres from x, degrees.
    pub fibre_angle: Option<f64>,
    /// Strain per kelvin, along and across fibres; without fibres both are the same.
    pub thermal_expansion: Option<[f64; 2]>,
    /// Mass per volume.
    pub density: Option<f64>,
}

/// The materials of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mixture {
    /// Those beside the base one.
    pub others: Vec<OtherMaterial>,
    /// Per point without images: 0 for the base material, else a place among the others, from 1 on. None where all are of the
    /// base material.
    pub numbers: Vec<u32>,
    /// Per point as the numbers: the modulus over that of the base material, > 0.
    pub factors: Vec<f64>,
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

    /// The angles of fibres from x, degrees, that differ: first that of the base material, none.
    pub fn fibre_angles(&self) -> Vec<Option<f64>> {
        let mut angles = vec![None];
        for own in self.others.iter().map(|other| other.fibre_angle) {
            if !angles.contains(&own) {
                angles.push(own);
            }
        }
        angles
    }

    /// The angle of the fibres of a point without images, degrees; none of those of the base material.
    pub fn fibre_angle(&self, point: usize) -> Option<f64> {
        self.of(point)?.fibre_angle
    }

    /// The largest modulus over that of the base material.
    pub fn stiffest(&self) -> f64 {
        self.factors.iter().copied().fold(1.0, f64::max)
    }

    /// The modulus over that of the base material of every point of a lattice with images of a real one; none where all points are
    /// of the base material.
    pub fn on_images(&self, lattice: &SquareLattice, body: (&SquareLattice, &Mirrors)) -> Vec<f64> {
        self.each(lattice, body, |own| own.map_or(1.0, |own| self.factors[own]))
    }

    /// What follows from the real points of those of a lattice with images; nothing where all are of the base material.
    pub fn each<T>(
        &self,
        lattice: &SquareLattice,
        (real, mirrors): (&SquareLattice, &Mirrors),
        of: impl Fn(Option<usize>) -> T,
    ) -> Vec<T> {
        if self.is_one() {
            return Vec::new();
        }
        let own = |point: usize| {
            let cell = lattice.cell(point);
            of(real.number(if mirrors.is_none() { cell } else { mirrors.image(cell).0 }))
        };
        (0..lattice.points()).map(own).collect()
    }
}
