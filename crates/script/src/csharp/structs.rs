//! Structs of RhinoCommon by their fields, in the order in which the declarations have them.

use katydid_data::{Colour, Complex};
use katydid_geometry::{
    Arc, BoundingBox, Box3, Circle, Ellipse, Interval, Line, Plane, Point2, Point3, Rectangle, Sphere,
    Vector3, Xform,
};
use katydid_members::Value;
use uuid::Uuid;

use super::convert::GEOMETRY;

/// The namespace, the name and the fields of a struct; none for any other value.
pub(super) fn fields(value: &Value) -> Option<(&'static str, &'static str, Vec<Value>)> {
    let numbers = |list: &[f64]| list.iter().copied().map(Value::Number).collect::<Vec<_>>();
    let (name, fields) = match value {
        Value::Point(p) => ("Point3d", numbers(&[p.x, p.y, p.z])),
        Value::Vector(v) => ("Vector3d", numbers(&[v.x, v.y, v.z])),
        Value::Point2(p) => ("Point2d", numbers(&[p.x, p.y])),
        Value::Interval(i) => ("Interval", numbers(&[i.start, i.end])),
        Value::Plane(plane) => {
            let axes = [plane.x_axis, plane.y_axis, plane.z_axis].map(Value::Vector);
            ("Plane", std::iter::once(Value::Point(plane.origin)).chain(axes).collect())
        }
        Value::Line(line) => ("Line", vec![Value::Point(line.from), Value::Point(line.to)]),
        Value::Transform(xform) => ("Transform", numbers(xform.rows.as_flattened())),
        Value::Circle(circle) => ("Circle", vec![Value::Plane(circle.plane), Value::Number(circle.radius)]),
        Value::Arc(arc) => {
            let circle = &arc.circle;
            let fields =
                vec![Value::Plane(circle.plane), Value::Number(circle.radius), Value::Interval(arc.angle)];
            ("Arc", fields)
        }
        Value::Ellipse(own) => {
            ("Ellipse", vec![Value::Plane(own.plane), Value::Number(own.rx), Value::Number(own.ry)])
        }
        Value::Rectangle(own) => {
            ("Rectangle3d", vec![Value::Plane(own.plane), Value::Interval(own.x), Value::Interval(own.y)])
        }
        Value::BoundingBox(own) => ("BoundingBox", vec![Value::Point(own.min), Value::Point(own.max)]),
        Value::Box(own) => {
            let ranges = [own.x, own.y, own.z].map(Value::Interval);
            ("Box", std::iter::once(Value::Plane(own.plane)).chain(ranges).collect())
        }
        Value::Sphere(own) => ("Sphere", vec![Value::Plane(own.plane), Value::Number(own.radius)]),
        Value::Face(corners) => ("MeshFace", corners.iter().map(|i| Value::Int(i64::from(*i))).collect()),
        Value::Map(_) => return record(value),
        _ => return None,
    };
    Some((GEOMETRY, name, fields))
}

/// A solid that comes as named values, as the server's JSON has it.
fn record(map: &Value) -> Option<(&'static str, &'static str, Vec<Value>)> {
    let number = |key| map.get(key).and_then(real).map(Value::Number);
    let fields = if let Some(plane) = map.get("BasePlane") {
        let fields = vec![plane_of(plane)?, number("Radius")?, number("Height1")?, number("Height2")?];
        ("Cylinder", fields)
    } else if let Some(minor) = number("MinorRadius") {
        ("Torus", vec![plane_of(map.get("Plane")?)?, number("MajorRadius")?, minor])
    } else {
        ("Cone", vec![plane_of(map.get("Plane")?)?, number("Height")?, number("Radius")?])
    };
    Some((GEOMETRY, fields.0, fields.1))
}

fn real(value: &Value) -> Option<f64> {
    match value {
        Value::Number(x) => Some(*x),
        #[expect(clippy::cast_precision_loss, reason = "JSON writes a whole number without its point")]
        Value::Int(whole) => Some(*whole as f64),
        _ => None,
    }
}

fn plane_of(value: &Value) -> Option<Value> {
    if let Value::Plane(_) = value {
        return Some(value.clone());
    }
    let triple = |key: &str| {
        let held = value.get(key)?;
        let part = |name| held.get(name).and_then(real);
        Some([part("X")?, part("Y")?, part("Z")?])
    };
    let vector = |key| triple(key).map(|[x, y, z]| Vector3::new(x, y, z));
    let [x, y, z] = triple("Origin")?;
    let (x_axis, y_axis) = (vector("XAxis")?, vector("YAxis")?);
    let z_axis = vector("ZAxis").unwrap_or_else(|| x_axis.cross(y_axis));
    Some(Value::Plane(Plane { origin: Point3::new(x, y, z), x_axis, y_axis, z_axis }))
}

/// A struct of its fields; none for a type that the table has not.
pub(super) fn of_fields(name: &str, parts: &[Value]) -> Option<Value> {
    use Value::{Int, Interval as Range, Number, Plane as Frame, Point as At, Vector as Along};
    Some(match (name, parts) {
        ("Point3d" | "Point3f", [Number(x), Number(y), Number(z)]) => At(Point3::new(*x, *y, *z)),
        ("Vector3d" | "Vector3f", [Number(x), Number(y), Number(z)]) => Along(Vector3::new(*x, *y, *z)),
        ("Point2d" | "Vector2d", [Number(x), Number(y)]) => Value::Point2(Point2::new(*x, *y)),
        ("Interval", [Number(a), Number(b)]) => Range(Interval::new(*a, *b)),
        ("Plane", [At(origin), Along(x), Along(y), Along(z)]) => {
            Frame(Plane { origin: *origin, x_axis: *x, y_axis: *y, z_axis: *z })
        }
        ("Line", [At(from), At(to)]) => Value::Line(Line::new(*from, *to)),
        ("Transform", numbers) => {
            let mut rows = [[0.0; 4]; 4];
            for (own, number) in rows.as_flattened_mut().iter_mut().zip(numbers) {
                *own = real(number)?;
            }
            Value::Transform(Box::new(Xform { rows }))
        }
        ("Circle", [Frame(plane), Number(radius)]) => {
            Value::Circle(Box::new(Circle { plane: *plane, radius: *radius }))
        }
        ("Arc", [Frame(plane), Number(radius), Range(angle)]) => {
            let circle = Circle { plane: *plane, radius: *radius };
            Value::Arc(Box::new(Arc { circle, angle: *angle }))
        }
        ("Ellipse", [Frame(plane), Number(rx), Number(ry)]) => {
            Value::Ellipse(Box::new(Ellipse { plane: *plane, rx: *rx, ry: *ry }))
        }
        ("Rectangle3d", [Frame(plane), Range(x), Range(y)]) => {
            Value::Rectangle(Box::new(Rectangle { plane: *plane, x: *x, y: *y }))
        }
        ("BoundingBox", [At(min), At(max)]) => {
            Value::BoundingBox(Box::new(BoundingBox { min: *min, max: *max }))
        }
        ("Box", [Frame(plane), Range(x), Range(y), Range(z)]) => {
            Value::Box(Box::new(Box3 { plane: *plane, x: *x, y: *y, z: *z }))
        }
        ("Sphere", [Frame(plane), Number(radius)]) => {
            Value::Sphere(Box::new(Sphere { plane: *plane, radius: *radius }))
        }
        ("MeshFace", [Int(a), Int(b), Int(c), Int(d)]) => {
            let corner = |i: i64| i32::try_from(i).ok();
            Value::Face([corner(*a)?, corner(*b)?, corner(*c)?, corner(*d)?])
        }
        ("Polyline" | "Point3dList", [points]) => {
            let point = |value: Value| if let At(p) = value { Some(p) } else { None };
            Value::Polyline(points.items()?.into_iter().map(point).collect::<Option<_>>()?)
        }
        ("CurveList" | "RhinoList" | "CurveIntersections", [items]) => Value::list(items.items()?),
        ("GH_Path", [indices]) => {
            let index = |value: Value| if let Int(i) = value { i32::try_from(i).ok() } else { None };
            Value::Path(indices.items()?.into_iter().map(index).collect::<Option<_>>()?)
        }
        ("Color", [Int(argb), ..]) => {
            let [a, r, g, b] = u32::try_from(*argb).ok()?.to_be_bytes();
            Value::Colour(Colour { a, r, g, b })
        }
        ("Complex", [Number(re), Number(im)]) => Value::Complex(Complex { re: *re, im: *im }),
        ("Guid", [Value::Text(text)]) => Value::Guid(Uuid::parse_str(text).ok()?),
        ("DateTime", [Int(ticks), ..]) => Value::Time(*ticks),
        _ => return None,
    })
}
