//! Curves in space with a parameter in 0…1: edges, and trims lifted onto their surfaces; and which place on one is
//! nearest to a place on the other.

use crate::brep::CurvePart;
use crate::meshing::thresholds::{FOOT_DONE, FOOT_STEP};
use crate::thresholds;
use crate::{Curve, Direction, Point2, Point3, Quadrant, Surface, Vector3};

/// Where a curve in space comes from.
#[derive(Clone, Copy)]
pub(super) enum Source<'a> {
    /// Part of a space curve.
    Space(&'a Curve, CurvePart),
    /// Part of a curve in the parameter plane of a surface.
    Lifted(&'a Curve, CurvePart, &'a Surface),
}

/// A curve in space over 0…1 with a table of its length.
pub(super) struct Track<'a> {
    source: Source<'a>,
    backwards: bool,
    /// Places where pieces meet, both ends among them.
    joints: Vec<f64>,
    /// The share of the length up to each of equally many places in every piece.
    table: Vec<[f64; 2]>,
    /// The length, by chords.
    pub(super) length: f64,
}

impl<'a> Track<'a> {
    pub(super) fn new(source: Source<'a>, backwards: bool) -> Self {
        let (curve, part) = match source {
            Source::Space(curve, part) | Source::Lifted(curve, part, _) => (curve, part),
        };
        let turned = part.reversed != backwards;
        let range = part.range;
        let inside = |t: f64| {
            let x = range.normalized(t);
            if turned { 1.0 - x } else { x }
        };
        let mut joints: Vec<f64> = (curve.pieces().iter())
            .map(|piece| inside(piece.whole.start))
            .filter(|x| *x > thresholds::SAME_PARAMETER && *x < 1.0 - thresholds::SAME_PARAMETER)
            .collect();
        joints.extend([0.0, 1.0]);
        joints.sort_by(f64::total_cmp);
        joints.dedup_by(|a, b| *a - *b < thresholds::SAME_PARAMETER);
        let mut track = Self { source, backwards, joints, table: Vec::new(), length: 0.0 };
        track.measure();
        track
    }

    /// Makes the table of lengths, with as many rows as it takes for chords to tell them: a straight trim on a spiral
    /// tube is a spiral.
    fn measure(&mut self) {
        /// Twice as many chords may be longer by so much.
        const GROWTH: f64 = 1.01;
        const MOST: usize = 8192;
        let pieces = self.joints.len() - 1;
        let spans = match self.source {
            Source::Space(..) => 0,
            Source::Lifted(_, _, surface) => {
                Direction::BOTH.iter().map(|&d| surface.span_parameters(d).len()).sum::<usize>()
            }
        };
        let mut each = ((2 * spans).clamp(64, MOST / 4) / pieces).clamp(4, MOST / 4);
        loop {
            let (table, coarse) = self.chords(each);
            let length = table.last().map_or(0.0, |row| row[1]);
            let known = length <= GROWTH * coarse || 2 * each * pieces > MOST;
            self.table = table;
            self.length = length;
            if known {
                break;
            }
            each *= 2;
        }
        let length = self.length;
        if length > 0.0 {
            self.table.iter_mut().for_each(|row| row[1] /= length);
        } else {
            self.table.iter_mut().for_each(|row| row[1] = row[0]);
        }
    }

    /// Places with the lengths up to them, by so many chords in every piece, and the length by half as many.
    fn chords(&self, each: usize) -> (Vec<[f64; 2]>, f64) {
        let mut table = Vec::with_capacity(each * self.joints.len());
        let (mut length, mut coarse) = (0.0, 0.0);
        let mut before = self.point(0.0);
        let mut even = before;
        table.push([0.0, 0.0]);
        for w in self.joints.windows(2) {
            for k in 1..=each {
                let x = w[0] + (w[1] - w[0]) * k as f64 / each as f64;
                let p = self.point(x);
                length += before.distance_to(p);
                before = p;
                table.push([x, length]);
                if k % 2 == 0 || k == each {
                    coarse += even.distance_to(p);
                    even = p;
                }
            }
        }
        (table, coarse)
    }

    /// The curve's parameter.
    fn parameter(&self, x: f64) -> f64 {
        let (Source::Space(_, part) | Source::Lifted(_, part, _)) = self.source;
        part.range.at(if part.reversed != self.backwards { 1.0 - x } else { x })
    }

    /// The parameters on the surface, for a lifted curve.
    pub(super) fn flat(&self, x: f64) -> Point2 {
        match self.source {
            Source::Lifted(curve, ..) => {
                let p = curve.point_at(self.parameter(x));
                Point2::new(p.x, p.y)
            }
            Source::Space(..) => Point2::new(f64::NAN, f64::NAN),
        }
    }

    /// The point at a place.
    pub(super) fn point(&self, x: f64) -> Point3 {
        match self.source {
            Source::Space(curve, _) => curve.point_at(self.parameter(x)),
            Source::Lifted(_, _, surface) => {
                let uv = self.flat(x);
                surface.point_at(uv.x, uv.y)
            }
        }
    }

    /// The point and two derivatives by the place, inside the piece that goes on from there or comes up to there.
    pub(super) fn jet(&self, x: f64, from_below: bool) -> [Vector3; 3] {
        let (Source::Space(curve, part) | Source::Lifted(curve, part, _)) = self.source;
        let turned = part.reversed != self.backwards;
        let scale = if turned { -part.range.length() } else { part.range.length() };
        let mut d = [Vector3::ZERO; 3];
        curve.derivatives_into(self.parameter(x), from_below != turned, &mut d);
        d[1] = d[1] * scale;
        d[2] = d[2] * (scale * scale);
        let Source::Lifted(_, _, surface) = self.source else { return d };
        let (u, v) = (d[0].x, d[0].y);
        let s = surface.derivatives(u, v, 2, Quadrant::new(d[1].x < 0.0, d[1].y < 0.0));
        let (a, b) = (d[1].x, d[1].y);
        [
            s.get(0, 0),
            s.get(1, 0) * a + s.get(0, 1) * b,
            s.get(2, 0) * (a * a)
                + s.get(1, 1) * (2.0 * a * b)
                + s.get(0, 2) * (b * b)
                + s.get(1, 0) * d[2].x
                + s.get(0, 1) * d[2].y,
        ]
    }

    /// The places where the curve turns sharply, both ends among them.
    pub(super) fn corners(&self) -> Vec<f64> {
        /// In radians.
        const SHARP: f64 = 1e-3;
        let mut out = self.joints.clone();
        out.retain(|&x| {
            x == 0.0 || x == 1.0 || {
                let [before, after] = [true, false].map(|below| self.jet(x, below)[1]);
                before.angle_to(after).is_none_or(|angle| angle > SHARP)
            }
        });
        out
    }

    /// Point and derivatives at equal steps between two places and where pieces meet, in order; at the joints as far
    /// as there are not too many.
    pub(super) fn jets_between(&self, from: f64, to: f64) -> Vec<[Vector3; 3]> {
        const STEPS: u32 = 4;
        const MOST: usize = 64;
        let first = self.joints.partition_point(|&x| x <= from);
        let last = self.joints.partition_point(|&x| x < to);
        let inner = self.joints.get(first..last).unwrap_or(&[]);
        let every = inner.len().div_ceil(MOST).max(1);
        let mut places: Vec<(f64, bool)> =
            (0..=STEPS).map(|k| (from + (to - from) * f64::from(k) / f64::from(STEPS), k == STEPS)).collect();
        places.extend(inner.iter().step_by(every).flat_map(|&x| [(x, true), (x, false)]));
        places.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        places.into_iter().map(|(x, below)| self.jet(x, below)).collect()
    }

    /// The share of the length up to a place.
    pub(super) fn share(&self, x: f64) -> f64 {
        lookup(&self.table, 0, x)
    }

    /// The place nearest to a point that lies at a share of the length, more or less.
    ///
    /// A spiral comes by the same point again and again: what is near along it is looked at first, and the rest only
    /// where nothing is found there.
    pub(super) fn nearest(&self, p: Point3, share: f64) -> f64 {
        self.nearest_within(p, share, [0.0, 1.0])
    }

    /// As [`Track::nearest`], but only in a range of places.
    pub(super) fn nearest_within(&self, p: Point3, share: f64, [from, to]: [f64; 2]) -> f64 {
        /// How far to look, in shares of the length.
        const REACHES: [f64; 3] = [0.005, 0.03, 0.1];
        /// Nearer than this part of the length is found.
        const FOUND: f64 = 1e-7;
        /// Farther than this part of the length is another place.
        const LOST: f64 = 1e-3;
        let guess = lookup(&self.table, 1, share).clamp(from, to);
        let mut best = (f64::INFINITY, guess);
        for reach in REACHES {
            let range = [share - reach, share + reach];
            let range = range.map(|share| lookup(&self.table, 1, share).clamp(from, to));
            let place = self.nearest_between(p, guess, range);
            let distance = self.point(place).distance_to(p);
            if distance < best.0 {
                best = (distance, place);
            }
            if distance <= FOUND * self.length || range == [from, to] {
                break;
            }
        }
        if best.0 > LOST * self.length {
            let (distance, place) = self.nearest_anywhere(p, [from, to]);
            if distance < 0.5 * best.0 {
                return place;
            }
        }
        best.1
    }

    /// The place nearest to a point in a range, with the distance, by a look at all of the table.
    fn nearest_anywhere(&self, p: Point3, [from, to]: [f64; 2]) -> (f64, f64) {
        let far = |x: f64| (self.point(x).distance_to(p), x);
        let nearer = |a: (f64, f64), b: (f64, f64)| if b.0 < a.0 { b } else { a };
        let inside = |row: &[f64; 2]| row[0] >= from && row[0] <= to;
        let first = self.table.partition_point(|row| row[0] < from);
        let rows = self.table.iter().enumerate().skip(first).take_while(|(_, row)| inside(row));
        let Some((k, best)) = rows.map(|(k, row)| (k, far(row[0]))).min_by(|a, b| a.1.0.total_cmp(&b.1.0))
        else {
            return (f64::INFINITY, from);
        };
        let at = |k: usize| self.table.get(k).map_or(to, |row| row[0]).clamp(from, to);
        nearer(best, far(self.nearest_between(p, best.1, [at(k.saturating_sub(1)), at(k + 1)])))
    }

    /// The place nearest to a point in a range where there is only one, by Newton's method in a shrinking bracket.
    pub(super) fn nearest_between(&self, p: Point3, guess: f64, [mut low, mut high]: [f64; 2]) -> f64 {
        let mut x = guess.clamp(low, high);
        for _ in 0..24 {
            let [at, by, _] = self.jet(x, false);
            let slope = (at - p.to_vector()).dot(by);
            let square = by.dot(by);
            // There already: the bracket says nothing more, and its middle may lie by another place as near as any.
            if slope.abs() <= FOOT_DONE * self.length * square.sqrt() && square > 0.0 {
                break;
            }
            if slope > 0.0 {
                high = x;
            } else {
                low = x;
            }
            let mut next = x - slope / square;
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            let step = (next - x).abs();
            x = next;
            if step < FOOT_STEP || !(step * square.sqrt() > FOOT_DONE * self.length) {
                break;
            }
        }
        x
    }
}

/// Linear interpolation in a table of ascending pairs, by one column for the other.
fn lookup(table: &[[f64; 2]], by: usize, value: f64) -> f64 {
    let k = table.partition_point(|row| row[by] <= value);
    match (k.checked_sub(1).and_then(|k| table.get(k)), table.get(k)) {
        (Some(a), Some(b)) => {
            let wide = b[by] - a[by];
            let x = if wide > 0.0 { (value - a[by]) / wide } else { 0.0 };
            a[1 - by] + (b[1 - by] - a[1 - by]) * x
        }
        (Some(a), None) => a[1 - by],
        (None, Some(b)) => b[1 - by],
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Source, Track};
    use crate::brep::CurvePart;
    use crate::{
        Arc, Curve, KnotSpacing, Line, LineCurve, NurbsCurve, Point3, PolyCurve, SumSurface, Surface, Vector3,
    };

    fn whole(curve: &Curve) -> CurvePart {
        CurvePart { curve: Some(0), range: curve.domain(), reversed: false, domain: curve.domain() }
    }

    /// A closed chain of quarter circles that comes by one height four times, each time level.
    #[test]
    fn what_is_met_exactly_is_kept() {
        let s = 0.5_f64.sqrt();
        let p = Point3::new;
        let round = [
            [p(0.0, 1.0, 1.0), p(s, 1.0, s), p(1.0, 1.0, 0.0)],
            [p(1.0, 1.0, 0.0), p(s, 1.0, -s), p(0.0, 1.0, -1.0)],
            [p(0.0, 1.0, -1.0), p(-s, s, -1.0), p(-1.0, 0.0, -1.0)],
            [p(-1.0, 0.0, -1.0), p(-s, -s, -1.0), p(0.0, -1.0, -1.0)],
            [p(0.0, -1.0, -1.0), p(s, -1.0, -s), p(1.0, -1.0, 0.0)],
            [p(1.0, -1.0, 0.0), p(s, -1.0, s), p(0.0, -1.0, 1.0)],
            [p(0.0, -1.0, 1.0), p(-s, -s, 1.0), p(-1.0, 0.0, 1.0)],
            [p(-1.0, 0.0, 1.0), p(-s, s, 1.0), p(0.0, 1.0, 1.0)],
        ];
        let arcs = round.map(|[a, b, c]| Curve::from(Arc::through(a, b, c).unwrap()));
        let curve: Curve = PolyCurve::new(arcs.to_vec()).unwrap().into();
        let track = Track::new(Source::Space(&curve, whole(&curve)), false);
        for k in 1..64 {
            let x = f64::from(k) / 64.0;
            let there = track.point(x);
            for found in [
                track.nearest(there, track.share(x)),
                track.nearest_between(there, x, [0.0, 1.0]),
                track.nearest_within(there, track.share(x), [0.0, 1.0]),
            ] {
                assert!((found - x).abs() < 1e-9, "{x} {found}");
            }
        }
    }

    /// A straight trim on a spiral strip is a spiral: the few chords of a straight line do not tell its length.
    #[test]
    fn straight_trims_of_spirals() {
        let points: Vec<Point3> = (0..800)
            .map(|k| {
                let t = f64::from(k) * 0.3;
                Point3::new(9.0 * t.cos(), 9.0 * t.sin(), 0.2 * t)
            })
            .collect();
        let spiral: Curve =
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap().into();
        let wall = Curve::from(Line::new(Point3::ORIGIN, Point3::ORIGIN + Vector3::Z * 0.1));
        let strip: Surface = SumSurface::new(spiral.clone(), wall, Vector3::ZERO).unwrap().into();
        let domain = spiral.domain();
        let line = Line::new(Point3::new(domain.start, 0.0, 0.0), Point3::new(domain.end, 0.0, 0.0));
        let flat: Curve = LineCurve { line, domain }.into();
        let edge = Track::new(Source::Space(&spiral, whole(&spiral)), false);
        let trim = Track::new(Source::Lifted(&flat, whole(&flat), &strip), false);
        assert!((edge.length / trim.length - 1.0).abs() < 0.01, "{} {}", edge.length, trim.length);
        for k in 0..=1000 {
            let x = f64::from(k) / 1000.0;
            let y = trim.nearest(edge.point(x), edge.share(x));
            assert!((y - x).abs() < 1e-6, "{x} {y}");
        }
    }
}
