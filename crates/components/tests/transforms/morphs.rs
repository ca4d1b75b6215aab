//! Deformations: every point of the shape goes where the map takes it, within the tolerance, and solids stay solids.

use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{
    Arc, Box3, Circle, Curve, Cylinder, Interval, Line, MeshSettings, NurbsCurve, Plane, Point3, Surface,
    TwistedBox, Vector3,
};

use crate::kinds::{distance, kinds, p, points, volume};

/// The tolerance of a definition that no model gives one, and rounding.
const NEAR: f64 = 0.01 + 1e-6;
/// At most so many points of a solid's faces are looked at.
const MOST: usize = 60;

/// A deformation with all its inputs but the geometry.
type Bending = Box<dyn Fn(Value) -> Trial>;

fn line(a: [f64; 3], b: [f64; 3]) -> Line {
    Line::new(a.into(), b.into())
}

/// A gently bent curve beside all the shapes.
fn rail() -> Curve {
    let points = [[-20.0, -12.0, 0.0], [-6.0, -14.0, 1.0], [6.0, -15.0, -1.0], [20.0, -12.0, 0.0]];
    NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into()
}

/// A part of a tube so wide that the shapes lie inside it.
fn tube() -> Surface {
    let about = Plane::from_axes(p(0.0, 0.0, -40.0), Vector3::Z, Vector3::X).unwrap();
    Cylinder::new(about, 30.0, Interval::new(-30.0, 30.0)).unwrap().into()
}

fn middle(surface: &Surface) -> Point3 {
    let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d).at(0.45));
    p(u, v, 0.0)
}

/// Every deformation that takes any geometry.
fn morphs() -> Vec<(&'static str, Bending)> {
    let around = || Box3 {
        plane: Plane::XY,
        x: Interval::new(-5.0, 10.0),
        y: Interval::new(-5.0, 10.0),
        z: Interval::new(-4.0, 12.0),
    };
    let twisted = move || {
        let mut corners = around().corners();
        corners[6] += Vector3::new(2.0, 1.0, 3.0);
        corners[1] += Vector3::new(-1.0, 1.5, 0.5);
        TwistedBox::new(corners).unwrap()
    };
    let up = || line([0.5, 0.3, -5.0], [0.5, 0.3, 12.0]);
    let short = || line([0.5, 0.3, 1.3], [0.5, 0.3, 2.2]);
    let about = || Plane::YZ.with_origin(p(0.0, -25.0, -5.0));
    let arc = move || Arc::new(Circle::new(about(), 25.0).unwrap(), Interval::new(0.0, 0.9)).unwrap();
    let by = [Vector3::new(0.0, 1.0, 2.0), Vector3::new(1.0, 0.0, 0.0)];
    let at = [p(2.0, 2.0, 1.0), p(9.0, -3.0, 4.0)];
    vec![
        ("Box Morph", Box::new(move |g| Trial::of("Box Morph").item(g).item(around()).item(twisted()))),
        (
            "Surface Morph",
            Box::new(move |g| {
                let (surface, unit) = (tube(), Interval::new(0.2, 0.4));
                let [u, v] = katydid_geometry::Direction::BOTH.map(|d| {
                    let domain = surface.domain(d);
                    Interval::new(domain.at(unit.start), domain.at(unit.end))
                });
                let morph = Trial::of("Surface Morph").item(g).item(around()).item(surface);
                morph.item(u).item(v).item(Interval::new(0.0, 8.0))
            }),
        ),
        ("Stretch", Box::new(move |g| Trial::of("Stretch").item(g).item(up()).item(25.0))),
        ("Stretch of a part", Box::new(move |g| Trial::of("Stretch").item(g).item(short()).item(2.0))),
        ("Taper", Box::new(move |g| Trial::of("Taper").item(g).item(up()).item(2.0).item(1.0).item(false))),
        (
            "Flat taper",
            Box::new(move |g| Trial::of("Taper").item(g).item(up()).item(1.0).item(2.0).item(true)),
        ),
        ("Twist", Box::new(move |g| Trial::of("Twist").item(g).item(up()).item(1.5).item(true))),
        (
            "Twist of a part",
            Box::new(move |g| Trial::of("Twist").item(g).item(short()).item(0.4).item(false)),
        ),
        ("Bend Deform", Box::new(move |g| Trial::of("Bend Deform").item(g).item(arc()))),
        ("Maelstrom", Box::new(|g| Trial::of("Maelstrom").item(g).default().item(1.7).item(12.0).item(0.6))),
        (
            "Flow",
            Box::new(|g| {
                Trial::of("Flow").item(g).item(line([-20.0, -12.0, 0.0], [20.0, -12.0, 0.0])).item(rail())
            }),
        ),
        (
            "Splop",
            Box::new(|g| Trial::of("Splop").item(g).default().item(tube()).item(middle(&tube())).item(0.3)),
        ),
        (
            "Sporph",
            Box::new(|g| {
                // The other way, and closed far below the shapes.
                let about = Plane::from_axes(p(0.0, 0.0, -60.0), -Vector3::Z, Vector3::Y).unwrap();
                let base: Surface = Cylinder::new(about, 50.0, Interval::new(-30.0, 30.0)).unwrap().into();
                let from = middle(&base);
                Trial::of("Sporph").item(g).item(base).item(from).item(tube()).item(middle(&tube()))
            }),
        ),
        (
            "Mirror Curve",
            Box::new(|g| Trial::of_guid("9c9f8219-ae88-4d29-ba1b-3433ed713639").item(g).item(rail())),
        ),
        (
            "Mirror Surface",
            Box::new(|g| Trial::of_guid("6ce1aa3c-626b-4db7-8b5b-bf74c78f8c5e").item(g).item(tube())),
        ),
        ("Spatial Deform", Box::new(move |g| Trial::of("Spatial Deform").item(g).list(at).list(by))),
        (
            "Spatial Deform (custom)",
            Box::new(move |g| {
                Trial::of("Spatial Deform (custom)").item(g).list(at).list(by).item("1/(2+x*x)")
            }),
        ),
    ]
}

/// A map that acts on a part of space has a kink, which takes many control points where it runs askew: these shapes are
/// enough for it.
const KINKED: [&str; 6] = ["line", "NURBS curve", "plane surface", "box brep", "cylinder", "mesh"];

/// Points of a shape, of a solid's faces too.
fn samples(value: &Value) -> Vec<Point3> {
    let mut all = points(value);
    if let Some(brep) = value.brep() {
        let settings = MeshSettings { min_edge: 0.2, relative_tolerance: 0.3, ..MeshSettings::default() };
        let mesh = brep.unwrap().mesh(&settings).unwrap();
        all.extend(mesh.points());
    }
    let step = all.len().div_ceil(MOST).max(1);
    all.into_iter().step_by(step).collect()
}

/// The image without messages.
fn image(name: &str, kind: &str, trial: Trial) -> Result<Value, String> {
    let outcome = trial.run();
    match outcome.outputs.first().and_then(|tree| tree.column().get(0)) {
        Some(image) if outcome.messages.is_empty() => Ok(image),
        _ => Err(format!("{name} of a {kind}: {:?}", outcome.messages)),
    }
}

#[test]
fn every_deformation_takes_every_geometry() {
    katydid_components::link();
    let mut faults = Vec::new();
    for (name, trial) in morphs() {
        let began = std::time::Instant::now();
        let mapped = |q: Point3| match trial(Value::Point(q)).run().outputs[0].column().get(0) {
            Some(Value::Point(q)) => q,
            other => panic!("{name}: {other:?}"),
        };
        for (kind, value) in kinds() {
            if (name.ends_with("of a part") || name == "Maelstrom") && !KINKED.contains(&kind) {
                continue;
            }
            if kind == "block" {
                // It is carried as a whole, and a remark says so.
                assert!(trial(value).message().contains("carried as a whole"));
                continue;
            }
            let made = match image(name, kind, trial(value.clone())) {
                Ok(made) => made,
                Err(fault) => {
                    faults.push(fault);
                    continue;
                }
            };
            if let Value::Vector(v) = value {
                let by = mapped(Point3::ORIGIN + v) - mapped(Point3::ORIGIN);
                assert!(matches!(made, Value::Vector(image) if (image - by).length() < 1e-9), "{name}");
                continue;
            }
            let miss = samples(&value).into_iter().map(|q| distance(&made, mapped(q))).fold(0.0, f64::max);
            if miss.is_nan() || miss >= NEAR {
                faults.push(format!("{name} of a {kind} is {miss} off"));
            }
            if let (Some(before), Some(after)) = (value.brep(), made.brep()) {
                let (before, after) = (before.unwrap(), after.unwrap());
                if !after.is_valid() {
                    faults.push(format!("{name} of a {kind}: {:?}", after.faults()));
                }
                let counts = |brep: &katydid_geometry::Brep| {
                    [brep.faces().len(), brep.edges().len(), brep.vertices().len()]
                };
                if before.is_solid() != after.is_solid() || counts(&before) != counts(&after) {
                    faults.push(format!(
                        "{name} of a {kind}: {:?} became {:?}",
                        counts(&before),
                        counts(&after)
                    ));
                }
                if after.is_solid() && volume(&made).is_none_or(|amount| amount.is_nan() || amount <= 0.0) {
                    faults.push(format!("{name} of a {kind} is inside out"));
                }
            }
        }
        println!("{name}: {:?}", began.elapsed());
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
