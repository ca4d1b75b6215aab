//! Every kind of geometry through every transform of the stock: nothing is refused, every point goes where the transform
//! says, and the content of solids grows as its determinant says.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::sync::Arc as Shared;

use katydid_3dm::{BrepObject, Extrusion, Limits, Object, PointCloud, SubDObject, SurfaceForm, TextDot};
use katydid_component::testing::Trial;
use katydid_data::{BlockDefinition, BlockInstance, Group, ModelObject, Value};
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::construct::{box_brep, cone, cylinder, sphere, torus};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Arc, Box3, Brep, Circle, Cone, Curve, Cylinder, Interval, Line, Mesh, NurbsCurve, Plane, PlaneSurface,
    Point3, PolyCurve, PolylineCurve, Rectangle, RevolutionSurface, Sphere, SumSurface, Surface, Tolerance,
    Torus, TwistedBox, Vector3, Xform,
};

/// How far an image may be from where the transform sends a point: rounding, of shapes about 10 in size.
const NEAR: f64 = 1e-7;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn cuboid() -> Box3 {
    let side = |length| Interval::new(1.0, 1.0 + length);
    Box3 { plane: Plane::XY, x: side(2.0), y: side(3.0), z: side(1.0) }
}

fn kept(object: Object) -> Value {
    Value::from(object.to_raw(80, &[]).unwrap())
}

/// A ball with the box that Rhino stores round its surface: a form that differs a little from the kernel's.
fn stored_ball() -> Value {
    let brep = sphere(&Sphere::around(p(3.0, 1.0, 2.0), 1.5).unwrap()).unwrap();
    let mut object = BrepObject::from(brep);
    let form = SurfaceForm::of(object.brep.parts().surfaces[0].as_ref().unwrap());
    let SurfaceForm::Revolution { axis, angle, domain, transposed, profile, .. } = form else { panic!() };
    let bounds = object.brep.bounds_of_faces();
    assert!(bounds.is_some());
    object
        .odd_surfaces
        .insert(0, SurfaceForm::Revolution { axis, angle, domain, bounds, transposed, profile });
    kept(Object::Brep(Box::new(object)))
}

fn extrusion() -> Value {
    let ring = Curve::from(Circle::new(Plane::XY, 1.5).unwrap());
    let form = katydid_3dm::CurveForm::of(&ring, 2);
    kept(Object::Extrusion(Box::new(Extrusion {
        profile: Some(form),
        profile_count: 1,
        path: Line::new(p(1.0, 2.0, 3.0), p(1.0, 2.0, 7.0)),
        part: Interval::UNIT,
        up: Vector3::Y,
        is_mitred: [false; 2],
        mitre_normals: [Vector3::Z; 2],
        path_domain: Interval::UNIT,
        transposed: false,
        caps: [true; 2],
        meshes: Vec::new(),
    })))
}

/// A part of a ball and of a cone with bent trims: their parameters do not stay under a stretch.
fn trimmed(surface: &Surface) -> Value {
    let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d));
    let radius = 0.2 * u.length().min(v.length());
    let middle = Plane { origin: p(u.at(0.37), v.at(0.52), 0.0), ..Plane::XY };
    let ring = Curve::from(Circle::new(middle, radius).unwrap());
    let tolerance = Tolerance { absolute: 1e-7, ..Tolerance::default() };
    let mut breps = Brep::from_parameter_loops(surface, &[ring], &tolerance).unwrap();
    Value::from(breps.remove(0))
}

fn chain() -> Curve {
    let arc = Arc::through(p(2.0, 0.0, 1.0), p(3.0, 1.0, 1.0), p(2.0, 2.0, 1.0)).unwrap();
    let parts = vec![
        Curve::from(Line::new(p(0.0, 0.0, 1.0), p(2.0, 0.0, 1.0))),
        Curve::from(arc),
        Curve::from(Line::new(p(2.0, 2.0, 1.0), p(0.0, 3.0, 2.0))),
    ];
    PolyCurve::new(parts).unwrap().into()
}

/// Geometry of every kind, each with a name.
fn kinds() -> Vec<(&'static str, Value)> {
    let tilted = Plane::from_axes(p(1.0, 2.0, 0.5), Vector3::new(1.0, 0.2, 0.1), Vector3::Y).unwrap();
    let circle = Circle::new(tilted, 2.0).unwrap();
    let arc = Arc::new(circle, Interval::new(0.3, 2.5)).unwrap();
    let unit = Interval::new(0.0, 2.0);
    let cube = box_brep(&cuboid()).unwrap();
    let mesh = Mesh::cuboid(&cuboid(), 1, 1, 1).unwrap();
    let wave = NurbsCurve::new(
        3,
        [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, -1.0, 1.0], [4.0, 0.0, 2.0]].map(Point3::from).to_vec(),
        vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
    )
    .unwrap();
    let axis = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 1.0));
    let leaning = Curve::from(Line::new(p(1.0, 0.0, 0.0), p(2.0, 0.0, 3.0)));
    let turned: Surface = RevolutionSurface::new(leaning, axis, Interval::new(0.2, 4.0)).unwrap().into();
    let sum: Surface =
        SumSurface::new(arc.into(), Line::new(p(0.0, 0.0, 0.0), p(0.0, 1.0, 4.0)).into(), Vector3::X)
            .unwrap()
            .into();
    let ball: Surface = Sphere::around(p(1.0, 1.0, 1.0), 2.0).unwrap().into();
    let tube = Cylinder::new(tilted, 1.0, Interval::new(0.0, 3.0)).unwrap();
    let net = SubD::new(SubDNet::from_mesh(&mesh, &FromMesh::default()).unwrap());
    let block = BlockDefinition::new("block", vec![ModelObject::new(Value::from(cube.clone()))]);
    let points = vec![p(1.0, 2.0, 3.0), p(-1.0, 0.5, 2.0)];
    vec![
        ("point", Value::Point(p(1.0, 2.0, 3.0))),
        ("vector", Value::Vector(Vector3::new(1.0, 2.0, 3.0))),
        ("plane", Value::from(tilted)),
        ("line", Value::from(Line::new(p(0.0, 0.0, 0.0), p(1.0, 2.0, 3.0)))),
        ("circle", Value::from(circle)),
        ("arc", Value::from(arc)),
        ("rectangle", Value::from(Rectangle { plane: tilted, x: unit, y: unit })),
        ("box", Value::from(cuboid())),
        ("tilted box", Value::from(Box3 { plane: tilted, ..cuboid() })),
        ("twisted box", Value::from(TwistedBox { corners: cuboid().corners() })),
        ("polyline", Value::from(Curve::from(PolylineCurve::new(cuboid().corners().to_vec()).unwrap()))),
        ("NURBS curve", Value::from(Curve::from(wave))),
        ("curve of curves", Value::from(chain())),
        ("plane surface", Value::from(Surface::from(PlaneSurface::new(tilted, unit, unit).unwrap()))),
        ("revolution", Value::from(turned.clone())),
        ("sum", Value::from(sum.clone())),
        ("NURBS surface", Value::from(Surface::from(ball.to_nurbs().unwrap()))),
        ("ball surface", Value::from(ball.clone())),
        ("box brep", Value::from(cube.clone())),
        ("ball", Value::from(sphere(&Sphere::around(p(1.0, 1.0, 1.0), 2.0).unwrap()).unwrap())),
        ("cylinder", Value::from(cylinder(&tube, [true; 2]).unwrap())),
        ("cone", Value::from(cone(&Cone::new(tilted, 1.0, 2.0).unwrap(), true).unwrap())),
        ("torus", Value::from(torus(&Torus::new(tilted, 3.0, 1.0).unwrap()).unwrap())),
        ("trimmed ball", trimmed(&ball)),
        ("trimmed revolution", trimmed(&turned)),
        ("trimmed sum", trimmed(&sum)),
        ("mesh", Value::from(mesh)),
        ("stored box", kept(Object::Brep(Box::new(BrepObject::from(cube.clone()))))),
        ("stored ball", stored_ball()),
        ("stored extrusion", extrusion()),
        ("stored SubD", kept(Object::SubD(Box::new(SubDObject::from(&net))))),
        ("stored cloud", kept(Object::PointCloud(PointCloud::from(points)))),
        ("stored dot", kept(Object::TextDot(TextDot::new(p(1.0, 0.0, 2.0), "a")))),
        ("model object", Value::from(ModelObject::new(Value::from(cube.clone())))),
        ("block", Value::from(BlockInstance { definition: Shared::new(block), transform: Xform::IDENTITY })),
        ("group", Value::from(Group { members: vec![Some(Value::from(cube)), None, Some(stored_ball())] })),
    ]
}

/// A transform with all its inputs but the geometry.
type Moving = Box<dyn Fn(Value) -> Trial>;

/// Every transform that takes a geometry first and gives its image and its map.
fn transforms() -> Vec<(&'static str, Moving)> {
    let tilted = || Plane::from_axes(p(3.0, -1.0, 2.0), Vector3::new(1.0, 1.0, 0.0), Vector3::Z).unwrap();
    let rectangle =
        |x: f64, y: f64| Rectangle { plane: Plane::XY, x: Interval::new(0.0, x), y: Interval::new(0.0, y) };
    let triangle = |s: f64| {
        let corners = [[0.0, 0.0, 0.0], [s, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]].map(Point3::from);
        Curve::from(PolylineCurve::new(corners.to_vec()).unwrap())
    };
    let around = |s: f64| Box3 {
        plane: Plane::XY,
        x: Interval::new(0.0, s),
        y: Interval::new(0.0, 2.0),
        z: Interval::new(0.0, 1.0),
    };
    let projected = "23285717-156c-468f-a691-b242488c06a6";
    vec![
        ("Move", Box::new(|g| Trial::of("Move").item(g).item(Vector3::new(1.0, -2.0, 3.0)))),
        ("Rotate", Box::new(move |g| Trial::of("Rotate").item(g).item(0.7).item(tilted()))),
        ("Rotate 3D", Box::new(|g| Trial::of("Rotate 3D").item(g).item(0.7).default().item(Vector3::Y))),
        ("Rotate Axis", Box::new(|g| Trial::of("Rotate Axis").item(g).item(1.1).default())),
        (
            "Rotate Direction",
            Box::new(|g| Trial::of("Rotate Direction").item(g).default().item(Vector3::X).item(Vector3::Z)),
        ),
        ("Mirror", Box::new(move |g| Trial::of("Mirror").item(g).item(tilted()))),
        ("Orient", Box::new(move |g| Trial::of("Orient").item(g).item(Plane::XY).item(tilted()))),
        ("Scale", Box::new(|g| Trial::of("Scale").item(g).item(p(1.0, 0.0, 0.0)).item(2.5))),
        ("Scale by −1", Box::new(|g| Trial::of("Scale").item(g).item(p(1.0, 0.0, 0.0)).item(-1.0))),
        (
            "Scale NU",
            Box::new(|g| Trial::of("Scale NU").item(g).item(Plane::XY).item(2.0).item(0.5).item(3.0)),
        ),
        (
            "Scale NU askew",
            Box::new(move |g| Trial::of("Scale NU").item(g).item(tilted()).item(2.0).item(-0.5).item(1.0)),
        ),
        (
            "Shear",
            Box::new(|g| Trial::of("Shear").item(g).default().item(p(0.0, 0.0, 1.0)).item(p(0.5, 1.0, 1.0))),
        ),
        ("Shear Angle", Box::new(|g| Trial::of("Shear Angle").item(g).default().item(0.3).item(-0.2))),
        (
            "Camera Obscura",
            Box::new(|g| Trial::of("Camera Obscura").item(g).item(p(0.5, 0.0, 0.0)).item(0.5)),
        ),
        (
            "Orient Direction",
            Box::new(|g| {
                let from = Trial::of("Orient Direction").item(g).default().item(Vector3::Z);
                from.item(p(1.0, 1.0, 1.0)).item(Vector3::X * 2.0)
            }),
        ),
        (
            "Rectangle Mapping",
            Box::new(move |g| {
                Trial::of("Rectangle Mapping").item(g).item(rectangle(1.0, 1.0)).item(rectangle(2.0, 5.0))
            }),
        ),
        (
            "Box Mapping",
            Box::new(move |g| Trial::of("Box Mapping").item(g).item(around(1.0)).item(around(3.0))),
        ),
        (
            "Triangle Mapping",
            Box::new(move |g| Trial::of("Triangle Mapping").item(g).item(triangle(1.0)).item(triangle(3.0))),
        ),
        ("Transform", {
            let mut xform = Xform::shear(&Plane::XY, [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]);
            xform.rows[0][3] = 2.0;
            Box::new(move |g| Trial::of("Transform").item(g).item(Value::Transform(Shared::new(xform))))
        }),
        ("Project", Box::new(move |g| Trial::of_guid(projected).item(g).item(Plane::XY))),
        (
            "Project Along",
            Box::new(|g| Trial::of("Project Along").item(g).default().item(Vector3::new(0.3, 0.1, -1.0))),
        ),
    ]
}

/// Points of a shape.
fn points(value: &Value) -> Vec<Point3> {
    let of_curve =
        |curve: &Curve| (0..=13).map(|i| curve.point_at(curve.domain().at(f64::from(i) / 13.0))).collect();
    match value {
        Value::Point(q) => vec![*q],
        Value::Plane(plane) => vec![plane.origin],
        Value::Line(line) => vec![line.from, line.to],
        Value::Circle(circle) => of_curve(&Curve::from(**circle)),
        Value::Arc(arc) => of_curve(&Curve::from(**arc)),
        Value::Rectangle(r) => r.corners().to_vec(),
        Value::TwistedBox(b) => b.corners.to_vec(),
        Value::Curve(curve) => of_curve(curve),
        Value::Mesh(mesh) => mesh.vertices().to_vec(),
        Value::Group(group) => group.members.iter().flatten().flat_map(points).collect(),
        _ => match (value.brep(), object(value)) {
            (Some(brep), _) => {
                let brep = brep.unwrap();
                let edges = (0..brep.edges().len()).filter_map(|e| brep.edge_as_curve(e).unwrap());
                edges.flat_map(|curve| of_curve(&curve)).collect()
            }
            (_, Some(Object::PointCloud(cloud))) => cloud.points,
            (_, Some(Object::TextDot(dot))) => vec![dot.point],
            (_, Some(Object::SubD(subd))) => {
                subd.levels[0].vertices.iter().map(|v| Point3::from(v.point)).collect()
            }
            _ => Vec::new(),
        },
    }
}

fn object(value: &Value) -> Option<Object> {
    match value {
        Value::Kept(raw) => Some(raw.parse(&Limits::default()).unwrap()),
        _ => None,
    }
}

/// How far a point is from a shape.
fn distance(value: &Value, q: Point3) -> f64 {
    let nearest = |all: Vec<Point3>| all.iter().map(|r| r.distance_to(q)).fold(f64::INFINITY, f64::min);
    let of_curve = |curve: &Curve| curve.closest_point(q).unwrap().distance;
    match value {
        Value::Circle(circle) => of_curve(&Curve::from(**circle)),
        Value::Arc(arc) => of_curve(&Curve::from(**arc)),
        Value::Rectangle(r) => of_curve(&r.to_polyline().unwrap().into()),
        Value::Curve(curve) => of_curve(curve),
        Value::Group(group) => {
            group.members.iter().flatten().map(|m| distance(m, q)).fold(f64::INFINITY, f64::min)
        }
        _ => match value.brep() {
            Some(brep) => ClosestOnBrep::new(brep.unwrap()).unwrap().nearest(q).unwrap().distance,
            None => nearest(points(value)),
        },
    }
}

fn volume(value: &Value) -> Option<f64> {
    match value {
        Value::Mesh(mesh) => Some(mesh.volume()),
        Value::Group(_) => None,
        _ => {
            let brep = value.brep()?.unwrap();
            brep.is_solid().then(|| brep.volume_properties(1e-9, || true).unwrap().amount)
        }
    }
}

/// The image and the map, which must both be there without a message.
fn run(name: &str, kind: &str, trial: Trial) -> (Value, Option<Xform>) {
    let outcome = trial.run();
    assert!(outcome.messages.is_empty(), "{name} of a {kind}: {:?}", outcome.messages);
    let first = |i: usize| outcome.outputs.get(i).and_then(|tree| tree.column().get(0));
    let image = first(0).unwrap_or_else(|| panic!("{name} of a {kind} gives nothing"));
    let map = match first(1) {
        Some(Value::Transform(xform)) => Some(*xform),
        _ => None,
    };
    (image, map)
}

#[test]
fn every_transform_takes_every_geometry() {
    katydid_components::link();
    for (name, trial) in transforms() {
        let flat = name.starts_with("Project");
        for (kind, value) in kinds() {
            if flat && kind == "plane" {
                // What is left of it need not be a plane.
                continue;
            }
            let (image, map) = run(name, kind, trial(value.clone()));
            let map = map.unwrap_or_else(|| {
                let mut xform = Xform::shear(&Plane::XY, [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]);
                xform.rows[0][3] = 2.0;
                xform
            });
            if let Value::Vector(v) = value {
                assert_eq!(image, Value::Vector(map.vector(v)), "{name}");
                continue;
            }
            if let (true, Some(_)) = (flat, value.brep()) {
                // A flattened solid is a heap of flat faces: it is enough that there is one, and that it is flat.
                let at = points(&image);
                assert!(at.iter().all(|q| q.z.abs() < NEAR), "{name} of a {kind}");
                continue;
            }
            for q in points(&value) {
                let miss = distance(&image, map.point(q));
                assert!(miss < NEAR, "{name} of a {kind}: {q:?} is {miss} off");
            }
            if let Some(brep) = image.brep() {
                let brep = brep.unwrap();
                assert!(brep.is_valid(), "{name} of a {kind}: {:?}", brep.faults());
            }
            if let Some(before) = volume(&value) {
                let (after, factor) = (volume(&image).unwrap_or(f64::NAN), map.determinant().abs());
                let near = (after - before * factor).abs() <= 1e-6 * before.abs() * factor;
                assert!(near, "{name} of a {kind}: {before} × {factor} becomes {after}");
            }
        }
    }
}

#[test]
fn a_trimmed_face_keeps_its_area_under_a_twofold_stretch() {
    // Twice as long in each direction by two steps that are no similarities: the area is four times what it was.
    katydid_components::link();
    for (kind, value) in kinds().into_iter().filter(|(kind, _)| kind.starts_with("trimmed")) {
        let area = |value: &Value| {
            let brep = value.brep().unwrap().unwrap();
            brep.area_properties(1e-9, || true).unwrap().amount
        };
        let stretch = |g: Value, [x, y, z]: [f64; 3]| {
            run("Scale NU", kind, Trial::of("Scale NU").item(g).default().item(x).item(y).item(z)).0
        };
        let image = stretch(stretch(value.clone(), [2.0, 1.0, 4.0]), [1.0, 2.0, 0.5]);
        let (before, after) = (area(&value), area(&image));
        assert!((after - 4.0 * before).abs() < 1e-6 * after, "{kind}: {before} and {after}");
    }
}

#[test]
fn arrays_take_every_geometry() {
    katydid_components::link();
    let cell = Box3 { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT, z: Interval::UNIT };
    let square = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
    for (kind, value) in kinds() {
        let arrays = [
            (3, Trial::of("Linear Array").item(value.clone()).item(Vector3::X * 5.0).item(3)),
            (8, Trial::of("Box Array").item(value.clone()).item(cell).item(2).item(2).item(2)),
            (4, Trial::of("Rectangular Array").item(value.clone()).item(square).item(2).item(2)),
            (3, Trial::of("Polar Array").item(value.clone()).default().item(3).default()),
            (4, Trial::of("Kaleidoscope").item(value.clone()).default().item(4)),
            (3, Trial::of("Curve Array").item(value.clone()).item(chain()).item(3)),
        ];
        for (count, trial) in arrays {
            let outcome = trial.run();
            assert!(outcome.messages.is_empty(), "{kind}: {:?}", outcome.messages);
            let tree = outcome.outputs.first().unwrap();
            let images = tree.column();
            assert!(images.len() >= count, "{kind}: {} images", images.len());
            assert!((0..images.len()).all(|i| images.get(i).is_some()), "{kind}");
        }
    }
}

/// Every Brep and extrusion inside the definitions at hand goes through a stretch and a turn.
#[test]
fn stored_solids_of_real_files() {
    katydid_components::link();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/3dm");
    let Ok(files) = std::fs::read_dir(folder) else {
        println!("skipped: {folder} is absent");
        return;
    };
    let (mut seen, mut faults) = (0, Vec::new());
    for file in files {
        let path = file.unwrap().path();
        let Ok(bytes) = std::fs::read(&path) else { continue };
        let Ok(model) = katydid_3dm::Model::read(&bytes, &Limits::default()) else { continue };
        for object in model.objects {
            let Object::Brep(brep) = &object.geometry else { continue };
            if !brep.brep.is_valid() || brep.brep.faces().len() > 60 {
                continue;
            }
            let value = kept(object.geometry);
            seen += 1;
            let named = path.file_stem().unwrap().to_string_lossy().into_owned();
            for trial in [
                Trial::of("Scale NU").item(value.clone()).default().item(2.0).item(0.5).item(3.0),
                Trial::of("Rotate").item(value).item(0.5).default(),
            ] {
                let outcome = trial.run();
                let image = outcome.outputs.first().and_then(|tree| tree.column().get(0));
                match image.and_then(|image| image.brep()) {
                    Some(Ok(image)) if image.is_valid() => {}
                    other => faults.push(format!(
                        "{named} {}: {:?} {:?}",
                        object.attributes.id,
                        outcome.messages,
                        other.map(|image| image.map(|image| image.faults().first().cloned()))
                    )),
                }
            }
        }
    }
    assert!(seen == 0 || seen > 100, "{seen}");
    assert!(faults.is_empty(), "{} of {seen}: {}", faults.len(), faults.join("\n"));
}
