//! Points of graded grids.

use crate::case::Grading;
use crate::diagnostic::{Faults, JsonPath, tidy};

/// Largest ratio of two cells of a line.
const MOST: f64 = 1e6;

/// Largest number of cells of a line: all points are kept.
const MOST_CELLS: usize = 50_000_000;

/// Distances of the points from the start of a line; `path` is that of the grading.
pub(super) fn stations(
    grading: &Grading,
    from: f64,
    length: f64,
    cells: usize,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<f64>> {
    if cells > MOST_CELLS {
        faults.error(path.clone(), format!("a graded grid has at most {MOST_CELLS} cells, found {cells}"));
        return None;
    }
    let stations = match grading {
        Grading::Geometric { ratio } => {
            let ratio = allowed(*ratio, &path.key("geometric"), faults)?;
            let last = (cells - 1).max(1) as f64;
            sums(length, (0..cells).map(|k| ratio.powf(k as f64 / last)))
        }
        Grading::BothEnds { ratio } => {
            let ratio = allowed(*ratio, &path.key("both_ends"), faults)?;
            let middle = ((cells - 1) / 2).max(1) as f64;
            let growth = |k: usize| ratio.powf(k.min(cells - 1 - k) as f64 / middle);
            let mut all = sums(length, (0..cells).map(growth));
            // The right half mirrors the left one to the last digit.
            (0..cells.div_ceil(2)).for_each(|k| all[cells - k] = length - all[k]);
            all
        }
        Grading::Positions(positions) => given(positions, from, length, cells, path, faults)?,
    };
    // Positions are what bonds are made of: they must differ where the line lies.
    let same = stations.windows(2).position(|pair| from + pair[1] <= from + pair[0]);
    if let Some(k) = same {
        faults
            .error(
                path.clone(),
                format!("the points {k} and {} have the same position, {}", k + 1, tidy(from + stations[k])),
            )
            .hint("use fewer cells or a grading that is less strong");
    }
    same.is_none().then_some(stations)
}

/// Sums of the lengths of cells, scaled to the length of the line.
fn sums(length: f64, cells: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = 0.0;
    let ends = cells.map(|cell| {
        sum += cell;
        sum
    });
    let mut all: Vec<f64> = std::iter::once(0.0).chain(ends).collect();
    let whole = all.last().copied().unwrap_or(1.0);
    all.iter_mut().for_each(|s| *s *= length / whole);
    if let Some(last) = all.last_mut() {
        *last = length;
    }
    all
}

fn allowed(ratio: f64, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    let fine = (1.0 / MOST..=MOST).contains(&ratio);
    if !fine {
        faults
            .error(path.key("ratio"), format!("`ratio` must be between 1e-6 and 1e6, found {ratio}"))
            .hint("it is the length of one cell over that of another");
    }
    fine.then_some(ratio)
}

fn given(
    positions: &[f64],
    from: f64,
    length: f64,
    cells: usize,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<f64>> {
    let path = path.key("positions");
    if positions.len() != cells + 1 {
        let count = positions.len();
        let mut message = format!("{count} positions make {} cells", count.saturating_sub(1));
        message += &format!(", and `cells` is {cells}");
        faults.error(path, message).hint("the positions of both ends count");
        return None;
    }
    let mut fine = true;
    let end = from + length;
    for (k, name, expected) in [(0, "first", from), (cells, "last", end)] {
        if (positions[k] - expected).abs() > 1e-9 * length {
            faults.error(
                path.index(k),
                format!(
                    "the {name} position must be that of the end of the line, {}, found {}",
                    tidy(expected),
                    positions[k]
                ),
            );
            fine = false;
        }
    }
    if let Some(k) = positions.windows(2).position(|pair| pair[1] <= pair[0]) {
        faults.error(
            path.index(k + 1),
            format!("positions must increase, found {} after {}", positions[k + 1], positions[k]),
        );
        fine = false;
    }
    let mut stations: Vec<f64> = positions.iter().map(|x| x - from).collect();
    (stations[0], stations[cells]) = (0.0, length);
    fine.then_some(stations)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(grading: &Grading, count: usize) -> Vec<f64> {
        let (mut faults, path) = (Faults::default(), JsonPath::default());
        let stations = stations(grading, 0.0, 1.0, count, &path, &mut faults).unwrap();
        assert_eq!((stations[0], stations[count], stations.len()), (0.0, 1.0, count + 1));
        stations.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    #[test]
    fn cells_of_a_geometric_grading_grow_by_one_factor_to_the_ratio() {
        let cells = cells(&Grading::Geometric { ratio: 16.0 }, 5);
        let factors: Vec<f64> = cells.windows(2).map(|pair| pair[1] / pair[0]).collect();
        assert!(factors.iter().all(|f| (f - 2.0).abs() < 1e-13), "{factors:?}");
        assert_eq!(self::cells(&Grading::Geometric { ratio: 5.0 }, 1), [1.0]);
    }

    #[test]
    fn cells_that_grow_from_both_ends_mirror_each_other() {
        let grading = Grading::BothEnds { ratio: 9.0 };
        for count in [1, 2, 5, 6] {
            let cells = cells(&grading, count);
            let mirrored: Vec<f64> = cells.iter().rev().copied().collect();
            assert!(cells.iter().zip(&mirrored).all(|(a, b)| (a - b).abs() < 1e-15), "{cells:?}");
        }
        let cells = cells(&grading, 5);
        assert!((cells[2] / cells[0] - 9.0).abs() < 1e-13 && (cells[1] / cells[0] - 3.0).abs() < 1e-13);
    }
}
