//! Functions called by path, against closed forms: curves and surfaces changed, breps cut, meshes mended.

use std::f64::consts::{PI, TAU};

use katydid_3dm::{CurveForm, Hatch, HatchLoop, Object};
use katydid_compute::wire::{GeometryBase, Read, Subdivision};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Brep, Circle, Curve, Cylinder, Direction, Interval, Line, Mesh, NurbsCurve, NurbsSurface, Plane,
    PlaneSurface, Point2, Point3, PolylineCurve, Sphere, Surface, Vector3,
};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, asked, at, ball, cube, cube_brep, cube_mesh, floor, near, object};

fn circle(plane: Plane, radius: f64) -> Curve {
    Circle::new(plane, radius).unwrap().into()
}

fn area(json: &Json) -> f64 {
    Brep::read(json).unwrap().area_properties(1e-9, || true).unwrap().amount
}

fn areas(json: &Json) -> Vec<f64> {
    let mut areas: Vec<f64> = json.as_array().unwrap().iter().map(area).collect();
    areas.sort_by(f64::total_cmp);
    areas
}

fn close(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{found} is not {wanted}");
}

#[test]
fn hatches_and_sums_of_volumes_are_measured() {
    let form = |radius: f64| CurveForm::of(&circle(Plane::XY, radius), 2);
    let plane = Plane::YZ.with_origin(Point3::new(3.0, 1.0, 2.0));
    let hatch = Hatch {
        plane: plane.into(),
        scale: 1.0,
        rotation: 0.0,
        pattern: 0,
        loops: vec![
            HatchLoop { outer: true, curve: form(5.0) },
            HatchLoop { outer: false, curve: form(2.0) },
        ],
        base_point: Point2::ORIGIN,
    };
    let sent = object(&GeometryBase::Other(Box::new(Object::Hatch(Box::new(hatch)))));
    let found = ask("areamassproperties/compute-hatch", json!([sent]));
    near(&found["Area"], 21.0 * PI);
    at(&found["Centroid"], [3.0, 1.0, 2.0]);
    assert!(asked("areamassproperties/compute-hatch", &json!([cube_brep()])).is_err());
    let of = |brep: Json| ask("volumemassproperties/compute-brep", json!([brep]));
    let (a, b) = (of(object(&ball(0.0, 1.0))), of(object(&ball(10.0, 1.0))));
    let sum = ask("volumemassproperties/sum-volumemassproperties_volumemassproperties", json!([a, b]));
    assert_eq!(sum[0], true);
    near(&sum[1]["Volume"], 8.0 / 3.0 * PI);
    at(&sum[1]["Centroid"], [5.0, 0.0, 0.0]);
    // About the middle each ball has 2/5 of its volume, and its volume times the square of 5.
    let one = 4.0 / 3.0 * PI;
    near(&sum[1]["CentroidCoordinatesMomentsOfInertia"]["X"], 2.0 * one * 0.4);
    near(&sum[1]["CentroidCoordinatesMomentsOfInertia"]["Y"], 2.0 * one * (0.4 + 25.0));
}

#[test]
fn curves_go_through_edit_points_and_ends() {
    let corners: Vec<Point3> = (0..5).map(|k| Point3::new(f64::from(k), f64::from(k % 2), 0.0)).collect();
    let curve = Curve::from(NurbsCurve::clamped_uniform(3, &corners).unwrap());
    let points = ask("nurbscurve/grevillepoints-nurbscurve_bool", json!([object(&curve), false]));
    let lifted: Vec<Point3> =
        points.as_array().unwrap().iter().map(|p| Point3::read(p).unwrap() + Vector3::Z * 2.0).collect();
    let sent: Vec<Json> = lifted.iter().map(object).collect();
    let path = "nurbscurve/setgrevillepoints-nurbscurve_point3darray";
    let set = ask(path, json!([object(&curve), sent]));
    assert_eq!(set[0], true);
    let up = ask("nurbscurve/grevillepoints-nurbscurve_bool", json!([set[1], false]));
    for (found, wanted) in up.as_array().unwrap().iter().zip(&lifted) {
        at(found, [wanted.x, wanted.y, wanted.z]);
    }
    assert_eq!(ask(path, json!([object(&curve), sent[1..]]))[0], false);
    // Through other points of a ring, all around: it stays a ring.
    let ring: Vec<Point3> =
        (0..6).map(|k| f64::from(k) * TAU / 6.0).map(|a| Point3::new(a.cos(), a.sin(), 0.0)).collect();
    let ring = Curve::from(NurbsCurve::periodic_uniform(3, &ring).unwrap());
    let points = ask("nurbscurve/grevillepoints-nurbscurve_bool", json!([object(&ring), false]));
    assert_eq!(points.as_array().unwrap().len(), 6);
    let same = ask(path, json!([object(&ring), points]));
    close(Curve::read(&same[1]).unwrap().length(), ring.length(), 1e-9);

    let path =
        "nurbscurve/setendcondition-nurbscurve_bool_nurbscurveendconditiontype_point3d_vector3d_vector3d";
    let set = ask(path, json!([object(&curve), true, 3, [4, 4, 4], [0, 0, 2], [0.5, 0, 7]]));
    assert_eq!(set[0], true);
    let set = Curve::read(&set[1]).unwrap();
    let end = set.domain().end;
    assert!(set.end().distance_to(Point3::new(4.0, 4.0, 4.0)) < 1e-9);
    assert!((set.tangent_at(end).unwrap() - Vector3::Z).length() < 1e-9);
    assert!((set.curvature_at(end) - Vector3::X * 0.5).length() < 1e-9);
    assert!(set.start().distance_to(curve.start()) < 1e-12);
    let path = "nurbscurve/setendcondition-nurbscurve_bool_nurbscurveendconditiontype_point3d_vector3d";
    let set = ask(path, json!([object(&curve), false, "Position", [0, 0, 1], [0, 0, 0]]));
    at(&object(&Curve::read(&set[1]).unwrap().start()), [0.0, 0.0, 1.0]);
    assert_eq!(ask(path, json!([object(&curve), false, 2, [0, 0, 1], [0, 0, 0]]))[0], false);
    assert_eq!(
        Curve::read(&ask(path, json!([object(&curve), true, 0, [9, 9, 9], [1, 0, 0]]))[1]).unwrap(),
        curve
    );
}

#[test]
fn kinks_are_taken_out() {
    let square = json!([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [0, 0, 0]]);
    let drop: Vec<Point3> =
        [(0.0, 0.0), (2.0, 0.0), (4.0, 1.0), (4.0, 3.0), (1.0, 4.0), (-1.0, 2.0), (0.0, 0.0)]
            .map(|(x, y)| Point3::new(x, y, 0.0))
            .to_vec();
    let drop = Curve::from(NurbsCurve::clamped_uniform(3, &drop).unwrap());
    for (path, more) in [
        ("curve/createperiodiccurve-curve", vec![]),
        ("curve/createperiodiccurve-curve_bool", vec![json!(false)]),
    ] {
        let arguments = |first: Json| Json::Array(std::iter::once(first).chain(more.clone()).collect());
        let made = Curve::read(&ask(path, arguments(object(&drop)))).unwrap();
        assert!(made.is_periodic() && made.is_closed());
        // Degree 1 stays as it is.
        assert_eq!(ask(path, arguments(square.clone())), Json::Null);
        assert!(asked(path, &arguments(json!([[0, 0, 0], [1, 1, 1]]))).is_err());
    }
    let top = drop.transformed(&katydid_geometry::Xform::translation(Vector3::Z)).unwrap();
    let tube = NurbsSurface::ruled(&drop.to_nurbs().unwrap(), &top.to_nurbs().unwrap()).unwrap();
    let tube = object(&Surface::from(tube));
    let made = ask("surface/createperiodicsurface-surface_int_bool", json!([tube, 0, false]));
    assert!(Surface::read(&made).unwrap().is_periodic(Direction::U));
    assert!(asked("surface/createperiodicsurface-surface_int", &json!([tube, 1])).is_err());
}

#[test]
fn spirals_wind_about_rails() {
    let path = "nurbscurve/createspiral-curve_double_double_point3d_double_double_double_double_int";
    let rail = Curve::from(Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 10.0)));
    let range = rail.domain();
    let helix = |pitch: f64, turns: f64| {
        let arguments = json!([object(&rail), range.start, range.end, [3, 0, 0], pitch, turns, 3, 3, 24]);
        Curve::read(&ask(path, arguments)).unwrap()
    };
    for made in [helix(0.0, 5.0), helix(2.0, 0.0)] {
        close(made.length(), (5.0 * TAU * 3.0_f64).hypot(10.0), 0.02);
        assert!(made.start().distance_to(Point3::new(3.0, 0.0, 0.0)) < 1e-9);
        // Counter-clockwise: a quarter of a turn on.
        let quarter = made.point_at(made.domain().at(0.05));
        assert!(quarter.distance_to(Point3::new(0.0, 3.0, 0.5)) < 0.01, "{quarter:?}");
    }
    let back = helix(0.0, -5.0);
    assert!(back.point_at(back.domain().at(0.05)).distance_to(Point3::new(0.0, -3.0, 0.5)) < 0.01);
    assert!(asked(path, &json!([object(&rail), 0, 1, [3, 0, 0], 0, 0, 3, 3, 24])).is_err());
    assert!(asked(path, &json!([object(&rail), 0, 1, [3, 0, 0], 0, 1, 3, 3, 4])).is_err());
}

#[test]
fn curves_lie_on_and_above_surfaces() {
    let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 8.0)).unwrap().into();
    let [u, v] = Direction::BOTH.map(|along| tube.domain(along));
    // A straight line over the domain is a helix.
    let flat = json!([[u.start, v.start, 0], [u.at(0.5), v.end, 0]]);
    let helix = ask("surface/pushup-surface_curve_double", json!([object(&tube), flat, 1e-5]));
    close(Curve::read(&helix).unwrap().length(), (PI * 2.0_f64).hypot(8.0), 1e-3);
    let part = json!({ "T0": 0.0, "T1": 0.5 });
    let line = object(
        &Curve::from(Line::new(Point3::new(u.start, v.start, 0.0), Point3::new(u.start, v.end, 0.0)))
            .with_domain(Interval::new(0.0, 1.0))
            .unwrap(),
    );
    let half = ask("surface/pushup-surface_curve_double_interval", json!([object(&tube), line, 1e-5, part]));
    close(Curve::read(&half).unwrap().length(), 4.0, 1e-9);
    let out = json!([[u.start - 9.0, v.start, 0], [u.end, v.end, 0]]);
    assert!(asked("surface/pushup-surface_curve_double", &json!([object(&tube), out, 1e-5])).is_err());

    let ring = circle(Plane::XY.with_origin(Point3::new(0.0, 0.0, 3.0)), 2.0);
    let normal = tube.normal_at(u.start, v.at(0.5)).unwrap().dot(Vector3::X);
    let wider = ask(
        "curve/offsetnormaltosurface-curve_surface_double",
        json!([object(&ring), object(&tube), normal]),
    );
    close(Curve::read(&wider).unwrap().length(), TAU * 3.0, 1e-2);

    for surface in ["surface", "brepface"] {
        let path = format!("curve/offsetonsurface-curve_{surface}_point2d_double");
        let through = json!([u.at(0.3), v.at(0.75)]);
        let made = ask(&path, json!([object(&ring), object(&tube), through, 1e-4]));
        let made: Vec<Curve> = Vec::read(&made).unwrap();
        close(made[0].length(), TAU * 2.0, 1e-2);
        close(made[0].start().z, tube.point_at(u.at(0.3), v.at(0.75)).z, 1e-3);
    }
}

#[test]
fn surfaces_are_changed() {
    let round: Surface = Sphere::around(Point3::ORIGIN, 5.0).unwrap().to_revolution().into();
    let [u, v] = Direction::BOTH.map(|along| round.domain(along));
    let part =
        round.sub_surface(Interval::new(u.at(0.1), u.at(0.4)), Interval::new(v.at(0.3), v.at(0.8))).unwrap();
    let fit = ask("surface/fit-surface_int_int_double", json!([object(&part), 3, 5, 1e-4]));
    let fit = Surface::read(&fit).unwrap();
    let [u, v] = Direction::BOTH.map(|along| part.domain(along));
    for (x, y) in [(0.0, 0.0), (0.33, 0.71), (0.5, 0.02), (1.0, 0.6)] {
        let p = fit.point_at(u.at(x), v.at(y));
        assert!(p.distance_to(part.point_at(u.at(x), v.at(y))) < 1e-4);
        close(p.to_vector().length(), 5.0, 1e-4);
    }
    let path = "surface/variableoffset-surface_double_double_double_double_double";
    let made = Surface::read(&ask(path, json!([object(&part), 0.1, 0.2, 0.3, 0.4, 1e-4]))).unwrap();
    for (x, y, d) in [(0.0, 0.0, 0.1), (0.0, 1.0, 0.2), (1.0, 0.0, 0.3), (1.0, 1.0, 0.4)] {
        let far = made.point_at(u.at(x), v.at(y)).distance_to(part.point_at(u.at(x), v.at(y)));
        close(far, d, 1e-4);
    }
    // A flat net with one point raised: it sinks, and each of its neighbours rises by a quarter.
    let net: Vec<Point3> = (0..25)
        .map(|k| Point3::new(f64::from(k / 5), f64::from(k % 5), if k == 12 { 1.0 } else { 0.0 }))
        .collect();
    let bump: Surface = NurbsSurface::clamped_uniform([3, 3], [5, 5], &net).unwrap().into();
    let path = "surface/smooth-surface_double_bool_bool_bool_bool_smoothingcoordinatesystem";
    let smooth = ask(path, json!([object(&bump), 1.0, false, false, true, true, 0]));
    let smooth = Surface::read(&smooth).unwrap().to_nurbs().unwrap();
    assert_eq!(smooth.control_point(2, 2), Some(Point3::new(2.0, 2.0, 0.0)));
    assert_eq!(smooth.control_point(1, 2), Some(Point3::new(1.0, 2.0, 0.25)));
    assert_eq!(smooth.control_point(0, 2), Some(Point3::new(0.0, 2.0, 0.0)));
    let path = "surface/smooth-surface_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane";
    let along = ask(path, json!([object(&bump), 0.5, true, true, true, false, 0, null]));
    let along = Surface::read(&along).unwrap().to_nurbs().unwrap();
    assert_eq!(along.control_point(2, 2), Some(Point3::new(2.0, 2.0, 0.5)));
    assert_eq!(along.control_point(0, 0), Some(Point3::new(0.25, 0.25, 0.0)));
}

#[test]
fn breps_are_cut_and_parted() {
    let plane = object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0)));
    let below = ask("brep/trim-brep_plane_double", json!([cube_brep(), plane, 0.001]));
    close(areas(&below)[0], 8.0, 1e-6);
    let far = object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 9.0)));
    close(areas(&ask("brep/trim-brep_plane_double", json!([cube_brep(), far, 0.001])))[0], 22.0, 1e-6);
    let low = object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, -9.0)));
    assert_eq!(ask("brep/trim-brep_plane_double", json!([cube_brep(), low, 0.001])), json!([]));
    let disc = circle(Plane::XY.with_origin(Point3::new(0.5, 1.0, 3.0)), 0.25);
    let path = "brep/split-brep_curvearray_double";
    let parts = areas(&ask(path, json!([cube_brep(), [object(&disc)], 0.001])));
    assert_eq!(parts.len(), 2);
    close(parts[0], PI / 16.0, 1e-6);
    close(parts[1], 22.0 - PI / 16.0, 1e-6);
    let away = circle(Plane::XY.with_origin(Point3::new(0.5, 1.0, 7.0)), 0.25);
    assert_eq!(ask(path, json!([cube_brep(), [object(&away)], 0.001])), json!([]));

    let apart = ask("brep/unjoinedges-brep_intarray", json!([cube_brep(), (0..12).collect::<Vec<_>>()]));
    assert_eq!(areas(&apart).len(), 6);
    let one = ask("brep/unjoinedges-brep_intarray", json!([cube_brep(), [3]]));
    let open = Brep::read(&one[0]).unwrap();
    let naked = open.naked_edges();
    assert_eq!(naked.len(), 2);
    let path = "brep/joinedges-brep_int_int_double_bool";
    let joined = ask(path, json!([one[0], naked[0], naked[1], 0.001, true]));
    assert_eq!(joined[0], true);
    assert!(Brep::read(&joined[1]).unwrap().is_solid());
    assert_eq!(ask(path, json!([cube_brep(), 0, 1, 0.001, true]))[0], false);
    // Two floors side by side.
    let next: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(4.0, 6.0), Interval::new(0.0, 3.0)).unwrap().into();
    let (a, b) = (Brep::from_surface(floor()).unwrap(), Brep::from_surface(next).unwrap());
    let side = |brep: &Brep| {
        (0..4)
            .find(|e| {
                (brep.edge_as_curve(*e).unwrap().unwrap().bounding_box().diagonal().x).abs() < 1e-9
                    && (brep.edge_as_curve(*e).unwrap().unwrap().start().x - 4.0).abs() < 1e-9
            })
            .unwrap()
    };
    let path = "brep/createfromjoinededges-brep_int_brep_int_double";
    let joined = ask(path, json!([object(&a), side(&a), object(&b), side(&b), 0.001]));
    close(area(&joined), 18.0, 1e-9);
    assert_eq!(Brep::read(&joined).unwrap().naked_edges().len(), 6);
    assert_eq!(ask(path, json!([object(&a), 0, object(&a), 1, 0.001])), Json::Null);

    let faces = Brep::read(&cube_brep()).unwrap().exploded().unwrap();
    let sent: Vec<Json> = faces.iter().map(object).collect();
    let solid = ask("brep/createsolid-breparray_double", json!([sent, 0.001]));
    assert!(solid.as_array().unwrap().len() == 1 && Brep::read(&solid[0]).unwrap().is_solid());
    assert!(asked("brep/createsolid-breparray_double", &json!([sent[1..], 0.001])).is_err());
    assert_eq!(ask("brep/removefins-brep", json!([cube_brep()]))[0], true);
    assert_eq!(ask("brep/removefins-brep", json!([sent[0]]))[0], false);
}

#[test]
fn balls_have_seams_elsewhere() {
    let ball_cover = ask("brep/createbaseballsphere-point3d_double_double", json!([[1, 2, 3], 2, 0.001]));
    let found = ask("volumemassproperties/compute-brep", json!([ball_cover]));
    close(found["Volume"].as_f64().unwrap(), 32.0 / 3.0 * PI, 1e-2);
    assert_eq!(Brep::read(&ball_cover).unwrap().faces().len(), 2);
    let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 8.0)).unwrap().into();
    let around = if tube.is_closed(Direction::U) { Direction::U } else { Direction::V };
    let quarter = tube.domain(around).at(0.25);
    let path = "brep/changeseam-brepface_int_double_double";
    let made = ask(path, json!([object(&tube), around.index(), quarter, 0.001]));
    close(area(&made), 32.0 * PI, 1e-6);
    let moved = Brep::read(&made).unwrap();
    let surface = moved.face_surface(0).unwrap();
    let corner = Direction::BOTH.map(|along| surface.domain(along).start);
    at(&object(&surface.point_at(corner[0], corner[1])), [0.0, 2.0, 0.0]);
    assert_eq!(ask(path, json!([object(&floor()), 0, 1.0, 0.001])), Json::Null);
}

#[test]
fn meshes_are_mended() {
    let whole = Mesh::read(&cube_mesh()).unwrap();
    let open = object(&whole.part(&whole.faces()[1..]).unwrap());
    let filled = ask("mesh/fillholes-mesh", json!([open]));
    assert_eq!(filled[0], true);
    let filled = Mesh::read(&filled[1]).unwrap();
    assert!(filled.is_closed());
    close(filled.volume(), 6.0, 1e-9);
    assert_eq!(ask("mesh/fillholes-mesh", json!([cube_mesh()]))[0], false);
    let one = Mesh::read(&open).unwrap();
    let mut edges: Vec<([u32; 2], usize)> = one
        .edges()
        .iter()
        .map(|e| ([e.vertices[0].min(e.vertices[1]), e.vertices[0].max(e.vertices[1])], e.faces))
        .collect();
    edges.sort_unstable();
    for (at, (_, faces)) in edges.iter().enumerate() {
        let filled = ask("mesh/filehole-mesh_int", json!([open, at]));
        assert_eq!(filled[0], *faces == 1);
        assert_eq!(Mesh::read(&filled[1]).unwrap().is_closed(), *faces == 1);
    }
    assert!(asked("mesh/filehole-mesh_int", &json!([open, 99])).is_err());

    let sheet = |x: [f64; 2], parts: usize| {
        let sides = katydid_geometry::Rectangle {
            plane: Plane::XY,
            x: Interval::new(x[0], x[1]),
            y: Interval::new(0.0, 1.0),
        };
        Mesh::plane(&sides, 1, parts).unwrap()
    };
    let apart = object(&Mesh::join(&[sheet([0.0, 1.0], 2), sheet([1.01, 2.0], 1)]).unwrap());
    let healed = ask("mesh/healnakededges-mesh_double", json!([apart, 0.05]));
    assert_eq!(healed[0], true);
    let healed = Mesh::read(&healed[1]).unwrap();
    close(healed.area(), 2.0, 1e-9);
    assert_eq!(healed.edges().iter().filter(|e| e.faces == 1).count(), 7);
    let path = "mesh/requireiterativecleanup-mesharray_double";
    assert_eq!(ask(path, json!([[apart], 0.05])), true);
    assert_eq!(ask(path, json!([[cube_mesh()], 0.05])), false);
    let path = "mesh/createfromiterativecleanup-mesharray_double";
    let cleaned = ask(path, json!([[cube_mesh(), apart], 0.05]));
    assert_eq!(cleaned[0], Json::Null);
    close(Mesh::read(&cleaned[1]).unwrap().area(), 2.0, 1e-9);
    assert_eq!(ask(path, json!([[cube_mesh()], 0.05])), Json::Null);

    // The one edge between two faces of a strip: both its ends part.
    let strip = sheet([0.0, 1.0], 2);
    let mut edges: Vec<([u32; 2], usize)> = strip
        .edges()
        .iter()
        .map(|e| ([e.vertices[0].min(e.vertices[1]), e.vertices[0].max(e.vertices[1])], e.faces))
        .collect();
    edges.sort_unstable();
    let inner = edges.iter().position(|(_, faces)| *faces == 2).unwrap();
    let opened = ask("mesh/unweldedge-mesh_intarray_bool", json!([object(&strip), [inner], true]));
    assert_eq!(opened[0], true);
    assert_eq!(Mesh::read(&opened[1]).unwrap().vertices().len(), strip.vertices().len() + 2);
}

#[test]
fn nets_of_subds_are_offset() {
    let mesh = Mesh::cuboid(&cube(), 1, 1, 1).unwrap().welded(PI);
    let net = SubDNet::from_mesh(&mesh, &FromMesh { creases: false, corners: false }).unwrap();
    let sent = object(&Subdivision(SubD::new(net)));
    let distance = 3.0_f64.sqrt();
    let made = ask("subd/offset-subd_double_bool", json!([sent, distance, false]));
    let Subdivision(made) = Subdivision::read(&made).unwrap();
    // At the corner of a box the mean of three unit normals: all sides move out by 1.
    let box_around =
        katydid_geometry::BoundingBox::from_points(made.net().vertices().iter().map(|v| v.point));
    let box_around = box_around.unwrap();
    assert!(box_around.min.distance_to(Point3::new(-1.0, -1.0, -1.0)) < 1e-9);
    assert!(box_around.max.distance_to(Point3::new(2.0, 3.0, 4.0)) < 1e-9);
    assert!(asked("subd/offset-subd_double_bool", &json!([sent, 1.0, true])).is_err());
}

#[test]
fn meshes_are_split() {
    let other = object(
        &Mesh::cuboid(
            &katydid_geometry::BoundingBox {
                min: Point3::new(0.6, 1.1, 2.2),
                max: Point3::new(4.0, 5.0, 6.0),
            }
            .into(),
            1,
            2,
            3,
        )
        .unwrap(),
    );
    let (x, y, z) = (0.4, 0.9, 0.8);
    let inner = x * y + y * z + z * x;
    let areas = |json: &Json| {
        let meshes: Vec<Mesh> = Vec::read(json).unwrap();
        let mut areas: Vec<f64> = meshes.iter().map(Mesh::area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    };
    let long = "mesh/split-mesh_mesharray_double_bool_textlog_cancellationtoken_doublearray";
    let longer = "mesh/split-mesh_mesharray_double_bool_bool_textlog_cancellationtoken_doublearray";
    for (path, more) in [
        ("mesh/split-mesh_mesh", json!([cube_mesh(), other])),
        ("mesh/split-mesh_mesharray", json!([cube_mesh(), [other]])),
        (long, json!([cube_mesh(), [other], 1e-6, false])),
        (longer, json!([cube_mesh(), [other], 1e-6, false, false])),
    ] {
        let found = areas(&ask(path, more));
        assert_eq!(found.len(), 2, "{path}: {found:?}");
        close(found[0], inner, 1e-6);
        close(found[1], 22.0 - inner, 1e-6);
    }
    let ball = object(&Mesh::sphere(&Plane::XY.with_origin(Point3::new(9.0, 0.0, 0.0)), 1.0, 9, 9).unwrap());
    assert_eq!(ask("mesh/split-mesh_mesh", json!([cube_mesh(), ball])), Json::Null);
    assert!(asked(long, &json!([cube_mesh(), [other], 1e-6, true])).is_err());
    let path = "mesh/splitwithprojectedpolylines-mesh_polylinecurvearray_double";
    let ring = PolylineCurve::new(
        [[0.2, 0.3, 3.0], [0.8, 0.4, 3.0], [0.5, 1.5, 3.0], [0.2, 0.3, 3.0]].map(Point3::from).to_vec(),
    )
    .unwrap();
    let found = areas(&ask(path, json!([cube_mesh(), [object(&ring)], 1e-6])));
    let inner = 0.5 * (0.6 * 1.2 - 0.3 * 0.1);
    assert_eq!(found.len(), 2);
    close(found[0], inner, 1e-6);
    close(found[1], 22.0 - inner, 1e-6);
    let away = json!([[0.2, 0.3, 4.0], [0.8, 0.4, 4.0]]);
    assert_eq!(ask(path, json!([cube_mesh(), [away], 1e-6])), Json::Null);
}

#[test]
fn ends_go_on_to_points() {
    let path = "curve/extend-curve_curveend_curveextensionstyle_point3d";
    let line = object(&Curve::from(Line::new(Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0))));
    let to = |end: &str, style: i32, p: Json| ask(path, json!([line, end, style, p]));
    let straight = Curve::read(&to("End", 0, json!([2, 3, 0]))).unwrap();
    close(straight.length(), 5.0, 1e-12);
    // A half circle of radius 2 leads to the other side.
    let round = Curve::read(&to("Start", 1, json!([0, 4, 0]))).unwrap();
    close(round.length(), 2.0 + PI * 2.0, 1e-9);
    assert!(round.start().distance_to(Point3::new(0.0, 4.0, 0.0)) < 1e-9);
    assert!(round.end().distance_to(Point3::new(2.0, 0.0, 0.0)) < 1e-9);
    close(Curve::read(&to("End", 1, json!([7, 0, 0]))).unwrap().length(), 7.0, 1e-9);
    assert_eq!(to("End", 1, json!([-7, 0, 0])), Json::Null);
    assert_eq!(to("Both", 0, json!([7, 0, 0])), Json::Null);
    assert!(asked(path, &json!([line, 2, 2, [7, 1, 0]])).is_err());
}

#[test]
fn pipes_have_walls_that_change_and_breps_are_repaired() {
    let path =
        "brep/createthickpipe-curve_doublearray_doublearray_doublearray_bool_pipecapmode_bool_double_double";
    let rail = object(&Curve::from(Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 6.0))));
    let made = ask(path, json!([rail, [0, 1], [1, 1], [2, 2], false, 1, false, 0.001, 0.01]));
    let made = Brep::read(&made[0]).unwrap();
    assert!(made.is_solid());
    close(made.volume_properties(1e-8, || true).unwrap().amount, 18.0 * PI, 1e-6);
    let none = json!([rail, [0, 1], [1, 2], [2, 2], false, 1, false, 0.001, 0.01]);
    assert!(asked(path, &none).is_err());
    assert!(asked(path, &json!([rail, [0, 1], [1], [2, 2], false, 1, false, 0.001, 0.01])).is_err());
    let repaired = ask("brep/repair-brep_double", json!([cube_brep(), 0.001]));
    assert_eq!(repaired[0], true);
    close(area(&repaired[1]), 22.0, 1e-9);
}

#[test]
fn surfaces_go_on() {
    let path = "surface/extend-surface_isostatus_double_bool";
    for (side, size) in [(3, [6.0, 3.0]), (4, [4.0, 5.0]), (5, [6.0, 3.0]), (6, [4.0, 5.0])] {
        let made = Surface::read(&ask(path, json!([object(&floor()), side, 2.0, side % 2 == 0]))).unwrap();
        close(made.area().unwrap().area, size[0] * size[1], 1e-6);
        let bounds = Brep::from_surface(made).unwrap().bounds_of_faces().unwrap();
        close(bounds.min.x, if side == 3 { -2.0 } else { 0.0 }, 1e-6);
        close(bounds.max.y, if side == 6 { 5.0 } else { 3.0 }, 1e-6);
    }
    // A quarter of a tube goes on round.
    let tube: Surface = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 8.0)).unwrap().into();
    let around = if tube.is_closed(Direction::U) { Direction::U } else { Direction::V };
    let range = tube.domain(around);
    let quarter = tube.trimmed(around, Interval::new(range.start, range.at(0.25))).unwrap();
    let side = if around == Direction::U { "East" } else { "North" };
    let made = Surface::read(&ask(path, json!([object(&quarter), side, 1.0, true]))).unwrap();
    close(made.area().unwrap().area, 8.0 * (PI + 1.0), 1e-5);
    assert!(asked(path, &json!([object(&quarter), side, 1.0, false])).is_err());
    let side = if around == Direction::U { "East" } else { "North" };
    assert_eq!(ask(path, json!([object(&tube), side, 1.0, true])), Json::Null);
    assert!(asked(path, &json!([object(&floor()), 1, 1.0, true])).is_err());
}

#[test]
fn curves_are_made_of_two_views() {
    let path = "curve/createcurve2view-curve_curve_vector3d_vector3d_double_double";
    let slope = object(&Curve::from(Line::new(Point3::new(-3.0, 0.0, -1.5), Point3::new(3.0, 0.0, 1.5))));
    let made = ask(path, json!([object(&circle(Plane::XY, 2.0)), slope, [0, 0, 1], [0, 1, 0], 1e-4, 0.01]));
    let made: Vec<Curve> = Vec::read(&made).unwrap();
    let ellipse = katydid_geometry::Ellipse::new(Plane::XY, 5.0_f64.sqrt(), 2.0).unwrap();
    close(made[0].length(), Curve::from(ellipse.to_nurbs().unwrap()).length(), 1e-2);
}
