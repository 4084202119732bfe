//! Distributed loads of a scene.

use super::loads::ResolvedLoads;
use super::place::{Layout, LayoutLine, Place};
use super::point_load::shares;
use super::spot;
use crate::case::{Distributed as Written, DistributedForce};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::model::timoshenko_beam::{Along, Distributed, Intensity};

/// The part of a line that a load covers.
struct Extent {
    chain: usize,
    from: f64,
    to: f64,
}

/// Resolves a distributed load.
pub(super) fn add(
    load: &Written,
    layout: &Layout,
    path: &JsonPath,
    to: &mut ResolvedLoads,
    faults: &mut Faults,
) {
    let extent = match &layout.frame {
        Some(_) => on_member(load, layout, path, faults),
        None => on_line(load, layout, path, faults),
    };
    let values = [
        ("force", load.force),
        ("axial", load.axial),
        ("force_x", load.force_x),
        ("force_y", load.force_y),
        ("moment", load.moment),
    ];
    if values.iter().all(|(_, value)| value.is_none()) {
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
    for (key, value) in values {
        let Some(value) = value else { continue };
        let Some(intensity) = intensity(value, &layout.lines[chain], [from, end], &path.key(key), faults)
        else {
            continue;
        };
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
            let intensity = scaled(intensity, share);
            to.loads.distributed.push(Distributed { chain, from, to: end, intensity, along });
        }
    }
}

/// The extent of a load on a member: all of it if nothing else is said.
fn on_member(load: &Written, layout: &Layout, path: &JsonPath, faults: &mut Faults) -> Option<Extent> {
    let frame = layout.frame.as_ref()?;
    let Some(name) = &load.member else {
        faults.error(path.clone(), "`member` is missing").hint(
            "a load on a frame names its member; `from` and `to` are distances from the joint `from` of that",
        );
        return None;
    };
    let chain = spot::member(name, frame, &path.key("member"), faults)?;
    let line = &layout.lines[chain];
    let (from, to) = (load.from.unwrap_or(0.0), load.to.unwrap_or(line.length));
    for (key, x) in [("from", from), ("to", to)] {
        if !line.holds(x) {
            faults
                .error(path.key(key), format!("the end of the load at x = {x} is off the member `{name}`"))
                .hint(format!("x runs from 0 to {} on this member", super::place::tidy(line.length)));
            return None;
        }
    }
    forwards(Extent { chain, from, to }, path, faults)
}

/// The extent of a load on a line: all of it if the body has one line and nothing else is said.
fn on_line(load: &Written, layout: &Layout, path: &JsonPath, faults: &mut Faults) -> Option<Extent> {
    let foreign = [
        ("member", load.member.is_some(), "a load on a line has `from` and `to`"),
        ("force_x", load.force_x.is_some(), "on a line use `axial`"),
        ("force_y", load.force_y.is_some(), "on a line use `force`"),
    ];
    for (key, _, hint) in foreign.iter().filter(|(_, given, _)| *given) {
        faults.error(path.key(*key), format!("`{key}` is for frames")).hint(*hint);
    }
    let single = layout.lines.len() == 1;
    if !single && (load.from.is_none() || load.to.is_none()) {
        faults
            .error(path.clone(), "`from` and `to` are needed where the body has several lines")
            .hint("a distributed load acts on one line");
        return None;
    }
    let from = load.from.unwrap_or(layout.lines[0].from);
    let to = load.to.unwrap_or(layout.lines[0].to());
    let places = [("from", from), ("to", to)].map(|(key, x)| {
        layout.place(x, &path.key(key), "the end of the load", faults).map(|place: Place| place.chain())
    });
    let [Some(a), Some(b)] = places else { return None };
    if a != b {
        faults
            .error(path.clone(), format!("a load from x = {from} to {to} spans a gap between lines"))
            .hint("give one load per line");
        return None;
    }
    forwards(Extent { chain: a, from, to }, path, faults)
}

fn forwards(extent: Extent, path: &JsonPath, faults: &mut Faults) -> Option<Extent> {
    let Extent { from, to, .. } = extent;
    if from >= to {
        faults.error(path.key("to"), format!("`to` must be greater than `from`, found {from} to {to}"));
        return None;
    }
    Some(extent)
}

/// A value along the line; `None` where the grid cannot see its waves.
fn intensity(
    value: DistributedForce,
    line: &LayoutLine,
    [from, to]: [f64; 2],
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Intensity> {
    let key = || path.key("sine").key("half_waves");
    match value {
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
        Intensity::Sine { amplitude, half_waves } => {
            Intensity::Sine { amplitude: share * amplitude, half_waves }
        }
    }
}
