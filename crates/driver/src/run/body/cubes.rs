//! A solid as cubes with one stencil.

use super::levels::{COARSEST_SOLID, is_narrow};
use crate::scene::body::Conditions;
use peristat_assembly::bonds::Mat;
use peristat_assembly::cubic::{CubicFaces, CubicLevels, CubicSolid, Follower, Stencil};
use peristat_assembly::model::plane::Solvable;
use peristat_assembly::model::solid::SolidEdges;
use peristat_assembly::system::System;

/// How much stiffer than a point a direction is that a support holds which lies along no axis.
const STIFF: f64 = 100.0;

/// Its levels; none of other bodies, or where supports or rigid regions that are free to move join points with each other: cubes
/// that rest below a region tell nothing of how it moves.
pub(super) fn levels<const D: usize>(
    model: &dyn Solvable<D>,
    conditions: &Conditions,
    system: &System<D>,
) -> Option<CubicLevels> {
    let solid = model.as_solid().filter(|_| model.contrast_of_points() == 1.0)?;
    let (lattice, mirrors) = model.lattice()?;
    let stencil = Stencil::new(solid.bonds_of_a_point());
    let points = model.points();
    if conditions.rigid.iter().any(|rigid| rigid.prescribed.contains(&None)) {
        return None;
    }
    let mut images = vec![false; points];
    model.ghosts().iter().for_each(|&ghost| images[ghost as usize] = true);
    let mut springs: Vec<(usize, Mat<3, 3>)> = Vec::new();
    let mut along = |point: usize, direction: [f64; 3], stiffness: f64| {
        springs.push((point, direction.map(|a| direction.map(|b| stiffness * a * b))));
    };
    let (mut held, mut followers): (Vec<(usize, usize)>, Vec<Follower>) = Default::default();
    let stiffness = STIFF * stencil.stiffness();
    for row in system.constraints().rows() {
        let (point, component) = (row.unknown % points, row.unknown / points);
        if images[point] {
            continue;
        }
        if row.masters.is_empty() {
            held.push((point, component));
            continue;
        }
        if row.masters.iter().all(|(master, _)| master % points != point) {
            let leaders =
                row.masters.iter().map(|&(master, share)| ((master % points, master / points), share));
            followers.push(((point, component), leaders.collect()));
            continue;
        }
        let mut direction = [0.0; 3];
        direction[component] = 1.0;
        for &(master, share) in &row.masters {
            if master % points != point {
                return None;
            }
            direction[master / points] -= share;
        }
        let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        along(point, direction.map(|d| d / length), stiffness);
    }
    for spring in &conditions.springs {
        let mut direction = [0.0; 3];
        spring.shares.iter().for_each(|&(component, share)| direction[component] += share);
        along(spring.point, direction, spring.stiffness);
    }
    let faces = match solid.bonds_on_border() {
        Some(bonds) => CubicFaces::Border(bonds),
        None if solid.faces() == SolidEdges::None => CubicFaces::Bare,
        None => CubicFaces::Other,
    };
    let cuts = solid.cut_bonds();
    let solid = CubicSolid { lattice, mirrors, stencil, held, springs, followers, cuts, faces };
    let is_coarsest = |sides: [usize; 3], points: usize| points <= COARSEST_SOLID || is_narrow(sides);
    CubicLevels::new(&solid, &is_coarsest)
}
