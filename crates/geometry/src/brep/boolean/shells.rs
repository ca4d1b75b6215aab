//! Shells of chosen regions: sewn along the pieces that they share, never by distance.

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use super::arrangement::Track;
use super::operands::Operands;
use super::pieces::Pieces;
use super::refusal::RefusalClass;
use super::regions::Region;
use super::thresholds::EDGE_OFF_FACE;
use super::{FaceName, Made};
use crate::brep::inside::ClosestOnBrep;
use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{BoundingBox, Brep, Containment, Result, cancellation};

/// A region of the result, and whether it is turned over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    pub(super) region: usize,
    pub(super) flipped: bool,
}

/// A use of a piece by a chosen region: which, the place among its steps, and whether the region runs along the piece
/// backwards as seen from before its face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Use {
    pub(super) chosen: usize,
    pub(super) step: (usize, usize),
    pub(super) backwards: bool,
}

/// Sets of chosen regions that hang together.
pub(super) struct Sets(Vec<usize>);

impl Sets {
    pub(super) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    pub(super) fn root(&mut self, mut k: usize) -> usize {
        while self.0[k] != k {
            self.0[k] = self.0[self.0[k]];
            k = self.0[k];
        }
        k
    }

    pub(super) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// The members of every set, in order.
    fn lists(&mut self) -> Vec<Vec<usize>> {
        let mut out: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for k in 0..self.0.len() {
            let root = self.root(k);
            out.entry(root).or_default().push(k);
        }
        out.into_values().collect()
    }
}

/// What shells are made of.
pub(super) struct Shells<'a> {
    pub(super) all: &'a Operands,
    pub(super) pieces: &'a Pieces,
    pub(super) regions: &'a [Region],
    pub(super) chosen: &'a [Chosen],
}

/// The edge that each step of each chosen region runs along: a piece, and which of several edges along it.
type Mates = BTreeMap<(usize, usize, usize), (usize, usize)>;

impl Shells<'_> {
    /// The solids that the chosen regions bound, with the faces that theirs came from.
    pub(super) fn solids(&self) -> Result<Vec<Made>> {
        let (mates, mut sets) = self.mated(|_| false)?;
        let shells = sets.lists();
        if let [only] = shells.as_slice() {
            let (made, inward) = self.built(only, &mates)?;
            if inward || !made.brep.is_solid() {
                return Err(self.refuse(RefusalClass::Unclosed, only.first().copied()));
            }
            return Ok(vec![made]);
        }
        let solids = self.nested(shells, &mates, false)?;
        Ok(solids.into_iter().map(|s| s.1).collect())
    }

    /// What the chosen regions bound, and what stays open: a piece may be the edge of one region alone where it may be
    /// `naked`.
    pub(super) fn open_or_closed(&self, naked: impl Fn(usize) -> bool) -> Result<Vec<Made>> {
        let (mates, mut sets) = self.mated(naked)?;
        let shells = sets.lists();
        let mut out = Vec::with_capacity(shells.len());
        let mut closed = Vec::new();
        for shell in shells {
            cancellation::check()?;
            let (made, _) = self.built(&shell, &mates)?;
            if made.brep.is_solid() { closed.push(shell) } else { out.push(made) }
        }
        out.extend(self.nested(closed, &mates, false)?.into_iter().map(|s| s.1));
        Ok(out)
    }

    /// The bounded cells between the chosen regions, of which each stands for both of its sides in turn: what is behind it,
    /// then, turned over, what is before it. For each the place of one of its chosen regions.
    pub(super) fn volumes(&self) -> Result<Vec<(usize, Made)>> {
        let mut kept: Vec<bool> = vec![true; self.chosen.len() / 2];
        loop {
            let mut sets = Sets::new(self.chosen.len());
            let mut mates = Mates::new();
            for (piece, list) in self.uses() {
                cancellation::check()?;
                // The uses of regions that are not turned, each of which stands for both sides.
                let list: Vec<Use> = list
                    .into_iter()
                    .filter(|u| u.chosen % 2 == 0 && kept.get(u.chosen / 2) == Some(&true))
                    .collect();
                let order = if list.len() > 2 { self.radial(piece, &list)? } else { list };
                let next = order.iter().cycle().skip(1);
                for (k, (a, b)) in order.iter().zip(next).enumerate() {
                    // The side of the first that looks to larger angles, and that of the second to smaller ones.
                    let sides = [a.chosen + usize::from(!a.backwards), b.chosen + usize::from(b.backwards)];
                    for (own, side) in [a, b].into_iter().zip(sides) {
                        mates.insert((side, own.step.0, own.step.1), (piece, k));
                    }
                    sets.join(sides[0], sides[1]);
                }
            }
            let dangling: Vec<usize> =
                (0..kept.len()).filter(|k| kept[*k] && sets.root(2 * k) == sets.root(2 * k + 1)).collect();
            if dangling.is_empty() {
                let shells = sets.lists().into_iter().filter(|s| s.first().is_some_and(|f| kept[f / 2]));
                let found = self.nested(shells.collect(), &mates, true)?;
                let dividing = (0..kept.len()).filter(|k| kept[*k]).map(|k| 2 * k);
                self.refuse_divided(&found, dividing)?;
                return Ok(found);
            }
            dangling.into_iter().for_each(|k| kept[k] = false);
        }
    }

    /// Refuses cells in whose inside a region lies that divides space: where one was not cut as it should have been, cells
    /// lie in each other, and their volumes do not show it.
    fn refuse_divided(
        &self,
        cells: &[(usize, Made)],
        regions: impl Iterator<Item = usize> + Clone,
    ) -> Result<()> {
        for (_, made) in cells {
            cancellation::check()?;
            let Some(bounds) = made.brep.bounds_of_faces() else { continue };
            let search = ClosestOnBrep::new(Shared::new(made.brep.clone()))?;
            for chosen in regions.clone() {
                let sample = self.region(chosen).and_then(|r| r.samples.first());
                let Some(p) = sample.map(|s| s.point).filter(|p| bounds.distance_to(*p) <= 0.0) else {
                    continue;
                };
                match search.contains(p, self.all.limit) {
                    Ok(Containment::Inside) => return Err(self.refuse(RefusalClass::Unsound, Some(chosen))),
                    Err(crate::Error::Stopped) => return Err(crate::Error::Stopped),
                    // What is not decided is no reason to refuse.
                    Ok(_) | Err(_) => {}
                }
            }
        }
        Ok(())
    }

    /// The faces that the chosen regions make, open or not, apart where they are cut.
    pub(super) fn faces(&self, cut: impl Fn(usize) -> bool) -> Result<Vec<(usize, Made)>> {
        let (mates, mut sets) = self.joined(cut);
        let lists = sets.lists().into_iter();
        lists.map(|shell| Ok((shell.first().copied().unwrap_or(0), self.built(&shell, &mates)?.0))).collect()
    }

    /// Closed shells as solids with their cavities. What looks inward and lies in no solid is refused, or, where shells
    /// are all sides of space, the outside.
    fn nested(&self, shells: Vec<Vec<usize>>, mates: &Mates, outside: bool) -> Result<Vec<(usize, Made)>> {
        let mut outer: Vec<(Vec<usize>, Made, f64)> = Vec::new();
        let mut cavities: Vec<Vec<usize>> = Vec::new();
        for shell in shells {
            cancellation::check()?;
            let (made, inward) = self.built(&shell, mates)?;
            if !made.brep.is_solid() {
                return Err(self.refuse(RefusalClass::Unclosed, shell.first().copied()));
            }
            if inward {
                cavities.push(shell);
            } else {
                let size = made.brep.bounds_of_faces().map_or(0.0, |b| b.diagonal().length());
                outer.push((shell, made, size));
            }
        }
        self.place_cavities(outer, cavities, mates, outside)
    }

    /// Every cavity becomes a shell of the smallest solid around it.
    fn place_cavities(
        &self,
        outer: Vec<(Vec<usize>, Made, f64)>,
        cavities: Vec<Vec<usize>>,
        mates: &Mates,
        outside: bool,
    ) -> Result<Vec<(usize, Made)>> {
        let mut inner: Vec<Vec<usize>> = vec![Vec::new(); outer.len()];
        for cavity in cavities {
            let first = cavity.first().copied();
            let mut best: Option<(f64, usize)> = None;
            for (k, (_, made, size)) in outer.iter().enumerate() {
                if best.is_some_and(|b| *size >= b.0) {
                    continue;
                }
                match self.holds(&made.brep, &cavity)? {
                    Some(true) => best = Some((*size, k)),
                    Some(false) => {}
                    // The whole boundary of a solid, seen from the outside.
                    None if outside => {}
                    None => return Err(self.refuse(RefusalClass::UndecidedPoint, first)),
                }
            }
            match best.and_then(|b| inner.get_mut(b.1)) {
                Some(own) => own.extend(cavity),
                None if outside => {}
                None => return Err(self.refuse(RefusalClass::Unclosed, first)),
            }
        }
        let mut out = Vec::with_capacity(outer.len());
        for ((mut shell, made, _), inner) in outer.into_iter().zip(inner) {
            let first = shell.first().copied().unwrap_or(0);
            if inner.is_empty() {
                out.push((first, made));
                continue;
            }
            shell.extend(inner);
            let (made, inward) = self.built(&shell, mates)?;
            if inward || !made.brep.is_solid() {
                return Err(self.refuse(RefusalClass::Unclosed, shell.first().copied()));
            }
            out.push((first, made));
        }
        Ok(out)
    }

    /// Whether a solid holds a shell: a point of it that is not on the solid's boundary tells; none where all are on it.
    fn holds(&self, solid: &Brep, shell: &[usize]) -> Result<Option<bool>> {
        // What reaches out of the box around a solid is not in it.
        let Some(bounds) = solid.bounds_of_faces().map(|b| b.inflated(self.all.limit)) else {
            return Ok(Some(false));
        };
        let within = |b: &BoundingBox| bounds.union(b) == bounds;
        let rims = shell.iter().filter_map(|c| self.region(*c)).flat_map(Region::pieces);
        if rims.filter_map(|(piece, _)| self.pieces.list.get(piece)).any(|p| !within(&p.bounds)) {
            return Ok(Some(false));
        }
        let search = ClosestOnBrep::new(Shared::new(solid.clone()))?;
        let mut unknown = false;
        for sample in shell.iter().filter_map(|c| self.region(*c)).flat_map(|r| &r.samples) {
            match search.contains(sample.point, self.all.limit) {
                Ok(Containment::Inside) => return Ok(Some(true)),
                Ok(Containment::Outside) => return Ok(Some(false)),
                Err(crate::Error::Stopped) => return Err(crate::Error::Stopped),
                Ok(Containment::On) => {}
                Err(_) => unknown = true,
            }
        }
        if unknown {
            return Err(self.refuse(RefusalClass::UndecidedPoint, shell.first().copied()));
        }
        Ok(None)
    }

    pub(super) fn region(&self, chosen: usize) -> Option<&Region> {
        self.regions.get(self.chosen.get(chosen)?.region)
    }

    fn refuse(&self, class: RefusalClass, chosen: Option<usize>) -> crate::Error {
        let region = chosen.and_then(|c| self.region(c));
        let place = region.and_then(|r| r.samples.first()).map(|s| s.point);
        let face: Vec<usize> = region.map(|r| r.face).into_iter().collect();
        self.all.refuse(class, &face, place)
    }

    /// The uses of every piece.
    pub(super) fn uses(&self) -> BTreeMap<usize, Vec<Use>> {
        let mut uses: BTreeMap<usize, Vec<Use>> = BTreeMap::new();
        for (place, chosen) in self.chosen.iter().enumerate() {
            let Some(region) = self.regions.get(chosen.region) else { continue };
            let turned = self.all.faces.get(region.face).is_some_and(|f| f.reversed) != chosen.flipped;
            for (l, chain) in region.loops.iter().enumerate() {
                for (s, step) in chain.iter().enumerate() {
                    if let Track::Piece(piece, reversed) = step.track {
                        let backwards = reversed != turned;
                        uses.entry(piece).or_default().push(Use { chosen: place, step: (l, s), backwards });
                    }
                }
            }
        }
        uses
    }

    /// Which uses of pieces share an edge, and which regions hang together: by pairs with material between them. A piece
    /// may have one region alone where it may be `naked`.
    fn mated(&self, naked: impl Fn(usize) -> bool) -> Result<(Mates, Sets)> {
        let mut sets = Sets::new(self.chosen.len());
        let mut mates = Mates::new();
        for (piece, list) in self.uses() {
            cancellation::check()?;
            let pairs = match list.as_slice() {
                [a, b] if a.backwards != b.backwards => vec![[*a, *b]],
                [_] if naked(piece) => continue,
                [] | [_] | [_, _] => return Err(self.refuse_at(piece, &list)),
                _ => self.wedges(piece, &list)?,
            };
            for (k, pair) in pairs.iter().enumerate() {
                for own in pair {
                    mates.insert((own.chosen, own.step.0, own.step.1), (piece, k));
                }
                sets.join(pair[0].chosen, pair[1].chosen);
            }
        }
        Ok((mates, sets))
    }

    /// As [`Self::mated`] for faces that need not close: faces at a piece hang together unless it is where they are cut.
    fn joined(&self, cut: impl Fn(usize) -> bool) -> (Mates, Sets) {
        let mut sets = Sets::new(self.chosen.len());
        let mut mates = Mates::new();
        for (piece, list) in self.uses() {
            let Some(first) = list.first() else { continue };
            let apart = cut(piece);
            // The seam of a face is one edge, whatever cuts it.
            for (k, own) in list.iter().enumerate() {
                let edge =
                    if apart { list.iter().position(|u| u.chosen == own.chosen).unwrap_or(k) } else { 0 };
                mates.insert((own.chosen, own.step.0, own.step.1), (piece, edge));
                if !apart {
                    sets.join(first.chosen, own.chosen);
                }
            }
        }
        (mates, sets)
    }

    pub(super) fn refuse_at(&self, piece: usize, uses: &[Use]) -> crate::Error {
        let faces: Vec<usize> = uses.iter().filter_map(|u| self.region(u.chosen)).map(|r| r.face).collect();
        self.all.refuse(RefusalClass::Unclosed, &faces, self.pieces.middle(piece))
    }

    /// More than two faces at a piece, in pairs with material between them: wedges of material go from a backward to a
    /// forward face.
    fn wedges(&self, piece: usize, uses: &[Use]) -> Result<Vec<[Use; 2]>> {
        let refused = || self.refuse_at(piece, uses);
        if uses.len() % 2 == 1 {
            return Err(refused());
        }
        let mut order = self.radial(piece, uses)?;
        let start = order.iter().position(|u| u.backwards).ok_or_else(refused)?;
        order.rotate_left(start);
        let mut out = Vec::with_capacity(order.len() / 2);
        for pair in order.chunks_exact(2) {
            let [a, b] = [pair[0], pair[1]];
            if !a.backwards || b.backwards {
                return Err(refused());
            }
            out.push([a, b]);
        }
        Ok(out)
    }

    /// The materials and colours of the faces that a brep's faces are parts of.
    fn with_colours(&self, mut brep: Brep, names: &[FaceName]) -> Brep {
        for (own, name) in brep.parts.faces.iter_mut().zip(names) {
            if let Some(old) = self.all.solids.get(name.operand).and_then(|s| s.brep().faces().get(name.face))
            {
                own.material_channel = old.material_channel;
                own.colour = old.colour;
            }
        }
        brep
    }

    /// A brep of some chosen regions; whether their normals point to the inside of what they close.
    fn built(&self, shell: &[usize], mates: &Mates) -> Result<(Made, bool)> {
        let mut builder = Builder::new();
        let mut vertices: BTreeMap<usize, NewVertex> = BTreeMap::new();
        let mut edges: BTreeMap<(usize, usize), NewEdge> = BTreeMap::new();
        let mut names = Vec::with_capacity(shell.len());
        let mut wanted = false;
        for (k, &place) in shell.iter().enumerate() {
            let (Some(chosen), Some(region)) = (self.chosen.get(place), self.region(place)) else { continue };
            let Some(face) = self.all.faces.get(region.face) else { continue };
            let turned = face.reversed != chosen.flipped;
            if k == 0 {
                wanted = turned;
            }
            names.push(FaceName { operand: face.solid, face: face.place });
            let new = builder.face(face.surface.clone(), turned);
            for (l, chain) in region.loops.iter().enumerate() {
                let mut paths = Vec::with_capacity(chain.len());
                for (s, step) in chain.iter().enumerate() {
                    let mut vertex = |v: usize| {
                        *vertices.entry(v).or_insert_with(|| builder.vertex(self.all.vertices.point(v)))
                    };
                    let along = match step.track {
                        Track::Point(v) => Along::Point(vertex(v)),
                        Track::Piece(piece, reversed) => {
                            let key = mates.get(&(place, l, s)).copied().unwrap_or((piece, 0));
                            let Some(own) = self.pieces.list.get(piece) else { continue };
                            let ends = own.ends.map(&mut vertex);
                            let edge =
                                *edges.entry(key).or_insert_with(|| builder.edge(own.curve.clone(), ends));
                            Along::Edge(edge, reversed)
                        }
                    };
                    paths.push(Path { curve: step.curve.clone(), along });
                }
                let kind = if l == 0 { LoopKind::Outer } else { LoopKind::Inner };
                builder.bound(new, kind, paths)?;
            }
        }
        let brep = builder.finish(EDGE_OFF_FACE * self.all.limit).map_err(|e| match e {
            crate::Error::Stopped => e,
            _ => self.refuse(RefusalClass::Unsound, shell.first().copied()),
        })?;
        let inward = brep.faces().first().is_some_and(|f| f.reversed != wanted);
        Ok((Made { brep: self.with_colours(brep, &names), names }, inward))
    }
}
