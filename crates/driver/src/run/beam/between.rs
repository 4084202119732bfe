//! Fields between two points of a line, as the exact element that joins them has them.

use super::ends::Ends;
use super::peak::Part;
use super::{BeamResult, LineFields};
use crate::case::FieldName;
use crate::scene::beam::{BeamScene, State};
use peristat_assembly::model::timoshenko_beam::{Along, Chain, Element, Inside};
use std::cell::OnceCell;

/// The cells of a line.
pub(crate) struct Between<'a> {
    result: &'a BeamResult,
    line: usize,
    fields: &'a LineFields,
    inside: Inside<'a>,
    has_axial: bool,
    /// Bonds that break leave no elements.
    has_elements: bool,
    /// Whether loads or foundations are spread over it.
    has_distributed: bool,
    /// Whether moments alone turn it, shear forces alone change moments, and nothing is spread along it.
    is_plain: bool,
    chain: &'a Chain,
}

impl<'a> Between<'a> {
    pub(super) fn new(scene: &'a BeamScene, result: &'a BeamResult, line: usize) -> Self {
        // Equilibria of a beam that breaks are of one state.
        let state = result.record.index.min(scene.states.len() - 1);
        let State { loads, eigenstrains, .. } = &scene.states[state];
        let chain = &scene.beam.chains()[line];
        let mut distributed = loads.distributed.iter().filter(|l| l.chain == line);
        Self {
            result,
            line,
            fields: &result.lines[line],
            inside: Inside::new(loads, line, chain),
            has_axial: scene.has_axial,
            has_elements: scene.fracture.is_none(),
            has_distributed: !scene.bedding.is_empty() || distributed.clone().next().is_some(),
            is_plain: eigenstrains.is_empty()
                && !chain.line().stiffness.couples()
                && distributed.all(|l| l.along == Along::Transverse),
            chain,
        }
    }

    /// The cell behind a point.
    pub(super) fn cell(&self, number: usize) -> Cell<'_> {
        let span = [number, number + 1].map(|point| self.fields.x.at(point));
        Cell { on: self, number, span, element: OnceCell::new() }
    }

    /// The position of a point.
    pub(super) fn position(&self, point: usize) -> f64 {
        self.fields.x.at(point)
    }

    /// Values of a field at the ends of all cells.
    pub(super) fn ends(&self, field: FieldName) -> Option<Ends<'a>> {
        self.result.ends(field, self.line)
    }

    /// Number of cells.
    pub(super) fn cells(&self) -> usize {
        self.fields.x.len() - 1
    }
}

/// A cell of a line.
pub(super) struct Cell<'a> {
    on: &'a Between<'a>,
    number: usize,
    span: [f64; 2],
    element: OnceCell<Option<Element<'a>>>,
}

impl Cell<'_> {
    /// Whether a field is known between points, not at points alone.
    fn knows(&self, field: FieldName) -> bool {
        use FieldName::{EnergyDensity, M, N, Phi, StressBottom, StressTop, U, Ux, Uy, V, W};
        self.on.has_elements
            && match field {
                U | N => self.on.has_axial,
                W | Phi | Ux | Uy | M | V | StressTop | StressBottom | EnergyDensity => true,
                _ => false,
            }
    }

    /// The parts of the cell in which a field is smooth, from end to end. None where it was not recovered or does not exist.
    pub(super) fn parts(&self, field: FieldName) -> Option<Vec<Part>> {
        let [a, b] = self.span;
        let [left, right] = self.ends(field)?;
        let places: Vec<f64> = match self.knows(field) {
            true => [a].into_iter().chain(self.on.inside.breaks([a, b])).chain([b]).collect(),
            false => vec![a, b],
        };
        let part = |ends: &[f64]| {
            let [from, to] = [ends[0], ends[1]];
            let start = if from == a { left } else { self.value(field, from, true)? };
            let end = if to == b { right } else { self.value(field, to, false)? };
            Some(Part { ends: [from, to], values: [start, end] })
        };
        places.windows(2).map(part).collect()
    }

    /// Whether a field has no extremes inside but those at the ends of its parts: one that is straight there.
    pub(super) fn is_straight(&self, field: FieldName) -> bool {
        use FieldName::{M, N, V};
        !self.knows(field) || matches!(field, M | N | V) && !self.on.has_distributed
    }

    /// Whether a field may have an extreme inside.
    pub(super) fn may_turn(&self, field: FieldName) -> bool {
        let has_breaks = || self.on.inside.breaks(self.span).next().is_some();
        self.knows(field) && (has_breaks() || !self.is_straight(field) && !self.is_monotonous(field))
    }

    /// Whether a field is known to have no extreme inside: its slope has no change of sign at the ends, and changes with one sign.
    fn is_monotonous(&self, field: FieldName) -> bool {
        let keeps = |[a, b]: [f64; 2]| a * b >= 0.0;
        let is = || {
            let (m, v) = (self.ends(FieldName::M)?, self.ends(FieldName::V)?);
            let (of_moment, of_turn) = (keeps(v), keeps(v) && keeps(m));
            Some(match field {
                FieldName::V => true,
                FieldName::M => of_moment,
                FieldName::StressTop | FieldName::StressBottom => of_moment && self.is_bent_alone(),
                FieldName::EnergyDensity => {
                    let is_even = !self.on.has_distributed && self.on.fields.section.has_uniform_area();
                    of_turn
                        && is_even
                        && self.axial()? == [0.0; 2]
                        && !self.on.chain.line().stiffness.varies()
                }
                FieldName::Phi => of_turn,
                // Nothing is spread along the line.
                FieldName::U => true,
                FieldName::W | FieldName::Ux | FieldName::Uy => {
                    let [slopes, bends] = self.slopes(field, m, v)?;
                    keeps(slopes) && of_turn && keeps(bends)
                }
                _ => false,
            })
        };
        // V changes with one sign.
        self.on.is_plain && self.on.inside.pushes_one_way(self.span) && is().unwrap_or(false)
    }

    /// Slopes of a displacement at both ends, and the slopes of these.
    fn slopes(&self, field: FieldName, m: [f64; 2], v: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        let ([a, b], line) = (self.span, self.on.chain.line());
        let (phi, n) = (self.ends(FieldName::Phi)?, self.axial()?);
        // Forces per length.
        let [q, p] = [v, n].map(|[left, right]| (left - right) / (b - a));
        let [c, s] = self.on.fields.direction;
        let (across, along) = match field {
            FieldName::Ux => (-s, c),
            FieldName::Uy => (c, s),
            _ => (1.0, 0.0),
        };
        let at = |k: usize| {
            let of = line.stiffness.compliance(self.span[k] - line.from);
            let stretch = if along == 0.0 { [0.0; 2] } else { [of.axial * n[k], -of.axial * p] };
            let bend = [phi[k] + of.shear * v[k], of.bending * m[k] - of.shear * q];
            [0, 1].map(|k| across * bend[k] + along * stretch[k])
        };
        let [left, right] = [at(0), at(1)];
        Some([0, 1].map(|k| [left[k], right[k]]))
    }

    /// Axial forces at the ends; zero without axial unknowns.
    fn axial(&self) -> Option<[f64; 2]> {
        let axial = &self.on.fields.forces.as_ref()?.axial;
        Some(axial.get(self.number).copied().unwrap_or([0.0; 2]))
    }

    /// Whether stresses change with the moment alone.
    fn is_bent_alone(&self) -> bool {
        let is_even = |[a, b]: [f64; 2]| (a - b).abs() <= 1e-12 * a.abs().max(b.abs());
        self.on.fields.section.has_uniform_stress() && self.axial().is_some_and(is_even)
    }

    /// Values at the ends, seen from inside.
    fn ends(&self, field: FieldName) -> Option<[f64; 2]> {
        let [a, b] = self.span;
        let forces = || self.on.fields.forces.as_ref();
        let stress = |sign| Some([self.stress(sign, a, true)?, self.stress(sign, b, false)?]);
        match field {
            FieldName::M => Some(forces()?.moment[self.number]),
            FieldName::V => Some(forces()?.shear[self.number]),
            FieldName::N => self.axial(),
            FieldName::StressTop => stress(-1.0),
            FieldName::StressBottom => stress(1.0),
            FieldName::EnergyDensity if self.on.has_elements => {
                Some([self.energy_density(a, true)?, self.energy_density(b, false)?])
            }
            _ => Some([self.at_point(field, 0)?, self.at_point(field, 1)?]),
        }
    }

    fn at_point(&self, field: FieldName, side: usize) -> Option<f64> {
        self.on.result.value(field, self.on.line, self.number + side)
    }

    /// Value of a field inside; before what acts at `x`, unless `after` it. One that is known at points alone is straight between
    /// them. None where the field was not recovered or does not exist.
    pub(super) fn value(&self, field: FieldName, x: f64, after: bool) -> Option<f64> {
        let [c, s] = self.on.fields.direction;
        let displaced = || Some(self.element()?.at(x));
        match field {
            _ if !self.knows(field) => self.straight(field, x),
            FieldName::W => Some(displaced()?[0]),
            FieldName::Phi => Some(displaced()?[1]),
            FieldName::U => Some(displaced()?[2]),
            FieldName::Ux => displaced().map(|[w, _, u]| c * u - s * w),
            FieldName::Uy => displaced().map(|[w, _, u]| s * u + c * w),
            FieldName::M => Some(self.section(x, after)?[0]),
            FieldName::V => Some(self.section(x, after)?[1]),
            FieldName::N => Some(self.section(x, after)?[2]),
            FieldName::StressTop => self.stress(-1.0, x, after),
            FieldName::StressBottom => self.stress(1.0, x, after),
            FieldName::EnergyDensity => self.energy_density(x, after),
            _ => None,
        }
    }

    fn straight(&self, field: FieldName, x: f64) -> Option<f64> {
        let ([a, b], [left, right]) = (self.span, self.ends(field)?);
        Some(left + (x - a) / (b - a) * (right - left))
    }

    /// The exact element.
    fn element(&self) -> Option<&Element<'_>> {
        let point = |side: usize| {
            let u = if self.on.has_axial { self.at_point(FieldName::U, side)? } else { 0.0 };
            Some([self.at_point(FieldName::W, side)?, self.at_point(FieldName::Phi, side)?, u])
        };
        let element = || Some(self.on.inside.element(self.span, [point(0)?, point(1)?], self.on.has_axial));
        self.element.get_or_init(element).as_ref()
    }

    /// `(M, V, N)`: statics from the start of the cell. What acts on points but stands for what is spread (lumped loads,
    /// foundations) is spread evenly over the cell, so that the forces at its end are met.
    fn section(&self, x: f64, after: bool) -> Option<[f64; 3]> {
        let forces = self.on.fields.forces.as_ref()?;
        let (m, v) = (forces.moment[self.number], forces.shear[self.number]);
        let (n, [a, b]) = (self.axial()?, self.span);
        let statics = |x: f64, after: bool| {
            let [force, lever, axial] = self.on.inside.carried([a, x], after);
            [m[0] - v[0] * (x - a) + lever, v[0] - force, n[0] - axial]
        };
        let (found, end) = (statics(x, after), statics(b, false));
        let (q, length) = ((x - a) / (b - a), b - a);
        let [dm, dv, dn] = [m[1] - end[0], v[1] - end[1], n[1] - end[2]];
        // The moment of a force per length −dv/length.
        let bow = 0.5 * dv * length;
        Some([found[0] - bow * q * q + (dm + bow) * q, found[1] + dv * q, found[2] + dn * q])
    }

    fn stress(&self, sign: f64, x: f64, after: bool) -> Option<f64> {
        let [m, _, n] = self.section(x, after)?;
        let [a, b] = self.span;
        self.on.fields.stress(sign, [m, n], x, if after { b } else { a })
    }

    fn energy_density(&self, x: f64, after: bool) -> Option<f64> {
        let [a, b] = self.span;
        self.on.fields.energy_density(self.section(x, after)?, x, if after { b } else { a })
    }
}
