//! Constraints `u = T q + g` from linear equations among the unknowns.
//!
//! Prescribed motion, ghosts, mirror images, symmetry and rigid links are all rows of `T` and `g`. `q` keeps the
//! numbering of `u`: the entries of constrained unknowns are inert and zero.

use crate::sum::Sum;
use peristat_vector::Real;
use std::collections::{BTreeMap, HashMap, HashSet};
use thiserror::Error;

/// One scalar unknown of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Unknown {
    /// Component, `0..D`.
    pub component: usize,
    /// Point.
    pub point: usize,
}

/// A linear equation `Σ coefficient · unknown = value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Unknowns and their coefficients. The first one becomes the dependent one where that is possible.
    pub terms: Vec<(Unknown, f64)>,
    /// Right-hand side, in the unit of the terms.
    pub value: f64,
    /// Who asks for it, as messages name it.
    pub origin: String,
}

/// Two equations that cannot both hold.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{origin} contradicts {}", others.join(", "))]
pub struct Contradiction {
    /// The equation found to be impossible.
    pub origin: String,
    /// The equations it meets.
    pub others: Vec<String>,
}

/// A constrained unknown, `u = Σ coefficient · q + value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of the constrained unknown.
    pub unknown: usize,
    /// Numbers of independent unknowns and their coefficients; empty for a prescribed value.
    pub masters: Vec<(usize, f64)>,
    /// The prescribed part, for a load factor of one.
    pub value: f64,
    /// How the prescribed part depends on the right-hand sides: index of an equation and ∂value/∂right-hand side.
    pub sources: Vec<(usize, f64)>,
}

/// The rows of `T` and `g` that differ from `u = q`.
#[derive(Clone, Debug, Default)]
pub struct Constraints {
    rows: Vec<Row>,
    equations: Vec<Vec<(usize, f64)>>,
    has_slaves: bool,
}

/// Coefficients below this part of the largest one of a row are nothing in double precision.
const UNSEEN: f64 = 1e-18;

/// Coefficients below this part of the largest one of an equation as it is given are what rounding makes of none: no unknown
/// follows from them. `cos 90°` is 6e-17, and what neighbours hold in common cancels to as much.
const NOTHING: f64 = 1e-12;

/// Part of the largest coefficient that the first one has at least, for its unknown to depend on the others.
const WEAK: f64 = 1e-3;

/// Part of its terms by which an equation may miss its right-hand side: corners of two edges are held once, to rounding.
const ROUNDING: f64 = 1e-8;

/// Row under construction, with the equations that went into it.
struct Pending {
    masters: Vec<(usize, f64)>,
    value: f64,
    sources: BTreeMap<usize, f64>,
}

impl Constraints {
    /// Eliminates one unknown per equation. Unknown `(component, point)` has the number `component · points + point`.
    ///
    /// # Errors
    /// [`Contradiction`] where an equation is violated by the ones before it; one that merely repeats them is dropped.
    pub fn new(points: usize, equations: &[Equation]) -> Result<Self, Contradiction> {
        let number = |u: &Unknown| u.component * points + u.point;
        let numbered: Vec<Vec<(usize, f64)>> =
            equations.iter().map(|e| e.terms.iter().map(|(u, c)| (number(u), *c)).collect()).collect();
        let mut rows: HashMap<usize, Pending> = HashMap::new();
        let mut users: HashMap<usize, HashSet<usize>> = HashMap::new();
        for (index, equation) in equations.iter().enumerate() {
            let reduced = substitute(&rows, &numbered[index], equation.value, index);
            let Some(pivot) = reduced.pivot(&numbered[index]) else {
                if reduced.residual_is_rounding() {
                    continue;
                }
                let others = reduced.sources.keys().filter(|&&o| o != index);
                return Err(Contradiction {
                    origin: equation.origin.clone(),
                    others: others.map(|&o| equations[o].origin.clone()).collect(),
                });
            };
            insert(&mut rows, &mut users, pivot, reduced);
        }
        let mut rows: Vec<Row> = rows
            .into_iter()
            .map(|(unknown, p)| {
                let Pending { masters, value, sources } = p;
                Row { unknown, masters, value, sources: sources.into_iter().collect() }
            })
            .collect();
        rows.sort_by_key(|r| r.unknown);
        let has_slaves = rows.iter().any(|r| !r.masters.is_empty());
        Ok(Self { rows, equations: numbered, has_slaves })
    }

    /// The same with other right-hand sides, those of the first equations; those of the rest are zero.
    ///
    /// # Errors
    /// The number of an equation that the ones before it violate.
    pub fn with_values(&self, values: &[f64]) -> Result<Self, usize> {
        let value = |equation: usize| values.get(equation).copied().unwrap_or(0.0);
        let mut all = self.clone();
        for row in &mut all.rows {
            row.value = row.sources.iter().map(|&(equation, share)| share * value(equation)).sum();
        }
        // What is independent counts for nothing: an equation holds whatever it is.
        let prescribed = |unknown: usize| {
            let found = all.rows.binary_search_by_key(&unknown, |row| row.unknown);
            found.map_or(0.0, |row| all.rows[row].value)
        };
        let holds = |(k, terms): (usize, &Vec<(usize, f64)>)| {
            let parts = terms.iter().map(|&(unknown, share)| share * prescribed(unknown));
            let (sum, size) = parts.fold((0.0, value(k).abs()), |(s, a), part| (s + part, a + part.abs()));
            (sum - value(k)).abs() <= ROUNDING * size
        };
        match self.equations.iter().enumerate().position(|equation| !holds(equation)) {
            Some(violated) => Err(violated),
            None => Ok(all),
        }
    }

    /// The rows of some unknowns under other numbers, without prescribed parts and equations. What depends on an unknown without
    /// a number stays at rest, as do the `still` ones.
    pub fn renumbered(
        &self,
        number: &dyn Fn(usize) -> Option<usize>,
        still: impl Iterator<Item = usize>,
    ) -> Self {
        let at_rest = |unknown: usize| Row { unknown, masters: Vec::new(), value: 0.0, sources: Vec::new() };
        let of = |row: &Row| {
            let masters = row.masters.iter().map(|&(master, share)| Some((number(master)?, share)));
            Some(Row {
                masters: masters.collect::<Option<_>>().unwrap_or_default(),
                ..at_rest(number(row.unknown)?)
            })
        };
        let mut rows: Vec<Row> = self.rows.iter().filter_map(of).chain(still.map(at_rest)).collect();
        rows.sort_by_key(|row| row.unknown);
        let has_slaves = rows.iter().any(|row| !row.masters.is_empty());
        Self { rows, equations: Vec::new(), has_slaves }
    }

    /// The constrained unknowns, in the order of their numbers.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Left-hand sides of all equations, by numbers of unknowns.
    pub fn equations(&self) -> &[Vec<(usize, f64)>] {
        &self.equations
    }

    /// Whether some constrained unknown depends on others: then `T` is more than a projection.
    pub fn has_slaves(&self) -> bool {
        self.has_slaves
    }

    /// Whether some prescribed part is not zero.
    pub fn moves(&self) -> bool {
        self.rows.iter().any(|r| r.value != 0.0)
    }

    /// Turns `q` into `u = T q + factor · g` in place.
    pub fn expand<R: Real>(&self, factor: f64, u: &mut [R]) {
        for row in &self.rows {
            // Masters are independent, so the order of the rows does not matter.
            let slaved: f64 = row.masters.iter().map(|&(m, c)| c * u[m].into()).sum();
            u[row.unknown] = R::of(slaved + factor * row.value);
        }
    }

    /// As [`expand`](Self::expand), of unknowns in two parts: doubles, and what rounding took from them.
    pub fn expand_twofold(&self, factor: f64, high: &mut [f64], low: &mut [f64]) {
        for row in &self.rows {
            let mut sum = Sum::default();
            sum.add_product(factor, row.value);
            for &(m, c) in &row.masters {
                sum.add_product(c, high[m]);
                sum.add_product(c, low[m]);
            }
            [high[row.unknown], low[row.unknown]] = sum.parts();
        }
    }

    /// Forces that hold the equations, one per equation, from the forces that act on the constrained unknowns: the
    /// derivative of the energy with respect to each right-hand side. An equation that only repeats others gets none.
    pub fn multipliers(&self, force: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut multipliers = vec![0.0; self.equations.len()];
        for row in &self.rows {
            let force = force(row.unknown);
            row.sources.iter().for_each(|&(equation, c)| multipliers[equation] += c * force);
        }
        multipliers
    }

    /// As [`restrict`](Self::restrict), of forces in twice the precision.
    pub fn restrict_twofold(&self, force: &mut [Sum]) {
        for row in &self.rows {
            let held = std::mem::take(&mut force[row.unknown]);
            row.masters.iter().for_each(|&(m, c)| force[m].add_multiple(c, held));
        }
    }

    /// Turns a force on `u` into the force `Tᵀ f` on `q` in place.
    pub fn restrict<R: Real>(&self, force: &mut [R]) {
        for row in &self.rows {
            let held = std::mem::take(&mut force[row.unknown]);
            row.masters.iter().for_each(|&(m, c)| force[m] += R::of(c * held.into()));
        }
    }
}

/// An equation in terms of independent unknowns only.
struct Reduced {
    terms: Vec<(usize, f64)>,
    value: f64,
    /// Sum of the magnitudes that went into the right-hand side.
    scale: f64,
    /// Equations that went into it, and how the right-hand side depends on theirs.
    sources: BTreeMap<usize, f64>,
}

fn substitute(rows: &HashMap<usize, Pending>, terms: &[(usize, f64)], value: f64, index: usize) -> Reduced {
    let mut sum: Vec<(usize, f64, f64)> = Vec::new();
    let mut add = |unknown: usize, c: f64| match sum.iter_mut().find(|t| t.0 == unknown) {
        Some(t) => (t.1, t.2) = (t.1 + c, t.2 + c.abs()),
        None => sum.push((unknown, c, c.abs())),
    };
    let (mut rest, mut scale) = (value, value.abs());
    let mut sources = BTreeMap::from([(index, 1.0)]);
    for &(unknown, c) in terms {
        match rows.get(&unknown) {
            Some(row) => {
                rest -= c * row.value;
                scale += (c * row.value).abs();
                row.sources.iter().for_each(|(&e, s)| *sources.entry(e).or_default() -= c * s);
                row.masters.iter().for_each(|&(m, a)| add(m, c * a));
            }
            None => add(unknown, c),
        }
    }
    // A coefficient that is the rounding of a cancellation is zero.
    let terms = sum.into_iter().filter(|t| !is_rounding(t.1, t.2)).map(|t| (t.0, t.1)).collect();
    Reduced { terms, value: rest, scale, sources }
}

/// Masters without those that are not seen beside the others: what neighbours hold in common fades from one to the next.
fn seen(mut masters: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
    let most = masters.iter().fold(0.0_f64, |most, m| most.max(m.1.abs()));
    masters.retain(|m| m.1.abs() > UNSEEN * most);
    masters
}

/// Whether a sum is what rounding left of terms of some size.
fn is_rounding(sum: f64, size: f64) -> bool {
    sum.abs() <= 1e-12 * size.abs()
}

impl Reduced {
    /// The unknown to eliminate from what is left of the equation with these terms: its first one if that is still there and has
    /// not all but gone, else the one with the largest coefficient; none if nothing is left.
    fn pivot(&self, given: &[(usize, f64)]) -> Option<usize> {
        let most = given.iter().fold(0.0_f64, |most, t| most.max(t.1.abs()));
        let largest = self.terms.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let is_weak = |t: &&(usize, f64)| t.1.abs() < WEAK * largest.1.abs();
        let declared = given.first().and_then(|&(u, _)| self.terms.iter().find(|t| t.0 == u));
        let pivot = declared.filter(|t| !is_weak(t)).unwrap_or(largest);
        (largest.1.abs() > NOTHING * most).then_some(pivot.0)
    }

    fn residual_is_rounding(&self) -> bool {
        is_rounding(self.value, self.scale)
    }
}

/// Solves the reduced equation for its pivot and removes the pivot from the rows that use it.
fn insert(
    rows: &mut HashMap<usize, Pending>,
    users: &mut HashMap<usize, HashSet<usize>>,
    pivot: usize,
    reduced: Reduced,
) {
    let coefficient = reduced.terms.iter().find(|t| t.0 == pivot).map_or(1.0, |t| t.1);
    let others = reduced.terms.iter().filter(|t| t.0 != pivot);
    let row = Pending {
        masters: seen(others.map(|&(u, c)| (u, -c / coefficient)).collect()),
        value: reduced.value / coefficient,
        sources: reduced.sources.into_iter().map(|(e, s)| (e, s / coefficient)).collect(),
    };
    for user in users.remove(&pivot).unwrap_or_default() {
        let Some(old) = rows.get_mut(&user) else {
            continue;
        };
        let Some(at) = old.masters.iter().position(|m| m.0 == pivot) else {
            continue;
        };
        let (_, c) = old.masters.swap_remove(at);
        old.value += c * row.value;
        row.sources.iter().for_each(|(&e, s)| *old.sources.entry(e).or_default() += c * s);
        for &(m, a) in &row.masters {
            match old.masters.iter().position(|t| t.0 == m) {
                // What is left of a cancellation must not become a pivot later.
                Some(at) if is_rounding(old.masters[at].1 + c * a, c * a) => _ = old.masters.swap_remove(at),
                Some(at) => old.masters[at].1 += c * a,
                None => old.masters.push((m, c * a)),
            }
            users.entry(m).or_default().insert(user);
        }
        old.masters = seen(std::mem::take(&mut old.masters));
    }
    for &(m, _) in &row.masters {
        users.entry(m).or_default().insert(pivot);
    }
    rows.insert(pivot, row);
}

#[cfg(test)]
mod tests;
