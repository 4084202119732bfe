//! Bending waves of a beam that are so soft that the rounding of its stiffness hides them.

use crate::scene::BeamScene;
use peristat_assembly::condition::Constraints;
use peristat_assembly::model::timoshenko_beam::{Chain, PHI, W};
use peristat_assembly::system::System;
use peristat_solve::SmoothVectors;
use std::collections::BTreeMap;
use std::ops::Range;

/// Parts of a beam whose deflection is a cubic: of the waves that rounding hides, the shortest has about ten half waves at a
/// slenderness of 1e4 and a million points, and thirty at ten million: the fourth root of how far the softest one is below rounding.
const PARTS: usize = 64;
/// Nodes of two ends and of supports beyond which the spans are too short to be soft.
const MOST_HELD: usize = 32;
/// The lowest eigenvalue of a cantilever, over EI/L⁴.
const LOWEST: f64 = 12.4;
/// How many times the softest wave is below rounding where knowing it saves time. Without it a cantilever of a million points takes 11
/// iterations at 70 times, which is less time than 3 with it; at 600 times it takes 16, which is more.
const WORTH_KNOWING: f64 = 100.0;

/// Cubic deflections between nodes, Hermite's, whose rotations are their slopes: waves of bending without shear.
///
/// The matrix of a fine, slender beam has entries of the size of `κGA/h`, and stiffnesses of its softest waves, `EI h/L⁴`, that are
/// below their rounding. Its factor knows nothing of these.
pub(super) struct SoftMotions {
    /// Positions of the points that are no ghosts, and the number of the first.
    along: Vec<f64>,
    first: usize,
    /// Points of the body.
    points: usize,
    parts: Vec<Part>,
    count: usize,
    /// Unknowns that are not free.
    held: Vec<usize>,
    /// Slopes are those of one unit of deflection over this length.
    unit: f64,
}

/// Points between two nodes, the last one only where the line ends there.
struct Part {
    points: Range<usize>,
    ends: [f64; 2],
    /// Numbers of deflection and slope at the first node and at the last, where they are free.
    motions: [Option<usize>; 4],
}

impl SoftMotions {
    /// Those of a single line; none where rounding hides no motion of it, where links join points of it, and where supports are as
    /// close as bonds are long.
    pub(super) fn new<const D: usize>(scene: &BeamScene, system: &System<D>) -> Option<Self> {
        let [chain] = scene.beam.chains() else { return None };
        let constraints = system.constraints();
        let (points, first) = (scene.beam.points(), scene.beam.first_real(0));
        let real = first..first + chain.points;
        if !hides_motions(chain) || links_points(constraints, (points, &real)) {
            return None;
        }
        let held: Vec<usize> = constraints.rows().iter().map(|row| row.unknown).collect();
        let mut nodes = BTreeMap::from([0, chain.points - 1].map(|end| (end, [true; 2])));
        for (component, point) in held.iter().map(|unknown| (unknown / points, unknown % points)) {
            if [W, PHI].contains(&component) && real.contains(&point) {
                nodes.entry(point - first).or_insert([true; 2])[component] = false;
            }
        }
        if nodes.len() > MOST_HELD {
            return None;
        }
        let mut along = Vec::with_capacity(chain.points);
        chain.positions(chain.ghosts[0], chain.points, |_, x| along.push(x));
        let nodes = between(nodes, system.reach())?;
        let (parts, count) = parts(&nodes, &along);
        let unit = chain.line().length / PARTS as f64;
        (count > 0).then_some(Self { along, first, points, parts, count, held, unit })
    }

    /// The cubics of a part, and their slopes, at its points.
    fn cubics<'a>(&'a self, part: &'a Part) -> impl Iterator<Item = [[f64; 4]; 2]> + 'a {
        let [from, to] = part.ends;
        let (length, unit) = (to - from, self.unit);
        self.along[part.points.clone()].iter().map(move |x| {
            let t = (x - from) / length;
            let (s, slope) = (1.0 - t, length / unit);
            let steep = 6.0 * t * s / length;
            let values =
                [(1.0 + 2.0 * t) * s * s, slope * t * s * s, t * t * (3.0 - 2.0 * t), -slope * t * t * s];
            let slopes = [-steep, s * (1.0 - 3.0 * t) / unit, steep, t * (3.0 * t - 2.0) / unit];
            [values, slopes]
        })
    }

    /// Places of the deflections and the rotations of a part in a vector.
    fn places(&self, part: &Part) -> [Range<usize>; 2] {
        [W, PHI].map(|component| {
            let first = component * self.points + self.first;
            first + part.points.start..first + part.points.end
        })
    }
}

impl SmoothVectors for SoftMotions {
    fn count(&self) -> usize {
        self.count
    }

    /// Two of each of three nodes in a row: bonds, which no part is shorter than, couple the first with the third across the second.
    fn reach(&self) -> usize {
        5
    }

    fn add(&self, factors: &[f64], x: &mut [f64]) {
        for part in &self.parts {
            let own = part.motions.map(|number| number.map_or(0.0, |number| factors[number]));
            if own == [0.0; 4] {
                continue;
            }
            for (component, place) in self.places(part).into_iter().enumerate() {
                for (x, cubics) in x[place].iter_mut().zip(self.cubics(part)) {
                    *x += dot(&own, &cubics[component]);
                }
            }
        }
        for &unknown in &self.held {
            x[unknown] = 0.0;
        }
    }

    fn project(&self, r: &[f64], products: &mut [f64]) {
        products.fill(0.0);
        for part in &self.parts {
            let [w, phi] = self.places(part);
            let mut own = [0.0; 4];
            for ((force, moment), [values, slopes]) in r[w].iter().zip(&r[phi]).zip(self.cubics(part)) {
                for (k, own) in own.iter_mut().enumerate() {
                    *own += force * values[k] + moment * slopes[k];
                }
            }
            for (number, own) in part.motions.iter().zip(own) {
                if let Some(number) = number {
                    products[*number] += own;
                }
            }
        }
    }
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Whether the stiffness of the softest motion of a line is far below the rounding of the stiffest one.
fn hides_motions(chain: &Chain) -> bool {
    let (line, h) = (chain.line(), chain.spacing);
    let sections = (0..=PARTS).map(|k| line.stiffness.compliance(line.length * k as f64 / PARTS as f64));
    let [bending, shear] =
        sections.fold([f64::INFINITY, 0.0], |[b, s], c| [b.min(1.0 / c.bending), s.max(1.0 / c.shear)]);
    WORTH_KNOWING * LOWEST * bending * h / line.length.powi(4) < f64::EPSILON * shear / h
}

/// Whether an unknown of a real point depends on another point.
fn links_points(constraints: &Constraints, (points, real): (usize, &Range<usize>)) -> bool {
    constraints.rows().iter().any(|row| {
        let own = row.unknown % points;
        real.contains(&own) && row.masters.iter().any(|master| master.0 % points != own)
    })
}

/// The nodes with more between them, whose motions are free; none where two are closer than bonds of some cells reach.
fn between(nodes: BTreeMap<usize, [bool; 2]>, reach: usize) -> Option<Vec<(usize, [bool; 2])>> {
    let stops: Vec<(usize, [bool; 2])> = nodes.into_iter().collect();
    let cells = stops.last()?.0;
    let mut all = Vec::with_capacity(2 * PARTS);
    for pair in stops.windows(2) {
        let (from, own) = (pair[0].0, pair[1].0 - pair[0].0);
        let number = (own * PARTS).div_ceil(cells).min(own / reach);
        if number == 0 {
            return None;
        }
        all.push(pair[0]);
        all.extend((1..number).map(|k| (from + own * k / number, [true; 2])));
    }
    all.extend(stops.last());
    Some(all)
}

/// The parts between nodes, and how many of their motions are free.
fn parts(nodes: &[(usize, [bool; 2])], along: &[f64]) -> (Vec<Part>, usize) {
    let mut count = 0;
    let mut number = |is_free: bool| {
        is_free.then(|| {
            count += 1;
            count - 1
        })
    };
    let numbers: Vec<[Option<usize>; 2]> = nodes.iter().map(|node| node.1.map(&mut number)).collect();
    let last = along.len() - 1;
    let parts = nodes.windows(2).zip(numbers.windows(2)).map(|(pair, motions)| {
        let [from, to] = [pair[0].0, pair[1].0];
        let end = if to == last { to + 1 } else { to };
        let motions = [motions[0][0], motions[0][1], motions[1][0], motions[1][1]];
        Part { points: from..end, ends: [along[from], along[to]], motions }
    });
    let parts = parts.collect();
    (parts, count)
}
