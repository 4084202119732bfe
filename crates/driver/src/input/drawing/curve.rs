//! Curves as chords that are near them.

use std::f64::consts::{PI, TAU};

type Point = [f64; 2];

/// Chords of one curve, at most.
const MOST: f64 = 10_000.0;

/// An arc of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Arc {
    /// Its middle.
    pub(crate) centre: Point,
    /// Its radius.
    pub(crate) radius: f64,
    /// The angle of its start from x, rad.
    pub(crate) start: f64,
    /// How far it turns, counter-clockwise if positive, rad.
    pub(crate) sweep: f64,
}

impl Arc {
    /// All around, from the right.
    pub(crate) fn circle(centre: Point, radius: f64) -> Self {
        Self { centre, radius, start: 0.0, sweep: TAU }
    }

    /// Around a centre from one position to another, the radius being that of the first.
    pub(crate) fn around(centre: Point, from: Point, to: Point, clockwise: bool) -> Self {
        let [a, b] = [from, to].map(|p| (p[1] - centre[1]).atan2(p[0] - centre[0]));
        let sweep = if clockwise { -(a - b).rem_euclid(TAU) } else { (b - a).rem_euclid(TAU) };
        Self { centre, radius: (from[0] - centre[0]).hypot(from[1] - centre[1]), start: a, sweep }
    }

    /// From one position through a second to a third; none where they are on a line.
    pub(crate) fn through(from: Point, by: Point, to: Point) -> Option<Self> {
        let (a, b) = ([by[0] - from[0], by[1] - from[1]], [to[0] - from[0], to[1] - from[1]]);
        let turn = a[0] * b[1] - a[1] * b[0];
        let [aa, bb] = [a, b].map(|v| v[0] * v[0] + v[1] * v[1]);
        if turn.abs() <= 1e-9 * (aa * bb).sqrt() || aa == 0.0 || bb == 0.0 {
            return None;
        }
        let to_centre = [(b[1] * aa - a[1] * bb) / (2.0 * turn), (a[0] * bb - b[0] * aa) / (2.0 * turn)];
        let centre = [from[0] + to_centre[0], from[1] + to_centre[1]];
        // The third position is on the left of the way to the second one: the arc turns left.
        Some(Self::around(centre, from, to, turn < 0.0))
    }

    /// From one position to another by the tangent of a quarter of its angle, as drawings have it.
    pub(crate) fn bulge(from: Point, to: Point, bulge: f64) -> Self {
        let sweep = 4.0 * bulge.atan();
        let (half, d) = (0.5 * sweep, [to[0] - from[0], to[1] - from[1]]);
        // From the middle of the chord to the centre, in chords.
        let off = 0.5 / half.tan();
        let centre = [0.5 * (from[0] + to[0]) - off * d[1], 0.5 * (from[1] + to[1]) + off * d[0]];
        let start = (from[1] - centre[1]).atan2(from[0] - centre[0]);
        Self { centre, radius: (from[0] - centre[0]).hypot(from[1] - centre[1]), start, sweep }
    }

    /// Its start, its end and positions between, of which chords are this far from it at most.
    pub(crate) fn chords(&self, deviation: f64) -> Vec<Point> {
        Ellipse { arc: *self, across: self.radius, turn: 0.0 }.chords(deviation)
    }
}

/// An arc of an ellipse: its angles are those of a circle that is squeezed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ellipse {
    /// The circle around the first half axis.
    pub(super) arc: Arc,
    /// The second half axis.
    pub(super) across: f64,
    /// Angle of the first half axis from x, rad.
    pub(super) turn: f64,
}

impl Ellipse {
    /// As the path of an SVG drawing has it: half axes, the angle of the first one, whether it is the larger part, and whether angles
    /// grow. None where its ends are the same or it is straight.
    pub(super) fn of_svg(
        [from, to]: [Point; 2],
        radii: [f64; 2],
        turn: f64,
        (large, grows): (bool, bool),
    ) -> Option<Self> {
        let [mut a, mut b] = radii.map(f64::abs);
        let (sin, cos) = turn.sin_cos();
        let half = [0.5 * (from[0] - to[0]), 0.5 * (from[1] - to[1])];
        let [x, y] = [cos * half[0] + sin * half[1], cos * half[1] - sin * half[0]];
        if a == 0.0 || b == 0.0 || (x == 0.0 && y == 0.0) {
            return None;
        }
        // Half axes that do not reach grow until they do.
        let reach = (x / a).hypot(y / b);
        if reach > 1.0 {
            [a, b] = [a * reach, b * reach];
        }
        let square = (x / a).powi(2) + (y / b).powi(2);
        let share = ((1.0 / square - 1.0).max(0.0)).sqrt() * if large == grows { -1.0 } else { 1.0 };
        let [cx, cy] = [share * a * y / b, -share * b * x / a];
        let centre =
            [cos * cx - sin * cy + 0.5 * (from[0] + to[0]), sin * cx + cos * cy + 0.5 * (from[1] + to[1])];
        let start = ((y - cy) / b).atan2((x - cx) / a);
        let end = ((-y - cy) / b).atan2((-x - cx) / a);
        let sweep = if grows { (end - start).rem_euclid(TAU) } else { -(start - end).rem_euclid(TAU) };
        Some(Self { arc: Arc { centre, radius: a, start, sweep }, across: b, turn })
    }

    /// A position on it.
    fn at(&self, angle: f64) -> Point {
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (self.arc.radius * cos, self.across * sin);
        let (s, c) = self.turn.sin_cos();
        [self.arc.centre[0] + c * x - s * y, self.arc.centre[1] + s * x + c * y]
    }

    /// Its start, its end and positions between, of which chords are this far from it at most. Quarters end on chords: arcs that
    /// reach farthest to a side do so with a vertex.
    pub(super) fn chords(&self, deviation: f64) -> Vec<Point> {
        let Arc { radius, start, sweep, .. } = self.arc;
        let largest = radius.abs().max(self.across.abs());
        // At least eight chords go around.
        let step = (2.0 * (1.0 - (deviation / largest).min(1.0)).acos()).clamp(1e-9, PI / 4.0);
        let mut points = vec![self.at(start)];
        for ends in quarters(start, start + sweep).windows(2) {
            let angle = ends[1] - ends[0];
            let count = (angle.abs() / step - 1e-9).ceil().clamp(1.0, MOST);
            points.extend((1..=count as usize).map(|k| self.at(ends[0] + angle * (k as f64 / count))));
        }
        points
    }
}

/// An angle, those of quarters behind it and another one; quarters next to an end are left out.
fn quarters(start: f64, end: f64) -> Vec<f64> {
    const QUARTER: f64 = 0.5 * PI;
    const NEAR: f64 = 1e-6;
    let (low, high) = (start.min(end) + NEAR, start.max(end) - NEAR);
    let first = (low / QUARTER).ceil();
    // More than eight quarters are none of an arc.
    let between = (0..8).map(|k| (first + f64::from(k)) * QUARTER).filter(|angle| *angle <= high);
    let mut all = vec![start];
    all.extend(between);
    if end < start {
        all[1..].reverse();
    }
    all.push(end);
    all
}

/// A curve of Bézier by its four positions, as chords.
pub(super) fn cubic(of: [Point; 4], deviation: f64) -> Vec<Point> {
    // A chord is away by an eighth of its square times the second derivative.
    let bend = |k: usize| {
        let [x, y] = [0, 1].map(|c| of[k][c] - 2.0 * of[k + 1][c] + of[k + 2][c]);
        6.0 * x.hypot(y)
    };
    let count = (bend(0).max(bend(1)) / (8.0 * deviation)).sqrt().ceil().clamp(1.0, MOST);
    let at = |k: usize| {
        let t = k as f64 / count;
        let s = 1.0 - t;
        let shares = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        [0, 1].map(|c| (0..4).map(|j| shares[j] * of[j][c]).sum::<f64>())
    };
    (0..=count as usize).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Point, b: Point) -> bool {
        (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12
    }

    /// How far chords are from a circle, at most.
    fn farthest(points: &[Point], centre: Point, radius: f64) -> f64 {
        let middle = |p: &[Point]| [0.5 * (p[0][0] + p[1][0]), 0.5 * (p[0][1] + p[1][1])];
        let off = |p: Point| (radius - (p[0] - centre[0]).hypot(p[1] - centre[1])).abs();
        points.windows(2).map(|p| off(middle(p)).max(off(p[0]))).fold(0.0, f64::max)
    }

    #[test]
    fn arcs_by_three_positions_by_centre_and_by_bulge_are_the_same() {
        let (from, to) = ([3.0, 1.0], [1.0, 3.0]);
        let by = [1.0 + 2.0_f64.sqrt(), 1.0 + 2.0_f64.sqrt()];
        let all = [
            Arc::through(from, by, to).unwrap(),
            Arc::around([1.0, 1.0], from, to, false),
            Arc::bulge(from, to, (PI / 8.0).tan()),
        ];
        for arc in all {
            assert!(near(arc.centre, [1.0, 1.0]) && (arc.sweep - PI / 2.0).abs() < 1e-12, "{arc:?}");
            let chords = arc.chords(1e-3);
            assert!(near(chords[0], from) && near(chords[chords.len() - 1], to));
            assert!(farthest(&chords, arc.centre, arc.radius) <= 1.001e-3);
        }
        let back = Arc::bulge(to, from, -(PI / 8.0).tan());
        assert!(near(back.centre, [1.0, 1.0]) && back.sweep < 0.0);
        assert!((Arc::around([1.0, 1.0], from, to, true).sweep + 1.5 * PI).abs() < 1e-12);
        assert_eq!(Arc::through([0.0, 0.0], [1.0, 1.0], [2.0, 2.0]), None);
    }

    #[test]
    fn arcs_of_paths_are_those_of_the_specification() {
        let (from, to) = ([1.0, 0.0], [0.0, 1.0]);
        let of = |flags| Ellipse::of_svg([from, to], [1.0, 1.0], 0.3, flags).unwrap();
        for (flags, centre, sweep) in [
            ((false, true), [0.0, 0.0], 0.5 * PI),
            ((true, true), [1.0, 1.0], 1.5 * PI),
            ((false, false), [1.0, 1.0], -0.5 * PI),
            ((true, false), [0.0, 0.0], -1.5 * PI),
        ] {
            let arc = of(flags);
            assert!(near(arc.arc.centre, centre) && (arc.arc.sweep - sweep).abs() < 1e-12, "{arc:?}");
            let chords = arc.chords(1e-4);
            assert!(near(chords[0], from) && near(chords[chords.len() - 1], to));
        }
        // Radii that are too small reach.
        let half = Ellipse::of_svg([[0.0; 2], [4.0, 0.0]], [1.0, 1.0], 0.0, (false, true)).unwrap();
        assert!((half.arc.radius - 2.0).abs() < 1e-12);
        assert_eq!(Ellipse::of_svg([from, from], [1.0, 1.0], 0.0, (false, true)), None);
    }

    #[test]
    fn curves_of_bezier_are_near_their_chords() {
        // A quarter of a circle to 3e-4 of its radius.
        let k = 0.552_284_75;
        let chords = cubic([[1.0, 0.0], [1.0, k], [k, 1.0], [0.0, 1.0]], 1e-3);
        assert!(farthest(&chords, [0.0; 2], 1.0) < 1.3e-3 && chords.len() < 40);
        assert_eq!(cubic([[0.0; 2], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]], 1e-9).len(), 2);
    }
}
