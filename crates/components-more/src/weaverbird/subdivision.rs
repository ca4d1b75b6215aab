//! The rules of subdivision, one level at a time.

use katydid_component::Message;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Point3, Vector3};

use crate::polygons::{Edges, Polygons, sides};

/// What becomes of naked edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Naked {
    /// They stay where they are.
    Fixed,
    /// They tend to a cubic spline.
    Smooth,
    /// They tend to a cubic spline between corners, which stay: vertices of one face.
    CornerFixed,
}

impl Naked {
    pub(super) fn of(number: i32) -> Result<Self, Message> {
        match number {
            0 => Ok(Self::Fixed),
            1 => Ok(Self::Smooth),
            2 => Ok(Self::CornerFixed),
            _ => Err(Message::error(format!(
                "There is no treatment {number} of naked edges: 0 is fixed, 1 smooth, 2 smooth with fixed corners"
            ))),
        }
    }
}

/// What a rule looks up: the edges at each point and the faces at each point.
struct Around {
    edges: Edges,
    at_point: Vec<Vec<usize>>,
    faces: Vec<usize>,
}

impl Around {
    fn new(polygons: &Polygons) -> Self {
        let edges = polygons.edges();
        let mut at_point = vec![Vec::new(); polygons.points.len()];
        for (e, &(a, b)) in edges.list.iter().enumerate() {
            for i in [a, b] {
                if let Some(own) = at_point.get_mut(i) {
                    own.push(e);
                }
            }
        }
        let mut faces = vec![0; polygons.points.len()];
        for &i in polygons.faces.iter().flatten() {
            if let Some(count) = faces.get_mut(i) {
                *count += 1;
            }
        }
        Self { edges, at_point, faces }
    }

    fn other_end(&self, e: usize, i: usize) -> usize {
        self.edges.list.get(e).map_or(i, |&(a, b)| if a == i { b } else { a })
    }

    /// Where a point on naked edges goes; `None` for one inside. Points where naked edges branch stay.
    fn naked(&self, polygons: &Polygons, i: usize, naked: Naked) -> Option<Point3> {
        let own = self.at_point.get(i)?;
        let ends: Vec<Point3> = own
            .iter()
            .filter(|&&e| self.edges.is_naked(e))
            .map(|&e| polygons.at(self.other_end(e, i)))
            .collect();
        let here = polygons.at(i);
        match ends.as_slice() {
            [] => None,
            [a, b] => {
                let corner = self.faces.get(i).is_some_and(|count| *count == 1);
                let stays = naked == Naked::Fixed || naked == Naked::CornerFixed && corner;
                Some(if stays { here } else { mix(&[(here, 0.75), (*a, 0.125), (*b, 0.125)]) })
            }
            _ => Some(here),
        }
    }
}

/// A weighted sum of points whose weights add up to 1.
fn mix(points: &[(Point3, f64)]) -> Point3 {
    let sum = points.iter().fold(Vector3::ZERO, |sum, (p, w)| sum + p.to_vector() * *w);
    Point3::ORIGIN + sum
}

/// One level of Catmull-Clark subdivision (E. Catmull and J. Clark, *Recursively generated B-spline surfaces on arbitrary
/// topological meshes*, 1978): every face becomes as many quads as it has corners.
pub(super) fn catmull_clark(polygons: &Polygons, naked: Naked) -> Polygons {
    let around = Around::new(polygons);
    let middles: Vec<Point3> = polygons.faces.iter().map(|face| polygons.middle(face)).collect();
    let middle = |f: usize| middles.get(f).copied().unwrap_or(Point3::ORIGIN);
    let mut fine = Polygons::default();
    // Where each point goes: (Q + 2 R + (n − 3) S) / n, Q the mean of the faces, R that of the edges.
    let mut face_sums = vec![Vector3::ZERO; polygons.points.len()];
    for (f, face) in polygons.faces.iter().enumerate() {
        for &i in face {
            if let Some(sum) = face_sums.get_mut(i) {
                *sum += middle(f).to_vector();
            }
        }
    }
    for (i, face_sum) in face_sums.iter().enumerate() {
        let here = polygons.at(i);
        let own = around.at_point.get(i).map_or(&[][..], Vec::as_slice);
        let faces = around.faces.get(i).copied().unwrap_or(0);
        let inner = || {
            let n = own.len() as f64;
            if own.is_empty() || faces == 0 {
                return here;
            }
            let halves = own.iter().fold(Vector3::ZERO, |sum, &e| {
                sum + here.lerp(polygons.at(around.other_end(e, i)), 0.5).to_vector()
            });
            let (q, r) = (*face_sum / faces as f64, halves / n);
            Point3::ORIGIN + (q + r * 2.0 + here.to_vector() * (n - 3.0)) / n
        };
        fine.points.push(around.naked(polygons, i, naked).unwrap_or_else(inner));
    }
    let first_edge = fine.points.len();
    for (&(a, b), faces) in around.edges.list.iter().zip(&around.edges.faces) {
        let (p, q) = (polygons.at(a), polygons.at(b));
        fine.points.push(match *faces.as_slice() {
            [f, g] => mix(&[(p, 0.25), (q, 0.25), (middle(f), 0.25), (middle(g), 0.25)]),
            _ => p.lerp(q, 0.5),
        });
    }
    let first_middle = fine.points.len();
    fine.points.extend(middles);
    for (f, face) in polygons.faces.iter().enumerate() {
        let halves: Vec<usize> = sides(face).filter_map(|(a, b)| around.edges.number(a, b)).collect();
        let n = face.len();
        for (k, &corner) in face.iter().enumerate() {
            if let (Some(after), Some(before)) = (halves.get(k), halves.get((k + n - 1) % n)) {
                fine.faces.push(vec![corner, first_edge + after, first_middle + f, first_edge + before]);
            }
        }
    }
    fine
}

/// The same faces as triangles: quads cut from first to third corner, others as a fan about the middle.
pub(super) fn triangulated(polygons: &Polygons) -> Polygons {
    let mut triangles = Polygons { points: polygons.points.clone(), faces: Vec::new() };
    for face in &polygons.faces {
        match *face.as_slice() {
            [_, _, _] => triangles.faces.push(face.clone()),
            [a, b, c, d] => triangles.faces.extend([vec![a, b, c], vec![c, d, a]]),
            _ => {
                let middle = triangles.points.len();
                triangles.points.push(polygons.middle(face));
                triangles.faces.extend(sides(face).map(|(a, b)| vec![a, b, middle]));
            }
        }
    }
    triangles
}

/// One level of Loop subdivision (C. Loop, *Smooth subdivision surfaces based on triangles*, 1987): every triangle becomes four.
pub(super) fn loop_level(polygons: &Polygons, naked: Naked) -> Polygons {
    let around = Around::new(polygons);
    let mut fine = Polygons::default();
    for i in 0..polygons.points.len() {
        let here = polygons.at(i);
        let own = around.at_point.get(i).map_or(&[][..], Vec::as_slice);
        let inner = || {
            if own.is_empty() {
                return here;
            }
            let n = own.len() as f64;
            let c = 0.375 + 0.25 * (std::f64::consts::TAU / n).cosine();
            let beta = (0.625 - c * c) / n;
            let ends = own
                .iter()
                .fold(Vector3::ZERO, |sum, &e| sum + polygons.at(around.other_end(e, i)).to_vector());
            Point3::ORIGIN + here.to_vector() * (1.0 - n * beta) + ends * beta
        };
        fine.points.push(around.naked(polygons, i, naked).unwrap_or_else(inner));
    }
    let first = fine.points.len();
    for (&(a, b), faces) in around.edges.list.iter().zip(&around.edges.faces) {
        let tip =
            |f: usize| polygons.faces.get(f).and_then(|face| face.iter().find(|i| **i != a && **i != b));
        let (p, q) = (polygons.at(a), polygons.at(b));
        fine.points.push(match *faces.as_slice() {
            [f, g] => {
                let at = |f: usize| tip(f).map_or(p, |&i| polygons.at(i));
                mix(&[(p, 0.375), (q, 0.375), (at(f), 0.125), (at(g), 0.125)])
            }
            _ => p.lerp(q, 0.5),
        });
    }
    quarter(polygons, &around.edges, first, &mut fine);
    fine
}

/// Four triangles for each: one at each corner and one between them.
fn quarter(polygons: &Polygons, edges: &Edges, first: usize, fine: &mut Polygons) {
    for face in &polygons.faces {
        let halves: Vec<usize> = sides(face).filter_map(|(a, b)| Some(first + edges.number(a, b)?)).collect();
        let ([a, b, c], [ab, bc, ca]) = (face.as_slice(), halves.as_slice()) else { continue };
        fine.faces.extend([vec![*a, *ab, *ca], vec![*b, *bc, *ab], vec![*c, *ca, *bc], vec![*ab, *bc, *ca]]);
    }
}

/// The middles of the edges after the points, and their numbers around each face.
fn halved(polygons: &Polygons) -> (Vec<Point3>, Vec<Vec<usize>>) {
    let edges = polygons.edges();
    let mut points = polygons.points.clone();
    let first = points.len();
    points.extend(edges.list.iter().map(|&(a, b)| polygons.at(a).lerp(polygons.at(b), 0.5)));
    let around = polygons
        .faces
        .iter()
        .map(|face| sides(face).filter_map(|(a, b)| Some(first + edges.number(a, b)?)).collect())
        .collect();
    (points, around)
}

/// Every face into as many quads as it has corners, without smoothing.
pub(super) fn split_quads(polygons: &Polygons) -> Polygons {
    let (points, halves) = halved(polygons);
    let mut fine = Polygons { points, faces: Vec::new() };
    for (face, halves) in polygons.faces.iter().zip(&halves) {
        let middle = fine.points.len();
        fine.points.push(polygons.middle(face));
        let n = halves.len();
        for (k, &corner) in face.iter().enumerate() {
            if let (Some(&after), Some(&before)) = (halves.get(k), halves.get((k + n - 1) % n.max(1))) {
                fine.faces.push(vec![corner, after, middle, before]);
            }
        }
    }
    fine
}

/// A triangle at each corner, and with `inner` a face between the middles of the edges.
pub(super) fn corner_triangles(polygons: &Polygons, inner: bool) -> Polygons {
    let (points, halves) = halved(polygons);
    let mut fine = Polygons { points, faces: Vec::new() };
    for (face, halves) in polygons.faces.iter().zip(&halves) {
        let n = halves.len();
        if inner {
            fine.faces.push(halves.clone());
        }
        for (k, &corner) in face.iter().enumerate() {
            if let (Some(&after), Some(&before)) = (halves.get(k), halves.get((k + n - 1) % n.max(1))) {
                fine.faces.push(vec![corner, after, before]);
            }
        }
    }
    fine
}

/// One level of mid-edge subdivision (J. Peters and U. Reif, *The simplest subdivision scheme for smoothing polyhedra*, 1997):
/// the middles of the edges, joined around each face and around each point. A point on the boundary stays as a corner of the
/// face around it, unless the boundary shall be smooth.
pub(super) fn mid_edge(polygons: &Polygons, naked: Naked) -> Polygons {
    let edges = polygons.edges();
    let on_boundary = polygons.naked_vertices();
    let mut fine = Polygons::default();
    fine.points.extend(edges.list.iter().map(|&(a, b)| polygons.at(a).lerp(polygons.at(b), 0.5)));
    let number = |a: usize, b: usize| edges.number(a, b);
    for face in &polygons.faces {
        fine.faces.push(sides(face).filter_map(|(a, b)| number(a, b)).collect());
    }
    let mut counts = vec![0_usize; polygons.points.len()];
    for &i in polygons.faces.iter().flatten() {
        if let Some(count) = counts.get_mut(i) {
            *count += 1;
        }
    }
    for (i, ring) in polygons.rings().into_iter().enumerate() {
        let mut face: Vec<usize> = ring.iter().filter_map(|&j| number(i, j)).collect();
        if on_boundary.contains(&i) {
            let corner = counts.get(i).is_some_and(|count| *count == 1);
            if naked == Naked::Fixed || naked == Naked::CornerFixed && corner {
                face.push(fine.points.len());
                fine.points.push(polygons.at(i));
            }
        }
        if face.len() > 2 {
            fine.faces.push(face);
        }
    }
    fine
}
