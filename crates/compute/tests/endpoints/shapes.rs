//! Functions called by path, against closed forms: ends of curves, curves on surfaces, breps and meshes mended.

use std::f64::consts::{PI, TAU};

use katydid_compute::Cause;
use katydid_compute::wire::{Read, Subdivision};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Brep, Circle, Curve, Ellipse, Interval, Line, Mesh, NurbsCurve, Plane, PlaneSurface, Point3,
    PolylineCurve, Sphere, Surface, Tolerance, Vector3, construct,
};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, asked, cube, object};

fn near(x: f64, expected: f64) {
    assert!((x - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{x} is not {expected}");
}

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

fn circle() -> Curve {
    Circle::new(Plane::XY, 5.0).unwrap().into()
}

fn line(a: Point3, b: Point3) -> Curve {
    Line::new(a, b).into()
}

fn volume(brep: &Brep) -> f64 {
    brep.volume_properties(1e-8, || true).unwrap().amount
}

fn area(brep: &Brep) -> f64 {
    brep.area_properties(1e-8, || true).unwrap().amount
}

#[test]
fn places_near_a_parameter() {
    let c = circle();
    let whole = c.domain();
    let perpendicular = |seed: f64| {
        ask("curve/getlocalperppoint-curve_point3d_double_double", json!([object(&c), [10, 0, 0], seed]))
    };
    // The nearest point and the farthest: the one that is nearer to the seed.
    let found = perpendicular(whole.at(0.45));
    assert_eq!(found[0], json!(true));
    assert!(c.point_at(found[1].as_f64().unwrap()).distance_to(p(-5.0, 0.0)) < 1e-9);
    let found = perpendicular(whole.at(0.1));
    assert!(c.point_at(found[1].as_f64().unwrap()).distance_to(p(5.0, 0.0)) < 1e-9);
    // Every place is at right angles to the way from the middle.
    let middle =
        ask("curve/getlocalperppoint-curve_point3d_double_double", json!([object(&c), [0, 0, 0], 3.0]));
    assert_eq!(middle, json!([true, 3.0]));
    let part = json!({ "T0": whole.at(0.1), "T1": whole.at(0.4) });
    let none = ask(
        "curve/getlocalperppoint-curve_point3d_double_interval_double",
        json!([object(&c), [10, 0, 0], 0.0, part]),
    );
    assert_eq!(none[0], json!(false));
    // Tangents from twice the radius touch at 60°.
    let touch = |share: f64| {
        let arguments = json!([object(&c), [10, 0, 0], whole.at(share)]);
        let found = ask("curve/getlocaltangentpoint-curve_point3d_double_double", arguments);
        assert_eq!(found[0], json!(true));
        c.point_at(found[1].as_f64().unwrap())
    };
    let height = 5.0 * (PI / 3.0).sin();
    assert!(touch(0.2).distance_to(p(2.5, height)) < 1e-9);
    assert!(touch(0.8).distance_to(p(2.5, -height)) < 1e-9);
    let inside =
        ask("curve/getlocaltangentpoint-curve_point3d_double_double", json!([object(&c), [1, 0, 0], 0.0]));
    assert_eq!(inside[0], json!(false));
}

#[test]
fn conic_sections_are_told_apart() {
    let kind = |curve: &Curve| ask("curve/getconicsectiontype-curve", json!([object(curve)]));
    assert_eq!(kind(&circle()), 1);
    let ellipse = Ellipse::new(Plane::XY, 4.0, 2.0).unwrap();
    assert_eq!(kind(&ellipse.to_nurbs().unwrap().into()), 2);
    let corners = [p(0.0, 0.0), p(1.0, 2.0), p(3.0, 0.0)];
    assert_eq!(kind(&NurbsCurve::bezier(&corners).unwrap().into()), 4);
    let knots = vec![0.0, 0.0, 1.0, 1.0];
    let pulled = NurbsCurve::with_weights(2, &corners, &[1.0, 3.0, 1.0], knots).unwrap();
    assert_eq!(kind(&pulled.into()), 3);
    assert_eq!(kind(&line(p(0.0, 0.0), p(1.0, 0.0))), 0);
}

#[test]
fn ends_are_blended() {
    let path = "curve/createarcblend-point3d_vector3d_point3d_vector3d_double";
    let half = Curve::read(&ask(path, json!([[0, 0, 0], [0, 1, 0], [4, 0, 0], [0, -1, 0], 1.0]))).unwrap();
    near(half.length(), TAU);
    let arcs = Curve::read(&ask(path, json!([[0, 0, 0], [0, 1, 0], [4, 1, 0], [1, 0, 0], 2.0]))).unwrap();
    assert!(arcs.start().distance_to(p(0.0, 0.0)) < 1e-9 && arcs.end().distance_to(p(4.0, 1.0)) < 1e-9);
    let (a, b) = (line(p(-10.0, 0.0), p(0.0, 0.0)), line(p(5.0, 1.0), p(9.0, 1.0)));
    let path = "curve/createblendcurve-curve_double_bool_blendcontinuity_curve_double_bool_blendcontinuity";
    let ends = (a.domain().end, b.domain().start);
    let blend =
        Curve::read(&ask(path, json!([object(&a), ends.0, false, 1, object(&b), ends.1, true, 2]))).unwrap();
    assert!(blend.start().distance_to(a.end()) < 1e-9 && blend.end().distance_to(b.start()) < 1e-9);
    let domain = blend.domain();
    for t in [domain.start, domain.end] {
        assert!((blend.tangent_at(t).unwrap() - Vector3::X).length() < 1e-9);
    }
    assert!(blend.curvature_on_side(domain.end, true).length() < 1e-9);
    // From the middle of the first, against its direction.
    let middle = a.domain().at(0.5);
    let back =
        Curve::read(&ask(path, json!([object(&a), middle, true, 1, object(&b), ends.1, true, 1]))).unwrap();
    assert!((back.tangent_at(back.domain().start).unwrap() + Vector3::X).length() < 1e-9);
    assert!(asked(path, &json!([object(&a), 99, false, 1, object(&b), 0, true, 1])).is_err());
}

#[test]
fn chains_are_closed_and_cleaned() {
    let path = "curve/makeclosed-curve_double";
    let open = json!([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 0.1, 0]]);
    let closed = ask(path, json!([open, 0.2]));
    assert_eq!(closed[0], json!(true));
    near(Curve::read(&closed[1]).unwrap().length(), 12.0);
    assert_eq!(ask(path, json!([open, 0.05]))[0], json!(false));
    assert_eq!(ask(path, json!([object(&circle()), 0.1]))[0], json!(true));
    assert_eq!(ask(path, json!([object(&line(p(0.0, 0.0), p(1.0, 0.0))), 0.0]))[0], json!(false));
    let bent = [p(0.0, 0.0), p(2.0, 4.0), p(5.0, 3.0), p(4.0, 0.0), p(0.0, -0.5)];
    let bent = NurbsCurve::interpolate(3, &bent, katydid_geometry::KnotSpacing::Chord, None, None).unwrap();
    let closed = ask(path, json!([object(&Curve::from(bent)), 0.0]));
    assert!(Curve::read(&closed[1]).unwrap().is_closed());
    let path = "curve/removeshortsegments-curve_double";
    let rough = json!([[0, 0, 0], [1, 0, 0], [1.001, 0, 0], [2, 1, 0], [2, 1.001, 0]]);
    let clean = ask(path, json!([rough, 0.01]));
    assert_eq!(clean[0], json!(true));
    let clean = PolylineCurve::read(&clean[1]).unwrap();
    assert_eq!(clean.points(), [p(0.0, 0.0), p(1.0, 0.0), p(2.0, 1.001)]);
    assert_eq!(ask(path, json!([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], 0.01]))[0], json!(false));
}

#[test]
fn ends_go_on_until_they_meet_something() {
    let short = object(&line(p(0.0, 0.0), p(1.0, 0.0)));
    let wall = object(&line(p(5.0, -3.0), p(5.0, 3.0)));
    let ball = object(&construct::sphere(&Sphere::around(p(20.0, 0.0), 2.0).unwrap()).unwrap());
    let path = "curve/extendbyline-curve_curveend_geometrybasearray";
    let to = |end: i32, shapes: Json| ask(path, json!([short, end, shapes]));
    near(Curve::read(&to(2, json!([ball, wall]))).unwrap().length(), 5.0);
    near(Curve::read(&to(2, json!([ball]))).unwrap().length(), 18.0);
    near(Curve::read(&to(3, json!([wall]))).unwrap().length(), 5.0);
    assert_eq!(to(1, json!([wall])), Json::Null);
    let quarter = Curve::from(
        katydid_geometry::Arc::new(Circle::new(Plane::XY, 5.0).unwrap(), Interval::new(0.0, PI / 2.0))
            .unwrap(),
    );
    let left = object(&line(p(-9.0, 0.0), p(-1.0, 0.0)));
    let path = "curve/extendbyarc-curve_curveend_geometrybasearray";
    near(Curve::read(&ask(path, json!([object(&quarter), 2, [left]]))).unwrap().length(), 5.0 * PI);
    let path = "curve/extend-curve_curveend_curveextensionstyle_geometrybasearray";
    near(Curve::read(&ask(path, json!([object(&quarter), "End", 2, [left]]))).unwrap().length(), 5.0 * PI);
    assert!(asked(path, &json!([object(&circle()), 2, 0, [left]])).is_err());
}

#[test]
fn curves_lie_on_surfaces() {
    let floor: Surface =
        PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into();
    let places = json!([[0.5, 0.5], [2, 2.5], [3.5, 1]]);
    let path = "surface/interpolatedcurveonsurfaceuv-surface_point2darray_double";
    let flat = Curve::read(&ask(path, json!([object(&floor), places, 0.001]))).unwrap();
    assert!(flat.is_planar(1e-9) && flat.closest_point(p(2.0, 2.5)).unwrap().distance < 1e-3);
    let ball = Sphere::around(Point3::ORIGIN, 5.0).unwrap();
    let round: Surface = ball.to_revolution().into();
    let [u, v] = katydid_geometry::Direction::BOTH.map(|d| round.domain(d));
    let at = |x: f64, y: f64| json!([u.at(x), v.at(y)]);
    let on = |curve: &Curve| {
        let domain = curve.domain();
        (0..=200).all(|k| {
            (curve.point_at(domain.at(f64::from(k) / 200.0)).to_vector().length() - 5.0).abs() < 2e-3
        })
    };
    let given = json!([at(0.1, 0.3), at(0.3, 0.6), at(0.5, 0.4), at(0.6, 0.7)]);
    let curve = Curve::read(&ask(path, json!([object(&round), given, 0.001]))).unwrap();
    assert!(on(&curve));
    let path = "nurbssurface/createcurveonsurface-surface_point2darray_double_bool";
    let ring = json!([at(0.2, 0.3), at(0.5, 0.3), at(0.5, 0.7), at(0.2, 0.7)]);
    let ring = Curve::read(&ask(path, json!([object(&round), ring, 0.001, true]))).unwrap();
    assert!(on(&ring) && ring.is_closed());
    let path = "surface/interpolatedcurveonsurface-surface_point3darray_double";
    let points = json!([[5, 0, 0], [3, 4, 0], [0, 3, 4]]);
    let through = Curve::read(&ask(path, json!([object(&round), points, 0.001]))).unwrap();
    assert!(on(&through) && through.closest_point(p(3.0, 4.0)).unwrap().distance < 2e-3);
}

#[test]
fn breps_are_mended() {
    let solid = construct::box_brep(&cube()).unwrap();
    let loose = Brep::merged(&solid.exploded().unwrap());
    let joined = ask("brep/joinnakededges-brep_double", json!([object(&loose), 0.01]));
    assert_eq!(joined[0], 12);
    near(volume(&Brep::read(&joined[1]).unwrap()), 6.0);
    let border: Vec<Curve> = vec![circle(), Circle::new(Plane::XY, 2.0).unwrap().into()];
    let ring = Brep::planar_faces(&border, &Tolerance::default()).unwrap().breps.remove(0);
    near(area(&ring), PI * 21.0);
    for path in ["brep/removeholes-brep_double", "brepface/removeholes-brepface_double"] {
        near(area(&Brep::read(&ask(path, json!([object(&ring), 0.001]))).unwrap()), PI * 25.0);
        near(
            volume(
                &Brep::read(&ask("brep/removeholes-brep_double", json!([object(&solid), 0.001]))).unwrap(),
            ),
            6.0,
        );
    }
    for (brep, inside) in [(&solid, true), (&ring, false)] {
        let found = ask("brep/getpointinside-brep_double_point3d", json!([object(brep), 0.001]));
        assert_eq!(found[0], json!(inside));
        if inside {
            let point = Point3::read(&found[1]).unwrap();
            assert!(
                [point.x, point.y / 2.0, point.z / 3.0].iter().all(|x| *x > 0.0 && *x < 1.0),
                "{point:?}"
            );
        }
    }
    let intervals =
        ask("brepface/trimawareisointervals-brepface_int_double", json!([object(&solid), 0, 0.5]));
    assert_eq!(intervals.as_array().unwrap().len(), 1, "{intervals}");
}

#[test]
fn pipes_have_walls() {
    let path = "brep/createthickpipe-curve_double_double_bool_pipecapmode_bool_double_double";
    let rail = object(&line(Point3::ORIGIN, Point3::new(0.0, 0.0, 9.0)));
    let made = ask(path, json!([rail, 1, 2, false, 1, false, 0.001, 0.01]));
    near(volume(&Brep::read(&made[0]).unwrap()), 27.0 * PI);
    let ring = ask(path, json!([object(&circle()), 2, 1, false, 0, false, 0.001, 0.01]));
    let ring = Brep::read(&ring[0]).unwrap();
    // Pappus: the area of the section times the way of its middle.
    assert!((volume(&ring) - 3.0 * PI * TAU * 5.0).abs() < 0.1, "{}", volume(&ring));
    assert!(matches!(
        asked(path, &json!([rail, 1, 2, false, 2, false, 0.001, 0.01])).unwrap_err().cause,
        Cause::NotSupported(_)
    ));
    assert!(asked(path, &json!([rail, 1, 1, false, 1, false, 0.001, 0.01])).is_err());
}

#[test]
fn meshes_are_taken_apart_and_turned() {
    let cube = Mesh::cuboid(&cube(), 1, 1, 1).unwrap();
    let mut faces = cube.faces().to_vec();
    faces[2] = faces[2].flipped();
    let wrong = Mesh::new(cube.vertices().to_vec(), faces).unwrap();
    for (path, fixed) in [("mesh/unifynormals-mesh", true), ("mesh/unifynormals-mesh_bool", false)] {
        let found = ask(path, json!([object(&wrong), !fixed]));
        assert_eq!(found[0], 1);
        assert_eq!(Mesh::read(&found[1]).unwrap().is_oriented(), fixed);
    }
    let apart = ask("mesh/explodeatunweldededges-mesh", json!([object(&cube.unwelded(0.1))]));
    assert_eq!(apart.as_array().unwrap().len(), 6);
    let whole = ask("mesh/explodeatunweldededges-mesh", json!([object(&cube.welded(PI))]));
    assert_eq!(whole.as_array().unwrap().len(), 1);
    // What has no result is null.
    let open = object(&cube.part(&cube.faces()[..3]).unwrap());
    assert_eq!(ask("mesh/createbooleanunion-mesharray", json!([[open, object(&cube)]])), Json::Null);
    assert_eq!(
        ask("curve/createbooleanunion-curvearray", json!([[object(&line(p(0.0, 0.0), p(1.0, 1.0)))]])),
        Json::Null
    );
    assert!(asked("mesh/createbooleanunion-mesharray", &json!(["no mesh"])).is_err());
}

#[test]
fn subds_are_breps_and_go_through_points() {
    let mesh = Mesh::cuboid(&cube(), 1, 1, 1).unwrap();
    let net = SubDNet::from_mesh(&mesh, &FromMesh { creases: false, corners: false }).unwrap();
    let subd = SubD::new(net);
    let sent = object(&Subdivision(subd.clone()));
    let brep =
        Brep::read(&ask("subd/tobrep-subd_subdtobrepoptions", json!([sent, {"PackFaces": false}]))).unwrap();
    assert!(brep.naked_edges().is_empty());
    // The surface of a fine mesh of it.
    let fine = subd.limit_mesh(5).unwrap().volume();
    assert!((volume(&brep) - fine).abs() < 5e-3 * fine, "{} {fine}", volume(&brep));
    let points: Vec<Point3> = subd.net().vertices().iter().map(|vertex| vertex.point).collect();
    let wanted: Vec<Json> = points.iter().map(|q| json!([q.x, q.y, q.z])).collect();
    let through = ask("subd/interpolatesurfacepoints-subd_point3darray", json!([sent, wanted]));
    assert_eq!(through[0], json!(true));
    let Subdivision(through) = Subdivision::read(&through[1]).unwrap();
    for (limit, point) in through.vertex_limits().iter().zip(&points) {
        assert!(limit.distance_to(*point) < 1e-5, "{limit:?} is not {point:?}");
    }
    assert!(asked("subd/interpolatesurfacepoints-subd_point3darray", &json!([sent, [[0, 0, 0]]])).is_err());
}

#[test]
fn curves_are_simplified_by_all_options_or_not_at_all() {
    let path = "curve/simplify-curve_curvesimplifyoptions_double_double";
    let chain = json!([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0]]);
    near(Curve::read(&ask(path, json!([chain, 63, 0.01, 0.01]))).unwrap().length(), 3.0);
    for options in [0, 1, 32] {
        let fault = asked(path, &json!([chain, options, 0.01, 0.01])).unwrap_err();
        assert!(matches!(fault.cause, Cause::NotSupported(_)), "{fault}");
    }
}
