//! Breps put together by hand: a cube, a cylinder, and both with one thing wrong.

#![allow(clippy::unwrap_used, reason = "tests build what they know to be sound")]

use katydid_geometry::brep::{
    Brep, CurvePart, Edge, Face, Iso, Loop, LoopKind, Parts, Solidity, Trim, TrimKind,
};
use katydid_geometry::{
    Circle, Curve, Interval, Line, LineCurve, Plane, PlaneSurface, Point3, RevolutionSurface, Side, Surface,
    Vector3,
};

const UNSET: f64 = -1.234_321_012_343_21e308;

/// A segment over 0…1.
fn segment(from: Point3, to: Point3) -> Curve {
    LineCurve { line: Line::new(from, to), domain: Interval::UNIT }.into()
}

/// The trims of one loop, each as (start, end, edge, whether it runs against the edge).
fn add_face(parts: &mut Parts, surface: Surface, trims: &[(Point3, Point3, Option<usize>, bool)]) {
    let (face, chain) = (parts.faces.len(), parts.loops.len());
    parts.faces.push(Face::new(parts.surfaces.len(), false));
    parts.faces[face].loops.push(chain);
    parts.surfaces.push(Some(surface));
    let mut names = Vec::new();
    for &(from, to, edge, reversed) in trims {
        let place = parts.trims.len();
        if let Some(edge) = edge {
            parts.edges[edge].trims.push(place);
        }
        parts.trims.push(Trim {
            part: CurvePart::whole(parts.curves_2d.len(), Interval::UNIT),
            edge,
            reversed,
            vertices: [None; 2],
            kind: TrimKind::Unknown,
            iso: Iso::None,
            in_loop: Some(chain),
            tolerance: [UNSET; 2],
            older_tolerances: [0.0; 2],
            deleted: false,
        });
        parts.curves_2d.push(Some(segment(from, to)));
        names.push(place);
    }
    parts.loops.push(Loop { trims: names, kind: LoopKind::Outer, face: Some(face), deleted: false });
}

fn add_edge(parts: &mut Parts, curve: Curve) -> usize {
    let place = parts.edges.len();
    parts.edges.push(Edge {
        part: CurvePart::whole(parts.curves_3d.len(), curve.domain()),
        vertices: [None; 2],
        trims: Vec::new(),
        tolerance: UNSET,
        deleted: false,
    });
    parts.curves_3d.push(Some(curve));
    place
}

fn finish(mut parts: Parts) -> Parts {
    parts.set_iso();
    parts.set_kinds();
    parts.set_vertices();
    parts.set_tolerances_from_older();
    parts
}

/// The cube from the origin to (1, 1, 1), its faces seen from outside.
fn cube() -> Parts {
    let corner = |i: usize| Point3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2 & 1) as f64);
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut parts = Parts::default();
    let mut edges: Vec<[usize; 2]> = Vec::new();
    let flat = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    for face in faces {
        let [o, x, y] = [corner(face[0]), corner(face[1]), corner(face[3])];
        let plane = Plane::from_axes(o, x - o, y - o).unwrap();
        let surface = PlaneSurface::new(plane, Interval::UNIT, Interval::UNIT).unwrap();
        let trims: Vec<_> = (0..4)
            .map(|k| {
                let ends = [face[k], face[(k + 1) % 4]];
                let known = edges.iter().position(|e| *e == ends || *e == [ends[1], ends[0]]);
                let edge = known.unwrap_or_else(|| {
                    edges.push(ends);
                    add_edge(&mut parts, segment(corner(ends[0]), corner(ends[1])))
                });
                (flat[k], flat[(k + 1) % 4], Some(edge), edges[edge] != ends)
            })
            .collect();
        add_face(&mut parts, surface.into(), &trims);
    }
    finish(parts)
}

/// A cone's side: closed in one direction, a point at one end.
fn cone() -> Parts {
    let mut parts = Parts::default();
    let profile = segment(Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 0.0, 2.0));
    let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
    let turn = Interval::new(0.0, std::f64::consts::TAU);
    let surface = RevolutionSurface::new(profile.clone(), axis, turn).unwrap();
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    let rim = add_edge(&mut parts, circle);
    let seam = add_edge(&mut parts, profile);
    let at = |u: f64, v: f64| Point3::new(u, v, 0.0);
    let full = turn.end;
    add_face(
        &mut parts,
        surface.into(),
        &[
            (at(0.0, 0.0), at(full, 0.0), Some(rim), false),
            (at(full, 0.0), at(full, 1.0), Some(seam), false),
            (at(full, 1.0), at(0.0, 1.0), None, false),
            (at(0.0, 1.0), at(0.0, 0.0), Some(seam), true),
        ],
    );
    finish(parts)
}

#[test]
fn a_cube_is_a_solid_without_faults() {
    let cube = Brep::from_parts(cube()).unwrap();
    assert_eq!(cube.faults(), []);
    assert!(cube.is_valid() && cube.is_solid());
    assert_eq!((cube.vertices().len(), cube.edges().len(), cube.trims().len()), (8, 12, 24));
    assert!(cube.trims().iter().all(|t| t.kind == TrimKind::Mated && matches!(t.iso, Iso::Side(_))));
    for vertex in cube.vertices() {
        assert_eq!((vertex.edges.len(), vertex.tolerance), (3, 0.0));
        assert!([vertex.point.x, vertex.point.y, vertex.point.z].iter().all(|x| *x == 0.0 || *x == 1.0));
    }
    assert_eq!(cube.as_surface(), None);
    assert_eq!(cube.edge_point(0, 0.5), Some(Point3::new(0.0, 0.5, 0.0)));
}

#[test]
fn a_cone_has_a_seam_a_singular_trim_and_a_naked_edge() {
    let cone = Brep::from_parts(cone()).unwrap();
    assert_eq!(cone.faults(), []);
    let kinds: Vec<TrimKind> = cone.trims().iter().map(|t| t.kind).collect();
    assert_eq!(kinds, [TrimKind::Boundary, TrimKind::Seam, TrimKind::Singular, TrimKind::Seam]);
    let sides: Vec<Iso> = cone.trims().iter().map(|t| t.iso).collect();
    assert_eq!(sides, [Side::South, Side::East, Side::North, Side::West].map(Iso::Side));
    assert_eq!(cone.vertices().len(), 2);
    assert!(!cone.is_solid());
    assert!(cone.as_surface().is_some_and(|(_, reversed)| !reversed));
}

/// What must be noticed when one thing of the cube is changed.
#[test]
fn what_is_wrong_is_named() {
    type Change = fn(&mut Parts);
    let cases: [(&str, &str, Change); 14] = [
        ("vertex", "tolerance", |p| p.vertices[2].tolerance = UNSET),
        ("vertex", "does not end here", |p| p.vertices[0].edges.push(11)),
        ("edge", "has no curve", |p| p.curves_3d[4] = None),
        ("edge", "beyond its curve", |p| p.edges[1].part.range = Interval::new(0.0, 2.0)),
        ("edge", "does not increase", |p| p.edges[1].part.domain = Interval::new(1.0, 1.0)),
        ("edge", "one vertex", |p| p.edges[3].vertices[0] = p.edges[3].vertices[1]),
        ("trim", "direction is stated", |p| p.trims[5].iso = Iso::InnerU),
        ("trim", "is mated, but", |p| {
            p.edges[0].trims.truncate(1);
        }),
        ("trim", "away from that of its edge", |p| {
            p.curves_3d[0] = Some(segment(Point3::new(0.0, 0.0, 0.5), Point3::new(0.0, 1.0, 0.5)));
        }),
        ("trim", "its vertices are not", |p| p.trims[0].reversed = !p.trims[0].reversed),
        ("loop", "do not share a vertex", |p| p.loops[0].trims.swap(0, 1)),
        ("loop", "begins at", |p| {
            p.curves_2d[0] = Some(segment(Point3::new(0.1, 0.0, 0.0), Point3::new(1.0, 0.0, 0.0)));
        }),
        ("face", "not outer", |p| p.loops[3].kind = LoopKind::Inner),
        ("face", "no surface", |p| p.surfaces[2] = None),
    ];
    for (part, why, change) in cases {
        let mut parts = cube();
        change(&mut parts);
        let faults = Brep::from_parts(parts).unwrap().faults();
        assert!(
            faults.iter().any(|fault| fault.part == part && fault.why.contains(why)),
            "{part}: {why} is not among {faults:?}"
        );
    }
}

#[test]
fn places_that_do_not_exist_are_refused() {
    type Change = fn(&mut Parts);
    let cases: [Change; 12] = [
        |p| p.vertices[0].edges.push(12),
        |p| p.edges[0].vertices[1] = Some(8),
        |p| p.edges[0].part.curve = Some(12),
        |p| p.edges[0].trims.push(24),
        |p| p.trims[0].part.curve = Some(usize::MAX),
        |p| p.trims[0].edge = Some(12),
        |p| p.trims[0].in_loop = Some(6),
        |p| p.trims[0].vertices[0] = Some(8),
        |p| p.loops[0].trims.push(24),
        |p| p.loops[0].face = Some(6),
        |p| p.faces[0].loops.push(6),
        |p| p.faces[0].surface = Some(6),
    ];
    for (i, change) in cases.into_iter().enumerate() {
        let mut parts = cube();
        change(&mut parts);
        assert!(Brep::from_parts(parts).is_err(), "case {i}");
    }
    let mut parts = cube();
    parts.vertices[0].point = Point3::new(f64::NAN, 0.0, 0.0);
    assert!(Brep::from_parts(parts).is_err());
}

#[test]
fn an_empty_brep_is_no_solid() {
    let empty = Brep::default();
    assert!(!empty.is_solid() && !empty.is_valid());
    assert_eq!(empty.parts().solidity, Solidity::Unknown);
}

/// Vertices do not depend on how the cube lies.
#[test]
fn a_moved_cube_has_moved_vertices() {
    let by = Vector3::new(3.0, -2.0, 0.25);
    let mut parts = cube();
    for curve in parts.curves_3d.iter_mut().flatten() {
        *curve = curve.transformed(&katydid_geometry::Xform::translation(by)).unwrap();
    }
    let before = parts.vertices.clone();
    parts.set_vertices();
    for (a, b) in before.iter().zip(&parts.vertices) {
        assert_eq!(a.point + by, b.point);
        assert_eq!(a.edges, b.edges);
    }
}
