//! The operations, each with the law that its result is held to.

use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct::{box_brep, offset_surface};
use katydid_geometry::intersect::{curve_with_surface, surface_with_surface};
use katydid_geometry::{
    Box3, Brep, Curve, Interval, Line, MeshSettings, Plane, PlaneSurface, Point3, Surface, Vector3,
};
use katydid_step::{Document, Part, Shape};

use crate::subjects::Subject;

/// Why an operation gave nothing: it refused, or what it gave breaks its law.
pub(crate) enum Fault {
    Refused(String),
    Wrong(String),
}

impl From<String> for Fault {
    fn from(why: String) -> Self {
        Self::Wrong(why)
    }
}

impl From<katydid_geometry::Error> for Fault {
    fn from(error: katydid_geometry::Error) -> Self {
        Self::Refused(error.to_string())
    }
}

/// What stands in the table.
#[derive(Debug)]
pub(crate) enum Cell {
    Works,
    Refused(String),
    Wrong(String),
}

impl Cell {
    pub(crate) fn of(result: Outcome) -> Self {
        match result {
            Ok(()) => Self::Works,
            Err(Fault::Refused(why)) => Self::Refused(why),
            Err(Fault::Wrong(why)) => Self::Wrong(why),
        }
    }
}

type Outcome = Result<(), Fault>;

/// The name, the law in words, and what is run.
pub(crate) type Operation = (&'static str, &'static str, fn(&Subject) -> Outcome);

pub(crate) const OPERATIONS: [Operation; 18] = [
    ("evaluate", "the normal is at right angles to both partial derivatives", evaluate),
    ("closest point", "of a point beside the surface it is the foot of its normal", closest_point),
    (
        "curvature",
        "the same as that of the NURBS form there, and Gaussian is the product of the principal ones",
        curvature,
    ),
    ("meet a curve", "a line along the normal goes through its foot", meet_a_curve),
    ("meet a plane", "the solid's section lies in the plane and on the solid", meet_a_plane),
    ("meet a surface", "the common curves with a rectangle lie on both", meet_a_surface),
    ("offset", "the surface beside it is everywhere at the distance", offset),
    ("split", "the parts of the solid on both sides of a plane have its area together", split),
    ("boolean", "the solid outside and inside of a box have its volume together", boolean),
    (
        "unite with a copy",
        "what a copy beside it has in common with the solid is counted once in the volume",
        unite,
    ),
    (
        "round an edge",
        "the first edge that can be rounded takes some of the volume and leaves a solid",
        round,
    ),
    ("unroll", "the flat pattern has the surface's area", unroll),
    ("mesh", "the mesh of the solid has its area, within half of a hundredth", mesh),
    ("area", "the same as in the form of NURBS", area),
    ("volume", "moved away from the origin it is the same", volume),
    ("as NURBS", "the points are the surface's", as_nurbs),
    ("STEP", "the solid that is read has the area and volume that were written", step),
    (".3dm", "the solid that is read has the area and volume that were written", archive),
];

/// Whether two numbers agree, within a fraction.
pub(crate) fn near(a: f64, b: f64, fraction: f64, what: &str) -> Result<(), String> {
    let scale = a.abs().max(b.abs()).max(1.0);
    if (a - b).abs() <= fraction * scale { Ok(()) } else { Err(format!("{what}: {a} and {b}")) }
}

fn area_of(brep: &Brep) -> Result<f64, Fault> {
    Ok(brep.area_properties(1e-9, || true)?.amount)
}

fn volume_of(brep: &Brep) -> Result<f64, Fault> {
    Ok(brep.volume_properties(1e-9, || true)?.amount)
}

/// How far a point is from the surface.
fn distance(surface: &Surface, point: Point3) -> Result<f64, Fault> {
    Ok(surface.closest_point(point)?.distance)
}

fn evaluate(subject: &Subject) -> Outcome {
    let [u, v] = subject.place();
    let (point, normal) = subject.frame();
    let step = 1e-6;
    for (du, dv) in [(step, 0.0), (0.0, step)] {
        let ahead = subject.surface.point_at(u + du, v + dv) - subject.surface.point_at(u - du, v - dv);
        near(ahead.dot(normal) / ahead.length(), 0.0, 1e-6, "normal along the surface")?;
    }
    Ok(near(distance(&subject.surface, point)?, 0.0, 1e-9, "distance of its own point")?)
}

fn closest_point(subject: &Subject) -> Outcome {
    let (point, normal) = subject.frame();
    let beside = point + normal * 0.05;
    let found = subject.surface.closest_point(beside)?;
    near(found.distance, 0.05, 1e-9, "distance")?;
    Ok(near(found.point.distance_to(point), 0.0, 1e-6, "foot")?)
}

fn curvature(subject: &Subject) -> Outcome {
    let [u, v] = subject.place();
    let own = subject.surface.curvature_at(u, v)?;
    near(own.gaussian, own.principal[0] * own.principal[1], 1e-9, "Gaussian curvature")?;
    let form = Surface::from(subject.surface.to_nurbs()?);
    let there = form.closest_point(own.point)?;
    let other = form.curvature_at(there.u, there.v)?;
    Ok(near(own.gaussian, other.gaussian, 1e-6, "Gaussian curvature of the NURBS form")?)
}

fn meet_a_curve(subject: &Subject) -> Outcome {
    let (point, normal) = subject.frame();
    let line = Curve::from(Line::new(point - normal * 0.5, point + normal * 0.5));
    let met = curve_with_surface(&line, &subject.surface, subject.tolerance.absolute)?;
    let nearest = met.crossings.iter().map(|one| one.point.distance_to(point)).fold(f64::INFINITY, f64::min);
    if !met.complete {
        return Err(Fault::Refused("the search did not come to its end".to_owned()));
    }
    Ok(near(nearest, 0.0, 1e-6, "crossing")?)
}

fn meet_a_plane(subject: &Subject) -> Outcome {
    let (point, _) = subject.frame();
    let plane = Plane::from_normal(point, Vector3::new(0.2, 0.5, 1.0))?;
    let section = subject.solid.section(&plane, &subject.tolerance)?;
    if !section.complete || section.curves.is_empty() {
        return Err(Fault::Wrong("no whole section through a point of the surface".to_owned()));
    }
    for place in section.curves.iter().flat_map(samples) {
        near(plane.signed_distance(place), 0.0, 2e-3, "distance from the plane")?;
        near(subject.solid.closest_point(place)?.distance, 0.0, 2e-3, "distance from the solid")?;
    }
    Ok(())
}

fn meet_a_surface(subject: &Subject) -> Outcome {
    let (point, normal) = subject.frame();
    let across = normal.cross(Vector3::new(0.3, 0.7, 0.6));
    let size = Interval::new(-0.6, 0.7);
    let other: Surface = PlaneSurface::new(Plane::from_normal(point, across)?, size, size)?.into();
    let met = surface_with_surface(&subject.surface, &other, &subject.tolerance)?;
    if !met.complete || met.branches.is_empty() {
        return Err(Fault::Wrong("no whole common curve through a common point".to_owned()));
    }
    for place in met.branches.iter().flat_map(|branch| samples(&branch.curve)) {
        near(distance(&subject.surface, place)?, 0.0, 2e-3, "distance from the surface")?;
        near(distance(&other, place)?, 0.0, 2e-3, "distance from the rectangle")?;
    }
    Ok(())
}

fn offset(subject: &Subject) -> Outcome {
    use katydid_geometry::Direction::{U, V};
    let beside = offset_surface(&subject.surface, 0.1, &subject.tolerance)?;
    for (a, b) in [(0.2, 0.3), (0.55, 0.8), (0.71, 0.47)] {
        let place = beside.point_at(beside.domain(U).at(a), beside.domain(V).at(b));
        near(distance(&subject.surface, place)?, 0.1, 2e-3, "distance")?;
    }
    Ok(())
}

fn split(subject: &Subject) -> Outcome {
    let (point, _) = subject.frame();
    let plane = Plane::from_normal(point, Vector3::new(0.2, 0.5, 1.0))?;
    let parts = subject.solid.split_by_plane(&plane, &subject.tolerance, || true)?;
    let mut sum = 0.0;
    for part in parts.iter().flatten() {
        sum += area_of(part)?;
    }
    if parts.iter().any(Vec::is_empty) {
        return Err(Fault::Wrong("one side is empty".to_owned()));
    }
    Ok(near(sum, area_of(&subject.solid)?, 1e-4, "area of the parts")?)
}

fn boolean(subject: &Subject) -> Outcome {
    let (point, normal) = subject.frame();
    let plane = Plane::from_normal(point + normal * 0.1, normal + Vector3::new(0.21, -0.13, 0.17))?;
    let tool = box_brep(&Box3 {
        plane,
        x: Interval::new(-0.5, 0.6),
        y: Interval::new(-0.55, 0.45),
        z: Interval::new(-0.5, 0.4),
    })?;
    let (solids, tools) = ([subject.solid.clone()], [tool]);
    let mut sum = 0.0;
    let outside = Brep::difference(&solids, &tools, &subject.tolerance)?;
    let inside = Brep::intersection(&solids, &tools, &subject.tolerance)?;
    if outside.is_empty() || inside.is_empty() {
        return Err(Fault::Wrong("the box cuts nothing".to_owned()));
    }
    for part in outside.iter().chain(&inside) {
        sum += volume_of(&part.brep)?;
    }
    Ok(near(sum, volume_of(&subject.solid)?, 1e-5, "volume outside and inside")?)
}

fn unite(subject: &Subject) -> Outcome {
    let copy =
        subject.solid.transformed(&katydid_geometry::Xform::translation(Vector3::new(0.41, 0.33, 0.27)))?;
    let (solids, copies) = ([subject.solid.clone()], [copy.clone()]);
    let mut whole = 0.0;
    for part in Brep::union(&[subject.solid.clone(), copy], &subject.tolerance)? {
        whole += volume_of(&part.brep)?;
    }
    for part in Brep::intersection(&solids, &copies, &subject.tolerance)? {
        whole += volume_of(&part.brep)?;
    }
    Ok(near(whole, 2.0 * volume_of(&subject.solid)?, 1e-5, "volume of both")?)
}

fn round(subject: &Subject) -> Outcome {
    let mut refused = "it has no edge".to_owned();
    for edge in 0..subject.solid.edges().len() {
        match subject.solid.filleted(
            &[(edge, 0.1)],
            FilletBlend::Arc,
            FilletRail::RollingBall,
            &subject.tolerance,
        ) {
            Ok(rounded) => {
                let (before, after) = (volume_of(&subject.solid)?, volume_of(&rounded)?);
                if !rounded.is_solid() || after >= before || after < 0.9 * before {
                    return Err(Fault::Wrong(format!("a volume of {before} becomes {after}")));
                }
                return Ok(());
            }
            Err(error) => refused = error.to_string(),
        }
    }
    Err(Fault::Refused(refused))
}

fn unroll(subject: &Subject) -> Outcome {
    let flat = Brep::from_surface(subject.surface.clone())?.unrolled_face(0, &subject.tolerance)?;
    if flat.vertices().iter().any(|corner| corner.point.z.abs() > 1e-9) {
        return Err(Fault::Wrong("the pattern is not flat".to_owned()));
    }
    Ok(near(area_of(&flat)?, subject.surface.area()?.area, 1e-4, "area of the pattern")?)
}

fn mesh(subject: &Subject) -> Outcome {
    let mesh = subject.solid.mesh(&MeshSettings::default())?.to_mesh()?;
    Ok(near(mesh.area(), area_of(&subject.solid)?, 5e-3, "area of the mesh")?)
}

fn area(subject: &Subject) -> Outcome {
    let own = subject.surface.area()?.area;
    let form = Surface::from(subject.surface.to_nurbs()?).area()?.area;
    Ok(near(own, form, 1e-6, "area of the NURBS form")?)
}

fn volume(subject: &Subject) -> Outcome {
    let own = volume_of(&subject.solid)?;
    let away = katydid_geometry::Xform::translation(Vector3::new(20.0, -30.0, 10.0));
    let there = volume_of(&subject.solid.transformed(&away)?)?;
    if own <= 0.0 {
        return Err(Fault::Wrong(format!("a volume of {own}")));
    }
    Ok(near(own, there, 1e-6, "volume elsewhere")?)
}

fn as_nurbs(subject: &Subject) -> Outcome {
    use katydid_geometry::Direction::{U, V};
    let form = Surface::from(subject.surface.to_nurbs()?);
    for (a, b) in [(0.2, 0.3), (0.55, 0.8), (0.71, 0.47)] {
        let place = form.point_at(form.domain(U).at(a), form.domain(V).at(b));
        near(distance(&subject.surface, place)?, 0.0, 1e-9, "distance")?;
    }
    Ok(())
}

fn step(subject: &Subject) -> Outcome {
    let mut document = Document::default();
    document.parts.push(Part::named("solid", Shape::Brep(subject.solid.clone().into())));
    let mut file = Vec::new();
    let left = katydid_step::write(&document, &mut file).map_err(|error| error.to_string())?;
    if !left.is_empty() {
        return Err(Fault::Refused(format!("{left:?}")));
    }
    let back = katydid_step::read(&file).map_err(|error| error.to_string())?;
    match back.parts.as_slice() {
        [Part { shape: Shape::Brep(brep), .. }] => same(&subject.solid, brep),
        parts => Err(Fault::Wrong(format!("{} parts", parts.len()))),
    }
}

fn archive(subject: &Subject) -> Outcome {
    let mut model = Model::default();
    model.objects.push(Object::Brep(Box::new(subject.solid.clone().into())).into());
    let bytes = model.write(70).map_err(|error| error.to_string())?;
    let back = Model::read(&bytes, &Limits::default()).map_err(|error| error.to_string())?;
    match back.objects.first().map(|one| &one.geometry) {
        Some(Object::Brep(object)) => same(&subject.solid, &object.brep),
        _ => Err(Fault::Wrong("no Brep came back".to_owned())),
    }
}

fn same(a: &Brep, b: &Brep) -> Outcome {
    near(area_of(a)?, area_of(b)?, 1e-6, "area")?;
    Ok(near(volume_of(a)?, volume_of(b)?, 1e-6, "volume")?)
}

/// Some points of a curve.
fn samples(curve: &Curve) -> Vec<Point3> {
    (1..8).map(|k| curve.point_at(curve.domain().at(f64::from(k) / 8.0))).collect()
}
