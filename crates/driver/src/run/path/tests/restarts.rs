//! Paths that go on from any of their states as if they had not stopped.

use super::*;
use crate::run::{Restart, RunError};

/// What a run has reported, and what it takes to go on from each state, as it is written to a file.
#[derive(Default)]
struct Kept {
    told: Recorder,
    restarts: Vec<(usize, Vec<u8>)>,
}

impl Sink for Kept {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.told.take(result)
    }

    fn advance(&mut self, advance: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.told.advance(advance, None)?;
        if let Some(restart) = restart {
            self.restarts.push((self.told.points.len(), postcard::to_stdvec(&restart()).unwrap()));
        }
        Ok(())
    }
}

/// Follows a path, and again from every so many of its states: the same states follow, to the last bit.
fn goes_on_from_every(case: &Value, stride: usize) -> RunReport {
    let scene = scene(case);
    let mut whole = Kept::default();
    let report = run::run(&scene, &RunOptions::default(), None, &mut whole).unwrap();
    let whole_states = &whole.told.states;
    assert!(
        whole.told.points.len() > 4 && report.path.as_ref().unwrap().steps + 1 == whole.told.points.len()
    );
    for (told, bytes) in whole.restarts.iter().step_by(stride) {
        let restart: Restart = postcard::from_bytes(bytes).unwrap();
        let recorded = restart.recorded;
        let mut rest = Kept::default();
        let again = run::run(&scene, &RunOptions::default(), Some(restart), &mut rest).unwrap();
        // Numbers that are none are not equal to themselves.
        let texts = |points: &[PathPoint]| points.iter().map(|p| format!("{p:?}")).collect::<Vec<_>>();
        assert_eq!(texts(&rest.told.points), texts(&whole.told.points[*told..]), "from state {told}");
        assert_eq!(rest.told.states.len() + recorded, whole_states.len());
        for (a, b) in rest.told.states.iter().zip(&whole_states[recorded..]) {
            assert!(a.record().u == b.record().u && a.record().name == b.record().name, "from state {told}");
        }
        assert_eq!(again.path, report.path);
        assert_eq!(again.counters, report.counters);
    }
    report
}

#[test]
fn steps_of_motions_go_on() {
    goes_on_from_every(&controlled(&plate(), "displacement", 0.1), 1);
}

#[test]
fn steps_of_dissipated_energy_go_on() {
    goes_on_from_every(&controlled(&law(&plate(), "failure_stretch", 0.0056), "dissipation", 0.1), 7);
}

/// With the factor that there was and the bonds that have changed since, through records that overwrite it.
#[test]
fn traced_events_go_on() {
    let case = with(
        &controlled(&law(&plate(), "failure_stretch", 0.0056), "event", 0.1),
        "/path/record_every",
        7.into(),
    );
    let report = goes_on_from_every(&case, 13);
    assert!(report.path.unwrap().facts["snap_back_steps"].as_f64().unwrap() > 0.0);
}

#[test]
fn paths_that_turn_and_bodies_that_rotate_go_on() {
    let there_and_back = json!([{ "load_factor": 0.5 }, { "load": 0 }, { "load_factor": 1 }]);
    for control in ["displacement", "event"] {
        goes_on_from_every(&turning(&controlled(&plate(), control, 0.1), there_and_back.clone()), 5);
    }
    let finite = law(&plate(), "kinematics", "finite");
    goes_on_from_every(&controlled(&finite, "dissipation", 0.1), 5);
}

/// What takes over from steps that get stuck is known after.
#[test]
fn another_control_goes_on() {
    let case = controlled(&forced(&notched(), 40_000.0), "auto", 0.02);
    let case = with(&with(&case, "/path/stop_below", 0.1.into()), "/path/record_every", 5.into());
    let report = goes_on_from_every(&case, 20);
    assert_eq!(report.path.unwrap().control, crate::case::PathControl::Event);
}

#[test]
fn a_restart_of_another_body_does_not_fit() {
    let of = |case: &Value| {
        let mut kept = Kept::default();
        run::run(&scene(case), &RunOptions::default(), None, &mut kept).unwrap();
        let bytes = kept.restarts.swap_remove(1).1;
        postcard::from_bytes::<Restart>(&bytes).unwrap()
    };
    let plate = controlled(&plate(), "displacement", 0.1);
    let chains = controlled(&chains(2), "event", 0.1);
    for (case, other) in [(&plate, &chains), (&chains, &plate)] {
        let refused =
            run::run(&scene(case), &RunOptions::default(), Some(of(other)), &mut Recorder::default());
        assert!(matches!(refused, Err(RunError::Misfit)), "{refused:?}");
    }
}
