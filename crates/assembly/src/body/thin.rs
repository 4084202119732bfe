//! Slots thinner than a cell: steps between next cells that leave the body and come back.

use super::cover::clipped;
use super::fill::FillError;
use super::geometry::{Point, dot, left_normal, meet, minus, moved};
use super::joined::Chains;
use super::lattice::{Cell, STEPS, SquareLattice, plus};
use super::outline::Outline;
use std::collections::BTreeMap;

/// Crossings this close along a step are one.
const SAME: f64 = 1e-9;

/// Cosine of the angle between the sides of a slot or a wedge that is as thin as one, outwards: 30 degrees. Wider wedges part
/// what is beside cells that they remove.
const FACING: f64 = -0.866;

/// A step from a cell to a next one, by its index.
type Step = (Cell, u8);

impl Outline {
    /// A lattice that it fills, with the slots that part its points; holes that are `missed` by all of its cells must.
    ///
    /// # Errors
    /// [`FillError::NoCellInHole`].
    pub(super) fn with_thin_slots(
        &self,
        lattice: SquareLattice,
        missed: &[usize],
    ) -> Result<SquareLattice, FillError> {
        let found: Vec<Vec<Step>> =
            (0..=self.holes().len()).map(|border| self.thin_slots(&lattice, border)).collect();
        let lattice = lattice.with_slots(found.concat());
        let has = |cell: Cell| lattice.number(cell).is_some();
        let is_open = |from: Cell, to: Cell| lattice.is_open(from, to);
        let chains = Chains { has: &has, is_open: &is_open };
        let is_parted = |&(cell, step): &Step| !chains.join(cell, STEPS[step as usize], 2);
        match missed.iter().find(|&&hole| !found[hole + 1].iter().any(is_parted)) {
            Some(&hole) => Err(FillError::NoCellInHole { hole }),
            None => Ok(lattice),
        }
    }

    /// The steps between points of a lattice that it fills which a slot parts, of its polygon, 0, or a hole, from 1: they cross
    /// it from one side to the opposite one. Where a border bulges between two points its sides face the same way, and nothing
    /// is parted.
    pub(super) fn thin_slots(&self, lattice: &SquareLattice, border: usize) -> Vec<Step> {
        let corners = self.in_cells(lattice, border, [-0.5; 2]);
        let edge = |k: usize| [corners[k], corners[(k + 1) % corners.len()]];
        let mut crossed: BTreeMap<Step, Vec<usize>> = BTreeMap::new();
        for k in 0..corners.len() {
            for_each_step_near(lattice, edge(k), &mut |cell, step| {
                crossed.entry((cell, step)).or_default().push(k);
            });
        }
        let parts = |(&(cell, step), edges): (&Step, &Vec<usize>)| {
            let [from, to] = [cell, plus(cell, STEPS[step as usize])].map(centre);
            let mut found: Vec<(f64, usize)> =
                edges.iter().map(|&k| (along([from, to], edge(k)), k)).collect();
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            found.windows(2).any(|pair| {
                let [(a, one), (b, other)] = [pair[0], pair[1]];
                let [n, m] = [one, other].map(|k| left_normal(edge(k)[0], edge(k)[1]));
                let middle = moved(from, 0.5 * (a + b), minus(to, from));
                b - a > SAME && dot(n, m) < FACING && !self.contains(place(lattice, middle))
            })
        };
        crossed.iter().filter(|c| c.1.len() > 1).filter(|c| parts(*c)).map(|c| *c.0).collect()
    }
}

/// A position in cells from point `[0, 0]`, m.
fn place(lattice: &SquareLattice, at: Point) -> Point {
    [0, 1].map(|k| lattice.corner()[k] + (at[k] + 0.5) * lattice.spacing())
}

fn centre([i, j, _]: Cell) -> Point {
    [f64::from(i), f64::from(j)]
}

/// Where on a segment an edge crosses it, from 0 to 1.
fn along([from, to]: [Point; 2], [a, b]: [Point; 2]) -> f64 {
    let across = minus(b, a);
    let normal = [across[1], -across[0]];
    dot(minus(a, from), normal) / dot(minus(to, from), normal)
}

/// Calls `visit` with every step between two points of a lattice that an edge meets; positions are in cells from point `[0, 0]`.
fn for_each_step_near(lattice: &SquareLattice, [a, b]: [Point; 2], visit: &mut dyn FnMut(Cell, u8)) {
    let [low, high] = [a[1].min(b[1]).floor() as i32 - 1, a[1].max(b[1]).ceil() as i32];
    for row in low.max(lattice.rows().start)..=high.min(lattice.rows().end) {
        let strip = [f64::from(row), f64::from(row + 1)];
        let ends = clipped(a, b, 1, strip).map(|p| p[0]);
        let columns = (ends[0].min(ends[1]).floor() as i32 - 1)..=(ends[0].max(ends[1]).ceil() as i32 + 1);
        for column in columns {
            let cell = [column, row, 0];
            for (step, to) in (0..).zip(STEPS.map(|step| plus(cell, step))) {
                let is_there = || [cell, to].iter().all(|c| lattice.number(*c).is_some());
                if is_there() && meet(centre(cell), centre(to), a, b) {
                    visit(cell, step);
                }
            }
        }
    }
}
