//! What a traction on a wall of a solid is: its values, from the key that says them.

use super::contact::{Contact, SLACK};
use super::profile::Profile;
use crate::case::{Amount, SpaceAxis, Traction};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::load::context::LoadContext;
use crate::scene::prescribed::{Along, Prescribed};
use peristat_assembly::body::{SIDES, SquareLattice, Wall, WallSide};

/// Places of a side on both halves of an axis, in spacings from its middle: with them cubic functions are integrated exactly.
const GAUSS: f64 = 0.288_675_134_594_812_9;

/// What a traction is on a side of a cell.
#[derive(Clone, Debug)]
pub(super) enum WallValue {
    /// The same force per area everywhere.
    Uniform([f64; 3]),
    /// Against the normal, per area.
    Pressure(f64),
    /// A force, shared by area.
    Total([f64; 3]),
    /// By formulas of the position.
    Formula(Along),
    /// Against the normal, by one.
    PressureFormula(Prescribed),
    /// Against the normal, as a round body presses.
    Contact(Contact),
    /// It varies along an axis, from the first number of metres to the second.
    Along(usize, [f64; 2], Profile),
}

impl WallValue {
    /// Places of a side with the force that acts there, N; `whole` is the area of all sides, m².
    pub(super) fn on(
        &self,
        own: &WallSide,
        lattice: &SquareLattice,
        whole: f64,
    ) -> Vec<([f64; 3], [f64; 3])> {
        let middle = own.side.middle(lattice);
        let value = |given: &Prescribed, at| given.at(at).unwrap_or(f64::NAN);
        match self {
            Self::Formula(given) => on_side(own, lattice)
                .map(|at| (at, [0, 1, 2].map(|k| 0.25 * own.area * value(&given[k], at))))
                .to_vec(),
            Self::PressureFormula(given) => on_side(own, lattice)
                .map(|at| (at, own.outwards.map(|a| -0.25 * a * value(given, at))))
                .to_vec(),
            Self::Uniform(traction) => vec![(middle, traction.map(|t| t * own.area))],
            Self::Pressure(pressure) => vec![(middle, own.outwards.map(|a| -a * pressure))],
            Self::Total(total) => vec![(middle, total.map(|f| f * own.area / whole))],
            Self::Contact(contact) => contact.on(own, lattice).into_iter().collect(),
            Self::Along(axis, [from, to], profile) => [-GAUSS, GAUSS]
                .map(|part| {
                    let mut at = middle;
                    at[*axis] += part * lattice.spacing();
                    let value = profile.at((at[*axis] - from) / (to - from), [0.0; 2], [0.0; 2]);
                    (at, value.map(|t| 0.5 * t * own.area))
                })
                .to_vec(),
        }
    }
}

/// Four places of a side, of the same share each.
fn on_side(own: &WallSide, lattice: &SquareLattice) -> [[f64; 3]; 4] {
    let normal = own.side.normal();
    let across = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or_default();
    let [first, second] = [(across + 1) % 3, (across + 2) % 3];
    [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].map(|[a, b]: [f64; 2]| {
        let mut at = own.side.middle(lattice);
        at[first] += a * GAUSS * lattice.spacing();
        at[second] += b * GAUSS * lattice.spacing();
        at
    })
}

/// What acts, from the one key that says it.
pub(super) fn value(
    load: &Traction,
    (wall, lattice): (&Wall, &SquareLattice),
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<WallValue> {
    let key = key(load, wall, path, faults)?;
    let at = path.key(key);
    let value = match load {
        Traction { uniform: Some(t), .. } => WallValue::Uniform(context.force(*t, key, &at, faults)?),
        Traction { total: Some(total), .. } => WallValue::Total(context.force(*total, key, &at, faults)?),
        Traction { linear: Some(ends), .. } => {
            let [from, to] = [0, 1].map(|k| context.force(ends[k], key, &at.index(k), faults));
            along(load.along, (wall, lattice), Profile::Linear([from?, to?]), context, path, faults)?
        }
        Traction { parabolic: Some(middle), .. } => {
            let middle = context.force(*middle, key, &at, faults)?;
            along(load.along, (wall, lattice), Profile::Parabolic(middle), context, path, faults)?
        }
        Traction { formula: Some(given), .. } => WallValue::Formula(context.along(given, key, &at, faults)?),
        Traction { pressure: Some(given), .. } => match context.prescribed(given, &at, faults)? {
            Prescribed::Number(pressure) => WallValue::Pressure(pressure),
            formula => WallValue::PressureFormula(formula),
        },
        Traction { hertz: Some(given), .. } => {
            let face = (*wall.face()?, wall.name.as_str());
            let slack = SLACK[usize::from(wall.patch().is_some())];
            WallValue::Contact(Contact::on_face(given, face, (lattice.spacing(), slack), &at, faults)?)
        }
        _ => WallValue::Pressure(0.0),
    };
    if value.is_zero() && context.factor.is_none() {
        faults.error(path.clone(), "this traction is zero");
    }
    Some(value)
}

/// The key that says what acts, which must have a meaning on the wall.
fn key(load: &Traction, wall: &Wall, path: &JsonPath, faults: &mut Faults) -> Option<&'static str> {
    let is_round = wall.radius().is_some();
    let values = match (is_round, wall.face()) {
        (true, _) => "give one of `pressure` and `total`",
        (_, None) if wall.patch().is_some() => "give one of `uniform`, `formula`, `pressure` and `total`",
        _ => "give one of `uniform`, `formula`, `pressure`, `total`, `linear`, `parabolic` and `hertz`",
    };
    let given = [
        ("depth", load.depth.is_some()),
        ("sharing", load.sharing.is_some()),
        ("uniform", load.uniform.is_some()),
        ("formula", load.formula.is_some()),
        ("pressure", load.pressure.is_some()),
        ("total", load.total.is_some()),
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
        ("hertz", load.hertz.is_some()),
    ];
    let keys: Vec<&'static str> = given.iter().filter(|given| given.1).map(|given| given.0).collect();
    let varies = |key: &str| ["linear", "parabolic"].contains(&key);
    let is_flat = |key: &str| varies(key) || key == "hertz";
    let (place, message, hint) = match keys[..] {
        [] => (path.clone(), "the value of this traction is missing".to_string(), values),
        [key @ ("depth" | "sharing"), ..] => {
            (path.key(key), format!("`{key}` is for edges in the plane"), values)
        }
        [first, second, ..] => (path.key(second), format!("`{first}` and `{second}` are both given"), values),
        [key] if wall.face().is_none() && is_flat(key) || is_round && key == "uniform" => {
            (path.key(key), format!("`{key}` is for flat faces across an axis"), values)
        }
        ["pressure"] if wall.face().is_none() && matches!(load.pressure, Some(Amount::Formula(_))) => (
            path.key("pressure"),
            "a pressure that a formula gives needs a flat face across an axis: of others cells make stairs, which have another volume"
                .to_string(),
            "give a number",
        ),
        [key] if load.along.is_some() && !varies(key) => {
            (path.key("along"), format!("`{key}` does not vary along an axis"), "leave it out")
        }
        [key] => return Some(key),
    };
    faults.error(place, message).hint(hint);
    None
}

impl WallValue {
    /// The contact that it is, if it is one.
    pub(super) fn contact(&self) -> Option<&Contact> {
        match self {
            Self::Contact(contact) => Some(contact),
            _ => None,
        }
    }

    fn is_zero(&self) -> bool {
        match self {
            Self::Formula(_) | Self::PressureFormula(_) => false,
            Self::Uniform(t) | Self::Total(t) => *t == [0.0; 3],
            Self::Pressure(pressure) => *pressure == 0.0,
            Self::Contact(contact) => contact.is_zero(),
            Self::Along(.., profile) => {
                [0.0, 0.5, 1.0].iter().all(|&place| profile.at(place, [0.0; 2], [0.0; 2]) == [0.0; 3])
            }
        }
    }
}

/// What varies along an axis of a face, from one of its sides to the other.
fn along(
    axis: Option<SpaceAxis>,
    (wall, lattice): (&Wall, &SquareLattice),
    profile: Profile,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<WallValue> {
    let across = wall.face().map(|face| face.axis)?;
    let in_it: Vec<&str> = (0..3).filter(|&k| k != across).map(|k| ["x", "y", "z"][k]).collect();
    let hint = format!("take `{}` or `{}`, which lie in the face `{}`", in_it[0], in_it[1], wall.name);
    let Some(axis) = axis.map(SpaceAxis::number) else {
        faults.error(path.clone(), "`along` is missing: the axis along which the traction varies").hint(hint);
        return None;
    };
    if axis == across {
        faults.error(path.key("along"), "this axis is across the face").hint(hint);
        return None;
    }
    let cells = [lattice.columns(), lattice.rows(), lattice.layers()][axis].clone();
    let box_side = |line: i32| lattice.corner()[axis] + f64::from(line) * lattice.spacing();
    let wall = |side: usize| context.ground.walls.iter().find(|wall| wall.name == SIDES[side]);
    let end = |side: usize, line: i32| {
        wall(side).and_then(Wall::face).map_or_else(|| box_side(line), |face| face.at)
    };
    Some(WallValue::Along(axis, [end(2 * axis, cells.start), end(2 * axis + 1, cells.end)], profile))
}
