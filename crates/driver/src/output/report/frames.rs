//! The states of a map: all but the last are packed as they come, so that they take little memory and few bytes of the page.

use super::field::{self, Field};
use super::map::{Cells, Map};
use super::pack::Packed;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Bytes that the states before the last one may take.
const MOST_BYTES: usize = 2_100_000;

/// How many times as far as in the state in the middle a body moves only where pieces have come off.
const COME_OFF: f64 = 20.0;

/// A state of a map before the last one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    state: usize,
    name: String,
    /// The fields of the map.
    packed: Vec<Packed>,
}

/// States of a map, collected in their order. Too many are thinned evenly: every second one goes, until they fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frames {
    /// Bytes that a state may take for more than the fewest digits.
    share: usize,
    /// Of states before the last one those are kept whose numbers are multiples of it.
    stride: usize,
    kept: Vec<Frame>,
    bytes: usize,
    /// Smallest and largest values of the fields in all states.
    ranges: Vec<[f64; 2]>,
    /// The factors on displacements of all states that have moved.
    factors: Vec<f64>,
    /// The first states in which sides had come apart, by cell and side.
    grown: BTreeMap<[usize; 2], usize>,
    /// The last state, not packed yet.
    #[serde(skip)]
    last: Option<Map>,
}

impl Default for Frames {
    fn default() -> Self {
        Self::new(None)
    }
}

impl Frames {
    /// Of no state yet; `states` is their number, as far as it is known.
    pub fn new(states: Option<usize>) -> Self {
        Self {
            share: states.map_or(0, |states| MOST_BYTES / states.max(1)),
            stride: 1,
            kept: Vec::new(),
            bytes: 0,
            ranges: Vec::new(),
            factors: Vec::new(),
            grown: BTreeMap::new(),
            last: None,
        }
    }

    /// Takes the map of the next state, on the same cells.
    pub fn take(&mut self, map: Map) {
        self.settle();
        self.ranges.resize(map.fields.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        for (own, Field { range: [low, high], .. }) in self.ranges.iter_mut().zip(&map.fields) {
            *own = [own[0].min(*low), own[1].max(*high)];
        }
        if let Some(moves) = map.moves.filter(|m| m.fields.iter().any(|&k| map.fields[k].range != [0.0; 2])) {
            self.factors.push(moves.factor);
        }
        for &[cell, side, state] in &map.grown {
            self.grown.entry([cell, side]).or_insert(state);
        }
        self.last = Some(map);
    }

    /// Packs the last state too: there will be a later one.
    pub fn settle(&mut self) {
        let Some(Map { fields, cells, state: (state, name), .. }) = self.last.take() else { return };
        if !state.is_multiple_of(self.stride) || fields.is_empty() || cells == Cells::default() {
            return;
        }
        let packed = field::packed(&fields, &cells.order(), self.share);
        self.bytes += field::bytes(&packed);
        self.kept.push(Frame { state, name, packed });
        while self.bytes > MOST_BYTES && self.kept.len() > 1 {
            self.stride *= 2;
            self.kept.retain(|frame| frame.state.is_multiple_of(self.stride));
            self.bytes = self.kept.iter().map(|frame| field::bytes(&frame.packed)).sum();
        }
    }

    /// Every how many states one is kept.
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// The map of all states; none if there is no last one.
    pub fn map(self) -> Option<Map> {
        let mut map = self.last?;
        map.fields.iter_mut().zip(&self.ranges).for_each(|(field, range)| field.range = *range);
        if let (Some(moves), Some(factor)) = (&mut map.moves, common(self.factors)) {
            moves.factor = factor;
        }
        map.grown = self.grown.into_iter().map(|([cell, side], state)| [cell, side, state]).collect();
        map.before = self.kept;
        Some(map)
    }
}

/// The factor on displacements of all states: that of the one that has moved most. But pieces that have come off move so far
/// that nothing else would be seen to move; then it is that of the state in the middle.
fn common(mut factors: Vec<f64>) -> Option<f64> {
    factors.sort_by(f64::total_cmp);
    let (least, middle) = (*factors.first()?, factors[factors.len() / 2]);
    Some(if least < middle / COME_OFF { middle } else { least })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::report::{Block, Moves, Page, Section, render};

    /// A wave that grows over the states, on a square of cells; a crack runs through its middle.
    fn state(number: usize, side: usize) -> Map {
        let cells = Cells::Grid {
            origin: [0.0; 2],
            sides: [[1.0, 0.0], [0.0, 1.0]],
            size: [side; 2],
            last: [1.0; 2],
            runs: (0..side).map(|row| [row, 0, side]).collect(),
            torn: Vec::new(),
        };
        let field = |k: usize| {
            let at = |cell: usize| {
                let [x, y] = [cell % side, cell / side].map(|v| v as f64 / side as f64);
                let noise = ((cell * 7919 + number * 104_729) % 1009) as f64 / 1009.0;
                number as f64 * ((3.0 * x + k as f64).sin() * (2.0 * y).cos() + 0.02 * noise)
            };
            let values: Vec<f64> = (0..side * side).map(at).collect();
            let most = values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            Field { name: format!("field {k}"), values, range: [-most, most], ..Field::default() }
        };
        Map {
            cells,
            fields: (0..12).map(field).collect(),
            moves: Some(Moves { fields: [0, 1], factor: 1000.0 / number.max(1) as f64 }),
            grown: (0..number.min(side)).map(|column| [side * side / 2 + column, 1, number]).collect(),
            state: (number, format!("state {number}")),
            ..Map::default()
        }
    }

    fn frames(states: usize, side: usize) -> Frames {
        let mut frames = Frames::new(None);
        (0..states).for_each(|number| frames.take(state(number, side)));
        frames
    }

    #[test]
    fn two_hundred_states_of_ten_thousand_points_fit_into_three_megabytes() {
        let frames = frames(200, 100);
        let stride = frames.stride();
        let map = frames.map().unwrap();
        assert!(map.before.len() >= 25, "{} states, every {stride}th", map.before.len());
        assert!(map.before.iter().enumerate().all(|(k, frame)| frame.state == k * stride));
        let sections = vec![Section::new("s", vec![Block::Map(map)])];
        let html = render(&Page { sections, ..Page::default() });
        assert!(html.len() < 3_000_000, "{} bytes", html.len());
    }

    #[test]
    fn ranges_the_factor_and_cracks_are_those_of_all_states() {
        let map = frames(5, 10).map().unwrap();
        let widest = state(4, 10).fields[3].range;
        assert_eq!(map.fields[3].range, widest);
        assert_eq!(map.moves.map(|m| m.factor), Some(250.0));
        assert_eq!(map.grown, [[50, 1, 1], [51, 1, 2], [52, 1, 3], [53, 1, 4]]);
        assert_eq!(map.before.iter().map(|f| f.state).collect::<Vec<_>>(), [0, 1, 2, 3]);
    }

    #[test]
    fn a_piece_that_has_come_off_does_not_scale_the_others() {
        assert_eq!(common(vec![50.0, 20.0, 10.0]), Some(10.0));
        assert_eq!(common(vec![50.0, 20.0, 0.5]), Some(20.0));
        assert_eq!(common(Vec::new()), None);
    }

    #[test]
    fn going_on_from_what_was_saved_changes_nothing() {
        let expected = frames(9, 30).map();
        let mut saved = frames(4, 30);
        saved.settle();
        let bytes = postcard::to_stdvec(&saved).unwrap();
        let mut again: Frames = postcard::from_bytes(&bytes).unwrap();
        (4..9).for_each(|number| again.take(state(number, 30)));
        assert_eq!(again.map(), expected);
    }
}
