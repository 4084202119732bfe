use super::*;
use crate::plane::{Plane, random};

/// Entries of the factor, one unknown per point: columns by following the elimination tree (Liu).
fn fill(graph: &PointGraph, order: &[usize]) -> usize {
    let n = order.len();
    let mut place = vec![0; n];
    order.iter().enumerate().for_each(|(k, p)| place[*p] = k);
    let (mut parent, mut seen, mut entries) = (vec![n; n], vec![n; n], n);
    for k in 0..n {
        seen[k] = k;
        for q in graph.neighbours(order[k]) {
            let mut i = place[*q as usize];
            while i < k && seen[i] != k {
                if parent[i] == n {
                    parent[i] = k;
                }
                entries += 1;
                seen[i] = k;
                i = parent[i];
            }
        }
    }
    entries
}

#[test]
fn every_point_comes_once_and_the_halves_are_not_coupled() {
    for (name, plane) in Plane::gallery() {
        let graph = plane.graph();
        let dissection = nested_dissection(&plane.positions, &graph);
        let mut sorted = dissection.order().to_vec();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..plane.positions.len()).collect::<Vec<_>>(), "{name}");
        let [first, second] = dissection.halves();
        let mut half = vec![2; sorted.len()];
        dissection.order()[..first].iter().for_each(|p| half[*p] = 0);
        dissection.order()[first..first + second].iter().for_each(|p| half[*p] = 1);
        assert!(plane.pairs.iter().all(|[p, q]| half[*p] + half[*q] != 1), "{name}");
    }
}

#[test]
fn halves_are_even_and_a_cut_makes_the_separator_thinner() {
    let gallery = Plane::gallery();
    let separator = |name: &str| {
        let (_, plane) = gallery.iter().find(|(own, _)| *own == name).unwrap();
        let dissection = nested_dissection(&plane.positions, &plane.graph());
        let [first, second] = dissection.halves();
        assert!(first.abs_diff(second) as f64 <= 0.2 * (first + second) as f64, "{name}: {first} {second}");
        plane.positions.len() - first - second
    };
    // Three columns of 30 points; a line across the plate is 30 rows long whatever its slope.
    let whole = separator("plate");
    assert!((80..=96).contains(&whole), "{whole}");
    assert!(separator("hole") < whole);
    assert!(separator("slit") < whole);
}

#[test]
fn a_square_lattice_fills_no_more_than_with_metis() {
    // METIS (pymetis 2025.2.2, nested_dissection) leaves 392607 entries; measured here 378788.
    let plane = Plane::new(Plane::lattice(60, |_| true), 3.0, |_, _| true);
    let graph = plane.graph();
    let entries = fill(&graph, nested_dissection(&plane.positions, &graph).order());
    assert!(entries <= 392_607, "{entries}");
}

#[test]
fn postorder_changes_the_order_but_not_the_fill() {
    let (_, plane) = Plane::gallery().swap_remove(1);
    let graph = plane.graph();
    let mut order: Vec<u32> = (0..graph.points() as u32).collect();
    let count = |order: &[u32]| fill(&graph, &order.iter().map(|p| *p as usize).collect::<Vec<_>>());
    order.sort_by_key(|p| p * 7919 % 1009);
    let before = (order.clone(), count(&order));
    tree::postorder(&graph, &mut order, graph.points());
    assert_ne!(order, before.0);
    assert_eq!(count(&order), before.1);
}

fn by_minimum_degree(nodes: usize, inner: usize, pairs: &[[u32; 2]]) -> Vec<u32> {
    let mut state = MinimumDegree::default();
    state.begin(nodes);
    for k in 0..nodes as u32 {
        for pair in pairs.iter().filter(|pair| pair.contains(&k)) {
            let other = pair[usize::from(pair[0] == k)];
            if (k.min(other) as usize) < inner {
                state.neighbour(other);
            }
        }
        state.close();
    }
    let mut order = Vec::new();
    state.order(inner, |node| order.push(node));
    order
}

#[test]
fn minimum_degree_of_a_tree_fills_nothing() {
    let mut next = random(3);
    let pairs: Vec<[u32; 2]> = (1..200).map(|k| [k, (next() * f64::from(k)) as u32]).collect();
    let order: Vec<usize> = by_minimum_degree(200, 200, &pairs).iter().map(|k| *k as usize).collect();
    let positions = vec![[0.0; 2]; 200];
    let tree = Plane { positions, pairs: pairs.iter().map(|[a, b]| [*a as usize, *b as usize]).collect() };
    assert_eq!(fill(&tree.graph(), &order), 200 + 199);
}

#[test]
fn the_rim_counts_but_is_not_ordered() {
    // A row 0-1-2-3, of which 0 touches a rim of three nodes: without them 0 would be among the first.
    let pairs = [[0, 1], [1, 2], [2, 3], [0, 4], [0, 5], [0, 6]];
    assert_eq!(by_minimum_degree(7, 4, &pairs), [3, 2, 1, 0]);
}
