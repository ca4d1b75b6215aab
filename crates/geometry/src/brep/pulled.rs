//! Edges pulled to a surface on which they lie, or nearly, beside a trim that tells where.

use super::Brep;
use crate::brep::thresholds::OF_THE_GAP;
use crate::surface::LocalFoot;
use crate::{Curve, Direction, NurbsCurve, Point3, PolyCurve, Result, Surface, Tolerance, Vector3};

/// Steps along each smooth stretch of an edge, if there are few.
const STEPS: usize = 4;
/// Stretches above which one step each has to do.
const MANY: usize = 64;
/// The shortest step, as a part of the stretch.
const SHORTEST: f64 = 1e-3;
/// The most halvings of a step.
const DEEPEST: u32 = 10;
/// The most cubics.
const MOST: usize = 2_000;
/// The widest step in search of a foot, in parts of the domain.
const WIDEST: f64 = 0.05;
/// Parameters nearer than this part of the domain are one.
const SAME: f64 = 1e-9;
/// A derivative that changes by no more than this part of it goes on.
const SMOOTH: f64 = 1e-6;

/// A parameter of the edge, and the parameters of its foot on the surface.
#[derive(Clone, Copy)]
struct Node {
    t: f64,
    uv: [f64; 2],
}

/// A way along an edge, from foot to foot.
struct Walk<'a> {
    foot: LocalFoot<'a>,
    edge: &'a Curve,
    /// No foot is farther.
    farthest: f64,
}

/// The feet of an edge's points as a curve in the parameter plane with the edge's own parameter, within about a limit;
/// and how far its image is from the edge. The search goes along the edge from foot to foot, and begins at the trim's
/// start: it stays beside the trim where the surface comes near the edge elsewhere too. None where a foot is farther
/// than twice the gap between trim and edge, the way does not end beside the trim's end, or the trim is a side of the
/// surface that the edge crosses.
pub(super) fn pulled(
    surface: &Surface,
    edge: &Curve,
    trim: &Curve,
    gap: f64,
    limit: f64,
) -> Option<(Curve, f64)> {
    let limit = limit.max(OF_THE_GAP * gap);
    let foot = LocalFoot { surface, periods: [None; 2] };
    let walk = Walk { foot, edge, farthest: 2.0 * gap + limit };
    let stretches = edge.smooth_stretches();
    let steps = if stretches.len() > MANY { 1 } else { STEPS };
    let mut uv = walk.beside(edge.point_at(edge.domain().start), [trim.start().x, trim.start().y])?;
    let mut nodes: Vec<Node> = vec![Node { t: edge.domain().start, uv }];
    let mut joints = Vec::new();
    let mut width = 0.0_f64;
    for stretch in stretches {
        let (whole, mut step) = (stretch.length(), stretch.length() / steps as f64);
        while nodes.last()?.t < stretch.end {
            if nodes.len() > MOST {
                return None;
            }
            let last = *nodes.last()?;
            let rest = stretch.end - last.t;
            let t = if step < (1.0 - SAME) * rest { last.t + step } else { stretch.end };
            let slope = walk.slope(&last, false).unwrap_or(Vector3::ZERO) * (t - last.t);
            let guess = [last.uv[0] + slope.x, last.uv[1] + slope.y];
            let Some(foot) = walk.beside(edge.point_at(t), guess) else {
                // The way bends more than one step shows.
                step *= 0.5;
                if step < SHORTEST * whole {
                    return None;
                }
                continue;
            };
            uv = foot;
            width = width.max(walk.refined(&mut nodes, Node { t, uv }, limit)?);
        }
        joints.push(nodes.len() - 1);
    }
    let end = trim.end();
    let strays = Direction::BOTH.into_iter().zip([end.x, end.y]).any(|(direction, want)| {
        let reach = 2.0 * WIDEST * surface.domain(direction).length();
        (uv[direction.index()] - want).abs() > reach
    });
    let apart = surface.point_at(uv[0], uv[1]).distance_to(surface.point_at(end.x, end.y));
    if strays || apart > 2.0 * walk.farthest {
        return None;
    }
    Some((walk.curve(&nodes, &joints, walk.held(trim, &nodes)?)?, width))
}

impl Brep {
    /// The edge of a trim as a curve in the parameter plane of the trim's face: the feet of its points on the surface,
    /// found from the trim. Only where the trim's image is farther from the edge than the tolerance, as in files whose
    /// trims were drawn roughly; none where it is not, or where the edge cannot be followed. `edge` is the edge itself
    /// in any form ([`Brep::edge_as_curve`]), whose direction and parameters the result has.
    ///
    /// # Errors
    /// The tolerance is not above 0.
    pub fn edge_beside_trim(
        &self,
        trim: usize,
        edge: &Curve,
        tolerance: &Tolerance,
    ) -> Result<Option<Curve>> {
        let limit = tolerance.positive_distance()?;
        Ok(self.edge_on_surface(trim, edge, limit))
    }

    fn edge_on_surface(&self, place: usize, edge: &Curve, limit: f64) -> Option<Curve> {
        let parts = self.parts();
        let trim = parts.trims.get(place)?;
        let own = parts.edges.get(trim.edge?)?;
        let gap = parts.distance(trim, own, parts.edge_curve(own)?);
        if gap <= limit {
            return None;
        }
        let flat = self.trim_as_curve(place).ok()??;
        let flat = if trim.reversed { flat.reversed() } else { flat };
        pulled(parts.trim_surface(trim)?, edge, &flat, gap, 0.1 * limit).map(|(curve, _)| curve)
    }
}

impl Walk<'_> {
    /// The parameters that do not change: those that do not along the trim, if the feet keep to them too. None where
    /// they do not change along the trim because the surface ends there, and the edge is beyond that side for a while:
    /// the feet would leave the side and come back to it, and a face that ends with its surface ends there.
    fn held(&self, trim: &Curve, nodes: &[Node]) -> Option<[Option<f64>; 2]> {
        let bounds = trim.bounding_box();
        let ranges = [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)];
        let mut out = [None; 2];
        for direction in Direction::BOTH {
            let k = direction.index();
            let (low, high) = ranges[k];
            let near = SAME * self.foot.surface.domain(direction).length();
            if high - low > near {
                continue;
            }
            if nodes.iter().all(|node| (node.uv[k] - low).abs() <= near) {
                out[k] = Some(low);
            } else if nodes
                .iter()
                .any(|node| self.foot.is_beyond_side(node.uv, self.edge.point_at(node.t))[k])
            {
                return None;
            }
        }
        Some(out)
    }

    fn beside(&self, point: Point3, guess: [f64; 2]) -> Option<[f64; 2]> {
        let (uv, _) = self.foot.polished(guess, point, WIDEST);
        (self.foot.image(Point3::new(uv[0], uv[1], 0.0)).distance_to(point) <= self.farthest).then_some(uv)
    }

    /// How far a place is outside the domain, as it would be measured on the surface.
    fn outside(&self, place: Point3) -> f64 {
        let surface = self.foot.surface;
        let [u, v] =
            [(Direction::U, place.x), (Direction::V, place.y)].map(|(d, t)| surface.domain(d).clamp(t));
        if (u, v) == (place.x, place.y) {
            return 0.0;
        }
        let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
        (d.get(1, 0) * (place.x - u) + d.get(0, 1) * (place.y - v)).length()
    }

    fn slope(&self, node: &Node, below: bool) -> Option<Vector3> {
        let [place, velocity] = self.edge.jet_at::<2>(node.t, below);
        self.foot.slope(node.uv, place, velocity).map(|[x, y]| Vector3::new(x, y, 0.0))
    }

    /// The slopes at both ends of a step; that of the chord where the surface is singular.
    fn slopes(&self, a: &Node, b: &Node) -> [Vector3; 2] {
        let chord = Vector3::new(b.uv[0] - a.uv[0], b.uv[1] - a.uv[1], 0.0) / (b.t - a.t);
        [self.slope(a, false).unwrap_or(chord), self.slope(b, true).unwrap_or(chord)]
    }

    /// Adds a node, and so many before it that cubics between them keep to the feet; how far they are from the edge.
    fn refined(&self, nodes: &mut Vec<Node>, to: Node, limit: f64) -> Option<f64> {
        let mut width = 0.0_f64;
        let mut left = vec![(to, 0)];
        while let Some((b, depth)) = left.pop() {
            let a = nodes.last()?;
            let h = b.t - a.t;
            let [from, to] = self.slopes(a, &b).map(|slope| slope * h);
            let at = |uv: [f64; 2]| Point3::new(uv[0], uv[1], 0.0);
            let cubic = NurbsCurve::hermite(at(a.uv), from, at(b.uv), to).ok()?;
            let (mut off, mut wide) = (0.0_f64, 0.0_f64);
            for x in [0.25, 0.5, 0.75] {
                let (place, point) = (cubic.point_at(x), self.edge.point_at(a.t + h * x));
                let image = self.foot.image(place);
                let foot = self.beside(point, [place.x, place.y]);
                // The image is that of the nearest place of the domain.
                off = off.max(self.outside(place));
                off = off.max(foot.map_or(f64::INFINITY, |uv| self.foot.image(at(uv)).distance_to(image)));
                wide = wide.max(image.distance_to(point));
            }
            if off <= limit || (depth >= DEEPEST && off <= self.farthest) {
                width = width.max(wide);
                nodes.push(b);
                continue;
            }
            if nodes.len() + left.len() > MOST || depth >= DEEPEST {
                return None;
            }
            let (t, place) = (a.t + 0.5 * h, cubic.point_at(0.5));
            let uv = self.beside(self.edge.point_at(t), [place.x, place.y])?;
            left.push((b, depth + 1));
            left.push((Node { t, uv }, depth + 1));
        }
        Some(width)
    }

    /// Cubics through the nodes, as one wherever the edge goes on smoothly: programs take a joint of two for a corner.
    fn curve(&self, nodes: &[Node], joints: &[usize], held: [Option<f64>; 2]) -> Option<Curve> {
        let along = |slope: Vector3| {
            let [x, y] = [(held[0], slope.x), (held[1], slope.y)].map(|(held, x)| held.map_or(x, |_| 0.0));
            Vector3::new(x, y, 0.0)
        };
        let at = |node: &Node| Point3::new(held[0].unwrap_or(node.uv[0]), held[1].unwrap_or(node.uv[1]), 0.0);
        let (mut curves, mut starts): (Vec<Curve>, Vec<f64>) = (Vec::new(), Vec::new());
        let (mut points, mut slopes, mut places) = (Vec::new(), Vec::new(), Vec::new());
        let mut joints = joints.iter().peekable();
        for (k, pair) in nodes.windows(2).enumerate() {
            let [from, to] = self.slopes(&pair[0], &pair[1]).map(along);
            points.push(at(&pair[0]));
            slopes.push(from);
            places.push(pair[0].t);
            let is_joint = joints.next_if(|joint| **joint == k + 1).is_some();
            let goes_on = nodes.get(k + 2).is_some_and(|next| {
                let after = along(self.slopes(&pair[1], next)[0]);
                !is_joint || (after - to).length() <= SMOOTH * to.length()
            });
            if !goes_on {
                points.push(at(&pair[1]));
                slopes.push(to);
                places.push(pair[1].t);
                starts.extend(places.first());
                curves.push(NurbsCurve::hermite_through(&points, &slopes, &places).ok()?.into());
                (points, slopes, places) = (Vec::new(), Vec::new(), Vec::new());
            }
        }
        starts.push(self.edge.domain().end);
        match <[Curve; 1]>::try_from(curves) {
            Ok([only]) => Some(only),
            Err(curves) => Some(PolyCurve::with_parameters(curves, starts).ok()?.into()),
        }
    }
}
