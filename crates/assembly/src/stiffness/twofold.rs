//! Internal forces in twice the precision: residuals of bodies that move far and strain little, on supports so soft that the
//! rounding of forces would move them.
//!
//! Measures and sums of forces are exact to the square of the rounding of doubles. A conjugate force is one double that acts
//! on all points of its element, so that its rounding is a change of stiffness, which no soft support notices.

use super::placed_bonds::{Member, row};
use super::{Family, WideMember};
use crate::bonds::{Mat, Rows};
use crate::sum::Sum;
use std::array::from_fn;

/// Unknowns in two parts: doubles, and what rounding took from them.
#[derive(Clone, Copy, Debug)]
pub struct Twofold<'a> {
    /// Doubles.
    pub high: &'a [f64],
    /// The rest.
    pub low: &'a [f64],
}

impl Twofold<'_> {
    /// One of them.
    pub fn at(self, unknown: usize) -> Sum {
        let mut sum = Sum::of(self.high[unknown]);
        sum.add(self.low[unknown]);
        sum
    }

    /// The difference of two of them.
    fn between(self, from: usize, to: usize) -> Sum {
        let mut difference = self.at(to);
        difference.join(-self.at(from));
        difference
    }
}

/// Adds the forces of a bond in a body of `points` points. Its rows are those of the difference and half of those of the
/// mean, `[measure][component]`.
pub(super) fn add_bond<const D: usize, const M: usize>(
    ([rows, half], moduli): ([&Mat<M, D>; 2], &[f64; M]),
    points: usize,
    [i, j]: [usize; 2],
    u: Twofold<'_>,
    force: &mut [Sum],
) {
    let difference: [Sum; D] = from_fn(|c| u.between(c * points + i, c * points + j));
    let both: [Sum; D] = from_fn(|c| {
        let mut sum = u.at(c * points + i);
        sum.join(u.at(c * points + j));
        sum
    });
    for m in 0..M {
        let mut measure = Sum::default();
        for c in 0..D {
            measure.add_multiple(rows[m][c], difference[c]);
            measure.add_multiple(half[m][c], both[c]);
        }
        let sigma = moduli[m] * measure.total();
        for c in 0..D {
            for (point, sign) in [(i, -1.0), (j, 1.0)] {
                force[c * points + point].add_product(sign * rows[m][c], sigma);
                force[c * points + point].add_product(half[m][c], sigma);
            }
        }
    }
}

/// Adds the forces of a bond between places in a body of `points` points.
pub(super) fn add_placed_bond<const D: usize, const M: usize>(
    (rows, moduli): (&Rows<D, M>, &[f64; M]),
    points: usize,
    members: &[Member],
    u: Twofold<'_>,
    force: &mut [Sum],
) {
    let Some((first, others)) = members.split_first() else { return };
    let first = first.point as usize;
    for m in 0..M {
        let mut measure = Sum::default();
        for c in 0..D {
            measure.add_multiple(rows.mean[m][c], u.at(c * points + first));
            for member in others {
                let moved = u.between(c * points + first, c * points + member.point as usize);
                measure.add_multiple(row(rows, member)[m][c], moved);
            }
        }
        let sigma = moduli[m] * measure.total();
        for member in members {
            let row = row(rows, member)[m];
            (0..D).for_each(|c| force[c * points + member.point as usize].add_product(row[c], sigma));
        }
    }
}

/// Adds the forces of a family of any size in a body of `points` points.
pub(super) fn add_wide_family<const D: usize, const M: usize>(
    (common, modulus): (&Mat<M, D>, &Mat<M, M>),
    points: usize,
    members: &[WideMember<D, M>],
    u: Twofold<'_>,
    force: &mut [Sum],
) {
    let Some((first, others)) = members.split_first() else { return };
    let first = first.point as usize;
    let measures: [f64; M] = from_fn(|m| {
        let mut sum = Sum::default();
        for c in 0..D {
            sum.add_multiple(common[m][c], u.at(c * points + first));
            for member in others {
                let moved = u.between(c * points + first, c * points + member.point as usize);
                sum.add_multiple(member.rows[m][c], moved);
            }
        }
        sum.total()
    });
    for (m, row) in modulus.iter().enumerate() {
        let sigma: f64 = (0..M).map(|k| row[k] * measures[k]).sum();
        for member in members {
            (0..D).for_each(|c| {
                force[c * points + member.point as usize].add_product(member.rows[m][c], sigma)
            });
        }
    }
}

/// Adds the forces of a family in a body of `points` points.
pub(super) fn add_family<const D: usize, const M: usize, const E: usize>(
    family: &Family<D, M, E>,
    points: usize,
    u: Twofold<'_>,
    force: &mut [Sum],
) {
    let own = family.point as usize;
    let others = || family.others.iter().map(|p| *p as usize).zip(&family.rows);
    let measures: [f64; M] = from_fn(|m| {
        let mut sum = Sum::default();
        for c in 0..D {
            sum.add_multiple(family.own[m][c], u.at(c * points + own));
            others().for_each(|(p, rows)| {
                sum.add_multiple(rows[m][c], u.between(c * points + own, c * points + p));
            });
        }
        sum.total()
    });
    let sigma = family.stress(&measures);
    for (c, m) in (0..D).flat_map(|c| (0..M).map(move |m| (c, m))) {
        force[c * points + own].add_product(family.own[m][c], sigma[m]);
        for (p, rows) in others() {
            force[c * points + p].add_product(rows[m][c], sigma[m]);
            force[c * points + own].add_product(-rows[m][c], sigma[m]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bonds::Rows;
    use crate::stiffness::{Bond, Bonds, Spring, Springs, Term};

    /// A beam bond over a length of one, γ = (w_j − w_i) − (φ_i + φ_j)/2 and φ_j − φ_i.
    fn beam_bond() -> Bonds<2, 2> {
        let rows = Rows { difference: [[1.0, 0.0], [0.0, 1.0]], mean: [[0.0, -1.0], [0.0, 0.0]] };
        Bonds::new(2, std::iter::once(Bond { points: [0, 1], rows, moduli: [7.0, 3.0] }))
    }

    #[test]
    fn forces_are_those_of_doubles_where_these_do() {
        let (bonds, u) = (beam_bond(), [0.25, 0.5, -0.125, 0.75]);
        let mut plain = [0.0; 4];
        bonds.add_force(&u, &mut plain);
        let mut twofold = [Sum::default(); 4];
        assert!(bonds.add_force_twofold(Twofold { high: &u, low: &[0.0; 4] }, &mut twofold));
        assert_eq!(twofold.map(Sum::total), plain);
    }

    #[test]
    fn a_strain_below_the_rounding_of_a_turn_is_felt() {
        // A turn by 0.1 about a place 3 to the left, whose displacements round, and a strain of 2^-70.
        let (turn, strain) = (0.1, 2.0_f64.powi(-70));
        let low = |exact: [f64; 2]| exact[0].mul_add(exact[1], -(exact[0] * exact[1]));
        let high = [turn * 3.0, turn * 4.0, turn, turn];
        let low = [low([turn, 3.0]), low([turn, 4.0]) + strain, 0.0, 0.0];
        let (bonds, mut force) = (beam_bond(), [Sum::default(); 4]);
        bonds.add_force_twofold(Twofold { high: &high, low: &low }, &mut force);
        let shear = 7.0 * strain;
        assert_eq!(force.map(Sum::total), [-shear, shear, -0.5 * shear, -0.5 * shear]);
        let mut plain = [0.0; 4];
        bonds.add_force(&high, &mut plain);
        assert!((plain[0] + shear).abs() > 1e3 * shear, "{plain:?}");
    }

    #[test]
    fn a_spring_feels_both_parts() {
        let springs = Springs::new(2, vec![Spring::on(0, 1, 4.0)]);
        let mut force = [Sum::default(); 4];
        let [high, low] = [[0.0, 1.0, 0.0, 0.0], [0.0, 2.0_f64.powi(-60), 0.0, 0.0]];
        assert!(Term::<2>::add_force_twofold(&springs, Twofold { high: &high, low: &low }, &mut force));
        let mut rest = force[1];
        rest.add(-4.0);
        assert_eq!(rest.total(), 0.0, "a conjugate force is one double");
    }
}
