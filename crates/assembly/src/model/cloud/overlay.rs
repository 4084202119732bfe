//! Triangles and tetrahedra that give the points of a cloud what they lack.

use super::{Cut, Pair, Place, Sites, moments};
use crate::bonds::Mat;
use crate::stiffness::Family;
use std::array::from_fn;

/// Those are taken that are as good as the best up to this factor.
const AS_GOOD: f64 = 4.0;

/// Triangles or tetrahedra, and the number of points that lack stiffness but have none.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Overlay<const D: usize, const S: usize> {
    pub(super) families: Vec<Family<D, S, D>>,
    pub(super) uncorrected: usize,
}

/// A point with D others.
#[derive(Clone, Copy, Debug)]
struct Candidate<const D: usize> {
    others: [u32; D],
    /// That of [`Place::badness`].
    badness: f64,
}

/// Gives every point what it lacks of the stiffness of the material, Pa, in equal parts by at most one triangle per quadrant
/// around it, or one tetrahedron per octant.
pub(in super::super) fn overlay<const D: usize, const S: usize>(
    sites: &Sites<D>,
    pairs: &[Pair<D>],
    stiffness: &Mat<S, S>,
    cut: &Cut<D>,
) -> Overlay<D, S>
where
    [f64; D]: Place<D, S>,
{
    let mut near: Vec<Vec<(f64, u32)>> = vec![Vec::new(); sites.positions.len()];
    for pair in pairs {
        let [i, j] = pair.points;
        near[i as usize].push((pair.length, j));
        near[j as usize].push((pair.length, i));
    }
    let mut overlay = Overlay::default();
    let moments = moments(pairs, sites);
    for (point, (mut near, moment)) in near.into_iter().zip(moments).enumerate() {
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut chosen = best(sites, point, &near[..near.len().min(<[f64; D]>::NEAREST)]);
        if chosen.is_empty() {
            chosen = best(sites, point, beside(sites, point, &near));
        }
        chosen.retain(|candidate| is_whole(sites, point, candidate, cut));
        overlay.uncorrected += usize::from(chosen.is_empty());
        let share = sites.volume(point) / chosen.len().max(1) as f64;
        let modulus = from_fn(|r| from_fn(|c| (stiffness[r][c] - moment[r][c]) * share));
        overlay.families.extend(chosen.iter().map(|candidate| Family {
            point: point as u32,
            others: candidate.others,
            rows: <[f64; D]>::strain_rows(candidate.others.map(|p| sites.between([point, p as usize]))),
            own: [[0.0; D]; S],
            modulus,
        }));
    }
    overlay
}

/// Whether nothing separates any two corners.
fn is_whole<const D: usize>(sites: &Sites<D>, point: usize, candidate: &Candidate<D>, cut: &Cut<D>) -> bool {
    let corner = |k: usize| sites.positions[if k < D { candidate.others[k] as usize } else { point }];
    !(0..=D).any(|k| (0..k).any(|l| cut(corner(k), corner(l))))
}

/// Where the nearest lie in a line or in a plane: the neighbours that are about as far as the one that makes the best triangle
/// with the nearest, or the best tetrahedron with both. All on the line or the plane are flat with each other, and there may be
/// very many.
fn beside<'a, const D: usize, const S: usize>(
    sites: &Sites<D>,
    point: usize,
    near: &'a [(f64, u32)],
) -> &'a [(f64, u32)]
where
    [f64; D]: Place<D, S>,
{
    let to = |k: usize| sites.between([point, near[k].1 as usize]);
    let (mut corners, mut last) = ([[0.0; D]; D], 0);
    for count in 0..D {
        if count > 0 {
            let with = |k: usize| {
                let mut corners = corners;
                corners[count] = to(k);
                Some((<[f64; D]>::badness(&corners[..=count])?, k))
            };
            let found = (1..near.len()).filter_map(with).min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((_, k)) = found else { return &[] };
            last = k;
        } else if near.is_empty() {
            return &[];
        }
        corners[count] = to(last);
    }
    let nearest = <[f64; D]>::NEAREST;
    &near[last.saturating_sub(nearest)..near.len().min(last + nearest)]
}

/// The best of each quadrant or octant that its centre can lie in, where it is about as good as the best of all.
fn best<const D: usize, const S: usize>(
    sites: &Sites<D>,
    point: usize,
    near: &[(f64, u32)],
) -> Vec<Candidate<D>>
where
    [f64; D]: Place<D, S>,
{
    let to: Vec<[f64; D]> = near.iter().map(|&(_, other)| sites.between([point, other as usize])).collect();
    let mut found: Vec<Option<Candidate<D>>> = vec![None; 1 << D];
    for_each_choice(near.len(), &mut |choice: [usize; D]| {
        let corners = choice.map(|k| to[k]);
        let Some(badness) = <[f64; D]>::badness(&corners) else { return };
        let is_behind = |axis: usize| corners.iter().map(|corner| corner[axis]).sum::<f64>() < 0.0;
        let part: usize = (0..D).map(|axis| usize::from(is_behind(axis)) << axis).sum();
        // By more than rounding: ties go to the nearer points.
        if found[part].is_none_or(|c| badness < c.badness * (1.0 - 1e-9)) {
            found[part] = Some(Candidate { others: choice.map(|k| near[k].1), badness });
        }
    });
    let least = found.iter().flatten().map(|c| c.badness).fold(f64::INFINITY, f64::min);
    found.into_iter().flatten().filter(|c| c.badness <= AS_GOOD * least).collect()
}

/// Visits all choices of D of the first numbers, each in ascending order.
fn for_each_choice<const D: usize>(of: usize, visit: &mut dyn FnMut([usize; D])) {
    let mut choice: [usize; D] = from_fn(|k| k);
    if of < D {
        return;
    }
    loop {
        visit(choice);
        // The last number that can still grow; those behind it follow it.
        let Some(grows) = (0..D).rev().find(|&k| choice[k] < of - D + k) else { return };
        let next = choice[grows] + 1;
        (grows..D).for_each(|k| choice[k] = next + k - grows);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The best of few that are beside the nearest, and the best of all neighbours of a point.
    fn found<const D: usize, const S: usize>(positions: Vec<[f64; D]>, point: usize) -> [Vec<Candidate<D>>; 2]
    where
        [f64; D]: Place<D, S>,
    {
        let sizes = vec![1.0; positions.len()];
        let sites = Sites { positions, sizes, thickness: 1.0 };
        let others = (0..sites.positions.len()).filter(|&p| p != point);
        let mut near: Vec<(f64, u32)> = others.map(|p| (sites.distance([point, p]), p as u32)).collect();
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let nearest = <[f64; D]>::NEAREST;
        assert!(best(&sites, point, &near[..nearest]).is_empty());
        let few = beside(&sites, point, &near);
        assert!(few.is_empty() || few.len() == 2 * nearest, "{}", few.len());
        let worst = |of: &[Candidate<D>]| of.iter().map(|c| c.badness).fold(0.0, f64::max);
        let both = [few, &near].map(|list| best(&sites, point, list));
        assert!(worst(&both[0]) <= 1.5 * worst(&both[1]), "{both:?}");
        both
    }

    #[test]
    fn a_point_of_a_dense_line_finds_its_triangles_beside_the_line() {
        // Two lines of points 0.01 apart, at a distance of 0.3, about the origin.
        let on = |y: f64| (-100..=100).map(move |k| [0.01 * f64::from(k), y]);
        // 1.18 of the worst of all measured.
        let [few, _] = found(on(0.0).chain(on(0.3)).collect(), 100);
        assert_eq!(few.len(), 2);
        // Nothing is beside a line alone.
        assert!(found(on(0.0).collect(), 100)[0].is_empty());
    }

    #[test]
    fn a_point_of_a_dense_plane_finds_its_tetrahedra_beside_the_plane() {
        let on =
            |z: f64| (0..121).map(move |k| [0.1 * f64::from(k % 11 - 5), 0.1 * f64::from(k / 11 - 5), z]);
        let [few, _] = found(on(0.0).chain(on(0.35)).collect(), 60);
        assert!(few.len() >= 2, "{few:?}");
        // Above and below.
        let [few, _] = found(on(0.0).chain(on(0.35)).chain(on(-0.35)).collect(), 60);
        assert!(few.len() >= 4, "{few:?}");
        // A plane alone, and a line.
        assert!(found(on(0.0).collect(), 60)[0].is_empty());
        assert!(found((0..40).map(|k| [0.0, 0.1 * f64::from(k), 0.0]).collect(), 20)[0].is_empty());
    }

    #[test]
    fn choices_are_complete_and_in_order() {
        let mut all = Vec::new();
        for_each_choice(5, &mut |choice: [usize; 3]| all.push(choice));
        assert_eq!((all.len(), all[0], all[1], all[9]), (10, [0, 1, 2], [0, 1, 3], [2, 3, 4]));
        assert!(all.is_sorted() && all.windows(2).all(|w| w[0] != w[1]));
        for_each_choice(1, &mut |_: [usize; 2]| panic!("too few"));
    }
}
