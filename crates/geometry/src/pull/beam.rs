//! Lines in one direction through a curve, and where they meet a surface.

use katydid_elementary::Elementary;

use super::lines::{LineIndex, Met};
use crate::curve::traced::Sample;
use crate::pull::thresholds::{ALONG_SURFACE, FOUND, MISSES, NEAR_WAY, ON_LINE};
use crate::surface::geodesic::Unrolled;
use crate::thresholds;
use crate::{Curve, Interval, Point3, Result, Surface, Vector3};

/// Lines of a smooth stretch that are met with the surface at first.
const LINES: usize = 32;

/// A line that meets the surface at a smaller sine grazes it: where it does is known to half the digits only, and no way
/// begins there. A curve that lies over the outline of the surface has such lines alone.
const GRAZING: f64 = 2e-3;
/// After so many lines that all but graze the surface no more are tried on a stretch: each costs as much as a hundred
/// others.
const MOST_GRAZING: usize = 3;
/// What all but grazes: the places are not exact yet.
const ALMOST: f64 = 1e-2;

/// A place where the line through a point of the curve meets the surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    /// The parameter on the curve.
    pub(super) t: f64,
    pub(super) uv: [f64; 2],
}

pub(super) struct Beam<'a> {
    sheet: Unrolled<'a>,
    curve: &'a Curve,
    lines: &'a LineIndex,
    direction: Vector3,
    /// Two directions across.
    across: [Vector3; 2],
    /// Lines this long, to both sides, reach all of the surface.
    reach: f64,
    size: f64,
}

impl<'a> Beam<'a> {
    pub(super) fn new(surface: &'a Surface, curve: &'a Curve, lines: &'a LineIndex) -> Self {
        let size = curve.bounding_box().union(&lines.bounds).diagonal().length();
        let (direction, across) = (lines.direction, lines.across);
        Self { sheet: Unrolled::new(surface), curve, lines, direction, across, reach: 1.01 * size, size }
    }

    /// The way of each meeting along a smooth stretch of the curve.
    pub(super) fn ways(&self, part: Interval) -> Result<Vec<Vec<Meeting>>> {
        let mut ways: Vec<Vec<Meeting>> = Vec::new();
        let near = NEAR_WAY * self.size;
        let mut grazing = 0;
        for k in 0..=LINES {
            if grazing == MOST_GRAZING {
                break;
            }
            crate::cancellation::check_now()?;
            let t = part.at(k as f64 / LINES as f64);
            let p = self.curve.point_at(t);
            let Met { places: hits, along } = self.lines.meet(p, self.reach, self.size)?;
            let sine = |uv| self.sheet.normal(uv).map_or(0.0, |normal| normal.dot(self.direction).abs());
            // One that runs in the surface for a while only grazes it as well.
            grazing += usize::from(along || (!hits.is_empty() && hits.iter().all(|hit| sine(*hit) < ALMOST)));
            for hit in hits {
                let uv = self.solve(t, hit).filter(|uv| !self.sheet.is_outside(*uv)).unwrap_or(hit);
                if sine(uv) < GRAZING || self.miss(p, uv) > MISSES * self.size {
                    continue;
                }
                // One that another way came through already starts none.
                let known = ways.iter().any(|way| {
                    let i = way.partition_point(|m| m.t < t);
                    [i.wrapping_sub(1), i].iter().filter_map(|&i| way.get(i)).any(|m| {
                        let there = self.solve(t, m.uv).unwrap_or(m.uv);
                        let inside = way
                            .first()
                            .is_some_and(|m| m.t <= t + thresholds::SAME_PARAMETER * part.length())
                            && way
                                .last()
                                .is_some_and(|m| m.t >= t - thresholds::SAME_PARAMETER * part.length());
                        inside && self.sheet.point(there).distance_to(self.sheet.point(uv)) <= near
                    })
                });
                if known {
                    continue;
                }
                let start = Meeting { t, uv };
                let mut way = self.follow(start, part.start);
                way.reverse();
                way.push(start);
                way.extend(self.follow(start, part.end));
                ways.push(way);
            }
        }
        Ok(ways)
    }

    /// The meetings from one on towards an end of the stretch, without the first.
    fn follow(&self, start: Meeting, end: f64) -> Vec<Meeting> {
        let mut out: Vec<Meeting> = Vec::new();
        let whole = end - start.t;
        if whole == 0.0 {
            return out;
        }
        let most = (self.curve.domain().length() / LINES as f64).min(whole.abs());
        let mut step = most;
        let mut here = start;
        let mut before: Option<Meeting> = None;
        // Steps grow again after a difficult place.
        for _ in 0..5000 {
            let left = end - here.t;
            if left == 0.0 || left * whole <= 0.0 || crate::cancellation::check().is_err() {
                break;
            }
            let t = if step >= left.abs() { end } else { here.t + step * whole.signum() };
            let guess = match before {
                Some(b) if b.t != here.t => {
                    let x = (t - here.t) / (here.t - b.t);
                    [0, 1].map(|d| here.uv[d] + (here.uv[d] - b.uv[d]) * x)
                }
                _ => here.uv,
            };
            let next = self.solve(t, guess).filter(|uv| !self.sheet.is_outside(*uv)).filter(|uv| {
                (0..2).all(|d| (uv[d] - here.uv[d]).abs() <= 0.125 * self.sheet.domains[d].length())
            });
            match next {
                Some(uv) => {
                    before = Some(here);
                    here = Meeting { t, uv };
                    out.push(here);
                    step = (2.0 * step).min(most);
                }
                None => {
                    step *= 0.5;
                    if step <= thresholds::EXACT_PARAMETER * self.curve.domain().length() {
                        break;
                    }
                }
            }
        }
        out
    }

    /// The place where the line through the curve's point at `t` meets the surface, next to a guess: Newton's method
    /// across the direction.
    fn solve(&self, t: f64, guess: [f64; 2]) -> Option<[f64; 2]> {
        let target = self.curve.point_at(t);
        let mut uv = guess;
        for _ in 0..20 {
            let jet = self.sheet.jet(uv, 1);
            let miss = self.across.map(|a| (jet.point() - target).dot(a));
            if miss[0].hypotenuse(miss[1]) <= FOUND * self.size {
                return Some(uv);
            }
            let [a, b] = self.across.map(|x| [jet.get(1, 0).dot(x), jet.get(0, 1).dot(x)]);
            let determinant = a[0] * b[1] - a[1] * b[0];
            let step = [
                (miss[0] * b[1] - miss[1] * a[1]) / determinant,
                (miss[1] * a[0] - miss[0] * b[0]) / determinant,
            ];
            let far = (0..2).any(|d| !(step[d].abs() <= 0.25 * self.sheet.domains[d].length()));
            if far {
                return None;
            }
            uv = [uv[0] - step[0], uv[1] - step[1]];
        }
        (self.miss(target, uv) <= ON_LINE * self.size).then_some(uv)
    }

    /// How far a place of the surface is from the line through a point.
    fn miss(&self, target: Point3, uv: [f64; 2]) -> f64 {
        let [a, b] = self.across.map(|a| (self.sheet.point(uv) - target).dot(a));
        a.hypotenuse(b)
    }

    /// The point on the surface for a parameter of the curve, and its direction, next to a guess.
    pub(super) fn sample(&self, t: f64, part: Interval, guess: [f64; 2]) -> Option<Sample> {
        let uv = self.solve(t, guess).unwrap_or(guess);
        let normal = self.sheet.normal(uv);
        let along = self.curve.tangent_on_side(t, t >= part.end);
        // The direction of the curve, moved along the beam into the tangent plane.
        let direction = normal.zip(along).and_then(|(n, v)| {
            let slope = n.dot(self.direction);
            let flat = if slope.abs() > ALONG_SURFACE {
                v - self.direction * (n.dot(v) / slope)
            } else {
                self.direction
            };
            flat.unitized()
        });
        Some(Sample { point: self.sheet.point(uv), direction })
    }
}
