//! The assembled stiffness of a case as a file, for programs that look at matrices.

use crate::model::with_body;
use crate::output::matrix_market;
use crate::run::body::BodyProblem;
use crate::run::{RunError, RunOptions, Sizes, beam, prepare};
use crate::scene::Scene;
use crate::{Error, Loaded};
use peristat_assembly::model::Component;
use peristat_assembly::system::System;
use std::io;
use std::path::Path;

/// Writes the stiffness before supports as a Matrix Market file.
///
/// # Errors
/// The case needs more memory than there is, or the file cannot be written.
pub fn write(loaded: &Loaded, file: &Path) -> Result<(), Error> {
    match &loaded.scene {
        Scene::Beam(scene) => {
            let points = match scene.frame {
                Some(_) => "of the points, member by member, in the axes of their members",
                None => "of the points from left to right",
            };
            match scene.has_axial {
                true => {
                    let system = beam::prepare::<3>(scene, &RunOptions::default());
                    let order = format!("w_0, phi_0, u_0, w_1, phi_1, u_1, ... {points}");
                    write_stiffness(loaded, system, file, &order)
                }
                false => {
                    let system = beam::prepare::<2>(scene, &RunOptions::default());
                    write_stiffness(loaded, system, file, &format!("w_0, phi_0, w_1, phi_1, ... {points}"))
                }
            }
        }
        Scene::Body(scene) => with_body!(&scene.model, body => {
            let problem = BodyProblem::new(scene, body.clone());
            let system = prepare(&problem, &RunOptions::default());
            write_stiffness(loaded, system, file, &in_plane(scene.model.components()))
        }),
        Scene::Plate(scene) => {
            let system = prepare(&**scene, &RunOptions::default());
            write_stiffness(
                loaded,
                system,
                file,
                "w_0, phi_x_0, phi_y_0, w_1, ... of the points row by row from the lower left",
            )
        }
    }
}

/// The order of the unknowns of a body in the plane.
fn in_plane(components: &[Component]) -> String {
    let of_point = |component: &Component| match component.is_rotation {
        true => format!("h {}_0", component.name),
        false => format!("{}_0", component.name),
    };
    let first: Vec<String> = components.iter().map(of_point).collect();
    let explained = if components.iter().any(|c| c.is_rotation) { "with the spacing h, " } else { "" };
    let next = components[0].name;
    format!("{}, {next}_1, ... {explained}of the points row by row from the lower left", first.join(", "))
}

fn write_stiffness<const D: usize>(
    loaded: &Loaded,
    prepared: Result<(System<D>, Sizes), RunError>,
    file: &Path,
    order: &str,
) -> Result<(), Error> {
    let (system, _) = prepared.map_err(|e| loaded.explain(e))?;
    let matrix = system.stiffness().to_csr(|point, component| D * point + component);
    let entries: Vec<(usize, usize, f64)> = matrix.iter().map(|(&v, (i, j))| (i, j, v)).collect();
    let comments = [
        format!(
            "stiffness of `{}` before supports, links and springs are applied",
            loaded.scene.case().title
        ),
        format!("unknowns in the order {order}"),
    ];
    matrix_market::write(file, system.size(), &entries, &comments)
        .map_err(|error| io::Error::new(error.kind(), format!("cannot write {}: {error}", file.display())))?;
    Ok(())
}
