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
    /// Critical strains of the base material, with their defaults, and its stretches by offset.
    critical: &'a Critical,
    stretches: &'a [f64],
}

/// Largest part by which the ratios of stretches along and across fibres differ that count as one.
const ALIKE: f64 = 1e-9;

/// Whether energy release rates are given.
fn by_energy(given: &Critical) -> bool {
    let rates =
        [given.energy_release_rate, given.fibre_energy_release_rate, given.matrix_energy_release_rate];
    rates.iter().any(Option::is_some)
}

impl Base<'_> {
    fn toughness(&self, given: &Critical, path: &JsonPath, faults: &mut Faults) -> Option<Toughness> {
        let mut given = given.clone();
        let by_energy = by_energy(&given);
        if by_energy {
            given.formula = given.formula.or(self.critical.formula);
        }
        let found = self.material.critical(&mut given, &self.on, path, faults)?;
        let ratios = found.by_offset.by_offset().iter().zip(self.stretches).map(|(own, base)| own / base);
        let ratios: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
        let ratio = *ratios.first()?;
        if ratios.iter().any(|other| (other / ratio - 1.0).abs() > ALIKE) {
            faults
                .error(path.clone(), "a material is as many times tougher along the fibres as across them")
                .hint("give both the same multiple of what `fracture.critical` has");
            return None;
        }
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
        if by_energy(self.critical) { Toughness::Energy(1.0) } else { Toughness::Stretch(1.0) }
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
    let of = Base { material, on: inputs.on_ground(case), critical, stretches: base.by_offset.by_offset() };
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
