//! Families as blocks of the assembled stiffness.

use super::GridFamilies;
use crate::body::plus;
use crate::bonds::Mat;
use crate::stiffness::BlockMatrix;
use std::collections::BTreeMap;

/// A member of a family and the rows `[ϑ, h]` of its unknowns.
pub(super) type Member<const D: usize> = (usize, Mat<2, D>);

impl<const D: usize> GridFamilies<D> {
    /// Members of the family of a point, itself among them.
    fn members(&self, point: usize, set: u32, members: &mut Vec<Member<D>>) {
        members.clear();
        let cell = self.lattice.cell(point);
        let mut own = [[0.0; D]; 2];
        for (step, row) in self.family.steps.iter().zip(&self.family.sets[set as usize]) {
            if let Some(other) = self.lattice.number(plus(cell, *step))
                && *row != [0.0; D]
            {
                members.push((other, [*row, [0.0; D]]));
                (0..D).for_each(|c| own[0][c] -= row[c]);
            }
        }
        if let Some(a) = self.family.own.get(point) {
            own[1][0] = *a;
        }
        members.push((point, own));
    }

    /// Members of the families of a block and the rows of its mean `Σ V (ϑ + h)/Σ V`, and the volume of the block.
    pub(super) fn mean_members(&self, block: &[u32]) -> (Vec<(usize, [f64; D])>, f64) {
        let whole: f64 = block.iter().map(|&k| self.family.volume[k as usize]).sum();
        let mut sums: BTreeMap<usize, [f64; D]> = BTreeMap::new();
        let mut members = Vec::new();
        for &point in block {
            let point = point as usize;
            let Some(set) = self.family.set_of[point] else { continue };
            let part = if whole > 0.0 { self.family.volume[point] / whole } else { 0.0 };
            self.members(point, set, &mut members);
            for (member, [theta, hoop]) in &members {
                let sum = sums.entry(*member).or_insert([0.0; D]);
                (0..D).for_each(|c| sum[c] += part * (theta[c] + hoop[c]));
            }
        }
        (sums.into_iter().collect(), whole)
    }

    pub(super) fn for_each_family(&self, mut visit: impl FnMut(usize, &[Member<D>])) {
        let mut members = Vec::new();
        for stretch in &self.stretches {
            for k in 0..stretch.columns.len() {
                self.members(stretch.first + k, stretch.set, &mut members);
                visit(stretch.first + k, &members);
            }
        }
    }

    /// The block of two members of a family of unit volume.
    fn block(&self, a: &Mat<2, D>, b: &Mat<2, D>) -> Mat<D, D> {
        let c = &self.family.modulus;
        let conjugate = |m: usize, column: usize| c[m][0] * b[0][column] + c[m][1] * b[1][column];
        std::array::from_fn(|r| {
            std::array::from_fn(|column| a[0][r] * conjugate(0, column) + a[1][r] * conjugate(1, column))
        })
    }

    pub(super) fn assemble(&self, tangent: &mut BlockMatrix<D>) {
        self.for_each_family(|point, members| {
            let volume = self.family.volume[point];
            for (i, a) in members {
                for (j, b) in members.iter().filter(|(j, _)| j >= i) {
                    tangent.add(*i, *j, &self.block(a, b).map(|row| row.map(|v| volume * v)));
                }
            }
        });
        for block in self.blocks.iter().flat_map(|blocks| blocks.iter()) {
            let (members, whole) = self.mean_members(block);
            let modulus = self.family.mean_modulus * whole;
            for (at, (i, a)) in members.iter().enumerate() {
                for (j, b) in &members[at..] {
                    tangent.add(*i, *j, &a.map(|a| b.map(|b| modulus * a * b)));
                }
            }
        }
    }

    pub(super) fn assemble_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        let add = |to: &mut Mat<D, D>, factor: f64, part: Mat<D, D>| {
            to.as_flattened_mut().iter_mut().zip(part.as_flattened()).for_each(|(t, p)| *t += factor * p);
        };
        self.for_each_family(|point, members| {
            let volume = self.family.volume[point];
            members.iter().for_each(|(i, a)| add(&mut blocks[*i], volume, self.block(a, a)));
        });
        for block in self.blocks.iter().flat_map(|blocks| blocks.iter()) {
            let (members, whole) = self.mean_members(block);
            let modulus = self.family.mean_modulus * whole;
            members.iter().for_each(|(i, a)| add(&mut blocks[*i], modulus, a.map(|r| a.map(|c| r * c))));
        }
    }
}
