//! Plates of several thicknesses.

use super::body::scaled_eigenvalues;
use super::{Held, PHI_X, PHI_Y, Solver, assert_close, deflection, fixed, line, parameters, pressure};
use crate::body::SquareLattice;
use crate::model::Model;
use crate::model::plate_bending::{CellSections, PlateBending, PlateParameters, PlateSection};
use std::sync::Arc;

/// A plate with another section in the cells that are in a part of it.
fn stepped(
    cells: SquareLattice,
    parameters: PlateParameters,
    other: PlateSection,
    is_other: impl Fn([i32; 2]) -> bool,
) -> PlateBending {
    let places = cells.runs().iter().flat_map(|run| run.columns.clone().map(|column| [column, run.row]));
    let numbers = places.map(|cell| u32::from(is_other(cell))).collect();
    let sections = CellSections { others: vec![other], numbers };
    PlateBending::of_sections(Arc::new(cells), parameters, sections).unwrap()
}

/// A section of a thickness per that of another one.
fn thinner(section: PlateSection, ratio: f64) -> PlateSection {
    PlateSection { bending: section.bending * ratio.powi(3), shear: section.shear * ratio, ..section }
}

#[test]
fn a_stepped_strip_is_exact_at_its_points() {
    for (t, ratio) in [0.2, 0.01, 1e-4].into_iter().flat_map(|t| [0.5, 0.1, 3.0].map(|ratio| (t, ratio))) {
        for cells in [8, 16, 32] {
            let (h, parameters) = (1.0 / f64::from(cells), parameters(1.5, t));
            let other = thinner(parameters.section, ratio);
            let strip = SquareLattice::rectangle(h, [0.0; 2], [cells, 3]);
            let plate = stepped(strip, parameters, other, |[i, _]| 2 * i >= cells);
            let solver = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Strip));
            let tip = |load: Vec<f64>| deflection(&plate, &solver.solve(&load), [1.0, h]);
            let (d, s) = (other.bending, [parameters.section.shear, other.shear]);
            // ∫ M² /D and ∫ V/S of a cantilever: M = 1 - x under a unit force at the tip, and (1 - x)²/2 under a unit pressure.
            let force = (1.0 - 0.125) / 3.0 + 0.125 / 3.0 / d + 0.5 / s[0] + 0.5 / s[1];
            assert_close(tip(line(&plate)), force, 1e-12);
            let pressed = 0.9375 / 8.0 + 0.0625 / 8.0 / d + 0.375 / s[0] + 0.125 / s[1];
            assert_close(tip(pressure(&plate)), pressed, 1e-12);
        }
    }
}

/// Columns of cells before the step.
const STEP: i32 = 5;

/// 12 × 9 cells with a hole across a step to another thickness and Poisson's ratio.
pub(super) fn perforated(m: f64, t: f64) -> PlateBending {
    let is_in = |[i, j]: [i32; 2]| !((3..7).contains(&i) && (3..5).contains(&j));
    let cells = SquareLattice::plane(0.1, [0.0; 2], 0..12, 0..9, is_in);
    let parameters = parameters(m, t);
    let other = PlateSection { poisson_ratio: 0.1, ..thinner(parameters.section, 0.4) };
    stepped(cells, parameters, other, |[i, _]| i >= STEP)
}

/// Curvatures `[κ_xx, κ_yy]` of the two parts: one κ_yy, and one M_xx.
fn curvatures(plate: &PlateBending) -> [[f64; 2]; 2] {
    let [a, b] = [plate.parameters().section, plate.sections().others[0]];
    let (yy, moment) = (0.7, 0.4);
    [a, b].map(|section| [moment / section.bending - section.poisson_ratio * yy, yy])
}

#[test]
fn a_step_between_uniform_curvatures_is_exact() {
    for (m, t) in [1.5, 2.0, 3.0].into_iter().flat_map(|m| [0.3, 1e-3].map(|t| (m, t))) {
        let plate = perforated(m, t);
        let (n, step, of_parts) = (plate.nodes().points(), 0.1 * f64::from(STEP), curvatures(&plate));
        let mut exact = vec![0.0; 3 * n];
        for point in 0..n {
            let [x, y] = plate.nodes().place(point);
            let [xx, yy] = of_parts[usize::from(x > step)];
            exact[point] = 0.5 * (xx * (x - step).powi(2) + yy * y * y);
            exact[PHI_X * n + point] = xx * (x - step);
            exact[PHI_Y * n + point] = yy * y;
        }
        let sections = [plate.parameters().section, plate.sections().others[0]];
        let moments = [0, 1].map(|k| sections[k].moments([of_parts[k][0], of_parts[k][1], 0.0]));
        let edges = plate.nodes().edges();
        let mut load = vec![0.0; 3 * n];
        let of_edge = |k: usize, _: [f64; 2]| {
            let [a, b] = edges[k].points.map(|p| plate.nodes().place(p as usize)[0]);
            let [x, y] = edges[k].outward;
            // Half a cell inside.
            let moment = moments[usize::from(0.5 * (a + b) - 0.05 * x > step)];
            [0.0, moment[0] * x, moment[1] * y]
        };
        let segments: Vec<[u32; 2]> = edges.iter().map(|edge| edge.points).collect();
        plate.add_line(&segments, of_edge, &mut load);
        // A point on the step, at the lower edge.
        let pinned = plate.nodes().number([STEP, 0]).unwrap();
        let u = Solver::new(&plate, Vec::new(), &[0, 1, 2].map(|c| c * n + pinned)).solve(&load);
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, v| most.max(v.abs()));
        let off = largest(&mut u.iter().zip(&exact).map(|(a, b)| a - b));
        // 1e-13 is found.
        assert!(off < 1e-11 * largest(&mut exact.iter().copied()), "m = {m}, t = {t}: {off:.1e}");
        let fields = plate.fields(&u, &[], &|_| [false; 2]);
        for (point, moment) in fields.moment.iter().enumerate() {
            let x = plate.nodes().place(point)[0];
            let yy = match (x - step).abs() < 1e-9 {
                true => 0.5 * (moments[0][1] + moments[1][1]),
                false => moments[usize::from(x > step)][1],
            };
            assert!((moment[0] - 0.4).abs() < 1e-8 && moment[2].abs() < 1e-8, "{point}: {moment:?}");
            assert!((moment[1] - yy).abs() < 1e-8, "{point}: {moment:?}, not {yy}");
        }
    }
}

#[test]
fn a_free_plate_with_a_step_has_three_motions_without_energy() {
    for (m, t) in [1.5, 3.0].into_iter().flat_map(|m| [0.3, 1e-4].map(|t| (m, t))) {
        let values = scaled_eigenvalues(&perforated(m, t));
        // The fourth is 1e-3 at t = 1e-4.
        assert!(values[2].abs() < 1e-12 && values[3] > 1e-4, "m = {m}, t = {t}: {:?}", &values[..4]);
    }
}

#[test]
fn cells_twice_as_large_have_the_section_of_most_of_their_cells() {
    let parameters = parameters(1.5, 0.1);
    let thick = thinner(parameters.section, 2.0);
    let cells = SquareLattice::rectangle(0.1, [0.0; 2], [8, 4]);
    // Three columns: the second pair has one of each, and is the stiffer one.
    let plate = stepped(cells, parameters, thick, |[i, _]| i < 3);
    let coarse = plate.coarser().unwrap();
    assert_eq!(coarse.sections().numbers, [1, 1, 0, 0, 1, 1, 0, 0]);
    assert_eq!(coarse.sections().others, [thick]);
    assert!(coarse.terms().len() == plate.terms().len());
}
