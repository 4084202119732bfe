//! Reactions along the lines that supports hold: a table of all, and a diagram of each.

use crate::output::plot::{Diagram, Series, Style};
use crate::results::files::write_table;
use crate::run::PlateResult;
use crate::scene::PlateScene;
use std::io;
use std::path::Path;

/// Name of the table of a state, behind that of the state.
pub(crate) const TABLE: &str = "-supports.csv";

/// Writes forces and moments per length at the points of all lines, which have their numbers from 1 in the summary.
///
/// # Errors
/// The file cannot be written.
pub(super) fn write(file: &Path, scene: &PlateScene, result: &PlateResult) -> io::Result<()> {
    let (nodes, h) = (scene.plate.nodes(), scene.plate.nodes().spacing());
    let mut columns: [(&str, Vec<f64>); 6] =
        ["line", "s", "x", "y", "reaction_per_length", "reaction_moment_per_length"]
            .map(|name| (name, Vec::new()));
    for (number, (line, found)) in scene.held_lines.iter().zip(&result.along_lines.lines).enumerate() {
        for (k, &point) in line.points.iter().enumerate() {
            let [x, y] = nodes.place(point as usize);
            let row = [number as f64 + 1.0, k as f64 * h, x, y, found.force[k], found.moment[k]];
            columns.iter_mut().zip(row).for_each(|(column, value)| column.1.push(value));
        }
    }
    write_table(file, scene.units, &columns.each_ref().map(|(name, values)| (*name, values.as_slice())))
}

/// The reaction per length along every edge or line that is held: all of one direction in one diagram.
pub(super) fn diagrams(scene: &PlateScene, result: &PlateResult, title: &str) -> Vec<(String, Diagram)> {
    let (nodes, units) = (scene.plate.nodes(), scene.units);
    let of_axis = |(axis, name): (usize, &str)| {
        let own = scene.held_lines.iter().zip(&result.along_lines.lines);
        let own = own.filter(|(line, _)| line.along == axis + 1);
        let series = own.map(|(line, found)| Series {
            label: line.name.clone(),
            style: Style::Line,
            points: line
                .points
                .iter()
                .map(|&point| nodes.place(point as usize)[axis])
                .zip(found.force.iter().copied())
                .collect(),
        });
        let diagram = Diagram {
            title: format!("{title} - supports along {name}"),
            x_label: units.label(name, units.length()),
            y_label: units.label("reaction per length", units.force_per_length()),
            series: series.collect(),
            ..Diagram::default()
        };
        (format!("supports_along_{name}"), diagram)
    };
    let all = [(0, "x"), (1, "y")].map(of_axis).into_iter();
    all.filter(|(_, diagram)| !diagram.series.is_empty()).collect()
}
