//! Moduli of materials at the points of a body.

use super::files;
use crate::case::Modulus;
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use crate::input::{Folder, table::Table};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::body::PointBody;

/// How many times stiffer or softer than the base a material may be: beyond it forces of the one are rounding beside the other.
const MOST_RATIO: f64 = 1e9;

/// What a modulus is at a place.
enum ModulusSource {
    Prescribed(Prescribed),
    Table(Table),
}

impl ModulusSource {
    fn at(&self, place: [f64; 3], key: &str, axes: usize) -> Result<f64, String> {
        let here = || place[..axes].iter().map(|x| tidy(*x)).collect::<Vec<_>>().join(", ");
        let value = match self {
            Self::Prescribed(prescribed) => prescribed.at(place)?,
            Self::Table(table) => {
                table.at(place).ok_or_else(|| format!("the table has no value at the point ({})", here()))?
            }
        };
        match value > 0.0 {
            true => Ok(value),
            false => Err(format!(
                "`{key}` must be greater than zero, found {} at the point ({})",
                tidy(value),
                here()
            )),
        }
    }
}

/// Values of a modulus at some points of a body; `base` is that of the base material, `path` where it is given, at `key`. None where
/// one of them is no modulus.
pub(super) fn values(
    given: &Modulus,
    (body, points): (&PointBody, &[u32]),
    (key, base): (&str, f64),
    path: &JsonPath,
    (folder, max_memory): (&Folder, Option<u64>),
    faults: &mut Faults,
) -> Option<Vec<f64>> {
    let axes = body.axes();
    let given = match given {
        Modulus::Amount(amount) => {
            ModulusSource::Prescribed(Prescribed::new(amount, (axes, None), path, faults)?)
        }
        Modulus::Table(table) => {
            ModulusSource::Table(files::table(folder, &table.file, axes, max_memory, path, faults)?)
        }
    };
    let all = if let ModulusSource::Prescribed(Prescribed::Number(value)) = given {
        positive(value, key, path.clone(), faults).then(|| vec![value; points.len()])?
    } else {
        let at = |point: &u32| given.at(body.position(*point as usize), key, axes);
        let all: Result<Vec<f64>, String> = points.iter().map(at).collect();
        let refuse = |reason| {
            faults
                .error(path.clone(), reason)
                .hint("it must be greater than zero at all points of the material, which a table reaches");
        };
        all.map_err(refuse).ok()?
    };
    let is_near = |value: &f64| (1.0 / MOST_RATIO..=MOST_RATIO).contains(&(value / base));
    let are_near = all.iter().all(is_near);
    if !are_near {
        let message =
            format!("it differs from that of `model` by more than a factor of {}", tidy(MOST_RATIO));
        faults
            .error(path.clone(), message)
            .hint("leave voids out of the body, and hold what is rigid by `rigid`");
    }
    are_near.then_some(all)
}
