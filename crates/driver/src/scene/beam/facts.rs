//! What a closed form may know about a state of a scene.

use super::foundation::Bed;
use super::links::RigidBar;
use super::state::State;
use super::supports::HeldPoint;
use crate::reference::{BondClass, End, Facts, Load};
use peristat_assembly::model::timoshenko_beam::end_treatment::EndKind;
use peristat_assembly::model::timoshenko_beam::{Along, Intensity, TimoshenkoBeam};

/// Facts on a beam of one line, x from its left end, or what a beam must be to have some.
pub(super) fn facts(
    beam: &TimoshenkoBeam,
    held: &[HeldPoint],
    bars: &[RigidBar],
    beds: &[Bed],
    state: &State,
) -> Result<Facts, &'static str> {
    let [chain] = beam.chains() else { return Err("a body of one line") };
    let line = chain.line();
    let Some((bending_stiffness, shear_stiffness)) = line.stiffness.plain() else {
        return Err("sections that do not vary or couple");
    };
    let cells = |stations: &Vec<f64>| stations.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let cell = line.stations.as_ref().map_or(chain.spacing, cells);
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-6 * cell;
    let kinds = |x: f64| {
        let mut kinds = held.iter().filter(|h| close(h.x, x)).map(|h| h.kind);
        match (kinds.next(), kinds.next()) {
            (None, _) => End::Free,
            (Some(kind), None) => kind,
            _ => End::Other,
        }
    };
    let (left, right) = (line.from, line.from + line.length);
    let mut ends = [kinds(left), kinds(right)];
    let inside: Vec<&HeldPoint> = held.iter().filter(|h| !close(h.x, left) && !close(h.x, right)).collect();
    if !bars.is_empty() || inside.iter().any(|h| h.kind != End::Simple) {
        // Only simple supports between the ends can be described; anything else, links as well, fits no reference.
        ends = [End::Other; 2];
    }
    let bonds = (0..chain.weights.classes()).map(|class| {
        let bond = chain.bonds.bond(class, 0);
        BondClass { weight: chain.weights.of_class(class), shear_stiffness: bond.shear * bond.length }
    });
    let mut loads = loads(state, left, right, close);
    for bed in beds {
        let whole = close(bed.extent[0], left) && close(bed.extent[1], right);
        let Some(stiffness) = bed.stiffness.uniform().filter(|_| whole) else {
            return Err("foundations that are uniform and under the whole beam");
        };
        if bed.only.is_some() {
            return Err("foundations that push and pull");
        }
        loads.push(Load::Foundation { stiffness });
    }
    Ok(Facts {
        length: line.length,
        bending_stiffness,
        shear_stiffness,
        ends,
        interior_supports: inside.iter().map(|h| h.x - left).collect(),
        loads,
        uniform_grid: chain.line().stations.is_none(),
        spacing: chain.spacing,
        horizon: line.horizon_ratio * chain.spacing,
        bonds: bonds.collect(),
        image_ends: chain.ends() == [EndKind::Mirrored; 2],
        lumped_loads: state.loads.lumped,
        published_law: beam.parameters().bond_law.name == "published",
    })
}

fn loads(state: &State, left: f64, right: f64, close: impl Fn(f64, f64) -> bool) -> Vec<Load> {
    let mut loads: Vec<Load> = state.eigenstrains.iter().map(|_| Load::Other).collect();
    for p in &state.loads.point {
        let x = p.x - left;
        if p.force != 0.0 {
            loads.push(Load::Force { x, value: p.force });
        }
        if p.moment != 0.0 {
            loads.push(Load::Moment { x, value: p.moment });
        }
    }
    for d in &state.loads.distributed {
        let whole = close(d.from, left) && close(d.to, right);
        loads.push(match d.intensity {
            Intensity::Linear { start, end } if whole && start == end && d.along == Along::Rotation => {
                Load::UniformMoment { value: start }
            }
            Intensity::Linear { start, end } if whole && start == end && d.along == Along::Transverse => {
                Load::Uniform { value: start }
            }
            Intensity::Sine { amplitude, half_waves } if whole && d.along == Along::Transverse => {
                Load::Sine { amplitude, half_waves }
            }
            _ => Load::Other,
        });
    }
    loads
}
