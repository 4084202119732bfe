//! Whether bonds that differ from those inside of a body fit into memory, before they are made: with long horizons they are
//! far more than the points.

use super::cracks::NamedCrack;
use crate::case::Case;
use crate::diagnostic::{Faults, root, tidy};
use crate::memory;
use crate::model::{Material, Surface};
use peristat_assembly::body::{Outline, PointBody, SquareLattice};
use peristat_assembly::model::plane::{Edges, FARTHEST, Mirrors};
use std::f64::consts::PI;

// Bytes, measured on squares of 3600 and 14400 points with horizons of 10 and 20 spacings.
/// Of a bond that a crack cuts.
const CUT: f64 = 220.0;
/// Of a bond near an edge, where it has a factor of its own.
const OWN: f64 = 65.0;
/// Of a bond that ends on the border, those of coarser lattices among them. Measured 480 with a horizon of ten spacings.
const ENDED: f64 = 480.0;
/// Of a spacing of a border that cuts cells, and of each spacing of the horizon beside it. Measured 21 000 and 28 000 with
/// horizons of three and six spacings around 400 holes.
const CUT_BORDER: [f64; 2] = [18_000.0, 2000.0];
/// The same of each squared spacing of the horizon where bodies break: springs by the directions of bonds, and their matrix.
/// Measured 95 000, 394 000 and 1 230 000 with horizons of three, six and ten.
const CUT_SPRINGS: f64 = 12_500.0;
/// Of a bond of listed points while it is made. Measured 98 with four million of them.
const LISTED: f64 = 98.0;
/// The same in space, and of such a point with its tetrahedra. Measured 113 and 5500 with 41 472 points.
const LISTED_IN_SPACE: [f64; 2] = [120.0, 6000.0];
/// Of a spacing of a border that completes families, and of each squared spacing of the horizon beside it. Measured 24 000 and
/// 116 000 with horizons of three and six spacings around 64 holes.
const FAMILIES: [f64; 2] = [10_000.0, 3_200.0];
/// Of a neighbour in a family of its own.
const NEIGHBOUR: f64 = 180.0;
/// Of a bond of an image. Measured 49 between four mirrors, with 2 and 480 million of them; 56 between joined faces of a solid, with
/// 64 million.
const IMAGE: f64 = 50.0;
/// Of a neighbour on the strip that a held edge of families is known from. Measured 28 with a horizon of 20 spacings.
const STRIP: f64 = 28.0;

/// Bonds of `bonds` on a body.
pub(crate) fn fits(
    case: &Case,
    material: &dyn Material,
    (body, outline): (&PointBody, Option<&Outline>),
    (cracks, mirrors): (&[NamedCrack], &Mirrors),
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> bool {
    let about = material.about();
    let (m, points) = (about.horizon_ratio, body.points() as f64);
    let family = PI * m * m;
    let border = outline.map_or(points, |outline| length_of(outline) / body.spacing());
    let near = points.min(border * m);
    // Along straight edges families repeat themselves, and those of four corners are left.
    let is_plain = outline.is_some_and(|o| o.is_rectangle() && o.holes().is_empty());
    let distinct = if is_plain { near.min(4.0 * (m + 1.0) * (m + 1.0)) } else { near };
    let crack = cracks.iter().map(|c| length_inside(&c.crack, outline) / body.spacing()).sum::<f64>();
    let cut = CUT * (crack * 2.0 / 3.0 * m.powi(3)).min(0.5 * points * family);
    let own = match body {
        // Listed points may lie close together in places.
        PointBody::Cloud(cloud) if body.is_solid() => {
            let [of_pair, of_point] = LISTED_IN_SPACE;
            of_pair * cloud.about_pairs(m * body.spacing()) + of_point * points
        }
        PointBody::Cloud(cloud) => LISTED * cloud.about_pairs(m * body.spacing()),
        PointBody::Lattice(_) if about.has_families && about.edges == Some(Edges::Border) => {
            border * (FAMILIES[0] + FAMILIES[1] * m * m)
        }
        PointBody::Lattice(lattice) if about.has_families => {
            let sides = [lattice.columns().len(), lattice.rows().len()];
            let holds = about.is_exact_at_edges && !case.supports.is_empty();
            let strip = match holds && sides.iter().any(|&n| takes_shares(n, m)) {
                true => STRIP * 16.0 * m * m,
                false => 0.0,
            };
            // It is gone before the families are made.
            family * strip.max(NEIGHBOUR * points.min(distinct + crack * 2.0 * m))
        }
        PointBody::Lattice(lattice) if about.edges == Some(Edges::Border) && !lattice.blocks().is_empty() => {
            let breaks = case.fracture.is_some() || case.path.is_some();
            border * if breaks { CUT_SPRINGS * m * m } else { CUT_BORDER[0] + CUT_BORDER[1] * m }
        }
        PointBody::Lattice(_) if about.edges == Some(Edges::Border) && m < f64::from(FARTHEST + 1) => {
            ENDED * border * 2.0 / 3.0 * m.powi(3)
        }
        // Points beside the sides of shells have bonds of their own, those at the ends bonds that end there.
        PointBody::Lattice(_) if matches!(about.surface, Surface::Cylinder(_)) => {
            OWN * 0.5 * family * near + ENDED * border * 2.0 / 3.0 * m.powi(3)
        }
        _ if about.edges.is_some_and(Edges::is_exact) => 0.0,
        _ => OWN * 0.5 * family * near,
    };
    let of_images = match body {
        PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
            let images = images(mirrors, lattice, m);
            let family = if body.axes() > 2 { family * m * 4.0 / 3.0 } else { family };
            IMAGE * 0.5 * images * family.min(images + points)
        }
        PointBody::Cloud(_) => 0.0,
    };
    let key = if case.horizon.is_some() { "horizon" } else { "horizon_ratio" };
    let what = format!("bonds over a horizon of {} spacings", tidy(m));
    memory::fits(cut + own + of_images, (&what, "use a shorter horizon"), max_memory, root(key), faults)
}

/// Whether so many points behind each other can share an edge. Bonds of the length of the horizon may have no weight, so that
/// shares end a row or column before it.
pub(crate) fn takes_shares(extent: usize, horizon_ratio: f64) -> bool {
    extent as f64 + 2.0 > horizon_ratio
}

/// Points that are images, about: beyond every line there are as many rows, columns or layers of them as the horizon has, but behind
/// a single one no more than of the body.
fn images(mirrors: &Mirrors, lattice: &SquareLattice, m: f64) -> f64 {
    let sides = [lattice.columns(), lattice.rows(), lattice.layers()].map(|side| side.len() as f64);
    let grown = mirrors.lines.into_iter().zip(sides).map(|(lines, n)| match lines {
        [None, None] => 1.0,
        [Some(_), Some(_)] => 1.0 + 2.0 * m / n,
        _ => 1.0 + (m / n).min(1.0),
    });
    lattice.points() as f64 * (grown.product::<f64>() - 1.0)
}

/// Length of all borders, m.
fn length_of(outline: &Outline) -> f64 {
    let holes = outline.holes().iter().map(|h| h.shape.perimeter());
    outline.border().perimeter() + holes.sum::<f64>()
}

/// Length of a crack, m; of each of its straight parts no more than the box around the body has room for.
fn length_inside(crack: &peristat_assembly::body::Crack, outline: Option<&Outline>) -> f64 {
    let most = outline.map_or(f64::INFINITY, |outline| {
        let [low, high] = outline.bounds();
        (high[0] - low[0]).hypot(high[1] - low[1])
    });
    let parts = crack.vertices().windows(2);
    parts.map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]).min(most)).sum()
}
