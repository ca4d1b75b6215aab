//! What is written with serde comes back the same, and what no constructor would make is refused.

#![cfg(feature = "serde")]
#![allow(clippy::unwrap_used, reason = "a test may stop")]

use std::fmt::Debug;

use katydid_geometry::{
    Arc, BoundingBox, Box3, Circle, Cone, Curve, Cylinder, Direction, Ellipse, Interval, Line, Matrix, Mesh,
    NurbsCurve, NurbsSurface, Plane, PlaneEquation, PlaneSurface, Point2, Point3, PolyCurve, PolylineCurve,
    Quaternion, Rectangle, RevolutionSurface, Sphere, SumSurface, Surface, Tolerance, Torus, Units, Vector2,
    Vector3, Xform,
};
use proptest::prelude::*;
use serde::{Serialize, de::DeserializeOwned};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

#[track_caller]
fn comes_back<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) {
    let text = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), value, "{text}");
}

#[track_caller]
fn refused<T: DeserializeOwned + Debug>(text: &str, why: &str) {
    let error = serde_json::from_str::<T>(text).unwrap_err().to_string();
    assert!(error.contains(why), "{error}");
}

fn tilted() -> Plane {
    Plane::from_normal(p(0.1, -2.7, 1.0 / 3.0), Vector3::new(0.3, 1.1, -0.2)).unwrap()
}

fn curves() -> Vec<Curve> {
    let arc = Arc::new(Circle::new(tilted(), 1.7).unwrap(), Interval::new(-0.3, 2.0)).unwrap();
    let polyline = PolylineCurve::with_parameters(
        vec![arc.end(), p(5.0, 5.0, 5.0), p(6.0, 1.0, 0.1)],
        vec![0.5, 0.7, 3.0],
    );
    let points = [p(0.0, 0.0, 0.0), p(1.0, 2.0, 0.0), p(3.0, 2.0, 1.0), p(4.0, 0.0, 1.0)];
    let weights = [1.0, 0.3, 2.0, 1.0];
    let knots = vec![0.0, 0.0, 0.5, 1.0, 1.0];
    let rational = NurbsCurve::with_weights(2, &points, &weights, knots.clone()).unwrap();
    let plain = NurbsCurve::new(2, points.to_vec(), knots).unwrap();
    let parts: Vec<Curve> = vec![arc.into(), polyline.unwrap().into()];
    let inner: Curve = PolyCurve::new(parts.clone()).unwrap().into();
    let outer = PolyCurve::new(vec![inner, Line::new(p(6.0, 1.0, 0.1), Point3::ORIGIN).into()]).unwrap();
    let mut all = parts;
    all.extend([
        Curve::from(rational),
        plain.into(),
        outer.into(),
        Circle::new(Plane::XZ, 2.0).unwrap().into(),
    ]);
    all
}

#[test]
fn everything_comes_back() {
    comes_back(&p(0.1, 1e-300, -7.0));
    comes_back(&Vector3::new(1.0 / 3.0, 0.0, 2.0));
    comes_back(&Point2::new(0.1, 0.2));
    comes_back(&Vector2::new(0.1, 0.2));
    comes_back(&Interval::new(2.0, -1.0));
    comes_back(&Quaternion::rotation(0.3, Vector3::X).unwrap());
    comes_back(&Xform::rotation(0.3, Vector3::new(1.0, 2.0, 3.0), p(1.0, 1.0, 1.0)).unwrap());
    comes_back(&Matrix::new(2, 3, vec![0.1, 0.2, 0.3, 0.4, 0.5, 0.6]).unwrap());
    comes_back(&tilted());
    comes_back(&PlaneEquation::from(&tilted()));
    comes_back(&Line::new(p(0.0, 0.1, 0.2), p(1.0, 1.0, 1.0)));
    comes_back(&BoundingBox { min: p(0.0, 0.0, 0.0), max: p(1.0, 0.0, 2.0) });
    let range = Interval::new(0.1, 0.7);
    comes_back(&Box3 { plane: tilted(), x: range, y: range, z: Interval::UNIT });
    comes_back(&Rectangle { plane: tilted(), x: range, y: Interval::UNIT });
    comes_back(&Ellipse::new(tilted(), 2.0, 0.1).unwrap());
    comes_back(&Tolerance::default());
    comes_back(&Units::Feet);
    comes_back(&Direction::V);
    let mesh = Mesh::cuboid(&Box3 { plane: tilted(), x: range, y: range, z: range }, 1, 2, 1).unwrap();
    comes_back(&mesh);
    let m = Xform::scale_non_uniform(&tilted(), 1.0, 2.0, -3.0);
    comes_back(&m.decompose_affine().unwrap());
    for curve in curves() {
        comes_back(&curve);
    }
}

#[test]
fn surfaces_come_back() {
    let [first, second] = [curves()[0].clone(), curves()[3].clone()];
    let axis = Line::new(p(9.0, 0.0, 0.0), p(9.0, 1.0, 3.0));
    let turned = RevolutionSurface::new(second.clone(), axis, Interval::new(0.0, 2.0)).unwrap();
    let points: Vec<Point3> =
        (0..12).map(|i| p(f64::from(i / 4), f64::from(i % 4), f64::from(i * i) / 7.0)).collect();
    let nurbs = NurbsSurface::clamped_uniform([2, 3], [3, 4], &points).unwrap();
    let heavy = nurbs.with_weight(1, 1, 3.0).unwrap();
    let extents = [Interval::new(0.0, 2.0), Interval::new(1.0, 4.0)];
    let all: Vec<Surface> = vec![
        PlaneSurface::with_domains(tilted(), extents, [Interval::UNIT, extents[1]]).unwrap().into(),
        SumSurface::new(first, second, Vector3::new(0.1, 0.2, 0.3)).unwrap().into(),
        turned.transposed().into(),
        turned.into(),
        nurbs.into(),
        heavy.into(),
    ];
    for surface in all {
        comes_back(&surface);
    }
    comes_back(&Sphere::new(tilted(), 0.1).unwrap());
    comes_back(&Cylinder::new(tilted(), 0.1, Interval::new(0.0, 2.0)).unwrap());
    comes_back(&Cone::new(tilted(), 2.0, 0.1).unwrap());
    comes_back(&Torus::new(tilted(), 2.0, 0.1).unwrap());
}

#[test]
fn what_cannot_be_is_refused() {
    refused::<Point3>("[1, 2]", "length 2");
    refused::<Circle>(
        r#"{"plane":{"origin":[0,0,0],"x_axis":[1,0,0],"y_axis":[0,1,0],"z_axis":[0,0,1]},"radius":-1}"#,
        "radius",
    );
    refused::<Plane>(r#"{"origin":[0,0,0],"x_axis":[1,0,0],"y_axis":[0,1,0],"z_axis":[0,0,-1]}"#, "frame");
    refused::<Plane>(r#"{"origin":[0,0,0],"x_axis":[2,0,0],"y_axis":[0,1,0],"z_axis":[0,0,1]}"#, "frame");
    refused::<NurbsCurve>(r#"{"degree":2,"knots":[0,0,1],"controls":{"plain":[[0,0,0]]}}"#, "control points");
    refused::<NurbsCurve>(
        r#"{"degree":1,"knots":[0,1],"controls":{"rational":[[0,0,0,1],[1,0,0,0]]}}"#,
        "weight 1",
    );
    refused::<NurbsCurve>(r#"{"degree":200,"knots":[0,1],"controls":{"plain":[[0,0,0],[1,0,0]]}}"#, "degree");
    refused::<Mesh>(r#"{"vertices":[[0,0,0]],"faces":[[0,1,2]]}"#, "face 0");
    refused::<Mesh>(r#"{"vertices":[[0,0,0]],"faces":[[0,0]]}"#, "corners");
    refused::<Matrix>(r#"{"rows":4,"columns":4000000000,"values":[]}"#, "entries");
    refused::<Curve>(
        r#"{"line":{"line":{"from":[0,0,0],"to":[1,0,0]},"domain":[1,1]}}"#,
        "does not increase",
    );
    refused::<Curve>(r#"{"poly":{"segments":[],"parameters":[0]}}"#, "no segments");
    refused::<Curve>(r#"{"spiral":{}}"#, "unknown variant");
    refused::<PlaneEquation>("[0, 0, 0, 1]", "plane equation");
    refused::<BoundingBox>(r#"{"min":[0,0,1],"max":[1,1,0]}"#, "box");
}

#[test]
fn deep_nesting_is_refused_before_the_stack_ends() {
    let mut text = r#"{"line":{"line":{"from":[0,0,0],"to":[1,0,0]},"domain":[0,1]}}"#.to_owned();
    for _ in 0..40 {
        text = format!(r#"{{"poly":{{"segments":[{text}],"parameters":[0,1]}}}}"#);
    }
    refused::<Curve>(&text, "nested");
}

proptest! {
    #[test]
    fn any_numbers_give_a_value_or_an_error(
        degree in 0..5_usize,
        knots in prop::collection::vec(-2.0..2.0_f64, 0..9),
        points in prop::collection::vec(prop::array::uniform4(-2.0..2.0_f64), 0..6),
    ) {
        let value = serde_json::json!({ "degree": degree, "knots": knots, "controls": { "rational": points } });
        if let Ok(curve) = serde_json::from_value::<NurbsCurve>(value) {
            prop_assert!(curve.point_at(curve.domain().start).is_finite());
        }
    }
}
