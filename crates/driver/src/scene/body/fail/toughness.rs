//! At which stretches bonds of several materials break, and those from one material to another.
//!
//! A crack whose bonds break at the stretch s takes an energy in proportion to `s² E` in a material, and to `s² φ E₀` along an
//! interface, with the factor φ of the bonds through both and the modulus E₀ of the base material. An interface that is given nothing
//! breaks at the energy of the weaker material beside it.

use crate::case::RegionMaterial;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::{Critical, CriticalStretches, Material, OnGround};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::root;

/// A material as it breaks.
#[derive(Clone, Copy)]
struct Breaking {
    /// Its modulus over that of the base material.
    modulus: f64,
    stretch: f64,
    /// What its interfaces are given.
    interface: Option<Toughness>,
}

/// How tough something is.
#[derive(Clone, Copy)]
enum Toughness {
    Stretch(f64),
    /// The stretch of the base material at the energy release rate that is given.
    AsBase(f64),
}

impl Toughness {
    /// The stretch where a crack takes so many times the energy that it takes in the base material.
    fn stretch(self, times: f64) -> f64 {
        match self {
            Self::Stretch(stretch) => stretch,
            Self::AsBase(stretch) => stretch / times.sqrt(),
        }
    }
}

/// What toughnesses are found from.
struct Base<'a> {
    material: &'a dyn Material,
    on: OnGround,
    /// Critical strains of the base material, with their defaults.
    critical: &'a Critical,
}

impl Base<'_> {
    fn toughness(&self, given: &Critical, path: &JsonPath, faults: &mut Faults) -> Option<Toughness> {
        let mut given = given.clone();
        let by_energy = given.energy_release_rate.is_some();
        if by_energy {
            given.formula = given.formula.or(self.critical.formula);
        }
        let found = self.material.critical(&mut given, &self.on, path, faults)?;
        let stretch = *found.by_offset.by_offset().first()?;
        Some(if by_energy { Toughness::AsBase(stretch) } else { Toughness::Stretch(stretch) })
    }

    fn breaking(&self, of: &RegionMaterial, path: &JsonPath, faults: &mut Faults) -> Option<Breaking> {
        let base = self.material.youngs_moduli().first()?.1;
        let modulus = match &of.youngs_modulus {
            Some(own) => own.number().or_else(|| refuse_graded(path, faults))? / base,
            None => 1.0,
        };
        let own = of.critical.as_ref().map(|own| self.toughness(own, &path.key("critical"), faults));
        let interface = of.interface.as_ref().map(|own| self.toughness(own, &path.key("interface"), faults));
        let alike =
            || self.toughness(self.critical, &root("fracture").key("critical"), &mut Faults::default());
        let own = own.unwrap_or_else(alike)?;
        let interface = interface.map_or(Some(None), |found| found.map(Some))?;
        Some(Breaking { modulus, stretch: own.stretch(modulus), interface })
    }

    /// The stretch of bonds between two materials.
    fn between(&self, [a, b]: [&Breaking; 2]) -> Option<f64> {
        let factor = self.material.interface_factor([a.modulus, b.modulus])?;
        let given = [a, b].into_iter().filter_map(|of| of.interface);
        let weaker = given.map(|own| own.stretch(factor)).reduce(f64::min);
        let energy = |of: &Breaking| of.stretch * of.stretch * of.modulus;
        Some(weaker.unwrap_or_else(|| (energy(a).min(energy(b)) / factor).sqrt()))
    }
}

/// Adds a fault for a modulus that varies within a material: its bonds would break at stretches of their own.
fn refuse_graded(path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    faults
        .error(path.key("youngs_modulus"), "bodies with a modulus that varies within a material do not break")
        .hint("give numbers to several regions");
    None
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
    let own = *base.by_offset.by_offset().first()?;
    let of = Base { material: &*inputs.material, on: inputs.on_ground(case), critical };
    let mut all = vec![Breaking { modulus: 1.0, stretch: own, interface: None }];
    for (name, material) in &case.materials {
        all.push(of.breaking(material, &root("materials").key(name), faults)?);
    }
    let ratio = |a: usize, b: usize| {
        let stretch = if a == b { Some(all[a].stretch) } else { of.between([&all[a], &all[b]]) };
        Some(stretch? / own)
    };
    let row = |a: usize| (0..all.len()).map(|b| ratio(a, b)).collect::<Option<Vec<f64>>>();
    let ratios = (0..all.len()).map(row).collect::<Option<Vec<Vec<f64>>>>()?;
    let by_offset = base.by_offset.of_materials(inputs.materials.numbers.clone(), ratios);
    Some(CriticalStretches { by_offset, ..base })
}
