//! Residuals of known fields, and the balance of those of any.

use super::*;
use crate::body::{BorderPart, Hole, Outline, Shape};
use crate::model::Points;
use crate::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use crate::model::plane::{Calibration, Edges, Mirrors};
use crate::recovery::hole::{Ellipse, HoleFields, HoleFit, HoleLoad};
use std::sync::Arc;

const FITTING: Fitting = Fitting { degree: 4, reach: 3.0 };

/// No weight and no holes.
const NOTHING: ([f64; 2], &[HoleFit]) = ([0.0; 2], &[]);

/// A displacement and its stress, of a material with Young's modulus 1 and Poisson's ratio 1/3 in plane stress.
type Exact = dyn Fn([f64; 2]) -> ([f64; 2], [f64; 3]);

/// A plate of cells of size one; its edges on lines of symmetry are no border.
struct Plate {
    model: BondPlane,
    correction: Correction,
    normals: Vec<[f64; 2]>,
}

impl Plate {
    fn new(outline: &Outline, mirrors: Mirrors, holes: &[HoleZone]) -> Self {
        let lattice = mirrors.extended(&outline.fill(1.0).unwrap(), 2);
        let material = PlaneMaterial { youngs_modulus: 1.0, state: PlaneState::Stress, thickness: 2.0 };
        let parameters = PlaneParameters {
            material,
            horizon_ratio: 2.0,
            influence: Influence::Constant,
            calibration: Calibration::Matched,
            weights: Weights::Nearest,
            volume_factor: VolumeFactor::Ramp,
            edges: Edges::Overlay,
        };
        let model = BondPlane::on_lattice(Arc::new(lattice), mirrors, parameters, &[]).unwrap();
        let low = outline.bounds()[0];
        let is_mirror = |part: &BorderPart| {
            let on = |k: usize| {
                mirrors.lines[k][0].is_some() && [0.0, 1.0].iter().all(|s| part.at(*s)[k] == low[k])
            };
            on(0) || on(1)
        };
        let edges = outline.edges().iter().flat_map(|edge| outline.edge_parts(edge));
        let parts = edges.chain((0..outline.holes().len()).flat_map(|hole| outline.hole_parts(hole)));
        let pieces: Vec<BorderPiece> = parts
            .filter(|part| !is_mirror(part))
            .map(|part| BorderPiece { part, held: [false; 2] })
            .collect();
        let bounds = Bounds { outline, pieces: &pieces, holes, singular: &[] };
        let correction = Correction::new(&model, bounds, 2.0, FITTING).unwrap();
        let normals = correction.samples().iter().map(|sample| sample.normal).collect();
        Self { model, correction, normals }
    }

    fn points(&self) -> usize {
        self.model.points()
    }

    fn displacements(&self, exact: &Exact) -> Vec<f64> {
        let at = |p: usize| exact(crate::model::BodyModel::place(&self.model, p)).0;
        let n = self.points();
        (0..2 * n).map(|k| at(k % n)[k / n]).collect()
    }

    fn tractions(&self, exact: &Exact) -> Vec<[f64; 2]> {
        let of = |(sample, [x, y]): (&Sample, &[f64; 2])| {
            let [xx, yy, xy] = exact(sample.at).1;
            [xx * x + xy * y, xy * x + yy * y]
        };
        self.correction.samples().iter().zip(&self.normals).map(of).collect()
    }

    /// Residual of displacements under the tractions of a field, and the largest force of these.
    fn residual(
        &self,
        u: &[f64],
        tractions: &Exact,
        (weight, holes): ([f64; 2], &[HoleFit]),
    ) -> (Vec<f64>, f64) {
        let border = self.tractions(tractions);
        let state = State { u, points: self.points(), border: &border, weight, holes };
        let spacing_and_thickness = 2.0;
        let traction = border.iter().flatten().fold(0.0_f64, |most, t| most.max(t.abs()));
        (self.correction.residual(state), traction * spacing_and_thickness)
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// σ_xx = x y, σ_yy = 0, σ_xy = −y²/2: of third degree in the displacements.
fn cubic([x, y]: [f64; 2]) -> ([f64; 2], [f64; 3]) {
    let nu = 1.0 / 3.0;
    let u = 0.5 * x * x * y - (2.0 + nu) * y * y * y / 6.0;
    let v = -0.5 * nu * x * y * y - x * x * x / 6.0;
    ([u, v], [x * y, 0.0, -0.5 * y * y])
}

/// φ = e^z, ψ = sin(2 z + 0.3) of z = s (x + i y).
fn transcendental([x, y]: [f64; 2]) -> ([f64; 2], [f64; 3]) {
    type C = nalgebra::Complex<f64>;
    let s = 0.06;
    let (z, twice_shear, kappa) = (C::new(s * x, s * (y - 5.0)), 0.75, 2.0);
    let (phi, inner) = (z.exp(), 2.0 * z + 0.3);
    let u = (kappa * phi - z * phi.conj() - inner.sin().conj()) / (twice_shear * s);
    let sum = 4.0 * phi.re;
    let other = 2.0 * (z.conj() * phi + 2.0 * inner.cos());
    ([u.re, u.im], [0.5 * (sum - other.re), 0.5 * (sum + other.re), 0.5 * other.im])
}

fn rectangle() -> Outline {
    Outline::rectangle([0.0; 2], [24.0, 10.0]).unwrap()
}

/// A plate with a round hole, an ellipse off the lines of the lattice, and a notch.
fn with_holes() -> Outline {
    let mut outline = Outline::rectangle([0.0; 2], [40.0, 24.0]).unwrap();
    let shapes = [
        Shape::Circle { centre: [12.3, 12.1], radius: 5.2 },
        Shape::Circle { centre: [28.0, 23.0], radius: 5.0 },
    ];
    shapes.into_iter().for_each(|shape| outline.cut(Hole { name: None, shape }).unwrap());
    outline
}

#[test]
fn what_fits_reproduce_leaves_nothing() {
    for outline in [rectangle(), with_holes()] {
        let plate = Plate::new(&outline, Mirrors::NONE, &[]);
        let (r, load) = plate.residual(&plate.displacements(&cubic), &cubic, NOTHING);
        // Found: 2e-13 and 1e-12.
        assert!(largest(&r) < 1e-11 * load, "{:e} of {load:e}", largest(&r));
    }
}

#[test]
fn what_fits_nearly_reproduce_leaves_little() {
    let plate = Plate::new(&rectangle(), Mirrors::NONE, &[]);
    let (r, load) = plate.residual(&plate.displacements(&transcendental), &transcendental, NOTHING);
    // Found: 7e-6.
    assert!(largest(&r) < 3e-5 * load, "{:e} of {load:e}", largest(&r));
}

/// Whatever the displacements, the forces have the resultant and the moment of the tractions.
#[test]
fn residuals_have_the_force_and_the_moment_of_the_tractions() {
    for outline in [rectangle(), with_holes()] {
        let round = Ellipse { centre: [12.3, 12.1], half_axes: [5.2; 2], turn: 0.0 };
        let has_zone = !outline.holes().is_empty();
        let zones = Vec::from_iter(has_zone.then_some(HoleZone { ellipse: round, level: 1.3 }));
        let plate = Plate::new(&outline, Mirrors::NONE, &zones);
        let n = plate.points();
        let u: Vec<f64> = (0..2 * n).map(|k| ((k * k) as f64 * 0.37).sin()).collect();
        let fields = HoleFields::new(&plate.model.stiffness(), round, 4).unwrap();
        let near = (0..n).map(|p| (crate::model::BodyModel::place(&plate.model, p), [u[p], u[n + p]]));
        let fit = HoleFit::new(
            fields,
            &HoleLoad::default(),
            near.filter(|(at, _)| (1.0..1.3).contains(&round.level(*at))),
        );
        let tractions = move |at: [f64; 2]| match has_zone && round.level(at) < 1.01 {
            true => ([0.0; 2], [0.0; 3]),
            false => cubic(at),
        };
        let (r, _) = plate.residual(&u, &tractions, ([0.0; 2], fit.as_slice()));
        let places: Vec<[f64; 2]> = (0..n).map(|p| crate::model::BodyModel::place(&plate.model, p)).collect();
        let force = [0, 1].map(|c| r[c * n..(c + 1) * n].iter().sum::<f64>());
        let moment: f64 = places.iter().enumerate().map(|(p, [x, y])| x * r[n + p] - y * r[p]).sum();
        let size = largest(&r);
        // Cubic tractions balance; on the hole they do so by themselves.
        assert!(force.iter().all(|f| f.abs() < 1e-12 * size), "{force:?} of {size}");
        assert!(moment.abs() < 1e-12 * size * 40.0, "{moment} of {size}");
    }
}

/// What fits reproduce leaves nothing beside lines of symmetry, whose images continue it.
#[test]
fn mirrors_are_seen_as_the_other_half() {
    // φ = x² y² − (x⁴ + y⁴)/6 of Airy.
    let symmetric = |[x, y]: [f64; 2]| {
        let (twice, nu) = (2.0 * (x * x - y * y), 1.0 / 3.0);
        let along = |a: f64, b: f64| (1.0 + nu) * (2.0 / 3.0 * a * a * a - 2.0 * a * b * b);
        ([along(x, y), along(y, x)], [twice, -twice, -4.0 * x * y])
    };
    let (first, none) = ([Some(0), None], [None; 2]);
    let corners = [([first, first], [0.0; 2]), ([first, none], [0.0, -5.0]), ([none, first], [-4.0, 0.0])];
    for ([columns, rows], low) in corners {
        let mut outline = Outline::rectangle(low, [14.0, 11.0]).unwrap();
        let shape = Shape::Circle { centre: [0.0; 2], radius: 4.3 };
        outline.cut(Hole { name: None, shape }).unwrap();
        let plate = Plate::new(&outline, Mirrors::in_plane(columns, rows), &[]);
        let (r, load) = plate.residual(&plate.displacements(&symmetric), &symmetric, NOTHING);
        // Found: 1e-13 and less.
        assert!(largest(&r) < 1e-11 * load, "{low:?}: {:e} of {load:e}", largest(&r));
    }
}

/// A body under its weight, with a stress that balances it: σ_xx = −b_x x + y, σ_yy = −b_y y, σ_xy = x.
#[test]
fn weight_is_in_balance_with_its_stress() {
    let force = [0.3, -0.7];
    let nu = 1.0 / 3.0;
    let exact = move |[x, y]: [f64; 2]| {
        let [a, b] = force;
        // ε_xx = −a x + y + ν b y, ε_yy = −b y + ν a x − ν y, γ = 8/3 x.
        let u = -0.5 * a * x * x + (1.0 + nu * b) * x * y - 0.5 * nu * a * y * y;
        let v =
            -0.5 * b * y * y + nu * a * x * y - 0.5 * nu * y * y + 0.5 * (8.0 / 3.0 - 1.0 - nu * b) * x * x;
        ([u, v], [-a * x + y, -b * y, x])
    };
    let plate = Plate::new(&with_holes(), Mirrors::NONE, &[]);
    // ∂σ_xy/∂x = 1 takes one more along y, ∂σ_xy/∂y nothing.
    let (r, load) = plate.residual(&plate.displacements(&exact), &exact, ([force[0], force[1] - 1.0], &[]));
    assert!(largest(&r) < 1e-11 * load, "{:e} of {load:e}", largest(&r));
}

#[test]
fn rotations_under_weight_are_those_of_its_displacements() {
    let stiffness = [[140.6, 2.5, 0.4], [2.5, 10.0, -0.2], [0.4, -0.2, 2.93]];
    let weight = Weight::new(&stiffness, [0.3, -0.1]).unwrap();
    let (h, at) = (1e-3, [1.4, 0.8]);
    let by = |c: usize, axis: usize| {
        let u = |step: f64| {
            let mut place = at;
            place[axis] += step;
            weight.field([0.3, -0.7], place).displacement[c]
        };
        (u(h) - u(-h)) / (2.0 * h)
    };
    let (found, expected) = (weight.field([0.3, -0.7], at).rotation, 0.5 * (by(1, 0) - by(0, 1)));
    // Found: 4e-16, of 1.8e-4.
    assert!((found - expected).abs() < 1e-14, "{found} {expected}");
}
