use super::*;

fn equation(terms: &[(usize, f64)], value: f64, origin: &str) -> Equation {
    let unknown = |point| Unknown { component: 0, point };
    let terms = terms.iter().map(|&(p, c)| (unknown(p), c)).collect();
    Equation { terms, value, origin: origin.into() }
}

#[test]
fn chains_of_slaves_end_at_independent_unknowns() {
    // u2 = u1 + 1, u1 = 2 u0, so u2 = 2 u0 + 1, whatever the order.
    let a = equation(&[(2, 1.0), (1, -1.0)], 1.0, "a");
    let b = equation(&[(1, 1.0), (0, -2.0)], 0.0, "b");
    for order in [[a.clone(), b.clone()], [b, a]] {
        let c = Constraints::new(4, &order).unwrap();
        let mut u = [3.0, 0.0, 0.0, 5.0];
        c.expand(1.0, &mut u);
        assert_eq!(u, [3.0, 6.0, 7.0, 5.0]);
        let mut force = [1.0, 10.0, 100.0, 1000.0];
        c.restrict(&mut force);
        assert_eq!(force, [221.0, 0.0, 0.0, 1000.0]);
    }
}

#[test]
fn a_slave_can_be_prescribed_through_its_master() {
    // u1 = u0 + 0.5 u2 and u1 = 2: one of the masters gives way.
    let tie = equation(&[(1, 1.0), (0, -1.0), (2, -0.5)], 0.0, "tie");
    let set = equation(&[(1, 1.0)], 2.0, "set");
    let c = Constraints::new(3, &[tie, set]).unwrap();
    let mut u = [0.0, 0.0, 0.6];
    c.expand(1.0, &mut u);
    assert_eq!(u, [1.7, 2.0, 0.6]);
}

#[test]
fn what_rounding_leaves_of_a_coefficient_holds_nothing() {
    // A roller turned by 90°, whose cosine is 6e-17, says what the other equation says, in either order.
    let turned = equation(&[(0, std::f64::consts::FRAC_PI_2.cos()), (1, 1.0)], 0.0, "turned");
    let plain = equation(&[(1, 1.0)], 0.0, "plain");
    for order in [[turned.clone(), plain.clone()], [plain, turned.clone()]] {
        let c = Constraints::new(2, &order).unwrap();
        let mut u = [3.0_f64, 5.0];
        c.expand(1.0, &mut u);
        assert!(u[0] == 3.0 && u[1].abs() < 1e-15, "{u:?}");
    }
    // Alone it holds the unknown that its normal is along, though the other is its first.
    let c = Constraints::new(2, &[turned]).unwrap();
    assert_eq!(c.rows()[0].unknown, 1);
    assert!(c.rows()[0].masters.iter().all(|m| m.1.abs() < 1e-15));
}

#[test]
fn fill_that_cancels_is_no_pivot() {
    // u0 = 0.1 u2, u1 = 0.3 u2 (1 + 1e-15), and 3 u0 - u1 = 0, which repeats them, or contradicts them with a value.
    let a = equation(&[(0, 1.0), (2, -0.1)], 0.0, "a");
    let b = equation(&[(1, 1.0), (2, -0.3 * (1.0 + 1e-15))], 0.0, "b");
    let last = |value: f64| equation(&[(0, 3e6), (1, -1e6)], value, "last");
    let c = Constraints::new(3, &[a.clone(), b.clone(), last(0.0)]).unwrap();
    assert_eq!(c.rows().iter().map(|row| row.unknown).collect::<Vec<_>>(), [0, 1]);
    assert!(Constraints::new(3, &[a, b, last(1.0)]).is_err());
}

#[test]
fn repetition_is_dropped_and_contradiction_named() {
    let one = equation(&[(0, 1.0)], 0.1 + 0.2, "first");
    let same = equation(&[(0, 1.0)], 0.3, "second");
    assert_eq!(Constraints::new(1, &[one.clone(), same]).unwrap().rows().len(), 1);
    let other = equation(&[(0, 1.0)], 0.4, "third");
    let error = Constraints::new(1, &[one, other]).unwrap_err();
    assert_eq!(error.to_string(), "third contradicts first");
}
