//! A scene as the three things that formats of meshes know: points, polylines, meshes.

use katydid_geometry::{Curve, Mesh, Point3, PolylineLimits, Vector3};

use crate::{LeftOut, Options, PointSet, Scene, Shape, Thing};

/// A thing, or a part of it, in the form that a format of meshes holds.
pub(crate) enum Form<'a> {
    Points(&'a PointSet),
    Polyline(Vec<Point3>),
    Mesh(&'a Mesh),
}

/// One of the forms, and the thing that it shows.
pub(crate) struct Piece<'a> {
    pub(crate) thing: &'a Thing,
    pub(crate) place: usize,
    pub(crate) form: Form<'a>,
}

impl Piece<'_> {
    /// Its points: all that a vertex list gets from it.
    pub(crate) fn points(&self) -> &[Point3] {
        match &self.form {
            Form::Points(set) => &set.points,
            Form::Polyline(points) => points,
            Form::Mesh(mesh) => mesh.vertices(),
        }
    }

    /// One normal a point, or none at all.
    pub(crate) fn normals(&self) -> &[Vector3] {
        match &self.form {
            Form::Points(set) => &set.normals,
            Form::Mesh(mesh) => mesh.normals(),
            Form::Polyline(_) => &[],
        }
    }

    /// One colour a point, or none at all.
    pub(crate) fn colours(&self) -> &[[u8; 4]] {
        match &self.form {
            Form::Points(set) => &set.colours,
            Form::Mesh(mesh) => mesh.colours(),
            Form::Polyline(_) => &[],
        }
    }
}

/// The pieces of a scene. Faces come as their facets or, where they have none, as their edges.
pub(crate) fn pieces<'a>(scene: &'a Scene, options: &Options) -> (Vec<Piece<'a>>, Vec<LeftOut>) {
    let mut pieces = Vec::with_capacity(scene.things.len());
    let mut left_out = Vec::new();
    for (place, thing) in scene.things.iter().enumerate() {
        let mut add = |form| pieces.push(Piece { thing, place, form });
        let mut polyline = |curve: &Curve| match polyline(scene, options, curve) {
            Some(points) => add(Form::Polyline(points)),
            None => LeftOut::add(
                &mut left_out,
                LeftOut::new("curve", 1, "it needs more points than a polyline may have"),
            ),
        };
        match &thing.shape {
            Shape::Curve(curve) => polyline(curve),
            Shape::Faces { facets: None, edges } => {
                edges.iter().for_each(polyline);
                let why = "solids are not meshed yet: its edges stand for it";
                LeftOut::add(&mut left_out, LeftOut::new(thing.shape.kind(), 1, why));
            }
            // Breps became facets before.
            Shape::Brep(_) => {}
            Shape::Region(region) => {
                region.boundaries.iter().for_each(polyline);
                let why = "only drawings are filled: its boundaries stand for it";
                LeftOut::add(&mut left_out, LeftOut::new("hatch", 1, why));
            }
            Shape::Text(_) => {
                LeftOut::add(&mut left_out, LeftOut::new("text", 1, "only drawings show text"));
            }
            Shape::Points(set) if set.points.is_empty() => {}
            Shape::Points(set) => add(Form::Points(set)),
            Shape::Mesh(mesh) | Shape::Faces { facets: Some(mesh), .. } if mesh.faces().is_empty() => {
                LeftOut::add(&mut left_out, LeftOut::new("mesh", 1, "it has no faces"));
            }
            Shape::Mesh(mesh) | Shape::Faces { facets: Some(mesh), .. } => add(Form::Mesh(mesh)),
        }
    }
    (pieces, left_out)
}

/// A curve as a polyline: exact for lines and polylines, else within the tolerance.
fn polyline(scene: &Scene, options: &Options, curve: &Curve) -> Option<Vec<Point3>> {
    match curve {
        Curve::Line(line) => Some(vec![line.line.from, line.line.to]),
        Curve::Polyline(polyline) => Some(polyline.points().to_vec()),
        _ => {
            let tolerance = scene.tolerance_for(options.tolerance, &curve.bounding_box());
            // A curve too long for its tolerance is better drawn coarsely than not at all.
            let found = [1.0, 10.0, 100.0, 1e4]
                .iter()
                .find_map(|factor| curve.to_polyline(&PolylineLimits::within(tolerance * factor)).ok());
            found.map(|polyline| polyline.into_parts().0)
        }
    }
}
