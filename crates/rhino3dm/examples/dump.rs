//! Prints what archives and single objects hold, one JSON object a line, for comparison with other readers.
//!
//! `dump FILE.3dm…` prints a line an object of each archive; `dump OBJECTS.jsonl` reads lines with the members
//! `archive3dm`, `opennurbs` and `data` (base64), the form rhino3dm encodes objects in, and prints a line each.

use base64::Engine;
use katydid_3dm::{BrepSummary, Limits, Model, Object};
use katydid_geometry::{Curve, Direction, Plane, Point3, Surface, Vector3};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        if path.ends_with(".jsonl") {
            for line in std::fs::read_to_string(&path)?.lines() {
                println!("{}", encoded_object(&serde_json::from_str(line)?));
            }
        } else {
            archive(&path)?;
        }
    }
    Ok(())
}

fn archive(path: &str) -> Result<(), Box<dyn std::error::Error>> {
    let model = match Model::read(&std::fs::read(path)?, &Limits::default()) {
        Ok(model) => model,
        Err(error) => {
            println!("{}", json!({"file": path, "error": error.to_string()}));
            return Ok(());
        }
    };
    let layers: Vec<Value> = (model.layers.iter().enumerate())
        .map(|(i, layer)| {
            json!({"name": layer.name, "path": model.layer_path(i), "colour": layer.colour,
                "id": layer.id.to_string(), "visible": layer.visible, "locked": layer.locked})
        })
        .collect();
    let warnings: Vec<String> = model.warnings.iter().map(ToString::to_string).collect();
    println!(
        "{}",
        json!({"file": path, "version": model.archive_version, "units": model.units.name(), "notes": model.notes,
            "absolute": model.tolerance.absolute, "angle": model.tolerance.angle, "layers": layers,
            "objects": model.objects.len(), "lights": model.lights.len(), "skipped": model.skipped,
            "warnings": warnings})
    );
    for object in model.objects.iter().chain(&model.lights) {
        let attributes = &object.attributes;
        println!(
            "{}",
            json!({"id": attributes.id.to_string(), "name": attributes.name, "layer": attributes.layer,
                "colour": attributes.colour, "visible": attributes.visible,
                "user_strings": attributes.user_strings, "geometry": geometry(&object.geometry)})
        );
    }
    Ok(())
}

fn encoded_object(form: &Value) -> Value {
    let number = |key: &str| form[key].as_i64().and_then(|n| i32::try_from(n).ok()).unwrap_or_default();
    let data = form["data"].as_str().unwrap_or_default();
    let Ok(data) = base64::engine::general_purpose::STANDARD.decode(data) else {
        return json!({"error": "the data is not base64"});
    };
    match Object::from_on_data(number("archive3dm"), number("opennurbs"), &data) {
        Ok(object) => {
            let written = object.to_on_data(60).map(|w| {
                let again = Object::from_on_data(w.archive3dm, w.opennurbs, &w.data);
                json!({"version": 10000, "archive3dm": w.archive3dm, "opennurbs": w.opennurbs,
                    "data": base64::engine::general_purpose::STANDARD.encode(&w.data),
                    "read_back_equal": again.is_ok_and(|back| back == object)})
            });
            json!({"geometry": geometry(&object), "written": written.ok()})
        }
        Err(error) => json!({"error": error.to_string()}),
    }
}

fn geometry(object: &Object) -> Value {
    let detail = match object {
        Object::Point(p) => json!({"point": point(*p)}),
        Object::PointCloud(cloud) => {
            json!({"points": points(&cloud.points), "normals": vectors(&cloud.normals),
                "colours": cloud.colours})
        }
        Object::Curve(c) => curve(c),
        Object::Surface(s) => surface(s),
        Object::Mesh(mesh) => {
            let faces: Vec<&[u32]> = mesh.faces().iter().map(|face| face.indices()).collect();
            json!({"vertices": points(mesh.vertices()), "faces": faces, "normals": vectors(mesh.normals()),
                "colours": mesh.colours()})
        }
        Object::Kept(raw) if raw.class_name() == "Brep" => match BrepSummary::read(raw) {
            Ok(brep) => {
                let curves: Vec<Value> = brep.curves.iter().map(curve).collect();
                let edges: Vec<Value> = (brep.edges.iter().enumerate())
                    .map(|(i, e)| {
                        let points: Vec<_> =
                            [0.0, 0.3, 1.0].map(|x| brep.edge_point(i, e.domain.at(x)).map(point)).into();
                        json!({"domain": [e.domain.start, e.domain.end], "trims": e.trims, "points": points})
                    })
                    .collect();
                json!({"faces": brep.faces, "vertices": points(&brep.vertices), "curves": curves,
                    "bare": raw.untrimmed_surface().ok().flatten().as_ref().map(surface),
                    "edges": edges, "closed": brep.is_closed(), "solidity": format!("{:?}", brep.solidity)})
            }
            Err(error) => json!({"brep_error": error.to_string()}),
        },
        _ => json!({}),
    };
    json!({"class": object.class_name(), "kept": matches!(object, Object::Kept(_)), "detail": detail})
}

fn surface(surface: &Surface) -> Value {
    let domains = Direction::BOTH.map(|d| surface.domain(d));
    let at = [0.0, 0.3, 0.5, 1.0];
    let samples: Vec<[f64; 3]> = at
        .iter()
        .flat_map(|x| at.map(|y| point(surface.point_at(domains[0].at(*x), domains[1].at(y)))))
        .collect();
    let kind = match surface {
        Surface::Plane(_) => "plane",
        Surface::Sum(_) => "sum",
        Surface::Revolution(_) => "revolution",
        Surface::Nurbs(_) => "nurbs",
    };
    let mut detail = json!({"kind": kind, "domains": domains.map(|d| [d.start, d.end]), "samples": samples});
    if let Surface::Nurbs(s) = surface {
        detail["degrees"] = json!(s.degrees());
        detail["knots"] = json!(Direction::BOTH.map(|d| s.knots(d)));
        detail["points"] = json!(s.homogeneous_points());
    }
    detail
}

fn curve(curve: &Curve) -> Value {
    let domain = curve.domain();
    let domain = [domain.start, domain.end];
    match curve {
        Curve::Line(c) => {
            json!({"kind": "line", "domain": domain, "from": point(c.line.from), "to": point(c.line.to)})
        }
        Curve::Arc(c) => json!({"kind": "arc", "domain": domain, "plane": plane(&c.arc.circle.plane),
            "radius": c.arc.circle.radius, "angle": [c.arc.angle.start, c.arc.angle.end]}),
        Curve::Polyline(c) => json!({"kind": "polyline", "domain": domain, "points": points(c.points()),
            "parameters": c.parameters()}),
        Curve::Nurbs(c) => json!({"kind": "nurbs", "domain": domain, "degree": c.degree(),
            "rational": c.is_rational(), "knots": c.knots(), "points": c.homogeneous_points()}),
        Curve::Poly(c) => {
            let segments: Vec<Value> = c.segments().iter().map(self::curve).collect();
            json!({"kind": "poly", "domain": domain, "parameters": c.parameters(), "segments": segments})
        }
    }
}

fn point(p: Point3) -> [f64; 3] {
    [p.x, p.y, p.z]
}

fn vector(v: Vector3) -> [f64; 3] {
    [v.x, v.y, v.z]
}

fn points(points: &[Point3]) -> Vec<[f64; 3]> {
    points.iter().copied().map(point).collect()
}

fn vectors(vectors: &[Vector3]) -> Vec<[f64; 3]> {
    vectors.iter().copied().map(vector).collect()
}

fn plane(plane: &Plane) -> [[f64; 3]; 4] {
    [point(plane.origin), vector(plane.x_axis), vector(plane.y_axis), vector(plane.z_axis)]
}
