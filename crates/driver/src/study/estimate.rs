//! The discretisation error of one run, from the same case on other spacings.

use super::order::{self, ROUNDING};
use super::record::{Measured, values};
use crate::case::{self, Body};
use crate::run::{RunOptions, taking};
use crate::summary::words::times;
use crate::summary::{Estimate, Estimates, Summary};
use crate::{Error, Loaded};
use peristat_assembly::model::timoshenko_beam::Grid;
use std::time::Instant;

/// Order that is assumed where none can be observed: from half the spacing the estimate is then within a third of the error
/// for every order from 1 up.
const ASSUMED: f64 = 2.0;
/// Smallest order that is believed: a lower one is that of values which do not yet go anywhere.
const LEAST: f64 = 1.0;

impl Loaded {
    /// Estimates the discretisation error of every probe of a run, and of its energy: the case is solved on a finer and on a
    /// coarser grid that have its points among theirs, or theirs among its own, with the same horizon ratio; where the finer
    /// one needs too much memory, on two coarser ones.
    ///
    /// # Errors
    /// Why there is no estimate.
    pub fn estimate(&self, summary: &Summary, max_memory: Option<u64>) -> Result<Estimates, String> {
        if self.scene.case().is_traced() {
            return Err("bodies that break or soften jump: their errors are not estimated".into());
        }
        let begin = Instant::now();
        let own = values(summary);
        let ratio = nested(&self.written.body);
        let other = |factor: f64| self.at_spacing(factor, max_memory);
        let finer = match other(ratio) {
            Ok(finer) => Some(finer),
            Err(Failure::Memory(_)) => None,
            Err(Failure::Other(reason)) => return Err(reason),
        };
        let mut remark = None;
        let (spacings, others) = match (finer, other(1.0 / ratio)) {
            (Some(finer), Ok(coarser)) => (vec![ratio, 1.0 / ratio], vec![coarser, finer]),
            (Some(finer), Err(failure)) => {
                remark = Some(format!("no order can be observed: {}", failure.reason()));
                (vec![1.0 / ratio], vec![finer])
            }
            (None, Ok(coarser)) => {
                let coarsest = other(1.0 / ratio / ratio).map_err(Failure::reason)?;
                (vec![ratio * ratio, ratio], vec![coarsest, coarser])
            }
            (None, Err(failure)) => return Err(failure.reason()),
        };
        let find = |all: &[Measured], name: &str| all.iter().find(|m| m.name == name).map(|m| m.value);
        let of = |own: &Measured| {
            let others = others.iter().map(|all| find(all, &own.name)).collect::<Option<Vec<f64>>>()?;
            Some(estimate(own, &spacings, &others))
        };
        Ok(Estimates {
            against: "the local solution, horizon and spacing to zero at the same ratio".into(),
            quantities: own.iter().filter_map(of).collect(),
            seconds: begin.elapsed().as_secs_f64(),
            spacings,
            remark,
        })
    }

    /// Values of the same case with its spacing and horizon divided by a factor.
    fn at_spacing(&self, factor: f64, max_memory: Option<u64>) -> Result<Vec<Measured>, Failure> {
        let overrides = self.written.refined(factor).map_err(Failure::Other)?;
        let mut overrides: Vec<String> =
            overrides.iter().map(|(path, value)| format!("{path}={value}")).collect();
        // Checks may name files that fit one spacing only.
        overrides.push("checks=[]".into());
        let solved = case::from_text(&self.file, self.text.clone(), &overrides)
            .map_err(Error::Case)
            .and_then(|source| Loaded::from_source(source, self.folder.clone(), max_memory))
            .and_then(|loaded| {
                loaded.run(&RunOptions { recover: false, max_memory }, None, &mut taking(|_| Ok(())))
            });
        match solved {
            Ok(summary) if summary.states.iter().all(|state| state.certificate.converged) => {
                Ok(values(&summary))
            }
            Ok(_) => Err(Failure::Other(format!(
                "at {} times the spacing a state did not converge",
                times(1.0 / factor)
            ))),
            Err(error) if error.lacks_memory() => Err(Failure::Memory(error.to_string())),
            Err(Error::Case(report)) => {
                let first = report.diagnostics.first().map_or(String::new(), |d| d.message.clone());
                Err(Failure::Other(format!("at {} times the spacing: {first}", times(1.0 / factor))))
            }
            Err(other) => Err(Failure::Other(other.to_string())),
        }
    }
}

/// The smallest whole number of cells into which a cell can be divided so that its point stays one.
fn nested(body: &Body) -> f64 {
    let at_ends = match body {
        Body::Frame(_) => true,
        Body::Line(_) | Body::Lines(_) => body.lines().iter().all(|line| line.grid == Grid::Nodes),
        _ => false,
    };
    if at_ends { 2.0 } else { 3.0 }
}

/// Why another spacing has no values.
enum Failure {
    Memory(String),
    Other(String),
}

impl Failure {
    fn reason(self) -> String {
        match self {
            Self::Memory(reason) | Self::Other(reason) => reason,
        }
    }
}

/// The estimate for a value from those at other spacings, relative to its own, coarse to fine.
fn estimate(own: &Measured, spacings: &[f64], others: &[f64]) -> Estimate {
    let mut all: Vec<(f64, f64)> = spacings.iter().copied().zip(others.iter().copied()).collect();
    all.push((1.0, own.value));
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (h, q): (Vec<f64>, Vec<f64>) = all.into_iter().unzip();
    let last = h.len() - 1;
    let observed = match (<[f64; 3]>::try_from(&h[..]), <[f64; 3]>::try_from(&q[..])) {
        (Ok(h), Ok(q)) => order::of_three(h, q).ok(),
        _ => None,
    };
    let pair = ([h[last - 1], h[last]], [q[last - 1], q[last]]);
    let limit = order::extrapolate(pair.0, pair.1, observed.map_or(ASSUMED, |order| order.max(LEAST)));
    let settled = (q[last] - q[last - 1]).abs() <= ROUNDING * q[last].abs();
    let error = (own.value - limit).abs();
    let basis = match observed {
        _ if settled => "both spacings agree to rounding".into(),
        Some(order) if order < LEAST => format!("order {order:.2} observed, {LEAST} taken"),
        Some(order) => format!("order {order:.2} observed"),
        None => format!("order {ASSUMED} assumed"),
    };
    Estimate {
        name: own.name.clone(),
        value: own.value,
        error,
        relative: (limit != 0.0).then(|| error / limit.abs()),
        order: observed.filter(|_| !settled),
        basis,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_estimated_and_no_order_is_safe() {
        let own = |value| Measured { name: "tip".into(), value };
        // 1 + 0.1 h².
        let found = estimate(&own(1.1), &[2.0, 0.5], &[1.4, 1.025]);
        assert!((found.error - 0.1).abs() < 1e-12 && (found.order.unwrap() - 2.0).abs() < 1e-12, "{found:?}");
        // The same without the coarser one.
        let found = estimate(&own(1.1), &[0.5], &[1.025]);
        assert!((found.error - 0.1).abs() < 1e-12 && found.order.is_none(), "{found:?}");
        // From coarser ones alone.
        let found = estimate(&own(1.1), &[4.0, 2.0], &[2.6, 1.4]);
        assert!((found.error - 0.1).abs() < 1e-12, "{found:?}");
        let found = estimate(&own(1.0), &[2.0, 0.5], &[1.0, 1.0]);
        assert_eq!((found.error, found.basis.as_str()), (0.0, "both spacings agree to rounding"));
    }
}
