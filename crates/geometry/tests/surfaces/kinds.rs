//! Planes, sums, revolutions and primitives: other kernels' answers, closed forms and laws.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::common::{
    self, close, close_points, close_surfaces, close_vectors, curve, number, oracle, plane, point, surface,
};
use katydid_geometry::{
    Arc, Circle, Cone, Curve, Cylinder, Direction, Interval, Line, LineCurve, NurbsCurve, NurbsSurface,
    Plane, PlaneSurface, Point3, RevolutionSurface, Side, Sphere, SumSurface, Surface, Torus, Vector3, Xform,
};
use serde_json::Value;

fn cases(data: &Value, kind: &str) -> Vec<Value> {
    data["primitives"].as_array().unwrap().iter().filter(|c| c["in"]["f"] == kind).cloned().collect()
}

fn tilted() -> Plane {
    Plane::from_axes(Point3::new(1.0, -2.0, 0.5), Vector3::new(1.0, 2.0, 0.3), Vector3::new(-1.0, 1.0, 2.0))
        .unwrap()
}

fn axis_z() -> Line {
    Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0))
}

#[test]
fn spheres_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for c in cases(&data, "Sphere") {
        let (id, out) = (c["id"].as_str().unwrap(), &c["out"]);
        let sphere = Sphere::around(point(&c["in"]["c"]), number(&c["in"]["r"])).unwrap();
        close_surfaces(&sphere.to_nurbs().unwrap(), &surface(&out["Nurbs"]), 1e-14, id);
        let q = point(&c["in"]["q"]);
        close_points(sphere.closest_point(q), point(&out["ClosestPoint"]), 1e-13, id);
        let (u, v) = sphere.closest_parameters(q).unwrap();
        close(u, number(&out["ClosestParameter"][1]), 1e-14, id);
        close(v, number(&out["ClosestParameter"][2]), 1e-14, id);
        let at = &out["PointAt"];
        let p = sphere.point_at(number(&at[0]), number(&at[1]));
        close_points(p, point(&at[2]), 1e-13, id);
        let surface = Surface::from(sphere);
        close_points(surface.point_at(number(&at[0]), number(&at[1])), p, 1e-14, id);
        let told = Surface::from(sphere.to_nurbs().unwrap()).as_sphere(1e-9).unwrap();
        close(told.radius, sphere.radius, 1e-12, id);
        close_points(told.center(), sphere.center(), 1e-12, id);
    }
}

#[test]
fn cylinders_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for c in cases(&data, "Cylinder") {
        let (id, input) = (c["id"].as_str().unwrap(), &c["in"]);
        let (r, h) = (number(&input["r"]), number(&input["h"]));
        let cylinder = Cylinder::new(plane(&input["plane"]), r, Interval::new(0.0, h)).unwrap();
        let nurbs = cylinder.to_nurbs().unwrap();
        close_surfaces(&nurbs, &surface(&c["out"]["Nurbs"]), 1e-14, id);
        let told = Surface::from(nurbs).as_cylinder(1e-9).unwrap();
        close(told.radius, r, 1e-11, id);
        close(told.height.length(), h, 1e-11, id);
    }
}

#[test]
fn revolutions_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for c in cases(&data, "RevSurface caps") {
        let id = c["id"].as_str().unwrap();
        let profile = curve(&c["in"]["profile"]);
        let s = RevolutionSurface::new(profile.into(), axis_z(), Interval::new(0.0, TAU)).unwrap();
        close_surfaces(&s.to_nurbs().unwrap(), &surface(&c["out"]["Nurbs"]), 1e-14, id);
        for at in c["out"]["PointAt"].as_array().unwrap() {
            close_points(s.point_at(number(&at[0]), number(&at[1])), point(&at[2]), 1e-13, id);
        }
    }
}

#[test]
fn extrusions_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for c in cases(&data, "Extrusion.Create circle") {
        let id = c["id"].as_str().unwrap();
        let circle = Circle::new(Plane::XY.with_origin(point(&c["in"]["c"])), number(&c["in"]["r"])).unwrap();
        let up = Vector3::new(0.0, 0.0, number(&c["in"]["h"]));
        let s = SumSurface::extrusion(circle.to_nurbs().unwrap().into(), up).unwrap();
        for (i, d) in Direction::BOTH.into_iter().enumerate() {
            close(s.domain(d).end, number(&c["out"]["Domain"][i][1]), 1e-15, id);
        }
        for at in c["out"]["PointAt"].as_array().unwrap() {
            close_points(s.point_at(number(&at[0]), number(&at[1])), point(&at[2]), 1e-13, id);
        }
    }
}

#[test]
fn curvature_agrees() {
    let Some(data) = oracle("occ_dev.json") else { return };
    for case in data["curvature"].as_array().unwrap() {
        let s = Surface::from(surface(&case["in"]));
        for e in case["eval"].as_array().unwrap() {
            let c = s.curvature_at(number(&e["uv"][0]), number(&e["uv"][1])).unwrap();
            close_vectors(c.normal, common::vector(&e["n"]), 1e-12, "normal");
            close(c.gaussian, number(&e["K"]), 1e-12, "Gaussian");
            close(c.mean, number(&e["H"]), 1e-12, "mean");
            close(c.principal[0], number(&e["k1"]), 1e-12, "k1");
            close(c.principal[1], number(&e["k2"]), 1e-12, "k2");
        }
    }
}

/// Every kind of surface, none of them over a domain that starts at 0.
fn zoo() -> Vec<Surface> {
    let p = tilted();
    let arc: katydid_geometry::Curve =
        katydid_geometry::Arc::new(Circle::new(p, 2.0).unwrap(), Interval::new(0.3, 2.0)).unwrap().into();
    let weights = [1.0, 2.0, 0.7, 1.3, 1.0, 0.9, 1.5, 1.0, 0.8, 1.0, 1.1, 2.0];
    let net: Vec<Point3> = (0..12)
        .map(|k| Point3::new(f64::from(k / 4), f64::from(k % 4) * 1.1, f64::from((k * 7) % 5) * 0.4))
        .collect();
    let knots = [vec![1.0, 1.0, 2.0, 2.0], vec![-1.0, -1.0, 0.5, 2.0, 2.0]];
    vec![
        PlaneSurface::with_domains(
            p,
            [Interval::new(-1.0, 2.0), Interval::new(1.0, 4.0)],
            [Interval::new(3.0, 5.0), Interval::new(-2.0, -1.0)],
        )
        .unwrap()
        .into(),
        SumSurface::new(
            arc.clone(),
            Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0)).into(),
            Vector3::X,
        )
        .unwrap()
        .into(),
        RevolutionSurface::with_domain(arc, axis_z(), Interval::new(0.2, 2.7), Interval::new(5.0, 6.0))
            .unwrap()
            .into(),
        NurbsSurface::with_weights([2, 2], [3, 4], &net, &weights, knots).unwrap().into(),
        Torus::new(p, 3.0, 1.0).unwrap().into(),
    ]
}

fn inside(s: &Surface) -> [(f64, f64); 4] {
    let [u, v] = Direction::BOTH.map(|d| s.domain(d));
    [(0.1, 0.2), (0.45, 0.6), (0.83, 0.31), (0.0, 1.0)].map(|(x, y)| (u.at(x), v.at(y)))
}

#[test]
fn derivatives_are_differences() {
    for s in zoo() {
        for (u, v) in &inside(&s)[..3] {
            let (u, v, h) = (*u, *v, 1e-5);
            let side = s.inner_quadrant(u, v);
            let d = s.derivatives(u, v, 3, side);
            close_points(d.point(), s.point_at(u, v), 1e-14, "point");
            for n in 0..3 {
                for j in 0..=n {
                    let i = n - j;
                    let at = |x: f64, y: f64| s.derivatives(x, y, n, side).get(i, j);
                    let along_u = (at(u + h, v) - at(u - h, v)) / (2.0 * h);
                    let along_v = (at(u, v + h) - at(u, v - h)) / (2.0 * h);
                    let scale = 1.0 + d.get(i + 1, j).length() + d.get(i, j + 1).length();
                    assert!((along_u - d.get(i + 1, j)).length() < 1e-4 * scale, "u {i} {j}");
                    assert!((along_v - d.get(i, j + 1)).length() < 1e-4 * scale, "v {i} {j}");
                }
            }
        }
    }
}

#[test]
fn edits_keep_the_points() {
    for s in zoo() {
        let [du, dv] = Direction::BOTH.map(|d| s.domain(d));
        for (u, v) in inside(&s) {
            let p = s.point_at(u, v);
            let n = s.normal_at(u, v).unwrap();
            let t = s.transposed();
            close_points(t.point_at(v, u), p, 1e-13, "transposed");
            close_vectors(t.normal_at(v, u).unwrap(), -n, 1e-12, "transposed normal");
            close_points(s.reversed(Direction::U).point_at(-u, v), p, 1e-13, "reversed u");
            close_points(s.reversed(Direction::V).point_at(u, -v), p, 1e-13, "reversed v");
            close_vectors(s.reversed(Direction::V).normal_at(u, -v).unwrap(), -n, 1e-12, "reversed normal");
            let moved = s.with_domain(Direction::U, Interval::new(-3.0, 9.0)).unwrap();
            close_points(moved.point_at(-3.0 + 12.0 * du.normalized(u), v), p, 1e-12, "domain");
            for d in Direction::BOTH {
                let t = s.domain(d).at(0.4);
                let (a, b) = s.split(d, t).unwrap();
                let own = if d == Direction::U { u } else { v };
                close_points(if own <= t { a } else { b }.point_at(u, v), p, 1e-12, "split");
                let iso = s.isocurve(d, if d == Direction::U { v } else { u }).unwrap();
                close_points(iso.point_at(own), p, 1e-12, "isocurve");
                assert_eq!(iso.domain(), s.domain(d));
            }
            let rotation =
                Xform::rotation(0.7, Vector3::new(1.0, 2.0, -1.0), Point3::new(3.0, 1.0, 0.0)).unwrap();
            let mirror = Xform::mirror(&tilted()) * Xform::scale(Point3::new(1.0, 0.0, 2.0), 2.5);
            for x in [rotation, mirror] {
                let image = s.transformed(&x).unwrap();
                assert_eq!(std::mem::discriminant(&image), std::mem::discriminant(&s));
                close_points(image.point_at(u, v), x.point(p), 1e-12, "image");
            }
        }
        let b = s.bounding_box().unwrap().inflated(1e-9);
        for i in 0..=10 {
            for j in 0..=10 {
                assert!(b.contains(s.point_at(du.at(f64::from(i) / 10.0), dv.at(f64::from(j) / 10.0))));
            }
        }
    }
}

#[test]
fn a_squeezed_sphere_is_an_exact_ellipsoid() {
    let sphere = Sphere::around(Point3::ORIGIN, 2.0).unwrap();
    let squeeze = Xform::scale_non_uniform(&Plane::XY, 1.0, 2.0, 0.5);
    let s = Surface::from(sphere).transformed(&squeeze).unwrap();
    assert!(matches!(s, Surface::Nurbs(_)));
    for i in 0..=12 {
        for j in 0..=8 {
            let p = s.point_at(TAU * f64::from(i) / 12.0, -FRAC_PI_2 + PI * f64::from(j) / 8.0);
            let q = (p.x * p.x / 4.0) + (p.y * p.y / 16.0) + p.z * p.z;
            close(q, 1.0, 1e-14, "ellipsoid");
        }
    }
    let b = s.bounding_box().unwrap();
    close_points(b.max, Point3::new(2.0, 4.0, 1.0), 1e-12, "box");
    close_points(b.min, Point3::new(-2.0, -4.0, -1.0), 1e-12, "box");
}

#[test]
fn projective_images_are_exact() {
    let mut x = Xform::IDENTITY;
    x.rows[3] = [0.05, 0.02, -0.03, 1.2];
    for s in zoo() {
        let s: Surface = s.to_nurbs().unwrap().into();
        let image = s.transformed(&x).unwrap();
        for (u, v) in inside(&s) {
            close_points(image.point_at(u, v), x.point(s.point_at(u, v)), 1e-12, "projected");
        }
    }
}

#[test]
fn normals_at_poles_and_apex() {
    let sphere = Sphere::new(tilted(), 1.5).unwrap();
    for s in [Surface::from(sphere), sphere.to_nurbs().unwrap().into()] {
        for u in [0.0, 1.0, 4.0, TAU] {
            close_vectors(s.normal_at(u, FRAC_PI_2).unwrap(), tilted().z_axis, 1e-12, "north");
            close_vectors(s.normal_at(u, -FRAC_PI_2).unwrap(), -tilted().z_axis, 1e-12, "south");
            close_vectors(s.normal_at(u, FRAC_PI_2 - 1e-9).unwrap(), tilted().z_axis, 1e-7, "near north");
            assert!(s.frame_at(u, FRAC_PI_2).is_some());
            assert!(s.curvature_at(u, FRAC_PI_2).is_err());
        }
        assert!(s.is_closed(Direction::U) && !s.is_closed(Direction::V) && s.is_solid());
        assert!(s.is_singular(Side::South) && s.is_singular(Side::North) && !s.is_singular(Side::East));
        assert!(s.is_at_singularity(1.0, FRAC_PI_2) && s.is_at_seam(0.0, 0.0) == [true, false]);
    }
    for height in [2.0, -2.0] {
        let cone = Cone::new(tilted(), height, 1.0).unwrap();
        let s = Surface::from(cone);
        for u in [0.0, 1.0, 4.0, TAU] {
            close_vectors(s.normal_at(u, 0.0).unwrap(), cone.normal_at(u), 1e-12, "apex");
            close_points(s.point_at(u, 0.5 * height), cone.point_at(u, 0.5 * height), 1e-14, "cone");
            close_vectors(s.normal_at(u, 0.5 * height).unwrap(), cone.normal_at(u), 1e-13, "ruling");
        }
        let told = Surface::from(cone.to_nurbs().unwrap()).as_cone(1e-9).unwrap();
        close_points(told.apex(), cone.apex(), 1e-10, "apex");
        close(told.half_angle(), cone.half_angle(), 1e-10, "half angle");
    }
    // A triangle: the normal at the corner where a side collapsed.
    let t =
        NurbsSurface::from_triangle(Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0), Point3::new(0.0, 3.0, 0.0));
    let t = Surface::from(t.unwrap());
    assert!(t.is_singular(Side::North));
    close_vectors(t.normal_at(0.7, 3.0).unwrap(), Vector3::Z, 1e-14, "triangle");
    // A curve has no normal anywhere.
    let a = Point3::ORIGIN;
    let line =
        NurbsSurface::from_corners(a, Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 0.0, 0.0), a).unwrap();
    assert_eq!(Surface::from(line).normal_at(0.5, 0.5), None);
}

#[test]
fn primitives_bend_as_they_should() {
    let p = tilted();
    let (sphere, cylinder, torus) = (
        Surface::from(Sphere::new(p, 2.0).unwrap()),
        Surface::from(Cylinder::new(p, 2.0, Interval::new(-1.0, 4.0)).unwrap()),
        Torus::new(p, 3.0, 1.0).unwrap(),
    );
    for (u, v) in [(0.0, 0.0), (1.3, 0.7), (4.0, -1.0)] {
        for s in [sphere.clone(), sphere.to_nurbs().unwrap().into()] {
            let c = s.curvature_at(u, v).unwrap();
            close(c.gaussian, 0.25, 1e-13, "sphere K");
            close(c.mean, -0.5, 1e-13, "sphere H");
            assert!(c.is_umbilic(1e-12));
            // Directions are an orthonormal frame even where all are equal.
            close(c.directions[0].dot(c.directions[1]), 0.0, 1e-15, "right angle");
            close_vectors(c.directions[0].cross(c.directions[1]), c.normal, 1e-14, "frame");
        }
        let c = cylinder.curvature_at(u, v).unwrap();
        close(c.gaussian, 0.0, 1e-15, "cylinder K");
        close(c.mean, -0.25, 1e-14, "cylinder H");
        close(c.directions[0].dot(p.z_axis).abs(), 1.0, 1e-14, "along the axis");
        let s = Surface::from(torus);
        let c = s.curvature_at(u, v).unwrap();
        let round = -v.cos() / (3.0 + v.cos());
        close(c.gaussian, -round, 1e-13, "torus K");
        close(c.mean, 0.5 * (round - 1.0), 1e-13, "torus H");
        close_vectors(c.normal, torus.normal_at(u, v), 1e-13, "torus normal");
    }
    let told = Surface::from(torus.to_nurbs().unwrap()).as_torus(1e-9).unwrap();
    close(told.major_radius, 3.0, 1e-10, "major");
    close(told.minor_radius, 1.0, 1e-10, "minor");
    assert!(sphere.as_cylinder(1e-6).is_none() && cylinder.as_sphere(1e-6).is_none());
    assert!(sphere.as_torus(1e-6).is_none() && cylinder.as_cone(1e-6).is_none());
}

/// Sections by Euler's formula, by the curve of the cut, and by walking along the cut with Newton's method.
#[test]
fn normal_sections_agree() {
    for s in &zoo()[1..] {
        for (u, v) in &inside(s)[..3] {
            let c = s.curvature_at(*u, *v).unwrap();
            for k in 0..7 {
                let (sin, cos) = (f64::from(k) * 0.9).sin_cos();
                let direction = c.directions[0] * cos + c.directions[1] * sin;
                let section = s.normal_section(*u, *v, direction).unwrap();
                close(section.by_euler, section.by_cutting, 1e-11, "Euler");
                let euler = c.principal[0] * cos * cos + c.principal[1] * sin * sin;
                close(section.by_euler, euler, 1e-12, "k1 cos² + k2 sin²");
                let h = 1e-3;
                let walk = |h: f64| {
                    let (mut x, mut y) = (*u, *v);
                    for _ in 0..20 {
                        let d = s.derivatives(x, y, 1, s.inner_quadrant(*u, *v));
                        let [a, _, e] = section.plane.coordinates(d.point());
                        let (a, e) = (h - a, -e);
                        let (x_axis, z_axis) = (section.plane.x_axis, section.plane.z_axis);
                        let [p, q] = [d.get(1, 0), d.get(0, 1)].map(|t| (t.dot(x_axis), t.dot(z_axis)));
                        let det = p.0 * q.1 - q.0 * p.1;
                        x += (a * q.1 - q.0 * e) / det;
                        y += (p.0 * e - a * p.1) / det;
                    }
                    section.plane.coordinates(s.point_at(x, y))[1]
                };
                let walked = (walk(h) + walk(-h)) / (h * h);
                close(section.by_cutting, walked, 1e-3, "walked");
            }
            assert!(s.normal_section(*u, *v, c.normal).is_err());
        }
    }
}

/// Enneper's surface is bicubic: x = u − u³/3 + uv², y = v − v³/3 + vu², z = u² − v², over −1…1.
#[test]
fn enneper_is_minimal() {
    // Blossoms of the powers at the Bézier points of −1…1.
    let power = |n: usize, k: usize| -> f64 {
        let ones: [f64; 3] = std::array::from_fn(|i| if i < k { 1.0 } else { -1.0 });
        let (e1, e3) = (ones.iter().sum::<f64>(), ones.iter().product::<f64>());
        let e2 = ones[0] * ones[1] + ones[1] * ones[2] + ones[2] * ones[0];
        [1.0, e1 / 3.0, e2 / 3.0, e3][n]
    };
    let mut net = Vec::new();
    for i in 0..4 {
        for j in 0..4 {
            let (u, v) = (|n| power(n, i), |n| power(n, j));
            net.push(Point3::new(
                u(1) - u(3) / 3.0 + u(1) * v(2),
                v(1) - v(3) / 3.0 + v(1) * u(2),
                u(2) - v(2),
            ));
        }
    }
    let whole = Interval::new(-1.0, 1.0);
    let s = Surface::from(NurbsSurface::bezier([4, 4], &net).unwrap());
    let s = s.with_domain(Direction::U, whole).unwrap().with_domain(Direction::V, whole).unwrap();
    for i in -5..=5 {
        for j in -5..=5 {
            let (u, v) = (f64::from(i) / 5.0, f64::from(j) / 5.0);
            let wanted =
                Point3::new(u - u.powi(3) / 3.0 + u * v * v, v - v.powi(3) / 3.0 + v * u * u, u * u - v * v);
            close_points(s.point_at(u, v), wanted, 1e-14, "Enneper");
            let c = s.curvature_at(u, v).unwrap();
            let k = -4.0 / (1.0 + u * u + v * v).powi(4);
            close(c.mean, 0.0, 1e-13, "mean");
            close(c.gaussian, k, 1e-13, "Gaussian");
        }
    }
}

/// The catenary through 400 points by a quintic: the profile is off by some 1e-12, its second derivative by 1e-8.
#[test]
fn catenoid_is_minimal() {
    let points: Vec<Point3> = (0..400)
        .map(|i| {
            let z = -1.0 + f64::from(i) / 199.5;
            Point3::new(z.cosh(), 0.0, z)
        })
        .collect();
    let profile =
        NurbsCurve::interpolate(5, &points, katydid_geometry::KnotSpacing::Chord, None, None).unwrap();
    let s: Surface =
        RevolutionSurface::new(profile.into(), axis_z(), Interval::new(0.0, TAU)).unwrap().into();
    let v = s.domain(Direction::V);
    for i in 1..20 {
        let c = s.curvature_at(0.7, v.at(f64::from(i) / 20.0)).unwrap();
        close(c.mean, 0.0, 1e-7, "mean");
        close(c.gaussian, -1.0 / c.point.z.cosh().powi(4), 1e-6, "Gaussian");
    }
}

/// The helicoid (v cos u, v sin u, u) is ruled between the helices v = ±1; these by quintics.
#[test]
fn helicoid_is_minimal() {
    let helix = |r: f64| {
        let points: Vec<Point3> = (0..300)
            .map(|i| {
                let u = f64::from(i) / 299.0 * PI;
                Point3::new(r * u.cos(), r * u.sin(), u)
            })
            .collect();
        NurbsCurve::interpolate(5, &points, katydid_geometry::KnotSpacing::Uniform, None, None).unwrap()
    };
    let s = Surface::from(NurbsSurface::ruled(&helix(-1.0), &helix(1.0)).unwrap());
    let d = s.domain(Direction::U);
    for (x, v) in [(0.2, 0.5), (0.5, 0.1), (0.77, 0.9)] {
        let c = s.curvature_at(d.at(x), v).unwrap();
        let r = 2.0 * v - 1.0;
        close(c.mean, 0.0, 1e-7, "mean");
        close(c.gaussian, -1.0 / (1.0 + r * r).powi(2), 1e-6, "Gaussian");
    }
}

#[test]
fn planes_are_told() {
    let s = PlaneSurface::new(tilted(), Interval::new(0.0, 2.0), Interval::new(0.0, 3.0)).unwrap();
    let s = Surface::from(s);
    let n = Surface::from(s.to_nurbs().unwrap());
    assert!(n.is_planar(1e-12) && s.is_planar(0.0) && s.has_four_corners());
    close_vectors(n.plane(1e-12).unwrap().z_axis, tilted().z_axis, 1e-13, "normal");
    let disc = SumSurface::extrusion(
        LineCurve::new(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))).into(),
        Vector3::Y,
    );
    assert!(Surface::from(disc.unwrap()).is_planar(1e-12));
    assert!(!Surface::from(Sphere::around(Point3::ORIGIN, 1.0).unwrap()).is_planar(1e-3));
}

#[test]
fn nearest_points_of_primitives() {
    let p = tilted();
    let cylinder = Cylinder::new(p, 1.0, Interval::new(0.0, 2.0)).unwrap();
    let (cone, torus) = (Cone::new(p, 2.0, 1.0).unwrap(), Torus::new(p, 3.0, 1.0).unwrap());
    for k in 0..40 {
        let x = f64::from(k);
        let q = p.at(4.0 * (x * 1.7).sin(), 4.0 * (x * 2.3).cos(), 3.0 * (x * 0.9).sin());
        let near = |found: Point3, at: &dyn Fn(f64, f64) -> Point3, v: Interval| {
            for i in 0..=40 {
                for j in 0..=40 {
                    let other = at(TAU * f64::from(i) / 40.0, v.at(f64::from(j) / 40.0));
                    assert!(found.distance_to(q) <= other.distance_to(q) + 1e-12);
                }
            }
        };
        near(cylinder.closest_point(q), &|u, v| cylinder.point_at(u, v), cylinder.height);
        near(cone.closest_point(q), &|u, v| cone.point_at(u, v), Interval::new(0.0, 2.0));
        near(torus.closest_point(q), &|u, v| torus.point_at(u, v), Interval::new(0.0, TAU));
    }
}

#[test]
fn small_circles_far_out_have_axes_at_right_angles() {
    let apex = Point3::new(-93511.881546, 31413.288701, 65376.561825);
    let unit =
        Vector3::new(0.7122798681047309, -0.21115729080591944, -0.6693803014969978).unitized().unwrap();
    let side = unit.cross(Vector3::Z).unitized().unwrap();
    let profile = Line::new(apex + side * 1e-7, apex + unit * 37369.98 + side * 23790.47);
    // The axis begins far from the small circle.
    let axis = Line::new(apex + unit * 37369.98, apex + unit * 37370.98);
    let turn = Interval::new(0.0, TAU);
    let cone = RevolutionSurface::new(profile.into(), axis, turn).unwrap();
    let start = cone.profile().domain().start;
    let Curve::Arc(circle) = Surface::from(cone).isocurve(Direction::U, start).unwrap() else { panic!() };
    let plane = circle.arc.circle.plane;
    for (a, b) in [(plane.x_axis, plane.y_axis), (plane.x_axis, plane.z_axis), (plane.y_axis, plane.z_axis)] {
        assert!(a.dot(b).abs() < 1e-14 && (a.length() - 1.0).abs() < 1e-14, "{plane:?}");
    }
}

/// A wall of flat parts and roundings: the radius of a flat part is that of rounding, and a sphere so large holds nothing.
#[test]
fn flat_parts_tell_no_huge_sphere() {
    let wall = |turn: f64| -> Surface {
        let plane = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 2.0, 3.0)).unwrap().rotated(turn);
        let at = |x: f64, y: f64| plane.at(x, y, 0.0);
        let corner = Plane::from_axes(at(3.0, 1.0), -plane.y_axis, plane.x_axis).unwrap();
        let round = Arc::new(Circle::new(corner, 1.0).unwrap(), Interval::new(0.0, FRAC_PI_2)).unwrap();
        let parts: [Curve; 3] = [
            Line::new(at(0.0, 0.0), at(3.0, 0.0)).into(),
            round.into(),
            Line::new(at(4.0, 1.0), at(4.0, 3.0)).into(),
        ];
        let profile = katydid_geometry::join_curves(&parts, 1e-9, false).remove(0).to_nurbs().unwrap();
        SumSurface::extrusion(profile.into(), plane.z_axis * 2.0).unwrap().into()
    };
    for k in 0..200 {
        let sum = wall(0.1 * f64::from(k));
        for s in [sum.to_nurbs().unwrap().into(), sum] {
            let told = [
                s.as_sphere(1e-9).map(|s| s.radius),
                s.as_cylinder(1e-9).map(|c| c.radius),
                s.as_cone(1e-9).map(|c| c.radius),
                s.as_torus(1e-9).map(|t| t.major_radius),
            ];
            assert_eq!(told, [None; 4], "{k}");
        }
    }
}
