//! Fields between two points of a line, as the exact element that joins them has them.

use super::BeamResult;
use crate::case::FieldName;
use crate::scene::beam::{BeamScene, BetweenPoints};

/// Value of a field between two points; none where it was not recovered or does not exist. Displacements are those of the
/// element with the section in its middle, without what a load on it adds. Section forces are statics from the point before;
/// where loads act on points alone, the moment has the slope −V at both ends.
pub(super) fn value(
    scene: &BeamScene,
    result: &BeamResult,
    field: FieldName,
    at: &BetweenPoints,
) -> Option<f64> {
    let fields = &result.lines[at.line];
    let x = [0, 1].map(|side| fields.x.at(at.before + side));
    let length = x[1] - x[0];
    let q = (at.x - x[0]) / length;
    let ends = |field: FieldName| {
        let [left, right] = [0, 1].map(|side| result.value(field, at.line, at.before + side));
        Some([left?, right?])
    };
    // Seen from inside the cell, where a field may jump at its ends.
    let inside = |field: FieldName| Some(result.cells(field, at.line)?[at.before]);
    let linear = |[a, b]: [f64; 2]| a + q * (b - a);
    let bent = || {
        let line = scene.beam.chains()[at.line].line();
        let compliance = line.stiffness.compliance(0.5 * (x[0] + x[1]) - line.from);
        let softness = compliance.shear / (compliance.bending * length * length);
        Some(element(ends(FieldName::W)?, ends(FieldName::Phi)?, length, softness, q))
    };
    let loads = &scene.states[result.record.index].loads;
    let [force, lever, axial] = loads.carried_between(at.line, [x[0], at.x]);
    let section = |field: FieldName, carried: f64| {
        let ends = inside(field)?;
        Some(if loads.lumped { linear(ends) } else { ends[0] - carried })
    };
    let moment = || {
        let [m, v] = [inside(FieldName::M)?, inside(FieldName::V)?];
        Some(match loads.lumped {
            true => hermite(m, v.map(|v| -v * length), q),
            false => m[0] - v[0] * (at.x - x[0]) + lever,
        })
    };
    let stress = |sign: f64| {
        let n = result.fields().contains(&FieldName::N).then(|| section(FieldName::N, axial)).flatten();
        fields.stress(sign, [moment()?, n.unwrap_or(0.0)], at.x, x[1])
    };
    let along = || ends(FieldName::U).map_or(0.0, linear);
    let [c, s] = fields.direction;
    match field {
        FieldName::W => Some(bent()?[0]),
        FieldName::Phi => Some(bent()?[1]),
        FieldName::Ux => Some(c * along() - s * bent()?[0]),
        FieldName::Uy => Some(s * along() + c * bent()?[0]),
        FieldName::U | FieldName::EnergyDensity => ends(field).map(linear),
        FieldName::M => moment(),
        FieldName::V => section(field, force),
        FieldName::N => section(field, axial),
        FieldName::StressTop => stress(-1.0),
        FieldName::StressBottom => stress(1.0),
        _ => None,
    }
}

/// Deflection and rotation at a share of the length of an element that nothing loads between its ends; `softness` is
/// EI/(S length²) with the shear stiffness S.
fn element(w: [f64; 2], phi: [f64; 2], length: f64, softness: f64, q: f64) -> [f64; 2] {
    let gap = (w[1] - w[0]) / length - 0.5 * (phi[0] + phi[1]);
    // The rotation is a parabola, whose curvature is that of the shear force: S γ = −EI φ″.
    let rise = 6.0 * gap / (1.0 + 12.0 * softness);
    let turn = (1.0 - q) * phi[0] + q * phi[1] + rise * q * (1.0 - q);
    let slopes = phi[0] * q * (1.0 - 0.5 * q) + phi[1] * 0.5 * q * q;
    let sheared = rise * (q * q * (0.5 - q / 3.0) + 2.0 * softness * q);
    [w[0] + length * (slopes + sheared), turn]
}

/// The cubic with values and slopes at both ends, over a unit of length.
fn hermite(values: [f64; 2], slopes: [f64; 2], q: f64) -> f64 {
    let (rest, step) = (1.0 - q, values[1] - values[0]);
    values[0] + q * step + q * rest * (rest * (slopes[0] - step) - q * (slopes[1] - step))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_exact_for_one_shear_force() {
        // φ = 1 + 2 x − 3 x² over a length of 2 with EI = 1: S γ = 6, w = x + x² − x³ + γ x, here with S = 4.
        let (gamma, length) = (1.5, 2.0);
        let phi = |x: f64| 1.0 + 2.0 * x - 3.0 * x * x;
        let w = |x: f64| x + x * x - x * x * x + gamma * x;
        let ends = |f: &dyn Fn(f64) -> f64| [f(0.0), f(length)];
        for q in [0.0, 0.3, 0.5, 1.0] {
            let [found_w, found_phi] =
                element(ends(&w), ends(&phi), length, 1.0 / (4.0 * length * length), q);
            assert!((found_w - w(q * length)).abs() < 1e-14, "{q}");
            assert!((found_phi - phi(q * length)).abs() < 1e-14, "{q}");
        }
    }

    #[test]
    fn cubics_are_met() {
        let f = |x: f64| 2.0 - x + 3.0 * x * x - 4.0 * x * x * x;
        let slope = |x: f64| -1.0 + 6.0 * x - 12.0 * x * x;
        for q in [0.0, 0.2, 0.7, 1.0] {
            assert!((hermite([f(0.0), f(1.0)], [slope(0.0), slope(1.0)], q) - f(q)).abs() < 1e-14);
        }
    }
}
