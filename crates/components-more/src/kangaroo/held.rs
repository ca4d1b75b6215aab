//! A solver in a hand: while particles are dragged it goes on from where they are.
//!
//! A solve begins anew as long as nobody has dragged, so that it gives what `katydid run` gives. From the first drag on it
//! goes on from where the one before ended, until any other goal, or a point that goals begin with, is another.

use std::sync::{Arc, Weak};

use katydid_component::Context;
use katydid_data::Keeper;
use katydid_geometry::{Point3, Vector3};

use super::solve::System;
use super::thresholds::{HELD_PULLS, HELD_STEPS};

/// Where a solver was when it ended.
#[derive(Debug, Clone)]
struct State {
    owner: Owner,
    points: Vec<Point3>,
    speeds: Vec<Vector3>,
    /// What the goals keep from step to step, but for hands.
    memories: Vec<Vec<f64>>,
    steps: usize,
    /// Where hands took hold, with the particles that they took.
    holds: Vec<(Point3, usize)>,
    /// Whether somebody has dragged since it began.
    is_dragged: bool,
}

/// Whose state it is: goals are known by being the very same things, as outputs are that were not computed anew.
#[derive(Debug, Clone)]
struct Owner {
    /// Which solver.
    name: &'static str,
    goals: Vec<Weak<dyn Keeper>>,
    start: Vec<Point3>,
}

impl Owner {
    fn of(name: &'static str, system: &System) -> Self {
        let goals = system.goals.iter().filter(|goal| goal.grab().is_none());
        Self {
            name,
            goals: goals.map(|goal| Arc::downgrade(&goal.keeper)).collect(),
            start: system.points.clone(),
        }
    }

    fn is(&self, other: &Self) -> bool {
        self.name == other.name
            && self.start == other.start
            && self.goals.len() == other.goals.len()
            // What somebody still refers to has its place in memory to itself.
            && self.goals.iter().zip(&other.goals).all(|(a, b)| std::ptr::addr_eq(a.as_ptr(), b.as_ptr()))
    }

    /// Whether its goals are gone: it never comes again.
    fn is_gone(&self) -> bool {
        self.goals.iter().any(|goal| goal.strong_count() == 0)
    }
}

/// What a solver remembers from its beginning to its end.
#[derive(Default)]
pub(super) struct Hand {
    owner: Option<Owner>,
    holds: Vec<(Point3, usize)>,
    is_dragged: bool,
}

impl Hand {
    /// Takes the system to where a drag has left it, and has hands take their particles. Nothing happens where no goal
    /// waits for a hand, or nobody looks on.
    pub(super) fn take(context: &Context<'_>, name: &'static str, system: &mut System) -> Self {
        let waits = system.goals.iter().any(|goal| goal.grab().is_some());
        let Some(kept) = context.kept().filter(|_| waits) else { return Self::default() };
        let owner = Owner::of(name, system);
        let state = kept.find(|state: &State| state.owner.is(&owner));
        let held = taken(system, state.as_ref());
        held.iter().for_each(|(k, _, particle)| system.bind(*k, *particle));
        let is_dragged = !held.is_empty() || state.as_ref().is_some_and(|state| state.is_dragged);
        if let Some(state) = state.filter(|_| is_dragged) {
            state.put_back(system);
        }
        let holds = held.into_iter().map(|(_, from, particle)| (from, particle)).collect();
        Self { owner: Some(owner), holds, is_dragged }
    }

    /// Whether a particle is held.
    pub(super) fn is_held(&self) -> bool {
        !self.holds.is_empty()
    }

    /// The most steps of a solve, each of which takes all pulls so many times: few while a particle is held, as the next solve
    /// follows.
    pub(super) fn most_steps(&self, system: &System, times: usize) -> usize {
        if !self.is_held() {
            return system.most_steps_of(times);
        }
        (HELD_PULLS / system.pull_count().saturating_mul(times).max(1)).clamp(1, HELD_STEPS)
    }

    /// Keeps where the system is.
    pub(super) fn keep(self, context: &Context<'_>, system: &System) {
        let (Some(kept), Some(owner)) = (context.kept(), self.owner) else { return };
        kept.forget(|state: &State| state.owner.is_gone() || state.owner.is(&owner));
        let memories = system.goals.iter().filter(|goal| goal.grab().is_none());
        kept.put(State {
            owner,
            points: system.points.clone(),
            speeds: system.speeds.clone(),
            memories: memories.map(|goal| goal.memory.clone()).collect(),
            steps: system.steps,
            holds: self.holds,
            is_dragged: self.is_dragged,
        });
    }
}

/// The goals whose hands hold a particle: their numbers, where the hands took hold, and the particles.
fn taken(system: &System, state: Option<&State>) -> Vec<(usize, Point3, usize)> {
    let at = state.map_or(&system.points, |state| &state.points);
    // Who goes on dragging keeps the particle, wherever it is by now.
    let known = |from: Point3| {
        let held = state?.holds.iter().find(|(place, _)| *place == from);
        held.map(|(_, particle)| *particle)
    };
    let hands = system.goals.iter().enumerate().filter_map(|(k, goal)| Some((k, goal.grab()?)));
    let held = hands.filter_map(|(k, grab)| {
        let from = grab.hold()?.from;
        Some((k, from, known(from).or_else(|| grab.taken(at))?))
    });
    held.collect()
}

impl State {
    /// Takes the system, of the same goals, to where it was.
    fn put_back(self, system: &mut System) {
        system.points = self.points;
        system.speeds = self.speeds;
        system.steps = self.steps;
        let goals = system.goals.iter_mut().filter(|goal| goal.grab().is_none());
        goals.zip(self.memories).for_each(|(goal, memory)| goal.memory = memory);
    }
}

/// Forgets where a solver was: it is to begin anew.
pub(super) fn begin_anew(context: &Context<'_>, name: &'static str, system: &System) {
    let Some(kept) = context.kept() else { return };
    let owner = Owner::of(name, system);
    kept.forget(|state: &State| state.owner.is_gone() || state.owner.is(&owner));
}
