//! Trims of Breps: what bounds a face in the parameters of its surface.

use std::sync::Arc;

use katydid_geometry::Brep;
use katydid_geometry::brep::TrimKind;

use super::brep_parts::{Whole, index, loop_record, vertex};
use crate::geometry::answer::Outcome;
use crate::geometry::table::Endpoints;
use crate::shape::{Record, Shape};
use crate::{Fault, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Brep.get_Trims this", |b: Whole| {
        (0..b.0.trims().len()).map(|place| trim(&b.0, place)).collect::<Outcome<Vec<Record>>>()
    });
}

/// A `BrepTrim`. Its ends lie in the parameters of the surface, with 0 for z.
fn trim(brep: &Arc<Brep>, place: usize) -> Outcome<Record> {
    let own = brep.trims().get(place).ok_or_else(|| super::beyond(place, brep.trims().len()))?;
    let domain = own.part.domain;
    let at = |t| {
        let point = brep.trim_point(place, t).map(Value::Point);
        point.ok_or_else(|| Fault::failed("the trim has no curve"))
    };
    let in_loop = own.in_loop.and_then(|of| Some((of, brep.loops().get(of)?)));
    let face = in_loop.and_then(|(_, own)| own.face);
    let end = |side: usize| {
        let found = own.vertices.get(side).copied().flatten();
        found.map_or(Value::Null, |place| Shape::Record(vertex(brep, place).into()).into())
    };
    let fields = vec![
        ("TrimIndex", index(place)),
        ("TrimType", Value::Enum("BrepTrimType".into(), kind(own.kind))),
        ("Brep", Shape::Brep(brep.clone()).into()),
        ("Edge", own.edge.map_or(Value::Null, |edge| Shape::Edge(brep.clone(), edge).into())),
        ("Face", face.map_or(Value::Null, |face| Shape::Face(brep.clone(), face).into())),
        (
            "Loop",
            match in_loop {
                Some((of, _)) => Shape::Record(loop_record(brep, of)?.into()).into(),
                None => Value::Null,
            },
        ),
        ("Domain", Value::Interval(domain)),
        ("PointAtStart", at(domain.start)?),
        ("PointAtEnd", at(domain.end)?),
        ("StartVertex", end(0)),
        ("EndVertex", end(1)),
    ];
    Ok(Record { class: "BrepTrim", fields })
}

/// The number of `BrepTrimType`.
fn kind(kind: TrimKind) -> i64 {
    match kind {
        TrimKind::Unknown => 0,
        TrimKind::Boundary => 1,
        TrimKind::Mated => 2,
        TrimKind::Seam => 3,
        TrimKind::Singular => 4,
    }
}
