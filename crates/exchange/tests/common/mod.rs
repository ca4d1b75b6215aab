//! Scenes to write, and what they measure.

#![allow(dead_code, reason = "each test uses a part")]

use katydid_exchange::{Layer, Scene, Shape, Thing};
use katydid_geometry::{
    BoundingBox, Circle, Curve, Line, Mesh, MeshFace, NurbsCurve, Plane, Point3, PolylineCurve,
};

/// A tetrahedron and a quad with names and colours on layers, a line, a polyline, a point. All its curves are straight.
pub(crate) fn sample() -> Scene {
    let p = Point3::new;
    let tetrahedron = vec![p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0), p(0.0, 3.0, 0.0), p(0.0, 0.0, 2.5)];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(MeshFace::Triangle).to_vec();
    let tetrahedron = Mesh::new(tetrahedron, faces).unwrap().with_normals();
    let quad = vec![p(0.1, 5.0, 1.0 / 3.0), p(1.0, 5.0, 0.0), p(1.0, 6.0, 0.0), p(0.0, 6.0, 0.0)];
    let quad = Mesh::new(quad, vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
    let polyline =
        PolylineCurve::new(vec![p(-1.0, 0.0, 0.0), p(-2.5, 0.25, 1.0), p(-2.0, 1.0, 7.0)]).unwrap();
    let thing = |name: &str, layer, shape| Thing { layer, ..Thing::named(name, shape) };
    let mut coloured = thing("mesh \"<&>\" ü\n", Some(1), Shape::Mesh(tetrahedron));
    coloured.colour = Some([200, 30, 7, 128]);
    Scene {
        layers: vec![
            Layer { name: "outer".into(), parent: None },
            Layer { name: "inner".into(), parent: Some(0) },
            Layer { name: "nothing on it".into(), parent: Some(0) },
        ],
        things: vec![
            coloured,
            thing("quad", Some(0), Shape::Mesh(quad)),
            thing("", None, Shape::Curve(Line::new(p(0.0, 0.0, 0.0), p(1.0, 1.0, 1.0)).into())),
            thing("zigzag", Some(1), Shape::Curve(polyline.into())),
            thing("place", Some(0), Shape::Points(vec![p(0.5, 0.25, -2.0)].into())),
        ],
        ..Scene::default()
    }
}

/// A circle and a curve of degree 5.
pub(crate) fn round() -> Scene {
    let circle: Curve = Circle::new(Plane::XY, 10.0).unwrap().into();
    let points: Vec<Point3> =
        (0..9).map(|i| Point3::new(f64::from(i), f64::from(i * i % 7), f64::from(i % 3))).collect();
    let wave = NurbsCurve::clamped_uniform(5, &points).unwrap();
    let things =
        vec![Thing::named("circle", Shape::Curve(circle)), Thing::named("wave", Shape::Curve(wave.into()))];
    Scene { things, ..Scene::default() }
}

/// The measures of a scene in its units times `scale`.
#[derive(Debug)]
pub(crate) struct Summary {
    pub(crate) meshes: usize,
    pub(crate) area: f64,
    pub(crate) length: f64,
    pub(crate) bounds: BoundingBox,
}

pub(crate) fn summary(scene: &Scene, scale: f64) -> Summary {
    let (mut meshes, mut area, mut length, mut points) = (0, 0.0, 0.0, Vec::new());
    for thing in &scene.things {
        match &thing.shape {
            Shape::Points(set) => points.extend_from_slice(&set.points),
            Shape::Mesh(mesh) => {
                meshes += 1;
                area += mesh.area() * scale * scale;
                points.extend_from_slice(mesh.vertices());
            }
            Shape::Curve(curve) => {
                let vertices = curve.as_polyline().unwrap_or_else(|| vec![curve.start(), curve.end()]);
                length += vertices.windows(2).map(|w| w[0].distance_to(w[1])).sum::<f64>() * scale;
                points.extend(vertices);
            }
            Shape::Faces { .. } | Shape::Brep(_) | Shape::Region(_) | Shape::Text(_) => {}
        }
    }
    let points = points.into_iter().map(|p| Point3::ORIGIN + p.to_vector() * scale);
    Summary { meshes, area, length, bounds: BoundingBox::from_points(points).unwrap() }
}
