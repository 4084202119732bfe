//! Rings of points around round holes, whose displacements tell the stress on the hole.

use super::load::sums::BodyLoads;
use super::load::traction::on_border::OnBorder;
use super::scene::{BodyScene, BodyState};
use super::site::boundary::Border;
use crate::model::Surface;
use peristat_assembly::body::{BorderPart, Outline, Shape};
use peristat_assembly::correction::HoleZone;
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::recovery::hole::{Ellipse, HoleFields, HoleFit, HoleLoad};

/// Outer over inner radius of a ring.
const WIDEST: f64 = 2.0;
/// The same, at least: narrower rings do not tell the fields apart.
const NARROWEST: f64 = 1.2;
/// In narrower rings few powers are worse than polynomials where displacements are corrected: with ten points per radius 2 to 5 %
/// off, and polynomials 0.5 to 1.3 %.
const NARROW: f64 = 1.3;
/// Highest powers of the fields: the first for which there are enough points. Near an edge high ones are needed: at a hole one
/// radius from it, six powers leave 0.7 % of the stress, however fine the lattice, ten 1e-4 and fourteen 5e-6.
const ORDERS: [usize; 7] = [14, 12, 10, 8, 6, 4, 3];
/// Displacements that the horizon blurs determine powers up to this one.
const HIGHEST_BLURRED: usize = 10;
/// A few points determine powers up to this one.
const MODEST: usize = 6;
/// Equations per field that powers up to it and higher ones need.
const EQUATIONS: [usize; 2] = [3, 12];
/// More points than this add nothing, images among them.
const MOST_POINTS: usize = 4000;
/// A probe is on a hole whose distance from it is no larger a part of the radius: places are written with three or four digits, and
/// the fields around a hole are known beside it, too.
const ON_BORDER: f64 = 1e-3;
/// A line of symmetry runs through the middle of a hole, and an ellipse stands straight, but for rounding.
const SAME: f64 = 1e-6;
/// Places of a border at which its distance is measured.
const PLACES: usize = 64;
/// Horizons around a hole whose points its own tractions load.
const OWN: f64 = 3.0;
/// Forces are none below this share of the largest.
const NO_FORCE: f64 = 1e-12;

/// Points around a round hole that nothing but tractions on it acts on.
#[derive(Clone, Debug)]
pub struct HoleRing {
    ellipse: Ellipse,
    /// Numbers of its points in the model.
    points: Vec<u32>,
    /// Whether lines of symmetry across x and across y run through its middle.
    mirrors: [bool; 2],
    /// Index of its hole.
    hole: usize,
    /// Outer over inner radius.
    reach: f64,
    /// Highest power of the fields that its points tell.
    order: usize,
    /// Tractions on the hole at a factor of one, by load case.
    loads: Vec<HoleLoad>,
}

impl HoleRing {
    /// Rings of the holes on which probes ask for stresses, or of all holes of a body whose displacements are corrected. Bodies that break, that are revolved or curved, or whose moduli are not
    /// those of the material, have none.
    pub(crate) fn of(scene: &BodyScene) -> Vec<Self> {
        // The fields are those of bodies that move in their plane.
        let is_curved = scene.material().about().surface != Surface::Flat || scene.model.along(0).is_none();
        let is_exact = scene.material().about().calibration == Calibration::Matched;
        let (Some(outline), true) = (scene.outline(), is_exact && !is_curved && !scene.case.is_traced())
        else {
            return Vec::new();
        };
        // Stretched unevenly by heat, a body has other fields.
        if scene.load_cases.iter().any(|loads| loads.eigenstrain.is_some()) {
            return Vec::new();
        }
        let is_corrected = scene.limit.is_some();
        let asked = |ellipse: &Ellipse| {
            let mut places = scene.probes.iter().filter(|p| p.is_recovered()).filter_map(|p| p.position);
            places.any(|[x, y, _]| is_on(ellipse, [x, y]))
        };
        let ring = |k: usize| {
            let ellipse = match outline.holes()[k].shape {
                Shape::Circle { centre, radius } => Ellipse { centre, half_axes: [radius; 2], turn: 0.0 },
                Shape::Ellipse { centre, half_axes, turn, .. } => Ellipse { centre, half_axes, turn },
                Shape::Slot { .. } | Shape::Polygon(_) => return None,
            };
            (is_corrected || asked(&ellipse)).then(|| Self::new(scene, outline, k, ellipse)).flatten()
        };
        (0..outline.holes().len()).filter_map(ring).collect()
    }

    fn new(scene: &BodyScene, outline: &Outline, hole: usize, ellipse: Ellipse) -> Option<Self> {
        let radius = ellipse.half_axes[0].min(ellipse.half_axes[1]);
        let sides = sides(scene, &ellipse);
        let loads = loads(scene, hole, (&ellipse, sides));
        let mirrors = sides.map(|side| side != 0.0);
        // The image of one that stands askew is another one.
        if mirrors.contains(&true)
            && (2.0 * ellipse.turn).sin().abs() > SAME
            && ellipse.half_axes[0] != ellipse.half_axes[1]
        {
            return None;
        }
        let free = to_other_borders(scene, outline, hole, &ellipse) - scene.horizon() / radius;
        let mut inside = WIDEST.min(free);
        let own = match loads.iter().any(|load| !load.is_zero()) {
            true => 1.0 + OWN * scene.horizon() / radius,
            false => 1.0,
        };
        let level = |p: usize| ellipse.level(scene.model.place(p));
        for p in loaded(scene)?.into_iter().filter(|p| level(*p) > own).chain(held(scene)) {
            inside = inside.min(level(p));
        }
        // Its fields are of one material.
        let materials = scene.materials();
        if let Some(beside) = scene.nearest(ellipse.centre).filter(|_| !materials.is_one()) {
            let all = || scene.real_points().zip(materials.numbers.iter().zip(&materials.factors));
            let own = all().find(|(p, _)| *p == beside).map(|(_, own)| own);
            for (p, _) in all().filter(|(_, other)| Some(*other) != own) {
                inside = inside.min(level(p) - scene.horizon() / radius);
            }
        }
        if inside < NARROWEST {
            return None;
        }
        let points: Vec<usize> = scene.real_points().filter(|p| (1.0..inside).contains(&level(*p))).collect();
        let images = 1_usize << mirrors.iter().filter(|mirrored| **mirrored).count();
        let step = (images * points.len()).div_ceil(MOST_POINTS).max(1);
        let points: Vec<u32> = points.into_iter().step_by(step).map(|p| p as u32).collect();
        let is_corrected = scene.limit.is_some();
        let order = order_told(2 * images * points.len(), is_corrected)?;
        if is_corrected && inside < NARROW && order <= MODEST {
            return None;
        }
        Some(Self { ellipse, points, mirrors, hole, reach: inside, order, loads })
    }

    /// Where its fields take the place of polynomials: well within the ring that they are fitted to.
    pub(crate) fn zone(&self) -> HoleZone {
        const INNER: f64 = 0.6;
        HoleZone { ellipse: self.ellipse, level: 1.0 + INNER * (self.reach - 1.0) }
    }

    /// Whether its fields tell the stress on a hole, by its index, that falls within a layer far thinner than it.
    pub(crate) fn tells_layer(&self, hole: usize) -> bool {
        self.hole == hole && self.order >= MODEST
    }

    /// Whether a place is on its hole.
    pub(crate) fn holds(&self, place: [f64; 2]) -> bool {
        is_on(&self.ellipse, place)
    }

    /// The fields nearest to the displacements of a state.
    pub(crate) fn fit(&self, scene: &BodyScene, state: &BodyState, u: &[f64]) -> Option<HoleFit> {
        let n = scene.model.points();
        let mut load = HoleLoad::default();
        state.terms.iter().for_each(|&(k, factor)| load.add_multiple(factor, &self.loads[k]));
        let signs = |mirrored: bool| if mirrored { &[1.0, -1.0][..] } else { &[1.0] };
        let images: Vec<[f64; 2]> = signs(self.mirrors[0])
            .iter()
            .flat_map(|x| signs(self.mirrors[1]).iter().map(move |y| [*x, *y]))
            .collect();
        let centre = self.ellipse.centre;
        let moved = |&p: &u32| {
            let (at, u) = (scene.model.place(p as usize), [u[p as usize], u[n + p as usize]]);
            let image = move |sign: &[f64; 2]| {
                let place = [0, 1].map(|k| centre[k] + sign[k] * (at[k] - centre[k]));
                (place, [0, 1].map(|k| sign[k] * u[k]))
            };
            images.iter().map(image)
        };
        let stiffness = scene.model.as_plane()?.stiffness_at(*self.points.first()? as usize);
        let fields = HoleFields::new(&stiffness, self.ellipse, self.order)?;
        HoleFit::new(fields, &load, self.points.iter().flat_map(moved))
    }
}

/// The highest power of the fields that so many equations tell; without corrections displacements are blurred.
fn order_told(equations: usize, is_corrected: bool) -> Option<usize> {
    let is_told = |order: &usize| {
        let needed = EQUATIONS[usize::from(*order > MODEST)];
        (is_corrected || *order <= HIGHEST_BLURRED) && equations >= needed * HoleFields::count_of(*order)
    };
    ORDERS.into_iter().find(is_told)
}

/// Whether a place is on the border of a hole.
pub(crate) fn is_on(ellipse: &Ellipse, at: [f64; 2]) -> bool {
    (ellipse.level(at) - 1.0).abs() <= ON_BORDER
}

/// Tractions on a hole by load case; beyond lines of symmetry those of the image.
fn loads(scene: &BodyScene, hole: usize, (ellipse, sides): (&Ellipse, [f64; 2])) -> Vec<HoleLoad> {
    let acts = |on: &&OnBorder| matches!(on.border, Border::Curved { hole: Some(k), .. } if k == hole);
    let of_case = |loads: &BodyLoads| {
        let mine: Vec<&OnBorder> = loads.on_border.iter().filter(acts).collect();
        HoleLoad::new(ellipse, |at, normal| {
            let away = [0, 1].map(|k| at[k] - ellipse.centre[k]);
            let signs = [0, 1].map(|k| if sides[k] * away[k] < 0.0 { -1.0 } else { 1.0 });
            let at = [0, 1].map(|k| ellipse.centre[k] + signs[k] * away[k]);
            let normal = [0, 1].map(|k| signs[k] * normal[k]);
            mine.iter().fold([0.0; 2], |sum, on| {
                // On a hole every place is like any other.
                let traction = on.profile.at(0.0, at, normal);
                [0, 1].map(|k| sum[k] + signs[k] * traction[k])
            })
        })
    };
    scene.load_cases.iter().map(of_case).collect()
}

/// On which sides of its middle a hole has the body, along x and along y, where lines of symmetry run through it; zero where none does.
fn sides(scene: &BodyScene, ellipse: &Ellipse) -> [f64; 2] {
    [0, 1].map(|k| {
        let at = &scene.inputs.symmetry.at[2 * k..2 * k + 2];
        let runs = |at: Option<f64>| {
            at.is_some_and(|at| (at - ellipse.centre[k]).abs() <= SAME * ellipse.half_axes[k])
        };
        f64::from(u8::from(runs(at[0]))) - f64::from(u8::from(runs(at[1])))
    })
}

/// Level of the nearest other border or crack. Lines of symmetry through the middle are none.
fn to_other_borders(scene: &BodyScene, outline: &Outline, hole: usize, ellipse: &Ellipse) -> f64 {
    let level = |at: [f64; 2]| ellipse.level(at);
    let nearest = |part: BorderPart| {
        let foot = match part {
            BorderPart::Straight { from, to, .. } => foot(ellipse.centre, from, to),
            BorderPart::Round { .. } => 0.0,
        };
        let places = (0..=PLACES).map(|k| k as f64 / PLACES as f64).chain([foot]);
        places.map(|share| level(part.at(share))).fold(f64::INFINITY, f64::min)
    };
    let through = |from: [f64; 2], to: [f64; 2]| {
        let near = |k: usize| {
            [from, to].iter().all(|p| (p[k] - ellipse.centre[k]).abs() <= SAME * ellipse.half_axes[k])
        };
        (0..2).any(near)
    };
    let symmetry = &scene.inputs.symmetry;
    let others = outline.edges().iter().filter(|e| !(symmetry.replaces(&e.name) && through(e.from, e.to)));
    let parts = others.flat_map(|edge| outline.edge_parts(edge));
    let holes = (0..outline.holes().len()).filter(|k| *k != hole).flat_map(|k| outline.hole_parts(k));
    let cracks = scene.cracks.iter().flat_map(|crack| {
        let pieces = crack.crack.vertices().windows(2);
        pieces.map(|ends| BorderPart::Straight { from: ends[0], to: ends[1], normal: [0.0; 2] })
    });
    parts.chain(holes).chain(cracks).map(nearest).fold(f64::INFINITY, f64::min)
}

/// Share of a segment at which it is nearest to a place.
fn foot(place: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let along = [0, 1].map(|k| to[k] - from[k]);
    let up = along[0] * (place[0] - from[0]) + along[1] * (place[1] - from[1]);
    (up / (along[0] * along[0] + along[1] * along[1])).clamp(0.0, 1.0)
}

/// Points that loads act on; none if all of them may be such.
fn loaded(scene: &BodyScene) -> Option<Vec<usize>> {
    let n = scene.model.points();
    let mut found = Vec::new();
    for loads in &scene.load_cases {
        if loads.density != [0.0; 3] || loads.spin != 0.0 {
            return None;
        }
        let mut force = vec![0.0; scene.model.components().len() * n];
        loads.add_to(&*scene.model, 1.0, &mut force);
        let most = force[..2 * n].iter().fold(0.0_f64, |most, f| most.max(f.abs()));
        let acts = |p: &usize| force[*p].abs().max(force[n + p].abs()) > NO_FORCE * most;
        found.extend((0..n).filter(acts));
    }
    Some(found)
}

/// Points that supports, rigid regions or springs hold.
fn held(scene: &BodyScene) -> impl Iterator<Item = usize> + '_ {
    scene.conditions.held_points().chain(scene.conditions.springs.iter().map(|s| s.point))
}
