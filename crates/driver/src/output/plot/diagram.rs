//! Diagrams of lines over lines.

use super::draw;
use super::scale::Scale;
use crate::output::atomic;
use std::io;
use std::path::Path;

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A line.
    Line,
    /// A thin line, as for what lies behind another one.
    Thin,
    /// Single points, as for measured or closed-form values.
    Dots,
    /// A dashed line.
    Dashed,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its name in the legend; empty for none.
    pub label: String,
    /// How it is drawn.
    pub style: Style,
    /// Pairs of x and y, in the order of the line.
    pub points: Vec<(f64, f64)>,
}

/// One diagram. The largest and the smallest value of its first series are written beside it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagram {
    /// Heading.
    pub title: String,
    /// Name and unit of x.
    pub x_label: String,
    /// Name and unit of y.
    pub y_label: String,
    /// Whether y grows downwards.
    pub downwards: bool,
    /// What is drawn, the first lowest.
    pub series: Vec<Series>,
}

/// Writes a diagram as SVG of 860 by 420 pixels.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] if there is no point or one that is not finite (or beyond 1e290); what
/// the file system reports.
pub fn write(path: &Path, diagram: &Diagram) -> io::Result<()> {
    atomic::write_atomically(path, render(diagram)?.as_bytes())
}

/// The diagram as the text of an SVG file; errors as in [`write()`].
pub fn render(diagram: &Diagram) -> io::Result<String> {
    let points = || diagram.series.iter().flat_map(|series| &series.points);
    let x = Scale::new(points().map(|p| p.0), 0.0, 8.0);
    let y = Scale::new(points().map(|p| p.1), 0.09, 6.0).map(|y| y.turned(diagram.downwards));
    let (Some(x), Some(y)) = (x, y) else {
        let message = format!("diagram `{}` has no points, or one that is not finite", diagram.title);
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    };
    draw::svg(diagram, &x, &y).map_err(io::Error::other)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagram(points: Vec<(f64, f64)>, style: Style) -> Diagram {
        let series = vec![Series { label: "a & b".to_string(), style, points }];
        Diagram {
            title: "<t>".to_string(),
            x_label: "x".to_string(),
            y_label: "y".to_string(),
            series,
            ..Diagram::default()
        }
    }

    #[test]
    fn a_million_points_stay_small() {
        let points: Vec<_> = (0..1_000_000).map(|i| (f64::from(i), f64::from(i % 977).sin())).collect();
        for style in [Style::Line, Style::Dots, Style::Dashed] {
            let svg = render(&diagram(points.clone(), style)).unwrap();
            assert!(svg.len() < 200_000, "{style:?}: {} bytes", svg.len());
        }
    }

    #[test]
    fn the_picture_has_its_size_and_escaped_texts() {
        let svg = render(&diagram(vec![(0.0, 0.0), (1.0, -2.5e-6)], Style::Dashed)).unwrap();
        assert!(svg.starts_with("<svg width=\"860\" height=\"420\""), "{}", &svg[..80]);
        assert!(svg.contains("viewBox=\"0 0 8600 4200\"") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("&lt;t&gt;") && svg.contains("a &amp; b"));
        assert!(svg.contains("×10⁻⁶") && svg.contains("−2.5×10⁻⁶"));
        assert!(!svg.lines().any(|line| line.starts_with("0.00")));
        assert!(svg.contains("stroke-dasharray"));
    }

    #[test]
    fn degenerate_diagrams_are_drawn() {
        for points in [
            vec![(0.0, 0.0)],
            vec![(1.0, 5.0)],
            vec![(0.0, 0.0), (1.0, 0.0)],
            vec![(1e-9, 1e12), (1e-9, -1e12)],
        ] {
            for style in [Style::Line, Style::Dots] {
                let svg = render(&diagram(points.clone(), style)).unwrap();
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{points:?}");
            }
        }
    }

    #[test]
    fn a_diagram_without_finite_points_is_refused() {
        for points in [vec![], vec![(0.0, f64::NAN)], vec![(f64::INFINITY, 0.0)]] {
            let error = render(&diagram(points, Style::Line)).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::InvalidInput);
        }
    }
}
