//! Tasks of a study that cannot be solved, and why: the report of all comes before the first solution.

use crate::Error;
use std::collections::HashMap;
use std::fmt;

/// Tasks that cannot be solved.
#[derive(Debug)]
pub struct TaskFaults {
    tasks: usize,
    /// Numbers of tasks with their fault.
    faults: Vec<(usize, Error)>,
}

impl TaskFaults {
    /// Faults of some of the tasks of a study, by their numbers.
    pub fn new(tasks: usize, faults: Vec<(usize, Error)>) -> Self {
        Self { tasks, faults }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    /// Every fault once, with the tasks that have it in words, such as `tasks 1 to 3 and 5 of 6`.
    pub fn groups(&self) -> impl Iterator<Item = (String, &Error)> {
        let mut groups: Vec<(Vec<usize>, &Error)> = Vec::new();
        let mut known: HashMap<String, usize> = HashMap::new();
        for (task, error) in &self.faults {
            // What is wrong, not the lines that show it: these have the values of their task.
            let fault = match error {
                Error::Case(report) => format!("{:?}", report.diagnostics),
                other => other.to_string(),
            };
            let group = *known.entry(fault).or_insert(groups.len());
            if group == groups.len() {
                groups.push((Vec::new(), error));
            }
            groups[group].0.push(*task);
        }
        groups.into_iter().map(|(numbers, error)| {
            let s = if numbers.len() == 1 { "" } else { "s" };
            (format!("task{s} {} of {}", words(&numbers), self.tasks), error)
        })
    }
}

impl fmt::Display for TaskFaults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let texts = self.groups().map(|(tasks, error)| format!("{tasks}:\n{}", error.to_string().trim_end()));
        f.write_str(&texts.collect::<Vec<_>>().join("\n\n"))
    }
}

/// Growing numbers in words: `1 to 3, 5 and 8`.
fn words(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).flat_map(|run| match run {
        [first, .., last] if run.len() > 2 => vec![format!("{first} to {last}")],
        _ => run.iter().map(ToString::to_string).collect(),
    });
    let mut runs: Vec<String> = runs.collect();
    match (runs.pop(), runs.is_empty()) {
        (Some(last), false) => format!("{} and {last}", runs.join(", ")),
        (last, _) => last.unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io;

    #[test]
    fn a_fault_of_many_tasks_is_told_once() {
        let fault = |text: &str| Error::Io(io::Error::other(text.to_string()));
        let all = [(1, "a"), (2, "a"), (3, "b"), (4, "a"), (5, "a"), (6, "a")];
        let faults = TaskFaults::new(7, all.map(|(task, text)| (task, fault(text))).into());
        let told: Vec<String> = faults.groups().map(|(tasks, _)| tasks).collect();
        assert_eq!(told, ["tasks 1, 2 and 4 to 6 of 7", "task 3 of 7"]);
        assert_eq!(faults.to_string(), "tasks 1, 2 and 4 to 6 of 7:\na\n\ntask 3 of 7:\nb");
    }
}
