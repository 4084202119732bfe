//! The same body with other cells, as overrides of its case.

use super::{Body, Case, Grading};
use crate::diagnostic::JsonPath;
use peristat_assembly::body::fitting_spacings;
use serde_json::Value;

/// Overrides of a case: paths and values.
pub type Overrides = Vec<(JsonPath, Value)>;

/// How far a number of cells may be from a whole one.
const SLACK: f64 = 1e-9;

/// Why some bodies are not refined.
const NO_SPACING: &str = "listed points and meshes have no spacing to change";

/// The greatest common divisor.
fn common(a: usize, b: usize) -> usize {
    if b == 0 { a } else { common(b, a % b) }
}

impl Case {
    /// Overrides that divide the spacing of the body by a factor: whole numbers of cells are multiplied by it, lengths of
    /// cells divided.
    ///
    /// # Errors
    /// The body has no spacing to change, or the factor leaves a part of a cell.
    pub fn with_spacing_over(&self, factor: f64) -> Result<Overrides, String> {
        let body = JsonPath::default().key("body");
        let cells = |path: JsonPath, cells: usize, grading: Option<&Grading>| {
            if matches!(grading, Some(Grading::Positions(_))) {
                return Err(format!("`{path}`: a grid of listed positions has no spacing to change"));
            }
            let wanted = cells as f64 * factor;
            match wanted.round() >= 1.0 && (wanted - wanted.round()).abs() <= SLACK * wanted {
                true => Ok((path, Value::from(wanted.round() as u64))),
                false => Err(format!("`{path}`: {cells} cells times {factor} are no whole number of cells")),
            }
        };
        let spacing = |kind: &str, spacing: f64| {
            Ok(vec![(body.key(kind).key("spacing"), Value::from(spacing / factor))])
        };
        let specimen = |kind: &str, count: usize| Ok(vec![cells(body.key(kind).key("cells"), count, None)?]);
        match &self.body {
            Body::Line(line) => {
                Ok(vec![cells(body.key("line").key("cells"), line.cells, line.grading.as_ref())?])
            }
            Body::Lines(lines) => {
                let path = |k: usize| body.key("lines").index(k).key("cells");
                let all = lines.iter().enumerate();
                all.map(|(k, line)| cells(path(k), line.cells, line.grading.as_ref())).collect()
            }
            Body::Frame(frame) => {
                let path = |k: usize| body.key("frame").key("members").index(k).key("cells");
                let all = frame.members.iter().enumerate();
                all.map(|(k, member)| cells(path(k), member.cells, member.grading.as_ref())).collect()
            }
            Body::Rectangle(rectangle) => spacing("rectangle", rectangle.spacing),
            Body::Outline(outline) => spacing("outline", outline.spacing),
            Body::Block(block) => spacing("block", block.spacing),
            Body::Solid(solid) => spacing("solid", solid.spacing),
            Body::CompactTension(s) => specimen("compact_tension", s.cells),
            Body::SingleEdgeBend(s) => specimen("single_edge_bend", s.cells),
            Body::CentreCrackedPanel(s) => specimen("centre_cracked_panel", s.cells),
            Body::Points(_) | Body::Mesh(_) => Err(NO_SPACING.into()),
        }
    }

    /// The nearest factors by which the spacing can be divided, so that no part of a cell is left: the first not below the one
    /// that is asked for, and the last below it.
    ///
    /// # Errors
    /// The body has no spacing to change.
    pub fn fitting_factors(&self, asked: f64) -> Result<[Option<f64>; 2], String> {
        let of_cells = |cells: usize| {
            let finer = (cells as f64 * asked * (1.0 - SLACK)).ceil().max(1.0);
            let coarser = Some(finer - 1.0).filter(|n| *n >= 1.0);
            [Some(finer), coarser].map(|number| number.map(|n| n / cells as f64))
        };
        let of_sides = |sides: &[f64], spacing: f64| {
            fitting_spacings(sides, spacing / asked).map(|fitting| fitting.map(|own| spacing / own))
        };
        match &self.body {
            Body::Line(line) => Ok(of_cells(line.cells)),
            Body::Lines(lines) => Ok(of_cells(lines.iter().fold(0, |all, line| common(all, line.cells)))),
            Body::Frame(frame) => {
                Ok(of_cells(frame.members.iter().fold(0, |all, member| common(all, member.cells))))
            }
            Body::Rectangle(rectangle) => Ok(of_sides(&rectangle.size, rectangle.spacing)),
            Body::Block(block) => Ok(of_sides(&block.size, block.spacing)),
            Body::CompactTension(s) => Ok(of_cells(s.cells)),
            Body::SingleEdgeBend(s) => Ok(of_cells(s.cells)),
            Body::CentreCrackedPanel(s) => Ok(of_cells(s.cells)),
            Body::Outline(_) | Body::Solid(_) => Ok([Some(asked), None]),
            Body::Points(_) | Body::Mesh(_) => Err(NO_SPACING.into()),
        }
    }

    /// Whether a crack that runs along an axis of a rectangle runs through points, if the spacing is divided by a factor: it
    /// would cut all of their bonds.
    pub fn cracks_run_through_points(&self, factor: f64) -> bool {
        let Body::Rectangle(rectangle) = &self.body else { return false };
        let is_on_points = |axis: usize, value: f64| {
            let cells = (value - rectangle.from[axis]) * factor / rectangle.spacing;
            let place = cells - 0.5;
            cells > 0.0
                && value < rectangle.from[axis] + rectangle.size[axis]
                && (place - place.round()).abs() <= SLACK * cells.max(1.0)
        };
        let runs = |ends: &[[f64; 2]]| {
            [0, 1].into_iter().any(|axis| ends[0][axis] == ends[1][axis] && is_on_points(axis, ends[0][axis]))
        };
        self.cracks.iter().filter_map(|crack| crack.path.as_deref()).any(|path| path.windows(2).any(runs))
    }

    /// [`Self::with_spacing_over`] with the horizon divided alike, so that their ratio stays.
    ///
    /// # Errors
    /// As [`Case::with_spacing_over`].
    pub fn refined(&self, factor: f64) -> Result<Overrides, String> {
        let mut overrides = self.with_spacing_over(factor)?;
        if let Some(horizon) = self.horizon {
            overrides.push((JsonPath::default().key("horizon"), Value::from(horizon / factor)));
        }
        Ok(overrides)
    }
}

#[cfg(test)]
mod tests {
    use crate::case::from_text;

    fn refined(text: &str, factor: f64) -> Result<Vec<String>, String> {
        let case = from_text("case", text.into(), &[], &crate::input::Folder::default()).unwrap().case;
        Ok(case.refined(factor)?.iter().map(|(path, value)| format!("{path}={value}")).collect())
    }

    #[test]
    fn cells_are_multiplied_and_lengths_divided() {
        let beam = crate::model::start("timoshenko_beam").unwrap();
        assert_eq!(refined(beam, 2.0).unwrap(), ["body.line.cells=192"]);
        assert_eq!(refined(beam, 0.5).unwrap(), ["body.line.cells=48"]);
        assert!(refined(beam, 0.3).unwrap_err().contains("no whole number"));
        let frame = crate::model::start("plane_frame").unwrap();
        assert!(refined(frame, 2.0).unwrap().len() > 1);
        let plate = crate::model::start("bond_plane").unwrap();
        let spacing = refined(plate, 2.0).unwrap();
        assert!(spacing.len() == 1 && spacing[0].starts_with("body.rectangle.spacing="), "{spacing:?}");
    }
}
