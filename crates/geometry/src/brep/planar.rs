//! Faces in a plane: from closed curves, with holes.

use super::build::{Along, NewEdge, Path};
use super::flatten::flattened;
use super::{Brep, Builder, LoopKind};
use crate::brep::thresholds::LEAST_TOLERANCE;
use crate::intersect::curve_curve;
use crate::region::{Face as Cell, FillRule, Region};
use crate::{BoundingBox, Containment, Curve, Interval, Plane, PlaneSurface, Result, Tolerance, join_curves};

/// A closed chain of edges, each with whether it is walked backwards and its curve, in its own sense.
pub(crate) type Rim = Vec<(NewEdge, bool, Curve)>;

/// What closed curves bound in their planes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlanarFaces {
    /// One brep of one face for each connected region.
    pub breps: Vec<Brep>,
    /// The curves that are not planar, do not close, or enclose nothing, joined where they meet.
    pub left: Vec<Curve>,
}

impl Brep {
    /// The regions that planar curves bound: each outer curve gives a trimmed plane, curves inside it its holes,
    /// curves inside holes new regions, and so on. Open curves are joined first where they meet within the
    /// tolerance. Curves in different planes bound different regions. A normal is that of the first curve's plane,
    /// from which it runs counter-clockwise; the plane's surface reaches as far as the outer curve, its parameters
    /// are coordinates in the plane.
    ///
    /// # Errors
    /// The tolerance is not above 0, or a number overflows.
    pub fn planar_faces(curves: &[Curve], tolerance: &Tolerance) -> Result<PlanarFaces> {
        let limit = tolerance.positive_distance()?;
        let (groups, left) = coplanar(curves, limit);
        let mut found = PlanarFaces { breps: Vec::new(), left };
        for (plane, group) in groups {
            let region = Region::new(&group, FillRule::EvenOdd, &plane, limit)?;
            if region.is_empty() {
                found.left.extend(group);
                continue;
            }
            for cell in region.faces() {
                found.breps.push(of_cell(&plane, cell, tolerance)?);
            }
        }
        Ok(found)
    }
}

impl Brep {
    /// A trimmed plane for each planar closed curve, with the closed curves that lie wholly inside it as holes, curves
    /// inside holes bounding planes again. Curves that touch, cross or cover each other do not know of each other: each
    /// bounds its own plane, as in Rhino. Open curves are joined first where they meet within the tolerance. A normal is
    /// that of the curve's plane, from which it runs counter-clockwise. Beside [`Brep::planar_faces`], for borders that
    /// belong together.
    ///
    /// # Errors
    /// The tolerance is not above 0, or a number overflows.
    pub fn planar_breps(curves: &[Curve], tolerance: &Tolerance) -> Result<PlanarFaces> {
        let limit = tolerance.positive_distance()?;
        let (groups, left) = coplanar(curves, limit);
        let mut found = PlanarFaces { breps: Vec::new(), left };
        for (plane, group) in groups {
            for nest in nests(&plane, &group, limit)? {
                let border: Vec<Curve> = nest.iter().map(|k| group[*k].clone()).collect();
                let region = Region::new(&border, FillRule::EvenOdd, &plane, limit)?;
                if region.is_empty() {
                    found.left.extend(border);
                    continue;
                }
                for cell in region.faces() {
                    found.breps.push(of_cell(&plane, cell, tolerance)?);
                }
            }
        }
        Ok(found)
    }
}

/// Curves of one plane each, and those that are not planar or do not close, joined where they meet.
fn coplanar(curves: &[Curve], limit: f64) -> (Vec<(Plane, Vec<Curve>)>, Vec<Curve>) {
    let mut left = Vec::new();
    let mut groups: Vec<(Plane, Vec<Curve>)> = Vec::new();
    for curve in join_curves(curves, limit, false) {
        let closes = curve.is_closed() || curve.start().distance_to(curve.end()) <= limit;
        let Some(plane) = curve.plane(limit).filter(|_| closes) else {
            left.push(curve);
            continue;
        };
        let flat =
            |plane: &Plane| curve.hull_points().iter().all(|p| plane.signed_distance(*p).abs() <= limit);
        match groups.iter_mut().find(|(known, _)| flat(known)) {
            Some((_, group)) => group.push(curve),
            None => groups.push((plane, vec![curve])),
        }
    }
    (groups, left)
}

/// The outlines of one plane, each with its holes: outlines that lie in an even number of others come first, those
/// directly inside one of them behind it.
fn nests(plane: &Plane, curves: &[Curve], limit: f64) -> Result<Vec<Vec<usize>>> {
    let boxes: Vec<_> = curves.iter().map(|curve| curve.bounding_box_in(plane)).collect();
    let within = |inner: Interval, outer: Interval| outer.min() <= inner.min() && inner.max() <= outer.max();
    let mut around = vec![Vec::new(); curves.len()];
    for (outer, its) in boxes.iter().enumerate() {
        let mut region = None;
        for (inner, other) in boxes.iter().enumerate() {
            if inner == outer || !within(other.x, its.x) || !within(other.y, its.y) {
                continue;
            }
            let met = curve_curve(&curves[outer], &curves[inner], limit)?;
            if !met.crossings.is_empty() || !met.overlaps.is_empty() {
                continue;
            }
            let region = match &region {
                Some(region) => region,
                None => region.insert(Region::new(&curves[outer..=outer], FillRule::Any, plane, limit)?),
            };
            if region.contains(curves[inner].start(), limit)? == Containment::Inside {
                around[inner].push(outer);
            }
        }
    }
    let depth: Vec<usize> = around.iter().map(Vec::len).collect();
    let mut nests: Vec<Vec<usize>> = Vec::new();
    let mut places = vec![None; curves.len()];
    for k in (0..curves.len()).filter(|k| depth[*k].is_multiple_of(2)) {
        places[k] = Some(nests.len());
        nests.push(vec![k]);
    }
    for k in (0..curves.len()).filter(|k| !depth[*k].is_multiple_of(2)) {
        // The innermost of those around it is the one that most others are around.
        let parent = around[k].iter().copied().max_by_key(|outer| depth[*outer]);
        if let Some(nest) = parent.and_then(|outer| places[outer]).and_then(|place| nests.get_mut(place)) {
            nest.push(k);
        }
    }
    Ok(nests)
}

/// The trimmed plane of one face of a region.
pub(crate) fn of_cell(plane: &Plane, cell: &Cell, tolerance: &Tolerance) -> Result<Brep> {
    let mut builder = Builder::new();
    let mut loops = Vec::new();
    for curve in cell.curves() {
        loops.push(rim(&mut builder, curve, tolerance)?);
    }
    add_planar_face(&mut builder, plane, &loops)?;
    builder.finish(tolerance.absolute.max(LEAST_TOLERANCE))
}

/// The edges along a closed curve, one for each stretch without a kink, with the curve of each.
pub(crate) fn rim(builder: &mut Builder, curve: &Curve, tolerance: &Tolerance) -> Result<Rim> {
    let pieces = curve.smooth_runs(tolerance)?;
    let starts: Vec<_> = pieces.iter().map(|piece| builder.vertex(piece.start())).collect();
    let mut out = Vec::with_capacity(pieces.len());
    for (k, piece) in pieces.into_iter().enumerate() {
        let ends = [starts[k], starts[(k + 1) % starts.len()]];
        out.push((builder.edge(piece.clone(), ends), false, piece));
    }
    Ok(out)
}

/// Adds a plane bounded by loops of edges, the outer one first and counter-clockwise, holes clockwise.
pub(crate) fn add_planar_face(builder: &mut Builder, plane: &Plane, loops: &[Rim]) -> Result<()> {
    let mut flat: Vec<Vec<Path>> = Vec::with_capacity(loops.len());
    for chain in loops {
        let mut paths = Vec::with_capacity(chain.len());
        for (edge, backwards, curve) in chain {
            let curve = flattened(curve, plane)?;
            let curve = if *backwards { curve.reversed() } else { curve };
            paths.push(Path { curve, along: Along::Edge(*edge, *backwards) });
        }
        flat.push(paths);
    }
    let bounds = flat.iter().flatten().map(|path| path.curve.bounding_box()).reduce(|a, b| a.union(&b));
    let bounds = bounds.unwrap_or(BoundingBox { min: crate::Point3::ORIGIN, max: crate::Point3::ORIGIN });
    let [x, y] =
        [(bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y)].map(|(a, b)| Interval::new(a, b));
    let face = builder.face(PlaneSurface::new(*plane, x, y)?.into(), false);
    for (place, paths) in flat.into_iter().enumerate() {
        builder.bound(face, if place == 0 { LoopKind::Outer } else { LoopKind::Inner }, paths)?;
    }
    Ok(())
}

impl Curve {
    /// The stretches between kinks, where the direction turns by more than `tolerance.angle`. A curve that has
    /// kinks is cut at its seam too; one without comes back whole. A stretch that openNURBS takes for a point goes with its
    /// neighbour.
    ///
    /// # Errors
    /// A stretch is too short to be a curve.
    pub(crate) fn smooth_runs(&self, tolerance: &Tolerance) -> Result<Vec<Self>> {
        let loose = Tolerance { absolute: f64::INFINITY, angle: tolerance.angle };
        let mut kinks = self.discontinuities(crate::Continuity::G1, &loose);
        if kinks.is_empty() {
            return Ok(vec![self.clone()]);
        }
        let domain = self.domain();
        let thin = |a: f64, b: f64| {
            let [p, q, r] = [a, 0.5 * (a + b), b].map(|t| self.point_at(t));
            p.coincides(q) && p.coincides(r)
        };
        kinks.insert(0, domain.start);
        kinks.dedup_by(|b, a| *a == *b || thin(*a, *b));
        if kinks.len() > 1 && kinks.last().is_some_and(|last| thin(*last, domain.end)) {
            kinks.pop();
        }
        Ok(self.split_at(&kinks)?.into_iter().map(Self::with_segment_as_line).collect())
    }
}
