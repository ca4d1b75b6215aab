use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{Curve, Direction, NurbsSurface, Plane, Point3, PolylineCurve, Surface};

/// A flat sheet of 6 by 4.
fn sheet() -> Value {
    let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let surface = NurbsSurface::from_corners(at(0., 0.), at(6., 0.), at(6., 4.), at(0., 4.)).unwrap();
    Value::from(std::sync::Arc::new(Surface::from(surface)))
}

/// The sum of the areas of flat panels: half of the cross product of the diagonals.
fn area(trial: Trial, outputs: usize) -> (usize, f64) {
    let outcome = trial.run();
    let (mut count, mut sum) = (0, 0.0);
    for tree in &outcome.outputs[..outputs] {
        for item in tree.column().iter() {
            let Some(Value::Surface(surface)) = item else { panic!("{item:?}") };
            let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
            let at = |s: f64, t: f64| surface.point_at(u.at(s), v.at(t));
            sum += 0.5 * (at(1., 1.) - at(0., 0.)).cross(at(0., 1.) - at(1., 0.)).length();
            count += 1;
        }
    }
    (count, sum)
}

#[test]
fn panels_cover_the_surface_once() {
    for (name, outputs, panels) in [
        ("Quad Panels", 1, 12),
        ("Triangular Panels A", 1, 24),
        ("Triangle Panels B", 1, 24),
        ("Triangle Panels C", 1, 48),
        ("Staggered Quad Panels", 1, 13),
        ("Skewed Quads", 1, 15),
        ("Random Quad Panels", 1, 12),
        ("Diamond Panels", 2, 32),
    ] {
        let (count, sum) = area(Trial::of(name).item(sheet()).item(4).item(3), outputs);
        assert_eq!(count, panels, "{name}");
        assert!((sum - 24.0).abs() < 1e-9, "{name}: {sum}");
    }
    assert!(!Trial::of("Quad Panels").item(sheet()).item(0).message().is_empty());
}

#[test]
fn structures_have_their_lines() {
    let count = |name: &str| {
        let run = Trial::of(name).item(sheet()).item(4).item(3).run();
        run.outputs.iter().map(|tree| tree.item_count()).collect::<Vec<usize>>()
    };
    assert_eq!(count("Grid Structure"), [4 * 4 + 5 * 3, 20]);
    assert_eq!(count("Braced Grid 1D Structure"), [31, 12, 20]);
    assert_eq!(count("Braced Grid 2D Structure"), [31, 24, 20]);
    assert_eq!(count("Diagrid Structure"), [48, 32]);
    let cells = Trial::of("Hexagon Cells").item(sheet()).item(4).item(3).run();
    assert_eq!(cells.outputs[0].item_count(), 4 + 3 + 4);
}

fn counts(trial: Trial) -> Vec<usize> {
    trial.run().outputs.iter().map(|tree| tree.item_count()).collect()
}

fn points(tree: &katydid_data::Tree) -> Vec<Point3> {
    let point = |item| match item {
        Some(Value::Point(p)) => p,
        other => panic!("{other:?}"),
    };
    tree.column().iter().map(point).collect()
}

#[test]
fn space_trusses_have_two_layers() {
    // 4 by 3 cells: 31 lines and 20 nodes on the surface, 12 nodes over the middles with 17 lines between them, 48 struts.
    let one = || Trial::of("Space Truss Structure 1").item(sheet()).item(4).item(3).item(1.5);
    assert_eq!(counts(one()), [31, 17, 48, 32]);
    let out = one().run().outputs;
    for (k, node) in points(&out[3]).iter().enumerate() {
        assert!((node.z - if k < 20 { 0.0 } else { 1.5 }).abs() < 1e-12);
    }
    for item in out[2].column().iter() {
        let Some(Value::Line(strut)) = item else { panic!("{item:?}") };
        // Half of 1.5 by 4/3 across, 1.5 up.
        let wanted = (0.75_f64 * 0.75 + 4.0 / 9.0 + 2.25).sqrt();
        assert!((strut.length() - wanted).abs() < 1e-9, "{strut:?}");
    }
    let two = Trial::of("Space Truss Structure 2").item(sheet()).item(sheet()).item(1).item(2);
    assert_eq!(counts(two), [7, 1, 8, 8]);
    let endless = Trial::of("Space Truss Structure 1").item(sheet()).item(4).item(3).item(f64::NAN);
    assert!(endless.message().contains("depth"));
    let many = Trial::of("Space Truss Structure 2").item(sheet()).item(sheet()).item(i32::MAX);
    assert!(many.message().contains("from 1 to"));
}

#[test]
fn hexagons_share_their_sides() {
    for turned in [false, true] {
        let trial = || Trial::of("Hexagonal Structure").item(sheet()).item(4).item(3).item(0.5).item(turned);
        let (lines, nodes) = (counts(trial())[0], counts(trial())[1]);
        // Euler, of a net without holes: nodes − lines + cells = 1.
        let cells = if turned { 3 + 2 + 3 + 2 } else { 4 + 3 + 4 };
        assert_eq!(nodes + cells, lines + 1, "{turned}");
    }
    // One cell alone.
    assert_eq!(counts(Trial::of("Hexagonal Structure").item(sheet()).item(1).item(1)), [6, 6]);
    let wrong = Trial::of("Hexagonal Structure").item(sheet()).item(4).item(3).item(2.0);
    assert!(wrong.message().contains("from 0 to 1"));
}

#[test]
fn corners_of_panels() {
    for (name, count) in [("Quad Grid", 12), ("Diamond Grid", 12 + 6)] {
        let out = Trial::of(name).item(sheet()).item(4).item(3).run().outputs;
        assert_eq!(out.iter().map(|tree| tree.item_count()).collect::<Vec<_>>(), [count; 6], "{name}");
        let lists: Vec<Vec<Point3>> = out[..5].iter().map(points).collect();
        let area: f64 =
            (0..count).map(|k| 0.5 * (lists[2][k] - lists[0][k]).cross(lists[3][k] - lists[1][k]).z).sum();
        // Quads are all of the sheet; diamonds are half a cell each.
        let wanted = if name == "Quad Grid" { 24.0 } else { 18.0 };
        assert!((area - wanted).abs() < 1e-9, "{name}: {area}");
        for item in out[5].column().iter() {
            let Some(Value::Vector(normal)) = item else { panic!("{item:?}") };
            assert!((normal.z - 1.0).abs() < 1e-12);
        }
    }
}

fn triangle() -> Value {
    let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let corners = vec![at(0., 0.), at(6., 0.), at(0., 4.), at(0., 0.)];
    Value::from(Curve::Polyline(PolylineCurve::new(corners).unwrap()))
}

#[test]
fn panels_are_cut_without_gaps() {
    let yes = |trial: Trial, all: [bool; 4]| all.into_iter().fold(trial, |trial, on| trial.item(on));
    for all in [[true, false, true, false], [true; 4], [false; 4]] {
        let (count, sum) = area(yes(Trial::of("Subdivide Quad").item(sheet()).item(3), all).item(false), 2);
        let going = all.iter().filter(|on| **on).count();
        let staying = 4 - going;
        assert_eq!(count, going.pow(3) + staying * (1 + going + going.pow(2)), "{all:?}");
        assert!((sum - 24.0).abs() < 1e-9, "{sum}");
    }
    let cells = |wires: bool| {
        yes(Trial::of("Subdivide Triangle").item(triangle()).item(4), [true, true, true, false]).item(wires)
    };
    assert_eq!(counts(cells(true)), [81, 1 + 3 + 9 + 27]);
    let (_, sum) = area(cells(false), 2);
    assert!((sum - 12.0).abs() < 1e-9, "{sum}");
    for (strips, count) in [(false, 64), (true, 27)] {
        let trial = Trial::of("Constant Quad Subdivide").item(sheet()).item(3).item(strips).item(false);
        let (found, sum) = area(trial, 1);
        assert_eq!(found, count);
        assert!((sum - 24.0).abs() < 1e-9, "{sum}");
    }
    assert!(Trial::of("Subdivide Quad").item(sheet()).item(-1).message().contains("from 0 to 20"));
    let huge = yes(Trial::of("Subdivide Quad").item(sheet()).item(20), [true; 4]);
    assert!(!huge.message().is_empty());
    assert!(Trial::of("Subdivide Triangle").item(sheet()).item(1).message().contains("3 corners, not 4"));
    assert!(Trial::of("Subdivide Triangle").item(3.0).item(1).message().contains("closed polyline"));
}

#[test]
fn frames_leave_the_scaled_panel() {
    for (value, whole) in [(sheet(), 24.0), (triangle(), 12.0)] {
        let out = Trial::of("Panel Frame").item(value).item(0.5).run().outputs;
        let area = |k: usize| match out[k].column().get(0) {
            Some(Value::Brep(brep)) => brep.area_properties(1e-9, || true).unwrap().amount,
            other => panic!("{other:?}"),
        };
        assert!((area(0) - 0.75 * whole).abs() < 1e-6);
        assert!((area(1) - 0.25 * whole).abs() < 1e-6);
    }
    for scale in [0.0, 1.0, f64::NAN] {
        assert!(Trial::of("Panel Frame").item(sheet()).item(scale).message().contains("between 0 and 1"));
    }
}

#[test]
fn surfaces_turned_flattened_and_joined() {
    let at = Point3::new;
    let twisted = NurbsSurface::from_corners(at(0., 0., 0.), at(2., 0., 1.), at(2., 2., 0.), at(0., 2., 1.));
    let twisted = Value::from(std::sync::Arc::new(Surface::from(twisted.unwrap())));
    let out = Trial::of("Flatness Check").list([sheet(), twisted]).run().outputs;
    let deviations: Vec<f64> = out[2]
        .column()
        .iter()
        .map(|item| match item {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        })
        .collect();
    // Corners by turns half above and half below the plane in the middle.
    assert!(deviations[0].abs() < 1e-12 && (deviations[1] - 0.5).abs() < 1e-9, "{deviations:?}");
    let corner = |option: i32| {
        let run = Trial::of("Reverse Surface Direction").item(sheet()).item(option).run();
        let Some(Value::Surface(surface)) = run.outputs[0].column().get(0) else { panic!() };
        let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
        let p = surface.point_at(u.start, v.start);
        [p.x, p.y]
    };
    assert_eq!([0, 1, 2, 3].map(corner), [[0., 0.], [6., 0.], [0., 4.], [6., 4.]]);
    assert!(Trial::of("Reverse Surface Direction").item(sheet()).item(4).message().contains("0, 1, 2 or 3"));
    let plane = Plane::XY.with_origin(at(1., 2., 3.)).rotated(std::f64::consts::FRAC_PI_2);
    let relative = Trial::of("Relative Coordinates").item(plane).item(at(1., 5., 4.));
    assert_eq!(relative.texts(0), ["{0}: {3, 0, 1}"]);
    let rebuilt = Trial::of("Rebuild Surface").item(sheet()).item(2).item(3).item(5).item(6).run();
    let Some(Value::Surface(surface)) = rebuilt.outputs[0].column().get(0) else { panic!() };
    let Surface::Nurbs(nurbs) = &*surface else { panic!() };
    assert_eq!([nurbs.degree(Direction::U), nurbs.degree(Direction::V)], [2, 3]);
    assert!(Trial::of("Rebuild Surface").item(sheet()).item(3).item(3).item(3).message().contains("from 4"));
    assert!(Trial::of("Rebuild Surface").item(sheet()).item(0).message().contains("from 1 to 11"));
    let halves = Trial::of("Quad Panels").item(sheet()).item(2).item(1).run().outputs[0].clone();
    let joined = Trial::of("Brep Join with Tolerance").tree(halves).item(0.01).run();
    assert_eq!(joined.outputs[0].item_count(), 1);
    let wrong = Trial::of("Brep Join with Tolerance").list([sheet()]).item(0.0);
    assert!(wrong.message().contains("greater than 0"));
    let patch = Trial::of("Patch Surface").list([triangle()]).item(4).item(4).run();
    assert_eq!(patch.outputs[0].item_count(), 1);
    assert!(Trial::of("Patch Surface").list([triangle()]).item(0).message().contains("from 1 to 100"));
}

#[test]
fn ports_are_told_by_their_short_names() {
    use katydid_component::parts::Uuid;
    let of = |name: &str, inputs: &[(&str, &str)], outputs: &[(&str, &str)]| {
        let found = katydid_component::stand_in(Uuid::from_u128(1), Some("LunchBox"), name, inputs, outputs);
        let found = found.unwrap_or_else(|| panic!("{name}"));
        let places = (0..inputs.len()).map(|k| found.input_place(k));
        (places.collect::<Vec<_>>(), (0..outputs.len()).map(|k| found.output_place(k)).collect::<Vec<_>>())
    };
    // Two ports of one full name each.
    let inputs = [("U Divisions", "U"), ("R Parameter", "a"), ("R Parameter", "b"), ("Scale", "S")];
    let (places, _) = of("Hyperbolic Paraboloid", &inputs, &[]);
    assert_eq!(places, [Some(0), Some(2), Some(3), Some(4)]);
    let outputs = [("Primary Lines", "LinesA"), ("Primary Lines", "LinesB"), ("Web Lines", "Web")];
    let (_, places) = of("Space Truss Structure 1", &[("Surface", "Srf")], &outputs);
    assert_eq!(places, [Some(0), Some(1), Some(2)]);
}
