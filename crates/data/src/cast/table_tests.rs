//! Every cell of the table of conversions: what each type becomes as each other one.

use katydid_geometry::{
    Arc, Box3, Circle, Curve, Interval, Line, LineCurve, Matrix, Mesh, Plane, PlaneSurface, Point3,
    PolylineCurve, Rectangle, Surface, TwistedBox, Vector3, Xform,
};

use super::*;
use crate::{Colour, Complex, Compound, Domain2, Group, Material, Path, text};

fn to(v: &Value, kind: Kind) -> Option<Value> {
    value(v, kind, &Rules { now: Some(DateTime { ticks: 0 }), ..Rules::default() })
}

fn point() -> Point3 {
    Point3::new(3.0, 4.0, 0.0)
}

fn range(a: f64, b: f64) -> Interval {
    Interval::new(a, b)
}

fn rectangle() -> Rectangle {
    Rectangle { plane: Plane::XY, x: range(0.0, 3.0), y: range(0.0, 2.0) }
}

fn flat() -> Value {
    Value::from(Surface::from(PlaneSurface::new(Plane::XY, range(0.0, 3.0), range(0.0, 2.0)).unwrap()))
}

fn disc() -> Value {
    to(&Value::from(Circle { plane: Plane::XY, radius: 1.0 }), Kind::Brep).unwrap()
}

fn cube() -> Box3 {
    Box3 { plane: Plane::XY, x: range(0.0, 2.0), y: range(0.0, 2.0), z: range(0.0, 2.0) }
}

fn sheet() -> Box3 {
    Box3 { z: range(1.0, 1.0), ..cube() }
}

fn segment() -> Line {
    Line::new(Point3::ORIGIN, point())
}

fn polyline(points: &[[f64; 2]]) -> Value {
    let points = points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
    Value::from(Curve::from(PolylineCurve::new(points).unwrap()))
}

fn triangle() -> Value {
    polyline(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]])
}

fn arc() -> Arc {
    Arc { circle: Circle { plane: Plane::XY, radius: 1.0 }, angle: range(0.0, std::f64::consts::PI) }
}

fn full() -> Arc {
    Arc { angle: range(0.0, std::f64::consts::TAU), ..arc() }
}

fn subd() -> Value {
    let net = katydid_geometry::subd::SubDNet::of_box(&cube(), 1, false).unwrap();
    let object = katydid_3dm::SubDObject::from(&katydid_geometry::subd::SubD::new(net));
    Value::from(katydid_3dm::Object::SubD(Box::new(object)).to_raw(80, &[]).unwrap())
}

fn moved() -> Xform {
    Xform::translation(Vector3::X)
}

fn four_by_four() -> Value {
    Value::from(Matrix::new(4, 4, moved().rows.concat()).unwrap())
}

/// The text of what a value becomes, for each conversion of the table.
fn cells() -> Vec<(Value, Kind, &'static str)> {
    use Kind as K;
    let p = || Value::Point(point());
    let v = || Value::Vector(point().to_vector());
    let c = |re: f64, im: f64| Value::from(Complex { re, im });
    let t = Value::text;
    let day = || Value::from(DateTime { ticks: 599_264_352_000_000_000 + 36 * 864_000_000_000 });
    let line = || Value::from(segment());
    let straight = || Value::from(Curve::from(LineCurve::new(segment())));
    let circle = || Value::from(Circle { plane: Plane::XY, radius: 1.0 });
    let domain = || Value::Domain(range(2.0, 5.0));
    let domains = || Value::from(Domain2 { u: range(0.0, 3.0), v: range(0.0, 2.0) });
    let grey = || Value::from(Colour::rgb(102, 102, 102));
    let brep = || to(&Value::from(cube()), Kind::Brep).unwrap();
    let mesh = || Value::from(Mesh::cuboid(&cube(), 1, 1, 1).unwrap());
    let path = || Value::Path(Path::from([7]));
    vec![
        (Value::Integer(2), K::Boolean, "True"),
        (Value::Number(0.0), K::Boolean, "False"),
        (t("no"), K::Boolean, "False"),
        (Value::Boolean(true), K::Integer, "1"),
        (Value::Number(2.5), K::Integer, "2"),
        (t("True"), K::Integer, "1"),
        (c(3.0, 0.0), K::Integer, "3"),
        (p(), K::Integer, "5"),
        (v(), K::Integer, "5"),
        (straight(), K::Integer, "5"),
        (line(), K::Integer, "5"),
        (circle(), K::Integer, "6"),
        (Value::from(arc()), K::Integer, "3"),
        (Value::from(rectangle()), K::Integer, "10"),
        (domain(), K::Integer, "3"),
        (path(), K::Integer, "7"),
        (Value::Boolean(true), K::Number, "1"),
        (Value::Integer(4), K::Number, "4"),
        (t("false"), K::Number, "0"),
        (c(3.5, 0.0), K::Number, "3.5"),
        (day(), K::Number, "36"),
        (v(), K::Number, "5"),
        (p(), K::Number, "5"),
        (straight(), K::Number, "5"),
        (line(), K::Number, "5"),
        (circle(), K::Number, "6.283185"),
        (Value::from(arc()), K::Number, "3.141593"),
        (Value::from(rectangle()), K::Number, "10"),
        (domain(), K::Number, "3"),
        (grey(), K::Number, "0.4"),
        (path(), K::Number, "7"),
        (Value::Boolean(true), K::Complex, "1 + 0i"),
        (Value::Integer(4), K::Complex, "4 + 0i"),
        (Value::Number(1.5), K::Complex, "1.5 + 0i"),
        (day(), K::Complex, "36 + 0i"),
        (t("3 - 4i"), K::Complex, "3 - 4i"),
        (p(), K::Complex, "3 + 4i"),
        (v(), K::Complex, "3 + 4i"),
        (t("1,2,3"), K::Colour, "1,2,3"),
        (Value::Integer(9), K::Colour, "9,9,9"),
        (Value::Number(9.4), K::Colour, "9,9,9"),
        (p(), K::Colour, "3,4,0"),
        (v(), K::Colour, "3,4,0"),
        (Value::from(Material::from(Colour::rgb(1, 2, 3))), K::Colour, "1,2,3"),
        (t("2024-02-29 13:05:09"), K::Time, "2024-02-29 13:05:09"),
        (Value::Number(36.0), K::Time, "1900-02-04 00:00:00"),
        (Value::Integer(36), K::Time, "1900-02-04 00:00:00"),
        (t("3effc6e6-8bd9-4c93-bd13-4ec8e8a0e0ab"), K::Guid, "3effc6e6-8bd9-4c93-bd13-4ec8e8a0e0ab"),
        (Value::Boolean(true), K::Domain, "0 To 1"),
        (Value::Integer(4), K::Domain, "0 To 4"),
        (Value::Number(2.5), K::Domain, "0 To 2.5"),
        (t("2 to 5"), K::Domain, "2 To 5"),
        (straight(), K::Domain, "0 To 5"),
        (line(), K::Domain, "0 To 1"),
        (circle(), K::Domain, "0 To 6.283185"),
        (Value::from(arc()), K::Domain, "0 To 3.141593"),
        (Value::from(rectangle()), K::Domain, "0 To 4"),
        (c(1.0, 2.0), K::Domain, "1 To 2"),
        (p(), K::Domain, "3 To 4"),
        (v(), K::Domain, "3 To 4"),
        (flat(), K::Domain2, "u:{0 To 3} v:{0 To 2}"),
        (disc(), K::Domain2, "u:{-1 To 1} v:{-1 To 1}"),
        (t("u:{0 To 1} v:{2 To 3}"), K::Domain2, "u:{0 To 1} v:{2 To 3}"),
        (Value::from(rectangle()), K::Domain2, "u:{0 To 3} v:{0 To 2}"),
        (domain(), K::Domain2, "u:{2 To 5} v:{2 To 5}"),
        (Value::Integer(4), K::Domain2, "u:{0 To 4} v:{0 To 4}"),
        (Value::Number(2.5), K::Domain2, "u:{0 To 2.5} v:{0 To 2.5}"),
        (t("{0;1}"), K::Path, "{0;1}"),
        (Value::Integer(3), K::Path, "{3}"),
        (Value::Number(3.2), K::Path, "{3}"),
        (v(), K::Point, "{3, 4, 0}"),
        (t("1,2,3"), K::Point, "{1, 2, 3}"),
        (Value::Integer(4), K::Point, "{4, 0, 0}"),
        (Value::Number(2.5), K::Point, "{2.5, 0, 0}"),
        (c(1.0, 2.0), K::Point, "{1, 2, 0}"),
        (Value::from(Plane { origin: point(), ..Plane::XY }), K::Point, "{3, 4, 0}"),
        (circle(), K::Point, "{0, 0, 0}"),
        (Value::from(arc()), K::Point, "{0, 0, 0}"),
        (line(), K::Point, "{1.5, 2, 0}"),
        (Value::from(rectangle()), K::Point, "{1.5, 1, 0}"),
        (Value::from(cube()), K::Point, "{1, 1, 1}"),
        (to(&circle(), K::Curve).unwrap(), K::Point, "{0, 0, 0}"),
        (p(), K::Vector, "{3, 4, 0}"),
        (t("1,2,3"), K::Vector, "{1, 2, 3}"),
        (Value::Integer(4), K::Vector, "{4, 0, 0}"),
        (Value::Number(2.5), K::Vector, "{2.5, 0, 0}"),
        (c(1.0, 2.0), K::Vector, "{1, 2, 0}"),
        (Value::from(Plane::XY), K::Vector, "{0, 0, 1}"),
        (line(), K::Vector, "{3, 4, 0}"),
        (straight(), K::Vector, "{3, 4, 0}"),
        (flat(), K::Vector, "{0, 0, 1}"),
        (disc(), K::Vector, "{0, 0, 1}"),
        (p(), K::Plane, "O(3.00,4.00,0.00) Z(0.00,0.00,1.00)"),
        (t("O(1,2,3) Z(1,0,0)"), K::Plane, "O(1.00,2.00,3.00) Z(1.00,0.00,0.00)"),
        (Value::Integer(4), K::Plane, "O(4.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::Number(4.0), K::Plane, "O(4.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (c(1.0, 2.0), K::Plane, "O(1.00,2.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::Vector(Vector3::X), K::Plane, "O(0.00,0.00,0.00) Z(1.00,0.00,0.00)"),
        (circle(), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::from(arc()), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::from(rectangle()), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::from(cube()), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (Value::from(Line::new(point(), Point3::ORIGIN)), K::Plane, "O(3.00,4.00,0.00) Z(-0.60,-0.80,0.00)"),
        (triangle(), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (flat(), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (disc(), K::Plane, "O(0.00,0.00,0.00) Z(0.00,0.00,1.00)"),
        (straight(), K::Line, "Line(L:5.00 mm)"),
        (v(), K::Line, "Line(L:5.00 mm)"),
        (to(&circle(), K::Curve).unwrap(), K::Circle, "Circle(R:1.00 mm)"),
        (Value::from(full()), K::Circle, "Circle(R:1.00 mm)"),
        (Value::Integer(2), K::Circle, "Circle(R:2.00 mm)"),
        (Value::Number(2.5), K::Circle, "Circle(R:2.50 mm)"),
        (circle(), K::Arc, "Arc(R:1.00 mm A:360\u{b0})"),
        (to(&Value::from(arc()), K::Curve).unwrap(), K::Arc, "Arc(R:1.00 mm A:180\u{b0})"),
        (to(&Value::from(rectangle()), K::Curve).unwrap(), K::Rectangle, "Rectangle (w=3, h=2)"),
        (domains(), K::Rectangle, "Rectangle (w=3, h=2)"),
        (flat(), K::Rectangle, "Rectangle (w=3, h=2)"),
        (disc(), K::Rectangle, "Rectangle (w=2, h=2)"),
        (Value::from(cube()), K::Rectangle, "Rectangle (w=2, h=2)"),
        (mesh(), K::Rectangle, "Rectangle (w=2, h=2)"),
        (Value::from(rectangle()), K::Box, "Box (x=3, y=2, z=0)"),
        (Value::from(cube()), K::TwistedBox, "Twisted Box"),
        (Value::from(rectangle()), K::TwistedBox, "Twisted Box"),
        (triangle(), K::TwistedBox, "Twisted Box"),
        (flat(), K::TwistedBox, "Twisted Box"),
        (brep(), K::TwistedBox, "Twisted Box"),
        (mesh(), K::TwistedBox, "Twisted Box"),
        (subd(), K::TwistedBox, "Twisted Box"),
        (Value::from(Group { members: vec![Some(p())] }), K::TwistedBox, "Twisted Box"),
        (line(), K::Curve, "Line-like Curve"),
        (circle(), K::Curve, "Circle-like Curve"),
        (Value::from(arc()), K::Curve, "Arc-like Curve"),
        (Value::from(rectangle()), K::Curve, "Polyline Curve"),
        (flat(), K::Curve, "Polyline Curve"),
        (disc(), K::Curve, "Circle-like Curve"),
        (Value::from(sheet()), K::Curve, "Polyline Curve"),
        (disc(), K::Surface, "Trimmed Surface"),
        (triangle(), K::Surface, "Trimmed Surface"),
        (polyline(&[[0.0, 0.0], [3.0, 4.0], [0.0, 4.0], [0.0, 0.0]]), K::Brep, "Trimmed Surface"),
        (circle(), K::Surface, "Trimmed Surface"),
        (circle(), K::Brep, "Trimmed Surface"),
        (Value::from(full()), K::Surface, "Trimmed Surface"),
        (Value::from(full()), K::Brep, "Trimmed Surface"),
        (Value::from(rectangle()), K::Surface, "Untrimmed Surface"),
        (Value::from(rectangle()), K::Brep, "Untrimmed Surface"),
        (Value::from(sheet()), K::Surface, "Untrimmed Surface"),
        (Value::from(sheet()), K::Brep, "Untrimmed Surface"),
        (Value::from(cube()), K::Brep, "Closed Brep"),
        (Value::from(TwistedBox::from(cube())), K::Brep, "Closed Brep"),
        (flat(), K::Brep, "Untrimmed Surface"),
        (mesh(), K::Brep, "Closed Brep"),
        (subd(), K::Brep, "Closed Brep"),
        (Value::from(cube()), K::Mesh, "Mesh (V:24  F:6)"),
        (Value::from(TwistedBox::from(cube())), K::Mesh, "Mesh (V:8  F:6)"),
        (triangle(), K::Mesh, "Mesh (V:3  F:1)"),
        (Value::from(rectangle()), K::Mesh, "Mesh (V:4  F:1)"),
        (subd(), K::Mesh, "Mesh (V:98  F:96)"),
        (t("Q{0;1;2;3}"), K::MeshFace, "Q{0;1;2;3}"),
        (t("{1,2,3}"), K::Geometry, "{1, 2, 3}"),
        (t("{1,2,3}"), K::Content, "{1, 2, 3}"),
        (Value::from(Compound { parts: vec![moved()] }), K::Transform, "Compound transform of 1 part"),
        (v(), K::Transform, "Transform"),
        (Value::from(Plane::XY), K::Transform, "Transform"),
        (four_by_four(), K::Transform, "Transform"),
        (Value::from(moved()), K::Compound, "Compound transform of 1 part"),
        (Value::from(moved()), K::Matrix, "Matrix (4 rows, 4 columns)"),
        (Value::from(Compound { parts: vec![moved()] }), K::Matrix, "Matrix (4 rows, 4 columns)"),
        (grey(), K::Material, "Material (102,102,102)"),
        (t("red"), K::Material, "Material (255,0,0)"),
        (Value::Integer(9), K::Material, "Material (9,9,9)"),
        (Value::Number(9.0), K::Material, "Material (9,9,9)"),
        (p(), K::Material, "Material (3,4,0)"),
        (v(), K::Material, "Material (3,4,0)"),
        (p(), K::Location, "4\u{b0} N, 3\u{b0} E"),
        (t("13.4, 52.5"), K::Location, "52.5\u{b0} N, 13.4\u{b0} E"),
    ]
}

/// Pairs whose result is looked at by other tests: what comes of them has no telling text.
const ELSEWHERE: [(Kind, Kind); 5] = [
    (Kind::Surface, Kind::Mesh),
    (Kind::Brep, Kind::Mesh),
    (Kind::Curve, Kind::Brep),
    (Kind::Circle, Kind::Mesh),
    (Kind::Arc, Kind::Mesh),
];

#[test]
fn each_cell_gives_what_its_row_says() {
    let mut wrong = Vec::new();
    for (from, kind, expected) in cells() {
        let style = text::Style::default();
        let made = to(&from, kind).map(|made| text::value(&made, &style).replace("-0.00", "0.00"));
        if made.as_deref() != Some(expected) {
            wrong.push(format!("{} to {kind}: {made:?}, not {expected}", from.kind()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_row_is_tried_and_no_pair_has_two() {
    let tried: Vec<(Kind, Kind)> = cells().iter().map(|(v, to, _)| (v.cast_kind(), *to)).collect();
    let mut seen = std::collections::HashSet::new();
    for way in all() {
        for from in way.from {
            assert!(seen.insert((*from, way.to)), "{from} to {} has two rows", way.to);
            let wild = matches!(from, Kind::Generic | Kind::Geometry);
            let pair = (*from, way.to);
            // Lines have no inside; the others of their row do.
            let open = matches!(pair, (Kind::Line, Kind::Surface | Kind::Brep | Kind::Mesh));
            assert!(
                wild || open || tried.contains(&pair) || ELSEWHERE.contains(&pair),
                "{from} to {}",
                way.to
            );
        }
    }
}

#[test]
fn what_has_no_row_is_no_conversion() {
    for (from, kind) in [
        (Value::Boolean(true), Kind::Point),
        (Value::Boolean(true), Kind::Colour),
        (Value::from(cube()), Kind::Surface),
        (Value::from(cube()), Kind::Curve),
        (Value::from(segment()), Kind::Surface),
        (Value::from(Plane::XY), Kind::Surface),
        (Value::text("no number"), Kind::Number),
        (Value::from(Complex { re: 1.0, im: 2.0 }), Kind::Number),
        (Value::from(Domain2 { u: range(0.0, 1.0), v: range(0.0, 1.0) }), Kind::Number),
        (Value::Point(Point3::ORIGIN), Kind::Curve),
        (Value::Point(Point3::ORIGIN), Kind::Mesh),
        (Value::from(arc()), Kind::Surface),
        (Value::Number(1.0), Kind::Geometry),
        (Value::Number(f64::NAN), Kind::Integer),
        (Value::Number(f64::INFINITY), Kind::Time),
        (Value::text("2023-02-29"), Kind::Time),
        (Value::text("O(0,0,0) Z(0,0,0)"), Kind::Plane),
    ] {
        assert_eq!(to(&from, kind), None, "{} to {kind}", from.kind());
    }
    assert_eq!(value(&Value::text("Now"), Kind::Time, &Rules::default()), None, "there is no clock");
    assert_eq!(to(&Value::text("now"), Kind::Time), Some(Value::Time(DateTime { ticks: 0 })));
}

#[test]
fn all_geometry_has_a_box_around_it() {
    for value in [Value::Point(point()), Value::from(segment()), triangle(), flat(), disc(), subd()] {
        assert!(matches!(to(&value, Kind::Box), Some(Value::Box(_))), "{}", value.kind());
    }
}

#[test]
fn what_is_our_own_reading_is_named() {
    let column = Column::of_values(vec![Value::from(Colour::rgb(255, 0, 0))], None);
    let cast = column_of(&column, Kind::Number);
    assert!(cast.failed.is_none());
    assert_eq!(cast.ours.map(|(from, way)| (from, way.to)), Some((Kind::Colour, Kind::Number)));
    let column = Column::of_values(vec![Value::Point(point())], None);
    assert!(column_of(&column, Kind::Number).ours.is_none());
}

fn column_of(column: &Column, kind: Kind) -> Cast {
    super::column(column, kind, &Rules::default())
}
