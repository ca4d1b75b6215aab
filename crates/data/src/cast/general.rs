//! To types that are not geometry, and to those that take almost anything.

use std::sync::Arc as Shared;

use katydid_geometry::{Matrix, Xform};

use super::Sure::{Likely, Shown, Used};
use super::way::{Way, way};
use super::{number, parse};
use crate::{Compound, Kind, Material, ModelObject, Path, Value, text};

pub(super) const WAYS: &[Way] = &[
    way(Kind::Generic, &[Kind::Generic], "the same, unchanged", Shown, |v, _| Some(v.clone())),
    way(Kind::Geometry, &[Kind::Geometry], "the same, unchanged", Shown, |v, _| Some(v.clone())),
    way(Kind::Geometry, &[Kind::Text], "the point that it reads as", Likely, |v, _| match v {
        Value::Text(text) => parse::point(text).map(Value::Point),
        _ => None,
    }),
    way(Kind::Text, &[Kind::Generic], "what a panel shows of it", Shown, |v, rules| {
        let style = text::Style { units: rules.units, tolerance: rules.tolerance };
        Some(Value::text(text::value(v, &style)))
    }),
    way(Kind::Guid, &[Kind::Text], "the id that it spells", Likely, |v, _| match v {
        Value::Text(text) => uuid::Uuid::parse_str(text.trim()).ok().map(Value::Guid),
        _ => None,
    }),
    way(
        Kind::Time,
        &[Kind::Text],
        "the date and time that it spells, or that of now for `Now`",
        Used,
        |v, rules| match v {
            Value::Text(text) if text.trim().eq_ignore_ascii_case("now") => rules.now.map(Value::Time),
            Value::Text(text) => parse::time(text).map(Value::Time),
            _ => None,
        },
    ),
    way(
        Kind::Time,
        &[Kind::Number, Kind::Integer],
        "the day of that number, counted from 1899-12-30",
        Likely,
        |v, _| number::number(v).and_then(number::day).map(Value::Time),
    ),
    way(
        Kind::Path,
        &[Kind::Text],
        "the path that it spells, such as `{0;1}` or `3`",
        Shown,
        |v, _| match v {
            Value::Text(text) => text.parse().ok().map(Value::Path),
            _ => None,
        },
    ),
    way(Kind::Path, &[Kind::Integer, Kind::Number], "the path of that one index", Likely, |v, _| match v {
        Value::Integer(i) => Some(Value::Path(Path::from([*i]))),
        _ => number::integer(v).map(|i| Value::Path(Path::from([i]))),
    }),
    way(
        Kind::MeshFace,
        &[Kind::Text],
        "the face that it spells, such as `Q{0;1;2;3}`",
        Shown,
        |v, _| match v {
            Value::Text(text) => parse::mesh_face(text).map(Value::MeshFace),
            _ => None,
        },
    ),
    // A compound is a transform: it stays whole, so that it can be taken apart later.
    way(Kind::Transform, &[Kind::Compound], "the same, whole", Likely, |v, _| Some(v.clone())),
    way(Kind::Transform, &[Kind::Vector], "the move along it", Likely, |v, _| match v {
        Value::Vector(v) => Some(Value::from(Xform::translation(*v))),
        _ => None,
    }),
    way(Kind::Transform, &[Kind::Plane], "the map that brings world XY onto it", Used, |v, _| match v {
        Value::Plane(plane) => Some(Value::from(Xform::plane_to_plane(&katydid_geometry::Plane::XY, plane))),
        _ => None,
    }),
    way(
        Kind::Transform,
        &[Kind::Matrix],
        "the map of a matrix of four rows and four columns",
        Likely,
        |v, _| match v {
            Value::Matrix(m) if (m.rows(), m.columns()) == (4, 4) => {
                let rows = std::array::from_fn(|i| std::array::from_fn(|j| m.get(i, j).unwrap_or_default()));
                Some(Value::from(Xform { rows }))
            }
            _ => None,
        },
    ),
    way(Kind::Compound, &[Kind::Transform], "the same, as the only part", Likely, |v, _| match v {
        Value::Transform(x) => Some(Value::from(Compound { parts: vec![**x] })),
        _ => None,
    }),
    way(
        Kind::Matrix,
        &[Kind::Transform, Kind::Compound],
        "its four rows and four columns",
        Likely,
        |v, _| {
            let matrix = Matrix::new(4, 4, v.as_transform()?.rows.concat());
            matrix.ok().map(|m| Value::Matrix(Shared::new(m)))
        },
    ),
    way(
        Kind::Material,
        &[Kind::Colour, Kind::Text, Kind::Integer, Kind::Number, Kind::Point, Kind::Vector],
        "the plain material of that colour",
        Likely,
        |v, _| number::colour(v).map(|c| Value::Material(Shared::new(Material::from(c)))),
    ),
    way(
        Kind::Location,
        &[Kind::Point, Kind::Text],
        "the place of that longitude and latitude in degrees",
        Likely,
        |v, _| parse::location(v).map(Value::Location),
    ),
    way(
        Kind::Content,
        &[Kind::Geometry],
        "a model object with that geometry and no attributes",
        Likely,
        |v, _| Some(Value::from(ModelObject::new(v.clone()))),
    ),
    way(
        Kind::Content,
        &[Kind::Text],
        "a model object with the point that it reads as",
        Likely,
        |v, _| match v {
            Value::Text(text) => parse::point(text).map(|p| Value::from(ModelObject::new(Value::Point(p)))),
            _ => None,
        },
    ),
];
