//! A goal: some points, and a rule that says where each of them would rather be.

use std::any::Any;
use std::fmt;
use std::sync::Arc;

use katydid_component::Message;
use katydid_data::{Keeper, Token, Value};
use katydid_geometry::{Point3, Vector3};

use super::grab::Grab;

/// How far a goal would move a point, and with which weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pull {
    pub(super) by: Vector3,
    pub(super) weight: f64,
}

impl Pull {
    pub(super) const NONE: Self = Self { by: Vector3::ZERO, weight: 0.0 };

    pub(super) fn new(by: Vector3, weight: f64) -> Self {
        Self { by, weight }
    }
}

/// What a goal wants of its points.
///
/// A particle rests where the weighted moves that its goals ask for add up to nothing, so a rule whose move times its weight
/// is a force gives the equilibrium of these forces: Bouaziz and others, *Projective Dynamics* (2014); Piker, *Kangaroo*
/// (2013).
pub(super) trait Rule: fmt::Debug + Send + Sync {
    /// Writes a pull for each point; one without weight where it lets a point go. `memory` is what the rule keeps from step
    /// to step, such as a rest length that has given way; `step` counts from 0.
    fn pull(&self, points: &[Point3], memory: &mut [f64], step: usize, pulls: &mut [Pull]);

    /// What `memory` begins with.
    fn memory(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The hand that drags a particle, where the rule has one: its particle is the solver's to choose.
    fn grab(&self) -> Option<&Grab> {
        None
    }

    /// Gives way to points that are at rest, as what is plastic does; whether it did. While points move they may swing
    /// farther than they are pulled, which bends nothing for good.
    fn give_way(&self, _points: &[Point3], _memory: &mut [f64]) -> bool {
        false
    }

    /// Whether its points keep each other away, so that one that comes free has been pushed by others.
    fn is_mutual(&self) -> bool {
        false
    }

    /// What the goal shows for its points: an item of the solver's output.
    fn shown(&self, _points: &[Point3]) -> Option<Value> {
        None
    }
}

/// A point that a goal works on: given by its place, or by the number of the particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Place {
    At(Point3),
    Number(usize),
}

/// A goal on its way to a solver.
#[derive(Debug)]
pub(super) struct Goal {
    name: &'static str,
    /// Whether it works on all particles of the solver.
    pub(super) everywhere: bool,
    pub(super) places: Vec<Place>,
    pub(super) rule: Box<dyn Rule>,
}

impl Goal {
    /// A goal on points, as an item of data.
    pub(super) fn item(
        name: &'static str,
        points: Vec<Point3>,
        rule: impl Rule + 'static,
    ) -> Result<Value, Message> {
        Self::of_places(name, points.into_iter().map(Place::At).collect(), rule)
    }

    /// A goal on points that may be given by number.
    pub(super) fn of_places(
        name: &'static str,
        places: Vec<Place>,
        rule: impl Rule + 'static,
    ) -> Result<Value, Message> {
        let finite = |place: &Place| match place {
            Place::At(p) => p.is_finite(),
            Place::Number(_) => true,
        };
        if !places.iter().all(finite) {
            return Err(Message::error("A point is not finite"));
        }
        let goal = Arc::new(Self { name, everywhere: false, places, rule: Box::new(rule) });
        Ok(Value::from(Token(goal)))
    }

    /// A goal on all particles of the solver that it comes to.
    pub(super) fn everywhere(name: &'static str, rule: impl Rule + 'static) -> Value {
        let goal = Arc::new(Self { name, everywhere: true, places: Vec::new(), rule: Box::new(rule) });
        Value::from(Token(goal))
    }
}

impl Keeper for Goal {
    fn number(&self) -> u64 {
        0
    }

    fn is_lost(&self) -> bool {
        false
    }

    fn text(&self) -> Option<&str> {
        Some(self.name)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// Whether a strength is a number that can be worked with.
///
/// # Errors
/// It is not finite.
pub(super) fn finite(value: f64, what: &str) -> Result<f64, Message> {
    if value.is_finite() { Ok(value) } else { Err(Message::error(format!("{what} is not finite"))) }
}
