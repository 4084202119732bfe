//! Whether a scene fits into memory, before it is built.

use super::place::{Layout, LayoutLine};
use super::section::Resolved;
use super::{frame, root};
use crate::diagnostic::Faults;
use crate::memory;
use peristat_assembly::model::timoshenko_beam::BeamBond;
use peristat_assembly::stiffness::Bond;

/// Largest number of bonds that are each their own: they are all kept.
const MOST_BONDS: usize = 50_000_000;

/// Adds a fault if bonds that are each their own, on graded grids or varying sections, are too many to keep or take more
/// memory than may be used: they are all made with the scene.
pub(super) fn check(layout: &Layout, sections: &[Resolved], max_memory: Option<u64>, faults: &mut Faults) {
    let bonds = |line: &LayoutLine| line.cells.saturating_mul(line.horizon_ratio.ceil() as usize);
    let special = || layout.lines.iter().zip(sections).enumerate().filter(|(_, line)| is_special(*line));
    let all = special().fold(0, |sum: usize, (_, (line, _))| sum.saturating_add(bonds(line)));
    let Some((k, _)) = special().max_by_key(|(_, (line, _))| bonds(line)) else { return };
    let path = match (&layout.frame, layout.lines.len()) {
        (Some(_), _) => frame::path().key("members").index(k),
        (None, 1) => root("body").key("line"),
        (None, _) => root("body").key("lines").index(k),
    };
    if all > MOST_BONDS {
        faults
            .error(path.key("cells"), format!("{all} bonds that all differ are too many to keep"))
            .hint(format!("on a graded grid or a varying section `cells` times `horizon_ratio` is at most {MOST_BONDS}, over all lines"));
        return;
    }
    let needed = (all * (size_of::<BeamBond>() + size_of::<Bond<2, 2>>())) as u64;
    if let Some(allowed) = memory::allowed(max_memory).filter(|&allowed| needed > allowed) {
        let [needed, allowed] = [needed, allowed].map(memory::words);
        faults
            .error(
                path.key("cells"),
                format!("about {needed} of memory would be needed for {all} bonds that all differ, {allowed} may be used"),
            )
            .for_lack_of_memory()
            .hint("use fewer cells or a shorter horizon, or raise `--max-memory`");
    }
}

/// Whether the bonds of a line differ from each other.
pub(super) fn is_special((line, section): (&LayoutLine, &Resolved)) -> bool {
    line.stations.is_some() || section.peculiarity().is_some()
}
