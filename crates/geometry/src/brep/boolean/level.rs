//! Operands fused at one tolerance, and what is asked of them.

use std::collections::{BTreeMap, BTreeSet};

use super::audit;
use super::cells::{self, Beside, Sheet};
use super::operands::{self, Operands};
use super::pieces::Pieces;
use super::regions::{self, Region};
use super::report::{self, Decision};
use super::shells::{Chosen, Shells};
use super::sides::{Inside, Sides};
use super::{CommonCurve, FaceName, FacePart, Made, Refusal, RefusalClass};
use super::{interferences, oriented, sections};
use crate::{Brep, Error, Result, cancellation};

/// Operands fused at one tolerance: all their faces cut along each other.
#[derive(Debug)]
pub(super) struct Level {
    pub(super) all: Operands,
    pieces: Pieces,
    regions: Vec<Region>,
    sheets: Vec<Sheet>,
    beside: Vec<Beside>,
}

/// Faces cut along each other.
struct Divided {
    pieces: Pieces,
    regions: Vec<Region>,
    sheets: Vec<Sheet>,
    beside: Vec<Beside>,
}

/// Why operands were not fused at a tolerance.
pub(super) struct Failed {
    pub(super) why: Error,
    /// As [`Level::gap`].
    pub(super) gap: f64,
}

impl From<Error> for Failed {
    fn from(why: Error) -> Self {
        Self { why, gap: 0.0 }
    }
}

impl Level {
    /// Fuses operands; points, curves and surfaces within `limit` of each other are one.
    pub(super) fn of(breps: &[&Brep], limit: f64) -> std::result::Result<Self, Failed> {
        let mut all = Operands::new(breps, limit)?;
        let divided = Self::divided(&mut all);
        let gap = gap(&all);
        let Divided { pieces, regions, sheets, beside } = divided.map_err(|why| Failed { why, gap })?;
        Ok(Self { all, pieces, regions, sheets, beside })
    }

    fn divided(all: &mut Operands) -> Result<Divided> {
        let pairs = interferences::face_pairs(all)?;
        interferences::meet_edges(all, &pairs)?;
        let found = sections::sections(all, &pairs)?;
        let found = sections::pieces(all, found)?;
        let mut pieces = Pieces::new(all, found, &pairs)?;
        let regions::Cut { mut regions, idle } = regions::all_regions(all, &pieces)?;
        cancellation::check_now()?;
        let (sheets, beside) = cells::sheets(all, &pieces, &regions, &idle)?;
        // No face or region is asked any more whether it covers a place: of many operands that is as much as the results.
        all.faces.iter_mut().for_each(operands::Face::forget_outlines);
        regions.iter_mut().for_each(Region::forget_outlines);
        pieces.forget_ends();
        Ok(Divided { pieces, regions, sheets, beside })
    }

    /// The operands, solids turned outward.
    pub(super) fn operands(&self) -> impl Iterator<Item = &Brep> {
        self.all.solids.iter().map(operands::Solid::brep)
    }

    /// The largest distance found between faces that were taken to lie on one surface.
    pub(super) fn gap(&self) -> f64 {
        gap(&self.all)
    }

    /// [`Fuse::solids`](super::Fuse::solids) at this tolerance.
    pub(super) fn solids(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
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

    /// [`Fuse::oriented`](super::Fuse::oriented) at this tolerance.
    pub(super) fn oriented(&self, wanted: impl Fn(&[bool]) -> bool) -> Result<Vec<Made>> {
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

    /// [`Fuse::outside_of_others`](super::Fuse::outside_of_others) at this tolerance.
    pub(super) fn outside_of_others(&self, operand: usize) -> Result<Vec<Made>> {
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

    /// [`Fuse::curves`](super::Fuse::curves) at this tolerance.
    pub(super) fn curves(&self) -> Vec<CommonCurve> {
        let common = self.pieces.list.iter().filter(|p| p.solids.len() > 1);
        common
            .map(|p| CommonCurve { operands: p.solids.iter().copied().collect(), curve: p.curve.clone() })
            .collect()
    }

    /// [`Fuse::faces`](super::Fuse::faces) at this tolerance.
    pub(super) fn faces(&self, mut wanted: impl FnMut(FacePart<'_>) -> bool) -> Result<Vec<Made>> {
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

    /// [`Fuse::cells`](super::Fuse::cells) at this tolerance.
    pub(super) fn cells(&self) -> Result<Vec<(Vec<bool>, Vec<Made>)>> {
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

    /// [`Fuse::volumes`](super::Fuse::volumes) at this tolerance.
    pub(super) fn volumes(&self) -> Result<Vec<(Vec<bool>, Made)>> {
        let two = |s: &Sheet| [false, true].map(|flipped| Chosen { region: s.region, flipped });
        let chosen: Vec<Chosen> = self.sheets.iter().flat_map(two).collect();
        let found = self.shells(&chosen).volumes()?;
        audit::enclosed(found.iter().map(|(_, made)| &made.brep))?;
        let inside = |place: usize| {
            let sides = self.sheets.get(place / 2).map(|s| &s.sides);
            sides.map_or_else(Vec::new, |s| {
                self.dense(if place.is_multiple_of(2) { &s.behind } else { &s.before })
            })
        };
        Ok(found.into_iter().map(|(place, made)| (inside(place), made)).collect())
    }

    /// [`Fuse::faces_of`](super::Fuse::faces_of) at this tolerance.
    pub(super) fn faces_of(&self, operand: usize) -> Result<Vec<(Vec<bool>, Made)>> {
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

    /// [`Fuse::report`](super::Fuse::report) at this tolerance.
    pub(super) fn report(&self) -> Vec<Decision> {
        report::decisions(&self.all, &self.pieces, &self.beside)
    }

    fn shells<'a>(&'a self, chosen: &'a [Chosen]) -> Shells<'a> {
        Shells { all: &self.all, pieces: &self.pieces, regions: &self.regions, chosen }
    }
}

fn gap(all: &Operands) -> f64 {
    all.upon.iter().map(|u| u.2).fold(0.0, f64::max)
}
