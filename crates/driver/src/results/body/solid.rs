//! A solid in its report: all fields of a state, on the surface and on cuts through it.

use super::blocks::Blocks;
use super::report::fields;
use crate::case::FieldName;
use crate::output::report::{Bricks, Solid};
use crate::run::body::BodyResult;
use crate::scene::body::BodyScene;
use peristat_assembly::body::PointBody;

/// Blocks of a solid: as many as fields of them fit into the report, a cube of 64 cells along a side.
const MOST: usize = 64 * 64 * 64;

/// The solid of a state.
pub(super) fn solid(scene: &BodyScene, result: &BodyResult) -> Solid {
    let blocks = Blocks::new(scene.body(), |blocks| blocks.cells.len() <= MOST);
    let axes = [FieldName::Ux, FieldName::Uy, FieldName::Uz];
    let (fields, moves) = fields(scene, result, axes, &|values| blocks.means(values));
    let size = blocks.size;
    let between = |from: [i32; 3], to: [i32; 3]| {
        let [from, to] = [from, to].map(|node| blocks.place(node));
        [0, 1, 2].map(|k| to[k] - from[k])
    };
    let bricks = Bricks {
        origin: blocks.place([0; 3]),
        sides: [[f64::from(blocks.step) * blocks.side; 3], between(size.map(|s| s - 1), size)],
        size: size.map(|s| s as usize),
        spans: blocks.spans(),
    };
    Solid {
        title: String::new(),
        note: note(&blocks, scene),
        length: scene.units.length().into(),
        bricks,
        fields,
        moves,
    }
}

/// What a reader must know of the cells.
fn note(blocks: &Blocks, scene: &BodyScene) -> String {
    const ENDS: &str = "the colour bar ends at the extremes of all points.";
    match (scene.body(), blocks.step) {
        (PointBody::Cloud(_), _) => format!("Every cell is the mean of the points in it; {ENDS}"),
        (_, 1) => String::new(),
        (_, step) => format!(
            "Every cell is the mean of {step} × {step} × {step} points, so that the page stays small; {ENDS}"
        ),
    }
}
