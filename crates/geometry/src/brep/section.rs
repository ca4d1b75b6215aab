//! Sections of breps by planes.

mod pieces;

use crate::brep::thresholds::{PLANE_ROUNDING, SECTION_GAP, SIDE_STEP, SIDE_STEPS};
use crate::thresholds;
use std::sync::Arc as Shared;

use katydid_elementary::Elementary;
use pieces::Cut;

use super::{Brep, ClosestOnBrep};
use crate::{
    Curve, Error, Interval, Plane, Point3, Result, Surface, Tolerance, intersect::curve_plane, join_curves,
};

/// What a plane and a brep have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepSection {
    /// The curves in which the plane passes through the faces, or along which they end in it, joined: closed ones where
    /// a plane cuts a solid.
    pub curves: Vec<Curve>,
    /// Points where an edge or a corner touches the plane beside all curves.
    pub points: Vec<Point3>,
    /// Whether the search came to its end on every face.
    pub complete: bool,
}

/// A brep prepared to be cut by many planes.
#[derive(Debug)]
pub struct BrepSections {
    search: ClosestOnBrep,
    tolerance: Tolerance,
    size: f64,
    /// How far from the origin the brep reaches.
    remote: f64,
}

/// What an edge has in common with the plane.
#[derive(Debug, Default)]
struct EdgeContacts {
    /// Where it passes through or touches.
    points: Vec<Point3>,
    /// The stretches of it that lie in the plane.
    stretches: Vec<(Interval, Curve)>,
}

impl BrepSections {
    /// Prepares a brep.
    ///
    /// # Errors
    /// The brep has no faces, a surface without a NURBS form or a loop without curves; or the tolerance is not above 0.
    pub fn new(brep: Shared<Brep>, tolerance: &Tolerance) -> Result<Self> {
        tolerance.positive_distance()?;
        let bounds = brep.bounds_of_faces().ok_or(Error::degenerate("brep", "it has no faces"))?;
        let size = bounds.diagonal().length();
        let remote = [bounds.min, bounds.max].map(|p| p.to_vector().length()).into_iter().fold(0.0, f64::max);
        Ok(Self { search: ClosestOnBrep::new(brep)?, tolerance: *tolerance, size, remote })
    }

    /// What a plane cuts out of the brep.
    ///
    /// Where an edge pierces the plane the curves of the faces beside it meet exactly; between edges they are those of
    /// [`surface_plane`](crate::intersect::surface_plane), within the trims. Edges in the plane belong to the section
    /// where the brep passes through the plane there, ends, or goes on in the plane: the outline of a face that lies in
    /// the plane, but not a ridge that only touches it.
    ///
    /// # Errors
    /// The plane is not finite, or a number overflows.
    pub fn cut(&self, plane: &Plane) -> Result<BrepSection> {
        if !plane.is_finite() {
            return Err(Error::NotFinite("plane"));
        }
        let contacts = self.contacts(plane)?;
        let mut out = BrepSection { curves: Vec::new(), points: Vec::new(), complete: true };
        for (edge, found) in contacts.iter().enumerate() {
            for (range, stretch) in &found.stretches {
                if self.shows(edge, *range, plane) {
                    out.curves.push(stretch.clone());
                }
            }
        }
        for sheet in self.search.sheets() {
            let range = sheet.bounds.range_of_distances(plane);
            let noise = self.noise(plane);
            if range.start > noise || range.end < -noise {
                continue;
            }
            let cut = Cut { sections: self, sheet, plane, contacts: &contacts };
            cut.add_to(&mut out)?;
        }
        let gap = 0.5
            * self.tolerance.absolute.min(SECTION_GAP * self.size).max(thresholds::SAME_POINT * self.size);
        out.curves = join_curves(&out.curves, gap, false);
        self.add_points(&contacts, plane, &mut out)?;
        Ok(out)
    }

    fn brep(&self) -> &Brep {
        self.search.brep()
    }

    /// How far rounding may move a point from the plane: what of the size is lost on curves and surfaces, and some
    /// units in the last place of coordinates far from the origin, which every step to a point loses anew.
    fn noise(&self, plane: &Plane) -> f64 {
        PLANE_ROUNDING * self.size
            + thresholds::FEW_ROUNDINGS * plane.origin.to_vector().length().max(self.remote)
    }

    fn contacts(&self, plane: &Plane) -> Result<Vec<EdgeContacts>> {
        let mut out: Vec<EdgeContacts> = Vec::new();
        out.resize_with(self.brep().edges().len(), EdgeContacts::default);
        let noise = self.noise(plane);
        for (edge, curve, bounds) in self.search.edge_curves() {
            let range = bounds.range_of_distances(plane);
            let Some(own) = out.get_mut(*edge) else { continue };
            if range.start > noise || range.end < -noise {
                continue;
            }
            let found = curve_plane(curve, plane, noise)?;
            own.points.extend(found.crossings.iter().map(|t| curve.point_at(*t)));
            for stretch in found.overlaps {
                let domain = curve.domain();
                let whole = stretch.start <= domain.start && domain.end <= stretch.end;
                let part = if whole { curve.clone() } else { curve.trimmed(stretch)? };
                own.points.extend([part.start(), part.end()]);
                own.stretches.push((stretch, part));
            }
        }
        Ok(out)
    }

    /// Whether a stretch of an edge in the plane belongs to the section.
    fn shows(&self, edge: usize, range: Interval, plane: &Plane) -> bool {
        let brep = self.brep();
        let trims = brep.edges().get(edge).map_or(&[] as &[usize], |e| &e.trims);
        let sides: Vec<i8> = trims.iter().filter_map(|trim| self.side(*trim, edge, range, plane)).collect();
        match sides.as_slice() {
            [] => false,
            [_] => true,
            [0, 0] => false,
            sides => sides.windows(2).any(|w| w.first() != w.last()),
        }
    }

    /// On which side of the plane a face lies next to a stretch of its edge; 0 for in it.
    fn side(&self, trim: usize, edge: usize, range: Interval, plane: &Plane) -> Option<i8> {
        let brep = self.brep();
        let own = brep.trims().get(trim)?;
        let surface = brep.face_surface(brep.face_of(trim)?)?;
        let whole = brep.edges().get(edge)?.part.domain;
        let share = (range.middle() - whole.start) / whole.length();
        let share = if own.reversed { 1.0 - share } else { share };
        let domain = own.part.domain;
        let (t, step) = (domain.at(share), SIDE_STEP * domain.length());
        let [a, b, c] = [t - step, t, t + step].map(|t| brep.trim_point(trim, t));
        let (along, at) = (c? - a?, b?);
        // The face lies to the left of its trims.
        let inward = crate::Vector3::new(-along.y, along.x, 0.0).unitized()?;
        let spans = crate::Direction::BOTH.map(|d| surface.domain(d).length());
        let reach = (inward.x.abs() / spans[0]).hypotenuse(inward.y.abs() / spans[1]).recip();
        for part in SIDE_STEPS {
            let p = at + inward * (part * reach);
            let height = plane.signed_distance(surface.point_at(p.x, p.y));
            // A height below what the trim itself is off tells nothing.
            if height.abs() > 100.0 * self.noise(plane) + 0.1 * part * self.tolerance.absolute {
                return Some(if height > 0.0 { 1 } else { -1 });
            }
        }
        Some(0)
    }

    /// The points of edges in the plane that no curve runs through.
    fn add_points(&self, contacts: &[EdgeContacts], plane: &Plane, out: &mut BrepSection) -> Result<()> {
        let near = 2.0 * self.tolerance.absolute.max(self.noise(plane));
        for found in contacts {
            for p in &found.points {
                let mut known = out.points.iter().any(|q| q.distance_to(*p) <= near);
                for curve in &out.curves {
                    known = known || curve.closest_point_within(*p, near)?.is_some();
                }
                if !known {
                    out.points.push(*p);
                }
            }
        }
        // Where an edge lies in the plane but only as a ridge, its ends say nothing either.
        let ridges: Vec<&Curve> =
            contacts.iter().flat_map(|c| &c.stretches).map(|(_, curve)| curve).collect();
        let mut kept = Vec::new();
        for p in std::mem::take(&mut out.points) {
            let mut on_ridge = false;
            for ridge in &ridges {
                on_ridge = on_ridge || ridge.closest_point_within(p, near)?.is_some();
            }
            if !on_ridge {
                kept.push(p);
            }
        }
        out.points = kept;
        Ok(())
    }
}

/// Whether a surface lies in a plane.
fn lies_in(surface: &Surface, plane: &Plane, noise: f64) -> bool {
    match surface {
        Surface::Plane(flat) => {
            let own = flat.plane();
            own.z_axis.parallel_to(plane.z_axis, thresholds::PARALLEL) != 0
                && plane
                    .signed_distance(flat.point_at(
                        flat.domain(crate::Direction::U).middle(),
                        flat.domain(crate::Direction::V).middle(),
                    ))
                    .abs()
                    <= noise
        }
        other => other.to_nurbs().is_ok_and(|nurbs| {
            nurbs.control_points().iter().all(|p| plane.signed_distance(*p).abs() <= noise)
        }),
    }
}

impl Brep {
    /// What a plane cuts out of the brep; for many planes see [`BrepSections`].
    ///
    /// # Errors
    /// As [`BrepSections::new`] and [`BrepSections::cut`].
    pub fn section(&self, plane: &Plane, tolerance: &Tolerance) -> Result<BrepSection> {
        BrepSections::new(Shared::new(self.clone()), tolerance)?.cut(plane)
    }
}
