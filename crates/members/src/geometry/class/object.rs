//! `GeometryBase`: what every kind of geometry does.

use std::sync::Arc;

use katydid_geometry::subd::{SubD, SubDNet};
use katydid_geometry::{Plane, Point3, Vector3, Xform};

use super::{Named, marks};
use crate::geometry::answer::{Answer, Outcome};
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape};
use crate::wire::{GeometryBase, Read, Script};
use crate::{Fault, Value};

pub(super) fn enter(table: &mut Endpoints) {
    for signature in ["GeometryBase.Duplicate this", "GeometryBase.DuplicateShallow this"] {
        // What is handed over as a struct has no strings to keep.
        table.member(signature, |own: Copied| Ok(own.0));
    }
    table.member("GeometryBase.Transform &this xform", |shape: Shape, xform: Xform| moved(&shape, &xform));
    table.member("GeometryBase.Translate &this translationVector", |shape: Shape, v: Vector3| {
        moved(&shape, &Xform::translation(v))
    });
    table.member("GeometryBase.Translate &this x y z", |shape: Shape, x: f64, y: f64, z: f64| {
        moved(&shape, &Xform::translation(Vector3::new(x, y, z)))
    });
    table.member("GeometryBase.Scale &this scaleFactor", |shape: Shape, factor: f64| {
        moved(&shape, &Xform::scale_non_uniform(&Plane::XY, factor, factor, factor))
    });
    table.member(
        "GeometryBase.Rotate &this angleRadians rotationAxis rotationCenter",
        |shape: Shape, angle: f64, axis: Vector3, centre: Point3| {
            moved(&shape, &Xform::rotation(angle, axis, centre)?)
        },
    );
    table.member("GeometryBase.GetBoundingBox this plane", |geometry: GeometryBase, plane: Plane| {
        crate::geometry::geometry_base::bounds(&geometry, &Xform::world_to_plane(&plane))
    });
    table.member("GeometryBase.get_IsValid this", |shape: Shape| Ok(is_valid(&shape)));
    table.member("GeometryBase.get_ObjectType this", |shape: Shape| {
        Ok(Named("ObjectType", object_type(&shape)))
    });
    table.member("GeometryBase.get_HasBrepForm this", |shape: Shape| Ok(shape.brep().is_some()));
    table.member("GeometryBase.get_IsDeformable this", |_: Shape| Ok(true));
    table.member("GeometryBase.MakeDeformable this", |_: Shape| Ok(true));
    table.member("Point.new location", |point: Point3| Ok(Shape::Point(point)));
    table.member("Point.get_Location this", |point: Point3| Ok(point));
    table.member("Point.set_Location &this location", |_: Shape, to: Point3| Ok(((), Shape::Point(to))));
}

impl Read for Shape {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Self::of_value(&GeometryBase::read(json)?.into_script()?)
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Geometry { shape, .. }) => Ok(shape.clone()),
            other => match GeometryBase::of_value(other)?.into_script()? {
                Value::Geometry(geometry) => Ok(geometry.shape),
                other => Err(Fault::bad_request(format!("is {}, not geometry", other.noun()))),
            },
        }
    }

    fn type_name() -> String {
        "GeometryBase".into()
    }
}

impl Answer for Shape {
    fn name() -> String {
        "Rhino.Geometry.GeometryBase".into()
    }

    fn json(self) -> Result<serde_json::Value, Fault> {
        self.to_json(crate::geometry::call::ARCHIVE)
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(self.into())
    }
}

/// Geometry with the texts that it carries.
struct Copied(Geometry);

impl Read for Copied {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Shape::read(json).map(|shape| Self(shape.into()))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(own) => Ok(Self(own.clone())),
            other => Shape::of_value(other).map(|shape| Self(shape.into())),
        }
    }

    fn type_name() -> String {
        "GeometryBase".into()
    }
}

/// Whether it could be moved, and what it becomes.
fn moved(shape: &Shape, xform: &Xform) -> Outcome<(bool, Shape)> {
    let moved = match shape {
        Shape::Point(point) => Shape::Point(xform.point(*point)),
        Shape::Curve(curve) => Shape::Curve(Arc::new(curve.transformed(xform)?)),
        Shape::Surface(surface) => Shape::Surface(Arc::new(surface.transformed(xform)?)),
        Shape::Brep(brep) => Shape::Brep(Arc::new(brep.transformed(xform)?)),
        Shape::Face(brep, place) => Shape::Face(Arc::new(brep.transformed(xform)?), *place),
        Shape::Edge(brep, place) => Shape::Edge(Arc::new(brep.transformed(xform)?), *place),
        Shape::Mesh(mesh) => Shape::Mesh(Arc::new(mesh.transformed(xform)?)),
        Shape::SubD(subd) => Shape::SubD(Arc::new(moved_subd(subd, xform)?)),
        Shape::Empty(class) => Shape::Empty(class),
        Shape::Unfinished(curve) => {
            let mut curve = (**curve).clone();
            curve.points.iter_mut().for_each(|point| *point = xform.point(*point));
            curve.shape()
        }
        Shape::Other(object) if marks::moves(object) => {
            Shape::Other(Arc::new(marks::moved((**object).clone(), xform)?))
        }
        Shape::UnfinishedSurface(surface) => {
            let mut surface = (**surface).clone();
            surface.points.iter_mut().for_each(|point| *point = xform.point(*point));
            surface.shape()
        }
        Shape::Other(_) | Shape::List(..) | Shape::Record(_) | Shape::SubDPart(..) => {
            match (shape.curve(), shape.brep()) {
                (Some(curve), _) => Shape::Curve(Arc::new(curve.transformed(xform)?)),
                (None, Some(brep)) => Shape::Brep(Arc::new(brep?.transformed(xform)?)),
                (None, None) => return Err(Fault::not_supported(format!("{}.Transform", shape.class()))),
            }
        }
    };
    Ok((true, moved))
}

/// The control points moved: the surface goes where its net goes under every affine map.
fn moved_subd(subd: &SubD, xform: &Xform) -> Outcome<SubD> {
    let level = |net: &SubDNet| {
        let mut vertices = net.vertices().to_vec();
        vertices.iter_mut().for_each(|vertex| vertex.point = xform.point(vertex.point));
        SubDNet::from_parts(vertices, net.edges().to_vec(), net.faces().to_vec())
    };
    Ok(SubD::from_levels(subd.levels().iter().map(level).collect::<Result<_, _>>()?)?)
}

fn is_valid(shape: &Shape) -> bool {
    match shape {
        Shape::Brep(brep) | Shape::Face(brep, _) | Shape::Edge(brep, _) => brep.is_valid(),
        Shape::Mesh(mesh) => mesh.check().is_ok() && !mesh.faces().is_empty(),
        Shape::Empty(_) | Shape::Unfinished(_) | Shape::UnfinishedSurface(_) => false,
        _ => true,
    }
}

/// The number of `Rhino.DocObjects.ObjectType`.
fn object_type(shape: &Shape) -> i64 {
    match shape.class() {
        "Point" => 1,
        "PointCloud" => 2,
        "Brep" | "BrepFace" => 16,
        "Mesh" => 32,
        "TextDot" => 8192,
        "Hatch" => 65_536,
        "SubD" => 262_144,
        "Extrusion" => 1_073_741_824,
        _ if shape.curve().is_some() => 4,
        _ if shape.surface().is_some() => 8,
        _ => 0,
    }
}
