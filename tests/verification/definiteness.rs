//! The free beam: a symmetric stiffness whose null space is the two rigid motions, and nothing else.

use crate::support::largest;
use nalgebra::DMatrix;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::end_treatment::EndSupport;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Grid, Line, TimoshenkoBeam, VolumeFactor, bond_law, end_treatment,
};
use peristat_assembly::system::System;

const CELLS: usize = 24;

fn beam(law: &str, treatment: &str, m: u32, grid: Grid, supports: [EndSupport; 2]) -> TimoshenkoBeam {
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find(law).expect("the law exists"),
        end_treatment: end_treatment::find(treatment).expect("the treatment exists"),
    };
    let stiffness = SectionStiffness::uniform(1.0, 400.0, 1.0, 1.0);
    let line = Line { grid, horizon_ratio: f64::from(m), supports, ..Line::new(1.0, CELLS, stiffness) };
    TimoshenkoBeam::new(parameters, vec![line]).expect("a chain")
}

/// Every law, treatment and horizon ratio.
fn each(mut visit: impl FnMut(&str, &str, u32)) {
    for law in bond_law::TABLE {
        for treatment in end_treatment::TABLE {
            for m in [1, 2, 3, 6] {
                visit(law.name, treatment.name, m);
            }
        }
    }
}

fn dense(matrix: &sprs::CsMat<f64>) -> DMatrix<f64> {
    let mut dense = DMatrix::zeros(matrix.rows(), matrix.cols());
    for (&value, (i, j)) in matrix {
        dense[(i, j)] += value;
    }
    dense
}

fn sorted_eigenvalues(matrix: DMatrix<f64>) -> Vec<f64> {
    let mut values = matrix.symmetric_eigenvalues().data.as_vec().clone();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn a_free_beam_has_exactly_two_motions_without_energy() {
    each(|law, treatment, m| {
        let beam = beam(law, treatment, m, Grid::Nodes, Default::default());
        let system = System::<2>::new(&beam, Vec::new(), Vec::new()).expect("no contradiction");
        let n = system.points();
        let k = dense(&system.stiffness().to_csr(|point, component| component * n + point));
        let name = format!("{law}, {treatment}, m = {m}");
        assert_eq!(k, k.transpose(), "{name}");
        let largest_entry = largest(k.as_slice());
        for kind in 0..2 {
            let motion: Vec<f64> =
                (0..2 * n).map(|u| Model::<2>::rigid_motion(&beam, kind, u % n, [0.0; 3])[u / n]).collect();
            let force = &k * nalgebra::DVector::from_vec(motion);
            // A10, measured 2.3e-16 of the largest entry.
            let relative = largest(force.as_slice()) / largest_entry;
            assert!(relative <= 1e-14, "{name}, motion {kind}: {relative:e}");
        }
        let values = sorted_eigenvalues(k);
        let top = values[2 * n - 1];
        // Measured 2e-16 at most, and 1e-5 at least.
        assert!(largest(&values[..2]) <= 1e-13 * top, "{name}: {:?}", &values[..3]);
        assert!(values[2] >= 1e-6 * top, "{name}: {:?}", &values[..3]);
    });
}

#[test]
fn guided_ends_by_images_leave_the_translation_and_nothing_else() {
    let guided = EndSupport { w: None, phi: Some(0.0) };
    for law in bond_law::TABLE {
        for m in [1, 2, 3, 6] {
            let beam = beam(law.name, "image", m, Grid::Cells, [guided; 2]);
            let system = System::<2>::new(&beam, Vec::new(), Vec::new()).expect("no contradiction");
            let mut k = dense(&system.assemble_sparse());
            k.fill_upper_triangle_with_lower_triangle();
            let name = format!("{}, m = {m}", law.name);
            // Dependent unknowns have a positive diagonal and couple to nothing.
            let values = sorted_eigenvalues(k);
            let top = values[values.len() - 1];
            assert!(values[0].abs() <= 1e-13 * top, "{name}: {:?}", &values[..2]);
            assert!(values[1] >= 1e-6 * top, "{name}: {:?}", &values[..2]);
        }
    }
}
