//! Runs the objects that have to run, each as soon as all it reads is done.

use std::sync::OnceLock;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::graph::Graph;

/// The objects that have to run, in an order in which each stands behind all it reads.
#[derive(Debug)]
pub(crate) struct Todo {
    objects: Vec<usize>,
    /// For each object of the document, one more than its place in `objects`; 0 for those that need not run. Zeros
    /// come from the system for free, so that a large document costs nothing where little has to run.
    places: Vec<usize>,
}

impl Todo {
    /// Those of `dirty` that can run, and those that cannot because they are in a loop.
    pub(crate) fn new(graph: &Graph, dirty: &[usize]) -> (Self, Vec<usize>) {
        let mut looped = Vec::new();
        let mut ranked = Vec::with_capacity(dirty.len());
        for &object in dirty {
            match graph.rank.get(object).copied().flatten() {
                Some(rank) => ranked.push((rank, object)),
                None => looped.push(object),
            }
        }
        ranked.sort_unstable();
        let mut places = vec![0; graph.rank.len()];
        let objects: Vec<usize> = ranked.into_iter().map(|(_, object)| object).collect();
        for (place, &object) in (1..).zip(&objects) {
            places[object] = place;
        }
        (Self { objects, places }, looped)
    }

    /// The objects, in order.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = usize> {
        self.objects.iter().copied()
    }

    /// The place of an object of the document among those that have to run.
    pub(crate) fn place(&self, object: usize) -> Option<usize> {
        self.places.get(object)?.checked_sub(1)
    }
}

/// Calls `task` for each object of `todo` once all of them that it reads are done; the results come back by place.
#[cfg(feature = "parallel")]
pub(crate) fn run<T: Send + Sync>(
    graph: &Graph,
    todo: &Todo,
    results: &[OnceLock<T>],
    task: impl Fn(usize) -> T + Sync,
) {
    // A handful of objects is done before a pool is awake.
    if todo.objects.len() < 2 || rayon::current_num_threads() == 1 {
        return in_order(todo, results, task);
    }
    let missing: Vec<AtomicUsize> = todo.iter().map(|_| AtomicUsize::new(0)).collect();
    for object in todo.iter() {
        for reader in graph.followers(object).iter().filter_map(|&reader| todo.place(reader)) {
            missing[reader].fetch_add(1, Ordering::Relaxed);
        }
    }
    let ready: Vec<usize> =
        (0..missing.len()).filter(|&place| missing[place].load(Ordering::Relaxed) == 0).collect();
    let shared = Shared { graph, todo, results, missing: &missing, task: &task };
    let Some((&first, others)) = ready.split_first() else { return };
    // The first on this thread: objects in a single row never wake the pool.
    rayon::in_place_scope(|scope| {
        for &place in others {
            scope.spawn(move |scope| shared.step(scope, place));
        }
        shared.step(scope, first);
    });
}

#[cfg(feature = "parallel")]
struct Shared<'a, T, F> {
    graph: &'a Graph,
    todo: &'a Todo,
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
    /// Runs the object at a place, then what waited for it alone: the first on this thread, the others on any.
    fn step(self, scope: &rayon::Scope<'a>, first: usize) {
        let mut next = Some(first);
        while let Some(place) = next.take() {
            let object = self.todo.objects[place];
            let _ = self.results[place].set((self.task)(object));
            for reader in self.graph.followers(object).iter().filter_map(|&reader| self.todo.place(reader)) {
                if self.missing[reader].fetch_sub(1, Ordering::AcqRel) != 1 {
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
    _: &Graph,
    todo: &Todo,
    results: &[OnceLock<T>],
    task: impl Fn(usize) -> T + Sync,
) {
    in_order(todo, results, task);
}

fn in_order<T>(todo: &Todo, results: &[OnceLock<T>], task: impl Fn(usize) -> T) {
    for (object, result) in todo.iter().zip(results) {
        let _ = result.set(task(object));
    }
}
