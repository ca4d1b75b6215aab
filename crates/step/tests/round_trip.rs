//! What is written is read again: shapes, names, colours, layers, units.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use katydid_geometry::{
    Arc, Brep, Circle, Cone, Curve, Cylinder, Interval, Line, NurbsCurve, Plane, Point3, PolylineCurve,
    Sphere, Surface, Torus, Vector3,
};
use katydid_step::{Document, Part, Shape, read, write};

fn written(document: &Document) -> Vec<u8> {
    let mut file = Vec::new();
    assert_eq!(write(document, &mut file).unwrap(), []);
    file
}

fn again(shape: Shape) -> Shape {
    let document = Document { parts: vec![Part::named("it", shape)], ..Document::default() };
    let read = read(&written(&document)).unwrap();
    assert_eq!(read.left_out, []);
    assert_eq!(read.parts.len(), 1);
    assert_eq!(read.parts[0].name, "it");
    read.parts[0].shape.clone()
}

#[test]
fn whole_surfaces_stay_what_they_are() {
    let plane = Plane::from_normal(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 2.0)).unwrap();
    let surfaces: [(Surface, bool); 4] = [
        (Sphere::new(plane, 5.0).unwrap().into(), true),
        (Torus::new(plane, 5.0, 2.0).unwrap().into(), true),
        (Cylinder::new(plane, 5.0, Interval::new(1.0, 4.0)).unwrap().into(), false),
        (Cone::new(plane, -4.0, 3.0).unwrap().into(), false),
    ];
    for (surface, is_solid) in surfaces {
        let brep = Brep::from_surface(surface).unwrap();
        let Shape::Brep(back) = again(Shape::Brep(brep.clone().into())) else { panic!() };
        assert!(back.is_valid(), "{:?}", back.faults());
        assert_eq!(back.is_solid(), is_solid);
        assert_eq!(back.faces().len(), 1);
        assert_eq!(back.edges().len(), brep.edges().len());
        assert!(matches!(back.face_surface(0), Some(Surface::Revolution(_))));
        let apart = |a: Point3, b: Point3| a.distance_to(b);
        let (ours, theirs) = (brep.bounds_of_faces().unwrap(), back.bounds_of_faces().unwrap());
        assert!(apart(ours.min, theirs.min) < 1e-9 && apart(ours.max, theirs.max) < 1e-9);
    }
}

#[test]
fn curves_and_points_stay_where_they_are() {
    let points: Vec<Point3> = (0..6).map(|k| Point3::new(f64::from(k), f64::from(k * k), 1.0)).collect();
    let arc = Arc::new(Circle::new(Plane::XY, 3.0).unwrap(), Interval::new(-1.0, 2.0)).unwrap();
    let curves: [Curve; 5] = [
        Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0)).into(),
        katydid_geometry::ArcCurve::new(arc).into(),
        Circle::new(Plane::XZ, 2.0).unwrap().into(),
        PolylineCurve::new(points.clone()).unwrap().into(),
        NurbsCurve::clamped_uniform(3, &points).unwrap().into(),
    ];
    for curve in curves {
        let Shape::Curve(back) = again(Shape::Curve(curve.clone())) else { panic!() };
        for k in 0..=20 {
            let x = f64::from(k) / 20.0;
            let (p, q) = (curve.point_at(curve.domain().at(x)), back.point_at(back.domain().at(x)));
            assert!(p.distance_to(q) < 1e-12, "{curve:?}");
        }
    }
    assert_eq!(again(Shape::Points(points.clone())), Shape::Points(points));
}

#[test]
fn names_colours_layers_and_units_are_kept() {
    let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, 1.0).unwrap().into()).unwrap();
    for metres in [1e-3, 1e-2, 1.0, 0.0254, 0.3048, 0.123] {
        let part = |name: &str, shape: Shape| Part {
            name: name.into(),
            layer: Some("outer::bäll".into()),
            colour: Some([10, 200, 30, 128]),
            shape,
        };
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
        let mut curve = part("it's a \\ line 球", Shape::Curve(line));
        curve.colour = Some([1, 2, 3, 255]);
        let parts = vec![part("bäll \"1\"", Shape::Brep(ball.clone().into())), curve];
        let document = Document { metres, parts, ..Document::default() };
        let back = read(&written(&document)).unwrap();
        assert!((back.metres - metres).abs() < 1e-15);
        for (ours, theirs) in document.parts.iter().zip(&back.parts) {
            assert_eq!((&ours.name, &ours.layer, ours.colour), (&theirs.name, &theirs.layer, theirs.colour));
        }
    }
}

#[test]
fn an_empty_document_is_a_file_too() {
    assert_eq!(read(&written(&Document::default())).unwrap().parts, []);
}

#[test]
fn the_same_document_makes_the_same_bytes() {
    let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, 1.0).unwrap().into()).unwrap();
    let document =
        Document { parts: vec![Part::named("a", Shape::Brep(ball.into()))], ..Document::default() };
    assert_eq!(written(&document), written(&document));
}

#[test]
fn curves_that_are_not_finite_are_left_out_by_name() {
    let curves = [
        // The domain is longer than numbers go.
        "#2=B_SPLINE_CURVE_WITH_KNOTS('',1,(#3,#4),.UNSPECIFIED.,.F.,.F.,(2,2),(-1.5E308,1.5E308),.UNSPECIFIED.);",
        // A weight times a coordinate is.
        "#2=(BOUNDED_CURVE()B_SPLINE_CURVE(1,(#3,#4),.UNSPECIFIED.,.F.,.F.)\
         B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.,1.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
         RATIONAL_B_SPLINE_CURVE((1.,1.E300))REPRESENTATION_ITEM(''));",
        // Its far end is.
        "#2=TRIMMED_CURVE('',#6,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(800.)),.T.,.PARAMETER.);\n\
         #6=HYPERBOLA('',#5,1.,1.);\n#5=AXIS2_PLACEMENT_3D('',#3,$,$);",
    ];
    for curve in curves {
        let text = format!(
            "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=SHAPE_REPRESENTATION('',(#2),#9);\n\
             #9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));\n\
             #3=CARTESIAN_POINT('',(0.,0.,0.));\n#4=CARTESIAN_POINT('',(1.E10,0.,0.));\n{curve}\nENDSEC;\nEND-ISO-10303-21;\n"
        );
        let document = read(text.as_bytes()).unwrap();
        assert_eq!(document.parts, [], "{curve}");
        assert!(document.left_out.iter().any(|one| one.why.contains("#2")), "{:?}", document.left_out);
    }
}

#[test]
fn arcs_turned_about_a_chord_have_their_poles_at_the_ends_of_their_profile() {
    // The axis is a chord: the profile ends on it, but its circle goes on to the other side.
    for (start, end) in [(-0.6, 1.4), (5.0, 7.5), (1.0, 4.0)] {
        let arc = Arc::new(Circle::new(Plane::XZ, 3.0).unwrap(), Interval::new(start, end)).unwrap();
        let profile: Curve = katydid_geometry::ArcCurve::new(arc).into();
        let axis = Line::new(profile.start(), profile.end());
        let turn = Interval::new(0.0, std::f64::consts::TAU);
        let surface = katydid_geometry::RevolutionSurface::new(profile, axis, turn).unwrap();
        let brep = Brep::from_surface(surface.into()).unwrap();
        let document = Document {
            parts: vec![Part::named("it", Shape::Brep(brep.clone().into()))],
            ..Document::default()
        };
        let text = String::from_utf8(written(&document)).unwrap();
        assert!(text.contains("TRIMMED_CURVE"), "{text}");
        let Shape::Brep(back) = again(Shape::Brep(brep.clone().into())) else { panic!() };
        assert!(back.is_solid() && back.is_valid(), "{:?}", back.faults());
        let volume = |brep: &Brep| brep.volume_properties(1e-9, || true).unwrap().amount;
        assert!((volume(&back) / volume(&brep) - 1.0).abs() < 1e-9);
    }
}

/// A face over a curve, straight up to a height, between two ends of the curve.
fn wall(keyword: &str, radii: &str, ends: [[f64; 2]; 2], height: f64) -> String {
    let point =
        |id: u32, [x, y]: [f64; 2], z: f64| format!("#{id}=CARTESIAN_POINT('',({x:?},{y:?},{z:?}));\n");
    let corners = [([0.0; 2], 0.0), ([0.0; 2], height), (ends[0], 0.0), (ends[1], 0.0)];
    let mut data: String = (16..).zip(corners).map(|(id, (xy, z))| point(id, xy, z)).collect();
    data += &[(20, ends[1]), (21, ends[0])].map(|(id, xy)| point(id, xy, height)).concat();
    for id in 18..22 {
        data += &format!("#{}=VERTEX_POINT('',#{id});\n", id + 10);
    }
    for (curve, place, origin) in [(10, 14, 16), (11, 15, 17)] {
        data += &format!("#{curve}={keyword}('',#{place},{radii});\n");
        data += &format!("#{place}=AXIS2_PLACEMENT_3D('',#{origin},#13,#22);\n");
    }
    for (id, [from, to, curve]) in (40..).zip([[28, 29, 10], [29, 30, 23], [31, 30, 11], [28, 31, 24]]) {
        data += &format!("#{id}=EDGE_CURVE('',#{from},#{to},#{curve},.T.);\n");
        data +=
            &format!("#{}=ORIENTED_EDGE('',*,*,#{id},{});\n", id + 10, if id < 42 { ".T." } else { ".F." });
    }
    format!(
        "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#2),#9);\n\
         #9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));\n\
         #2=SHELL_BASED_SURFACE_MODEL('',(#3));\n#3=OPEN_SHELL('',(#4));\n#4=ADVANCED_FACE('',(#5),#6,.T.);\n\
         #5=FACE_OUTER_BOUND('',#7,.T.);\n#7=EDGE_LOOP('',(#50,#51,#52,#53));\n\
         #6=SURFACE_OF_LINEAR_EXTRUSION('',#10,#12);\n#12=VECTOR('',#13,1.);\n#13=DIRECTION('',(0.,0.,1.));\n\
         #22=DIRECTION('',(1.,0.,0.));\n#23=LINE('',#19,#12);\n#24=LINE('',#18,#12);\n{data}ENDSEC;\n\
         END-ISO-10303-21;\n"
    )
}

#[test]
fn curves_without_ends_are_extruded_as_far_as_their_face_goes() {
    let area = |text: String| {
        let document = read(text.as_bytes()).unwrap();
        assert_eq!(document.left_out, [], "{text}");
        let Shape::Brep(brep) = &document.parts[0].shape else { panic!() };
        assert!(brep.is_valid(), "{:?}", brep.faults());
        brep.area_properties(1e-10, || true).unwrap().amount
    };
    // The parabola (2t², 4t) between −1 and 1 is 4(√2 + asinh 1) long.
    let parabola = area(wall("PARABOLA", "2.", [[2.0, -4.0], [2.0, 4.0]], 5.0));
    assert!((parabola / (20.0 * (2f64.sqrt() + 1f64.asinh())) - 1.0).abs() < 1e-9, "{parabola}");
    // The hyperbola (3 cosh t, 2 sinh t): its length by Simpson's rule.
    let end = [3.0 * 1f64.cosh(), 2.0 * 1f64.sinh()];
    let hyperbola = area(wall("HYPERBOLA", "3.,2.", [[end[0], -end[1]], end], 5.0));
    let speed = |t: f64| (3.0 * t.sinh()).hypot(2.0 * t.cosh());
    let weights = |k: u32| if k == 0 || k == 1000 { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
    let sum: f64 = (0..=1000).map(|k| weights(k) * speed(f64::from(k) / 500.0 - 1.0)).sum();
    assert!((hyperbola / (5.0 * sum / 1500.0) - 1.0).abs() < 1e-9, "{hyperbola}");
}

#[test]
fn what_counts_as_one_place_is_small_beside_small_shapes() {
    for (radius, wanted) in [(1e-3, 1e-5), (1e-9, 1e-7), (1e6, 1e-3)] {
        let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, radius).unwrap().into()).unwrap();
        let document =
            Document { parts: vec![Part::named("a", Shape::Brep(ball.into()))], ..Document::default() };
        let text = String::from_utf8(written(&document)).unwrap();
        let (_, told) = text.split_once("LENGTH_MEASURE(").unwrap();
        let near: f64 = told.split_once(')').unwrap().0.parse().unwrap();
        assert!(near > 0.1 * wanted && near <= wanted, "{near} beside {radius}");
    }
}
