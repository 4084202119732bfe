use super::super::lattice::minus;
use super::*;

/// Offsets of bonds up to three spacings long in the plane.
fn offsets(reach: i32) -> Vec<Cell> {
    let all = (-reach..=reach).flat_map(|b| (-reach..=reach).map(move |a| [a, b, 0]));
    all.filter(|&[a, b, _]| [b, a] > [0, 0] && a * a + b * b <= reach * reach).collect()
}

fn apart(lattice: &SquareLattice, steps: &[Cell]) -> Vec<[Cell; 2]> {
    let has = |cell: Cell| lattice.number(cell).is_some();
    let chains = Chains { has: &has, is_open: &|_, _| true };
    let all: Vec<usize> = (0..lattice.points()).collect();
    let ends = |(k, lower): (usize, usize)| [lattice.cell(lower), plus(lattice.cell(lower), steps[k])];
    parted_bonds(lattice, &chains, steps, &all)[0].iter().copied().map(ends).collect()
}

#[test]
fn a_slot_parts_bonds_and_its_ends_do_not() {
    // Row 6 lacks columns 5 to 9.
    let lattice = SquareLattice::plane(1.0, [0.0; 2], 0..15, 0..13, |[i, j]| j != 6 || !(5..10).contains(&i));
    let found = apart(&lattice, &offsets(2));
    // Bonds of two spacings across: the outermost ones go round an end with one step more, (4, 5), (4, 6), (4, 7), (5, 7).
    assert_eq!(found, [6, 7, 8].map(|i| [[i, 5, 0], [i, 7, 0]]));
}

#[test]
fn a_diagonal_step_needs_a_cell_beside_it() {
    let joins = |cells: &[Cell], offset: Cell, axes: usize| {
        let has = |cell: Cell| cell == [0; 3] || cell == offset || cells.contains(&cell);
        Chains { has: &has, is_open: &|_, _| true }.join([0; 3], offset, axes)
    };
    assert!(!joins(&[], [1, 1, 0], 2) && joins(&[[1, 0, 0]], [1, 1, 0], 2));
    // A way around is none for next neighbours.
    assert!(!joins(&[[-1, 0, 0], [-1, 1, 0], [0, 2, 0]], [1, 1, 0], 2));
    // In space cells beside each other lead along all axes.
    assert!(!joins(&[[1, 0, 0]], [1; 3], 3) && joins(&[[1, 0, 0], [1, 0, 1]], [1; 3], 3));
}

#[test]
fn single_rows_keep_their_bonds() {
    // A row of one cell between two slots.
    let inside = |[i, j]: [i32; 2]| !(5..10).contains(&i) || (j != 5 && j != 7);
    let lattice = SquareLattice::plane(1.0, [0.0; 2], 0..15, 0..13, inside);
    let has = |cell: Cell| lattice.number(cell).is_some();
    let chains = Chains { has: &has, is_open: &|_, _| true };
    let all: Vec<usize> = (0..lattice.points()).collect();
    let [apart, kept] = parted_bonds(&lattice, &chains, &offsets(2), &all);
    let thin: Vec<Cell> = all.iter().map(|&p| lattice.cell(p)).filter(|c| chains.is_thin(*c, 2)).collect();
    assert_eq!(thin, [5, 6, 7, 8, 9].map(|i| [i, 6, 0]));
    // Columns 6, 7 and 8 of the row to either side.
    assert_eq!((apart.len(), kept.len()), (0, 6));
}

/// What thin parts tell of bodies: blocks of eight cells in solids.
#[test]
fn blocks_of_solids_have_eight_cells() {
    let has = |cell: Cell| cell.iter().all(|k| (0..2).contains(k));
    let chains = Chains { has: &has, is_open: &|_, _| true };
    assert!(!chains.is_thin([0; 3], 3));
    let has = |cell: Cell| cell != [1; 3] && cell.iter().all(|k| (0..2).contains(k));
    let chains = Chains { has: &has, is_open: &|_, _| true };
    assert!(chains.is_thin([0; 3], 3) && !chains.is_thin([0; 3], 2));
}

/// Round holes, centred on a corner of cells and on a point: none loses a bond (the note of the rule has the same for 6, 10
/// and 20 spacings).
#[test]
fn round_holes_lose_no_bond() {
    for (radius, centre) in [6, 10, 20].into_iter().flat_map(|r| [(r, 0.0), (r, 0.5)]) {
        let far = |i: i32| f64::from(i) + 0.5 - centre;
        let out = |[i, j]: [i32; 2]| far(i).hypot(far(j)) > f64::from(radius);
        let n = radius + 8;
        let lattice = SquareLattice::plane(1.0, [0.0; 2], -n..n, -n..n, out);
        for reach in [2, 3] {
            assert!(apart(&lattice, &offsets(reach)).is_empty(), "{radius} {centre} {reach}");
        }
    }
}

/// The search alone, on cells drawn at random, against chains counted with matrices of steps.
#[test]
fn the_stairs_of_a_bond_are_a_chain() {
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / f64::from(1_u32 << 31)
    };
    let steps = offsets(4);
    for _ in 0..40 {
        let cells: Vec<bool> = (0..144).map(|_| random() < 0.8).collect();
        let lattice =
            SquareLattice::plane(1.0, [0.0; 2], 0..12, 0..12, |[i, j]| cells[(12 * j + i) as usize]);
        let has = |cell: Cell| lattice.number(cell).is_some();
        let chains = Chains { has: &has, is_open: &|_, _| true };
        for (point, &step) in (0..lattice.points()).flat_map(|p| steps.iter().map(move |s| (p, s))) {
            let ways = Ways::of(step, 2, SLACK);
            let start = lattice.cell(point);
            if has(plus(start, step)) {
                assert_eq!(chains.joins(start, &ways), chains.search(start, &ways), "{start:?} {step:?}");
                let back = Ways::of(minus([0; 3], step), 2, SLACK);
                assert_eq!(chains.joins(plus(start, step), &back), chains.joins(start, &ways));
            }
        }
    }
}
