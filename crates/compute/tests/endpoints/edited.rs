//! Functions that make curves, surfaces and meshes over: smoothed, rebuilt, made alike, taken apart and thickened.

use std::f64::consts::TAU;

use katydid_compute::Cause;
use katydid_compute::wire::Read;
use katydid_geometry::{
    Arc, BoundingBox, Brep, Curve, Direction, Mesh, NurbsCurve, NurbsSurface, Plane, Point3, PolylineCurve,
    SumSurface, Surface, Tolerance, Vector3,
};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, c1, circle, cube_mesh, floor, near, object, refused};

const SMOOTH: &str = "curve/smooth-curve_double_bool_bool_bool_bool_smoothingcoordinatesystem";

fn points(json: &Json) -> Vec<Point3> {
    Curve::read(json).unwrap().to_nurbs().unwrap().control_points()
}

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

#[test]
fn control_points_go_halfway_to_the_middle_of_their_neighbours() {
    let roof = || {
        object(&Curve::from(
            NurbsCurve::new(1, vec![p(0., 0., 0.), p(1., 2., 0.), p(4., 0., 2.)], vec![0., 1., 2.]).unwrap(),
        ))
    };
    let smooth = |strength: f64, axes: [bool; 3], fixed: bool| {
        points(&ask(SMOOTH, json!([roof(), strength, axes[0], axes[1], axes[2], fixed, 0])))
    };
    assert_eq!(smooth(1.0, [true; 3], true), [p(0., 0., 0.), p(2., 0., 1.), p(4., 0., 2.)]);
    assert_eq!(smooth(0.5, [true; 3], true), [p(0., 0., 0.), p(1.5, 1., 0.5), p(4., 0., 2.)]);
    assert_eq!(smooth(0.5, [true; 3], false), [p(0.5, 1., 0.), p(1.5, 1., 0.5), p(2.5, 1., 1.)]);
    assert_eq!(smooth(1.0, [false, true, false], true)[1], p(1., 0., 0.));
    let in_plane = format!("{SMOOTH}_plane");
    let turned = ask(&in_plane, json!([roof(), 1.0, true, false, false, true, 1, object(&Plane::YZ)]));
    assert_eq!(points(&turned)[1], p(1., 0., 0.), "the plane's x is the world's y");
    let own = refused(&in_plane, json!([roof(), 1.0, true, false, false, true, 2, Json::Null]));
    assert!(matches!(own.cause, Cause::NotSupported(_)));
    // A closed curve stays closed and about its centre.
    let round = Curve::read(&ask(SMOOTH, json!([c1(), 0.5, true, true, true, false, 0]))).unwrap();
    assert!(round.is_closed() && round.length() < TAU * 5.0);
    at(&object(&round.area_and_centroid(1e-9).unwrap().1), [0.0; 3]);
}

#[test]
fn what_a_surface_was_it_is_when_rebuilt() {
    let net: Vec<Point3> =
        (0..12).map(|i| p(f64::from(i / 3), f64::from(i % 3), f64::from(i * i % 7))).collect();
    let cubic = Surface::from(NurbsSurface::bezier([4, 3], &net).unwrap());
    let rebuilt = ask("surface/rebuild-surface_int_int_int_int", json!([object(&cubic), 3, 2, 7, 6]));
    let rebuilt = Surface::read(&rebuilt).unwrap();
    let nurbs = rebuilt.to_nurbs().unwrap();
    assert_eq!((nurbs.degrees(), nurbs.counts()), ([3, 2], [7, 6]));
    for k in 0..=10 {
        let (u, v) = (f64::from(k) / 10.0, f64::from(k * 7 % 11) / 10.0);
        assert!(rebuilt.point_at(u, v).distance_to(cubic.point_at(u, v)) < 1e-9);
    }
    let few = ask("surface/rebuild-surface_int_int_int_int", json!([object(&floor()), 3, 3, 2, 2]));
    near(&ask("areamassproperties/compute-surface", json!([few]))["Area"], 12.0);
}

#[test]
fn surfaces_are_made_alike_and_measured() {
    let net: Vec<Point3> = (0..12).map(|i| p(f64::from(i / 3), f64::from(i % 3), f64::from(i % 5))).collect();
    let a = Surface::from(
        NurbsSurface::bezier([4, 3], &net).unwrap().insert_knot(Direction::U, 0.25, 1).unwrap(),
    );
    let b = SumSurface::extrusion(circle(0.0, 2.0), Vector3::new(0.0, 0.0, 3.0)).unwrap();
    let b = Surface::from(b);
    let both = ask(
        "nurbssurface/makecompatible-surface_surface_nurbssurface_nurbssurface",
        json!([object(&a), object(&b)]),
    );
    assert_eq!(both[0], json!(true));
    let [new_a, new_b] = [1, 2].map(|k| Surface::read(&both[k]).unwrap());
    let [na, nb] = [&new_a, &new_b].map(|s| s.to_nurbs().unwrap());
    assert_eq!((na.degrees(), na.counts(), na.is_rational()), (nb.degrees(), nb.counts(), nb.is_rational()));
    for direction in Direction::BOTH {
        assert_eq!(na.knots(direction), nb.knots(direction));
    }
    for k in 0..=8 {
        let (s, t) = (f64::from(k) / 8.0, f64::from(k * 3 % 9) / 8.0);
        for (old, new) in [(&a, &new_a), (&b, &new_b)] {
            let place =
                |of: &Surface| of.point_at(of.domain(Direction::U).at(s), of.domain(Direction::V).at(t));
            assert!(place(old).distance_to(place(new)) < 1e-9, "{s} {t}");
        }
    }
    let size =
        |surface: &Surface| ask("surface/getsurfacesize-surface_double_double", json!([object(surface)]));
    assert_eq!(size(&floor()), json!([true, 4.0, 3.0]));
    let wall = size(&b);
    near(&wall[1], TAU * 2.0);
    near(&wall[2], 3.0);
}

#[test]
fn a_network_finds_out_which_curves_run_which_way() {
    const NETWORK: &str = "nurbssurface/createnetworksurface-curvearray_int_double_double_double_int";
    let along = |y: f64| json!([[0, y, 0], [4, y, 0]]);
    let across = |x: f64| json!([[x, 0, 0], [x, 3, 0]]);
    let curves = json!([along(0.0), across(4.0), across(0.0), along(3.0), across(2.0), along(1.0)]);
    let made = ask(NETWORK, json!([curves, 0, 0.001, 0.001, 0.01]));
    near(&ask("areamassproperties/compute-surface", json!([made[0]]))["Area"], 12.0);
    assert_eq!(made[1], json!(0));
    let lost = json!([along(0.0), across(4.0), across(0.0), along(3.0), along(9.0)]);
    assert!(refused(NETWORK, json!([lost, 0, 0.001, 0.001, 0.01])).message.contains("curve 4"));
    let knot = json!([along(0.0), across(0.0), across(4.0), [[0, 0, 0], [4, 3, 0]]]);
    assert!(refused(NETWORK, json!([knot, 0, 0.001, 0.001, 0.01])).message.contains("two sets"));
}

#[test]
fn a_patch_is_as_flat_as_what_it_goes_through() {
    let path =
        "brep/createpatch-geometrybasearray_surface_int_int_bool_bool_double_double_double_boolarray_double";
    let rim = object(&circle(0.0, 5.0));
    let patch = |trim: bool, start: Json| {
        json!([[rim], start, 10, 10, trim, false, 1, 1, 0, [false, false, false, false], 0.001])
    };
    let made = ask(path, patch(true, Json::Null));
    near(&ask("areamassproperties/compute-brep", json!([made]))["Area"], TAU * 12.5);
    let whole = ask("areamassproperties/compute-brep", json!([ask(path, patch(false, Json::Null))]));
    near(&whole["Area"], 100.0);
    let from = refused(path, patch(true, object(&floor())));
    assert!(matches!(from.cause, Cause::NotSupported(_)));
}

#[test]
fn the_arc_of_a_fillet_alone() {
    let path = "curve/createfillet-curve_curve_double_double_double";
    let lines = json!([[[-4, 0, 0], [4, 0, 0]], [[0, -4, 0], [0, 4, 0]]]);
    for (x, y, centre) in
        [(8.0, 8.0, [1.0, 1.0, 0.0]), (0.0, 8.0, [-1.0, 1.0, 0.0]), (8.0, 0.0, [1.0, -1.0, 0.0])]
    {
        let arc = Arc::read(&ask(path, json!([lines[0], lines[1], 1.0, x, y]))).unwrap();
        assert!(arc.circle.plane.origin.distance_to(Point3::from(centre)) < 1e-9, "{arc:?}");
        near(&json!(arc.circle.radius * arc.angle.length()), TAU / 4.0);
    }
    assert_eq!(ask(path, json!([lines[0], lines[1], 100.0, 8.0, 8.0])), Json::Null);
}

#[test]
fn only_the_holes_that_are_listed_are_closed() {
    let corners = [p(-5., -5., 0.), p(15., -5., 0.), p(15., 5., 0.), p(-5., 5., 0.), p(-5., -5., 0.)];
    let outer = Curve::from(PolylineCurve::new(corners.to_vec()).unwrap());
    let curves = [outer, circle(0.0, 1.0), circle(10.0, 2.0)];
    let brep = Brep::planar_faces(&curves, &Tolerance::default()).unwrap().breps.remove(0);
    let area = |json: &Json| Brep::read(json).unwrap().area_properties(1e-9, || true).unwrap().amount;
    let path = "brep/removeholes-brep_componentindexarray_double";
    let hole =
        brep.loops().iter().position(|own| own.kind == katydid_geometry::brep::LoopKind::Inner).unwrap();
    let index = |at: usize| json!({ "ComponentIndexType": 5, "Index": at });
    let closed = area(&ask(path, json!([object(&brep), [index(hole)], 0.001])));
    let left = 200.0 - closed;
    let [small, large] = [TAU / 2.0, 4.0 * TAU / 2.0];
    assert!((left - small).abs() < 1e-6 || (left - large).abs() < 1e-6, "{left}");
    let both: Vec<Json> = (0..brep.loops().len()).map(index).collect();
    near(&json!(area(&ask(path, json!([object(&brep), both, 0.001])))), 200.0);
    assert!(refused(path, json!([object(&brep), [index(99)], 0.001])).message.contains("no loop 99"));
    let edge = json!({ "ComponentIndexType": 2, "Index": 0 });
    assert!(refused(path, json!([object(&brep), [edge], 0.001])).message.contains("is no loop"));
}

/// Nine vertices and four faces, 4 by 2.
fn sheet(middle: f64) -> Mesh {
    let vertices = (0..9).map(|i| {
        let z = if i == 4 { middle } else { 0.0 };
        p(2.0 * f64::from(i % 3), f64::from(i / 3), z)
    });
    let quad = |i: u32| katydid_geometry::MeshFace::Quad([i, i + 1, i + 4, i + 3]);
    Mesh::new(vertices.collect(), [0, 1, 3, 4].map(quad).to_vec()).unwrap()
}

#[test]
fn faces_part_where_they_are_unwelded() {
    let path = "mesh/unweldvertices-mesh_intarray_bool";
    let vertices = |listed: Json| {
        let reply = ask(path, json!([object(&sheet(1.0)), listed, true]));
        let mesh = Mesh::read(&reply[1]).unwrap();
        near(&json!(mesh.area()), sheet(1.0).area());
        (mesh.vertices().len(), mesh.merged_indices().iter().collect::<std::collections::HashSet<_>>().len())
    };
    assert_eq!(vertices(json!([4])), (12, 9), "four faces meet in the middle");
    assert_eq!(vertices(json!([0])), (9, 9), "a corner has one face");
    assert_eq!(vertices(json!([1, 3, 4, 5, 7])), (16, 9));
    assert!(refused(path, json!([object(&sheet(0.0)), [9], true])).message.contains("9 is not 0 to 8"));
}

#[test]
fn a_sheet_is_drawn_along_a_direction() {
    let path = "mesh/offset-mesh_double_bool_vector3d_intarray";
    for (direction, height) in
        [([0.0, 0.0, 3.0], 0.5), ([1.0, 0.0, 1.0], 0.5_f64.sqrt() / 2.0), ([0.0, 0.0, -1.0], 0.5)]
    {
        let reply = ask(path, json!([object(&sheet(0.0)), 0.5, true, direction]));
        let mesh = Mesh::read(&reply[0]).unwrap();
        assert!(mesh.is_closed() && mesh.is_oriented(), "{direction:?}");
        near(&json!(mesh.volume()), 8.0 * height);
        let walls: Vec<usize> =
            Vec::<i32>::read(&reply[1]).unwrap().into_iter().map(|i| i as usize).collect();
        assert_eq!(walls, (8..16).collect::<Vec<_>>(), "a wall at each edge of the rim");
    }
    let moved =
        ask("mesh/offset-mesh_double_bool_vector3d", json!([object(&sheet(0.0)), 0.5, false, [0, 2, 0]]));
    let moved = Mesh::read(&moved).unwrap();
    assert_eq!((moved.faces().len(), moved.vertices()[0]), (4, p(0.0, 0.5, 0.0)));
    // A closed mesh has no rim: there are two shells.
    let shells = Mesh::read(&ask(path, json!([cube_mesh(), 9.0, true, [1, 0, 0]]))[0]).unwrap();
    assert_eq!(shells.pieces().unwrap().len(), 2);
    assert!(refused(path, json!([object(&sheet(0.0)), 0.5, true, [0, 0, 0]])).message.contains("no length"));
}

#[test]
fn solids_are_split_by_solids() {
    let cube = |x: f64| {
        let corners = BoundingBox { min: p(x, 0.0, 0.0), max: p(x + 2.0, 2.0, 2.0) };
        Mesh::cuboid(&corners.into(), 1, 1, 1).unwrap()
    };
    let path = "mesh/createbooleansplit-mesharray_mesharray";
    let volumes = |x: f64| {
        let pieces =
            Vec::<Mesh>::read(&ask(path, json!([[object(&cube(0.0))], [object(&cube(x))]]))).unwrap();
        pieces.iter().map(Mesh::volume).collect::<Vec<f64>>()
    };
    let [left, shared] = volumes(1.5)[..] else { panic!("two pieces") };
    assert!((left - 6.0).abs() < 1e-6 && (shared - 2.0).abs() < 1e-6, "{left} {shared}");
    let [whole] = volumes(5.0)[..] else { panic!("one piece") };
    assert!((whole - 8.0).abs() < 1e-6);
    let open = refused(path, json!([[object(&sheet(0.0))], [object(&cube(0.0))]]));
    assert!(open.message.contains("mesh 0 cannot be cut"), "{open}");
}

#[test]
fn only_the_vertices_that_are_listed_are_smoothed() {
    let path = "mesh/smooth-mesh_intarray_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane";
    let middle = |listed: Json, axes: [bool; 3]| {
        let reply = ask(
            path,
            json!([object(&sheet(1.0)), listed, 0.5, axes[0], axes[1], axes[2], false, 0, Json::Null]),
        );
        Mesh::read(&reply[1]).unwrap().vertices().to_vec()
    };
    assert_eq!(middle(json!([4]), [true; 3])[4], p(2.0, 1.0, 0.5));
    assert_eq!(middle(json!([4]), [true; 3])[0], p(0.0, 0.0, 0.0));
    assert_eq!(middle(json!([4]), [true, true, false])[4], p(2.0, 1.0, 1.0));
    assert_eq!(middle(json!([0]), [true; 3])[4], p(2.0, 1.0, 1.0));
    let none = refused(path, json!([object(&sheet(1.0)), [9], 1, true, true, true, false, 0, Json::Null]));
    assert!(none.message.contains("no vertex 9"));
}
