//! Surfaces from control grids, corners and edge curves.

use super::compatible::compatible_curves;
use super::curve::Controls;
use super::surface::check_net;
use super::uniform::{clamped_uniform_knots, periodic_uniform_knots};
use super::{NurbsCurve, NurbsSurface};
use crate::{Error, Interval, Point3, Result};

/// Checks that a list of points is a grid of `counts[0]` by `counts[1]`.
pub(crate) fn check_grid(counts: [usize; 2], given: usize) -> Result<()> {
    if counts[0].checked_mul(counts[1]) == Some(given) && given > 0 {
        return Ok(());
    }
    Err(Error::Invalid {
        what: "grid of points",
        why: format!("{} by {} points are not {given}", counts[0], counts[1]),
    })
}

impl NurbsSurface {
    /// The surface with uniform clamped knots over a grid of control points, v running fastest; domains
    /// 0…count − degree.
    ///
    /// # Errors
    /// The points are no such grid, there are fewer than degree + 1 in a direction, a degree is not 1…31, or a point
    /// is not finite.
    pub fn clamped_uniform(degrees: [usize; 2], counts: [usize; 2], points: &[Point3]) -> Result<Self> {
        Self::uniform(degrees, counts, points, [false; 2])
    }

    /// The surface with uniform knots over a grid of control points, v running fastest, periodic in those directions
    /// that `periodic` marks and clamped in the others. Where it is periodic the first `degree` lines are repeated
    /// at the end, all knots are simple and the domain is 0…count.
    ///
    /// # Errors
    /// As [`NurbsSurface::clamped_uniform`]; a periodic direction needs as many points as its degree, and two.
    pub fn uniform(
        degrees: [usize; 2],
        counts: [usize; 2],
        points: &[Point3],
        periodic: [bool; 2],
    ) -> Result<Self> {
        check_grid(counts, points.len())?;
        let mut all = counts;
        for d in 0..2 {
            if periodic[d] {
                if counts[d] < degrees[d].max(2) {
                    return Err(Error::Invalid {
                        what: "NURBS control points",
                        why: format!(
                            "a periodic direction of degree {} needs at least {} of them, got {}",
                            degrees[d],
                            degrees[d].max(2),
                            counts[d]
                        ),
                    });
                }
                all[d] = counts[d].saturating_add(degrees[d]);
            }
        }
        let knots = |d: usize| {
            if periodic[d] {
                periodic_uniform_knots(degrees[d], all[d])
            } else {
                clamped_uniform_knots(degrees[d], all[d])
            }
        };
        let knots = [knots(0)?, knots(1)?];
        let mut net = Vec::with_capacity(all[0] * all[1]);
        for i in 0..all[0] {
            let row = (i % counts[0]) * counts[1];
            net.extend((0..all[1]).filter_map(|j| points.get(row + j % counts[1]).copied()));
        }
        Self::new(degrees, all, net, knots)
    }

    /// The Bézier surface with these control points over 0…1 by 0…1, of degrees one less than the counts.
    ///
    /// # Errors
    /// The points are no such grid, a count is not 2…32, or a point is not finite.
    pub fn bezier(counts: [usize; 2], points: &[Point3]) -> Result<Self> {
        Self::clamped_uniform(counts.map(|n| n.saturating_sub(1)), counts, points)
    }

    /// The bilinear surface through four corners, walked round: `a` at the start of both domains, `b` at the end of
    /// u, `c` opposite `a`, `d` at the end of v. Each domain is 0…the longer of its two sides, as openNURBS makes
    /// it.
    ///
    /// # Errors
    /// A corner is not finite.
    pub fn from_corners(a: Point3, b: Point3, c: Point3, d: Point3) -> Result<Self> {
        let length = |x: f64, y: f64| {
            let longer = x.max(y);
            if longer <= f64::EPSILON { 1.0 } else { longer }
        };
        let u = length(a.distance_to(b), c.distance_to(d));
        let v = length(a.distance_to(d), b.distance_to(c));
        Self::new([1, 1], [2, 2], vec![a, d, b, c], [vec![0.0, u], vec![0.0, v]])
    }

    /// The triangle as a bilinear surface whose north side is the point `c`; u runs from `a` to `b`.
    ///
    /// # Errors
    /// A corner is not finite.
    pub fn from_triangle(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        Self::from_corners(a, b, c, c)
    }

    /// The ruled surface between two curves: u runs along both, straight lines in v go from the first, at 0, to the
    /// second, at 1. The curves are made compatible first, see [`compatible_curves`].
    ///
    /// # Errors
    /// Those of [`compatible_curves`].
    pub fn ruled(first: &NurbsCurve, second: &NurbsCurve) -> Result<Self> {
        let curves = compatible_curves(&[first.clone(), second.clone()])?;
        let [a, b] = curves.as_slice() else {
            return Err(Error::degenerate("ruled surface", "a curve is missing"));
        };
        let (count, knots) = (a.point_count(), [a.knots.clone(), vec![0.0, 1.0]]);
        let controls = match (&a.controls, &b.controls) {
            (Controls::Plain(p), Controls::Plain(q)) => {
                Controls::Plain(p.iter().zip(q).flat_map(|(&p, &q)| [p, q]).collect())
            }
            _ => Controls::Rational(
                a.homogeneous_points()
                    .into_iter()
                    .zip(b.homogeneous_points())
                    .flat_map(|(p, q)| [p, q])
                    .collect(),
            ),
        };
        Self::from_controls([a.degree(), 1], [count, 2], controls, knots)
    }

    /// The cone over a curve: straight lines in v go from the curve, at 0, to the apex, at 1.
    ///
    /// # Errors
    /// The apex is not finite.
    pub fn to_apex(curve: &NurbsCurve, apex: Point3) -> Result<Self> {
        let knots = [curve.knots.clone(), vec![0.0, 1.0]];
        let controls = match &curve.controls {
            Controls::Plain(p) => Controls::Plain(p.iter().flat_map(|&p| [p, apex.into()]).collect()),
            Controls::Rational(p) => Controls::Rational(
                p.iter().flat_map(|&p| [p, [apex.x * p[3], apex.y * p[3], apex.z * p[3], p[3]]]).collect(),
            ),
        };
        Self::from_controls([curve.degree(), 1], [curve.point_count(), 2], controls, knots)
    }

    /// The surface of all sums of a point of one curve and a point of another, moved by `shift`: u runs along the
    /// first.
    ///
    /// # Errors
    /// A number overflows, or the surface would have more than ten million control points.
    pub fn sum(first: &NurbsCurve, second: &NurbsCurve, shift: crate::Vector3) -> Result<Self> {
        let (degrees, counts) =
            ([first.degree(), second.degree()], [first.point_count(), second.point_count()]);
        check_net(counts)?;
        let knots = [first.knots.clone(), second.knots.clone()];
        if let (Controls::Plain(p), Controls::Plain(q)) = (&first.controls, &second.controls) {
            let net = p.iter().flat_map(|a| {
                q.iter().map(move |b| [a[0] + b[0] + shift.x, a[1] + b[1] + shift.y, a[2] + b[2] + shift.z])
            });
            return Self::from_controls(degrees, counts, Controls::Plain(net.collect()), knots);
        }
        let (p, q) = (first.homogeneous_points(), second.homogeneous_points());
        let s = [shift.x, shift.y, shift.z];
        let net = p.iter().flat_map(|a| {
            q.iter().map(move |b| {
                let w = a[3] * b[3];
                let at = |i: usize| a[i] * b[3] + b[i] * a[3] + s[i] * w;
                [at(0), at(1), at(2), w]
            })
        });
        Self::from_controls(degrees, counts, Controls::Rational(net.collect()), knots)
    }

    /// The rectangle of a plane between two ranges of its coordinates as a bilinear surface over two domains.
    pub(crate) fn from_plane(
        plane: &crate::Plane,
        extents: [Interval; 2],
        domains: [Interval; 2],
    ) -> Result<Self> {
        let [x, y] = extents;
        let corner = |u: f64, v: f64| plane.at(u, v, 0.0);
        let points = vec![
            corner(x.start, y.start),
            corner(x.start, y.end),
            corner(x.end, y.start),
            corner(x.end, y.end),
        ];
        let knots = domains.map(|d| vec![d.start, d.end]);
        Self::new([1, 1], [2, 2], points, knots)
    }
}
