//! The system that a problem becomes.

use super::error::RunError;
use super::memory;
use super::options::RunOptions;
use super::problem::{Problem, Spread};
use super::scene_sizes::Sizes;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::body::CONTRADICTION;
use peristat_assembly::condition::Contradiction;
use peristat_assembly::stiffness::{Springs, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};
use std::collections::{HashMap, HashSet};
use std::str::FromStr;

/// Free motions that are reported one by one, at most.
const MOST_MOTIONS: usize = 6;

/// The system of a problem, checked for size, contradictions and free motions, in this order.
///
/// # Errors
/// [`RunError::Memory`] if solving would take more than is allowed, or than the machine has; [`RunError::Case`] names
/// contradicting supports or every motion that nothing holds.
pub fn prepare<const D: usize>(
    problem: &dyn Problem<D>,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError> {
    prepare_within(problem, memory::estimate(problem, options.recover), options)
}

/// The same where solving will take `needed` bytes of memory.
pub(super) fn prepare_within<const D: usize>(
    problem: &dyn Problem<D>,
    needed: u64,
    options: &RunOptions,
) -> Result<(System<D>, Sizes), RunError> {
    check_memory(needed, options.max_memory)?;
    let mut faults = Faults::default();
    let system = system(problem)?;
    let (motions, supports) = (free_motions(problem.model(), &system), JsonPath::default().key("supports"));
    let (told, more) = in_words(problem, &motions);
    for text in told {
        faults.error(supports.clone(), text).hint(problem.remedy());
    }
    if more > 0 {
        let s = if more == 1 { "" } else { "s" };
        faults.error(supports, format!("{more} more motion{s} of this kind would be free"));
    }
    if faults.has_errors() {
        return Err(RunError::Case(faults));
    }
    let sizes = Sizes {
        points: system.points(),
        bonds: system.elements(),
        unknowns: system.independent() - problem.model().idle(),
        estimated_bytes: needed,
    };
    Ok((system, sizes))
}

/// Free motions in words, those of a part that nothing holds as one, and the number of further ones.
fn in_words<const D: usize>(problem: &dyn Problem<D>, motions: &[FreeMotion]) -> (Vec<String>, usize) {
    let mut ways: HashMap<&[[usize; 2]], usize> = HashMap::new();
    motions.iter().for_each(|motion| *ways.entry(&motion.parts).or_default() += 1);
    let all_ways = problem.model().rigid_motions().len();
    let (mut loose, mut told) = (HashSet::new(), Vec::new());
    for (k, motion) in motions.iter().enumerate() {
        if told.len() == MOST_MOTIONS {
            let others = motions[k..].iter().filter(|m| !loose.contains(&&m.parts[..]));
            return (told, others.count());
        }
        if loose.contains(&&motion.parts[..]) {
            continue;
        }
        let of_part = Some(motion).filter(|m| ways.get(&m.parts[..]) == Some(&all_ways));
        match of_part.and_then(|motion| problem.describe_loose(motion)) {
            Some(text) => {
                loose.insert(&motion.parts[..]);
                told.push(text);
            }
            None => told.push(problem.describe(motion)),
        }
    }
    (told, 0)
}

/// The system of a problem with its supports and links, free motions or not.
///
/// # Errors
/// As [`prepare`], but for free motions.
pub(crate) fn constrained<const D: usize>(
    problem: &dyn Problem<D>,
    max_memory: Option<u64>,
) -> Result<System<D>, RunError> {
    check_memory(memory::estimate(problem, false), max_memory)?;
    system(problem)
}

/// An error if more memory is needed than is allowed.
pub(super) fn check_memory(needed: u64, max_memory: Option<u64>) -> Result<(), RunError> {
    let allowed = crate::memory::allowed_for(needed, max_memory);
    if needed > allowed { Err(RunError::Memory { needed, allowed }) } else { Ok(()) }
}

/// The terms, springs and equations of a problem.
///
/// # Errors
/// A contradiction of its equations.
pub(super) fn assembled<const D: usize>(problem: &dyn Problem<D>) -> Result<System<D>, Contradiction> {
    System::new(problem.model(), springs(problem), problem.equations().to_vec())
}

fn springs<const D: usize>(problem: &dyn Problem<D>) -> Vec<Box<dyn Term<D>>> {
    if problem.springs().is_empty() {
        return Vec::new();
    }
    vec![Box::new(Springs::new(problem.model().points(), problem.springs().to_vec()))]
}

/// The system of a problem in a state whose motions are no multiple of those at a factor of one; none where they are.
///
/// # Errors
/// Motions that contradict each other.
pub(crate) fn moved<const D: usize>(
    problem: &dyn Problem<D>,
    system: &System<D>,
    state: usize,
) -> Result<Option<System<D>>, RunError> {
    let Some(values) = problem.motions(state) else { return Ok(None) };
    match system.constraints().with_values(&values) {
        Ok(constraints) => Ok(Some(System::with_constraints(problem.model(), springs(problem), constraints))),
        Err(violated) => {
            let origin = problem.equations().get(violated).map_or("supports", |e| &e.origin);
            let mut faults = Faults::default();
            faults
                .error(
                    JsonPath::from_str(origin).unwrap_or_default(),
                    format!("`{origin}` contradicts other motions in step {}", state + 1),
                )
                .hint(CONTRADICTION);
            Err(RunError::Case(faults))
        }
    }
}

fn system<const D: usize>(problem: &dyn Problem<D>) -> Result<System<D>, RunError> {
    match assembled(problem) {
        Ok(system) => Ok(system),
        Err(contradiction) => {
            let mut faults = Faults::default();
            let path = JsonPath::from_str(&contradiction.origin).unwrap_or_default();
            let mut others: Vec<String> = contradiction
                .others
                .iter()
                .filter(|o| **o != contradiction.origin)
                .map(|o| format!("`{o}`"))
                .collect();
            others.sort_unstable();
            others.dedup();
            let message = match others.is_empty() {
                true => format!("`{}` contradicts itself", contradiction.origin),
                false => format!("`{}` contradicts {}", contradiction.origin, others.join(", ")),
            };
            faults.error(path, message).hint(match problem.spread() {
                Spread::Chain => {
                    "prescribe each motion once; points that a link or a joint joins move together"
                }
                _ => CONTRADICTION,
            });
            Err(RunError::Case(faults))
        }
    }
}
