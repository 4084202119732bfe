//! Fits around squares, points and other places: those that see the same are one.

use super::border::Border;
use super::grid::{Grid, Node};
use crate::recovery::hole::HoleFit;
use crate::recovery::trefftz::{Basis, Known, LocalFit};
use nalgebra::{DMatrix, DVector, MatrixXx6};
use rayon::prelude::*;
use std::collections::HashMap;

/// Places whose distances from a centre differ by less, in spacings, are one.
const SAME: f64 = 1e-6;

/// How near to a place where stresses are infinite fits are linear, in spacings.
const ROUGH: f64 = 4.5;
/// How far these see, in spacings: a square its own points.
const OWN: f64 = 1.5;

/// What a fit is made of, and how many spacings it sees.
#[derive(Clone, Debug)]
pub(super) struct Fits {
    pub(super) basis: Basis,
    /// Displacements, rotations and stresses of its fields in the centre, one column each.
    pub(super) at_centre: MatrixXx6<f64>,
    /// Linear fields of the basis, one column each.
    linear: DMatrix<f64>,
    reach: f64,
    /// Where stresses are infinite, and images of these.
    singular: Vec<[f64; 2]>,
    known: Vec<LocalFit>,
    numbers: HashMap<Vec<i32>, u32>,
}

/// What is known around a place: the points, then the marks of the border.
#[derive(Clone, Debug, Default)]
pub(super) struct Around {
    pub(super) centre: [f64; 2],
    points: Vec<([i32; 2], Node)>,
    marks: Vec<u32>,
}

/// A place with the number of its fit.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub(super) around: Around,
    pub(super) fit: u32,
}

/// A state: displacements in two planes, and what is known at every sample of the border.
#[derive(Clone, Copy, Debug)]
pub struct State<'a> {
    /// Displacements of the points of the model, m, along x, then along y.
    pub u: &'a [f64],
    /// Number of points.
    pub points: usize,
    /// By sample and axis: the displacement where it is held, m, the traction elsewhere, Pa.
    pub border: &'a [[f64; 2]],
    /// Force on every point, N/m³.
    pub weight: [f64; 2],
    /// Fields around the holes that have their own.
    pub holes: &'a [HoleFit],
}

impl Around {
    pub(super) fn new(centre: [f64; 2], reach: f64, grid: &Grid, border: &Border) -> Self {
        Self { marks: border.near(centre, reach), ..Self::of_points(centre, reach, grid) }
    }

    /// The points alone.
    fn of_points(centre: [f64; 2], reach: f64, grid: &Grid) -> Self {
        let [columns, rows] = centre.map(|x| (x - reach).ceil() as i32..=(x + reach).floor() as i32);
        let places = rows.flat_map(|j| columns.clone().map(move |i| [i, j]));
        let is_near = |place: &[i32; 2]| {
            let [x, y] = [0, 1].map(|k| f64::from(place[k]) - centre[k]);
            x.hypot(y) <= reach * (1.0 + SAME)
        };
        let points = places.filter(is_near).filter_map(|place| Some((place, grid.node(place)?))).collect();
        Self { centre, points, marks: Vec::new() }
    }

    /// What tells it from others: everything relative to the centre.
    fn key(&self, is_rough: bool, border: &Border) -> Vec<i32> {
        let rounded = |x: f64| (x / SAME).round() as i32;
        let mut key = Vec::with_capacity(1 + 2 * self.points.len() + 5 * self.marks.len());
        key.push(i32::from(is_rough));
        for (place, _) in &self.points {
            key.extend([0, 1].map(|k| rounded(f64::from(place[k]) - self.centre[k])));
        }
        for mark in self.marks.iter().map(|mark| &border.marks[*mark as usize]) {
            key.extend([0, 1].map(|k| rounded(mark.at[k] - self.centre[k])));
            key.extend(mark.normal.map(rounded));
            key.push(i32::from(mark.held[0]) + 2 * i32::from(mark.held[1]));
        }
        key
    }

    fn known(&self, reach: f64, border: &Border) -> Vec<Known> {
        let relative = |at: [f64; 2]| [0, 1].map(|k| (at[k] - self.centre[k]) / reach);
        let points = self.points.iter().map(|(place, _)| Known::Displacement(relative(place.map(f64::from))));
        let marks = self.marks.iter().map(|mark| &border.marks[*mark as usize]);
        let marks = marks.map(|m| Known::Border { at: relative(m.at), normal: m.normal, held: m.held });
        points.chain(marks).collect()
    }

    /// What is known in a state.
    fn values(&self, border: &Border, state: State) -> Vec<f64> {
        let mut values = Vec::with_capacity(2 * (self.points.len() + self.marks.len()));
        for (_, node) in &self.points {
            values.extend(
                [0, 1].map(|c| f64::from(node.signs[c]) * state.u[c * state.points + node.number as usize]),
            );
        }
        for mark in self.marks.iter().map(|mark| &border.marks[*mark as usize]) {
            let own = state.border[mark.sample as usize];
            values.extend([0, 1].map(|c| f64::from(mark.signs[c]) * own[c]));
        }
        values
    }
}

impl Fits {
    /// Polynomials up to a degree that see so many spacings.
    pub(super) fn new(stiffness: &[[f64; 3]; 3], degree: i32, reach: f64, singular: Vec<[f64; 2]>) -> Self {
        let basis = Basis::new(stiffness, degree);
        let linear = basis.lower(stiffness, 1);
        let centre = [0.0; 2];
        let (u, turn, stress) =
            (basis.displacements(centre), basis.rotations(centre), basis.stresses(centre));
        let columns = u.iter().chain(&turn).chain(&stress).copied();
        let at_centre = MatrixXx6::from_iterator(basis.count(), columns);
        Self { basis, at_centre, linear, reach, singular, known: Vec::new(), numbers: HashMap::new() }
    }

    /// Whether stresses are infinite so near to a place that polynomials of a high degree do harm.
    pub(super) fn is_rough(&self, [x, y]: [f64; 2]) -> bool {
        self.singular.iter().any(|[a, b]| (x - a).hypot(y - b) < ROUGH)
    }

    /// How far a fit sees, m.
    pub(super) fn radius(&self, grid: &Grid) -> f64 {
        self.reach * grid.spacing
    }

    /// A place relative to the centre of a fit over its radius.
    pub(super) fn relative(&self, at: [f64; 2], centre: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (at[k] - centre[k]) / self.reach)
    }

    /// Places with their fits, those that are new made in parallel; none where too little is known to tell one.
    pub(super) fn add(&mut self, centres: &[[f64; 2]], grid: &Grid, border: &Border) -> Option<Vec<Fitted>> {
        let mut new: Vec<(bool, Vec<Known>)> = Vec::new();
        let first = self.known.len() as u32;
        let mut fitted = Vec::with_capacity(centres.len());
        for centre in centres {
            let is_rough = self.is_rough(*centre);
            let around = match is_rough {
                true => Around::of_points(*centre, OWN, grid),
                false => Around::new(*centre, self.reach, grid, border),
            };
            let next = first + new.len() as u32;
            let fit = *self.numbers.entry(around.key(is_rough, border)).or_insert_with(|| {
                new.push((is_rough, around.known(self.reach, border)));
                next
            });
            fitted.push(Fitted { around, fit });
        }
        let radius = self.radius(grid);
        let made = new.par_iter().map(|(is_rough, known)| match is_rough {
            true => LocalFit::within(&self.linear, &self.basis, radius, known),
            false => LocalFit::new(&self.basis, radius, known),
        });
        self.known.extend(made.collect::<Option<Vec<_>>>()?);
        Some(fitted)
    }

    /// What a fit misses of a state, relative to what strains the body around it in another, of which the first is a part.
    pub(super) fn misfit(
        &self,
        at: &Fitted,
        (grid, border): (&Grid, &Border),
        [part, whole]: [State; 2],
    ) -> f64 {
        let (fit, known) = (&self.known[at.fit as usize], at.around.known(self.reach, border));
        let values = |state| at.around.values(border, state);
        let strained = fit.strained(&self.basis, &known, &values(whole));
        if strained == 0.0 {
            return 0.0;
        }
        fit.missed(&self.basis, self.radius(grid), &known, &values(part)) / strained
    }

    /// Coefficients of the fields of a fit in a state.
    pub(super) fn coefficients(&self, at: &Fitted, border: &Border, state: State) -> DVector<f64> {
        self.known[at.fit as usize].coefficients(&at.around.values(border, state))
    }
}
