//! The fast ways to evaluate agree with the general ones: batches, jets, grids.

use katydid_geometry::{
    Circle, Curve, Direction, NurbsCurve, NurbsSurface, Plane, Point3, PolyCurve, PolylineCurve, Quadrant,
    Vector3,
};

/// Numbers in −1…1 that look random.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn point(&mut self) -> Point3 {
        Point3::new(self.next(), self.next(), self.next())
    }

    /// Clamped knots with steps of very different sizes, some of them multiple.
    fn knots(&mut self, degree: usize, count: usize) -> Vec<f64> {
        let mut knots = vec![0.0; degree];
        let (mut t, mut run) = (0.0, 1);
        for _ in degree..count - 1 {
            if self.next() > -0.5 || run >= degree || t == 0.0 {
                t += 0.05 + (1.0 + self.next()).powi(3);
                run = 1;
            } else {
                run += 1;
            }
            knots.push(t);
        }
        let end = t + 1.0;
        knots.extend(std::iter::repeat_n(end, degree));
        knots
    }
}

fn curves() -> Vec<NurbsCurve> {
    let mut numbers = Numbers(7);
    let mut out = Vec::new();
    for degree in 1..=8 {
        for count in [degree + 1, degree + 2, 15] {
            let points: Vec<_> = (0..count).map(|_| numbers.point()).collect();
            let weights: Vec<_> = (0..count).map(|_| 1.5 + numbers.next()).collect();
            let knots = numbers.knots(degree, count);
            out.push(NurbsCurve::with_weights(degree, &points, &weights, knots.clone()).unwrap());
            out.push(NurbsCurve::new(degree, points, knots).unwrap());
        }
    }
    out.push(NurbsCurve::periodic_uniform(3, &(0..7).map(|_| numbers.point()).collect::<Vec<_>>()).unwrap());
    out
}

fn near(a: Vector3, b: Vector3, tolerance: f64) -> bool {
    (a - b).length() <= tolerance * (1.0 + a.length().max(b.length()))
}

#[test]
fn batches_are_as_single_points() {
    for curve in curves() {
        let domain = curve.domain();
        // Sorted from before the domain to beyond it, with every knot, and then in no order.
        let mut t: Vec<f64> = (-20..=420).map(|i| domain.at(f64::from(i) / 400.0)).collect();
        t.extend(curve.span_parameters());
        t.sort_by(f64::total_cmp);
        let shuffled: Vec<f64> = (0..t.len()).map(|i| t[i * 7919 % t.len()]).collect();
        for t in [t, shuffled] {
            let points = curve.points_at(&t);
            let jets = curve.jets_at::<4>(&t);
            for ((&t, p), jet) in t.iter().zip(points).zip(jets) {
                let inside = (domain.start..=domain.end).contains(&t);
                let single = curve.point_at(t);
                let tolerance = if inside { 1e-14 } else { 1e-9 };
                assert!(near(p.to_vector(), single.to_vector(), tolerance), "{p:?} {single:?}");
                let (point, d) = curve.derivatives(t, 3, false);
                assert!(near(point.to_vector(), single.to_vector(), tolerance));
                let one = curve.jet_at::<4>(t, false);
                for k in 1..4 {
                    let scale = if inside { 1e-9 } else { 1e-6 };
                    assert!(
                        near(jet[k], d[k - 1], scale),
                        "{} {k} {:?} {:?}",
                        curve.degree(),
                        jet[k],
                        d[k - 1]
                    );
                    assert!(near(one[k], d[k - 1], scale), "{k} {:?} {:?}", one[k], d[k - 1]);
                }
            }
        }
    }
}

#[test]
fn ends_and_sharp_knots_are_exact() {
    let mut numbers = Numbers(3);
    for degree in 1..=6 {
        let points: Vec<_> = (0..2 * degree + 1).map(|_| numbers.point()).collect();
        let third = 1.0 / 3.0;
        let mut knots = vec![0.0; degree];
        knots.extend(std::iter::repeat_n(third, degree));
        knots.extend(std::iter::repeat_n(0.7, degree));
        let curve = NurbsCurve::new(degree, points.clone(), knots).unwrap();
        for (t, i) in [(0.0, 0), (third, degree), (0.7, 2 * degree)] {
            assert_eq!(curve.point_at(t), points[i]);
            assert_eq!(curve.jet_at::<3>(t, false)[0].to_point(), points[i], "degree {degree} at {t}");
            assert_eq!(curve.jet_at::<3>(t, true)[0].to_point(), points[i], "degree {degree} below {t}");
        }
        let t: Vec<f64> = (0..=300).map(|i| f64::from(i) * 0.7 / 300.0).collect();
        let all = curve.points_at(&t);
        assert_eq!((all[0], all[300]), (points[0], points[2 * degree]));
    }
}

#[test]
fn batches_of_other_curves() {
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    let points = vec![Point3::ORIGIN, Point3::new(1.0, 2.0, 0.0), Point3::new(3.0, 2.0, 1.0)];
    let chain: Curve = PolylineCurve::new(points).unwrap().into();
    let both: Curve = PolyCurve::new(vec![circle.clone(), chain.clone()]).unwrap().into();
    for curve in [circle, chain, both] {
        let t: Vec<f64> = (0..=30).map(|i| curve.domain().at(f64::from(i) / 30.0)).collect();
        let (points, jets) = (curve.points_at(&t), curve.jets_at::<3>(&t));
        for ((&t, p), jet) in t.iter().zip(points).zip(jets) {
            let (point, d) = curve.derivatives(t, 2, false);
            assert_eq!((p, jet), (point, [point.to_vector(), d[0], d[1]]));
        }
    }
}

#[test]
fn surfaces_by_all_ways() {
    let mut numbers = Numbers(11);
    for (p, q) in
        [(1, 1), (1, 2), (2, 1), (1, 3), (3, 1), (2, 2), (2, 3), (3, 2), (3, 3), (4, 5), (5, 2), (7, 3)]
    {
        let counts = [p + 4, q + 3];
        let n = counts[0] * counts[1];
        let points: Vec<_> = (0..n).map(|_| numbers.point()).collect();
        let weights: Vec<_> = (0..n).map(|_| 1.5 + numbers.next()).collect();
        let knots = [numbers.knots(p, counts[0]), numbers.knots(q, counts[1])];
        let plain = NurbsSurface::new([p, q], counts, points.clone(), knots.clone()).unwrap();
        let rational = NurbsSurface::with_weights([p, q], counts, &points, &weights, knots).unwrap();
        for s in [plain, rational] {
            let list = |d| {
                let mut t: Vec<f64> = (0..=12).map(|i| s.domain(d).at(f64::from(i) / 12.0)).collect();
                t.extend(s.span_parameters(d));
                t
            };
            let (us, vs) = (list(Direction::U), list(Direction::V));
            let (grid, partials) = (s.points_grid(&us, &vs), s.partials_grid(&us, &vs));
            for (i, &u) in us.iter().enumerate() {
                for (j, &v) in vs.iter().enumerate() {
                    for side in
                        [Quadrant::NorthEast, Quadrant::NorthWest, Quadrant::SouthWest, Quadrant::SouthEast]
                    {
                        // Of order 3 they come from the general algorithm.
                        let want = s.derivatives(u, v, 3, side);
                        let [a, b, c] = s.partials_at(u, v, side);
                        let second = s.second_partials_at(u, v, side);
                        let first = [(a, 0, 0), (b, 1, 0), (c, 0, 1)];
                        let all = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
                        for (got, k, l) in
                            first.into_iter().chain(second.iter().zip(all).map(|(d, (k, l))| (*d, k, l)))
                        {
                            assert!(near(got, want.get(k, l), 1e-10), "{p} {q} ({k}, {l}) at {u}, {v}");
                        }
                    }
                    let at = i * vs.len() + j;
                    let want = s.partials_at(u, v, Quadrant::NorthEast);
                    assert!(near(grid[at].to_vector(), want[0], 1e-14));
                    assert!(near(s.point_at(u, v).to_vector(), want[0], 1e-14));
                    assert!((0..3).all(|k| near(partials[at][k], want[k], 1e-12)));
                }
            }
            // Corners are control points.
            let end = |d| s.domain(d).end;
            let corner = s.control_point(counts[0] - 1, counts[1] - 1).unwrap();
            assert_eq!(s.point_at(end(Direction::U), end(Direction::V)), corner);
            assert!(near(*grid.last().map(|p| p.to_vector()).as_ref().unwrap(), corner.to_vector(), 1e-15));
        }
    }
}

#[test]
fn raising_and_inserting_keep_the_curve() {
    for curve in curves() {
        let domain = curve.domain();
        let spans = curve.span_parameters();
        let mut others = vec![curve.raised_to(curve.degree() + 1).unwrap()];
        others.push(curve.raised_to(curve.degree() + 3).unwrap());
        others.push(curve.clamped().unwrap());
        for x in [0.1, 0.37, 0.9] {
            let t = domain.at(x);
            for multiplicity in [1, curve.degree()] {
                others.push(curve.insert_knot(t, multiplicity).unwrap());
            }
        }
        if let Some(&t) = spans.get(1) {
            others.push(curve.insert_knot(t, curve.degree()).unwrap());
        }
        for other in others {
            for i in 0..=100 {
                let t = domain.at(f64::from(i) / 100.0);
                assert!(
                    near(other.point_at(t).to_vector(), curve.point_at(t).to_vector(), 1e-13),
                    "{} {t}: {other:?}",
                    curve.degree()
                );
            }
        }
    }
}
