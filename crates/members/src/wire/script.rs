//! Values of scripts as the types of functions, and back.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_geometry::{
    Arc, BoundingBox, Box3, Brep, Circle, Cone, Curve, Cylinder, Ellipse, Interval, Line, Mesh, Plane,
    Point2, Point3, PolylineCurve, Rectangle, Sphere, Surface, Torus, Vector3, Xform, construct,
};

use super::{GeometryBase, MeshingParameters, Ray, Subdivision, made, no};
use crate::shape::{Geometry, Shape};
use crate::{Fault, Value};

/// A type that scripts hand over and get back.
pub trait Script: Sized {
    /// Reads a value; `None` where only its JSON form can say, which is then read.
    fn from_script(value: &Value) -> Option<Result<Self, Fault>>;

    /// As a script gets it.
    ///
    /// # Errors
    /// It has no form there.
    fn into_script(self) -> Result<Value, Fault>;
}

type Found<T> = Option<Result<T, Fault>>;

/// What geometry is when it is not what was asked for; nothing for other values.
fn other<T: super::Wire>(value: &Value) -> Found<T> {
    match value {
        Value::Geometry(geometry) => Some(Err(no::<T>(format!("it is a {}", geometry.shape.class())))),
        _ => None,
    }
}

fn finite<T: super::Wire>(value: T, numbers: &[f64]) -> Found<T> {
    Some(match numbers.iter().all(|x| x.is_finite()) {
        true => Ok(value),
        false => Err(no::<T>("it is not finite, or unset")),
    })
}

impl Script for Point3 {
    fn from_script(value: &Value) -> Found<Self> {
        let point = match value {
            Value::Point(p) => *p,
            Value::Vector(v) => Self::new(v.x, v.y, v.z),
            Value::Point2(p) => Self::new(p.x, p.y, 0.0),
            Value::Geometry(Geometry { shape: Shape::Point(p), .. }) => *p,
            value => return other(value),
        };
        finite(point, &[point.x, point.y, point.z])
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Point(self))
    }
}

impl Script for Vector3 {
    fn from_script(value: &Value) -> Found<Self> {
        let vector = match value {
            Value::Vector(v) => *v,
            Value::Point(p) => Self::new(p.x, p.y, p.z),
            value => return other(value),
        };
        finite(vector, &[vector.x, vector.y, vector.z])
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Vector(self))
    }
}

impl Script for Point2 {
    fn from_script(value: &Value) -> Found<Self> {
        let point = match value {
            Value::Point2(p) => *p,
            Value::Point(p) => Self::new(p.x, p.y),
            value => return other(value),
        };
        finite(point, &[point.x, point.y])
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Point2(self))
    }
}

impl Script for Interval {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Interval(i) => finite(*i, &[i.start, i.end]),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Interval(self))
    }
}

impl Script for Line {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Line(line) => {
                let (a, b) = (line.from, line.to);
                finite(*line, &[a.x, a.y, a.z, b.x, b.y, b.z])
            }
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Line(self))
    }
}

/// The plane, its axes made unit vectors at right angles.
fn plane(plane: &Plane) -> Result<Plane, Fault> {
    Plane::from_axes(plane.origin, plane.x_axis, plane.y_axis).map_err(no::<Plane>)
}

impl Script for Plane {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Plane(held) => Some(plane(held)),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Plane(self))
    }
}

impl Script for Xform {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Transform(xform) => finite(**xform, xform.rows.as_flattened()),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Transform(Box::new(self)))
    }
}

impl Script for BoundingBox {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::BoundingBox(b) => {
                let (min, max) = (b.min, b.max);
                match min.x <= max.x && min.y <= max.y && min.z <= max.z {
                    true => finite(**b, &[min.x, min.y, min.z, max.x, max.y, max.z]),
                    false => Some(Err(no::<Self>("its Min lies beyond its Max"))),
                }
            }
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::BoundingBox(Box::new(self)))
    }
}

/// Structs in a plane, made anew so that what no such shape has is refused.
macro_rules! shapes {
    ($($type:ident: $held:ident => $make:expr;)*) => {
        $(impl Script for $type {
            fn from_script(value: &Value) -> Found<Self> {
                let make: fn(&$type) -> Result<$type, Fault> = $make;
                match value {
                    Value::$type(held) => Some(make(held)),
                    value => other(value),
                }
            }

            fn into_script(self) -> Result<Value, Fault> {
                Ok(Value::$type(Box::new(self)))
            }
        })*
    };
}

shapes! {
    Circle: held => |held| made(Circle::new(plane(&held.plane)?, held.radius));
    Ellipse: held => |held| made(Ellipse::new(plane(&held.plane)?, held.rx, held.ry));
    Arc: held => |held| made(Arc::new(Circle::new(plane(&held.circle.plane)?, held.circle.radius)?, held.angle));
    Sphere: held => |held| made(Sphere::new(plane(&held.plane)?, held.radius));
    Rectangle: held => |held| match [held.x, held.y].iter().all(|i| i.start.is_finite() && i.end.is_finite()) {
        true => Ok(Rectangle { plane: plane(&held.plane)?, ..*held }),
        false => Err(no::<Rectangle>("it is not finite")),
    };
}

impl Script for Box3 {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Box(held) => {
                let finite =
                    [held.x, held.y, held.z].iter().all(|i| i.start.is_finite() && i.end.is_finite());
                Some(match finite {
                    true => plane(&held.plane).map(|plane| Self { plane, ..**held }),
                    false => Err(no::<Self>("it is not finite")),
                })
            }
            Value::BoundingBox(_) => Some(BoundingBox::from_script(value)?.and_then(|bounds| {
                let around = Self::around(&Plane::XY, [bounds.min, bounds.max]);
                around.ok_or_else(|| no::<Self>("the bounding box is empty"))
            })),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Box(Box::new(self)))
    }
}

impl Script for Colour {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Colour(colour) => Some(Ok(*colour)),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Value::Colour(self))
    }
}

/// The points of a polyline.
fn polyline(points: Vec<Point3>) -> Result<PolylineCurve, Fault> {
    made(PolylineCurve::new(points))
}

impl Script for Curve {
    /// A curve of any class, an edge, or a struct that is one.
    fn from_script(value: &Value) -> Found<Self> {
        let held = |value: &Value| match value {
            Value::Geometry(geometry) => geometry.shape.curve().map(|curve| Ok((*curve).clone())),
            Value::Line(_) => Some(Line::from_script(value)?.map(Self::from)),
            Value::Circle(_) => Some(Circle::from_script(value)?.map(Self::from)),
            Value::Arc(_) => Some(Arc::from_script(value)?.map(Self::from)),
            Value::Ellipse(_) => {
                Some(Ellipse::from_script(value)?.and_then(|e| made(e.to_nurbs().map(Self::from))))
            }
            Value::Rectangle(_) => {
                Some(Rectangle::from_script(value)?.and_then(|r| made(r.to_polyline()).map(Self::from)))
            }
            Value::Polyline(points) | Value::Points(points) => Some(polyline(points.clone()).map(Self::from)),
            _ => None,
        };
        held(value).or_else(|| other(value))
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Shape::Curve(Shared::new(self)).into())
    }
}

impl Script for PolylineCurve {
    fn from_script(value: &Value) -> Found<Self> {
        match Curve::from_script(value)? {
            Ok(Curve::Polyline(polyline)) => Some(Ok(polyline)),
            Ok(other) => Some(match other.as_polyline() {
                Some(points) => made(Self::new(points)),
                None => Err(no::<Self>("it is curved")),
            }),
            Err(fault) => Some(Err(fault)),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Curve::from(self).into_script()
    }
}

impl Script for Surface {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Geometry(geometry) => match geometry.shape.surface() {
                Some(surface) => Some(Ok((*surface).clone())),
                None => other(value),
            },
            _ => None,
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Shape::Surface(Shared::new(self)).into())
    }
}

impl Script for Brep {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Geometry(geometry) => match geometry.shape.brep() {
                Some(brep) => Some(brep.map(Shared::unwrap_or_clone)),
                None => other(value),
            },
            Value::Box(_) | Value::BoundingBox(_) => {
                Some(Box3::from_script(value)?.and_then(|shape| made(construct::box_brep(&shape))))
            }
            _ => None,
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Shape::Brep(Shared::new(self)).into())
    }
}

impl Script for Mesh {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Geometry(Geometry { shape: Shape::Mesh(mesh), .. }) => Some(Ok((**mesh).clone())),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Shape::Mesh(Shared::new(self)).into())
    }
}

impl Script for Subdivision {
    fn from_script(value: &Value) -> Found<Self> {
        match value {
            Value::Geometry(Geometry { shape: Shape::SubD(subd), .. }) => Some(Ok(Self((**subd).clone()))),
            value => other(value),
        }
    }

    fn into_script(self) -> Result<Value, Fault> {
        Ok(Shape::SubD(Shared::new(self.0)).into())
    }
}

impl Script for GeometryBase {
    fn from_script(value: &Value) -> Found<Self> {
        let Value::Geometry(geometry) = value else {
            return match Point3::from_script(value) {
                Some(point) => Some(point.map(Self::Point)),
                None => match Curve::from_script(value) {
                    Some(curve) => Some(curve.map(Self::Curve)),
                    None => Brep::from_script(value).map(|brep| brep.map(Self::Brep)),
                },
            };
        };
        let shape = &geometry.shape;
        if let Some(curve) = shape.curve() {
            return Some(Ok(Self::Curve((*curve).clone())));
        }
        Some(Ok(match shape {
            Shape::Point(point) => Self::Point(*point),
            Shape::Mesh(mesh) => Self::Mesh((**mesh).clone()),
            Shape::SubD(subd) => Self::SubD(Subdivision((**subd).clone())),
            Shape::Surface(surface) => Self::Surface((**surface).clone()),
            shape => match shape.brep() {
                Some(Ok(brep)) => Self::Brep(Shared::unwrap_or_clone(brep)),
                Some(Err(fault)) => return Some(Err(fault)),
                None => match shape.object() {
                    Ok(object) => Self::Other(Box::new(object)),
                    Err(fault) => return Some(Err(fault)),
                },
            },
        }))
    }

    fn into_script(self) -> Result<Value, Fault> {
        match self {
            Self::Point(point) => Ok(Shape::Point(point).into()),
            Self::Curve(curve) => curve.into_script(),
            Self::Surface(surface) => surface.into_script(),
            Self::Brep(brep) => brep.into_script(),
            Self::Mesh(mesh) => mesh.into_script(),
            Self::SubD(subd) => subd.into_script(),
            Self::Other(object) => Ok(Shape::Other(Shared::from(object)).into()),
        }
    }
}

/// Classes whose properties are named values: they are read from a record or a map of those names.
macro_rules! records {
    ($($type:ident, $class:literal;)*) => {
        $(impl Script for $type {
            fn from_script(_: &Value) -> Found<Self> {
                None
            }

            fn into_script(self) -> Result<Value, Fault> {
                let Value::Map(pairs) = Value::from(super::Wire::to_json(&self, 0)?) else {
                    return Err(Fault::failed(concat!($class, " has no properties")));
                };
                Ok(Value::Map(pairs))
            }
        })*
    };
}

records! {
    Cone, "Cone";
    Cylinder, "Cylinder";
    Torus, "Torus";
    Ray, "Ray3d";
    MeshingParameters, "MeshingParameters";
}
