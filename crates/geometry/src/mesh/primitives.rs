//! Meshes of simple shapes.

use crate::thresholds;
use std::f64::consts::{PI, TAU};

use katydid_elementary::Elementary;

use super::{Mesh, MeshFace};
use crate::{Box3, Error, Interval, Plane, Point3, Rectangle, Result};

/// More faces than this are refused before memory is asked for.
const MOST: usize = 50_000_000;

fn check_counts(counts: &[(usize, &'static str)], least: usize) -> Result<()> {
    let mut product = 1_usize;
    for &(count, what) in counts {
        product = product.saturating_mul(count);
        if count < least || product > MOST {
            return Err(Error::OutOfRange {
                what,
                value: count as f64,
                must: "1 or more (3 around), and not too many",
            });
        }
    }
    Ok(())
}

/// The grid of quads over a rectangle in a plane: vertices row by row with x fastest.
fn grid(plane: &Plane, x: Interval, y: Interval, nx: usize, ny: usize) -> (Vec<Point3>, Vec<MeshFace>) {
    let mut vertices = Vec::with_capacity((nx + 1) * (ny + 1));
    for j in 0..=ny {
        for i in 0..=nx {
            let (u, v) = (x.at(i as f64 / nx as f64), y.at(j as f64 / ny as f64));
            vertices.push(plane.at(u, v, 0.0));
        }
    }
    let mut faces = Vec::with_capacity(nx * ny);
    for j in 0..ny {
        for i in 0..nx {
            let at = |i: usize, j: usize| (j * (nx + 1) + i) as u32;
            faces.push(MeshFace::Quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
        }
    }
    (vertices, faces)
}

impl Mesh {
    /// The grid of `nx` × `ny` quads over a rectangle, looking along its plane's normal: (nx + 1)(ny + 1) vertices,
    /// row by row with x fastest.
    ///
    /// # Errors
    /// A count of 0 or too many faces.
    pub fn plane(rectangle: &Rectangle, nx: usize, ny: usize) -> Result<Self> {
        check_counts(&[(nx, "faces along x"), (ny, "faces along y")], 1)?;
        let (x, y) = (rectangle.x.ordered(), rectangle.y.ordered());
        let (vertices, faces) = grid(&rectangle.plane, x, y, nx, ny);
        Ok(Self::new(vertices, faces)?.with_normals())
    }

    /// A box of six grids that share no vertices, so that its edges are creases: y min, x max, y max, x min, bottom,
    /// top. All sides look outwards.
    ///
    /// # Errors
    /// A count of 0 or too many faces.
    pub fn cuboid(shape: &Box3, nx: usize, ny: usize, nz: usize) -> Result<Self> {
        check_counts(&[(nx, "faces along x"), (ny, "faces along y"), (nz, "faces along z")], 1)?;
        let (x, y, z) = (shape.x.ordered(), shape.y.ordered(), shape.z.ordered());
        let p = &shape.plane;
        let frame = |origin: Point3, x_axis, y_axis| Plane::from_axes(origin, x_axis, y_axis);
        let (lx, ly, lz) = (x.length(), y.length(), z.length());
        let span = |l: f64| Interval::new(0.0, l);
        let corner = |u: f64, v: f64, w: f64| p.at(u, v, w);
        let sides = [
            (frame(corner(x.start, y.start, z.start), p.x_axis, p.z_axis)?, lx, lz, nx, nz),
            (frame(corner(x.end, y.start, z.start), p.y_axis, p.z_axis)?, ly, lz, ny, nz),
            (frame(corner(x.end, y.end, z.start), -p.x_axis, p.z_axis)?, lx, lz, nx, nz),
            (frame(corner(x.start, y.end, z.start), -p.y_axis, p.z_axis)?, ly, lz, ny, nz),
            (frame(corner(x.start, y.start, z.start), p.y_axis, p.x_axis)?, ly, lx, ny, nx),
            (frame(corner(x.start, y.start, z.end), p.x_axis, p.y_axis)?, lx, ly, nx, ny),
        ];
        let mut parts = Vec::with_capacity(6);
        for (plane, a, b, na, nb) in sides {
            let (vertices, faces) = grid(&plane, span(a), span(b), na, nb);
            parts.push(Self::new(vertices, faces)?.with_normals());
        }
        let mut mesh = Self::join(&parts)?;
        // The frames above reach a corner along different axes: what is one place becomes exactly one.
        let corners = shape.corners();
        let size = thresholds::ROUNDING * (lx + ly + lz);
        for v in &mut mesh.vertices {
            let [a, b, c] = p.coordinates(*v);
            let snapped = |t: f64, r: Interval| {
                if (t - r.start).abs() <= size {
                    r.start
                } else if (t - r.end).abs() <= size {
                    r.end
                } else {
                    t
                }
            };
            let grid_step = |t: f64, r: Interval, n: usize| {
                let k = (r.normalized(t) * n as f64).round();
                snapped(r.at(k / n as f64), r)
            };
            let flat = |r: Interval| r.length() <= 0.0;
            let place = |t: f64, r: Interval, n: usize| if flat(r) { r.start } else { grid_step(t, r, n) };
            *v = p.at(place(a, x, nx), place(b, y, ny), place(c, z, nz));
            if let Some(corner) = corners.iter().find(|k| k.distance_to(*v) <= size) {
                *v = *corner;
            }
        }
        Ok(mesh)
    }

    /// A sphere of `around` × `up` faces about a plane's axis: triangles at the poles, quads between; one vertex a
    /// pole, and no double vertices at the seam: around·(up − 1) + 2 of them.
    ///
    /// # Errors
    /// Fewer than 3 faces around or 2 from pole to pole, too many faces, or a radius not greater than 0.
    pub fn sphere(plane: &Plane, radius: f64, around: usize, up: usize) -> Result<Self> {
        check_counts(&[(around, "faces around")], 3)?;
        check_counts(&[(up, "faces from pole to pole"), (around, "faces around")], 2)?;
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::OutOfRange {
                what: "radius",
                value: radius,
                must: "finite and greater than 0",
            });
        }
        let mut vertices = vec![plane.at(0.0, 0.0, -radius)];
        for j in 1..up {
            let (z, r) = (PI * (j as f64 / up as f64 - 0.5)).sine_cosine();
            for i in 0..around {
                let (sin, cos) = (TAU * i as f64 / around as f64).sine_cosine();
                vertices.push(plane.at(radius * r * cos, radius * r * sin, radius * z));
            }
        }
        vertices.push(plane.at(0.0, 0.0, radius));
        let at = |i: usize, j: usize| (1 + (j - 1) * around + i % around) as u32;
        let top = (vertices.len() - 1) as u32;
        let mut faces = Vec::with_capacity(around * up);
        for j in 0..up {
            for i in 0..around {
                faces.push(if j == 0 {
                    MeshFace::Triangle([0, at(i + 1, 1), at(i, 1)])
                } else if j == up - 1 {
                    MeshFace::Triangle([at(i, j), at(i + 1, j), top])
                } else {
                    MeshFace::Quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
                });
            }
        }
        let center = plane.origin;
        let normals = vertices.iter().map(|&p| (p - center) / radius).collect();
        Self::from_parts(vertices, faces, normals, Vec::new())
    }
}
