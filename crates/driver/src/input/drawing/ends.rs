//! Which ends of strokes meet.

use super::super::ReadError;
use super::strokes::Stroke;
use std::collections::HashMap;

/// The places where ends of strokes meet, with the two strokes that meet there.
pub(super) struct Ends {
    /// The places of both ends of every stroke.
    places: Vec<[usize; 2]>,
    /// The strokes at every place.
    at: Vec<Vec<usize>>,
}

impl Ends {
    /// Ends within a distance meet.
    ///
    /// # Errors
    /// Somewhere one stroke ends alone, or more than two do.
    pub(super) fn new(strokes: &[Stroke], within: f64) -> Result<Self, ReadError> {
        let mut near: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
        let (mut positions, mut at): (Vec<[f64; 2]>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
        let mut places = Vec::new();
        for (k, stroke) in strokes.iter().enumerate() {
            let ends = [stroke.points[0], stroke.points[stroke.points.len() - 1]].map(|end| {
                let cell = end.map(|x| (x / within).floor() as i64);
                let around = (-1..=1).flat_map(|a| (-1..=1).map(move |b| [a, b]));
                let cells = around.map(|[a, b]| [cell[0].saturating_add(a), cell[1].saturating_add(b)]);
                let known = cells.filter_map(|c| near.get(&c)).flatten().copied();
                let is_it = |&p: &usize| {
                    let [x, y]: [f64; 2] = positions[p];
                    (x - end[0]).hypot(y - end[1]) <= within
                };
                let found = known.into_iter().find(is_it);
                let place = found.unwrap_or_else(|| {
                    near.entry(cell).or_default().push(positions.len());
                    positions.push(end);
                    at.push(Vec::new());
                    positions.len() - 1
                });
                at[place].push(k);
                place
            });
            places.push(ends);
        }
        for (strokes_here, [x, y]) in at.iter().zip(&positions) {
            let line = |k: usize| strokes[strokes_here[k]].line;
            match strokes_here.len() {
                2 => {}
                1 => {
                    return Err(ReadError::at(
                        line(0),
                        format!("the outline is open at ({x}, {y}): nothing goes on there"),
                    )
                    .hint(
                        "join the ends of its lines; they meet if they are a millionth of the drawing apart",
                    ));
                }
                count => {
                    return Err(ReadError::at(
                        line(2),
                        format!("{count} lines end at ({x}, {y}), the first one in line {}", line(0)),
                    )
                    .hint(
                        "an outline has two at every corner: remove lines that are no border, or drawn twice",
                    ));
                }
            }
        }
        Ok(Self { places, at })
    }

    /// Strokes in the order in which they follow each other, loop by loop, each with whether it is walked backwards.
    pub(super) fn loops(&self) -> Vec<Vec<(usize, bool)>> {
        let mut is_used = vec![false; self.places.len()];
        let mut loops = Vec::new();
        for first in 0..self.places.len() {
            let (mut k, mut from, mut found) = (first, self.places[first][0], Vec::new());
            while !is_used[k] {
                is_used[k] = true;
                let backwards = self.places[k][0] != from;
                found.push((k, backwards));
                from = self.places[k][usize::from(!backwards)];
                k = self.at[from].iter().copied().find(|other| *other != k).unwrap_or(k);
            }
            if !found.is_empty() {
                loops.push(found);
            }
        }
        loops
    }
}
