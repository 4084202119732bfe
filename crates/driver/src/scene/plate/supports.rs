//! Supports of a plate as equations and springs.

use super::border::Side;
use super::clamped_stairs::{self, Followed};
use super::restraints::{Place, Restraints};
use super::site::Site;
use super::{support_keys, support_springs, symmetry};
use crate::case::{Amount, Support};
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::site::place_of_point;
use crate::scene::prescribed::Motion;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, W};
use std::collections::BTreeMap;

/// The supports of the case.
pub(super) fn held(site: &Site, faults: &mut Faults) -> Restraints {
    let mut held = Restraints::default();
    if site.case.supports.is_empty() && site.case.foundation.is_empty() {
        faults
            .error(root("supports"), "nothing holds the plate: `supports` is empty")
            .hint(r#"a simple support all around is { "at": { "region": "all" }, "w": 0.0, "phi_t": 0.0 }"#)
            .in_solution_only();
    }
    for (k, support) in site.case.supports.iter().enumerate() {
        let path = root("supports").index(k);
        support_keys::check(support, &path, faults);
        let Some(spot) = site.spot(&support.at, &path.key("at"), "the support", faults) else { continue };
        place_of_point::doubt(site.ground, &support.at, &spot, &path.key("at"), faults);
        for name in support.at.region.iter().flat_map(|names| site.ground.edges_of(names)) {
            symmetry::not_mirrored(site, &name, &path.key("at").key("region"), faults);
        }
        let mut of =
            OneSupport { site, path: &path, support, equations: Vec::new(), followed: BTreeMap::new() };
        let sides = of.sides(&spot.points);
        of.clamp_steps(&spot.points, &sides);
        of.hold_deflection(&spot.points, &sides, faults);
        of.hold_rotations(&spot.points, &sides, faults);
        let equations = of.equations;
        let springs = support_springs::springs(support, site, (&spot.points, &sides), &path, faults);
        let place = Place { name: spot.words, points: spot.points, sides, is_mirror: false };
        held.take(place, equations, springs);
    }
    held
}

struct OneSupport<'a> {
    site: &'a Site<'a>,
    path: &'a JsonPath,
    support: &'a Support,
    /// With what they prescribe in every load step, where that is not in proportion to the load factor.
    equations: Vec<(Equation, Vec<f64>)>,
    /// Points of steps that are clamped by what is deeper in the plate.
    followed: BTreeMap<u32, Followed>,
}

impl OneSupport<'_> {
    /// The sides that it holds: those of its part of the border, or all between its points.
    fn sides(&self, points: &[u32]) -> Vec<Side> {
        let named = self.support.at.region.as_ref().and_then(|name| self.site.sides(name));
        named.unwrap_or_else(|| {
            let all = self.site.border.all().iter();
            let is_own = |side: &&Side| side.segment.points.iter().all(|p| points.binary_search(p).is_ok());
            all.filter(is_own).copied().collect()
        })
    }

    /// Whether all rotations are held, too: then stairs are as good a clamp as the cells are a body.
    fn clamps(&self) -> bool {
        let Support { phi_x, phi_y, phi_n, phi_t, .. } = self.support;
        phi_n.is_some() && phi_t.is_some() || phi_x.is_some() && phi_y.is_some()
    }

    /// Clamps points of steps as far from the true edge as they are, where the edge neither turns nor bends.
    fn clamp_steps(&mut self, points: &[u32], sides: &[Side]) {
        let Support { w: Some(Amount::Number(w)), phi_x, phi_y, phi_n, phi_t, .. } = self.support else {
            return;
        };
        let mut turns = [phi_x, phi_y, phi_n, phi_t].into_iter().flatten();
        if !self.clamps() || turns.any(|value| !matches!(value, Amount::Number(0.0))) {
            return;
        }
        self.followed = clamped_stairs::followed(self.site, points, sides);
        for (&point, Followed { shares, part }) in &self.followed {
            for (component, part) in [(W, part * part), (PHI_X, *part), (PHI_Y, *part)] {
                let unknown = |point: u32| Unknown { component, point: point as usize };
                let mut terms = vec![(unknown(point), 1.0)];
                terms.extend(shares.iter().map(|&(p, share)| (unknown(p), -part * share)));
                let value = if component == W { w * (1.0 - part) } else { 0.0 };
                self.equations.push((Equation { terms, value, origin: self.path.to_string() }, Vec::new()));
            }
        }
    }

    /// The points that do not follow others.
    fn held_themselves(&self, points: &[u32]) -> Vec<u32> {
        points.iter().copied().filter(|point| !self.followed.contains_key(point)).collect()
    }

    fn motion(&self, key: &str, given: Option<&Amount>, faults: &mut Faults) -> Option<Motion> {
        Motion::new(given?, 2, self.site.case.steps.as_ref(), &self.path.key(key), faults)
    }

    /// What a point moves by, at a factor of one or in every load step.
    fn values(&self, key: &str, of: &Motion, point: u32, faults: &mut Faults) -> Vec<f64> {
        let [x, y] = self.site.nodes.place(point as usize);
        of.values([x, y, 0.0], None).unwrap_or_else(|reason| {
            faults.error(self.path.key(key), reason);
            vec![0.0]
        })
    }

    /// Adds an equation with its value at a factor of one, or those in all load steps.
    fn push(&mut self, key: &str, terms: Vec<(Unknown, f64)>, motion: &Motion, values: Vec<f64>) {
        let value = motion.standing(&values);
        let by_step = if matches!(motion, Motion::BySteps(_)) { values } else { Vec::new() };
        let origin = self.path.key(key).to_string();
        self.equations.push((Equation { terms, value, origin }, by_step));
    }

    /// `w` at points; on stairs it is that of the true border, `w + φ·d`: were the steps themselves held, they would clamp a
    /// thin plate however fine they are.
    fn hold_deflection(&mut self, points: &[u32], sides: &[Side], faults: &mut Faults) {
        let Some(given) = self.motion("w", self.support.w.as_ref(), faults) else { return };
        let mut ways: BTreeMap<u32, [f64; 2]> = BTreeMap::new();
        if !self.clamps() {
            for point in sides.iter().filter(|side| !side.is_true).flat_map(|side| side.segment.points) {
                let way = || self.site.border.way(sides, self.site.nodes.place(point as usize)).0;
                ways.entry(point).or_insert_with(way);
            }
            // Where a straight edge begins its own points are held.
            for point in sides.iter().filter(|side| side.is_true).flat_map(|side| side.segment.points) {
                ways.remove(&point);
            }
        }
        for point in self.held_themselves(points) {
            let unknown = |component| Unknown { component, point: point as usize };
            let mut terms = vec![(unknown(W), 1.0)];
            if let Some(way) = ways.get(&point) {
                let turns = [PHI_X, PHI_Y].into_iter().zip(way);
                terms.extend(turns.filter(|turn| *turn.1 != 0.0).map(|(c, d)| (unknown(c), *d)));
            }
            let values = self.values("w", &given, point, faults);
            self.push("w", terms, &given, values);
        }
    }

    /// Rotations along x and y, or along and across the sides.
    fn hold_rotations(&mut self, points: &[u32], sides: &[Side], faults: &mut Faults) {
        let along_axes =
            [("phi_x", self.support.phi_x.as_ref(), PHI_X), ("phi_y", self.support.phi_y.as_ref(), PHI_Y)];
        for (key, given, component) in along_axes {
            let Some(given) = self.motion(key, given, faults) else { continue };
            for point in self.held_themselves(points) {
                let values = self.values(key, &given, point, faults);
                self.push(key, vec![(Unknown { component, point: point as usize }, 1.0)], &given, values);
            }
        }
        let [normal, tangential] = [self.support.phi_n.as_ref(), self.support.phi_t.as_ref()];
        if (normal.is_some() || tangential.is_some()) && sides.is_empty() {
            faults
                .error(
                    self.path.key("at"),
                    "`phi_n` and `phi_t` are along and across an edge, and here is none",
                )
                .hint("name an edge, or hold `phi_x` and `phi_y`");
            return;
        }
        let on_stairs = sides.iter().any(|side| !side.is_true);
        if normal.is_some() != tangential.is_some() && on_stairs {
            let (key, hint) = match normal {
                None => (
                    "phi_t",
                    "leave `phi_t` out: `w` alone is held on the true edge, not on the steps of the cells",
                ),
                Some(_) => ("phi_n", "guide straight edges along x or y"),
            };
            faults
                .error(
                    self.path.key(key),
                    format!("`{key}` is for edges along x or y: the cells of this one are steps"),
                )
                .hint(hint);
            return;
        }
        self.hold_along("phi_n", normal, |[x, y]| [x, y], sides, faults);
        self.hold_along("phi_t", tangential, |[x, y]| [-y, x], sides, faults);
    }

    /// The rotation along a direction that follows from the normals of the sides.
    fn hold_along(
        &mut self,
        key: &str,
        given: Option<&Amount>,
        direction: impl Fn([f64; 2]) -> [f64; 2],
        sides: &[Side],
        faults: &mut Faults,
    ) {
        let Some(given) = self.motion(key, given, faults) else { return };
        let mut held: BTreeMap<(usize, u32), Vec<f64>> = BTreeMap::new();
        for side in sides {
            let direction = direction(side.segment.outward);
            let component = if direction[0] != 0.0 { PHI_X } else { PHI_Y };
            for point in side.segment.points.into_iter().filter(|p| !self.followed.contains_key(p)) {
                let sign = direction[0] + direction[1];
                // −0 is no value of its own.
                let values = self.values(key, &given, point, faults).into_iter().map(|v| sign * v + 0.0);
                held.entry((component, point)).or_insert_with(|| values.collect());
            }
        }
        for ((component, point), values) in held {
            self.push(key, vec![(Unknown { component, point: point as usize }, 1.0)], &given, values);
        }
    }
}
