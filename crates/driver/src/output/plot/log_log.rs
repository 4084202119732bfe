//! Errors over sizes: both axes logarithmic, with a triangle that shows the slope of each line.

use super::draw::{COLORS, Canvas, Drawn, FINE, INK, at, font, mesh, on_canvas, text};
use crate::output::atomic;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;
use std::io;
use std::path::Path;

/// Size in pixels.
const SIZE: (i32, i32) = (860, 520);
/// Margins: left, right, bottom.
const LEFT: i32 = 88;
const RIGHT: i32 = SIZE.0 - 28;
const BOTTOM: i32 = SIZE.1 - 58;
/// Lines that are named in the legend, at most.
const MOST_NAMES: usize = 12;
/// Width of a triangle of slope, decades.
const TRIANGLE: f64 = 0.15;

/// A line of positive numbers over positive numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PowerLine {
    /// Name in the legend; empty for none.
    pub label: String,
    /// Pairs of x and y; those that are not positive are left out.
    pub points: Vec<(f64, f64)>,
    /// Slope that a triangle at its end of small x shows.
    pub slope: Option<f64>,
}

/// A diagram with logarithmic axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LogLog {
    /// Heading.
    pub title: String,
    /// Name and unit of x.
    pub x_label: String,
    /// Name and unit of y.
    pub y_label: String,
    /// Lines.
    pub lines: Vec<PowerLine>,
}

/// Writes a diagram with logarithmic axes as SVG of 860 by 520 pixels.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] if there is no positive point; what the file system reports.
pub fn write_log_log(path: &Path, diagram: &LogLog) -> io::Result<()> {
    atomic::write_atomically(path, render_log_log(diagram)?.as_bytes())
}

/// The diagram as the text of an SVG file; errors as in [`write_log_log`].
pub fn render_log_log(diagram: &LogLog) -> io::Result<String> {
    let lines: Vec<Vec<(f64, f64)>> = diagram.lines.iter().map(logarithms).collect();
    let range = |of: fn(&(f64, f64)) -> f64| Decades::around(lines.iter().flatten().map(of));
    let (Some(x), Some(y)) = (range(|p| p.0), range(|p| p.1)) else {
        let message = format!("diagram `{}` has no positive points", diagram.title);
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    };
    on_canvas(SIZE, |canvas| draw(canvas, diagram, &lines, (&x, &y))).map_err(io::Error::other)
}

/// Decimal logarithms of the positive points of a line.
fn logarithms(line: &PowerLine) -> Vec<(f64, f64)> {
    let positive =
        line.points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0 && p.0.is_finite() && p.1.is_finite());
    positive.map(|p| (p.0.log10(), p.1.log10())).collect()
}

fn draw(
    canvas: &Canvas<'_>,
    diagram: &LogLog,
    lines: &[Vec<(f64, f64)>],
    (x, y): (&Decades, &Decades),
) -> Drawn {
    canvas.fill(&WHITE)?;
    text(canvas, &diagram.title, at(LEFT, 24), font(17).style(FontStyle::Bold).color(&INK), HPos::Left)?;
    let top = legend(canvas, diagram)?;
    let mut chart = ChartBuilder::on(canvas)
        .margin_top(top * FINE)
        .margin_right((SIZE.0 - RIGHT) * FINE)
        .x_label_area_size((SIZE.1 - BOTTOM) * FINE)
        .y_label_area_size(LEFT * FINE)
        .build_cartesian_2d(x.clone(), y.clone())?;
    mesh(&mut chart)?;
    for ((points, line), color) in lines.iter().zip(&diagram.lines).zip(COLORS.iter().cycle()) {
        chart.draw_series(LineSeries::new(points.iter().copied(), color.stroke_width(18)))?;
        chart.draw_series(points.iter().map(|p| Circle::new(*p, 3 * FINE, color.filled())))?;
        if let (Some(slope), Some(&finest)) = (line.slope, points.iter().min_by(|a, b| a.0.total_cmp(&b.0))) {
            let corners = triangle(finest, slope, y);
            let closed = [corners[0], corners[1], corners[2], corners[0]];
            chart.draw_series([PathElement::new(closed, color.stroke_width(10))])?;
            let middle = chart.backend_coord(&(corners[1].0, 0.5 * (corners[1].1 + corners[2].1)));
            let beside = (middle.0 + 5 * FINE, middle.1);
            text(canvas, &format!("{slope:.2}"), beside, font(12).color(color), HPos::Left)?;
        }
    }
    let upwards = font(13).transform(FontTransform::Rotate270).color(&INK);
    text(canvas, &diagram.x_label, at((LEFT + RIGHT) / 2, BOTTOM + 40), font(13).color(&INK), HPos::Center)?;
    text(canvas, &diagram.y_label, at(18, (top + BOTTOM) / 2), upwards, HPos::Center)?;
    Ok(canvas.present()?)
}

/// Corners of a triangle a little below the finest point: left, right angle, and on the slope.
fn triangle((x, y): (f64, f64), slope: f64, range: &Decades) -> [(f64, f64); 3] {
    let below = y - 0.03 * (range.high - range.low);
    [(x, below), (x + TRIANGLE, below), (x + TRIANGLE, below + slope * TRIANGLE)]
}

/// Marks and names below the title; the height where the plot begins.
fn legend(canvas: &Canvas<'_>, diagram: &LogLog) -> Drawn<i32> {
    let (mut left, mut row) = (LEFT, 52);
    let named = diagram.lines.iter().zip(COLORS.iter().cycle()).filter(|(line, _)| !line.label.is_empty());
    for (line, color) in named.take(MOST_NAMES) {
        // Without a font at hand the width of a letter is guessed.
        let width = 44 + 13 * line.label.chars().count() as i32 / 2;
        if left > LEFT && left + width > SIZE.0 {
            (left, row) = (LEFT, row + 20);
        }
        canvas.draw(&Circle::new(at(left + 6, row), 4 * FINE, color.filled()))?;
        text(canvas, &line.label, at(left + 18, row), font(13).color(&INK), HPos::Left)?;
        left += width;
    }
    Ok(if left > LEFT { row + 28 } else { 52 })
}

/// An axis of decimal logarithms, with ticks at powers of ten, or between them where there are few.
#[derive(Clone, Debug)]
struct Decades {
    low: f64,
    high: f64,
}

impl Decades {
    /// A range around logarithms with a margin; none without any.
    fn around(values: impl Iterator<Item = f64>) -> Option<Self> {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        let margin = 0.08 * (high - low).max(1.0) + 0.02;
        (low <= high).then_some(Self { low: low - 2.0 * margin, high: high + margin })
    }

    fn ticks(&self) -> Vec<f64> {
        let (first, last) = (self.low.ceil() as i32, self.high.floor() as i32);
        if last - first < 2 {
            let leads = [1.0, 2.0, 5.0_f64].map(f64::log10);
            let all = (first - 1..=last).flat_map(|power| leads.map(|lead| f64::from(power) + lead));
            return all.filter(|t| (self.low..=self.high).contains(t)).collect();
        }
        let every = ((last - first) / 10 + 1) as usize;
        (first..=last).step_by(every).map(f64::from).collect()
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.low) / (self.high - self.low);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks() }
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Decades {
    fn format_ext(&self, tick: &f64) -> String {
        let (power, lead) = (tick.floor(), 10_f64.powf(tick - tick.floor()).round());
        match (lead as i32, power as i32) {
            (1, power) if !(-2..=4).contains(&power) => super::scale::power_of_ten(power),
            (lead, power) if (-4..=4).contains(&power) => {
                let decimals = usize::try_from(-power).unwrap_or(0);
                format!("{:.decimals$}", f64::from(lead) * 10_f64.powi(power))
            }
            (lead, power) => format!("{lead}×{}", super::scale::power_of_ten(power)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagram(points: Vec<(f64, f64)>, slope: Option<f64>) -> LogLog {
        let lines = vec![PowerLine { label: "law <a>".into(), points, slope }];
        LogLog { title: "Error".into(), x_label: "δ".into(), y_label: "error".into(), lines }
    }

    #[test]
    fn a_slope_has_its_triangle_and_number() {
        let points = vec![(0.1, 1e-2), (0.05, 2.5e-3), (0.025, 6.25e-4)];
        let svg = render_log_log(&diagram(points.clone(), Some(2.0))).unwrap();
        assert!(svg.contains("2.00") && svg.contains("law &lt;a&gt;") && svg.contains("10⁻³"), "{svg}");
        let plain = render_log_log(&diagram(points, None)).unwrap();
        assert!(!plain.contains("2.00"));
        assert_eq!(svg.matches("<polyline").count(), plain.matches("<polyline").count() + 1);
    }

    #[test]
    fn what_is_not_positive_is_left_out() {
        assert!(render_log_log(&diagram(vec![(0.0, 1.0), (1.0, -1.0), (1.0, f64::NAN)], None)).is_err());
        let svg = render_log_log(&diagram(vec![(1.0, 0.0), (2.0, 1e-16)], None)).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
