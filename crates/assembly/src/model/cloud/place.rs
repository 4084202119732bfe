//! What the plane and space have of their own.

use super::super::{plane, solid};
use crate::bonds::Mat;

/// Positions and directions of D coordinates, where strains have S components.
pub(in super::super) trait Place<const D: usize, const S: usize>: Copy {
    /// Neighbours of a point among which the corners of its triangles or tetrahedra are looked for.
    const NEAREST: usize;

    /// Side of the square or the cube of a size, m.
    fn width(size: f64) -> f64;

    /// `N` of a direction: `e = ξ N·E` in a uniform strain E.
    fn product(self) -> [f64; S];

    /// Strains of a triangle or a tetrahedron per displacement of its other corners relative to a point, from which they are
    /// `corners`, m.
    fn strain_rows(corners: [[f64; D]; D]) -> [Mat<S, D>; D];

    /// How bad the triangle or the tetrahedron of a point and some others is, relative to it: small where it is near and well
    /// shaped. `None` for one that is flat but for rounding.
    fn badness(corners: &[[f64; D]]) -> Option<f64>;
}

/// Flatter ones are flat but for rounding.
const FLAT: f64 = 1e-6;

impl Place<2, 3> for [f64; 2] {
    const NEAREST: usize = 10;

    fn width(size: f64) -> f64 {
        size.sqrt()
    }

    fn product(self) -> [f64; 3] {
        let [x, y] = self;
        [x * x, y * y, x * y]
    }

    fn strain_rows([first, second]: [[f64; 2]; 2]) -> [Mat<3, 2>; 2] {
        plane::strain_rows(first, second)
    }

    /// (Sum of the squared sides)²/area.
    fn badness(corners: &[[f64; 2]]) -> Option<f64> {
        let &[a, b] = corners else { return None };
        let area = (a[0] * b[1] - a[1] * b[0]).abs();
        let sides = squared_sides(corners);
        (area >= FLAT * sides).then(|| sides * sides / area)
    }
}

impl Place<3, 6> for [f64; 3] {
    const NEAREST: usize = 14;

    fn width(size: f64) -> f64 {
        size.cbrt()
    }

    fn product(self) -> [f64; 6] {
        let [x, y, z] = self;
        [x * x, y * y, z * z, y * z, x * z, x * y]
    }

    fn strain_rows(corners: [[f64; 3]; 3]) -> [Mat<6, 3>; 3] {
        solid::strain_rows(corners)
    }

    /// (Sum of the squared edges)^(5/2)/volume, or of the triangle of two corners what it is in the plane.
    fn badness(corners: &[[f64; 3]]) -> Option<f64> {
        let sides = squared_sides(corners);
        match *corners {
            [a, b] => {
                let area = cross(a, b).into_iter().fold(0.0, f64::hypot);
                (area >= FLAT * sides).then(|| sides * sides / area)
            }
            [a, b, c] => {
                let normal = cross(a, b);
                let volume = (0..3).map(|k| normal[k] * c[k]).sum::<f64>().abs();
                let cubed = sides * sides.sqrt();
                (volume >= FLAT * cubed).then(|| sides * cubed / volume)
            }
            _ => None,
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sum of the squared distances of some corners from the origin and from each other.
fn squared_sides<const D: usize>(corners: &[[f64; D]]) -> f64 {
    let squared = |v: [f64; D]| v.into_iter().map(|x| x * x).sum::<f64>();
    let own: f64 = corners.iter().copied().map(squared).sum();
    let others = corners.iter().enumerate().flat_map(|(k, a)| corners[k + 1..].iter().map(move |b| [a, b]));
    own + others.map(|[a, b]| squared(std::array::from_fn(|k| b[k] - a[k]))).sum::<f64>()
}
