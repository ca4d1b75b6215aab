//! Curves in space with a parameter in 0…1: edges, and trims lifted onto their surfaces; and which place on one is
//! nearest to a place on the other.

use crate::brep::CurvePart;
use crate::{Curve, Point2, Point3, Quadrant, Surface, Vector3};

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
            .filter(|x| *x > 1e-9 && *x < 1.0 - 1e-9)
            .collect();
        joints.extend([0.0, 1.0]);
        joints.sort_by(f64::total_cmp);
        joints.dedup_by(|a, b| *a - *b < 1e-9);
        let mut track = Self { source, backwards, joints, table: Vec::new(), length: 0.0 };
        let each = (64 / (track.joints.len() - 1)).clamp(4, 64);
        let mut table = Vec::with_capacity(each * track.joints.len());
        let mut before = track.point(0.0);
        table.push([0.0, 0.0]);
        for w in track.joints.windows(2) {
            for k in 1..=each {
                let x = w[0] + (w[1] - w[0]) * k as f64 / each as f64;
                let p = track.point(x);
                track.length += before.distance_to(p);
                before = p;
                table.push([x, track.length]);
            }
        }
        if track.length > 0.0 {
            table.iter_mut().for_each(|row| row[1] /= track.length);
        } else {
            table.iter_mut().for_each(|row| row[1] = row[0]);
        }
        track.table = table;
        track
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
        /// How far to look, in shares of the length.
        const REACHES: [f64; 3] = [0.005, 0.03, 0.1];
        /// Nearer than this part of the length is found.
        const FOUND: f64 = 1e-7;
        let guess = lookup(&self.table, 1, share);
        let mut best = (f64::INFINITY, guess);
        for reach in REACHES {
            let range = [share - reach, share + reach].map(|share| lookup(&self.table, 1, share));
            let place = self.nearest_between(p, guess, range);
            let distance = self.point(place).distance_to(p);
            if distance < best.0 {
                best = (distance, place);
            }
            if distance <= FOUND * self.length {
                break;
            }
        }
        best.1
    }

    /// The place nearest to a point in a range where there is only one, by Newton's method in a shrinking bracket.
    pub(super) fn nearest_between(&self, p: Point3, guess: f64, [mut low, mut high]: [f64; 2]) -> f64 {
        let mut x = guess.clamp(low, high);
        for _ in 0..24 {
            let [at, by, _] = self.jet(x, false);
            let slope = (at - p.to_vector()).dot(by);
            let square = by.dot(by);
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
            if step < 1e-14 || !(step * square.sqrt() > 1e-13 * self.length) {
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
