//! Distributed loads of a scene.

use super::extent::{self, Extent, GivenExtent, Words};
use super::place::{Layout, LayoutLine};
use super::point_load::shares;
use super::resolved_loads::ResolvedLoads;
use crate::case::{Distributed as Written, DistributedForce};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::formula::Formula;
use peristat_assembly::model::timoshenko_beam::{Along, Distributed, Intensity};

/// What messages say of the extent of a load.
const WORDS: Words = Words {
    what: "load",
    on_a_line: "a load on a line has `from` and `to`",
    of_a_line: "a distributed load acts on one line",
    of_a_member: "a load on a frame names its member; `from` and `to` are distances from the joint `from` of that",
};

/// Resolves a distributed load, at the load factor of a step where its formulas know that.
pub(super) fn add(
    load: &Written,
    (layout, factor): (&Layout, Option<f64>),
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    if layout.frame.is_none() {
        let foreign = [
            ("force_x", &load.force_x, "on a line use `axial`"),
            ("force_y", &load.force_y, "on a line use `force`"),
        ];
        for (key, _, hint) in foreign.iter().filter(|(_, given, _)| given.is_some()) {
            faults.error(path.key(*key), format!("`{key}` is for frames")).hint(*hint);
        }
    }
    let given = GivenExtent { member: load.member.as_deref(), from: load.from, to: load.to };
    let extent = extent::find(&given, layout, path, &WORDS, faults);
    if load.forces().all(|(_, value)| value.is_none()) {
        let hint = match layout.frame {
            Some(_) => {
                "give `force`, `axial`, `force_x`, `force_y` or `moment`, each per length of the member"
            }
            None => "give `force`, `moment` or `axial`",
        };
        faults.error(path.clone(), "this load has no value").hint(hint);
    }
    let Some(Extent { chain, from, to: end }) = extent else { return };
    let direction = layout.direction(chain);
    for (key, value) in load.forces() {
        let Some(value) = value else { continue };
        let pieces = pieces((value, factor), &layout.lines[chain], [from, end], &path.key(key), faults);
        // Shares of the value across the line, along it, and in rotation.
        let [across, along, turning] = match key {
            "force" => [1.0, 0.0, 0.0],
            "axial" => [0.0, 1.0, 0.0],
            "moment" => [0.0, 0.0, 1.0],
            _ => {
                let unit = if key == "force_x" { [1.0, 0.0] } else { [0.0, 1.0] };
                let [across, along] = shares(direction, unit);
                [across, along, 0.0]
            }
        };
        let parts = [(across, Along::Transverse), (along, Along::Axial), (turning, Along::Rotation)];
        for (share, along) in parts.into_iter().filter(|(share, _)| *share != 0.0) {
            let piece = |&([from, to], intensity): &Piece| Distributed {
                chain,
                from,
                to,
                intensity: scaled(intensity, share),
                along,
            };
            to.loads.distributed.extend(pieces.iter().map(piece));
        }
    }
}

/// Pieces of a load that a formula gives.
const PIECES: u32 = 256;

/// A part of the loaded length and the value on it.
type Piece = ([f64; 2], Intensity);

/// The values along the loaded length; none where there is a fault.
fn pieces(
    (value, factor): (&DistributedForce, Option<f64>),
    line: &LayoutLine,
    [from, to]: [f64; 2],
    path: &JsonPath,
    faults: &mut Faults,
) -> Vec<Piece> {
    let DistributedForce::Formula(text) = value else {
        return intensity(value, line, [from, to], path, faults)
            .map(|found| ([from, to], found))
            .into_iter()
            .collect();
    };
    let place = |part: f64| from + (to - from) * part / f64::from(PIECES);
    let parabola = |formula: &Formula, k: u32| {
        let [start, middle, end] =
            [0.0, 0.5, 1.0].map(|part| formula.at([place(f64::from(k) + part), 0.0, 0.0]));
        let parabola = Intensity::Parabola { start: start?, middle: middle?, end: end? };
        Ok(([place(f64::from(k)), place(f64::from(k + 1))], parabola))
    };
    let found = Formula::new(text, 1, factor)
        .and_then(|formula| (0..PIECES).map(|k| parabola(&formula, k)).collect());
    found.unwrap_or_else(|reason| {
        faults.error(path.key("formula"), reason).hint("for example `12*sin(pi*x/4)^2`, in x along the line");
        Vec::new()
    })
}

/// A value along the line; `None` where the grid cannot see its waves.
fn intensity(
    value: &DistributedForce,
    line: &LayoutLine,
    [from, to]: [f64; 2],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Intensity> {
    let key = || path.key("sine").key("half_waves");
    match *value {
        // It is in pieces.
        DistributedForce::Formula(_) => None,
        DistributedForce::Uniform(q) => Some(Intensity::Linear { start: q, end: q }),
        DistributedForce::Linear([start, end]) => Some(Intensity::Linear { start, end }),
        DistributedForce::Sine(sine) if sine.half_waves == 0 => {
            faults.error(key(), "`half_waves` must be at least 1, found 0");
            None
        }
        // More half waves than cells look like fewer.
        DistributedForce::Sine(sine) if f64::from(sine.half_waves) > line.cells_between(from, to).ceil() => {
            faults
                .error(
                    key(),
                    format!("{} half waves are more than the grid has cells under the load", sine.half_waves),
                )
                .hint("use more cells; a wave needs several to be seen");
            None
        }
        DistributedForce::Sine(sine) => {
            Some(Intensity::Sine { amplitude: sine.amplitude, half_waves: sine.half_waves })
        }
    }
}

fn scaled(intensity: Intensity, share: f64) -> Intensity {
    match intensity {
        Intensity::Linear { start, end } => Intensity::Linear { start: share * start, end: share * end },
        Intensity::Parabola { start, middle, end } => {
            Intensity::Parabola { start: share * start, middle: share * middle, end: share * end }
        }
        Intensity::Sine { amplitude, half_waves } => {
            Intensity::Sine { amplitude: share * amplitude, half_waves }
        }
    }
}
