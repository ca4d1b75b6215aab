//! A face cut along the curves drawn on it: one arrangement in its parameter plane, whatever its surface. Seams are
//! edges that occur twice, and where the surface is a point its side is a piece without an edge.
//!
//! Curves meet at nodes only, so that the order around a node is that in which they leave a small circle about it.
//! Loops are followed with the face on their left (half-edges as in M. de Berg et al., *Computational Geometry*, 2).

use std::collections::BTreeSet;

use katydid_elementary::Elementary;

use super::operands::{Face, Operands};
use super::pieces::{OfEdge, Pieces};
use super::refusal::RefusalClass;
use super::thresholds::{ACROSS_SEAM, HALVINGS, NEWTON, ROUNDING, SAME_DISTANCE, SAME_PARAMETER, SAMPLES};
use crate::brep::build::with_ends;
use crate::region::Outline;
use crate::{Curve, Direction, Interval, Line, Plane, Point3, Result, Side};

/// What a piece of a loop runs along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Track {
    /// A piece, or the piece walked backwards.
    Piece(usize, bool),
    /// The point of a vertex.
    Point(usize),
}

/// A piece of a loop in the parameter plane.
#[derive(Debug, Clone)]
pub(super) struct Step {
    pub(super) curve: Curve,
    pub(super) track: Track,
}

/// The loops around a region of a face, the outer one first.
pub(super) type Loops = Vec<Vec<Step>>;

/// A piece in the parameter plane, both ways.
#[derive(Debug)]
struct Arc {
    curve: Curve,
    track: Track,
    nodes: [usize; 2],
    /// Whether only its left side belongs to the face.
    border: bool,
}

/// A vertex at one place of the parameter plane.
#[derive(Debug, Clone, Copy)]
struct Node {
    vertex: usize,
    uv: [f64; 2],
}

/// The loops of a face with its border cut at the vertices on it, when nothing is drawn on it.
pub(super) fn whole(all: &Operands, pieces: &Pieces, face: &Face) -> Result<Loops> {
    let mut out = Vec::with_capacity(face.loops.len());
    for chain in &face.loops {
        let mut steps = Vec::with_capacity(chain.len());
        for bound in chain {
            match bound.edge {
                None => steps.push(Step { curve: bound.curve.clone(), track: Track::Point(bound.start) }),
                Some((edge, reversed)) => {
                    steps.extend(border_steps(all, pieces, face, edge, reversed, &bound.curve)?)
                }
            }
        }
        out.push(steps);
    }
    Ok(out)
}

/// The pieces of a trim, in its order.
fn border_steps(
    all: &Operands,
    pieces: &Pieces,
    face: &Face,
    edge: usize,
    reversed: bool,
    trim: &Curve,
) -> Result<Vec<Step>> {
    let parts: &[OfEdge] = pieces.of_edge.get(edge).map_or(&[], Vec::as_slice);
    let Some(own) = all.edges.get(edge) else { return Ok(Vec::new()) };
    let track = |part: &OfEdge| Track::Piece(part.piece, part.reversed != reversed);
    if let [only] = parts {
        return Ok(vec![Step { curve: trim.clone(), track: track(only) }]);
    }
    let whole = own.curve.domain();
    let domain = trim.domain();
    let mut places = Vec::with_capacity(parts.len() + 1);
    places.push(domain.start);
    let ordered: Vec<&OfEdge> = if reversed { parts.iter().rev().collect() } else { parts.iter().collect() };
    for pair in ordered.windows(2) {
        let t = if reversed { pair[0].range.start } else { pair[0].range.end };
        let share = whole.normalized(t);
        let guess = domain.at(if reversed { 1.0 - share } else { share });
        places.push(trim_parameter(face, trim, guess, own.curve.point_at(t)));
    }
    places.push(domain.end);
    let mut out = Vec::with_capacity(ordered.len());
    for (part, range) in ordered.iter().zip(places.windows(2)) {
        let range = Interval::new(range[0], range[1]);
        if !range.is_increasing() {
            return Err(all.refuse(
                RefusalClass::UnclosedSplit,
                &[],
                Some(own.curve.point_at(part.range.start)),
            ));
        }
        out.push(Step { curve: trim.trimmed(range)?, track: track(part) });
    }
    Ok(out)
}

/// The parameter at which the image of a trim is nearest to a point, from a guess: Newton's method on the tangent.
pub(super) fn trim_parameter(face: &Face, trim: &Curve, guess: f64, p: Point3) -> f64 {
    let domain = trim.domain();
    let off = |t: f64| {
        let uv = trim.point_at(t);
        face.surface.point_at(uv.x, uv.y).distance_to(p)
    };
    let newton = |mut t: f64| {
        for _ in 0..NEWTON {
            let [uv, slope] = trim.jet_at::<2>(t, false);
            let quadrant = face.surface.inner_quadrant(uv.x, uv.y);
            let d = face.surface.derivatives(uv.x, uv.y, 1, quadrant);
            let along = d.get(1, 0) * slope.x + d.get(0, 1) * slope.y;
            let square = along.length_squared();
            if !(square > 0.0) {
                break;
            }
            let step = (p - d.point()).dot(along) / square;
            let next = domain.clamp(t + step);
            if (next - t).abs() <= f64::EPSILON * domain.length() {
                return next;
            }
            t = next;
        }
        t
    };
    let first = newton(guess);
    // Where the image is at the point nothing else is nearer.
    if off(first) <= ROUNDING * face.size {
        return first;
    }
    let best = (0..=SAMPLES)
        .map(|k| domain.at(k as f64 / SAMPLES as f64))
        .min_by(|a, b| off(*a).total_cmp(&off(*b)))
        .map_or(first, newton);
    if off(first) <= off(best) * (1.0 + SAME_DISTANCE) + f64::MIN_POSITIVE { first } else { best }
}

/// The loops around every region of a face, and the pieces drawn on it that divide nothing.
pub(super) fn regions(
    all: &Operands,
    pieces: &Pieces,
    place: usize,
) -> Result<(Vec<Loops>, BTreeSet<usize>)> {
    let (Some(face), Some(drawn)) = (all.faces.get(place), pieces.on_face.get(place)) else {
        return Ok((Vec::new(), BTreeSet::new()));
    };
    let border = whole(all, pieces, face)?;
    if drawn.is_empty() {
        return Ok((vec![border], BTreeSet::new()));
    }
    let mut plan = Plan::new(all, face, place);
    for chain in &border {
        plan.add_chain(pieces, chain)?;
    }
    for &piece in drawn {
        plan.add_drawn(pieces, piece)?;
    }
    plan.cut_poles()?;
    let before = plan.drawn();
    let chains = plan.prune();
    let idle: BTreeSet<usize> = before.difference(&plan.drawn()).copied().collect();
    plan.refuse_lost(pieces, &idle)?;
    Ok((plan.loops(chains)?, idle))
}

/// An arrangement being made.
pub(super) struct Plan<'a> {
    pub(super) all: &'a Operands,
    pub(super) face: &'a Face,
    place: usize,
    nodes: Vec<Node>,
    arcs: Vec<Arc>,
    pub(super) domain: [Interval; 2],
    /// What makes steps in both parameters comparable lengths.
    pub(super) scale: [f64; 2],
}

impl<'a> Plan<'a> {
    fn new(all: &'a Operands, face: &'a Face, place: usize) -> Self {
        let domain = Direction::BOTH.map(|d| face.surface.domain(d));
        let [u, v] = domain.map(Interval::middle);
        let d = face.surface.derivatives(u, v, 1, face.surface.inner_quadrant(u, v));
        let scale = [d.get(1, 0).length(), d.get(0, 1).length()].map(|s| if s > 0.0 { s } else { 1.0 });
        Self { all, face, place, nodes: Vec::new(), arcs: Vec::new(), domain, scale }
    }

    pub(super) fn refuse(&self, p: Option<Point3>) -> crate::Error {
        self.all.refuse(RefusalClass::UnclosedSplit, &[self.place], p)
    }

    /// Whether parameters lie on a side where the surface is a point.
    pub(super) fn pole(&self, uv: [f64; 2]) -> Option<Side> {
        Side::ALL.into_iter().find(|side| {
            let (along, at_end) = side.along();
            let k = along.other().index();
            let value = if at_end { self.domain[k].end } else { self.domain[k].start };
            (uv[k] - value).abs() <= SAME_PARAMETER * self.domain[k].length()
                && self.face.surface.is_singular(*side)
        })
    }

    /// The node of a vertex at a place of the parameter plane.
    fn node(&mut self, vertex: usize, uv: Point3) -> usize {
        let uv = [uv.x, uv.y];
        let at_pole = self.pole(uv).is_some();
        let near = |node: &Node| {
            node.vertex == vertex
                && (0..2).all(|k| {
                    let share = if at_pole { SAME_PARAMETER } else { ACROSS_SEAM };
                    (node.uv[k] - uv[k]).abs() <= share * self.domain[k].length()
                })
        };
        if let Some(known) = self.nodes.iter().position(near) {
            return known;
        }
        self.nodes.push(Node { vertex, uv });
        self.nodes.len() - 1
    }

    fn add_chain(&mut self, pieces: &Pieces, chain: &[Step]) -> Result<()> {
        for step in chain {
            let vertices = match step.track {
                Track::Point(vertex) => [vertex; 2],
                Track::Piece(piece, reversed) => {
                    let ends = pieces.list.get(piece).ok_or_else(|| self.refuse(None))?.ends;
                    if reversed { [ends[1], ends[0]] } else { ends }
                }
            };
            let nodes =
                [self.node(vertices[0], step.curve.start()), self.node(vertices[1], step.curve.end())];
            self.arcs.push(Arc { curve: step.curve.clone(), track: step.track, nodes, border: true });
        }
        Ok(())
    }

    fn add_drawn(&mut self, pieces: &Pieces, place: usize) -> Result<()> {
        let piece = pieces.list.get(place).ok_or_else(|| self.refuse(None))?;
        let flat = self.pulled(&piece.curve)?;
        let flat = self.inside(&flat)?;
        let nodes = [self.node(piece.ends[0], flat.start()), self.node(piece.ends[1], flat.end())];
        // On its nodes exactly, unless it is but for rounding: arcs of flat faces stay arcs.
        let want =
            nodes.map(|n| self.nodes.get(n).map_or(Point3::ORIGIN, |n| Point3::new(n.uv[0], n.uv[1], 0.0)));
        let ends = [flat.start(), flat.end()];
        let size = self.domain[0].length().max(self.domain[1].length());
        let off = want[0].distance_to(ends[0]).max(want[1].distance_to(ends[1]));
        let flat = if off <= f64::EPSILON * 64.0 * size { flat } else { with_ends(&flat, want)? };
        self.arcs.push(Arc { curve: flat, track: Track::Piece(place, false), nodes, border: false });
        Ok(())
    }

    /// Cuts the pieces along sides that are points at the nodes on them.
    fn cut_poles(&mut self) -> Result<()> {
        let arcs = std::mem::take(&mut self.arcs);
        for arc in arcs {
            let (Track::Point(vertex), true) = (arc.track, arc.border) else {
                self.arcs.push(arc);
                continue;
            };
            let (a, b) = (arc.curve.start(), arc.curve.end());
            let way = b - a;
            let length = way.length();
            let mut stops: Vec<(f64, usize)> = Vec::new();
            for (k, node) in self.nodes.iter().enumerate().filter(|(_, n)| n.vertex == vertex) {
                let off = Point3::new(node.uv[0], node.uv[1], 0.0) - a;
                let along = off.dot(way) / length;
                let aside = (off - way * (along / length)).length();
                let inner = along > SAME_PARAMETER * length && along < (1.0 - SAME_PARAMETER) * length;
                if inner && aside <= SAME_PARAMETER * length && !arc.nodes.contains(&k) {
                    stops.push((along, k));
                }
            }
            stops.sort_by(|x, y| x.0.total_cmp(&y.0));
            let mut before = arc.nodes[0];
            for next in stops.into_iter().map(|s| s.1).chain([arc.nodes[1]]) {
                let ends = [before, next].map(|n| {
                    self.nodes.get(n).map_or(Point3::ORIGIN, |n| Point3::new(n.uv[0], n.uv[1], 0.0))
                });
                let curve = Line::new(ends[0], ends[1]).into();
                self.arcs.push(Arc { curve, track: arc.track, nodes: [before, next], border: true });
                before = next;
            }
        }
        Ok(())
    }

    /// The pieces drawn on the face.
    fn drawn(&self) -> BTreeSet<usize> {
        let piece = |arc: &Arc| match arc.track {
            Track::Piece(piece, _) if !arc.border => Some(piece),
            _ => None,
        };
        self.arcs.iter().filter_map(piece).collect()
    }

    /// Where two solids pass through each other their pieces divide the face. One that does not ends in a place where
    /// another was not found.
    fn refuse_lost(&self, pieces: &Pieces, idle: &BTreeSet<usize>) -> Result<()> {
        let lost = idle.iter().find(|p| pieces.list.get(**p).is_some_and(|p| p.crossing));
        lost.map_or(Ok(()), |piece| Err(self.refuse(pieces.middle(*piece))))
    }

    /// Takes drawn pieces away that end in nothing, and those with one region on both sides: they divide nothing. Gives the
    /// chains of what is left.
    fn prune(&mut self) -> Vec<Vec<usize>> {
        loop {
            let count = self.arcs.len();
            let mut degrees = vec![0_usize; self.nodes.len()];
            for arc in &self.arcs {
                arc.nodes.iter().for_each(|n| degrees[*n] += 1);
            }
            self.arcs.retain(|arc| arc.border || arc.nodes.iter().all(|n| degrees[*n] > 1));
            if self.arcs.len() < count {
                continue;
            }
            let chains = self.chains();
            let mut of_half = vec![0; 2 * self.arcs.len()];
            for (k, chain) in chains.iter().enumerate() {
                chain.iter().for_each(|h| of_half[*h] = k);
            }
            let mut place = 0;
            self.arcs.retain(|arc| {
                let keep = arc.border || of_half[2 * place] != of_half[2 * place + 1];
                place += 1;
                keep
            });
            if self.arcs.len() == count {
                return chains;
            }
        }
    }

    /// The node at which a half of an arc starts; odd halves run backwards.
    fn tail(&self, half: usize) -> usize {
        self.arcs.get(half / 2).map_or(0, |arc| arc.nodes[half % 2])
    }

    /// A place on a half of an arc, by the share of its way, in comparable lengths from a node.
    fn along(&self, half: usize, share: f64) -> [f64; 2] {
        let Some(arc) = self.arcs.get(half / 2) else { return [0.0; 2] };
        let share = if half.is_multiple_of(2) { share } else { 1.0 - share };
        let p = arc.curve.point_at(arc.curve.domain().at(share));
        [p.x * self.scale[0], p.y * self.scale[1]]
    }

    /// The chains of halves with nothing on their left but one region.
    fn chains(&self) -> Vec<Vec<usize>> {
        let count = 2 * self.arcs.len();
        let mut out_of: Vec<Vec<usize>> = vec![Vec::new(); self.nodes.len()];
        for half in 0..count {
            if let Some(list) = out_of.get_mut(self.tail(half)) {
                list.push(half);
            }
        }
        // The half that leaves a node just before another, counter-clockwise.
        let mut before = vec![0; count];
        for list in &mut out_of {
            self.sort_around(list);
            for k in 0..list.len() {
                before[list[(k + 1) % list.len()]] = list[k];
            }
        }
        let mut seen = vec![false; count];
        let mut chains = Vec::new();
        for first in 0..count {
            if seen[first] {
                continue;
            }
            let mut chain = Vec::new();
            let mut half = first;
            while !seen[half] {
                seen[half] = true;
                chain.push(half);
                half = before[half ^ 1];
            }
            chains.push(chain);
        }
        chains
    }

    /// Sorts the halves that leave a node counter-clockwise, by where they leave a circle around it.
    fn sort_around(&self, list: &mut [usize]) {
        // Of two each is the next one of the other.
        if list.len() <= 2 {
            return;
        }
        let from = self.along(list[0], 0.0);
        let distance = |q: [f64; 2]| (q[0] - from[0]).hypotenuse(q[1] - from[1]);
        let step = |k: usize| k as f64 / SAMPLES as f64;
        // Segments leave every circle in their direction, and reach as far as their ends are.
        let straight =
            |half: usize| self.arcs.get(half / 2).is_some_and(|a| matches!(a.curve, Curve::Line(_)));
        let reach = |half: usize| {
            let first = if straight(half) { SAMPLES } else { 1 };
            (first..=SAMPLES).map(|k| distance(self.along(half, step(k)))).fold(0.0, f64::max)
        };
        let radius = 0.25 * list.iter().map(|half| reach(*half)).fold(f64::INFINITY, f64::min);
        let angle = |half: usize| {
            if straight(half) {
                let [p, q] = [self.along(half, 0.0), self.along(half, 1.0)];
                return (q[1] - p[1]).arctangent_of(q[0] - p[0]);
            }
            let (mut low, mut high) = (0.0, 1.0);
            for k in 1..=4 * SAMPLES {
                let share = k as f64 / (4 * SAMPLES) as f64;
                if distance(self.along(half, share)) > radius {
                    high = share;
                    break;
                }
                low = share;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if distance(self.along(half, middle)) > radius { high = middle } else { low = middle }
            }
            let q = self.along(half, high);
            (q[1] - from[1]).arctangent_of(q[0] - from[0])
        };
        let mut keyed: Vec<(f64, usize)> = list.iter().map(|half| (angle(*half), *half)).collect();
        keyed.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (place, (_, half)) in list.iter_mut().zip(keyed) {
            *place = half;
        }
    }

    fn step(&self, half: usize) -> Option<Step> {
        let arc = self.arcs.get(half / 2)?;
        if half.is_multiple_of(2) {
            return Some(Step { curve: arc.curve.clone(), track: arc.track });
        }
        let track = match arc.track {
            Track::Piece(piece, reversed) => Track::Piece(piece, !reversed),
            point => point,
        };
        Some(Step { curve: arc.curve.reversed(), track })
    }

    /// Twice the area that a chain goes round, counter-clockwise.
    fn area(&self, chain: &[usize]) -> f64 {
        let mut points: Vec<[f64; 2]> = Vec::with_capacity(chain.len() * SAMPLES);
        for &half in chain {
            let straight = self.arcs.get(half / 2).is_some_and(|a| matches!(a.curve, Curve::Line(_)));
            let count = if straight { 1 } else { 2 * SAMPLES };
            points.extend((0..count).map(|k| self.along(half, k as f64 / count as f64)));
        }
        let Some(&[x, y]) = points.first() else { return 0.0 };
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(p, q)| (p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y)).sum()
    }

    /// The loops around every region.
    fn loops(&self, chains: Vec<Vec<usize>>) -> Result<Vec<Loops>> {
        let outside = |half: usize| half % 2 == 1 && self.arcs.get(half / 2).is_some_and(|a| a.border);
        let mut outer: Vec<(f64, Vec<Step>, Outline, Vec<usize>)> = Vec::new();
        let mut holes: Vec<Vec<usize>> = Vec::new();
        for chain in chains {
            if chain.iter().any(|h| outside(*h)) {
                if chain.iter().all(|h| outside(*h)) {
                    continue;
                }
                // A piece is drawn beyond the border.
                let place = chain.first().map(|h| self.along(*h, 0.0));
                return Err(self.refuse(
                    place.map(|[x, y]| self.face.surface.point_at(x / self.scale[0], y / self.scale[1])),
                ));
            }
            let area = self.area(&chain);
            if area > 0.0 {
                let steps: Vec<Step> = chain.iter().filter_map(|h| self.step(*h)).collect();
                let curves = steps.iter().map(|s| s.curve.clone()).collect();
                let outline = Outline::new(&crate::curve::chained(curves, 0.0), &Plane::XY);
                outer.push((area, steps, outline, chain));
            } else {
                holes.push(chain);
            }
        }
        outer.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut out: Vec<Loops> = outer.iter().map(|o| vec![o.1.clone()]).collect();
        for hole in holes {
            let Some(&first) = hole.first() else { continue };
            let [x, y] = self.along(first, 0.5);
            let uv = [x / self.scale[0], y / self.scale[1]];
            // Not the loop on the other side of the same pieces.
            let owner = outer.iter().position(|(_, _, outline, chain)| {
                !hole.iter().any(|h| chain.contains(&(h ^ 1))) && outline.winding(uv) != 0
            });
            let Some(loops) = owner.and_then(|o| out.get_mut(o)) else {
                return Err(self.refuse(Some(self.face.surface.point_at(uv[0], uv[1]))));
            };
            loops.push(hole.iter().filter_map(|h| self.step(*h)).collect());
        }
        Ok(out)
    }
}
