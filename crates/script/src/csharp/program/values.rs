//! What scripts give over the types of RhinoCommon, against formulas and values worked by hand.

#![allow(clippy::panic, reason = "a test may fail")]

use super::tests::row;
use super::*;
use katydid_geometry::{Point3, Vector3};

/// The number that a script's output A is.
fn number(body: &str) -> Result<f64, String> {
    let mut program =
        super::tests::program(body, "", "ref object A").map_err(|faults| format!("{faults:?}"))?;
    let called = program.call(&[]);
    match called.row.as_slice() {
        [Value::Number(x)] => Ok(*x),
        [Value::Int(whole)] => Ok(*whole as f64),
        other => Err(format!("{other:?} {:?}", called.messages)),
    }
}

#[test]
fn numbers_follow_their_formulas() {
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI, SQRT_2, TAU};
    let cases: &[(&str, f64)] = &[
        ("A = new Interval(2, 6).ParameterAt(0.25);", 3.0),
        ("A = new Interval(2, 6).NormalizedParameterAt(3);", 0.25),
        ("A = Vector3d.VectorAngle(Vector3d.XAxis, new Vector3d(1, 1, 0));", PI / 4.0),
        ("A = Vector3d.VectorAngle(Vector3d.YAxis, Vector3d.XAxis, Plane.WorldXY);", 1.5 * PI),
        ("Vector3d v = Vector3d.XAxis; v.Rotate(Math.PI / 2, Vector3d.ZAxis); A = v.Y;", 1.0),
        ("A = new Plane(0, 0, 2, -6).DistanceTo(new Point3d(1, 1, 5));", 2.0),
        ("A = new Line(0, 0, 0, 3, 4, 0).Length;", 5.0),
        ("A = new Line(0, 0, 0, 10, 0, 0).ClosestParameter(new Point3d(4, 3, 0));", 0.4),
        ("A = new Circle(2).Circumference;", 2.0 * TAU),
        ("A = new Circle(new Point3d(1, 0, 0), new Point3d(0, 1, 0), new Point3d(-1, 0, 0)).Radius;", 1.0),
        ("A = new Arc(new Point3d(1, 0, 0), new Point3d(0, 1, 0), new Point3d(-1, 0, 0)).Length;", PI),
        ("A = new Arc(Point3d.Origin, Vector3d.XAxis, new Point3d(1, 1, 0)).Length;", FRAC_PI_2),
        ("A = new Rectangle3d(Plane.WorldXY, 3, 4).Area;", 12.0),
        ("A = new Rectangle3d(Plane.WorldXY, 3, 4).PointAt(1.5).Y;", 2.0),
        ("A = new Box(new BoundingBox(0, 0, 0, 1, 2, 3)).Volume;", 6.0),
        ("A = new Sphere(Point3d.Origin, 2).ClosestPoint(new Point3d(9, 0, 0)).X;", 2.0),
        ("A = Transform.Rotation(Math.PI / 2, Point3d.Origin).M10;", 1.0),
        ("A = Transform.Scale(new Point3d(1, 0, 0), 3).Determinant;", 27.0),
        ("A = (Transform.Translation(1, 2, 3) * new Point3d(1, 1, 1)).Z;", 4.0),
        ("A = (Transform.Mirror(Plane.WorldYZ) * new Point3d(2, 1, 0)).X;", -2.0),
        ("Transform t; Transform.Translation(5, 0, 0).TryGetInverse(out t); A = t.M03;", -5.0),
        (
            "Plane p = Plane.WorldXY; p.Origin = new Point3d(7, 0, 0); A = (Transform.PlaneToPlane(Plane.WorldXY, p) * Point3d.Origin).X;",
            7.0,
        ),
        (
            "Polyline p = new Polyline(); p.Add(0, 0, 0); p.Add(3, 0, 0); p.Add(3, 4, 0); A = p.Length + p.PointAt(1.5).Y;",
            9.0,
        ),
        (
            "A = Polyline.CreateInscribedPolygon(new Circle(1), 4)[0].DistanceTo(new Point3d(0, 1, 0));",
            SQRT_2,
        ),
        (
            "Plane p; Plane.FitPlaneToPoints(new Point3d[] { new Point3d(0, 0, 2), new Point3d(4, 0, 2), new Point3d(0, 3, 2), new Point3d(1, 1, 2) }, out p); A = Math.Abs(p.ZAxis.Z) + p.OriginZ;",
            3.0,
        ),
        (
            "double s, t; Rhino.Geometry.Intersect.Intersection.LineLine(new Line(0, 0, 0, 2, 0, 0), new Line(1, -1, 0, 1, 3, 0), out s, out t); A = s * 10 + t;",
            5.25,
        ),
        (
            "double t; Rhino.Geometry.Intersect.Intersection.LinePlane(new Line(0, 0, -1, 0, 0, 3), Plane.WorldXY, out t); A = t;",
            0.25,
        ),
        ("A = new Point3d(1, 2, 3)[2] + new MeshFace(4, 5, 6).D;", 9.0),
        ("Point3d p = new Point3f(1, 2, 2); A = ((Vector3d)p).Length;", 3.0),
        ("Vector3d v = new Vector3d(1, 1, 0); v.Unitize(); A = v.X;", FRAC_1_SQRT_2),
        ("A = BoundingBox.Union(new BoundingBox(0, 0, 0, 1, 1, 1), new Point3d(0, 0, 5)).Diagonal.Z;", 5.0),
        ("A = (int)PointContainment.Coincident + (int)CurveOrientation.Clockwise;", 2.0),
        // Members of the table.
        ("A = new LineCurve(new Line(0, 0, 0, 3, 4, 0)).GetLength();", 5.0),
        (
            "Curve c = new ArcCurve(new Circle(2)); double t; c.ClosestPoint(new Point3d(0, 9, 0), out t, 20.0); A = c.PointAt(t).Y;",
            2.0,
        ),
        (
            "Curve c = new LineCurve(new Line(0, 0, 0, 8, 0, 0)); double t; c.LengthParameter(2, out t); A = c.PointAt(t).X;",
            2.0,
        ),
        ("Arc a; new ArcCurve(new Circle(3)).TryGetArc(out a, 0.01); A = a.Radius;", 3.0),
        ("A = new Circle(1).ToNurbsCurve().Points.Count;", 9.0),
        ("A = (int)new ArcCurve(new Circle(2)).Contains(Point3d.Origin, Plane.WorldXY, 0.001);", 1.0),
        ("A = Brep.CreateFromBox(new Box(new BoundingBox(0, 0, 0, 1, 2, 3))).GetVolume();", 6.0),
        ("A = AreaMassProperties.Compute(new ArcCurve(new Circle(2))).Area;", 2.0 * TAU),
        ("A = new Sphere(Point3d.Origin, 1).ToBrep().GetArea();", 2.0 * TAU),
        (
            "var x = Rhino.Geometry.Intersect.Intersection.CurveCurve(new LineCurve(new Line(0, 0, 0, 4, 0, 0)), new LineCurve(new Line(1, -1, 0, 1, 1, 0)), 0.001, 0.001); A = x.Count * 10 + x[0].PointA.X;",
            11.0,
        ),
        (
            "Brep b = Brep.CreateFromBox(new BoundingBox(0, 0, 0, 1, 1, 1)); int n = 0; foreach (BrepFace f in b.Faces) n++; A = n * 100 + b.Edges.Count + b.Vertices[0].Location.Z;",
            612.0,
        ),
        (
            "Brep b = Brep.CreateFromBox(new BoundingBox(0, 0, 0, 1, 1, 1)); double sum = 0; for (int i = 0; i < b.Faces.Count; i++) sum += b.Faces.ExtractFace(i).GetArea(); A = sum;",
            6.0,
        ),
        // Texts that geometry carries.
        (
            "Mesh m = new Mesh(); m.SetUserString(\"k\", \"v\"); m.SetUserString(\"l\", \"w\"); Mesh n = m.DuplicateMesh(); m.DeleteUserString(\"k\"); A = n.UserStringCount * 10 + m.UserStringCount + (n.GetUserString(\"k\") == \"v\" ? 100 : 0) + (n.GetUserStrings()[\"l\"] == \"w\" ? 1000 : 0) + (m.GetUserString(\"k\") == null ? 10000 : 0);",
            11121.0,
        ),
        (
            "Curve c = new LineCurve(new Line(0, 0, 0, 1, 0, 0)); c.SetUserString(\"k\", \"v\"); c.Translate(1, 0, 0); A = c.PointAtStart.X + c.UserStringCount + c.GetUserStrings().AllKeys.Length;",
            3.0,
        ),
        // Hatches: a ring between circles of radius 2 and 1.
        (
            "Hatch[] h = Hatch.Create(new Curve[] { new ArcCurve(new Circle(2)), new ArcCurve(new Circle(1)) }, 1, 0.5, 2.0, 0.001); A = h.Length * 100 + AreaMassProperties.Compute(h[0]).Area / Math.PI + h[0].PatternScale * 10 + h[0].PatternRotation;",
            123.5,
        ),
        // A bilinear surface by its points and knots: the middle of the square with one corner raised by 4.
        (
            "NurbsSurface s = NurbsSurface.Create(3, false, 2, 2, 2, 2); for (int i = 0; i < 2; i++) for (int j = 0; j < 2; j++) s.Points.SetPoint(i, j, i, j, i * j * 4.0); s.KnotsU.CreateUniformKnots(1.0); s.KnotsV[0] = 0; s.KnotsV[1] = 1; A = s.PointAt(0.5, 0.5).Z + s.Points.GetControlPoint(1, 1).Location.Z * 10 + s.KnotsU.Count * 100 + s.Points.CountV * 1000;",
            2241.0,
        ),
        (
            "PointCloud c = new PointCloud(); c.Add(new Point3d(1, 2, 3)); c.Add(new Point3d(4, 5, 6)); double sum = c[1].Y; foreach (PointCloudItem i in c) sum += i.X * 10; A = sum;",
            55.0,
        ),
        // The SubD of a cube: 8 vertices with 3 edges each, 12 edges, 6 faces of 4 corners.
        (
            "SubD s = SubD.CreateFromMesh(Mesh.CreateFromBox(new Box(new BoundingBox(0, 0, 0, 2, 2, 2)), 1, 1, 1)); int n = 0; foreach (SubDVertex v in s.Vertices) n += v.EdgeCount; foreach (SubDFace f in s.Faces) n += f.VertexCount * 100; A = n + s.Edges.Count * 10000 + s.Faces.Find(1).ControlNetCenterNormal.Length;",
            122425.0,
        ),
    ];
    let mut wrong = Vec::new();
    for (body, expected) in cases {
        match number(body) {
            Ok(given) if (given - expected).abs() < 1e-6 * expected.abs().max(1.0) => {}
            given => wrong.push(format!("{body}: {given:?}, not {expected}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn meshes_have_lists_that_can_be_changed() {
    let body = "Mesh m = new Mesh(); m.Vertices.Add(0, 0, 0); m.Vertices.Add(new Point3d(2, 0, 0)); m.Vertices.Add(0, 2, 0);
        m.Faces.AddFace(0, 1, 2); m.Vertices[2] = new Point3f(0, 3, 0); m.Normals.ComputeNormals();
        Point3d p = m.Vertices[2]; double sum = 0; foreach (Point3f v in m.Vertices) sum += v.X;
        A = p.Y * 100 + m.Faces.Count * 10 + sum; B = m.Faces[0].B + m.Normals[0].Z; C = m;";
    let given = row(body, "ref object A, ref object B, ref object C", &[]);
    assert_eq!(given[..2], [Value::Number(312.0), Value::Number(2.0)]);
    let Value::Geometry(geometry) = &given[2] else { panic!("{given:?}") };
    assert_eq!(geometry.shape.class(), "Mesh");
}

#[test]
fn structs_come_back_as_what_they_are() {
    let body = "A = new Circle(Plane.WorldXY, 2); B = new Arc(Plane.WorldXY, 2, 1); C = new Rectangle3d(Plane.WorldXY, 1, 2);
        D = new Sphere(Point3d.Origin, 3); E = Transform.Identity; F = System.Drawing.Color.FromArgb(1, 2, 3, 4); G = new Guid(\"00010203-0405-0607-0809-0a0b0c0d0e0f\");";
    let parameters =
        "ref object A, ref object B, ref object C, ref object D, ref object E, ref object F, ref object G";
    let given = row(body, parameters, &[]);
    let nouns: Vec<&str> = given.iter().map(Value::noun).collect();
    assert_eq!(
        nouns,
        ["a Circle", "an Arc", "a Rectangle3d", "a Sphere", "a Transform", "a colour", "a Guid"]
    );
    assert_eq!(given[5], Value::Colour(katydid_data::Colour { a: 1, r: 2, g: 3, b: 4 }));
    let Value::Guid(id) = &given[6] else { panic!("{given:?}") };
    assert_eq!(id.to_string(), "00010203-0405-0607-0809-0a0b0c0d0e0f");
}

#[test]
fn values_of_all_kinds_go_in_and_out() {
    let id = uuid::Uuid::from_u128(0x1234);
    let values = [
        Value::Colour(katydid_data::Colour { a: 255, r: 9, g: 8, b: 7 }),
        Value::Guid(id),
        Value::Face([0, 1, 2, 2]),
        Value::Path(vec![0, 3]),
        Value::Time(630_822_816_000_000_000),
        Value::Polyline(vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]),
    ];
    for value in values {
        assert_eq!(row("A = x;", "object x, ref object A", std::slice::from_ref(&value)), [value]);
    }
}

/// The rule of openNURBS for the axes of a plane with a normal: the kernel has it too.
#[test]
fn planes_of_normals_are_those_of_the_kernel() {
    let mut program =
        super::tests::program("A = new Plane(Point3d.Origin, n);", "", "Vector3d n, ref object A")
            .unwrap_or_else(|faults| panic!("{faults:?}"));
    let normals = [
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [1.0, 1.0, 1.0],
        [1.0, 2.0, 3.0],
        [3.0, 2.0, 1.0],
        [2.0, 3.0, 1.0],
        [1.0, 3.0, 2.0],
        [-2.0, 1.0, 3.0],
        [0.5, 0.5, 0.0],
        [0.0, 2.0, 2.0],
    ];
    for [x, y, z] in normals {
        let normal = Vector3::new(x, y, z);
        let called = program.call(&[Value::Vector(normal)]);
        let [Value::Plane(own)] = called.row.as_slice() else { panic!("{called:?}") };
        let kernel = katydid_geometry::Plane::from_normal(Point3::ORIGIN, normal)
            .unwrap_or(katydid_geometry::Plane::XY);
        assert!(
            (own.x_axis - kernel.x_axis).length() < 1e-12 && (own.y_axis - kernel.y_axis).length() < 1e-12,
            "{normal:?}"
        );
    }
}

#[test]
fn what_is_missing_is_the_default_of_its_type() {
    let body = "A = p.X; B = n; C = t == null ? 1 : 2; D = plane.ZAxis.Length;";
    let parameters =
        "Point3d p, double n, string t, Plane plane, ref object A, ref object B, ref object C, ref object D";
    let nulls = vec![Value::Null; 4];
    assert_eq!(
        row(body, parameters, &nulls),
        [0.0, 0.0, 1.0, 0.0].map(|x| if x == 1.0 { Value::Int(1) } else { Value::Number(x) })
    );
}

fn basic(body: &str, parameters: &str, inputs: &[Value]) -> Vec<Value> {
    let script = Script {
        language: ScriptLanguage::VisualBasic,
        text: body.into(),
        additional: String::new(),
        using: String::new(),
        from_wire: false,
    };
    let mut program = Program::new(&script, parameters).unwrap_or_else(|faults| panic!("{body}: {faults:?}"));
    let called = program.call(inputs);
    assert!(called.messages.is_empty(), "{body}: {:?}", called.messages);
    called.row
}

#[test]
fn scripts_in_vb_use_the_same_members() {
    let at = |x: f64, y: f64, z: f64| Value::Point(Point3::new(x, y, z));
    // Members in any case, and `out` parameters without a word: the nearest point of the plane is (2, 3, 0).
    let body = "Dim s As Surface = New PlaneSurface(Plane.WorldXY, New Interval(0, 10), New Interval(0, 10))
        Dim u, v As Double
        s.closestpoint(pt, u, v)
        A = s.PointAt(u, v)
        Dim dir As New Vector3d(pt - s.pointat(u, v))
        B = dir * s.NormalAt(u, v)";
    let given = basic(body, "Point3d @pt, ref object @A, ref object @B", &[at(2.0, 3.0, 4.0)]);
    let [Value::Point(foot), Value::Number(height)] = given.as_slice() else { panic!("{given:?}") };
    assert!(foot.distance_to(Point3::new(2.0, 3.0, 0.0)) < 1e-6 && (height.abs() - 4.0).abs() < 1e-6);
    // Elements of a matrix in parentheses, and a call without them.
    let body = "Dim m As New Transform(1)
        m(0, 3) = 5
        Dim p As New Point3d(1, 1, 1)
        p.transform(m)
        A = p
        Dim v As New Vector3d(3, 0, 0)
        v.Unitize
        B = m(0, 3) + v.X";
    let given = basic(body, "ref object @A, ref object @B", &[]);
    assert_eq!(given, [at(6.0, 1.0, 1.0), Value::Number(6.0)]);
    // Data without a hint: its members are found when it runs.
    assert_eq!(
        basic("A = x + y", "dynamic @x, dynamic @y, ref object @A", &[Value::Number(2.5), Value::Int(4)]),
        [Value::Number(6.5)]
    );
    // Beside a vector it counts as a number, and a text as the number it says: a quarter of the way along.
    for quarter in [Value::Number(0.25), Value::from("0.25")] {
        let inputs = [at(0.0, 0.0, 0.0), at(4.0, 0.0, 8.0), quarter];
        let given =
            basic("D = p + t * (q - p)", "Point3d @p, Point3d @q, dynamic @t, ref object @D", &inputs);
        assert_eq!(given, [at(1.0, 0.0, 2.0)]);
    }
    // Six faces of a cube of edge 2, moved by 1: the numbers of the others stay while one is taken out.
    let body = "Dim area As Double
        Dim i As Int32
        For i = 0 To box.Faces.Count() - 1
          Dim face As Brep = box.Faces.ExtractFace(i)
          area += face.GetArea()
        Next
        A = area";
    let cube = row("A = Brep.CreateFromBox(new BoundingBox(0, 0, 0, 2, 2, 2));", "ref object A", &[]);
    let given = basic(body, "Brep @box, ref object @A", &cube);
    assert!(matches!(given.as_slice(), [Value::Number(sum)] if (sum - 24.0).abs() < 1e-6), "{given:?}");
}

#[test]
fn singular_trims_have_no_edge() {
    // A sphere has a pole at each end of its seam.
    let body = "int n = 0; foreach (BrepTrim t in new Sphere(Point3d.Origin, 2).ToBrep().Trims) if (t.Edge == null) {
            Point2d p = new Point2d(t.PointAtStart); n += Math.Abs(t.Face.PointAt(p.X, p.Y).Z) > 1.999 ? 1 : 100; } A = n;";
    assert_eq!(row(body, "ref object A", &[]), [Value::Int(2)]);
}

#[test]
fn statements_alone_are_a_script() {
    let program_of = |text: &str, parameters: &str| {
        let script = Script {
            language: ScriptLanguage::CSharp,
            text: text.into(),
            additional: String::new(),
            using: String::new(),
            from_wire: false,
        };
        Program::new(&script, parameters)
    };
    let mut program = program_of(
        "using System;\n\na = x + y;\n\nConsole.WriteLine(a);",
        "dynamic @x, dynamic @y, ref object @a",
    )
    .unwrap_or_else(|faults| panic!("{faults:?}"));
    let called = program.call(&[Value::Number(1.5), Value::Int(2)]);
    assert_eq!((called.row, called.printed.trim_end()), (vec![Value::Number(3.5)], "3.5"));
    let faults = program_of("using Some.Plugin;\nvar t = new Thing();", "").err().unwrap_or_default();
    assert!(faults.iter().all(|fault| fault.text.contains("Thing")) && !faults.is_empty(), "{faults:?}");
}
