//! Wb Create: a mesh from its edges.

use std::collections::{HashMap, HashSet, VecDeque};
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Line, Mesh, Plane, Point3, Vector3};

use crate::polygons::Polygons;

/// Points, and for each the points that a line joins it to.
struct Net {
    points: Vec<Point3>,
    neighbours: Vec<Vec<usize>>,
}

impl Net {
    /// The net of lines whose ends are one where they are within the tolerance.
    fn of(lines: &[Line], tolerance: f64) -> Self {
        let ends: Vec<Point3> = lines.iter().flat_map(|line| [line.from, line.to]).collect();
        let (points, numbers) = merged(&ends, tolerance);
        let mut neighbours = vec![Vec::new(); points.len()];
        let mut known = HashSet::new();
        for pair in numbers.chunks_exact(2) {
            let &[a, b] = pair else { continue };
            if a != b && known.insert((a.min(b), a.max(b))) {
                for (from, to) in [(a, b), (b, a)] {
                    if let Some(own) = neighbours.get_mut(from) {
                        own.push(to);
                    }
                }
            }
        }
        Self { points, neighbours }
    }

    fn at(&self, i: usize) -> Point3 {
        self.points.get(i).copied().unwrap_or(Point3::ORIGIN)
    }

    fn near(&self, i: usize) -> &[usize] {
        self.neighbours.get(i).map_or(&[], Vec::as_slice)
    }

    fn towards(&self, from: usize, to: usize) -> Vector3 {
        (self.at(to) - self.at(from)).unitized().unwrap_or(Vector3::ZERO)
    }

    /// The normal of the plane that fits best through the neighbours of a point; none where they do not span one.
    fn normal(&self, i: usize) -> Option<Vector3> {
        let mut tips: Vec<Point3> =
            self.near(i).iter().map(|&j| Point3::ORIGIN + self.towards(i, j)).collect();
        if tips.len() < 3 {
            tips.push(Point3::ORIGIN);
        }
        let (plane, _) = Plane::fit(&tips).ok()?;
        Some(plane.z_axis)
    }

    /// Normals that look to one side of the net, as far as it hangs together: across a line both normals turn about it as one.
    fn normals(&self) -> Vec<Vector3> {
        let own: Vec<Option<Vector3>> = (0..self.points.len()).map(|i| self.normal(i)).collect();
        let mut normals = vec![Vector3::ZERO; own.len()];
        let mut done = vec![false; own.len()];
        for start in 0..own.len() {
            if done.get(start) != Some(&false) || own.get(start).is_none_or(Option::is_none) {
                continue;
            }
            let mut queue =
                VecDeque::from([(start, own.get(start).copied().flatten().unwrap_or(Vector3::Z))]);
            while let Some((i, normal)) = queue.pop_front() {
                let (Some(slot), Some(seen)) = (normals.get_mut(i), done.get_mut(i)) else { continue };
                if std::mem::replace(seen, true) {
                    continue;
                }
                *slot = normal;
                for &j in self.near(i) {
                    let along = self.towards(i, j);
                    let across = |v: Vector3| v - along * v.dot(along);
                    // A point in the middle of a straight line has no normal of its own.
                    let next = own.get(j).copied().flatten().unwrap_or(normal);
                    let turned = across(next).dot(across(normal)) < 0.0;
                    queue.push_back((j, if turned { -next } else { next }));
                }
            }
        }
        normals
    }

    /// The neighbours of a point in order around its normal.
    fn around(&self, i: usize, normal: Vector3) -> Vec<usize> {
        let mut ring = self.near(i).to_vec();
        let Some(first) = ring.first().map(|&j| self.towards(i, j)) else { return ring };
        let x = (first - normal * first.dot(normal)).unitized().unwrap_or(Vector3::X);
        let y = normal.cross(x);
        let turn = |j: usize| {
            let to = self.towards(i, j);
            to.dot(y).arctangent_of(to.dot(x))
        };
        ring.sort_by(|&a, &b| turn(a).total_cmp(&turn(b)).then(a.cmp(&b)));
        ring
    }

    /// Faces: from each line on to the next one at its end, until the walk closes.
    fn faces(&self, most: usize) -> Vec<Vec<usize>> {
        let normals = self.normals();
        // From a directed line to the corner after it: the neighbour before the one where it came from.
        let mut after: HashMap<(usize, usize), usize> = HashMap::new();
        for (i, normal) in normals.iter().enumerate() {
            let ring = self.around(i, *normal);
            for (k, &from) in ring.iter().enumerate() {
                let before = (k + ring.len() - 1) % ring.len();
                after.extend(ring.get(before).map(|&to| ((from, i), to)));
            }
        }
        let mut used = HashSet::new();
        let mut faces = Vec::new();
        for i in 0..self.points.len() {
            for &j in self.near(i) {
                if let Some(face) =
                    walk((i, j), &after, &mut used, most).filter(|face| self.is_inner(face, &normals))
                {
                    faces.push(face);
                }
            }
        }
        faces
    }

    /// Whether a walk goes round a face, and not around the outside of the net.
    fn is_inner(&self, face: &[usize], normals: &[Vector3]) -> bool {
        let area = crate::polygons::sides(face).fold(Vector3::ZERO, |sum, (a, b)| {
            let origin = self.at(face.first().copied().unwrap_or(a));
            sum + (self.at(a) - origin).cross(self.at(b) - origin)
        });
        let normal = face.iter().filter_map(|&i| normals.get(i)).fold(Vector3::ZERO, |sum, n| sum + *n);
        area.dot(normal) > 0.0
    }
}

/// The corners of the walk that begins with a line; none where it was walked before, is too long, or meets a corner twice.
fn walk(
    start: (usize, usize),
    after: &HashMap<(usize, usize), usize>,
    used: &mut HashSet<(usize, usize)>,
    most: usize,
) -> Option<Vec<usize>> {
    let mut face = Vec::new();
    let mut at = start;
    while used.insert(at) {
        if face.len() <= most {
            face.push(at.0);
        }
        at = (at.1, *after.get(&at)?);
    }
    let simple = face.iter().collect::<HashSet<_>>().len() == face.len();
    (at == start && simple && (3..=most).contains(&face.len())).then_some(face)
}

/// Points without those within the tolerance of one before, and for each point its number among them.
fn merged(points: &[Point3], tolerance: f64) -> (Vec<Point3>, Vec<usize>) {
    let side = 2.0 * tolerance;
    let cell = |p: Point3| [p.x, p.y, p.z].map(|c| (c / side).floor());
    let key = |c: [f64; 3]| c.map(|c| (c + 0.0).to_bits());
    let mut cells: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    let mut own: Vec<Point3> = Vec::new();
    let numbers = points.iter().map(|p| {
        let [x, y, z] = cell(*p);
        let around = (-1..=1).flat_map(|i| (-1..=1).flat_map(move |j| (-1..=1).map(move |k| [i, j, k])));
        let found = around
            .filter_map(|[i, j, k]| cells.get(&key([x + f64::from(i), y + f64::from(j), z + f64::from(k)])))
            .flatten()
            .find(|&&n| own.get(n).is_some_and(|q| q.distance_to(*p) <= tolerance))
            .copied();
        found.unwrap_or_else(|| {
            own.push(*p);
            cells.entry(key([x, y, z])).or_default().push(own.len() - 1);
            own.len() - 1
        })
    });
    let numbers = numbers.collect();
    (own, numbers)
}

/// Makes the mesh whose edges are given. Stands for Weaverbird's Mesh From Lines (Weave Back); that faces are found by turning from
/// line to line around the normals at their ends is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b56",
    name = "Mesh From Lines (Weave Back)",
    nick = "wbWeaveback",
    at = "Weaverbird/Wb Create"
)]
#[output("Mesh", "O", "The mesh; faces of more than four corners are triangles about their middle.")]
fn weave_back(
    context: &Context<'_>,
    /// The edges. Ends are one within the tolerance of the document.
    #[port("Lines", "L")]
    lines: List<Line>,
    /// The most corners of a face: larger openings stay open.
    #[port("Maximum valence", "V", default = 4)]
    most: i32,
) -> Result<Shared<Mesh>, Message> {
    let lines: Vec<Line> = lines.present().collect();
    if lines.iter().any(|line| !line.from.is_finite() || !line.to.is_finite()) {
        return Err(Message::error("A line is not finite"));
    }
    let Some(most) = usize::try_from(most).ok().filter(|most| *most > 2) else {
        return Err(Message::error(format!("Faces of at most {most} corners: there must be 3 at least")));
    };
    context.items(lines.len().saturating_mul(4))?;
    let net = Net::of(&lines, context.tolerance().absolute);
    let faces = net.faces(most);
    if faces.is_empty() {
        return Err(Message::error("No face was found between the lines"));
    }
    Ok(Shared::new(Polygons { points: net.points, faces }.to_mesh(context)?))
}
