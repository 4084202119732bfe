//! What the figures of a page ask of it: scripts that draw them, and a share of its bytes.

use super::block::Block;

/// In the order in which they need each other.
const SCRIPTS: [&str; 10] = [
    include_str!("number.js"),
    include_str!("stage.js"),
    include_str!("field.js"),
    include_str!("chart.js"),
    include_str!("states.js"),
    include_str!("cells.js"),
    include_str!("marks.js"),
    include_str!("map.js"),
    include_str!("picture.js"),
    include_str!("page.js"),
];
/// What pages with solids have besides, before the last one.
const OF_SOLIDS: [&str; 7] = [
    include_str!("camera.js"),
    include_str!("mesh.js"),
    include_str!("gl.js"),
    include_str!("plain.js"),
    include_str!("axes.js"),
    include_str!("turn.js"),
    include_str!("solid.js"),
];

/// Bytes that the fields of all maps of a page may take, each of its last state: a page is to stay below a megabyte, with solids
/// below two, with earlier states below three.
const MAP_BYTES: usize = 760_000;
const SOLID_BYTES: usize = 1_700_000;

/// How many figures with fields a page has.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Figures {
    maps: usize,
    solids: usize,
}

impl Figures {
    /// Counts those among blocks.
    pub(super) fn add(&mut self, blocks: &[Block]) {
        for block in blocks {
            match block {
                Block::Map(_) => self.maps += 1,
                Block::Solid(_) => self.solids += 1,
                Block::Choice(_, sets) => sets.iter().for_each(|(_, blocks)| self.add(blocks)),
                _ => {}
            }
        }
    }

    /// Bytes that the fields of each may take.
    pub(super) fn bytes(self) -> usize {
        let all = if self.solids > 0 { SOLID_BYTES } else { MAP_BYTES };
        all / (self.maps + self.solids).max(1)
    }

    /// What draws all figures of the page.
    pub(super) fn scripts(self) -> String {
        let (last, first) = SCRIPTS.split_last().map_or(("", &[][..]), |(last, first)| (*last, first));
        let of_solids = if self.solids > 0 { OF_SOLIDS.concat() } else { String::new() };
        first.concat() + &of_solids + last
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::report::{Map, Solid};

    #[test]
    fn figures_share_the_bytes_and_only_solids_bring_their_scripts() {
        let of = |blocks: &[Block]| {
            let mut figures = Figures::default();
            figures.add(blocks);
            figures
        };
        let map = Block::Map(Map::default());
        let maps = of(&[map.clone(), Block::Choice("s".into(), vec![("a".into(), vec![map])])]);
        assert_eq!(maps.bytes(), MAP_BYTES / 2);
        assert!(!maps.scripts().contains("webgl2"));
        let solid = of(&[Block::Solid(Solid::default())]);
        assert_eq!(solid.bytes(), SOLID_BYTES);
        assert!(solid.scripts().contains("webgl2"));
    }
}
