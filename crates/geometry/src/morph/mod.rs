//! Maps of space that bend: what they do to curves, surfaces and meshes.
//!
//! A [`Morph`] takes points to points. What is made of points follows: meshes by their vertices, curves by samples to
//! which a curve is fitted within a tolerance, surfaces by splines through the images of their points, Breps by all of these.

mod axis;
mod bend;
mod brep;
mod cage;
mod curve;
mod flow;
mod forces;
mod maelstrom;
mod mirror;
mod patch;
mod surface;
mod thresholds;

pub use axis::{Stretch, Taper, Twist};
pub use bend::Bend;
pub use cage::{BoxMorph, SurfaceMorph};
pub use flow::Flow;
pub use forces::Forces;
pub use maelstrom::Maelstrom;
pub use mirror::{MirrorInCurve, MirrorInSurface};
pub use patch::{MapToSurface, Splop, Sporph};

use crate::{Curve, Error, Mesh, NurbsCurve, Plane, Point3, PolylineCurve, Result, Surface, Xform};

/// A map of space.
pub trait Morph {
    /// The image of a point.
    ///
    /// # Errors
    /// The point is not finite, or has no image.
    fn image(&self, p: Point3) -> Result<Point3>;

    /// Planes at which the map has a kink. Curves are cut there before they are mapped, so that the image keeps the
    /// kink sharp.
    fn seams(&self) -> Vec<Plane> {
        Vec::new()
    }
}

/// A finite point, or the error that says so.
fn finite(p: Point3) -> Result<Point3> {
    if p.is_finite() { Ok(p) } else { Err(Error::NotFinite("image of a point")) }
}

/// The frame that a frame becomes: its origin's image, and axes along the images of its axes, taken over `reach` to
/// both sides, x first.
///
/// # Errors
/// As the map's, and where it leaves no frame.
pub fn morphed_frame(morph: &dyn Morph, frame: &Plane, reach: f64) -> Result<Plane> {
    let along = |axis| -> Result<_> {
        Ok(morph.image(frame.origin + axis * reach)? - morph.image(frame.origin - axis * reach)?)
    };
    Plane::from_axes(morph.image(frame.origin)?, along(frame.x_axis)?, along(frame.y_axis)?)
}

/// The rigid motion that a map comes to near the origin of `frame`: see [`morphed_frame`].
///
/// # Errors
/// As [`morphed_frame`].
pub fn rigid_part(morph: &dyn Morph, frame: &Plane, reach: f64) -> Result<Xform> {
    Ok(Xform::plane_to_plane(frame, &morphed_frame(morph, frame, reach)?))
}

impl Mesh {
    /// The mesh with every vertex mapped. Normals, if there are any, are computed anew.
    ///
    /// # Errors
    /// As the map's.
    pub fn morphed(&self, morph: &dyn Morph) -> Result<Self> {
        let vertices = self.vertices().iter().map(|&p| morph.image(p)).collect::<Result<Vec<_>>>()?;
        let image = Self::from_parts(vertices, self.faces().to_vec(), Vec::new(), self.colours().to_vec())?;
        Ok(if self.normals().is_empty() { image } else { image.with_normals() })
    }
}

impl Curve {
    /// The curve with its control points mapped, knots and weights kept: lines and polylines stay what they are, other
    /// curves become NURBS curves. It is the exact image only under affine maps.
    ///
    /// # Errors
    /// As the map's, and when the curve has no NURBS form.
    pub fn with_morphed_controls(&self, morph: &dyn Morph) -> Result<Self> {
        match self {
            Self::Line(line) => {
                let [from, to] = [morph.image(line.line.from)?, morph.image(line.line.to)?];
                Ok(crate::LineCurve { line: crate::Line::new(from, to), domain: line.domain }.into())
            }
            Self::Polyline(polyline) => {
                let points = polyline.points().iter().map(|&p| morph.image(p)).collect::<Result<_>>()?;
                Ok(PolylineCurve::with_parameters(points, polyline.parameters().to_vec())?.into())
            }
            _ => {
                let nurbs = self.to_nurbs()?;
                let points =
                    nurbs.control_points().into_iter().map(|p| morph.image(p)).collect::<Result<Vec<_>>>()?;
                let knots = nurbs.knots().to_vec();
                Ok(if nurbs.is_rational() {
                    NurbsCurve::with_weights(nurbs.degree(), &points, &nurbs.weights(), knots)?.into()
                } else {
                    NurbsCurve::new(nurbs.degree(), points, knots)?.into()
                })
            }
        }
    }
}

impl Surface {
    /// The surface with the control points of its NURBS form mapped, knots and weights kept. It is the exact image
    /// only under affine maps.
    ///
    /// # Errors
    /// As the map's, and when the surface has no NURBS form.
    pub fn with_morphed_controls(&self, morph: &dyn Morph) -> Result<Self> {
        Ok(surface::by_controls(&self.to_nurbs()?, morph)?.into())
    }
}
