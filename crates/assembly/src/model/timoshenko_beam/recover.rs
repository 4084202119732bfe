//! Fields of a solved beam: section forces, stress, energy density.

use super::TimoshenkoBeam;
use super::load::BeamLoads;

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
    /// Fields of a line under unknowns `u` and the loads that caused them.
    ///
    /// Section forces are cut sums: every bond that crosses a section adds its constant shear force, its linear moment
    /// and the fixed-end forces of the load it carries. That is exact, for every law, for the loads as given.
    pub fn fields(&self, chain: usize, u: &[f64], loads: &BeamLoads) -> BeamFields {
        let (c, bonds) = (&self.chains[chain], &self.bonds[chain]);
        let cells = c.points - 1;
        let mut forces = SectionForces { moment: vec![[0.0; 2]; cells], shear: vec![[0.0; 2]; cells] };
        let mut energy = vec![0.0; cells];
        let loaded = loads.loads_bonds(chain);
        for class in 0..bonds.classes().len() {
            let step = bonds.classes()[class].step;
            let moduli = bonds.moduli(class);
            bonds.for_each(class, |lower, weight| {
                let s = bonds.measure(class, lower, u);
                let (m, v) = (weight * moduli[0] * s[0], weight * moduli[1] * s[1]);
                let real = |p: usize| p.checked_sub(c.ghosts[0]).filter(|&k| k < c.points);
                let span = self.span(chain, class, lower);
                let density = 0.5 * (m * s[0] + v * s[1]) / (self.parameters.area * span.length);
                let ends = if loaded { loads.on(chain, &span) } else { [0.0; 4] };
                for cell in lower..lower + step {
                    let Some(k) = real(cell).filter(|&k| k < cells) else { continue };
                    energy[k] += density;
                    for side in 0..2 {
                        let s = (cell + side - lower) as f64 * c.spacing;
                        let mut part = [m + v * (0.5 * span.length - s), v];
                        if loaded {
                            let [q, qx] = loads.resultant(chain, span.x, span.x + s, side == 0);
                            part[0] += weight * (ends[1] - ends[0] * s + qx);
                            part[1] += weight * (ends[0] - q);
                        }
                        forces.moment[k][side] += part[0];
                        forces.shear[k][side] += part[1];
                    }
                }
            });
        }
        let energy_density = (0..c.points)
            .map(|k| {
                let sides = [k.checked_sub(1), Some(k).filter(|&k| k < cells)];
                let (sum, count) =
                    sides.iter().flatten().fold((0.0, 0.0), |(sum, n), &c| (sum + energy[c], n + 1.0));
                sum / count
            })
            .collect();
        BeamFields { forces, energy_density }
    }
}
