//! Random beams: certified, in equilibrium, and indifferent to units, to the side they are seen from and to the way
//! their loads are put together.

use super::random_beam::{METRES, MILLIMETRES, beam, run};
use proptest::prelude::*;

fn largest(v: impl IntoIterator<Item = f64>) -> f64 {
    v.into_iter().fold(0.0, |a, x| if x.is_nan() { f64::INFINITY } else { a.max(x.abs()) })
}

/// Largest difference relative to the largest value of the unknowns, `w` over the length and φ taken together.
fn difference(a: &[f64], b: &[f64], length: f64) -> f64 {
    assert_eq!(a.len(), b.len());
    let n = a.len() / 2;
    let scaled = |u: &[f64], k: usize| if k < n { u[k] / length } else { u[k] };
    let off = largest((0..2 * n).map(|k| scaled(a, k) - scaled(b, k)));
    // A load on a support moves nothing.
    if off == 0.0 { 0.0 } else { off / largest((0..2 * n).map(|k| scaled(b, k))) }
}

proptest! {
    #![proptest_config(super::cases(300))]

    #[test]
    fn a_random_beam_is_certified_and_in_equilibrium(beam in beam()) {
        let (states, report) = run(&beam.case(METRES));
        let state = &states[0];
        let certificate = &state.record.certificate;
        prop_assert!(report.converged, "{certificate:?}");
        prop_assert!(certificate.next_correction <= 1e-11, "{certificate:?}");
        prop_assert!(certificate.energy_balance <= 1e-11, "{certificate:?}");
        let applied = beam.resultant();
        let [mut force, mut moment] = applied;
        let mut scale = applied[0].abs() * beam.length + applied[1].abs();
        for reaction in &state.reactions {
            force += reaction.force;
            moment += reaction.moment + reaction.x * reaction.force;
            scale += reaction.force.abs() * beam.length + reaction.moment.abs();
        }
        // Measured 2e-13.
        prop_assert!(force.abs() * beam.length <= 1e-10 * scale, "{force} of {scale}");
        prop_assert!(moment.abs() <= 1e-10 * scale, "{moment} of {scale}");
    }

    #[test]
    fn a_beam_is_the_same_in_strains_and_in_displacements(beam in beam()) {
        let [strains, displacements] = ["strain", "band"].map(|solver| {
            let mut case = beam.case(METRES);
            case["solver"] = solver.into();
            let (mut states, report) = run(&case);
            assert!(report.converged, "{solver}: {:?}", states[0].record.certificate);
            states.remove(0).record.u
        });
        let off = difference(&strains, &displacements, beam.length);
        // Measured 4e-14 over 6000 beams.
        prop_assert!(off <= 1e-12, "{off:e}");
    }

    #[test]
    fn units_do_not_change_a_beam(beam in beam()) {
        let (metres, _) = run(&beam.case(METRES));
        let (millimetres, _) = run(&beam.case(MILLIMETRES));
        let n = metres[0].record.u.len() / 2;
        let scale = |k: usize| if k < n { 1e-3 } else { 1.0 };
        let back: Vec<f64> = millimetres[0].record.u.iter().enumerate().map(|(k, v)| scale(k) * v).collect();
        let off = difference(&back, &metres[0].record.u, beam.length);
        // Measured 1e-14.
        prop_assert!(off <= 3e-13, "{off:e}");
    }

    #[test]
    fn a_mirrored_beam_bends_as_the_mirror_image(beam in beam()) {
        let (one, _) = run(&beam.case(METRES));
        let (other, _) = run(&beam.mirrored().case(METRES));
        let n = one[0].record.u.len() / 2;
        let mut back: Vec<f64> = other[0].record.u[..n].iter().rev().copied().collect();
        back.extend(other[0].record.u[n..].iter().rev().map(|phi| -phi));
        let off = difference(&back, &one[0].record.u, beam.length);
        // Measured 2e-14.
        prop_assert!(off <= 3e-13, "{off:e}");
    }

    #[test]
    fn loads_superpose(beam in beam()) {
        let (together, _) = run(&beam.case(METRES));
        let (apart, report) = run(&beam.taken_apart());
        prop_assert_eq!(report.counters.factorisations, 1);
        let count = beam.loads.len();
        let sum: Vec<f64> = (0..together[0].record.u.len()).map(|k| apart[..count].iter().map(|s| s.record.u[k]).sum()).collect();
        // Parts may be larger than their sum.
        let size = largest(apart[..count].iter().flat_map(|s| s.record.u.iter().copied()));
        let cancelled = 1.0 + size / largest(together[0].record.u.iter().copied()).max(f64::MIN_POSITIVE);
        for found in [&sum, &apart[count].record.u] {
            let off = difference(found, &together[0].record.u, beam.length);
            // Measured 3e-15.
            prop_assert!(off <= 1e-13 * cancelled, "{off:e}");
        }
    }
}
