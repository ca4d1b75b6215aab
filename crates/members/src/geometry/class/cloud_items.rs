//! Items of point clouds: points with their normals, colours and values.

use katydid_3dm::PointCloud;
use katydid_data::Colour;
use katydid_geometry::{Point3, Vector3};

use super::beyond;
use super::marks::{Cloud, cloud};
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::{Record, Shape};
use crate::{Fault, Value};

type Index = Count<0, 100_000_000>;

/// What a point has whose cloud got colours later.
const NO_COLOUR: [u8; 4] = [0, 0, 0, 255];

pub(super) fn enter(table: &mut Endpoints) {
    asked(table);
    changed(table);
}

fn asked(table: &mut Endpoints) {
    table.member("PointCloud.get_Item this index", |Cloud(own): Cloud, i: Index| item(&own, i.0));
    table.member("PointCloud.get_ContainsNormals this", |Cloud(own): Cloud| Ok(has(&own, own.normals.len())));
    table.member("PointCloud.get_ContainsColors this", |Cloud(own): Cloud| Ok(has(&own, own.colours.len())));
    table.member("PointCloud.get_ContainsPointValues this", |Cloud(own): Cloud| {
        Ok(has(&own, own.values.len()))
    });
    table.member("PointCloud.get_HiddenPointCount this", |_: Cloud| Ok(0_i32));
    table.member("PointCloud.GetNormals this", |Cloud(own): Cloud| Ok(own.normals));
    table.member("PointCloud.GetColors this", |Cloud(own): Cloud| {
        Ok(own.colours.iter().map(|colour| colour_of(*colour)).collect::<Vec<Colour>>())
    });
    table.member("PointCloud.GetPointValues this", |Cloud(own): Cloud| Ok(own.values));
}

fn changed(table: &mut Endpoints) {
    table.member("PointCloud.Add &this point color", |Cloud(own): Cloud, point: Point3, colour: Colour| {
        added(own, point, None, Some(colour))
    });
    table.member("PointCloud.Add &this point normal", |Cloud(own): Cloud, point: Point3, normal: Vector3| {
        added(own, point, Some(normal), None)
    });
    table.member(
        "PointCloud.Add &this point normal color",
        |Cloud(own): Cloud, point: Point3, normal: Vector3, colour: Colour| {
            added(own, point, Some(normal), Some(colour))
        },
    );
    table.member(
        "PointCloud.AddRange &this points colors",
        |Cloud(mut own): Cloud, points: Vec<Point3>, colours: Vec<Colour>| {
            if points.len() != colours.len() {
                return Err(Fault::bad_request(format!(
                    "{} colors for {} points",
                    colours.len(),
                    points.len()
                )));
            }
            own.colours.resize(own.points.len(), NO_COLOUR);
            own.points.extend(points);
            own.colours.extend(colours.iter().map(|colour| bytes_of(*colour)));
            filled(own)
        },
    );
    table.member("PointCloud.Insert &this index point", |Cloud(mut own): Cloud, i: Index, point: Point3| {
        if i.0 > own.points.len() {
            return Err(beyond(i.0, own.points.len()));
        }
        if !(own.normals.is_empty() && own.colours.is_empty() && own.values.is_empty()) {
            return Err(Fault::not_supported(
                "points inserted into a PointCloud with normals, colours or values",
            ));
        }
        own.points.insert(i.0, point);
        Ok(((), cloud(own)))
    });
    table.member("PointCloud.Merge &this other", |Cloud(mut own): Cloud, Cloud(more): Cloud| {
        let (before, after) = (own.points.len(), own.points.len() + more.points.len());
        own.points.extend(more.points);
        if !(own.normals.is_empty() && more.normals.is_empty()) {
            own.normals.resize(before, Vector3::ZERO);
            own.normals.extend(more.normals);
            own.normals.resize(after, Vector3::ZERO);
        }
        if !(own.colours.is_empty() && more.colours.is_empty()) {
            own.colours.resize(before, NO_COLOUR);
            own.colours.extend(more.colours);
            own.colours.resize(after, NO_COLOUR);
        }
        if !(own.values.is_empty() && more.values.is_empty()) {
            own.values.resize(before, 0.0);
            own.values.extend(more.values);
            own.values.resize(after, 0.0);
        }
        Ok(((), cloud(own)))
    });
    table.member("PointCloud.RemoveRange &this indices", |Cloud(own): Cloud, indices: Vec<Index>| {
        let mut goes = vec![false; own.points.len()];
        for index in &indices {
            let count = goes.len();
            *goes.get_mut(index.0).ok_or_else(|| beyond(index.0, count))? = true;
        }
        let removed = goes.iter().filter(|gone| **gone).count();
        Ok((removed, cloud(kept(own, &goes))))
    });
    table.member("PointCloud.ClearColors &this", |Cloud(mut own): Cloud| {
        own.colours.clear();
        Ok(((), cloud(own)))
    });
    table.member("PointCloud.ClearNormals &this", |Cloud(mut own): Cloud| {
        own.normals.clear();
        Ok(((), cloud(own)))
    });
    table.member("PointCloud.ClearPointValues &this", |Cloud(mut own): Cloud| {
        own.values.clear();
        Ok(((), cloud(own)))
    });
}

/// Whether a list beside the points says something of each.
fn has(own: &PointCloud, count: usize) -> bool {
    count > 0 && count == own.points.len()
}

fn colour_of([r, g, b, a]: [u8; 4]) -> Colour {
    Colour { r, g, b, a }
}

fn bytes_of(colour: Colour) -> [u8; 4] {
    [colour.r, colour.g, colour.b, colour.a]
}

/// A `PointCloudItem`: what the cloud has not is RhinoCommon's default.
fn item(own: &PointCloud, place: usize) -> Outcome<Record> {
    let at = *own.points.get(place).ok_or_else(|| beyond(place, own.points.len()))?;
    let normal = own.normals.get(place).copied().unwrap_or(Vector3::ZERO);
    let colour = own.colours.get(place).copied().unwrap_or(NO_COLOUR);
    let fields = vec![
        ("Location", Value::Point(at)),
        ("X", Value::Number(at.x)),
        ("Y", Value::Number(at.y)),
        ("Z", Value::Number(at.z)),
        ("Normal", Value::Vector(normal)),
        ("Color", Value::Colour(colour_of(colour))),
        ("PointValue", Value::Number(own.values.get(place).copied().unwrap_or(0.0))),
        ("Hidden", Value::Bool(false)),
        ("Index", super::brep_parts::index(place)),
    ];
    Ok(Record { class: "PointCloudItem", fields })
}

/// A point behind the others, with what is said of it. Points before that nothing was said of get a default.
fn added(
    mut own: PointCloud,
    point: Point3,
    normal: Option<Vector3>,
    colour: Option<Colour>,
) -> Outcome<((), Shape)> {
    let before = own.points.len();
    own.points.push(point);
    if let Some(normal) = normal {
        own.normals.resize(before, Vector3::ZERO);
        own.normals.push(normal);
    }
    if let Some(colour) = colour {
        own.colours.resize(before, NO_COLOUR);
        own.colours.push(bytes_of(colour));
    }
    filled(own)
}

/// A cloud whose lists beside the points are as long as they, or empty.
fn filled(mut own: PointCloud) -> Outcome<((), Shape)> {
    let count = own.points.len();
    if !own.normals.is_empty() {
        own.normals.resize(count, Vector3::ZERO);
    }
    if !own.colours.is_empty() {
        own.colours.resize(count, NO_COLOUR);
    }
    if !own.values.is_empty() {
        own.values.resize(count, 0.0);
    }
    Ok(((), cloud(own)))
}

/// The cloud without some of its points.
fn kept(mut own: PointCloud, goes: &[bool]) -> PointCloud {
    fn without<T>(list: &mut Vec<T>, goes: &[bool]) {
        let mut places = goes.iter();
        // What is longer than the points means nothing, and stays.
        list.retain(|_| !places.next().copied().unwrap_or(false));
    }
    without(&mut own.points, goes);
    without(&mut own.normals, goes);
    without(&mut own.colours, goes);
    without(&mut own.values, goes);
    own
}
