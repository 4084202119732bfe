//! Linear interpolation along lines, from every second station.

use super::LinePlace;
use super::matrix::Matrix;

/// The interpolation from coarse unknowns, and the places of these. Two stations in a row become one, whose unknowns lie
/// halfway between theirs: a line has one where it has an unknown at either.
///
/// An unknown takes three quarters of the coarse one of its own pair and a quarter of that next to it. At an end of a line it
/// is continued linearly; an unknown whose pair has no neighbour takes what its pair has. No coarse unknown is without
/// effect, so that the coarse matrix is as positive definite as the fine one.
pub(super) fn interpolation(places: &[Option<LinePlace>]) -> (Matrix, Vec<LinePlace>) {
    let pair = |place: &LinePlace| LinePlace { station: place.station / 2, ..*place };
    let mut coarse: Vec<LinePlace> = places.iter().flatten().map(pair).collect();
    // By stations, so that those of one station follow each other.
    coarse.sort_unstable();
    coarse.dedup();
    let number = |station: u32, line: u32| {
        coarse.binary_search(&LinePlace { station, line }).ok().map(|number| number as u32)
    };
    let shares = |place: &LinePlace| -> Vec<(u32, f64)> {
        let LinePlace { station: own, line } = pair(place);
        let (below, above) =
            (own.checked_sub(1).and_then(|below| number(below, line)), number(own + 1, line));
        let (near, far) = if place.station.is_multiple_of(2) { (below, above) } else { (above, below) };
        let own = number(own, line).expect("it is that of this unknown");
        match (near, far) {
            (Some(near), _) => vec![(own, 0.75), (near, 0.25)],
            (None, Some(far)) => vec![(own, 1.25), (far, -0.25)],
            (None, None) => vec![(own, 1.0)],
        }
    };
    let rows = places.iter().map(|place| place.as_ref().map_or(vec![], shares));
    (Matrix::from_rows(rows, coarse.len()), coarse)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(stations: &[u32]) -> Vec<Option<LinePlace>> {
        stations.iter().map(|&station| Some(LinePlace { station, line: 7 })).collect()
    }

    #[test]
    fn linear_functions_are_interpolated_exactly() {
        let fine: Vec<u32> = (3..12).collect();
        let (transfer, coarse) = interpolation(&places(&fine));
        assert_eq!(coarse.iter().map(|c| c.station).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
        // A pair of stations 2 J and 2 J + 1 is at 2 J + 1/2.
        let at: Vec<f64> = coarse.iter().map(|c| 2.0 * f64::from(c.station) + 0.5).collect();
        let mut found = vec![0.0; fine.len()];
        transfer.multiply(&at, &mut found);
        fine.iter().zip(found).for_each(|(fine, found)| assert!((f64::from(*fine) - found).abs() < 1e-14));
    }

    #[test]
    fn unknowns_alone_and_at_rest_have_their_rows() {
        let mut all = places(&[0, 5]);
        all.push(None);
        let (transfer, coarse) = interpolation(&all);
        assert_eq!(coarse.len(), 2);
        let mut found = vec![9.0; 3];
        transfer.multiply(&[2.0, 3.0], &mut found);
        assert_eq!(found, [2.0, 3.0, 0.0]);
    }
}
