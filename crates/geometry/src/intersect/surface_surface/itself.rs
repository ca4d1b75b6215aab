//! A surface with itself: offsets, sweeps and pipes that run through themselves.

use super::contacts::{contacts, drop_doubles};
use super::cover::Curves;
use super::search::{boxes_apart, corner_normal, hull};
use super::{BranchKind, SurfaceBranch, SurfaceContactKind, SurfaceMeeting, rows, shifted};
use crate::chart::thresholds::{AT_POLE, MET, SAME_PLACE, SMALLEST, TINY};
use crate::chart::{Breaks, Chart};
use crate::intersect::judge::separated;
use crate::intersect::patch_tree::{PatchNode, PatchTree};
use crate::trace::{Box4, Condition, Four, Limits, Pair, Place, fitted_within};
use crate::{Error, NurbsSurface, Result, Tolerance, Vector3, Xform, cancellation};

/// More pairs of parts of one size than this are not looked at.
const MOST_PAIRS: usize = 400_000;
/// More undecided pairs than this, and the surface lies upon itself.
const MOST_UNDECIDED: usize = 20_000;

/// The curves in which a NURBS surface passes through itself, and the places in which it touches itself. Branches have both
/// images in its one domain, the two ways in which each common point is met.
///
/// # Method
/// As [`surface_surface`](super::surface_surface()), over the pairs of parts of one surface. Two parts beside each other have
/// nothing but their border in common when the surface over the range of both is proved to be a graph: when its derivatives, seen
/// along the normal of the middle and multiplied by the inverse of those there, differ from the unit matrix by less than 1: such a
/// map is one to one on a convex set (the mean value theorem; derived here). At poles and cusps this is
/// never so: what is left undecided there is dropped at poles, and is a contact elsewhere.
///
/// # Errors
/// As [`surface_surface`](super::surface_surface()); also when the surface lies upon itself over a wide range
/// ([`Error::Unsupported`]).
pub fn surface_self(surface: &NurbsSurface, tolerance: &Tolerance) -> Result<SurfaceMeeting> {
    let limit = tolerance.positive_distance()?;
    let bounds = surface.hull_box();
    let shift = bounds.center().to_vector();
    if !(bounds.diagonal().length() > 0.0) {
        return Err(Error::degenerate("surface", "it is a point"));
    }
    let chart = Chart::new(surface.transformed(&Xform::translation(-shift))?)?;
    let pair = Pair::new(&chart, &chart);
    let size = pair.size();
    let mut search =
        SelfSearch { pair, tree: PatchTree::over(chart.nurbs(), chart.nets())?, smallest: SMALLEST * size };
    let (leaves, undecided) = search.places()?;
    let limits = Limits::new(limit, size, pair.noise);
    let mut curves = Curves { found: Vec::new(), limits, complete: true };
    search.follow(&mut curves, leaves)?;
    let mut out = SurfaceMeeting { branches: Vec::new(), contacts: Vec::new(), complete: curves.complete };
    out.contacts = contacts(&pair, &undecided, limit);
    // At a pole a surface meets itself in all directions, and that is nothing.
    let poles = chart.poles();
    out.contacts.retain(|c| poles.iter().all(|p| p.distance_to(c.point) > AT_POLE * size));
    drop_doubles(&mut out.contacts, SAME_PLACE * size);
    out.complete &= curves.stuck().is_empty();
    out.complete &= out.contacts.iter().all(|c| c.kind != SurfaceContactKind::Undecided);
    for row in rows::joined(&pair, std::mem::take(&mut curves.found), Breaks::Turns) {
        let fit = fitted_within(&pair, &row.places, limit)?;
        out.branches.push(SurfaceBranch {
            curve: fit.curve,
            parameters: fit.parameters,
            deviation: fit.deviation,
            closed: row.closed,
            kind: BranchKind::Followed,
        });
    }
    shifted(out, shift)
}

/// A pair of parts whose common curve is a graph over a direction.
struct SelfLeaf {
    nodes: [u32; 2],
    along: Vector3,
}

/// The search over pairs of parts of one surface.
struct SelfSearch<'a> {
    pair: Pair<'a>,
    tree: PatchTree<'a>,
    smallest: f64,
}

/// The same place with its two ways exchanged.
fn exchanged([a, b, c, d]: Four) -> Four {
    [c, d, a, b]
}

impl SelfSearch<'_> {
    fn places(&mut self) -> Result<(Vec<SelfLeaf>, Vec<Box4>)> {
        let (mut leaves, mut undecided) = (Vec::new(), Vec::new());
        let mut level = vec![[self.tree.root; 2]];
        while !level.is_empty() {
            cancellation::room::<[u32; 2]>(level.len())?;
            if level.len() > MOST_PAIRS || undecided.len() > MOST_UNDECIDED {
                return Err(Error::Unsupported("a surface that lies upon itself over a wide range"));
            }
            let mut next = Vec::new();
            for nodes in level.drain(..) {
                cancellation::check()?;
                if self.is_apart(nodes) || self.is_embedded(nodes) {
                    continue;
                }
                if let Some(leaf) = self.leaf(nodes) {
                    leaves.push(leaf);
                } else if self.is_smallest(nodes) {
                    undecided.push(self.bounds(nodes));
                } else {
                    self.divide(nodes, &mut next);
                }
            }
            level = next;
        }
        Ok((leaves, undecided))
    }

    fn node(&self, index: u32) -> &PatchNode {
        &self.tree.nodes[index as usize]
    }

    fn bounds(&self, nodes: [u32; 2]) -> Box4 {
        let [[a, b], [c, d]] = nodes.map(|n| self.node(n).ranges);
        [a, b, c, d]
    }

    fn is_smallest(&self, nodes: [u32; 2]) -> bool {
        nodes.iter().all(|n| {
            let node = self.node(*n);
            node.patch().is_some() && node.size_squared() < self.smallest * self.smallest
        })
    }

    /// The pairs of halves; of a part with itself those of its halves with themselves and with each other.
    fn divide(&mut self, nodes: [u32; 2], out: &mut Vec<[u32; 2]>) {
        let [a, b] = nodes;
        if a == b {
            if let Some((l, r)) = self.tree.children(a) {
                out.extend([[l, l], [l, r], [r, r]]);
            }
            return;
        }
        let sizes = nodes.map(|n| self.node(n).size_squared());
        let larger = usize::from(sizes[1] > sizes[0]);
        for s in [larger, 1 - larger] {
            if let Some((l, r)) = self.tree.children(nodes[s]) {
                out.extend([l, r].map(|half| if s == 0 { [half, b] } else { [a, half] }));
                return;
            }
        }
    }

    fn is_apart(&self, nodes: [u32; 2]) -> bool {
        if nodes[0] == nodes[1] {
            return false;
        }
        let reach = MET * self.pair.noise;
        let [a, b] = nodes.map(|n| self.node(n));
        if (0..3).any(|k| a.min[k] > b.max[k] + reach || b.min[k] > a.max[k] + reach) {
            return true;
        }
        if a.patch().is_none() || b.patch().is_none() {
            return false;
        }
        let hulls = [a, b].map(|node| hull(self.tree.points(node)));
        if (a.is_loose() || b.is_loose()) && boxes_apart(&hulls, reach) {
            return true;
        }
        let [m, n] = [0, 1].map(|s| corner_normal(&hulls[s], self.tree.counts));
        let along = m.cross(n);
        [m, n, along, m.cross(along), n.cross(along)]
            .iter()
            .any(|d| separated(&hulls[0], &hulls[1], *d, reach))
    }

    /// Whether two parts that are one or beside each other, also across a seam, are proved to have no other point in common than
    /// those of their border.
    fn is_embedded(&self, nodes: [u32; 2]) -> bool {
        if nodes.iter().any(|n| self.node(*n).patch().is_none()) {
            return false;
        }
        let [a, b] = nodes.map(|n| self.node(n).ranges);
        let chart = self.pair.charts[0];
        let turns = |k: usize| chart.period(k).map_or(vec![0.0], |p| vec![0.0, p, -p]);
        for du in turns(0) {
            for dv in turns(1) {
                let moved = [b[0].map(|t| t + du), b[1].map(|t| t + dv)];
                let beside = (0..2).all(|k| a[k][0] <= moved[k][1] && moved[k][0] <= a[k][1]);
                if beside
                    && is_graph(chart, [0, 1].map(|k| [a[k][0].min(moved[k][0]), a[k][1].max(moved[k][1])]))
                {
                    return true;
                }
            }
        }
        false
    }

    fn leaf(&self, nodes: [u32; 2]) -> Option<SelfLeaf> {
        if nodes[0] == nodes[1] || nodes.iter().any(|n| self.node(*n).patch().is_none()) {
            return None;
        }
        let bounds = self.bounds(nodes);
        let jets = self.pair.jets(bounds.map(|[a, b]| 0.5 * (a + b)));
        let [m, n] = jets.map(|j| j[1].cross(j[2]).unitized());
        let along = m?.cross(n?).unitized()?;
        self.pair.is_graph(self.pair.grown(bounds, 0.5), along).then_some(SelfLeaf { nodes, along })
    }

    /// Follows the curves through leaves, each once.
    fn follow(&mut self, curves: &mut Curves, leaves: Vec<SelfLeaf>) -> Result<()> {
        let mut stack = leaves;
        stack.reverse();
        let tiny = TINY * self.smallest;
        while let Some(leaf) = stack.pop() {
            cancellation::check()?;
            let bounds = self.bounds(leaf.nodes);
            let wide = self.pair.grown(bounds, 0.5);
            let [a, b, c, d] = wide;
            if curves.found.iter().any(|f| f.enters(&wide) || f.enters(&[c, d, a, b])) {
                continue;
            }
            let jets = self.pair.jets(bounds.map(|[a, b]| 0.5 * (a + b)));
            let through = (jets[0][0] + jets[1][0]) * 0.5;
            let slice = Condition::Slice { through, across: leaf.along };
            if let Some(start) = self.start(&wide, slice) {
                let known = |x: Four| curves.found.iter().any(|f| f.holds(x, start.point));
                if !known(start.x) && !known(exchanged(start.x)) {
                    curves.add_through(&self.pair, start)?;
                }
                continue;
            }
            if leaf.nodes.iter().all(|n| self.node(*n).size_squared() < tiny * tiny) {
                continue;
            }
            let mut pairs = Vec::new();
            self.divide(leaf.nodes, &mut pairs);
            pairs.retain(|n| !self.is_apart(*n));
            stack.extend(pairs.into_iter().rev().map(|nodes| SelfLeaf { nodes, along: leaf.along }));
        }
        Ok(())
    }

    /// The common point of the box, where the surface is met in two ways.
    fn start(&self, wide: &Box4, slice: Condition) -> Option<Place> {
        let x = self.pair.polished(wide.map(|[a, b]| 0.5 * (a + b)), slice)?;
        // Outside the box it may be any point with itself.
        if (0..4).any(|k| !(wide[k][0] <= x[k] && x[k] <= wide[k][1])) {
            return None;
        }
        self.pair.place(self.pair.clamped(x))
    }
}

/// Whether the surface over ranges of the parameters is proved to be a graph over the plane of its middle.
fn is_graph(chart: &Chart, ranges: [[f64; 2]; 2]) -> bool {
    let domains = [0, 1].map(|k| chart.domain(k));
    let middle = ranges.map(|[a, b]| 0.5 * (a + b));
    let jet = chart.jet(middle);
    let Some(normal) = jet[1].cross(jet[2]).unitized() else { return false };
    let Some(e) = jet[1].unitized() else { return false };
    let f = normal.cross(e);
    // The inverse of the derivatives in the middle, seen along the normal: they are (a, b; 0, d).
    let (a, b, d) = (jet[1].dot(e), jet[2].dot(e), jet[2].dot(f));
    if !(a * d > 0.0) {
        return false;
    }
    // Rows that take a vector of space to parameters, in the unit of the range so that no direction's unit matters.
    let widths = ranges.map(|[a, b]| b - a);
    let rows = [(e / a - f * (b / (a * d))) / widths[0], f / (d * widths[1])];
    for u in parts(ranges[0], domains[0], chart.period(0)) {
        for v in parts(ranges[1], domains[1], chart.period(1)) {
            let slopes = chart.slopes_over([u, v]);
            for (i, row) in rows.iter().enumerate() {
                let vectors = widths.map(|w| *row * w);
                let ranges = slopes.along(vectors, vectors.map(|r| r.x.abs() + r.y.abs() + r.z.abs()));
                let off: f64 =
                    ranges.iter().enumerate().map(|(j, r)| r.off(if i == j { 1.0 } else { 0.0 })).sum();
                if !(off < LEAST_SHRINK) {
                    return false;
                }
            }
        }
    }
    true
}

/// A map that differs from the unit map by less than this part is one to one, also after rounding.
const LEAST_SHRINK: f64 = 0.99;

/// The parts of a range in the domain: two across a seam.
fn parts(range: [f64; 2], domain: crate::Interval, period: Option<f64>) -> Vec<[f64; 2]> {
    let mut out = Vec::new();
    let period = period.unwrap_or(0.0);
    for shift in if period > 0.0 { vec![0.0, period, -period] } else { vec![0.0] } {
        let part = [(range[0] + shift).max(domain.start), (range[1] + shift).min(domain.end)];
        if part[0] < part[1] {
            out.push(part);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

    use super::surface_self;
    use crate::{
        Curve, NurbsCurve, NurbsSurface, Plane, Point3, Sphere, SumSurface, Surface, Tolerance, Torus,
        Vector3,
    };

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-5, ..Tolerance::default() }
    }

    /// A loop that crosses itself once: the wall over it meets itself in one line.
    #[test]
    fn a_wall_over_a_loop() {
        let points = [(0.0, 0.0), (4.0, 3.0), (2.0, 6.0), (0.0, 3.0), (4.0, 0.0)];
        let points: Vec<Point3> = points.iter().map(|(x, y)| Point3::new(*x, *y, 0.0)).collect();
        let curve: Curve = NurbsCurve::clamped_uniform(3, &points).unwrap().into();
        let own = crate::intersect::curve_self(&curve, 1e-9).unwrap();
        let [crossing] = &own.crossings[..] else { panic!("{own:?}") };
        let wall = Surface::from(SumSurface::extrusion(curve, Vector3::new(0.0, 0.0, 2.0)).unwrap());
        let met = surface_self(&wall.to_nurbs().unwrap(), &tolerance()).unwrap();
        let [line] = &met.branches[..] else { panic!("{}", met.branches.len()) };
        assert!(met.complete && met.contacts.is_empty() && !line.closed);
        assert!((line.curve.length() - 2.0).abs() < 1e-9);
        let p = line.curve.start();
        assert!((p.x - crossing.point.x).hypot(p.y - crossing.point.y) < 1e-9);
        // Both images are different.
        let [a, b] = [0, 1].map(|s| line.parameters[s].point_at(line.parameters[s].domain().start));
        assert!(a.distance_to(b) > 0.1);
    }

    #[test]
    fn surfaces_without_a_crossing() {
        let ring = Surface::from(Torus::new(Plane::XY, 5.0, 2.0).unwrap());
        let ball = Surface::from(Sphere::around(Point3::ORIGIN, 2.0).unwrap());
        let tube =
            Surface::from(crate::Cylinder::new(Plane::XY, 1.0, crate::Interval::new(0.0, 3.0)).unwrap());
        for s in [ring, ball, tube] {
            let met = surface_self(&s.to_nurbs().unwrap(), &tolerance()).unwrap();
            assert!(met.branches.is_empty() && met.complete && met.contacts.is_empty(), "{met:?}");
        }
    }

    /// A strip that turns over on its way: it runs through itself as a helicoid whose axis is crossed twice does not, a bent
    /// sheet that dips through itself does.
    #[test]
    fn a_bent_sheet() {
        // x = u³ − u, z = u², a nodal cubic: it crosses itself in (0, 1) at u = ±1; the height of the crossing varies with v.
        let n = 9;
        let points: Vec<Point3> = (0..n * 5)
            .map(|k| {
                let u = -1.5 + 3.0 * (k / 5) as f64 / (n - 1) as f64;
                let v = (k % 5) as f64 / 4.0;
                Point3::new(u * u * u - u, 2.0 * v, u * u + 0.2 * v * v)
            })
            .collect();
        let sheet = NurbsSurface::clamped_uniform([3, 3], [n, 5], &points).unwrap();
        let met = surface_self(&sheet, &tolerance()).unwrap();
        assert_eq!(met.branches.len(), 1);
        assert!(met.complete && !met.branches[0].closed);
        assert!(met.branches[0].curve.length() >= 2.0);
    }
}
