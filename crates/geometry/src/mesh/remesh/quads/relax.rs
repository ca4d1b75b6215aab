use std::collections::HashMap;

use super::super::imprint::Course;
use super::super::net::Net;
use super::super::target::Target;
use crate::cancellation::check;
use crate::{Error, Mesh, MeshFace, Point3, Result, Vector3};

/// Rounds of evening out.
const ROUNDS: usize = 12;
/// Rounds after quads were brought to the middle of a curve.
const AGAIN: usize = 4;

/// How a vertex may move.
#[derive(Clone, Copy, PartialEq)]
enum Freedom {
    Surface,
    /// Between its two neighbours along an edge that stays.
    Line([u32; 2]),
    None,
}

/// Faces divided about their middles, evened out on the surface; the edges that cross `rings` are crossed in the middle.
pub(super) fn finished(
    net: &Net,
    at: Vec<Point3>,
    faces: &[Vec<u32>],
    surface: &Target,
    rings: &[Course],
) -> Result<Mesh> {
    let mut divided = Divided::new(net, at, faces, surface)?;
    for _ in 0..ROUNDS {
        check()?;
        divided.even_out(surface);
    }
    if !rings.is_empty() {
        rings.iter().for_each(|ring| divided.centre(ring, surface));
        for _ in 0..AGAIN {
            check()?;
            divided.even_out(surface);
        }
    }
    Ok(Mesh::new(divided.points, divided.quads.into_iter().map(MeshFace::Quad).collect())?.with_normals())
}

struct Divided {
    points: Vec<Point3>,
    quads: Vec<[u32; 4]>,
    neighbours: Vec<Vec<u32>>,
    around: Vec<Vec<u32>>,
    freedom: Vec<Freedom>,
}

impl Divided {
    fn new(net: &Net, at: Vec<Point3>, faces: &[Vec<u32>], surface: &Target) -> Result<Self> {
        let most = faces.iter().map(Vec::len).sum::<usize>();
        u32::try_from(at.len().saturating_add(3 * most))
            .map_err(|_| Error::degenerate("mesh", "too many faces"))?;
        let mut number: HashMap<u32, u32> = HashMap::new();
        let mut points: Vec<Point3> = Vec::new();
        let mut freedom: Vec<Freedom> = Vec::new();
        for &v in faces.iter().flatten() {
            number.entry(v).or_insert_with(|| {
                let ends = net.kept_neighbours(v);
                let (place, free) = match ends.len() {
                    0 => (surface.nearest(at[v as usize]), Freedom::Surface),
                    2 if net.goes_straight(v, &ends) => {
                        (surface.nearest_on_line(at[v as usize]), Freedom::Line([0; 2]))
                    }
                    _ => (at[v as usize], Freedom::None),
                };
                points.push(place);
                freedom.push(free);
                points.len() as u32 - 1
            });
        }
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut quads = Vec::with_capacity(most);
        let mut ends_on_line: HashMap<u32, Vec<u32>> = HashMap::new();
        for face in faces {
            let n = face.len();
            let sum: Vector3 = face.iter().map(|v| points[number[v] as usize].to_vector()).sum();
            let mut sides = Vec::with_capacity(n);
            for k in 0..n {
                let (a, b) = (face[k], face[(k + 1) % n]);
                let key = [a.min(b), a.max(b)];
                let (na, nb) = (number[&a], number[&b]);
                let middle = *middles.entry(key).or_insert_with(|| {
                    let place = points[na as usize].lerp(points[nb as usize], 0.5);
                    let kept = net.is_kept(a, b);
                    points.push(if kept { surface.nearest_on_line(place) } else { surface.nearest(place) });
                    freedom.push(if kept { Freedom::Line([na, nb]) } else { Freedom::Surface });
                    let m = points.len() as u32 - 1;
                    if kept {
                        ends_on_line.entry(na).or_default().push(m);
                        ends_on_line.entry(nb).or_default().push(m);
                    }
                    m
                });
                sides.push(middle);
            }
            points.push(surface.nearest(Point3::ORIGIN + sum / n as f64));
            freedom.push(Freedom::Surface);
            let centre = points.len() as u32 - 1;
            for k in 0..n {
                quads.push([number[&face[k]], sides[k], centre, sides[(k + n - 1) % n]]);
            }
        }
        for (v, ends) in ends_on_line {
            if let Freedom::Line(own) = &mut freedom[v as usize] {
                if let &[a, b] = ends.as_slice() {
                    *own = [a, b];
                } else {
                    freedom[v as usize] = Freedom::None;
                }
            }
        }
        let mut made = Self {
            neighbours: vec![Vec::new(); points.len()],
            around: vec![Vec::new(); points.len()],
            points,
            quads,
            freedom,
        };
        made.link();
        Ok(made)
    }

    fn link(&mut self) {
        for (quad, f) in self.quads.iter().zip(0..) {
            for k in 0..4 {
                let (a, b) = (quad[k], quad[(k + 1) % 4]);
                self.around[a as usize].push(f);
                for (from, to) in [(a, b), (b, a)] {
                    let list = &mut self.neighbours[from as usize];
                    if !list.contains(&to) {
                        list.push(to);
                    }
                }
            }
        }
    }

    /// Moves each vertex halfway to the middle of its neighbours, along the surface.
    fn even_out(&mut self, surface: &Target) {
        for v in 0..self.points.len() {
            let here = self.points[v];
            let place = match self.freedom[v] {
                Freedom::None => continue,
                Freedom::Line([a, b]) => {
                    let middle = self.points[a as usize].lerp(self.points[b as usize], 0.5);
                    surface.nearest_on_line(here.lerp(middle, 0.5))
                }
                Freedom::Surface => {
                    let near = &self.neighbours[v];
                    let mean = near.iter().map(|&w| self.points[w as usize] - here).sum::<Vector3>();
                    let step = mean / near.len().max(1) as f64 * 0.5;
                    let normal: Vector3 = self.around[v].iter().map(|&f| self.normal(f)).sum();
                    let level = normal.unitized().map_or(step, |n| step - n * n.dot(step));
                    surface.nearest(here + level)
                }
            };
            if place.is_finite() {
                self.points[v] = place;
            }
        }
    }

    /// Moves vertices beside a curve so that it crosses their edges in the middle, and keeps them there.
    fn centre(&mut self, ring: &Course, surface: &Target) {
        // Of each vertex how far it lies to the left of the curve, and the place beside it.
        let sides: Vec<Option<(f64, f64, Point3)>> = (0..self.points.len())
            .map(|v| {
                let p = self.points[v];
                let reach = self.neighbours[v].iter().map(|&w| self.points[w as usize].distance_to(p));
                let foot = ring.foot(p, reach.fold(0.0, f64::max)).filter(|foot| !foot.end)?;
                let normal: Vector3 = self.around[v].iter().map(|&f| self.normal(f)).sum();
                let left = normal.cross(foot.along).unitized()?;
                Some((left.dot(p - foot.place), foot.at, foot.place))
            })
            .collect();
        let mut moves: Vec<(usize, Point3)> = Vec::new();
        for (v, side) in sides.iter().enumerate() {
            let (Some((own, at, foot)), true) = (*side, self.freedom[v] == Freedom::Surface) else {
                continue;
            };
            let here = self.points[v];
            let mut wanted: Vec<f64> = Vec::new();
            for &w in &self.neighbours[v] {
                let Some((other, there, _)) = sides[w as usize].filter(|s| s.0 * own < 0.0) else { continue };
                let long = self.points[w as usize].distance_to(here);
                if ring.apart(at, there) <= long {
                    let free = self.freedom[w as usize] == Freedom::Surface;
                    wanted.push(if free { 0.5 * long } else { other.abs() });
                }
            }
            if wanted.is_empty() {
                continue;
            }
            let distance = wanted.iter().sum::<f64>() / wanted.len() as f64;
            let place = surface.nearest(foot + (here - foot) * (distance / own.abs()));
            if place.is_finite() {
                moves.push((v, place));
            }
        }
        for (v, place) in moves {
            (self.points[v], self.freedom[v]) = (place, Freedom::None);
        }
    }

    /// The doubled area vector of a quad.
    fn normal(&self, f: u32) -> Vector3 {
        let [a, b, c, d] = self.quads[f as usize].map(|i| self.points[i as usize]);
        (c - a).cross(d - b)
    }
}
