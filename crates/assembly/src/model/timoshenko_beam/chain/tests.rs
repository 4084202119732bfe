//! Ends of lines with ghost points: what these move by, and their share of the energy.

use super::super::{TimoshenkoBeam, VolumeFactor, bond_law, end_treatment};
use super::*;
use crate::condition::Equation;
use crate::material::Profile;
use crate::model::{Model, Points};

const FREE: EndSupport = EndSupport { w: None, phi: None };

fn beam(law: &str, treatment: &str, line: Line) -> TimoshenkoBeam {
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find(law).unwrap(),
        end_treatment: end_treatment::find(treatment).unwrap(),
    };
    TimoshenkoBeam::new(parameters, vec![line]).unwrap()
}

/// A line of 6 cells from an end at x = 0 to a free end, on its right or on its left.
fn half(side: usize, support: EndSupport, grid: Grid, horizon_ratio: f64) -> Line {
    let mut supports = [FREE; 2];
    supports[side] = support;
    let section = SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3);
    Line { from: -(side as f64), grid, horizon_ratio, supports, ..Line::new(1.0, 6, section) }
}

/// Deflections and rotations of all points, ghosts included.
fn motion(beam: &TimoshenkoBeam, w: fn(f64) -> f64, phi: fn(f64) -> f64) -> Vec<f64> {
    let x = |p: usize| beam.position(p)[0];
    let points = 0..beam.points();
    points.clone().map(|p| w(x(p))).chain(points.map(|p| phi(x(p)))).collect()
}

#[test]
fn a_half_between_mirrors_has_half_the_energy() {
    let simple = EndSupport { w: Some(0.0), phi: None };
    let guided = EndSupport { w: None, phi: Some(0.0) };
    let odd: [fn(f64) -> f64; 2] = [|x| x * (x * x - 2.0), |x| x * x * (0.3 + x * x)];
    let energy = |beam: &TimoshenkoBeam, [w, phi]: [fn(f64) -> f64; 2]| -> f64 {
        let u = motion(beam, w, phi);
        Model::<2>::terms(beam).iter().map(|t| t.survey(&u).energy).sum()
    };
    for (law, treatment) in [("exact", "image"), ("corrected", "ghost"), ("published", "ghost")] {
        for (grid, m) in [Grid::Nodes, Grid::Cells].into_iter().flat_map(|g| (1..=5).map(move |m| (g, m))) {
            for (support, planes) in [(simple, odd), (guided, [odd[1], odd[0]])] {
                for side in 0..2 {
                    let line = half(side, support, grid, f64::from(m));
                    let both =
                        Line { from: -1.0, length: 2.0, cells: 12, supports: [FREE; 2], ..line.clone() };
                    let [one, two] = [line, both].map(|line| energy(&beam(law, treatment, line), planes));
                    // Measured: 4e-16.
                    assert!(
                        (2.0 * one / two - 1.0).abs() < 1e-13,
                        "{law} {grid:?} m = {m}, {support:?}: {one} {two}"
                    );
                }
            }
        }
    }
}

#[test]
fn ghost_points_mirror_or_continue_what_is_held() {
    let held = |w, phi| EndSupport { w, phi };
    type Case = (&'static str, EndSupport, fn(f64) -> f64, fn(f64) -> f64);
    let cases: [Case; 4] = [
        ("image", held(None, Some(0.4)), |x| 0.3 + 0.4 * x + x * x, |x| 0.4 - x),
        ("image", held(Some(0.7), Some(0.4)), |x| 0.7 + 0.4 * x - x * x, |x| 0.4 + x),
        ("ghost", held(Some(0.7), None), |x| 0.7 + x - x.powi(3), |x| 1.0 + x * x),
        ("ghost", held(Some(0.7), Some(0.4)), |x| 0.7 + 0.4 * x, |_| 0.4),
    ];
    for (treatment, support, w, phi) in cases {
        for (side, grid) in [(0, Grid::Nodes), (1, Grid::Nodes), (0, Grid::Cells), (1, Grid::Cells)] {
            let beam = beam("exact", treatment, half(side, support, grid, 3.0));
            let u = motion(&beam, w, phi);
            let chain = &beam.chains()[0];
            let relations = chain.relations(0);
            assert!(chain.ghosts[side] > 0 && relations.len() == 2 * chain.ghosts[side]);
            for Equation { terms, value, .. } in relations {
                let sum: f64 = terms.iter().map(|(k, f)| f * u[k.component * beam.points() + k.point]).sum();
                assert!((sum - value).abs() < 1e-14, "{treatment} {support:?} {grid:?}: {sum} {value}");
            }
        }
    }
}

#[test]
fn the_compliance_changes_little_in_a_piece() {
    let mut stiffness = SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3);
    stiffness.bending = Profile::Polynomial(vec![2.0, 40.0]);
    let line = Line { from: 0.7, ..Line::new(1.0, 6, stiffness) };
    let pieces = pieces(&line, &[0.3, 0.5], 0.8, 1.5);
    assert_eq!((pieces[0].0, pieces[pieces.len() - 1].1), (0.8, 1.5));
    assert!(pieces.windows(2).all(|pair| pair[0].1 == pair[1].0));
    assert!([1.0, 1.2].iter().all(|cut| pieces.iter().any(|(_, end)| (end - cut).abs() < 1e-15)));
    let bending = |x: f64| 2.0 + 40.0 * (x - 0.7);
    assert!(pieces.iter().all(|&(a, b)| a < b && bending(b) < 1.51 * bending(a)), "{pieces:?}");
}

#[test]
fn a_stiffness_that_is_rounding_has_an_end() {
    // EI = (1 − x)³ in powers of x: beside the tip nothing but rounding, whose sign changes everywhere.
    let mut stiffness = SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3);
    stiffness.bending = Profile::Polynomial(vec![1.0, -3.0, 3.0, -1.0]);
    let line = Line::new(1.0, 6, stiffness);
    let pieces = pieces(&line, &[], 0.8, 1.0);
    assert_eq!((pieces[0].0, pieces[pieces.len() - 1].1), (0.8, 1.0));
    assert!(pieces.len() < 5000, "{}", pieces.len());
}
