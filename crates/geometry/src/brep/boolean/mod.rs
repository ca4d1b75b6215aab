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
//! After the general fuse of Open CASCADE (*Boolean Operations*, specification) in its stages; selection by both sides of
//! a region is derived, and makes the order of operands not matter.

mod arrangement;
mod cells;
mod interferences;
mod operands;
mod pieces;
mod refusal;
mod regions;
mod sections;
mod shells;
#[cfg(test)]
mod tests;
mod thresholds;
mod vertices;

pub use refusal::{Refusal, RefusalClass};

use crate::{Brep, Result, Tolerance, patience};
use cells::Sheet;
use operands::Operands;
use pieces::Pieces;
use regions::Region;
use shells::{Chosen, Shells};

/// A face of an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FaceName {
    /// The operand's place among all of the call.
    pub operand: usize,
    /// The face's place in the operand.
    pub face: usize,
}

/// A brep that a boolean made.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// The brep.
    pub brep: Brep,
    /// For each of its faces the face of an operand that it is a part of.
    pub names: Vec<FaceName>,
}

/// Operands fused: all their faces cut along each other, ready to be asked for any combination of them.
#[derive(Debug)]
pub struct Fuse {
    all: Operands,
    pieces: Pieces,
    regions: Vec<Region>,
    sheets: Vec<Sheet>,
}

impl Fuse {
    /// Fuses operands. Solids may have their normals either way.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused) with the kind of case where it is not decided; an operand has no faces, or
    /// a face without a surface; the tolerance is not above 0; or the work was stopped.
    pub fn new(breps: &[Brep], tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        let mut all = Operands::new(breps, limit)?;
        let pairs = interferences::face_pairs(&all)?;
        interferences::meet_edges(&mut all, &pairs)?;
        let found = sections::sections(&mut all, &pairs)?;
        let found = sections::pieces(&mut all, found)?;
        let pieces = Pieces::new(&all, found, &pairs)?;
        let regions = regions::all_regions(&all, &pieces)?;
        patience::check_now()?;
        let sheets = cells::sheets(&all, &pieces, &regions)?;
        Ok(Self { all, pieces, regions, sheets })
    }

    /// The solids of all points for which `wanted` says yes: it is asked with, for every operand, whether a point lies
    /// inside. It must say no where all are outside.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): an operand is not closed, or the parts do not make sound solids.
    pub fn solids(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
        if let Some(open) = self.all.solids.iter().position(|s| !s.closed) {
            let name = FaceName { operand: open, face: 0 };
            return Err(Refusal::at(RefusalClass::OpenOperand, &[name], None));
        }
        let mut chosen = Vec::new();
        for sheet in &self.sheets {
            match (wanted(&sheet.sides.behind), wanted(&sheet.sides.before)) {
                (true, false) => chosen.push(Chosen { region: sheet.region, flipped: false }),
                (false, true) => chosen.push(Chosen { region: sheet.region, flipped: true }),
                _ => {}
            }
        }
        if chosen.is_empty() {
            return Ok(Vec::new());
        }
        self.shells(&chosen).solids()
    }

    /// The cells into which the operands divide space, but for the outside of all: for each the operands in which it lies,
    /// and its solids.
    ///
    /// # Errors
    /// As [`Fuse::solids`].
    pub fn cells(&self) -> Result<Vec<(Vec<bool>, Vec<Made>)>> {
        let mut kinds: Vec<&Vec<bool>> = Vec::new();
        for sheet in &self.sheets {
            for side in [&sheet.sides.behind, &sheet.sides.before] {
                if side.iter().any(|x| *x) && !kinds.contains(&side) {
                    kinds.push(side);
                }
            }
        }
        kinds.into_iter().map(|kind| Ok((kind.clone(), self.solids(|inside| inside == kind)?))).collect()
    }

    /// The bounded parts of space between all faces of all operands, open ones among them: for each the closed operands
    /// in which it lies. What hangs in a part without dividing it is left out.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts do not make sound solids.
    pub fn volumes(&self) -> Result<Vec<(Vec<bool>, Made)>> {
        let two = |s: &Sheet| [false, true].map(|flipped| Chosen { region: s.region, flipped });
        let chosen: Vec<Chosen> = self.sheets.iter().flat_map(two).collect();
        let found = self.shells(&chosen).volumes()?;
        let inside = |place: usize| {
            let sides = self.sheets.get(place / 2).map(|s| &s.sides);
            sides.map_or_else(Vec::new, |s| {
                if place.is_multiple_of(2) { s.behind.clone() } else { s.before.clone() }
            })
        };
        Ok(found.into_iter().map(|(place, made)| (inside(place), made)).collect())
    }

    /// The faces of one operand, cut where the others meet it: for each connected part the closed operands in which it
    /// lies.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn faces_of(&self, operand: usize) -> Result<Vec<(Vec<bool>, Made)>> {
        let owner = |r: &Region| self.all.faces.get(r.face).map(|f| f.solid);
        let chosen: Vec<Chosen> = (self.regions.iter().enumerate())
            .filter(|(_, r)| owner(r) == Some(operand))
            .map(|(region, _)| Chosen { region, flipped: false })
            .collect();
        let cut = |piece: usize| {
            self.pieces.list.get(piece).is_some_and(|p| p.solids.iter().any(|s| *s != operand))
        };
        let found = self.shells(&chosen).faces(cut)?;
        let inside = |place: usize| {
            let region = chosen.get(place).map(|c| c.region);
            let sheet = self.sheets.iter().find(|s| Some(s.region) == region);
            sheet.map_or_else(Vec::new, |s| s.sides.before.clone())
        };
        Ok(found.into_iter().map(|(place, made)| (inside(place), made)).collect())
    }

    fn shells<'a>(&'a self, chosen: &'a [Chosen]) -> Shells<'a> {
        Shells { all: &self.all, pieces: &self.pieces, regions: &self.regions, chosen }
    }
}

impl Brep {
    /// The solids that some solids fill together. What does not meet stays apart; an empty list gives nothing.
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::solids`].
    pub fn union(solids: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        if solids.is_empty() {
            return Ok(Vec::new());
        }
        Fuse::new(solids, tolerance)?.solids(|inside| inside.iter().any(|x| *x))
    }

    /// What is left of some solids outside of all tools.
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::solids`].
    pub fn difference(solids: &[Self], tools: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        Self::two_sided(solids, tools, tolerance, |a, b| a && !b)
    }

    /// What lies in one of the first solids and in one of the others.
    ///
    /// # Errors
    /// As [`Fuse::new`] and [`Fuse::solids`].
    pub fn intersection(solids: &[Self], others: &[Self], tolerance: &Tolerance) -> Result<Vec<Made>> {
        Self::two_sided(solids, others, tolerance, |a, b| a && b)
    }

    fn two_sided(
        first: &[Self],
        second: &[Self],
        tolerance: &Tolerance,
        wanted: impl Fn(bool, bool) -> bool,
    ) -> Result<Vec<Made>> {
        if first.is_empty() {
            return Ok(Vec::new());
        }
        let all: Vec<Self> = first.iter().chain(second).cloned().collect();
        let split = first.len();
        let any = |inside: Option<&[bool]>| inside.is_some_and(|i| i.iter().any(|x| *x));
        Fuse::new(&all, tolerance)?.solids(|i| wanted(any(i.get(..split)), any(i.get(split..))))
    }
}
