//! What is known of a body that softens, by name: what checks can ask for.

use super::super::fracture::Facts;
use super::point::PathPoint;
use crate::case::PATH_FACTS;

/// The facts of a path so far.
pub(super) fn facts(points: &[PathPoint]) -> Facts {
    let last = points.last().cloned().unwrap_or_default();
    // Softening begins after the state in which the first bond is at its limit.
    let first = points.windows(2).find(|p| p[1].softened + p[1].broken > 0).map(|p| &p[0]);
    let peak = points.iter().max_by(|a, b| a.load.abs().total_cmp(&b.load.abs()));
    let begin = points.iter().find(|p| p.load_factor != 0.0);
    let largest = |of: fn(&PathPoint) -> f64| points.iter().map(|p| of(p).abs()).fold(0.0, f64::max);
    let back = points.iter().filter(|p| p.is_back).count();
    let values = [
        first.map(|p| p.load_factor),
        first.map(|p| p.load),
        peak.map(|p| p.load_factor),
        peak.map(|p| p.load),
        Some(last.load_factor),
        Some(last.load),
        begin.map(|p| p.load / p.load_factor),
        Some(last.work),
        Some(last.stored),
        Some(last.dissipated),
        Some(largest(|p| p.balance)),
        Some(largest(|p| p.identity)),
        Some(points.len().saturating_sub(1) as f64),
        Some(back as f64),
        points.windows(2).find(|p| p[1].is_branched()).map(|p| p[0].load_factor),
        Some(points.iter().map(|p| p.refused).sum::<usize>() as f64),
        Some(last.broken as f64),
        Some(last.island_points as f64),
    ];
    let named = PATH_FACTS.iter().zip(values).filter_map(|(name, value)| Some((name.to_string(), value?)));
    Facts(named.collect())
}
