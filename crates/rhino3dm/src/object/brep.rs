//! Class Brep (section 8), read as far as its edges: curves, vertices, edges, and how many faces there are.

use katydid_geometry::{Curve, Interval, Point3};

use super::{RawObject, curve};
use crate::chunk::{Context, Reader};
use crate::{Error, Limits, Result, class_ids, typecode};

/// What a brep says about its inside.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Solidity {
    /// It does not say.
    #[default]
    Unknown,
    /// Closed, with normals outward.
    Outward,
    /// Closed, with normals inward.
    Inward,
}

/// An edge: a part of one of the brep's curves between two vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepEdge {
    /// Index into [`BrepSummary::curves`]; nothing for an edge without a curve.
    pub curve: Option<usize>,
    /// Whether the edge runs against its curve.
    pub reversed: bool,
    /// The part of the curve's domain that the edge covers.
    pub part: Interval,
    /// The edge's own domain, which `part` maps to (backwards when reversed).
    pub domain: Interval,
    /// Indices of its end vertices, start first.
    pub vertices: [Option<usize>; 2],
    /// How many faces meet at the edge, each trim counted: 1 is naked, 2 an inner edge or a seam.
    pub trims: usize,
    /// Its tolerance in model units.
    pub tolerance: f64,
}

/// The skeleton of a brep.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepSummary {
    /// What the flag in its bytes says. Breps that were never asked have [`Solidity::Unknown`]; see
    /// [`BrepSummary::is_closed`].
    pub solidity: Solidity,
    /// The number of faces.
    pub faces: usize,
    /// The vertices.
    pub vertices: Vec<Point3>,
    /// The curves in space that edges refer to.
    pub curves: Vec<Curve>,
    /// The edges.
    pub edges: Vec<BrepEdge>,
}

const WHAT: &str = "brep";
/// Files written by an older openNURBS store no edge domain.
const EDGE_DOMAIN_FROM: u32 = 200_206_180;

impl BrepSummary {
    /// Reads the skeleton out of a kept brep. The `index` of items, curves in parameter space and surfaces are
    /// passed over.
    ///
    /// # Errors
    /// The object is no brep, is of the layout that version 2 files have, or its bytes are broken.
    pub fn read(raw: &RawObject) -> Result<Self> {
        let context = Context::new(&Limits::default());
        raw.with_class(&context, |object| {
            if class_ids::canonical(object.class) != class_ids::BREP {
                return Err(Error::malformed(0, WHAT, format!("a {} is no brep", raw.class_name())));
            }
            let mut body =
                object.data.ok_or_else(|| Error::malformed(object.offset, WHAT, "it has no body"))?;
            Self::read_body(&mut body)
        })
    }

    /// Whether no edge is naked: by the flag if it says so, else by counting the trims at each edge.
    pub fn is_closed(&self) -> bool {
        match self.solidity {
            Solidity::Outward | Solidity::Inward => true,
            Solidity::Unknown => self.faces > 0 && self.edges.iter().all(|edge| edge.trims >= 2),
        }
    }

    /// The point of edge `edge` at parameter `t` of the edge's own domain; nothing when there is no such edge or
    /// it has no curve.
    ///
    /// The edge's domain maps linearly onto its part of the curve's, backwards when the edge runs against it.
    pub fn edge_point(&self, edge: usize, t: f64) -> Option<Point3> {
        let edge = self.edges.get(edge)?;
        let x = edge.domain.normalized(t);
        let x = if edge.reversed { 1.0 - x } else { x };
        Some(self.curves.get(edge.curve?)?.point_at(edge.part.at(x)))
    }

    fn read_body(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 3 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not read yet")));
        }
        body.expect(typecode::ANONYMOUS, "brep parameter curves")?;
        let (curves, places) = read_curves(body)?;
        body.expect(typecode::ANONYMOUS, "brep surfaces")?;
        let vertices = read_vertices(body)?;
        let edges = read_edges(body, &places)?;
        body.expect(typecode::ANONYMOUS, "brep trims")?;
        body.expect(typecode::ANONYMOUS, "brep loops")?;
        let (faces, count) = read_list(body, "brep faces")?;
        faces.check_count(count, 20, "brep faces")?;
        body.take(48, "brep box")?;
        if minor >= 1 {
            body.expect(typecode::ANONYMOUS, "brep render meshes")?;
            body.expect(typecode::ANONYMOUS, "brep analysis meshes")?;
        }
        let flag = if minor >= 2 { body.i32("brep solid flag")? } else { 0 };
        // 3 means not solid, but openNURBS itself takes 3 and beyond for "not set": the edges decide then.
        let solidity = match flag {
            1 => Solidity::Outward,
            2 => Solidity::Inward,
            _ => Solidity::Unknown,
        };
        Ok(Self { solidity, faces: count, vertices, curves, edges })
    }
}

/// The body and count of one of the brep's lists.
pub(super) fn read_list<'a>(body: &mut Reader<'a>, what: &'static str) -> Result<(Reader<'a>, usize)> {
    let mut list = body.expect(typecode::ANONYMOUS, what)?;
    list.packed_version(what)?;
    let count = list.count(4, what)?;
    Ok((list, count))
}

/// The curves, and for each place of the stored list the index of its curve, for places may be empty.
fn read_curves(body: &mut Reader<'_>) -> Result<(Vec<Curve>, Vec<Option<usize>>)> {
    let (mut list, count) = read_list(body, "brep curves")?;
    let mut curves = Vec::new();
    let mut places = Vec::with_capacity(count);
    for _ in 0..count {
        if list.i32("brep curves")? == 0 {
            places.push(None);
            continue;
        }
        places.push(Some(curves.len()));
        curves.push(curve::read_object(&mut list)?);
    }
    list.finish();
    Ok((curves, places))
}

fn read_vertices(body: &mut Reader<'_>) -> Result<Vec<Point3>> {
    const WHAT: &str = "brep vertices";
    let (mut list, count) = read_list(body, WHAT)?;
    list.check_count(count, 40, WHAT)?;
    let mut vertices = Vec::with_capacity(count);
    for _ in 0..count {
        list.i32(WHAT)?;
        vertices.push(list.point(WHAT)?);
        list.ints(WHAT)?;
        list.f64(WHAT)?;
    }
    list.finish();
    Ok(vertices)
}

fn read_edges(body: &mut Reader<'_>, places: &[Option<usize>]) -> Result<Vec<BrepEdge>> {
    const WHAT: &str = "brep edges";
    let (mut list, count) = read_list(body, WHAT)?;
    list.check_count(count, 48, WHAT)?;
    let version = list.version();
    let has_domain = version.archive >= 3 && version.opennurbs >= EDGE_DOMAIN_FROM;
    let mut edges = Vec::with_capacity(count);
    for _ in 0..count {
        list.i32(WHAT)?;
        let place = list.i32(WHAT)?;
        let reversed = list.i32(WHAT)? == 1;
        let part = list.interval(WHAT)?;
        let vertices = [list.i32(WHAT)?, list.i32(WHAT)?].map(|v| usize::try_from(v).ok());
        let trims = list.ints(WHAT)?.len();
        let tolerance = list.f64(WHAT)?;
        let domain = if has_domain { list.interval(WHAT)? } else { part };
        let curve = usize::try_from(place).ok().and_then(|place| places.get(place).copied().flatten());
        edges.push(BrepEdge { curve, reversed, part, domain, vertices, trims, tolerance });
    }
    list.finish();
    Ok(edges)
}
