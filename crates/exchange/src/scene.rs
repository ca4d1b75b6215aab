use katydid_3dm::{Model, Object};
use katydid_geometry::{Curve, Mesh, Point3};

/// Geometry with names.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// What is in it, in order.
    pub things: Vec<Thing>,
    /// Objects of a model that no format here can hold, by class.
    pub unknown: Vec<String>,
}

/// One piece of geometry.
#[derive(Debug, Clone)]
pub struct Thing {
    /// Its name; may be empty.
    pub name: String,
    /// Its form.
    pub shape: Shape,
}

/// The forms of geometry that are written.
#[derive(Debug, Clone)]
pub enum Shape {
    /// A point.
    Point(Point3),
    /// A curve.
    Curve(Curve),
    /// A mesh.
    Mesh(Mesh),
}

impl Scene {
    /// The objects of a model.
    pub fn from_model(model: &Model) -> Self {
        let mut scene = Self::default();
        for object in &model.objects {
            let mut add = |shape| scene.things.push(Thing { name: object.attributes.name.clone(), shape });
            match &object.geometry {
                Object::Point(p) => add(Shape::Point(*p)),
                Object::PointCloud(cloud) => cloud.points.iter().for_each(|p| add(Shape::Point(*p))),
                Object::Curve(curve) => add(Shape::Curve(curve.clone())),
                Object::Mesh(mesh) => add(Shape::Mesh(mesh.clone())),
                other => scene.unknown.push(other.class_name()),
            }
        }
        scene
    }

    /// A line a class of what could not be taken over.
    pub(crate) fn left_out(&self) -> Vec<String> {
        let mut classes = self.unknown.clone();
        classes.sort();
        let counts = classes.chunk_by(|a, b| a == b);
        counts.map(|same| format!("{} × {}", same.len(), same[0])).collect()
    }
}

/// A curve as points: exact for lines and polylines, else so many a smooth piece that it looks round.
pub(crate) fn points(curve: &Curve) -> Vec<Point3> {
    match curve {
        Curve::Line(line) => vec![line.line.from, line.line.to],
        Curve::Polyline(polyline) => polyline.points().to_vec(),
        Curve::Poly(poly) => {
            let mut all: Vec<Point3> = Vec::new();
            for segment in poly.segments() {
                let next = points(segment);
                all.extend(next.into_iter().skip(usize::from(!all.is_empty())));
            }
            all
        }
        Curve::Arc(_) | Curve::Nurbs(_) => {
            let domain = curve.domain();
            let n = if let Curve::Nurbs(nurbs) = curve { 16 * nurbs.point_count() } else { 64 };
            (0..=n).map(|i| curve.point_at(domain.at(i as f64 / n as f64))).collect()
        }
    }
}
