//! Maps of a state of a body in the plane: displacement on the deformed shape, von Mises stress, damage.

use super::apart::Side;
use super::marks;
use super::raster::Raster;
use super::surface;
use crate::case::{Arrows, FieldName};
use crate::output::plot::{self, Isoline, Map, Patch, write_map};
use crate::results::factor::magnification;
use crate::run::body::BodyResult;
use crate::run::scan;
use crate::scene::body::BodyScene;
use crate::scene::words;
use std::io;
use std::path::Path;

/// Writes the maps of a state into a folder.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(folder: &Path, scene: &BodyScene, result: &BodyResult) -> io::Result<()> {
    let title = title(scene, result);
    if scene.body().is_solid() {
        return surface::write(folder, scene, result, &title);
    }
    let raster = Raster::new(scene);
    let apart = raster.between(&result.parted(scene));
    let torn = [raster.torn(&scene.crack_paths()), apart.clone()].concat();
    let drawing = &scene.case.drawing;
    let corners: Vec<_> = raster.corners().collect();
    let given = scene.cracks.iter().map(|c| c.crack.vertices().to_vec());
    let grown = apart.iter().filter_map(|&side| raster.faces(side, &corners).into_iter().next());
    let lines: Vec<Vec<[f64; 2]>> = given.chain(grown).collect();
    write_map(&folder.join("displacement.svg"), &displacement(scene, result, (&raster, &torn), &title))?;
    let stress = scene.units.label("von Mises stress", scene.units.stress());
    let deflection = scene.units.label("w, outwards", scene.units.length());
    let fields = [
        ("w", FieldName::W, deflection.as_str()),
        ("von_mises", FieldName::VonMises, stress.as_str()),
        ("damage", FieldName::Damage, "damage: cut share of the family"),
    ];
    for (file, field, label) in fields.into_iter().filter(|f| result.fields().any(|own| own == f.1)) {
        let Some(values) = result.values(scene, field) else { continue };
        let means = raster.means(&values);
        let (range, mut note) = range(scene, &values);
        let isolines = isolines(scene, (&raster, &torn), (&means, &corners), range);
        let mut arrows = Vec::new();
        if field == FieldName::VonMises && drawing.arrows == Some(Arrows::PrincipalStress) {
            note += "; arrows: principal stresses, inwards in compression";
            let stresses = [FieldName::StressXx, FieldName::StressYy, FieldName::StressXy];
            let means = |field| raster.means(&result.values(scene, field).unwrap_or_default());
            arrows = marks::principal_stresses(&raster, &stresses.map(means));
        }
        let patches =
            corners.iter().zip(means).map(|(corners, value)| Patch::flat(*corners, value)).collect();
        let (title, label, lines) = (title.clone(), label.into(), lines.clone());
        let map = Map { title, note, label, range, patches, lines, isolines, arrows, ..Map::default() };
        write_map(&folder.join(format!("{file}.svg")), &map)?;
    }
    Ok(())
}

/// The title of a state: that of the case, and its name where there are several.
pub(super) fn title(scene: &BodyScene, result: &BodyResult) -> String {
    match scene.states.len() {
        1 if !scene.case.is_traced() => scene.case.title.clone(),
        _ => format!("{} - {}", scene.case.title, result.record.name),
    }
}

/// Smallest and largest value, and a note that says where they are.
pub(super) fn range(scene: &BodyScene, values: &[f64]) -> ([f64; 2], String) {
    let Some([low, high]) = scan::extremes(values) else { return ([0.0; 2], String::new()) };
    let place = |point: usize| {
        let at = scene.body().position(point);
        words::placed(at, scene.body(), plot::short)
    };
    let note = format!("smallest at {}, largest at {}", place(low), place(high));
    ([values[low], values[high]], note)
}

/// Length of the diagonal around the points.
pub(super) fn size_of(scene: &BodyScene) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    scene.body().visit(|at| {
        (0..3).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k])));
    });
    (high[0] - low[0]).hypot(high[1] - low[1]).hypot(high[2] - low[2])
}

/// The magnitude of the displacement on the deformed shape.
fn displacement(
    scene: &BodyScene,
    result: &BodyResult,
    (raster, apart): (&Raster, &[Side]),
    title: &str,
) -> Map {
    let [ux, uy] = [FieldName::Ux, FieldName::Uy].map(|f| result.values(scene, f).unwrap_or_default());
    let size: Vec<f64> = ux.iter().zip(&uy[..]).map(|(x, y)| x.hypot(*y)).collect();
    let (range, note) = range(scene, &size);
    let factor = magnification(size_of(scene), range[1]);
    let means = [raster.means(&ux), raster.means(&uy)];
    let corners = raster.deformed(&means, factor, apart);
    let lines = apart.iter().flat_map(|&side| raster.faces(side, &corners)).collect();
    let sizes = raster.means(&size);
    let isolines = isolines(scene, (raster, apart), (&sizes, &corners), range);
    let arrows = match scene.case.drawing.arrows {
        Some(Arrows::Displacement) => marks::displacements(raster, &means, factor),
        _ => Vec::new(),
    };
    let patches = corners.into_iter().zip(sizes);
    Map {
        title: title.into(),
        note: format!("deformed shape, displacements times {factor}; {note}"),
        label: scene.units.label("displacement", scene.units.length()),
        range,
        patches: patches.map(|(corners, value)| Patch::flat(corners, value)).collect(),
        ghost: raster.corners().collect(),
        lines,
        isolines,
        arrows,
    }
}

/// The isolines that the case asks for, of means over blocks with some corners.
fn isolines(
    scene: &BodyScene,
    (raster, apart): (&Raster, &[Side]),
    (means, corners): (&[f64], &[[[f64; 2]; 4]]),
    range: [f64; 2],
) -> Vec<Isoline> {
    let Some(count) = scene.case.drawing.isolines else { return Vec::new() };
    let middle = |c: &[[f64; 2]; 4]| [0, 1].map(|k| 0.25 * (c[0][k] + c[1][k] + c[2][k] + c[3][k]));
    let middles: Vec<[f64; 2]> = corners.iter().map(middle).collect();
    marks::isolines(raster, (means, &middles), apart, (range, count))
}
