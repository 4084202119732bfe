//! Fields of a solved beam: section forces, stress, energy density.

use super::TimoshenkoBeam;
use super::load::BeamLoads;
use crate::model::Model;
use crate::sum::Sum;

/// Moment and shear force at the two ends of every cell of a line, seen from inside the cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionForces {
    /// Moments M at the left and right end of each cell, N m.
    pub moment: Vec<[f64; 2]>,
    /// Shear forces V at the left and right end of each cell, N.
    pub shear: Vec<[f64; 2]>,
}

/// Recovered fields of one line.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamFields {
    /// Section forces per cell between neighbouring points.
    pub forces: SectionForces,
    /// Strain energy density per point, J/m³: the mean of its cells, over which every bond spreads its energy. Inside, that
    /// is Eqs. (11a,b) up to δ²; at an end the halves of those equations pile up where bonds make up for missing ones.
    pub energy_density: Vec<f64>,
}

impl SectionForces {
    /// Moment and shear at a point: the value to its right, at the last point the one to its left.
    pub fn at(&self, point: usize) -> (f64, f64) {
        let cells = self.moment.len();
        let (cell, end) = if point < cells { (point, 0) } else { (cells - 1, 1) };
        (self.moment[cell][end], self.shear[cell][end])
    }
}

impl TimoshenkoBeam {
    /// Fields of a line under unknowns `u`, with all forces on its points (loads, reactions, forces of links and springs;
    /// two planes) and the loads that bonds share.
    ///
    /// Section forces are sums from the left end. Summed over the bonds that cross a section they would be the same, but
    /// the shear force would be a small difference of large deflections: half its digits are gone at slenderness 10⁴.
    /// Loads that bonds share reach the points as fixed-end forces; what these say differently from the load itself inside
    /// the crossing bonds is put back, so that moment and shear force are those of the loads as given.
    pub fn fields(&self, chain: usize, u: &[f64], forces: &[f64], loads: &BeamLoads) -> BeamFields {
        let mut sections = self.statics(chain, forces);
        if loads.loads_bonds(chain) {
            self.add_fixed_end_forces(chain, loads, &mut sections);
        }
        BeamFields { forces: sections, energy_density: self.energy_density(chain, u) }
    }

    /// Section forces of forces on points.
    fn statics(&self, chain: usize, forces: &[f64]) -> SectionForces {
        let (c, n) = (&self.chains[chain], self.points());
        let first = self.bonds[chain].lattice().first;
        let mut sections = SectionForces::default();
        let (mut moment, mut shear) = (Sum::default(), Sum::default());
        for k in 0..c.ghosts[0] + c.points - 1 {
            // A force on a point lowers V to its right, a moment lowers M.
            shear.add(-forces[first + k]);
            moment.add(-forces[n + first + k]);
            let left = moment.total();
            moment.add(-shear.total() * c.spacing);
            if k >= c.ghosts[0] {
                sections.moment.push([left, moment.total()]);
                sections.shear.push([shear.total(); 2]);
            }
        }
        sections
    }

    /// Adds to every cell what the crossing bonds carry of their loads beyond the fixed-end forces on their points.
    fn add_fixed_end_forces(&self, chain: usize, loads: &BeamLoads, sections: &mut SectionForces) {
        let (c, bonds) = (&self.chains[chain], &self.bonds[chain]);
        for class in 0..bonds.classes().len() {
            let step = bonds.classes()[class].step;
            bonds.for_each_run(class, |run, weight| {
                for lower in run {
                    let span = self.span(chain, class, lower);
                    let ends = loads.on(chain, &span);
                    for cell in 0..step {
                        for side in 0..2 {
                            let s = (cell + side) as f64 * c.spacing;
                            let [q, qx] = loads.resultant(chain, span.x, span.x + s, side == 0);
                            sections.moment[lower + cell][side] += weight * (ends[1] - ends[0] * s + qx);
                            sections.shear[lower + cell][side] += weight * (ends[0] - q);
                        }
                    }
                }
            });
        }
    }

    /// Energy density per point.
    fn energy_density(&self, chain: usize, u: &[f64]) -> Vec<f64> {
        let (c, bonds) = (&self.chains[chain], &self.bonds[chain]);
        let cells = c.points - 1;
        let mut energy = vec![0.0; cells];
        for (class, offset) in bonds.classes().iter().enumerate() {
            let moduli = bonds.moduli(class);
            let volume = self.parameters.area * offset.geometry.length();
            bonds.for_each_run(class, |run, weight| {
                for lower in run {
                    let s = bonds.measure(class, lower, u);
                    let density = 0.5 * weight * (moduli[0] * s[0] * s[0] + moduli[1] * s[1] * s[1]) / volume;
                    let real = (lower..lower + offset.step).filter_map(|p| p.checked_sub(c.ghosts[0]));
                    real.filter(|&k| k < cells).for_each(|k| energy[k] += density);
                }
            });
        }
        let point = |k: usize| {
            let sides = [k.checked_sub(1), Some(k).filter(|&k| k < cells)];
            let (sum, count) =
                sides.iter().flatten().fold((0.0, 0.0), |(sum, n), &c| (sum + energy[c], n + 1.0));
            sum / count
        };
        (0..c.points).map(point).collect()
    }
}
