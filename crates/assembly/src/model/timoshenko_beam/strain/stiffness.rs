//! Columns of the stiffness, cell by cell.

use super::StrainForm;
use crate::model::timoshenko_beam::BondTable;
use crate::stiffness::Weights;
use peristat_vector::vectorised;

/// Couplings `[p][q]` of the unknowns p of one cell with the unknowns q of another; 0 is θ, 1 is g.
pub(super) type Block = [[f64; 2]; 2];

/// The stiffness as a lower band of columns that repeat in runs.
///
/// Unknown `2 j + p` is θ (p = 0) or g (p = 1) of the cell `N − 1 − j`: the matrix begins at the right end.
#[derive(Clone, Debug, PartialEq)]
pub struct StrainBand {
    /// Half bandwidth, 2m − 1.
    pub half_bandwidth: usize,
    /// Cells of every run.
    pub runs: Vec<usize>,
    /// Per run the two columns of one cell, each of 2m entries from the diagonal down: J/rad², N, N/m.
    pub values: Vec<f64>,
}

/// Cells whose bonds are looked at together when runs are sought.
const STRETCH: usize = 64;

impl StrainForm<'_> {
    /// The stiffness for a factorisation.
    pub fn band(&self) -> StrainBand {
        let m = self.reach();
        let mut band = StrainBand { half_bandwidth: 2 * m - 1, runs: Vec::new(), values: Vec::new() };
        let mut columns = vec![Block::default(); m];
        let (mut end, mut ordinary) = (self.cells(), false);
        while end > 0 {
            let count =
                [STRETCH, 1].into_iter().find(|&count| count <= end && self.are_ordinary(end - count, end));
            match (count, band.runs.last_mut()) {
                (Some(count), Some(run)) if ordinary => *run += count,
                (count, _) => {
                    self.columns(end - 1, &mut columns);
                    band.runs.push(count.unwrap_or(1));
                    band.push(&columns);
                }
            }
            ordinary = count.is_some();
            end -= count.unwrap_or(1);
        }
        band
    }

    /// A lower bound of the eigenvalues of the stiffness scaled by its diagonal, from at most 256 cells: what the bonds
    /// between neighbours alone, which couple no cells, are of the diagonal. A residual is at least the error of the
    /// strains times this, both in units of the energy.
    ///
    /// It is 1 for m = 1, 0.4 for 3 and 0.2 for 5, whatever the slenderness, unless the law `published` locks.
    pub fn least_eigenvalue(&self) -> f64 {
        let mut columns = vec![Block::default(); self.reach()];
        let of = |cell: usize| {
            self.columns(cell, &mut columns);
            let (alpha, bond) = (self.chain.weights.weight(0, cell), self.chain.bonds.bond(0, cell));
            let coupling = alpha * bond.shear * bond.eccentricity;
            let own = alpha * bond.bending + coupling * bond.eccentricity;
            let [theta, g] = [columns[0][0][0], columns[0][1][1]];
            let (a, b, c) = (own / theta, alpha * bond.shear / g, coupling * (coupling / theta) / g);
            // The smaller root, without a difference of what may be nearly equal.
            let larger = 0.5 * (a + b) + (0.25 * (a - b) * (a - b) + c).sqrt();
            alpha * bond.bending / theta * (alpha * bond.shear / g) / larger
        };
        self.samples().map(of).fold(f64::INFINITY, f64::min)
    }

    /// The most that a force, N, and a couple, N m, anywhere on the beam make of `|r| / √K_cc`, √J, in at most 256 cells.
    pub fn most_action(&self, [force, couple]: [f64; 2]) -> f64 {
        let mut columns = vec![Block::default(); self.reach()];
        let moment = couple + force * self.distance(self.cells());
        let of = |cell: usize| {
            self.columns(cell, &mut columns);
            (moment / columns[0][0][0].sqrt()).max(force / columns[0][1][1].sqrt())
        };
        self.samples().map(of).fold(0.0, f64::max)
    }

    /// Cells that stand for all, the first and the last among them, and one of those that are alike.
    fn samples(&self) -> impl Iterator<Item = usize> {
        const CELLS: usize = 256;
        let (cells, count) = (self.cells(), CELLS.min(self.cells()));
        let all = (0..count).map(move |k| if count == 1 { 0 } else { k * (cells - 1) / (count - 1) });
        let mut has_ordinary = false;
        all.filter(move |&cell| {
            let is_ordinary = self.are_ordinary(cell, cell + 1);
            !(is_ordinary && std::mem::replace(&mut has_ordinary, true))
        })
    }

    /// Whether the columns of the cells `start..end` are those of ordinary cells.
    pub(super) fn are_ordinary(&self, start: usize, end: usize) -> bool {
        let back = self.reach() - 1;
        self.ordinary.is_some() && start >= back && self.chain.weights.are_ordinary(start - back..end)
    }

    /// Columns of an ordinary cell.
    pub(super) fn ordinary_columns(&self) -> Vec<Block> {
        let mut columns = vec![Block::default(); self.reach()];
        // The place does not matter to bonds that are all alike.
        self.collect(self.reach(), |weights, class, _| weights.of_class(class), &mut columns);
        columns
    }

    /// Couplings of a cell with itself and the cells on its left: `columns[d]` with the cell d further left.
    pub(super) fn columns(&self, cell: usize, columns: &mut [Block]) {
        match &self.ordinary {
            Some(ordinary) if self.are_ordinary(cell, cell + 1) => columns.copy_from_slice(ordinary),
            _ => self.collect(cell, Weights::weight, columns),
        }
    }

    /// Sums the bonds over a cell, in a time of the bonds over it: a bond that begins k cells further left couples the
    /// cell with as many, and its arm to each differs from its own arm by the distance D of the cells.
    fn collect(&self, cell: usize, weight: impl Fn(&Weights, usize, usize) -> f64, columns: &mut [Block]) {
        let weights = &self.chain.weights;
        columns.fill(Block::default());
        for class in 0..weights.classes() {
            let step = weights.step(class);
            for lower in (cell + 1).saturating_sub(step)..=cell {
                let alpha = weight(weights, class, lower);
                if alpha == 0.0 {
                    continue;
                }
                let bond = self.chain.bonds.bond(class, lower);
                let arm = self.arm(class, lower, cell) + bond.eccentricity;
                let [[bending, coupling], [_, shear]] = &mut columns[cell - lower];
                *bending += alpha * (bond.bending + bond.shear * arm * arm);
                *coupling += alpha * bond.shear * arm;
                *shear += alpha * bond.shear;
            }
        }
        let [mut bending, mut coupling, mut shear] = [0.0; 3];
        for (back, block) in columns.iter_mut().enumerate().rev() {
            bending += block[0][0];
            coupling += block[0][1];
            shear += block[1][1];
            if back <= cell {
                let distance = self.distance_back(cell, back);
                *block = [[bending + distance * coupling, coupling], [coupling + distance * shear, shear]];
            }
        }
    }

    /// Distance of the middle of a cell from that of the cell `back` further left, m.
    fn distance_back(&self, cell: usize, back: usize) -> f64 {
        let chain = self.chain;
        match &chain.bonds {
            BondTable::Uniform { .. } => back as f64 * chain.spacing,
            BondTable::Each { .. } => {
                let apart = |point: usize| chain.position(point) - chain.position(point - back);
                0.5 * (apart(cell) + apart(cell + 1))
            }
        }
    }

    /// Distance of the middle of a bond from that of a cell under it.
    #[inline(always)]
    fn arm(&self, class: usize, lower: usize, cell: usize) -> f64 {
        let (chain, step) = (self.chain, self.chain.weights.step(class));
        match &chain.bonds {
            BondTable::Uniform { .. } => {
                (lower as f64 - cell as f64 + 0.5 * (step - 1) as f64) * chain.spacing
            }
            BondTable::Each { .. } => {
                // Neighbouring positions first: their differences are not rounded.
                let upper = (lower + step).min(chain.points - 1);
                let right = chain.position(upper) - chain.position(cell + 1);
                0.5 * (right - (chain.position(cell) - chain.position(lower)))
            }
        }
    }

    /// Products `K v` of the cells `start..end` into `rows`, and the diagonal entries where `diagonal` is given. `v` holds
    /// the unknowns of `end − start` cells with m − 1 more on each side, zero beyond the ends.
    pub(super) fn product(
        &self,
        start: usize,
        end: usize,
        v: [&[f64]; 2],
        mut rows: [&mut [f64]; 2],
    ) -> Diagonal {
        match &self.ordinary {
            Some(columns) if self.are_ordinary(start, (end + self.reach() - 1).min(self.cells())) => {
                vectorised(
                    #[inline(always)]
                    || product_of_equal(columns, v, rows.each_mut().map(|row| &mut **row)),
                );
                Diagonal::Equal([columns[0][0][0], columns[0][1][1]])
            }
            _ => self.product_of_each(start, end, v, rows),
        }
    }

    fn product_of_each(&self, start: usize, end: usize, v: [&[f64]; 2], rows: [&mut [f64]; 2]) -> Diagonal {
        let m = self.reach();
        let mut diagonal = Vec::with_capacity(end - start);
        // Columns of the cells from the current one on, cell c in place c % m.
        let mut columns = vec![vec![Block::default(); m]; m];
        let load = |cell: usize, columns: &mut Vec<Vec<Block>>| {
            if cell < self.cells() {
                self.columns(cell, &mut columns[cell % m]);
            } else {
                columns[cell % m].fill(Block::default());
            }
        };
        (start..start + m - 1).for_each(|cell| load(cell, &mut columns));
        for cell in start..end {
            load(cell + m - 1, &mut columns);
            let at = cell - start + m - 1;
            let mut sum = [0.0; 2];
            for (back, block) in columns[cell % m].iter().enumerate() {
                (0..2).for_each(|p| sum[p] += block[p][0] * v[0][at - back] + block[p][1] * v[1][at - back]);
            }
            for ahead in 1..m {
                let block = &columns[(cell + ahead) % m][ahead];
                (0..2)
                    .for_each(|p| sum[p] += block[0][p] * v[0][at + ahead] + block[1][p] * v[1][at + ahead]);
            }
            (rows[0][cell - start], rows[1][cell - start]) = (sum[0], sum[1]);
            diagonal.push([columns[cell % m][0][0][0], columns[cell % m][0][1][1]]);
        }
        Diagonal::Each(diagonal)
    }
}

/// Diagonal entries of some cells.
pub(super) enum Diagonal {
    /// The same for all.
    Equal([f64; 2]),
    /// One by one.
    Each(Vec<[f64; 2]>),
}

/// Products of cells that are all alike.
#[inline(always)]
fn product_of_equal(columns: &[Block], v: [&[f64]; 2], rows: [&mut [f64]; 2]) {
    let (reach, [rows_0, rows_1]) = (columns.len() - 1, rows);
    let width = rows_0.len();
    rows_0.fill(0.0);
    rows_1.fill(0.0);
    for shift in 0..=2 * reach {
        // Cells on the left are in the columns of this cell, it is in those of the cells on the right.
        let block = if shift <= reach {
            columns[reach - shift]
        } else {
            let [[a, b], [c, d]] = columns[shift - reach];
            [[a, c], [b, d]]
        };
        let (theta, g) = (&v[0][shift..shift + width], &v[1][shift..shift + width]);
        for k in 0..width {
            rows_0[k] += block[0][0] * theta[k] + block[0][1] * g[k];
            rows_1[k] += block[1][0] * theta[k] + block[1][1] * g[k];
        }
    }
}

impl StrainBand {
    /// Appends the columns of one cell.
    fn push(&mut self, columns: &[Block]) {
        for p in 0..2 {
            let entry = |k: usize| columns.get((p + k) / 2).map_or(0.0, |block| block[p][(p + k) % 2]);
            self.values.extend((0..=self.half_bandwidth).map(entry));
        }
    }
}
