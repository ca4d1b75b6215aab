//! Point clouds and text dots.

use std::sync::Arc;

use katydid_3dm::{Limits, Object, PointCloud, TextDot};
use katydid_data::Value as Data;
use katydid_geometry::{Point3, Xform};

use super::beyond;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape};
use crate::wire::Read;
use crate::{Fault, Value};

type Index = Count<0, 100_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    clouds(table);
    dots(table);
}

fn clouds(table: &mut Endpoints) {
    table.member("PointCloud.new", || Ok(shape(Object::PointCloud(PointCloud::default()))));
    table.member("PointCloud.new points", |points: Vec<Point3>| Ok(cloud(points.into())));
    table.member("PointCloud.new other", |Cloud(own): Cloud| Ok(cloud(own)));
    table.member("PointCloud.get_Count this", |Cloud(own): Cloud| Ok(own.points.len()));
    for signature in ["PointCloud.GetPoints this", "PointCloud.AsReadOnlyListOfPoints this"] {
        table.member(signature, |Cloud(own): Cloud| Ok(own.points));
    }
    table.member("PointCloud.PointAt this index", |Cloud(own): Cloud, i: Index| {
        own.points.get(i.0).copied().ok_or_else(|| beyond(i.0, own.points.len()))
    });
    table.member("PointCloud.Add &this point", |Cloud(own): Cloud, point: Point3| added(own, &[point]));
    table
        .member("PointCloud.AddRange &this points", |Cloud(own): Cloud, more: Vec<Point3>| added(own, &more));
    table.member("PointCloud.RemoveAt &this index", |Cloud(mut own): Cloud, i: Index| {
        if i.0 >= own.points.len() {
            return Err(beyond(i.0, own.points.len()));
        }
        own.points.remove(i.0);
        remove_beside(&mut own, i.0);
        Ok(((), cloud(own)))
    });
    table.member("PointCloud.ClosestPoint this testPoint", |Cloud(own): Cloud, test: Point3| {
        let far = |point: &Point3| point.distance_to(test);
        let places = own.points.iter().enumerate();
        let nearest = places.min_by(|(_, a), (_, b)| far(a).total_cmp(&far(b)));
        Ok(nearest.map_or(-1, |(place, _)| i32::try_from(place).unwrap_or(-1)))
    });
}

/// Takes the entry of a point out of the lists beside the points: one of another length would mean nothing.
fn remove_beside(own: &mut PointCloud, place: usize) {
    if place < own.normals.len() {
        own.normals.remove(place);
    }
    if place < own.colours.len() {
        own.colours.remove(place);
    }
    if place < own.values.len() {
        own.values.remove(place);
    }
}

/// Points behind the others. Normals, colours and values are for all points or none.
fn added(mut own: PointCloud, more: &[Point3]) -> Result<((), Shape), Fault> {
    if !own.normals.is_empty() || !own.colours.is_empty() || !own.values.is_empty() {
        return Err(Fault::not_supported("points added to a PointCloud with normals, colours or values"));
    }
    own.points.extend_from_slice(more);
    Ok(((), cloud(own)))
}

fn dots(table: &mut Endpoints) {
    table.member("TextDot.new text location", |text: String, at: Point3| {
        Ok(shape(Object::TextDot(TextDot::new(at, text))))
    });
    table.member("TextDot.get_Text this", |Dot(own): Dot| Ok(own.text));
    table.member("TextDot.set_Text &this text", |Dot(own): Dot, text: String| {
        Ok(((), shape(Object::TextDot(TextDot { text, ..own }))))
    });
    table.member("TextDot.get_Point this", |Dot(own): Dot| Ok(own.point));
    table.member("TextDot.set_Point &this point", |Dot(own): Dot, point: Point3| {
        Ok(((), shape(Object::TextDot(TextDot { point, ..own }))))
    });
    table.member("TextDot.get_FontHeight this", |Dot(own): Dot| Ok(own.height));
    table.member("TextDot.get_FontFace this", |Dot(own): Dot| Ok(own.font));
}

fn shape(object: Object) -> Shape {
    Shape::Other(Arc::new(object))
}

/// A cloud; the box that a file may hold of other points is not kept.
pub(super) fn cloud(own: PointCloud) -> Shape {
    shape(Object::PointCloud(PointCloud { bounds: PointCloud::default().bounds, ..own }))
}

/// Whether [`moved`] moves an object.
pub(super) fn moves(object: &Object) -> bool {
    matches!(object, Object::PointCloud(_) | Object::TextDot(_) | Object::Hatch(_))
}

/// A cloud or a dot moved; other objects as they are.
pub(super) fn moved(object: Object, xform: &Xform) -> Result<Object, Fault> {
    Ok(match object {
        Object::PointCloud(mut own) => {
            own.points.iter_mut().for_each(|point| *point = xform.point(*point));
            own.normals.iter_mut().for_each(|normal| *normal = xform.vector(*normal));
            own.bounds = PointCloud::default().bounds;
            Object::PointCloud(own)
        }
        Object::TextDot(dot) => Object::TextDot(TextDot { point: xform.point(dot.point), ..dot }),
        hatch @ Object::Hatch(_) => {
            let none = || Fault::failed("the hatch has no image under the transform");
            let data = Data::from_object(hatch, &[]).ok_or_else(none)?;
            match data.transformed(xform).map_err(|error| Fault::bad_request(error.to_string()))? {
                Data::Kept(raw) => {
                    raw.parse(&Limits::default()).map_err(|error| Fault::failed(error.to_string()))?
                }
                _ => return Err(none()),
            }
        }
        other => other,
    })
}

/// A point cloud.
pub(super) struct Cloud(pub(super) PointCloud);
/// A text dot.
struct Dot(TextDot);

/// An object of a model, of one kind.
macro_rules! read_object {
    ($kind:ident, $variant:ident, $name:literal, $held:expr) => {
        impl Read for $kind {
            fn read(_: &serde_json::Value) -> Result<Self, Fault> {
                Err(Fault::bad_request(concat!("is no ", $name)))
            }

            fn of_value(value: &Value) -> Result<Self, Fault> {
                match value {
                    Value::Geometry(Geometry { shape: Shape::Other(object), .. }) => match &**object {
                        Object::$variant(own) => {
                            let held: fn(&_) -> _ = $held;
                            Ok(Self(held(own)))
                        }
                        _ => Err(Fault::bad_request(concat!("is no ", $name))),
                    },
                    other => Err(Fault::bad_request(format!("is {}, no {}", other.noun(), $name))),
                }
            }

            fn type_name() -> String {
                $name.into()
            }
        }
    };
}

read_object!(Cloud, PointCloud, "PointCloud", PointCloud::clone);
read_object!(Dot, TextDot, "TextDot", TextDot::clone);
pub(super) use read_object;
