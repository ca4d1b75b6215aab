//! The point of a curve nearest to a given one.

use katydid_elementary::Elementary;

use super::Curve;
use super::closest_part::{Best, Parts};
use super::piece::{Piece, Shape};
use crate::bernstein::BUDGET;
use crate::box_tree::{Bounds, BoxTree, bounds_of, squared_distance_to};
use crate::curve::thresholds::{NEAREST_LIMIT, WIDER_BOX};
use crate::thresholds;
use crate::{Arc, Error, Point3, Result, cancellation};

/// A point on a curve and how far it is from where one asked.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurvePoint {
    /// The parameter on the curve.
    pub parameter: f64,
    /// The point there.
    pub point: Point3,
    /// Its distance from the point asked for.
    pub distance: f64,
}

/// A curve prepared for many questions about its nearest point: its Bézier parts in a tree of boxes.
///
/// An answer is the global minimum, proven by bounds: no point of the curve is nearer by more than 2·10⁻¹³ of the
/// distance (or, next to the curve, some 10⁻⁸ of the size of a span where two branches cross just there). A question
/// takes no memory. Of equally near points it gives one; [`Curve::local_closest_points`] has them all.
#[derive(Debug, Clone)]
pub struct ClosestOnCurve<'a> {
    pieces: Vec<Piece<'a>>,
    tree: BoxTree,
    /// For each box of the tree: a part of a NURBS span, or a whole segment or arc.
    items: Vec<Item>,
    parts: Parts,
}

#[derive(Debug, Clone, Copy)]
enum Item {
    Part(u32),
    Simple(u32),
}

fn xyz(p: Point3) -> [f64; 3] {
    p.into()
}

impl<'a> ClosestOnCurve<'a> {
    /// Prepares a curve: about 10 µs for a NURBS curve of 20 control points.
    pub fn new(curve: &'a Curve) -> Self {
        Self::build(curve.pieces(), true, |_, _| true)
    }

    /// Over those pieces that are wanted, by index and bounds.
    fn build(pieces: Vec<Piece<'a>>, halve: bool, wanted: impl Fn(usize, &Bounds) -> bool) -> Self {
        let mut parts = Parts::default();
        let (mut items, mut boxes) = (Vec::new(), Vec::new());
        let mut bezier = Vec::new();
        for (i, piece) in pieces.iter().enumerate() {
            if !wanted(i, &hull_of(piece)) {
                continue;
            }
            if let Shape::Span(curve, j) = piece.shape {
                bezier.clear();
                curve.push_bezier(j, &mut bezier);
                let first = parts.list.len() as u32;
                parts.push(i as u32, &bezier, [0.0, 1.0], halve, &mut boxes);
                items.extend((first..parts.list.len() as u32).map(Item::Part));
            } else {
                boxes.push(hull_of(piece));
                items.push(Item::Simple(i as u32));
            }
        }
        Self { tree: BoxTree::in_order(&boxes), pieces, items, parts }
    }

    /// The point of the curve nearest to `q`.
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn nearest(&self, q: Point3) -> Result<CurvePoint> {
        check(q)?;
        let found = self.search(xyz(q), f64::INFINITY, BUDGET);
        found.map(|best| self.finish(&best, q)).ok_or(Error::NotFinite("square of the distance to the curve"))
    }

    /// The point of the curve nearest to `q` if it is nearer than `limit`, or `None`. The smaller the limit, the
    /// faster the answer.
    ///
    /// # Errors
    /// `q` is not finite.
    pub fn nearest_within(&self, q: Point3, limit: f64) -> Result<Option<CurvePoint>> {
        check(q)?;
        if !(limit > 0.0) {
            return Ok(None);
        }
        let found = self.search(xyz(q), limit * limit, BUDGET);
        Ok(found.map(|best| self.finish(&best, q)).filter(|p| p.distance < limit))
    }

    /// The nearest points for many places, in their order. Long lists run in parallel with the `parallel` feature.
    ///
    /// # Errors
    /// As [`ClosestOnCurve::nearest`], for any of them.
    pub fn nearest_all(&self, points: &[Point3]) -> Result<Vec<CurvePoint>> {
        #[cfg(feature = "parallel")]
        if points.len() >= 512 {
            use rayon::prelude::*;
            let own = crate::CancellationToken::now();
            let all = points.par_iter().with_min_len(64).map(|&q| own.during(|| self.nearest(q)));
            return crate::parallel::waiting(|| all.collect());
        }
        points.iter().map(|&q| self.nearest(q)).collect()
    }

    fn search(&self, q: [f64; 3], limit: f64, budget: u32) -> Option<Best> {
        let mut best = Best { squared: limit, piece: u32::MAX, place: 0.0 };
        let mut budget = budget;
        self.tree.visit_near(&q, limit, |i| {
            match self.items.get(i) {
                Some(&Item::Part(part)) => self.parts.search(part as usize, q, &mut best, &mut budget),
                Some(&Item::Simple(index)) => self.offer_simple(index, q, &mut best),
                None => (),
            }
            best.squared
        });
        (best.piece != u32::MAX).then_some(best)
    }

    /// Segments and arcs by formula.
    fn offer_simple(&self, index: u32, q: [f64; 3], best: &mut Best) {
        let Some(piece) = self.pieces.get(index as usize) else { return };
        let q = Point3::from(q);
        let own = match piece.shape {
            Shape::Segment(a, b) => {
                let along = b - a;
                // Halved lengths do not overflow before the squares of distances do.
                let x = (q - a).dot(along) / along.length_squared();
                if x.is_finite() { x.clamp(0.0, 1.0) } else { 0.0 }
            }
            Shape::Arc(arc) => arc.closest_angle(q),
            Shape::Span(..) => return,
        };
        best.offer((piece.point(own) - q).length_squared(), index, piece.own.normalized(own));
    }

    fn finish(&self, best: &Best, q: Point3) -> CurvePoint {
        let Some(piece) = self.pieces.get(best.piece as usize) else {
            return CurvePoint { parameter: 0.0, point: q, distance: f64::INFINITY };
        };
        let own = piece.own.at(best.place);
        let point = piece.point(own);
        CurvePoint { parameter: piece.whole_parameter(own), point, distance: point.distance_to(q) }
    }
}

fn check(q: Point3) -> Result<()> {
    if q.is_finite() { cancellation::check() } else { Err(Error::NotFinite("point to project on the curve")) }
}

/// A box that holds a piece: around control points, or around the circle of an arc.
fn hull_of(piece: &Piece<'_>) -> Bounds {
    match piece.shape {
        Shape::Segment(a, b) => bounds_of([xyz(a), xyz(b)]),
        Shape::Arc(arc) => {
            let (r, plane) = (arc.circle.radius, &arc.circle.plane);
            let centre = xyz(plane.origin);
            let (x, y): ([f64; 3], [f64; 3]) = (plane.x_axis.into(), plane.y_axis.into());
            let reach = |c: usize| r * x[c].hypotenuse(y[c]) * (1.0 + WIDER_BOX);
            [std::array::from_fn(|c| centre[c] - reach(c)), std::array::from_fn(|c| centre[c] + reach(c))]
        }
        Shape::Span(curve, j) => bounds_of(curve.span_hull(j).map(xyz)),
    }
}

impl Curve {
    /// The point of the curve nearest to `q`: always the global one, and of equally near ones one of them. For many
    /// questions about one curve use [`ClosestOnCurve`].
    ///
    /// Segments and arcs by formula. NURBS spans by branch and bound on the Bernstein coefficients of the squared
    /// distance: a range is discarded when the coefficients prove it no nearer than the best found, or solved by
    /// Newton's method when they prove that there is one minimum (compare X.-D. Chen et al., *Improved algebraic
    /// algorithm on point projection for Bézier curves*, 2007).
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn closest_point(&self, q: Point3) -> Result<CurvePoint> {
        check(q)?;
        let pieces = self.pieces();
        // Ends first: they cost little, and only pieces that may come nearer need tables.
        let mut limit = f64::INFINITY;
        for piece in &pieces {
            limit = limit.min((piece.start() - q).length_squared()).min((piece.end() - q).length_squared());
        }
        let limit = limit * (1.0 + NEAREST_LIMIT);
        let index =
            ClosestOnCurve::build(pieces, false, |_, hull| !(squared_distance_to(hull, &xyz(q)) > limit));
        index.nearest(q)
    }

    /// The nearest points for many places, in their order. Long lists run in parallel with the `parallel` feature.
    ///
    /// # Errors
    /// As [`Curve::closest_point`], for any of them.
    pub fn closest_points(&self, points: &[Point3]) -> Result<Vec<CurvePoint>> {
        ClosestOnCurve::new(self).nearest_all(points)
    }

    /// The point of the curve nearest to `q` if it is nearer than `limit`, or `None`.
    ///
    /// # Errors
    /// `q` is not finite.
    pub fn closest_point_within(&self, q: Point3, limit: f64) -> Result<Option<CurvePoint>> {
        check(q)?;
        let squared = limit * limit;
        let index = ClosestOnCurve::build(self.pieces(), false, |_, hull| {
            !(squared_distance_to(hull, &xyz(q)) > squared)
        });
        index.nearest_within(q, limit)
    }
}

impl Arc {
    /// The angle, within the arc's own, of its point nearest to `q`; the start for a point on the axis.
    pub fn closest_angle(&self, q: Point3) -> f64 {
        let [x, y, _] = self.circle.plane.coordinates(q);
        let tiny = thresholds::FEW_ROUNDINGS * self.circle.radius;
        if x.abs() <= tiny && y.abs() <= tiny {
            return self.angle.start;
        }
        let (low, high) = (self.angle.min(), self.angle.max());
        let turn = std::f64::consts::TAU;
        let mut angle = y.arctangent_of(x);
        // The representative at or after the lower end.
        angle += ((low - angle) / turn).ceil() * turn;
        if angle <= high {
            return angle;
        }
        // Outside: the nearer end. Going back from `angle − 2π` the lower end is nearer when that is the smaller gap.
        if angle - high <= low - (angle - turn) { high } else { low }
    }
}
