//! A plate in bending as a model with three unknowns per point.

use super::nodes::PlateNodes;
use super::part::Part;
use super::sections::CellSections;
use super::{PlateError, PlateParameters, PlateSection};
use crate::body::SquareLattice;
use crate::bonds::Point;
use crate::condition::Equation;
use crate::model::{Component, Model, Points, RigidMotion};
use crate::stiffness::Term;
use std::sync::Arc;

/// A plate in bending.
#[derive(Clone, Debug)]
pub struct PlateBending {
    nodes: PlateNodes,
    sections: Arc<CellSections>,
    parts: Vec<Part>,
    /// Bonds that every point has lost; empty as long as none has broken.
    pub(super) cut: Vec<f64>,
}

const COMPONENTS: [Component; 3] =
    [Component::displacement("w", 2), Component::rotation("phi_x", 1.0), Component::rotation("phi_y", 1.0)];

const RIGID_MOTIONS: [RigidMotion; 3] = [
    RigidMotion::translation("translation along z", "move across its plane"),
    RigidMotion::rotation("tilt along x", "tilt along x about {centre}"),
    RigidMotion::rotation("tilt along y", "tilt along y about {centre}"),
];

impl PlateBending {
    /// The plate of some square cells.
    ///
    /// # Errors
    /// [`PlateError`].
    pub fn new(cells: Arc<SquareLattice>, parameters: PlateParameters) -> Result<Self, PlateError> {
        Self::of_sections(cells, parameters, CellSections::default())
    }

    /// The same where some of the cells have other sections.
    ///
    /// # Errors
    /// [`PlateError`].
    pub fn of_sections(
        cells: Arc<SquareLattice>,
        parameters: PlateParameters,
        sections: CellSections,
    ) -> Result<Self, PlateError> {
        Self::on(PlateNodes::new(cells)?, parameters, sections)
    }

    /// The same on points that are there already.
    pub(super) fn on(
        nodes: PlateNodes,
        parameters: PlateParameters,
        sections: CellSections,
    ) -> Result<Self, PlateError> {
        let all = [parameters.section].into_iter().chain(sections.others.iter().copied()).enumerate();
        let part = |(number, section): (usize, PlateSection)| {
            let inside = |cell: [i32; 2]| sections.has(&nodes, number, cell);
            Part::new(&nodes, PlateParameters { section, ..parameters }, &inside)
        };
        let parts = all.map(part).collect::<Result<_, _>>()?;
        Ok(Self { nodes, sections: Arc::new(sections), parts, cut: Vec::new() })
    }

    /// Its parameters, with the section of cells that have no other.
    pub fn parameters(&self) -> &PlateParameters {
        &self.parts[0].parameters
    }

    /// The section of a number, the base first.
    pub fn section(&self, number: usize) -> &PlateSection {
        &self.parts[number].parameters.section
    }

    /// Its points and cells.
    pub fn nodes(&self) -> &PlateNodes {
        &self.nodes
    }

    /// The sections of its cells.
    pub fn sections(&self) -> &CellSections {
        &self.sections
    }

    /// Number of bonds that are whole, or half along an edge or a step.
    pub fn bonds(&self) -> usize {
        self.parts.iter().map(|part| part.bonds.elements()).sum()
    }

    /// Number of pieces of bonds that leave the body or cross a step.
    pub fn pieces(&self) -> usize {
        self.parts.iter().map(Part::pieces).sum()
    }

    pub(super) fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// Takes a bond between next points out of a part, by the index of its offset and its lower point, and the triangles beside it.
    pub(super) fn cut_bond(&mut self, part: usize, (offset, lower): (usize, usize)) {
        if let Some((ends, factor)) = self.parts[part].cut_bond(&self.nodes, (offset, lower)) {
            self.cut.resize(self.nodes.points(), 0.0);
            ends.iter().for_each(|&point| self.cut[point] += factor);
        }
    }
}

impl Points for PlateBending {
    fn points(&self) -> usize {
        self.nodes.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.nodes.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<3> for PlateBending {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        self.parts.iter().flat_map(Part::terms).collect()
    }

    fn contrast(&self) -> f64 {
        self.contrast_of_points()
    }

    fn contrast_of_points(&self) -> f64 {
        // A section that no cell has does not count.
        let used = || self.parts.iter().filter(|part| part.bonds.elements() > 0);
        let bending = || used().map(|part| part.parameters.section.bending);
        let largest = bending().fold(0.0, f64::max);
        (largest / bending().fold(largest, f64::min)).sqrt()
    }

    fn relations(&self) -> Vec<Equation> {
        Vec::new()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        let [x, y] = self.nodes.place(point);
        match kind {
            0 => [1.0, 0.0, 0.0],
            1 => [x - centre[0], 1.0, 0.0],
            _ => [y - centre[1], 0.0, 1.0],
        }
    }
}
