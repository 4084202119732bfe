//! Stress and energy density of the points of a solid, and the load that belongs to a stress.

use super::super::plane::LatticeBond;
use super::body::SolidBody;
use super::bond::SolidBond;
use super::{SolidFields, TENSOR};
use crate::bonds::{BondGeometry, Mat};
use std::array::from_fn;

impl SolidBody {
    /// Stresses and energy densities of a state: the virial `σ_k = (1/V) [½ Σ_j k ξ N e] + D Ē + A ϑ 1` of a whole point, with
    /// the mean strain Ē of its tetrahedra.
    pub(super) fn fields(&self, u: &[f64]) -> SolidFields {
        let (n, volume) = (self.lattice.points(), self.cell_volume());
        let shares = self.virial_shares(1.0 / volume);
        let mut sums = self.whole().sums::<TENSOR>(u, &shares);
        sums[TENSOR * n..].iter_mut().for_each(|energy| *energy /= volume);
        if let Some(interface) = &self.interface {
            interface.uneven.add_to(self.whole(), (u, &shares, volume), &mut sums);
            for family in interface.stress_families() {
                family.add_densities(TENSOR, volume, u, &mut sums);
            }
        }
        let overlay = &self.overlay;
        for family in 0..overlay.families.count() {
            let (point, kind, factor, measures) = overlay.families.family(family, u);
            let own = self.factor(point);
            let kind = &overlay.kinds[kind];
            let strain = kind.strain_of(&measures);
            for q in 0..TENSOR {
                sums[q * n + point] += own * (0..TENSOR).map(|r| kind.lack[q][r] * strain[r]).sum::<f64>();
            }
            sums[TENSOR * n + point] += own * overlay.families.energy(family, &measures) / (factor * volume);
        }
        if let (Some(families), Some(law)) = (&self.families, &self.law.dilatation) {
            for (point, theta) in families.dilatations(u).into_iter().enumerate() {
                let modulus = law.modulus * self.factor(point);
                (0..3).for_each(|q| sums[q * n + point] += modulus * theta);
                sums[TENSOR * n + point] += 0.5 * modulus * theta * theta;
            }
        }
        for &ghost in &self.ghosts {
            (0..=TENSOR).for_each(|q| sums[q * n + ghost as usize] = 0.0);
        }
        SolidFields::of(sums)
    }

    /// Adds the forces that do the work `Σ_k t_k·V_k σ_k` with the strains `t`, six planes.
    pub(super) fn add_strain_work(&self, t: &mut [f64], force: &mut [f64]) {
        let n = self.lattice.points();
        if let Some(border) = &self.border {
            self.reflect(t);
            border.bonds.add_work(t, &border.uniform, force);
        }
        for &ghost in &self.ghosts {
            (0..TENSOR).for_each(|q| t[q * n + ghost as usize] = 0.0);
        }
        for &(point, part) in self.lattice.cut_cells() {
            (0..TENSOR).for_each(|q| t[q * n + point as usize] *= part);
        }
        if self.border.is_none() {
            self.add_overlay_work(t, force);
        }
        if let (Some(families), Some(law)) = (&self.families, &self.law.dilatation) {
            let trace = |p: usize| t[p] + t[n + p] + t[2 * n + p];
            let stress =
                (0..n).map(|p| self.cell_volume() * law.modulus * self.factor(p) * trace(p)).collect();
            families.add_measure_work([stress, Vec::new()], force);
        }
        let lines = self.lattice.rows().len() * self.lattice.layers().len();
        let spans = vec![self.lattice.columns(); lines];
        let shares = self.virial_shares(1.0);
        self.whole().add_work::<TENSOR>(t, &spans, &shares, force);
        if let Some(interface) = &self.interface {
            interface.uneven.add_work(self.whole(), (t, &shares), force);
            interface.add_work(t, force);
        }
    }

    /// Gives images the strains of their points.
    fn reflect(&self, t: &mut [f64]) {
        let n = self.lattice.points();
        for &ghost in &self.ghosts {
            let (image, [x, y, z]) = self.mirrors.image(self.lattice.cell(ghost as usize));
            let signs = [1.0, 1.0, 1.0, y * z, x * z, x * y];
            let real = self.lattice.number(image);
            (0..TENSOR).for_each(|q| {
                t[q * n + ghost as usize] = real.map_or(0.0, |real| signs[q] * t[q * n + real])
            });
        }
    }

    /// The part of tetrahedra.
    fn add_overlay_work(&self, t: &[f64], force: &mut [f64]) {
        let (n, volume, overlay) = (self.lattice.points(), self.cell_volume(), &self.overlay);
        for family in 0..overlay.families.count() {
            let (point, kind) = overlay.families.point_and_kind(family);
            let kind = &overlay.kinds[kind];
            let own: [f64; TENSOR] = from_fn(|q| t[q * n + point]);
            let stress: [f64; TENSOR] =
                from_fn(|q| volume * (0..TENSOR).map(|r| kind.lack[q][r] * own[r]).sum::<f64>());
            let sigma: Vec<f64> =
                kind.strain.iter().map(|rows| (0..TENSOR).map(|q| rows[q] * stress[q]).sum()).collect();
            overlay.families.add_work(family, &sigma, force);
        }
    }

    pub(super) fn bond(&self) -> SolidBond {
        SolidBond { volume: self.cell_volume() }
    }

    /// `½ ξ N scale` per offset that has bonds: with the forces of the bonds it makes `V_k σ_k` of their points.
    fn virial_shares(&self, scale: f64) -> Vec<Mat<TENSOR, 1>> {
        let of = |k: usize| {
            let bond = BondGeometry { xi: self.lattice.vector(self.law.neighbourhood.offsets[k]) };
            let [uniform] = self.bond().in_uniform_state(&bond);
            uniform.map(|x| [0.5 * scale * x])
        };
        self.law.neighbourhood.bonded().map(of).collect()
    }
}
