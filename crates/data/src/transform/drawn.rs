//! Annotations, hatches, lights and the like: what lies in a plane of its own, or stands at a place.

use katydid_3dm::{
    Annotation, AnnotationKind, ClippingPlane, CurveForm, Dimension, Hatch, Light, Object, StoredPlane,
};
use katydid_geometry::{Plane, Point2, Result, Vector2, Vector3, Xform};

/// The image of an object that is drawn rather than solid; nothing for a class that is not known here.
///
/// Text stays as high as it is; measures, hatches and lights grow with the map.
///
/// # Errors
/// The map leaves no plane of the object's plane, or no curve of its outline.
pub(super) fn transformed(object: Object, xform: &Xform) -> Result<Option<Object>> {
    Ok(Some(match object {
        Object::Annotation(annotation) => Object::Annotation(Box::new(self::annotation(*annotation, xform)?)),
        Object::Hatch(hatch) => Object::Hatch(Box::new(self::hatch(*hatch, xform)?)),
        Object::Light(light) => Object::Light(Box::new(self::light(*light, xform))),
        Object::ClippingPlane(clipping) => {
            Object::ClippingPlane(Box::new(self::clipping_plane(*clipping, xform)?))
        }
        Object::BlockReference(mut block) => {
            block.transform = *xform * block.transform;
            block.bounds = None;
            Object::BlockReference(block)
        }
        _ => return Ok(None),
    }))
}

/// The image of a plane, and how the coordinates of its points change: by a matrix, which is a plain factor unless the
/// map is no similarity.
struct Moved {
    plane: Plane,
    matrix: [[f64; 2]; 2],
}

impl Moved {
    fn new(old: &Plane, xform: &Xform) -> Result<Self> {
        let plane = old.transformed(xform)?;
        let column = |axis: Vector3| {
            let image = xform.vector(axis);
            [image.dot(plane.x_axis), image.dot(plane.y_axis)]
        };
        let ([a, c], [b, d]) = (column(old.x_axis), column(old.y_axis));
        Ok(Self { plane, matrix: [[a, b], [c, d]] })
    }

    fn point(&self, p: &mut Point2) {
        let [[a, b], [c, d]] = self.matrix;
        *p = Point2::new(a * p.x + b * p.y, c * p.x + d * p.y);
    }

    fn direction(&self, v: &mut Vector2) {
        let mut p = Point2::new(v.x, v.y);
        self.point(&mut p);
        *v = Vector2::new(p.x, p.y);
    }

    /// How lengths in the plane grow: the root of how areas do.
    fn factor(&self) -> f64 {
        let [[a, b], [c, d]] = self.matrix;
        (a * d - b * c).abs().sqrt()
    }

    /// The map as one of space, for curves at z = 0.
    fn in_space(&self) -> Xform {
        let [[a, b], [c, d]] = self.matrix;
        let mut xform = Xform::IDENTITY;
        xform.rows[0] = [a, b, 0.0, 0.0];
        xform.rows[1] = [c, d, 0.0, 0.0];
        xform
    }
}

fn annotation(mut annotation: Annotation, xform: &Xform) -> Result<Annotation> {
    let moved = Moved::new(&annotation.plane.frame, xform)?;
    annotation.plane = StoredPlane::from(moved.plane);
    let text = |dimension: &mut Dimension| {
        if let Some(point) = &mut dimension.text_point {
            moved.point(point);
        }
    };
    match &mut annotation.kind {
        AnnotationKind::Text => {}
        AnnotationKind::Leader { points } => points.iter_mut().for_each(|p| moved.point(p)),
        AnnotationKind::Linear { dimension, end, line, .. } => {
            text(dimension);
            moved.point(end);
            moved.point(line);
        }
        AnnotationKind::Angular { dimension, directions, offsets, arc, .. } => {
            text(dimension);
            directions.iter_mut().for_each(|v| moved.direction(v));
            offsets.iter_mut().for_each(|offset| *offset *= moved.factor());
            moved.point(arc);
        }
        AnnotationKind::Radial { dimension, on_circle, line, .. } => {
            text(dimension);
            moved.point(on_circle);
            moved.point(line);
        }
        AnnotationKind::Ordinate { dimension, point, leader, kinks, .. } => {
            text(dimension);
            moved.point(point);
            moved.point(leader);
            kinks.iter_mut().for_each(|kink| *kink *= moved.factor());
        }
        AnnotationKind::CentreMark { dimension, radius } => {
            text(dimension);
            *radius *= moved.factor();
        }
    }
    Ok(annotation)
}

fn hatch(mut hatch: Hatch, xform: &Xform) -> Result<Hatch> {
    let moved = Moved::new(&hatch.plane.frame, xform)?;
    hatch.plane = StoredPlane::from(moved.plane);
    hatch.scale *= moved.factor();
    moved.point(&mut hatch.base_point);
    for edge in &mut hatch.loops {
        let image = edge.curve.to_curve()?.transformed(&moved.in_space())?;
        edge.curve = CurveForm::of(&image, 2);
    }
    Ok(hatch)
}

fn light(mut light: Light, xform: &Xform) -> Light {
    light.location = xform.point(light.location);
    light.direction = xform.vector(light.direction);
    light.length = xform.vector(light.length);
    light.width = xform.vector(light.width);
    light
}

fn clipping_plane(mut clipping: ClippingPlane, xform: &Xform) -> Result<ClippingPlane> {
    let moved = Moved::new(&clipping.surface_plane.frame, xform)?;
    let factor = moved.factor();
    clipping.surface_plane = StoredPlane::from(moved.plane);
    clipping.plane = StoredPlane::from(clipping.plane.frame.transformed(xform)?);
    for extent in &mut clipping.extents {
        extent.start *= factor;
        extent.end *= factor;
    }
    clipping.depth *= factor;
    Ok(clipping)
}
