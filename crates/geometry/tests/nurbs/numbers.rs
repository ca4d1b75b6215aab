//! NURBS curves: the book's rows C2, C3, C9, C10 and N1 to N10, and openNURBS's answers.

use crate::common::{
    self, close, close_curves, close_points, close_vectors, curve, number, numbers, point, vector,
};
use katydid_geometry::{
    Interval, KnotSpacing, MAX_DEGREE, NurbsCurve, Point3, Vector3, bezier_to_hermite, check_knots,
    clamped_uniform_knots, de_casteljau, hermite_to_bezier,
};
use proptest::prelude::*;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn four() -> [Point3; 4] {
    [p(0.0, 0.0, 0.0), p(1.0, 3.0, 0.0), p(4.0, 3.0, 1.0), p(6.0, -1.0, 2.0)]
}

#[test]
fn oracle_curves() {
    let Some(data) = common::oracle("on_dev.json") else { return };
    let mut tried = std::collections::BTreeMap::<&str, usize>::new();
    for case in data["curves"].as_array().unwrap() {
        let (c, out) = (curve(&case["in"]), &case["out"]);
        let id = case["id"].as_str().unwrap();
        let planar = case["in"]["dim"].as_u64() == Some(2);
        assert_eq!(c.domain(), common::interval(&out["Domain"]), "{id}");
        assert_eq!(c.span_parameters().len() - 1, out["SpanCount"].as_u64().unwrap() as usize, "{id}");
        if let Some(periodic) = out["IsPeriodic"].as_bool() {
            assert_eq!(c.is_periodic(), periodic, "{id} periodic");
        }
        for e in out["eval"].as_array().unwrap() {
            let t = number(&e["t"]);
            close_points(c.point_at(t), point(&e["PointAt"]), 1e-13, id);
            let want: Vec<Vector3> = e["Der"].as_array().unwrap().iter().map(vector).collect();
            let (at, got) = c.derivatives(t, want.len() - 1, false);
            // openNURBS takes the side from below at the very end of the domain; so does the last span here.
            close_points(at, want[0].to_point(), 1e-13, id);
            for (k, (a, b)) in got.iter().zip(&want[1..]).enumerate() {
                close_vectors(*a, *b, 1e-9, &format!("{id} derivative {} at {t}", k + 1));
            }
        }
        let below = &out["DerBelowKnot"];
        if let Some(t) = below[0].as_f64() {
            let want: Vec<Vector3> = below[1].as_array().unwrap().iter().map(vector).collect();
            let (at, got) = c.derivatives(t, want.len() - 1, true);
            close_points(at, want[0].to_point(), 1e-13, id);
            for (a, b) in got.iter().zip(&want[1..]) {
                close_vectors(*a, *b, 1e-9, &format!("{id} below {t}"));
            }
        }
        for (a, b) in c.greville_abscissae().iter().zip(numbers(&out["Greville"])) {
            close(*a, b, 1e-14, id);
        }
        if let Some(length) = out["ControlPolygonLength"].as_f64().filter(|_| !planar) {
            close(c.control_polygon_length(), length, 1e-12, id);
        }
        let mut compare = |name: &'static str, ours: NurbsCurve| {
            if let Some(r) = out.get(name).and_then(|o| o.get("r")) {
                *tried.entry(name).or_default() += 1;
                close_curves(&ours, &curve(r), 1e-11, &format!("{id} {name}"));
            }
        };
        compare("IncreaseDegree1", c.raised_to(c.degree() + 1).unwrap());
        compare("Reverse", c.reversed());
        if let Some(o) = out.get("InsertKnot").filter(|o| o["ok"].as_bool() == Some(true)) {
            let multiplicity = o["mult"].as_u64().unwrap() as usize;
            compare("InsertKnot", c.insert_knot(number(&o["t"]), multiplicity).unwrap());
        }
        if let Some(o) = out.get("Transform").filter(|_| !planar) {
            let n = numbers(&o["x"]);
            let x = katydid_geometry::Xform {
                rows: std::array::from_fn(|i| std::array::from_fn(|j| n[4 * i + j])),
            };
            compare("Transform", c.transformed(&x).unwrap());
        }
        if let Some(o) = out.get("Trim") {
            compare("Trim", c.trimmed(common::interval(&o["t"])).unwrap());
        }
        if let Some(o) = out.get("Split") {
            *tried.entry("Split").or_default() += 1;
            let (a, b) = c.split(number(&o["t"])).unwrap();
            close_curves(&a, &curve(&o["r"][0]), 1e-11, &format!("{id} first part"));
            close_curves(&b, &curve(&o["r"][1]), 1e-11, &format!("{id} second part"));
        }
    }
    println!("{tried:?}");
    assert!(tried["InsertKnot"] > 30 && tried["IncreaseDegree1"] > 30 && tried["Reverse"] > 20, "{tried:?}");
}

#[test]
fn n1_degrees_and_n2_equal_weights() {
    let line: katydid_geometry::Curve = katydid_geometry::Line::new(four()[0], four()[1]).into();
    assert_eq!(line.to_nurbs().unwrap().degree(), 1);
    let circle: katydid_geometry::Curve =
        katydid_geometry::Circle::new(katydid_geometry::Plane::XY, 1.0).unwrap().into();
    let circle = circle.to_nurbs().unwrap();
    assert!(circle.degree() == 2 && circle.is_rational() && circle.point_count() == 9);
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    let equal = NurbsCurve::with_weights(3, &four(), &[2.5; 4], c.knots().to_vec()).unwrap();
    for t in [0.0, 0.2, 0.9] {
        close_points(equal.point_at(t), c.point_at(t), 1e-15, "equal weights are no weights");
    }
    assert!(NurbsCurve::clamped_uniform(4, &four()).is_err());
}

#[test]
fn n5_two_knot_vectors_two_curves_and_n9_walking_them() {
    let points: Vec<_> = (0..5).map(|i| p(f64::from(i), f64::from(i * i % 4), 0.0)).collect();
    let a = NurbsCurve::new(3, points.clone(), vec![0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]).unwrap();
    let b = NurbsCurve::new(3, points.clone(), vec![0.0, 0.0, 0.0, 1.8, 2.0, 2.0, 2.0]).unwrap();
    assert!(a.point_at(1.0).distance_to(b.point_at(1.0)) > 0.1);
    let walked: Vec<_> = (0..a.point_count()).map(|i| a.control_point(i).unwrap()).collect();
    assert_eq!(walked, points);
    assert_eq!((a.control_point(5), a.weight(4)), (None, Some(1.0)));
    assert_eq!(a.knots().iter().map(|&k| a.multiplicity(k)).collect::<Vec<_>>(), [3, 3, 3, 1, 3, 3, 3]);
}

#[test]
fn n3_knot_counts() {
    let points: Vec<_> = (0..7).map(|i| p(f64::from(i), f64::from(i % 3), 0.0)).collect();
    let c = NurbsCurve::clamped_uniform(3, &points).unwrap();
    assert_eq!((c.knots().len(), c.textbook_knots().len()), (9, 11));
    assert_eq!(c.knots(), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 4.0]);
    assert_eq!(c.textbook_knots(), [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0, 4.0, 4.0]);
    assert_eq!(c.order(), 4);
}

#[test]
fn n4_full_multiplicity_allows_a_kink() {
    let points: Vec<_> = (0..7).map(|i| p(f64::from(i), f64::from(i % 2), 0.0)).collect();
    let c = NurbsCurve::new(3, points.clone(), vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0]).unwrap();
    assert_eq!(c.multiplicity(1.0), 3);
    assert_eq!(c.point_at(1.0), points[3]);
    let (left, right) = (c.derivatives(1.0, 1, true).1[0], c.derivatives(1.0, 1, false).1[0]);
    assert!(left.cross(right).length() > 1.0);
    assert!(check_knots(3, 7, &[0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0]).is_err());
}

#[test]
fn n6_domain_and_ends() {
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    assert_eq!(c.domain(), Interval::new(0.0, 1.0));
    assert_eq!(c.point_at(0.0), four()[0]);
    assert_eq!(c.point_at(1.0), four()[3]);
}

#[test]
fn n7_clamped_uniform_and_n8_periodic_uniform() {
    let clamped = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    assert_eq!(clamped.point_count(), 4);
    assert!(clamped.is_clamped() && !clamped.is_periodic());
    let periodic = NurbsCurve::periodic_uniform(3, &four()).unwrap();
    assert_eq!(periodic.point_count(), 7);
    assert_eq!(periodic.domain(), Interval::new(0.0, 4.0));
    assert!(periodic.is_periodic());
    assert!(periodic.knots().windows(2).all(|w| w[1] - w[0] == 1.0));
    for k in 0..3 {
        let (a, b) = (periodic.derivatives(0.0, 2, false), periodic.derivatives(4.0, 2, true));
        if k == 0 {
            close_points(a.0, b.0, 1e-14, "seam")
        } else {
            close_vectors(a.1[k - 1], b.1[k - 1], 1e-13, "")
        }
    }
    assert_eq!(periodic.distinct_control_points(), four());
    let quadratic = NurbsCurve::periodic_uniform(2, &four()).unwrap();
    assert_eq!(quadratic.point_count(), 6);
    assert!(quadratic.is_periodic());
    let polygon = NurbsCurve::periodic_uniform(1, &four()).unwrap();
    assert_eq!(polygon.control_points().last(), Some(&four()[0]));
}

#[test]
fn n10_weights_in_homogeneous_form() {
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    assert!(!c.is_rational());
    let w = c.with_weight(1, 5.0).unwrap();
    assert!(w.is_rational());
    assert_eq!(w.homogeneous_point(1), Some([5.0, 15.0, 0.0, 5.0]));
    assert_eq!(w.control_point(1), c.control_point(1));
    assert_eq!(w.weights(), [1.0, 5.0, 1.0, 1.0]);
    assert!(w.point_at(0.4).distance_to(four()[1]) < c.point_at(0.4).distance_to(four()[1]));
    assert!(
        c.with_weight(9, 1.0).is_err()
            && c.with_weight(0, 0.0).is_err()
            && c.with_weight(0, f64::NAN).is_err()
    );
    let same = c.to_rational();
    close_points(same.point_at(0.3), c.point_at(0.3), 1e-15, "weights of 1");
    assert_eq!(same.to_non_rational(), Some(c));
    assert_eq!(w.to_non_rational(), None);
}

#[test]
fn c2_hermite_and_bezier_convert_exactly() {
    let (a, ta, b, tb) = bezier_to_hermite(four());
    for (x, y) in hermite_to_bezier(a, ta, b, tb).iter().zip(four()) {
        close_points(*x, y, 1e-15, "back again");
    }
    let c = NurbsCurve::bezier(&four()).unwrap();
    close_vectors(c.derivatives(0.0, 1, false).1[0], ta, 1e-15, "start derivative");
    close_vectors(c.derivatives(1.0, 1, true).1[0], tb, 1e-15, "end derivative");
}

#[test]
fn c9_de_casteljau_names_every_point() {
    let [a, b, c, d] = four();
    let t = 0.3;
    let levels = de_casteljau(&four(), t);
    let (m, n, o) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
    let (pp, q) = (m.lerp(n, t), n.lerp(o, t));
    assert_eq!(levels, vec![vec![m, n, o], vec![pp, q], vec![pp.lerp(q, t)]]);
    close_points(levels[2][0], NurbsCurve::bezier(&four()).unwrap().point_at(t), 1e-15, "R");
    assert!(de_casteljau(&[], 0.5).is_empty());
}

#[test]
fn c10_de_boor_worked_numbers() {
    let points: Vec<_> = (0..7).map(|i| p(f64::from(i), f64::from(i * i % 5), f64::from(i % 3))).collect();
    // The book prints the textbook form with one knot more at each end.
    let full = [0.0, 0.0, 0.0, 0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0, 1.0];
    let c = NurbsCurve::new(3, points.clone(), full[1..10].to_vec()).unwrap();
    assert_eq!(c.textbook_knots(), full);
    let d = c.de_boor(0.4);
    let ratios: Vec<Vec<f64>> = d.levels.iter().map(|l| l.iter().map(|s| s.ratio).collect()).collect();
    let want = [vec![0.8, 8.0 / 15.0, 0.2], vec![0.8, 0.3], vec![0.6]];
    for (a, b) in ratios.iter().flatten().zip(want.iter().flatten()) {
        close(*a, *b, 1e-15, "ratio");
    }
    assert_eq!(d.first_control_point, 1);
    let mix = |a: Point3, b: Point3, x: f64| a.lerp(b, x);
    let (a, b, cc) = (
        mix(points[1], points[2], 0.8),
        mix(points[2], points[3], 8.0 / 15.0),
        mix(points[3], points[4], 0.2),
    );
    close_points(d.levels[0][0].point, a, 1e-14, "A");
    close_points(d.levels[0][1].point, b, 1e-14, "B");
    close_points(d.levels[0][2].point, cc, 1e-14, "C");
    let (dd, e) = (mix(a, b, 0.8), mix(b, cc, 0.3));
    close_points(d.levels[1][0].point, dd, 1e-14, "D");
    close_points(d.levels[1][1].point, e, 1e-14, "E");
    close_points(d.point, mix(dd, e, 0.6), 1e-14, "F");
    close_points(d.point, c.point_at(0.4), 1e-15, "on the curve");
}

#[test]
fn interpolated_cubic_is_the_one_of_rhino() {
    let points =
        [p(0.0, 0.0, 0.0), p(3.0, 4.0, 0.0), p(-1.0, 4.0, 0.0), p(-4.0, 0.0, 0.0), p(-4.0, -3.0, 0.0)];
    let c = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap();
    assert_eq!(c.knots(), [0.0, 0.0, 0.0, 5.0, 9.0, 14.0, 17.0, 17.0, 17.0]);
    let want = [
        (0.0, 0.0),
        (1.278803, 1.06885),
        (5.265114, 4.792727),
        (-2.182465, 4.50471),
        (-4.175262, 0.712181),
        (-4.204863, -2.021209),
        (-4.0, -3.0),
    ];
    for (got, (x, y)) in c.control_points().iter().zip(want) {
        assert!(got.distance_to(p(x, y, 0.0)) < 2e-6, "{got:?}");
    }
}

#[test]
fn interpolation_goes_through_its_points() {
    let points: Vec<_> = (0..40)
        .map(|i| {
            let t = f64::from(i) * 0.37;
            p(t.cos() * (1.0 + t), 2.0 * t.sin(), (t * 1.7).sin() * 3.0)
        })
        .collect();
    for spacing in [KnotSpacing::Uniform, KnotSpacing::Chord, KnotSpacing::SquareRootChord] {
        for degree in [1, 2, 3, 4, 5, 7] {
            let c = NurbsCurve::interpolate(degree, &points, spacing, None, None).unwrap();
            let chords: Vec<f64> = points.windows(2).map(|w| w[0].distance_to(w[1])).collect();
            let mut t = 0.0;
            for (i, q) in points.iter().enumerate() {
                close_points(c.point_at(t), *q, 1e-11, &format!("degree {degree} point {i}"));
                t += chords.get(i).map_or(0.0, |&c| match spacing {
                    KnotSpacing::Uniform => 1.0,
                    KnotSpacing::Chord => c,
                    KnotSpacing::SquareRootChord => c.sqrt(),
                });
            }
            if degree % 2 == 1 {
                let c = NurbsCurve::interpolate_periodic(degree, &points, spacing).unwrap();
                close_points(c.point_at(c.domain().start), points[0], 1e-11, "start");
                close_points(c.point_at(c.domain().end), points[0], 1e-11, "end");
                close_points(c.point_at(c.span_parameters()[17]), points[17], 1e-10, "17");
                assert!(degree == 1 || c.is_periodic(), "degree {degree}");
            }
        }
    }
    let tangent = Vector3::new(0.0, 0.0, 2.0);
    let c = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, Some(tangent), Some(tangent)).unwrap();
    close_vectors(c.derivatives(0.0, 1, false).1[0], Vector3::Z, 1e-12, "given start tangent");
    close_vectors(c.derivatives(c.domain().end, 1, true).1[0], Vector3::Z, 1e-12, "given end tangent");
    let two = NurbsCurve::interpolate(3, &points[..2], KnotSpacing::Chord, None, None).unwrap();
    close_points(two.control_point(1).unwrap(), points[0].lerp(points[1], 1.0 / 3.0), 1e-14, "thirds");
}

#[test]
fn invalid_curves_are_refused_with_a_reason() {
    let knots = clamped_uniform_knots(3, 4).unwrap();
    let why = |r: katydid_geometry::Result<NurbsCurve>| r.unwrap_err().to_string();
    assert!(why(NurbsCurve::new(3, four()[..3].to_vec(), knots.clone())).contains("needs at least 4"));
    assert!(why(NurbsCurve::new(3, four().to_vec(), knots[1..].to_vec())).contains("need 6 knots, got 5"));
    assert!(why(NurbsCurve::new(0, four().to_vec(), knots.clone())).contains("degree"));
    assert!(why(NurbsCurve::new(MAX_DEGREE + 1, four().to_vec(), knots.clone())).contains("degree"));
    assert!(why(NurbsCurve::new(3, vec![p(f64::NAN, 0.0, 0.0); 4], knots.clone())).contains("finite"));
    assert!(why(NurbsCurve::new(3, four().to_vec(), vec![0.0, 0.0, 1.0, 0.5, 1.0, 1.0])).contains("smaller"));
    assert!(why(NurbsCurve::new(3, four().to_vec(), vec![0.0; 6])).contains("repeated"));
    assert!(
        why(NurbsCurve::with_weights(3, &four(), &[1.0, -1.0, 1.0, 1.0], knots.clone())).contains("weight 1")
    );
    assert!(why(NurbsCurve::with_weights(3, &four(), &[1.0; 3], knots)).contains("4 control points but 3"));
    assert!(NurbsCurve::interpolate(3, &[], KnotSpacing::Chord, None, None).is_err());
    assert!(NurbsCurve::interpolate(3, &[four()[0]; 9], KnotSpacing::Chord, None, None).is_err());
    assert!(NurbsCurve::interpolate(5, &four(), KnotSpacing::Chord, None, None).is_err());
    assert!(NurbsCurve::interpolate_periodic(5, &four(), KnotSpacing::Chord).is_err());
    assert!(NurbsCurve::clamped_uniform(3, &four()).unwrap().trimmed(Interval::new(0.5, 2.0)).is_err());
    assert!(NurbsCurve::clamped_uniform(3, &four()).unwrap().insert_knot(7.0, 1).is_err());
}

fn curves() -> impl Strategy<Value = NurbsCurve> {
    (1_usize..6, 0_usize..6, any::<bool>()).prop_flat_map(|(degree, more, rational)| {
        let count = degree + 1 + more;
        (
            proptest::collection::vec(proptest::array::uniform3(-10.0..10.0_f64), count),
            proptest::collection::vec(0.2..3.0_f64, count),
            proptest::collection::vec(0.05..2.0_f64, count - degree),
        )
            .prop_map(move |(points, weights, steps)| {
                let mut knots = vec![0.0; degree];
                let mut t = 0.0;
                for s in steps {
                    t += s;
                    knots.push(t);
                }
                knots.extend(std::iter::repeat_n(t, degree - 1));
                let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
                if rational {
                    NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap()
                } else {
                    NurbsCurve::new(degree, points, knots).unwrap()
                }
            })
    })
}

proptest! {
    #[test]
    fn c3_knot_insertion_degree_raising_and_parts_keep_the_shape(c in curves(), x in 0.01..0.99_f64, y in 0.0..1.0_f64) {
        let domain = c.domain();
        let (t, s) = (domain.at(x), domain.at(y));
        let want = c.point_at(s);
        prop_assert!(c.insert_knot(t, 1).unwrap().point_at(s).distance_to(want) < 1e-11);
        prop_assert!(c.insert_knot(t, c.degree()).unwrap().point_at(s).distance_to(want) < 1e-11);
        prop_assert!(c.raised_to(c.degree() + 2).unwrap().point_at(s).distance_to(want) < 1e-10);
        prop_assert!(c.reversed().point_at(-s).distance_to(want) < 1e-11);
        let moved = c.with_domain(Interval::new(3.0, 8.0)).unwrap();
        prop_assert!(moved.point_at(Interval::new(3.0, 8.0).at(y)).distance_to(want) < 1e-10);
        let (a, b) = c.split(t).unwrap();
        let part = if s <= t { &a } else { &b };
        prop_assert!(part.point_at(s).distance_to(want) < 1e-10);
        prop_assert!(a.point_at(t).distance_to(b.point_at(t)) < 1e-11);
        for piece in c.bezier_pieces().unwrap() {
            if piece.domain().contains(s) {
                prop_assert!(piece.point_at(s).distance_to(want) < 1e-9);
            }
        }
        let many = c.points_at(&[s, t, s]);
        prop_assert_eq!(many[0], want);
        prop_assert_eq!(many[1], c.point_at(t));
    }
}
