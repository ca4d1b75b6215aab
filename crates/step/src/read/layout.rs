//! The loops of a face in its parameter plane: shifted by whole periods until they join, closed along poles, and cut
//! open where they go round a surface that closes.

use super::pull::{Flat, pull};
use super::support::Support;
use super::topology::{Face, Topology, Use};
use crate::{Error, Result};
use katydid_geometry::brep::LoopKind;
use katydid_geometry::{BoundingBox, Curve, Direction, Interval, Line, LineCurve, Point3, Surface, Xform};

/// Parts of a period that are rounding.
const SAME: f64 = 1e-6;

/// What a piece of a loop runs along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Along {
    /// An edge of the file.
    Edge(Use),
    /// The seam, which the file has not; backwards or not.
    Seam(bool),
    /// A pole where a vertex is.
    Vertex(usize),
    /// A pole where no vertex is.
    Tip,
}

/// A piece of a loop.
#[derive(Clone)]
pub(super) struct Piece {
    pub(super) curve: Curve,
    pub(super) along: Along,
}

/// An end of a seam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    Vertex(usize),
    Tip(Point3),
}

/// A seam that the file has not.
pub(super) struct Seam {
    pub(super) curve: Curve,
    pub(super) ends: [End; 2],
}

/// A face, ready to be built.
pub(super) struct Layout {
    pub(super) surface: Surface,
    pub(super) loops: Vec<(LoopKind, Vec<Piece>)>,
    pub(super) seam: Option<Seam>,
}

/// What came of laying out a face.
pub(super) enum Outcome {
    Done(Box<Layout>),
    /// An edge is to be divided first, at a point.
    Split(usize, Point3),
}

/// A loop on its way: its pieces joined end to end.
struct Chain {
    pieces: Vec<Piece>,
    /// How often it goes round in u and in v.
    turns: [i32; 2],
}

fn line(a: [f64; 2], b: [f64; 2]) -> Curve {
    let at = |uv: [f64; 2]| Point3::new(uv[0], uv[1], 0.0);
    LineCurve::new(Line::new(at(a), at(b))).into()
}

fn start(piece: &Piece) -> [f64; 2] {
    let p = piece.curve.start();
    [p.x, p.y]
}

fn end(piece: &Piece) -> [f64; 2] {
    let p = piece.curve.end();
    [p.x, p.y]
}

fn moved(curve: &Curve, by: [f64; 2]) -> Result<Curve> {
    if by == [0.0; 2] {
        return Ok(curve.clone());
    }
    Ok(curve.transformed(&Xform::translation(katydid_geometry::Vector3::new(by[0], by[1], 0.0)))?)
}

impl Chain {
    fn moved(&self, by: [f64; 2]) -> Result<Self> {
        let pieces = self.pieces.iter().map(|p| Ok(Piece { curve: moved(&p.curve, by)?, along: p.along }));
        Ok(Self { pieces: pieces.collect::<Result<_>>()?, turns: self.turns })
    }

    /// Twice the area that the loop encloses, by points along it.
    fn area(&self) -> f64 {
        let mut points = Vec::new();
        for piece in &self.pieces {
            let count = if let Curve::Line(_) = piece.curve { 1 } else { 24 };
            let domain = piece.curve.domain();
            points
                .extend((0..count).map(|k| piece.curve.point_at(domain.at(f64::from(k) / f64::from(count)))));
        }
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum()
    }

    fn bounds(&self) -> Option<BoundingBox> {
        self.pieces.iter().map(|p| p.curve.bounding_box()).reduce(|a, b| a.union(&b))
    }
}

/// A face on its way.
struct Laying<'a> {
    support: &'a Support,
    topology: &'a Topology,
    tolerance: f64,
}

/// Lays out the loops of a face.
pub(super) fn lay_out(topology: &Topology, face: &Face, tolerance: f64) -> Result<Outcome> {
    let laying = Laying { support: &face.support, topology, tolerance };
    let mut chains = Vec::new();
    for uses in &face.loops {
        chains.push(laying.chain(uses)?);
    }
    let refuse = |why: String| Error::entity(face.id, why);
    let (round, flat): (Vec<Chain>, Vec<Chain>) = chains.into_iter().partition(|c| c.turns != [0, 0]);
    let mut seam = None;
    let (outer, inner) = if round.is_empty() {
        let place = (0..flat.len()).max_by(|a, b| flat[*a].area().abs().total_cmp(&flat[*b].area().abs()));
        let mut inner = flat;
        let outer = place.map(|place| inner.swap_remove(place));
        (outer.ok_or_else(|| refuse("it has no loops".into()))?, inner)
    } else {
        match laying.cut(round).map_err(refuse)? {
            Cut::Split(edge, point) => return Ok(Outcome::Split(edge, point)),
            Cut::Done(chain, made) => {
                seam = Some(*made);
                (chain, flat)
            }
        }
    };
    let bounds = outer.bounds().ok_or_else(|| refuse("it has no size".into()))?;
    let ranges = [Interval::new(bounds.min.x, bounds.max.x), Interval::new(bounds.min.y, bounds.max.y)];
    if ranges.iter().any(|range| !range.is_increasing()) {
        return Err(refuse("its outer loop encloses nothing".into()));
    }
    let surface = face.support.bounded(ranges).map_err(|error| refuse(error.to_string()))?;
    let mut loops = Vec::new();
    let mut kind = LoopKind::Outer;
    for chain in std::iter::once(&outer).chain(&inner) {
        let chain = laying.brought_in(chain, &surface)?;
        let wanted = if kind == LoopKind::Outer { 1.0 } else { -1.0 };
        let pieces = if chain.area() * wanted < 0.0 { backwards(chain.pieces) } else { chain.pieces };
        loops.push((kind, pieces));
        kind = LoopKind::Inner;
    }
    Ok(Outcome::Done(Box::new(Layout { surface, loops, seam })))
}

/// The same loop walked the other way.
fn backwards(pieces: Vec<Piece>) -> Vec<Piece> {
    let turned = |piece: Piece| {
        let along = match piece.along {
            Along::Edge(one) => Along::Edge(Use { reversed: !one.reversed, ..one }),
            Along::Seam(reversed) => Along::Seam(!reversed),
            other => other,
        };
        Piece { curve: piece.curve.reversed(), along }
    };
    pieces.into_iter().rev().map(turned).collect()
}

/// What came of cutting loops that go round.
enum Cut {
    Done(Chain, Box<Seam>),
    Split(usize, Point3),
}

impl Laying<'_> {
    fn flat(&self, one: Use, is_seam: bool) -> Result<Flat> {
        let edge = self.topology.edge(one.edge)?;
        let flat = pull(self.support, &edge.curve, self.tolerance, is_seam)?;
        Ok(if one.reversed { flat.reversed() } else { flat })
    }

    /// The vertex at the start of a use.
    fn vertex(&self, one: Use) -> Result<usize> {
        let edge = self.topology.edge(one.edge)?;
        Ok(edge.vertices[usize::from(one.reversed)])
    }

    fn chain(&self, uses: &[Use]) -> Result<Chain> {
        let mut pieces: Vec<Piece> = Vec::new();
        let mut poles = Vec::new();
        for one in uses {
            let is_seam = uses.iter().filter(|other| other.edge == one.edge).count() > 1;
            let flat = self.flat(*one, is_seam)?;
            let (pole, at) = (flat.poles[0], flat.curve.start());
            let (mut from, mut by) = ([at.x, at.y], [0.0; 2]);
            if let Some(last) = pieces.last() {
                let to = end(last);
                let is_same = matches!(last.along, Along::Edge(other) if other.edge == one.edge);
                by = self.shift(to, from, pole, is_same);
                from = [from[0] + by[0], from[1] + by[1]];
                self.along_pole(&mut pieces, to, from, pole, *one)?;
            }
            poles.push(pole);
            pieces.push(Piece { curve: moved(&flat.curve, by)?, along: Along::Edge(*one) });
        }
        let mut turns = [0; 2];
        if let (Some(first), Some(last), Some(one)) = (pieces.first(), pieces.last(), uses.first()) {
            let (from, to) = (start(first), end(last));
            match poles.first().copied().flatten() {
                Some(pole) => self.along_pole(&mut pieces, to, from, Some(pole), *one)?,
                None => {
                    for d in 0..2 {
                        if let Some(period) = self.support.periods[d] {
                            turns[d] = ((to[d] - from[d]) / period).round() as i32;
                        }
                    }
                }
            }
        }
        Ok(Chain { pieces, turns })
    }

    /// What brings a start to where the piece before ends: whole periods, along a pole the way that a loop goes there.
    fn shift(
        &self,
        to: [f64; 2],
        from: [f64; 2],
        pole: Option<super::support::Pole>,
        is_same: bool,
    ) -> [f64; 2] {
        let mut by = [0.0; 2];
        for d in 0..2 {
            let Some(period) = self.support.periods[d] else { continue };
            by[d] = match pole.filter(|pole| pole.free == d) {
                None => period * ((to[d] - from[d]) / period).round(),
                Some(pole) => {
                    let sense = pole.sense();
                    let mut way = (sense * (from[d] - to[d])).rem_euclid(period);
                    if way <= SAME * period || way >= period * (1.0 - SAME) {
                        way = if is_same { period } else { 0.0 };
                    }
                    to[d] + sense * way - from[d]
                }
            };
        }
        by
    }

    /// A piece along a pole, where two edges meet there in different directions.
    fn along_pole(
        &self,
        pieces: &mut Vec<Piece>,
        to: [f64; 2],
        from: [f64; 2],
        pole: Option<super::support::Pole>,
        next: Use,
    ) -> Result<()> {
        let Some(pole) = pole else { return Ok(()) };
        let gap = (from[pole.free] - to[pole.free]).abs();
        if gap > SAME * self.support.periods[pole.free].unwrap_or(gap) {
            // Both ends lie on the pole itself.
            let at = self.support.poles[1 - pole.free][usize::from(pole.is_high)];
            let (mut to, mut from) = (to, from);
            if let Some(at) = at {
                to[1 - pole.free] = at;
                from[1 - pole.free] = at;
            }
            pieces.push(Piece { curve: line(to, from), along: Along::Vertex(self.vertex(next)?) });
        }
        Ok(())
    }

    /// Joins loops that go round by a seam: two of them, or one and a pole.
    fn cut(&self, round: Vec<Chain>) -> std::result::Result<Cut, String> {
        let told = |error: Error| error.to_string();
        let d = usize::from(round.iter().all(|chain| chain.turns[0] == 0));
        let o = 1 - d;
        let Some(period) = self.support.periods[d] else { return Err("a loop goes round nothing".into()) };
        // A loop with the face on the side of greater values of the other parameter.
        let is_low = |chain: &Chain| (chain.turns[d] > 0) == (d == 0);
        if round.iter().any(|chain| chain.turns[o] != 0 || chain.turns[d].abs() != 1) {
            return Err("loops that wind round a surface are not supported".into());
        }
        let (mut low, mut high): (Vec<Chain>, Vec<Chain>) = round.into_iter().partition(is_low);
        let tip = |end: usize| {
            self.support.poles[o][end].ok_or("nothing bounds the face on one side of a loop that goes round")
        };
        match (low.pop(), high.pop(), low.is_empty() && high.is_empty()) {
            (Some(low), Some(high), true) => self.band(low, high, d, period).map_err(told),
            (Some(one), None, true) => {
                let cap = self.capped(one, d, tip(1)?, true).map_err(told)?;
                Ok(cap)
            }
            (None, Some(one), true) => Ok(self.capped(one, d, tip(0)?, false).map_err(told)?),
            _ => Err("more than two loops go round the surface: not supported".into()),
        }
    }

    fn first_vertex(&self, chain: &Chain) -> Result<usize> {
        match chain.pieces.first().map(|piece| piece.along) {
            Some(Along::Edge(one)) => self.vertex(one),
            _ => Err(katydid_geometry::Error::Degenerate { what: "loop", why: "it has no edges" }.into()),
        }
    }

    /// The loop that goes round, a seam to a pole, the pole, and the seam back.
    fn capped(&self, mut chain: Chain, d: usize, pole: f64, is_high: bool) -> Result<Cut> {
        let vertex = self.first_vertex(&chain)?;
        let (Some(first), Some(last)) = (chain.pieces.first(), chain.pieces.last()) else {
            return Err(katydid_geometry::Error::Degenerate { what: "loop", why: "it has no edges" }.into());
        };
        let (from, mut to) = (start(first), end(last));
        // Exactly a period on.
        let period = self.support.periods[d].unwrap_or_default();
        to[d] = from[d] + period * f64::from(chain.turns[d]);
        to[1 - d] = from[1 - d];
        let mut tips = [to, from];
        tips.iter_mut().for_each(|tip| tip[1 - d] = pole);
        chain.pieces.push(Piece { curve: line(to, tips[0]), along: Along::Seam(!is_high) });
        chain.pieces.push(Piece { curve: line(tips[0], tips[1]), along: Along::Tip });
        chain.pieces.push(Piece { curve: line(tips[1], from), along: Along::Seam(is_high) });
        let tip = End::Tip(self.support.point(tips[1]));
        let ends = if is_high { [End::Vertex(vertex), tip] } else { [tip, End::Vertex(vertex)] };
        let (a, b) = if is_high { (from, tips[1]) } else { (tips[1], from) };
        let seam = Seam { curve: self.seam_curve(d, a, b)?, ends };
        Ok(Cut::Done(Chain { turns: [0; 2], ..chain }, Box::new(seam)))
    }

    /// The curve of a seam in space, from one place to another of greater value.
    fn seam_curve(&self, d: usize, a: [f64; 2], b: [f64; 2]) -> Result<Curve> {
        let o = 1 - d;
        let mut ranges = [Interval::UNIT; 2];
        ranges[o] = Interval::new(a[o], b[o]);
        ranges[d] = Interval::new(a[d], a[d] + self.support.periods[d].unwrap_or(1.0));
        let direction = if o == 0 { Direction::U } else { Direction::V };
        let surface = self.support.bounded(ranges)?;
        let across = surface.domain(direction.other());
        let period = self.support.periods[d].unwrap_or(1.0);
        let constant = a[d] + period * ((across.start - a[d]) / period).round();
        let curve = surface.isocurve(direction, across.clamp(constant))?;
        let range = Interval::new(curve.domain().clamp(a[o]), curve.domain().clamp(b[o]));
        Ok(if range == curve.domain() { curve } else { curve.trimmed(range)? })
    }

    /// The band between two loops that go round.
    fn band(&self, low: Chain, high: Chain, d: usize, period: f64) -> Result<Cut> {
        let o = 1 - d;
        let places = |chain: &Chain| chain.pieces.iter().map(start).collect::<Vec<_>>();
        let is_same = |a: f64, b: f64| {
            let apart = ((a - b) / period).rem_euclid(1.0);
            apart <= SAME || apart >= 1.0 - SAME
        };
        let (lows, highs) = (places(&low), places(&high));
        let pair = lows
            .iter()
            .enumerate()
            .find_map(|(i, a)| highs.iter().position(|b| is_same(a[d], b[d])).map(|j| (i, j)));
        let Some((i, j)) = pair else {
            return self.split_opposite(&high, d, period, lows.first().map_or(0.0, |p| p[d]));
        };
        let low = self.begun_at(low, i, d, period)?;
        let high = self.begun_at(high, j, d, period)?;
        let mut by = [0.0; 2];
        let (Some(a), Some(b)) = (low.pieces.first().map(start), high.pieces.first().map(start)) else {
            return Err(katydid_geometry::Error::Degenerate { what: "loop", why: "it has no edges" }.into());
        };
        let low_end = a[d] + period * f64::from(low.turns[d]);
        by[d] = low_end - b[d];
        if let Some(other) = self.support.periods[o] {
            // Around a tube the band goes on from the low loop.
            let way = (b[o] - a[o]).rem_euclid(other);
            by[o] = a[o] + if way <= SAME * other { other } else { way } - b[o];
        }
        let vertices = [self.first_vertex(&low)?, self.first_vertex(&high)?];
        let high = high.moved(by)?;
        let mut low_end_at = a;
        low_end_at[d] = low_end;
        let high_start = [b[0] + by[0], b[1] + by[1]];
        let mut high_end = high_start;
        high_end[d] = a[d];
        let mut pieces = low.pieces;
        pieces.push(Piece { curve: line(low_end_at, high_start), along: Along::Seam(false) });
        pieces.extend(high.pieces);
        pieces.push(Piece { curve: line(high_end, a), along: Along::Seam(true) });
        let curve = self.seam_curve(d, a, high_end)?;
        let seam = Seam { curve, ends: vertices.map(End::Vertex) };
        Ok(Cut::Done(Chain { pieces, turns: [0; 2] }, Box::new(seam)))
    }

    /// A loop that goes round, begun at another of its pieces.
    fn begun_at(&self, mut chain: Chain, place: usize, d: usize, period: f64) -> Result<Chain> {
        let mut by = [0.0; 2];
        by[d] = period * f64::from(chain.turns[d]);
        chain.pieces.rotate_left(place);
        let count = chain.pieces.len();
        for piece in chain.pieces.iter_mut().skip(count - place) {
            piece.curve = moved(&piece.curve, by)?;
        }
        Ok(chain)
    }

    /// Where an edge of a loop passes a value of a parameter.
    fn split_opposite(&self, chain: &Chain, d: usize, period: f64, value: f64) -> Result<Cut> {
        for piece in &chain.pieces {
            let Along::Edge(one) = piece.along else { continue };
            let (a, b) = (start(piece)[d], end(piece)[d]);
            let (low, high) = (a.min(b), a.max(b));
            let wanted = value + period * ((low - value) / period).ceil();
            if wanted > high {
                continue;
            }
            let domain = piece.curve.domain();
            let at = |t: f64| {
                let p = piece.curve.point_at(t);
                [p.x, p.y]
            };
            let (mut from, mut to) = (domain.start, domain.end);
            for _ in 0..80 {
                let middle = 0.5 * (from + to);
                if (at(middle)[d] < wanted) == (a < b) { from = middle } else { to = middle }
            }
            let mut uv = at(0.5 * (from + to));
            uv[d] = wanted;
            return Ok(Cut::Split(one.edge, self.support.point(uv)));
        }
        Err(katydid_geometry::Error::Degenerate { what: "loop", why: "it does not go all the way round" }
            .into())
    }

    /// The chain moved by whole periods to lie in the domain of a surface.
    fn brought_in(&self, chain: &Chain, surface: &Surface) -> Result<Chain> {
        let Some(bounds) = chain.bounds() else { return chain.moved([0.0; 2]) };
        let middle = bounds.center();
        let mut by = [0.0; 2];
        for (d, direction) in Direction::BOTH.into_iter().enumerate() {
            if let Some(period) = self.support.periods[d] {
                let domain = surface.domain(direction);
                let at = if d == 0 { middle.x } else { middle.y };
                let inside = domain.contains(at);
                by[d] = if inside { 0.0 } else { period * ((domain.middle() - at) / period).round() };
            }
        }
        chain.moved(by)
    }
}
