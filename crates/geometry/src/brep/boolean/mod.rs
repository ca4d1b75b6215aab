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
mod aside;
mod audit;
mod cells;
mod interferences;
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

use std::collections::{BTreeMap, BTreeSet};

use crate::error::refusal;
use crate::{Brep, Curve, Result, Tolerance, cancellation};
use cells::{Beside, Sheet};
use operands::Operands;
use pieces::Pieces;
use regions::Region;
use shells::{Chosen, Shells};
use sides::{Inside, Sides};

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
    all: Operands,
    pieces: Pieces,
    regions: Vec<Region>,
    sheets: Vec<Sheet>,
    beside: Vec<Beside>,
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
        let mut all = Operands::new(breps, limit)?;
        let pairs = interferences::face_pairs(&all)?;
        interferences::meet_edges(&mut all, &pairs)?;
        let found = sections::sections(&mut all, &pairs)?;
        let found = sections::pieces(&mut all, found)?;
        let mut pieces = Pieces::new(&all, found, &pairs)?;
        let regions::Cut { mut regions, idle } = regions::all_regions(&all, &pieces)?;
        cancellation::check_now()?;
        let (sheets, beside) = cells::sheets(&all, &pieces, &regions, &idle)?;
        // No face or region is asked any more whether it covers a place: of many operands that is as much as the results.
        all.faces.iter_mut().for_each(operands::Face::forget_outlines);
        regions.iter_mut().for_each(Region::forget_outlines);
        pieces.forget_ends();
        Ok(Self { all, pieces, regions, sheets, beside })
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
        let chosen: Vec<Chosen> = self.sheets.iter().filter_map(|s| self.chosen(s, &wanted)).collect();
        if chosen.is_empty() {
            return Ok(Vec::new());
        }
        self.shells(&chosen).solids()
    }

    /// As [`Fuse::solids`] where operands may be open: an open one is taken to fill what lies behind it, on the side away
    /// from its normals, where others meet it, and nothing else. The results may be open: at borders of open operands only.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): an open operand ends inside another one, so that it does not divide it,
    /// or as for [`Fuse::solids`].
    pub fn oriented(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
        if self.all.solids.iter().all(|s| s.closed) {
            return self.solids(wanted);
        }
        let sheets = self.with_open()?;
        let chosen: Vec<Chosen> = sheets.iter().filter_map(|s| self.chosen(s, &wanted)).collect();
        let naked = self.naked_pieces();
        self.shells(&chosen).open_or_closed(|piece| naked.contains(&piece))
    }

    /// A sheet as a part of the boundary of what is wanted, if what is wanted differs on its two sides.
    fn chosen(&self, sheet: &Sheet, wanted: impl Fn(&[bool]) -> bool) -> Option<Chosen> {
        let Sides { behind, before } = &sheet.sides;
        match (wanted(&self.dense(behind)), wanted(&self.dense(before))) {
            (true, false) => Some(Chosen { region: sheet.region, flipped: false }),
            (false, true) => Some(Chosen { region: sheet.region, flipped: true }),
            _ => None,
        }
    }

    /// For every operand whether it holds a place.
    fn dense(&self, inside: &Inside) -> Vec<bool> {
        inside.of_all(self.all.solids.len())
    }

    /// The faces of one operand that lie in none of the others, apart where they are cut. What an open one has behind it
    /// is as in [`Fuse::oriented`].
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn outside_of_others(&self, operand: usize) -> Result<Vec<Made>> {
        let sheets = self.with_open()?;
        let chosen: Vec<Chosen> = (self.regions.iter().enumerate())
            .filter(|(_, r)| self.all.faces.get(r.face).map(|f| f.solid) == Some(operand))
            .filter(|(region, _)| {
                let own = sheets.iter().find(|s| s.region == *region);
                let inside =
                    |k: usize, s: &Sheet| k != operand && s.sides.behind.has(k) && s.sides.before.has(k);
                // A region that lies upon another operand's is outside of it.
                own.is_none_or(|s| !(0..self.all.solids.len()).any(|k| inside(k, s)))
            })
            .map(|(region, _)| Chosen { region, flipped: false })
            .collect();
        let found = self.shells(&chosen).faces(self.cut_at(operand))?;
        Ok(found.into_iter().map(|(_, made)| made).collect())
    }

    fn with_open(&self) -> Result<Vec<Sheet>> {
        let every = oriented::every(&self.sheets);
        oriented::with_open(&self.shells(&every), &self.sheets)
    }

    /// The pieces of edges that one face of an open operand has alone.
    fn naked_pieces(&self) -> BTreeSet<usize> {
        let mut uses: BTreeMap<usize, usize> = BTreeMap::new();
        let open = |solid: usize| self.all.solids.get(solid).is_some_and(|s| !s.closed);
        for face in self.all.faces.iter().filter(|f| open(f.solid)) {
            for (edge, _) in face.loops.iter().flatten().filter_map(|bound| bound.edge) {
                *uses.entry(edge).or_default() += 1;
            }
        }
        let alone = uses.into_iter().filter(|(_, count)| *count == 1);
        alone.filter_map(|(edge, _)| self.pieces.of_edge.get(edge)).flatten().map(|p| p.piece).collect()
    }

    /// Whether faces of an operand are cut along a piece.
    fn cut_at(&self, operand: usize) -> impl Fn(usize) -> bool {
        move |piece| self.pieces.list.get(piece).is_some_and(|p| p.solids.iter().any(|s| *s != operand))
    }

    /// The curves in which the boundaries of operands meet: where faces cross or touch, and the edges of one that lie on
    /// another.
    pub fn curves(&self) -> Vec<CommonCurve> {
        let common = self.pieces.list.iter().filter(|p| p.solids.len() > 1);
        common
            .map(|p| CommonCurve { operands: p.solids.iter().copied().collect(), curve: p.curve.clone() })
            .collect()
    }

    /// The parts of faces for which `wanted` says yes, each asked once though it may lie on several operands; those that
    /// share an edge hang together.
    ///
    /// # Errors
    /// [`Error::Refused`](crate::Error::Refused): the parts are not sound.
    pub fn faces(&self, mut wanted: impl FnMut(FacePart<'_>) -> bool) -> Result<Vec<Made>> {
        let mut chosen = Vec::new();
        for sheet in &self.sheets {
            let [behind, before] = [&sheet.sides.behind, &sheet.sides.before].map(|s| self.dense(s));
            let both = || behind.iter().zip(&before);
            let on: Vec<bool> = both().map(|(a, b)| a != b).collect();
            let inside: Vec<bool> = both().map(|(a, b)| *a && *b).collect();
            if wanted(FacePart { on: &on, inside: &inside }) {
                chosen.push(Chosen { region: sheet.region, flipped: false });
            }
        }
        let found = self.shells(&chosen).faces(|_| false)?;
        Ok(found.into_iter().map(|(_, made)| made).collect())
    }

    /// The cells into which the operands divide space, but for the outside of all: for each the operands in which it lies,
    /// and its solids.
    ///
    /// # Errors
    /// As [`Fuse::solids`].
    pub fn cells(&self) -> Result<Vec<(Vec<bool>, Vec<Made>)>> {
        let mut kinds: Vec<&Inside> = Vec::new();
        for sheet in &self.sheets {
            for side in [&sheet.sides.behind, &sheet.sides.before] {
                if !side.is_empty() && !kinds.contains(&side) {
                    kinds.push(side);
                }
            }
        }
        let kinds = kinds.into_iter().map(|kind| self.dense(kind));
        kinds.map(|kind| Ok((kind.clone(), self.solids(|inside| inside == kind)?))).collect()
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
                self.dense(if place.is_multiple_of(2) { &s.behind } else { &s.before })
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
        let found = self.shells(&chosen).faces(self.cut_at(operand))?;
        let inside = |place: usize| {
            let region = chosen.get(place).map(|c| c.region);
            let sheet = self.sheets.iter().find(|s| Some(s.region) == region);
            sheet.map_or_else(Vec::new, |s| self.dense(&s.sides.before))
        };
        Ok(found.into_iter().map(|(place, made)| (inside(place), made)).collect())
    }

    /// What was decided within the tolerance, and how far it moved what: two points, curves or surfaces that are not one
    /// to rounding were taken as one, or a part nearer to a boundary was told to lie on one side of it.
    pub fn report(&self) -> Vec<Decision> {
        report::decisions(&self.all, &self.pieces, &self.beside)
    }

    fn shells<'a>(&'a self, chosen: &'a [Chosen]) -> Shells<'a> {
        Shells { all: &self.all, pieces: &self.pieces, regions: &self.regions, chosen }
    }
}
