//! Parts of a body one cell wide beside slots.
//!
//! Bonds end at slots, but those of single rows of cells stay: nothing else would hold the row. So a slot beside one acts as if
//! it were filled.

use crate::scene::body::scene::BodyScene;
use peristat_assembly::body::Outline;
use peristat_assembly::model::plane::{Edges, thin_points};

/// A part of a body one cell wide, with bonds across what is beside it.
pub(crate) struct Bridge {
    /// A point of it.
    pub(crate) place: [f64; 3],
    /// How many points there are of this kind.
    pub(crate) points: usize,
    /// Names of the borders beside the point, where they are drawn.
    pub(crate) between: Vec<String>,
}

/// The first part of this kind and all of their points.
pub(crate) fn narrow(scene: &BodyScene) -> Option<Bridge> {
    let (lattice, mirrors) = scene.model.lattice()?;
    if scene.model.edges() == Some(Edges::Border) && lattice.blocks().is_empty() {
        // Bonds that leave the body end there.
        return None;
    }
    let points = thin_points(lattice, mirrors, &scene.inputs.material.offsets().ok()?);
    let point = *points.get(points.len() / 2)?;
    let place = scene.model.position(point);
    let beside = |outline| beside(outline, [place[0], place[1]], lattice.spacing());
    Some(Bridge { place, points: points.len(), between: scene.outline().map_or(Vec::new(), beside) })
}

/// Names of the edges and holes within a spacing of a place, the nearest first.
fn beside(outline: &Outline, at: [f64; 2], spacing: f64) -> Vec<String> {
    let holes = outline.holes().iter().enumerate().map(|(k, hole)| {
        let name = hole.name.clone().unwrap_or_else(|| format!("hole {}", k + 1));
        (hole.shape.distance(at), name)
    });
    let edges = outline.edges().iter().map(|edge| (edge.distance(at), edge.name.clone()));
    let mut near: Vec<(f64, String)> = holes.chain(edges).filter(|near| near.0 <= spacing).collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    near.into_iter().map(|near| near.1).collect()
}
