//! The inputs on which the peers were measured: a thousand closest points each on a plain and a rational curve, and
//! their lengths, against answers of global searches by scipy.

use katydid_geometry::{Curve, KnotSpacing, NurbsCurve, Point3};

fn shared(file: &str) -> Option<String> {
    crate::common::shared(&format!("kernel-bench/{file}"))
}

/// The numbers after the header of a named record, and the header's own.
fn record(text: &str, kind: &str, name: &str) -> (Vec<usize>, Vec<f64>) {
    let mut words = text.split_whitespace().peekable();
    let is_kind = |w: &str| matches!(w, "curve" | "surf" | "pts" | "prm");
    while let Some(word) = words.next() {
        if word == kind && words.peek() == Some(&name) {
            words.next();
            let count = match kind {
                "curve" => 3,
                "pts" => 1,
                _ => 2,
            };
            let header = (0..count).map(|_| words.next().unwrap().parse().unwrap()).collect();
            let rest = words.take_while(|w| !is_kind(w)).map(|w| w.parse().unwrap()).collect();
            return (header, rest);
        }
    }
    panic!("no {kind} {name}")
}

fn points(text: &str, name: &str) -> Vec<Point3> {
    record(text, "pts", name).1.chunks_exact(3).map(|c| Point3::new(c[0], c[1], c[2])).collect()
}

fn curve(text: &str, name: &str) -> NurbsCurve {
    let (header, numbers) = record(text, "curve", name);
    let (degree, count, rational) = (header[0], header[1], header[2] == 1);
    let (knots, cvs) = numbers.split_at(count + degree + 1);
    let knots = knots[1..knots.len() - 1].to_vec();
    let points: Vec<_> = cvs.chunks_exact(4).map(|c| Point3::new(c[0], c[1], c[2])).collect();
    if rational {
        let weights: Vec<f64> = cvs.chunks_exact(4).map(|c| c[3]).collect();
        NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap()
    } else {
        NurbsCurve::new(degree, points, knots).unwrap()
    }
}

#[test]
fn closest_points_and_lengths_of_the_bench_curves() {
    let (Some(inputs), Some(reference)) = (shared("inputs.txt"), shared("reference.json")) else { return };
    let reference: serde_json::Value = serde_json::from_str(&reference).unwrap();
    let queries = points(&inputs, "q_curve");
    for name in ["c_nr", "c_r"] {
        let c: Curve = curve(&inputs, name).into();
        let want = reference[format!("{name}_cp")].as_array().unwrap();
        let mut worst = f64::NEG_INFINITY;
        for (q, want) in queries.iter().zip(want) {
            let found = c.closest_point(*q).unwrap();
            worst = worst.max(found.distance - want.as_f64().unwrap());
        }
        assert!(worst < 1e-9, "{name}: {worst} above the reference");
        let length = reference[format!("{name}_len")].as_f64().unwrap();
        assert!((c.length() - length).abs() < 1e-11 * length, "{name}: {} against {length}", c.length());
    }
}

#[test]
fn a_thousand_points_interpolated() {
    let Some(inputs) = shared("inputs.txt") else { return };
    let points = points(&inputs, "interp1000");
    let c = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap();
    let spans = c.span_parameters();
    assert_eq!(spans.len(), points.len());
    for (t, p) in spans.iter().zip(&points) {
        assert!(c.point_at(*t).distance_to(*p) < 1e-10);
    }
}
