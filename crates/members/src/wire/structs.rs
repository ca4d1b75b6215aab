//! Points, vectors, lines, planes, ranges and transforms.

use katydid_geometry::{BoundingBox, Interval, Line, Plane, Point2, Point3, Vector3, Xform};
use serde_json::{Map, Value as Json, json};

use super::numbers::number;
use super::read::{Members, Read, triple};
use super::{Wire, made, no};
use crate::Fault;

/// A point and the direction in which something leaves it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub position: Point3,
    /// Where it goes, of any length but 0.
    pub direction: Vector3,
}

impl Wire for Point3 {
    const TYPE: &'static str = "Rhino.Geometry.Point3d";
    const NAME: &'static str = "a point";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        triple(json).map(Self::from).map_err(no::<Self>)
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        Ok(json!({ "X": number(self.x), "Y": number(self.y), "Z": number(self.z) }))
    }
}

impl Wire for Vector3 {
    const TYPE: &'static str = "Rhino.Geometry.Vector3d";
    const NAME: &'static str = "a vector";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        triple(json).map(Self::from).map_err(no::<Self>)
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        Ok(json!({ "X": number(self.x), "Y": number(self.y), "Z": number(self.z) }))
    }
}

impl Wire for Point2 {
    const TYPE: &'static str = "Rhino.Geometry.Point2d";
    const NAME: &'static str = "a point of parameters";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let [x, y, _] = triple(json).map_err(no::<Self>)?;
        Ok(Self::new(x, y))
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        Ok(json!({ "X": number(self.x), "Y": number(self.y) }))
    }
}

impl Wire for Interval {
    const TYPE: &'static str = "Rhino.Geometry.Interval";
    const NAME: &'static str = "an interval";

    /// `{"T0", "T1"}`, `{"Min", "Max"}` or `[start, end]`.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if let Json::Array(items) = json {
            let [start, end] = items.as_slice() else { return Err(no::<Self>("a list of it has 2 numbers")) };
            let number = |item| f64::read(item).map_err(no::<Self>);
            return Ok(Self::new(number(start)?, number(end)?));
        }
        let members = Members::of(json).map_err(no::<Self>)?;
        let ends =
            |start, end| -> Result<_, Fault> { Ok(Self::new(members.read(start)?, members.read(end)?)) };
        if members.get("T0").is_some() { ends("T0", "T1") } else { ends("Min", "Max") }.map_err(no::<Self>)
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        Ok(json!({ "T0": number(self.start), "T1": number(self.end) }))
    }
}

impl Wire for Line {
    const TYPE: &'static str = "Rhino.Geometry.Line";
    const NAME: &'static str = "a line";

    /// `{"From", "To"}` or `[from, to]`.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if let Json::Array(items) = json {
            let [from, to] = items.as_slice() else { return Err(no::<Self>("a list of it has 2 points")) };
            let point = |item| Point3::read(item).map_err(no::<Self>);
            return Ok(Self::new(point(from)?, point(to)?));
        }
        let members = Members::of(json).map_err(no::<Self>)?;
        let ends = || -> Result<_, Fault> { Ok(Self::new(members.read("From")?, members.read("To")?)) };
        ends().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({ "From": self.from.to_json(archive)?, "To": self.to.to_json(archive)? }))
    }
}

impl Wire for Ray {
    const TYPE: &'static str = "Rhino.Geometry.Ray3d";
    const NAME: &'static str = "a ray";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let ray = Self { position: members.read("Position")?, direction: members.read("Direction")? };
            if ray.direction.unitized().is_none() {
                return Err(Fault::bad_request("its Direction has no length"));
            }
            Ok(ray)
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(
            json!({ "Position": self.position.to_json(archive)?, "Direction": self.direction.to_json(archive)? }),
        )
    }
}

impl Wire for Plane {
    const TYPE: &'static str = "Rhino.Geometry.Plane";
    const NAME: &'static str = "a plane";

    /// `{"Origin", "XAxis", "YAxis"}`, the y axis turned to be at right angles to the first; without axes the world's,
    /// or those of a `Normal` or `ZAxis`.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let origin: Point3 = members.read("Origin")?;
            let (x, y) = (members.get("XAxis"), members.get("YAxis"));
            let normal = members.first(&["Normal", "ZAxis"]);
            let plane = match (x, y, normal) {
                (None, None, None) => Ok(Self::XY.with_origin(origin)),
                (None, None, Some(normal)) => Self::from_normal(origin, Vector3::read(normal)?),
                _ => Self::from_axes(origin, members.read("XAxis")?, members.read("YAxis")?),
            };
            plane.map_err(|error| Fault::bad_request(error.to_string()))
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "Origin": self.origin.to_json(archive)?,
            "XAxis": self.x_axis.to_json(archive)?,
            "YAxis": self.y_axis.to_json(archive)?,
            "ZAxis": self.z_axis.to_json(archive)?,
            "Normal": self.z_axis.to_json(archive)?,
        }))
    }
}

impl Wire for BoundingBox {
    const TYPE: &'static str = "Rhino.Geometry.BoundingBox";
    const NAME: &'static str = "a bounding box";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            let (min, max): (Point3, Point3) = (members.read("Min")?, members.read("Max")?);
            if min.x > max.x || min.y > max.y || min.z > max.z {
                return Err(Fault::bad_request("its Min lies beyond its Max"));
            }
            Ok(Self { min, max })
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({ "Min": self.min.to_json(archive)?, "Max": self.max.to_json(archive)? }))
    }
}

/// The members of a transform, row by row.
fn matrix_names() -> impl Iterator<Item = (usize, usize, String)> {
    (0..4).flat_map(|row| (0..4).map(move |column| (row, column, format!("M{row}{column}"))))
}

impl Wire for Xform {
    const TYPE: &'static str = "Rhino.Geometry.Transform";
    const NAME: &'static str = "a transform";

    /// `{"M00", ..., "M33"}`, a list of 16 numbers row by row, or a list of 4 rows.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let mut rows = [[0.0; 4]; 4];
            if let Json::Array(items) = json {
                let nested = items.iter().map(Json::as_array).collect::<Option<Vec<_>>>();
                let flat: Vec<&Json> = match &nested {
                    Some(lists) => lists.iter().flat_map(|row| row.iter()).collect(),
                    None => items.iter().collect(),
                };
                if flat.len() != 16 {
                    return Err(Fault::bad_request(format!(
                        "a list of it has 16 numbers, not {}",
                        flat.len()
                    )));
                }
                for (cell, item) in rows.iter_mut().flatten().zip(flat) {
                    *cell = f64::read(item)?;
                }
            } else {
                let members = Members::of(json)?;
                for (cell, (_, _, name)) in rows.iter_mut().flatten().zip(matrix_names()) {
                    *cell = members.read(&name)?;
                }
            }
            Ok(Self { rows })
        };
        read().map_err(no::<Self>)
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        let cells = self.rows.iter().flatten().zip(matrix_names());
        Ok(Json::Object(cells.map(|(cell, (_, _, name))| (name, number(*cell))).collect::<Map<_, _>>()))
    }
}

/// The points of a polyline, as a list of them.
pub(super) fn polyline(json: &Json) -> Option<Result<katydid_geometry::PolylineCurve, Fault>> {
    let items = json.as_array()?;
    let points: Result<Vec<Point3>, Fault> = items.iter().map(Point3::read).collect();
    Some(points.and_then(|points| {
        let curve = katydid_geometry::PolylineCurve::new(points);
        curve.map_err(|error| Fault::bad_request(format!("is not a polyline: {error}")))
    }))
}

impl Wire for katydid_geometry::Circle {
    const TYPE: &'static str = "Rhino.Geometry.Circle";
    const NAME: &'static str = "a circle";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let read = || -> Result<_, Fault> {
            let members = Members::of(json)?;
            Ok((super::read::plane_of(&members, &["Plane"], "Normal")?, members.read("Radius")?))
        };
        let (plane, radius) = read().map_err(no::<Self>)?;
        made(Self::new(plane, radius))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Ok(json!({
            "Radius": number(self.radius),
            "Plane": self.plane.to_json(archive)?,
            "Center": self.plane.origin.to_json(archive)?,
            "Normal": self.plane.z_axis.to_json(archive)?,
        }))
    }
}
