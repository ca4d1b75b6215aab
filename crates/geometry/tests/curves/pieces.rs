//! Curves divided, joined, exploded and made longer.

use crate::common::{close, close_points};
use crate::made::{chain, circle, line, p, polyline, wave};
use katydid_geometry::{
    Arc, ArcLength, Continuity, Curve, Interval, Line, LineCurve, NurbsCurve, PolyCurve, Tolerance, Vector3,
    join_curves,
};

#[test]
fn divisions() {
    let c = wave();
    let ts = c.divide_by_count(7).unwrap();
    assert_eq!(ts.len(), 8);
    let measure = ArcLength::new(&c);
    for (i, t) in ts.iter().enumerate() {
        close(measure.length_at(*t), measure.total() * i as f64 / 7.0, 1e-12, "equal parts");
    }
    assert_eq!(circle(1.0).divide_by_count(5).unwrap().len(), 5);
    assert!(c.divide_by_count(0).is_err() && c.divide_by_count(usize::MAX).is_err());
    let straight = line(p(0.0, 0.0, 0.0), p(10.0, 0.0, 0.0));
    assert_eq!(straight.divide_by_length(3.0).unwrap().len(), 4);
    assert_eq!(straight.divide_by_length(2.5).unwrap(), vec![0.0, 2.5, 5.0, 7.5, 10.0]);
    assert_eq!(straight.divide_by_length(11.0).unwrap(), vec![0.0]);
    assert!(straight.divide_by_length(0.0).is_err() && straight.divide_by_length(f64::NAN).is_err());
    assert!(straight.divide_by_length(1e-300).is_err());
    let closed = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    assert_eq!(closed.divide_by_length(0.5).unwrap().len(), 8);
    for c in [wave(), chain(), circle(2.0)] {
        let ts = c.divide_by_distance(0.7).unwrap();
        assert!(ts.len() > 5);
        for w in ts.windows(2) {
            assert!(w[0] < w[1]);
            close(c.point_at(w[0]).distance_to(c.point_at(w[1])), 0.7, 1e-10, "chord");
            for i in 1..20 {
                let t = Interval::new(w[0], w[1]).at(f64::from(i) / 20.0);
                assert!(c.point_at(w[0]).distance_to(c.point_at(t)) < 0.7 + 1e-10, "the first such point");
            }
        }
    }
    assert_eq!(straight.divide_by_distance(2.0).unwrap().len(), 6);
    assert_eq!(straight.divide_by_distance(99.0).unwrap(), vec![0.0]);
    assert!(straight.divide_by_distance(-1.0).is_err() && straight.divide_by_distance(1e-9).is_err());
    assert_eq!(c.parameter_at_length(-1.0), None);
    assert_eq!(c.parameter_at_normalized_length(1.0), Some(c.domain().end));
}

#[test]
fn joins() {
    let (a, b, c) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0));
    let joined = join_curves(&[line(a, b), line(c, b), line(p(9.0, 9.0, 9.0), a)], 1e-3, false);
    assert_eq!(joined.len(), 1);
    assert_eq!(joined[0].as_polyline().unwrap(), [p(9.0, 9.0, 9.0), a, b, c]);
    assert!(matches!(joined[0], Curve::Polyline(_)));
    let kept = join_curves(&[line(a, b), line(c, b)], 1e-3, true);
    assert_eq!(kept.len(), 2);
    let triangle =
        join_curves(&[line(a, b), line(p(1.0, 0.0004, 0.0), c), line(c, p(0.0, 0.0003, 0.0))], 1e-3, true);
    assert_eq!(triangle.len(), 1);
    assert!(triangle[0].is_closed());
    let parts = chain().explode(true).unwrap();
    assert_eq!(parts.len(), 3);
    let mixed = [parts[2].reversed(), circle(1.0), parts[0].clone(), parts[1].clone()];
    let again = join_curves(&mixed, 1e-6, false);
    assert_eq!(again.len(), 2);
    close(again[0].length(), chain().length(), 1e-12, "joined again");
    assert_eq!(again[1], circle(1.0));
    assert!(join_curves(&[], 1.0, false).is_empty());
}

#[test]
fn explode_and_discontinuities() {
    let tolerance = Tolerance::default();
    let bent = polyline(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0)]);
    assert_eq!(bent.explode(true).unwrap().len(), 3);
    assert_eq!(bent.discontinuities(Continuity::G1, &tolerance), vec![2.0]);
    assert_eq!(bent.discontinuities(Continuity::C1, &tolerance), vec![2.0]);
    let square = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    assert_eq!(square.discontinuities(Continuity::G1, &tolerance), vec![0.0, 1.0, 2.0, 3.0]);
    assert!(circle(3.0).discontinuities(Continuity::G2, &tolerance).is_empty());
    assert!(wave().discontinuities(Continuity::C2, &tolerance).is_empty());
    let mut points: Vec<_> = (0..7).map(|i| p(f64::from(i), f64::from(i % 2), 0.0)).collect();
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0];
    let kinked: Curve = NurbsCurve::new(3, points.clone(), knots.clone()).unwrap().into();
    assert_eq!(kinked.explode(true).unwrap().len(), 2);
    points[4] = points[3] + (points[3] - points[2]);
    let smooth: Curve = NurbsCurve::new(3, points, knots).unwrap().into();
    assert_eq!(smooth.explode(true).unwrap().len(), 1);
    assert_eq!(smooth.discontinuities(Continuity::C2, &tolerance), vec![1.0]);
    let nested: Curve =
        PolyCurve::new(vec![chain(), line(p(9.0, 9.0, 0.0), p(9.0, 10.0, 0.0))]).unwrap().into();
    assert_eq!(nested.explode(true).unwrap().len(), 4);
    assert_eq!(nested.explode(false).unwrap().len(), 2);
    close_points(nested.point_at(nested.domain().end), p(9.0, 10.0, 0.0), 1e-15, "nested");
}

#[test]
fn extension_by_lines() {
    let arc: Curve =
        Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::X, p(1.0, 1.0, 0.0)).unwrap().into();
    let longer = arc.extended_by_lines(2.0, 3.0).unwrap();
    close(longer.length(), arc.length() + 5.0, 1e-13, "length");
    close_points(longer.start(), p(-2.0, 0.0, 0.0), 1e-14, "start");
    close_points(longer.end(), p(1.0, 4.0, 0.0), 1e-14, "end");
    assert!(longer.discontinuities(Continuity::G1, &Tolerance::default()).is_empty());
    let l = line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).extended_by_lines(1.0, 1.0).unwrap();
    assert_eq!(
        l,
        LineCurve { line: Line::new(p(-1.0, 0.0, 0.0), p(2.0, 0.0, 0.0)), domain: Interval::new(-1.0, 2.0) }
            .into()
    );
    assert!(circle(1.0).extended_by_lines(1.0, 0.0).is_err());
    assert!(l.extended_by_lines(-1.0, 0.0).is_err());
    assert_eq!(arc.extended_by_lines(0.0, 0.0).unwrap(), arc);
}
