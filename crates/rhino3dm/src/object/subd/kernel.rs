//! Between what archives hold and the kernel's subdivision surfaces.

use katydid_geometry::subd::{SubD, SubDEdge, SubDEdgeTag, SubDFace, SubDNet, SubDSide, SubDVertex};
use katydid_geometry::{Error, Point3, Result};

use super::{
    EDGE_TAGS, Reference, StoredEdge, StoredFace, StoredPart, StoredVertex, SubDLevel, SubDObject,
    VERTEX_TAGS,
};

/// The flag that an edge is seen against its direction.
const REVERSED: u8 = 1;

impl SubDObject {
    /// The kernel's subdivision surface: nets, tags, sharpness and sector coefficients.
    ///
    /// # Errors
    /// There is no net, or one is inconsistent; the error says where.
    pub fn to_subd(&self) -> Result<SubD> {
        SubD::from_levels(self.levels.iter().map(SubDLevel::to_net).collect::<Result<_>>()?)
    }
}

/// Finds parts by their numbers.
struct Numbers {
    vertices: usize,
    edges: usize,
    faces: usize,
}

impl Numbers {
    /// The index of a part in its list, whose first number is one more than `before`.
    fn index(number: u32, before: usize, count: usize) -> Result<usize> {
        let index = (number as usize).checked_sub(before + 1).filter(|index| *index < count);
        index.ok_or_else(|| invalid(format!("a part names number {number}, which is of another kind")))
    }

    fn vertex(&self, reference: Reference) -> Result<usize> {
        Self::index(reference.number, 0, self.vertices)
    }

    fn edge(&self, reference: Reference) -> Result<SubDSide> {
        let index = Self::index(reference.number, self.vertices, self.edges)?;
        Ok(SubDSide { index, reversed: reference.flags & REVERSED != 0 })
    }

    fn face(&self, reference: Reference) -> Result<SubDSide> {
        let index = Self::index(reference.number, self.vertices + self.edges, self.faces)?;
        Ok(SubDSide { index, reversed: reference.flags & REVERSED != 0 })
    }
}

fn invalid(why: String) -> Error {
    Error::Invalid { what: "SubD", why }
}

impl SubDLevel {
    fn to_net(&self) -> Result<SubDNet> {
        let numbers =
            Numbers { vertices: self.vertices.len(), edges: self.edges.len(), faces: self.faces.len() };
        let vertices = self.vertices.iter().map(|v| v.to_kernel(&numbers)).collect::<Result<_>>()?;
        let edges = self.edges.iter().map(|e| e.to_kernel(&numbers)).collect::<Result<_>>()?;
        let face = |f: &StoredFace| {
            let edges = f.edges.iter().map(|e| numbers.edge(*e)).collect::<Result<_>>()?;
            Ok(SubDFace { id: f.part.id, edges })
        };
        SubDNet::from_parts(vertices, edges, self.faces.iter().map(face).collect::<Result<_>>()?)
    }

    fn from_net(net: &SubDNet, level: u16) -> Self {
        let [edges_from, faces_from] = [net.vertices().len(), net.vertices().len() + net.edges().len()];
        let named = |side: &SubDSide, before: usize| Reference {
            // Nets of more parts than numbers are refused when they are written.
            number: u32::try_from(side.index + before + 1).unwrap_or(0),
            flags: if side.reversed { REVERSED } else { 0 },
        };
        let part = |id: u32| StoredPart { id, level, ..StoredPart::default() };
        let all = |sides: &[SubDSide], before: usize| sides.iter().map(|s| named(s, before)).collect();
        let vertex = |v: &SubDVertex| StoredVertex {
            part: part(v.id),
            tag: VERTEX_TAGS
                .iter()
                .position(|tag| *tag == v.tag)
                .and_then(|n| u8::try_from(n).ok())
                .unwrap_or(0),
            point: [v.point.x, v.point.y, v.point.z],
            edges: all(&v.edges, edges_from),
            faces: v.faces.iter().map(|f| named(&SubDSide::forward(*f), faces_from)).collect(),
        };
        let edge = |e: &SubDEdge| StoredEdge {
            part: part(e.id),
            tag: EDGE_TAGS.iter().find(|(tag, _)| *tag == e.tag).map_or(0, |(_, number)| *number),
            sector_coefficients: e.sector_coefficients,
            sharpness: e.sharpness,
            vertices: e.vertices.map(|v| named(&SubDSide::forward(v), 0)),
            faces: all(&e.faces, faces_from),
        };
        let face = |f: &SubDFace| StoredFace {
            part: part(f.id),
            level_zero_face: f.id,
            edges: all(&f.edges, edges_from),
            ..StoredFace::default()
        };
        Self {
            index: level,
            vertices: net.vertices().iter().map(vertex).collect(),
            edges: net.edges().iter().map(edge).collect(),
            faces: net.faces().iter().map(face).collect(),
        }
    }
}

impl StoredVertex {
    fn to_kernel(&self, numbers: &Numbers) -> Result<SubDVertex> {
        Ok(SubDVertex {
            id: self.part.id,
            tag: VERTEX_TAGS.get(usize::from(self.tag)).copied().unwrap_or(VERTEX_TAGS[0]),
            point: Point3::from(self.point),
            edges: self.edges.iter().map(|e| numbers.edge(*e)).collect::<Result<_>>()?,
            faces: self.faces.iter().map(|f| Ok(numbers.face(*f)?.index)).collect::<Result<_>>()?,
        })
    }
}

impl StoredEdge {
    fn to_kernel(&self, numbers: &Numbers) -> Result<SubDEdge> {
        let [a, b] = self.vertices;
        let tag = EDGE_TAGS.iter().find(|(_, number)| *number == self.tag);
        Ok(SubDEdge {
            id: self.part.id,
            tag: tag.map_or(SubDEdgeTag::Unset, |(tag, _)| *tag),
            sharpness: self.sharpness,
            sector_coefficients: self.sector_coefficients,
            vertices: [numbers.vertex(a)?, numbers.vertex(b)?],
            faces: self.faces.iter().map(|f| numbers.face(*f)).collect::<Result<_>>()?,
        })
    }
}

impl From<&SubD> for SubDObject {
    fn from(subd: &SubD) -> Self {
        // Without them other readers call the SubD not valid.
        let nets = subd.levels().iter().map(|net| net.clone().with_sector_coefficients());
        let levels = nets.zip(0_u16..).map(|(net, level)| SubDLevel::from_net(&net, level));
        Self { levels: levels.collect(), ..Self::default() }
    }
}
