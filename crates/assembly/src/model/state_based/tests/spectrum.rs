//! Motions without energy, and no negative energies.

use super::*;
use crate::model::Points;

pub(super) fn eigenvalues(model: &StateBased) -> Vec<f64> {
    let system = System::new(model, Vec::new(), Vec::new()).unwrap();
    let full = stiffness(&system);
    // Rows of dependent unknowns are inert.
    let inert: Vec<usize> = system.constraints().rows().iter().map(|row| row.unknown).collect();
    let free: Vec<usize> = (0..system.size()).filter(|k| inert.binary_search(k).is_err()).collect();
    let part = full.select_rows(&free).select_columns(&free);
    let mut values: Vec<f64> = part.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn only_rigid_motions_cost_nothing() {
    for horizon_ratio in [2.0, 3.0] {
        let ring: StateBased =
            body(cells(0.1, 1.0, [10, 10]), Mirrors::NONE, StateParameters { horizon_ratio, ..RING });
        let plate: StateBased =
            body(cells(0.1, 1.0, [10, 10]), Mirrors::NONE, StateParameters { horizon_ratio, ..PLATE });
        for (values, rigid) in [(eigenvalues(&ring), 1), (eigenvalues(&plate), 3)] {
            let most = values[values.len() - 1];
            let zero = values.iter().filter(|v| **v < 1e-10 * most).count();
            assert_eq!(zero, rigid, "{horizon_ratio}");
            assert!(values[0] > -1e-13 * most);
        }
    }
}

#[test]
fn damaged_families_have_no_negative_energy() {
    for nu in [-0.6, 0.0, 0.2, 0.45] {
        for dilatation in [Dilatation::Points, Dilatation::Blocks] {
            let parameters = StateParameters { poisson_ratio: nu, dilatation, ..RING };
            // Every third bond is gone.
            let cut = |lattice: &SquareLattice| {
                let offsets = StateBased::offsets(&parameters).len();
                let all = (0..lattice.points()).flat_map(|p| (0..offsets).map(move |k| (k, p)));
                all.filter(|(k, p)| (7 * k + 3 * p * p + p) % 3 == 0).collect()
            };
            let lattice = Arc::new(cells(0.1, 1.0, [8, 8]));
            let model =
                StateBased::on_lattice(lattice, Mirrors::NONE, parameters, &|_, _| false, &cut).unwrap();
            let values = eigenvalues(&model);
            assert!(values[0] > -1e-13 * values[values.len() - 1], "{nu} {dilatation:?} {:e}", values[0]);
        }
    }
}

#[test]
fn energies_given_away_leave_none_that_is_negative() {
    // With the negative weights of corners it would be −0.17 of the largest one (an independent Python implementation).
    let moment = StateParameters { edges: StateEdges::MomentPlus, ..RING };
    let model: StateBased = body(cells(0.1, 1.0, [10, 10]), Mirrors::NONE, moment);
    let values = eigenvalues(&model);
    assert!(values[0] > -1e-13 * values[values.len() - 1]);
}

#[test]
fn a_translation_along_the_axis_costs_nothing() {
    for axis in [Axis::Images, Axis::Table, Axis::Truncated] {
        let edges = if axis == Axis::Truncated { StateEdges::MomentPlus } else { StateEdges::Ghosts };
        let parameters = StateParameters { axis, edges, influence: Influence::Linear, ..RING };
        let model: StateBased = body(cells(0.1, 0.0, [10, 10]), Mirrors::NONE, parameters);
        let n = model.points();
        let u: Vec<f64> = (0..2 * n).map(|k| f64::from(u8::from(k >= n))).collect();
        let mut force = vec![0.0; 2 * n];
        model.terms().iter().for_each(|t| t.add_force(&u, &mut force));
        assert_eq!(largest(force), 0.0);
    }
}
