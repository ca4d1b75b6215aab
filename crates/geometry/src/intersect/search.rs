//! The search for contacts: pairs of parts are discarded, settled or halved.

use super::CurveIntersections;
use super::judge::{Verdict, judge, runs_along, side_by_side};
use super::thresholds::{CONVERGED, IN_RANGE, LAST_STEP, LEFT, NO_BETTER, SHORT_PART};
use super::tree::{Node, Tree};
use crate::curve::{Piece, Shape};
use crate::{Vector3, cancellation};

/// A place, or a stretch, where two curves were found within the tolerance of each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// The range on the first curve, by the whole curve's parameter; increasing.
    pub(super) a: [f64; 2],
    /// The range on the second curve, increasing.
    pub(super) b: [f64; 2],
    /// Where the curves are nearest, as far as known.
    pub(super) best: (f64, f64),
    /// How near.
    pub(super) gap: f64,
    /// A single common point, proved and polished.
    pub(super) root: bool,
    /// How far beyond its range on each curve another contact still belongs to the same place.
    pub(super) reach: [f64; 2],
}

/// The search in one pair of trees, or in one tree against itself.
pub(super) struct Search<'a> {
    first: Tree<'a>,
    /// `None` when a curve meets itself.
    second: Option<Tree<'a>>,
    /// Whether the curve that meets itself is closed.
    closed: bool,
    pub(super) tolerance: f64,
    pub(super) contacts: Vec<Contact>,
    pub(super) visits: u64,
    /// What has been done, in looks at two boxes.
    work: u64,
    pub(super) complete: bool,
    stack: Vec<(u32, u32)>,
}

/// So much work and no more: some tenths of a second, and more for curves of many pieces.
const BUDGET: u64 = 14_000_000;
const BUDGET_A_PIECE: u64 = 20;

/// No more contacts than this are kept.
const MOST_CONTACTS: usize = 800_000;

/// The smallest tolerance that rounding lets one ask for, as a part of the largest coordinate.
pub(super) const NOISE: f64 = 8e-15;

impl<'a> Search<'a> {
    pub(super) fn pair(a: Vec<Piece<'a>>, b: Vec<Piece<'a>>, tolerance: f64) -> Self {
        Self::new(Tree::new(a), Some(Tree::new(b)), false, tolerance)
    }

    pub(super) fn own(a: Vec<Piece<'a>>, closed: bool, tolerance: f64) -> Self {
        Self::new(Tree::new(a), None, closed, tolerance)
    }

    fn new(first: Tree<'a>, second: Option<Tree<'a>>, closed: bool, tolerance: f64) -> Self {
        let scale = second.as_ref().map_or(first.scale, |t| t.scale.max(first.scale));
        let tolerance = tolerance.max(NOISE * scale).max(f64::MIN_POSITIVE);
        let (contacts, stack) = (Vec::new(), Vec::new());
        Self { first, second, closed, tolerance, contacts, visits: 0, work: 0, complete: true, stack }
    }

    pub(super) fn pieces(&self) -> (&[Piece<'a>], &[Piece<'a>]) {
        (&self.first.pieces, self.second.as_ref().map_or(&self.first.pieces, |t| &t.pieces))
    }

    /// The answer so far, without contacts.
    pub(super) fn summary(&self) -> CurveIntersections {
        let (crossings, overlaps) = (Vec::new(), Vec::new());
        CurveIntersections { crossings, overlaps, complete: self.complete, visits: self.visits }
    }

    fn second(&self) -> &Tree<'a> {
        self.second.as_ref().unwrap_or(&self.first)
    }

    /// Finds all contacts, or stops when the budget is spent.
    pub(super) fn run(&mut self) {
        if self.first.nodes.is_empty() || self.second().nodes.is_empty() {
            return;
        }
        let pieces = (self.first.pieces.len() + self.second().pieces.len()) as u64;
        let budget = BUDGET.saturating_add(pieces.saturating_mul(BUDGET_A_PIECE));
        self.stack.push((self.first.root, self.second().root));
        while let Some((ia, ib)) = self.stack.pop() {
            self.visits += 1;
            self.work += 1;
            let given_up = self.visits.is_multiple_of(1024) && cancellation::check().is_err();
            if given_up || self.work > budget || self.contacts.len() > MOST_CONTACTS {
                self.complete = false;
                self.stack.clear();
                return;
            }
            self.visit(ia, ib);
        }
    }

    fn visit(&mut self, ia: u32, ib: u32) {
        let (a, b) = (self.first.nodes[ia as usize], self.second().nodes[ib as usize]);
        if self.second.is_none() && ia == ib {
            return self.visit_itself(ia, &a);
        }
        if a.apart(&b, self.tolerance) {
            return;
        }
        let (Some(pa), Some(pb)) = (a.piece(), b.piece()) else {
            // Runs of pieces: open the run, of two the larger.
            let open_a = a.piece().is_none() && (b.piece().is_some() || a.size_squared() >= b.size_squared());
            self.open(ia, ib, open_a, !open_a);
            return;
        };
        let pairs = u64::from(a.pairs_of_points(&b));
        self.work += 1 + pairs / 4;
        let verdict = judge(self.first.hull(&a), self.second().hull(&b), self.tolerance);
        if verdict == Verdict::Apart {
            return;
        }
        if self.second.is_none() && self.neighbours(&a, pa, &b, pb) {
            // They share a joint: other common points are what counts.
            let small = a.size_squared().max(b.size_squared()) <= self.tolerance * self.tolerance;
            match verdict {
                Verdict::Single(..) | Verdict::Corner(..) => return,
                _ if small => return,
                Verdict::Parallel { opposite: false, .. } => {
                    self.open(ia, ib, true, true);
                    return;
                }
                _ => {}
            }
        }
        let (pa, pb) = (self.first.pieces[pa], self.second().pieces[pb]);
        let (sa, sb) = (a.size_squared(), b.size_squared());
        if sa.max(sb) <= self.tolerance * self.tolerance {
            return self.whole(&a, &b, pa, pb);
        }
        let verdict = match verdict {
            Verdict::Single(s, t) => {
                self.work += (pairs * pairs / 5).min(240);
                if let Some(contact) = crossing(&pa, &a, &pb, &b, (s, t), self.tolerance) {
                    self.contacts.push(contact);
                    return;
                }
                // No crossing, but perhaps near each other all along.
                side_by_side(self.first.hull(&a), self.second().hull(&b), self.tolerance)
            }
            other => other,
        };
        match verdict {
            Verdict::Apart => return,
            Verdict::Corner(last_a, last_b) => {
                let u = if last_a { a.to } else { a.from };
                let v = if last_b { b.to } else { b.from };
                let gap = pa.point(u).distance_to(pb.point(v));
                if gap <= 4.0 * self.tolerance {
                    self.add(&pa, [u, u], &pb, [v, v], (u, v), gap);
                }
                return;
            }
            Verdict::Parallel { along, opposite, low, high } => {
                self.visits += 2;
                self.work += 8;
                if self.beside(&a, &b, (along, opposite, low, high)) {
                    self.work += 8 + 11 * pairs;
                    return;
                }
            }
            Verdict::Single(..) | Verdict::Unclear => {}
        }
        if !self.open(ia, ib, sa >= 0.25 * sb, sb >= 0.25 * sa) {
            self.whole(&a, &b, pa, pb);
        }
    }

    /// A part against itself: nothing when it runs in one direction, else its halves.
    fn visit_itself(&mut self, i: u32, node: &Node) {
        if node.piece().is_some() {
            let hull = self.first.hull(node);
            let (Some(p), Some(q)) = (hull.first(), hull.last()) else { return };
            let small = node.size_squared() <= self.tolerance * self.tolerance;
            if small || (*q - *p).unitized().is_some_and(|d| runs_along(hull, d, 1.0)) {
                return;
            }
        }
        if let Some((l, r)) = self.first.children(i) {
            self.stack.extend([(l, r), (l, l), (r, r)]);
        }
    }

    /// Whether two parts of one curve follow each other.
    fn neighbours(&self, a: &Node, pa: usize, b: &Node, pb: usize) -> bool {
        let pieces = &self.first.pieces;
        let own = |i: usize| pieces[i].own;
        let follows = |x: &Node, px: usize, y: &Node, py: usize| {
            (px == py && x.to == y.from)
                || (px + 1 == py && x.to == own(px).end && y.from == own(py).start)
                || (self.closed
                    && px + 1 == pieces.len()
                    && py == 0
                    && x.to == own(px).end
                    && y.from == own(py).start)
        };
        follows(a, pa, b, pb) || follows(b, pb, a, pa)
    }

    /// Puts the halves on the stack; `false` when there are none.
    fn open(&mut self, ia: u32, ib: u32, open_a: bool, open_b: bool) -> bool {
        let a = if open_a { self.first.children(ia) } else { None };
        let b = match &mut self.second {
            _ if !open_b => None,
            Some(tree) => tree.children(ib),
            None => self.first.children(ib),
        };
        match (a, b) {
            (Some((l, r)), Some((m, n))) => self.stack.extend([(r, n), (r, m), (l, n), (l, m)]),
            (Some((l, r)), None) => self.stack.extend([(r, ib), (l, ib)]),
            (None, Some((m, n))) => self.stack.extend([(ia, n), (ia, m)]),
            (None, None) => return false,
        }
        true
    }

    /// Records two parts, each no larger than the tolerance, as one contact.
    fn whole(&mut self, a: &Node, b: &Node, pa: Piece<'a>, pb: Piece<'a>) {
        let (u, v) = (0.5 * (a.from + a.to), 0.5 * (b.from + b.to));
        let gap = pa.point(u).distance_to(pb.point(v));
        self.add(&pa, [a.from, a.to], &pb, [b.from, b.to], (u, v), gap);
    }

    fn add(&mut self, pa: &Piece<'a>, u: [f64; 2], pb: &Piece<'a>, v: [f64; 2], best: (f64, f64), gap: f64) {
        let ends = |piece: &Piece<'a>, u: [f64; 2]| {
            let [x, y] = u.map(|u| piece.whole_parameter(u));
            [x.min(y), x.max(y)]
        };
        let reach = |piece: &Piece<'a>, u: [f64; 2]| {
            let slowest = u.map(|u| piece.jet(u)[1].length()).into_iter().fold(f64::INFINITY, f64::min);
            reach_of(piece, slowest, self.tolerance)
        };
        self.contacts.push(Contact {
            a: ends(pa, u),
            b: ends(pb, v),
            best: (pa.whole_parameter(best.0), pb.whole_parameter(best.1)),
            gap,
            root: false,
            reach: [reach(pa, u), reach(pb, v)],
        });
    }

    /// Whether two parts that run in one direction lie within the tolerance of each other all along what they share
    /// of it: then that is recorded. The ends decide first; then as many places between them as a curve of such a
    /// degree has room to wind.
    fn beside(&mut self, a: &Node, b: &Node, side: (Vector3, bool, f64, f64)) -> bool {
        let (along, opposite, low, high) = side;
        let (Some(ia), Some(ib)) = (a.piece(), b.piece()) else { return false };
        let (pa, pb) = (self.first.pieces[ia], self.second().pieces[ib]);
        let tolerance = self.tolerance;
        let turned = if opposite { (b.to, b.from) } else { (b.from, b.to) };
        let mut ends = [(0.0, 0.0); 2];
        let mut least = (f64::INFINITY, 0.0, 0.0);
        let mut most = 0.0_f64;
        let mut take = |u: f64, v: f64| {
            let gap = pa.point(u).distance_to(pb.point(v));
            if gap < least.0 {
                least = (gap, u, v);
            }
            most = most.max(gap);
            gap <= 1.25 * tolerance
        };
        for (k, x) in [low, high].into_iter().enumerate() {
            let u = level(&pa, (a.from, a.to), along, x);
            let v = level(&pb, turned, along, x);
            ends[k] = (u, v);
            if !take(u, v) {
                return false;
            }
        }
        let (u0, u1) = (ends[0].0, ends[1].0);
        let places = 2 * degree(&pa).max(degree(&pb)) + 2;
        for k in 1..places {
            let u = u0 + (u1 - u0) * k as f64 / places as f64;
            let x = pa.point(u).to_vector().dot(along);
            if !take(u, level(&pb, turned, along, x)) {
                return false;
            }
        }
        // Just outside the tolerance is settled only where the curves do not come near each other: no crossing may
        // be lost, and no part need be halved for ever along the border.
        if most > tolerance && least.0 < 0.5 * tolerance {
            return false;
        }
        let (gap, u, v) = least;
        self.add(&pa, [u0, u1], &pb, [ends[0].1, ends[1].1], (u, v), gap);
        true
    }
}

fn degree(piece: &Piece<'_>) -> usize {
    match piece.shape {
        Shape::Segment(..) => 1,
        Shape::Arc(_) => 2,
        Shape::Span(curve, _) => curve.degree(),
    }
}

/// The step of parameter that leads some tolerances along a curve, by its speed in the piece's own parameter.
fn reach_of(piece: &Piece<'_>, speed: f64, tolerance: f64) -> f64 {
    let own = (4.0 * tolerance / speed).min(SHORT_PART * piece.own.length().abs());
    own * (piece.whole.length() / piece.own.length()).abs()
}

/// The parameter in a range at which a piece that runs along a direction reaches level `x`, or the nearer end.
fn level(piece: &Piece<'_>, (from, to): (f64, f64), along: Vector3, x: f64) -> f64 {
    let height = |u: f64| piece.point(u).to_vector().dot(along) - x;
    let (mut low, mut high) = (from, to);
    let (h0, h1) = (height(low), height(high));
    if !(h0 < 0.0) {
        return from;
    }
    if !(h1 > 0.0) {
        return to;
    }
    let mut u = low + (high - low) * (h0 / (h0 - h1));
    for _ in 0..60 {
        let [p, d, _] = piece.jet(u);
        let h = p.dot(along) - x;
        if h == 0.0 {
            break;
        }
        if h < 0.0 {
            low = u;
        } else {
            high = u;
        }
        let mut next = u - h / d.dot(along);
        if !(low.min(high) < next && next < low.max(high)) {
            next = 0.5 * (low + high);
        }
        if (next - u).abs() <= LAST_STEP * (to - from).abs() {
            return next;
        }
        u = next;
    }
    u
}

/// Newton's method on a(s) − b(t) in the plane of both tangents, which is Gauss–Newton on the distance in space; the
/// result is accepted inside both ranges, or a hair outside where the neighbour may miss it by rounding.
fn crossing(
    pa: &Piece<'_>,
    a: &Node,
    pb: &Piece<'_>,
    b: &Node,
    guess: (f64, f64),
    tolerance: f64,
) -> Option<Contact> {
    let (wa, wb) = (a.to - a.from, b.to - b.from);
    let window = |from: f64, width: f64, u: f64| {
        let x = (u - from) / width;
        (-0.25..=1.25).contains(&x)
    };
    let mut s = a.from + wa * guess.0.clamp(-0.2, 1.2);
    let mut t = b.from + wb * guess.1.clamp(-0.2, 1.2);
    let mut last = f64::INFINITY;
    let mut found = None;
    for _ in 0..24 {
        let ([p, da, _], [q, db, _]) = (pa.jet(s), pb.jet(t));
        let r = q - p;
        let n = da.cross(db);
        let nn = n.length_squared();
        if !(nn > 0.0) {
            return None;
        }
        let (ds, dt) = (r.cross(db).dot(n) / nn, r.cross(da).dot(n) / nn);
        let step = (ds / wa).abs().max((dt / wb).abs());
        found = Some((s, t, r.length(), da.length(), db.length()));
        if !(step < last) && step < NO_BETTER {
            break;
        }
        last = step;
        (s, t) = (s + ds, t + dt);
        if !(window(a.from, wa, s) && window(b.from, wb, t)) {
            return None;
        }
        if step < CONVERGED {
            // Quadratic: the step taken was the last that rounding lets one see.
            found = Some((s, t, pa.point(s).distance_to(pb.point(t)), da.length(), db.length()));
            break;
        }
    }
    let (s, t, _, va, vb) = found?;
    if last > LEFT {
        return None;
    }
    let settle = |u: f64, from: f64, to: f64, own: crate::Interval| {
        let slack = IN_RANGE * own.length().abs();
        let inside = from.min(to) - slack <= u && u <= from.max(to) + slack;
        inside.then(|| own.clamp(u))
    };
    let (s, t) = (settle(s, a.from, a.to, pa.own)?, settle(t, b.from, b.to, pb.own)?);
    let gap = pa.point(s).distance_to(pb.point(t));
    if !(gap <= tolerance) {
        return None;
    }
    let (u, v) = (pa.whole_parameter(s), pb.whole_parameter(t));
    let reach = [reach_of(pa, va, tolerance), reach_of(pb, vb, tolerance)];
    Some(Contact { a: [u, u], b: [v, v], best: (u, v), gap, root: true, reach })
}
