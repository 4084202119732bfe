//! Maps: bodies in the plane as coloured cells, with a colour bar. The SVG is written by hand: cells of one colour share a
//! path, so that a map stays small.

use super::marks::{self, Isoline};
use super::patch::{Light, Patch, color};
use super::scale::{Scale, short};
use crate::output::{atomic, xml};
use std::fmt::Write;
use std::io;
use std::path::Path;

/// A map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Map {
    /// Heading.
    pub title: String,
    /// One line below it: what is drawn, and to which scale.
    pub note: String,
    /// Name and unit of the values, at the colour bar.
    pub label: String,
    /// Smallest and largest value, at the ends of the colour bar; those of cells that are means may be less far apart.
    pub range: [f64; 2],
    /// Cells; those that are in a row and have one colour are drawn as one.
    pub patches: Vec<Patch>,
    /// Cells in light grey below the others, such as the body before it moved.
    pub ghost: Vec<[[f64; 2]; 4]>,
    /// Lines over the cells, such as cracks.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Where the field has round values.
    pub isolines: Vec<Isoline>,
    /// Arrows over all else, each from its first place to its second.
    pub arrows: Vec<[[f64; 2]; 2]>,
}

/// Width in pixels; room at the sides, for the heading, and for the colour bar.
const WIDTH: f64 = 860.0;
const SIDE: f64 = 40.0;
const TOP: f64 = 78.0;
const BELOW: f64 = 84.0;
/// Largest height of the body.
const TALLEST: f64 = 620.0;
/// Part of a pixel that coordinates are rounded to.
const FINE: f64 = 10.0;
/// Number of colours.
const LEVELS: usize = 48;
const FONT: &str = "font-family=\"Helvetica, Arial, sans-serif\" fill=\"#333A44\"";

/// From coordinates to tenths of pixels.
struct View {
    low: [f64; 2],
    scale: f64,
    left: f64,
    bottom: f64,
}

impl View {
    /// Around all cells; `None` if there is none, or one that is not finite.
    fn new(map: &Map) -> Option<Self> {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for at in map.patches.iter().map(|p| &p.corners).chain(&map.ghost).flatten() {
            if !at.iter().all(|v| v.is_finite()) {
                return None;
            }
            (0..2).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
        }
        let [width, height] = [0, 1].map(|k| high[k] - low[k]);
        let scale = ((WIDTH - 2.0 * SIDE) / width).min(TALLEST / height);
        let (left, bottom) = (0.5 * (WIDTH - scale * width), TOP + scale * height);
        (scale.is_finite() && scale > 0.0).then_some(Self { low, scale, left, bottom })
    }

    fn place(&self, at: [f64; 2]) -> [i64; 2] {
        let x = self.left + self.scale * (at[0] - self.low[0]);
        let y = self.bottom - self.scale * (at[1] - self.low[1]);
        [x, y].map(|v| (FINE * v).round() as i64)
    }

    /// A cell as a part of a path.
    fn cell(&self, path: &mut String, corners: &[[f64; 2]; 4]) {
        let [a, b, c, d] = corners.map(|at| self.place(at));
        let _ = match a[1] == b[1] && b[0] == c[0] && c[1] == d[1] && d[0] == a[0] {
            true => write!(path, "M{} {}h{}v{}H{}z", a[0], a[1], b[0] - a[0], c[1] - b[1], a[0]),
            false => {
                let step = |p: [i64; 2], q: [i64; 2]| format!("{} {}", q[0] - p[0], q[1] - p[1]);
                let (ab, bc, cd) = (step(a, b), step(b, c), step(c, d));
                write!(path, "M{} {}l{ab} {bc} {cd}z", a[0], a[1])
            }
        };
    }
}

/// Writes a map as SVG.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] if there is no cell or one that is not finite; what the file system reports.
pub fn write_map(path: &Path, map: &Map) -> io::Result<()> {
    atomic::write_atomically(path, render_map(map)?.as_bytes())
}

/// The map as the text of an SVG file; errors as in [`write_map`].
pub fn render_map(map: &Map) -> io::Result<String> {
    let scale = Scale::new(map.range.into_iter(), 0.0, 6.0);
    let (Some(view), Some(scale)) = (View::new(map), scale) else {
        let message = format!("map `{}` has no cells, or one that is not finite", map.title);
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    };
    let height = view.bottom + BELOW;
    let mut svg = format!(
        "<svg width=\"{WIDTH}\" height=\"{height:.0}\" viewBox=\"0 0 {:.0} {:.0}\" xmlns=\"http://www.w3.org/2000/svg\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        FINE * WIDTH,
        FINE * height
    );
    text(&mut svg, [SIDE, 30.0], 17, "start", " font-weight=\"bold\"", &map.title);
    text(&mut svg, [SIDE, 54.0], 13, "start", "", &map.note);
    // Viewers of PDF smooth every edge: without a line of its own colour, cells would have seams.
    svg.push_str("<g shape-rendering=\"crispEdges\" stroke-width=\"4\">\n");
    cells(&mut svg, map, &view, &scale);
    svg.push_str("</g>\n");
    let place = |at: [f64; 2]| view.place(at);
    marks::isolines(&mut svg, &map.isolines, &place, &short);
    for line in &map.lines {
        let points: Vec<String> =
            line.iter().map(|&at| view.place(at)).map(|[x, y]| format!("{x},{y}")).collect();
        // Dark on white is seen on every colour.
        for (color, width) in [("#fff", 26), ("#333A44", 12)] {
            let _ = writeln!(
                svg,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"/>",
                points.join(" ")
            );
        }
    }
    marks::arrows(&mut svg, &map.arrows, &place);
    bar(&mut svg, map, &scale, view.bottom + 26.0);
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// The cells, one path per colour.
fn cells(svg: &mut String, map: &Map, view: &View, scale: &Scale) {
    let mut ghost = vec![String::new()];
    paths(&mut ghost, view, map.ghost.iter().map(|corners| (0, *corners)));
    let level = |value: f64| match value.is_nan() {
        true => LEVELS,
        false => (part(scale, map, value) * LEVELS as f64).clamp(0.0, (LEVELS - 1) as f64) as usize,
    };
    // Levels in full light, then those in less.
    const STEP: usize = LEVELS + 1;
    let mut colored = vec![String::new(); Light::ALL.len() * STEP];
    let group = |p: &Patch| p.light as usize * STEP + level(p.value);
    paths(&mut colored, view, map.patches.iter().map(|p| (group(p), p.corners)));
    let fill = |k: usize| match k % STEP {
        LEVELS => "#B9BFC7".to_string(),
        level => color((level as f64 + 0.5) / LEVELS as f64, Light::ALL[k / STEP]),
    };
    let colors = colored.iter().enumerate().map(|(k, path)| (fill(k), path));
    for (fill, path) in std::iter::once(("#E4E7EB".to_string(), &ghost[0])).chain(colors) {
        if !path.is_empty() {
            let _ = writeln!(svg, "<path fill=\"{fill}\" stroke=\"{fill}\" d=\"{path}\"/>");
        }
    }
}

/// Adds cells to the paths of their levels; upright cells in a row are one.
fn paths(paths: &mut [String], view: &View, cells: impl Iterator<Item = (usize, [[f64; 2]; 4])>) {
    let mut pending: Option<(usize, [[f64; 2]; 4])> = None;
    for (level, corners) in cells {
        if let Some((last, row)) = &mut pending
            && *last == level
            && row[1] == corners[0]
            && row[2] == corners[3]
            && is_upright(row)
            && is_upright(&corners)
        {
            (row[1], row[2]) = (corners[1], corners[2]);
        } else if let Some((last, row)) = pending.replace((level, corners)) {
            view.cell(&mut paths[last], &row);
        }
    }
    if let Some((last, row)) = pending {
        view.cell(&mut paths[last], &row);
    }
}

fn is_upright(c: &[[f64; 2]; 4]) -> bool {
    c[0][1] == c[1][1] && c[1][0] == c[2][0] && c[2][1] == c[3][1] && c[3][0] == c[0][0]
}

/// Part of the range at which a value lies; the middle where all values are one.
fn part(scale: &Scale, map: &Map, value: f64) -> f64 {
    let [low, high] = bounds(scale, map);
    (value - low) / (high - low)
}

/// Ends of the colour bar: the range of the values, or one around a single value.
fn bounds(scale: &Scale, map: &Map) -> [f64; 2] {
    let [low, high] = map.range;
    let size = low.abs().max(high.abs());
    if high - low > 1e-9 * size && size > 0.0 { map.range } else { [scale.low, scale.high] }
}

/// The colour bar with its numbers, at some height.
fn bar(svg: &mut String, map: &Map, scale: &Scale, y: f64) {
    const LENGTH: f64 = 460.0;
    let (left, step) = (0.5 * (WIDTH - LENGTH), LENGTH / LEVELS as f64);
    for k in 0..LEVELS {
        let _ = writeln!(
            svg,
            "<rect x=\"{:.0}\" y=\"{:.0}\" width=\"{:.0}\" height=\"{:.0}\" fill=\"{}\"/>",
            FINE * (left + k as f64 * step),
            FINE * y,
            FINE * step + 5.0,
            FINE * 12.0,
            color((k as f64 + 0.5) / LEVELS as f64, Light::Full)
        );
    }
    let [low, high] = bounds(scale, map);
    for &tick in scale.ticks.iter().filter(|t| (low..=high).contains(*t)) {
        let x = left + LENGTH * (tick - low) / (high - low);
        let _ = writeln!(
            svg,
            "<path d=\"M{:.0} {:.0}v50\" stroke=\"#333A44\" stroke-width=\"10\"/>",
            FINE * x,
            FINE * (y + 12.0)
        );
        text(svg, [x, y + 30.0], 12, "middle", "", &scale.label(tick));
    }
    let factor = scale.factor().map_or(String::new(), |f| format!(" {f}"));
    text(svg, [0.5 * WIDTH, y + 48.0], 13, "middle", "", &format!("{}{factor}", map.label));
    text(svg, [left - 8.0, y + 10.5], 12, "end", " font-weight=\"bold\"", &short(low));
    text(svg, [left + LENGTH + 8.0, y + 10.5], 12, "start", " font-weight=\"bold\"", &short(high));
}

pub(super) fn text(svg: &mut String, [x, y]: [f64; 2], size: u32, anchor: &str, style: &str, words: &str) {
    let _ = writeln!(
        svg,
        "<text x=\"{:.0}\" y=\"{:.0}\" font-size=\"{}\" text-anchor=\"{anchor}\" {FONT}{style}>{}</text>",
        FINE * x,
        FINE * y,
        FINE * f64::from(size),
        xml(words)
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(i: usize, j: usize, value: f64) -> Patch {
        let at = |a: usize, b: usize| [(i + a) as f64, (j + b) as f64];
        Patch::flat([at(0, 0), at(1, 0), at(1, 1), at(0, 1)], value)
    }

    fn map(size: usize, value: impl Fn(usize, usize) -> f64) -> Map {
        let patches: Vec<Patch> = (0..size)
            .flat_map(|j| (0..size).map(move |i| (i, j)))
            .map(|(i, j)| square(i, j, value(i, j)))
            .collect();
        let values = || patches.iter().map(|p| p.value).filter(|v| v.is_finite());
        let range = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
        Map { title: "<t>".into(), label: "σ [MPa]".into(), range, patches, ..Map::default() }
    }

    #[test]
    fn cells_of_one_colour_in_a_row_are_one() {
        let svg = render_map(&map(4, |_, j| j as f64)).unwrap();
        // Four rows over the height that a map has, in tenths of pixels.
        assert_eq!(svg.matches("h6200v").count(), 4, "{svg}");
        assert!(svg.contains("&lt;t&gt;") && svg.contains("σ [MPa]") && svg.trim_end().ends_with("</svg>"));
    }

    #[test]
    fn a_map_of_many_cells_stays_below_a_megabyte() {
        let noisy = map(160, |i, j| ((i * 7919 + j * 104_729) % 977) as f64);
        assert!(render_map(&noisy).unwrap().len() < 1_000_000);
        let mut turned = noisy;
        for corner in turned.patches.iter_mut().flat_map(|p| &mut p.corners) {
            *corner = [0.8 * corner[0] - 0.6 * corner[1], 0.6 * corner[0] + 0.8 * corner[1]];
        }
        let svg = render_map(&turned).unwrap();
        assert!(svg.len() < 1_000_000, "{} bytes", svg.len());
    }

    #[test]
    fn one_value_alone_and_values_that_are_no_numbers_are_drawn() {
        for value in [0.0, 5.0, -1e-9] {
            let svg = render_map(&map(2, |_, _| value)).unwrap();
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
        }
        let svg = render_map(&map(2, |i, _| if i == 0 { f64::NAN } else { 1.0 })).unwrap();
        assert!(svg.contains("#B9BFC7"));
        assert!(render_map(&Map::default()).is_err());
    }

    #[test]
    fn sides_in_less_light_have_darker_paths_of_their_own() {
        let mut map = map(2, |_, _| 1.0);
        [Light::Full, Light::Half, Light::Low]
            .into_iter()
            .zip(&mut map.patches)
            .for_each(|(l, p)| p.light = l);
        let svg = render_map(&map).unwrap();
        for light in Light::ALL {
            // One value alone is in the middle of the range.
            let color = color((LEVELS as f64 / 2.0 + 0.5) / LEVELS as f64, light);
            assert_eq!(svg.matches(&format!("<path fill=\"{color}\"")).count(), 1, "{color}: {svg}");
        }
    }
}
