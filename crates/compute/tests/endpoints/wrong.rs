//! Every function called with all sorts of arguments, right and wrong: an answer or a fault, never a panic.

use std::panic::{AssertUnwindSafe, catch_unwind};

use katydid_compute::wire::Subdivision;
use katydid_compute::{Bounds, geometry};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Brep, Circle, Curve, Interval, KnotSpacing, Line, Mesh, NurbsCurve, Plane, PlaneSurface, Point3,
    PolylineCurve, Rectangle, Sphere, Surface, construct,
};
use serde_json::{Value as Json, json};

use crate::helpers::{cube, object};

/// One sample of everything that arguments may be.
struct Pool {
    curves: Vec<Json>,
    surfaces: Vec<Json>,
    breps: Vec<Json>,
    meshes: Vec<Json>,
    subd: Json,
}

impl Pool {
    fn new() -> Self {
        let points =
            [(0.0, 0.0), (1.0, 2.0), (3.0, 1.0), (4.0, 0.0)].map(|(x, y)| Point3::new(x, y, 0.5 * x));
        let through = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap();
        let square =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)].map(|(x, y)| Point3::new(x, y, 0.0));
        let curves: [Curve; 4] = [
            Circle::new(Plane::XY, 5.0).unwrap().into(),
            Line::new(Point3::new(-10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 0.0)).into(),
            PolylineCurve::new(square.to_vec()).unwrap().into(),
            through.into(),
        ];
        let flat = PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap();
        let ball = Sphere::around(Point3::ORIGIN, 5.0).unwrap();
        let surfaces: [Surface; 2] = [flat.into(), ball.to_revolution().into()];
        let breps = [
            construct::sphere(&ball).unwrap(),
            construct::box_brep(&cube()).unwrap(),
            Brep::from_surface(surfaces[0].clone()).unwrap(),
        ];
        let rectangle = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        let meshes = [
            Mesh::cuboid(&cube(), 1, 1, 1).unwrap(),
            Mesh::sphere(&Plane::XY, 2.0, 8, 6).unwrap(),
            Mesh::plane(&rectangle, 2, 2).unwrap(),
        ];
        let net = SubDNet::from_mesh(&meshes[0], &FromMesh { creases: false, corners: false }).unwrap();
        Self {
            curves: curves.iter().map(object).collect(),
            surfaces: surfaces.iter().map(object).collect(),
            breps: breps.iter().map(object).collect(),
            meshes: meshes.iter().map(object).collect(),
            subd: object(&Subdivision(SubD::new(net))),
        }
    }

    /// An argument of a type of a path, one of several.
    fn argument(&self, kind: &str, turn: usize) -> Json {
        let one = |all: &[Json]| all[turn % all.len()].clone();
        if let Some(inner) = kind.strip_suffix("array") {
            return json!([self.argument(inner, turn), self.argument(inner, turn + 1)]);
        }
        let point = || json!({ "X": turn, "Y": 0.5, "Z": 1.0 });
        match kind {
            "curve" | "nurbscurve" | "polylinecurve" | "polyline" => one(&self.curves),
            "surface" | "nurbssurface" => one(&self.surfaces),
            "brep" | "brepface" | "extrusion" => one(&self.breps),
            "mesh" => one(&self.meshes),
            "subd" => self.subd.clone(),
            "geometrybase" => {
                one(&[self.curves[turn % 4].clone(), self.breps[turn % 3].clone(), self.meshes[0].clone()])
            }
            "point3d" | "point2d" => point(),
            "vector3d" => json!({ "X": 0.0, "Y": 0.25 * turn as f64, "Z": 1.0 }),
            "plane" => object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 0.5))),
            "line" => object(&Line::new(Point3::new(0.0, -9.0, 0.5), Point3::new(1.0, 9.0, 0.5))),
            "interval" => json!({ "T0": 0.25, "T1": 0.75 }),
            "double" => json!([0.01, 0.5, 2.0][turn % 3]),
            "int" => json!([2, 0, 5][turn % 3]),
            "bool" => json!(turn.is_multiple_of(2)),
            "ray3d" => json!({ "Position": [0.25, 0.25, 20.0], "Direction": [0.0, 0.0, -1.0] }),
            "boundingbox" | "box" => object(&cube()),
            "sphere" => object(&Sphere::around(Point3::ORIGIN, 2.0).unwrap()),
            "circle" => object(&Circle::new(Plane::XY, 2.0).unwrap()),
            "transform" => json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
            "meshingparameters" => json!({ "RelativeTolerance": 0.3 }),
            "meshpoint" => json!({ "FaceIndex": 0, "T": [0.25, 0.25, 0.5, 0.0] }),
            _ => json!(0),
        }
    }
}

/// What is in the way of a call: a panic, told by its path and arguments.
fn call(path: &str, arguments: &[Json]) -> Result<bool, String> {
    let body = serde_json::to_vec(arguments).unwrap();
    let bounds = Bounds::default();
    let called =
        catch_unwind(AssertUnwindSafe(|| geometry::call(path, &geometry::Query::default(), &body, &bounds)));
    match called {
        Ok(result) => {
            if let Err(fault) = &result {
                assert!(!fault.message.is_empty(), "{path}");
            }
            Ok(result.is_ok())
        }
        Err(_) => {
            Err(format!("{path} {}", String::from_utf8_lossy(&body).chars().take(300).collect::<String>()))
        }
    }
}

/// The types of a path, as many as callers send arguments.
fn kinds(path: &str, count: usize) -> Vec<String> {
    let types = path.split_once('-').map_or("", |(_, types)| types);
    let mut kinds: Vec<String> = types.split('_').map(str::to_owned).collect();
    kinds.resize(count.max(1), "int".into());
    kinds
}

#[test]
fn no_arguments_make_a_function_panic() {
    let pool = Pool::new();
    let wrong = [
        Json::Null,
        json!("text"),
        json!("NaN"),
        json!(-1),
        json!(1e308),
        json!(true),
        json!([]),
        json!({}),
        json!([[[]]]),
        json!({ "url": "http://127.0.0.1/" }),
        json!({ "version": 10000, "archive3dm": 999, "opennurbs": 0, "data": "AAAA" }),
        json!({ "X": "NaN", "Y": 0, "Z": 0 }),
    ];
    let (mut panics, mut silent) = (Vec::new(), Vec::new());
    for path in geometry::endpoints().answered() {
        let count = geometry::endpoints().parameters(path).unwrap().len();
        let kinds = kinds(path, count);
        let mut answered = false;
        for turn in 0..4 {
            let arguments: Vec<Json> =
                kinds.iter().enumerate().map(|(i, kind)| pool.argument(kind, turn + i)).collect();
            match call(path, &arguments) {
                Ok(fine) => answered |= fine,
                Err(panic) => panics.push(panic),
            }
            if turn > 0 {
                continue;
            }
            for place in 0..arguments.len() {
                for bad in wrong.iter().chain([&pool.subd, &pool.curves[0], &pool.meshes[0]]) {
                    let mut arguments = arguments.clone();
                    arguments[place] = bad.clone();
                    panics.extend(call(path, &arguments).err());
                }
                panics.extend(call(path, &arguments[..place]).err());
            }
        }
        if !answered {
            silent.push(path);
        }
    }
    assert!(panics.is_empty(), "{} panics:\n{}", panics.len(), panics.join("\n"));
    // These need arguments that fit each other better than samples do; the cases have them.
    println!("{} paths answered no sample: {silent:#?}", silent.len());
}

#[test]
fn numbers_at_the_end_of_their_range_are_answered_or_refused() {
    let pool = Pool::new();
    let mut panics = Vec::new();
    for path in geometry::endpoints().answered() {
        let count = geometry::endpoints().parameters(path).unwrap().len();
        let kinds = kinds(path, count);
        for extreme in [0.0, -1.0, 1e-300, 1e12, 1e300] {
            let one = |(i, kind): (usize, &String)| match kind.as_str() {
                "double" | "int" => json!(extreme),
                "point3d" => json!([extreme, 0.0, 0.0]),
                other => pool.argument(other, i),
            };
            panics.extend(call(path, &kinds.iter().enumerate().map(one).collect::<Vec<_>>()).err());
        }
    }
    assert!(panics.is_empty(), "{} panics:\n{}", panics.len(), panics.join("\n"));
}
