//! Regions of a plane, bounded by closed curves of any kind, and their booleans.
//!
//! All closed curves that take part are cut at every crossing, touch and end of a shared stretch; stretches that
//! coincide become one; the winding numbers of all curves on both sides of a stretch decide whether it belongs to the
//! border of the result; and the border is walked in loops. The pieces of the result are pieces of the input: an arc
//! stays an arc, a line a line, and a curve that nothing cuts comes back as it is. Where a region is split, strands
//! inside it are walked both ways; what was walked there and back at once separates nothing.
//!
//! **Tolerance.** Crossings are exact. Crossings, ends and corners within the tolerance of each other are one place, a
//! corner within it of another curve is a place on that curve, and stretches that stay within it of each other from
//! one place to another are one stretch; a result may be off by as much. It should be smaller than the features of
//! the curves. Where it is found not to be, because places that are far apart would become one or the
//! border would not close, a finer one is taken, down to 4·10⁻¹² of the largest coordinate.
//!
//! ```
//! use katydid_geometry::{Circle, Curve, Plane, Point3, region::Region};
//! # fn main() -> katydid_geometry::Result<()> {
//! let disc: Curve = Circle::new(Plane::XY, 2.0)?.into();
//! let hole: Curve = Circle::new(Plane::XY.with_origin(Point3::new(0.5, 0.0, 0.0)), 1.0)?.into();
//! let ring = Region::difference_of(&[disc.clone()], &[hole], &Plane::XY, 0.001)?;
//! assert_eq!(ring.faces()[0].outline(), &disc);
//! assert!((ring.area() - 3.0 * std::f64::consts::PI).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! Sources: the arrangement and the walk around its faces after M. de Berg and others, *Computational Geometry*,
//! chapter 2; selection by winding numbers on both sides derived; crossings by
//! [`curve_curve`](crate::intersect::curve_curve), which is complete.

mod assemble;
mod cell;
mod combine;
mod contains;
mod loops;
mod meetings;
mod nodes;
mod relation;
mod sides;
mod slits;
mod sources;
mod split;
mod strands;
mod thresholds;
mod trim;
mod winding;

use combine::{Operand, combined};
pub(crate) use winding::Outline;

pub use cell::plane_cell;
pub use relation::{CurveRelation, relation};
pub use slits::{Slit, slits};
pub use trim::TrimmedCurve;

use crate::{Containment, Curve, Error, Plane, Point3, Result, Xform};

/// What several closed curves enclose together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FillRule {
    /// Points that at least one curve runs around, whatever the directions: the union of what each encloses by
    /// itself.
    #[default]
    Any,
    /// Points around which the turns of all curves do not add up to 0. Outlines and holes that run in opposite
    /// directions are filled as one expects.
    NonZero,
    /// Points around which the turns of all curves add up to an odd number. Of nested curves every other ring is
    /// filled, whatever the directions.
    EvenOdd,
}

/// A connected piece of a region: an outline, counter-clockwise about the normal of the plane, without the holes in
/// it, which run clockwise. No curve crosses or touches itself; a hole may touch the outline or another hole in
/// single points.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    outline: Curve,
    holes: Vec<Curve>,
}

impl Face {
    /// The border on the outside.
    pub fn outline(&self) -> &Curve {
        &self.outline
    }

    /// The borders of the holes.
    pub fn holes(&self) -> &[Curve] {
        &self.holes
    }

    /// The outline, then the holes.
    pub fn curves(&self) -> impl Iterator<Item = &Curve> {
        std::iter::once(&self.outline).chain(&self.holes)
    }

    /// The outline, then the holes, for keeps.
    pub fn into_curves(self) -> Vec<Curve> {
        let mut out = vec![self.outline];
        out.extend(self.holes);
        out
    }
}

/// A part of a plane: faces that do not overlap, and touch each other at most in single points.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    plane: Plane,
    faces: Vec<Face>,
}

impl Region {
    /// The region that closed curves, projected into the plane, enclose by a rule. For one curve `Any` is the rule of
    /// non-zero winding.
    ///
    /// Curves whose ends are no further apart than the tolerance count as closed.
    ///
    /// # Errors
    /// A curve is open; the tolerance is not finite and above 0; there are so many crossings that the work is
    /// refused, or curves so tangled that inside and outside cannot be told apart by rounded numbers.
    pub fn new(curves: &[Curve], rule: FillRule, plane: &Plane, tolerance: f64) -> Result<Self> {
        let all = Operand { curves, rule };
        let none = Operand { curves: &[], rule };
        combined([all, none], |a, _| a, plane, tolerance)
    }

    /// The points that some curve of the list encloses.
    ///
    /// # Errors
    /// As [`Region::new`].
    pub fn union_of(curves: &[Curve], plane: &Plane, tolerance: f64) -> Result<Self> {
        Self::new(curves, FillRule::Any, plane, tolerance)
    }

    /// The points that some curve of the first list and some curve of the second enclose.
    ///
    /// # Errors
    /// As [`Region::new`].
    pub fn intersection_of(a: &[Curve], b: &[Curve], plane: &Plane, tolerance: f64) -> Result<Self> {
        let rule = FillRule::Any;
        combined([Operand { curves: a, rule }, Operand { curves: b, rule }], |a, b| a && b, plane, tolerance)
    }

    /// The points that some curve of the first list and none of the second encloses.
    ///
    /// # Errors
    /// As [`Region::new`].
    pub fn difference_of(a: &[Curve], b: &[Curve], plane: &Plane, tolerance: f64) -> Result<Self> {
        let rule = FillRule::Any;
        combined([Operand { curves: a, rule }, Operand { curves: b, rule }], |a, b| a && !b, plane, tolerance)
    }

    /// The points of this region or the other one.
    ///
    /// # Errors
    /// As [`Region::new`]; or the planes of the regions are not the same within the tolerance.
    pub fn union(&self, other: &Self, tolerance: f64) -> Result<Self> {
        self.with(other, |a, b| a || b, tolerance)
    }

    /// The points that this region and the other one have in common.
    ///
    /// # Errors
    /// As [`Region::union`].
    pub fn intersection(&self, other: &Self, tolerance: f64) -> Result<Self> {
        self.with(other, |a, b| a && b, tolerance)
    }

    /// The points of this region that are not in the other one.
    ///
    /// # Errors
    /// As [`Region::union`].
    pub fn difference(&self, other: &Self, tolerance: f64) -> Result<Self> {
        self.with(other, |a, b| a && !b, tolerance)
    }

    /// The points in one of both regions and not in the other.
    ///
    /// # Errors
    /// As [`Region::union`].
    pub fn symmetric_difference(&self, other: &Self, tolerance: f64) -> Result<Self> {
        self.with(other, |a, b| a != b, tolerance)
    }

    fn with(&self, other: &Self, keep: impl Fn(bool, bool) -> bool, tolerance: f64) -> Result<Self> {
        let rule = FillRule::NonZero;
        let (a, b) = (self.curves(), other.curves());
        for curve in &b {
            let height = curve.extent_along(self.plane.z_axis);
            let own = self.plane.origin.to_vector().dot(self.plane.z_axis);
            if (height.start - own).abs().max((height.end - own).abs()) > tolerance {
                return Err(Error::Invalid { what: "region", why: "it lies in another plane".into() });
            }
        }
        let (a, b) = (Operand { curves: &a, rule }, Operand { curves: &b, rule });
        combined([a, b], keep, &self.plane, tolerance)
    }

    /// The plane.
    pub fn plane(&self) -> &Plane {
        &self.plane
    }

    /// The faces, in the order of the curves they come from.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// The faces, for keeps.
    pub fn into_faces(self) -> Vec<Face> {
        self.faces
    }

    /// All borders: of each face the outline, then its holes.
    pub fn curves(&self) -> Vec<Curve> {
        self.faces.iter().flat_map(Face::curves).cloned().collect()
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }

    /// The area, without the holes.
    pub fn area(&self) -> f64 {
        self.faces.iter().flat_map(Face::curves).map(|c| c.signed_area_in(&self.plane).0).sum()
    }

    /// Where a point lies, projected into the plane; points within `tolerance` of a border are on it.
    ///
    /// # Errors
    /// The point is not finite.
    pub fn contains(&self, p: Point3, tolerance: f64) -> Result<Containment> {
        if !p.is_finite() {
            return Err(Error::NotFinite("point to test"));
        }
        let q = self.plane.closest_point(p);
        // About the point, so that nothing is lost far from the plane's origin.
        let local = self.plane.with_origin(q);
        let mut turns = 0;
        for curve in self.faces.iter().flat_map(Face::curves) {
            if curve.closest_point_within(q, tolerance.max(f64::MIN_POSITIVE))?.is_some() {
                return Ok(Containment::On);
            }
            turns += Outline::new(curve, &local).winding([0.0; 2]);
        }
        Ok(if turns == 0 { Containment::Outside } else { Containment::Inside })
    }

    /// The region moved with its plane by an affine map.
    ///
    /// # Errors
    /// The map sends a curve to infinity or squeezes the plane to a line.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let at = |p: Point3| xform.point(p);
        let o = at(self.plane.origin);
        let (x, y) =
            (at(self.plane.origin + self.plane.x_axis) - o, at(self.plane.origin + self.plane.y_axis) - o);
        let plane = Plane::from_axes(o, x, y)?;
        let moved = |c: &Curve| c.transformed(xform);
        let face = |f: &Face| {
            let holes = f.holes.iter().map(moved).collect::<Result<_>>()?;
            Ok(Face { outline: moved(&f.outline)?, holes })
        };
        Ok(Self { plane, faces: self.faces.iter().map(face).collect::<Result<_>>()? })
    }
}
