//! Vertices, edges and faces of SubDs.

use std::sync::Arc;

use katydid_geometry::subd::{SubD, SubDEdgeTag, SubDSide, SubDVertexTag};
use katydid_geometry::{Point3, Vector3};

use super::{Named, beyond, of_class};
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape, SubDPart};
use crate::wire::{Read, Subdivision};
use crate::{Fault, Value};

type Index = Count<0, 100_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    lists(table);
    vertices(table);
    edges(table);
    faces(table);
    table.member("SubD.get_IsSolid this", |s: Own| {
        let edges = s.0.net().edges();
        Ok(!edges.is_empty() && edges.iter().all(|edge| edge.faces.len() == 2))
    });
}

fn lists(table: &mut Endpoints) {
    table.member("SubD.get_Vertices this", |s: Own| {
        Ok(s.parts(SubDPart::Vertex).map(VertexShape).collect::<Vec<_>>())
    });
    table.member("SubD.get_Edges this", |s: Own| {
        Ok(s.parts(SubDPart::Edge).map(EdgeShape).collect::<Vec<_>>())
    });
    table.member("SubD.get_Faces this", |s: Own| {
        Ok(s.parts(SubDPart::Face).map(FaceShape).collect::<Vec<_>>())
    });
    table.member("SubDVertexList.Find this id", |s: Own, id: Index| {
        Ok(s.find(SubDPart::Vertex, id.0).map(VertexShape))
    });
    table.member("SubDEdgeList.Find this id", |s: Own, id: Index| {
        Ok(s.find(SubDPart::Edge, id.0).map(EdgeShape))
    });
    table.member("SubDFaceList.Find this id", |s: Own, id: Index| {
        Ok(s.find(SubDPart::Face, id.0).map(FaceShape))
    });
    table.member("SubDVertexList.get_First this", |s: Own| {
        Ok(s.parts(SubDPart::Vertex).next().map(VertexShape))
    });
    table.member(
        "SubDEdgeList.SetEdgeTags &this edgeIndices tag",
        |s: Own, edges: Vec<Index>, tag: EdgeTag| {
            let edges: Vec<usize> = edges.into_iter().map(|index| index.0).collect();
            let count = s.0.net().edges().len();
            if let Some(beyond_last) = edges.iter().find(|index| **index >= count) {
                return Err(beyond(*beyond_last, count));
            }
            let net = s.0.net().clone().with_edge_tag(&edges, tag.0)?;
            Ok(((), Subdivision(SubD::new(net))))
        },
    );
}

fn vertices(table: &mut Endpoints) {
    table.member("SubDVertex.get_Id this", |v: Vertex| Ok(v.0.id()));
    table.member("SubDVertex.get_ParentSubD this", |v: Vertex| Ok(v.0.parent()));
    table.member("SubDVertex.get_Tag this", |v: Vertex| {
        let tag = v.0.subd.net().vertices().get(v.0.place).map_or(SubDVertexTag::Unset, |own| own.tag);
        // As openNURBS numbers them.
        let number = match tag {
            SubDVertexTag::Unset => 0,
            SubDVertexTag::Smooth => 1,
            SubDVertexTag::Crease => 2,
            SubDVertexTag::Corner => 3,
            SubDVertexTag::Dart => 4,
        };
        Ok(Named("SubDVertexTag", number))
    });
    table.member("SubDVertex.get_ControlNetPoint this", |v: Vertex| Ok(v.0.control_point(v.0.place)));
    table.member("SubDVertex.SurfacePoint this", |v: Vertex| {
        v.0.subd
            .vertex_limits()
            .get(v.0.place)
            .copied()
            .ok_or_else(|| Fault::failed("the SubD has no surface"))
    });
    table.member("SubDVertex.get_EdgeCount this", |v: Vertex| Ok(v.edges().len()));
    table.member("SubDVertex.get_FaceCount this", |v: Vertex| Ok(v.faces().len()));
    table.member("SubDVertex.get_Edges this", |v: Vertex| {
        let sides = v.edges().iter().map(|side| v.0.edge(side.index));
        Ok(sides.collect::<Vec<EdgeShape>>())
    });
    table.member("SubDVertex.EdgeAt this index", |v: Vertex, i: Index| {
        let found = v.edges().get(i.0).map(|side| v.0.edge(side.index));
        found.ok_or_else(|| beyond(i.0, v.edges().len()))
    });
    table.member("SubDVertex.FaceAt this index", |v: Vertex, i: Index| {
        let found = v.faces().get(i.0).map(|face| v.0.face(*face));
        found.ok_or_else(|| beyond(i.0, v.faces().len()))
    });
    table.member("SubDVertex.get_Next this", |v: Vertex| {
        let next = v.0.place + 1;
        Ok((next < v.0.subd.net().vertices().len()).then(|| v.0.vertex(next)))
    });
    table.member("SubDVertex.get_Previous this", |v: Vertex| {
        Ok(v.0.place.checked_sub(1).map(|place| v.0.vertex(place)))
    });
}

fn edges(table: &mut Endpoints) {
    table.member("SubDEdge.get_Id this", |e: Edge| Ok(e.0.id()));
    table.member("SubDEdge.get_ParentSubD this", |e: Edge| Ok(e.0.parent()));
    table.member("SubDEdge.get_Tag this", |e: Edge| {
        let tag = e.0.subd.net().edges().get(e.0.place).map_or(SubDEdgeTag::Unset, |own| own.tag);
        // As openNURBS numbers them.
        let number = match tag {
            SubDEdgeTag::Unset => 0,
            SubDEdgeTag::Smooth => 1,
            SubDEdgeTag::Crease => 2,
            SubDEdgeTag::SmoothX => 4,
        };
        Ok(Named("SubDEdgeTag", number))
    });
    table.member("SubDEdge.get_VertexFrom this", |e: Edge| Ok(e.end(0)));
    table.member("SubDEdge.get_VertexTo this", |e: Edge| Ok(e.end(1)));
    table.member("SubDEdge.get_ControlNetLine this", |e: Edge| {
        e.0.subd.net().edge_line(e.0.place).ok_or_else(|| Fault::failed("the edge has no ends"))
    });
    table.member("SubDEdge.get_FaceCount this", |e: Edge| Ok(e.faces().len()));
    table.member("SubDEdge.FaceAt this index", |e: Edge, i: Index| {
        let found = e.faces().get(i.0).map(|side| e.0.face(side.index));
        found.ok_or_else(|| beyond(i.0, e.faces().len()))
    });
}

fn faces(table: &mut Endpoints) {
    table.member("SubDFace.get_Id this", |f: Face| Ok(f.0.id()));
    table.member("SubDFace.get_ParentSubD this", |f: Face| Ok(f.0.parent()));
    for signature in ["SubDFace.get_EdgeCount this", "SubDFace.get_VertexCount this"] {
        table.member(signature, |f: Face| Ok(f.edges().len()));
    }
    table.member("SubDFace.VertexAt this index", |f: Face, i: Index| {
        let found = f.corners().get(i.0).map(|place| f.0.vertex(*place));
        found.ok_or_else(|| beyond(i.0, f.edges().len()))
    });
    table.member("SubDFace.EdgeAt this index", |f: Face, i: Index| {
        let found = f.edges().get(i.0).map(|side| f.0.edge(side.index));
        found.ok_or_else(|| beyond(i.0, f.edges().len()))
    });
    table.member("SubDFace.EdgeDirectionMatchesFaceOrientation this index", |f: Face, i: Index| {
        f.edges().get(i.0).map(|side| !side.reversed).ok_or_else(|| beyond(i.0, f.edges().len()))
    });
    table.member("SubDFace.get_ControlNetCenterPoint this", |f: Face| {
        Ok(f.0.subd.net().face_middle(f.0.place))
    });
    table.member("SubDFace.get_ControlNetCenterNormal this", |f: Face| {
        // The sum over the edges of the cross products of their ends: twice the area vector of the polygon.
        let middle = f.0.subd.net().face_middle(f.0.place);
        let corners: Vec<Point3> = f.corners().iter().map(|place| f.0.control_point(*place)).collect();
        let next = corners.iter().cycle().skip(1);
        let area: Vector3 = corners.iter().zip(next).map(|(a, b)| (*a - middle).cross(*b - middle)).sum();
        Ok(area.unitized().unwrap_or(Vector3::ZERO))
    });
}

of_class! {
    /// A vertex that is handed back.
    VertexShape, "SubDVertex";
    /// An edge that is handed back.
    EdgeShape, "SubDEdge";
    /// A face that is handed back.
    FaceShape, "SubDFace";
    /// A SubD that is handed back.
    Whole, "SubD";
}

/// A SubD that is shared.
struct Own(Arc<SubD>);

impl Own {
    /// All parts of a kind.
    fn parts(&self, part: SubDPart) -> impl Iterator<Item = Shape> {
        (0..part.count(&self.0)).map(move |place| Shape::SubDPart(self.0.clone(), part, place))
    }

    /// The part with a number; none where no part has it.
    fn find(&self, part: SubDPart, id: usize) -> Option<Shape> {
        let place = (0..part.count(&self.0)).find(|place| part.id(&self.0, *place) == id)?;
        Some(Shape::SubDPart(self.0.clone(), part, place))
    }
}

impl Read for Own {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Subdivision::read(json).map(|subd| Self(Arc::new(subd.0)))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Geometry { shape: Shape::SubD(subd), .. }) => Ok(Self(subd.clone())),
            other => Subdivision::of_value(other).map(|subd| Self(Arc::new(subd.0))),
        }
    }

    fn type_name() -> String {
        "SubD".into()
    }
}

/// A part of a SubD by its place.
struct Part {
    subd: Arc<SubD>,
    kind: SubDPart,
    place: usize,
}

impl Part {
    fn id(&self) -> usize {
        self.kind.id(&self.subd, self.place)
    }

    fn parent(&self) -> Whole {
        Whole(Shape::SubD(self.subd.clone()))
    }

    fn vertex(&self, place: usize) -> VertexShape {
        VertexShape(Shape::SubDPart(self.subd.clone(), SubDPart::Vertex, place))
    }

    fn edge(&self, place: usize) -> EdgeShape {
        EdgeShape(Shape::SubDPart(self.subd.clone(), SubDPart::Edge, place))
    }

    fn face(&self, place: usize) -> FaceShape {
        FaceShape(Shape::SubDPart(self.subd.clone(), SubDPart::Face, place))
    }

    fn control_point(&self, vertex: usize) -> Point3 {
        self.subd.net().vertices().get(vertex).map_or(Point3::ORIGIN, |own| own.point)
    }

    fn of(value: &Value, wanted: SubDPart) -> Outcome<Self> {
        match value {
            Value::Geometry(Geometry { shape: Shape::SubDPart(subd, kind, place), .. })
                if *kind == wanted =>
            {
                Ok(Self { subd: subd.clone(), kind: *kind, place: *place })
            }
            other => Err(Fault::bad_request(format!("is {}, no {}", other.noun(), wanted.class()))),
        }
    }
}

/// A vertex.
struct Vertex(Part);
/// An edge.
struct Edge(Part);
/// A face.
struct Face(Part);

macro_rules! read_part {
    ($($kind:ident, $name:literal;)*) => {
        $(impl Read for $kind {
            fn read(_: &serde_json::Value) -> Result<Self, Fault> {
                Err(Fault::bad_request(concat!("is no ", $name)))
            }

            fn of_value(value: &Value) -> Result<Self, Fault> {
                Part::of(value, SubDPart::$kind).map(Self)
            }

            fn type_name() -> String {
                $name.into()
            }
        })*
    };
}

read_part! {
    Vertex, "SubDVertex";
    Edge, "SubDEdge";
    Face, "SubDFace";
}

impl Vertex {
    fn edges(&self) -> &[SubDSide] {
        self.0.subd.net().vertices().get(self.0.place).map_or(&[], |own| own.edges.as_slice())
    }

    fn faces(&self) -> &[usize] {
        self.0.subd.net().vertices().get(self.0.place).map_or(&[], |own| own.faces.as_slice())
    }
}

impl Edge {
    fn faces(&self) -> &[SubDSide] {
        self.0.subd.net().edges().get(self.0.place).map_or(&[], |own| own.faces.as_slice())
    }

    fn end(&self, side: usize) -> Option<VertexShape> {
        let edge = self.0.subd.net().edges().get(self.0.place)?;
        Some(self.0.vertex(*edge.vertices.get(side)?))
    }
}

impl Face {
    fn edges(&self) -> &[SubDSide] {
        self.0.subd.net().faces().get(self.0.place).map_or(&[], |own| own.edges.as_slice())
    }

    fn corners(&self) -> Vec<usize> {
        self.0.subd.net().corners(self.0.place).collect()
    }
}

/// `SubDEdgeTag`, as openNURBS numbers its members.
struct EdgeTag(SubDEdgeTag);

impl Read for EdgeTag {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        match json.as_i64() {
            Some(1) => Ok(Self(SubDEdgeTag::Smooth)),
            Some(2) => Ok(Self(SubDEdgeTag::Crease)),
            _ => Err(Fault::bad_request("is no tag that can be set: 1 for Smooth, 2 for Crease")),
        }
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        Self::read(&value.to_json(0)?)
    }

    fn type_name() -> String {
        "SubDEdgeTag".into()
    }
}
