//! The map of a body in the plane in its report: all fields of a state, on the deformed shape.

use super::plots::size_of;
use super::raster::{Grid, Limits, Raster};
use crate::case::Arrows::{Displacement, PrincipalStress};
use crate::case::FieldName;
use crate::output::plot::short;
use crate::output::report::{self, Cells, Field, Map, Marks, Moves};
use crate::results::factor::magnification;
use crate::run::body::BodyResult;
use crate::run::scan;
use crate::scene::body::BodyScene;
use crate::summary::words::kind;
use peristat_assembly::body::PointBody;

/// The field of the lengths of displacements.
const DISPLACEMENT: &str = "displacement";

/// Cells of a map: as many as fields of them fit into the report.
const LIMITS: Limits = Limits { blocks: 120_000, along: 1500 };
/// Those of a map of several states.
const OF_STATES: Limits = Limits { blocks: 40_000, along: 1000 };

/// The map of a state.
pub(super) fn map(scene: &BodyScene, result: &BodyResult) -> Map {
    let has_states = scene.case.is_traced() || scene.states.len() > 1;
    let raster = Raster::within(scene, if has_states { OF_STATES } else { LIMITS });
    let grown = raster.between(&result.parted(scene));
    let (fields, moves) =
        fields(scene, result, [FieldName::Ux, FieldName::Uy], &|values| raster.means(values));
    let marks = marks(scene, &fields);
    Map {
        title: String::new(),
        note: note(scene, &raster),
        length: scene.units.length().into(),
        cells: cells(scene, &raster),
        fields,
        moves,
        marks,
        lines: scene.cracks.iter().map(|c| c.crack.vertices().to_vec()).collect(),
        grown: grown.into_iter().map(|[cell, side]| [cell, side, result.record.index]).collect(),
        state: (result.record.index, state_name(scene, result)),
        before: Vec::new(),
    }
}

/// The isolines and arrows that the case asks for: those of displacements on displacements, those of stresses on stresses.
fn marks(scene: &BodyScene, fields: &[Field]) -> Marks {
    let drawing = &scene.case.drawing;
    let numbered = |is: &dyn Fn(&str) -> bool| (0..fields.len()).filter(|&k| is(&fields[k].name)).collect();
    let number = |field: FieldName| fields.iter().position(|own| own.name == field.name());
    let arrows = drawing.arrows.and_then(|arrows| match arrows {
        Displacement => {
            let axes = [FieldName::Ux, FieldName::Uy];
            let moves = axes.into_iter().all(|axis| number(axis).is_some());
            let on = numbered(&|name| name == DISPLACEMENT || axes.iter().any(|axis| axis.name() == name));
            moves.then_some(report::Arrows { on, tensor: None })
        }
        PrincipalStress => {
            let components = [FieldName::StressXx, FieldName::StressYy, FieldName::StressXy];
            let von_mises = FieldName::VonMises.name();
            let on = numbered(&|name| name == von_mises || name.starts_with("stress_"));
            let [xx, yy, xy] = components.map(number);
            Some(report::Arrows { on, tensor: Some([xx?, yy?, xy?]) })
        }
    });
    Marks { isolines: drawing.isolines, arrows }
}

/// What a state is called, with its load factor where it has one of its own.
fn state_name(scene: &BodyScene, result: &BodyResult) -> String {
    let record = &result.record;
    match scene.case.is_traced() || scene.case.steps.is_some() {
        true => format!("{}, load factor {}", record.name, short(record.load_factor)),
        false => record.name.clone(),
    }
}

/// All fields of a state, as means over the cells that are drawn, and how these move along some axes.
pub(super) fn fields<const AXES: usize>(
    scene: &BodyScene,
    result: &BodyResult,
    axes: [FieldName; AXES],
    means: &dyn Fn(&[f64]) -> Vec<f64>,
) -> (Vec<Field>, Option<Moves<AXES>>) {
    let field = |name: &str, unit: &str, values: &[f64]| {
        let range = scan::extremes(values).map_or([0.0; 2], |ends| ends.map(|point| values[point]));
        Field { name: name.into(), unit: unit.into(), values: means(values), range }
    };
    let named =
        |f: FieldName| Some(field(f.name(), f.about().unit.label(scene.units), &result.values(scene, f)?));
    let u = axes.map(|f| result.values(scene, f).unwrap_or_default());
    let points = u.iter().map(|u| u.len()).min().unwrap_or(0);
    let size: Vec<f64> =
        (0..points).map(|p| u.iter().map(|u| u[p]).fold(0.0, |sum: f64, u| sum.hypot(u))).collect();
    let size = field(DISPLACEMENT, scene.units.length(), &size);
    let factor = magnification(size_of(scene), size.range[1]);
    let mut fields: Vec<Field> = ordered(scene, result).into_iter().filter_map(named).collect();
    clear_rounding(&mut fields);
    // What a reader sees first stays first.
    fields.insert(usize::from(!fields.is_empty()), size);
    let numbers = axes.map(|f| fields.iter().position(|own| own.name == f.name()));
    let moves = numbers.iter().all(Option::is_some);
    let moves = moves.then(|| Moves { fields: numbers.map(Option::unwrap_or_default), factor });
    (fields, moves)
}

/// Clears fields that are rounding beside others of their kind.
fn clear_rounding(fields: &mut [Field]) {
    let size = |field: &Field| field.range[0].abs().max(field.range[1].abs());
    let sizes: Vec<(String, f64)> = fields.iter().map(|f| (kind(&f.name).to_string(), size(f))).collect();
    for field in fields {
        let alike = sizes.iter().filter(|(of, _)| of == kind(&field.name));
        let largest = alike.map(|(_, size)| *size).fold(0.0, f64::max);
        if size(field) < 1e-11 * largest {
            field.values.fill(0.0);
            field.range = [0.0; 2];
        }
    }
}

/// The fields of a state, first what tells most: damage where bonds break, the deflection of a shell, else von Mises stress.
fn ordered(scene: &BodyScene, result: &BodyResult) -> Vec<FieldName> {
    let rank = |f: &FieldName| match f {
        FieldName::Damage if scene.case.is_traced() => 0,
        FieldName::W => 1,
        FieldName::VonMises => 2,
        _ => 3,
    };
    let mut fields: Vec<FieldName> = result.fields().collect();
    fields.sort_by_key(rank);
    fields
}

/// What a reader must know of the cells.
fn note(scene: &BodyScene, raster: &Raster) -> String {
    let mut told = Vec::new();
    if let Some(radius) = scene.material().cylinder_radius() {
        let radius = short(radius);
        told.push(format!(
            "The surface, developed: x runs along the axis, y around it at the radius {radius}."
        ));
    }
    let ends = "the colour bar ends at the extremes of all points.";
    match (scene.body(), &raster.grid) {
        (PointBody::Lattice(_), _) if raster.step > 1 => {
            told.push(format!("Every cell is the mean of {0} × {0} points; {ends}", raster.step));
        }
        (PointBody::Cloud(_), Some(_)) => {
            told.push(format!("Every cell is the mean of the points in it; {ends}"))
        }
        _ => {}
    }
    told.extend(scene.case.drawing.arrows.map(|arrows| match arrows {
        Displacement => "Arrows on displacements: where points have moved.".into(),
        PrincipalStress => "Arrows on stresses: principal stresses, inwards in compression.".into(),
    }));
    told.join(" ")
}

fn cells(scene: &BodyScene, raster: &Raster) -> Cells {
    let Some(grid) = &raster.grid else {
        let side = |c: &[[f64; 2]; 4]| c[1][0] - c[0][0];
        return Cells::Squares {
            centres: (0..raster.blocks.len()).map(|block| raster.middle(block)).collect(),
            sides: raster.corners().map(|c| side(&c)).collect(),
        };
    };
    let (origin, sides, last) = layout(scene, raster, grid);
    let mut runs: Vec<[usize; 3]> = Vec::new();
    for [column, row] in grid.cells.iter().map(|cell| cell.map(|k| k as usize)) {
        match runs.last_mut() {
            Some(run) if run[0] == row && run[1] + run[2] == column => run[2] += 1,
            _ => runs.push([row, column, 1]),
        }
    }
    let size = [grid.columns as usize, grid.rows as usize];
    Cells::Grid { origin, sides, size, last, runs, torn: raster.torn(&scene.crack_paths()) }
}

/// Corner and sides of the first block, whether it is there or not, and the parts of the last ones.
fn layout(scene: &BodyScene, raster: &Raster, grid: &Grid) -> ([f64; 2], [[f64; 2]; 2], [f64; 2]) {
    match scene.body() {
        PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
            let (first, step) = ([lattice.columns().start, lattice.rows().start], raster.step);
            let origin = lattice.node(first);
            let side = |k: usize| {
                let mut next = first;
                next[k] += 1;
                let next = lattice.node(next);
                [0, 1].map(|c| step as f64 * (next[c] - origin[c]))
            };
            let last = [lattice.columns().len(), lattice.rows().len()];
            let last = last.map(|count| ((count - 1) % step + 1) as f64 / step as f64);
            (origin, [side(0), side(1)], last)
        }
        PointBody::Cloud(_) => {
            let ([a, b, _, d], cell) = (raster.blocks[0], grid.cells[0].map(f64::from));
            let sides = [b, d].map(|end| [0, 1].map(|c| end[c] - a[c]));
            let origin = [0, 1].map(|c| a[c] - cell[0] * sides[0][c] - cell[1] * sides[1][c]);
            (origin, sides, [1.0; 2])
        }
    }
}
