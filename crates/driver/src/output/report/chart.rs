//! Charts: lines over an axis.

use super::json::{all, inline, rounded};
use super::table::{Cell, Column, Table};
use super::{element, number};
use crate::output::plot::thin;
use serde_json::json;
use std::fmt::Write;

/// Points of a line that are kept, at most: the lowest and the highest of every column of pixels.
const MOST_POINTS: usize = 1600;
/// Rows of the table of values of a chart, at most.
const MOST_ROWS: usize = 25;

/// A chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// A remark below the title; empty for none.
    pub note: String,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// Lines, the first lowest.
    pub series: Vec<Series>,
    /// Triangles that show an order of convergence; both axes must be logarithmic.
    pub slopes: Vec<Slope>,
    /// Where the states of the page stand, by their number: a ring follows the one that is shown.
    pub marks: Vec<(f64, f64)>,
}

/// An axis.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Axis {
    /// Name and unit.
    pub label: String,
    /// Whether it is logarithmic; values that are not positive are then left out.
    pub log: bool,
    /// Whether it runs the other way, downwards.
    pub turned: bool,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), ..Self::default() }
    }

    /// A logarithmic axis.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), log: true, ..Self::default() }
    }
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// A line.
    #[default]
    Line,
    /// A thin line, as for what lies behind another one.
    Thin,
    /// A dashed line, as for what is compared with.
    Dashed,
    /// Points on a line, as of a study.
    Marked,
    /// Points alone.
    Dots,
}

impl Look {
    fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Thin => "thin",
            Self::Dashed => "dashed",
            Self::Marked => "marked",
            Self::Dots => "dots",
        }
    }
}

/// Points that belong together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub label: String,
    /// How it is drawn.
    pub look: Look,
    /// Pairs of x and y in the order of the line; what is not finite is left out.
    pub points: Vec<(f64, f64)>,
}

/// A triangle of an order of convergence: from a point to another x, where y has grown with the power `order` of x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The order, written beside the triangle.
    pub order: f64,
    /// Where the slanted side begins.
    pub from: (f64, f64),
    /// The x where it ends.
    pub to_x: f64,
}

impl Slope {
    /// A triangle below the two points with the smallest x, the finest of a study; none where there are not two of them.
    pub fn below(points: &[(f64, f64)], order: f64) -> Option<Self> {
        let mut points: Vec<(f64, f64)> = points.iter().copied().filter(|p| p.0 > 0.0 && p.1 > 0.0).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = points.first()?;
        let next = points.iter().find(|p| p.0 > first.0)?;
        // A third of a decade below the lower one of them along the slope.
        let base = first.1.min(next.1 * (first.0 / next.0).powf(order));
        Some(Self { order, from: (first.0, 0.46 * base), to_x: next.0 })
    }
}

/// A series with those of its points that can be drawn.
type Line<'a> = (&'a Series, Vec<(f64, f64)>);

/// The points of a series that can be drawn.
fn drawn<'a>(chart: &Chart, series: &'a Series) -> Line<'a> {
    let fits = |value: f64, axis: &Axis| value.is_finite() && (!axis.log || value > 0.0);
    let points = series.points.iter().copied().filter(|p| fits(p.0, &chart.x) && fits(p.1, &chart.y));
    (series, points.collect())
}

/// The chart as a figure; a sentence where there is nothing to draw.
pub(super) fn render(out: &mut String, chart: &Chart) {
    let lines: Vec<Line> = chart.series.iter().map(|s| drawn(chart, s)).collect();
    if lines.iter().all(|(_, points)| points.is_empty()) {
        element::paragraph(out, &element::titled(&chart.title, "there are no values to draw."));
        return;
    }
    let line = |(s, points): &Line| {
        let points = thin(points, MOST_POINTS);
        let (x, y) = (all(points.iter().map(|p| p.0)), all(points.iter().map(|p| p.1)));
        json!({ "label": s.label, "look": s.look.name(), "x": x, "y": y })
    };
    let slope = |s: &Slope| {
        let ends = [s.from.0, s.from.1, s.to_x].map(rounded);
        json!({ "order": s.order, "x": ends[0], "y": ends[1], "to": ends[2] })
    };
    let is_log = chart.x.log && chart.y.log;
    let axis = |axis: &Axis| json!({ "label": axis.label, "log": axis.log, "turned": axis.turned });
    let data = json!({
        "x": axis(&chart.x),
        "y": axis(&chart.y),
        "series": lines.iter().map(line).collect::<Vec<_>>(),
        "slopes": chart.slopes.iter().filter(|_| is_log).map(slope).collect::<Vec<_>>(),
        "marks": chart.marks.iter().map(|m| [m.0, m.1].map(rounded)).collect::<Vec<_>>(),
    });
    element::figure(
        out,
        "chart",
        (&chart.title, &chart.note),
        &described(chart, &lines),
        &inline(&data),
        &|out| {
            legend(out, &lines);
        },
    );
    values(out, chart, &lines);
    out.push_str("</figure>\n");
}

/// The chart in words.
fn described(chart: &Chart, lines: &[Line]) -> String {
    let range = |(series, points): &Line| {
        let low = points.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
        format!("{} from {} to {}", series.label, number(low), number(high))
    };
    let ranges: Vec<String> = lines.iter().filter(|l| !l.1.is_empty()).map(range).collect();
    let text = format!("{} over {}; {}", chart.y.label, chart.x.label, ranges.join(", "));
    element::titled(&chart.title, &text)
}

/// Marks and names of the series; none for a single one without a name of its own.
fn legend(out: &mut String, lines: &[Line]) {
    if lines.len() < 2 {
        return;
    }
    out.push_str("<div class=\"legend\">");
    for (k, (series, _)) in lines.iter().enumerate() {
        let color = k % 6 + 1;
        let look = series.look.name();
        let label = element::escaped(&series.label);
        let _ = write!(out, "<span><i class=\"c{color} {look}\"></i>{label}</span>");
    }
    out.push_str("</div>\n");
}

/// The values as a folded table; of many some at even distances. Lines over the same x share its column.
fn values(out: &mut String, chart: &Chart, lines: &[Line]) {
    let first = &lines[0].1;
    let is_shared = |p: &[(f64, f64)]| p.len() == first.len() && p.iter().zip(first).all(|(a, b)| a.0 == b.0);
    let shared = lines.iter().all(|(_, points)| is_shared(points));
    let total = if shared { first.len() } else { lines.iter().map(|l| l.1.len()).sum() };
    let step = total.div_ceil(MOST_ROWS).max(1);
    let x = Column::numbers(chart.x.label.as_str());
    let (columns, rows): (Vec<Column>, Vec<Vec<Cell>>) = if shared {
        let y = lines.iter().map(|(s, _)| Column::numbers(s.label.as_str()));
        let row = |k: usize| {
            let y = lines.iter().map(|(_, points)| number(points[k].1).into());
            std::iter::once(number(first[k].0).into()).chain(y).collect()
        };
        (std::iter::once(x).chain(y).collect(), (0..total).step_by(step).map(row).collect())
    } else {
        let row = |s: &Series, p: &(f64, f64)| {
            vec![s.label.as_str().into(), number(p.0).into(), number(p.1).into()]
        };
        let of_line = |(s, points): &Line| points.iter().step_by(step).map(|p| row(s, p)).collect::<Vec<_>>();
        let y = Column::numbers(chart.y.label.as_str());
        (vec![Column::words("line"), x, y], lines.iter().flat_map(of_line).collect())
    };
    let words = if step > 1 { "Some of the values" } else { "Values" };
    let _ = writeln!(out, "<details class=\"values\"><summary>{words}</summary>");
    element::table(out, &Table { title: String::new(), columns, rows });
    out.push_str("</details>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<(f64, f64)>, log: bool) -> Chart {
        let axis = |label: &str| Axis { label: label.into(), log, ..Axis::default() };
        let series = vec![Series { label: "a".into(), look: Look::Marked, points }];
        Chart { title: "t".into(), x: axis("x"), y: axis("y"), series, ..Chart::default() }
    }

    fn rendered(chart: &Chart) -> String {
        let mut out = String::new();
        render(&mut out, chart);
        out
    }

    #[test]
    fn a_million_points_are_thinned_and_a_peak_stays() {
        let mut points: Vec<_> = (0..1_000_000).map(|k| (f64::from(k), f64::from(k % 7))).collect();
        points[345_678].1 = 99.5;
        let html = rendered(&chart(points, false));
        assert!(html.len() < 60_000, "{} bytes", html.len());
        assert!(html.contains("99.5") && html.contains("Some of the values"));
    }

    #[test]
    fn logarithmic_axes_leave_out_what_is_not_positive() {
        let html = rendered(&chart(vec![(1.0, 0.0), (2.0, 3.5), (-1.0, 4.5), (f64::NAN, 1.0)], true));
        assert!(html.contains("\"x\":[2],\"y\":[3.5]"), "{html}");
        assert!(rendered(&chart(vec![(1.0, -1.0)], true)).contains("no values to draw"));
    }

    #[test]
    fn a_triangle_lies_below_the_points_and_has_the_order() {
        let points = [(0.4, 1.6e-2), (0.2, 4e-3), (0.1, 1e-3), (0.8, 9.0)];
        let slope = Slope::below(&points, 2.0).unwrap();
        assert_eq!((slope.from.0, slope.to_x), (0.1, 0.2));
        assert!((slope.from.1 - 0.46e-3).abs() < 1e-12);
        assert_eq!(Slope::below(&points[..1], 2.0), None);
    }
}
