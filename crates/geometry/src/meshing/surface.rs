//! Meshes of surfaces without trims.

use super::{BrepMesh, MeshSettings};
use crate::brep::{Brep, CurvePart, Edge, Face, Iso, Loop, LoopKind, Parts, Trim, TrimKind};
use crate::{Direction, Interval, Line, LineCurve, Point3, Result, Side, Surface};

/// A tolerance that was never computed.
const UNSET: f64 = -1.234_321_012_343_21e308;

impl Surface {
    /// The mesh of the whole surface, closed along seams and at sides that are points.
    ///
    /// # Errors
    /// As [`Brep::mesh`], and when a side's curve is degenerate.
    pub fn mesh(&self, settings: &MeshSettings) -> Result<BrepMesh> {
        whole(self)?.mesh(settings)
    }
}

/// The brep of one face that is all of a surface.
pub(crate) fn whole(surface: &Surface) -> Result<Brep> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let corner = |x: f64, y: f64| Point3::new(x, y, 0.0);
    // Counter-clockwise; the curves of the sides run along the parameters.
    let sides = [
        (Side::South, corner(u.start, v.start), corner(u.end, v.start), false),
        (Side::East, corner(u.end, v.start), corner(u.end, v.end), false),
        (Side::North, corner(u.end, v.end), corner(u.start, v.end), true),
        (Side::West, corner(u.start, v.end), corner(u.start, v.start), true),
    ];
    let mut parts = Parts { faces: vec![Face::new(0, false)], ..Parts::default() };
    parts.surfaces.push(Some(surface.clone()));
    parts.faces.iter_mut().for_each(|face| face.loops.push(0));
    let mut edges: [Option<usize>; 4] = [None; 4];
    for (k, (side, from, to, reversed)) in sides.into_iter().enumerate() {
        let closed = surface.is_closed(side.along().0.other());
        let edge = if surface.is_singular(side) {
            None
        } else if let Some(shared) = edges.get(k.wrapping_sub(2)).copied().flatten().filter(|_| closed) {
            Some(shared)
        } else {
            let curve = surface.side_curve(side)?;
            parts.edges.push(Edge {
                part: CurvePart::whole(parts.curves_3d.len(), curve.domain()),
                vertices: [None; 2],
                trims: Vec::new(),
                tolerance: 0.0,
                deleted: false,
            });
            parts.curves_3d.push(Some(curve));
            Some(parts.edges.len() - 1)
        };
        edges[k] = edge;
        if let Some(edge) = edge.and_then(|e| parts.edges.get_mut(e)) {
            edge.trims.push(k);
        }
        parts.trims.push(Trim {
            part: CurvePart::whole(k, Interval::UNIT),
            edge,
            reversed,
            vertices: [None; 2],
            kind: TrimKind::Unknown,
            iso: Iso::Side(side),
            in_loop: Some(0),
            tolerance: [UNSET; 2],
            older_tolerances: [0.0; 2],
            deleted: false,
        });
        parts.curves_2d.push(Some(LineCurve { line: Line::new(from, to), domain: Interval::UNIT }.into()));
    }
    parts.loops.push(Loop { trims: vec![0, 1, 2, 3], kind: LoopKind::Outer, face: Some(0), deleted: false });
    parts.set_kinds();
    parts.set_vertices();
    Brep::from_parts(parts)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::{MeshSettings, Plane, Point3, Sphere, Surface, Torus};

    #[test]
    fn round_surfaces_close() {
        for tolerance in [0.3, 0.03, 0.003, 0.0003] {
            let sphere: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
            for sphere in [sphere.clone(), sphere.to_nurbs().unwrap().into()] {
                let mesh = sphere.mesh(&MeshSettings::within(tolerance)).unwrap().welded().unwrap();
                assert!(mesh.is_closed() && mesh.is_oriented(), "{}", mesh.faces().len());
                for [a, b, c] in mesh.triangles() {
                    let m = (a.to_vector() + b.to_vector() + c.to_vector()) / 3.0;
                    assert!(2.0 - m.length() <= tolerance, "{tolerance} {}", 2.0 - m.length());
                    assert!(
                        (b - a).cross(c - a).dot(m) > 0.0,
                        "{tolerance} {a:?} {b:?} {c:?} {}",
                        mesh.faces().len()
                    );
                }
                let round = 4.0 / 3.0 * PI * 8.0;
                assert!((mesh.volume() - round).abs() < 16.0 * PI * tolerance);
            }
            let own = Torus::new(Plane::XY, 3.0, 1.0).unwrap();
            let torus: Surface = own.into();
            for torus in [torus.clone(), torus.to_nurbs().unwrap().into()] {
                let mesh = torus.mesh(&MeshSettings::within(tolerance)).unwrap().welded().unwrap();
                assert!(mesh.is_closed() && mesh.is_oriented());
                assert!(
                    mesh.face_centers().iter().all(|p| own.closest_point(*p).distance_to(*p) <= tolerance)
                );
            }
        }
    }
}
