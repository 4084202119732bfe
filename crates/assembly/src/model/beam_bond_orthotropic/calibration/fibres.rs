//! Which bonds of a lattice lie exactly along and across the fibres.

use super::super::super::plane::{is_up, length};
use crate::body::Cell;

/// Largest angle between a bond and fibres that are parallel, rad.
const PARALLEL: f64 = 1e-9;

/// Fibres among the offsets of a lattice.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Fibres {
    /// Their unit vector in the axes of the lattice.
    pub(in super::super) direction: [f64; 2],
    /// Per offset, whether it lies along them.
    pub(in super::super) along: Vec<bool>,
    /// Per offset, whether it lies across them.
    pub(in super::super) across: Vec<bool>,
    /// The shortest offset along them.
    shortest: Option<Cell>,
}

impl Fibres {
    /// Fibres at an angle to the rows of a lattice, rad, among half offsets.
    pub(in super::super) fn new(angle: f64, offsets: &[Cell]) -> Self {
        let (s, c) = angle.sin_cos();
        let small = |product: f64, step: Cell| product.abs() <= PARALLEL * length(step);
        let along: Vec<bool> = offsets
            .iter()
            .map(|&step| small(f64::from(step[0]) * s - f64::from(step[1]) * c, step))
            .collect();
        let across = offsets
            .iter()
            .map(|&step| small(f64::from(step[0]) * c + f64::from(step[1]) * s, step))
            .collect();
        let shortest = (0..offsets.len()).filter(|&k| along[k]).map(|k| offsets[k]);
        let shortest = shortest.min_by(|&v, &w| length(v).total_cmp(&length(w)));
        let exact = shortest.map(|step| [0, 1].map(|k| f64::from(step[k]) / length(step)));
        Self { direction: exact.unwrap_or([c, s]), along, across, shortest }
    }

    /// Whether bonds lie along the fibres. On square cells there then are some across them too.
    pub(in super::super) fn are_bonds(&self) -> bool {
        self.shortest.is_some()
    }

    /// The half offset whose bonds are the images of those of another in the fibres; none unless the whole lattice is its
    /// image, which it is for fibres along its rows, columns and diagonals.
    pub(super) fn image(&self, [a, b, _]: Cell) -> Option<Cell> {
        let [x, y, _] = self.shortest.map(|step| step.map(i32::signum))?;
        if self.shortest.is_some_and(|[p, q, _]| p * q != 0 && p.abs() != q.abs()) {
            return None;
        }
        // v ↦ 2 (v·d) d/|d|² − v
        let twice = 2 * (a * x + b * y) / (x * x + y * y);
        let image = [twice * x - a, twice * y - b, 0];
        Some(if is_up(image) { image } else { image.map(|v| -v) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OFFSETS: [Cell; 8] =
        [[1, 0, 0], [2, 0, 0], [-1, 1, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0], [-1, 2, 0], [1, 2, 0]];

    #[test]
    fn bonds_are_found_at_their_angles_alone() {
        let of = |degrees: f64| Fibres::new(degrees.to_radians(), &OFFSETS);
        let chosen = |mask: &[bool]| (0..8).filter(|&k| mask[k]).map(|k| OFFSETS[k]).collect::<Vec<_>>();
        assert_eq!(chosen(&of(180.0).along), [[1, 0, 0], [2, 0, 0]]);
        assert_eq!(chosen(&of(-90.0).along), [[0, 1, 0]]);
        assert_eq!(chosen(&of(135.0).across), [[1, 1, 0]]);
        assert_eq!(chosen(&of(45.0 + 1e-6).along), [[0; 3]; 0]);
        let slope = Fibres::new(0.5_f64.atan(), &OFFSETS);
        assert_eq!((chosen(&slope.along), chosen(&slope.across)), (vec![[2, 1, 0]], vec![[-1, 2, 0]]));
        assert_eq!(of(90.0).direction, [0.0, 1.0]);
    }

    #[test]
    fn images_are_those_of_a_mirror_along_the_fibres() {
        let image = |degrees: f64, step| Fibres::new(degrees.to_radians(), &OFFSETS).image(step);
        assert_eq!(image(0.0, [2, 1, 0]), Some([-2, 1, 0]));
        assert_eq!(image(90.0, [2, 1, 0]), Some([-2, 1, 0]));
        assert_eq!(image(45.0, [2, 1, 0]), Some([1, 2, 0]));
        assert_eq!(image(45.0, [1, 1, 0]), Some([1, 1, 0]));
        assert_eq!(image(135.0, [2, 1, 0]), Some([1, 2, 0]));
        assert_eq!(image(135.0, [1, 0, 0]), Some([0, 1, 0]));
        assert_eq!(Fibres::new(0.5_f64.atan(), &OFFSETS).image([1, 0, 0]), None);
        assert_eq!(image(30.0, [1, 0, 0]), None);
    }
}
