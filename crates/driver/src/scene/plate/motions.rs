//! Free motions of a plate in words.

use super::scene::PlateScene;
use crate::diagnostic::tidy;
use peristat_assembly::model::{Model, Points};
use peristat_assembly::system::FreeMotion;

impl PlateScene {
    /// What nothing holds, and how it would move.
    pub fn describe(&self, motion: &FreeMotion) -> String {
        let (parts, motions) = (self.plate.connected(), self.plate.rigid_motions());
        let mut told = Vec::new();
        for (span, part) in motion.parts.iter().zip(&motion.moves) {
            let own = parts.of(span[0]);
            let points = (0..self.plate.points()).filter(|&point| parts.of(point) == own);
            let what = match points.count() == self.plate.points() {
                true => "the plate".to_string(),
                false => {
                    let [x, y, _] = self.plate.position(span[0]);
                    format!("the part of the plate at ({}, {})", tidy(x), tidy(y))
                }
            };
            let last = part.amounts.iter().rposition(|amount| *amount != 0.0).unwrap_or(0);
            // A tilt and a translation are a tilt about another line.
            let [x, y, _] = part.centre;
            let moved = |kind: usize| if kind == last { part.amounts[0] / part.amounts[last] } else { 0.0 };
            let [x, y] = [x - moved(1), y - moved(2)];
            let verb = motions[last].verb.replace("{centre}", &format!("({}, {})", tidy(x), tidy(y)));
            told.push(format!("{what} is free to {verb}"));
        }
        format!("{}: no support prevents it", told.join(", and "))
    }
}
