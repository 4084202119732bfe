//! Supports and links of a scene.

use super::place::{Layout, Place};
use super::root;
use crate::case::{At, Case, Link, Support};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::timoshenko_beam::end_treatment::{EndKind, EndSupport};
use peristat_assembly::stiffness::Spring;

/// A place that a support holds.
#[derive(Clone, Debug)]
pub struct HeldPoint {
    /// Position.
    pub x: f64,
    /// Line, and real point on it where the support acts on a point.
    pub local: Option<(usize, usize)>,
    /// Number of the point; `None` where ghost points hold the end of a line.
    pub point: Option<usize>,
    /// Prescribed values of w and φ.
    pub prescribed: [Option<f64>; 2],
    /// Stiffness of springs against w and φ.
    pub springs: [Option<f64>; 2],
    /// Where it stands in the case.
    pub path: JsonPath,
}

/// A rigid bar between two points.
#[derive(Clone, Debug)]
pub struct RigidBar {
    /// Line and real point of one end.
    pub from: (usize, usize),
    /// Line and real point of the other end.
    pub to: (usize, usize),
    /// Numbers of the points.
    pub points: [usize; 2],
    /// Signed length.
    pub length: f64,
    /// Where it stands in the case.
    pub path: JsonPath,
}

const KEYS: [[&str; 2]; 2] = [["w", "phi"], ["w_spring", "phi_spring"]];

impl HeldPoint {
    /// The same with the number of its point; `first` are the numbers of the first real points of the lines.
    pub(super) fn numbered(self, first: &[usize]) -> Self {
        Self { point: self.local.map(|(chain, k)| first[chain] + k), ..self }
    }
}

impl RigidBar {
    /// The same with the numbers of its points.
    pub(super) fn numbered(self, first: &[usize]) -> Self {
        Self { points: [first[self.from.0] + self.from.1, first[self.to.0] + self.to.1], ..self }
    }
}

/// Springs before points have numbers: line and real point.
pub(super) type LocalSpring = ((usize, usize), Spring);

/// Held points, springs, and what holds the ends of every line.
pub(super) fn held(
    case: &Case,
    layout: &Layout,
    faults: &mut Faults,
) -> (Vec<HeldPoint>, Vec<LocalSpring>, Vec<[EndSupport; 2]>) {
    let mut ends = vec![[EndSupport::default(); 2]; layout.lines.len()];
    let (mut held, mut springs) = (Vec::new(), Vec::new());
    if case.supports.is_empty() {
        faults.error(root("supports"), "nothing holds the beam: `supports` is empty").hint(
            r#"a clamped end is { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, a simple support { "at": { "x": 0.0 }, "w": 0.0 }"#,
        );
    }
    for (k, support) in case.supports.iter().enumerate() {
        let path = root("supports").index(k);
        check(support, &path, faults);
        let at = path.key("at").key("x");
        let Some(place) = layout.place(support.at.x, &at, "the support", faults) else {
            continue;
        };
        let point = HeldPoint {
            x: support.at.x,
            local: None,
            point: None,
            prescribed: [support.w, support.phi],
            springs: [support.w_spring, support.phi_spring],
            path,
        };
        match place {
            Place::Point { chain, point: p } => {
                let last = layout.lines[chain].points() - 1;
                for (side, end) in [0, last].into_iter().enumerate() {
                    if p == end {
                        hold(&mut ends[chain][side], support);
                    }
                }
                for (component, stiffness) in point.springs.iter().enumerate() {
                    if let &Some(stiffness) = stiffness {
                        springs.push(((chain, p), Spring { component, point: 0, stiffness }));
                    }
                }
                held.push(HeldPoint { local: Some((chain, p)), ..point });
            }
            Place::End { chain, side } if layout.treatment.name != "truncated" => {
                hold(&mut ends[chain][side], support);
                let kind = (layout.treatment.end)(&ends[chain][side]);
                if kind == EndKind::Mirrored && support.w.is_some() && support.phi.is_some() {
                    faults
                        .error(point.path.clone(), "images prescribe the rotation of an end, and a grid of cells has no point there to hold its deflection")
                        .hint("use the grid `nodes`, or the end treatment `ghost`");
                }
                if support.w_spring.is_some() || support.phi_spring.is_some() {
                    faults
                        .error(
                            point.path.clone(),
                            "a spring needs a point, and a grid of cells has none on its end",
                        )
                        .hint("use the grid `nodes`");
                }
                held.push(point);
            }
            Place::End { chain, .. } | Place::Between { chain, .. } => {
                layout.needs_point(chain, support.at.x, &at, "the support", faults);
            }
        }
    }
    (held, springs, ends)
}

fn hold(end: &mut EndSupport, support: &Support) {
    end.w = support.w.or(end.w);
    end.phi = support.phi.or(end.phi);
}

fn check(support: &Support, path: &JsonPath, faults: &mut Faults) {
    let prescribed = [support.w, support.phi];
    let springs = [support.w_spring, support.phi_spring];
    if prescribed.iter().chain(&springs).all(Option::is_none) {
        faults
            .error(path.clone(), "this support holds nothing")
            .hint("give `w`, `phi`, or both; or `w_spring`, `phi_spring` for an elastic support");
    }
    for c in 0..2 {
        let (held, spring) = (KEYS[0][c], KEYS[1][c]);
        if let Some(stiffness) = springs[c] {
            super::material::positive(stiffness, spring, path.key(spring), faults);
            if prescribed[c].is_some() {
                faults
                    .error(
                        path.key(spring),
                        format!("`{held}` is prescribed, so `{spring}` would do nothing"),
                    )
                    .hint("remove one of them");
            }
        }
    }
}

/// Rigid bars of the case.
pub(super) fn bars(case: &Case, layout: &Layout, faults: &mut Faults) -> Vec<RigidBar> {
    let mut bars = Vec::new();
    for (k, link) in case.links.iter().enumerate() {
        let Link::Rigid(link) = link;
        let path = root("links").index(k).key("rigid");
        let mut end = |at: &At, key: &str| {
            let path = path.key(key).key("x");
            match layout.place(at.x, &path, "the end of the link", faults)? {
                Place::Point { chain, point } => Some((chain, point)),
                Place::End { chain, .. } | Place::Between { chain, .. } => {
                    layout.needs_point(chain, at.x, &path, "the end of the link", faults);
                    None
                }
            }
        };
        let (Some(from), Some(to)) = (end(&link.from, "from"), end(&link.to, "to")) else {
            continue;
        };
        if from == to {
            faults.error(path, "a link joins a point to itself");
            continue;
        }
        let x = |(chain, point): (usize, usize)| layout.lines[chain].position(point);
        bars.push(RigidBar { from, to, points: [0; 2], length: x(to) - x(from), path });
    }
    bars
}

/// Springs on numbered points.
pub(super) fn numbered_springs(springs: Vec<LocalSpring>, first: &[usize]) -> Vec<Spring> {
    springs.into_iter().map(|((chain, k), s)| Spring { point: first[chain] + k, ..s }).collect()
}

/// Equations of supports on points and of rigid bars, `w₂ = w₁ + length φ₁` and `φ₂ = φ₁`.
pub(super) fn equations(held: &[HeldPoint], bars: &[RigidBar]) -> Vec<Equation> {
    let mut equations = Vec::new();
    for h in held {
        for (component, value) in h.prescribed.iter().enumerate() {
            if let (Some(point), &Some(value)) = (h.point, value) {
                let terms = vec![(Unknown { component, point }, 1.0)];
                let origin = h.path.key(KEYS[0][component]).to_string();
                equations.push(Equation { terms, value, origin });
            }
        }
    }
    for bar in bars {
        let unknown = |component, end: usize| Unknown { component, point: bar.points[end] };
        let origin = bar.path.to_string();
        let w = vec![(unknown(0, 1), 1.0), (unknown(0, 0), -1.0), (unknown(1, 0), -bar.length)];
        let phi = vec![(unknown(1, 1), 1.0), (unknown(1, 0), -1.0)];
        equations.extend([w, phi].map(|terms| Equation { terms, value: 0.0, origin: origin.clone() }));
    }
    equations
}
