//! Strains and rotations between neighbouring points of a body in the plane, which are there whatever fields were asked for.

use super::BodyResult;
use crate::case::FieldName;
use crate::scene::body::BodyScene;
use peristat_assembly::body::{Cell, PointBody, SquareLattice, plus};

/// A magnitude, and where it is.
pub(crate) type Place = (f64, [f64; 2]);

/// The largest strain and rotation of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Steepest {
    /// Magnitude of the largest principal strain.
    pub(crate) strain: Option<Place>,
    /// Rotation, rad.
    pub(crate) rotation: Option<Place>,
}

/// The steepest place of a lattice; nothing is known of a cloud. Points with cut bonds are left out: their neighbours may
/// stand on the other side of a crack, and beside its tip strains have no bound.
pub(crate) fn steepest(scene: &BodyScene, result: &BodyResult) -> Steepest {
    let mut found = Steepest::default();
    let PointBody::Lattice(lattice) = scene.body() else { return found };
    let values = |field| result.values(scene, field);
    let damage = values(FieldName::Damage);
    if damage.is_none() && (!scene.cracks.is_empty() || scene.case.is_traced()) {
        return found;
    }
    let (Some(ux), Some(uy)) = (values(FieldName::Ux), values(FieldName::Uy)) else { return found };
    let w = values(FieldName::W);
    let shell = w.as_deref().zip(scene.material().cylinder_radius());
    let is_around = scene.material().surface().axis().is_some();
    let neighbours = Neighbours { lattice, u: [&ux, &uy], shell, is_around };
    let is_cut = |point: usize| damage.as_ref().is_some_and(|damage| damage[point] > 0.0);
    for run in lattice.runs() {
        for (column, point) in run.columns.clone().zip(run.points()).filter(|(_, point)| !is_cut(*point)) {
            let [strain, rotation] = neighbours.at(run.cell(column), point);
            for (most, value) in [(&mut found.strain, strain), (&mut found.rotation, rotation)] {
                if let Some(value) = value.filter(|value| most.is_none_or(|m| *value > m.0)) {
                    *most = Some((value, lattice.place(point)));
                }
            }
        }
    }
    found
}

/// Differences of displacements along the axes of a lattice.
struct Neighbours<'a> {
    lattice: &'a SquareLattice,
    /// Displacements along x and y.
    u: [&'a [f64]; 2],
    /// Displacements across the surface of a shell, and its radius.
    shell: Option<(&'a [f64], f64)>,
    /// Whether x is the radius, so that rings stretch around the axis.
    is_around: bool,
}

impl Neighbours<'_> {
    /// Largest magnitude of a strain at a point, and the rotation, where it has neighbours along both axes.
    fn at(&self, cell: Cell, point: usize) -> [Option<f64>; 2] {
        let h = self.lattice.spacing();
        let slope = |values: &[f64], to: usize| (values[to] - values[point]) / h;
        let steps = [[1, 0, 0], [0, 1, 0]];
        let next = steps.map(|step| self.lattice.number(plus(cell, step)));
        let axes = steps.map(|step| self.lattice.vector(step).map(|x| x / h));
        // Slope of the displacement along the axis `of` on the way along the axis `along`.
        let part = |of: usize, along: usize| {
            let to = next[along]?;
            Some(axes[of][0] * slope(self.u[0], to) + axes[of][1] * slope(self.u[1], to))
        };
        let around = self.shell.map_or(0.0, |(w, radius)| w[point] / radius);
        let normal = [part(0, 0), part(1, 1).map(|strain| strain + around)];
        let both = part(1, 0).zip(part(0, 1));
        let in_plane = match (normal, both) {
            ([Some(x), Some(y)], Some((a, b))) => {
                Some((0.5 * (x + y)).abs() + (0.5 * (x - y)).hypot(0.5 * (a + b)))
            }
            ([x, y], _) => x.or(y).map(f64::abs),
        };
        let hoop = if self.is_around { self.u[0][point] / self.lattice.place(point)[0] } else { around };
        let tilt = self.shell.map_or(0.0, |(w, radius)| {
            let [x, y] = next.map(|to| to.map_or(0.0, |to| slope(w, to)));
            x.hypot(y - self.u[1][point] / radius)
        });
        let turned = both.map(|(a, b)| (0.5 * (a - b)).hypot(tilt));
        [Some(in_plane.unwrap_or(0.0).max(hoop.abs())), turned]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Strain and rotation at the lower left point of four whose displacements are linear, with these slopes.
    fn of(slopes: [[f64; 2]; 2], shell: Option<f64>) -> [Option<f64>; 2] {
        let lattice = SquareLattice::rectangle(0.5, [2.0, 0.0], [2, 2]);
        let along = |k: usize| {
            let at = |p: usize| lattice.place(p);
            (0..4).map(|p| slopes[k][0] * at(p)[0] + slopes[k][1] * at(p)[1]).collect::<Vec<f64>>()
        };
        let (x, y, w) = (along(0), along(1), [0.3; 4]);
        let shell = shell.map(|radius| (&w[..], radius));
        let neighbours = Neighbours { lattice: &lattice, u: [&x, &y], shell, is_around: false };
        neighbours.at([0; 3], 0)
    }

    #[test]
    fn strains_are_principal_and_rotations_cost_none() {
        let near = |found: [Option<f64>; 2], expected: [f64; 2]| {
            found.iter().zip(expected).all(|(f, e)| (f.unwrap() - e).abs() < 1e-14)
        };
        assert!(near(of([[0.02, 0.0], [0.0, -0.05]], None), [0.05, 0.0]));
        // Pure shear of γ = 0.08.
        assert!(near(of([[0.0, 0.04], [0.04, 0.0]], None), [0.04, 0.0]));
        assert!(near(of([[0.0, -0.1], [0.1, 0.0]], None), [0.0, 0.1]));
        // A tube that widens.
        assert!(near(of([[0.0; 2]; 2], Some(3.0)), [0.1, 0.0]));
    }
}
