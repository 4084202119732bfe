//! Faults of the regions that a case defines.

use super::ground::Ground;
use crate::case;
use crate::diagnostic::{Faults, JsonPath, suggest};
use peristat_assembly::body::RegionError;

impl Ground<'_> {
    /// Adds the fault of a region of the case.
    pub(super) fn refuse(&self, error: &RegionError, region: &str, path: &JsonPath, faults: &mut Faults) {
        let place = match (&self.case.regions[region], error) {
            (case::Region::Edge(_), RegionError::Unknown { .. }) => path.key("edge").key("name"),
            (case::Region::Face(_), RegionError::Unknown { .. }) => path.key("face").key("name"),
            (case::Region::Face(_), _) => path.key("face").key("depth"),
            (case::Region::Ball(_), RegionError::NotPositive { .. }) => path.key("ball").key("radius"),
            (case::Region::Cylinder(_), RegionError::NotPositive { .. }) => {
                path.key("cylinder").key("radius")
            }
            (case::Region::Cylinder(_), RegionError::Position { what }) => path.key("cylinder").key(*what),
            (case::Region::Cylinder(_), RegionError::NoLength) => path.key("cylinder").key("to"),
            (case::Region::HalfSpace(_), RegionError::Position { what }) => path.key("half_space").key(*what),
            (case::Region::Hole(_), RegionError::Unknown { .. }) => path.key("hole").key("name"),
            (case::Region::Group(_), _) => path.key("group"),
            (case::Region::Union(_), _) => path.key("union"),
            (case::Region::Edge(_), _) => path.key("edge").key("depth"),
            (case::Region::Hole(_), _) => path.key("hole").key("depth"),
            (case::Region::Disc(_), RegionError::NotPositive { .. }) => path.key("disc").key("radius"),
            (case::Region::HalfPlane(_), RegionError::Position { what }) => path.key("half_plane").key(*what),
            _ => path.clone(),
        };
        match error {
            RegionError::Unknown { kind, name, known } => {
                let (name, place) = self.missing(name, &self.case.regions[region], place);
                let hint = match (*kind, known.is_empty()) {
                    ("edge", true) => "edges are those of the bodies `rectangle` and `outline`".to_string(),
                    ("hole", true) => "no hole of the body has a name".into(),
                    ("group", true) => "groups are those of a mesh with named physical groups".into(),
                    _ => suggest(&name, known.iter().map(String::as_str)),
                };
                faults.error(place, format!("there is no {kind} `{name}`")).hint(hint);
            }
            RegionError::NotPositive { what, found } => {
                faults.error(place, format!("`{what}` must be greater than zero, found {found}"));
            }
            error => {
                faults.error(place, error.to_string());
            }
        }
    }

    /// The first name of a list that is unknown, and its place.
    fn missing(&self, name: &str, region: &case::Region, place: JsonPath) -> (String, JsonPath) {
        let case::Region::Edge(edge) = region else { return (name.into(), place) };
        let is_unknown = |name: &String| self.outline.is_none_or(|outline| outline.members(name).is_none());
        match edge.name.each().iter().position(is_unknown) {
            Some(k) if edge.name.is_list() => (edge.name.each()[k].clone(), place.index(k)),
            _ => (name.into(), place),
        }
    }
}
