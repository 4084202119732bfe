//! The part of a dissected factor that a few unknowns need.

use super::part::Part;

/// What a factor eliminates from a right-hand side that is zero beside some unknowns, which is also what a solution of these unknowns
/// alone takes: the blocks on the paths of the elimination tree from them to its root.
#[derive(Clone, Debug)]
pub struct Reach {
    pub(super) parts: [PartReach; 2],
    /// Unknowns of the separator, by their places in it.
    pub(super) separator: Vec<Place>,
    pub(super) unknowns: Vec<usize>,
}

/// The part of a half.
#[derive(Clone, Debug)]
pub(super) struct PartReach {
    /// In the order of elimination.
    pub(super) blocks: Vec<u32>,
    pub(super) places: Vec<Place>,
}

/// The place of an unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// In the half or the separator.
    pub(super) own: u32,
    /// Among the unknowns of the reach.
    pub(super) among: u32,
}

impl Reach {
    pub(super) fn new(order: usize, parts: [&Part; 2], separator: &[u32], unknowns: Vec<usize>) -> Self {
        let mut among = vec![None; order];
        for (k, unknown) in unknowns.iter().enumerate() {
            among[*unknown] = Some(k as u32);
        }
        let places = separator.iter().enumerate();
        Self {
            parts: parts.map(|part| part.reach(&among)),
            separator: places
                .filter_map(|(own, unknown)| {
                    Some(Place { own: own as u32, among: among[*unknown as usize]? })
                })
                .collect(),
            unknowns,
        }
    }

    /// The unknowns, in the order of vectors of them.
    #[must_use]
    pub fn unknowns(&self) -> &[usize] {
        &self.unknowns
    }
}
