//! Area that a cell and a disc have in common.

use crate::body::Cell;

/// Area of the unit cell around an offset inside the disc of a radius around the origin, all in spacings.
pub(in crate::model) fn cell_in_disc([a, b, _]: Cell, radius: f64) -> f64 {
    let [x, y] = [f64::from(a.abs()), f64::from(b.abs())];
    let upper = corner(x + 0.5, y + 0.5, radius) - corner(x - 0.5, y + 0.5, radius);
    let lower = corner(x + 0.5, y - 0.5, radius) - corner(x - 0.5, y - 0.5, radius);
    // What is left of a cell outside is rounding.
    let area = (upper - lower).clamp(0.0, 1.0);
    if area > 1e-12 { area } else { 0.0 }
}

/// Area of the disc inside the rectangle from the origin to `(x, y)`, odd in both.
fn corner(x: f64, y: f64, radius: f64) -> f64 {
    let sign = x.signum() * y.signum();
    let (x, y) = (x.abs(), y.abs());
    if x * x + y * y <= radius * radius {
        return sign * x * y;
    }
    // ∫ √(r² − t²) dt
    let under = |t: f64| {
        0.5 * (t * (radius * radius - t * t).max(0.0).sqrt() + radius * radius * (t / radius).min(1.0).asin())
    };
    let flat = if y < radius { (radius * radius - y * y).sqrt() } else { 0.0 };
    let end = x.min(radius);
    if flat >= end { sign * y * end } else { sign * (y * flat + under(end) - under(flat)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_cells_together_make_the_disc() {
        for radius in [0.3, 0.5, 1.0, 2.0, 3.0, 3.015, 4.7] {
            let cells = (-6..=6).flat_map(|b| (-6..=6).map(move |a| [a, b, 0]));
            let area: f64 = cells.map(|c| cell_in_disc(c, radius)).sum();
            assert!(
                (area / (std::f64::consts::PI * radius * radius) - 1.0).abs() < 1e-12,
                "{radius}: {area}"
            );
        }
    }

    #[test]
    fn a_cell_is_cut_as_midpoints_say() {
        let (radius, n) = (3.0, 1000);
        for cell in [[3, 0, 0], [2, 2, 0], [3, 1, 0], [2, 3, 0], [0, 0, 0], [1, 2, 0]] {
            let at = |k: usize, c: i32| (k as f64 + 0.5) / n as f64 - 0.5 + f64::from(c);
            let inside = (0..n * n)
                .filter(|k| at(k % n, cell[0]).powi(2) + at(k / n, cell[1]).powi(2) <= radius * radius);
            let sampled = inside.count() as f64 / (n * n) as f64;
            assert!((cell_in_disc(cell, radius) - sampled).abs() < 2e-5, "{cell:?}");
        }
    }
}
