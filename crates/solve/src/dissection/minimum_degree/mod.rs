//! Approximate minimum degree of a small graph with a rim that is eliminated later.

mod eliminate;

/// Nothing; also the end of a list.
const NONE: u32 = u32::MAX;

/// Orders part of a graph by approximate minimum degree (Amestoy, Davis and Duff 1996) on the quotient graph:
/// supervariables, mass elimination, aggressive absorption.
///
/// The first `inner` nodes are ordered; the others, the rim, are never eliminated but count in the degrees, which is
/// what makes the order good inside the larger graph (Pellegrini, Roman and Amestoy 2000). All arrays are kept for the
/// next graph.
#[derive(Debug, Default)]
pub(super) struct MinimumDegree {
    /// Lists one after another: of a variable its elements and then its variables, of an element its variables.
    lists: Vec<u32>,
    start: Vec<usize>,
    /// Length of the list of a node.
    length: Vec<u32>,
    /// How many of the list of a variable are elements.
    elements: Vec<u32>,
    /// Nodes that a variable stands for; 0 if it is merged or eliminated; negative while in the pivot's element.
    weight: Vec<i32>,
    /// Bound of the degree of a variable; weight of the variables of an element.
    degree: Vec<u32>,
    /// Weight of the variables of an element that are not in the pivot's, where `mark` is the stamp.
    outside: Vec<u32>,
    /// Whether the node is an element that no other has absorbed.
    live: Vec<bool>,
    /// The next and the last of the nodes that a variable stands for.
    chain: Vec<u32>,
    tail: Vec<u32>,
    mark: Vec<u32>,
    stamp: u32,
    /// Nodes below this are ordered, the others form the rim.
    inner: u32,
    /// Variables to eliminate by degree, in lists linked both ways.
    head: Vec<u32>,
    next: Vec<u32>,
    previous: Vec<u32>,
    /// Variables of the pivot's element by the sum of their lists.
    hashed: Vec<(u64, u32)>,
}

impl MinimumDegree {
    /// Begins a graph of `nodes` nodes; then [`neighbour`](Self::neighbour) and [`close`](Self::close) list them.
    pub(super) fn begin(&mut self, nodes: usize) {
        self.lists.clear();
        self.start.clear();
        self.length.clear();
        for (array, value) in [
            (&mut self.elements, 0),
            (&mut self.degree, 0),
            (&mut self.chain, NONE),
            (&mut self.next, NONE),
            (&mut self.previous, NONE),
            (&mut self.mark, 0),
            (&mut self.outside, 0),
        ] {
            array.clear();
            array.resize(nodes, value);
        }
        self.head.clear();
        self.head.resize(nodes + 1, NONE);
        self.tail.clear();
        self.tail.extend(0..nodes as u32);
        self.weight.clear();
        self.weight.resize(nodes, 1);
        self.live.clear();
        self.live.resize(nodes, false);
        self.stamp = 0;
    }

    /// One more neighbour of the node that is being listed.
    pub(super) fn neighbour(&mut self, node: u32) {
        self.lists.push(node);
    }

    /// Ends the list of a node; the next one follows.
    pub(super) fn close(&mut self) {
        let start = self.start.last().map_or(0, |start| start + self.length[self.length.len() - 1] as usize);
        self.length.push((self.lists.len() - start) as u32);
        self.start.push(start);
    }

    /// Hands the first `inner` nodes to `emit` in the order found.
    pub(super) fn order(&mut self, inner: usize, mut emit: impl FnMut(u32)) {
        self.inner = inner as u32;
        for i in 0..inner {
            self.degree[i] = self.length[i];
            self.insert(i as u32);
        }
        let (mut left, mut lowest) = (inner as i32, 0);
        while left > 0 {
            while self.head[lowest] == NONE {
                lowest += 1;
            }
            let pivot = self.head[lowest];
            self.remove(pivot);
            left -= self.gather(pivot);
            self.emit_chain(pivot, &mut emit);
            self.measure(pivot);
            left -= self.shorten(pivot, &mut emit);
            self.merge();
            lowest = lowest.min(self.finish(pivot));
        }
    }

    fn emit_chain(&self, variable: u32, emit: &mut impl FnMut(u32)) {
        let mut node = variable;
        while node != NONE {
            emit(node);
            node = self.chain[node as usize];
        }
    }

    fn range(&self, node: u32) -> std::ops::Range<usize> {
        let start = self.start[node as usize];
        start..start + self.length[node as usize] as usize
    }

    fn insert(&mut self, variable: u32) {
        let (i, degree) = (variable as usize, self.degree[variable as usize] as usize);
        let first = std::mem::replace(&mut self.head[degree], variable);
        (self.previous[i], self.next[i]) = (NONE, first);
        if first != NONE {
            self.previous[first as usize] = variable;
        }
    }

    fn remove(&mut self, variable: u32) {
        let i = variable as usize;
        let (before, after) = (self.previous[i], self.next[i]);
        match before {
            NONE => self.head[self.degree[i] as usize] = after,
            before => self.next[before as usize] = after,
        }
        if after != NONE {
            self.previous[after as usize] = before;
        }
    }
}
