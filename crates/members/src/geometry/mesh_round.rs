//! Meshes of cylinders, cones, tori and spheres.

use std::collections::HashMap;
use std::f64::consts::TAU;

use katydid_elementary::Elementary;
use katydid_geometry::{Cone, Cylinder, Mesh, MeshFace, Plane, Point3, Sphere, Torus, Vector3};

use super::answer::Outcome;
use super::argument::Count;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/createfromcylinder-cylinder_int_int", |c: Cylinder, up: Up, around: Around| {
        cylinder(&c, up, around, [true, true])
    });
    table.add(
        "mesh/createfromcylinder-cylinder_int_int_bool_bool",
        |c: Cylinder, up: Up, around: Around, bottom: bool, top: bool| {
            cylinder(&c, up, around, [bottom, top])
        },
    );
    table.add(
        "mesh/createfromcylinder-cylinder_int_int_bool_bool_bool",
        |c: Cylinder, up: Up, around: Around, bottom: bool, top: bool, quads: bool| {
            if quads && (bottom || top) {
                return Err(Fault::not_supported("caps of quads"));
            }
            cylinder(&c, up, around, [bottom, top])
        },
    );
    table.add("mesh/createfromcone-cone_int_int", |c: Cone, up: Up, around: Around| {
        cone(&c, up, around, true)
    });
    table.add("mesh/createfromcone-cone_int_int_bool", |c: Cone, up: Up, around: Around, solid: bool| {
        cone(&c, up, around, solid)
    });
    table.add(
        "mesh/createfromcone-cone_int_int_bool_bool",
        |c: Cone, up: Up, around: Around, solid: bool, quads: bool| {
            if quads && solid {
                return Err(Fault::not_supported("caps of quads"));
            }
            cone(&c, up, around, solid)
        },
    );
    table.add("mesh/createfromtorus-torus_int_int", torus);
    table.add("mesh/createquadsphere-sphere_int", quad_sphere);
    table.add("mesh/createicosphere-sphere_int", icosphere);
}

type Up = Count<1, 2000>;
type Around = Count<3, 2000>;
type Levels = Count<0, 8>;

/// Rings of vertices about a plane's axis, each by its radius and height, joined by quads that look away from the axis
/// when heights grow; ring after ring, the last one to the first when it closes.
struct Rings {
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
    around: u32,
    plane: Plane,
}

/// The number of a vertex.
fn number(count: usize) -> Outcome<u32> {
    u32::try_from(count)
        .map_err(|_| Fault::too_large("the mesh would have more vertices than can be counted"))
}

impl Rings {
    fn new(plane: Plane, around: usize) -> Outcome<Self> {
        Ok(Self { vertices: Vec::new(), faces: Vec::new(), around: number(around)?, plane })
    }

    fn point(&mut self, point: Point3) -> Outcome<u32> {
        self.vertices.push(point);
        number(self.vertices.len() - 1)
    }

    /// The first vertex of a new ring.
    fn ring(&mut self, radius: f64, height: f64) -> Outcome<u32> {
        let first = number(self.vertices.len())?;
        for k in 0..self.around {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(self.around)).sine_cosine();
            self.vertices.push(self.plane.at(radius * cos, radius * sin, height));
        }
        Ok(first)
    }

    fn quads(&mut self, below: u32, above: u32) {
        for k in 0..self.around {
            let next = (k + 1) % self.around;
            self.faces.push(MeshFace::Quad([below + k, below + next, above + next, above + k]));
        }
    }

    /// Triangles from a ring to a point; they look along the axis when `up`.
    fn fan(&mut self, ring: u32, tip: u32, up: bool) {
        for k in 0..self.around {
            let (a, b) = (ring + k, ring + (k + 1) % self.around);
            self.faces.push(MeshFace::Triangle(if up { [a, b, tip] } else { [b, a, tip] }));
        }
    }

    /// A flat cap with vertices of its own, so that its rim is a crease.
    fn cap(&mut self, radius: f64, height: f64, up: bool) -> Outcome<()> {
        let ring = self.ring(radius, height)?;
        let centre = self.point(self.plane.at(0.0, 0.0, height))?;
        self.fan(ring, centre, up);
        Ok(())
    }

    fn mesh(self) -> Outcome<Mesh> {
        Ok(Mesh::new(self.vertices, self.faces)?.with_normals())
    }
}

fn cylinder(
    shape: &Cylinder,
    Count(up): Up,
    Count(around): Around,
    [bottom, top]: [bool; 2],
) -> Outcome<Mesh> {
    let mut rings = Rings::new(shape.plane, around)?;
    let mut below = rings.ring(shape.radius, shape.height.start)?;
    for k in 1..=up {
        let above = rings.ring(shape.radius, shape.height.at(k as f64 / up as f64))?;
        rings.quads(below, above);
        below = above;
    }
    if bottom {
        rings.cap(shape.radius, shape.height.start, false)?;
    }
    if top {
        rings.cap(shape.radius, shape.height.end, true)?;
    }
    rings.mesh()
}

/// A cone has its tip at the plane's origin and its base at the height, which may be below 0.
fn cone(shape: &Cone, Count(up): Up, Count(around): Around, solid: bool) -> Outcome<Mesh> {
    let mut rings = Rings::new(shape.plane, around)?;
    let outward = shape.height > 0.0;
    let tip = rings.point(shape.plane.origin)?;
    let mut last = None;
    for k in 1..=up {
        let share = k as f64 / up as f64;
        let ring = rings.ring(shape.radius * share, shape.height * share)?;
        match last {
            None => rings.fan(ring, tip, !outward),
            Some(last) if outward => rings.quads(last, ring),
            Some(last) => rings.quads(ring, last),
        }
        last = Some(ring);
    }
    if solid {
        rings.cap(shape.radius, shape.height, outward)?;
    }
    rings.mesh()
}

fn torus(shape: Torus, Count(tube): Around, Count(around): Around) -> Outcome<Mesh> {
    let mut rings = Rings::new(shape.plane, around)?;
    let mut firsts = Vec::with_capacity(tube);
    for k in 0..tube {
        let (sin, cos) = (TAU * k as f64 / tube as f64).sine_cosine();
        firsts.push(rings.ring(shape.major_radius + shape.minor_radius * cos, shape.minor_radius * sin)?);
    }
    let next = firsts.iter().cycle().skip(1);
    for (below, above) in firsts.iter().zip(next) {
        rings.quads(*below, *above);
    }
    rings.mesh()
}

/// Moves a direction's end onto a sphere.
fn onto(sphere: &Sphere, direction: Vector3) -> Point3 {
    let v = direction.unitized().unwrap_or(Vector3::Z) * sphere.radius;
    sphere.plane.at(v.x, v.y, v.z)
}

/// A cube whose sides are halved so many times, moved out onto the sphere.
fn quad_sphere(shape: Sphere, Count(levels): Levels) -> Outcome<Mesh> {
    let corner = |x: f64, y: f64, z: f64| Vector3::new(x, y, z);
    let mut directions = Vec::new();
    for z in [-1.0, 1.0] {
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            directions.push(corner(x, y, z));
        }
    }
    let mut quads: Vec<[u32; 4]> =
        vec![[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    for _ in 0..levels {
        let mut middles = Middles::new(directions);
        let mut finer = Vec::with_capacity(4 * quads.len());
        for [a, b, c, d] in quads {
            let [ab, bc, cd, da] =
                [middles.of(&[a, b])?, middles.of(&[b, c])?, middles.of(&[c, d])?, middles.of(&[d, a])?];
            let centre = middles.of(&[a, b, c, d])?;
            finer.extend([
                [a, ab, centre, da],
                [ab, b, bc, centre],
                [centre, bc, c, cd],
                [da, centre, cd, d],
            ]);
        }
        (directions, quads) = (middles.directions, finer);
    }
    let vertices = directions.into_iter().map(|v| onto(&shape, v)).collect();
    Ok(Mesh::new(vertices, quads.into_iter().map(MeshFace::Quad).collect())?.with_normals())
}

/// An icosahedron whose sides are halved so many times, moved out onto the sphere.
fn icosphere(shape: Sphere, Count(levels): Levels) -> Outcome<Mesh> {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut directions: Vec<Vector3> = Vec::new();
    for (x, y, z) in [(-1.0, golden, 0.0), (1.0, golden, 0.0), (-1.0, -golden, 0.0), (1.0, -golden, 0.0)] {
        directions.push(Vector3::new(x, y, z));
    }
    for (x, y, z) in [(0.0, -1.0, golden), (0.0, 1.0, golden), (0.0, -1.0, -golden), (0.0, 1.0, -golden)] {
        directions.push(Vector3::new(x, y, z));
    }
    for (x, y, z) in [(golden, 0.0, -1.0), (golden, 0.0, 1.0), (-golden, 0.0, -1.0), (-golden, 0.0, 1.0)] {
        directions.push(Vector3::new(x, y, z));
    }
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..levels {
        let mut middles = Middles::new(directions);
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [middles.of(&[a, b])?, middles.of(&[b, c])?, middles.of(&[c, a])?];
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        (directions, triangles) = (middles.directions, finer);
    }
    let vertices = directions.into_iter().map(|v| onto(&shape, v)).collect();
    Ok(Mesh::new(vertices, triangles.into_iter().map(MeshFace::Triangle).collect())?.with_normals())
}

/// Directions, and those halfway between some of them, each once.
struct Middles {
    directions: Vec<Vector3>,
    known: HashMap<Vec<u32>, u32>,
}

impl Middles {
    fn new(directions: Vec<Vector3>) -> Self {
        Self { directions, known: HashMap::new() }
    }

    fn of(&mut self, corners: &[u32]) -> Outcome<u32> {
        let mut key = corners.to_vec();
        key.sort_unstable();
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let unit =
            |i: &u32| self.directions.get(*i as usize).and_then(|v| v.unitized()).unwrap_or(Vector3::ZERO);
        let sum: Vector3 = corners.iter().map(unit).sum();
        let new = number(self.directions.len())?;
        self.directions.push(sum);
        self.known.insert(key, new);
        Ok(new)
    }
}
