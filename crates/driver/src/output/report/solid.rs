//! Solids: bricks in space, coloured by one of several fields, which readers turn, cut, and move by a multiple of three of them.
//!
//! The scripts draw with WebGL themselves: the smallest kept library for that, three.js, has 0.7 MB, more than a whole report, where
//! one shader is needed. Without WebGL they draw the same sides on a plain canvas.

use super::element;
use super::field::{self, Field, Moves};
use super::json::{inline, rounded};
use super::pack::Order;
use serde_json::json;

/// A solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solid {
    /// What it shows.
    pub title: String,
    /// A remark below the title; empty for none.
    pub note: String,
    /// Unit of positions.
    pub length: String,
    /// Where the bricks are.
    pub bricks: Bricks,
    /// What they hold; the first one is shown first.
    pub fields: Vec<Field>,
    /// How they move.
    pub moves: Option<Moves<3>>,
}

/// Bricks of a box, the fields of which stand row by row along x, layer by layer along z.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bricks {
    /// The corner of the box with the smallest coordinates.
    pub origin: [f64; 3],
    /// Side of a brick, and of one at the end of the box, along each axis.
    pub sides: [[f64; 3]; 2],
    /// Number of bricks along the axes, whether they are there or not.
    pub size: [usize; 3],
    /// Numbers of bricks of the box in their order: that are missing, that are there, that are missing, and so on.
    pub spans: Vec<usize>,
}

impl Bricks {
    /// Number of bricks that are there.
    fn count(&self) -> usize {
        self.spans.iter().skip(1).step_by(2).sum()
    }

    /// What foretells the values of a brick: its neighbours in its layer.
    fn order(&self) -> Order {
        let [columns, rows, _] = self.size;
        let (mut runs, mut at): (Vec<[usize; 3]>, usize) = (Vec::new(), 0);
        for pair in self.spans.chunks(2) {
            at += pair[0];
            let end = at + pair.get(1).copied().unwrap_or(0);
            while at < end {
                let (row, column) = (at / columns, at % columns);
                let count = (columns - column).min(end - at);
                // A row that no layer has parts the layers.
                runs.push([row + row / rows, column, count]);
                at += count;
            }
        }
        Order::of_runs(columns, &runs)
    }
}

/// The solid as a figure, the fields of which take no more than some bytes, at the price of digits.
///
/// # Panics
/// A field does not have a value per brick.
pub(super) fn render(out: &mut String, solid: &Solid, most_bytes: usize) {
    let count = solid.bricks.count();
    if count == 0 || solid.fields.is_empty() {
        element::paragraph(out, &element::titled(&solid.title, "there are no cells to draw."));
        return;
    }
    assert!(solid.fields.iter().all(|f| f.values.len() == count), "a field has a value per brick");
    let Bricks { origin, sides, size, spans } = &solid.bricks;
    let packed = field::packed(&solid.fields, &solid.bricks.order(), most_bytes);
    let data = json!({
        "length": solid.length,
        "bricks": { "origin": origin, "sides": sides, "size": size, "spans": spans },
        "fields": field::json(&solid.fields, &packed),
        "moves": solid.moves.map(|m| json!({ "fields": m.fields, "factor": rounded(m.factor) })),
    });
    let described = format!(
        "{}. Arrow keys turn the body, with Shift they move it, + and − zoom, Home shows all of it, Enter reads the middle.",
        field::described(&solid.title, &solid.fields)
    );
    element::figure(out, "solid", (&solid.title, &solid.note), &described, &inline(&data), &|out| {
        out.push_str("<div class=\"controls\">");
        field::choice(out, &solid.fields);
        if solid.moves.is_some() {
            element::slider(out);
        }
        out.push_str(CONTROLS);
    });
    out.push_str("</figure>\n");
}

/// The controls of the cut and the views, and the note that appears without WebGL.
const CONTROLS: &str = r#"<label class="cut">Cut <select class="across"><option value="">none</option><option value="0">across x</option>
<option value="1">across y</option><option value="2">across z</option></select></label>
<label class="cut"><input type="range" class="depth" min="1" value="1" aria-label="Place of the cut" hidden><output></output></label>
<button type="button" class="flip" hidden>other half</button>
<span class="views" role="group" aria-label="View"><button type="button" value="all">all</button><button type="button" value="front">front</button>
<button type="button" value="back">back</button><button type="button" value="left">left</button><button type="button" value="right">right</button>
<button type="button" value="top">top</button><button type="button" value="bottom">bottom</button></span></div>
<p class="note slow" hidden>This browser shows no WebGL, so the body is drawn without light, and turns slowly.</p>
"#;

#[cfg(test)]
mod tests {
    use super::super::pack::pack;
    use super::*;

    /// A box of 4 × 3 × 2 without the brick [1, 1, 0] and without the last row.
    fn bricks() -> Bricks {
        Bricks { size: [4, 3, 2], sides: [[1.0; 3]; 2], spans: vec![0, 5, 1, 14], ..Bricks::default() }
    }

    #[test]
    fn bricks_are_foretold_by_those_of_their_layer() {
        let order = bricks().order();
        assert_eq!(bricks().count(), 19);
        let steps: Vec<u16> = (0..19).map(|k| 100 + k).collect();
        // The first one of a layer has none before; those above the missing one have one neighbour.
        let foretold: Vec<u16> = [0, 1, 4, 5, 11, 15].map(|k| order.foretold(&steps, k)).into();
        assert_eq!(foretold, [0, 100, 100, 102, 0, 111]);
    }

    #[test]
    fn a_wave_in_a_box_takes_half_a_byte_per_value() {
        let bricks =
            Bricks { size: [40; 3], sides: [[1.0; 3]; 2], spans: vec![0, 64_000], ..Bricks::default() };
        let wave = |k: usize| {
            let [x, y, z] = [k % 40, k / 40 % 40, k / 1600].map(|v| v as f64 / 12.0);
            x.sin() * y.cos() + z.sin()
        };
        let values: Vec<f64> = (0..64_000).map(wave).collect();
        let packed = pack(&values, &bricks.order(), 10);
        let length = packed.data.len();
        assert!(length < 40_000, "{length} bytes of 64 000 values");
    }

    #[test]
    #[should_panic(expected = "a field has a value per brick")]
    fn fields_of_another_length_are_a_broken_contract() {
        let fields = vec![Field { values: vec![1.0; 18], ..Field::default() }];
        render(&mut String::new(), &Solid { bricks: bricks(), fields, ..Solid::default() }, 0);
    }
}
