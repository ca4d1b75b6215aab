use katydid_geometry::{Curve, Interval, Line, MeshFace, Plane, Point3, Vector3};

use super::*;
use crate::{Colour, Domain2, text};

fn to(v: Value, kind: Kind) -> Option<Value> {
    value(&v, kind, &Rules::default())
}

#[test]
fn numbers_round_to_integers_with_halves_to_even() {
    for (x, i) in [(2.5, 2), (3.5, 4), (-0.5, 0), (2.4, 2), (-2.6, -3)] {
        assert_eq!(to(Value::Number(x), Kind::Integer), Some(Value::Integer(i)));
    }
    assert_eq!(to(Value::Number(3e9), Kind::Integer), None);
    assert_eq!(to(Value::Number(f64::NAN), Kind::Integer), None);
}

/// Eight real definitions by six authors evaluate, shatter or frame lines of any length at 0 to 1.
#[test]
fn a_line_is_a_curve_over_0_to_1() {
    let line = Line::new(Point3::new(2.0, 3.0, 0.0), Point3::new(13.0, 6.0, 0.0));
    let Some(Value::Curve(curve)) = to(Value::from(line), Kind::Curve) else { panic!() };
    assert_eq!(curve.domain(), Interval::UNIT);
    assert!(curve.point_at(0.3).distance_to(Point3::new(5.3, 3.9, 0.0)) < 1e-14);
    assert_eq!(to(Value::from(line), Kind::Number), Some(Value::Number(130.0_f64.sqrt())));
}

#[test]
fn zero_is_false() {
    assert_eq!(to(Value::Number(0.0), Kind::Boolean), Some(Value::Boolean(false)));
    assert_eq!(to(Value::Number(-0.3), Kind::Boolean), Some(Value::Boolean(true)));
    assert_eq!(to(Value::Boolean(true), Kind::Number), Some(Value::Number(1.0)));
    assert_eq!(to(Value::text("0"), Kind::Boolean), Some(Value::Boolean(false)));
    assert_eq!(to(Value::text("TRUE"), Kind::Boolean), Some(Value::Boolean(true)));
    assert_eq!(to(Value::text("maybe"), Kind::Boolean), None);
}

#[test]
fn texts_are_read() {
    assert_eq!(to(Value::text(" 3.6 "), Kind::Number), Some(Value::Number(3.6)));
    assert_eq!(to(Value::text("1/4"), Kind::Number), Some(Value::Number(0.25)));
    assert_eq!(to(Value::text("1e3"), Kind::Integer), Some(Value::Integer(1000)));
    assert_eq!(to(Value::text("20"), Kind::Domain), Some(Value::Domain(Interval::new(0.0, 20.0))));
    assert_eq!(to(Value::text("-1 to 10"), Kind::Domain), Some(Value::Domain(Interval::new(-1.0, 10.0))));
    assert_eq!(to(Value::text("{0,1.5, -2}"), Kind::Point), Some(Value::Point(Point3::new(0.0, 1.5, -2.0))));
    assert_eq!(
        to(Value::text("Q{0,1,2,3}"), Kind::MeshFace),
        Some(Value::MeshFace(MeshFace::Quad([0, 1, 2, 3])))
    );
    assert_eq!(
        to(Value::text("T{1;2;4}"), Kind::MeshFace),
        Some(Value::MeshFace(MeshFace::Triangle([1, 2, 4])))
    );
    assert_eq!(to(Value::text("255,0,10"), Kind::Colour), Some(Value::Colour(Colour::rgb(255, 0, 10))));
    assert_eq!(to(Value::text("#80ff0000"), Kind::Colour), Some(Value::Colour(Colour::argb(128, 255, 0, 0))));
    let square = Domain2 { u: Interval::new(0.0, 50.0), v: Interval::new(0.0, 20.0) };
    assert_eq!(
        to(Value::text("u:{0 To 50} v:{0 To 20}"), Kind::Domain2),
        Some(Value::Domain2(square.into()))
    );
    // .NET passes over commas between digits: `0,0,550` is a point, and the height of a box in a real definition.
    for (spelled, x) in [("0,0,550", 550.0), ("1,000.5", 1000.5), ("-1,2", -12.0), ("1,0e1", 100.0)] {
        assert_eq!(to(Value::text(spelled), Kind::Number), Some(Value::Number(x)), "{spelled}");
    }
    assert_eq!(to(Value::text("0,0,550"), Kind::Integer), Some(Value::Integer(550)));
    for nonsense in ["", "x", ",2", "1.5,2", "1,2 mm", "{", "to", "{1,2,3", "Q{a}"] {
        assert_eq!(to(Value::text(nonsense), Kind::Number), None, "{nonsense}");
    }
}

#[test]
fn points_vectors_and_planes_change_into_each_other() {
    let p = Point3::new(1.0, 2.0, 3.0);
    assert_eq!(to(Value::Point(p), Kind::Vector), Some(Value::Vector(p.to_vector())));
    assert_eq!(to(Value::Vector(p.to_vector()), Kind::Point), Some(Value::Point(p)));
    let plane = Plane { origin: p, ..Plane::XY };
    assert_eq!(to(Value::Point(p), Kind::Plane), Some(Value::Plane(plane.into())));
    assert_eq!(to(Value::Plane(plane.into()), Kind::Point), Some(Value::Point(p)));
    assert_eq!(to(Value::Plane(plane.into()), Kind::Vector), Some(Value::Vector(Vector3::Z)));
}

#[test]
fn circles_lines_and_rectangles_are_curves_and_back() {
    let circle = to(Value::Number(2.0), Kind::Circle).unwrap();
    let curve = to(circle.clone(), Kind::Curve).unwrap();
    assert_eq!(to(curve, Kind::Circle), Some(circle));
    let rectangle = to(
        Value::Domain2(Domain2 { u: Interval::new(0.0, 3.0), v: Interval::new(0.0, 2.0) }.into()),
        Kind::Rectangle,
    );
    let curve = to(rectangle.clone().unwrap(), Kind::Curve).unwrap();
    assert_eq!(to(curve, Kind::Rectangle), rectangle);
}

#[test]
fn a_column_tells_what_failed_and_keeps_its_nulls() {
    let column = Column::of_options(vec![
        Some(Value::text("1")),
        None,
        Some(Value::text("a")),
        Some(Value::text("b")),
    ]);
    let cast = super::column(&column, Kind::Number, &Rules::default());
    assert_eq!(cast.failed, Some((Kind::Text, 2)));
    assert_eq!(cast.column.iter().collect::<Vec<_>>(), [Some(Value::Number(1.0)), None, None, None]);
}

#[test]
fn a_column_of_the_right_type_is_shared() {
    let column = Column::of_values(vec![Value::Number(1.0)], None);
    let cast = super::column(&column, Kind::Number, &Rules::default()).column;
    let (Items::Numbers(a), Items::Numbers(b)) = (column.items(), cast.items()) else { panic!() };
    assert!(Shared::ptr_eq(a, b));
}

#[test]
fn a_compound_is_a_transform_that_stays_whole() {
    use crate::{Compound, Item};
    use katydid_geometry::Xform;
    let (step, scale) = (Xform::translation(Vector3::X), Xform::scale(Point3::ORIGIN, 2.0));
    let compound = Value::from(Compound { parts: vec![step, scale] });
    assert_eq!(to(compound.clone(), Kind::Transform), Some(compound.clone()));
    // Mixed with plain ones too.
    for column in [
        Column::of_values(vec![compound.clone()], None),
        Column::of_values(vec![Value::from(step), compound.clone()], None),
    ] {
        let cast = super::column(&column, Kind::Transform, &Rules::default()).column;
        let last = cast.len() - 1;
        assert_eq!(cast.get(last), Some(compound.clone()));
        assert_eq!(Xform::get(&cast, last), Some(scale * step));
    }
    assert_eq!(to(Value::from(step), Kind::Compound), Some(Value::from(Compound { parts: vec![step] })));
    let Some(Value::Matrix(matrix)) = to(compound.clone(), Kind::Matrix) else { panic!() };
    let back = to(Value::Matrix(matrix.clone()), Kind::Transform).and_then(|t| t.as_transform());
    assert_eq!(back, compound.as_transform());
    assert_eq!((matrix.get(0, 0), matrix.get(0, 3)), (Some(2.0), Some(2.0)));
}

#[test]
fn places_on_the_globe() {
    let place = |v: Value| match to(v, Kind::Location) {
        Some(Value::Location(place)) => Some((place.longitude, place.latitude)),
        _ => None,
    };
    assert_eq!(place(Value::Point(Point3::new(13.4, 52.5, 0.0))), Some((13.4, 52.5)));
    assert_eq!(place(Value::text("-74, 40.7")), Some((-74.0, 40.7)));
    assert_eq!(place(Value::Point(Point3::new(0.0, 91.0, 0.0))), None);
}

#[test]
fn surfaces_and_what_becomes_one() {
    use katydid_geometry::{Circle, Direction, PlaneSurface, PolylineCurve, Rectangle, Sphere, Surface};

    let r = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(2.0, -1.0) };
    let Some(Value::Surface(flat)) = to(r.into(), Kind::Surface) else { panic!("a surface") };
    assert_eq!(*flat, PlaneSurface::new(Plane::XY, r.x, r.y.ordered()).unwrap().into());
    let outline: Vec<Point3> = r.corners().into_iter().chain([r.corners()[0]]).collect();
    let outline = Value::from(Curve::from(PolylineCurve::new(outline).unwrap()));
    assert!(matches!(to(outline, Kind::Brep), Some(Value::Surface(_))));
    // Other closed flat outlines give trimmed surfaces.
    let circle = Circle { plane: Plane::XY, radius: 1.0 };
    for kind in [Kind::Surface, Kind::Brep] {
        let Some(Value::Brep(disc)) = to(circle.into(), kind) else { panic!("a face") };
        let area = disc.area_properties(1e-9, || true).unwrap().amount;
        assert!(disc.faces().len() == 1 && (area - std::f64::consts::PI).abs() < 1e-6);
    }
    let zigzag = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]];
    let zigzag = zigzag.map(|[x, y, z]| Point3::new(x, y, z)).to_vec();
    for open in [zigzag.clone(), zigzag[..3].to_vec()] {
        assert_eq!(to(Value::from(Curve::from(PolylineCurve::new(open).unwrap())), Kind::Surface), None);
    }

    let surface = Value::Surface(flat.clone());
    for kind in [Kind::Brep, Kind::Surface, Kind::Geometry, Kind::Generic] {
        assert_eq!(to(surface.clone(), kind), Some(surface.clone()), "{kind}");
    }
    let line = Line { from: Point3::ORIGIN, to: Point3::new(0.0, 3.0, 4.0) };
    assert_eq!(to(line.into(), Kind::Domain), Some(Interval::UNIT.into()));
    let domains = Domain2 { u: flat.domain(Direction::U), v: flat.domain(Direction::V) };
    assert_eq!(to(surface.clone(), Kind::Domain2), Some(domains.into()));
    assert_eq!(to(surface.clone(), Kind::Plane), Some(Plane::XY.into()));
    assert_eq!(to(surface.clone(), Kind::Text), Some(Value::text("Untrimmed Surface")));
    let Some(Value::Box(b)) = to(surface, Kind::Box) else { panic!("a box") };
    assert_eq!((b.x, b.y), (Interval::new(0.0, 3.0), Interval::new(-1.0, 2.0)));
    let ball = Value::from(Surface::from(Sphere::around(Point3::ORIGIN, 1.0).unwrap()));
    assert_eq!(to(ball.clone(), Kind::Plane), None);
    let Some(Value::Mesh(mesh)) = to(ball, Kind::Mesh) else { panic!("a mesh") };
    assert!((mesh.area() - 4.0 * std::f64::consts::PI).abs() < 0.2);
}

#[test]
fn columns_of_surfaces_keep_their_type() {
    let ball = Value::from(katydid_geometry::Surface::from(
        katydid_geometry::Sphere::around(Point3::ORIGIN, 1.0).unwrap(),
    ));
    let balls = Column::of_options(vec![None, Some(ball.clone())]);
    assert_eq!(balls.kind(), Kind::Surface);
    for kind in [Kind::Brep, Kind::Geometry] {
        let cast = column(&balls, kind, &Rules::default());
        assert_eq!((cast.column.kind(), cast.failed), (Kind::Surface, None));
        assert_eq!(cast.column.get(1), Some(ball.clone()));
    }
}

#[test]
fn a_colour_is_a_plain_material() {
    let half = Colour::argb(127, 10, 20, 30);
    let Some(Value::Material(made)) = to(Value::Colour(half), Kind::Material) else { panic!("no material") };
    assert_eq!(made.diffuse, Colour::rgb(10, 20, 30));
    assert!((made.transparency - 128.0 / 255.0).abs() < 1e-15);
    assert_eq!(to(Value::Material(made), Kind::Colour), Some(Value::Colour(Colour::rgb(10, 20, 30))));
}

#[test]
fn a_box_becomes_a_twisted_one() {
    let side = Interval::new(0.0, 2.0);
    let cube = Value::from(katydid_geometry::Box3 { plane: Plane::XY, x: side, y: side, z: side });
    let Some(Value::TwistedBox(twisted)) = to(cube, Kind::TwistedBox) else { panic!("a twisted box") };
    assert_eq!(twisted.corners[6], Point3::new(2.0, 2.0, 2.0));
    let twisted = Value::TwistedBox(twisted);
    assert_eq!(text::value(&twisted, &text::Style::default()), "Twisted Box");
    assert!(matches!(to(twisted.clone(), Kind::Box), Some(Value::Box(b)) if b.volume() == 8.0));
    assert!(matches!(to(twisted.clone(), Kind::Mesh), Some(Value::Mesh(m)) if m.faces().len() == 6));
    assert_eq!(to(twisted.clone(), Kind::Geometry), Some(twisted));
    assert_eq!(to(Point3::ORIGIN.into(), Kind::TwistedBox), None);
}
