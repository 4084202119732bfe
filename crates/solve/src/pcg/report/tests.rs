use super::*;

/// Status and iterations after `r . z` has gone through these values.
fn follow(values: &[f64], options: &PcgOptions) -> (Option<PcgStatus>, usize) {
    let mut watch = Watch::new(options);
    assert_eq!(watch.start(values[0], || 1.0), None);
    for pair in values.windows(2) {
        if let Some(status) = watch.step(1.0, pair[0], pair[1]) {
            return (Some(status), watch.iterations);
        }
    }
    (None, watch.iterations)
}

fn window(stagnation_window: usize) -> PcgOptions {
    PcgOptions { stagnation_window, ..PcgOptions::default() }
}

#[test]
fn a_window_without_a_new_minimum_is_stagnation() {
    let rising = [1.0, 0.1, 0.2, 0.3, 0.2, 0.09];
    assert_eq!(follow(&rising, &window(3)), (Some(PcgStatus::Stagnated), 4));
    assert_eq!(follow(&rising, &window(4)), (None, 5));
}

#[test]
fn at_the_rounding_floor_it_is_convergence() {
    let floor = [1.0, 1.0e-25, 2e-25, 2e-25, 2e-25, 2e-25, 2e-25, 2e-25];
    assert_eq!(follow(&floor, &window(60)), (Some(PcgStatus::Converged), 6));
    let deep = [1.0, 1.0e-12, 1.0e-33];
    assert_eq!(follow(&deep, &window(60)), (Some(PcgStatus::Converged), 2));
}

#[test]
fn a_negative_value_ends_the_iteration() {
    let small = follow(&[1.0, 1.0e-9, -1.0e-26], &window(60));
    assert_eq!(small, (Some(PcgStatus::Converged), 2));
    let large = follow(&[1.0, 1.0e-9, -1.0e-9], &window(60));
    assert_eq!(large, (Some(PcgStatus::Stagnated), 2));
}

#[test]
fn only_steep_falls_are_foretold() {
    let options = PcgOptions { energy_drop: 1.0e-20, ..PcgOptions::STANDARD };
    let foretold = |values: [f64; 3]| {
        let mut watch = Watch::new(&options);
        watch.start(values[0], || 1.0);
        watch.step(1.0, values[0], values[1]);
        watch.step(1.0, values[1], values[2]);
        watch.foretell(|| 1.0)
    };
    assert_eq!(foretold([1.0, 1.0e-8, 1.0e-16]), Some(1.0e-24));
    assert_eq!(foretold([1.0, 1.0e-8, 1.0e-10]), None); // 1e-12 is too much
    assert_eq!(foretold([1.0, 1.0e-18, 2.0e-20]), None); // no more than a factor of 50
}

#[test]
fn a_residual_that_is_small_enough_needs_no_preconditioner() {
    let options = PcgOptions { residual_drop: 1.0e-3, ..PcgOptions::STANDARD };
    let mut watch = Watch::new(&options);
    watch.start(1.0, || 4.0);
    assert_eq!(watch.foretell(|| 8.0e-6), None);
    assert_eq!(watch.step(1.0, 1.0, 0.1), None);
    let next = watch.foretell(|| 4.0e-6).unwrap();
    assert_eq!(watch.step(1.0, 0.1, next), Some(PcgStatus::Converged));
    let report = watch.report(PcgStatus::Converged);
    assert_eq!(report.residual_ratio, Some(1.0e-3));
    assert!((report.energy_ratio - 0.05).abs() < 1.0e-16); // as r . r fell from 8e-6
}

#[test]
fn the_first_correction_is_an_energy_norm() {
    let options = PcgOptions::default();
    let mut watch = Watch::new(&options);
    watch.start(4.0, || 1.0);
    watch.step(1.0, 4.0, 1.0); // energy 4
    watch.step(0.5, 1.0, 0.5); // energy 1/2
    watch.step(1.0, 0.5, 0.0); // energy 1/2
    let report = watch.report(PcgStatus::Converged);
    assert_eq!(report.first_correction, 0.2_f64.sqrt()); // 1 of 5
    assert_eq!((report.energy_ratio, report.iterations), (0.0, 3));
}
