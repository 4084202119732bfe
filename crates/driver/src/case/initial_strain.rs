//! Strains without stress that members and bodies have from the beginning.

use super::Amount;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a line, a member or a region of a body would be strained by if nothing held it: prestress, misfit, swelling, shrinkage. Of a
/// line or member give one of `strain`, `length` and `force`, or `curvature`, or both; of a body its components; of a plate in bending
/// those of its curvature.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InitialStrain {
    /// Member of a frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Strain of the axis, positive where it would be longer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strain: Option<f64>,
    /// By how much it is made longer than the distance of its ends; one that is too short has a negative one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Axial force that it has as long as its ends are held, such as that of a tendon: N > 0 is tension.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// Curvature, the derivative of phi along it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature: Option<f64>,
    /// Name of the region of a body that has it; the whole body if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Of a body: strain along x, a number or a formula of x, y and, in a solid, z. Of a plate in bending: the curvature `curvature_xx`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub xx: Option<Amount>,
    /// Of a body: strain along y, as that along x. Of a plate in bending: the curvature `curvature_yy`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yy: Option<Amount>,
    /// Of a solid, or of a body in plane strain: strain along z, as that along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zz: Option<Amount>,
    /// Of a body: half of the change of the angle between x and y, as the field `strain_xy`; as that along x. Of a plate in bending: the
    /// curvature `curvature_xy`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub xy: Option<Amount>,
    /// Of a solid: half of the change of the angle between y and z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yz: Option<Amount>,
    /// Of a solid: half of the change of the angle between x and z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub xz: Option<Amount>,
}

impl InitialStrain {
    /// Components of that of a body, by keys; shears are halves of changes of angles.
    pub(crate) fn components(&self) -> [(&'static str, &Option<Amount>); 6] {
        [
            ("xx", &self.xx),
            ("yy", &self.yy),
            ("zz", &self.zz),
            ("xy", &self.xy),
            ("yz", &self.yz),
            ("xz", &self.xz),
        ]
    }

    /// Which keys of a line or member it has.
    pub(crate) fn of_lines(&self) -> impl Iterator<Item = &'static str> {
        let keys = [
            ("member", self.member.is_some()),
            ("strain", self.strain.is_some()),
            ("length", self.length.is_some()),
            ("force", self.force.is_some()),
            ("curvature", self.curvature.is_some()),
        ];
        keys.into_iter().filter_map(|(key, is_given)| is_given.then_some(key))
    }
}
