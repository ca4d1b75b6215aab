use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{Direction, NurbsSurface, Point3, Surface};

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
