//! Fields of a solved beam: section forces, energy density.

use super::load::{BeamLoads, FixedEnd};
use super::{Chain, PHI, TimoshenkoBeam, U, W};
use crate::sum::Sum;
use std::ops::Range;

/// Section forces at the two ends of every cell of a line, seen from inside the cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionForces {
    /// Moments M at the left and right end of each cell, N m.
    pub moment: Vec<[f64; 2]>,
    /// Shear forces V at the left and right end of each cell, N.
    pub shear: Vec<[f64; 2]>,
    /// Axial forces N at the left and right end of each cell, N, tension positive; empty in bodies without axial unknowns.
    pub axial: Vec<[f64; 2]>,
}

impl SectionForces {
    /// Moment, shear and axial force at a point: the values to its right, at the last point those to its left.
    pub fn at(&self, point: usize) -> (f64, f64, f64) {
        let cells = self.moment.len();
        let (cell, end) = if point < cells { (point, 0) } else { (cells - 1, 1) };
        let axial = self.axial.get(cell).map_or(0.0, |n| n[end]);
        (self.moment[cell][end], self.shear[cell][end], axial)
    }
}

/// Cells whose shares of loads are found together.
const BLOCK: usize = 1024;

/// Moment, shear and axial force at both ends of cells that crossing bonds carry of their loads beyond the fixed-end forces on their
/// points: N m, N, N.
fn carried_beyond(chain: &Chain, fixed_end: &FixedEnd, cells: &Range<usize>) -> Vec<[[f64; 3]; 2]> {
    // Loads were shared before anything broke.
    let weights = chain.intact_weights();
    let mut shares = vec![[[0.0; 3]; 2]; cells.len()];
    for class in 0..if cells.is_empty() { 0 } else { weights.classes() } {
        let step = weights.step(class);
        for lower in (cells.start + 1).saturating_sub(step)..cells.end.min(chain.points.saturating_sub(step))
        {
            let weight = weights.weight(class, lower);
            if weight == 0.0 {
                continue;
            }
            let (ends, start) = (fixed_end.of(class, lower), chain.position(lower));
            for cell in lower.max(cells.start)..(lower + step).min(cells.end) {
                for (side, share) in shares[cell - cells.start].iter_mut().enumerate() {
                    let x = chain.position(cell + side);
                    let [q, qx, p] = fixed_end.resultant(start, x, side == 0);
                    share[0] += weight * (ends[1] - ends[0] * (x - start) + qx);
                    share[1] += weight * (ends[0] - q);
                    share[2] += weight * (ends[4] - p);
                }
            }
        }
    }
    shares
}

impl TimoshenkoBeam {
    /// Section forces of a line under all forces on its points (loads, reactions, forces of links and springs; two or three
    /// planes) and the loads that bonds share.
    ///
    /// Section forces are sums from the left end. Summed over the bonds that cross a section they would be the same, but
    /// the shear force would be a small difference of large deflections: half its digits are gone at slenderness 10⁴.
    /// Loads that bonds share reach the points as fixed-end forces; what these say differently from the load itself inside
    /// the crossing bonds is put back, so that section forces are those of the loads as given.
    ///
    /// `lumped` are those of the forces that only stand for what acts all along the parts of their points, lumped loads and
    /// foundations, in as many planes: half of such a force has not been passed yet where its point is.
    pub fn section_forces(
        &self,
        chain: usize,
        forces: &[f64],
        lumped: Option<&[f64]>,
        loads: &BeamLoads,
    ) -> SectionForces {
        let mut sections = self.statics(chain, forces);
        if let Some(lumped) = lumped {
            self.spread_lumped(chain, lumped, &mut sections);
        }
        let fixed_end = FixedEnd::new(loads, chain, &self.chains[chain]);
        if fixed_end.is_needed() {
            self.add_fixed_end_forces(chain, &fixed_end, &mut sections);
        }
        sections
    }

    /// Section forces of forces on points.
    fn statics(&self, chain: usize, forces: &[f64]) -> SectionForces {
        let (c, n, first) = (&self.chains[chain], self.points, self.first[chain]);
        let has_axial = forces.len() > U * n;
        let cells = c.points - 1;
        let mut sections = SectionForces {
            moment: Vec::with_capacity(cells),
            shear: Vec::with_capacity(cells),
            axial: Vec::with_capacity(if has_axial { cells } else { 0 }),
        };
        let (mut moment, mut shear, mut axial) = (Sum::default(), Sum::default(), Sum::default());
        for k in 0..c.ghosts[0] + cells {
            // A force on a point lowers V to its right, a moment lowers M.
            shear.add(-forces[first + k]);
            moment.add(-forces[PHI * n + first + k]);
            let left = moment.total();
            moment.add(-shear.total() * (c.position(k + 1) - c.position(k)));
            if has_axial {
                axial.add(-forces[U * n + first + k]);
            }
            if k >= c.ghosts[0] {
                sections.moment.push([left, moment.total()]);
                sections.shear.push([shear.total(); 2]);
                if has_axial {
                    sections.axial.push([axial.total(); 2]);
                }
            }
        }
        sections
    }

    /// Gives the two sides of every point the share of its lumped forces that lies on their side.
    fn spread_lumped(&self, chain: usize, lumped: &[f64], sections: &mut SectionForces) {
        let (c, n, first) = (&self.chains[chain], self.points, self.first_real(chain));
        let SectionForces { moment, shear, axial } = sections;
        for (component, cells) in [(W, shear), (PHI, moment), (U, axial)] {
            for (k, cell) in cells.iter_mut().enumerate() {
                for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
                    let point = k + side;
                    let ((a, b), x) = (c.tributary(point), c.position(c.ghosts[0] + point));
                    let part = if side == 0 { b - x } else { x - a };
                    cell[side] += sign * part / (b - a) * lumped[component * n + first + point];
                }
            }
        }
    }

    /// Adds to every cell what the crossing bonds carry of their loads beyond the fixed-end forces on their points.
    fn add_fixed_end_forces(&self, chain: usize, fixed_end: &FixedEnd, sections: &mut SectionForces) {
        let (chain, cells) = (&self.chains[chain], sections.moment.len());
        for start in (0..cells).step_by(BLOCK) {
            let block = start..(start + BLOCK).min(cells);
            let alike = fixed_end.cells_alike(&block);
            let one = alike.start..alike.end.min(alike.start + 1);
            let [left, right] = [block.start..alike.start, alike.end..block.end];
            for (cells, of) in [(left.clone(), left), (alike, one), (right.clone(), right)] {
                let shares = carried_beyond(chain, fixed_end, &of);
                for (cell, share) in cells.zip(shares.iter().cycle()) {
                    for (side, [moment, shear, axial]) in share.iter().enumerate() {
                        sections.moment[cell][side] += moment;
                        sections.shear[cell][side] += shear;
                        if let Some(values) = sections.axial.get_mut(cell) {
                            values[side] += axial;
                        }
                    }
                }
            }
        }
    }

    /// Strain energy density per point that bonds store under unknowns `u`, J/m³: the mean of its cells, over which every bond spreads
    /// its energy. Inside, that is Eqs. (11a,b) up to δ²; at an end the halves of those equations pile up where bonds make up for
    /// missing ones.
    pub fn energy_density(&self, chain: usize, u: &[f64]) -> Vec<f64> {
        let (c, n, first) = (&self.chains[chain], self.points, self.first[chain]);
        let cells = c.points - 1;
        // A bar from end to end stretches evenly.
        let has_axial = u.len() > U * n;
        let mut energy = vec![0.0; cells];
        for class in 0..c.weights.classes() {
            let step = c.weights.step(class);
            for lower in 0..c.extended() - step {
                let weight = c.weights.weight(class, lower);
                let bond = c.bonds.bond(class, lower);
                let [i, j] = [first + lower, first + lower + step];
                let du = if has_axial { u[U * n + j] - u[U * n + i] } else { 0.0 };
                let difference = [u[j] - u[i], u[n + j] - u[n + i], du];
                let [dphi, gamma, stretch] = bond.measures(difference, u[n + i] + u[n + j]);
                let mut density = bond.bending * dphi * dphi + bond.shear * gamma * gamma;
                if has_axial {
                    density += bond.axial * stretch * stretch;
                }
                density *= 0.5 * weight / (c.line().stiffness.area * bond.length);
                let real = (lower..lower + step).filter_map(|p| p.checked_sub(c.ghosts[0]));
                real.filter(|&k| weight != 0.0 && k < cells).for_each(|k| energy[k] += density);
            }
        }
        let point = |k: usize| {
            let sides = [k.checked_sub(1), Some(k).filter(|&k| k < cells)];
            let (sum, count) =
                sides.iter().flatten().fold((0.0, 0.0), |(sum, n), &c| (sum + energy[c], n + 1.0));
            sum / count
        };
        (0..c.points).map(point).collect()
    }

    /// Completes axial displacements between the ends of lines that stretch as one bar, in three planes.
    pub fn fill_axial(&self, u: &mut [f64]) {
        for (chain, &first) in self.chains.iter().zip(&self.first).filter(|(c, _)| c.stretches_as_bar()) {
            let plane = &mut u[U * self.points + first..][..chain.points];
            let (start, last) = (plane[0], chain.points - 1);
            let stretch = (plane[last] - start) / last as f64;
            (1..last).for_each(|k| plane[k] = start + k as f64 * stretch);
        }
    }
}
