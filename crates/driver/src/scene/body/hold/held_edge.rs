//! Edges along the lattice, held on their line.
//!
//! The force that holds an edge has to reach its points as the traction of a uniform stress does; any other sharing
//! disturbs the body within a horizon, which moves the held line by most of a spacing. So what is held is the
//! displacement that this traction does its work on: a weighted sum over the few points behind each other, in every row.
//! For a linear field this is the displacement of the edge.

use crate::model::{Material, Mixture, OnLattice};
use crate::scene::body::site::size::takes_shares;
use peristat_assembly::body::{Cell, Edge, Face, SquareLattice, plus};
use peristat_assembly::model::plane::{Edges, Mirrors};
use std::cell::OnceCell;

/// How an edge or a face is held.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldEdge {
    /// From its points to those behind them, cells.
    inward: Cell,
    /// Shares of the points behind each other in the displacement of the edge along x, along y and across, the outermost first.
    shares: [Vec<f64>; 3],
}

impl HeldEdge {
    /// A straight edge along a lattice; `None` for any other, and wherever a lattice is turned.
    pub(crate) fn new(edge: &Edge, lattice: &SquareLattice, shares: &EdgeShares) -> Option<Self> {
        if lattice.is_turned() {
            return None;
        }
        let axis = edge.normal.iter().position(|n| n.abs() > 1.0 - 1e-12)?;
        let mut inward = [0; 3];
        inward[axis] = if edge.normal[axis] > 0.0 { -1 } else { 1 };
        // Where the edge lies between the centres of cells.
        let at = (edge.from[axis] - lattice.corner()[axis]) / lattice.spacing();
        let between = (at - at.round()).abs() < 1e-6;
        let extent = if axis == 0 { lattice.columns() } else { lattice.rows() };
        let about = shares.material.about();
        let [normal, tangential] = match between && about.is_exact_at_edges {
            // What moves the border is linear in the two outermost points.
            true if about.edges == Some(Edges::Border) => [vec![1.5, -0.5], vec![1.5, -0.5]],
            // The traction reaches behind all points: whatever its shares, they are held themselves.
            true if !takes_shares(extent.len(), about.horizon_ratio) => [vec![1.0], vec![1.0]],
            true => shares.found()?.clone(),
            // The other treatments are not exact at edges: a line through two points is good enough.
            false => [vec![1.5, -0.5], vec![1.5, -0.5]],
        };
        let [x, y] = if axis == 0 { [normal, tangential] } else { [tangential, normal] };
        Some(Self { inward, shares: [x, y, Vec::new()] })
    }

    /// An end of a developed cylinder, whose border moves with the two outermost points behind each other; none of its sides.
    pub(super) fn of_cylinder(edge: &Edge) -> Option<Self> {
        let is_end = edge.normal[0].abs() > 1.0 - 1e-12;
        let inward = [if edge.normal[0] > 0.0 { -1 } else { 1 }, 0, 0];
        is_end.then(|| Self { inward, shares: [(); 3].map(|()| vec![1.5, -0.5]) })
    }

    /// A face of a solid, whose border moves with the two outermost points behind each other.
    pub(super) fn of_face(face: &Face) -> Self {
        let mut inward = [0; 3];
        inward[face.axis] = if face.is_high { -1 } else { 1 };
        Self { inward, shares: [(); 3].map(|()| vec![1.5, -0.5]) }
    }

    /// The points behind each of some ascending points of the edge; none where there are too few, or where they are points
    /// of the edge themselves: then the point itself is held.
    pub(crate) fn chains(&self, lattice: &SquareLattice, points: &[u32]) -> Vec<Vec<u32>> {
        let depth = self.shares.iter().map(Vec::len).max().unwrap_or(1) as i32;
        let chain = |&point: &u32| {
            let cell = lattice.cell(point as usize);
            let behind = |k: i32| lattice.number(plus(cell, self.inward.map(|step| k * step)));
            let chain: Option<Vec<u32>> = (1..depth).map(|k| behind(k).map(|p| p as u32)).collect();
            chain.filter(|c| c.iter().all(|p| points.binary_search(p).is_err())).unwrap_or_default()
        };
        points.iter().map(chain).collect()
    }

    /// Shares of the displacement along a component, the outermost point first; where points move across the plane alone both are
    /// the same.
    pub(crate) fn shares(&self, component: usize) -> &[f64] {
        &self.shares[component.min(1)]
    }
}

/// The shares that the points behind an edge have in it: the same for all edges of a body, and found when one asks for them.
pub(crate) struct EdgeShares<'a> {
    material: &'a dyn Material,
    found: OnceCell<Option<[Vec<f64>; 2]>>,
}

impl<'a> EdgeShares<'a> {
    /// Shares of some material.
    pub(crate) fn new(material: &'a dyn Material) -> Self {
        Self { material, found: OnceCell::new() }
    }

    /// Across and along the edge.
    fn found(&self) -> Option<&[Vec<f64>; 2]> {
        self.found.get_or_init(|| shares(self.material)).as_ref()
    }
}

/// How the traction of a stress on the left side of a body reaches the points behind each other, far from its other sides:
/// for one across the side, and one along it.
fn shares(material: &dyn Material) -> Option<[Vec<f64>; 2]> {
    /// Below this part of the whole it is rounding.
    const ROUNDING: f64 = 1e-12;
    let depth = material.depth().ok()?;
    // How far a side is felt: families join points two horizons apart, and ghosts those two cells further.
    let felt = if material.about().has_families { 2 * depth + 4 } else { depth + 2 };
    let (columns, rows) = (2 * felt, 2 * felt + 1);
    let real = SquareLattice::rectangle(1.0, [0.0; 2], [columns, rows]);
    let mut straight = material.boxed();
    straight.unroll();
    let on = OnLattice {
        real: &real,
        mirrors: Mirrors::NONE,
        materials: &Mixture::default(),
        cuts: &|_, _| Vec::new(),
        separated: &|_, _| false,
    };
    let body = straight.on_lattice(&on).ok()?;
    let (n, (lattice, _)) = (body.points(), body.lattice()?);
    let of = |stress: [f64; 3], component: usize| {
        let mut force = vec![0.0; body.components().len() * n];
        body.as_plane()?.add_stress_load(None, &|_, _| stress, &mut force);
        body.fold(&mut force);
        let at = |column: i32| lattice.number([column, rows / 2, 0]).map(|p| force[component * n + p]);
        let forces: Vec<f64> = (0..columns / 2).map(at).collect::<Option<_>>()?;
        let total: f64 = forces.iter().sum();
        let last = forces.iter().rposition(|f| f.abs() > ROUNDING * total.abs())?;
        (forces[0] != 0.0).then(|| forces[..=last].iter().map(|f| f / total).collect())
    };
    if body.along(0).is_none() {
        // The shear that goes across the plane, through the edge.
        let across: Vec<f64> = of([1.0, 0.0, 0.0], 0)?;
        return Some([across.clone(), across]);
    }
    Some([of([1.0, 0.0, 0.0], 0)?, of([0.0, 0.0, 1.0], 1)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Faults;
    use crate::model::{Asked, BodyKind, Model};
    use peristat_assembly::body::Outline;
    use serde_json::{Value, json};

    fn material(model: Value, horizon_ratio: f64) -> Box<dyn Material> {
        let model: Model = serde_json::from_value(model).unwrap();
        let asked = Asked {
            body: BodyKind::Other,
            body_path: "body".into(),
            breaks: false,
            softens: false,
            has_cracks: false,
            materials: None,
            fibre_angles: Vec::new(),
            symmetry: &[],
            joined: Vec::new(),
        };
        let mut material = model.keys().unwrap().resolve(&asked, &mut Faults::default()).unwrap();
        material.set_horizon_ratio(horizon_ratio);
        material
    }

    fn bonds(horizon_ratio: f64) -> Box<dyn Material> {
        let keys =
            json!({ "youngs_modulus": 7.0, "thickness": 0.3, "state": "plane_stress", "edges": "overlay" });
        material(json!({ "bond_plane": keys }), horizon_ratio)
    }

    #[test]
    fn an_edge_beside_turned_rows_is_held_by_its_points() {
        let outline = Outline::rectangle([0.0; 2], [20.0, 10.0]).unwrap();
        let lattice = outline.fill_turned(1.0, 0.3).unwrap();
        assert_eq!(
            HeldEdge::new(outline.edge("left").unwrap(), &lattice, &EdgeShares::new(&*bonds(3.0))),
            None
        );
    }

    #[test]
    fn shares_are_of_one_force_on_the_line_of_the_edge() {
        for horizon_ratio in [2.0, 3.0, 4.5] {
            let bonds = bonds(horizon_ratio);
            let outline = Outline::rectangle([0.0; 2], [20.0, 10.0]).unwrap();
            let lattice = outline.fill(1.0).unwrap();
            for (name, inward) in [("left", [1, 0, 0]), ("top", [0, -1, 0])] {
                let held =
                    HeldEdge::new(outline.edge(name).unwrap(), &lattice, &EdgeShares::new(&*bonds)).unwrap();
                assert_eq!(held.inward, inward);
                for shares in &held.shares[..2] {
                    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                    // Centres are half a spacing, and more, behind the edge: the moment about it is zero.
                    let moment: f64 = shares.iter().enumerate().map(|(k, s)| s * (k as f64 + 0.5)).sum();
                    assert!(moment.abs() < 1e-13, "{moment}");
                }
            }
        }
    }

    #[test]
    fn points_of_thin_bodies_are_held_as_the_shares_have_it() {
        // The longest bonds of the influence `linear` have no weight.
        let family = |horizon_ratio: f64| {
            let keys = json!({ "youngs_modulus": 7.0, "poisson_ratio": 0.2, "thickness": 0.3,
                "state": "plane_stress", "influence": "linear", "edges": "ghosts" });
            material(json!({ "state_plane": keys }), horizon_ratio)
        };
        for horizon_ratio in [2.0, 3.0, 4.0, 4.5, 5.0, 6.0] {
            for bonds in [bonds(horizon_ratio), family(horizon_ratio)] {
                let held = |columns: f64| {
                    let outline = Outline::rectangle([0.0; 2], [columns, 4.0]).unwrap();
                    let lattice = outline.fill(1.0).unwrap();
                    let shares = EdgeShares::new(&*bonds);
                    let held = HeldEdge::new(outline.edge("left").unwrap(), &lattice, &shares).unwrap();
                    (lattice, held)
                };
                let (_, wide) = held(30.0);
                for columns in 1..10 {
                    let (lattice, thin) = held(f64::from(columns));
                    let points: Vec<u32> =
                        (0..4).map(|row| lattice.number([0, row, 0]).unwrap() as u32).collect();
                    let found = thin.chains(&lattice, &points);
                    assert_eq!(found, wide.chains(&lattice, &points), "{horizon_ratio} {columns}");
                }
            }
        }
    }
}
