//! How many equilibria a body that breaks will take, and how long, before any is solved: from the bonds that a crack through it cuts.
//! Measured on the gallery; both are right to a factor of three where a crack goes through. One equilibrium is all where no bond breaks.

use crate::case::Strategy;
use crate::run::Sizes;
use crate::scene::Scene;
use crate::scene::body::BodyScene;
use serde::Serialize;
use std::f64::consts::PI;

/// Time per bond and equilibrium, s: 0.6 to 3.3 µs on one core of 2025.
const PER_BOND: f64 = 1.3e-6;
/// Bonds that break at an equilibrium, by the strategy `worst`, by the others, and in a solid, where all along a front break.
const WORST: f64 = 2.7;
const OTHER: f64 = 4.0;
const IN_SOLID: f64 = 20.0;

/// What a run of a body that breaks will take, about, if a crack goes through it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Forecast {
    /// Equilibria.
    pub equilibria: usize,
    /// Time, s.
    pub seconds: f64,
}

/// The forecast of a scene whose bonds break, with its sizes.
pub fn forecast(scene: &Scene, sizes: &Sizes) -> Option<Forecast> {
    let (cut, strategy, most, is_solid) = match scene {
        Scene::Beam(scene) => {
            let fracture = scene.fracture.as_ref()?;
            // All bonds across one section.
            let ratio = scene.case.horizon_ratio.unwrap_or(1.0);
            (ratio * (ratio + 1.0) / 2.0, fracture.strategy, fracture.max_solves, false)
        }
        Scene::Body(scene) => {
            let fracture = scene.fracture.as_ref()?;
            let is_solid = scene.body().is_solid();
            (cut_bonds(scene), fracture.steps.strategy, fracture.steps.max_solves, is_solid)
        }
        Scene::Plate(scene) => {
            let fracture = scene.fracture.as_ref()?;
            // Three bonds per cell of the shorter side.
            let cells = scene.plate.nodes().cells();
            let across = cells.columns().len().min(cells.rows().len());
            (3.0 * across as f64, fracture.strategy, fracture.max_solves, false)
        }
    };
    let at_once = match strategy {
        _ if is_solid => IN_SOLID,
        Strategy::Worst => WORST,
        Strategy::Batch | Strategy::All => OTHER,
    };
    // One more without a broken bond.
    let equilibria = (cut / at_once).round().max(1.0) as usize + 1;
    let equilibria = equilibria.min(most);
    Some(Forecast { equilibria, seconds: PER_BOND * equilibria as f64 * sizes.bonds as f64 })
}

/// Bonds that a crack cuts on its way through the body: on from one that is there, or across the shortest side. Per area of one cell
/// ∫ z dA of half a disc of the horizon, in a solid of half a ball.
fn cut_bonds(scene: &BodyScene) -> f64 {
    let body = scene.body();
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    body.visit(|at| (0..3).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k]))));
    let cells = [0, 1, 2].map(|k| (high[k] - low[k]) / body.spacing() + 1.0);
    let ratio =
        scene.case.horizon_ratio.or_else(|| scene.case.horizon.map(|horizon| horizon / body.spacing()));
    let ratio = ratio.unwrap_or(3.0);
    if body.axes() > 2 {
        let longest = cells.into_iter().fold(0.0, f64::max);
        return PI / 4.0 * ratio.powi(4) * cells.iter().product::<f64>() / longest;
    }
    let ahead = match scene.crack_paths().first() {
        None => cells[0].min(cells[1]),
        Some(crack) => {
            let inside = |at: &[f64; 2], k: usize| at[k].clamp(low[k], high[k]);
            let vertices = crack.vertices();
            let along = |k: usize| {
                let all = || vertices.iter().map(|at| inside(at, k));
                all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
            };
            let axis = usize::from(along(1) > along(0));
            (cells[axis] - along(axis) / body.spacing()).max(1.0)
        }
    };
    2.0 / 3.0 * ratio.powi(3) * ahead
}
