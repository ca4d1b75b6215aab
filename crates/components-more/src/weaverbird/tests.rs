use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Rectangle};

fn cube() -> Mesh {
    let side = Interval::new(-1.0, 1.0);
    Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 1, 1, 1).unwrap()
}

fn grid(n: usize) -> Mesh {
    let side = Interval::new(0.0, n as f64);
    Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, n, n).unwrap()
}

fn tetrahedron() -> Mesh {
    let points = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]].map(MeshFace::Triangle);
    Mesh::new(points.map(Point3::from).to_vec(), faces.to_vec()).unwrap()
}

fn made(trial: Trial) -> Mesh {
    let outcome = trial.run();
    match outcome.outputs.first().and_then(|tree| tree.column().get(0)) {
        Some(Value::Mesh(mesh)) => (*mesh).clone(),
        other => panic!("{other:?} {:?}", outcome.messages),
    }
}

fn counts(mesh: &Mesh) -> [usize; 3] {
    [mesh.vertices().len(), mesh.edges().len(), mesh.faces().len()]
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{a} instead of {b}");
}

#[test]
fn catmull_clark_counts_and_places() {
    let once = made(Trial::of("Catmull-Clark Subdivision").item(cube()).item(1));
    assert_eq!(counts(&once), [26, 48, 24]);
    assert!(once.is_closed() && once.is_oriented());
    // The corner of a cube of half side 1 goes to 5/9, the middle of an edge to (3/4, 3/4, 0), that of a face stays.
    near(once.vertices()[0].x.abs(), 5.0 / 9.0);
    let radii: Vec<f64> = once.vertices().iter().map(|p| p.to_vector().length()).collect();
    assert_eq!(radii.iter().filter(|r| (**r - 3_f64.sqrt() * 5.0 / 9.0).abs() < 1e-12).count(), 8);
    assert_eq!(radii.iter().filter(|r| (**r - 1.125_f64.sqrt()).abs() < 1e-12).count(), 12);
    assert_eq!(radii.iter().filter(|r| (**r - 1.0).abs() < 1e-12).count(), 6);
    let thrice = made(Trial::of("Catmull-Clark Subdivision").item(cube()).item(3));
    assert_eq!(counts(&thrice), [386, 768, 384]);
    assert!(thrice.volume() > 0.0);
}

#[test]
fn boundaries_stay_or_tend_to_splines() {
    let area =
        |naked: i32| made(Trial::of("Catmull-Clark Subdivision").item(grid(3)).item(4).item(naked)).area();
    near(area(0), 9.0);
    assert!(area(2) > 8.9 && area(2) < 9.0 + 1e-9);
    // A corner whose boundary is a cubic spline is cut off by 3/8 of the side from each edge... only less is left.
    assert!(area(1) < area(2));
    let message = Trial::of("Catmull-Clark Subdivision").item(grid(1)).item(1).item(5).message();
    assert!(message.contains("naked"), "{message}");
    assert!(Trial::of("Catmull-Clark Subdivision").item(grid(1)).item(99).message().contains("level"));
}

#[test]
fn loop_on_a_tetrahedron() {
    let once = made(Trial::of("Loop Subdivision").item(tetrahedron()).item(1));
    assert_eq!(counts(&once), [10, 24, 16]);
    // Valence 3: β = (5/8 − (3/8 + cos(120°)/4)²)/3 = 3/16, so a corner p goes to 7/16 p + 3/16 (sum of others = −p) = p/4.
    near(once.vertices()[0].x, 0.25);
    assert!(once.is_closed() && once.is_oriented());
    // A regular flat net stays flat and even.
    let flat = made(Trial::of("Loop Subdivision").item(grid(4)).item(2).item(0));
    near(flat.area(), 16.0);
    assert_eq!(flat.faces().len(), 32 * 16);
}

#[test]
fn linear_splits_keep_the_shape() {
    for (name, faces) in [
        ("Split Polygons Subdivision", 24),
        ("Split Triangles Subdivision", 48),
        ("Constant Quads Split Subdivision", 24),
        ("Inner Polygons Subdivision", 30),
    ] {
        let mesh = made(Trial::of(name).item(cube()));
        assert_eq!(mesh.faces().len(), faces, "{name}");
        near(mesh.area(), 24.0);
        near(mesh.volume(), 8.0);
    }
    let holes = made(Trial::of("Sierpinski Triangles Subdivision").item(cube()));
    assert_eq!(holes.faces().len(), 24);
    near(holes.area(), 12.0);
    // The first mid-edge level of a cube is a cuboctahedron: 12 vertices, 8 triangles and 6 squares.
    let middle = made(Trial::of("Midedge Subdivision").item(cube()));
    assert_eq!(counts(&middle), [12, 24, 14]);
    near(middle.volume(), 20.0 / 3.0);
}

#[test]
fn frames_windows_and_bevels() {
    // A fifth of each edge on both sides leaves a hole of 3/5 of the side.
    let frame = made(Trial::of("Picture Frame").item(cube()).item(20.0));
    assert_eq!(frame.faces().len(), 24);
    near(frame.area(), 24.0 * (1.0 - 0.36));
    let parallel = made(Trial::of("Picture Frame").item(cube()).item(0.4).item(1));
    near(parallel.area(), 24.0 * (1.0 - 0.36));
    let window = made(Trial::of("Mesh Window").item(cube()).item(20.0));
    near(window.area(), 24.0);
    assert_eq!(window.faces().len(), 30);
    let carpet = made(Trial::of("Sierpinski Carpet").item(cube()).item(25.0));
    assert_eq!(carpet.faces().len(), 48);
    near(carpet.area(), 24.0 * 0.75);
    // A cube with its edges cut: 6 squares, 12 quads, 8 triangles.
    let edges = made(Trial::of("Bevel Edges").item(cube()).item(25.0));
    assert!(edges.is_closed() && edges.is_oriented());
    assert_eq!(edges.faces().len(), 26);
    // Half of twelve bars of a quarter by one, and eight corners of which a sixth is left, are gone.
    near(edges.volume(), 8.0 - 1.5 - 8.0 * 0.125 * 5.0 / 6.0);
    // Corners cut at a quarter: each is a corner of three legs of half a unit, 1/48.
    let corners = made(Trial::of("Bevel Vertices").item(cube()).item(25.0));
    assert!(corners.is_closed() && corners.is_oriented());
    near(corners.volume(), 8.0 - 8.0 / 48.0);
    let peaks = made(Trial::of("Stellate/Cumulation").item(cube()).item(1.0));
    assert_eq!(peaks.faces().len(), 24);
    // The rhombic dodecahedron has twice the volume of its cube.
    near(peaks.volume(), 16.0);
    let kept = Trial::of("Stellate/Cumulation").item(cube()).list(Vec::<f64>::new()).message();
    assert!(!kept.is_empty());
}

#[test]
fn thick_and_smooth() {
    let thick = made(Trial::of("Mesh Thicken").item(grid(3)).item(0.5));
    assert!(thick.is_closed() && thick.is_oriented());
    near(thick.volume(), 4.5);
    let off = made(Trial::of("Offset Mesh").item(grid(2)).item(0.25));
    near(off.vertices()[0].z, 0.25);
    let smooth = made(Trial::of("Laplacian Smoothing").item(cube()).item(1));
    // The three neighbours of a corner of a cube have a third of its coordinates as their mean.
    near(smooth.vertices()[0].x.abs(), 1.0 / 3.0);
    let same = made(Trial::of("Laplacian Smoothing").item(cube()).item(5).item(1).item(1.0));
    near(same.volume(), 8.0);
    let held = made(Trial::of("LaplacianHC Smoothing").item(cube()).item(1));
    assert!(held.volume() > smooth.volume());
}

#[test]
fn parts() {
    let edges = Trial::of("Mesh Edges").item(cube());
    assert_eq!(edges.run().outputs[0].item_count(), 24 / 2);
    assert_eq!(Trial::of("Face Polylines").item(cube()).run().outputs[0].item_count(), 6);
    let joined = made(Trial::of("Join Meshes and Weld").list([grid(2), cube()]));
    assert_eq!(joined.vertices().len(), 9 + 8);
    let boundary = Trial::of("Naked boundary").item(grid(3)).run();
    assert_eq!(boundary.outputs[0].item_count(), 1);
    assert_eq!(Trial::of("Dual graph").item(cube()).run().outputs[0].item_count(), 8);
    // Polylines in, polylines out.
    let faces = Trial::of("Face Polylines").item(cube()).run().outputs[0].clone();
    let split = Trial::of("Catmull-Clark Subdivision").tree(faces).run();
    assert_eq!(split.outputs[0].item_count(), 24);
    assert!(matches!(split.outputs[0].column().get(0), Some(Value::Curve(_))));
    assert!(!Trial::of("Catmull-Clark Subdivision").item(4.0).message().is_empty());
}

/// A solid of that name over a base of so many sides, with its top at a height.
fn solid(name: &str, sides: i32, height: f64) -> Mesh {
    let top = Point3::new(0.0, 0.0, height);
    made(Trial::of(name).item(Plane::XY).item(1.0).item(sides).item(top))
}

#[test]
fn solids_over_regular_polygons() {
    for height in [2.0, -2.0] {
        for (name, wanted) in [
            ("Mesh Pyramid", [5, 8, 5]),
            ("Mesh Dipyramid", [6, 12, 8]),
            ("Mesh Prism", [8, 12, 6]),
            ("Mesh Antiprism", [8, 16, 10]),
        ] {
            let mesh = solid(name, 4, height);
            assert_eq!(counts(&mesh), wanted, "{name}");
            assert!(mesh.is_closed() && mesh.is_oriented() && mesh.volume() > 0.0, "{name} {height}");
        }
    }
    // A square with its corners at distance 1 has the area 2.
    near(solid("Mesh Pyramid", 4, 2.0).volume(), 4.0 / 3.0);
    near(solid("Mesh Dipyramid", 4, 2.0).volume(), 8.0 / 3.0);
    near(solid("Mesh Prism", 4, 2.0).volume(), 4.0);
    // An antiprism over n sides with corners at distance 1: n h (sin 2a + sin a) / 3, where a = π / n.
    let a = std::f64::consts::PI / 5.0;
    near(solid("Mesh Antiprism", 5, 2.0).volume(), 5.0 * 2.0 * ((2.0 * a).sin() + a.sin()) / 3.0);
    let inside = made(
        Trial::of("Mesh Prism")
            .item(Plane::XY)
            .item(1.0)
            .item(4)
            .item(Point3::new(0.0, 0.0, 1.0))
            .item(false),
    );
    near(inside.volume(), 4.0);
    assert!(Trial::of("Mesh Prism").item(Plane::XY).item(1.0).item(2).message().contains("sides"));
    assert!(Trial::of("Mesh Prism").item(Plane::XY).item(f64::NAN).message().contains("width"));
    assert!(
        Trial::of("Mesh Prism")
            .item(Plane::XY)
            .item(1.0)
            .item(4)
            .item(Point3::ORIGIN)
            .message()
            .contains("top")
    );
}

/// The edges of a mesh given to Mesh From Lines.
fn woven(mesh: &Mesh, most: i32) -> Mesh {
    let edges = Trial::of("Mesh Edges").item(mesh.clone()).run();
    let lines: Vec<Value> = edges.outputs[0].column().iter().flatten().collect();
    made(Trial::of("Mesh From Lines (Weave Back)").list(lines).item(most))
}

#[test]
fn meshes_come_back_from_their_edges() {
    for mesh in [cube(), tetrahedron(), grid(1), grid(5), solid("Mesh Antiprism", 4, 2.0)] {
        let back = woven(&mesh, 4);
        assert_eq!(counts(&back)[1..], counts(&mesh)[1..]);
        near(back.area(), mesh.area());
        assert!(back.is_oriented());
        assert_eq!(back.is_closed(), mesh.is_closed());
    }
    let ball = made(Trial::of("Catmull-Clark Subdivision").item(cube()).item(3));
    assert_eq!(counts(&woven(&ball, 4)), counts(&ball));
    // One line bounds no face.
    let some = Trial::of("Mesh From Lines (Weave Back)")
        .list([katydid_geometry::Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))]);
    assert!(some.message().contains("No face"));
}

#[test]
fn faces_are_parted_and_cut() {
    let outcome = Trial::of("Reroute Faces").item(cube()).list([0, 5, 5]).run();
    let faces: Vec<usize> = outcome
        .outputs
        .iter()
        .map(|tree| match tree.column().get(0) {
            Some(Value::Mesh(mesh)) => mesh.faces().len(),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(faces, [2, 4]);
    assert_eq!(counts(&made(Trial::of("Tile").item(cube()).item(2).item(0))), [14, 36, 24]);
    assert_eq!(counts(&made(Trial::of("Tile").item(cube()).item(2).item(9))), [8, 12, 6]);
    assert!(Trial::of("Tile").item(cube()).item(8).message().contains("fill"));
}

#[test]
fn blurring_takes_the_mean_with_the_neighbours() {
    // A corner at (1, 1, 1) has three neighbours whose sum is (1, 1, 1): the mean of four is half of it.
    let once = made(Trial::of("Blur Mesh").item(cube()).item(1));
    assert!(
        once.vertices().iter().all(|p| (p.x.abs() - 0.5).abs() < 1e-12 && (p.z.abs() - 0.5).abs() < 1e-12)
    );
}

#[test]
fn regular_solids() {
    let at = Plane::XY.with_origin(Point3::new(1.0, 2.0, 3.0));
    let mesh = made(Trial::of("Mesh Mesh Icosahedron").item(at).item(2.0));
    assert_eq!(counts(&mesh), [12, 30, 20]);
    assert!(mesh.is_closed() && mesh.is_oriented());
    // Of a regular icosahedron with corners at distance 2; sin 72° is the radius over an edge.
    let edge = 2.0 / (std::f64::consts::TAU / 5.0).sin();
    near(mesh.volume(), 5.0 * (3.0 + 5.0_f64.sqrt()) / 12.0 * edge.powi(3));
    assert!(mesh.vertices().iter().all(|p| (p.distance_to(at.origin) - 2.0).abs() < 1e-12));
    let faces = Trial::of("Polylines Dodecahedron").item(at).item(2.0).run().outputs[0].clone();
    assert_eq!(faces.item_count(), 12);
    let edge = 8.0 / (3.0_f64.sqrt() * (1.0 + 5.0_f64.sqrt()));
    for k in 0..12 {
        let Some(Value::Curve(face)) = faces.column().get(k) else { panic!("a curve") };
        assert!(face.is_closed());
        near(face.length(), 5.0 * edge);
    }
    for radius in [0.0, -1.0, f64::NAN] {
        assert!(Trial::of("Mesh Mesh Icosahedron").default().item(radius).message().contains("above 0"));
    }
}

#[test]
fn faces_by_a_pattern() {
    let mesh = made(Trial::of("Mesh Mesh Icosahedron"));
    let trial = || Trial::of("Reroute Faces by Pattern").item(mesh.clone());
    let faces = |pattern: &[bool]| {
        let out = trial().list(pattern.to_vec()).run().outputs;
        [0, 1].map(|k| match out[k].column().get(0) {
            Some(Value::Mesh(mesh)) => mesh.faces().len(),
            _ => 0,
        })
    };
    assert_eq!(faces(&[true, false, false]), [7, 13]);
    assert_eq!(faces(&[true]), [20, 0]);
    assert_eq!(faces(&[false]), [0, 20]);
    let none: [Option<bool>; 1] = [None];
    assert_eq!(trial().gaps(none).texts(0), ["{0}: null"]);
}
