//! Constraints `u = T q + g` for random sets of equations.

use super::consistency::{Noise, dot};
use peristat_assembly::condition::{Constraints, Equation, Unknown};
use proptest::prelude::*;

const POINTS: usize = 12;
const COMPONENTS: usize = 2;
const SIZE: usize = POINTS * COMPONENTS;

fn unknown(number: usize) -> Unknown {
    Unknown { component: number / POINTS, point: number % POINTS }
}

/// Left side of an equation, by numbers of unknowns.
type Left = Vec<(usize, f64)>;

fn value(left: &Left, u: &[f64]) -> f64 {
    left.iter().map(|&(k, c)| c * u[k]).sum()
}

fn equation(left: &Left, value: f64, origin: usize) -> Equation {
    Equation {
        terms: left.iter().map(|&(k, c)| (unknown(k), c)).collect(),
        value,
        origin: origin.to_string(),
    }
}

/// Equations of one to four terms that all hold for `solution`; some are sums of earlier ones.
fn consistent(number: usize, solution: &[f64], noise: &mut Noise) -> Vec<(Left, f64)> {
    let mut lefts: Vec<Left> = Vec::new();
    for k in 0..number {
        let left = if k >= 2 && noise.next() > 0.6 {
            let (a, b) = (noise.index(k), noise.index(k));
            lefts[a].iter().chain(&lefts[b]).copied().collect()
        } else {
            let terms = 1 + noise.index(4);
            let coefficient = |noise: &mut Noise| noise.next().signum() * (0.75 + 0.5 * noise.next());
            (0..terms).map(|_| (noise.index(SIZE), coefficient(noise))).collect()
        };
        lefts.push(left);
    }
    lefts.into_iter().map(|left| (left.clone(), value(&left, solution))).collect()
}

fn equations(set: &[(Left, f64)]) -> Vec<Equation> {
    set.iter().enumerate().map(|(k, (left, value))| equation(left, *value, k)).collect()
}

proptest! {
    #![proptest_config(super::cases(512))]

    #[test]
    fn every_equation_holds_after_expansion(number in 1_usize..10, factor in -2.0..2.0_f64, seed in any::<u64>()) {
        let mut noise = Noise(seed);
        let solution = noise.vector(SIZE);
        let set = consistent(number, &solution, &mut noise);
        let constraints = Constraints::new(POINTS, &equations(&set)).expect("consistent");
        let mut u = noise.vector(SIZE);
        constraints.expand(factor, &mut u);
        let size = u.iter().fold(1.0_f64, |a, v| a.max(v.abs()));
        for (left, value_there) in &set {
            let off = value(left, &u) - factor * value_there;
            prop_assert!(off.abs() <= 1e-11 * size, "{left:?}: off by {off:e}");
        }
        // Masters are independent unknowns, so a second expansion changes nothing.
        let again = u.clone();
        constraints.expand(factor, &mut u);
        prop_assert_eq!(u, again);
    }

    #[test]
    fn restriction_is_the_adjoint_of_expansion(number in 1_usize..10, seed in any::<u64>()) {
        let mut noise = Noise(seed);
        let solution = noise.vector(SIZE);
        let set = consistent(number, &solution, &mut noise);
        let constraints = Constraints::new(POINTS, &equations(&set)).expect("consistent");
        let (mut q, force) = (noise.vector(SIZE), noise.vector(SIZE));
        for row in constraints.rows() {
            q[row.unknown] = 0.0;
        }
        let mut expanded = q.clone();
        constraints.expand(0.0, &mut expanded);
        let mut restricted = force.clone();
        constraints.restrict(&mut restricted);
        let size: f64 = 1.0 + expanded.iter().map(|v| v.abs()).sum::<f64>();
        prop_assert!((dot(&expanded, &force) - dot(&q, &restricted)).abs() <= 1e-12 * size);
        for row in constraints.rows() {
            prop_assert_eq!(restricted[row.unknown], 0.0);
        }
    }

    #[test]
    fn multipliers_are_the_work_per_change_of_an_equation(number in 1_usize..10, seed in any::<u64>()) {
        let mut noise = Noise(seed);
        let solution = noise.vector(SIZE);
        let set = consistent(number, &solution, &mut noise);
        let constraints = Constraints::new(POINTS, &equations(&set)).expect("consistent");
        let (mut before, force) = (noise.vector(SIZE), noise.vector(SIZE));
        constraints.expand(1.0, &mut before);
        let multipliers = constraints.multipliers(|unknown| force[unknown]);
        for (k, multiplier) in multipliers.into_iter().enumerate() {
            let mut changed = set.clone();
            changed[k].1 += 1.0;
            // What other equations repeat cannot change alone.
            let Ok(changed) = Constraints::new(POINTS, &equations(&changed)) else { continue };
            let mut after = before.clone();
            changed.expand(1.0, &mut after);
            let work = dot(&force, &after) - dot(&force, &before);
            let size: f64 = 1.0 + after.iter().map(|v| v.abs()).sum::<f64>();
            prop_assert!((work - multiplier).abs() <= 1e-11 * size, "{work} and {multiplier}");
        }
    }

    #[test]
    fn the_order_of_equations_does_not_matter(number in 1_usize..10, seed in any::<u64>()) {
        let mut noise = Noise(seed);
        let solution = noise.vector(SIZE);
        let mut set = consistent(number, &solution, &mut noise);
        let one = Constraints::new(POINTS, &equations(&set)).expect("consistent");
        set.reverse();
        let other = Constraints::new(POINTS, &equations(&set)).expect("consistent");
        prop_assert_eq!(one.rows().len(), other.rows().len());
        // What satisfies one satisfies the other: expanding it changes nothing.
        let mut u = noise.vector(SIZE);
        one.expand(1.0, &mut u);
        let size = u.iter().fold(1.0_f64, |a, v| a.max(v.abs()));
        let mut again = u.clone();
        other.expand(1.0, &mut again);
        for (a, b) in u.iter().zip(&again) {
            prop_assert!((a - b).abs() <= 1e-10 * size, "{a} and {b}");
        }
    }

    #[test]
    fn a_violated_combination_of_equations_is_named(number in 2_usize..10, seed in any::<u64>()) {
        let mut noise = Noise(seed);
        let solution = noise.vector(SIZE);
        let mut set = consistent(number, &solution, &mut noise);
        let (a, b) = (noise.index(number), noise.index(number));
        let sum: Left = set[a].0.iter().chain(&set[b].0).copied().collect();
        set.push((sum.clone(), value(&sum, &solution) + 0.5));
        let contradiction = Constraints::new(POINTS, &equations(&set)).expect_err("contradictory");
        prop_assert_eq!(contradiction.origin, number.to_string());
        prop_assert!(!contradiction.others.is_empty());
    }
}

/// Other right-hand sides move the same rows, and what only repeats others must go with them.
#[test]
fn right_hand_sides_change_without_a_new_elimination() {
    let at = |point: usize| Unknown { component: 0, point };
    let equation = |terms: &[(usize, f64)], value: f64| Equation {
        terms: terms.iter().map(|&(point, share)| (at(point), share)).collect(),
        value,
        origin: String::new(),
    };
    let of = |values: [f64; 3]| {
        [
            equation(&[(0, 1.0)], values[0]),
            equation(&[(1, 2.0), (0, 1.0), (3, -1.0)], values[1]),
            // The sum of both.
            equation(&[(1, 2.0), (0, 2.0), (3, -1.0)], values[2]),
        ]
    };
    let first = Constraints::new(4, &of([1.0, 3.0, 4.0])).expect("they agree");
    for values in [[2.0, -6.0, -4.0], [0.0, 0.5, 0.5]] {
        let moved = first.with_values(&values).expect("they agree");
        let again = Constraints::new(4, &of(values)).expect("they agree");
        let mut found = [0.0, 0.0, 7.0, 11.0];
        let mut expected = found;
        moved.expand(1.0, &mut found);
        again.expand(1.0, &mut expected);
        assert_eq!(found, expected);
    }
    assert_eq!(first.with_values(&[1.0, 3.0, 5.0]).err(), Some(2));
    assert_eq!(first.with_values(&[1.0, 3.0]).err(), Some(2));
}
