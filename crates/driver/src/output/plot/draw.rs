//! The drawing itself: where things stand, their colours and fonts.

use std::error::Error;

use plotters::coord::Shift;
use plotters::coord::ranged1d::ValueFormatter;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::scale::{Scale, short};
use super::thin::thin;
use super::{Diagram, Style};

/// Size in pixels.
const SIZE: (i32, i32) = (860, 420);
/// The backend knows whole pixels only; it draws on a finer raster and the `viewBox` scales it down.
pub(super) const FINE: i32 = 10;
/// Points of a series that are drawn, at most: more than the width has pixels are not seen.
const MOST_POINTS: usize = 2000;
/// Dots of a series, at most: more would lie on each other.
const MOST_DOTS: usize = 48;
/// Widths of strokes in fine units. A dashed line is distinguished from others by its width, see [`svg`].
const STROKE: u32 = 20;
const DASHED_STROKE: u32 = 19;
const THIN_STROKE: u32 = 8;
/// Left edge of the plot, and with it of title and legend.
const LEFT: i32 = 88;
/// Right edge of the plot; the last tick label stands half beyond it.
const RIGHT: i32 = SIZE.0 - 28;
/// Lower edge of the plot.
const BOTTOM: i32 = SIZE.1 - 58;
/// Where the legend ends even if there is more to name.
const LEGEND_END: i32 = 140;

pub(super) const INK: RGBColor = RGBColor(0x33, 0x3A, 0x44);
const FAINT: RGBColor = RGBColor(0xE4, 0xE7, 0xEB);
pub(super) const ZERO: RGBColor = RGBColor(0x9A, 0xA3, 0xAE);
/// Told apart in every common form of colour blindness (Okabe and Ito 2008), the yellow left out.
pub(super) const COLORS: [RGBColor; 6] = [
    RGBColor(0x00, 0x72, 0xB2),
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x00, 0x9E, 0x73),
    RGBColor(0xCC, 0x79, 0xA7),
    RGBColor(0x56, 0xB4, 0xE9),
    RGBColor(0x44, 0x44, 0x44),
];

pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Drawn<T = ()> = Result<T, Box<dyn Error + Send + Sync>>;

/// The diagram as the text of an SVG file.
pub(super) fn svg(diagram: &Diagram, x: &Scale, y: &Scale) -> Drawn<String> {
    on_canvas(SIZE, |canvas| draw(canvas, diagram, x, y))
}

/// A drawing of so many pixels as the text of an SVG file.
pub(super) fn on_canvas(
    (width, height): (i32, i32),
    draw: impl FnOnce(&Canvas<'_>) -> Drawn,
) -> Drawn<String> {
    let mut svg = String::new();
    let size = ((width * FINE) as u32, (height * FINE) as u32);
    draw(&SVGBackend::with_string(&mut svg, size).into_drawing_area())?;
    // The fine raster is scaled down to pixels here, and the marked strokes become dashes: as the many
    // elements that plotters makes of them, a noisy line would need megabytes.
    let raster = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
    let pixels = format!("width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\"");
    let marked = format!("stroke-width=\"{DASHED_STROKE}\"");
    let dashed = format!("{marked} stroke-dasharray=\"70 45\"");
    Ok(svg.replacen(&raster, &pixels, 1).replace(&marked, &dashed))
}

fn draw(canvas: &Canvas<'_>, diagram: &Diagram, x: &Scale, y: &Scale) -> Drawn {
    canvas.fill(&WHITE)?;
    let bold = font(17).style(FontStyle::Bold);
    text(canvas, &diagram.title, at(LEFT, 24), bold.color(&INK), HPos::Left)?;
    let top = legend(canvas, diagram)?;
    let mut chart = ChartBuilder::on(canvas)
        .margin_top(top * FINE)
        .margin_right((SIZE.0 - RIGHT) * FINE)
        .x_label_area_size((SIZE.1 - BOTTOM) * FINE)
        .y_label_area_size(LEFT * FINE)
        .build_cartesian_2d(x.clone(), y.clone())?;
    mesh(&mut chart)?;
    if y.low < 0.0 && y.high > 0.0 {
        let line = [(x.low, 0.0), (x.high, 0.0)];
        chart.draw_series([PathElement::new(line, ZERO.stroke_width(12))])?;
    }
    for (series, color) in diagram.series.iter().zip(COLORS.iter().cycle()) {
        if series.style == Style::Dots {
            let dots = thin(&series.points, MOST_DOTS).into_iter();
            chart.draw_series(dots.map(|p| Circle::new(p, 3 * FINE, color.filled())))?;
        } else {
            let points = thin(&series.points, MOST_POINTS);
            chart.draw_series(LineSeries::new(points, stroke(series.style, color)))?;
        }
    }
    names(canvas, diagram, x, y, top)?;
    if let Some(series) = diagram.series.first() {
        extremes(canvas, (&series.points, diagram.downwards), |p| chart.backend_coord(&p))?;
    }
    Ok(canvas.present()?)
}

/// The axes with their numbers, and faint lines across.
pub(super) fn mesh<'a, X, Y>(chart: &mut ChartContext<'a, SVGBackend<'a>, Cartesian2d<X, Y>>) -> Drawn
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let mut mesh = chart.configure_mesh();
    mesh.light_line_style(TRANSPARENT)
        .bold_line_style(FAINT.stroke_width(10))
        .axis_style(ZERO.stroke_width(10))
        .set_all_tick_mark_size(5 * FINE)
        .label_style(font(12).color(&INK));
    Ok(mesh.draw()?)
}

/// The names of the axes, and the powers of ten that their numbers leave out.
fn names(canvas: &Canvas<'_>, diagram: &Diagram, x: &Scale, y: &Scale, top: i32) -> Drawn {
    let name = || font(13).color(&INK);
    let upwards = font(13).transform(FontTransform::Rotate270).color(&INK);
    let factor = || font(12).color(&INK);
    let (x_factor, y_factor) = (x.factor().unwrap_or_default(), y.factor().unwrap_or_default());
    text(canvas, &diagram.x_label, at((LEFT + RIGHT) / 2, BOTTOM + 40), name(), HPos::Center)?;
    text(canvas, &diagram.y_label, at(18, (top + BOTTOM) / 2), upwards, HPos::Center)?;
    text(canvas, &x_factor, at(RIGHT, BOTTOM + 40), factor(), HPos::Right)?;
    text(canvas, &y_factor, at(LEFT - 8, top - 11), factor(), HPos::Right)
}

/// A row of marks and names below the title, or several; the height where the plot begins.
fn legend(canvas: &Canvas<'_>, diagram: &Diagram) -> Drawn<i32> {
    let (mut left, mut row) = (LEFT, 52);
    let series = diagram.series.iter().zip(COLORS.iter().cycle());
    for (series, color) in series.filter(|(series, _)| !series.label.is_empty()) {
        // Without a font at hand the width of a letter is guessed.
        let width = 58 + 13 * series.label.chars().count() as i32 / 2;
        if left > LEFT && left + width > SIZE.0 {
            (left, row) = (LEFT, row + 20);
        }
        if row > LEGEND_END {
            break;
        }
        if series.style == Style::Dots {
            canvas.draw(&Circle::new(at(left + 13, row), 3 * FINE, color.filled()))?;
        } else {
            let line = [at(left, row), at(left + 26, row)];
            canvas.draw(&PathElement::new(line, stroke(series.style, color)))?;
        }
        text(canvas, &series.label, at(left + 33, row), font(13).color(&INK), HPos::Left)?;
        left += width;
    }
    Ok(if left > LEFT { row + 28 } else { 52 })
}

/// Marks the largest value if it is above zero and the smallest if it is below.
fn extremes(
    canvas: &Canvas<'_>,
    (points, downwards): (&[(f64, f64)], bool),
    place: impl Fn((f64, f64)) -> (i32, i32),
) -> Drawn {
    let by_y = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
    let largest = points.iter().rev().max_by(by_y).filter(|p| p.1 > 0.0);
    let smallest = points.iter().min_by(by_y).filter(|p| p.1 < 0.0);
    let out = if downwards { -1 } else { 1 };
    for (point, side) in [(largest, -out), (smallest, out)] {
        let Some(&point) = point else { continue };
        let (x, y) = place(point);
        canvas.draw(&Circle::new((x, y), 4 * FINE, COLORS[0].filled()))?;
        canvas.draw(&Circle::new((x, y), 2 * FINE, WHITE.filled()))?;
        let (anchor, shift) = match x / FINE {
            x if x < LEFT + 40 => (HPos::Left, 5),
            x if x > RIGHT - 40 => (HPos::Right, 0),
            _ => (HPos::Center, 0),
        };
        let value = font(12).style(FontStyle::Bold).color(&COLORS[0]);
        text(canvas, &short(point.1), (x + shift * FINE, y + side * 13 * FINE), value, anchor)?;
    }
    Ok(())
}

/// Writes a text at a place of the raster.
pub(super) fn text(
    canvas: &Canvas<'_>,
    text: &str,
    at: (i32, i32),
    style: TextStyle<'_>,
    side: HPos,
) -> Drawn {
    Ok(canvas.draw(&Text::new(text, at, style.pos(Pos::new(side, VPos::Center))))?)
}

fn stroke(style: Style, color: &RGBColor) -> ShapeStyle {
    color.stroke_width(match style {
        Style::Dashed => DASHED_STROKE,
        Style::Thin => THIN_STROKE,
        Style::Line | Style::Dots => STROKE,
    })
}

/// A pixel on the raster.
pub(super) fn at(x: i32, y: i32) -> (i32, i32) {
    (x * FINE, y * FINE)
}

/// A font of so many pixels; plotters writes its size divided by 1.24.
pub(super) fn font(pixels: i32) -> FontDesc<'static> {
    ("Helvetica, Arial, sans-serif", f64::from(pixels * FINE) * 1.24).into_font()
}
