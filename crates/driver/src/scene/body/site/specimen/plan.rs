//! What specimens check of their sizes.

use crate::case::{DiscRegion, Region};
use crate::diagnostic::{Diagnostic, Faults, JsonPath, positive, tidy};

/// Lengths are whole numbers of spacings up to this part of one.
const WHOLE: f64 = 1e-6;
/// Numbers of cells that are tried for a hint.
const MOST_TRIED: usize = 1000;

/// A length of a specimen that cells must fill.
pub(crate) struct Filled {
    /// What it is, for messages.
    pub(crate) what: &'static str,
    /// Spacings along it per cell that the case counts.
    pub(crate) per_cell: f64,
    /// What lies between two of its cells in the middle, `rows` or `columns`, where the crack is there.
    pub(crate) between: Option<&'static str>,
}

impl Filled {
    /// Whether so many cells fill it, and leave the crack between points.
    fn fits(&self, cells: usize) -> bool {
        let count = self.per_cell * cells as f64 / if self.between.is_some() { 2.0 } else { 1.0 };
        (count - count.round()).abs() <= WHOLE && count > 0.5
    }
}

/// A specimen in the making.
pub(crate) struct Plan<'a> {
    /// Where it stands in the case.
    pub(crate) path: JsonPath,
    /// Horizon of a spacing, m.
    pub(crate) horizon: &'a dyn Fn(f64) -> f64,
    pub(crate) faults: &'a mut Faults,
}

impl Plan<'_> {
    /// A fault at a key of the specimen.
    pub(crate) fn error(&mut self, key: &str, message: impl Into<String>) -> &mut Diagnostic {
        self.faults.error(self.path.key(key), message)
    }

    /// Whether lengths, by their keys, are all positive.
    pub(crate) fn positive(&mut self, lengths: &[(&str, f64)]) -> bool {
        let check = |&(key, value): &(&str, f64)| positive(value, key, self.path.key(key), self.faults);
        // All are asked, so that all faults are reported.
        lengths.iter().map(check).filter(|fine| !fine).count() == 0
    }

    /// Whether `cells` fill some lengths.
    pub(crate) fn filled(&mut self, cells: usize, lengths: &[Filled]) -> bool {
        let Some(unfit) = lengths.iter().find(|l| !l.fits(cells)) else { return true };
        let (what, spacings) = (unfit.what, unfit.per_cell * cells as f64);
        let is_whole = (spacings - spacings.round()).abs() <= WHOLE;
        let count = tidy(if is_whole { spacings.round() } else { spacings });
        let message = match unfit.between {
            _ if cells == 0 => "`cells` must be at least 1".to_string(),
            Some(rows) if is_whole => {
                format!(
                    "{what} is {count} spacings, an odd number, which puts the crack through points and not between {rows}"
                )
            }
            _ => format!("{what} is {count} spacings, which is not a whole number"),
        };
        let least = (1..=MOST_TRIED).find(|&k| lengths.iter().all(|l| l.fits(k)));
        self.error("cells", message).hint(match least {
            Some(1) => "any other number fits".to_string(),
            Some(least) => format!("multiples of {least} fit"),
            None => "no number up to 1000 fits: give the specimen lengths with a common divisor".into(),
        });
        false
    }

    /// Whether the tip of the crack is two horizons away from boundaries, given by their names with the distances.
    pub(crate) fn tip(&mut self, horizon: f64, distances: &[(&str, f64)]) -> bool {
        let Some((what, distance)) = distances.iter().find(|d| d.1 < 2.0 * horizon * (1.0 - 1e-9)) else {
            return true;
        };
        let (left, needed) = (tidy(*distance), tidy(2.0 * horizon));
        if *distance <= 0.0 {
            self.error("crack_length", format!("the tip of the crack is beyond {what}, outside of the body"))
                .hint("shorten the crack");
        } else {
            self.error(
                "crack_length",
                format!("the tip of the crack is {left} from {what}, closer than two horizons, {needed}"),
            )
            .hint("use more `cells`, a shorter horizon or another length: the tip needs that much body around it");
        }
        false
    }
}

/// A disc.
pub(crate) fn disc(centre: [f64; 2], radius: f64) -> Region {
    Region::Disc(DiscRegion { centre, radius })
}

/// Several regions.
pub(crate) fn union<const N: usize>(of: [&str; N]) -> Region {
    Region::Union(of.map(Into::into).into())
}
