//! Runs the objects that have to run, each as soon as all it reads is done.

use std::sync::OnceLock;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::graph::Graph;

/// Calls `task` for each object of `todo` once all objects it reads are done; those not in `todo` count as
/// done. The results come back by object.
#[cfg(feature = "parallel")]
pub(crate) fn run<T: Send + Sync>(
    graph: &Graph,
    todo: &[bool],
    results: &[OnceLock<T>],
    task: impl Fn(usize) -> T + Sync,
) {
    let missing: Vec<AtomicUsize> = (0..todo.len()).map(|_| AtomicUsize::new(0)).collect();
    let mut pending = 0;
    for &object in &graph.order {
        if !todo[object] {
            continue;
        }
        pending += 1;
        for &reader in &graph.readers[object] {
            missing[reader].fetch_add(1, Ordering::Relaxed);
        }
    }
    // A handful of objects is done before a pool is awake.
    if pending < 2 || rayon::current_num_threads() == 1 {
        return in_order(graph, todo, results, task);
    }
    let ready: Vec<usize> = graph
        .order
        .iter()
        .copied()
        .filter(|&object| todo[object] && missing[object].load(Ordering::Relaxed) == 0)
        .collect();
    let shared = Shared { graph, todo, results, missing: &missing, task: &task };
    rayon::scope(|scope| {
        for object in ready {
            scope.spawn(move |scope| shared.step(scope, object));
        }
    });
}

#[cfg(feature = "parallel")]
struct Shared<'a, T, F> {
    graph: &'a Graph,
    todo: &'a [bool],
    results: &'a [OnceLock<T>],
    missing: &'a [AtomicUsize],
    task: &'a F,
}

#[cfg(feature = "parallel")]
impl<T, F> Clone for Shared<'_, T, F> {
    fn clone(&self) -> Self {
        *self
    }
}

#[cfg(feature = "parallel")]
impl<T, F> Copy for Shared<'_, T, F> {}

#[cfg(feature = "parallel")]
impl<'a, T: Send + Sync, F: Fn(usize) -> T + Sync> Shared<'a, T, F> {
    /// Runs an object, then what waited for it alone: the first on this thread, the others on any.
    fn step(self, scope: &rayon::Scope<'a>, first: usize) {
        let mut next = Some(first);
        while let Some(object) = next.take() {
            let _ = self.results[object].set((self.task)(object));
            for &reader in &self.graph.readers[object] {
                if !self.todo[reader] || self.missing[reader].fetch_sub(1, Ordering::AcqRel) != 1 {
                    continue;
                }
                if next.is_none() {
                    next = Some(reader);
                } else {
                    scope.spawn(move |scope| self.step(scope, reader));
                }
            }
        }
    }
}

/// The same on one thread.
#[cfg(not(feature = "parallel"))]
pub(crate) fn run<T: Send + Sync>(
    graph: &Graph,
    todo: &[bool],
    results: &[OnceLock<T>],
    task: impl Fn(usize) -> T + Sync,
) {
    in_order(graph, todo, results, task);
}

fn in_order<T>(graph: &Graph, todo: &[bool], results: &[OnceLock<T>], task: impl Fn(usize) -> T) {
    for &object in &graph.order {
        if todo[object] {
            let _ = results[object].set(task(object));
        }
    }
}
