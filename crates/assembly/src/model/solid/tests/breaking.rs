//! Solids whose bonds break.

use super::*;
use crate::body::Cell;
use crate::model::plane::{BreakingModel, CriticalStretch, ToughMaterials, Toughness};
use crate::model::{BodyModel, Breakable, Points};
use crate::stiffness::Term;
use crate::system::System;
use std::collections::{BTreeMap, HashSet};

const SPACING: f64 = 0.5;

/// A block whose bonds break.
fn block<P: SolidMaterial>(cells: [i32; 3], parameters: P) -> Box<dyn BreakingModel<3>> {
    let lattice = SquareLattice::cuboid(SPACING, [0.0; 3], cells);
    let mut body = Solid::on_lattice(Arc::new(lattice), Mirrors::NONE, parameters, &[]).unwrap();
    body.prepare_to_break();
    body.breaking().unwrap()
}

/// Blocks of either kind with some edges and horizon.
fn blocks(cells: [i32; 3], edges: SolidEdges, horizon_ratio: f64) -> Vec<Box<dyn BreakingModel<3>>> {
    let mut all = vec![block(cells, BondSolidParameters { edges, horizon_ratio, ..BONDS })];
    // Families do not break where tetrahedra complete them.
    if edges != SolidEdges::Overlay {
        for poisson_ratio in [0.4, 0.1] {
            all.push(block(cells, StateSolidParameters { edges, horizon_ratio, poisson_ratio, ..STATE }));
        }
    }
    all
}

/// A block of three layers, of two materials.
fn layered(cells: [i32; 3], horizon_ratio: f64) -> Box<dyn BreakingModel<3>> {
    let lattice = SquareLattice::cuboid(SPACING, [0.0; 3], cells);
    let is_middle = |p: usize| (1.0..2.0).contains(&lattice.position(p)[2]);
    let factors = (0..lattice.points()).map(|p| if is_middle(p) { 20.0 } else { 1.0 }).collect();
    let parameters = BondSolidParameters { edges: SolidEdges::Border, horizon_ratio, ..BONDS };
    let mut body = Solid::mixed(Arc::new(lattice), Mirrors::NONE, parameters, &[], factors).unwrap();
    body.prepare_to_break();
    body.breaking().unwrap()
}

/// All bonds, whose ratios are those of a uniform growth.
fn all_bonds(model: &dyn BreakingModel<3>) -> Vec<u64> {
    let n = model.points();
    let mut u = vec![0.0; 3 * n];
    for point in 0..n {
        let at = model.position(point);
        (0..3).for_each(|c| u[c * n + point] = at[c]);
    }
    let (critical, mut bonds) = (CriticalStretch::new(vec![1.0; 1000]), Vec::new());
    model.for_each_ratio(&u, &critical, &mut |bond, _| bonds.push(bond));
    bonds
}

fn energy(terms: &[Box<dyn Term<3>>], u: &[f64]) -> f64 {
    terms.iter().map(|term| term.survey(u).energy).sum()
}

fn forces(terms: &[Box<dyn Term<3>>], u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    terms.iter().for_each(|term| term.add_force(u, &mut force));
    force
}

#[test]
fn bonds_across_a_plane_have_the_energy_that_the_formula_counts() {
    // Of planes (100), (110) and (111): the in-plane vectors of a patch, and twice the place of the plane between two layers.
    let planes: [(Cell, [Cell; 2]); 3] = [
        ([1, 0, 0], [[0, 1, 0], [0, 0, 1]]),
        ([1, 1, 0], [[1, -1, 0], [0, 0, 1]]),
        ([1, 1, 1], [[1, -1, 0], [0, 1, -1]]),
    ];
    for horizon_ratio in [2.0, 3.0] {
        let parameters = BondSolidParameters { horizon_ratio, edges: SolidEdges::Border, ..BONDS };
        let model = block([14, 14, 14], parameters);
        let n = model.points();
        let stretch = 1e-3;
        let mut u = vec![0.0; 3 * n];
        for point in 0..n {
            let at = model.position(point);
            (0..3).for_each(|c| u[c * n + point] = stretch * at[c]);
        }
        let (lattice, _) = model.lattice().unwrap();
        let middle: Cell = [6, 6, 6];
        let bonds = all_bonds(&*model);
        for (normal, patch) in planes {
            let dot = |a: Cell, b: [f64; 3]| (0..3).map(|k| f64::from(a[k]) * b[k]).sum::<f64>();
            let length = dot(normal, normal.map(f64::from)).sqrt();
            let level = dot(normal, middle.map(f64::from)) + 0.5;
            // Coordinates of a place in the plane by the two vectors of the patch.
            let inside = |place: [f64; 3]| {
                let from = [0, 1, 2].map(|k| place[k] - f64::from(middle[k]) + 1e-3);
                let gram = |a: Cell, b: Cell| dot(a, b.map(f64::from));
                let [p, q] = patch;
                let determinant = gram(p, p) * gram(q, q) - gram(p, q) * gram(p, q);
                let along = [
                    (gram(q, q) * dot(p, from) - gram(p, q) * dot(q, from)) / determinant,
                    (gram(p, p) * dot(q, from) - gram(p, q) * dot(p, from)) / determinant,
                ];
                along.iter().all(|a| (0.0..1.0).contains(a))
            };
            let crossing = |bond: &&u64| {
                let [a, b] = model.ends(**bond).map(|p| lattice.cell(p).map(f64::from));
                let [below, above] = [dot(normal, a) - level, dot(normal, b) - level];
                let at = below / (below - above);
                below * above < 0.0 && inside([0, 1, 2].map(|k| a[k] + at * (b[k] - a[k])))
            };
            let crossing: Vec<u64> = bonds.iter().filter(crossing).copied().collect();
            let [p, q] = patch;
            let area =
                ((gram_of(p, p) * gram_of(q, q) - gram_of(p, q).pow(2)) as f64).sqrt() * SPACING.powi(2);
            let counted = energy(&model.part(&crossing), &u) / area;
            let unit = normal.map(|k| f64::from(k) / length);
            let found = toughness::critical_stretch(counted, &parameters, SPACING, unit).unwrap();
            assert!((found / stretch - 1.0).abs() < 1e-9, "{horizon_ratio} {normal:?}: {found}");
        }
    }
}

fn gram_of(a: Cell, b: Cell) -> i32 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

#[test]
fn what_is_left_and_what_has_gone_are_the_whole() {
    for edges in [SolidEdges::Border, SolidEdges::Overlay, SolidEdges::None] {
        let models = [2.0, 3.0].into_iter().flat_map(|horizon_ratio| {
            let mut all = blocks([7, 6, 5], edges, horizon_ratio);
            if edges == SolidEdges::Border {
                all.push(layered([7, 6, 6], horizon_ratio));
            }
            all
        });
        for mut model in models {
            let n = model.points();
            let u: Vec<f64> =
                (0..3 * n).map(|k| ((37 * k * k + 11 * k) % 101) as f64 / 101.0 - 0.5).collect();
            let (before, pulled) = (energy(&model.terms(), &u), forces(&model.terms(), &u));
            let all = all_bonds(&*model);
            let (mut gone, mut unloaded) = (0.0, vec![0.0; 3 * n]);
            // One after the other, those on the border among them.
            let scattered: Vec<u64> = all.iter().step_by(17).copied().collect();
            for bonds in [&all[40..60], &all[all.len() - 30..], &all[300..303], &scattered[..]] {
                let there: HashSet<u64> = all_bonds(&*model).into_iter().collect();
                let bonds: Vec<u64> = bonds.iter().filter(|bond| there.contains(bond)).copied().collect();
                let part = model.part(&bonds);
                gone += energy(&part, &u);
                unloaded.iter_mut().zip(forces(&part, &u)).for_each(|(sum, f)| *sum += f);
                model.break_bonds(&bonds);
            }
            let (after, pulls) = (energy(&model.terms(), &u), forces(&model.terms(), &u));
            assert!((before - gone - after).abs() < 1e-12 * before, "{edges:?}: {before} {gone} {after}");
            assert!(gone > 1e-3 * before);
            for k in 0..3 * n {
                assert!((pulled[k] - unloaded[k] - pulls[k]).abs() < 1e-12 * before, "{edges:?} {k}");
            }
            // The matrix is that of the forces.
            let system = System::new(&*model, Vec::new(), Vec::new()).unwrap();
            let (mut product, mut force) = (vec![0.0; 3 * n], vec![0.0; 3 * n]);
            let matrix = system.assemble_sparse();
            for (value, (row, column)) in &matrix {
                product[row] += value * u[column];
                if row != column {
                    product[column] += value * u[row];
                }
            }
            system.force(&u, &mut force);
            for k in 0..3 * n {
                assert!((product[k] - force[k]).abs() < 1e-11 * before, "{edges:?} {k}");
            }
        }
    }
}

#[test]
fn a_cut_through_leaves_two_parts() {
    let edges = [SolidEdges::Border, SolidEdges::Overlay, SolidEdges::None];
    for (edges, mut model) in
        edges.into_iter().flat_map(|edges| blocks([6, 4, 4], edges, 2.0).into_iter().map(move |b| (edges, b)))
    {
        let n = model.points();
        let bonds: Vec<u64> = all_bonds(&*model)
            .into_iter()
            .filter(|&bond| {
                let [a, b] = model.ends(bond).map(|p| model.position(p)[0]);
                (a < 3.0 * SPACING) != (b < 3.0 * SPACING)
            })
            .collect();
        model.break_bonds(&bonds);
        assert_eq!(model.connected().spans().len(), 2, "{edges:?}");
        // They move apart for nothing.
        let mut u = vec![0.0; 3 * n];
        (0..n).filter(|&p| model.position(p)[0] > 3.0 * SPACING).for_each(|p| u[p] = 1.0);
        assert!(energy(&model.terms(), &u) < 1e-28, "{edges:?}");
        let damage = model.damage();
        let most = damage.iter().fold(0.0, |a: f64, b| a.max(*b));
        assert!(most > 0.3 && most < 0.7, "{most}");
    }
}

/// Ratios of all bonds of a body that grows uniformly, by their numbers.
fn ratios(model: &Solid<BondSolidParameters>, critical: &CriticalStretch) -> BTreeMap<u64, f64> {
    let n = model.points();
    let mut u = vec![0.0; 3 * n];
    for point in 0..n {
        let at = model.position(point);
        (0..3).for_each(|c| u[c * n + point] = 1e-3 * at[c]);
    }
    let mut found = BTreeMap::new();
    Breakable::for_each_ratio(model, &u, critical, &mut |bond, ratio| _ = found.insert(bond, ratio));
    found
}

#[test]
fn bonds_on_the_border_are_of_what_they_pass() {
    for horizon_ratio in [2.0, 3.0] {
        let parameters = BondSolidParameters { edges: SolidEdges::Border, horizon_ratio, ..BONDS };
        let lattice = Arc::new(SquareLattice::cuboid(SPACING, [0.0; 3], [6, 6, 12]));
        let is_upper: Vec<bool> = (0..lattice.points()).map(|p| lattice.cell(p)[2] >= 6).collect();
        let of = |moduli: Vec<f64>| {
            let mut model = Solid::mixed(lattice.clone(), Mirrors::NONE, parameters, &[], moduli).unwrap();
            model.prepare_to_break();
            model
        };
        let tough = |own: Toughness, modulus: f64, between: Option<Toughness>| {
            CriticalStretch::new(vec![1.0; 500]).of_materials(ToughMaterials {
                numbers: is_upper.iter().map(|upper| u32::from(*upper)).collect(),
                moduli: vec![modulus; is_upper.len()],
                own: vec![own; 2],
                interfaces: vec![None, between],
                crossing: toughness::crossing_bonds(&parameters).unwrap(),
            })
        };
        let plain = of(vec![1.0; is_upper.len()]);
        let usual = ratios(&plain, &CriticalStretch::new(vec![1.0; 500]));
        // At the same energy bonds of four times the modulus break at half the stretch.
        let stiff = ratios(&of(vec![4.0; is_upper.len()]), &tough(Toughness::Energy(1.0), 4.0, None));
        assert!(usual.len() == stiff.len() && usual.len() > 1000, "{} {}", usual.len(), stiff.len());
        assert!(usual.iter().all(|(bond, ratio)| (stiff[bond] / ratio - 2.0).abs() < 1e-9));
        // An interface at which they break at half the stretch is that of those alone that pass it.
        let weak = ratios(&plain, &tough(Toughness::Stretch(1.0), 1.0, Some(Toughness::Stretch(0.5))));
        let (border, whole) = (plain.body.border.as_ref().unwrap(), plain.body.whole_bonds());
        let (mut passing, mut beside) = (0, 0);
        border.bonds.for_each_measured(&vec![0.0; 3 * plain.points()], |bond, kind, _| {
            let offset = plain.body.law.neighbourhood.offsets[border.wholes[kind].offset];
            let Some(ratio) = weak.get(&((whole + bond) as u64)) else { return };
            let times = ratio / usual[&((whole + bond) as u64)];
            let is_weak = (times - 2.0).abs() < 1e-9;
            assert!(is_weak || (times - 1.0).abs() < 1e-9, "{times}");
            let own = plain.body.own_end(bond).map(|own| lattice.cell(own as usize)[2]);
            match own {
                Some(layer) if offset[2] == 0 || !(4..8).contains(&layer) => {
                    // Along the layers, or farther from the interface than it reaches.
                    beside += usize::from((5..7).contains(&layer));
                    assert!(!is_weak || offset[2].abs() > 2, "{offset:?} {layer}");
                }
                _ => passing += usize::from(is_weak),
            }
        });
        // Over two spacings they leave the body before the next layer.
        assert!(beside > 100 && (passing > 0) == (horizon_ratio == 3.0), "{passing} {beside}");
    }
}
