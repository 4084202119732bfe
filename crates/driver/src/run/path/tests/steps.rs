//! Single steps, refused steps, and odd cases.

use super::*;

#[test]
fn nothing_is_committed_from_a_refused_step() {
    // More than the ligament bears: steps beyond find no equilibrium.
    let case = controlled(&forced(&notched(), 40000.0), "displacement", 1.0);
    let plate = scene(&case).into_body().unwrap();
    let (coarse, refused) = climb(&mut course(&plate), 1.0);
    let (fine, _) = climb(&mut course(&plate), 1.0 / 64.0);
    // Refused 8 times, in three steps to 0.546875; the small ones go on to 0.5532.
    assert!(refused > 0 && coarse.len() > 1 && fine.len() > 30, "{refused} {coarse:?}");
    for [load_factor, stored, dissipated] in coarse {
        let same = fine.iter().find(|f| f[0] == load_factor).expect("the small steps come there");
        // Measured: 1.2e-11 and 7e-12.
        assert!((stored - same[1]).abs() < 1e-9 * same[1]);
        assert!((dissipated - same[2]).abs() < 1e-9 * same[1]);
    }
}

#[test]
fn odd_cases_end() {
    let arrived = "the path is where it was asked to go";
    let everywhere = json!({ "half_plane": { "point": [0, 0], "normal": [1, 0] } });
    for control in ["event", "displacement", "dissipation", "auto"] {
        let base = controlled(&plate(), control, 0.05);
        let ends = |case: &Value, ending: &str| {
            let ran = solve(case);
            assert_eq!(ran.path().ending, ending, "{control}");
            // The longest of them takes 164 steps.
            assert!(ran.points.len() < 300, "{control}: {}", ran.points.len());
            ran
        };
        ends(&with(&base, "/cracks", json!([])), arrived);
        ends(&with(&base, "/path/increment", 1.into()), arrived);
        let one = ends(&with(&base, "/path/max_steps", 1.into()), "as many steps as allowed were made");
        assert_eq!(one.points.len(), 2);
        ends(&with(&base, "/path/stop_below", 0.3.into()), "the load fell below its part of the peak");
        // Bonds that are all but brittle.
        ends(&law(&base, "failure_stretch", 0.002_800_1), arrived);
        ends(&turning(&base, json!([{ "load_factor": -0.4 }, { "load_factor": 0.4 }])), arrived);

        let elastic =
            with(&with(&base, "/regions/all", everywhere.clone()), "/path/no_damage", json!(["all"]));
        let elastic = ends(&elastic, arrived);
        assert_eq!((elastic.last().softened, elastic.last().broken), (0, 0));
        assert!((elastic.last().stored / (0.5 * 0.06 * elastic.last().load) - 1.0).abs() < 1e-9);
        // Nothing moves.
        assert_eq!(ends(&with(&base, "/supports/1/uy", 0.into()), arrived).last().work, 0.0);

        // A load that the body does not have, on either side of the one at the turn.
        for load in [-1e9, 1e9] {
            let case = turning(&base, json!([{ "load_factor": 0.4 }, { "load": load }]));
            let ran = ends(&case, "no equilibrium was found beyond this state");
            assert!(!ran.report.converged && ran.largest(|p| p.load_factor) == 0.4);
        }
        let turns = json!([{ "load_factor": 0.05 }, { "load": 0 }, { "load_factor": -0.05 }]);
        let ran = ends(&turning(&base, turns), arrived);
        assert!(ran.points.iter().any(|p| p.load_factor.abs() < 1e-12 && p.step > 0));
    }
}

#[test]
fn plain_newton_stops_right_after_the_peak() {
    // The specimen of `cases/ductile/ct_2024.json`: nine steps of 0.05 to the peak at an opening of 0.45.
    let text = include_str!("../../../../../../cases/ductile/ct_2024.json");
    let plate = scene(&serde_json::from_str(text).unwrap()).into_body().unwrap();
    let (mut course, mut control) = (course(&plate), Displacement::<2>::new(1.0 / 60.0));
    let mut predictor = course.elastic.clone();
    for step in 1..=9 {
        let goal = Goal::LoadFactor(f64::from(step) / 60.0);
        let Step::To(state, cost, _) = control.step(&mut course, goal, &|_, _| 0.0).unwrap() else {
            panic!("the peak is reached");
        };
        predictor = state.u.iter().zip(&course.state.u).map(|(now, before)| (now - before) * 60.0).collect();
        course.accept(state, cost);
        control.committed(&mut course, false);
    }
    let mut state = course.state.clone();
    state.u.iter_mut().zip(&predictor).for_each(|(u, d)| *u += d / 60.0);
    state.load_factor += 1.0 / 60.0;
    course.body.evaluate(&mut state);
    let mut tangent = Tangent::<2>::new(state.u.len());
    let mut correction = vec![0.0; state.u.len()];
    for _ in 0..30 {
        assert!(tangent.factor(&mut course.body, &state).unwrap());
        assert!(tangent.apply(&mut course.body, &state.residual, &mut correction));
        state.u.iter_mut().zip(&correction).for_each(|(u, d)| *u -= d);
        course.body.evaluate(&mut state);
    }
    // The default finds the next state in four iterations; this one is left with a residual of percents.
    assert!(state.norm() > 1e-3 * course.reference, "{}", state.norm() / course.reference);
    let goal = Goal::LoadFactor(10.0 / 60.0);
    let step = control.step(&mut course, goal, &|_, _| 0.0).unwrap();
    assert!(matches!(step, Step::To(_, cost, true) if cost.refused == 0));
}
