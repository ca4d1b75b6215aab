use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{Box3, Curve, Interval, Line, Mesh, Plane, Point3};

/// An empty grid over ±1 in all directions.
fn grid(size: f64) -> Value {
    let side = Interval::new(-1.0, 1.0);
    let frame = Box3 { plane: Plane::XY, x: side, y: side, z: side };
    let made = Trial::of("Create VoxelGrid").item(frame).item(size).item(size).item(size).run();
    made.outputs[0].column().get(0).unwrap()
}

fn filled(geometry: impl Into<Value>, grid: Value, distance: f64) -> Value {
    let run = Trial::of("VoxelateGeometry").list([geometry.into()]).item(grid).item(distance).run();
    run.outputs[0].column().get(0).unwrap()
}

fn count(grid: &Value) -> f64 {
    Trial::of("VoxelGrid Statistics").item(grid.clone()).texts(5)[0]
        .trim_start_matches("{0}: ")
        .parse()
        .unwrap()
}

#[test]
fn a_ball_has_the_volume_of_a_ball() {
    let ball = Mesh::sphere(&Plane::XY, 0.9, 96, 48).unwrap();
    let voxels = filled(ball, grid(0.05), 0.0);
    let volume = count(&voxels) * 0.05_f64.powi(3);
    let exact = 4.0 / 3.0 * std::f64::consts::PI * 0.9_f64.powi(3);
    assert!((volume / exact - 1.0).abs() < 0.01, "{volume} {exact}");
    // By distance from its centre it is the same ball.
    let near = count(&filled(Point3::ORIGIN, grid(0.05), 0.9)) * 0.05_f64.powi(3);
    assert!((near / exact - 1.0).abs() < 0.01, "{near} {exact}");
}

#[test]
fn a_box_fills_its_voxels_whole() {
    let half = Interval::new(-0.5, 0.5);
    let voxels = filled(Box3 { plane: Plane::XY, x: half, y: half, z: half }, grid(0.5), 0.0);
    assert_eq!(count(&voxels), 8.0);
    let hull = Trial::of("VoxelGrid To Mesh Hull").item(voxels.clone()).item(false).run();
    let Some(Value::Mesh(mesh)) = hull.outputs[0].column().get(0) else { panic!() };
    assert!(mesh.is_closed());
    assert!((mesh.volume() - 1.0).abs() < 1e-12, "{}", mesh.volume());
    let Some(Value::Mesh(top)) = hull.outputs[5].column().get(0) else { panic!() };
    assert!((top.area() - 1.0).abs() < 1e-12);
    assert_eq!(Trial::of("VoxelGrid Statistics").item(voxels.clone()).texts(7), ["{0}: 6"]);
    // Half way between centres the hull of one cell alone is an octahedron of half a cell's radius.
    let one = filled(Point3::new(0.1, 0.1, 0.1), grid(0.5), 0.0);
    let hull = Trial::of("Hull from Marching Cubes").item(one).item(0.5).run();
    let Some(Value::Mesh(mesh)) = hull.outputs[0].column().get(0) else { panic!() };
    assert!(mesh.is_closed());
    assert!((mesh.volume() - 4.0 / 3.0 * 0.25_f64.powi(3)).abs() < 1e-12, "{}", mesh.volume());
}

#[test]
fn grids_are_sets() {
    let line = |y: f64| Curve::from(Line::new(Point3::new(-0.9, y, 0.1), Point3::new(0.9, y, 0.1)));
    let (a, b) = (filled(line(0.1), grid(0.5), 0.0), filled(line(0.6), grid(0.5), 0.0));
    assert_eq!([count(&a), count(&b)], [4.0, 4.0]);
    let merged = |name: &str, lists: [&Value; 2]| {
        let run = Trial::of(name).list(lists.map(Clone::clone)).run();
        count(&run.outputs[0].column().get(0).unwrap())
    };
    assert_eq!(merged("VoxelGrid Boolean Union", [&a, &b]), 8.0);
    assert_eq!(merged("VoxelGrid Boolean Intersect", [&a, &b]), 0.0);
    assert_eq!(merged("VoxelGrid Boolean Subtract", [&a, &b]), 4.0);
    assert_eq!(merged("VoxelGrid Boolean Exclusive", [&a, &a]), 0.0);
    let rest = Trial::of("VoxelGrid Boolean Invert").item(a).run();
    assert_eq!(count(&rest.outputs[0].column().get(0).unwrap()), 60.0);
}

#[test]
fn bad_sizes_are_refused() {
    let side = Interval::new(0.0, 1.0);
    let frame = Box3 { plane: Plane::XY, x: side, y: side, z: side };
    for size in [0.0, -1.0, f64::NAN, 1e-9, 3.0] {
        let message = Trial::of("Create VoxelGrid").item(frame).item(size).item(1.0).item(1.0).message();
        assert!(!message.is_empty(), "{size}");
    }
    assert!(Trial::of("VoxelGrid Dimensions").item(3.0).message().contains("no grid"));
}
