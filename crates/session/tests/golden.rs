//! Previews byte for byte as they were agreed on, one of each kind. The same files are read by the studio's own test
//! (`studio/tests/unit/golden.test.ts`) and compared with what is written beside them, so that both sides are held to one
//! layout. `KATYDID_GOLDEN=write` writes them anew, when the layout is meant to change.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly"
)]

mod reader;

use std::path::Path as FilePath;

use katydid_data::cast::Rules;
use katydid_data::{Column, Path, Tree, Value};
use katydid_definition::document::{Object, ids};
use katydid_geometry::{
    Curve, Mesh, MeshFace, NurbsCurve, NurbsSurface, Plane, Point3, PolylineCurve, Vector3,
};
use katydid_session::analysis;
use katydid_session::display::{Fineness, Geometry, Shown, encode};
use katydid_session::protocol::{AnalysisView, CombView, IsocurvesView, Part, PartKind, Slice, SliceType};
use reader::Read;
use serde_json::{Value as Json, json};
use uuid::{Uuid, uuid};

const OBJECT: Uuid = uuid!("0f8fad5b-d9cb-469f-a165-70867728950e");
const POINT_ORDER: Uuid = uuid!("0ad9f1ab-2204-45bb-b282-474469e2fa7b");
const TEXT_TAG: Uuid = uuid!("3b220754-4114-4170-b6c3-b286b86ed524");

fn tree(values: impl IntoIterator<Item = Value>) -> Tree {
    let column = Column::of_values(values.into_iter().collect(), None);
    Tree::branch_at(Path::from([0, 3].as_slice()), column)
}

fn parameter() -> Object {
    Object::new_parameter(ids::GEOMETRY, "Geometry", "Geo", OBJECT)
}

fn drawn(object: &Object, outputs: &[Tree], inputs: &[Tree]) -> Geometry {
    let shown = Shown { object, outputs, inputs };
    encode(&[shown], &Rules::default(), Fineness::Coarse, || true).remove(0).geometry.unwrap()
}

fn of_values(values: impl IntoIterator<Item = Value>) -> Geometry {
    drawn(&parameter(), &[tree(values)], &[])
}

fn of_component(id: Uuid, inputs: &[Tree]) -> Geometry {
    katydid_components::link();
    let mut object = Object::new_component(id, "Display", "Display", OBJECT);
    object.hidden = false;
    drawn(&object, &[], inputs)
}

fn points() -> Vec<Point3> {
    [[1000.0, 2000.0, -3.0], [1001.5, 2000.25, 0.0], [1002.0, 2004.0, 1.0], [1005.0, 2003.0, 0.5]]
        .map(Point3::from)
        .to_vec()
}

fn curve() -> NurbsCurve {
    NurbsCurve::with_weights(2, &points(), &[1.0, 0.5, 2.0, 1.0], vec![0.0, 0.0, 0.5, 1.0, 1.0]).unwrap()
}

fn patch() -> NurbsSurface {
    let grid: Vec<Point3> =
        (0..9).map(|k| Point3::new(f64::from(k / 3), f64::from(k % 3), f64::from((k * 5) % 4))).collect();
    NurbsSurface::clamped_uniform([2, 2], [3, 3], &grid).unwrap()
}

fn mesh() -> Mesh {
    let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 2.0, 0.0]];
    let faces = vec![MeshFace::Quad([0, 1, 2, 3]), MeshFace::Triangle([3, 2, 4])];
    let colours = (0..5_u8).map(|k| [40 * k, 255 - 40 * k, 7, 255]).collect();
    Mesh::from_parts(corners.map(Point3::from).to_vec(), faces, vec![Vector3::Z; 5], colours).unwrap()
}

fn analysed() -> Geometry {
    let object = parameter();
    let outputs = [tree([
        Value::Curve(std::sync::Arc::new(curve().into())),
        Value::Surface(std::sync::Arc::new(patch().into())),
    ])];
    let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
    let subjects = analysis::Subjects::of(&shown, &Rules::default());
    let view = AnalysisView {
        comb: Some(CombView { teeth: 3, length: 0.25, surfaces: false }),
        circles: 1,
        controls: true,
        isocurves: Some(IsocurvesView { between: 1, directions: true }),
        ..AnalysisView::default()
    };
    let measured = analysis::measure(&[&subjects], &view, false, None);
    analysis::encode(&[(OBJECT, &subjects)], &view, &measured.measure, || true).remove(0).1.unwrap()
}

fn all() -> Vec<(&'static str, Geometry)> {
    let polyline: Curve = PolylineCurve::new(points()).unwrap().into();
    let places = || tree(points().into_iter().map(Value::Point));
    let words = ["höhe 高さ", "<b>\"1\"</b>", "", "w = 2"].map(Value::text);
    vec![
        ("points", of_values(points().into_iter().map(Value::Point))),
        ("curves", of_values([polyline, curve().into()].map(|c| Value::Curve(std::sync::Arc::new(c))))),
        ("planes", of_values([Value::Plane(std::sync::Arc::new(Plane::XY))])),
        ("mesh", of_values([Value::Mesh(std::sync::Arc::new(mesh()))])),
        ("surface", of_values([Value::Surface(std::sync::Arc::new(patch().into()))])),
        ("arrows", of_component(POINT_ORDER, &[places()])),
        ("texts", of_component(TEXT_TAG, &[places(), tree(words)])),
        ("analysis", analysed()),
    ]
}

/// The numbers of an array, by the words of the layout.
fn numbers(read: &Read, slice: Option<&Slice>) -> Json {
    let Some(slice) = slice else { return Json::Null };
    let (start, count) = (slice.offset as usize, slice.count as usize);
    let bytes = &read.arrays[start..];
    let list: Vec<f64> = (0..count)
        .map(|k| match slice.kind {
            SliceType::F32 => f64::from(f32::from_le_bytes(bytes[4 * k..4 * k + 4].try_into().unwrap())),
            SliceType::U32 => f64::from(u32::from_le_bytes(bytes[4 * k..4 * k + 4].try_into().unwrap())),
            SliceType::U16 => f64::from(u16::from_le_bytes(bytes[2 * k..2 * k + 2].try_into().unwrap())),
            SliceType::U8 => f64::from(bytes[k]),
            SliceType::I8 => f64::from(bytes[k] as i8),
        })
        .collect();
    json!(list)
}

/// What a reader must find.
fn words(geometry: &Geometry) -> Json {
    let read = Read::new(geometry);
    let part = |part: &Part| {
        json!({
            "kind": part.kind,
            "colour": part.colour,
            "width": part.width,
            "positions": numbers(&read, Some(&part.positions)),
            "normals": numbers(&read, part.normals.as_ref()),
            "colours": numbers(&read, part.colours.as_ref()),
            "values": numbers(&read, part.values.as_ref()),
            "mean": numbers(&read, part.mean.as_ref()),
            "indices": numbers(&read, part.indices.as_ref()),
            "texts": part.texts,
            "textHeight": part.text_height,
            "pieces": part.pieces,
        })
    };
    json!({
        "object": read.header.object,
        "origin": read.header.origin,
        "bounds": read.header.bounds,
        "draft": read.header.draft,
        "parts": read.header.parts.iter().map(part).collect::<Vec<_>>(),
    })
}

#[test]
fn previews_are_byte_for_byte_as_they_were_agreed_on() {
    let folder = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let writes = std::env::var("KATYDID_GOLDEN").is_ok_and(|value| value == "write");
    let mut kinds = std::collections::HashSet::new();
    for (name, geometry) in all() {
        let text = serde_json::to_string(&words(&geometry)).unwrap() + "\n";
        let [bytes_at, text_at] = ["preview", "json"].map(|ending| folder.join(format!("{name}.{ending}")));
        if writes {
            std::fs::write(&bytes_at, &geometry.bytes).unwrap();
            std::fs::write(&text_at, &text).unwrap();
        }
        let read = Read::new(&geometry);
        kinds.extend(read.header.parts.iter().map(|part| part.kind as u8));
        let kept = std::fs::read(&bytes_at).unwrap();
        assert!(
            kept == geometry.bytes,
            "{name}: the bytes differ; KATYDID_GOLDEN=write if they are meant to"
        );
        assert_eq!(std::fs::read_to_string(&text_at).unwrap(), text, "{name}");
    }
    assert_eq!(kinds.len(), PartKind::Texts as usize + 1, "one of each kind");
}
