//! Winkler foundations of a scene: springs against deflection on the points above them.

use super::extent::{self, Extent, GivenExtent, Words};
use super::one_way::{OneWay, Origin, Part};
use super::place::Layout;
use super::profile;
use crate::case::{BedStiffness, Case, Foundation, Sign};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath, tidy};
use peristat_assembly::material::Profile;
use peristat_assembly::model::timoshenko_beam::{TimoshenkoBeam, W};
use peristat_assembly::stiffness::Spring;

/// What messages say of the extent of a foundation.
const WORDS: Words = Words {
    what: "foundation",
    on_a_line: "a foundation under a line has `from` and `to`",
    of_a_line: "a foundation is under one line",
    of_a_member: "a foundation is under one member of a frame, by its name",
};

/// A foundation under a part of a line.
#[derive(Clone, Debug)]
pub(super) struct Bed {
    /// Line.
    pub(super) chain: usize,
    /// Start and end, in the line's own coordinate.
    pub(super) extent: [f64; 2],
    /// Force per length and deflection, by the distance from the start.
    pub(super) stiffness: Profile,
    /// Sign of the only force with which it pushes, 1 or −1.
    pub(super) only: Option<f64>,
}

/// The foundations of the case.
pub(super) fn beds(case: &Case, layout: &Layout, faults: &mut Faults) -> Vec<Bed> {
    let each = case.foundation.iter().enumerate();
    each.filter_map(|(k, foundation)| bed(foundation, layout, &root("foundation").index(k), faults)).collect()
}

fn bed(foundation: &Foundation, layout: &Layout, path: &JsonPath, faults: &mut Faults) -> Option<Bed> {
    let given =
        GivenExtent { member: foundation.member.as_deref(), from: foundation.from, to: foundation.to };
    let Extent { chain, from, to } = extent::find(&given, layout, path, &WORDS, faults)?;
    let at = path.key("stiffness");
    let stiffness = along(&foundation.stiffness, &at, faults)?;
    let fine =
        profile::is_well_formed(&stiffness, &at, faults) && can_carry(&stiffness, to - from, &at, faults);
    let only = foundation.only.map(Sign::factor);
    fine.then_some(Bed { chain, extent: [from, to], stiffness, only })
}

/// The stiffness by the distance from the start; a fault for one by a formula.
fn along(given: &BedStiffness, path: &JsonPath, faults: &mut Faults) -> Option<Profile> {
    match given {
        BedStiffness::Uniform(value) => Some(Profile::Uniform(*value)),
        BedStiffness::Polynomial(coefficients) => Some(Profile::Polynomial(coefficients.clone())),
        BedStiffness::Table(pairs) => Some(Profile::Table(pairs.clone())),
        BedStiffness::Formula(_) => {
            faults
                .error(path.key("formula"), "a formula is for foundations of plates")
                .hint("under a beam the stiffness is `uniform`, a `polynomial` or a `table`");
            None
        }
    }
}

/// A foundation must not push, and must hold something.
fn can_carry(stiffness: &Profile, length: f64, path: &JsonPath, faults: &mut Faults) -> bool {
    let (s, least) = profile::lowest(stiffness, length);
    if least < 0.0 {
        let place = match stiffness.uniform() {
            Some(_) => String::new(),
            None => format!(" at {} from its start", tidy(s)),
        };
        faults.error(
            path.clone(),
            format!("the stiffness of a foundation must not be negative, found {}{place}", tidy(least)),
        );
        return false;
    }
    let carries = profile::places(&[stiffness], length).into_iter().any(|s| stiffness.value(s) > 0.0);
    if !carries {
        faults
            .error(path.clone(), "this foundation has no stiffness anywhere")
            .hint("it is a force per length and deflection, > 0 somewhere between its ends");
    }
    carries
}

/// The largest number of springs of foundations.
pub(super) fn count(beds: &[Bed], layout: &Layout) -> f64 {
    // Beside both ends of a foundation there may be one more.
    beds.iter().map(|bed| layout.lines[bed.chain].cells_between(bed.extent[0], bed.extent[1]) + 3.0).sum()
}

/// Adds the springs of foundations: the value at a point times its part of the line; the integral over a part that the
/// foundation covers in part or on which it does not vary smoothly. Those of foundations that push one way are named, too.
pub(super) fn add_springs(
    beds: &[Bed],
    beam: &TimoshenkoBeam,
    springs: &mut Vec<Spring>,
    one_way: &mut Vec<OneWay>,
) {
    for (number, bed) in beds.iter().enumerate() {
        let before = springs.len();
        let (chain, [from, to]) = (&beam.chains()[bed.chain], bed.extent);
        let (first, last) = (chain.nearest(from), chain.nearest(to));
        // They may be as many as points: none is copied.
        springs.reserve_exact(last + 3 - first);
        for k in first.saturating_sub(1)..=(last + 1).min(chain.points - 1) {
            let Some(([a, b], at)) = chain.share(k, bed.extent) else { continue };
            let breaks = || bed.stiffness.breaks().iter().map(|pair| from + pair[0]);
            let stiffness = match at.filter(|_| breaks().all(|x| x <= a || x >= b)) {
                Some(x) => bed.stiffness.value(x - from) * (b - a),
                None => bed.stiffness.integral(a - from, b - from),
            };
            if stiffness > 0.0 {
                springs.push(Spring::on(W, beam.first_real(bed.chain) + k, stiffness));
            }
        }
        if let Some(sign) = bed.only {
            let of = |k| OneWay { part: Part::Spring(k), sign, gap: 0.0, origin: Origin::Foundation(number) };
            one_way.extend((before..springs.len()).map(of));
        }
    }
}
