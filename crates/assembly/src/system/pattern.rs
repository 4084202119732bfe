//! Places of the stiffness of bonds in a sparse matrix, found once: values change many times, their places never.

#[cfg(test)]
mod tests;

use crate::bonds::Mat;
use crate::condition::Constraints;
use sprs::CsMat;

/// An independent unknown in the difference of the displacements of two places.
#[derive(Clone, Copy, Debug)]
struct Share {
    unknown: u32,
    component: u8,
    coefficient: f64,
}

/// Where bonds that resist differences of displacements put their blocks.
///
/// The difference of the `D` displacements of the ends of a bond is `Σ coefficient · q` over a few independent unknowns; a block
/// on it adds to all pairs of these. Unknowns that are constrained keep their numbers and a diagonal of one.
#[derive(Clone, Debug)]
pub struct DifferencePattern<const D: usize> {
    /// First share of every bond, and their number at the end.
    first: Vec<u32>,
    shares: Vec<Share>,
    /// First place of every bond.
    first_place: Vec<u32>,
    /// Places of the pairs of shares of the lower triangle, bond by bond, in the order of [`pairs`].
    places: Vec<u32>,
    /// Unknowns that are constrained.
    inert: Vec<u32>,
    /// Place of the diagonal of every unknown.
    diagonal: Vec<u32>,
    pointers: Vec<usize>,
    columns: Vec<usize>,
}

/// Pairs of shares that fall into the lower triangle.
fn pairs(shares: &[Share]) -> impl Iterator<Item = (&Share, &Share)> {
    shares.iter().flat_map(move |a| shares.iter().filter(|b| b.unknown <= a.unknown).map(move |b| (a, b)))
}

impl<const D: usize> DifferencePattern<D> {
    /// Places of bonds, of a body of `points` points; a bond is the points that move its ends and their shares in the difference
    /// of the displacements of these, −1 and 1 between two points.
    pub fn new<B: IntoIterator<Item = (u32, f64)>>(
        points: usize,
        constraints: &Constraints,
        bonds: impl Iterator<Item = B>,
    ) -> Self {
        let size = D * points;
        let mut row_of = vec![0_u32; size];
        constraints.rows().iter().zip(1..).for_each(|(row, number)| row_of[row.unknown] = number);
        let (mut first, mut shares) = (vec![0_u32], Vec::new());
        for bond in bonds {
            let begin = shares.len();
            for (point, part) in bond {
                for component in 0..D {
                    let unknown = component * points + point as usize;
                    let mut add = |unknown: usize, coefficient: f64| {
                        merge(
                            &mut shares,
                            begin,
                            Share { unknown: unknown as u32, component: component as u8, coefficient },
                        );
                    };
                    match row_of[unknown] {
                        0 => add(unknown, part),
                        number => {
                            let masters = &constraints.rows()[number as usize - 1].masters;
                            masters.iter().for_each(|&(m, c)| add(m, part * c));
                        }
                    }
                }
            }
            first.push(shares.len() as u32);
        }
        let of = |k: usize| &shares[first[k] as usize..first[k + 1] as usize];
        let bonds = first.len() - 1;
        let key = |row: u32, column: u32| u64::from(row) << 32 | u64::from(column);
        let mut keys: Vec<u64> = (0..size as u32).map(|k| key(k, k)).collect();
        (0..bonds).for_each(|k| keys.extend(pairs(of(k)).map(|(a, b)| key(a.unknown, b.unknown))));
        keys.sort_unstable();
        keys.dedup();
        let mut pointers = vec![0; size + 1];
        keys.iter().for_each(|k| pointers[(k >> 32) as usize + 1] += 1);
        (0..size).for_each(|r| pointers[r + 1] += pointers[r]);
        let columns: Vec<usize> = keys.iter().map(|k| (k & u64::from(u32::MAX)) as usize).collect();
        let place = |row: u32, column: u32| {
            let range = pointers[row as usize]..pointers[row as usize + 1];
            let found = columns[range.clone()].binary_search(&(column as usize));
            (range.start + found.expect("every pair has a place")) as u32
        };
        let (mut first_place, mut places) = (vec![0_u32], Vec::new());
        for k in 0..bonds {
            places.extend(pairs(of(k)).map(|(a, b)| place(a.unknown, b.unknown)));
            first_place.push(places.len() as u32);
        }
        let diagonal = (0..size).map(|k| pointers[k + 1] as u32 - 1).collect();
        let inert = constraints.rows().iter().map(|row| row.unknown as u32).collect();
        Self { first, shares, first_place, places, inert, diagonal, pointers, columns }
    }

    fn of(&self, bond: usize) -> &[Share] {
        &self.shares[self.first[bond] as usize..self.first[bond + 1] as usize]
    }

    /// A zero matrix, the lower triangle in compressed rows.
    pub fn matrix(&self) -> CsMat<f64> {
        let size = self.diagonal.len();
        CsMat::new((size, size), self.pointers.clone(), self.columns.clone(), vec![0.0; self.columns.len()])
    }

    /// Overwrites the values of a matrix of this pattern with the blocks of all bonds.
    pub fn fill(&self, block: impl Fn(usize) -> Mat<D, D>, matrix: &mut CsMat<f64>) {
        let values = matrix.data_mut();
        values.fill(0.0);
        for bond in 0..self.first.len() - 1 {
            let block = block(bond);
            let places = &self.places[self.first_place[bond] as usize..self.first_place[bond + 1] as usize];
            for ((a, b), &place) in pairs(self.of(bond)).zip(places) {
                let entry = block[usize::from(a.component)][usize::from(b.component)];
                values[place as usize] += a.coefficient * b.coefficient * entry;
            }
        }
        self.inert.iter().for_each(|&k| values[self.diagonal[k as usize] as usize] = 1.0);
    }

    /// Place of the diagonal of every unknown among the values of a matrix.
    pub fn diagonal(&self) -> &[u32] {
        &self.diagonal
    }

    /// The elongation of a bond of some direction as a sum of independent unknowns.
    pub fn column(&self, bond: usize, direction: &[f64; D]) -> Vec<(usize, f64)> {
        let mut column: Vec<(usize, f64)> = Vec::new();
        for share in self.of(bond) {
            let (unknown, value) =
                (share.unknown as usize, share.coefficient * direction[usize::from(share.component)]);
            match column.iter_mut().find(|c| c.0 == unknown) {
                Some(entry) => entry.1 += value,
                None => column.push((unknown, value)),
            }
        }
        column
    }
}

/// Adds a share to those from `begin` on.
fn merge(shares: &mut Vec<Share>, begin: usize, share: Share) {
    let same = |s: &&mut Share| s.unknown == share.unknown && s.component == share.component;
    match shares[begin..].iter_mut().find(same) {
        Some(known) => known.coefficient += share.coefficient,
        None => shares.push(share),
    }
}
