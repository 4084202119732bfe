//! Elimination trees.

use super::PointGraph;

/// No parent, no child.
const NONE: u32 = u32::MAX;

/// Sorts the first `count` points of an order of elimination so that every point follows the points that depend on it
/// alone at once (post-order of the elimination tree): the fill is the same, but columns of equal structure become
/// adjacent.
pub(super) fn postorder(graph: &PointGraph, order: &mut [u32], count: usize) {
    let parent = parents(graph, order, count);
    let (mut first, mut next) = (vec![NONE; count], vec![NONE; count]);
    for k in (0..count).rev() {
        if parent[k] != NONE {
            next[k] = std::mem::replace(&mut first[parent[k] as usize], k as u32);
        }
    }
    let old = order[..count].to_vec();
    let mut to = 0;
    let mut path = Vec::new();
    for root in (0..count).filter(|k| parent[*k] == NONE) {
        path.push(root as u32);
        while let Some(k) = path.last() {
            let child = first[*k as usize];
            if child == NONE {
                order[to] = old[*k as usize];
                to += 1;
                path.pop();
            } else {
                first[*k as usize] = next[child as usize];
                path.push(child);
            }
        }
    }
}

/// Parents in the elimination tree (Liu) of the first `count` points, counted in the order.
fn parents(graph: &PointGraph, order: &[u32], count: usize) -> Vec<u32> {
    let mut place = vec![NONE; order.len()];
    for (k, p) in order.iter().enumerate() {
        place[*p as usize] = k as u32;
    }
    let (mut parent, mut ancestor) = (vec![NONE; count], vec![NONE; count]);
    for k in 0..count as u32 {
        for q in graph.neighbours(order[k as usize] as usize) {
            let mut i = place[*q as usize];
            while i < k {
                let above = std::mem::replace(&mut ancestor[i as usize], k);
                if above == NONE {
                    parent[i as usize] = k;
                }
                i = above;
            }
        }
    }
    parent
}
