//! The same surface in another form or place, and single control points and weights.

use super::NurbsSurface;
use super::curve::Controls;
use super::surface::Direction;
use super::surface_refine::transposed;
use crate::nurbs::thresholds::{COLUMN_DIFFERENCE, EQUAL_WEIGHTS};
use crate::{Error, Interval, Point3, Result, Xform};

impl NurbsSurface {
    /// The same surface with u and v exchanged; the normal turns over.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let [u, v] = self.knots.clone();
        let controls = match &self.controls {
            Controls::Plain(p) => Controls::Plain(transposed(p, self.counts[1])),
            Controls::Rational(p) => Controls::Rational(transposed(p, self.counts[1])),
        };
        Self {
            degrees: [self.degrees[1], self.degrees[0]],
            counts: [self.counts[1], self.counts[0]],
            knots: [v, u],
            controls,
        }
    }

    /// The same surface with one direction walked backwards; its domain a…b becomes −b…−a, as in openNURBS, and the
    /// normal turns over.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        let mut surface = self.clone();
        surface.knots[direction.index()] = self.knots(direction).iter().rev().map(|k| -k).collect();
        let columns = self.counts[1];
        match &mut surface.controls {
            Controls::Plain(p) => reverse_lines(p, columns, direction),
            Controls::Rational(p) => reverse_lines(p, columns, direction),
        }
        surface
    }

    /// The same surface over another domain in one direction: the parameter is mapped linearly.
    ///
    /// # Errors
    /// The domain does not increase, or is so small or so far from 0 that knots would fall together.
    pub fn with_domain(&self, direction: Direction, domain: Interval) -> Result<Self> {
        if !domain.is_increasing() {
            return Err(Error::Invalid {
                what: "domain",
                why: format!("{} to {} does not increase", domain.start, domain.end),
            });
        }
        let old = self.domain(direction);
        if old == domain {
            return Ok(self.clone());
        }
        let knots = self.knots(direction).iter().map(|&k| domain.at(old.normalized(k))).collect();
        self.with_line(direction, self.degree(direction), knots, self.controls.clone())
    }

    /// The same surface with weights, all 1 when it had none.
    #[must_use]
    pub fn to_rational(&self) -> Self {
        Self { controls: Controls::Rational(self.homogeneous_points()), ..self.clone() }
    }

    /// The same surface without weights, when they are all equal; otherwise `None`.
    pub fn to_non_rational(&self) -> Option<Self> {
        match &self.controls {
            Controls::Plain(_) => Some(self.clone()),
            Controls::Rational(points) => {
                let w = points.first()?[3];
                points.iter().all(|p| (p[3] - w).abs() <= EQUAL_WEIGHTS * w).then(|| {
                    let plain = points.iter().map(|p| [p[0] / p[3], p[1] / p[3], p[2] / p[3]]).collect();
                    Self { controls: Controls::Plain(plain), ..self.clone() }
                })
            }
        }
    }

    /// The surface with control point (i, j) at another place; its weight stays.
    ///
    /// # Errors
    /// There is no such control point, or the place is not finite.
    pub fn with_control_point(&self, i: usize, j: usize, place: Point3) -> Result<Self> {
        let slot = self.slot_or_error(i, j)?;
        let mut controls = self.controls.clone();
        match &mut controls {
            Controls::Plain(points) => {
                if let Some(p) = points.get_mut(slot) {
                    *p = place.into();
                }
            }
            Controls::Rational(points) => {
                if let Some(p) = points.get_mut(slot) {
                    let w = p[3];
                    *p = [place.x * w, place.y * w, place.z * w, w];
                }
            }
        }
        Self::from_controls(self.degrees, self.counts, controls, self.knots.clone())
    }

    /// The surface with another weight at control point (i, j), which stays where it is; rational from then on.
    ///
    /// # Errors
    /// There is no such control point, or the weight is not a finite number greater than 0.
    pub fn with_weight(&self, i: usize, j: usize, weight: f64) -> Result<Self> {
        if !(weight > 0.0 && weight.is_finite()) {
            return Err(Error::OutOfRange {
                what: "weight",
                value: weight,
                must: "finite and greater than 0",
            });
        }
        let slot = self.slot_or_error(i, j)?;
        let place = self.control_point(i, j).unwrap_or(Point3::ORIGIN);
        let mut points = self.homogeneous_points();
        if let Some(p) = points.get_mut(slot) {
            *p = [place.x * weight, place.y * weight, place.z * weight, weight];
        }
        Self::rational(self.degrees, self.counts, points, self.knots.clone())
    }

    fn slot_or_error(&self, i: usize, j: usize) -> Result<usize> {
        self.slot(i, j).ok_or_else(|| Error::Invalid {
            what: "control point index",
            why: format!("({i}, {j}) is outside a grid of {} by {}", self.counts[0], self.counts[1]),
        })
    }

    /// The exact image: control points are mapped, homogeneous ones where the surface is rational or the map
    /// projective.
    ///
    /// # Errors
    /// A projective map sends part of the surface's hull to infinity, or a number overflows.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let controls = match &self.controls {
            Controls::Plain(points) if xform.is_affine() => {
                Controls::Plain(points.iter().map(|&p| xform.point(p.into()).into()).collect())
            }
            _ => Controls::Rational(
                self.homogeneous_points()
                    .iter()
                    .map(|p| xform.rows.map(|r| r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] * p[3]))
                    .collect(),
            ),
        };
        Self::from_controls(self.degrees, self.counts, controls, self.knots.clone())
    }

    /// The same closed surface with its seam in one direction at parameter `t`; the domain becomes t…t + period. A
    /// periodic surface stays periodic, another gets a knot of full multiplicity where its seam was.
    ///
    /// # Errors
    /// The surface is not closed in the direction, `t` is outside its domain, or the weights of the two sides of the
    /// old seam differ.
    pub fn with_seam(&self, direction: Direction, t: f64) -> Result<Self> {
        let domain = self.domain(direction);
        let t = self.snapped(direction, t);
        if !domain.contains(t) {
            return Err(Error::OutOfRange { what: "seam", value: t, must: "inside the surface's domain" });
        }
        if !self.is_closed(direction) {
            return Err(Error::degenerate("surface", "it is not closed in the direction of the new seam"));
        }
        if t == domain.start || t == domain.end {
            return Ok(self.clone());
        }
        // The seam across v is that across u of the transposed surface.
        if direction == Direction::V {
            return Ok(self.transposed().with_seam(Direction::U, t)?.transposed());
        }
        if self.is_periodic(direction) {
            return self.insert_knot(direction, t, 1)?.rotated_to(t);
        }
        let (first, second) = self.split(direction, t)?;
        let (columns, degree) = (self.counts[1], self.degrees[0]);
        let (points, tail) = (second.homogeneous_points(), first.homogeneous_points());
        let last = points.get(points.len() - columns..).unwrap_or(&[]);
        let size = points.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()));
        let differ = |a: &[f64; 4], b: &[f64; 4]| {
            a.iter().zip(b).any(|(x, y)| (x - y).abs() > COLUMN_DIFFERENCE * size)
        };
        if last.iter().zip(&tail).any(|(a, b)| differ(a, b)) {
            return Err(Error::Unsupported("a seam whose two sides have different weights"));
        }
        let mut knots = second.knots[0].clone();
        knots.extend(first.knots[0].iter().skip(degree).map(|k| k + domain.length()));
        let mut joined = points;
        joined.extend(tail.into_iter().skip(columns));
        let controls = match &self.controls {
            Controls::Plain(_) => Controls::Plain(joined.iter().map(|p| [p[0], p[1], p[2]]).collect()),
            Controls::Rational(_) => Controls::Rational(joined),
        };
        self.with_line(direction, degree, knots, controls)
    }

    /// A surface that is periodic in u and has the knot `t`, started there.
    fn rotated_to(&self, t: f64) -> Result<Self> {
        let (p, columns) = (self.degrees[0], self.counts[1]);
        let (knots, period) = (&self.knots[0], self.domain(Direction::U).length());
        let distinct = self.counts[0] - p;
        let at = knots.iter().rposition(|&k| k == t).unwrap_or(p - 1);
        let shift = (at + 1).saturating_sub(p);
        let new_knots = (shift..shift + knots.len())
            .map(|i| match knots.get(i) {
                Some(&k) => k,
                None => knots.get(i - distinct).map_or(f64::NAN, |k| k + period),
            })
            .collect();
        let rows = (0..self.counts[0]).map(|i| (i + shift) % distinct);
        let controls = match &self.controls {
            Controls::Plain(points) => Controls::Plain(take_rows(points, columns, rows)),
            Controls::Rational(points) => Controls::Rational(take_rows(points, columns, rows)),
        };
        self.with_line(Direction::U, p, new_knots, controls)
    }
}

fn take_rows<T: Copy>(points: &[T], columns: usize, rows: impl Iterator<Item = usize>) -> Vec<T> {
    rows.flat_map(|i| points.iter().skip(i * columns).take(columns).copied()).collect()
}

fn reverse_lines<T>(points: &mut [T], columns: usize, direction: Direction) {
    match direction {
        Direction::V => points.chunks_mut(columns).for_each(<[T]>::reverse),
        // Everything backwards, then each row forwards again.
        Direction::U => {
            points.reverse();
            points.chunks_mut(columns).for_each(<[T]>::reverse);
        }
    }
}
