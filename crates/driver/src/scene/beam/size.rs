//! Whether a scene fits into memory, before it is built.

use super::frame_layout;
use super::place::{Layout, LayoutLine};
use super::section::Resolved;
use crate::diagnostic::Faults;
use crate::diagnostic::root;
use crate::memory;
use peristat_assembly::model::timoshenko_beam::{BeamBond, Distributed, PointAction};
use peristat_assembly::stiffness::{Bond, Spring};

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
        (Some(_), _) => frame_layout::path().key("members").index(k),
        (None, 1) => root("body").key("line"),
        (None, _) => root("body").key("lines").index(k),
    };
    if all > MOST_BONDS {
        faults
            .error(path.key("cells"), format!("{all} bonds that all differ are too many to keep"))
            .hint(format!("on a graded grid or a varying section `cells` times `horizon_ratio` is at most {MOST_BONDS}, over all lines"));
        return;
    }
    let needed = (all * (size_of::<BeamBond>() + size_of::<Bond<2, 2>>())) as f64;
    let what = format!("{all} bonds that all differ");
    memory::fits(
        needed,
        (&what, "use fewer cells or a shorter horizon"),
        max_memory,
        path.key("cells"),
        faults,
    );
}

/// Whether the positions of graded cells fit into memory, of which all lines and members have so many.
pub(super) fn check_graded(cells: usize, max_memory: Option<u64>, faults: &mut Faults) -> bool {
    // They are summed up in one list and kept in another one.
    let needed = (2 * size_of::<f64>()) as f64 * cells as f64;
    let what = format!("the positions of {cells} graded cells");
    memory::fits(needed, (&what, "use fewer cells"), max_memory, root("body"), faults)
}

/// Whether so many springs of foundations, one for every point, fit into memory.
pub(super) fn check_springs(springs: f64, max_memory: Option<u64>, faults: &mut Faults) -> bool {
    let needed = size_of::<Spring>() as f64 * springs;
    let what = format!("{springs:.2e} springs of foundations");
    memory::fits(needed, (&what, "use fewer cells"), max_memory, root("foundation"), faults)
}

/// Whether so many lists of values at all points, which baselines are, fit into memory.
pub(super) fn check_baselines(
    lists: usize,
    layout: &Layout,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> bool {
    let points: usize = layout.lines.iter().map(LayoutLine::points).sum();
    let needed = (lists * size_of::<(f64, f64)>()) as f64 * points as f64;
    let what = format!("{lists} baselines at {points} points");
    memory::fits(needed, (&what, "use fewer of them"), max_memory, root("checks"), faults)
}

/// Memory of a load of a state, of whichever kind, bytes.
const PER_LOAD: f64 = (size_of::<Distributed>() + size_of::<PointAction>()) as f64;

/// Whether so many loads of all load steps, or load cases and combinations, fit into memory.
pub(super) fn check_loads(loads: f64, key: &str, max_memory: Option<u64>, faults: &mut Faults) -> bool {
    let what = format!("{loads:e} loads of all steps or combinations");
    memory::fits(PER_LOAD * loads, (&what, "use fewer of them"), max_memory, root(key), faults)
}

/// Whether the bonds of a line differ from each other.
pub(super) fn is_special((line, section): (&LayoutLine, &Resolved)) -> bool {
    line.stations.is_some() || section.peculiarity().is_some()
}
