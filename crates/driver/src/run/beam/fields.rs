//! Results of one state of a beam.

use super::line_points::LinePoints;
use super::one_way::OneWayState;
use super::reaction::{HeldForce, JointReaction, Reaction};
use crate::case::FieldName;
use crate::run::StateRecord;
use crate::scene::beam::SectionAlong;
use peristat_assembly::material::{Compliance, SectionStiffness};
use peristat_assembly::model::timoshenko_beam::{PHI, SectionForces, U, W};
use std::borrow::Cow;

/// Fields of one line.
#[derive(Clone, Debug)]
pub struct LineFields {
    /// Positions of the real points.
    pub x: LinePoints,
    /// Number of the first of them.
    pub first: usize,
    /// Position in the plane of the coordinate 0.
    pub origin: [f64; 2],
    /// Unit vector in which positions grow.
    pub direction: [f64; 2],
    /// Stiffness of its sections.
    pub(super) stiffness: SectionStiffness,
    /// What else is known of them.
    pub(super) section: SectionAlong,
    /// Position of its start.
    pub(super) from: f64,
    /// Section forces, where they were asked for.
    pub forces: Option<SectionForces>,
    /// Energy density at points of bonds some of which may be broken; section forces say that of all others.
    pub(super) stored: Option<Vec<f64>>,
}

/// The result of one state of a beam or frame.
#[derive(Clone, Debug)]
pub struct BeamResult {
    /// State, unknowns (two or three planes: w, φ, u) and certificate.
    pub record: StateRecord,
    /// Fields per line.
    pub lines: Vec<LineFields>,
    /// Reactions of the supports on points of lines, in the order of the case.
    pub reactions: Vec<Reaction>,
    /// Reactions of the supports of a frame, in the order of the case.
    pub joint_reactions: Vec<JointReaction>,
    /// Which of what acts one way does act, if there is any.
    pub one_way: Option<OneWayState>,
    pub(super) held: Vec<HeldForce>,
    /// Number of points, ghosts included.
    pub(super) points: usize,
    /// The fields that its points have, in the order of tables.
    pub(super) fields: &'static [FieldName],
}

/// What makes stresses of section forces.
struct Fibres {
    /// At the extreme fibre on the side of −w, if it is known.
    per_moment: Option<f64>,
    area: Option<f64>,
}

impl Fibres {
    fn stress(&self, sign: f64, [m, n]: [f64; 2]) -> Option<f64> {
        let bending = sign * m * self.per_moment?;
        let stretching = if n == 0.0 { 0.0 } else { n / self.area? };
        Some(bending + stretching)
    }
}

/// What makes energy densities of section forces.
struct Yielding {
    of: Compliance,
    area: f64,
}

impl Yielding {
    /// `(M φ' + V (w' − φ) + N u') / 2A`.
    fn energy_density(&self, [m, v, n]: [f64; 3]) -> f64 {
        let of = &self.of;
        // The axial stiffness of what has no axial forces may not have been given.
        let stretched = if n == 0.0 { 0.0 } else { n * (of.axial * n + 2.0 * of.coupling * m) };
        0.5 * (of.bending * m * m + of.shear * v * v + stretched) / self.area
    }
}

impl LineFields {
    /// Position of a point in the plane.
    pub fn position(&self, point: usize) -> [f64; 2] {
        [0, 1].map(|k| self.origin[k] + self.x.at(point) * self.direction[k])
    }

    /// Normal stress at an extreme fibre, that on the side of −w if `sign` is 1, under a moment and an axial force at a
    /// position of the line; on a jump of the section that on the side of `towards`.
    pub(super) fn stress(&self, sign: f64, forces: [f64; 2], x: f64, towards: f64) -> Option<f64> {
        self.fibres(x, towards).stress(sign, forces)
    }

    fn fibres(&self, x: f64, towards: f64) -> Fibres {
        let [s, towards] = [x, towards].map(|x| x - self.from);
        let area = self.section.area.as_ref().map(|area| area.beside(s, towards));
        Fibres { per_moment: self.section.stress_per_moment(s, towards), area }
    }

    /// Strain energy density under section forces M, V and N at a position of the line; on a jump of the section that on the side of
    /// `towards`. None where the area is not known.
    pub(super) fn energy_density(&self, forces: [f64; 3], x: f64, towards: f64) -> Option<f64> {
        Some(self.yielding(x, towards)?.energy_density(forces))
    }

    fn yielding(&self, x: f64, towards: f64) -> Option<Yielding> {
        let [s, towards] = [x, towards].map(|x| x - self.from);
        let area = self.section.area.as_ref()?.beside(s, towards);
        Some(Yielding { of: self.stiffness.compliance_beside(s, towards), area })
    }

    /// Whether one section is that of the whole line.
    fn is_even(&self) -> bool {
        let Self { section, stiffness, .. } = self;
        section.has_uniform_area() && section.has_uniform_stress() && !stiffness.varies()
    }

    /// Energy density at a point: of bonds some of which may be broken, which have the area at the start, or of the section forces.
    fn energy_at(&self, point: usize) -> Option<f64> {
        let x = self.x.at(point);
        let Some(stored) = &self.stored else {
            let (m, v, n) = self.forces.as_ref()?.at(point);
            return self.energy_density([m, v, n], x, self.neighbour(point));
        };
        let area = self.section.area.as_ref()?;
        Some(stored[point] * area.value(0.0) / area.value(x - self.from))
    }

    /// What follows from the section forces `at` both sides of all cells and from the section there, which an even line has one of.
    fn at_ends<S>(
        &self,
        section: impl Fn(f64, f64) -> Option<S>,
        at: impl Fn(usize, usize) -> [f64; 3],
        of: impl Fn(&S, [f64; 3]) -> Option<f64>,
    ) -> Option<Vec<[f64; 2]>> {
        let cells = self.x.len() - 1;
        let mut found = Vec::with_capacity(cells);
        if self.is_even() {
            let section = section(self.x.at(0), self.x.at(1))?;
            for k in 0..cells {
                found.push([of(&section, at(k, 0))?, of(&section, at(k, 1))?]);
            }
            return Some(found);
        }
        let value = |k: usize, side: usize| {
            let [x, towards] = [k + side, k + 1 - side].map(|point| self.x.at(point));
            of(&section(x, towards)?, at(k, side))
        };
        for k in 0..cells {
            found.push([value(k, 0)?, value(k, 1)?]);
        }
        Some(found)
    }

    /// The point that a field at a point looks at: the next one, at the last point the one before.
    fn neighbour(&self, point: usize) -> f64 {
        self.x.at(if point + 1 < self.x.len() { point + 1 } else { point - 1 })
    }
}

impl BeamResult {
    /// The fields that its points have, in the order of tables.
    pub fn fields(&self) -> &'static [FieldName] {
        self.fields
    }

    /// Displacement along the line; zero where there are no axial unknowns.
    fn along(&self, number: usize) -> f64 {
        self.record.u.get(U * self.points + number).copied().unwrap_or(0.0)
    }

    /// Value of a field at a real point of a line; `None` where it was not recovered or does not exist.
    pub fn value(&self, field: FieldName, line: usize, point: usize) -> Option<f64> {
        let fields = &self.lines[line];
        let (n, number) = (self.points, fields.first + point);
        if !field.is_reaction() && !self.fields.contains(&field) {
            return None;
        }
        let forces = || fields.forces.as_ref().map(|forces| forces.at(point));
        let stress = |sign: f64| {
            let (m, _, axial) = forces()?;
            fields.stress(sign, [m, axial], fields.x.at(point), fields.neighbour(point))
        };
        let reaction = |of: fn(&HeldForce) -> f64| {
            Some(self.held.iter().filter(|held| held.point == number).map(of).sum())
        };
        let [c, s] = fields.direction;
        match field {
            FieldName::W => Some(self.record.u[number]),
            FieldName::U => Some(self.along(number)),
            FieldName::Ux => Some(c * self.along(number) - s * self.record.u[number]),
            FieldName::Uy => Some(s * self.along(number) + c * self.record.u[number]),
            FieldName::Phi => Some(self.record.u[n + number]),
            FieldName::M => forces().map(|f| f.0),
            FieldName::V => forces().map(|f| f.1),
            FieldName::N => forces().map(|f| f.2),
            // A positive moment bends the ends towards +w and shortens the fibres on that side.
            FieldName::StressTop => stress(-1.0),
            FieldName::StressBottom => stress(1.0),
            FieldName::EnergyDensity => fields.energy_at(point),
            FieldName::ReactionX => reaction(|r| r.force[0]),
            FieldName::ReactionForce | FieldName::ReactionY => reaction(|r| r.force[1]),
            FieldName::ReactionMoment => reaction(|r| r.moment),
            // Fields of bodies in the plane.
            _ => None,
        }
    }

    /// The values of a field along a line that lie somewhere one after the other.
    fn stored(&self, field: FieldName, line: usize) -> Option<&[f64]> {
        let fields = &self.lines[line];
        let plane = match field {
            FieldName::W => W,
            FieldName::Phi => PHI,
            FieldName::U => U,
            FieldName::EnergyDensity => {
                fields.section.area.as_ref()?.uniform()?;
                return fields.stored.as_deref();
            }
            _ => return None,
        };
        self.record.u.get(plane * self.points + fields.first..)?.get(..fields.x.len())
    }

    /// All values of a field along a line.
    pub fn values(&self, field: FieldName, line: usize) -> Option<Cow<'_, [f64]>> {
        match self.stored(field, line) {
            Some(values) => Some(values.into()),
            None => (0..self.lines[line].x.len()).map(|point| self.value(field, line, point)).collect(),
        }
    }

    /// Values of a field at all real points, line by line.
    pub fn all_values(&self, field: FieldName) -> Option<Cow<'_, [f64]>> {
        if self.lines.len() == 1 {
            return self.values(field, 0);
        }
        let lines: Option<Vec<_>> = (0..self.lines.len()).map(|line| self.values(field, line)).collect();
        Some(lines?.concat().into())
    }

    /// Displacements of all real points in the plane, line by line.
    pub fn displacements(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.lines.iter().flat_map(|line| self.displacements_on(line))
    }

    /// The same of one line.
    pub(super) fn displacements_on(&self, line: &LineFields) -> impl Iterator<Item = [f64; 2]> + '_ {
        let [c, s] = line.direction;
        (line.first..line.first + line.x.len()).map(move |k| {
            let (w, u) = (self.record.u[k], self.along(k));
            [c * u - s * w, s * u + c * w]
        })
    }

    /// Section force, or what follows from it, at both ends of every cell of a line, seen from inside.
    pub(super) fn cells(&self, field: FieldName, line: usize) -> Option<Cow<'_, [[f64; 2]]>> {
        let fields = &self.lines[line];
        let forces = fields.forces.as_ref()?;
        if !self.fields.contains(&field) {
            return None;
        }
        let axial = |cell: usize| forces.axial.get(cell).copied().unwrap_or([0.0; 2]);
        let at = |cell: usize, side: usize| {
            [forces.moment[cell][side], forces.shear[cell][side], axial(cell)[side]]
        };
        let stress = |sign: f64| {
            let of = |fibres: &Fibres, [m, _, n]: [f64; 3]| fibres.stress(sign, [m, n]);
            Some(fields.at_ends(|x, towards| Some(fields.fibres(x, towards)), at, of)?.into())
        };
        match field {
            FieldName::M => Some((&forces.moment).into()),
            FieldName::V => Some((&forces.shear).into()),
            FieldName::N => Some((0..forces.moment.len()).map(axial).collect()),
            FieldName::StressTop => stress(-1.0),
            FieldName::StressBottom => stress(1.0),
            FieldName::EnergyDensity if fields.stored.is_none() => {
                let of = |yielding: &Yielding, forces: [f64; 3]| Some(yielding.energy_density(forces));
                Some(fields.at_ends(|x, towards| fields.yielding(x, towards), at, of)?.into())
            }
            _ => None,
        }
    }

    /// Values of a field to the left of the points of a line, where it may jump.
    pub fn left_values(&self, field: FieldName, line: usize) -> Option<Vec<f64>> {
        let cells = self.cells(field, line)?;
        let first = cells.first().map(|c| c[0]);
        Some(first.into_iter().chain(cells.iter().map(|c| c[1])).collect())
    }
}
