//! Making bonds between points and nodes.

use super::super::Place;
use super::stretches::Stretches;
use super::{NodedBonds, NodedKind};
use std::collections::HashMap;

/// Bonds that are found one by one, and their nodes.
#[derive(Clone, Debug)]
pub struct NodedBondsBuilder<const D: usize, const M: usize> {
    points: usize,
    nodes: Vec<Place>,
    kinds: Vec<NodedKind<D, M>>,
    /// Per kind: what each of its bonds hangs on, end by end: a point, or nodes.
    hung: Vec<Vec<u32>>,
}

impl<const D: usize, const M: usize> NodedBondsBuilder<D, M> {
    /// No bonds yet, of a body of `points` points.
    pub fn new(points: usize) -> Self {
        Self { points, nodes: Vec::new(), kinds: Vec::new(), hung: Vec::new() }
    }

    /// Adds a node; returns its number.
    pub fn add_node(&mut self, place: Place) -> u32 {
        self.nodes.push(place);
        self.nodes.len() as u32 - 1
    }

    /// Adds a kind; returns its number.
    pub fn add_kind(&mut self, kind: NodedKind<D, M>) -> usize {
        self.kinds.push(kind);
        self.hung.push(Vec::new());
        self.kinds.len() - 1
    }

    /// Adds a bond of a kind: the points or nodes at its first end, then those at the other.
    pub fn push(&mut self, kind: usize, hung: impl IntoIterator<Item = u32>) {
        self.hung[kind].extend(hung);
    }

    /// The bonds, in the order of their kinds and of what they hang on.
    pub fn build(self) -> NodedBonds<D, M> {
        let Self { points, nodes, kinds, hung } = self;
        // Nodes that move alike with neighbouring points follow each other: those of each side of the body by themselves.
        let mut order: Vec<u32> = (0..nodes.len() as u32).collect();
        order.sort_by(|a, b| {
            let shares = |node: &u32| nodes[*node as usize].iter().map(|of| of.1.to_bits());
            let points = |node: &u32| nodes[*node as usize].iter().map(|of| of.0);
            shares(a).cmp(shares(b)).then_with(|| points(a).cmp(points(b)))
        });
        let mut number = vec![0; nodes.len()];
        order.iter().enumerate().for_each(|(k, node)| number[*node as usize] = k as u32);
        let (node_shares, node_stretches) = place_stretches(&nodes, &order);
        let mut stretches = Stretches::default();
        for (kind, (of, mut hung)) in kinds.iter().zip(hung).enumerate() {
            let (first, width) = (of.width(0), of.width(0) + of.width(1));
            let is_node = |k: usize| !of.shares[usize::from(k >= first)].is_empty();
            hung.iter_mut()
                .enumerate()
                .filter(|(k, _)| is_node(k % width))
                .for_each(|(_, id)| *id = number[*id as usize]);
            let mut bonds: Vec<&[u32]> = hung.chunks_exact(width).collect();
            // Those of one end follow each other as their points do.
            let end = if of.shares[0].is_empty() { 0 } else { first };
            bonds.sort_by(|a, b| a[end..].cmp(&b[end..]));
            stretches.add(kind, width, &bonds.concat());
        }
        stretches.shrink();
        NodedBonds::new(points, (node_shares, node_stretches), (kinds, stretches), nodes.len())
    }
}

/// The kinds of nodes, by their shares, and the nodes: their own number, then their points.
fn place_stretches(nodes: &[Place], order: &[u32]) -> (Vec<Vec<f64>>, Stretches) {
    let mut known: HashMap<Vec<u64>, usize> = HashMap::new();
    let (mut shares, mut lists): (Vec<Vec<f64>>, Vec<Vec<u32>>) = (Vec::new(), Vec::new());
    for (number, node) in order.iter().enumerate() {
        let place = &nodes[*node as usize];
        let kind = *known.entry(place.iter().map(|of| of.1.to_bits()).collect()).or_insert_with(|| {
            shares.push(place.iter().map(|of| of.1).collect());
            lists.push(Vec::new());
            shares.len() - 1
        });
        lists[kind].push(number as u32);
        lists[kind].extend(place.iter().map(|of| of.0));
    }
    let mut stretches = Stretches::default();
    for (kind, list) in lists.iter().enumerate() {
        stretches.add(kind, shares[kind].len() + 1, list);
    }
    stretches.shrink();
    (shares, stretches)
}
