//! Solving the tasks of a study side by side.

use super::faults::TaskFaults;
use super::plan::{Plan, Task};
use super::record::Record;
use crate::workers::{self, side_by_side};
use crate::{Error, memory};
use std::io;

/// How the tasks of a study are solved, and what becomes of their records.
pub struct Solving<'a> {
    /// Tasks that are solved at the same time; as many as there are cores if not given.
    pub threads: Option<u16>,
    /// Largest memory of all that are solved at the same time, bytes.
    pub max_memory: Option<u64>,
    /// Asked before each task whether to go on.
    pub is_interrupted: &'a (dyn Fn() -> bool + Sync),
    /// Takes the record of each task as it comes.
    pub keep: &'a (dyn Fn(Record) -> io::Result<()> + Sync),
}

impl Solving<'_> {
    /// Solves tasks, which have no faults; returns those that cannot be solved.
    ///
    /// # Errors
    /// [`Error::Tasks`] with the faults of all tasks before one is solved; [`Error::Io`] where a record cannot be kept.
    pub fn solve(&self, plan: &Plan, tasks: &[&Task]) -> Result<TaskFaults, Error> {
        self.check(plan, tasks)?;
        let outcomes = self.with_all(tasks, |task, max_memory| {
            let record = Record::solve(task, &plan.folder, max_memory);
            record.and_then(|record| Ok((self.keep)(record)?))
        });
        let mut faults = Vec::new();
        for (task, outcome) in tasks.iter().zip(outcomes) {
            match outcome {
                Some(Ok(())) | None => {}
                Some(Err(Error::Io(error))) => return Err(Error::Io(error)),
                Some(Err(error)) => faults.push((task.number, error)),
            }
        }
        Ok(TaskFaults::new(plan.tasks.len(), faults))
    }

    /// Finds the faults of all tasks. Too little memory is none: the smaller tasks tell something, too.
    fn check(&self, plan: &Plan, tasks: &[&Task]) -> Result<(), Error> {
        let checked = self.with_all(tasks, |task, max_memory| task.check(&plan.folder, max_memory));
        let fault = |(task, outcome): (&&Task, Option<Result<(), Error>>)| {
            let error = outcome?.err().filter(|error| !error.lacks_memory())?;
            Some((task.number, error))
        };
        let faults = TaskFaults::new(plan.tasks.len(), tasks.iter().zip(checked).filter_map(fault).collect());
        if faults.is_empty() { Ok(()) } else { Err(Error::Tasks(faults)) }
    }

    /// Does something with every task. Those that need more memory than their share follow alone; `None` are those that nobody
    /// waited for.
    fn with_all<T: Send>(
        &self,
        tasks: &[&Task],
        work: impl Fn(&Task, Option<u64>) -> Result<T, Error> + Sync,
    ) -> Vec<Option<Result<T, Error>>> {
        let allowed = memory::allowed(self.max_memory);
        let share = allowed.map(|all| all / workers::threads(self.threads, tasks.len()) as u64);
        let work = |task: &Task, max_memory| (!(self.is_interrupted)()).then(|| work(task, max_memory));
        let first = side_by_side(self.threads, tasks.len(), |k| work(tasks[k], share));
        let again = |(task, outcome): (&&Task, Option<Result<T, Error>>)| match outcome {
            Some(Err(error)) if error.lacks_memory() => work(task, self.max_memory),
            other => other,
        };
        tasks.iter().zip(first).map(again).collect()
    }
}
