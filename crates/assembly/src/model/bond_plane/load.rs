//! Loads that belong to a stress: exact where it is the stress of the body.

use super::fields::virial_shares;
use super::{Body, BondPlane};
use std::ops::Range;

impl BondPlane {
    /// Adds the forces `Σ_k V_k S_k : E_k` of a stress `[S_xx, S_yy, S_xy]`, Pa, with E the strain of a point as
    /// [`strain`](Self::strain) has it: with one stress for all points and the tractions that it has at the edges, the
    /// linear displacement that belongs to it is the solution to rounding. Where S varies, `V div S` has to be added.
    ///
    /// `points` are those where S can be other than zero, none for all; images of real points have no part in it, but get
    /// forces from bonds to them.
    pub fn add_stress_load(
        &self,
        points: Option<&[usize]>,
        stress_at: &(dyn Fn([f64; 2]) -> [f64; 3] + Sync),
        force: &mut [f64],
    ) {
        let n = self.points();
        // V_k S_k : E_k = (C⁻¹ S_k)·(V_k σ_k)
        let mut t = vec![0.0; 3 * n];
        let mut enter = |point: usize, position: [f64; 2]| {
            let strain = self.parameters.material.strain(stress_at(position));
            (0..3).for_each(|q| t[q * n + point] = strain[q]);
        };
        match (points, &self.body) {
            (Some(points), _) => points.iter().for_each(|&p| enter(p, self.place(p))),
            (None, Body::Lattice(body)) => {
                for run in body.lattice.runs() {
                    for column in run.columns.clone() {
                        enter(run.number(column), body.lattice.centre([column, run.row]));
                    }
                }
            }
            (None, Body::Cloud(body)) => body.positions.iter().enumerate().for_each(|(p, at)| enter(p, *at)),
        }
        match &self.body {
            Body::Lattice(body) => {
                body.ghosts.iter().for_each(|&g| (0..3).for_each(|q| t[q * n + g as usize] = 0.0));
                let shares = virial_shares(&body.hood, body.lattice.spacing(), 1.0);
                body.whole.add_work::<3>(&t, &self.spans(points), &shares, force);
            }
            Body::Cloud(body) => body.add_work(&t, force),
        }
        for triangle in self.overlay().list() {
            let own: [f64; 3] = std::array::from_fn(|q| t[q * n + triangle.point as usize]);
            if own != [0.0; 3] {
                triangle.add_work(n, &triangle.stress(&own), force);
            }
        }
    }

    /// Columns from the first to behind the last of some points, per row of the lattice.
    fn spans(&self, points: Option<&[usize]>) -> Vec<Range<i32>> {
        let Body::Lattice(body) = &self.body else { return Vec::new() };
        let rows = body.lattice.rows();
        let Some(points) = points else {
            return rows.map(|_| body.lattice.columns()).collect();
        };
        let mut spans = vec![0..0; rows.len()];
        for &point in points {
            let [column, row] = body.lattice.cell(point);
            let span: &mut Range<i32> = &mut spans[(row - rows.start) as usize];
            *span = match span.start >= span.end {
                true => column..column + 1,
                false => span.start.min(column)..span.end.max(column + 1),
            };
        }
        spans
    }
}
