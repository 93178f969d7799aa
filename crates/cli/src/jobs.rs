//! Work on several files at once.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// Works on all items with so many threads. `done` gets the results in the order of the items, as
/// soon as all before them are there, so that what is printed does not depend on the threads.
pub(crate) fn in_order<T: Sync, R: Send, E>(
    items: &[T],
    jobs: usize,
    work: impl Fn(&T) -> R + Sync,
    mut done: impl FnMut(&T, R) -> Result<(), E>,
) -> Result<(), E> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..jobs.clamp(1, items.len().max(1)) {
            let (sender, next, work) = (sender.clone(), &next, &work);
            scope.spawn(move || {
                while let Some((index, item)) = take(items, next) {
                    // Nobody listens any more after an error: the rest need not be done.
                    if sender.send((index, work(item))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut first = 0;
        for (index, result) in receiver {
            waiting.insert(index, result);
            while let Some(result) = waiting.remove(&first) {
                done(&items[first], result)?;
                first += 1;
            }
        }
        Ok(())
    })
}

fn take<'a, T>(items: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    items.get(index).map(|item| (index, item))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every item is worked on once, and the results come in order, with any number of threads.
    #[test]
    fn results_come_in_order() {
        let items: Vec<u64> = (0..100).collect();
        for jobs in [0, 1, 3, 200] {
            let mut results = vec![];
            let work = |item: &u64| (0..(100 - item) * 100).sum::<u64>() + item;
            let done = |item: &u64, result| {
                results.push((*item, result));
                Ok::<(), ()>(())
            };
            assert_eq!(in_order(&items, jobs, work, done), Ok(()));
            let expected: Vec<_> = items.iter().map(|item| (*item, work(item))).collect();
            assert_eq!(results, expected);
        }
        assert_eq!(in_order(&items, 2, |item| *item, |_, item| Err(item)), Err(0));
    }
}
