//! The model `timoshenko_beam` of a case.

use super::super::LoadSharing;
use super::{PowerLaw, Stiffness};
use peristat_assembly::material::{Section, ShearCorrection};
use peristat_assembly::model::timoshenko_beam::{VolumeFactor, bond_law, end_treatment};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// A Timoshenko beam. Give its sections by one of `section`, `stiffness` and `power_law`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beam {
    /// Young's modulus E, > 0; with `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub youngs_modulus: Option<f64>,
    /// Poisson's ratio ν, between −1 and 1/2; G = E/(2(1 + ν)). Give this or `shear_modulus`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// Shear modulus G, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_modulus: Option<f64>,
    /// Cross-section.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<Section>,
    /// Cross-section at the end of every line, of the same shape; dimensions vary linearly from those of `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_section: Option<Section>,
    /// Stiffness of the sections as numbers, instead of moduli and `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Stiffness>,
    /// A functionally graded section, instead of `youngs_modulus` and `section`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power_law: Option<PowerLaw>,
    /// Where the shear correction factor κ comes from; default: `classical`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_correction: Option<ShearCorrection>,
    /// Name of the law for the shear stiffness of a bond; default: `exact`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "bond_laws")]
    pub bond_law: Option<String>,
    /// Volume of points at the edge of the horizon.
    #[serde(default)]
    pub volume_factor: VolumeFactor,
    /// Name of the treatment of bonds that an end cuts off; default: `cover` on nodes, `ghost` on cells.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "end_treatments")]
    pub end_treatment: Option<String>,
    /// How distributed loads reach the points; default: `lumped` with a foundation or without the end treatment
    /// `cover`, else `consistent`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distributed_loads: Option<LoadSharing>,
}

fn one_of<'a>(names: impl Iterator<Item = &'a str>) -> Schema {
    let names: Vec<&str> = names.collect();
    json_schema!({ "type": "string", "enum": names })
}

fn bond_laws(_: &mut SchemaGenerator) -> Schema {
    one_of(bond_law::TABLE.iter().map(|l| l.name))
}

fn end_treatments(_: &mut SchemaGenerator) -> Schema {
    one_of(end_treatment::TABLE.iter().map(|t| t.name))
}
