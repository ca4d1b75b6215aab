use crate::mesh::polygon::polygon_faces;
use crate::{BoundingBox, Mesh, Point3, Result, Vector3};

/// A convex body with flat faces.
///
/// Faces are rings of corners, counter-clockwise seen from outside, and each carries a tag that says where it comes
/// from: for a cell of a Voronoi diagram the index of the site beyond, or `None` at the border.
#[derive(Debug, Clone, PartialEq)]
pub struct ConvexPolyhedron {
    vertices: Vec<Point3>,
    corners: Vec<u32>,
    faces: Vec<Face>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Face {
    /// Where its corners end; they begin where those of the face before end.
    end: u32,
    tag: u32,
}

/// The tag of a face that nothing lies beyond.
const BORDER: u32 = u32::MAX;

/// Room to work in, kept between cuts.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    sides: Vec<f64>,
    /// The new number of each vertex that stays.
    numbers: Vec<u32>,
    vertices: Vec<Point3>,
    corners: Vec<u32>,
    faces: Vec<Face>,
    /// New vertices by the edge they lie on.
    made: Vec<([u32; 2], u32)>,
    /// Sides of the new face.
    rim: Vec<[u32; 2]>,
}

/// What a cut did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    /// Nothing lay beyond the plane.
    Nothing,
    /// Something was cut off.
    Part,
    /// All of it lay beyond.
    All,
}

impl ConvexPolyhedron {
    /// A box along the world axes.
    pub fn from_box(b: &BoundingBox) -> Self {
        /// The faces of a box by its corners: the bottom counter-clockwise from the smallest, then the top likewise.
        const FACES: [[u32; 4]; 6] =
            [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
        Self {
            vertices: b.corners().to_vec(),
            corners: FACES.concat(),
            faces: (1..=6).map(|k| Face { end: 4 * k, tag: BORDER }).collect(),
        }
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The corners of face `i` as indices of vertices, counter-clockwise seen from outside; none beyond the last face.
    pub fn face(&self, i: usize) -> &[u32] {
        let start = i.checked_sub(1).and_then(|b| self.faces.get(b)).map_or(0, |f| f.end);
        self.faces.get(i).and_then(|f| self.corners.get(start as usize..f.end as usize)).unwrap_or(&[])
    }

    /// The faces in order.
    pub fn faces(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.faces.len()).map(|i| self.face(i))
    }

    /// What lies beyond face `i`; `None` at the border.
    pub fn beyond(&self, i: usize) -> Option<usize> {
        self.faces.get(i).filter(|f| f.tag != BORDER).map(|f| f.tag as usize)
    }

    /// Whether some face lies on the border.
    pub fn touches_border(&self) -> bool {
        self.faces.iter().any(|f| f.tag == BORDER)
    }

    /// The volume.
    pub fn volume(&self) -> f64 {
        let Some(&o) = self.vertices.first() else { return 0.0 };
        let at = |i: u32| self.vertices.get(i as usize).map_or(Vector3::ZERO, |&p| p - o);
        let fan = |ring: &[u32]| -> f64 {
            let Some(&first) = ring.first() else { return 0.0 };
            ring.windows(2).map(|w| at(first).dot(at(w[0]).cross(at(w[1])))).sum()
        };
        self.faces().map(fan).sum::<f64>() / 6.0
    }

    /// The body with every vertex moved by a map that keeps flat what is flat.
    #[must_use]
    pub fn mapped(mut self, map: impl Fn(Point3) -> Point3) -> Self {
        for p in &mut self.vertices {
            *p = map(*p);
        }
        self
    }

    /// The body's skin as a closed mesh: every face with vertices of its own, as triangles and quads.
    ///
    /// # Errors
    /// A vertex is not finite.
    pub fn to_mesh(&self) -> Result<Mesh> {
        let mut vertices = Vec::with_capacity(self.corners.len());
        let mut faces = Vec::with_capacity(self.corners.len() / 2);
        for ring in self.faces() {
            let start = vertices.len() as u32;
            vertices.extend(ring.iter().filter_map(|&i| self.vertices.get(i as usize)));
            let end = vertices.len() as u32;
            polygon_faces(&(start..end).collect::<Vec<_>>(), &mut faces);
        }
        Ok(Mesh::new(vertices, faces)?.with_normals())
    }

    /// Cuts off what lies beyond the plane n·p = d, n of length 1, by more than `tolerance`, and gives the new face a
    /// tag. A cut that rounding makes meaningless does nothing.
    pub(super) fn cut(&mut self, n: Vector3, d: f64, tolerance: f64, tag: u32, s: &mut Scratch) -> Cut {
        s.sides.clear();
        s.sides.extend(self.vertices.iter().map(|p| n.dot(p.to_vector()) - d));
        if !s.sides.iter().any(|&x| x > tolerance) {
            return Cut::Nothing;
        }
        if !s.sides.iter().any(|&x| x < -tolerance) {
            return Cut::All;
        }
        s.vertices.clear();
        s.numbers.clear();
        for (&p, &side) in self.vertices.iter().zip(&s.sides) {
            s.numbers.push(s.vertices.len() as u32);
            if side <= tolerance {
                s.vertices.push(p);
            }
        }
        s.corners.clear();
        s.faces.clear();
        s.made.clear();
        s.rim.clear();
        let mut start = 0;
        for face in &self.faces {
            let ring = self.corners.get(start as usize..face.end as usize).unwrap_or(&[]);
            start = face.end;
            let first = s.corners.len();
            s.clip_ring(ring, &self.vertices, tolerance);
            if s.corners.len() < first + 3 {
                s.corners.truncate(first);
            } else {
                s.faces.push(Face { end: s.corners.len() as u32, tag: face.tag });
            }
        }
        if !s.close(tag) {
            return Cut::Nothing;
        }
        std::mem::swap(&mut self.vertices, &mut s.vertices);
        std::mem::swap(&mut self.corners, &mut s.corners);
        std::mem::swap(&mut self.faces, &mut s.faces);
        Cut::Part
    }
}

impl Scratch {
    /// Adds what is left of a face to the corners, and the side along the cut to the rim.
    fn clip_ring(&mut self, ring: &[u32], vertices: &[Point3], tolerance: f64) {
        let side = |s: &Self, i: u32| s.sides.get(i as usize).copied().unwrap_or(0.0);
        let (mut leaves, mut enters) = (None, None);
        let first = self.corners.len();
        for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let (from, to) = (side(self, a), side(self, b));
            let (a_stays, b_stays) = (from <= tolerance, to <= tolerance);
            if a_stays {
                let a = self.number(a);
                self.add(first, a);
            }
            if a_stays != b_stays {
                let crossing = self.crossing([a, b], [from, to], vertices, tolerance);
                self.add(first, crossing);
                *(if a_stays { &mut leaves } else { &mut enters }) = Some(crossing);
            }
        }
        if self.corners.len() > first + 1 && self.corners.last() == self.corners.get(first) {
            self.corners.pop();
        }
        if let (Some(x), Some(y)) = (leaves, enters)
            && x != y
        {
            self.rim.push([y, x]);
        }
    }

    fn number(&self, i: u32) -> u32 {
        self.numbers.get(i as usize).copied().unwrap_or(0)
    }

    fn add(&mut self, first: usize, corner: u32) {
        if self.corners.len() == first || self.corners.last() != Some(&corner) {
            self.corners.push(corner);
        }
    }

    /// Where an edge crosses the plane: an end of it that lies in the plane, or a new vertex, the same for both faces.
    fn crossing(
        &mut self,
        [a, b]: [u32; 2],
        [from, to]: [f64; 2],
        vertices: &[Point3],
        tolerance: f64,
    ) -> u32 {
        let (stays, at) = if from <= tolerance { (a, from) } else { (b, to) };
        if at >= -tolerance {
            return self.number(stays);
        }
        let edge = [a.min(b), a.max(b)];
        if let Some((_, number)) = self.made.iter().find(|(e, _)| *e == edge) {
            return *number;
        }
        let place = |i: u32| vertices.get(i as usize).copied().unwrap_or(Point3::ORIGIN);
        let number = self.vertices.len() as u32;
        self.vertices.push(place(a).lerp(place(b), from / (from - to)));
        self.made.push((edge, number));
        number
    }

    /// Makes the new face of the rim; `false` when it is not one ring of three corners or more.
    fn close(&mut self, tag: u32) -> bool {
        let Some([start, mut at]) = self.rim.first().copied() else { return false };
        self.corners.push(start);
        let mut used = 1;
        while at != start && used < self.rim.len() {
            self.corners.push(at);
            let Some(next) = self.rim.iter().find(|side| side[0] == at) else { return false };
            at = next[1];
            used += 1;
        }
        if at != start || used != self.rim.len() || used < 3 {
            return false;
        }
        self.faces.push(Face { end: self.corners.len() as u32, tag });
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> ConvexPolyhedron {
        ConvexPolyhedron::from_box(&BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 1.0, 1.0) })
    }

    fn cut(body: &mut ConvexPolyhedron, n: [f64; 3], d: f64) -> Cut {
        let n = Vector3::from(n);
        let length = n.length();
        body.cut(n / length, d / length, 1e-12, 7, &mut Scratch::default())
    }

    #[test]
    fn cuts_through_corners_edges_and_faces() {
        assert_eq!(cube().volume(), 1.0);
        assert!(cube().to_mesh().unwrap().is_closed());
        for (n, d, volume, faces) in [
            ([1.0, 0.0, 0.0], 0.25, 0.25, 6),
            ([1.0, 1.0, 1.0], 2.5, 1.0 - 1.0 / 48.0, 7),
            ([1.0, 1.0, 1.0], 1.5, 0.5, 7),
            ([1.0, 1.0, 1.0], 1.0, 1.0 / 6.0, 4),
            ([1.0, 1.0, 0.0], 1.0, 0.5, 5),
            ([1.0, 1.0, 1.0], 2.0, 5.0 / 6.0, 7),
        ] {
            let mut body = cube();
            assert_eq!(cut(&mut body, n, d), Cut::Part);
            assert!((body.volume() - volume).abs() < 1e-12, "{n:?} {d}: {}", body.volume());
            assert_eq!(body.face_count(), faces, "{n:?} {d}");
            let mesh = body.to_mesh().unwrap();
            assert!(mesh.is_closed() && mesh.is_oriented());
            assert!((mesh.volume() - volume).abs() < 1e-12);
            assert_eq!(body.beyond(faces - 1), Some(7));
        }
        for (n, d, what) in [
            ([1.0, 0.0, 0.0], 1.0, Cut::Nothing),
            ([1.0, 0.0, 0.0], 0.0, Cut::All),
            ([1.0, 0.0, 0.0], -1.0, Cut::All),
            ([1.0, 1.0, 0.0], 2.0, Cut::Nothing),
        ] {
            assert_eq!(cut(&mut cube(), n, d), what);
        }
    }
}
