//! Borders that cut cells, held on their line.
//!
//! A held border takes the traction of the body on it. What is held are means of its displacement over short pieces, one by
//! every point beside it: together they are as many as the points, and a uniform traction is a sum of their forces, so that a
//! uniform stress goes into the support undisturbed.

use crate::scene::body::site::boundary::{Sample, Stretch};
use peristat_assembly::body::{SquareLattice, in_space, plus};
use peristat_assembly::model::BodyModel;
use std::collections::BTreeMap;

/// Points and their shares in the displacement of a piece of a border; they sum to one.
pub(crate) type Piece = Vec<(u32, f64)>;

/// Pieces shorter than this part of the spacing go to the points beside theirs.
const LEAST: f64 = 0.4;

/// How far behind a border its points are, spacings, at most.
const BEHIND: i32 = 2;

/// The piece of a border by each of some points of a model, none for points that have nothing of it; none at all where the
/// points beside the border, in rows along it, tell how it moves, or nothing does.
pub(crate) fn pieces(stretches: &[Stretch], points: &[u32], model: &dyn BodyModel) -> Option<Vec<Piece>> {
    let (lattice, _) = model.lattice().filter(|_| model.follows_border())?;
    let shares = model.border_shares()?;
    let parts = stretches.iter().flat_map(|stretch| stretch.between_lines(lattice));
    let samples: Vec<Sample> = parts.flat_map(|part| part.samples().collect::<Vec<_>>()).collect();
    let moved: Vec<Vec<(usize, f64)>> =
        samples.iter().map(|s| shares(in_space(s.at), in_space(s.normal))).collect::<Option<_>>()?;
    // Beside rows that run along it a place moves with two points of either of two rows.
    if moved.iter().all(|shares| shares.len() <= 4) {
        return None;
    }
    let owned = owned(&samples, points, lattice);
    let of = |point: &u32| {
        let mut sum = BTreeMap::<u32, f64>::new();
        let own = owned.get(point).map_or(&[][..], |own| own);
        let length: f64 = own.iter().map(|&k| samples[k].length).sum();
        for &k in own {
            let part = samples[k].length / length;
            moved[k].iter().for_each(|&(p, share)| *sum.entry(p as u32).or_default() += part * share);
        }
        // The point itself first: it becomes the dependent one.
        let mut piece: Piece = sum.into_iter().collect();
        piece.sort_by_key(|&(p, _)| p != *point);
        piece
    };
    Some(points.iter().map(of).collect())
}

/// The samples of a border that are nearest to each of some points; points that would have too little have none.
fn owned(samples: &[Sample], points: &[u32], lattice: &SquareLattice) -> BTreeMap<u32, Vec<usize>> {
    let mut owned: BTreeMap<u32, Vec<usize>> = points.iter().map(|&p| (p, Vec::new())).collect();
    let mut homeless: Vec<usize> = (0..samples.len()).collect();
    loop {
        for k in homeless {
            if let Some(list) = nearest(samples[k].at, &owned, lattice).and_then(|p| owned.get_mut(&p)) {
                list.push(k);
            }
        }
        let length = |own: &[usize]| own.iter().map(|&k| samples[k].length).sum::<f64>();
        let lengths = owned.iter().map(|(&point, own)| (point, length(own)));
        let shortest = lengths.min_by(|a, b| a.1.total_cmp(&b.1));
        match shortest.filter(|s| s.1 < LEAST * lattice.spacing() && owned.len() > 1) {
            Some((point, _)) => homeless = owned.remove(&point).unwrap_or_default(),
            None => return owned,
        }
    }
}

/// The nearest of some points to a position.
fn nearest<T>(at: [f64; 2], among: &BTreeMap<u32, T>, lattice: &SquareLattice) -> Option<u32> {
    let distance = |point: &u32| {
        let [x, y] = lattice.place(*point as usize);
        (x - at[0]).hypot(y - at[1])
    };
    let cell = lattice.cell_at(at);
    let around = (-BEHIND..=BEHIND).flat_map(|b| (-BEHIND..=BEHIND).map(move |a| plus(cell, [a, b, 0])));
    let near = around.filter_map(|cell| Some(lattice.number(cell)? as u32)).filter(|p| among.contains_key(p));
    let by = |a: &u32, b: &u32| distance(a).total_cmp(&distance(b));
    near.min_by(by).or_else(|| among.keys().copied().min_by(by))
}
