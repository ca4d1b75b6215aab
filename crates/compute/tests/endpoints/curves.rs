//! Functions of curves: lengths, places, divisions, and curves made of curves.

use std::f64::consts::{PI, TAU};

use katydid_compute::wire::Read;
use katydid_geometry::{Curve, Plane, Point3, PolylineCurve};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, ball, c1, c2, circle, curves, lens, line, near, object, square};

#[test]
fn lengths_and_parameters() {
    near(&ask("curve/getlength-curve", json!([c1()])), TAU * 5.0);
    near(&ask("curve/getlength-curve_double", json!([c1(), 1e-8])), TAU * 5.0);
    near(&ask("curve/getlength-curve_interval", json!([line(), { "T0": 0, "T1": 5 }])), 5.0);
    near(&ask("RHINO/Geometry/Curve/GetLength", json!([line()])), 20.0);
    assert_eq!(ask("curve/isshort-curve_double", json!([line(), 19])), json!(false));
    assert_eq!(ask("curve/isshort-curve_double", json!([line(), 21])), json!(true));
    assert_eq!(ask("curve/lengthparameter-curve_double_double", json!([line(), 5])), json!([true, 5.0]));
    assert_eq!(ask("curve/lengthparameter-curve_double_double", json!([line(), 21]))[0], json!(false));
    near(
        &ask("curve/lengthparameter-curve_double_double_interval", json!([line(), 5, { "T0": 2, "T1": 9 }]))
            [1],
        7.0,
    );
    near(&ask("curve/normalizedlengthparameter-curve_double_double", json!([line(), 0.25]))[1], 5.0);
    let half =
        ask("curve/normalizedlengthparameters-curve_doublearray_double", json!([line(), [0, 0.5, 1], 0.01]));
    assert_eq!(half, json!([0.0, 10.0, 20.0]));
    at(&ask("curve/pointatlength-curve_double", json!([line(), 4])), [-6.0, 0.0, 0.0]);
    assert_eq!(ask("curve/pointatlength-curve_double", json!([line(), 40])), Json::Null);
    at(&ask("curve/pointatnormalizedlength-curve_double", json!([c1(), 0.25])), [0.0, 5.0, 0.0]);
}

#[test]
fn divisions() {
    let ten = ask("curve/dividebycount-curve_int_bool", json!([c1(), 10, true]));
    assert_eq!(ten.as_array().unwrap().len(), 10);
    assert_eq!(
        ask("curve/dividebycount-curve_int_bool", json!([line(), 4, true])),
        json!([0.0, 5.0, 10.0, 15.0, 20.0])
    );
    assert_eq!(
        ask("curve/dividebycount-curve_int_bool", json!([line(), 4, false])),
        json!([5.0, 10.0, 15.0])
    );
    let both = ask("curve/dividebycount-curve_int_bool_point3darray", json!([line(), 2, true]));
    at(&both[1][1], [0.0, 0.0, 0.0]);
    assert_eq!(
        ask("curve/dividebylength-curve_double_bool", json!([line(), 8, true])),
        json!([0.0, 8.0, 16.0])
    );
    let back = ask("curve/dividebylength-curve_double_bool_bool", json!([line(), 8, true, true]));
    [20.0, 12.0, 4.0].iter().enumerate().for_each(|(i, t)| near(&back[i], *t));
    assert_eq!(back.as_array().unwrap().len(), 3);
    assert_eq!(ask("curve/dividebylength-curve_double_bool", json!([line(), 80, true])), Json::Null);
    assert_eq!(ask("curve/divideequidistant-curve_double", json!([line(), 10])).as_array().unwrap().len(), 3);
    let contour =
        ask("curve/divideascontour-curve_point3d_point3d_double", json!([line(), [-9, 0, 0], [9, 0, 0], 6]));
    assert_eq!(contour.as_array().unwrap().len(), 4);
}

#[test]
fn nearest_points_and_places() {
    let found = ask("curve/closestpoint-curve_point3d_double", json!([c1(), [10, 0, 0]]));
    assert_eq!(found, json!([true, 0.0]));
    assert_eq!(
        ask("curve/closestpoint-curve_point3d_double_double", json!([line(), [0, 3, 0], 1]))[0],
        json!(false)
    );
    near(&ask("curve/closestpoint-curve_point3d_double_double", json!([line(), [0, 3, 0], 4]))[1], 10.0);
    let pair =
        ask("curve/closestpoints-curve_curve_point3d_point3d", json!([c1(), [[20, -1, 0], [20, 1, 0]]]));
    at(&pair[1], [5.0, 0.0, 0.0]);
    at(&pair[2], [20.0, 0.0, 0.0]);
    for (p, expected) in [([1, 1, 0], 1), ([9, 0, 0], 2), ([5, 0, 0], 3)] {
        assert_eq!(
            ask("curve/contains-curve_point3d_plane_double", json!([c1(), p, object(&Plane::XY), 0.001])),
            expected
        );
    }
    assert_eq!(ask("curve/contains-curve_point3d", json!([line(), [0, 0, 0]])), 0);
    let ends = ask("curve/extremeparameters-curve_vector3d", json!([c1(), [0, 1, 0]]));
    assert_eq!(ends.as_array().unwrap().len(), 2);
    let frame = ask("curve/perpendicularframeat-curve_double_plane", json!([line(), 3]));
    assert_eq!(frame[0], json!(true));
    at(&frame[1]["Normal"], [1.0, 0.0, 0.0]);
    assert_eq!(
        ask("curve/dodirectionsmatch-curve_curve", json!([line(), [[0, 1, 0], [5, 1, 0]]])),
        json!(true)
    );
    assert_eq!(
        ask("curve/dodirectionsmatch-curve_curve", json!([line(), [[5, 1, 0], [0, 1, 0]]])),
        json!(false)
    );
}

#[test]
fn curves_made_of_curves() {
    let grown = ask(
        "curve/offset-curve_plane_double_double_curveoffsetcornerstyle",
        json!([c1(), object(&Plane::XY), 1.0, 0.01, 1]),
    );
    near(&json!(curves(&grown)[0].length()), TAU * 6.0);
    let shrunk = ask(
        "curve/offset-curve_point3d_vector3d_double_double_curveoffsetcornerstyle",
        json!([c1(), [0, 0, 0], [0, 0, 1], 1.0, 0.01, "Sharp"]),
    );
    near(&json!(curves(&shrunk)[0].length()), TAU * 4.0);
    let joined =
        ask("curve/joincurves-curvearray", json!([[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 0]]]]));
    near(&json!(curves(&joined)[0].length()), 2.0);
    let through =
        ask("curve/createinterpolatedcurve-point3darray_int", json!([[[0, 0, 0], [1, 1, 0], [2, 0, 0]], 3]));
    let through = Curve::read(&through).unwrap();
    assert!(through.closest_point(Point3::new(1.0, 1.0, 0.0)).unwrap().distance < 1e-12);
    let between = ask(
        "curve/createtweencurves-curve_curve_int",
        json!([[[0, 0, 0], [1, 0, 0]], [[0, 2, 0], [1, 2, 0]], 1]),
    );
    at(&object(&curves(&between)[0].start()), [0.0, 1.0, 0.0]);
    near(
        &json!(
            Curve::read(&ask("curve/trim-curve_curveend_double", json!([line(), 1, 5]))).unwrap().length()
        ),
        15.0,
    );
    assert_eq!(ask("curve/trim-curve_curveend_double", json!([line(), 3, 10])), Json::Null);
    near(
        &json!(
            Curve::read(&ask("curve/extend-curve_double_double", json!([line(), -5, 25]))).unwrap().length()
        ),
        30.0,
    );
    let longer = ask("curve/extend-curve_curveend_double_curveextensionstyle", json!([line(), 2, 5, 0]));
    near(&json!(Curve::read(&longer).unwrap().length()), 25.0);
    let flat = ask("curve/projecttoplane-curve_plane", json!([[[0, 0, 0], [3, 0, 4]], object(&Plane::XY)]));
    near(&json!(Curve::read(&flat).unwrap().length()), 3.0);
    assert_eq!(curves(&ask("curve/duplicatesegments-curve", json!([square(2.0)]))).len(), 4);
    let split = ask("curve/split-curve_brep_double", json!([line(), object(&ball(0.0, 5.0)), 0.001]));
    let lengths: Vec<f64> = curves(&split).iter().map(Curve::length).collect();
    assert_eq!(lengths.len(), 3, "{lengths:?}");
    let rounded = ask(
        "curve/createfilletcornerscurve-curve_double_double_double",
        json!([square(4.0), 1, 0.001, 0.01]),
    );
    let rounded = Curve::read(&rounded).unwrap();
    assert!(rounded.length() < 16.0 && rounded.length() > 16.0 - 4.0 * (2.0 - PI / 2.0) - 1e-6);
    let fillet = ask(
        "curve/createfilletcurves-curve_point3d_curve_point3d_double_bool_bool_bool_double_double",
        json!([
            [[0, 0, 0], [10, 0, 0]],
            [0, 0, 0],
            [[5, -5, 0], [5, 5, 0]],
            [5, 5, 0],
            1,
            true,
            true,
            true,
            0.001,
            0.01
        ]),
    );
    near(&json!(curves(&fillet)[0].length()), 4.0 + PI / 2.0 + 4.0);
    let chain = ask("curve/topolyline-curve_double_double_double_double", json!([c1(), 0.01, 0, 0, 0]));
    let chain = PolylineCurve::read(&chain).unwrap();
    assert!((Curve::from(chain).length() - TAU * 5.0).abs() < 0.1);
    let simple = ask(
        "curve/simplify-curve_curvesimplifyoptions_double_double",
        json!([[[0, 0, 0], [1, 0, 0], [2, 0, 0]], 63, 0.01, 0.01]),
    );
    assert!(matches!(Curve::read(&simple).unwrap(), Curve::Line(_)));
}

#[test]
fn regions_of_curves() {
    let area = |json: &Json| curves(json).iter().map(|c| c.area_and_centroid(1e-6).unwrap().0).sum::<f64>();
    let (disc, common) = (PI * 25.0, lens(5.0, 3.0));
    near(
        &json!(area(&ask("curve/createbooleanunion-curvearray_double", json!([[c1(), c2()], 0.01])))),
        2.0 * disc - common,
    );
    near(&json!(area(&ask("curve/createbooleanintersection-curve_curve", json!([c1(), c2()])))), common);
    near(&json!(area(&ask("curve/createbooleandifference-curve_curve", json!([c1(), c2()])))), disc - common);
    near(
        &json!(area(&ask("curve/createbooleandifference-curve_curvearray", json!([c1(), [c2()]])))),
        disc - common,
    );
    let related = |a: Json, b: Json| {
        ask(
            "curve/planarclosedcurverelationship-curve_curve_plane_double",
            json!([a, b, object(&Plane::XY), 0.001]),
        )
    };
    assert_eq!(related(c1(), c2()), 1);
    assert_eq!(related(c1(), object(&circle(0.0, 1.0))), 3);
    assert_eq!(related(object(&circle(0.0, 1.0)), c1()), 2);
    assert_eq!(related(c1(), object(&circle(50.0, 1.0))), 0);
    assert_eq!(ask("curve/createbooleanunion-curvearray", json!([[line()]])), Json::Null);
}
