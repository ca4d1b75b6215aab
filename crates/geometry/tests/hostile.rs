//! Nothing panics, hangs or lies silently on numbers that are huge, tiny, equal or not numbers.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

use std::sync::atomic::{AtomicUsize, Ordering};

use katydid_geometry::isoline::Metaballs;
use katydid_geometry::region::Region;
use katydid_geometry::subd::{FromMesh, SubDNet};
use katydid_geometry::substrate::substrate;
use katydid_geometry::{
    Arc, Brep, CancellationToken, Circle, Continuity, Curve, Interval, KnotSpacing, Line, Mesh, MeshFace,
    NurbsCurve, NurbsSurface, OffsetCorner, Plane, Point2, Point3, PolyCurve, PolylineCurve, RemeshOptions,
    Sphere, Tolerance, Vector3, Waiting, Xform, cloud, construct, intersect, join_curves,
};
use proptest::prelude::*;

/// Numbers of all sizes, many of them equal.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -3_i32..4,
        1 => Just(7),
    ]
    .prop_map(f64::from)
    .prop_flat_map(|x| prop_oneof![6 => Just(x), 1 => Just(x * 1e-12), 1 => Just(x * 1e12), 1 => Just(x * 1e150), 1 => Just(x * 1e-200)])
}

fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![8 => number(), 1 => Just(f64::NAN), 1 => Just(f64::INFINITY), 1 => Just(f64::MAX), 1 => Just(-0.0)]
}

fn points(least: usize) -> impl Strategy<Value = Vec<Point3>> {
    proptest::collection::vec((number(), number(), number()), least..8)
        .prop_map(|v| v.into_iter().map(|(x, y, z)| Point3::new(x, y, z)).collect())
}

fn curve() -> impl Strategy<Value = Option<Curve>> {
    (0_usize..7, points(4), 1_usize..5, proptest::collection::vec(number(), 8)).prop_map(
        |(kind, points, degree, n)| {
            let made: Option<Curve> = match kind {
                0 => Some(Line::new(points[0], points[1]).into()),
                1 => Arc::through(points[0], points[1], points[2]).ok().map(Into::into),
                2 => PolylineCurve::new(points).ok().map(Into::into),
                3 => NurbsCurve::clamped_uniform(degree, &points).ok().map(Into::into),
                4 => NurbsCurve::periodic_uniform(degree, &points).ok().map(Into::into),
                5 => {
                    let mut knots: Vec<f64> = n.iter().take(points.len() + degree - 1).copied().collect();
                    knots.sort_by(f64::total_cmp);
                    let weights: Vec<f64> = n.iter().map(|x| x.abs() + 0.1).take(points.len()).collect();
                    NurbsCurve::with_weights(degree, &points, &weights, knots).ok().map(Into::into)
                }
                _ => NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).ok().and_then(|c| {
                    let line = Line::new(points[1], points[0]).into();
                    PolyCurve::new(vec![line, c.into()]).ok().map(Into::into)
                }),
            };
            made
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn curves_answer_every_question(c in curve(), x in wild(), y in wild(), q in (number(), number(), number())) {
        let Some(c) = c else { return Ok(()) };
        let q = Point3::new(q.0, q.1, q.2);
        let d = c.domain();
        prop_assert!(d.start < d.end);
        let t = d.at(0.3);
        let _ = (c.point_at(x), c.tangent_at(x), c.curvature_at(x), c.frame_at(x), c.torsion_at(x), c.derivatives(x, 5, true));
        let _ = (c.osculating_circle_at(t), c.curvature_graph(3, 1.0), c.curvature_samples(3), c.signed_curvature_at(t, Vector3::Z));
        let _ = (c.is_closed(), c.is_periodic(), c.plane(1e-3), c.as_line(1e-3), c.as_arc(1e-3), c.as_polyline());
        let length = c.length();
        prop_assert!(length >= 0.0 || length.is_nan() || length.is_infinite());
        let _ = (c.parameter_at_length(x), c.parameter_at_normalized_length(y), c.length_between(Interval::new(x, y)));
        let _ = (c.divide_by_count(7), c.divide_by_length(length / 5.5), c.divide_by_distance(length / 4.5));
        let b = c.bounding_box();
        let found = c.closest_point(q).unwrap();
        prop_assert!(d.contains(found.parameter));
        if b.diagonal().length() < 1e15 && q.to_vector().length() < 1e15 {
            let slack = 1e-9 * (1.0 + b.diagonal().length() + b.min.to_vector().length());
            prop_assert!(found.distance + slack >= b.distance_to(q), "{} against {}", found.distance, b.distance_to(q));
        }
        let _ = (c.trimmed(Interval::new(x, y)), c.sub_curve(Interval::new(x, y)), c.split_at(&[x, y, t]), c.with_seam(x));
        let _ = (c.with_domain(Interval::new(x, y)), c.extended_by_lines(x, y), c.offset_in_plane(&Plane::XY, x));
        let _ = (c.intersect_plane(&Plane::XZ, 1e-6), c.intersect_plane(&Plane::XY.with_origin(q), 0.0));
        let _ = (c.explode(true), c.to_nurbs(), c.perpendicular_frames(&[t, x, d.end]), c.horizontal_frame_at(t));
        let _ = (c.area_and_centroid(1e-3), c.contains_in_plane(q, &Plane::XY, 1e-3), c.hull_points());
        for kind in [Continuity::C0, Continuity::C1, Continuity::C2, Continuity::G1, Continuity::G2] {
            let _ = c.discontinuities(kind, &Tolerance::default());
        }
        let _ = c.transformed(&Xform { rows: [[x, y, 1.0, 0.0], [0.0, 1.0, x, y], [y, 0.0, 1.0, x], [0.0, 0.0, 0.0, 1.0]] });
        let _ = c.transformed(&Xform { rows: [[1.0, y, 1.0, 0.0], [0.0, 1.0, 2.0, y], [y, 0.0, 1.0, 3.0], [x, y, 0.5, 1.0]] });
        let joined = join_curves(&[c.clone(), c.reversed(), Line::new(c.end(), q).into()], 1e-3, false);
        prop_assert!(!joined.is_empty());
        if let Curve::Nurbs(n) = &c {
            let _ = (n.insert_knot(x, 2), n.raised_to(6), n.split(t), n.bezier_pieces(), n.de_boor(x), n.clamped());
            let _ = (n.with_weight(1, x), n.to_non_rational(), n.greville_abscissae(), n.distinct_control_points());
        }
    }

    #[test]
    fn simple_shapes_answer_or_refuse(v in proptest::collection::vec(wild(), 16)) {
        let p = |i: usize| Point3::new(v[i], v[i + 1], v[i + 2]);
        let w = |i: usize| p(i).to_vector();
        let _ = (w(0).unitized(), w(0).angle_to(w(3)), w(0).perpendicular(), w(0).rotated(v[9], w(3)), w(0).parallel_to(w(3), 0.1));
        let plane = Plane::from_points(p(0), p(3), p(6));
        if let Ok(plane) = plane {
            prop_assert!(plane.is_finite());
            prop_assert!((plane.x_axis.dot(plane.y_axis)).abs() < 1e-9);
        }
        let _ = (Plane::from_normal(p(0), w(3)), Plane::from_equation([v[0], v[1], v[2], v[3]]), Plane::fit(&[p(0), p(3), p(6), p(9)]));
        let _ = (Circle::through(p(0), p(3), p(6)), Circle::fit(&[p(0), p(3), p(6), p(9)]), Line::fit(&[p(0), p(3), p(6)]));
        let _ = (Arc::from_start_direction_end(p(0), w(3), p(6)), intersect::line_line(&Line::new(p(0), p(3)), &Line::new(p(6), p(9))));
        let x = Xform { rows: std::array::from_fn(|i| std::array::from_fn(|j| v[4 * i + j])) };
        if let Some(inverse) = x.inverse() {
            prop_assert!(inverse.is_finite());
        }
        let _ = (x.determinant(), x.similarity_factor(1e-9), Plane::XY.transformed(&x), Xform::rotation(v[0], w(1), p(4)));
        let _ = NurbsCurve::interpolate(3, &[p(0), p(3), p(6), p(9)], KnotSpacing::SquareRootChord, Some(w(12)), None);
        let _ = NurbsCurve::interpolate_periodic(5, &[p(0), p(3), p(6), p(9), p(12), p(2)], KnotSpacing::Uniform);
    }

    #[test]
    fn meshes_answer_or_refuse(vertices in points(3), indices in proptest::collection::vec(0_u32..9, 8), angle in wild(), q in (number(), number(), number())) {
        let faces = vec![
            MeshFace::Triangle([indices[0], indices[1], indices[2]]),
            MeshFace::Quad([indices[3], indices[4], indices[5], indices[6]]),
        ];
        let Ok(m) = Mesh::new(vertices, faces) else { return Ok(()) };
        let _ = (m.check(), m.area_and_centroid(), m.volume_and_centroid(), m.edges(), m.is_closed(), m.bounding_box());
        let _ = (m.welded(angle), m.unwelded(angle), m.flipped(), m.vertex_normals(), m.face_centers());
        let found = m.closest_point(Point3::new(q.0, q.1, q.2));
        prop_assert!(found.is_ok());
    }
}

#[test]
fn nets_that_multiply_are_refused_before_there_is_room_for_them() {
    let long = |count: usize, speed: f64| -> NurbsCurve {
        let points: Vec<Point3> =
            (0..count).map(|i| Point3::new(i as f64 * speed, (i as f64).sin(), speed)).collect();
        NurbsCurve::clamped_uniform(3, &points).unwrap()
    };
    let refused =
        |what: katydid_geometry::Result<NurbsSurface>| what.unwrap_err().to_string().contains("at most");
    assert!(refused(NurbsSurface::sum(&long(100_000, 1.0), &long(100_000, 0.5), Vector3::ZERO)));
    // No two share a knot: over those of all there would be a hundred times as many points.
    let sections: Vec<Curve> = (0..200).map(|i| long(1000 + i, 1.0 + 0.1 * i as f64).into()).collect();
    let options = construct::LoftOptions::default();
    let why = construct::loft(&sections, &options, &Tolerance::default()).unwrap_err();
    assert!(why.to_string().contains("at most 10,000,000"), "{why}");
    // The sides of a patch: its net is their product.
    let along = |a: Point3, b: Point3, count: usize| -> Curve {
        let points: Vec<Point3> = (0..count).map(|i| a + (b - a) * (i as f64 / (count - 1) as f64)).collect();
        NurbsCurve::clamped_uniform(3, &points).unwrap().into()
    };
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point3::new(x, y, x * y));
    let sides: Vec<Curve> = (0..4).map(|i| along(corners[i], corners[(i + 1) % 4], 20_000)).collect();
    assert!(construct::edge_surface(&sides, &Tolerance::default()).is_err());
}

/// A curve that turns at random, which everything takes long over.
fn tangle(count: u32, seed: f64) -> NurbsCurve {
    let place = |t: f64, a: f64, b: f64| ((t * a + seed).sin() * b).fract() * 100.0;
    let points: Vec<Point3> = (0..count)
        .map(|i| {
            let t = f64::from(i);
            Point3::new(place(t, 12.9898, 43_758.545_3), place(t, 78.233, 12_345.678), 0.0)
        })
        .collect();
    NurbsCurve::clamped_uniform(3, &points).unwrap()
}

#[test]
fn what_takes_long_ends_when_nobody_waits() {
    let tolerance = Tolerance::default();
    let [a, b]: [Curve; 2] = [tangle(200, 0.0).into(), tangle(200, 1.0).into()];
    let closed: Curve = NurbsCurve::periodic_uniform(3, &tangle(60, 0.5).control_points()).unwrap().into();
    let ring: Curve = Circle::new(Plane::YZ, 0.01).unwrap().into();
    let sections: Vec<Curve> = (0..200).map(|i| tangle(20 + i, 0.1).into()).collect();
    let zigzag: Curve = PolylineCurve::new(tangle(300, 0.0).control_points()).unwrap().into();
    let beside = zigzag.transformed(&Xform::translation(Vector3::new(0.0, 3.0, 0.0))).unwrap();
    let rung: Curve = Line::new(zigzag.start(), beside.start()).into();
    let sphere = Mesh::sphere(&Plane::XY, 1.0, 60, 60).unwrap();
    let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, 5.0).unwrap().into()).unwrap();
    let small =
        RemeshOptions { length: 0.05, iterations: 50, crease: None, points: Vec::new(), limit: 1 << 20 };
    let field = Metaballs::new(&tangle(300, 0.0).control_points(), &[1.0], &Plane::XY).unwrap();
    let unit = Interval::new(0.0, 1.0);
    let mut number = 0.5;
    let mut random = move || {
        number = (number * 997.0_f64 + 0.123).fract();
        number
    };
    let works: [(&str, &mut dyn FnMut() -> katydid_geometry::Result<()>); 17] = [
        ("offset", &mut || a.offset(&Plane::XY, 0.5, OffsetCorner::Round, &tolerance).map(drop)),
        ("region", &mut || Region::union_of(std::slice::from_ref(&closed), &Plane::XY, 1e-3).map(drop)),
        ("planar faces", &mut || Brep::planar_faces(std::slice::from_ref(&closed), &tolerance).map(drop)),
        ("loft", &mut || {
            construct::loft(&sections, &construct::LoftOptions::default(), &tolerance).map(drop)
        }),
        ("sweep", &mut || {
            construct::sweep_one(
                &a,
                std::slice::from_ref(&ring),
                &construct::SweepOptions::default(),
                &tolerance,
            )
            .map(drop)
        }),
        ("rebuild", &mut || a.rebuilt(3, 1000, false).map(drop)),
        ("nearest points", &mut || a.closest_points(&tangle(2000, 2.0).control_points()).map(drop)),
        ("curves", &mut || (0..200).try_for_each(|_| intersect::curve_curve(&a, &b, 1e-3).map(drop))),
        ("sweep along two rails", &mut || {
            construct::sweep_two([&zigzag, &beside], std::slice::from_ref(&rung), false, &tolerance).map(drop)
        }),
        ("mesh as a brep", &mut || Brep::from_mesh(&sphere, &tolerance).map(drop)),
        ("mesh as a subd", &mut || SubDNet::from_mesh(&sphere, &FromMesh::default()).map(drop)),
        ("aligned vertices", &mut || sphere.with_aligned_vertices(1e-6).map(drop)),
        ("remeshed", &mut || sphere.remeshed(&small, None).map(drop)),
        ("projected to a brep", &mut || ball.project_curve(&zigzag, Vector3::Z, &tolerance).map(drop)),
        ("extruded", &mut || construct::extrude(&zigzag, Vector3::Z, false, &tolerance).map(drop)),
        ("outlines of balls", &mut || field.isolines(0.5, 1e-4, usize::MAX).map(drop)),
        ("cracks", &mut || substrate([unit, unit], 5000, &[0.3], 0.1, &mut random).map(drop)),
    ];
    for (name, work) in works {
        let asked = std::sync::Arc::new(AtomicUsize::new(0));
        let own = asked.clone();
        let token = CancellationToken::new(move || own.fetch_add(1, Ordering::Relaxed) < 3);
        let made = token.during(work);
        let asked = asked.load(Ordering::Relaxed);
        assert!(asked > 3, "{name} asked {asked} times");
        assert_eq!(made, Err(katydid_geometry::Error::Stopped), "{name}");
        // And what was given up is given up soon.
        assert!(asked < 100, "{name} asked {asked} times");
    }
}

/// Refuses tables of more than a megabyte.
struct Megabyte;

impl Waiting for Megabyte {
    fn go_on(&self) -> bool {
        true
    }

    fn has_room(&self, bytes: u64) -> bool {
        bytes <= 1 << 20
    }
}

#[test]
fn what_takes_much_memory_asks_for_it() {
    let places: Vec<Point2> = (0..50_000).map(|i| Point2::new(f64::from(i), f64::from(i % 1013))).collect();
    let points: Vec<Point3> = places.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let polygons: Vec<Vec<usize>> = (0..20_000).map(|i| vec![i, i + 1, i + 2]).collect();
    let corners: Vec<Point3> = points.iter().chain(&points[..2]).copied().collect();
    let rows: Vec<Curve> = (0..100).map(|i| tangle(300, f64::from(i)).into()).collect();
    let options = construct::LoftOptions::default();
    let works: [(&str, &dyn Fn() -> katydid_geometry::Result<()>); 4] = [
        ("triangles", &|| cloud::Delaunay::new(&places).map(drop)),
        ("a curve through points", &|| {
            NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).map(drop)
        }),
        ("a subd", &|| SubDNet::from_polygons(corners.clone(), &polygons).map(drop)),
        ("a loft", &|| construct::loft(&rows, &options, &Tolerance::default()).map(drop)),
    ];
    for (name, work) in works {
        let made = CancellationToken::of(std::sync::Arc::new(Megabyte)).during(work);
        assert_eq!(made, Err(katydid_geometry::Error::Stopped), "{name}");
        assert!(work().is_ok(), "{name}");
    }
}
