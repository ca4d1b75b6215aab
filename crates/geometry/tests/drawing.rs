//! Drawings with hidden lines against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use katydid_geometry::construct;
use katydid_geometry::drawing::{Drawing, DrawingOptions, Drawn, DrawnCurve, View, Visibility, drawing};
use katydid_geometry::silhouette::SilhouetteKind as Kind;
use katydid_geometry::{
    Box3, Brep, Circle, Curve, Cylinder, Interval, Line, Mesh, Plane, Point3, Sphere, Surface, Tolerance,
    Torus, Vector3,
};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn options() -> DrawingOptions {
    DrawingOptions {
        tangent_edges: false,
        tangent_seams: false,
        clipping: Vec::new(),
        tolerance: Tolerance::default(),
    }
}

fn draw(objects: &[Drawn], view: View, options: &DrawingOptions) -> Drawing {
    let made = drawing(objects, &view, options, &|| true).unwrap();
    assert!(made.complete);
    for one in &made.curves {
        assert!(one.curve.start().z == 0.0 && one.curve.end().z == 0.0);
    }
    made
}

fn cube([x, y, z]: [[f64; 2]; 3]) -> Brep {
    let side = |[a, b]: [f64; 2]| Interval::new(a, b);
    construct::box_brep(&Box3 { plane: Plane::XY, x: side(x), y: side(y), z: side(z) }).unwrap()
}

fn brep(one: Brep) -> Drawn {
    Drawn::Brep(Arc::new(one))
}

fn whole(surface: impl Into<Surface>) -> Drawn {
    brep(Brep::from_surface(surface.into()).unwrap())
}

fn of(made: &Drawing, visibility: Visibility) -> Vec<&DrawnCurve> {
    made.curves.iter().filter(|c| c.visibility == visibility).collect()
}

fn length<'a>(curves: impl IntoIterator<Item = &'a DrawnCurve>) -> f64 {
    curves.into_iter().map(|c| c.curve.length()).sum()
}

fn from_above() -> View {
    View::parallel(Plane::XY).unwrap()
}

/// The view along a direction.
fn along(d: Vector3) -> View {
    View::parallel(Plane::from_normal(Point3::ORIGIN, -d).unwrap()).unwrap()
}

#[test]
fn a_sphere_is_a_circle() {
    let ball = whole(Sphere::around(p(1.0, 2.0, 9.0), 5.0).unwrap());
    for view in [from_above(), along(Vector3::new(1.0, 2.0, -3.0))] {
        let made = draw(std::slice::from_ref(&ball), view, &options());
        let (seen, hidden) = (of(&made, Visibility::Visible), of(&made, Visibility::Hidden));
        assert!((length(seen.iter().copied()) - TAU * 5.0).abs() < 1e-6, "{made:?}");
        assert!(hidden.is_empty(), "{made:?}");
        let [x, y, _] = view.plane().coordinates(p(1.0, 2.0, 9.0));
        for one in seen {
            assert_eq!(one.kind, Kind::Tangent);
            let q = one.curve.point_at(one.curve.domain().at(0.3));
            assert!((q.distance_to(p(x, y, 0.0)) - 5.0).abs() < 1e-8);
        }
    }
}

#[test]
fn a_cylinder_has_rulings_and_half_of_an_ellipse_hidden() {
    let tube = whole(Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap());
    let Drawn::Brep(tube) = tube else { panic!("a brep") };
    let (solid, _) = tube.capped(&Tolerance::default()).unwrap();
    // 45° from above: ellipses with half axes 2 and √2, rulings of 10/√2.
    let made = draw(&[brep(solid)], along(Vector3::new(1.0, 0.0, -1.0)), &options());
    let ellipse = Curve::from(
        katydid_geometry::Ellipse::new(Plane::XY, 2.0, 2.0_f64.sqrt()).unwrap().to_nurbs().unwrap(),
    )
    .length();
    let seen = length(of(&made, Visibility::Visible));
    let hidden = length(of(&made, Visibility::Hidden));
    // In the picture the rulings touch the lower ellipse, whose radius of curvature is 1 there: within the tolerance of
    // 0.001 they are one for a length of √(2 · 0.001) at each of both ends.
    let touch = 2.0 * (2.0 * 0.001_f64).sqrt();
    assert!((seen - 1.5 * ellipse - 20.0 / 2.0_f64.sqrt()).abs() < touch, "{seen} {made:?}");
    assert!((hidden - 0.5 * ellipse).abs() < touch, "{hidden}");
}

#[test]
fn a_torus_from_above_and_from_the_side() {
    let ring = whole(Torus::new(Plane::XY, 5.0, 2.0).unwrap());
    let made = draw(std::slice::from_ref(&ring), from_above(), &options());
    assert!((length(of(&made, Visibility::Visible)) - TAU * 10.0).abs() < 1e-5, "{made:?}");
    assert!(of(&made, Visibility::Hidden).is_empty());
    // From the side: two lines of 10, and two half circles of 2; the inner halves of the circles are hidden.
    let made = draw(&[ring], along(Vector3::X), &options());
    let (seen, hidden) = (length(of(&made, Visibility::Visible)), length(of(&made, Visibility::Hidden)));
    // Where they part from the lines the halves are as near to them as the tolerance over 0.1 units.
    assert!((seen - 20.0 - TAU * 2.0).abs() < 0.1, "{seen} {made:?}");
    assert!((hidden - TAU * 2.0).abs() < 0.1, "{hidden} {made:?}");
}

#[test]
fn a_box_from_its_corner() {
    let cube = || cube([[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]]);
    let d = Vector3::new(-1.0, -2.0, -3.0);
    let made = draw(&[brep(cube())], along(d), &options());
    assert_eq!(of(&made, Visibility::Visible).len(), 9, "{made:?}");
    assert_eq!(of(&made, Visibility::Hidden).len(), 3);
    // From above the lower edges lie under the upper ones.
    let plan = draw(&[brep(cube())], from_above(), &options());
    assert_eq!(of(&plan, Visibility::Visible).len(), 4, "{plan:?}");
    assert_eq!(of(&plan, Visibility::Duplicate).len(), 4);
    // A mesh box has the same drawing.
    let side = Interval::new(0.0, 1.0);
    let mesh = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 1, 1, 1).unwrap();
    for view in [along(d), from_above(), along(Vector3::new(0.3, -0.2, 0.9))] {
        let a = draw(&[brep(cube())], view, &options());
        let b = draw(&[Drawn::Mesh(Arc::new(mesh.clone()))], view, &options());
        for visibility in [Visibility::Visible, Visibility::Hidden, Visibility::Duplicate] {
            assert_eq!(of(&a, visibility).len(), of(&b, visibility).len());
            assert!((length(of(&a, visibility)) - length(of(&b, visibility))).abs() < 1e-9);
        }
    }
}

#[test]
fn a_box_before_a_box_hides_by_formula() {
    // Seen from above: a plate of 4 by 4 under a plate of 2 by 2 that covers one of its corners.
    let low = cube([[0.0, 4.0], [0.0, 4.0], [0.0, 1.0]]);
    let high = cube([[3.0, 5.0], [3.0, 5.0], [5.0, 6.0]]);
    let made = draw(&[brep(low), brep(high)], from_above(), &options());
    let seen = |object| length(of(&made, Visibility::Visible).into_iter().filter(|c| c.object == object));
    let hidden = |object| length(of(&made, Visibility::Hidden).into_iter().filter(|c| c.object == object));
    assert!((seen(0) - 14.0).abs() < 1e-6, "{} {made:?}", seen(0));
    assert!((hidden(0) - 2.0).abs() < 1e-6, "{}", hidden(0));
    assert!((seen(1) - 8.0).abs() < 1e-6 && hidden(1) == 0.0);
}

#[test]
fn curves_behind_and_through_a_sphere() {
    let ball = || whole(Sphere::around(Point3::ORIGIN, 5.0).unwrap());
    let line = |a: Point3, b: Point3| Drawn::Curve(Line::new(a, b).into());
    // Under it, at a distance of 3 from its centre: a chord of 8 is hidden.
    let made = draw(&[ball(), line(p(-10.0, 3.0, -8.0), p(10.0, 3.0, -8.0))], from_above(), &options());
    let of_line = |v| length(of(&made, v).into_iter().filter(|c| c.object == 1));
    assert!((of_line(Visibility::Hidden) - 8.0).abs() < 1e-6, "{made:?}");
    assert!((of_line(Visibility::Visible) - 12.0).abs() < 1e-6);
    assert!(made.curves.iter().filter(|c| c.object == 1).all(|c| c.kind == Kind::MiscellaneousFeature));
    // Down through its top: from z = 8 over x = 0 to z = −8 over x = 3.2, hidden from where it enters.
    let (a, b) = (p(0.0, 0.0, 8.0), p(3.2, 0.0, -8.0));
    let made = draw(&[ball(), line(a, b)], from_above(), &options());
    let slope = 16.0 / 3.2_f64;
    // x² + (8 − slope x)² = 25.
    let (qa, qb, qc) = (1.0 + slope * slope, -16.0 * slope, 39.0);
    let enters = (-qb - (qb * qb - 4.0 * qa * qc).sqrt()) / (2.0 * qa);
    let of_line = |v| length(of(&made, v).into_iter().filter(|c| c.object == 1));
    assert!((of_line(Visibility::Visible) - enters).abs() < 0.01, "{enters} {made:?}");
    assert!((of_line(Visibility::Hidden) - 3.2 + enters).abs() < 0.01);
}

#[test]
fn perspective_positions() {
    let d = 10.0;
    let made = draw(
        &[brep(cube([[-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0]]))],
        View::perspective(p(0.0, 0.0, d), Plane::XY).unwrap(),
        &options(),
    );
    // The upper face is drawn as a square of half side d/(d − 1), the lower one of d/(d + 1), hidden.
    let (near, far) = (d / (d - 1.0), d / (d + 1.0));
    let seen = of(&made, Visibility::Visible);
    assert_eq!(seen.len(), 4, "{made:?}");
    for one in &seen {
        for q in [one.curve.start(), one.curve.end()] {
            assert!((q.x.abs() - near).abs() < 1e-9 && (q.y.abs() - near).abs() < 1e-9, "{q:?}");
        }
    }
    let hidden = length(of(&made, Visibility::Hidden));
    assert!((hidden - 8.0 * far - 4.0 * 2.0_f64.sqrt() * (near - far)).abs() < 1e-6, "{made:?}");
    // A sphere about the axis is a circle of the radius d r/√(d² − r²).
    let ball = whole(Sphere::around(Point3::ORIGIN, 2.0).unwrap());
    let made = draw(&[ball], View::perspective(p(0.0, 0.0, d), Plane::XY).unwrap(), &options());
    let want = TAU * d * 2.0 / 96.0_f64.sqrt();
    assert!((length(of(&made, Visibility::Visible)) - want).abs() < 1e-5, "{made:?}");
    // What is behind the camera is not drawn.
    let line = Drawn::Curve(Line::new(p(1.0, 0.0, 0.0), p(1.0, 0.0, 20.0)).into());
    let made = draw(&[line], View::perspective(p(0.0, 0.0, d), Plane::XY).unwrap(), &options());
    assert_eq!(made.curves.len(), 1);
}

#[test]
fn clipping_cuts_and_draws_the_section() {
    let mut clipped = options();
    clipped.clipping = vec![Plane::XY.offset(0.4).flipped()];
    for object in [
        brep(cube([[0.0, 2.0], [0.0, 2.0], [0.0, 1.0]])),
        Drawn::Mesh(Arc::new(
            Mesh::cuboid(
                &Box3 {
                    plane: Plane::XY,
                    x: Interval::new(0.0, 2.0),
                    y: Interval::new(0.0, 2.0),
                    z: Interval::new(0.0, 1.0),
                },
                1,
                1,
                1,
            )
            .unwrap(),
        )),
    ] {
        let made = draw(&[object], along(Vector3::new(-1.0, -2.0, -3.0)), &clipped);
        let cut: Vec<_> = made.curves.iter().filter(|c| c.kind == Kind::SectionCut).collect();
        assert!(!cut.is_empty() && cut.iter().all(|c| c.visibility == Visibility::Visible), "{made:?}");
        // Everything that is left is lower than the plane: uprights are 0.4 of what they were.
        let all = draw(
            &[brep(cube([[0.0, 2.0], [0.0, 2.0], [0.0, 0.4]]))],
            along(Vector3::new(-1.0, -2.0, -3.0)),
            &options(),
        );
        assert!((length(&made.curves) - length(&all.curves)).abs() < 1e-6);
    }
}

#[test]
fn visible_and_hidden_are_all_there_is() {
    let objects = [
        whole(Sphere::around(p(0.0, 0.0, 0.0), 3.0).unwrap()),
        whole(Torus::new(Plane::XY, 5.0, 1.0).unwrap()),
        brep(cube([[1.0, 4.0], [1.0, 3.0], [2.0, 5.0]])),
        Drawn::Curve(Circle::new(Plane::XY, 6.5).unwrap().into()),
    ];
    for d in [Vector3::new(1.0, 2.0, -3.0), Vector3::new(-2.0, 0.3, -0.7), Vector3::new(0.1, 0.2, 1.0)] {
        let together = draw(&objects, along(d), &options());
        let alone: f64 =
            objects.iter().map(|o| length(&draw(std::slice::from_ref(o), along(d), &options()).curves)).sum();
        assert!(
            (length(&together.curves) - alone).abs() < 0.05,
            "{d:?} {} {alone}",
            length(&together.curves)
        );
    }
    let _ = PI;
}

#[test]
fn seams_and_tangent_edges_are_drawn_when_asked_for() {
    let tube = whole(Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 10.0)).unwrap());
    let view = along(Vector3::new(-1.0, -0.4, -0.5));
    let without = draw(std::slice::from_ref(&tube), view, &options());
    let with = draw(&[tube], view, &DrawingOptions { tangent_seams: true, ..options() });
    assert!(without.curves.iter().all(|c| c.kind != Kind::NonSilhouetteSeam));
    assert_eq!(with.curves.iter().filter(|c| c.kind == Kind::NonSilhouetteSeam).count(), 1, "{with:?}");
}

#[test]
fn bad_input_is_refused() {
    assert!(View::parallel(Plane::XY.with_origin(p(f64::NAN, 0.0, 0.0))).is_err());
    assert!(View::perspective(p(3.0, 4.0, 0.0), Plane::XY).is_err());
    assert!(View::perspective(p(3.0, f64::INFINITY, 1.0), Plane::XY).is_err());
    let objects = [brep(cube([[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]]))];
    let none = DrawingOptions { tolerance: Tolerance { absolute: 0.0, angle: 0.1 }, ..options() };
    assert!(drawing(&objects, &from_above(), &none, &|| true).is_err());
    assert!(drawing(&objects, &from_above(), &options(), &|| false).is_err());
    assert!(drawing(&[], &from_above(), &options(), &|| true).unwrap().curves.is_empty());
}
