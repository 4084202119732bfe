//! How far a triangle is.

use super::facets::{dot, minus};

/// Square of the distance of a position from a triangle, m².
///
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
pub(super) fn squared(at: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> f64 {
    let (ab, ac, ap) = (minus(b, a), minus(c, a), minus(at, a));
    let along = |from: [f64; 3], way: [f64; 3], part: f64| {
        let away = minus(minus(at, from), way.map(|x| part * x));
        dot(away, away)
    };
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return dot(ap, ap);
    }
    let bp = minus(at, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return dot(bp, bp);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return along(a, ab, d1 / (d1 - d3));
    }
    let cp = minus(at, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
    if d6 >= 0.0 && d5 <= d6 {
        return dot(cp, cp);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return along(a, ac, d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return along(b, minus(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let all = va + vb + vc;
    let inside = [0, 1, 2].map(|k| vb / all * ab[k] + vc / all * ac[k]);
    along(a, inside, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_are_as_far_as_their_nearest_sample() {
        let corners = [[0.0, 0.0, 0.0], [2.0, 0.5, 0.0], [0.3, 1.5, 1.0]];
        let steps = 200;
        for at in [
            [0.5, 0.5, 1.0],
            [-1.0, -1.0, 0.2],
            [3.0, 0.0, 0.0],
            [1.0, -0.5, 0.0],
            [1.5, 1.5, 0.5],
            [-0.5, 1.0, 0.3],
            [0.0, 3.0, 2.0],
        ] {
            let mut least = f64::INFINITY;
            for i in 0..=steps {
                for j in 0..=steps - i {
                    let parts = [i, j].map(|n| f64::from(n) / f64::from(steps));
                    let place = [0, 1, 2].map(|k| {
                        corners[0][k]
                            + parts[0] * (corners[1][k] - corners[0][k])
                            + parts[1] * (corners[2][k] - corners[0][k])
                    });
                    let away = minus(at, place);
                    least = least.min(dot(away, away).sqrt());
                }
            }
            // Samples are up to 0.01 from each other.
            let found = squared(at, corners).sqrt();
            assert!(found <= least + 1e-12 && found > least - 0.01, "{at:?}: {found} {least}");
        }
    }
}
