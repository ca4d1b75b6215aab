//! Members by name, against closed forms and values worked out by hand.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::cloned_ref_to_slice_refs,
    reason = "a test may fail, and reads plainly"
)]

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_geometry::{Box3, Circle, Interval, Line, Plane, Point3, Rectangle, Sphere, Vector3, Xform};
use katydid_members::{Call, Cause, Fault, Geometry, Host, Value};

/// A host as a script meets it: everything goes through bytes.
struct Script(Host);

impl Script {
    fn new() -> Self {
        Self(Host::new())
    }

    fn outcome(&mut self, member: &str, arguments: &[Value]) -> Value {
        let mut words = vec![Value::from("call"), Value::from(member)];
        words.extend(arguments.iter().cloned());
        let request = self.0.encode(&Value::List(words)).unwrap();
        let answer = self.0.answer(&request).unwrap();
        self.0.decode(&answer).unwrap()
    }

    fn call(&mut self, member: &str, arguments: &[Value]) -> Value {
        match self.outcome(member, arguments) {
            Value::List(mut words) if words.len() == 2 => words.pop().unwrap(),
            other => panic!("{member}: {other:?}"),
        }
    }

    fn number(&mut self, member: &str, arguments: &[Value]) -> f64 {
        match self.call(member, arguments) {
            Value::Number(x) => x,
            #[expect(clippy::cast_precision_loss, reason = "small counts")]
            Value::Int(count) => count as f64,
            other => panic!("{member}: {other:?}"),
        }
    }

    fn error(&mut self, member: &str, arguments: &[Value]) -> (String, String) {
        match self.outcome(member, arguments) {
            Value::Error(kind, message) => (kind, message),
            other => panic!("{member}: {other:?}"),
        }
    }

    /// The object that a handle stands for now.
    fn again(&mut self, held: &Value) -> Value {
        let bytes = self.0.encode(held).unwrap();
        self.0.decode(&bytes).unwrap()
    }
}

fn class(value: &Value) -> &str {
    match value {
        Value::Geometry(Geometry { shape, .. }) => shape.class(),
        other => panic!("{other:?}"),
    }
}

fn point(x: f64, y: f64, z: f64) -> Value {
    Value::Point(Point3::new(x, y, z))
}

fn circle(radius: f64) -> Value {
    Value::Circle(Box::new(Circle::new(Plane::XY, radius).unwrap()))
}

fn cube(side: f64) -> Value {
    let edge = Interval::new(0.0, side);
    Value::Box(Box::new(Box3 { plane: Plane::XY, x: edge, y: edge, z: edge }))
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}

fn near(value: &Value, to: Point3) {
    match value {
        Value::Point(p) => assert!(p.distance_to(to) < 1e-9, "{p:?} is not {to:?}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_table_that_servers_have_answers_scripts() {
    let mut script = Script::new();
    close(script.number("Curve.GetLength", &[circle(2.0)]), 4.0 * PI);
    let line = Value::Line(Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 7.0)));
    close(script.number("Curve.GetLength", &[line]), 7.0);
    close(script.number("Brep.GetVolume", &[cube(3.0)]), 27.0);
}

#[test]
fn derived_classes_have_their_bases_members() {
    let mut script = Script::new();
    let line = script.call("LineCurve.new", &[point(0.0, 0.0, 0.0), point(3.0, 4.0, 0.0)]);
    assert_eq!(class(&line), "LineCurve");
    close(script.number("LineCurve.GetLength", &[line.clone()]), 5.0);
    near(&script.call("LineCurve.get_PointAtMid", &[line]), Point3::new(1.5, 2.0, 0.0));
}

#[test]
fn an_object_changes_under_its_number() {
    let mut script = Script::new();
    let line = script.call("LineCurve.new", &[point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0)]);
    let twin = script.call("LineCurve.Duplicate", &[line.clone()]);
    assert_eq!(script.call("Curve.Reverse", &[line.clone()]), Value::Bool(true));
    let line = script.again(&line);
    near(&script.call("Curve.get_PointAtStart", &[line.clone()]), Point3::new(1.0, 0.0, 0.0));
    near(&script.call("Curve.get_PointAtStart", &[twin]), Point3::ORIGIN);
    script.call("LineCurve.Translate", &[line.clone(), Value::Vector(Vector3::new(0.0, 0.0, 2.0))]);
    near(&script.call("Curve.get_PointAtEnd", &[line]), Point3::new(0.0, 0.0, 2.0));
}

#[test]
fn every_way_to_move_an_object_moves_it() {
    let mut script = Script::new();
    let object = script.call("Point.new", &[point(1.0, 0.0, 0.0)]);
    let z = Value::Vector(Vector3::Z);
    script.call("Point.Rotate", &[object.clone(), Value::Number(FRAC_PI_2), z, point(0.0, 0.0, 0.0)]);
    near(&script.call("Point.get_Location", &[object.clone()]), Point3::new(0.0, 1.0, 0.0));
    script.call("Point.Scale", &[object.clone(), Value::Number(3.0)]);
    near(&script.call("Point.get_Location", &[object.clone()]), Point3::new(0.0, 3.0, 0.0));
    let mirror = Xform::mirror(&Plane::from_normal(Point3::ORIGIN, Vector3::Y).unwrap());
    script.call("Point.Transform", &[object.clone(), Value::Transform(Box::new(mirror))]);
    near(&script.call("Point.get_Location", &[object.clone()]), Point3::new(0.0, -3.0, 0.0));
    script.call("Point.Translate", &[object.clone(), Value::Int(1), Value::Int(2), Value::Int(3)]);
    near(&script.call("Point.get_Location", &[object]), Point3::new(1.0, -1.0, 3.0));
}

#[test]
fn a_circle_is_what_geometry_says() {
    let mut script = Script::new();
    let arc = script.call("ArcCurve.new", &[circle(2.0)]);
    close(script.number("ArcCurve.get_Radius", &[arc.clone()]), 2.0);
    assert_eq!(script.call("Curve.get_IsClosed", &[arc.clone()]), Value::Bool(true));
    let Value::Vector(curvature) = script.call("Curve.CurvatureAt", &[arc.clone(), Value::Number(0.3)])
    else {
        panic!("no vector")
    };
    close(curvature.length(), 0.5);
    assert_eq!(script.call("Curve.IsCircle", &[arc.clone()]), Value::Bool(true));
    assert_eq!(script.call("Curve.IsLinear", &[arc.clone()]), Value::Bool(false));
    // Counter-clockwise is 1 in RhinoCommon.
    let turn = script.call("Curve.ClosedCurveOrientation", &[arc.clone()]);
    assert_eq!(turn, Value::Enum("CurveOrientation".into(), 1));
    let area = script.call("AreaMassProperties.Compute", &[arc.clone()]);
    assert_eq!(class(&area), "AreaMassProperties");
    close(script.number("AreaMassProperties.get_Area", &[area.clone()]), 4.0 * PI);
    near(&script.call("AreaMassProperties.get_Centroid", &[area]), Point3::ORIGIN);
    let parts = script.call("Curve.Split", &[arc, Value::Numbers(vec![1.0, 2.0])]);
    let mut total = 0.0;
    for part in parts.items().unwrap() {
        total += script.number("Curve.GetLength", &[part]);
    }
    close(total, 4.0 * PI);
}

#[test]
fn a_rectangle_of_a_script_is_a_curve() {
    let mut script = Script::new();
    let rectangle = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 4.0), y: Interval::new(0.0, 3.0) };
    let held = Value::Rectangle(Box::new(rectangle));
    close(script.number("Curve.GetLength", &[held.clone()]), 14.0);
    let offset = script.call(
        "Curve.Offset",
        &[
            held,
            Value::Plane(Plane::XY),
            Value::Number(1.0),
            Value::Number(0.001),
            Value::Enum("CurveOffsetCornerStyle".into(), 1),
        ],
    );
    assert_eq!(offset.items().unwrap().len(), 1);
}

#[test]
fn segments_are_appended_to_a_curve_that_was_empty() {
    let mut script = Script::new();
    let poly = script.call("PolyCurve.new", &[]);
    assert_eq!(class(&poly), "PolyCurve");
    let line = |from: (f64, f64), to: (f64, f64)| {
        Value::Line(Line::new(Point3::new(from.0, from.1, 0.0), Point3::new(to.0, to.1, 0.0)))
    };
    for segment in [line((0.0, 0.0), (2.0, 0.0)), line((2.0, 0.0), (2.0, 1.0))] {
        assert_eq!(script.call("PolyCurve.Append", &[poly.clone(), segment]), Value::Bool(true));
    }
    let poly = script.again(&poly);
    close(script.number("PolyCurve.get_SegmentCount", &[poly.clone()]), 2.0);
    close(script.number("Curve.GetLength", &[poly]), 3.0);
}

#[test]
fn a_box_has_its_faces_edges_and_corners() {
    let mut script = Script::new();
    let brep = script.call("Brep.CreateFromBox", &[cube(2.0)]);
    let faces = script.call("Brep.get_Faces", &[brep.clone()]).items().unwrap();
    assert_eq!(faces.len(), 6);
    let mut area = 0.0;
    for face in &faces {
        assert_eq!(class(face), "BrepFace");
        let whole = script.call("BrepFace.DuplicateFace", &[face.clone(), Value::Bool(false)]);
        area += script.number("Brep.GetArea", &[whole]);
        // The normal of a solid's face points out of it: away from the middle.
        let Value::Interval(u) = script.call("BrepFace.Domain", &[face.clone(), Value::Int(0)]) else {
            panic!()
        };
        let Value::Interval(v) = script.call("BrepFace.Domain", &[face.clone(), Value::Int(1)]) else {
            panic!()
        };
        let at = [face.clone(), Value::Number(u.at(0.5)), Value::Number(v.at(0.5))];
        let Value::Point(p) = script.call("BrepFace.PointAt", &at) else { panic!() };
        let Value::Vector(n) = script.call("BrepFace.NormalAt", &at) else { panic!() };
        assert!(n.dot(p - Point3::new(1.0, 1.0, 1.0)) > 0.99);
        assert_eq!(script.call("BrepFace.AdjacentFaces", &[face.clone()]).items().unwrap().len(), 4);
    }
    close(area, 24.0);
    let edges = script.call("Brep.get_Edges", &[brep.clone()]).items().unwrap();
    assert_eq!(edges.len(), 12);
    let mut length = 0.0;
    for edge in edges {
        assert_eq!(script.call("BrepEdge.AdjacentFaces", &[edge.clone()]).items().unwrap().len(), 2);
        length += script.number("BrepEdge.GetLength", &[edge]);
    }
    close(length, 24.0);
    let vertices = script.call("Brep.get_Vertices", &[brep.clone()]).items().unwrap();
    assert_eq!(vertices.len(), 8);
    let corner = script.call("BrepVertex.get_Location", &[vertices.first().unwrap().clone()]);
    assert!(matches!(corner, Value::Point(_)));
    assert_eq!(script.call("Brep.get_IsSolid", &[brep.clone()]), Value::Bool(true));
    assert_eq!(
        script.call("Brep.get_SolidOrientation", &[brep.clone()]),
        Value::Enum("BrepSolidOrientation".into(), 1)
    );
    assert_eq!(
        script.call("Brep.DuplicateNakedEdgeCurves", &[brep, Value::Bool(true), Value::Bool(true)]),
        Value::List(vec![])
    );
}

#[test]
fn eight_corners_are_the_box_that_they_bound() {
    let mut script = Script::new();
    let corners = [
        (0., 0., 0.),
        (2., 0., 0.),
        (2., 3., 0.),
        (0., 3., 0.),
        (0., 0., 4.),
        (2., 0., 4.),
        (2., 3., 4.),
        (0., 3., 4.),
    ];
    let corners = corners.map(|(x, y, z)| Point3::new(x, y, z)).to_vec();
    let brep = script.call("Brep.CreateFromBox", &[Value::Points(corners)]);
    close(script.number("Brep.GetVolume", &[brep.clone()]), 24.0);
    assert_eq!(
        script.call("Brep.get_SolidOrientation", &[brep]),
        Value::Enum("BrepSolidOrientation".into(), 1)
    );
}

#[test]
fn a_sphere_has_its_measures() {
    let mut script = Script::new();
    let sphere = Value::Sphere(Box::new(Sphere::new(Plane::XY, 3.0).unwrap()));
    let brep = script.call("Brep.CreateFromSphere", &[sphere.clone()]);
    assert!((script.number("Brep.GetVolume", &[brep]) - 36.0 * PI).abs() < 1e-6);
    let surface = script.call("NurbsSurface.CreateFromSphere", &[sphere]);
    let Value::Interval(u) = script.call("Surface.Domain", &[surface.clone(), Value::Int(0)]) else {
        panic!()
    };
    let Value::Interval(v) = script.call("Surface.Domain", &[surface.clone(), Value::Int(1)]) else {
        panic!()
    };
    let at = [surface, Value::Number(u.at(0.3)), Value::Number(v.at(0.6))];
    let curvature = script.call("Surface.CurvatureAt", &at);
    close(script.number("SurfaceCurvature.get_Gaussian", &[curvature]), 1.0 / 9.0);
}

#[test]
fn a_sphere_is_singular_at_its_poles_and_known_again() {
    let mut script = Script::new();
    let sphere = Value::Sphere(Box::new(Sphere::new(Plane::XY, 3.0).unwrap()));
    let surface = script.call("RevSurface.CreateFromSphere", &[sphere]);
    let poles: Vec<Value> =
        (0..4).map(|side| script.call("Surface.IsSingular", &[surface.clone(), Value::Int(side)])).collect();
    assert_eq!(poles, [true, false, true, false].map(Value::Bool));
    let Value::List(found) = script.call("Surface.TryGetSphere", &[surface.clone()]) else { panic!() };
    assert!(matches!(&found[1], Value::Sphere(own) if (own.radius - 3.0).abs() < 1e-9));
    assert_eq!(script.call("Surface.IsCylinder", &[surface.clone()]), Value::Bool(false));
    let Value::Interval(u) = script.call("Surface.Domain", &[surface.clone(), Value::Int(0)]) else {
        panic!()
    };
    let Value::Interval(v) = script.call("Surface.Domain", &[surface.clone(), Value::Int(1)]) else {
        panic!()
    };
    let at = [surface.clone(), Value::Number(u.at(0.2)), Value::Number(v.at(0.4)), Value::Int(1)];
    let Value::List(found) = script.call("Surface.Evaluate", &at) else { panic!() };
    let (Value::Point(point), Value::Vectors(partials)) = (&found[1], &found[2]) else { panic!() };
    // The tangents of a sphere are at right angles to its radius.
    assert!(partials.len() == 2 && partials.iter().all(|d| d.dot(point.to_vector()).abs() < 1e-9));
    let nurbs = script.call("Surface.ToNurbsSurface", &[surface]);
    assert_eq!(
        script.call("NurbsSurface.IncreaseDegreeU", &[nurbs.clone(), Value::Int(4)]),
        Value::Bool(true)
    );
    let nurbs = script.again(&nurbs);
    assert_eq!(script.call("Surface.Degree", &[nurbs, Value::Int(0)]), Value::Int(4));
}

#[test]
fn a_corner_is_where_a_polyline_is_not_smooth() {
    let mut script = Script::new();
    let corner = vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 0.0)];
    let polyline = script.call("PolylineCurve.new", &[Value::Points(corner)]);
    let Value::Number(t) = script.call("PolylineCurve.Parameter", &[polyline.clone(), Value::Int(1)]) else {
        panic!()
    };
    let Value::Interval(domain) = script.call("Curve.get_Domain", &[polyline.clone()]) else { panic!() };
    let g1 = Value::Enum("Continuity".into(), 4);
    let next = [polyline.clone(), g1.clone(), Value::Number(domain.start), Value::Number(domain.end)];
    assert_eq!(
        script.call("Curve.GetNextDiscontinuity", &next),
        Value::List(vec![Value::Bool(true), Value::Number(t)])
    );
    assert_eq!(
        script.call("Curve.IsContinuous", &[polyline.clone(), g1, Value::Number(t)]),
        Value::Bool(false)
    );
    let c0 = Value::Enum("Continuity".into(), 1);
    assert_eq!(script.call("Curve.IsContinuous", &[polyline, c0, Value::Number(t)]), Value::Bool(true));
}

#[test]
fn a_mesh_is_written_through_its_lists() {
    let mut script = Script::new();
    let mesh = script.call("Mesh.new", &[]);
    let vertices = script.0.call(&Call::new("Mesh.get_Vertices", vec![mesh.clone()])).unwrap();
    // A list is handed over as its object.
    let vertices = script.again(&vertices);
    for (x, y) in [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)] {
        script.call(
            "MeshVertexList.Add",
            &[vertices.clone(), Value::Number(x), Value::Number(y), Value::Int(0)],
        );
    }
    let faces = script.call("Mesh.get_Faces", &[mesh.clone()]);
    let corners: Vec<Value> = (0..4).map(Value::Int).collect();
    let mut arguments = vec![faces];
    arguments.extend(corners);
    assert_eq!(script.call("MeshFaceList.AddFace", &arguments), Value::Int(0));
    let mesh = script.again(&mesh);
    close(script.number("MeshVertexList.get_Count", &[mesh.clone()]), 4.0);
    let area = script.call("AreaMassProperties.Compute", &[mesh.clone()]);
    close(script.number("AreaMassProperties.get_Area", &[area]), 4.0);
    assert_eq!(
        script.call("MeshFaceList.get_Item", &[mesh.clone(), Value::Int(0)]),
        Value::Face([0, 1, 2, 3])
    );
    script.call("Mesh.Weld", &[mesh.clone(), Value::Number(PI)]);
    let (kind, message) = script.error("MeshVertexList.get_Item", &[mesh, Value::Int(4)]);
    assert_eq!((kind.as_str(), message.as_str()), ("argument", "index is 4, of 4"));
}

#[test]
fn a_list_keeps_its_object() {
    let mut script = Script::new();
    let mesh = script.call("Mesh.new", &[]);
    let bytes = {
        let Value::Geometry(held) = &mesh else { panic!() };
        let request = Value::List(vec!["call".into(), "Mesh.get_Vertices".into(), mesh.clone()]);
        let request = script.0.encode(&request).unwrap();
        let answer = script.0.answer(&request).unwrap();
        let release = Value::List(vec!["release".into(), Value::Ints(vec![i64::try_from(held.id).unwrap()])]);
        let release = script.0.encode(&release).unwrap();
        assert!(script.0.answer(&release).is_none());
        answer
    };
    // The mesh is still there for its list.
    assert!(script.0.decode(&bytes).is_ok());
    let list = Value::List(vec!["release".into(), Value::Ints(vec![2])]);
    let list = script.0.encode(&list).unwrap();
    assert!(script.0.answer(&list).is_none());
    assert_eq!(script.0.handles().len(), 0);
}

#[test]
fn crossings_are_events() {
    let mut script = Script::new();
    let line = Value::Line(Line::new(Point3::new(-5.0, 1.0, 0.0), Point3::new(5.0, 1.0, 0.0)));
    let tolerance = Value::Number(0.001);
    let events = script.call("Intersection.CurveCurve", &[circle(2.0), line, tolerance.clone(), tolerance]);
    let mut xs = Vec::new();
    for event in events.items().unwrap() {
        assert_eq!(class(&event), "IntersectionEvent");
        assert_eq!(script.call("IntersectionEvent.get_IsPoint", &[event.clone()]), Value::Bool(true));
        let Value::Point(p) = script.call("IntersectionEvent.get_PointA", &[event]) else { panic!() };
        xs.push(p.x);
    }
    xs.sort_by(f64::total_cmp);
    let expected = 3f64.sqrt();
    assert!(xs.len() == 2 && (xs[0] + expected).abs() < 1e-6 && (xs[1] - expected).abs() < 1e-6, "{xs:?}");
}

#[test]
fn what_is_wrong_is_said() {
    let mut script = Script::new();
    let (kind, message) = script.error("Curve.Nothing", &[]);
    assert_eq!((kind.as_str(), message.as_str()), ("not_supported", "Curve.Nothing is not supported"));
    let (kind, message) = script.error("Curve.GetLength", &[Value::Int(3)]);
    assert_eq!(kind, "argument");
    assert!(message.contains("this is not a curve"), "{message}");
    assert_eq!(script.error("Curve.PointAt", &[circle(1.0), Value::Number(f64::NAN)]).0, "argument");
    let many = vec![Value::Null; 20];
    assert_eq!(script.error("Curve.GetLength", &many).0, "argument");
    let answer = script.0.answer(b"rubbish").unwrap();
    assert!(matches!(script.0.decode(&answer), Ok(Value::Error(..))));
    let request = script.0.encode(&Value::List(vec!["components".into()])).unwrap();
    let answer = script.0.answer(&request).unwrap();
    assert!(matches!(script.0.decode(&answer), Ok(Value::Error(..))));
    let fault: Fault = script
        .0
        .call(&Call::new("Brep.CreateShell", vec![Value::List(vec![]), Value::Number(0.1)]))
        .unwrap_err();
    assert!(matches!(fault.cause, Cause::NotSupported(_)));
}

#[test]
fn every_signature_names_a_member_and_its_types() {
    let mut script = Script::new();
    let request = script.0.encode(&Value::List(vec!["members".into()])).unwrap();
    let answer = script.0.answer(&request).unwrap();
    let Ok(Value::List(words)) = script.0.decode(&answer) else { panic!() };
    let signatures: Vec<String> =
        words[1].items().unwrap().iter().map(|s| s.as_text().unwrap().to_owned()).collect();
    assert!(signatures.contains(&"Curve.GetLength(this Curve) -> Double".to_owned()));
    assert!(
        signatures.contains(&"Curve.Reverse(this Curve) -> Boolean".to_owned()),
        "{:?}",
        signatures.iter().filter(|s| s.starts_with("Curve.Rev")).collect::<Vec<_>>()
    );
    assert!(signatures.contains(&"LineCurve.new(Point3d from, Point3d to) -> Curve".to_owned()));
    assert!(
        signatures
            .contains(&"Curve.ClosestPoint(this Curve, Point3d testPoint) -> Boolean, Double".to_owned())
    );
    for signature in &signatures {
        let (name, rest) = signature.split_once('(').unwrap();
        assert!(name.contains('.') && rest.contains(") -> "), "{signature}");
        assert!(!rest.contains("Object "), "{signature} does not know a type");
    }
}

/// Any member with any few arguments answers or says what is wrong; it does not panic.
#[test]
fn wild_arguments_are_refused_in_words() {
    let mut script = Script::new();
    let brep = script.call("Brep.CreateFromBox", &[cube(1.0)]);
    let mesh = script.call("Mesh.new", &[]);
    let nan = Value::Number(f64::NAN);
    let wild = [
        Value::Null,
        Value::Int(i64::MAX),
        Value::Int(-1),
        nan,
        Value::List(vec![]),
        Value::from("x"),
        brep,
        mesh,
        circle(1.0),
        Value::Plane(Plane { x_axis: Vector3::ZERO, ..Plane::XY }),
        Value::Points(vec![Point3::ORIGIN; 3]),
    ];
    let names: Vec<String> = katydid_members::geometry::endpoints()
        .members()
        .iter()
        .filter_map(|signature| Some(signature.split_once('(')?.0.to_owned()))
        .collect();
    for name in names {
        for first in &wild {
            let _ = script.outcome(&name, &[first.clone()]);
            for second in &wild[..6] {
                let _ = script.outcome(&name, &[first.clone(), second.clone()]);
            }
        }
    }
}

/// RhinoCommon's way to write a curve: a constructor, then points, weights and knots one by one.
#[test]
fn a_nurbs_curve_is_written_number_by_number() {
    let mut script = Script::new();
    let new = [Value::Int(3), Value::Bool(true), Value::Int(3), Value::Int(3)];
    let arc = script.call("NurbsCurve.new", &new);
    for (i, (x, y)) in [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].into_iter().enumerate() {
        let place = Value::Int(i64::try_from(i).unwrap());
        let point = Value::Point(Point3::new(x, y, 0.0));
        script.call("NurbsCurvePointList.SetPoint", &[arc.clone(), place, point]);
    }
    script
        .call("NurbsCurvePointList.SetWeight", &[arc.clone(), Value::Int(1), Value::Number(0.5_f64.sqrt())]);
    let (kind, why) = script.error("Curve.PointAt", &[arc.clone(), Value::Number(0.5)]);
    assert_eq!(kind, "argument", "its knots are all 0: {why}");
    for (i, knot) in [0.0, 0.0, 1.0, 1.0].into_iter().enumerate() {
        let place = Value::Int(i64::try_from(i).unwrap());
        script.call("NurbsCurveKnotList.set_Item", &[arc.clone(), place, Value::Number(knot)]);
    }
    // A quarter of the unit circle.
    assert!((script.number("Curve.GetLength", &[arc.clone()]) - FRAC_PI_2).abs() < 1e-6);
    let Value::Point(middle) = script.call("Curve.PointAt", &[arc.clone(), Value::Number(0.5)]) else {
        panic!()
    };
    assert!(middle.distance_to(Point3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0)) < 1e-12);
    assert_eq!(script.number("NurbsCurve.get_Order", &[arc.clone()]), 3.0);
    let beyond = [arc, Value::Int(4), Value::Number(2.0)];
    assert_eq!(script.error("NurbsCurveKnotList.set_Item", &beyond).0, "argument");
    let few = [Value::Int(3), Value::Int(3)];
    assert_eq!(script.error("NurbsCurve.new", &few).0, "argument", "degree 3 wants four points");
}

#[test]
fn uniform_knots_are_those_of_open_nurbs() {
    let mut script = Script::new();
    let curve = script.call("NurbsCurve.new", &[Value::Int(3), Value::Int(6)]);
    let spacing = [curve.clone(), Value::Number(0.5)];
    assert_eq!(script.call("NurbsCurveKnotList.CreateUniformKnots", &spacing), Value::Bool(true));
    let knots = script.call("NurbsCurveKnotList.ToArray", &[curve.clone()]);
    assert_eq!(knots, Value::Numbers(vec![0.0, 0.0, 0.0, 0.5, 1.0, 1.5, 1.5, 1.5]));
    script.call("NurbsCurveKnotList.CreatePeriodicKnots", &spacing);
    let knots = script.call("NurbsCurveKnotList.ToArray", &[curve]);
    assert_eq!(knots, Value::Numbers(vec![-1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5]));
}

#[test]
fn trims_know_their_edge_their_face_and_their_kind() {
    let mut script = Script::new();
    let plane = Plane::XY;
    let kinds = |script: &mut Script, brep: &Value| -> Vec<i64> {
        let trims = script.call("Brep.get_Trims", std::slice::from_ref(brep)).items().unwrap();
        trims
            .iter()
            .map(|trim| match script.call("BrepTrim.get_TrimType", std::slice::from_ref(trim)) {
                Value::Enum(name, number) if name == "BrepTrimType" => number,
                other => panic!("{other:?}"),
            })
            .collect()
    };
    let side = Interval::new(0.0, 1.0);
    let cube = Box3 { plane, x: side, y: side, z: side };
    let cube = script.call("Brep.CreateFromBox", &[Value::Box(Box::new(cube))]);
    // Six faces of four trims; each edge is shared.
    assert_eq!(kinds(&mut script, &cube), vec![2; 24]);
    // A sphere's one face: two trims along the seam, two at the poles, which have no edge.
    let sphere = Sphere { plane, radius: 2.0 };
    let sphere = script.call("Brep.CreateFromSphere", &[Value::Sphere(Box::new(sphere))]);
    let mut found = kinds(&mut script, &sphere);
    found.sort_unstable();
    assert_eq!(found, vec![3, 3, 4, 4]);
    let trims = script.call("Brep.get_Trims", &[sphere]).items().unwrap();
    let edges =
        trims.iter().filter(|trim| script.call("BrepTrim.get_Edge", &[(*trim).clone()]) != Value::Null);
    assert_eq!(edges.count(), 2);
}

#[test]
fn point_clouds_and_dots_are_made_asked_and_moved() {
    let mut script = Script::new();
    let points = vec![Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0)];
    let cloud = script.call("PointCloud.new", &[Value::Points(points)]);
    script.call("PointCloud.Add", &[cloud.clone(), Value::Point(Point3::new(0.0, 4.0, 0.0))]);
    assert_eq!(script.number("PointCloud.get_Count", &[cloud.clone()]), 3.0);
    let up = Value::Vector(Vector3::new(0.0, 0.0, 2.0));
    assert_eq!(script.call("GeometryBase.Translate", &[cloud.clone(), up.clone()]), Value::Bool(true));
    let near = [cloud.clone(), Value::Point(Point3::new(2.0, 0.0, 0.0))];
    assert_eq!(script.number("PointCloud.ClosestPoint", &near), 1.0);
    script.call("PointCloud.RemoveAt", &[cloud.clone(), Value::Int(0)]);
    let left = vec![Point3::new(3.0, 0.0, 2.0), Point3::new(0.0, 4.0, 2.0)];
    assert_eq!(script.call("PointCloud.GetPoints", &[cloud.clone()]), Value::Points(left));
    assert_eq!(script.error("PointCloud.RemoveAt", &[cloud, Value::Int(2)]).0, "argument");
    let dot = script.call("TextDot.new", &["a".into(), Value::Point(Point3::ORIGIN)]);
    script.call("GeometryBase.Translate", &[dot.clone(), up]);
    script.call("TextDot.set_Text", &[dot.clone(), "b".into()]);
    assert_eq!(script.call("TextDot.get_Text", &[dot.clone()]), Value::from("b"));
    assert_eq!(script.call("TextDot.get_Point", &[dot]), Value::Point(Point3::new(0.0, 0.0, 2.0)));
}

#[test]
fn geometry_carries_texts_which_changes_keep_and_copies_share() {
    let mut script = Script::new();
    let line = script.call("LineCurve.new", &[point(0.0, 0.0, 0.0), point(3.0, 4.0, 0.0)]);
    let (key, text) = (Value::from("key"), Value::from("text"));
    assert_eq!(
        script.call("LineCurve.SetUserString", &[line.clone(), key.clone(), text.clone()]),
        Value::Bool(true)
    );
    let copy = script.call("LineCurve.Duplicate", &[line.clone()]);
    let up = Value::Vector(Vector3::new(0.0, 0.0, 1.0));
    script.call("LineCurve.Translate", &[line.clone(), up]);
    assert_eq!(script.call("LineCurve.GetUserString", &[line.clone(), key.clone()]), text);
    assert_eq!(script.call("LineCurve.DeleteUserString", &[line.clone(), key.clone()]), Value::Bool(true));
    assert_eq!(script.call("LineCurve.GetUserString", &[line.clone(), key.clone()]), Value::Null);
    assert_eq!(script.number("LineCurve.get_UserStringCount", &[copy.clone()]), 1.0);
    // Null takes the key out; an empty key is none.
    assert_eq!(
        script.call("LineCurve.SetUserString", &[copy.clone(), key.clone(), Value::Null]),
        Value::Bool(true)
    );
    assert_eq!(script.number("LineCurve.get_UserStringCount", &[copy.clone()]), 0.0);
    assert_eq!(script.call("LineCurve.SetUserString", &[copy, Value::from(""), text]), Value::Bool(false));
    // A struct carries none.
    let (kind, _) =
        script.error("Curve.SetUserString", &[circle(1.0), Value::from("key"), Value::from("text")]);
    assert_eq!(kind, "argument");
}

/// A surface is set point by point: it is none until its knots rise.
#[test]
fn a_surface_is_written_point_by_point() {
    let mut script = Script::new();
    let int = Value::Int;
    let made =
        script.call("NurbsSurface.Create", &[int(3), Value::Bool(true), int(3), int(2), int(3), int(2)]);
    assert_eq!(class(&made), "NurbsSurface");
    assert_eq!(script.call("NurbsSurface.get_IsValid", &[made.clone()]), Value::Bool(false));
    // A quarter of a cylinder of radius 2 and height 3: the middle weight is the cosine of 45°.
    let w = std::f64::consts::FRAC_1_SQRT_2;
    for (u, (x, y, weight)) in [(2.0, 0.0, 1.0), (2.0, 2.0, w), (0.0, 2.0, 1.0)].into_iter().enumerate() {
        for v in 0..2 {
            let u = i64::try_from(u).unwrap();
            let at = point(x, y, if v == 0 { 0.0 } else { 3.0 });
            let arguments = [made.clone(), int(u), int(v), at, Value::Number(weight)];
            assert_eq!(script.call("NurbsSurfacePointList.SetPoint", &arguments), Value::Bool(true));
        }
    }
    for direction in [0, 1] {
        let arguments = [made.clone(), int(direction), Value::Number(1.0)];
        assert_eq!(script.call("NurbsSurfaceKnotList.CreateUniformKnots", &arguments), Value::Bool(true));
    }
    assert_eq!(script.call("NurbsSurface.get_IsValid", &[made.clone()]), Value::Bool(true));
    let half = [made.clone(), Value::Number(0.5), Value::Number(0.5)];
    near(&script.call("NurbsSurface.PointAt", &half), Point3::new(2.0 * w, 2.0 * w, 1.5));
    let weight = [made.clone(), int(1), int(0)];
    close(script.number("NurbsSurfacePointList.GetWeight", &weight), w);
    let beyond = [made.clone(), int(3), int(0)];
    assert_eq!(script.error("NurbsSurfacePointList.GetWeight", &beyond).0, "argument");
    let too_large = script.error(
        "NurbsSurface.Create",
        &[int(3), Value::Bool(false), int(2), int(2), int(90_000), int(90_000)],
    );
    assert_eq!(too_large.0, "memory");
}

/// A disk of radius 3 with a hole of radius 1, as a hatch.
#[test]
fn hatches_are_made_moved_and_measured() {
    let mut script = Script::new();
    let curves = Value::List(vec![circle(3.0), circle(1.0)]);
    let numbers = [Value::Int(2), Value::Number(0.25), Value::Number(1.5), Value::Number(0.001)];
    let mut arguments = vec![curves];
    arguments.extend(numbers.iter().cloned());
    let Value::List(mut made) = script.call("Hatch.Create", &arguments) else { panic!("a list") };
    assert_eq!(made.len(), 1);
    let hatch = made.pop().unwrap();
    assert_eq!(class(&hatch), "Hatch");
    close(script.number("Hatch.get_PatternRotation", &[hatch.clone()]), 0.25);
    let brep = script.call("Hatch.ToBrep", &[hatch.clone()]);
    assert!((script.number("Brep.GetArea", &[brep]) - 8.0 * PI).abs() < 1e-6);
    let twice = Value::Transform(Box::new(Xform::scale(Point3::ORIGIN, 2.0)));
    assert_eq!(script.call("Hatch.Transform", &[hatch.clone(), twice]), Value::Bool(true));
    close(script.number("Hatch.get_PatternScale", &[hatch.clone()]), 3.0);
    let outer = script.call("Hatch.Get3dCurves", &[hatch.clone(), Value::Bool(true)]);
    let outer = outer.items().unwrap();
    close(script.number("Curve.GetLength", &outer), 12.0 * PI);
    let line = Value::Line(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)));
    let mut open = vec![line];
    open.extend(numbers);
    assert_eq!(script.call("Hatch.Create", &open).items().unwrap().len(), 0);
}

/// The control net of a cube: 8 vertices with three edges and three faces each.
#[test]
fn parts_of_a_subd_know_each_other() {
    let mut script = Script::new();
    let mesh = script.call("Mesh.CreateFromBox", &[cube(2.0), Value::Int(1), Value::Int(1), Value::Int(1)]);
    let subd = script.call("SubD.CreateFromMesh", &[mesh]);
    let vertices = script.call("SubD.get_Vertices", &[subd.clone()]).items().unwrap();
    assert_eq!(vertices.len(), 8);
    for vertex in &vertices {
        assert_eq!(script.number("SubDVertex.get_EdgeCount", &[vertex.clone()]), 3.0);
        assert_eq!(script.number("SubDVertex.get_FaceCount", &[vertex.clone()]), 3.0);
    }
    let edges = script.call("SubD.get_Edges", &[subd.clone()]).items().unwrap();
    assert_eq!(edges.len(), 12);
    let line = script.call("SubDEdge.get_ControlNetLine", &[edges[0].clone()]);
    let Value::Line(line) = line else { panic!("a line") };
    close(line.from.distance_to(line.to), 2.0);
    let faces = script.call("SubD.get_Faces", &[subd.clone()]).items().unwrap();
    let id = script.call("SubDFace.get_Id", &[faces[2].clone()]);
    let found = script.call("SubDFaceList.Find", &[subd.clone(), id]);
    let middle = script.call("SubDFace.get_ControlNetCenterPoint", &[found]);
    let Value::Point(middle) = middle else { panic!("a point") };
    close(middle.distance_to(Point3::new(1.0, 1.0, 1.0)), 1.0);
    assert_eq!(script.call("SubD.get_IsSolid", &[subd]), Value::Bool(true));
}
