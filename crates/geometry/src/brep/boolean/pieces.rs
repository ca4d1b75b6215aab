//! One table of the pieces into which vertices cut edges and sections: what lies upon each other is one piece.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::interferences::edge_stops;
use super::operands::{Near, Operands, Place};
use super::sections::{SectionPiece, index_of};
use super::thresholds::{BESIDE_BORDER, CAPTURE, CROSSING, PLACES, SAME_CURVE};
use crate::{BoundingBox, BoxIndex, Curve, Interval, Point3, Result, cancellation};

/// A stretch of a curve between two vertices, with none between them.
#[derive(Debug)]
pub(super) struct Piece {
    pub(super) curve: Curve,
    pub(super) ends: [usize; 2],
    pub(super) bounds: BoundingBox,
    /// The largest distance found of a curve that was taken as this one.
    pub(super) apart: f64,
    /// Whether faces of two solids pass through each other along it: then it divides both.
    pub(super) crossing: bool,
    /// The operands on whose boundary it lies.
    pub(super) solids: BTreeSet<usize>,
}

/// A piece as a part of an edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfEdge {
    pub(super) piece: usize,
    /// Whether it runs against the edge.
    pub(super) reversed: bool,
    /// The range of the edge.
    pub(super) range: Interval,
}

/// A piece on a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnFace {
    pub(super) face: usize,
    pub(super) piece: usize,
}

/// All pieces, where they are on edges, and which of them are drawn on faces.
#[derive(Debug)]
pub(super) struct Pieces {
    pub(super) list: Vec<Piece>,
    by_ends: HashMap<[usize; 2], Vec<usize>>,
    /// The pieces of every edge, in its order.
    pub(super) of_edge: Vec<Vec<OfEdge>>,
    /// The pieces that are drawn on every face, besides its border, in order.
    pub(super) on_face: Vec<BTreeSet<usize>>,
    /// Pieces that run along the border of a face without being a part of it, and are not drawn.
    pub(super) beside: Vec<OnFace>,
    limit: f64,
}

impl Pieces {
    /// Cuts all edges at the vertices on them, adds the pieces of sections, and draws on every face the edges of other
    /// operands that lie in it.
    pub(super) fn new(all: &Operands, sections: Vec<SectionPiece>, pairs: &[(usize, usize)]) -> Result<Self> {
        let mut out = Self {
            list: Vec::new(),
            by_ends: HashMap::new(),
            of_edge: vec![Vec::new(); all.edges.len()],
            on_face: vec![BTreeSet::new(); all.faces.len()],
            beside: Vec::new(),
            limit: all.limit,
        };
        let index = index_of(all);
        for place in 0..all.edges.len() {
            cancellation::check()?;
            out.cut_edge(all, &index, place)?;
        }
        let borders = out.borders(all);
        for section in sections {
            let crossing = crosses(all, &section)?;
            let (piece, _) = out.at(section.curve, section.ends)?;
            out.list.get_mut(piece).into_iter().for_each(|p| p.crossing |= crossing);
            for face in section.faces {
                if let (Some(own), Some(border)) = (all.faces.get(face), borders.get(face)) {
                    out.list.get_mut(piece).into_iter().for_each(|p| {
                        p.solids.insert(own.solid);
                    });
                    if !border.contains(&piece) {
                        out.on_face.get_mut(face).into_iter().for_each(|list| {
                            list.insert(piece);
                        });
                    }
                }
            }
        }
        out.draw_edges(all, pairs, &borders)?;
        Ok(out)
    }

    /// The pieces along the borders of faces.
    fn borders(&self, all: &Operands) -> Vec<BTreeSet<usize>> {
        let of_edge = |e: &usize| self.of_edge.get(*e).map_or(&[] as &[OfEdge], Vec::as_slice);
        all.faces.iter().map(|f| f.border.iter().flat_map(of_edge).map(|p| p.piece).collect()).collect()
    }

    fn cut_edge(&mut self, all: &Operands, index: &BoxIndex, place: usize) -> Result<()> {
        let Some(edge) = all.edges.get(place) else { return Ok(()) };
        let stops = edge_stops(all, index, edge)?;
        let mut parts = Vec::with_capacity(stops.len());
        for pair in stops.windows(2) {
            let [(s, a), (t, b)] = [pair[0], pair[1]];
            let range = Interval::new(s, t);
            if !range.is_increasing() || (a == b && stops.len() > 2) {
                continue;
            }
            let curve = if stops.len() == 2 { edge.curve.clone() } else { edge.curve.trimmed(range)? };
            if a == b && curve.bounding_box().diagonal().length() <= 2.0 * self.limit {
                continue;
            }
            let (piece, reversed) = self.at(curve, [a, b])?;
            self.list.get_mut(piece).into_iter().for_each(|p| {
                p.solids.insert(edge.solid);
            });
            parts.push(OfEdge { piece, reversed, range });
        }
        if let Some(own) = self.of_edge.get_mut(place) {
            *own = parts;
        }
        Ok(())
    }

    /// The piece along a curve between two vertices, and whether it runs against it: a known one, or a new one.
    fn at(&mut self, curve: Curve, ends: [usize; 2]) -> Result<(usize, bool)> {
        let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let known = self.by_ends.get(&key).cloned().unwrap_or_default();
        for place in known {
            let Some(piece) = self.list.get(place) else { continue };
            if let Some((reversed, apart)) = self.same(piece, &curve, ends)? {
                self.list.get_mut(place).into_iter().for_each(|p| p.apart = p.apart.max(apart));
                return Ok((place, reversed));
            }
        }
        let place = self.list.len();
        let bounds = curve.bounding_box();
        self.list.push(Piece { curve, ends, bounds, apart: 0.0, crossing: false, solids: BTreeSet::new() });
        self.by_ends.entry(key).or_default().push(place);
        Ok((place, false))
    }

    /// Whether a curve with the same ends runs along a piece; then, whether backwards and at which distance.
    fn same(&self, piece: &Piece, curve: &Curve, ends: [usize; 2]) -> Result<Option<(bool, f64)>> {
        let domain = curve.domain();
        let reach = SAME_CURVE * self.limit;
        let search = Near::of(&piece.curve);
        let mut at = [0.0; 2];
        let mut apart = 0.0_f64;
        for (t, share) in at.iter_mut().zip([0.5, 0.29]) {
            let p = curve.point_at(domain.at(share));
            let Some(found) = search.parameter(p, reach)? else {
                return Ok(None);
            };
            *t = found;
            apart = apart.max(piece.curve.point_at(found).distance_to(p));
        }
        let reversed = if ends[0] == ends[1] {
            // By the directions at a common place.
            let [_, d] = curve.jet_at::<2>(domain.middle(), false);
            let [_, e] = piece.curve.jet_at::<2>(at[0], false);
            d.dot(e) < 0.0
        } else {
            piece.ends != ends
        };
        Ok(Some((reversed, apart)))
    }

    /// Draws edges on the faces of other operands in which they lie.
    fn draw_edges(
        &mut self,
        all: &Operands,
        pairs: &[(usize, usize)],
        borders: &[BTreeSet<usize>],
    ) -> Result<()> {
        let mut asked: BTreeSet<(usize, usize)> = BTreeSet::new();
        for &(a, b) in pairs {
            for (own, other) in [(a, b), (b, a)] {
                cancellation::check()?;
                let (Some(border), Some(taken)) = (borders.get(own), borders.get(other)) else { continue };
                let Some(face) = all.faces.get(other) else { continue };
                for &piece in border {
                    let Some(p) = self.list.get(piece) else { continue };
                    if p.bounds.distance_to_box(&face.bounds) > all.limit || !asked.insert((piece, other)) {
                        continue;
                    }
                    if taken.contains(&piece) {
                        continue;
                    }
                    match lies(all, face, &p.curve)? {
                        Lies::Outside => continue,
                        Lies::Beside => self.beside.push(OnFace { face: other, piece }),
                        Lies::Inside => self.on_face.get_mut(other).into_iter().for_each(|list| {
                            list.insert(piece);
                        }),
                    }
                    self.list.get_mut(piece).into_iter().for_each(|p| {
                        p.solids.insert(face.solid);
                    });
                }
            }
        }
        Ok(())
    }

    /// Lets go of what finds pieces by their ends: none is added any more.
    pub(super) fn forget_ends(&mut self) {
        self.by_ends = HashMap::new();
    }

    /// How often each piece of some list occurs an odd number of times, in order: the boundary of what pieces go round.
    pub(super) fn odd(pieces: impl IntoIterator<Item = usize>) -> Vec<usize> {
        let mut counts: BTreeMap<usize, bool> = BTreeMap::new();
        for piece in pieces {
            let odd = counts.entry(piece).or_default();
            *odd = !*odd;
        }
        counts.into_iter().filter(|(_, odd)| *odd).map(|(piece, _)| piece).collect()
    }

    /// The middle of a piece.
    pub(super) fn middle(&self, piece: usize) -> Option<Point3> {
        let own = self.list.get(piece)?;
        Some(own.curve.point_at(own.curve.domain().middle()))
    }
}

/// Whether the faces of two solids pass through each other along a piece of their section.
fn crosses(all: &Operands, section: &SectionPiece) -> Result<bool> {
    let p = section.curve.point_at(section.curve.domain().middle());
    let mut normals = Vec::with_capacity(2);
    for face in section.faces.iter().filter_map(|f| all.faces.get(*f)) {
        if all.solids.get(face.solid).is_some_and(|s| s.closed) {
            normals.extend(face.normal(face.parameters(p)?));
        }
    }
    let [m, n] = normals.as_slice() else { return Ok(false) };
    Ok(m.cross(*n).length() > CROSSING)
}

/// How a curve without a vertex between its ends, which is no piece of a face's border, lies to the face.
enum Lies {
    Inside,
    Outside,
    /// Nowhere farther from the border than points are told apart, and not inside.
    Beside,
}

/// Where all places of a curve are near the border, less is counted as the border until they tell: the curve is not the
/// border, so that something lies between the two.
fn lies(all: &Operands, face: &super::operands::Face, curve: &Curve) -> Result<Lies> {
    let domain = curve.domain();
    for beside in BESIDE_BORDER {
        let mut inside = false;
        for share in PLACES {
            let p = curve.point_at(domain.at(share));
            match all.place_beside(face, p, CAPTURE * all.limit, beside * all.limit)? {
                Place::Inside(_) => inside = true,
                // Only what is clear of the border leaves no doubt.
                Place::Outside => return Ok(if beside < CAPTURE { Lies::Beside } else { Lies::Outside }),
                Place::Border => {}
            }
        }
        if inside {
            return Ok(Lies::Inside);
        }
    }
    Ok(Lies::Beside)
}
