//! Materials and profiles by name, in a file that many cases share.

use super::Units;
use crate::diagnostic::{Faults, JsonPath, Report, parse, positive, root, suggest};
use crate::input::{Folder, Refusal};
use peristat_assembly::material::{Rolled, Section, ShearCorrection};
use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// What the file of a library holds.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Library {
    #[serde(default)]
    pub(super) units: Units,
    #[serde(default)]
    pub(super) materials: BTreeMap<String, Material>,
    #[serde(default)]
    pub(super) profiles: BTreeMap<String, Section>,
}

/// A material of a library.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub(super) youngs_modulus: Option<f64>,
    pub(super) poisson_ratio: Option<f64>,
    pub(super) shear_modulus: Option<f64>,
    pub(super) density: Option<f64>,
    pub(super) thermal_expansion: Option<f64>,
}

impl Library {
    /// Reads the file that a case names; all faults of its rows, at the key `library` of the case.
    pub(super) fn read(file: &str, folder: &Folder, max_memory: Option<u64>) -> Result<Self, Faults> {
        let refuse = |report: Report| {
            let mut faults = Faults::default();
            for fault in &report.diagnostics {
                let line =
                    report.line_and_column(fault).map_or(String::new(), |(line, _)| format!(", line {line}"));
                let told =
                    faults.error(root("library"), format!("the library {file}{line}: {}", fault.message));
                told.hint.clone_from(&fault.hint);
            }
            faults
        };
        let text = folder.read(file, max_memory).and_then(|bytes| {
            String::from_utf8(bytes).map_err(|_| Refusal { reason: "is no text".into(), hint: None })
        });
        let text = text.map_err(|refusal| {
            let mut faults = Faults::default();
            let fault = faults.error(root("library"), format!("the library {file} {}", refusal.reason));
            fault.hint(refusal.hint.unwrap_or("the path is relative to the case"));
            faults
        })?;
        let library: Self = parse(file, &text).map_err(refuse)?;
        let mut faults = Faults::default();
        for (name, material) in &library.materials {
            material.check(&root("materials").key(name), &mut faults);
        }
        for (name, section) in &library.profiles {
            check(name, section, &root("profiles").key(name), &mut faults);
        }
        if faults.has_errors() { Err(refuse(faults.into_report(file, text))) } else { Ok(library) }
    }

    /// A material by its name; a fault at `path` where there is none.
    fn material(&self, name: &str, path: JsonPath, faults: &mut Faults) -> Option<&Material> {
        let found = self.materials.get(name);
        if found.is_none() {
            let hint = suggest(name, self.materials.keys().map(String::as_str));
            faults.error(path, format!("there is no material `{name}` in the library")).hint(hint);
        }
        found
    }

    /// Writes into a case what its names stand for. What the case gives itself counts.
    pub(super) fn fill(&self, case: &mut Map<String, Value>) -> Result<(), Faults> {
        let mut faults = Faults::default();
        let is_frame = case.get("body").is_some_and(|body| body.get("frame").is_some());
        let named = case.get("material").and_then(Value::as_str);
        if let Some(material) = named.and_then(|name| self.material(name, root("material"), &mut faults)) {
            give(case, [("density", material.density), ("thermal_expansion", material.thermal_expansion)]);
            if let Some(keys) = model_of(case) {
                give(keys, material.moduli(keys));
            }
        }
        let weighs = ["loads", "load_cases"].iter().filter_map(|key| case.get(*key)).any(weighs);
        let density = case.get("density").and_then(Value::as_f64);
        let ratio = model_of(case).and_then(|keys| keys.get("poisson_ratio")?.as_f64());
        let has_fibres = model_of(case).is_some_and(|keys| keys.contains_key("fibre_angle"));
        let others = case.get_mut("materials").and_then(Value::as_object_mut);
        for (own, other) in others.into_iter().flatten() {
            let Some(keys) = other.as_object_mut() else { continue };
            let Some(name) = keys.get("material").and_then(Value::as_str) else { continue };
            let path = root("materials").key(own).key("material");
            let found = self.material(name, path.clone(), &mut faults).copied();
            let Some(mut material) = found else { continue };
            if has_fibres {
                faults
                    .error(path, "materials of a library have no fibres")
                    .hint("say how stiff the region is by its `stiffness_factor`, and where its fibres run by its `fibre_angle`");
                continue;
            }
            let heavier = material.density.filter(|own| weighs && Some(*own) != density);
            if !is_frame {
                give(keys, [("density", heavier)]);
            } else if heavier.is_some() {
                let message = format!(
                    "`{name}` has a density of its own, and `gravity` and `spin` know that of the case alone"
                );
                let hint = "give the moduli here, without `material`, if its weight may be that of the rest";
                faults.error(root("materials").key(own).key("material"), message).hint(hint);
            }
            match is_frame {
                // Members have no ratio of their own.
                true => (material.shear_modulus, material.poisson_ratio) = (material.shear(), None),
                // Regions of bonds have none, either; they say none where it is that of the model.
                false => material.poisson_ratio = material.poisson_ratio.filter(|own| Some(*own) != ratio),
            }
            give(keys, material.moduli(keys));
            give(keys, [("thermal_expansion", material.thermal_expansion)]);
        }
        for key in ["model", "body"] {
            if let Some(value) = case.get_mut(key) {
                self.place(value, &root(key), &mut faults);
            }
        }
        if faults.has_errors() { Err(faults) } else { Ok(()) }
    }

    /// Puts the shapes of profiles where sections name them.
    fn place(&self, value: &mut Value, path: &JsonPath, faults: &mut Faults) {
        if let Some(name) = value.get("rolled").and_then(Value::as_str) {
            match self.profiles.get(name) {
                Some(section) => *value = serde_json::to_value(section).unwrap_or_default(),
                None if Rolled::of(name).is_some() => {}
                None => {
                    let own: Vec<&str> = self.profiles.keys().map(String::as_str).collect();
                    let rolled: Vec<&str> = Rolled::names().collect();
                    let alike = suggest(name, own.iter().chain(&rolled).copied());
                    let known = || format!("the library has {}", own.join(", "));
                    let message = format!("`{name}` is no rolled section, and no profile of the library");
                    let hint = if alike.starts_with("did you") { alike } else { known() };
                    faults.error(path.key("rolled"), message).hint(hint);
                }
            }
            return;
        }
        match value {
            Value::Object(map) => map.iter_mut().for_each(|(key, v)| self.place(v, &path.key(key), faults)),
            Value::Array(list) => {
                list.iter_mut().enumerate().for_each(|(k, v)| self.place(v, &path.index(k), faults));
            }
            _ => {}
        }
    }
}

impl Material {
    fn check(&self, path: &JsonPath, faults: &mut Faults) {
        let numbers = [
            ("youngs_modulus", self.youngs_modulus),
            ("shear_modulus", self.shear_modulus),
            ("density", self.density),
        ];
        for (key, value) in numbers.into_iter().filter_map(|(key, value)| Some((key, value?))) {
            positive(value, key, path.key(key), faults);
        }
        if let Some(nu) = self.poisson_ratio.filter(|nu| !(*nu > -1.0 && *nu <= 0.5)) {
            let message = format!("`poisson_ratio` must be above -1 and at most 0.5, found {nu}");
            faults.error(path.key("poisson_ratio"), message);
        }
        if self.youngs_modulus.and(self.poisson_ratio).and(self.shear_modulus).is_some() {
            let message = "`youngs_modulus`, `poisson_ratio` and `shear_modulus` are all given";
            faults.error(path.clone(), message).hint("one follows from the others: remove it");
        }
        if *self == Self::default() {
            faults
                .error(path.clone(), "this material has no properties")
                .hint("give `youngs_modulus` and `poisson_ratio`");
        }
    }

    /// G, also from E and ν.
    fn shear(&self) -> Option<f64> {
        let isotropic = self.youngs_modulus.zip(self.poisson_ratio).map(|(e, nu)| e / (2.0 * (1.0 + nu)));
        self.shear_modulus.or(isotropic)
    }

    /// Its moduli, but none that contradicts one of some keys.
    fn moduli(&self, keys: &Map<String, Value>) -> [(&'static str, Option<f64>); 3] {
        let without = |key: &str, value: Option<f64>| value.filter(|_| !keys.contains_key(key));
        [
            ("youngs_modulus", self.youngs_modulus),
            ("poisson_ratio", without("shear_modulus", self.poisson_ratio)),
            ("shear_modulus", without("poisson_ratio", self.shear_modulus)),
        ]
    }
}

/// Adds a fault of a profile that cannot be, or has the name of a rolled section.
fn check(name: &str, section: &Section, path: &JsonPath, faults: &mut Faults) {
    if Rolled::of(name).is_some() {
        let message = format!("`{name}` is the name of a rolled section");
        faults
            .error(path.clone(), message)
            .hint("give it a name of its own; `peristat list profiles` has those taken");
    }
    if let Err(error) = section.properties(ShearCorrection::Classical, 0.0) {
        faults.error(path.clone(), error.to_string());
    }
}

/// Whether a load of a list, or of a list of load cases, is that of a mass.
fn weighs(loads: &Value) -> bool {
    let is_mass = |load: &Value| ["gravity", "spin"].iter().any(|key| load.get(key).is_some());
    let mut all = loads.as_array().into_iter().flatten();
    all.any(|load| is_mass(load) || load.get("loads").is_some_and(weighs))
}

/// The keys of the model of a case.
fn model_of(case: &mut Map<String, Value>) -> Option<&mut Map<String, Value>> {
    case.get_mut("model")?.as_object_mut()?.values_mut().next()?.as_object_mut()
}

/// Adds numbers to keys that are not there.
fn give<const N: usize>(keys: &mut Map<String, Value>, numbers: [(&str, Option<f64>); N]) {
    for (key, value) in numbers.into_iter().filter_map(|(key, value)| Some((key, value?))) {
        keys.entry(key).or_insert(value.into());
    }
}
