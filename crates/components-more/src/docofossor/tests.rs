use katydid_component::testing::Trial;
use katydid_data::{Tree, Value};
use katydid_geometry::{Curve, Interval, Line, Plane, PlaneSurface, Point3, Surface};

/// Points of a flat grid of 81 × 81 cells of a quarter of a unit, from -10 to 10.
fn flat() -> Tree {
    let points = (0..81 * 81)
        .map(|i| Point3::new(f64::from(i / 81) * 0.25 - 10.0, f64::from(i % 81) * 0.25 - 10.0, 0.0));
    Trial::of("Import Points").list(points).run().outputs[0].clone()
}

fn volume(run: &katydid_component::Outcome) -> f64 {
    match run.outputs[1].column().get(0) {
        Some(Value::Number(x)) => x,
        other => panic!("{other:?}"),
    }
}

#[test]
fn points_become_a_grid() {
    let grid = flat();
    let head: Vec<_> = (0..8).map(|i| grid.column().get(i).unwrap()).collect();
    let wanted = [81.0, 81.0, -10.0, -10.0, 0.25, 0.25, 0.0, 0.0].map(Value::Number);
    assert_eq!(head, wanted);
    assert_eq!(grid.column().len(), 10 + 81 * 81);
    let mesh = Trial::of("Grid Mesh").tree(grid).texts(0);
    assert_eq!(mesh, ["{0}: Mesh (V:6561  F:6400)"]);
}

#[test]
fn a_cone_has_the_volume_of_a_cone() {
    // A cone 3 deep at 45 degrees has a radius of 3.
    let run = Trial::of("Cut In Point")
        .tree(flat())
        .list([Point3::new(0.0, 0.0, -3.0)])
        .item(45.0)
        .item(30.0)
        .run();
    let exact = -std::f64::consts::PI * 27.0 / 3.0;
    assert!((volume(&run) / exact - 1.0).abs() < 5e-3, "{} {exact}", volume(&run));
    let fill = Trial::of("Fill In Point")
        .tree(flat())
        .list([Point3::new(0.0, 0.0, 3.0)])
        .item(45.0)
        .item(30.0)
        .run();
    assert!((volume(&fill) + volume(&run)).abs() < 1e-9);
    let both = Trial::of("Grid Compare").tree(run.outputs[0].clone()).tree(fill.outputs[0].clone()).texts(0);
    // What one cuts and the other fills lies between them.
    assert_eq!(both, ["{0;0}: 0"]);
}

#[test]
fn a_trench_has_the_section_of_a_trapezoid() {
    // 20.25 long over the cells, 2 wide at the bottom, 1 deep at 45 degrees: a section of 2 + 1.
    let path = Curve::from(Line::new(Point3::new(-20.0, 0.0, -1.0), Point3::new(20.0, 0.0, -1.0)));
    let run = |name: &str| Trial::of(name).tree(flat()).list([path.clone()]);
    let length = 81.0 * 0.25;
    let relative = run("Cut On Path").item(1.0).item(2.0).item(45.0).default().item(30.0).run();
    assert!((volume(&relative) + 3.0 * length).abs() < 0.05 * length, "{}", volume(&relative));
    let absolute = run("Cut & Fill In Path").item(2.0).item(45.0).default().item(30.0).run();
    assert!((volume(&absolute) - volume(&relative)).abs() < 1e-9);
    let none = run("Fill In Path").item(2.0).item(45.0).default().item(30.0).run();
    assert_eq!(volume(&none), 0.0);
}

#[test]
fn bumps_are_nowhere_steeper_than_asked() {
    let run = Trial::of("Fill On Point").tree(flat()).list([Point3::ORIGIN]).item(2.0).item(30.0).run();
    let slopes = Trial::of("Slope Vector").tree(run.outputs[0].clone()).run().outputs[0].clone();
    let steepest = slopes
        .column()
        .iter()
        .filter_map(|v| match v {
            Some(Value::Vector(v)) => Some(v.length()),
            _ => None,
        })
        .fold(0.0, f64::max);
    let limit = 30_f64.to_radians().tan();
    assert!(steepest <= limit + 1e-9 && steepest > 0.95 * limit, "{steepest} {limit}");
    // The volume under (1 + cos(πd/r))·h/2: h·r²·(π/2 − 2/π).
    let (pi, r) = (std::f64::consts::PI, std::f64::consts::PI / limit);
    let exact = 2.0 * r * r * (pi / 2.0 - 2.0 / pi);
    assert!((volume(&run) / exact - 1.0).abs() < 1e-2, "{} {exact}", volume(&run));
}

#[test]
fn grids_keep_their_place_in_the_world() {
    let shifted = Trial::of("Grid Shift").tree(flat()).item(0.0).item(0.0).run().outputs[0].clone();
    assert_eq!(shifted.column().get(2), Some(Value::Number(0.0)));
    let back = Trial::of("Grid Global").tree(shifted).run().outputs[0].clone();
    assert_eq!(back.column().get(2), Some(Value::Number(-10.0)));
    let thin = Trial::of("Grid Filter").tree(flat()).item(2).run().outputs[0].clone();
    assert_eq!(thin.column().len(), 10 + 41 * 41);
    let fine = Trial::of("Grid Interpolation").tree(thin).run().outputs[0].clone();
    let numbers = |tree: &Tree| tree.column().iter().collect::<Vec<_>>();
    assert!(numbers(&fine) == numbers(&flat()));
}

#[test]
fn shortest_ways_are_straight_on_flat_ground() {
    let run = Trial::of("Shortest Path")
        .tree(flat())
        .tree(Tree::empty())
        .item(Point3::new(-10.0, -10.0, 0.0))
        .item(Point3::new(10.0, 10.0, 0.0))
        .item(2)
        .item(1.0)
        .run();
    assert_eq!(run.outputs[1].item_count(), 81);
    let Some(Value::Number(far)) = run.outputs[0].column().get(0) else { panic!() };
    assert!((far - 20.0 * 2_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn strange_lists_are_refused() {
    assert!(Trial::of("Grid Mesh").list([1.0, 2.0]).message().contains("no terrain grid"));
    let list = [1e12, 1e12, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0];
    assert!(!Trial::of("Grid Mesh").list(list).message().is_empty());
    assert!(
        Trial::of("Cut In Point").tree(flat()).list([Point3::ORIGIN]).item(90.0).message().contains("slope")
    );
}

#[test]
fn a_surface_of_one_face_fills_the_terrain() {
    // A level square of 4 by 4 units, 1 above, with slopes of 45 degrees: a prism, half prisms at its sides, and the quarters of a cone.
    let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0));
    let square = PlaneSurface::new(plane, Interval::new(-2.0, 2.0), Interval::new(-2.0, 2.0)).unwrap();
    let run = Trial::of("Fill In Surface")
        .tree(flat())
        .item(Value::Surface(Surface::from(square).into()))
        .item(45.0)
        .run();
    let exact = 16.0 + 8.0 + std::f64::consts::PI / 3.0;
    assert!((volume(&run) / exact - 1.0).abs() < 2e-2, "{} {exact}", volume(&run));
}

/// Numbers are rounded as they are shown everywhere.
#[test]
fn what_a_grid_is_is_told_in_rounded_numbers() {
    let heights = [0.1 + 0.2, 1.0 / 3.0, 2.0 / 3.0, 0.7 + 0.1];
    let points = heights.iter().enumerate().map(|(i, z)| {
        let (x, y) = ((i / 2) as f64, (i % 2) as f64);
        Point3::new(0.1 * x, 0.1 * y, *z)
    });
    let grid = Trial::of("Import Points").list(points.collect::<Vec<_>>()).run().outputs[0].clone();
    let told = Trial::of("Grid Info").tree(grid).texts(0).concat();
    assert!(told.contains("heights: 0.3 to 0.8"), "{told}");
    assert!(told.contains("cell size: 0.1, 0.1"), "{told}");
}
