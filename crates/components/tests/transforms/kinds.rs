//! Geometry of every kind, and measures of it.

use std::sync::Arc as Shared;

use katydid_3dm::{BrepObject, Extrusion, Limits, Object, PointCloud, SubDObject, SurfaceForm, TextDot};
use katydid_component::testing::Trial;
use katydid_data::{BlockDefinition, BlockInstance, Group, ModelObject, Value};
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::construct::{box_brep, cone, cylinder, extrude_brep, sphere, torus};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Arc, Box3, Brep, Circle, Cone, Curve, Cylinder, Interval, Line, Mesh, NurbsCurve, Plane, PlaneSurface,
    Point3, PolyCurve, PolylineCurve, Rectangle, RevolutionSurface, Sphere, SumSurface, Surface, Tolerance,
    Torus, TwistedBox, Vector3, Xform,
};

pub(crate) fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

pub(crate) fn cuboid() -> Box3 {
    let side = |length| Interval::new(1.0, 1.0 + length);
    Box3 { plane: Plane::XY, x: side(2.0), y: side(3.0), z: side(1.0) }
}

pub(crate) fn kept(object: Object) -> Value {
    Value::from(object.to_raw(80, &[]).unwrap())
}

/// A ball with the box that Rhino stores round its surface: a form that differs a little from the kernel's.
pub(crate) fn stored_ball() -> Value {
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

pub(crate) fn extrusion() -> Value {
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
pub(crate) fn trimmed(surface: &Surface) -> Value {
    let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d));
    let radius = 0.2 * u.length().min(v.length());
    let middle = Plane { origin: p(u.at(0.37), v.at(0.52), 0.0), ..Plane::XY };
    let ring = Curve::from(Circle::new(middle, radius).unwrap());
    let tolerance = Tolerance { absolute: 1e-7, ..Tolerance::default() };
    let mut breps = Brep::from_parameter_loops(surface, &[ring], &tolerance).unwrap();
    Value::from(breps.remove(0))
}

fn holes() -> Brep {
    let outline = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 5.0), y: Interval::new(0.0, 4.0) };
    let ring = |x: f64, r: f64| Circle::new(Plane { origin: p(x, 2.0, 0.0), ..Plane::XY }, r).unwrap().into();
    let curves = [outline.to_polyline().unwrap().into(), ring(1.5, 0.8), ring(3.5, 0.5)];
    let mut found = Brep::planar_faces(&curves, &Tolerance::default()).unwrap().breps;
    assert_eq!((found.len(), found[0].loops().len()), (1, 3));
    found.remove(0)
}

/// A flat face with two holes.
fn plate() -> Value {
    Value::from(holes())
}

/// A slab with two holes through it.
fn pierced() -> Value {
    let solid = extrude_brep(&holes(), Vector3::new(0.3, 0.0, 2.0), &Tolerance::default()).unwrap();
    assert!(solid.is_solid());
    Value::from(solid)
}

/// A pole of a cone and an open end.
fn funnel() -> Value {
    let tilted = Plane::from_axes(p(2.0, 2.0, 3.0), Vector3::X, Vector3::new(0.0, 1.0, 0.3)).unwrap();
    Value::from(cone(&Cone::new(tilted, 2.0, 1.5).unwrap(), false).unwrap())
}

pub(crate) fn chain() -> Curve {
    let arc = Arc::through(p(2.0, 0.0, 1.0), p(3.0, 1.0, 1.0), p(2.0, 2.0, 1.0)).unwrap();
    let parts = vec![
        Curve::from(Line::new(p(0.0, 0.0, 1.0), p(2.0, 0.0, 1.0))),
        Curve::from(arc),
        Curve::from(Line::new(p(2.0, 2.0, 1.0), p(0.0, 3.0, 2.0))),
    ];
    PolyCurve::new(parts).unwrap().into()
}

/// Geometry of every kind, each with a name.
pub(crate) fn kinds() -> Vec<(&'static str, Value)> {
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
        ("solid with a hole", pierced()),
        ("plate with holes", plate()),
        ("open cone", funnel()),
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

/// Points of a shape.
pub(crate) fn points(value: &Value) -> Vec<Point3> {
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
pub(crate) fn distance(value: &Value, q: Point3) -> f64 {
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

pub(crate) fn volume(value: &Value) -> Option<f64> {
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
pub(crate) fn run(name: &str, kind: &str, trial: Trial) -> (Value, Option<Xform>) {
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
