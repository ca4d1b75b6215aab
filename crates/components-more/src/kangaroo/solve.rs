//! Particles brought to rest: the weighted mean of what their goals ask for, step by step.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_component::{Context, Message};
use katydid_data::{Content, Value};
use katydid_geometry::{Point3, Vector3};

use super::goal::Place;
use super::grab::Grab;
use super::thresholds::{MOST_PULLS, MOST_STEPS, SHORTEST};
use super::{Goal, Pull};

/// One goal with the numbers of its particles.
pub(super) struct Bound {
    pub(super) keeper: Arc<dyn katydid_data::Keeper>,
    /// Where its particles stand in the list of all goals' particles.
    from: usize,
    to: usize,
    pub(super) memory: Vec<f64>,
}

impl Bound {
    /// The hand that drags for this goal, where it has one.
    pub(super) fn grab(&self) -> Option<&Grab> {
        self.keeper.as_any().downcast_ref::<Goal>()?.rule.grab()
    }
}

/// The particles and goals of a solver.
pub(super) struct System {
    pub(super) points: Vec<Point3>,
    pub(super) speeds: Vec<Vector3>,
    pub(super) goals: Vec<Bound>,
    /// The particles of all goals, one goal after another.
    particles: Vec<usize>,
    pulls: Vec<Pull>,
    /// Which of them had a weight in the step before.
    held: Vec<bool>,
    sums: Vec<(Vector3, f64)>,
    /// Particles that a goal has let go of in this step.
    freed: Vec<bool>,
    at: Vec<Point3>,
    pub(super) steps: usize,
    /// Goals' items in order, with their numbers; what was no goal has none.
    order: Vec<Option<usize>>,
}

/// How a system moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Motion {
    /// As quickly to rest as can be: particles keep their speed while they go the way they are pulled.
    ToRest,
    /// As things with inertia; the share of speed that is left after a step.
    Inertia(f64),
}

fn goal_of(value: &Value) -> Option<Arc<dyn katydid_data::Keeper>> {
    let Value::Content(content) = value else { return None };
    let Content::Token(token) = &**content else { return None };
    token.0.as_any().is::<Goal>().then(|| token.0.clone())
}

/// Particles by place: points nearer than the tolerance are one.
struct Places {
    tolerance: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl Places {
    fn cell(&self, p: Point3) -> [i64; 3] {
        // Beyond 2^53 cells all numbers round to whole ones anyway; the cast saturates.
        [p.x, p.y, p.z].map(|x| (x / self.tolerance).floor() as i64)
    }

    fn find(&self, p: Point3, points: &[Point3]) -> Option<usize> {
        let [x, y, z] = self.cell(p);
        let mut best: Option<usize> = None;
        for dx in -1..=1 {
            for dy in -1..=1 {
                for dz in -1..=1 {
                    let key = [x.saturating_add(dx), y.saturating_add(dy), z.saturating_add(dz)];
                    for &i in self.cells.get(&key).map_or(&[][..], Vec::as_slice) {
                        let near = points.get(i).is_some_and(|q| q.distance_to(p) <= self.tolerance);
                        // The first of all that are near, on whichever side of a cell's wall.
                        if near && best.is_none_or(|b| i < b) {
                            best = Some(i);
                        }
                    }
                }
            }
        }
        best
    }

    fn add(&mut self, p: Point3, i: usize) {
        let key = self.cell(p);
        self.cells.entry(key).or_default().push(i);
    }
}

impl System {
    /// The system of these items; what is no goal is passed over.
    ///
    /// # Errors
    /// The tolerance is not a positive number; too many points; a goal asks for a particle that there is not.
    pub(super) fn new(
        context: &Context<'_>,
        items: &[Option<Value>],
        first: &[Point3],
        tolerance: f64,
    ) -> Result<Self, Message> {
        /// A particle with its sums, and a place in a goal.
        const BYTES: usize = 160;
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(Message::error("The tolerance is not a number of at least 0"));
        }
        let mut places = Places { tolerance: tolerance.max(SHORTEST), cells: HashMap::new() };
        let mut system = Self {
            points: Vec::new(),
            speeds: Vec::new(),
            goals: Vec::new(),
            particles: Vec::new(),
            pulls: Vec::new(),
            held: Vec::new(),
            sums: Vec::new(),
            freed: Vec::new(),
            at: Vec::new(),
            steps: 0,
            order: Vec::new(),
        };
        for &p in first.iter().filter(|p| p.is_finite()) {
            let i = system.points.len();
            if places.find(p, &system.points).is_none() {
                places.add(p, i);
            }
            system.points.push(p);
        }
        let mut strangers = 0_usize;
        for item in items {
            let keeper = item.as_ref().and_then(goal_of);
            let Some(keeper) = keeper else {
                strangers += 1;
                system.order.push(None);
                continue;
            };
            let Some(goal) = keeper.as_any().downcast_ref::<Goal>() else { continue };
            context.bytes(goal.places.len().saturating_mul(BYTES))?;
            let from = system.particles.len();
            for place in &goal.places {
                let particle = match *place {
                    Place::Number(n) => n,
                    Place::At(p) => places.find(p, &system.points).unwrap_or_else(|| {
                        let i = system.points.len();
                        places.add(p, i);
                        system.points.push(p);
                        i
                    }),
                };
                system.particles.push(particle);
            }
            system.order.push(Some(system.goals.len()));
            let memory = goal.rule.memory();
            system.goals.push(Bound { keeper: keeper.clone(), from, to: system.particles.len(), memory });
        }
        if strangers > 0 && !items.is_empty() {
            context.warn(format!("{strangers} items are no goals, and were passed over"));
        }
        let count = system.points.len();
        if let Some(lost) = system.particles.iter().find(|&&i| i >= count) {
            return Err(Message::error(format!("A goal asks for particle {lost}, of {count}")));
        }
        for goal in &mut system.goals {
            let everywhere = goal.keeper.as_any().downcast_ref::<Goal>().is_some_and(|goal| goal.everywhere);
            if everywhere {
                context.bytes(count.saturating_mul(BYTES))?;
                goal.from = system.particles.len();
                system.particles.extend(0..count);
                goal.to = system.particles.len();
            }
        }
        system.speeds = vec![Vector3::ZERO; count];
        system.sums = vec![(Vector3::ZERO, 0.0); count];
        system.freed = vec![false; count];
        system.pulls = vec![Pull::NONE; system.particles.len()];
        system.held = vec![false; system.particles.len()];
        Ok(system)
    }

    /// Has goal `k` work on that particle, in place of those that it worked on.
    pub(super) fn bind(&mut self, k: usize, particle: usize) {
        let (from, to) = (self.particles.len(), self.particles.len() + 1);
        let Some(goal) = self.goals.get_mut(k).filter(|_| particle < self.points.len()) else { return };
        (goal.from, goal.to) = (from, to);
        self.particles.push(particle);
        self.pulls.push(Pull::NONE);
    }

    /// Takes the particles to where those of another system are, and has hands hold the ones that they hold there; its goals
    /// from number `from` on are these.
    pub(super) fn hold_as(&mut self, whole: &Self, from: usize) {
        self.points.clone_from(&whole.points);
        for k in 0..self.goals.len() {
            let Some(there) = whole.goals.get(from + k).filter(|goal| goal.grab().is_some()) else {
                continue;
            };
            let held = whole.particles.get(there.from..there.to).and_then(|held| held.first().copied());
            if let Some(particle) = held {
                self.bind(k, particle);
            }
        }
    }

    /// How many pulls a step takes.
    pub(super) fn pull_count(&self) -> usize {
        self.pulls.len()
    }

    /// The number of steps that may be taken at most when nobody says how many.
    pub(super) fn most_steps(&self) -> usize {
        self.most_steps_of(1)
    }

    /// The same where each step takes all pulls so many times.
    pub(super) fn most_steps_of(&self, times: usize) -> usize {
        (MOST_PULLS / self.pulls.len().saturating_mul(times).max(1)).clamp(50, MOST_STEPS)
    }

    /// One step; gives the mean square of the moves.
    pub(super) fn step(&mut self, motion: Motion) -> f64 {
        let mut before = std::mem::take(&mut self.at);
        before.clear();
        before.extend_from_slice(&self.points);
        for (p, v) in self.points.iter_mut().zip(&self.speeds) {
            *p += *v;
        }
        self.gather();
        self.find_freed();
        let keeps = match motion {
            Motion::ToRest => 1.0,
            Motion::Inertia(share) => share,
        };
        let mut total = 0.0;
        let particles = self.points.iter_mut().zip(&mut self.speeds).zip(&before);
        for (((p, v), old), ((sum, weight), freed)) in particles.zip(self.sums.iter().zip(&self.freed)) {
            if matches!(motion, Motion::ToRest) && *freed && *v != Vector3::ZERO {
                // Its speed has carried it past where a goal stops to work, such as past contact, and nothing of that goal
                // would bring it back: the move is taken back and the speed out, as accelerated descent is restarted
                // (B. O'Donoghue and E. Candès, *Adaptive restart for accelerated gradient schemes*, 2015). It counts as a
                // move, so that what pulls where it was is seen before all is said to rest.
                total += v.length_squared();
                (*p, *v) = (*old, Vector3::ZERO);
                continue;
            }
            let pull = if *weight > 0.0 { *sum / *weight } else { Vector3::ZERO };
            *p += pull;
            *v = (*v + pull) * keeps;
            // Where a particle is pulled back it has passed the place of rest: its motion is taken out, as in dynamic
            // relaxation with kinetic damping (Barnes 1999).
            if matches!(motion, Motion::ToRest) && v.dot(pull) < 0.0 {
                *v = Vector3::ZERO;
            }
        }
        for ((p, old), v) in self.points.iter_mut().zip(&before).zip(&mut self.speeds) {
            if !p.is_finite() {
                (*p, *v) = (*old, Vector3::ZERO);
            }
            total += (*p - *old).length_squared();
        }
        self.at = before;
        self.steps += 1;
        total / self.points.len().max(1) as f64
    }

    /// One step of plain means without motion, for goals taken in turns; gives the mean square of the moves.
    pub(super) fn relax(&mut self, share: f64) -> f64 {
        self.gather();
        let mut total = 0.0;
        for (p, (sum, weight)) in self.points.iter_mut().zip(&self.sums) {
            let pull = if *weight > 0.0 { *sum / *weight * share } else { Vector3::ZERO };
            if pull.is_finite() {
                *p += pull;
                total += pull.length_squared();
            }
        }
        self.steps += 1;
        total / self.points.len().max(1) as f64
    }

    /// Adds up what the goals ask for, in their order, so that the sums do not depend on threads.
    fn gather(&mut self) {
        let mut local: Vec<Point3> = Vec::new();
        for goal in &mut self.goals {
            let Some(particles) = self.particles.get(goal.from..goal.to) else { continue };
            local.clear();
            local.extend(particles.iter().map(|&i| self.points.get(i).copied().unwrap_or(Point3::ORIGIN)));
            let Some(pulls) = self.pulls.get_mut(goal.from..goal.to) else { continue };
            pulls.fill(Pull::NONE);
            if let Some(found) = goal.keeper.as_any().downcast_ref::<Goal>() {
                found.rule.pull(&local, &mut goal.memory, self.steps, pulls);
            }
        }
        self.sums.fill((Vector3::ZERO, 0.0));
        for (&i, pull) in self.particles.iter().zip(&self.pulls) {
            let Some(sum) = self.sums.get_mut(i) else { continue };
            if pull.weight.is_finite() && pull.by.is_finite() {
                sum.0 += pull.by * pull.weight;
                sum.1 += pull.weight.abs();
            }
        }
    }

    /// Finds the particles that a goal has let go of since the step before; all of a goal whose points keep each other away.
    fn find_freed(&mut self) {
        self.freed.fill(false);
        for goal in &self.goals {
            let range = goal.from..goal.to;
            let (Some(particles), Some(pulls), Some(held)) =
                (self.particles.get(range.clone()), self.pulls.get(range.clone()), self.held.get_mut(range))
            else {
                continue;
            };
            let mut any = false;
            for ((&i, pull), held) in particles.iter().zip(pulls).zip(held) {
                let was_held = std::mem::replace(held, pull.weight != 0.0);
                if was_held && pull.weight == 0.0 {
                    any = true;
                    self.freed.get_mut(i).into_iter().for_each(|freed| *freed = true);
                }
            }
            let mutual = |goal: &Goal| goal.rule.is_mutual();
            if any && goal.keeper.as_any().downcast_ref::<Goal>().is_some_and(mutual) {
                for &i in particles {
                    self.freed.get_mut(i).into_iter().for_each(|freed| *freed = true);
                }
            }
        }
    }

    /// Lets goals give way to where their particles are; whether one did.
    pub(super) fn give_way(&mut self) -> bool {
        let mut any = false;
        let mut local: Vec<Point3> = Vec::new();
        for goal in self.goals.iter_mut().filter(|goal| !goal.memory.is_empty()) {
            let Some(particles) = self.particles.get(goal.from..goal.to) else { continue };
            local.clear();
            local.extend(particles.iter().map(|&i| self.points.get(i).copied().unwrap_or(Point3::ORIGIN)));
            if let Some(found) = goal.keeper.as_any().downcast_ref::<Goal>() {
                any |= found.rule.give_way(&local, &mut goal.memory);
            }
        }
        any
    }

    /// Steps until the mean square of a step is below `rest` and no goal gives way, at most `most` times. Gives whether it came to
    /// rest.
    ///
    /// # Errors
    /// The work shall stop.
    pub(super) fn run(
        &mut self,
        context: &Context<'_>,
        motion: Motion,
        rest: f64,
        most: usize,
    ) -> Result<bool, Message> {
        for _ in 0..most {
            context.check()?;
            let rests = self.step(motion) < rest;
            // Bodies with inertia give way wherever they swing.
            let gives_way = (rests || matches!(motion, Motion::Inertia(_))) && self.give_way();
            if rests && !gives_way {
                return Ok(true);
            }
        }
        Ok(self.goals.is_empty())
    }

    /// What item `k` of those that came in shows.
    pub(super) fn shown(&self, k: usize) -> Option<Value> {
        let goal = self.goals.get((*self.order.get(k)?)?)?;
        let particles = self.particles.get(goal.from..goal.to)?;
        let points: Vec<Point3> = particles.iter().filter_map(|&i| self.points.get(i).copied()).collect();
        goal.keeper.as_any().downcast_ref::<Goal>()?.rule.shown(&points)
    }
}
