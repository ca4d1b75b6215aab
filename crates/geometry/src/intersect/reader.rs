//! From contacts of parts to crossings, touches and overlaps of curves.

use super::clusters::{Cluster, gather};
use super::result::{ContactKind, Crossing, CurveIntersections, Overlap};
use super::search::{Contact, NOISE};
use super::side::{Side, joints};
use super::thresholds::{
    AT_END, CROSSES, IN_RANGE, INSIDE, LAST_STEPS, NO_BEND, ON_OTHER, SAME_PARAMETER, SAME_ROOT, SAME_TOUCH,
};
use crate::Interval;
use crate::curve::curvature;

/// How much further than a contact's reach, which is some tolerances, a turn may be that belongs to it.
const NEAR_A_TURN: f64 = 16.0;

/// What the contacts amount to.
pub(super) struct Reader<'a> {
    pub(super) a: Side<'a>,
    pub(super) b: Side<'a>,
    pub(super) tolerance: f64,
    /// Whether both sides are the same curve.
    pub(super) itself: bool,
}

impl Reader<'_> {
    /// Reads all clusters, or until the purse is empty: then the result is not complete.
    pub(super) fn read(&self, contacts: Vec<Contact>, out: &mut CurveIntersections) {
        for mut cluster in gather(contacts, &self.a, &self.b) {
            if self.is_broke() {
                break;
            }
            if self.itself && self.is_diagonal(&cluster) {
                continue;
            }
            if let [only] = cluster.members.as_slice()
                && only.root
            {
                out.crossings.push(self.crossing(only.best.0, only.best.1, Some(ContactKind::Transversal)));
                continue;
            }
            cluster.sort();
            let before = out.overlaps.len();
            if !cluster.members.iter().all(|c| c.root) {
                self.overlaps(&cluster, &mut out.overlaps);
            }
            if out.overlaps.len() == before
                && !self.crossings(&cluster, &mut out.crossings)
                && !self.own_turn(&cluster)
            {
                out.crossings.extend(self.touch(&cluster));
            }
        }
        out.sort();
        self.drop_doubles(out);
        self.drop_shadows(&mut out.crossings);
        if !self.a.turns.is_empty() || !self.b.turns.is_empty() {
            join_overlaps(&mut out.overlaps, [self.a.domain, self.b.domain]);
            self.drop_at_turns(out);
        }
        out.complete &= !self.is_broke();
    }

    /// Whether there is no more to spend on places.
    fn is_broke(&self) -> bool {
        self.a.budget.get() == 0
    }

    /// The turn of a curve that meets itself at which a cluster's two ranges meet.
    fn turn_between(&self, cluster: &Cluster) -> Option<f64> {
        if !self.itself {
            return None;
        }
        let (low, high) = (cluster.a[1].min(cluster.b[1]), cluster.a[0].max(cluster.b[0]));
        let turn = self.a.turn_near(
            0.5 * (low + high),
            0.5 * (high - low).max(0.0) + SAME_PARAMETER * self.a.domain.length(),
        )?;
        let p = self.a.point(turn);
        let near = |t: f64| self.a.point(t).distance_to(p) <= 8.0 * self.tolerance;
        (near(low) && near(high)).then_some(turn)
    }

    /// Whether a contact of a curve with itself is only the tip of a cusp.
    fn own_turn(&self, cluster: &Cluster) -> bool {
        self.turn_between(cluster).is_some()
    }

    /// Crossings at turns: the same from both sides of one is one, and at the end of an overlap it is none.
    fn drop_at_turns(&self, out: &mut CurveIntersections) {
        let epsilon = [AT_END * self.a.domain.length(), AT_END * self.b.domain.length()];
        let mut kept: Vec<Crossing> = Vec::with_capacity(out.crossings.len());
        for c in out.crossings.drain(..) {
            let turn =
                self.a.turn_near(c.a, epsilon[0]).is_some() || self.b.turn_near(c.b, epsilon[1]).is_some();
            let within = |range: Interval, t: f64, epsilon: f64| {
                range.min() - epsilon <= t && t <= range.max() + epsilon
            };
            let same = |d: &Crossing| (d.a - c.a).abs() <= epsilon[0] && (d.b - c.b).abs() <= epsilon[1];
            self.a.pay(if turn { out.overlaps.len() / 16 } else { 0 });
            let known = turn
                && (kept.iter().rev().take(64).any(same)
                    || out
                        .overlaps
                        .iter()
                        .any(|o| within(o.a, c.a, epsilon[0]) && within(o.b, c.b, epsilon[1])));
            if !known {
                kept.push(c);
            }
        }
        out.crossings = kept;
    }

    /// A touch next to a crossing, where the curves have not parted in between, is that crossing's shadow: around a
    /// shallow one they stay within the tolerance for long.
    fn drop_shadows(&self, crossings: &mut Vec<Crossing>) {
        let weight = |c: &Crossing| (c.kind == ContactKind::Tangent, c.gap);
        let mut kept: Vec<Crossing> = Vec::with_capacity(crossings.len());
        for c in crossings.drain(..) {
            let touch = |x: &Crossing| x.kind == ContactKind::Tangent;
            match kept.last_mut() {
                Some(last)
                    if (touch(last) || touch(&c)) && self.within_between((last.a, last.b), (c.a, c.b)) =>
                {
                    let (old, new) = (weight(last), weight(&c));
                    if (new.0, new.1) < (old.0, old.1) {
                        *last = c;
                    }
                }
                _ => kept.push(c),
            }
        }
        *crossings = kept;
    }

    fn gap(&self, s: f64, t: f64) -> f64 {
        self.a.point(s).distance_to(self.b.point(t))
    }

    /// The crossing at two parameters; without a kind, by the directions there.
    fn crossing(&self, a: f64, b: f64, kind: Option<ContactKind>) -> Crossing {
        let (p, q) = (self.a.point(a), self.b.point(b));
        let kind = kind.unwrap_or_else(|| {
            let (u, v) = (self.a.jet(a)[1].unitized(), self.b.jet(b)[1].unitized());
            match (u, v) {
                (Some(u), Some(v)) if u.cross(v).length() > CROSSES => ContactKind::Transversal,
                _ => ContactKind::Tangent,
            }
        });
        Crossing { a, b, point: p.lerp(q, 0.5), gap: p.distance_to(q), kind }
    }

    /// Whether a contact of a curve with itself is only the curve's going on: everything between both parameters
    /// lies in the same place.
    fn is_diagonal(&self, cluster: &Cluster) -> bool {
        let (from, to) = (cluster.a[0].min(cluster.b[0]), cluster.a[1].max(cluster.b[1]));
        let all_near = |from: f64, to: f64| {
            let p = self.a.point(from);
            (0..=16).all(|k| {
                let t = Interval::new(from, to).at(f64::from(k) / 16.0);
                p.distance_to(self.a.point(t)) <= 8.0 * self.tolerance
            })
        };
        if all_near(from, to) {
            return true;
        }
        let Interval { start, end } = self.a.domain;
        let (low, high) = (cluster.a[1].min(cluster.b[1]), cluster.a[0].max(cluster.b[0]));
        self.a.closed && all_near(start, low) && all_near(high, end)
    }

    /// The parameter on the second curve that belongs to `s` on the first, in a cluster.
    fn partner(&self, cluster: &Cluster, s: f64) -> f64 {
        let (near, looks) = cluster.at(0, s);
        self.a.pay(looks / 8);
        let Some(c) = near else { return cluster.b[0] };
        let middle = 0.5 * (c.b[0] + c.b[1]);
        let q = self.a.point(s);
        // From the middle and from both ends, for stretches that run either way.
        let range = self.b.widened(cluster.b, NEAR_A_TURN * cluster.reach[1]);
        let tries = [middle, c.b[0], c.b[1]].map(|t| self.b.near(q, range, t));
        tries.into_iter().min_by(|&x, &y| self.gap(s, x).total_cmp(&self.gap(s, y))).unwrap_or(middle)
    }

    /// The first curve's parameter for one of the second, likewise.
    fn back(&self, cluster: &Cluster, t: f64) -> f64 {
        let (near, looks) = cluster.at(1, t);
        self.b.pay(looks / 8);
        let Some(c) = near else { return cluster.a[0] };
        let middle = 0.5 * (c.a[0] + c.a[1]);
        let q = self.b.point(t);
        let range = self.a.widened(cluster.a, NEAR_A_TURN * cluster.reach[0]);
        let tries = [middle, c.a[0], c.a[1]].map(|s| self.a.near(q, range, s));
        tries.into_iter().min_by(|&x, &y| self.gap(x, t).total_cmp(&self.gap(y, t))).unwrap_or(middle)
    }

    /// The stretches of a cluster along which the curves coincide.
    ///
    /// Two analytic pieces coincide until one of them ends, so that an overlap runs between joints (or ends) of
    /// either curve. Where a stretch within the tolerance does not end at a curve's end, the curves part there:
    /// what is no overlap but a touch tells itself by the gap, which between joints of an overlap is nothing.
    fn overlaps(&self, cluster: &Cluster, out: &mut Vec<Overlap>) {
        let [a0, a1] = cluster.a;
        if !(a0 < a1) {
            return;
        }
        let (b0, b1) = (self.partner(cluster, a0), self.partner(cluster, a1));
        let epsilon = |side: &Side<'_>, t: f64, reach: f64| {
            let d = side.domain;
            let slack = SAME_PARAMETER * d.length() + reach;
            t - d.start <= slack || d.end - t <= slack || side.turn_near(t, slack).is_some()
        };
        let shut = |s: f64, t: f64| {
            epsilon(&self.a, s, cluster.reach[0].min(AT_END * self.a.domain.length()))
                || epsilon(&self.b, t, cluster.reach[1].min(AT_END * self.b.domain.length()))
        };
        let both_shut = shut(a0, b0) && shut(a1, b1);
        let limit = if both_shut { self.tolerance } else { ON_OTHER * self.tolerance };
        let limit = limit.max(NOISE * self.scale());
        // Joints of both curves inside, and the ends where they are ends of a curve.
        let slack = SAME_PARAMETER * self.a.domain.length();
        let mut stops: Vec<(f64, f64)> = Vec::new();
        for (s, t) in [(a0, b0), (a1, b1)] {
            if both_shut || shut(s, t) {
                stops.push((s, t));
            }
        }
        for s in joints(self.a.pieces, cluster.a, cluster.reach[0]) {
            stops.push((s, self.partner(cluster, s)));
        }
        for t in joints(self.b.pieces, cluster.b, cluster.reach[1]) {
            stops.push((self.back(cluster, t), t));
        }
        // Where a curve stands still, parts of some tolerances are long in its parameter: the last contact may end
        // well before the turn.
        let distance = 4.0 * NEAR_A_TURN * self.tolerance;
        for s in self.a.turns_at(cluster.a, distance) {
            stops.push((s, self.partner(cluster, s)));
        }
        for t in self.b.turns_at(cluster.b, distance) {
            stops.push((self.back(cluster, t), t));
        }
        // A curve that turns back on itself does so to its turn; there the search does not look.
        if let Some(turn) = self.turn_between(cluster) {
            stops
                .retain(|&(s, t)| (s - turn).abs() > cluster.reach[0] && (t - turn).abs() > cluster.reach[1]);
            stops.push((turn, turn));
        }
        stops.sort_by(|x, y| x.0.total_cmp(&y.0));
        stops.dedup_by(|later, first| later.0 - first.0 <= slack);
        let mut run: Option<((f64, f64), (f64, f64))> = None;
        let mut close = |run: Option<((f64, f64), (f64, f64))>| {
            let Some((from, to)) = run else { return };
            let steps = 8;
            let at = |k: i32| self.a.point(Interval::new(from.0, to.0).at(f64::from(k) / f64::from(steps)));
            let length: f64 = (0..steps).map(|k| at(k).distance_to(at(k + 1))).sum();
            if length > 4.0 * self.tolerance {
                let (from, to) = (self.snapped(from), self.snapped(to));
                let (a, b) = (Interval::new(from.0, to.0), Interval::new(from.1, to.1));
                out.push(Overlap { a, b, same_direction: b.start < b.end });
            }
        };
        for w in stops.windows(2) {
            let (from, to) = (w[0], w[1]);
            let range = Interval::new(from.1, to.1);
            let mut before = from.1;
            let together = (0..=8).all(|k| {
                let x = f64::from(k) / 8.0;
                let s = Interval::new(from.0, to.0).at(x);
                // From where it should be and from the place before: in a part that stands still no search moves.
                let places = [range.at(x), before];
                let feet = places.map(|t| self.b.near(self.a.point(s), [range.min(), range.max()], t));
                let gaps = feet.map(|t| self.gap(s, t));
                before = if gaps[0] <= gaps[1] { feet[0] } else { feet[1] };
                gaps[0].min(gaps[1]) <= limit
            });
            if !together {
                close(run.take());
            } else if let Some((_, end)) = &mut run {
                *end = to;
            } else {
                run = Some((from, to));
            }
        }
        close(run.take());
    }

    fn scale(&self) -> f64 {
        let p = self.a.point(self.a.domain.start);
        p.x.abs().max(p.y.abs()).max(p.z.abs())
    }

    /// Parameters a hair from an end of the domain are that end.
    fn snapped(&self, (s, t): (f64, f64)) -> (f64, f64) {
        let snap = |side: &Side<'_>, t: f64| {
            let d = side.domain;
            let epsilon = SAME_ROOT * d.length();
            let end = if t - d.start <= epsilon {
                d.start
            } else if d.end - t <= epsilon {
                d.end
            } else {
                return t;
            };
            if side.point(end).distance_to(side.point(t)) <= self.tolerance { end } else { t }
        };
        (snap(&self.a, s), snap(&self.b, t))
    }

    /// The proved crossings of a cluster, each once, and those that a lens no deeper than the tolerance divides as
    /// one; `false` when there are none.
    fn crossings(&self, cluster: &Cluster, out: &mut Vec<Crossing>) -> bool {
        let mut roots: Vec<&Contact> = cluster.members.iter().filter(|c| c.root).collect();
        roots.sort_by(|x, y| x.best.0.total_cmp(&y.best.0).then(x.best.1.total_cmp(&y.best.1)));
        let (wa, wb) = (INSIDE * self.a.domain.length(), INSIDE * self.b.domain.length());
        let mut distinct: Vec<&Contact> = Vec::new();
        for root in roots {
            let same =
                |d: &&Contact| (d.best.0 - root.best.0).abs() <= wa && (d.best.1 - root.best.1).abs() <= wb;
            let recent = distinct.iter_mut().rev().take_while(|d| root.best.0 - d.best.0 <= wa);
            let mut looks = 0;
            match recent.inspect(|_| looks += 1).find(|d| same(d)) {
                // Of two readings of one crossing the better.
                Some(known) if root.gap < known.gap => *known = root,
                Some(_) => {}
                None => distinct.push(root),
            }
            self.a.pay(looks / 16);
        }
        let mut group: Vec<&Contact> = Vec::new();
        let mut close = |group: &mut Vec<&Contact>| {
            let Some(&middle) = group.get(group.len() / 2) else { return };
            if group.len() % 2 == 1 {
                out.push(self.crossing(middle.best.0, middle.best.1, Some(ContactKind::Transversal)));
            } else if let (Some(f), Some(l)) = (group.first(), group.last()) {
                let range = |x: f64, y: f64| [x.min(y), x.max(y)];
                let a = range(f.best.0, l.best.0);
                let b = range(f.best.1, l.best.1);
                let start = (0.5 * (a[0] + a[1]), 0.5 * (b[0] + b[1]));
                let (s, t) = self.tangency(start, a, b).unwrap_or(middle.best);
                out.push(self.crossing(s, t, Some(ContactKind::Tangent)));
            }
            group.clear();
        };
        for root in distinct.iter().copied() {
            if let Some(last) = group.last()
                && !self.within_between(last.best, root.best)
            {
                close(&mut group);
            }
            group.push(root);
        }
        close(&mut group);
        !distinct.is_empty()
    }

    /// Whether between two crossings the curves stay within the tolerance of each other.
    fn within_between(&self, x: (f64, f64), y: (f64, f64)) -> bool {
        let b = [x.1.min(y.1), x.1.max(y.1)];
        // The middle first: it decides most cases.
        [4, 1, 2, 3, 5, 6, 7].into_iter().all(|k| {
            let f = f64::from(k) / 8.0;
            let (s, t) = (Interval::new(x.0, y.0).at(f), Interval::new(x.1, y.1).at(f));
            self.gap(s, self.b.near(self.a.point(s), b, t)) <= self.tolerance
        })
    }

    /// A cluster without a proved crossing: the place where the curves are nearest, when that is within the
    /// tolerance.
    fn touch(&self, cluster: &Cluster) -> Option<Crossing> {
        let mut best = (f64::INFINITY, 0.0, 0.0);
        let mut offer = |s: f64, t: f64, favour: f64| {
            let gap = self.gap(s, t);
            if gap < best.0 + favour {
                best = (gap, s, t);
            }
        };
        for c in &cluster.members {
            offer(c.best.0, c.best.1, 0.0);
        }
        let wide = |x: [f64; 2], reach: f64, d: Interval| {
            let more = (x[1] - x[0]).max(reach);
            [d.clamp(x[0] - more), d.clamp(x[1] + more)]
        };
        let a = wide(cluster.a, cluster.reach[0], self.a.domain);
        let b = wide(cluster.b, cluster.reach[1], self.b.domain);
        // The nearest members lead to the nearest place: by alternating projection, then by parallel tangents.
        let (mut s, mut t) =
            cluster.members.iter().min_by(|x, y| x.gap.total_cmp(&y.gap)).map_or((a[0], b[0]), |c| c.best);
        for _ in 0..4 {
            t = self.b.near(self.a.point(s), b, t);
            s = self.a.near(self.b.point(t), a, s);
        }
        offer(s, t, 0.0);
        if let Some((s, t)) = self.crossed(cluster) {
            offer(s, t, 0.0);
        }
        for s in cluster.a {
            let t = self.partner(cluster, s);
            offer(s, t, 0.0);
        }
        let middle = (0.5 * (cluster.a[0] + cluster.a[1]), 0.5 * (cluster.b[0] + cluster.b[1]));
        for start in [(s, t), middle] {
            if let Some((s, t)) = self.tangency(start, a, b) {
                offer(s, t, ON_OTHER * self.tolerance);
            }
        }
        let (gap, s, t) = best;
        let (s, t) = self.snapped((s, t));
        (gap <= self.tolerance).then(|| self.crossing(s, t, None))
    }

    /// Where the curves of a cluster change sides.
    fn crossed(&self, cluster: &Cluster) -> Option<(f64, f64)> {
        let between = |s: f64| {
            let t = self.partner(cluster, s);
            (t, self.b.point(t) - self.a.point(s))
        };
        let [mut low, mut high] = cluster.a;
        let ((_, g0), (_, g1)) = (between(low), between(high));
        let noise = NOISE * self.scale();
        if !(g0.dot(g1) < 0.0) || g0.length() <= noise || g1.length() <= noise {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if !(low < middle && middle < high) {
                break;
            }
            if between(middle).1.dot(g0) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let s = 0.5 * (low + high);
        Some((s, between(s).0))
    }

    /// Newton's method for the place where the curves are level and parallel: (a − b)·T = 0 with T their common
    /// direction, and equal tangents as seen along the difference of their curvatures. `None` when it leaves the
    /// ranges or the curves osculate.
    fn tangency(&self, start: (f64, f64), ra: [f64; 2], rb: [f64; 2]) -> Option<(f64, f64)> {
        let (mut s, mut t) = start;
        let (wa, wb) = (self.a.domain.length(), self.b.domain.length());
        for _ in 0..24 {
            let ([p, da, dda], [q, db, ddb]) = (self.a.jet(s), self.b.jet(t));
            let (ta, tb) = (da.unitized()?, db.unitized()?);
            let sign = if ta.dot(tb) < 0.0 { -1.0 } else { 1.0 };
            let along = (ta + tb * sign).unitized()?;
            let (ka, kb) = (curvature(da, dda), curvature(db, ddb));
            let m = ka - kb;
            let m = m - along * m.dot(along);
            if !(m.length() > NO_BEND * (ka.length() + kb.length())) {
                return None;
            }
            let (f, g) = ((p - q).dot(along), (ta - tb * sign).dot(m));
            let (fs, ft) = (da.dot(along), -db.dot(along));
            let (gs, gt) = (da.length() * ka.dot(m), -sign * db.length() * kb.dot(m));
            let determinant = fs * gt - ft * gs;
            let ds = -(f * gt - ft * g) / determinant;
            let dt = -(fs * g - f * gs) / determinant;
            if !(ds.is_finite() && dt.is_finite()) {
                return None;
            }
            (s, t) = (s + ds, t + dt);
            let inside = |x: f64, r: [f64; 2], w: f64| r[0] - IN_RANGE * w <= x && x <= r[1] + IN_RANGE * w;
            if !(inside(s, ra, wa) && inside(t, rb, wb)) {
                return None;
            }
            if ds.abs() <= LAST_STEPS * wa && dt.abs() <= LAST_STEPS * wb {
                return Some((self.a.domain.clamp(s), self.b.domain.clamp(t)));
            }
        }
        None
    }

    /// One place has one entry: the seam of a closed curve counts at its start, and ends of overlaps are no
    /// crossings.
    fn drop_doubles(&self, out: &mut CurveIntersections) {
        if self.a.closed || self.b.closed {
            let overlaps = std::mem::take(&mut out.overlaps);
            let all = std::mem::take(&mut out.crossings);
            let near = |side: &Side<'_>, x: f64, y: f64| {
                (x - y).abs() <= SAME_PARAMETER * side.domain.length()
                    || ((x - y).abs() <= SAME_TOUCH * side.domain.length()
                        && side.point(x).distance_to(side.point(y)) <= 4.0 * self.tolerance)
            };
            let twins = |c: &Crossing| {
                let a = [Some(c.a), self.a.over_seam(c.a)];
                let b = [Some(c.b), self.b.over_seam(c.b)];
                let pairs =
                    a.into_iter().flatten().flat_map(move |x| b.into_iter().flatten().map(move |y| (x, y)));
                pairs.collect::<Vec<_>>()
            };
            for c in &all {
                self.a.pay((out.crossings.len() + overlaps.len()) / 16);
                let seam = self.a.over_seam(c.a).is_some() || self.b.over_seam(c.b).is_some();
                let known = seam
                    && twins(c).iter().any(|&(x, y)| {
                        let (x, y) = if self.itself { (x.min(y), x.max(y)) } else { (x, y) };
                        let at = |s: f64, t: f64| near(&self.a, x, s) && near(&self.b, y, t);
                        out.crossings.iter().any(|d| at(d.a, d.b))
                            || overlaps.iter().any(|o| at(o.a.start, o.b.start) || at(o.a.end, o.b.end))
                    });
                if !known {
                    out.crossings.push(*c);
                }
            }
            out.overlaps = overlaps;
        }
    }
}

/// Joins overlaps that go on in each other on both curves.
fn join_overlaps(overlaps: &mut Vec<Overlap>, domains: [Interval; 2]) {
    let epsilon = domains.map(|d| SAME_PARAMETER * d.length());
    let mut kept: Vec<Overlap> = Vec::with_capacity(overlaps.len());
    for o in overlaps.drain(..) {
        let goes_on = |k: &&mut Overlap| {
            k.same_direction == o.same_direction
                && (k.a.end - o.a.start).abs() <= epsilon[0]
                && (k.b.end - o.b.start).abs() <= epsilon[1]
        };
        match kept.iter_mut().rev().take(64).find(goes_on) {
            Some(known) => (known.a.end, known.b.end) = (o.a.end, o.b.end),
            None => kept.push(o),
        }
    }
    *overlaps = kept;
}
