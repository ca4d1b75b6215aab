//! Solids between a brep and its moved copy or a point: a wall along each naked edge, put together edge by edge.

use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{
    Brep, Curve, Direction, Error, Interval, Line, LineCurve, NurbsSurface, Point3, Result, Side, SumSurface,
    Surface, Vector3, Xform,
};

/// How a brep is drawn out.
pub(super) enum Way<'a> {
    /// Straight, as far as a vector.
    Straight(Vector3),
    /// Along an open curve without kinks, without turning.
    Along(&'a Curve),
    /// Straight to a point.
    To(Point3),
}

impl Way<'_> {
    /// What an edge draws: u along the edge, v along the way.
    fn wall(&self, edge: Curve) -> Result<Surface> {
        Ok(match self {
            Self::Straight(direction) => SumSurface::extrusion(edge, *direction)?.into(),
            Self::Along(path) => SumSurface::new(edge, (*path).clone(), -path.start().to_vector())?.into(),
            Self::To(apex) => NurbsSurface::to_apex(&edge.to_nurbs()?, *apex)?.into(),
        })
    }

    /// Where the copy of the brep lies; none when it is a point.
    fn shift(&self) -> Option<Vector3> {
        match self {
            Self::Straight(direction) => Some(*direction),
            Self::Along(path) => Some(path.end() - path.start()),
            Self::To(_) => None,
        }
    }
}

/// The far end of the walls.
#[derive(Clone, Copy)]
enum Top {
    /// The copy of the brep, whose edges and vertices come so many places later.
    Copy { edges: usize, vertices: usize },
    /// One point.
    Apex(NewVertex),
}

/// The solid that an open brep draws: itself, its copy turned over, and walls that share their upright edges.
///
/// # Errors
/// The brep has no naked edges, an edge runs along the way, or nothing closed comes of it.
pub(super) fn drawn_out(base: &Brep, way: &Way<'_>) -> Result<Brep> {
    let live: Vec<usize> = (0..base.faces().len()).collect();
    let base = base.sub_brep(&live)?;
    let chains = base.naked_loops();
    if chains.is_empty() {
        return Err(Error::degenerate("extrusion", "the brep has no naked edges"));
    }
    let (mut builder, top) = match way.shift() {
        Some(shift) => {
            let copy = base.transformed(&Xform::translation(shift))?.flipped();
            let top = Top::Copy { edges: base.edges().len(), vertices: base.vertices().len() };
            (Builder::from_brep(Brep::merged(&[base.clone(), copy])), top)
        }
        None => {
            let Way::To(apex) = way else { return Err(open()) };
            let mut builder = Builder::from_brep(base.clone());
            let apex = builder.vertex(*apex);
            (builder, Top::Apex(apex))
        }
    };
    for chain in &chains {
        add_walls(&mut builder, &base, chain, way, top)?;
    }
    let whole = builder.finish(f64::INFINITY)?;
    if whole.is_solid() { Ok(whole) } else { Err(open()) }
}

fn open() -> Error {
    Error::degenerate("extrusion", "its faces do not close")
}

/// A wall for each edge of a chain of naked edges. Each upright edge is that of two neighbours, or the seam of the one
/// wall along a closed edge.
fn add_walls(
    builder: &mut Builder,
    base: &Brep,
    chain: &[(usize, bool)],
    way: &Way<'_>,
    top: Top,
) -> Result<()> {
    let mut uprights: Vec<Option<NewEdge>> = vec![None; chain.len()];
    for (place, &(edge, back)) in chain.iter().enumerate() {
        let curve = base.edge_as_curve(edge)?.ok_or_else(open)?;
        let wall = way.wall(curve)?;
        wall.check_area()?;
        let ends = base.edges().get(edge).map(|e| e.vertices).ok_or_else(open)?;
        // The walk goes against the edge where `back` is set: there its start is the edge's end.
        let (here, next) = (place, (place + 1) % chain.len());
        let joints = if back { [next, here] } else { [here, next] };
        let mut sides = [None; 2];
        for (k, side) in [Side::West, Side::East].into_iter().enumerate() {
            let slot = uprights.get_mut(joints[k]).ok_or_else(open)?;
            if slot.is_none() {
                let foot = ends[k].and_then(|v| builder.known_vertex(v)).ok_or_else(open)?;
                let head = match top {
                    Top::Copy { vertices, .. } => {
                        ends[k].and_then(|v| builder.known_vertex(v + vertices)).ok_or_else(open)?
                    }
                    Top::Apex(apex) => apex,
                };
                *slot = Some(builder.edge(wall.side_curve(side)?, [foot, head]));
            }
            sides[k] = *slot;
        }
        let [Some(west), Some(east)] = sides else { return Err(open()) };
        let south = builder.known_edge(edge).ok_or_else(open)?;
        let north = match top {
            Top::Copy { edges, .. } => Along::Edge(builder.known_edge(edge + edges).ok_or_else(open)?, true),
            Top::Apex(apex) => Along::Point(apex),
        };
        let along = [Along::Edge(south, false), Along::Edge(east, false), north, Along::Edge(west, true)];
        let paths = round(&wall, along);
        // The face beside the edge runs with the walk, so the wall must run against it.
        let face = builder.face(wall, !back);
        builder.bound(face, LoopKind::Outer, paths)?;
    }
    Ok(())
}

/// The way round a whole surface from its south west: each side with what it runs along.
fn round(surface: &Surface, along: [Along; 4]) -> Vec<Path> {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let corners = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)];
    let ranges = [u, v, Interval::new(-u.end, -u.start), Interval::new(-v.end, -v.start)];
    let at = |k: usize| Point3::new(corners[k % 4].0, corners[k % 4].1, 0.0);
    let side = |(k, (along, domain)): (usize, (Along, Interval))| {
        let line = Line::new(at(k), at(k + 1));
        Path { curve: LineCurve { line, domain }.into(), along }
    };
    along.into_iter().zip(ranges).enumerate().map(side).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::brep::Solidity;
    use crate::construct::{extrude, extrude_brep, extrude_brep_along, extrude_brep_to_point};
    use crate::{Brep, Circle, Curve, NurbsCurve, Plane, Point3, PolylineCurve, Tolerance, Vector3};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 0.01, angle: 1_f64.to_radians() }
    }

    fn polyline(points: &[[f64; 3]]) -> Curve {
        PolylineCurve::new(points.iter().copied().map(Point3::from).collect()).unwrap().into()
    }

    fn face(curves: &[Curve]) -> Brep {
        Brep::planar_faces(curves, &tolerance()).unwrap().breps.pop().unwrap()
    }

    /// A valid solid, outward, of so many faces and so much volume.
    fn check(brep: &Brep, faces: usize, volume: f64) {
        assert_eq!(brep.faults(), []);
        assert!(brep.is_solid());
        assert_eq!((brep.faces().len(), brep.parts().solidity), (faces, Solidity::Outward));
        let found = brep.volume_properties(1e-9, || true).unwrap().amount;
        assert!((found - volume).abs() < 1e-7 * volume, "{found} {volume}");
    }

    #[test]
    fn rings_and_polygons_become_solids() {
        let circle = |radius: f64| Curve::from(Circle { plane: Plane::XY, radius });
        let ring = face(&[circle(3.0), circle(1.0)]);
        let up = Vector3::new(0.0, 0.0, 2.0);
        check(&extrude_brep(&ring, up, &tolerance()).unwrap(), 4, 16.0 * PI);
        check(&extrude_brep(&ring, -up, &tolerance()).unwrap(), 4, 16.0 * PI);
        check(&extrude_brep(&ring.clone().flipped(), up, &tolerance()).unwrap(), 4, 16.0 * PI);
        let apex = Point3::new(0.5, 0.0, 3.0);
        check(&extrude_brep_to_point(&face(&[circle(2.0)]), apex, &tolerance()).unwrap(), 2, 4.0 * PI);
        let bow = [[0.0, 0.0, 0.0], [1.0, 0.0, 2.0], [0.0, 1.0, 4.0], [0.0, 0.0, 6.0]].map(Point3::from);
        let bow: Curve = NurbsCurve::clamped_uniform(3, &bow).unwrap().into();
        check(&extrude_brep_along(&ring, &bow, &tolerance()).unwrap(), 4, 48.0 * PI);
        let bent = polyline(&[[0.0, 0.0, 0.0], [1.0, 0.0, 2.0], [0.0, 0.0, 4.0]]);
        check(&extrude_brep_along(&face(&[circle(1.0)]), &bent, &tolerance()).unwrap(), 4, 4.0 * PI);
        let outline =
            polyline(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]]);
        let area = 3.5;
        check(&extrude_brep(&face(std::slice::from_ref(&outline)), up, &tolerance()).unwrap(), 6, 2.0 * area);
        let leaning = Vector3::new(5.0, 1.0, 2.0);
        check(&extrude(&outline, leaning, true, &tolerance()).unwrap(), 6, 2.0 * area);
        assert!(extrude_brep(&face(&[outline]), Vector3::X, &tolerance()).is_err());
    }

    /// Of several joined faces only the outer edges get walls.
    #[test]
    fn joined_faces_get_walls_outside_only() {
        let square = |x: f64| {
            let corners = [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x + 1.0, 1.0, 0.0], [x, 1.0, 0.0]];
            face(&[polyline(&[corners[0], corners[1], corners[2], corners[3], corners[0]])])
        };
        let sheet = Brep::join(&[square(0.0), square(1.0), square(2.0)], &tolerance()).unwrap().breps;
        assert_eq!(sheet.len(), 1);
        check(&extrude_brep(&sheet[0], Vector3::Z, &tolerance()).unwrap(), 14, 3.0);
    }

    /// An edge of any length, down to what openNURBS does not tell from a point, leaves a solid.
    #[test]
    fn hair_thin_edges() {
        let up = Vector3::new(0.0, 0.0, 2.0);
        for length in [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 2.4e-10, 1e-10, 1e-12, 1e-15] {
            for slant in [0.0, length] {
                let outline = polyline(&[
                    [0.0, 0.0, 0.0],
                    [4.0, 0.0, 0.0],
                    [4.0 - slant, length, 0.0],
                    [4.0, 3.0, 0.0],
                    [0.0, 3.0, 0.0],
                    [0.0, 0.0, 0.0],
                ]);
                let solid = extrude(&outline, up, true, &tolerance()).unwrap();
                assert!(solid.is_solid() && solid.is_valid(), "{length}");
                let solid = extrude_brep(&face(&[outline]), up, &tolerance()).unwrap();
                assert!(solid.is_solid() && solid.is_valid(), "{length}");
                let volume = solid.volume_properties(1e-9, || true).unwrap().amount;
                assert!((volume - (24.0 - 3.0 * slant)).abs() < 1e-6, "{length} {volume}");
            }
        }
    }
}
