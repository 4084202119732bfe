//! Many independent pieces of work on a few threads.

use std::num::NonZeroUsize;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Threads that so many pieces of work are done on: as many as are given or as there are cores.
pub(crate) fn threads(given: Option<u16>, count: usize) -> usize {
    let cores = || thread::available_parallelism().map_or(1, NonZeroUsize::get);
    given.map_or_else(cores, usize::from).min(count).max(1)
}

/// Does the pieces of work `0..count` side by side, on [`threads`], and returns what
/// they give by their numbers.
pub(crate) fn side_by_side<T: Send>(
    given: Option<u16>,
    count: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(count));
    thread::scope(|scope| {
        for _ in 0..threads(given, count) {
            scope.spawn(|| {
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    if k >= count {
                        break;
                    }
                    let result = work(k);
                    done.lock().expect("no holder of the lock panics").push((k, result));
                }
            });
        }
    });
    let mut done = done.into_inner().expect("no holder of the lock panics");
    done.sort_by_key(|(k, _)| *k);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_work() {
        for threads in [Some(1), Some(7), None] {
            assert_eq!(side_by_side(threads, 5, |k| k * k), [0, 1, 4, 9, 16]);
        }
        assert!(side_by_side(None, 0, |k| k).is_empty());
    }
}
