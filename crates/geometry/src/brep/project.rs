//! Curves projected onto breps.

use super::{Brep, ClosestOnBrep};
use crate::pull::LineIndex;
use crate::{Curve, Error, Result, Surface, Tolerance, Vector3, Xform, join_curves};

/// The sine of the angle below which a direction runs along a plane.
const EDGE_ON: f64 = 1e-9;

/// A brep prepared for many curves that are projected onto it along one direction.
pub struct CurveProjection {
    search: ClosestOnBrep,
    direction: Vector3,
    faces: Vec<Target>,
}

/// A face that curves are projected onto.
struct Target {
    face: usize,
    /// Whether the face is all of its surface.
    whole: bool,
    /// `None` for a plane, on which images are exact.
    lines: Option<LineIndex>,
}

impl CurveProjection {
    /// # Errors
    /// The direction has no length, or there are no faces.
    pub fn new(brep: std::sync::Arc<Brep>, direction: Vector3) -> Result<Self> {
        if !(direction.length() > 0.0) {
            return Err(Error::degenerate("direction", "it has no length"));
        }
        let search = ClosestOnBrep::new(brep)?;
        let mut faces = Vec::with_capacity(search.sheets().len());
        for sheet in search.sheets() {
            let Some(surface) = search.brep().face_surface(sheet.face) else { continue };
            let lines = match surface {
                Surface::Plane(_) => None,
                other => Some(LineIndex::new(other, direction)?),
            };
            faces.push(Target {
                face: sheet.face,
                whole: search.brep().faces().get(sheet.face).is_some_and(|face| search.brep().is_whole(face)),
                lines,
            });
        }
        Ok(Self { search, direction, faces })
    }

    /// A curve projected onto the faces along the direction, forwards and backwards, within the trims. As
    /// [`Surface::project_curve`] for each face.
    ///
    /// # Errors
    /// The tolerance is not above 0.
    pub fn project(&self, curve: &Curve, tolerance: &Tolerance) -> Result<Vec<Curve>> {
        let direction = self.direction;
        let mut out = Vec::new();
        for target in &self.faces {
            crate::cancellation::check_now()?;
            let Some(surface) = self.search.brep().face_surface(target.face) else { continue };
            let images = match (surface, &target.lines) {
                // An arc's image on a plane is an arc or an ellipse.
                (Surface::Plane(flat), _) => {
                    let upright = direction.dot(flat.plane().z_axis).abs();
                    if !(upright > EDGE_ON * direction.length()) {
                        continue;
                    }
                    vec![curve.transformed(&Xform::projection_along(flat.plane(), direction)?)?]
                }
                (other, Some(lines)) => other.project_along(curve, lines, tolerance)?,
                (_, None) => Vec::new(),
            };
            // What a plane gives goes on beyond its sides.
            if target.whole && target.lines.is_some() {
                out.extend(images);
                continue;
            }
            for image in images {
                out.extend(self.search.curve_within(target.face, &image, tolerance.absolute)?);
            }
        }
        Ok(join_curves(&out, tolerance.absolute, false))
    }
}

impl Brep {
    /// Curves projected onto the faces along a direction, forwards and backwards, within the trims. For many curves see
    /// [`CurveProjection`].
    ///
    /// # Errors
    /// The direction has no length, the tolerance is not above 0, or there are no faces.
    pub fn project_curve(
        &self,
        curve: &Curve,
        direction: Vector3,
        tolerance: &Tolerance,
    ) -> Result<Vec<Curve>> {
        CurveProjection::new(std::sync::Arc::new(self.clone()), direction)?.project(curve, tolerance)
    }
}
