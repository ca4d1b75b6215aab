//! What lies inside the border that an offset draws.

use super::RawPart;
use crate::box_tree::{BoxTree, bounds_of};
use crate::curve::{ClosestOnCurve, CurvePoint};
use crate::{Curve, Plane, Point3, Result, Vector3};

/// What bounds a filled corner outwards.
#[derive(Debug, Clone)]
pub(super) enum Outer {
    /// Half planes: unit normals, and how far from the vertex.
    Lines(Vec<(Vector3, f64)>),
    /// A curve from the offset of the side before to that of the side after.
    Blend(Curve),
}

/// The area that fills a corner: the wedge between the normals of its sides, up to a border that is no arc.
#[derive(Debug, Clone)]
pub(super) struct Cap {
    /// The vertex, x to the offset before, y towards that after.
    pub(super) frame: Plane,
    /// The angle of the wedge.
    pub(super) turn: f64,
    pub(super) outer: Outer,
    /// Corners of the fill, for its box.
    pub(super) outline: Vec<Point3>,
}

impl Cap {
    /// Whether a point lies in the wedge, without regard to how far out.
    fn holds(&self, q: Point3) -> bool {
        let [x, y, _] = self.frame.coordinates(q);
        let angle = y.atan2(x);
        let angle = if angle < -1e-9 { angle + std::f64::consts::TAU } else { angle };
        angle <= self.turn + 1e-9
    }

    /// How deep below the border a point of the wedge lies; negative outside.
    fn depth(&self, q: Point3) -> Result<f64> {
        let from = q - self.frame.origin;
        Ok(match &self.outer {
            Outer::Lines(lines) => lines.iter().fold(f64::INFINITY, |m, (n, h)| m.min(h - n.dot(from))),
            Outer::Blend(curve) => {
                let near = curve.closest_point(q)?;
                let along = curve.tangent_at(near.parameter).unwrap_or(Vector3::ZERO);
                (near.point - q).dot(along.cross(self.frame.z_axis))
            }
        })
    }
}

/// The source of an offset, prepared for many questions.
pub(super) struct Validity<'a> {
    whole: ClosestOnCurve<'a>,
    parts: &'a [Curve],
    near_parts: BoxTree,
    caps: &'a [Cap],
    near_caps: BoxTree,
    plane: &'a Plane,
    distance: f64,
    /// Whether the source is closed and does not meet itself.
    simple: bool,
    /// Nearer than this is the same place.
    hair: f64,
}

impl<'a> Validity<'a> {
    pub(super) fn new(
        curve: &'a Curve,
        parts: &'a [Curve],
        caps: &'a [Cap],
        plane: &'a Plane,
        distance: f64,
        (simple, hair): (bool, f64),
    ) -> Self {
        let boxes: Vec<_> = caps
            .iter()
            .map(|c| bounds_of(c.outline.iter().chain([&c.frame.origin]).map(|&p| p.into())))
            .collect();
        let near_caps = BoxTree::by_place(&boxes);
        let boxes: Vec<_> = if caps.is_empty() { Vec::new() } else { parts.iter().map(box_of).collect() };
        let near_parts = BoxTree::by_place(&boxes);
        let whole = ClosestOnCurve::new(curve);
        Self { whole, parts, near_parts, caps, near_caps, plane, distance, simple, hair }
    }

    /// How far a point of a part lies outside what the offset goes round: 0 on its border or outside, negative
    /// within. For an approximated part the exact offset at its parameter is asked, so that the tolerance does not
    /// blur the answer.
    pub(super) fn margin(&self, part: &RawPart, t: f64) -> Result<f64> {
        let exact = part.source.as_ref().and_then(|source| {
            let right = super::right_of(source.tangent_at(t)?, self.plane).ok()?;
            Some(source.point_at(t) + right * self.distance)
        });
        self.margin_at(exact.unwrap_or_else(|| part.curve.point_at(t)))
    }

    fn margin_at(&self, q: Point3) -> Result<f64> {
        let reach = self.distance.abs();
        let mut margin = 0.0_f64;
        if let Some(near) = self.whole.nearest_within(q, reach - 0.005 * self.hair)? {
            if self.in_wedge(q, near.point) {
                // The vertex of a filled corner: the fill decides, and all that is not this vertex.
                let mut hits = Vec::new();
                self.near_parts.visit_near(&q.into(), reach * reach, |i| {
                    hits.push(i);
                    reach * reach
                });
                for part in hits.into_iter().filter_map(|i| self.parts.get(i)) {
                    let Some(near) = part.closest_point_within(q, reach)? else { continue };
                    let mut feet = vec![near];
                    if !matches!(part, Curve::Line(_)) && !self.counts(part, &near, q) {
                        // The part may come back.
                        feet = part.local_closest_points(q)?;
                    }
                    for near in feet.iter().filter(|f| f.distance < reach && self.counts(part, f, q)) {
                        margin = margin.min(near.distance - reach);
                    }
                }
            } else {
                margin = near.distance - reach;
            }
        }
        let mut hits = Vec::new();
        let limit = self.hair * self.hair;
        self.near_caps.visit_near(&q.into(), limit, |i| {
            hits.push(i);
            limit
        });
        for cap in hits.into_iter().filter_map(|i| self.caps.get(i)) {
            if cap.holds(q) {
                margin = margin.min(-cap.depth(q)?);
            }
        }
        Ok(margin)
    }

    /// Whether a foot behind the vertex of a filled corner is in the way: of a simple closed source those inside a
    /// part, seen from the side of the offset.
    fn counts(&self, part: &Curve, foot: &CurvePoint, q: Point3) -> bool {
        if !self.simple {
            return !self.in_wedge(q, foot.point);
        }
        let (t, domain) = (foot.parameter, part.domain());
        let along = part.tangent_at(t).unwrap_or(Vector3::ZERO);
        let right = (q - foot.point).cross(along).dot(self.plane.z_axis);
        domain.start < t && t < domain.end && right * self.distance > 0.0
    }

    /// Whether a point lies on the side of the source to which the offset goes. Tips of sharp corners may reach over
    /// the source to the other.
    pub(super) fn on_own_side(&self, curve: &Curve, q: Point3) -> Result<bool> {
        let near = self.whole.nearest(q)?;
        let (t, domain) = (near.parameter, curve.domain());
        let (mut arriving, mut leaving) = (curve.tangent_on_side(t, true), curve.tangent_on_side(t, false));
        // Over the seam.
        if t <= domain.start {
            arriving = curve.tangent_on_side(domain.end, true);
        } else if t >= domain.end {
            leaving = curve.tangent_on_side(domain.start, false);
        }
        let (Some(arriving), Some(leaving)) = (arriving, leaving) else { return Ok(true) };
        let turn = arriving.cross(leaving).dot(self.plane.z_axis);
        let right = if turn.abs() > 1e-7 || arriving.dot(leaving) < 0.0 {
            turn > 0.0
        } else {
            (q - near.point).cross(arriving).dot(self.plane.z_axis) > 0.0
        };
        Ok(right == (self.distance > 0.0))
    }

    /// Whether a foot is the vertex of a filled corner, seen from its wedge.
    fn in_wedge(&self, q: Point3, foot: Point3) -> bool {
        let mut found = false;
        let limit = self.hair * self.hair;
        self.near_caps.visit_near(&foot.into(), limit, |i| {
            let own = |c: &Cap| c.frame.origin.distance_to(foot) <= self.hair && c.holds(q);
            found = found || self.caps.get(i).is_some_and(own);
            limit
        });
        found
    }
}

fn box_of(curve: &Curve) -> crate::box_tree::Bounds {
    let b = curve.bounding_box();
    [b.min.into(), b.max.into()]
}
