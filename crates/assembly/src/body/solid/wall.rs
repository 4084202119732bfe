//! Named parts of the border of a solid, made of sides of cells.

use super::super::BORDER;
use super::super::lattice::{SquareLattice, plus};
use super::cut::Cut;
use super::shape::{Face, SIDES, SolidShape};
use super::surface::{Patch, WallSide};

/// A face of a block, the border of a part that is cut out of it, or a part of the surface around a body. No side of a cell is in two of
/// them: one between the body and several parts that overlap is in the first, and where a round body touches a face of its block, the
/// sides are those of the round body.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Its name.
    pub name: String,
    /// Where it is.
    pub kind: WallKind,
    /// What it is of a surface, if the body has one.
    patch: Option<Patch>,
    /// Borders of other parts that come first.
    before: Vec<NamedCut>,
    /// Faces that the body goes on behind.
    mirrored: Vec<Face>,
}

/// A part that is cut out of a block and has a name.
#[derive(Clone, Copy, Debug, PartialEq)]
struct NamedCut {
    cut: Cut,
    /// Lowest and highest corner of the block, m.
    block: [[f64; 3]; 2],
}

/// What a wall is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallKind {
    /// A plane across an axis: a face of the block, or a flat part of the surface around the body.
    Face(Face),
    /// The border of a cut.
    Cut {
        /// The cut.
        cut: Cut,
        /// Lowest and highest corner of the block, m.
        block: [[f64; 3]; 2],
    },
    /// A part of the surface around the body that is no plane across an axis.
    Surface,
}

impl NamedCut {
    /// Whether a side of a cell, beyond which no cell is, is between the body and the cut.
    fn has(&self, side: &Side, lattice: &SquareLattice) -> bool {
        let (middle, half, slack) =
            (side.middle(lattice), 0.5 * lattice.spacing(), BORDER * lattice.spacing());
        let normal = side.normal();
        let at = [0, 1, 2].map(|k| middle[k] + half * normal[k]);
        let [low, high] = self.block;
        match (0..3).all(|k| low[k] < at[k] && at[k] < high[k]) {
            true => self.cut.contains(at, slack),
            // The faces of the block go on beside holes in it, and on a round body that is cut off at them.
            false => self.cut.is_outside() && self.cut.contains(middle, slack),
        }
    }
}

/// A side of a cell on the border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// Point of the cell.
    pub point: usize,
    /// Axis across it.
    pub axis: usize,
    /// Whether the body is below it along its axis.
    pub is_high: bool,
}

impl Side {
    /// Unit normal that points out of the body.
    pub fn normal(&self) -> [f64; 3] {
        let mut normal = [0.0; 3];
        normal[self.axis] = if self.is_high { 1.0 } else { -1.0 };
        normal
    }

    /// Its middle, m.
    pub fn middle(&self, lattice: &SquareLattice) -> [f64; 3] {
        let mut at = lattice.position(self.point);
        at[self.axis] += 0.5 * lattice.spacing() * self.normal()[self.axis];
        at
    }

    /// One cell from it out of the body.
    pub fn outwards(&self) -> [i32; 3] {
        let mut step = [0; 3];
        step[self.axis] = if self.is_high { 1 } else { -1 };
        step
    }
}

impl Wall {
    /// The face, if it is one.
    pub fn face(&self) -> Option<&Face> {
        match &self.kind {
            WallKind::Face(face) => Some(face),
            WallKind::Cut { .. } | WallKind::Surface => None,
        }
    }

    /// Its radius, m, if it is round, so that sides of cells make stairs of it.
    pub fn radius(&self) -> Option<f64> {
        match self.kind {
            WallKind::Cut { cut: Cut::Ball { radius, .. } | Cut::Bore { radius, .. }, .. } => Some(radius),
            _ => None,
        }
    }

    /// A part of a surface, which may be a plane across an axis.
    pub(super) fn of_surface(name: String, face: Option<Face>, patch: Patch) -> Self {
        let kind = face.map_or(WallKind::Surface, WallKind::Face);
        Self { name, kind, patch: Some(patch), before: Vec::new(), mirrored: Vec::new() }
    }

    /// What it is of a surface, if the body has one.
    pub fn patch(&self) -> Option<&Patch> {
        self.patch.as_ref()
    }

    /// Takes faces for planes of symmetry: a cut or a part of a surface that reaches them has no border there.
    pub fn mirror(&mut self, faces: &[Face], lattice: &SquareLattice) {
        if let Some(patch) = &mut self.patch {
            // The side of the box itself stays a region.
            let is_other = |face: &&Face| SIDES[2 * face.axis + usize::from(face.is_high)] != self.name;
            let faces: Vec<Face> = faces.iter().filter(is_other).copied().collect();
            patch.mirror(&faces, lattice);
        } else if self.face().is_none() {
            self.mirrored = faces.to_vec();
        }
    }

    /// Its sides of cells, in the order of their points.
    pub fn sides(&self, lattice: &SquareLattice) -> Vec<Side> {
        if let Some(patch) = &self.patch {
            return patch.sides.iter().map(|side| side.0).collect();
        }
        let each = (0..lattice.points())
            .flat_map(|point| (0..6).map(move |k| Side { point, axis: k / 2, is_high: k % 2 == 1 }));
        each.filter(|side| self.has(side, lattice)).collect()
    }

    /// Its sides of cells with what they stand for of it. Those of a part of a surface have the sums of its area and of its area vector;
    /// other ones stand for themselves.
    pub fn areas(&self, lattice: &SquareLattice) -> Vec<WallSide> {
        if let Some(patch) = &self.patch {
            return patch.areas(lattice.spacing());
        }
        let area = lattice.spacing().powi(2);
        let own = |side: Side| WallSide { side, area, outwards: side.normal().map(|n| area * n) };
        self.sides(lattice).into_iter().map(own).collect()
    }

    fn has(&self, side: &Side, lattice: &SquareLattice) -> bool {
        let is_own = match self.kind {
            WallKind::Face(face) => face.has(side, lattice),
            WallKind::Cut { cut, block } => NamedCut { cut, block }.has(side, lattice),
            WallKind::Surface => false,
        };
        let is_border = || lattice.number(plus(lattice.cell(side.point), side.outwards())).is_none();
        // Most sides lie on other faces, which is known before their neighbours are looked up.
        is_own
            && is_border()
            && !self.before.iter().any(|other| other.has(side, lattice))
            && !self.mirrored.iter().any(|face| face.has(side, lattice))
    }
}

impl Face {
    /// Whether a side of a cell lies on it.
    pub fn has(&self, side: &Side, lattice: &SquareLattice) -> bool {
        let slack = 1e-6 * lattice.spacing();
        (side.axis, side.is_high) == (self.axis, self.is_high)
            && (side.middle(lattice)[self.axis] - self.at).abs() <= slack
    }
}

impl SolidShape {
    /// Its faces, in the order of [`SIDES`](super::SIDES), and the borders of cuts that have names.
    pub fn walls(&self) -> Vec<Wall> {
        let block = self.bounds();
        let named = self.cuts.iter().filter_map(|(name, cut)| Some((name.as_ref()?, *cut)));
        let named: Vec<(&String, NamedCut)> =
            named.map(|(name, cut)| (name, NamedCut { cut, block })).collect();
        let all: Vec<NamedCut> = named.iter().map(|(_, cut)| *cut).collect();
        let face = |(name, face): (&str, Face)| Wall {
            name: name.to_string(),
            kind: WallKind::Face(face),
            patch: None,
            before: all.clone(),
            mirrored: Vec::new(),
        };
        let cut = |(k, (name, cut)): (usize, &(&String, NamedCut))| Wall {
            name: (*name).clone(),
            kind: WallKind::Cut { cut: cut.cut, block },
            patch: None,
            before: all[..k].to_vec(),
            mirrored: Vec::new(),
        };
        let faces = SIDES.into_iter().zip(self.faces()).map(face);
        faces.chain(named.iter().enumerate().map(cut)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block of 6 x 6 x 4 cells of side 0.5 with a square hole through it and a ball in a corner.
    fn shape() -> SolidShape {
        let mut shape = SolidShape::block([0.0; 3], [3.0, 3.0, 2.0]).unwrap();
        let hole = Cut::Block { from: [1.0, 1.0, 0.0], to: [2.0, 2.0, 2.0] };
        shape.cut(Some("hole".into()), hole).unwrap();
        shape
            .cut(Some("corner".into()), Cut::Ball { centre: [3.0; 3], radius: 1.4, outside: false })
            .unwrap();
        shape
    }

    #[test]
    fn walls_of_cuts_have_the_sides_between_body_and_cut_alone() {
        let shape = shape();
        let (lattice, walls) = (shape.fill(0.5).unwrap(), shape.walls());
        let wall = |name: &str| walls.iter().find(|wall| wall.name == name).unwrap().sides(&lattice);
        // Four sides of 2 x 4 cells.
        let hole = wall("hole");
        assert_eq!(hole.len(), 32);
        for side in &hole {
            // Out of the body is towards the middle of the hole.
            let (at, normal) = (side.middle(&lattice), side.normal());
            assert!((0..3).map(|k| (1.5 - at[k]) * normal[k]).sum::<f64>() > 0.49, "{side:?}");
        }
        // The pressure on an eighth of a ball has the same force along every axis, and the faces of the block have none of it.
        let corner = wall("corner");
        let sums = [0, 1].map(|axis| corner.iter().filter(|s| s.axis == axis && s.is_high).count());
        assert_eq!(sums[0], sums[1]);
        assert!(corner.iter().all(|side| side.is_high));
        assert_eq!(wall("left").len(), 6 * 4);
        // Less than 24 at the corner, and the rest of the border is that of the ball.
        let right = wall("right").len();
        assert!(right < 24 && right + sums[0] == 24, "{right} {sums:?}");
    }

    #[test]
    fn no_side_is_in_two_walls_and_all_of_the_border_is_in_one() {
        let mut shape = SolidShape::block([0.0; 3], [4.0; 3]).unwrap();
        let ball = Cut::Ball { centre: [2.0; 3], radius: 2.6, outside: true };
        shape.cut(Some("ball".into()), ball).unwrap();
        for (name, axis) in [("one", 0), ("two", 1)] {
            let bore = Cut::Bore { axis, centre: [2.0; 3], radius: 0.9, outside: false };
            shape.cut(Some(name.into()), bore).unwrap();
        }
        let lattice = shape.fill(0.4).unwrap();
        let sides: Vec<Side> = shape.walls().iter().flat_map(|wall| wall.sides(&lattice)).collect();
        let twice = sides.iter().enumerate().filter(|(k, side)| sides[..*k].contains(side)).count();
        assert_eq!(twice, 0);
        let all = (0..lattice.points()).flat_map(|point| (0..6).map(move |k| (point, k)));
        let border = all.filter(|&(point, k)| {
            let side = Side { point, axis: k / 2, is_high: k % 2 == 1 };
            lattice.number(plus(lattice.cell(point), side.outwards())).is_none()
        });
        assert_eq!(sides.len(), border.count());
        // The ball is cut off at the faces, which keep their sides.
        assert!(shape.walls()[..6].iter().all(|face| face.sides(&lattice).len() > 20));
    }
}
