//! Trims brought to the parameters of their edges.
//!
//! A file says that a curve on a surface is at each parameter where the edge is. Kernels that keep trims and edges
//! apart do not promise that: there a trim runs the same way at another pace. Here it keeps its way and takes the pace
//! of the edge: a chain of cubics through points of the trim, with its tangents, at the parameters of the edge's points
//! nearest to them.

use katydid_geometry::{Curve, NurbsCurve, Point3, Quadrant, Surface, Vector3};

/// Steps of the tables of length, for each span.
const STEPS: usize = 16;
/// The most steps of a table.
const MOST_STEPS: usize = 2048;
/// The most cubics of a chain.
const MOST: usize = 400;
/// How far a chain may leave the trim, in parts of the edge's length.
const FRACTION: f64 = 1e-8;
/// How far it may run ahead of the edge or behind, in parts of the edge's length.
const PACE: f64 = 1e-7;
/// Directions that differ by no more than this many radians go on.
const SMOOTH: f64 = 1e-6;
/// A trim farther from its edge than this part of the edge's length does not belong to it.
const FARTHEST: f64 = 0.02;

/// A place of the trim and the edge's parameter beside it.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// The trim's parameter.
    s: f64,
    /// The edge's.
    t: f64,
}

/// A trim, as it runs along its edge, and that edge.
struct Pair<'a> {
    flat: &'a NurbsCurve,
    space: &'a Curve,
    surface: &'a Surface,
    /// Lengths along the trim's image and along the edge, at equal steps.
    lengths: [Vec<f64>; 2],
}

/// The trim's way at the edge's pace, over the domain of the edge; none where the trim does not follow the edge within
/// the given distance (or a small part of its length).
pub(super) fn at_pace(flat: &Curve, space: &Curve, surface: &Surface, tolerance: f64) -> Option<NurbsCurve> {
    let flat = flat.to_nurbs().ok()?;
    let pair = Pair::new(&flat, space, surface)?;
    let length = pair.length();
    let nodes = pair.nodes(tolerance.max(FARTHEST * length))?;
    pair.chain(&refined(&pair, nodes, FRACTION * length)?)
}

impl<'a> Pair<'a> {
    fn new(flat: &'a NurbsCurve, space: &'a Curve, surface: &'a Surface) -> Option<Self> {
        let spans = flat.span_parameters().len().max(space.to_nurbs().ok()?.span_parameters().len());
        let steps = (STEPS * spans).min(MOST_STEPS);
        let mut pair = Self { flat, space, surface, lengths: [Vec::new(), Vec::new()] };
        let image = |k: usize| pair.image(flat.domain().at(k as f64 / steps as f64));
        let edge = |k: usize| space.point_at(space.domain().at(k as f64 / steps as f64));
        let lengths = [running((0..=steps).map(image)), running((0..=steps).map(edge))];
        pair.lengths = lengths;
        (pair.length() > 0.0 && pair.length().is_finite()).then_some(pair)
    }

    fn image(&self, s: f64) -> Point3 {
        let uv = self.flat.point_at(s);
        self.surface.point_at(uv.x, uv.y)
    }

    fn length(&self) -> f64 {
        self.lengths[1].last().copied().unwrap_or(0.0)
    }

    /// The trim's own breaks and some places between, each with the edge's parameter beside it.
    fn nodes(&self, farthest: f64) -> Option<Vec<Node>> {
        let breaks = self.flat.span_parameters();
        let mut nodes: Vec<Node> = Vec::new();
        let domain = self.space.domain();
        let (first, last) = (*breaks.first()?, *breaks.last()?);
        let each = if self.flat.degree() > 1 { 4 } else { 1 };
        for window in breaks.windows(2) {
            for k in 0..each {
                let s = window[0] + (window[1] - window[0]) * f64::from(k) / f64::from(each);
                let t = if s == first { domain.start } else { self.beside(s)? };
                nodes.push(Node { s, t });
            }
        }
        nodes.push(Node { s: last, t: domain.end });
        let is_near = |node: &Node| self.image(node.s).distance_to(self.space.point_at(node.t)) <= farthest;
        if !nodes.iter().all(is_near) {
            return None;
        }
        // Where the edge seems to run back, as at a gap between trims, places in between are left out.
        let mut forward: Vec<Node> = Vec::with_capacity(nodes.len());
        let least = 1e-9 * domain.length();
        for node in nodes {
            if forward.last().is_none_or(|before| node.t > before.t + least) {
                forward.push(node);
            }
        }
        let end = forward.last_mut()?;
        if end.t != domain.end {
            *end = Node { s: last, t: domain.end };
        }
        (forward.len() >= 2).then_some(forward)
    }

    /// The edge's parameter nearest to the image of the trim at `s`, found from that at the same share of the length.
    fn beside(&self, s: f64) -> Option<f64> {
        let [images, edges] = &self.lengths;
        let steps = images.len().checked_sub(1)?;
        let place = self.flat.domain().normalized(s) * steps as f64;
        let low = (place.floor() as usize).min(steps.checked_sub(1)?);
        let gone = images[low] + (images[low + 1] - images[low]) * (place - low as f64);
        let share = gone / images.last()? * edges.last()?;
        let high = edges.partition_point(|length| *length < share).clamp(1, steps);
        let step = edges[high] - edges[high - 1];
        let part = if step > 0.0 { (share - edges[high - 1]) / step } else { 0.5 };
        let domain = self.space.domain();
        self.foot(self.image(s), domain.at(((high - 1) as f64 + part) / steps as f64))
    }

    /// Newton's method for the foot of a perpendicular on the edge.
    fn foot(&self, point: Point3, mut t: f64) -> Option<f64> {
        let domain = self.space.domain();
        for _ in 0..12 {
            let (at, slope) = self.space_jet(t);
            let speed = slope.dot(slope);
            if speed == 0.0 {
                break;
            }
            let next = (t + (point - at).dot(slope) / speed).clamp(domain.start, domain.end);
            let moved = (next - t).abs();
            t = next;
            if moved <= 1e-14 * domain.length() {
                break;
            }
        }
        t.is_finite().then_some(t)
    }

    fn space_jet(&self, t: f64) -> (Point3, Vector3) {
        let mut jet = [Vector3::ZERO; 2];
        self.space.derivatives_into(t, false, &mut jet);
        (jet[0].to_point(), jet[1])
    }

    /// The trim's derivative by the edge's parameter, on one side of a place.
    fn slope(&self, node: &Node, from_below: bool) -> Vector3 {
        let ends_here = node.s >= self.flat.domain().end;
        let [uv, by_s] = self.flat.jet_at::<2>(node.s, ends_here || (from_below && !self.is_smooth(node)));
        let jet = self.surface.derivatives(uv.x, uv.y, 1, Quadrant::NorthEast);
        let along = jet.get(1, 0) * by_s.x + jet.get(0, 1) * by_s.y;
        let (_, edge) = self.space_jet(node.t);
        let speed = along.dot(along);
        if speed == 0.0 { Vector3::ZERO } else { by_s * (edge.dot(along) / speed).max(0.0) }
    }

    /// The inner control points of the cubic between two nodes.
    fn inner(&self, a: &Node, b: &Node) -> [Point3; 2] {
        let [from, to] = [a, b].map(|node| self.flat.point_at(node.s));
        let third = (b.t - a.t) / 3.0;
        [from + self.slope(a, false) * third, to - self.slope(b, true) * third]
    }

    /// Whether the trim goes on in the same direction.
    fn is_smooth(&self, node: &Node) -> bool {
        let [before, after] = [true, false].map(|below| self.flat.jet_at::<2>(node.s, below)[1]);
        before.angle_to(after).is_none_or(|angle| angle <= SMOOTH)
    }

    /// How far the cubic between two nodes leaves the trim, in space; being ahead of the edge counts less.
    fn error(&self, a: &Node, b: &Node) -> f64 {
        let [from, to] = [a, b].map(|node| self.flat.point_at(node.s));
        let inner = self.inner(a, b);
        let mut worst = 0.0_f64;
        for share in [0.25, 0.5, 0.75] {
            let at = bezier(from, inner, to, share);
            let mut s = a.s + (b.s - a.s) * share;
            let mut off = Vector3::ZERO;
            for _ in 0..6 {
                let [uv, by_s] = self.flat.jet_at::<2>(s, false);
                off = at.to_vector() - uv;
                let speed = by_s.dot(by_s);
                if speed == 0.0 {
                    break;
                }
                s = (s + off.dot(by_s) / speed).clamp(a.s, b.s);
            }
            let jet = self.surface.derivatives(at.x, at.y, 1, Quadrant::NorthEast);
            let (beside, along) = self.space_jet(a.t + (b.t - a.t) * share);
            let ahead = along.unitized().map_or(0.0, |along| (jet.point() - beside).dot(along).abs());
            let aside = (jet.get(1, 0) * off.x + jet.get(0, 1) * off.y).length();
            worst = worst.max(aside).max(ahead * (FRACTION / PACE));
        }
        worst
    }

    /// The cubics as one curve; with a tangent that goes on wherever the trim's does, for many programs refuse curves
    /// that are smooth by chance alone.
    fn chain(&self, nodes: &[Node]) -> Option<NurbsCurve> {
        let (first, last) = (nodes.first()?, nodes.last()?);
        let mut points = vec![self.flat.point_at(first.s)];
        let mut knots = vec![first.t; 3];
        for pair in nodes.windows(2) {
            let (a, b) = (&pair[0], &pair[1]);
            points.extend(self.inner(a, b));
            if b.s < last.s && self.is_smooth(b) {
                knots.extend([b.t; 2]);
            } else {
                points.push(self.flat.point_at(b.s));
                knots.extend([b.t; 3]);
            }
        }
        NurbsCurve::new(3, points, knots).ok()
    }
}

/// Halves steps until each cubic stays by the trim.
fn refined(pair: &Pair<'_>, nodes: Vec<Node>, within: f64) -> Option<Vec<Node>> {
    let domain = pair.space.domain();
    let mut out: Vec<Node> = Vec::with_capacity(nodes.len());
    let mut left: Vec<Node> = nodes.into_iter().rev().collect();
    out.push(left.pop()?);
    while let (Some(a), Some(b)) = (out.last().copied(), left.last().copied()) {
        if pair.error(&a, &b) > within && out.len() + left.len() < MOST {
            let s = 0.5 * (a.s + b.s);
            let t = pair.foot(pair.image(s), 0.5 * (a.t + b.t))?;
            let least = 1e-6 * (b.t - a.t);
            if t > a.t + least && t < b.t - least && b.t - a.t > 1e-7 * domain.length() {
                left.push(Node { s, t });
                continue;
            }
        }
        out.push(b);
        left.pop();
    }
    Some(out)
}

fn bezier(a: Point3, [b, c]: [Point3; 2], d: Point3, x: f64) -> Point3 {
    let (ab, bc, cd) = (a.lerp(b, x), b.lerp(c, x), c.lerp(d, x));
    ab.lerp(bc, x).lerp(bc.lerp(cd, x), x)
}

/// The length gone at each of a row of points.
fn running(points: impl Iterator<Item = Point3>) -> Vec<f64> {
    let mut before: Option<Point3> = None;
    let mut gone = 0.0;
    points
        .map(|p| {
            gone += before.map_or(0.0, |before| p.distance_to(before));
            before = Some(p);
            gone
        })
        .collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail loudly")]
mod tests {
    use super::at_pace;
    use katydid_geometry::{Curve, NurbsCurve, Plane, PlaneSurface, Point3, PolylineCurve, Surface, Vector3};

    fn support() -> Surface {
        let range = katydid_geometry::Interval::new(-10.0, 10.0);
        PlaneSurface::new(Plane::XY, range, range).unwrap().into()
    }

    /// How far a chain leaves its edge at the same parameters.
    fn worst(chain: &NurbsCurve, edge: &Curve) -> f64 {
        assert_eq!(chain.domain(), edge.domain());
        let at = |k: u32| edge.domain().at(f64::from(k) / 500.0);
        (0..=500).map(|k| chain.point_at(at(k)).distance_to(edge.point_at(at(k)))).fold(0.0, f64::max)
    }

    #[test]
    fn a_trim_takes_the_pace_of_its_edge() {
        let points = [(0.0, 0.0), (2.0, 5.0), (4.0, -3.0), (7.0, 6.0), (8.0, 1.0)];
        let points: Vec<Point3> = points.iter().map(|(x, y)| Point3::new(*x, *y, 0.0)).collect();
        let flat = NurbsCurve::clamped_uniform(3, &points).unwrap();
        for factor in [0.2, 1.0, 6.0] {
            let edge: Curve = flat.reparametrized(factor).unwrap().into();
            let chain = at_pace(&flat.clone().into(), &edge, &support(), 1e-6).unwrap();
            assert!(worst(&chain, &edge) < 1e-6, "{factor}: {}", worst(&chain, &edge));
        }
    }

    #[test]
    fn corners_and_gaps_stay() {
        let corner = [Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 4.0, 0.0)];
        let flat: Curve = PolylineCurve::new(corner.to_vec()).unwrap().into();
        // Beside the trim, above the surface, by another pace.
        let off = katydid_geometry::Xform::translation(Vector3::new(0.0, 0.0, 0.01));
        let edge = flat.to_nurbs().unwrap().reparametrized(2.0).unwrap().transformed(&off).unwrap();
        let edge: Curve = edge.into();
        let chain = at_pace(&flat, &edge, &support(), 0.02).unwrap();
        assert!((worst(&chain, &edge) - 0.01).abs() < 1e-6, "{}", worst(&chain, &edge));
        assert!(chain.control_points().iter().any(|p| p.distance_to(corner[1]) < 1e-12));
        // An edge that is elsewhere is not this trim's.
        let far = katydid_geometry::Xform::translation(Vector3::new(0.0, 0.0, 3.0));
        assert!(at_pace(&flat, &edge.transformed(&far).unwrap(), &support(), 0.02).is_none());
    }
}
