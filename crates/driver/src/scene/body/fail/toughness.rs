//! How tough the materials of a body and their interfaces are.
//!
//! A crack whose bonds break at the stretch s takes an energy in proportion to `s² E` in a material. What is given as an energy is taken
//! at any modulus, and what is given as a stretch is that of all bonds; an interface that is given nothing takes the energy of the
//! weaker material beside it.

use crate::case::RegionMaterial;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::{Critical, CriticalStretches, Material, OnGround};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::root;
use peristat_assembly::model::plane::{ToughMaterials, Toughness};

/// What toughnesses are found from.
struct Base<'a> {
    material: &'a dyn Material,
    on: OnGround,
    /// Critical strains of the base material, with their defaults, and its stretch.
    critical: &'a Critical,
    stretch: f64,
}

impl Base<'_> {
    fn toughness(&self, given: &Critical, path: &JsonPath, faults: &mut Faults) -> Option<Toughness> {
        let mut given = given.clone();
        let by_energy = given.energy_release_rate.is_some();
        if by_energy {
            given.formula = given.formula.or(self.critical.formula);
        }
        let found = self.material.critical(&mut given, &self.on, path, faults)?;
        let ratio = found.by_offset.by_offset().first()? / self.stretch;
        Some(if by_energy { Toughness::Energy(ratio * ratio) } else { Toughness::Stretch(ratio) })
    }

    /// What a material takes, and what its interfaces are given.
    fn of(
        &self,
        material: &RegionMaterial,
        path: &JsonPath,
        faults: &mut Faults,
    ) -> Option<(Toughness, Option<Toughness>)> {
        let own = material.critical.as_ref().map(|own| self.toughness(own, &path.key("critical"), faults));
        let interface =
            material.interface.as_ref().map(|own| self.toughness(own, &path.key("interface"), faults));
        let own = own.unwrap_or_else(|| Some(self.usual()))?;
        Some((own, interface.map_or(Some(None), |found| found.map(Some))?))
    }

    /// That of a material that gives none.
    fn usual(&self) -> Toughness {
        match self.critical.energy_release_rate {
            Some(_) => Toughness::Energy(1.0),
            None => Toughness::Stretch(1.0),
        }
    }
}

/// The stretches of a body whose base material has some: with those of the others and between them.
pub(super) fn of_materials(
    base: CriticalStretches,
    critical: &Critical,
    site: &HeldBody,
    faults: &mut Faults,
) -> Option<CriticalStretches> {
    let (case, inputs) = (site.ground.case, site.inputs);
    if inputs.materials.is_one() {
        return Some(base);
    }
    let material = &*inputs.material;
    let stretch = *base.by_offset.by_offset().first()?;
    let of = Base { material, on: inputs.on_ground(case), critical, stretch };
    let (mut own, mut interfaces) = (vec![of.usual()], vec![None]);
    for (name, given) in &case.materials {
        let (toughness, interface) = of.of(given, &root("materials").key(name), faults)?;
        own.push(toughness);
        interfaces.push(interface);
    }
    let materials = ToughMaterials {
        numbers: inputs.materials.numbers.clone(),
        moduli: inputs.materials.factors.clone(),
        own,
        interfaces,
        crossing: material.crossing_bonds()?,
    };
    Some(CriticalStretches { by_offset: base.by_offset.of_materials(materials), ..base })
}
