//! Names of several parts of a border: edges, holes and sides of holes that conditions name together.

use super::hole::Shape;
use super::outline::{Edge, Outline};

/// A part of the border of an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BorderMember {
    /// An edge, by its number.
    Edge(usize),
    /// All around a hole, by its number.
    Hole(usize),
    /// An edge of a hole that is a polygon.
    HoleEdge {
        /// The number of the hole.
        hole: usize,
        /// The number of the edge.
        edge: usize,
    },
}

/// Parts of a border under one name.
#[derive(Clone, Debug, PartialEq)]
pub struct BorderGroup {
    /// The name.
    pub name: String,
    /// The parts, ascending, each once.
    pub members: Vec<BorderMember>,
    /// Whether it is worth a hint where a name is not found.
    pub is_known: bool,
}

impl BorderGroup {
    /// The chords of every side that has several edges.
    pub(super) fn of_curves(sides: &[usize]) -> Vec<Self> {
        let mut first = 0;
        let mut groups = Vec::new();
        for (k, &count) in sides.iter().enumerate() {
            if count > 1 {
                let members = (first..first + count).map(BorderMember::Edge).collect();
                groups.push(Self { name: format!("edge_{}", k + 1), members, is_known: true });
            }
            first += count;
        }
        groups
    }
}

impl Outline {
    /// Gives parts of the border a name. It hides an edge or hole that has the same; a later group hides an earlier one.
    pub fn name(&mut self, name: &str, members: Vec<BorderMember>) {
        self.group(name, members, true);
    }

    /// The same, of a name that no hint tells.
    pub fn name_aside(&mut self, name: &str, members: Vec<BorderMember>) {
        self.group(name, members, false);
    }

    fn group(&mut self, name: &str, mut members: Vec<BorderMember>, is_known: bool) {
        members.sort_unstable();
        members.dedup();
        self.groups.retain(|group| group.name != name);
        self.groups.push(BorderGroup { name: name.into(), members, is_known });
    }

    /// Names of several parts, or of one beside its own.
    pub fn groups(&self) -> &[BorderGroup] {
        &self.groups
    }

    /// The parts that a name has: those of a group, an edge or a hole.
    pub fn members(&self, name: &str) -> Option<Vec<BorderMember>> {
        if let Some(group) = self.groups.iter().find(|group| group.name == name) {
            return Some(group.members.clone());
        }
        if let Some(k) = self.edges().iter().position(|edge| edge.name == name) {
            return Some(vec![BorderMember::Edge(k)]);
        }
        let hole = self.holes().iter().position(|hole| hole.name.as_deref() == Some(name));
        hole.map(|k| vec![BorderMember::Hole(k)])
    }

    /// Whether an edge is what a name calls, or a part of it.
    pub fn calls(&self, name: &str, edge: &Edge) -> bool {
        let is_it = |member: &BorderMember| matches!(member, BorderMember::Edge(k) if self.edges()[*k].name == edge.name);
        name == edge.name || self.members(name).is_some_and(|members| members.iter().any(is_it))
    }

    /// An edge of a hole that is a polygon, as one of the body: its normal points into the hole.
    pub fn hole_edge(&self, hole: usize, edge: usize) -> Option<Edge> {
        let Shape::Polygon(polygon) = &self.holes().get(hole)?.shape else { return None };
        let [from, to] = (edge < polygon.vertices().len()).then(|| polygon.edge(edge))?;
        let normal = polygon.normal(edge).map(|n| 0.0 - n);
        Some(Edge { name: String::new(), from, to, normal, is_chord: true })
    }

    /// A part of the border that is straight.
    pub fn straight(&self, member: BorderMember) -> Option<Edge> {
        match member {
            BorderMember::Edge(k) => self.edges().get(k).cloned(),
            BorderMember::HoleEdge { hole, edge } => self.hole_edge(hole, edge),
            BorderMember::Hole(_) => None,
        }
    }

    /// Names that hints tell: chords have none of their own.
    pub fn border_names(&self) -> impl Iterator<Item = &str> {
        let edges = self.edges().iter().filter(|edge| !edge.is_chord).map(|edge| edge.name.as_str());
        let groups = self.groups.iter().filter(|group| group.is_known).map(|group| group.name.as_str());
        edges.chain(groups).chain(self.holes().iter().filter_map(|hole| hole.name.as_deref()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Hole, Polygon};

    fn outline() -> Outline {
        let vertices = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [6.0, 5.5], [4.0, 6.0], [0.0, 6.0]];
        let mut outline = Outline::curved(vertices, &[1, 1, 2, 1, 1]).unwrap();
        let square = Polygon::new(vec![[2.0, 2.0], [4.0, 2.0], [4.0, 4.0], [2.0, 4.0]]).unwrap();
        outline.cut(Hole { name: Some("window".into()), shape: Shape::Polygon(square) }).unwrap();
        outline
    }

    #[test]
    fn chords_have_the_name_of_their_curve() {
        let outline = outline();
        let names: Vec<&str> = outline.border_names().collect();
        assert_eq!(names, ["edge_1", "edge_2", "edge_4", "edge_5", "edge_3", "window"]);
        assert_eq!(outline.members("edge_3"), Some(vec![BorderMember::Edge(2), BorderMember::Edge(3)]));
        assert!(
            outline.calls("edge_3", &outline.edges()[2]) && !outline.calls("edge_3", &outline.edges()[1])
        );
        assert_eq!(outline.members("window"), Some(vec![BorderMember::Hole(0)]));
        assert_eq!(outline.members("roof"), None);
    }

    #[test]
    fn edges_of_holes_look_into_the_hole() {
        let mut outline = outline();
        let bottom = BorderMember::HoleEdge { hole: 0, edge: 0 };
        outline.name("sill", vec![bottom, bottom]);
        assert_eq!(outline.members("sill"), Some(vec![bottom]));
        let edge = outline.straight(bottom).unwrap();
        assert_eq!((edge.from, edge.normal), ([2.0, 2.0], [0.0, 1.0]));
        assert_eq!(outline.hole_edge(0, 4), None);
        assert_eq!(outline.hole_edge(1, 0), None);
    }

    #[test]
    fn a_hole_takes_no_name_of_a_group() {
        let mut outline = outline();
        outline.name("sill", vec![BorderMember::Edge(0)]);
        let shape = Shape::Circle { centre: [6.0, 2.0], radius: 0.5 };
        assert!(outline.cut(Hole { name: Some("sill".into()), shape }).is_err());
    }
}
