//! What lies inside the border that an offset draws.

use katydid_elementary::Elementary;

use super::RawPart;
use crate::box_tree::{BoxTree, bounds_of};
use crate::curve::ClosestOnCurve;
use crate::offset::thresholds::CUSP_SIDE;
use crate::thresholds;
use crate::{Curve, Plane, Point3, Result, Vector3};

/// The area that fills a sharp corner: the wedge between the normals of its sides, up to straight borders, none of
/// them nearer to the vertex than an arc about it.
#[derive(Debug, Clone)]
pub(super) struct Cap {
    /// The vertex, x to the offset before, y towards that after.
    pub(super) frame: Plane,
    /// The angle of the wedge.
    pub(super) turn: f64,
    /// Half planes that bound it outwards: unit normals, and how far from the vertex.
    pub(super) outer: Vec<(Vector3, f64)>,
    /// Corners of the fill, for its box.
    pub(super) outline: Vec<Point3>,
}

impl Cap {
    /// Whether a point lies in the wedge, without regard to how far out.
    fn holds(&self, q: Point3) -> bool {
        let [x, y, _] = self.frame.coordinates(q);
        let angle = y.arctangent_of(x);
        let angle = if angle < -thresholds::PARALLEL { angle + std::f64::consts::TAU } else { angle };
        angle <= self.turn + thresholds::PARALLEL
    }

    /// How deep below the border a point of the wedge lies; negative outside.
    fn depth(&self, q: Point3) -> f64 {
        let from = q - self.frame.origin;
        self.outer.iter().fold(f64::INFINITY, |m, (n, h)| m.min(h - n.dot(from)))
    }
}

/// The source of an offset, prepared for many questions.
pub(super) struct Validity<'a> {
    whole: ClosestOnCurve<'a>,
    caps: &'a [Cap],
    near_caps: BoxTree,
    plane: &'a Plane,
    distance: f64,
    /// Nearer than this is the same place.
    epsilon: f64,
}

impl<'a> Validity<'a> {
    pub(super) fn new(
        curve: &'a Curve,
        caps: &'a [Cap],
        plane: &'a Plane,
        distance: f64,
        epsilon: f64,
    ) -> Self {
        let boxes: Vec<_> = caps
            .iter()
            .map(|c| bounds_of(c.outline.iter().chain([&c.frame.origin]).map(|&p| p.into())))
            .collect();
        let near_caps = BoxTree::by_place(&boxes);
        Self { whole: ClosestOnCurve::new(curve), caps, near_caps, plane, distance, epsilon }
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
        let near = self.whole.nearest_within(q, reach - 0.005 * self.epsilon)?;
        let mut margin = near.map_or(0.0, |n| n.distance - reach);
        let mut hits = Vec::new();
        let limit = self.epsilon * self.epsilon;
        self.near_caps.visit_near(&q.into(), limit, |i| {
            hits.push(i);
            limit
        });
        for cap in hits.into_iter().filter_map(|i| self.caps.get(i)) {
            if cap.holds(q) {
                margin = margin.min(-cap.depth(q));
            }
        }
        Ok(margin)
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
        let right = if turn.abs() > CUSP_SIDE || arriving.dot(leaving) < 0.0 {
            turn > 0.0
        } else {
            (q - near.point).cross(arriving).dot(self.plane.z_axis) > 0.0
        };
        Ok(right == (self.distance > 0.0))
    }
}
