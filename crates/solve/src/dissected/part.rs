//! The factor of one half with the separator.

use super::reach::{PartReach, Place};
use super::structure::Structure;
use crate::FactorError;
use crate::sparse::{buffer, out_of_memory, zeros};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::matmul::{matmul, triangular};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Accum, Mat, MatMut, MatRef, Par};
use sprs::CsMat;

/// Factor of the principal submatrix of a half and the separator, which comes last.
pub(super) struct Part {
    /// Unknowns of the half in the order of elimination, then those of the separator.
    unknowns: Vec<u32>,
    /// How many of them are of the half.
    own: usize,
    structure: Structure,
    symbolic: supernodal::SymbolicSupernodalCholesky<usize>,
    data: Vec<f64>,
    values: Vec<f64>,
    scratch: MemBuffer,
    complement: Mat<f64>,
    /// Vectors of the unknowns and of the rows of a block.
    x: Vec<f64>,
    block: Vec<f64>,
}

impl Part {
    pub(super) fn analyse(
        pattern: &CsMat<f64>,
        half: Vec<u32>,
        separator: &[u32],
        coupled: &[bool],
    ) -> Result<Self, FactorError> {
        let own = half.len();
        // What is coupled with nothing comes first, lest it interrupts blocks.
        let (coupled, mut unknowns): (Vec<u32>, Vec<u32>) =
            half.into_iter().partition(|i| coupled[*i as usize]);
        unknowns.extend(coupled.iter().chain(separator));
        let structure = Structure::new(pattern, &unknowns);
        let symbolic = symbolic(&structure)?;
        let need = supernodal::factorize_supernodal_numeric_llt_scratch::<usize, f64>(
            &symbolic,
            Par::Seq,
            Default::default(),
        );
        let longest = (0..symbolic.n_supernodes()).map(|s| symbolic.supernode(s).pattern().len()).max();
        let widest =
            symbolic.supernode_begin().iter().zip(symbolic.supernode_end()).map(|(b, e)| e - b).max();
        Ok(Self {
            own,
            data: vec![0.0; structure.rows.len()],
            values: zeros(symbolic.len_val())?,
            scratch: buffer(need)?,
            complement: Mat::zeros(separator.len(), separator.len()),
            x: vec![0.0; unknowns.len()],
            block: vec![0.0; longest.unwrap_or(0) + widest.unwrap_or(0)],
            unknowns,
            structure,
            symbolic,
        })
    }

    pub(super) fn structure(&self) -> &Structure {
        &self.structure
    }

    pub(super) fn fill(&self) -> usize {
        self.values.len()
    }

    pub(super) fn bytes(&self) -> usize {
        let numbers = self.values.len() + self.data.len() + self.x.len() + self.block.len();
        let square = self.complement.nrows() * self.complement.nrows();
        8 * (numbers + square + self.structure.rows.len())
            + 4 * self.structure.sources.len()
            + self.scratch.len()
    }

    /// Factors the submatrix of a matrix, given by its values, and finds the complement.
    pub(super) fn factor(&mut self, values: &[f64]) -> Result<(), FactorError> {
        for (to, source) in self.data.iter_mut().zip(&self.structure.sources) {
            *to = values[*source as usize];
        }
        let order = self.unknowns.len();
        let Structure { starts, rows, .. } = &self.structure;
        let pattern = SymbolicSparseColMatRef::new_checked(order, order, starts, None, rows);
        supernodal::factorize_supernodal_numeric_llt(
            &mut self.values,
            SparseColMatRef::new(pattern, &self.data[..]),
            Default::default(),
            &self.symbolic,
            Par::Seq,
            MemStack::new(&mut self.scratch),
            Default::default(),
        )
        .map_err(|LltError::NonPositivePivot { index }| FactorError::NonPositivePivot {
            index: self.unknowns[index] as usize,
            count: 1,
        })?;
        self.complete();
        Ok(())
    }

    /// Lower triangle of `G G'`, where `G` are the last columns of the factor.
    fn complete(&mut self) {
        let size = self.complement.nrows();
        let mut g = Mat::<f64>::zeros(size, size);
        let factor = supernodal::SupernodalLltRef::new(&self.symbolic, &self.values[..]);
        for s in 0..self.symbolic.n_supernodes() {
            let (begin, end) = self.columns(s);
            let block = factor.supernode(s);
            for j in begin.max(self.own)..end {
                for i in j..end {
                    g[(i - self.own, j - self.own)] = block.val()[(i - begin, j - begin)];
                }
                for (k, i) in block.pattern().iter().enumerate() {
                    g[(i - self.own, j - self.own)] = block.val()[(end - begin + k, j - begin)];
                }
            }
        }
        use triangular::BlockStructure::{TriangularLower, TriangularUpper};
        triangular::matmul(
            self.complement.as_mut(),
            TriangularLower,
            Accum::Replace,
            g.as_ref(),
            TriangularLower,
            g.transpose(),
            TriangularUpper,
            1.0,
            Par::Seq,
        );
    }

    /// `C - B' A^-1 B`, lower triangle.
    pub(super) fn complement(&self) -> &Mat<f64> {
        &self.complement
    }

    /// First and last column of a block, the latter excluded.
    fn columns(&self, s: usize) -> (usize, usize) {
        (self.symbolic.supernode_begin()[s], self.symbolic.supernode_end()[s])
    }

    /// Eliminates the half from a right-hand side; what it leaves on the separator is in [`last`](Self::last).
    pub(super) fn forward(&mut self, r: &[f64]) {
        let (own, last) = self.x.split_at_mut(self.own);
        for (to, unknown) in own.iter_mut().zip(&self.unknowns) {
            *to = r[*unknown as usize];
        }
        last.fill(0.0);
        for s in 0..self.blocks() {
            self.eliminate(s);
        }
    }

    /// The same of a right-hand side that is zero beside some unknowns.
    pub(super) fn forward_from(&mut self, reach: &PartReach, r: &[f64]) {
        self.x.fill(0.0);
        reach.places.iter().for_each(|place| self.x[place.own as usize] = r[place.among as usize]);
        reach.blocks.iter().for_each(|s| self.eliminate(*s as usize));
    }

    /// Blocks that have columns of the half.
    pub(super) fn blocks(&self) -> usize {
        self.symbolic.supernode_begin().partition_point(|begin| *begin < self.own)
    }

    fn eliminate(&mut self, s: usize) {
        let (begin, end) = self.columns(s);
        let factor = supernodal::SupernodalLltRef::new(&self.symbolic, &self.values[..]);
        let width = end.min(self.own) - begin;
        let block = factor.supernode(s);
        let (top, below) = block.val().subcols(0, width).split_at_row(width);
        let x = &mut self.x[begin..begin + width];
        solve_lower_triangular_in_place(top, MatMut::from_column_major_slice_mut(x, width, 1), Par::Seq);
        let product = &mut self.block[..below.nrows()];
        let x = MatRef::from_column_major_slice(x, width, 1);
        let to = MatMut::from_column_major_slice_mut(product, below.nrows(), 1);
        matmul(to, Accum::Replace, below, x, 1.0, Par::Seq);
        // A block may reach into the separator.
        let rows = (begin + width..end).chain(block.pattern().iter().copied());
        rows.zip(product).for_each(|(row, value)| self.x[row] -= *value);
    }

    /// The separator's part of the vector.
    pub(super) fn last(&self) -> &[f64] {
        &self.x[self.own..]
    }

    /// Solves for the half, given the values of the separator.
    pub(super) fn backward(&mut self, separator: &[f64]) {
        self.x[self.own..].copy_from_slice(separator);
        for s in (0..self.blocks()).rev() {
            self.substitute(s);
        }
    }

    /// The same for some unknowns alone.
    pub(super) fn backward_to(&mut self, reach: &PartReach, separator: &[f64]) {
        self.x[self.own..].copy_from_slice(separator);
        reach.blocks.iter().rev().for_each(|s| self.substitute(*s as usize));
    }

    fn substitute(&mut self, s: usize) {
        let (begin, end) = self.columns(s);
        let factor = supernodal::SupernodalLltRef::new(&self.symbolic, &self.values[..]);
        let width = end.min(self.own) - begin;
        let block = factor.supernode(s);
        let (top, below) = block.val().subcols(0, width).split_at_row(width);
        let known = &mut self.block[..below.nrows()];
        let rows = (begin + width..end).chain(block.pattern().iter().copied());
        rows.zip(&mut *known).for_each(|(row, value)| *value = self.x[row]);
        let known = MatRef::from_column_major_slice(known, below.nrows(), 1);
        let mut x = MatMut::from_column_major_slice_mut(&mut self.x[begin..begin + width], width, 1);
        matmul(x.as_mut(), Accum::Add, below.transpose(), known, -1.0, Par::Seq);
        solve_upper_triangular_in_place(top.transpose(), x, Par::Seq);
    }

    /// Writes those of some unknowns to their places among these.
    pub(super) fn gather(&self, reach: &PartReach, z: &mut [f64]) {
        reach.places.iter().for_each(|place| z[place.among as usize] = self.x[place.own as usize]);
    }

    /// What of the half some unknowns need, given the place of every unknown among them.
    pub(super) fn reach(&self, among: &[Option<u32>]) -> PartReach {
        let places = self.unknowns[..self.own].iter().enumerate();
        let places: Vec<Place> = places
            .filter_map(|(own, unknown)| Some(Place { own: own as u32, among: among[*unknown as usize]? }))
            .collect();
        let block_of = |column: usize| self.symbolic.supernode_end().partition_point(|end| *end <= column);
        let mut is_reached = vec![false; self.blocks()];
        places.iter().for_each(|place| is_reached[block_of(place.own as usize)] = true);
        for s in 0..is_reached.len() {
            // The parent of a block has its first row below; all others are further up from there.
            let next = self.symbolic.supernode(s).pattern().iter().min().map(|row| block_of(*row));
            if let Some(next) = next.filter(|next| is_reached[s] && *next < is_reached.len()) {
                is_reached[next] = true;
            }
        }
        let blocks = (0..is_reached.len()).filter(|s| is_reached[*s]).map(|s| s as u32).collect();
        PartReach { blocks, places }
    }

    /// Writes the values of the half over those of a vector of all unknowns.
    pub(super) fn scatter(&self, z: &mut [f64]) {
        for (unknown, value) in self.unknowns[..self.own].iter().zip(&self.x) {
            z[*unknown as usize] = *value;
        }
    }
}

/// Blocks of the factor.
fn symbolic(structure: &Structure) -> Result<supernodal::SymbolicSupernodalCholesky<usize>, FactorError> {
    let (starts, rows) = structure.upper_pattern();
    let order = starts.len() - 1;
    let pattern = SymbolicSparseColMatRef::new_checked(order, order, &starts, None, &rows);
    let need = simplicial::prefactorize_symbolic_cholesky_scratch::<usize>(order, rows.len());
    let mut memory = buffer(StackReq::or(
        need,
        supernodal::factorize_supernodal_symbolic_cholesky_scratch::<usize>(order),
    ))?;
    let (mut tree, mut counts) = (vec![0_isize; order], vec![0_usize; order]);
    let stack = MemStack::new(&mut memory);
    let tree = simplicial::prefactorize_symbolic_cholesky(&mut tree, &mut counts, pattern, stack);
    supernodal::factorize_supernodal_symbolic_cholesky(pattern, tree, &counts, stack, Default::default())
        .map_err(|error| out_of_memory(&error, 0))
}
