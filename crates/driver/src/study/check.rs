//! Faults of a study that its own keys show.

use super::file::{Refine, Study};
use super::refined::steps;
use super::settings::includes;
use crate::diagnostic::{Faults, JsonPath};
use serde_json::{Map, Value};

/// Most tasks of a study.
const MOST: usize = 100_000;

/// Settings of all series; faults of the study.
pub(super) fn check(study: &Study, faults: &mut Faults) -> Vec<Map<String, Value>> {
    let root = |key: &str| JsonPath::default().key(key);
    let levels = study.refine.as_ref().map_or(1, |refine| steps(refine).len());
    let mut series = vec![Map::new()];
    for (k, axis) in study.vary.iter().enumerate() {
        let place = root("vary").index(k);
        let lengths: Vec<Option<usize>> =
            axis.values().map(|v| v.as_array().map(Vec::len).filter(|n| *n > 0)).collect();
        let Some(&Some(length)) = lengths.first().filter(|_| lengths.iter().all(Option::is_some)) else {
            faults
                .error(place, "every path of an axis needs a list of values")
                .hint("for example `{ \"horizon_ratio\": [2, 3, 4] }`");
            continue;
        };
        if lengths.iter().any(|n| *n != Some(length)) {
            faults.error(place, "the paths of an axis move together: their lists must be equally long");
            continue;
        }
        if series.len().saturating_mul(length).saturating_mul(levels) > MOST {
            faults.error(root("vary"), format!("a study has at most {MOST} tasks"));
            break;
        }
        if let Some(path) = axis.keys().find(|path| series.iter().any(|s| s.contains_key(*path))) {
            faults.error(place, format!("`{path}` is varied by another axis, too"));
            continue;
        }
        if (1..length).any(|j| (0..j).any(|i| axis.values().all(|v| v[i] == v[j]))) {
            faults.error(place, "two values of this axis are the same");
            continue;
        }
        let with = |before: &Map<String, Value>, j: usize| {
            let own = axis.iter().map(|(path, values)| (path.clone(), values[j].clone()));
            before.clone().into_iter().chain(own).collect()
        };
        series = series.iter().flat_map(|before| (0..length).map(move |j| with(before, j))).collect();
    }
    if let Some(refine) = &study.refine {
        check_refine(refine, faults);
    }
    let exact = (0..).zip(&study.exact).map(|(k, e)| (root("exact").index(k), &e.r#where));
    let expect = (0..).zip(&study.expect).map(|(k, e)| (root("expect").index(k), &e.r#where));
    for (place, values) in exact.chain(expect) {
        let unknown = values.keys().find(|path| !study.vary.iter().any(|axis| axis.contains_key(*path)));
        if let Some(path) = unknown {
            faults.error(place.key("where"), format!("`{path}` is not varied"));
        } else if !series.iter().any(|settings| includes(settings, values)) {
            faults.error(place.key("where"), "no series has these values");
        }
    }
    for (k, expect) in study.expect.iter().enumerate() {
        let asks = [expect.order, expect.error_at_most, expect.extrapolated_over_finest];
        if asks.iter().all(Option::is_none) {
            faults
                .error(root("expect").index(k), "this expects nothing")
                .hint("give an `order`, `error_at_most` or `extrapolated_over_finest`");
        }
    }
    series
}

fn check_refine(refine: &Refine, faults: &mut Faults) {
    let place = JsonPath::default().key("refine");
    let mut check = |kind: &str, key: &str, values: &[f64], fine: &dyn Fn(usize) -> f64| {
        let path = place.key(kind).key(key);
        if values.len() < 2 {
            faults.error(path, "a refinement needs two values, an extrapolation three");
        } else if !values.iter().all(|v| *v > 0.0 && v.is_finite()) {
            faults.error(path, "all values must be greater than zero");
        } else if (1..values.len()).any(|k| fine(k) <= fine(k - 1)) {
            faults.error(path, "every level must be finer than the one before");
        }
    };
    match refine {
        Refine::DeltaConvergence(r) => check("delta_convergence", "factors", &r.factors, &|k| r.factors[k]),
        Refine::MConvergence(r) => check("m_convergence", "ratios", &r.ratios, &|k| r.ratios[k]),
        Refine::JointConvergence(r) if r.factors.len() == r.ratios.len() => {
            check("joint_convergence", "factors", &r.factors, &|k| r.factors[k]);
            check("joint_convergence", "ratios", &r.ratios, &|k| r.factors[k] * r.ratios[k]);
        }
        Refine::JointConvergence(_) => {
            let path = place.key("joint_convergence").key("ratios");
            faults.error(path, "there must be as many ratios as factors");
        }
        Refine::Values(r) => {
            check("values", "sizes", &r.sizes, &|k| -r.sizes[k]);
            let fits = |list: &Value| list.as_array().is_some_and(|list| list.len() == r.sizes.len());
            for (path, _) in r.set.iter().filter(|(_, list)| !fits(list)) {
                let place = place.key("values").key("set").key(path.as_str());
                faults.error(place, "every path needs a list of as many values as there are sizes");
            }
        }
    }
}
