//! Stress and energy density of the points of a lattice, from bonds and triangles, and the load that belongs to a stress.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::{By, modulus};
use super::geometry;
use crate::bonds::{Mat, add};
use crate::model::BodyFields;
use crate::stiffness::{Family, WideFamilies};
use rayon::prelude::*;
use std::array::from_fn;
use std::ops::Range;

/// Fields by component planes; images have zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneFields {
    /// `[σ_xx, σ_yy, σ_xy]`, Pa, of every point.
    pub stress: [Vec<f64>; 3],
    /// Strain energy density, J/m³, of every point.
    pub energy_density: Vec<f64>,
    /// Stress across the section, Pa, of every point; empty where it follows from the others
    /// ([`stress_across`](super::PlaneModel::stress_across)).
    pub across: Vec<f64>,
}

impl From<PlaneFields> for BodyFields {
    fn from(PlaneFields { stress, energy_density, across }: PlaneFields) -> Self {
        Self { stress: stress.into(), energy_density, across }
    }
}

impl PlaneFields {
    /// Adds what triangles bring to their points to three planes of stresses and one of energy densities; `volume` is
    /// that of a point.
    pub(in super::super) fn with_triangles<'a, const D: usize, const S: usize>(
        mut sums: Vec<f64>,
        triangles: impl Iterator<Item = &'a Family<D, S, 2>>,
        volume: impl Fn(usize) -> f64,
        u: &[f64],
    ) -> Self {
        let n = sums.len() / 4;
        for triangle in triangles {
            triangle.add_densities(3, volume(triangle.point as usize), u, &mut sums);
        }
        let energy_density = sums.split_off(3 * n);
        let xy = sums.split_off(2 * n);
        let yy = sums.split_off(n);
        Self { stress: [sums, yy, xy], energy_density, across: Vec::new() }
    }
}

/// Adds the forces of triangles that do the work of their stresses with the strains `t`, three planes.
fn add_work_of_triangles<const D: usize, const S: usize>(
    triangles: &[Family<D, S, 2>],
    t: &[f64],
    force: &mut [f64],
) {
    triangles.iter().for_each(|triangle| triangle.add_strain_work(3, t, force));
}

/// Adds the forces that do the work of families of any size in strains `t` of the points, three planes, as far as they move them.
fn add_strain_work_of<const D: usize, const S: usize>(
    families: &WideFamilies<D, S>,
    t: &[f64],
    force: &mut [f64],
) {
    let n = t.len() / 3;
    for family in 0..families.count() {
        let mut strain = [0.0; S];
        for member in families.members(family) {
            (0..3).for_each(|q| strain[q] += member.share * t[q * n + member.point as usize]);
        }
        if strain != [0.0; S] {
            families.add_work(family, &families.stress(family, &strain), force);
        }
    }
}

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// Stresses and energy densities of a state: the virial `σ_k = (1/V_k) [½ Σ_j Uᵀ c s + Σ D E/n]` of bonds with the
    /// measures s, `U E` in a uniform state E, and of triangles.
    pub(in super::super) fn fields(&self, u: &[f64]) -> PlaneFields {
        let n = self.lattice.points();
        let volume = self.cell_volume();
        let shares = self.virial_shares(1.0 / volume);
        let mut sums = self.whole().sums::<3>(u, &shares);
        sums[3 * n..].par_iter_mut().with_min_len(4096).for_each(|energy| *energy /= volume);
        if let Some(interface) = &self.interface {
            interface.uneven.add_to(self.whole(), (u, &shares, volume), &mut sums);
        }
        // Beside a border that is completed a point stands for a whole cell of its stress.
        let follows = self.border.is_cut();
        let cut_cells = if follows { &[] } else { self.lattice.cut_cells() };
        for &(point, part) in cut_cells {
            (0..4).for_each(|q| sums[q * n + point as usize] /= part);
        }
        self.ghosts.iter().for_each(|&g| (0..4).for_each(|q| sums[q * n + g as usize] = 0.0));
        let of_point = |point| self.stress_volume(point);
        let given_back = self.interface.iter().flat_map(|interface| interface.stress_families());
        let triangles = self.triangles.list().iter().chain(given_back);
        let mut fields = PlaneFields::with_triangles(sums, triangles, of_point, u);
        if let Some(strains) = &self.border.strains {
            let of_tables: Vec<Mat<S, S>> =
                (0..=self.neighbourhood.others.len()).map(|table| self.stiffness(table)).collect();
            strains.for_each((n, u), &mut |point, strain| {
                let (c, factor) = (&of_tables[self.table(point)], self.factor(point));
                let stress: [f64; 3] = from_fn(|q| (0..3).map(|k| factor * c[q][k] * strain[k]).sum());
                (0..3).for_each(|q| fields.stress[q][point] = stress[q]);
                fields.energy_density[point] = (0..3).map(|q| 0.5 * stress[q] * strain[q]).sum();
            });
        }
        fields
    }

    /// Stiffness of the material of a table, Pa, for uniform states.
    fn stiffness(&self, table: usize) -> Mat<S, S> {
        let mut sum = [[0.0; S]; S];
        for k in self.neighbourhood.bonded() {
            let weights = self.neighbourhood.weights_of(table, k);
            let own = modulus(&self.lattice, &self.kind.bond, self.neighbourhood.offsets[k], weights);
            add(&mut sum, &own);
        }
        sum.map(|row| row.map(|x| x / self.cell_volume()))
    }

    /// Adds the forces that do the work `Σ_k t_k·V_k σ_k` with the strains `t`, three planes, of some points, none for all.
    pub(in super::super) fn add_strain_work(
        &self,
        t: &mut [f64],
        points: Option<&[usize]>,
        force: &mut [f64],
    ) {
        self.add_border_work(t, force);
        self.add_bond_work(t, points, force);
    }

    /// The part of what completes the border; images get the strains of their points.
    pub(in super::super) fn add_border_work(&self, t: &mut [f64], force: &mut [f64]) {
        let n = self.lattice.points();
        if !self.border.is_none() {
            for &ghost in &self.ghosts {
                let (image, [x, y, _]) = self.mirrors.image(self.lattice.cell(ghost as usize));
                let real = self.lattice.number(image);
                let signs = B::image_signs([x, y]);
                let of = |q: usize| real.map_or(0.0, |real| signs[q] * t[q * n + real]);
                let strain = [of(0), of(1), of(2)];
                (0..3).for_each(|q| t[q * n + ghost as usize] = strain[q]);
            }
        }
        match &self.border.by {
            By::Points => add_work_of_triangles(self.triangles.list(), t, force),
            By::Bonds(border) => {
                border.add_strain_work((&self.lattice, &self.neighbourhood, &self.kind.bond), t, force);
            }
            By::Triangles(families) => add_strain_work_of(families, t, force),
        }
        if let Some(interface) = &self.interface {
            add_work_of_triangles(interface.beside_border(), t, force);
        }
    }

    /// The part of the bonds between points.
    pub(in super::super) fn add_bond_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.add_work_of_halves(t, points, force);
        if let Some(interface) = &self.interface {
            interface.uneven.add_work(self.whole(), (t, &self.virial_shares(1.0)), force);
        }
    }

    /// The same, both points having half of every bond; images have no part in it.
    pub(super) fn add_work_of_halves(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        let n = self.lattice.points();
        self.ghosts.iter().for_each(|&g| (0..3).for_each(|q| t[q * n + g as usize] = 0.0));
        let shares = self.virial_shares(1.0);
        self.whole().add_work::<3>(t, &self.spans(points), &shares, force);
        if let Some(interface) = &self.interface {
            add_work_of_triangles(interface.stress_families(), t, force);
        }
    }

    /// `½ Uᵀ scale` per offset that has bonds: with the forces of the bonds it makes `V_k σ_k` of their points.
    pub(super) fn virial_shares(&self, scale: f64) -> Vec<Mat<3, M>> {
        let of = |k: usize| {
            let uniform =
                self.kind.bond.in_uniform_state(&geometry(&self.lattice, self.neighbourhood.offsets[k]));
            from_fn(|q| from_fn(|m| 0.5 * scale * uniform[m][q]))
        };
        self.neighbourhood.bonded().map(of).collect()
    }

    /// Columns from the first to behind the last of some points, per row of the plane.
    fn spans(&self, points: Option<&[usize]>) -> Vec<Range<i32>> {
        let rows = self.lattice.rows();
        let Some(points) = points else {
            return rows.map(|_| self.lattice.columns()).collect();
        };
        let mut spans = vec![0..0; rows.len()];
        for &point in points {
            let [column, row, _] = self.lattice.cell(point);
            let span: &mut Range<i32> = &mut spans[(row - rows.start) as usize];
            *span = match span.start >= span.end {
                true => column..column + 1,
                false => span.start.min(column)..span.end.max(column + 1),
            };
        }
        spans
    }
}
