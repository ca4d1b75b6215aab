use katydid_component::testing::Trial;
use katydid_data::{Tree, Value};
use katydid_geometry::{
    Box3, Circle, Curve, Interval, Line, Mesh, Plane, PlaneSurface, Point3, PolylineCurve, Rectangle,
    Surface, Vector3,
};

fn first(trial: Trial) -> Value {
    trial.run().outputs[0].column().get(0).unwrap()
}

fn curve(trial: Trial) -> std::sync::Arc<Curve> {
    match first(trial) {
        Value::Curve(curve) => curve,
        other => panic!("{other:?}"),
    }
}

fn mesh(trial: Trial) -> std::sync::Arc<Mesh> {
    match first(trial) {
        Value::Mesh(mesh) => mesh,
        other => panic!("{other:?}"),
    }
}

fn circle(radius: f64, height: f64) -> Curve {
    let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, height));
    Curve::from(Circle::new(plane, radius).unwrap())
}

fn segment(from: [f64; 3], to: [f64; 3]) -> Curve {
    Curve::from(Line::new(Point3::from(from), Point3::from(to)))
}

#[test]
fn the_middle_of_two_circles_is_the_circle_between() {
    let tween =
        |f: f64| curve(Trial::of("Tween Two Curves").item(circle(1.0, 0.0)).item(circle(3.0, 4.0)).item(f));
    for (f, radius, height) in [(0.0, 1.0, 0.0), (0.5, 2.0, 2.0), (1.0, 3.0, 4.0)] {
        let found = tween(f);
        let exact = found.as_circle(1e-9).unwrap();
        assert!((exact.radius - radius).abs() < 1e-12, "{f}: {}", exact.radius);
        assert!((exact.center().z - height).abs() < 1e-12);
    }
    let sets = || {
        let curves = [circle(1.0, 0.0), circle(2.0, 1.0), circle(4.0, 2.0)];
        Trial::of("Tween Through Curves").list(curves)
    };
    // 2.5 of four is no place of three: 1.5 lies between the second and the third.
    let found = curve(sets().item(1.5).item(false).item(false).item(false).item(0));
    assert!((found.as_circle(1e-9).unwrap().radius - 3.0).abs() < 1e-12);
    let found = curve(sets().item(0.5).item(true).item(false).item(false).item(1));
    assert!((found.as_circle(1e-9).unwrap().radius - 2.0).abs() < 1e-12);
    let mean = curve(Trial::of("Average Curve").list([circle(1.0, 0.0), circle(2.0, 3.0), circle(6.0, 3.0)]));
    assert!((mean.as_circle(1e-9).unwrap().radius - 3.0).abs() < 1e-12);
}

/// Circles of one start have the same weights; a circle and an arc do not.
#[test]
fn tweens_of_rational_curves_are_means_without_kinks() {
    let round = circle(2.0, 0.0);
    let aside = Plane::XY.with_origin(Point3::new(3.0, 1.0, 5.0));
    let aside = Curve::from(Circle::new(aside, 2.0).unwrap());
    let found = curve(Trial::of("Tween Two Curves").item(round.clone()).item(aside).item(0.5));
    assert!((found.as_circle(1e-9).unwrap().radius - 2.0).abs() < 1e-9);
    let [a, b, c] = [[2.0, 0.0, 1.0], [0.0, 3.0, 4.0], [-2.5, 0.0, 1.0]].map(Point3::from);
    let bow = Curve::from(katydid_geometry::Arc::through(a, b, c).unwrap());
    let mixed = curve(Trial::of("Tween Two Curves").item(round.clone()).item(bow.clone()).item(0.5));
    // Parameters are those of the NURBS forms, not angles.
    let [round, bow] = [round, bow].map(|curve| Curve::from(curve.to_nurbs().unwrap()));
    let mut before: Option<Vector3> = None;
    for i in 0..=2000 {
        let t = f64::from(i) / 2000.0;
        let at = |curve: &Curve| curve.point_at(curve.domain().at(t));
        assert!(at(&mixed).distance_to(at(&round).lerp(at(&bow), 0.5)) < 1e-3);
        let tangent = mixed.tangent_at(mixed.domain().at(t)).unwrap();
        assert!(before.is_none_or(|before| before.angle_to(tangent).unwrap() < 0.02), "a kink at {t}");
        before = Some(tangent);
    }
}

/// Beyond its ends each pair goes on along its own line, as pairs of points do.
#[test]
fn consecutive_curves_go_beyond_their_pairs() {
    let set = [circle(1.0, 0.0), circle(2.0, 1.0), circle(5.0, 5.0)];
    for (factor, heights) in [(1.5, [1.5, 7.0]), (-1.0, [-1.0, -3.0]), (1.0, [1.0, 5.0])] {
        let run = Trial::of("Tween Consecutive Curves").list(set.clone()).item(factor).run();
        let found: Vec<f64> = run.outputs[0]
            .column()
            .iter()
            .map(|value| match value {
                Some(Value::Curve(curve)) => curve.start().z,
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(found, heights, "{factor}");
    }
}

#[test]
fn sampled_closed_curves_have_no_corner_at_the_seam() {
    let sampled = Trial::of("Tween Two Curves").item(circle(1.0, 0.0)).item(circle(3.0, 0.0)).item(0.5);
    let found = curve(sampled.item(0).item(12));
    assert!(found.is_closed());
    let domain = found.domain();
    let (end, start) = (found.tangent_on_side(domain.end, true), found.tangent_on_side(domain.start, false));
    assert!(end.unwrap().angle_to(start.unwrap()).unwrap() < 1e-9);
    // Control points on the circle between pull the curve inwards by what the uniform cubic does at all of them alike.
    let inside = 2.0 * (2.0 + (std::f64::consts::TAU / 12.0).cos()) / 3.0;
    assert!(found.start().distance_to(Point3::new(inside, 0.0, 0.0)) < 1e-9, "{:?}", found.start());
}

#[test]
fn polylines_keep_their_corners() {
    let corner = Curve::from(
        PolylineCurve::new(vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 0.0)])
            .unwrap(),
    );
    let line = segment([0.0, 0.0, 2.0], [2.0, 0.0, 2.0]);
    let found = curve(Trial::of("Tween Two Curves").item(corner).item(line).item(0.5));
    let points = found.as_polyline().unwrap();
    let wanted = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.5, 0.5, 1.0]].map(Point3::from);
    assert_eq!(points.len(), 3);
    assert!(points.iter().zip(wanted).all(|(p, q)| p.distance_to(q) < 1e-12), "{points:?}");
}

#[test]
fn simple_things_are_blended() {
    let points = [Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0), Point3::new(2.0, 2.0, 0.0)];
    let point = |f: f64| first(Trial::of("Tween Through Points").list(points).item(f));
    assert_eq!(point(0.75), Value::Point(Point3::new(2.0, 1.0, 0.0)));
    let con = Trial::of("Tween Consecutive Points").list(points).item(0.5).item(false).item(true).run();
    assert_eq!(con.outputs[0].item_count(), 3);
    assert_eq!(con.outputs[0].column().get(2), Some(Value::Point(Point3::new(1.0, 1.0, 0.0))));
    // A smooth way passes through each item too.
    let smooth = Trial::of("Tween Through Numbers").list([0.0, 1.0, 4.0]).item(1.0).item(false);
    assert_eq!(first(smooth.item(false).item(false).item(false).item(3)), Value::Number(1.0));
    let domain =
        Trial::of("Tween Two Domains").item(Interval::new(0.0, 2.0)).item(Interval::new(4.0, 10.0)).item(0.5);
    assert_eq!(first(domain), Value::Domain(Interval::new(2.0, 6.0)));
    assert!(Trial::of("Tween Two Numbers").item(0.0).item(1.0).item(f64::NAN).message().contains("finite"));
    let none: Vec<f64> = Vec::new();
    assert!(!Trial::of("Tween Through Numbers").list(none).item(0.5).message().is_empty());
}

#[test]
fn planes_turn_evenly() {
    let quarter = Plane::from_axes(Point3::new(2.0, 0.0, 0.0), Vector3::Y, -Vector3::X).unwrap();
    let plane = first(Trial::of("Tween Two Planes").item(Plane::XY).item(quarter).item(1.0 / 3.0).item(true));
    let Value::Plane(plane) = plane else { panic!() };
    let angle = Vector3::X.angle_to(plane.x_axis).unwrap();
    assert!((angle - std::f64::consts::FRAC_PI_6).abs() < 1e-12);
    assert!((plane.origin.x - 2.0 / 3.0).abs() < 1e-12);
}

#[test]
fn surfaces_of_other_structure_are_blended() {
    let side = Interval::new(0.0, 1.0);
    let flat = |z: f64| {
        let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, z));
        Surface::from(PlaneSurface::new(plane, side, side).unwrap())
    };
    let cap =
        Surface::from(katydid_geometry::Sphere::around(Point3::ORIGIN, 1.0).unwrap().to_nurbs().unwrap());
    let found = first(Trial::of("Tween Two Surfaces").item(flat(0.0)).item(flat(3.0)).item(0.25));
    let Value::Surface(found) = found else { panic!() };
    assert!(found.point_at(0.3, 0.7).distance_to(Point3::new(0.3, 0.7, 0.75)) < 1e-12);
    let ends = first(Trial::of("Tween Two Surfaces").item(flat(0.0)).item(cap.clone()).item(1.0));
    let Value::Surface(ends) = ends else { panic!() };
    assert!((ends.point_at(0.4, 0.6).distance_to(Point3::ORIGIN) - 1.0).abs() < 1e-9);
}

#[test]
fn meshes_are_blended_and_given_a_thickness() {
    let side = |n: f64| Interval::new(0.0, n);
    let cube = |n: f64| {
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side(n), y: side(n), z: side(n) }, 1, 1, 1).unwrap()
    };
    let found = mesh(Trial::of("Tween Two Meshes").item(cube(1.0)).item(cube(3.0)).item(0.5));
    assert!((found.volume() - 8.0).abs() < 1e-12);
    let rectangle = Rectangle { plane: Plane::XY, x: side(2.0), y: side(2.0) };
    let params = || vec![0.0, 0.5, 1.0];
    let flat =
        mesh(Trial::of("Parameter Plane Mesh").item(rectangle).list(params()).list(params()).item(false));
    assert_eq!((flat.vertices().len(), flat.faces().len()), (9, 4));
    let solid = mesh(Trial::of("Offset Mesh").item((*flat).clone()).item(0.5).tree(Tree::empty()).item(true));
    assert!(solid.is_closed());
    assert!((solid.volume() - 2.0).abs() < 1e-9, "{}", solid.volume());
    let voxels = [Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 0.0)];
    let boxes =
        mesh(Trial::of("Voxel Mesh").list(voxels).item(Plane::XY).item(1.0).item(1.0).item(1.0).item(false));
    assert!(boxes.is_closed());
    assert_eq!(boxes.faces().len(), 14);
    assert!((boxes.volume() - 3.0).abs() < 1e-12);
}

#[test]
fn lofts_and_pipes_are_closed() {
    let sections = [circle(1.0, 0.0), circle(1.0, 2.0)];
    let shares: Vec<f64> = (0..=64).map(|i| f64::from(i) / 64.0).collect();
    let tube =
        mesh(Trial::of("Parameter Loft Mesh").list(sections).list(shares.clone()).list([0.0, 0.5, 1.0]));
    // A prism of 64 sides.
    let side = 2.0 * (std::f64::consts::PI / 64.0).sin();
    assert!((tube.area() - 64.0 * side * 2.0).abs() < 1e-9, "{}", tube.area());
    // Sections that run counter-clockwise and go up look outwards, and closed ones have no seam.
    let tips = || {
        let tent =
            Trial::of("Parameter Loft Mesh").list([circle(1.0, 0.0), circle(1.0, 2.0)]).list(shares.clone());
        let tent = tent.list([0.0, 0.5, 1.0]).item(false).item(false).item(0.0).item(false).item(false);
        tent.item(Point3::ORIGIN).item(Point3::new(0.0, 0.0, 3.0))
    };
    let base = 32.0 * (std::f64::consts::TAU / 64.0).sin();
    let solid = mesh(tips());
    assert!(solid.is_closed());
    assert!((solid.volume() - base * (2.0 + 1.0 / 3.0)).abs() < 1e-9, "{}", solid.volume());
    let profile = Trial::of("Parameter Extrude Mesh").item(circle(1.0, 0.0));
    let wall = mesh(profile.item(Vector3::Z * 2.0).list(shares.clone()).list([0.0, 1.0]));
    assert_eq!(wall.vertices().len(), 2 * 64);
    for (p, normal) in tube.vertices().iter().zip(tube.vertex_normals()) {
        assert!((normal.dot(Vector3::new(p.x, p.y, 0.0)) - 1.0).abs() < 1e-2, "{normal:?} at {p:?}");
    }
    for (p, normal) in wall.vertices().iter().zip(wall.vertex_normals()) {
        assert!(normal.dot(Vector3::new(p.x, p.y, 0.0)) > 0.99, "{normal:?} at {p:?}");
    }
    assert_eq!(tube.vertices().len(), 3 * 64);
    let pipe = Trial::of("Parameter Pipe Mesh").item(segment([0.0, 0.0, 0.0], [0.0, 0.0, 5.0])).item(0.5);
    let pipe = mesh(pipe.list([0.0, 1.0]).list(shares).item(false).item(false).item(0.0).item(1));
    assert!(pipe.is_closed());
    let exact = 5.0 * 0.25 * 32.0 * (std::f64::consts::TAU / 64.0).sin();
    assert!((pipe.volume() - exact).abs() < 1e-9, "{} {exact}", pipe.volume());
}

#[test]
fn grids_have_the_cells_of_their_parameters() {
    let side = Interval::new(0.0, 4.0);
    let flat = Surface::from(PlaneSurface::new(Plane::XY, side, side).unwrap());
    let grid =
        |name: &str| Trial::of(name).item(flat.clone()).list([0.0, 0.25, 1.0]).list([0.0, 0.5, 0.75, 1.0]);
    let run = grid("Parameter Surface Grid").run();
    assert_eq!([run.outputs[0].item_count(), run.outputs[1].item_count()], [6, 12]);
    assert_eq!(grid("Parameter Point Divide Surface").run().outputs[0].branch_count(), 3);
    assert_eq!(grid("Parameter Subdivide Surface").run().outputs[0].item_count(), 6);
    let divided = |us: &[f64]| {
        let trial = Trial::of("Parameter Subdivide Surface").item(flat.clone());
        trial.list(us.to_vec()).list([0.0, 0.5, 1.0]).run()
    };
    assert_eq!(divided(&[1.0, 0.25, 0.0]).outputs[0], divided(&[0.0, 0.25, 1.0]).outputs[0]);
    assert_eq!(divided(&[1.0, 0.25, 0.0]).outputs[0].item_count(), 4);
    assert!(divided(&[0.5, 0.5]).messages.iter().any(|m| m.text.contains("two different parameters")));
    let net = Trial::of("Net On Surface").item(flat).item(5).item(4).item(false).run();
    assert_eq!(net.outputs[0].item_count(), 5);
}

#[test]
fn curves_are_closed_and_measured() {
    let open = Curve::from(
        PolylineCurve::new(vec![Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0), Point3::new(3.0, 4.0, 0.0)])
            .unwrap(),
    );
    let closed = curve(Trial::of("Close Curve").item(open.clone()).item(0).item(1.0).item(0.0));
    assert!(closed.is_closed());
    assert!((closed.length() - 12.0).abs() < 1e-9);
    let middle = Trial::of("Curve Middle Point").item(open.clone()).item(false);
    assert_eq!(first(middle), Value::Point(Point3::new(3.0, 0.5, 0.0)));
    let run = Trial::of("Bounding Rectangle").list([open]).item(Plane::XY).item(0).item(0.0).item(true).run();
    let size = |k: usize| katydid_component::testing::texts(&run.outputs[k])[0].clone();
    assert!(size(1).ends_with(": 3") && size(2).ends_with(": 4"), "{} {}", size(1), size(2));
}

#[test]
fn numbers_are_rounded_and_mapped() {
    let texts = |trial: Trial| trial.texts(0);
    assert_eq!(texts(Trial::of("Round To Factor").item(7.3).item(0.5)), ["{0}: 7.5"]);
    assert_eq!(texts(Trial::of("Round To Decimal Place").item(1.23456).item(3).item(true)), ["{0}: 1.234"]);
    let parts = Trial::of("Partition Number").item(10).item(3).run();
    assert_eq!(parts.outputs[0].column().iter().flatten().collect::<Vec<_>>(), [4, 3, 3].map(Value::from));
    let unit = Trial::of("Reparameterize Numbers").list([2.0, 4.0, 6.0]).item(true).run();
    assert_eq!(
        unit.outputs[0].column().iter().flatten().collect::<Vec<_>>(),
        [1.0, 0.5, 0.0].map(Value::from)
    );
    let side = Interval::new(0.0, 1.0);
    let frame = Rectangle { plane: Plane::XY, x: side, y: side };
    // The graph y = 1 - x over values from 0 to 10, mapped to 0 to 100.
    let graph = Trial::of("Curve Graph Mapper").list([segment([0.0, 1.0, 0.0], [1.0, 0.0, 0.0])]).item(frame);
    let run =
        graph.list([0.0, 2.5, 10.0]).item(Interval::new(0.0, 10.0)).item(Interval::new(0.0, 100.0)).run();
    let mapped: Vec<f64> = run.outputs[0]
        .column()
        .iter()
        .map(|value| match value {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        })
        .collect();
    assert!(mapped.iter().zip([100.0, 75.0, 0.0]).all(|(x, y)| (x - y).abs() < 1e-6), "{mapped:?}");
}
