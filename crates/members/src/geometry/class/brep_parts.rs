//! Faces, edges, vertices and loops of Breps.

use std::sync::Arc;

use katydid_geometry::brep::LoopKind;
use katydid_geometry::{Brep, Curve};

use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Record, Shape};
use crate::wire::Read;
use crate::{Fault, Value};

type Index = Count<0, 10_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Brep.get_Faces this", |b: Whole| Ok(b.faces()));
    table.member("Brep.get_Edges this", |b: Whole| Ok(b.edges()));
    table.member("Brep.get_Vertices this", |b: Whole| {
        Ok((0..b.0.vertices().len()).map(|place| vertex(&b.0, place)).collect::<Vec<Record>>())
    });
    table.member("Brep.get_Loops this", |b: Whole| {
        (0..b.0.loops().len()).map(|place| loop_record(&b.0, place)).collect::<Outcome<Vec<Record>>>()
    });
    faces(table);
    edges(table);
}

fn faces(table: &mut Endpoints) {
    table.member("BrepFace.get_FaceIndex this", |f: Part| Ok(f.place));
    table.member("BrepFace.get_Brep this", |f: Part| Ok(Shape::Brep(f.brep)));
    table.member("BrepFace.get_OrientationIsReversed this", |f: Part| {
        Ok(f.brep.faces().get(f.place).is_some_and(|face| face.reversed))
    });
    table.member("BrepFace.get_IsSurface this", |f: Part| {
        Ok(f.brep.sub_brep(&[f.place])?.as_surface().is_some())
    });
    table.member("BrepFace.DuplicateFace this duplicateMeshes", |f: Part, _: bool| {
        Ok(f.brep.sub_brep(&[f.place])?)
    });
    table.member("BrepFace.DuplicateSurface this", |f: katydid_geometry::Surface| Ok(f));
    table.member("BrepFace.UnderlyingSurface this", |f: katydid_geometry::Surface| Ok(f));
    table.member("BrepFace.get_OuterLoop this", |f: Part| {
        let own = loops_of(&f.brep, f.place);
        let outer = own.iter().find(|place| kind(&f.brep, **place) == Some(LoopKind::Outer));
        match outer.or(own.first()) {
            Some(place) => loop_record(&f.brep, *place),
            None => Err(Fault::failed("the face has no loop")),
        }
    });
    table.member("BrepFace.get_Loops this", |f: Part| {
        loops_of(&f.brep, f.place)
            .iter()
            .map(|place| loop_record(&f.brep, *place))
            .collect::<Outcome<Vec<_>>>()
    });
    table.member("BrepFace.AdjacentEdges this", |f: Part| Ok(edges_of(&f.brep, f.place)));
    table.member("BrepFace.AdjacentFaces this", |f: Part| {
        let mut others: Vec<usize> =
            edges_of(&f.brep, f.place).into_iter().flat_map(|edge| faces_at(&f.brep, edge)).collect();
        others.sort_unstable();
        others.dedup();
        others.retain(|other| *other != f.place);
        Ok(others)
    });
}

fn edges(table: &mut Endpoints) {
    table.member("BrepEdge.get_EdgeIndex this", |e: Part| Ok(e.place));
    table.member("BrepEdge.get_Brep this", |e: Part| Ok(Shape::Brep(e.brep)));
    table.member("BrepEdge.get_EdgeCurve this", |e: Curve| Ok(e));
    table.member("BrepEdge.get_Tolerance this", |e: Part| {
        Ok(e.brep.edges().get(e.place).map_or(0.0, |edge| edge.tolerance))
    });
    table.member("BrepEdge.get_TrimCount this", |e: Part| {
        Ok(e.brep.edges().get(e.place).map_or(0, |edge| edge.trims.len()))
    });
    table.member("BrepEdge.AdjacentFaces this", |e: Part| Ok(faces_at(&e.brep, e.place)));
    table.member("BrepEdge.get_StartVertex this", |e: Part| end(&e, 0));
    table.member("BrepEdge.get_EndVertex this", |e: Part| end(&e, 1));
    table.member("Brep.Face this index", |b: Whole, i: Index| {
        b.faces().into_iter().nth(i.0).ok_or_else(|| Fault::bad_request(format!("there is no face {}", i.0)))
    });
    table.member("Brep.Edge this index", |b: Whole, i: Index| {
        b.edges().into_iter().nth(i.0).ok_or_else(|| Fault::bad_request(format!("there is no edge {}", i.0)))
    });
}

/// A whole Brep, shared.
pub(super) struct Whole(pub(super) Arc<Brep>);

impl Whole {
    fn faces(&self) -> Vec<Shape> {
        (0..self.0.faces().len()).map(|place| Shape::Face(self.0.clone(), place)).collect()
    }

    fn edges(&self) -> Vec<Shape> {
        (0..self.0.edges().len()).map(|place| Shape::Edge(self.0.clone(), place)).collect()
    }
}

impl Read for Whole {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Brep::read(json).map(|brep| Self(Arc::new(brep)))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Geometry { shape, .. }) => match shape.brep() {
                Some(brep) => brep.map(Self),
                None => Err(Fault::bad_request(format!("is a {}, not a brep", shape.class()))),
            },
            other => Brep::of_value(other).map(|brep| Self(Arc::new(brep))),
        }
    }

    fn type_name() -> String {
        "Brep".into()
    }
}

/// A face or an edge, as a part of its Brep.
struct Part {
    brep: Arc<Brep>,
    place: usize,
}

impl Read for Part {
    fn read(_: &serde_json::Value) -> Result<Self, Fault> {
        Err(Fault::bad_request("is no part of a brep"))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Geometry {
                shape: Shape::Face(brep, place) | Shape::Edge(brep, place), ..
            }) => Ok(Self { brep: brep.clone(), place: *place }),
            other => Err(Fault::bad_request(format!("is {}, no part of a brep", other.noun()))),
        }
    }

    fn type_name() -> String {
        "BrepPart".into()
    }
}

pub(super) fn index(place: usize) -> Value {
    i64::try_from(place).map_or(Value::Null, Value::Int)
}

/// A `BrepVertex`.
pub(super) fn vertex(brep: &Brep, place: usize) -> Record {
    let own = brep.vertices().get(place);
    let edges = own.map(|own| own.edges.iter().map(|edge| index(*edge)).collect()).unwrap_or_default();
    let fields = vec![
        ("VertexIndex", index(place)),
        ("Location", own.map_or(Value::Null, |own| Value::Point(own.point))),
        ("EdgeIndices", Value::list(edges)),
    ];
    Record { class: "BrepVertex", fields }
}

fn end(edge: &Part, side: usize) -> Outcome<Record> {
    let own = edge.brep.edges().get(edge.place).and_then(|own| own.vertices.get(side).copied().flatten());
    own.map(|place| vertex(&edge.brep, place)).ok_or_else(|| Fault::failed("the edge has no vertex there"))
}

fn kind(brep: &Brep, place: usize) -> Option<LoopKind> {
    brep.loops().get(place).map(|own| own.kind)
}

/// A `BrepLoop`, with its curve in space.
pub(super) fn loop_record(brep: &Arc<Brep>, place: usize) -> Outcome<Record> {
    let number = match kind(brep, place) {
        Some(LoopKind::Outer) => 1,
        Some(LoopKind::Inner) => 2,
        Some(LoopKind::Slit) => 3,
        _ => 0,
    };
    let curves = brep.loop_curves(place)?;
    let joined =
        katydid_geometry::join_curves(&curves, katydid_geometry::Tolerance::default().absolute, false);
    let curve = joined.into_iter().next().map(|curve| Value::from(Shape::Curve(Arc::new(curve))));
    let face = brep.loops().get(place).and_then(|own| own.face);
    let fields = vec![
        ("LoopIndex", index(place)),
        ("LoopType", Value::Enum("BrepLoopType".into(), number)),
        ("Face", face.map_or(Value::Null, |face| Shape::Face(brep.clone(), face).into())),
        ("To3dCurve", curve.unwrap_or(Value::Null)),
    ];
    Ok(Record { class: "BrepLoop", fields })
}

fn loops_of(brep: &Brep, face: usize) -> Vec<usize> {
    brep.faces().get(face).map(|face| face.loops.clone()).unwrap_or_default()
}

/// The edges around a face, each once, sorted.
fn edges_of(brep: &Brep, face: usize) -> Vec<usize> {
    let loops = loops_of(brep, face);
    let trims = loops.iter().filter_map(|place| brep.loops().get(*place)).flat_map(|own| own.trims.iter());
    let mut edges: Vec<usize> = trims.filter_map(|trim| brep.trims().get(*trim)?.edge).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// The faces at an edge, each once, sorted.
fn faces_at(brep: &Brep, edge: usize) -> Vec<usize> {
    let trims = brep.edges().get(edge).map(|edge| edge.trims.as_slice()).unwrap_or_default();
    let mut faces: Vec<usize> =
        trims.iter().filter_map(|trim| brep.loops().get(brep.trims().get(*trim)?.in_loop?)?.face).collect();
    faces.sort_unstable();
    faces.dedup();
    faces
}
