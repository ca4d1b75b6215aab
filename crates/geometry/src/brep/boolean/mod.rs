//! Solids cut solids: union, difference, intersection and all else that a general fuse gives.
//!
//! # Method
//! One fuse for any number of operands, none of which is changed. (1) Pairs of faces whose boxes meet; the points that
//! edges have in common with edges and faces go into one table of vertices. (2) Pairs of faces have section curves, exact
//! ones where both lie on planes, spheres, cylinders, cones or tori with a closed form. (3) Vertices cut edges and sections
//! into pieces; pieces upon each other are one. (4) Every face is divided by one arrangement in its parameter plane.
//! (5) Regions with one rim upon each other are one. (6) What hangs together across pieces that are not on an operand's
//! boundary lies on one side of it, which rays tell. (7) A region belongs to the result where what is asked for differs on
//! its two sides. (8) Chosen regions are sewn along their pieces, and the shells are checked.
//!
//! What lies within the tolerance by chance, such as a corner of one operand beside a seam of another, may be taken as one
//! here and as two there, and then nothing sound comes of it. The tolerance is the most that may be taken as one: where
//! decisions at it contradict each other, they are made at a finer one, unless faces are one at the tolerance alone.
//!
//! After the general fuse of Open CASCADE (*Boolean Operations*, specification) in its stages; selection by both sides of
//! a region is derived, and makes the order of operands not matter.

mod arrangement;
mod aside;
mod audit;
mod cells;
mod interferences;
mod level;
#[cfg(test)]
mod more_tests;
mod operands;
mod operations;
mod oriented;
mod pieces;
mod pulled;
mod radial;
mod refuse;
mod regions;
mod report;
mod sections;
mod shells;
mod sides;
#[cfg(test)]
mod tests;
mod thresholds;
mod vertices;

pub use crate::error::{FaceName, Refusal, RefusalClass};
pub use report::{Decision, DecisionKind};

use std::sync::OnceLock;

use crate::error::refusal;
use crate::{Brep, Curve, Error, Result, Tolerance, cancellation};
use level::{Failed, Level};
use thresholds::FINER;

/// A brep that a boolean made.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// The brep.
    pub brep: Brep,
    /// For each of its faces the face of an operand that it is a part of.
    pub names: Vec<FaceName>,
}

/// A curve on the boundaries of several operands.
#[derive(Debug, Clone, PartialEq)]
pub struct CommonCurve {
    /// The operands on whose faces or edges it lies, in order.
    pub operands: Vec<usize>,
    /// The curve, without a common point of operands between its ends.
    pub curve: Curve,
}

/// Where a part of a face lies, as far as operands tell.
#[derive(Debug, Clone, Copy)]
pub struct FacePart<'a> {
    /// For every operand whether the part belongs to its boundary.
    pub on: &'a [bool],
    /// For every closed operand whether the part lies inside.
    pub inside: &'a [bool],
}

/// Operands fused: all their faces cut along each other, ready to be asked for any combination of them.
#[derive(Debug)]
pub struct Fuse {
    level: Level,
    /// The parts of the tolerance that are left to try.
    left: &'static [f64],
    /// The distance of which `left` are parts.
    limit: f64,
    finer: OnceLock<Option<Box<Fuse>>>,
}

impl Fuse {
    /// Fuses operands. Solids may have their normals either way.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused) with the kind of case where it is not decided; an operand has no faces, or
    /// a face without a surface; the tolerance is not above 0; or the work was stopped.
    pub fn new(breps: &[Brep], tolerance: &Tolerance) -> Result<Self> {
        Self::of(&breps.iter().collect::<Vec<_>>(), tolerance)
    }

    /// As [`Fuse::new`], of operands that stand in several places.
    fn of(breps: &[&Brep], tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        Self::within(breps, limit, limit, &FINER)
    }

    /// Operands fused within a distance, or within the first of the parts `left` of the tolerance that is finer and does.
    fn within(breps: &[&Brep], distance: f64, limit: f64, left: &'static [f64]) -> Result<Self> {
        match Level::of(breps, distance) {
            Ok(level) => Ok(Self { level, left, limit, finer: OnceLock::new() }),
            Err(Failed { why, gap }) => match finer(left, limit, &why, gap) {
                // What is refused is told as it is at the tolerance of the call.
                Some((distance, left)) => {
                    Self::within(breps, distance, limit, left).map_err(|e| told(why, e))
                }
                None => Err(why),
            },
        }
    }

    /// Asks the operands fused at the tolerance, and where the answer is not sound those at finer ones.
    fn ask<T>(&self, question: &impl Fn(&Level) -> Result<T>) -> Result<T> {
        let why = match question(&self.level) {
            Err(why) => why,
            answered => return answered,
        };
        let Some((distance, left)) = finer(self.left, self.limit, &why, self.level.gap()) else {
            return Err(why);
        };
        let made = self.finer.get_or_init(|| {
            let breps: Vec<&Brep> = self.level.operands().collect();
            Self::within(&breps, distance, self.limit, left).ok().map(Box::new)
        });
        match made {
            Some(fuse) => fuse.ask(question).map_err(|e| told(why, e)),
            None => {
                cancellation::check_now()?;
                Err(why)
            }
        }
    }

    /// What was asked last: the finest that was needed.
    fn last(&self) -> &Level {
        match self.finer.get() {
            Some(Some(fuse)) => fuse.last(),
            _ => &self.level,
        }
    }

    /// The solids of all points for which `wanted` says yes: it is asked with, for every operand, whether a point lies
    /// inside. It must say no where all are outside.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): an operand is not closed, or the parts do not make sound solids.
    pub fn solids(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
        self.ask(&|level| level.solids(&wanted))
    }

    /// As [`Fuse::solids`] where operands may be open: an open one is taken to fill what lies behind it, on the side away
    /// from its normals, where others meet it, and nothing else. The results may be open: at borders of open operands only.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): an open operand ends inside another one, so that it does not divide it,
    /// or as for [`Fuse::solids`].
    pub fn oriented(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
        self.ask(&|level| level.oriented(&wanted))
    }

    /// The faces of one operand that lie in none of the others, apart where they are cut. What an open one has behind it
    /// is as in [`Fuse::oriented`].
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn outside_of_others(&self, operand: usize) -> Result<Vec<Made>> {
        self.ask(&|level| level.outside_of_others(operand))
    }

    /// The curves in which the boundaries of operands meet: where faces cross or touch, and the edges of one that lie on
    /// another.
    pub fn curves(&self) -> Vec<CommonCurve> {
        self.last().curves()
    }

    /// The parts of faces for which `wanted` says yes, each asked once though it may lie on several operands; those that
    /// share an edge hang together.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn faces(&self, wanted: impl FnMut(FacePart<'_>) -> bool) -> Result<Vec<Made>> {
        self.last().faces(wanted)
    }

    /// The cells into which the operands divide space, but for the outside of all: for each the operands in which it lies,
    /// and its solids.
    ///
    /// # Errors
    /// As [`Fuse::solids`].
    pub fn cells(&self) -> Result<Vec<(Vec<bool>, Vec<Made>)>> {
        self.ask(&Level::cells)
    }

    /// The bounded parts of space between all faces of all operands, open ones among them: for each the closed operands
    /// in which it lies. What hangs in a part without dividing it is left out.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts do not make sound solids.
    pub fn volumes(&self) -> Result<Vec<(Vec<bool>, Made)>> {
        self.ask(&Level::volumes)
    }

    /// The faces of one operand, cut where the others meet it: for each connected part the closed operands in which it
    /// lies.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn faces_of(&self, operand: usize) -> Result<Vec<(Vec<bool>, Made)>> {
        self.ask(&|level| level.faces_of(operand))
    }

    /// What was decided within the tolerance, and how far it moved what: two points, curves or surfaces that are not one
    /// to rounding were taken as one, or a part nearer to a boundary was told to lie on one side of it.
    pub fn report(&self) -> Vec<Decision> {
        self.last().report()
    }
}

/// The next finer distance for what was refused, and the parts left after it. Faces that are one within the tolerance, and
/// would not be within all of `left`, stay one: taken apart they would leave slivers between them.
fn finer(left: &'static [f64], limit: f64, why: &Error, gap: f64) -> Option<(f64, &'static [f64])> {
    let (next, rest) = left.split_first()?;
    let finest = left.last().map_or(0.0, |share| share * limit);
    let Error::Refused(refusal) = why else { return None };
    (refusal.class.may_be_chance() && gap <= 0.5 * finest).then_some((next * limit, rest))
}

/// What is told of a question that was refused at the tolerance and then at a finer one.
fn told(at_tolerance: Error, at_finer: Error) -> Error {
    if at_finer == Error::Stopped { at_finer } else { at_tolerance }
}
