//! Curve with surface.

use super::ContactKind;
use super::curve_curve::check;
use super::judge::separated;
use super::patch_tree::{PatchNode, PatchTree};
use super::search::NOISE;
use super::tree::{Node, Tree};
use crate::curve::Piece;
use crate::nurbs::project;
use crate::{Curve, Direction, Interval, NurbsSurface, Point3, Result, Vector3};

/// A point that a curve and a surface have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceCrossing {
    /// The parameter on the curve.
    pub t: f64,
    /// The parameters on the surface.
    pub u: f64,
    /// See `u`.
    pub v: f64,
    /// The point halfway between curve and surface there.
    pub point: Point3,
    /// The distance between them there, at most the tolerance.
    pub gap: f64,
    /// Whether the curve pierces the surface or touches it.
    pub kind: ContactKind,
}

/// A stretch of a curve that lies in a surface, within the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceOverlap {
    /// The range on the curve, increasing.
    pub t: Interval,
    /// The surface's u and v where the stretch begins.
    pub from: [f64; 2],
    /// The surface's u and v where the stretch ends.
    pub to: [f64; 2],
}

/// All that a curve and a surface have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceIntersections {
    /// The points, sorted by the parameter on the curve.
    pub crossings: Vec<SurfaceCrossing>,
    /// The stretches, sorted likewise.
    pub overlaps: Vec<SurfaceOverlap>,
    /// Whether the search came to its end; see [`super::CurveIntersections::complete`].
    pub complete: bool,
    /// The pairs of parts that were looked at.
    pub visits: u64,
}

/// All points and stretches that a curve and a NURBS surface have in common within `tolerance`.
///
/// **Complete** in the sense of [`super::curve_curve`]: spans of the curve and Bézier patches are discarded when hulls
/// of control points prove them further apart than the tolerance; settled when all differences of their control
/// points, along the curve, along u and along v, prove that they share at most one point and Newton's method in three
/// unknowns finds it; all else is halved. Crossings are polished to rounding. A touch is listed once; a stretch of the
/// curve in the surface is an overlap, also where it is only as long as a part of a span.
///
/// The tolerance and the bound on the work are those of [`super::curve_curve`]. On closed surfaces a point of the
/// seam counts once, with the smaller parameter.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_surface(curve: &Curve, surface: &NurbsSurface, tolerance: f64) -> Result<SurfaceIntersections> {
    check(tolerance)?;
    let tree = Tree::new(curve.pieces());
    let patches = PatchTree::new(surface)?;
    let scale = tree.scale.max(patches.scale);
    let tolerance = tolerance.max(NOISE * scale).max(f64::MIN_POSITIVE);
    let mut search = Search {
        tree,
        patches,
        tolerance,
        limit: 1_000_000,
        visits: 0,
        complete: true,
        contacts: Vec::new(),
        stack: Vec::new(),
        domain: Direction::BOTH.map(|d| surface.domain(d)),
    };
    search.run();
    Ok(search.read(curve.domain()))
}

/// A place, or a stretch, where curve and surface were found within the tolerance of each other.
#[derive(Debug, Clone, Copy)]
struct Contact {
    /// The range on the curve, by the whole curve's parameter.
    t: [f64; 2],
    best: f64,
    uv: [f64; 2],
    gap: f64,
    root: bool,
    /// How far beyond its range another contact still belongs to it.
    reach: f64,
}

struct Search<'a> {
    tree: Tree<'a>,
    patches: PatchTree,
    tolerance: f64,
    limit: u64,
    visits: u64,
    complete: bool,
    contacts: Vec<Contact>,
    stack: Vec<(u32, u32)>,
    domain: [Interval; 2],
}

/// What control points prove.
enum Verdict {
    Apart,
    Single,
    Unclear,
}

impl Search<'_> {
    fn run(&mut self) {
        if self.tree.nodes.is_empty() || self.patches.nodes.is_empty() {
            return;
        }
        self.stack.push((self.tree.root, self.patches.root));
        while let Some((ic, ip)) = self.stack.pop() {
            self.visits += 1;
            if self.visits > self.limit {
                self.complete = false;
                return;
            }
            self.visit(ic, ip);
        }
    }

    fn visit(&mut self, ic: u32, ip: u32) {
        let (c, p) = (self.tree.nodes[ic as usize], self.patches.nodes[ip as usize]);
        let reach = self.tolerance;
        if (0..3).any(|k| c.min[k] - p.max[k] > reach || p.min[k] - c.max[k] > reach) {
            return;
        }
        let (sc, sp) = (c.size_squared(), p.size_squared());
        let (Some(piece), Some(patch)) = (c.piece(), p.patch()) else {
            let open_curve = c.piece().is_none() && (p.patch().is_some() || sc >= sp);
            self.open(ic, ip, open_curve);
            return;
        };
        let verdict = self.judge(&c, &p);
        let piece = self.tree.pieces[piece];
        match verdict {
            Verdict::Apart => return,
            Verdict::Single => {
                if let Some(contact) = self.crossing(&piece, &c, &p, patch) {
                    self.contacts.push(contact);
                    return;
                }
            }
            Verdict::Unclear => {}
        }
        if sc.max(sp) <= self.tolerance * self.tolerance {
            self.add(&piece, [c.from, c.to], &p, patch);
            return;
        }
        if self.inside(&piece, &c, &p, patch) {
            return;
        }
        if !self.open(ic, ip, sc >= sp) && !self.open(ic, ip, sc < sp) {
            self.add(&piece, [c.from, c.to], &p, patch);
        }
    }

    fn open(&mut self, ic: u32, ip: u32, curve: bool) -> bool {
        if curve {
            let Some((l, r)) = self.tree.children(ic) else { return false };
            self.stack.extend([(r, ip), (l, ip)]);
        } else {
            let Some((l, r)) = self.patches.children(ip) else { return false };
            self.stack.extend([(ic, r), (ic, l)]);
        }
        true
    }

    /// Hulls apart, or, in coordinates along the mean directions of curve, u and v, differences of control points
    /// that keep to their axis so strictly that no chord of the curve is one of the patch.
    fn judge(&self, c: &Node, p: &PatchNode) -> Verdict {
        let hull = self.tree.hull(c);
        let grid = self.patches.points(p);
        let [n, m] = self.patches.counts;
        let mut net = [Vector3::ZERO; 64];
        let mut heap = Vec::new();
        let net: &[Vector3] = if grid.len() <= 64 {
            for (to, from) in net.iter_mut().zip(grid) {
                *to = project(*from).to_vector();
            }
            &net[..grid.len()]
        } else {
            heap.extend(grid.iter().map(|&q| project(q).to_vector()));
            &heap
        };
        let (Some(&first), Some(&last)) = (hull.first(), hull.last()) else { return Verdict::Unclear };
        let [q00, q01, q10, q11] = [net[0], net[m - 1], net[(n - 1) * m], net[n * m - 1]];
        let u = (q10 - q00 + q11 - q01) * 0.5;
        let v = (q01 - q00 + q11 - q10) * 0.5;
        let d = last - first;
        let normal = u.cross(v);
        let between = (q00 + q01 + q10 + q11) * 0.25 - (first + last) * 0.5;
        let squared = d.length_squared();
        let side = if squared > 0.0 { between - d * (between.dot(d) / squared) } else { between };
        for axis in [normal, side, d.cross(u), d.cross(v)] {
            if separated(hull, net, axis, self.tolerance) {
                return Verdict::Apart;
            }
        }
        let determinant = normal.dot(d);
        if !(determinant.abs() > 1e-9 * normal.length() * d.length()) || determinant == 0.0 {
            return Verdict::Unclear;
        }
        // Rows of the inverse of (u v d).
        let rows = [v.cross(d) / determinant, d.cross(u) / determinant, normal / determinant];
        let keeps = |w: Vector3, axis: usize, slack: f64| {
            let x = rows.map(|r| r.dot(w));
            let size: f64 = x.iter().map(|x| x.abs()).sum();
            // x > the others and what the weights can add.
            w == Vector3::ZERO && slack == 0.0
                || x[axis] > 1.000_001 * (size - x[axis].abs()) + 1e-9 * size + slack
        };
        if !hull.windows(2).all(|w| keeps(w[1] - w[0], 2, 0.0)) {
            return Verdict::Unclear;
        }
        // Along u: ΔA − SΔw for homogeneous points A and any point S of the patch; S is the middle, give or take.
        let middle = (q00 + q01 + q10 + q11) * 0.25;
        let radius = net.iter().map(|q| (*q - middle).length()).fold(0.0, f64::max);
        let factor: f64 = rows.iter().map(|r| r.length()).sum();
        let slope = |a: usize, b: usize| {
            let (wa, wb) = (grid[a][3], grid[b][3]);
            let w = (net[b] - middle) * wb - (net[a] - middle) * wa;
            (w, (wb - wa).abs() * radius * factor * 2.0)
        };
        for i in 0..n {
            for j in 0..m {
                if i + 1 < n {
                    let (w, slack) = slope(i * m + j, (i + 1) * m + j);
                    if !keeps(w, 0, slack) {
                        return Verdict::Unclear;
                    }
                }
                if j + 1 < m {
                    let (w, slack) = slope(i * m + j, i * m + j + 1);
                    if !keeps(w, 1, slack) {
                        return Verdict::Unclear;
                    }
                }
            }
        }
        Verdict::Single
    }

    /// Newton's method on C(t) − S(u, v).
    fn crossing(&self, piece: &Piece<'_>, c: &Node, p: &PatchNode, patch: usize) -> Option<Contact> {
        let patch = &self.patches.patches[patch];
        let mut x = [
            0.5 * (c.from + c.to),
            0.5 * (p.ranges[0][0] + p.ranges[0][1]),
            0.5 * (p.ranges[1][0] + p.ranges[1][1]),
        ];
        let ranges = [[c.from, c.to], p.ranges[0], p.ranges[1]];
        let mut small = false;
        for _ in 0..24 {
            let [q, d, _] = piece.jet(x[0]);
            let [s, su, sv] = patch.jet([x[1], x[2]]);
            let r = q - s;
            let n = su.cross(sv);
            let determinant = n.dot(d);
            if determinant == 0.0 {
                return None;
            }
            // C + C′ dt = S + Su du + Sv dv.
            let dt = -r.dot(n) / determinant;
            let w = r + d * dt;
            let nn = n.length_squared();
            let du = w.cross(sv).dot(n) / nn;
            let dv = su.cross(w).dot(n) / nn;
            let steps = [dt, du, dv];
            let mut largest = 0.0_f64;
            for k in 0..3 {
                let width = ranges[k][1] - ranges[k][0];
                x[k] += steps[k];
                largest = largest.max((steps[k] / width).abs());
                let off = (x[k] - ranges[k][0]) / width;
                if !(-1.0..=2.0).contains(&off) {
                    return None;
                }
            }
            if small {
                break;
            }
            small = largest < 1e-9;
        }
        if !small {
            return None;
        }
        let wholes = [piece.own, patch.domain[0], patch.domain[1]];
        for k in 0..3 {
            let slack = 1e-12 * wholes[k].length().abs();
            let [a, b] = ranges[k];
            if !(a.min(b) - slack <= x[k] && x[k] <= a.max(b) + slack) {
                return None;
            }
            x[k] = wholes[k].clamp(x[k]);
        }
        let gap = (piece.jet(x[0])[0] - patch.jet([x[1], x[2]])[0]).length();
        if !(gap <= self.tolerance) {
            return None;
        }
        let t = piece.whole_parameter(x[0]);
        Some(Contact {
            t: [t, t],
            best: t,
            uv: [x[1], x[2]],
            gap,
            root: true,
            reach: self.reach(piece, x[0]),
        })
    }

    /// The step of the whole curve's parameter that leads some tolerances along it.
    fn reach(&self, piece: &Piece<'_>, u: f64) -> f64 {
        let own = piece.own.length().abs();
        let step = (4.0 * self.tolerance / piece.jet(u)[1].length()).min(1e-3 * own);
        step * piece.whole.length() / own
    }

    /// Records a part as one contact, by its nearest place to the patch.
    fn add(&mut self, piece: &Piece<'_>, t: [f64; 2], p: &PatchNode, patch: usize) {
        let u = 0.5 * (t[0] + t[1]);
        let start = p.ranges.map(|[a, b]| 0.5 * (a + b));
        let (uv, gap) = self.foot(patch, piece.point(u), start);
        let ends = t.map(|t| piece.whole_parameter(t));
        let reach = self.reach(piece, t[0]).max(self.reach(piece, t[1]));
        let t = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.contacts.push(Contact { t, best: piece.whole_parameter(u), uv, gap, root: false, reach });
    }

    /// The place of a patch nearest to `q`, as far as Gauss–Newton from `start` shows it, and its distance.
    fn foot(&self, patch: usize, q: Point3, start: [f64; 2]) -> ([f64; 2], f64) {
        let patch = &self.patches.patches[patch];
        let q = q.to_vector();
        let mut uv = start;
        let mut best = (start, f64::INFINITY);
        for _ in 0..20 {
            let [s, su, sv] = patch.jet(uv);
            let r = q - s;
            let gap = r.length();
            if !(gap < best.1) {
                break;
            }
            best = (uv, gap);
            let (a, b, d) = (su.dot(su), su.dot(sv), sv.dot(sv));
            let (e, f) = (r.dot(su), r.dot(sv));
            let determinant = a * d - b * b;
            let clamp = |k: usize, x: f64| patch.domain[k].clamp(x);
            let mut next = [
                clamp(0, uv[0] + (e * d - f * b) / determinant),
                clamp(1, uv[1] + (f * a - e * b) / determinant),
            ];
            // At a border the other parameter goes on alone.
            if next[0] == patch.domain[0].start || next[0] == patch.domain[0].end {
                let left = f - b * (next[0] - uv[0]);
                next[1] = clamp(1, uv[1] + left / d);
            } else if next[1] == patch.domain[1].start || next[1] == patch.domain[1].end {
                let left = e - b * (next[1] - uv[1]);
                next[0] = clamp(0, uv[0] + left / a);
            }
            if !next.iter().all(|x| x.is_finite()) || next == uv {
                break;
            }
            uv = next;
        }
        best
    }

    /// Whether a part of the surface is so flat that no point has two feet on it: in coordinates along its mean
    /// directions and its normal, all differences of control points keep to their axis.
    fn is_graph(&self, p: &PatchNode) -> bool {
        let grid = self.patches.points(p);
        let [n, m] = self.patches.counts;
        let at = |i: usize, j: usize| grid.get(i * m + j).map_or(Vector3::ZERO, |&q| project(q).to_vector());
        let u = at(n - 1, 0) - at(0, 0) + at(n - 1, m - 1) - at(0, m - 1);
        let v = at(0, m - 1) - at(0, 0) + at(n - 1, m - 1) - at(n - 1, 0);
        let (Some(u), Some(v)) = (u.unitized(), v.unitized()) else { return false };
        let Some(normal) = u.cross(v).unitized() else { return false };
        let determinant = u.cross(v).dot(normal);
        let rows = [v.cross(normal) / determinant, normal.cross(u) / determinant, normal];
        let keeps = |w: Vector3, axis: usize| {
            let x = rows.map(|r| r.dot(w));
            x[axis] >= 1.2 * (x.iter().map(|x| x.abs()).sum::<f64>() - x[axis].abs())
        };
        (0..n).all(|i| {
            (0..m).all(|j| {
                (i + 1 == n || keeps(at(i + 1, j) - at(i, j), 0))
                    && (j + 1 == m || keeps(at(i, j + 1) - at(i, j), 1))
            })
        })
    }

    /// Whether a part of the curve lies within the tolerance of a flat part of the surface all along: at its ends,
    /// and at as many places between as the degrees leave room to wind. Then that is recorded, and because no point
    /// has a second foot there, nothing is left to find.
    fn inside(&mut self, piece: &Piece<'_>, c: &Node, p: &PatchNode, patch: usize) -> bool {
        let hull = self.tree.hull(c);
        let (Some(&first), Some(&last)) = (hull.first(), hull.last()) else { return false };
        if !super::judge::runs_along(hull, last - first, 1.0) {
            return false;
        }
        let [n, m] = self.patches.counts;
        let places = (n + m) * hull.len();
        let middle = p.ranges.map(|[a, b]| 0.5 * (a + b));
        let near = |uv: [f64; 2]| {
            (0..2).all(|k| (uv[k] - middle[k]).abs() <= 0.75 * (p.ranges[k][1] - p.ranges[k][0]))
        };
        let mut uv = middle;
        let mut best = (f64::INFINITY, c.from, uv);
        let mut most = 0.0_f64;
        self.visits += 1;
        // The ends first: they decide most cases.
        for k in [0, places].into_iter().chain(1..places) {
            let t = c.from + (c.to - c.from) * k as f64 / places as f64;
            let (at, gap) = self.foot(patch, piece.point(t), if k == places { middle } else { uv });
            if !(gap <= 1.25 * self.tolerance && near(at)) {
                return false;
            }
            if k == places && !self.is_graph(p) {
                return false;
            }
            uv = at;
            most = most.max(gap);
            if gap < best.0 {
                best = (gap, t, at);
            }
        }
        if most > self.tolerance && best.0 < 0.5 * self.tolerance {
            return false;
        }
        self.visits += 2;
        let ends = [c.from, c.to].map(|t| piece.whole_parameter(t));
        let reach = self.reach(piece, c.from).max(self.reach(piece, c.to));
        let (gap, t, uv) = best;
        let best = piece.whole_parameter(t);
        let t = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.contacts.push(Contact { t, best, uv, gap, root: false, reach });
        true
    }
}

impl Search<'_> {
    fn piece_at(&self, t: f64) -> Option<&Piece<'_>> {
        let pieces = &self.tree.pieces;
        pieces.get(pieces.partition_point(|p| p.whole.end <= t).min(pieces.len().wrapping_sub(1)))
    }

    fn point(&self, t: f64) -> Point3 {
        self.piece_at(t).map_or(Point3::ORIGIN, |p| p.point(p.own_parameter(t)))
    }

    /// The nearest place of the surface to the curve at `t`, from places found before.
    fn gap_at(&self, t: f64, near: &[Contact]) -> ([f64; 2], f64) {
        let q = self.point(t);
        let mut best = ([0.0; 2], f64::INFINITY);
        let off = |c: &Contact| (c.t[0] - t).max(t - c.t[1]).max(0.0) + 1e-3 * (c.best - t).abs();
        let mut nearest: [Option<&Contact>; 2] = [None; 2];
        for c in near {
            if nearest[0].is_none_or(|d| off(c) < off(d)) {
                nearest = [Some(c), nearest[0]];
            } else if nearest[1].is_none_or(|d| off(c) < off(d)) {
                nearest[1] = Some(c);
            }
        }
        for c in nearest.into_iter().flatten() {
            for (i, patch) in self.patches.patches.iter().enumerate() {
                let d = patch.domain;
                let hair = |k: usize| 1e-3 * d[k].length();
                let holds = |k: usize| d[k].start - hair(k) <= c.uv[k] && c.uv[k] <= d[k].end + hair(k);
                if holds(0) && holds(1) {
                    let found = self.foot(i, q, [d[0].clamp(c.uv[0]), d[1].clamp(c.uv[1])]);
                    if found.1 < best.1 {
                        best = found;
                    }
                }
            }
            if best.1 <= 1e-3 * self.tolerance {
                break;
            }
        }
        best
    }

    fn read(mut self, domain: Interval) -> SurfaceIntersections {
        let (mut crossings, mut overlaps) = (Vec::new(), Vec::new());
        let mut contacts = std::mem::take(&mut self.contacts);
        contacts.sort_by(|x, y| {
            (x.t[0] - x.reach).total_cmp(&(y.t[0] - y.reach)).then(x.uv[0].total_cmp(&y.uv[0]))
        });
        // One place: neighbours along the curve whose points of the surface are near each other.
        let mut places: Vec<([f64; 2], Vec<Contact>)> = Vec::new();
        for c in contacts {
            let joined = places.iter_mut().rev().take(16).find(|(t, members)| {
                let reach = members.iter().map(|m| m.reach).fold(c.reach, f64::max);
                t[0] <= c.t[1] + reach
                    && c.t[0] <= t[1] + reach
                    && (members.iter().all(|m| !m.root)
                        || !c.root
                        || members.iter().any(|m| (m.best - c.best).abs() <= 1e-10 * domain.length()))
            });
            match joined {
                Some((t, members)) => {
                    *t = [t[0].min(c.t[0]), t[1].max(c.t[1])];
                    members.push(c);
                }
                None => places.push((c.t, vec![c])),
            }
        }
        for (t, members) in &places {
            if !self.overlap(*t, members, domain, &mut overlaps) {
                crossings.extend(self.place(*t, members));
            }
        }
        crossings.sort_by(|x: &SurfaceCrossing, y| {
            x.t.total_cmp(&y.t).then(x.u.total_cmp(&y.u)).then(x.v.total_cmp(&y.v))
        });
        crossings.dedup_by(|later, first| {
            (later.t - first.t).abs() <= 1e-9 * domain.length()
                && later.point.distance_to(first.point) <= 4.0 * self.tolerance
        });
        overlaps.sort_by(|x: &SurfaceOverlap, y| x.t.start.total_cmp(&y.t.start));
        let covers = |t: f64| {
            overlaps.iter().any(|o| {
                let more = 1e-6 * domain.length();
                o.t.start - more <= t
                    && t <= o.t.end + more
                    && [o.t.clamp(t)]
                        .iter()
                        .all(|&s| self.point(s).distance_to(self.point(t)) <= 8.0 * self.tolerance)
            })
        };
        crossings.retain(|c| !covers(c.t));
        let (complete, visits) = (self.complete, self.visits);
        SurfaceIntersections { crossings, overlaps, complete, visits }
    }

    /// The stretch of a place that lies in the surface: one that ends where the curve or the surface does, or, where
    /// they part, one that before was far nearer than a touch is.
    fn overlap(
        &self,
        t: [f64; 2],
        members: &[Contact],
        domain: Interval,
        out: &mut Vec<SurfaceOverlap>,
    ) -> bool {
        let range = Interval::new(t[0], t[1]);
        let steps = 64;
        let places: Vec<f64> = (0..=steps).map(|k| range.at(f64::from(k) / f64::from(steps))).collect();
        let length: f64 = places.windows(2).map(|w| self.point(w[0]).distance_to(self.point(w[1]))).sum();
        if !(length > 4.0 * self.tolerance) {
            return false;
        }
        let reach = members.iter().map(|m| m.reach).fold(0.0, f64::max);
        let shut = |t: f64| {
            let slack = 1e-9 * domain.length() + reach;
            let ([u, v], _) = self.gap_at(t, members);
            let border = |d: Interval, x: f64| (x - d.start).min(d.end - x) <= 1e-7 * d.length();
            t - domain.start <= slack
                || domain.end - t <= slack
                || border(self.domain[0], u)
                || border(self.domain[1], v)
        };
        let limit = if shut(t[0]) && shut(t[1]) { self.tolerance } else { 1e-3 * self.tolerance };
        let limit = limit.max(NOISE * self.tree.scale.max(self.patches.scale));
        let within: Vec<bool> = places.iter().map(|&t| self.gap_at(t, members).1 <= limit).collect();
        let mut best = (0, 0);
        let mut k = 0;
        while k < within.len() {
            let end = (k..within.len()).find(|&i| !within[i]).unwrap_or(within.len());
            if end - k > best.1 - best.0 {
                best = (k, end);
            }
            k = end + 1;
        }
        if best.1 - best.0 < within.len() / 4 {
            return false;
        }
        // The ends to the last bit: joints and ends of the curve where they are near, else by halving.
        let refine = |good: f64, bad: Option<f64>| {
            let Some(mut bad) = bad else { return good };
            let mut good = good;
            for _ in 0..50 {
                let middle = 0.5 * (good + bad);
                if self.gap_at(middle, members).1 <= limit { good = middle } else { bad = middle }
            }
            good
        };
        let snap = |t: f64| {
            let stops = self.tree.pieces.iter().flat_map(|p| [p.whole.start, p.whole.end]);
            let near = stops.min_by(|x, y| (x - t).abs().total_cmp(&(y - t).abs())).unwrap_or(t);
            if self.point(near).distance_to(self.point(t)) <= 4.0 * self.tolerance { near } else { t }
        };
        let start = refine(places[best.0], best.0.checked_sub(1).map(|i| places[i]));
        let end = refine(places[best.1 - 1], places.get(best.1).copied());
        let (start, end) = (snap(start), snap(end));
        if !(start < end) {
            return false;
        }
        let (from, to) = (self.gap_at(start, members).0, self.gap_at(end, members).0);
        out.push(SurfaceOverlap { t: Interval::new(start, end), from, to });
        true
    }

    /// The crossing or touch of a place.
    fn place(&self, t: [f64; 2], members: &[Contact]) -> Option<SurfaceCrossing> {
        let finish = |t: f64, uv: [f64; 2], gap: f64, kind: ContactKind| {
            let q = self.point(t);
            let (uv, gap) = match self.gap_at(t, members) {
                (better, g) if g < gap => (better, g),
                _ => (uv, gap),
            };
            let s = self.patches.patches.iter().find(|p| (0..2).all(|k| p.domain[k].contains(uv[k])));
            let point = s.map_or(q, |s| q.lerp(s.jet(uv)[0].to_point(), 0.5));
            SurfaceCrossing { t, u: uv[0], v: uv[1], point, gap, kind }
        };
        if let Some(c) = members.iter().filter(|c| c.root).min_by(|x, y| x.gap.total_cmp(&y.gap)) {
            return Some(finish(c.best, c.uv, c.gap, ContactKind::Transversal));
        }
        // The least gap by golden section around the nearest place found.
        let steps = 32;
        let wide = members.iter().map(|m| m.reach).fold(t[1] - t[0], f64::max);
        let (first, last) = self.tree.pieces.first().zip(self.tree.pieces.last())?;
        let range = Interval::new((t[0] - wide).max(first.whole.start), (t[1] + wide).min(last.whole.end));
        let gap = |t: f64| self.gap_at(t, members).1;
        let samples = (0..=steps).map(|k| range.at(f64::from(k) / f64::from(steps)));
        let start =
            samples.chain(members.iter().map(|m| m.best)).min_by(|&x, &y| gap(x).total_cmp(&gap(y)))?;
        let width = range.length() / f64::from(steps);
        let (mut low, mut high) = ((start - width).max(range.start), (start + width).min(range.end));
        for _ in 0..60 {
            let (x, y) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if gap(x) <= gap(y) { high = y } else { low = x }
        }
        let middle = 0.5 * (low + high);
        let best =
            [start, middle, range.start, range.end].into_iter().min_by(|&x, &y| gap(x).total_cmp(&gap(y)))?;
        let (uv, least) = self.gap_at(best, members);
        if !(least <= self.tolerance) {
            return None;
        }
        let kind = self.kind(best, uv);
        Some(finish(best, uv, least, kind))
    }

    /// Tangent when the curve's direction lies in the tangent plane.
    fn kind(&self, t: f64, uv: [f64; 2]) -> ContactKind {
        let direction = self.piece_at(t).and_then(|p| p.jet(p.own_parameter(t))[1].unitized());
        let patch = self.patches.patches.iter().find(|p| (0..2).all(|k| p.domain[k].contains(uv[k])));
        let normal = patch.and_then(|p| {
            let [_, su, sv] = p.jet(uv);
            su.cross(sv).unitized()
        });
        match (direction, normal) {
            (Some(d), Some(n)) if d.dot(n).abs() > 1e-3 => ContactKind::Transversal,
            _ => ContactKind::Tangent,
        }
    }
}
