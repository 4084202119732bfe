//! Stress intensities of cracks, as a case asks for them.

use super::front::{FrontFault, FrontJump};
use super::jump::Jump;
use crate::case::{Case, TipQuantity, Tips};
use crate::diagnostic::{Faults, JsonPath, root, suggest, tidy};
use crate::scene::body::site::cracks::NamedCrack;
use crate::scene::body::site::tips;
use peristat_assembly::body::{Crack, CrackSurface};
use std::collections::HashSet;

/// Spacings of the radius of a front below which its stress intensity is more than some per cent off.
const FEW: f64 = 4.0;

/// A stress intensity that is asked for.
#[derive(Clone, Debug)]
pub struct Intensity {
    /// Name.
    pub name: String,
    /// Index of the crack.
    pub crack: usize,
    /// Which tips move; none of the front of a crack in a solid.
    pub tips: Option<Tips>,
    /// What is reported of them.
    pub quantity: TipQuantity,
    /// How the faces part at the tip, where its modes are asked for.
    pub(crate) jump: Option<Jump>,
    /// How they part at a place of the front of a crack in a solid, where it is asked for.
    pub(crate) front: Option<FrontJump>,
}

/// How the faces of a crack part at a tip: of the tip and the vertex before it, if these leave room for it.
pub(crate) type FindJump<'a> = dyn Fn([[f64; 2]; 2]) -> Option<Jump> + 'a;

/// How the faces of a crack of this number, a surface, part at the place of its front nearest to a position.
pub(crate) type FindFront<'a> = dyn Fn(usize, [f64; 3]) -> Result<FrontJump, FrontFault> + 'a;

/// Stress intensities of the case.
pub(crate) fn intensities(
    case: &Case,
    cracks: &[NamedCrack],
    contains: &dyn Fn([f64; 2]) -> bool,
    around: &tips::Around,
    (find_jump, find_front): (Option<&FindJump>, &FindFront),
    faults: &mut Faults,
) -> Vec<Intensity> {
    let (mut found, mut slanted) = (Vec::new(), HashSet::new());
    let mut names: HashSet<&str> = case.probes.iter().map(|p| p.name.as_str()).collect();
    for (k, given) in case.stress_intensity.iter().enumerate() {
        let path = root("stress_intensity").index(k);
        if !names.insert(&given.name) {
            faults
                .error(path.key("name"), format!("the name `{}` is taken", given.name))
                .hint("probes and stress intensities must differ in their names");
        }
        let Some(crack) = cracks.iter().position(|c| c.name == given.crack.0) else {
            faults
                .error(path.key("crack"), format!("there is no crack `{}`", given.crack.0))
                .hint(suggest(&given.crack.0, cracks.iter().map(|c| c.name.as_str())));
            continue;
        };
        let tips = match (&cracks[crack].crack, given.tips) {
            (solid, tips) if solid.surface().is_some() => {
                check_front((solid, tips, given.at), around, &path, faults);
                None
            }
            (_, _) if given.at.is_some() => {
                faults.error(path.key("at"), "a crack in the plane has tips").hint("name them by `tips`");
                continue;
            }
            (_, None) => {
                faults
                    .error(path, "`tips` is missing")
                    .hint("`start`, `end` or `both`: those that are in the body");
                continue;
            }
            (_, Some(tips)) => {
                check_tips((crack, tips), cracks, (contains, around), &path, faults);
                Some(tips)
            }
        };
        if case.path.is_some() && given.quantity != TipQuantity::K {
            faults
                .error(path.key("quantity"), "of a body that softens the stress intensity alone is followed")
                .hint("leave `quantity` out: `j_integral` is in the curve");
        }
        let front = match (given.at, cracks[crack].crack.surface()) {
            (Some(at), Some(_)) => {
                place_of_front(crack, at, (find_front, around.spacing), &path.key("at"), faults)
            }
            _ => None,
        };
        if front.as_ref().is_some_and(FrontJump::is_slanted) && slanted.insert(crack) {
            warn_of_slant(&path.key("at"), faults);
        }
        let jump = match given.quantity {
            _ if given.at.is_some() => None,
            TipQuantity::KIII if cracks[crack].crack.surface().is_none() => {
                faults
                    .error(path.key("quantity"), "K_III is that of a place of a front in a solid")
                    .hint("give the place by `at`, in a solid; in antiplane shear leave `quantity` out");
                None
            }
            TipQuantity::KI | TipQuantity::KII | TipQuantity::KIII => {
                jump(&cracks[crack].crack, tips, find_jump, &path.key("quantity"), faults)
            }
            TipQuantity::K | TipQuantity::EnergyReleaseRate => None,
        };
        let (name, quantity) = (given.name.clone(), given.quantity);
        found.push(Intensity { name, crack, tips, quantity, jump, front });
    }
    found
}

/// Adds what is known of the errors at fronts that no layer of points lies along.
fn warn_of_slant(path: &JsonPath, faults: &mut Faults) {
    faults
        .warning(
            path.clone(),
            "the crack is slanted to the layers of points: on a disc with eight of them over its radius K_I is off by up to 6 % at a place of the front, and by 12 % where the faces slide, K_II and K_III by a sixth of the largest K",
        )
        .hint("turn the body so that the crack is across x, y or z; the mean of places all around is better, K_I of a disc within 3 %");
}

/// How the faces of a crack part at a place of its front.
fn place_of_front(
    crack: usize,
    at: [f64; 3],
    (find, spacing): (&FindFront, f64),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<FrontJump> {
    match find(crack, at) {
        Ok(found) => return Some(found),
        Err(FrontFault::Far) => {
            faults
                .error(
                    path.clone(),
                    "there is no front of the crack in the body within a spacing of this position",
                )
                .hint("give a position on it; a disc has its front on its rim, a polygon on its edges");
        }
        Err(FrontFault::Short { spacings }) => {
            let far = tidy(spacings * spacing);
            faults
                .error(
                    path.clone(),
                    format!("behind this position the crack is not plane, in the body and without another front or crack for {far}"),
                )
                .hint("its faces are compared up to there: use a smaller spacing, or another position");
        }
    }
    None
}

/// How the faces of a crack part at the one tip whose modes are asked for.
fn jump(
    crack: &Crack,
    tips: Option<Tips>,
    find: Option<&FindJump>,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Jump> {
    if crack.surface().is_some() {
        faults
            .error(path.clone(), "a front has modes at each of its places")
            .hint("give a position on the front by `at`");
        return None;
    }
    let (Some(find), Some(tips)) = (find, tips) else {
        faults
            .error(path.clone(), "only tips of cracks whose faces move in the plane have separate modes")
            .hint("leave `quantity` out");
        return None;
    };
    let v = crack.vertices();
    let last = v.len() - 1;
    let ends = match tips {
        Tips::Start => [v[0], v[1]],
        Tips::End => [v[last], v[last - 1]],
        Tips::Both => {
            faults
                .error(path.clone(), "modes are those of one tip, and `tips` names both")
                .hint("ask for `start` and `end` by two names");
            return None;
        }
    };
    let found = find(ends);
    if found.is_none() {
        faults
            .error(path.clone(), "the crack is straight for less than eight spacings before its tip")
            .hint("use a smaller spacing: its faces are compared up to four spacings behind the tip");
    }
    found
}

/// Faults of tips that are none.
fn check_tips(
    (crack, tips): (usize, Tips),
    cracks: &[NamedCrack],
    (contains, around): (&dyn Fn([f64; 2]) -> bool, &tips::Around),
    path: &JsonPath,
    faults: &mut Faults,
) {
    let vertices = cracks[crack].crack.vertices();
    let ends = [("start", vertices[0], Tips::End), ("end", vertices[vertices.len() - 1], Tips::Start)];
    for (end, tip, other) in ends {
        if tips != other && !contains(tip) {
            let at = format!("({}, {})", tidy(tip[0]), tidy(tip[1]));
            faults
                .error(path.key("tips"), format!("the {end} of the crack at {at} is not in the body"))
                .hint("name the tips that are: `start` is the first position of the path, `end` the last");
        }
    }
    for (end, tip, _) in ends.into_iter().filter(|e| tips != e.2) {
        let before = if end == "start" { vertices[1] } else { vertices[vertices.len() - 2] };
        if let Some(met) = tips::met(tip, before, crack, cracks, around) {
            let at = format!("({}, {})", tidy(tip[0]), tidy(tip[1]));
            faults
                .error(path.key("tips"), format!("the {end} of the crack at {at} {met}, so it is no tip"))
                .hint("a tip needs a spacing of whole body before it, and no other crack along the last spacing");
        }
    }
}

/// Faults of a crack in a solid that has no front to move.
fn check_front(
    (crack, tips, at): (&Crack, Option<Tips>, Option<[f64; 3]>),
    around: &tips::Around,
    path: &JsonPath,
    faults: &mut Faults,
) {
    if !around.is_lattice {
        faults
            .error(
                path.key("crack"),
                "the area by which a crack grows is counted in cells, which listed points have not",
            )
            .hint("find the stress intensity from the energies of two runs with cracks of different size");
        return;
    }
    if tips.is_some() {
        faults.error(path.key("tips"), "the front of a crack in a solid has no tips").hint("leave it out");
    }
    if at.is_some() {
        return;
    }
    let radius = crack.surface().and_then(CrackSurface::front_radius);
    if radius.is_some_and(|radius| radius < FEW * around.spacing) {
        faults
            .warning(
                path.key("crack"),
                format!("the front of this crack has a radius of less than {FEW} spacings"),
            )
            .hint("use a smaller spacing: with one its stress intensity is a third too large");
    }
    if radius.is_none() {
        faults
            .error(path.key("crack"), "the mean along a front is that of a `disc`")
            .hint("give a position on the front by `at`");
    }
}

/// A crack with some of its tips, or without them its front, moved along it, outwards if `by` (m) is positive.
pub(crate) fn moved(crack: &Crack, tips: Option<Tips>, by: f64) -> Option<Crack> {
    let Some(tips) = tips else { return crack.surface()?.grown(by).map(Crack::from) };
    let mut vertices = crack.vertices().to_vec();
    let last = vertices.len() - 1;
    let mut shift = |tip: usize, before: usize| {
        let d = [0, 1].map(|k| vertices[tip][k] - vertices[before][k]);
        let length = d[0].hypot(d[1]);
        (0..2).for_each(|k| vertices[tip][k] += by / length * d[k]);
        length + by > 0.0
    };
    let mut fine = true;
    if tips != Tips::End {
        fine &= shift(0, 1);
    }
    if tips != Tips::Start {
        fine &= shift(last, last - 1);
    }
    if fine { Crack::new(vertices).ok() } else { None }
}
