use katydid_3dm::{Model, Object};
use katydid_geometry::{Curve, Direction, Mesh, MeshFace, Point3, Surface};

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
                Object::PointCloud(cloud) => {
                    cloud.points.iter().filter(|p| p.is_finite()).for_each(|p| add(Shape::Point(*p)));
                }
                Object::Curve(curve) => add(Shape::Curve(curve.clone())),
                Object::Mesh(mesh) => match mesh.to_mesh() {
                    Ok(mesh) => add(Shape::Mesh(mesh)),
                    Err(_) => scene.unknown.push(object.geometry.class_name()),
                },
                Object::Surface(surface) => match facets(surface) {
                    Some(mesh) => add(Shape::Mesh(mesh)),
                    None => scene.unknown.push(object.geometry.class_name()),
                },
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

/// A surface as a grid of quads: one a span where it is straight, else so many that it looks round. None when it has
/// no NURBS form.
fn facets(surface: &Surface) -> Option<Mesh> {
    const ROUND: usize = 16;
    /// Rows of one direction; spans beyond are left out evenly.
    const MOST: usize = 2048;
    let nurbs = surface.to_nurbs().ok()?;
    let [us, vs] = Direction::BOTH.map(|d| {
        let spans = nurbs.span_parameters(d);
        let inner = if nurbs.degree(d) == 1 { 1 } else { ROUND.min(MOST / spans.len().max(1)).max(1) };
        let step = spans.len().div_ceil(MOST).max(1);
        let ends = spans.iter().copied().step_by(step).chain(spans.last().copied());
        let ends: Vec<f64> = ends.collect();
        let mut all: Vec<f64> = Vec::new();
        for w in ends.windows(2) {
            let [a, b] = *w else { continue };
            all.extend((0..inner).map(|i| a + (b - a) * (i as f64 / inner as f64)));
        }
        all.extend(ends.last().copied());
        all.dedup();
        all
    });
    let vertices = nurbs.points_grid(&us, &vs);
    let mut faces = Vec::new();
    for i in 1..us.len() {
        for j in 1..vs.len() {
            let at = |i: usize, j: usize| u32::try_from(i * vs.len() + j).ok();
            faces.push(MeshFace::Quad([at(i - 1, j - 1)?, at(i, j - 1)?, at(i, j)?, at(i - 1, j)?]));
        }
    }
    Mesh::new(vertices, faces).ok()
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

#[cfg(test)]
mod tests {
    use katydid_geometry::Sphere;

    use super::*;

    #[test]
    fn surfaces_are_shown_as_meshes() {
        let ball = Sphere::around(Point3::ORIGIN, 1.0).unwrap();
        let mesh = facets(&ball.into()).unwrap();
        assert_eq!(mesh.faces().len(), 64 * 32);
        // Four quadrants in u, two halves in v, of 16 each: 2 % short of the sphere's area at most.
        let (area, _) = mesh.area_and_centroid();
        assert!((0.98..1.0).contains(&(area / ball.area())), "{area}");
    }
}
