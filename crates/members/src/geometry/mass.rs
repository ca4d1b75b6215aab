//! Areas and volumes with their centroids and moments.

use katydid_geometry::{Brep, Curve, MassProperties, Mesh, Plane, Surface, Tolerance, Vector3, Xform};
use serde_json::{Map, Value as Json};

use super::answer::{Answer, Outcome};
use super::argument::{Some1, Waiting, Within};
use super::table::Endpoints;
use crate::wire::{GeometryBase, Members, Read};
use crate::{Fault, Record, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("areamassproperties/compute-curve", |c: Curve| Ok(Area(c.area_properties(0.001)?)));
    table.add("areamassproperties/compute-curve_double", |c: Curve, t: Within| {
        Ok(Area(c.area_properties(t.0)?))
    });
    table.add("areamassproperties/compute-mesh", |m: Mesh| Ok(Area(m.area_properties()?)));
    table.add(
        "areamassproperties/compute-mesh_bool_bool_bool_bool",
        |m: Mesh, _: Flag, _: Flag, _: Flag, _: Flag| Ok(Area(m.area_properties()?)),
    );
    table.add("areamassproperties/compute-brep", |b: Brep, w: Waiting| area_of_brep(&b, &w).map(Area));
    table.add(
        "areamassproperties/compute-brep_bool_bool_bool_bool",
        |b: Brep, _: Flag, _: Flag, _: Flag, _: Flag, w: Waiting| area_of_brep(&b, &w).map(Area),
    );
    table.add("areamassproperties/compute-surface", |s: Surface| area_of_surface(&s).map(Area));
    table.add(
        "areamassproperties/compute-surface_bool_bool_bool_bool",
        |s: Surface, _: Flag, _: Flag, _: Flag, _: Flag| area_of_surface(&s).map(Area),
    );
    table.add("areamassproperties/compute-geometrybasearray", |g: Some1<GeometryBase>, w: Waiting| {
        together(&g.0, &w, area).map(Area)
    });
    table.add(
        "areamassproperties/compute-geometrybasearray_bool_bool_bool_bool",
        |g: Some1<GeometryBase>, _: Flag, _: Flag, _: Flag, _: Flag, w: Waiting| {
            together(&g.0, &w, area).map(Area)
        },
    );
    table.add("volumemassproperties/compute-mesh", |m: Mesh| Ok(Volume(m.volume_properties()?)));
    table.add(
        "volumemassproperties/compute-mesh_bool_bool_bool_bool",
        |m: Mesh, _: Flag, _: Flag, _: Flag, _: Flag| Ok(Volume(m.volume_properties()?)),
    );
    table.add("volumemassproperties/compute-brep", |b: Brep, w: Waiting| volume_of_brep(&b, &w).map(Volume));
    table.add(
        "volumemassproperties/compute-brep_bool_bool_bool_bool",
        |b: Brep, _: Flag, _: Flag, _: Flag, _: Flag, w: Waiting| volume_of_brep(&b, &w).map(Volume),
    );
    table.add("volumemassproperties/compute-surface", |s: Surface, w: Waiting| {
        volume_of_brep(&Brep::from_surface(s)?, &w).map(Volume)
    });
    table.add(
        "volumemassproperties/compute-surface_bool_bool_bool_bool",
        |s: Surface, _: Flag, _: Flag, _: Flag, _: Flag, w: Waiting| {
            volume_of_brep(&Brep::from_surface(s)?, &w).map(Volume)
        },
    );
    table.add("volumemassproperties/compute-geometrybasearray", |g: Some1<GeometryBase>, w: Waiting| {
        together(&g.0, &w, volume).map(Volume)
    });
    table.add(
        "volumemassproperties/compute-geometrybasearray_bool_bool_bool_bool",
        |g: Some1<GeometryBase>, _: Flag, _: Flag, _: Flag, _: Flag, w: Waiting| {
            together(&g.0, &w, volume).map(Volume)
        },
    );
    table.add("brep/getarea-brep", |b: Brep, w: Waiting| Ok(area_of_brep(&b, &w)?.amount));
    table.add("brep/getarea-brep_double_double", |b: Brep, _: Share, _: Share, w: Waiting| {
        Ok(area_of_brep(&b, &w)?.amount)
    });
    table.add("brep/getvolume-brep", |b: Brep, w: Waiting| Ok(volume_of_brep(&b, &w)?.amount));
    table.add("brep/getvolume-brep_double_double", |b: Brep, _: Share, _: Share, w: Waiting| {
        Ok(volume_of_brep(&b, &w)?.amount)
    });
    table.add("areamassproperties/compute-hatch", |h: Hatched, w: Waiting| hatched(&h, &w).map(Area));
    table.add(
        "volumemassproperties/sum-volumemassproperties_volumemassproperties",
        |own: Volume, other: Volume| Ok((true, Volume(MassProperties::together(&[own.0, other.0])?))),
    );
    table.add("mesh/volume-mesh", |m: Mesh| Ok(m.volume()));
}

/// Which moments are wanted: all of them are given.
type Flag = Option<bool>;

/// A tolerance that results keep within anyway: not below 0.
struct Share;

impl Read for Share {
    fn read(json: &Json) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if x >= 0.0 { Ok(Self) } else { Err(Fault::bad_request(format!("is {x}, below 0"))) }
    }

    fn type_name() -> String {
        "Double".into()
    }
}

/// The fraction to which integrals over faces are exact.
const FRACTION: f64 = 1e-9;

fn stopped(waiting: &Waiting, error: katydid_geometry::Error) -> Fault {
    if waiting.go_on() { error.into() } else { Fault::new(crate::Cause::Cancelled, "it was cancelled") }
}

fn area_of_brep(brep: &Brep, waiting: &Waiting) -> Outcome<MassProperties> {
    brep.area_properties(FRACTION, || waiting.go_on()).map_err(|error| stopped(waiting, error))
}

fn volume_of_brep(brep: &Brep, waiting: &Waiting) -> Outcome<MassProperties> {
    brep.volume_properties(FRACTION, || waiting.go_on()).map_err(|error| stopped(waiting, error))
}

fn area_of_surface(surface: &Surface) -> Outcome<MassProperties> {
    let found = surface.area_within(FRACTION)?;
    let (amount, centroid, second_moments) = (found.area, found.centroid, found.second_moments);
    Ok(MassProperties { amount, centroid, second_moments, error: FRACTION * amount })
}

fn area(geometry: &GeometryBase, waiting: &Waiting) -> Option<Outcome<MassProperties>> {
    Some(match geometry {
        GeometryBase::Curve(curve) => curve.area_properties(0.001).map_err(Fault::from),
        GeometryBase::Surface(surface) => area_of_surface(surface),
        GeometryBase::Brep(brep) => area_of_brep(brep, waiting),
        GeometryBase::Mesh(mesh) => mesh.area_properties().map_err(Fault::from),
        _ => return None,
    })
}

fn volume(geometry: &GeometryBase, waiting: &Waiting) -> Option<Outcome<MassProperties>> {
    Some(match geometry {
        GeometryBase::Surface(surface) => Brep::from_surface(surface.clone())
            .map_err(Fault::from)
            .and_then(|brep| volume_of_brep(&brep, waiting)),
        GeometryBase::Brep(brep) => volume_of_brep(brep, waiting),
        GeometryBase::Mesh(mesh) => mesh.volume_properties().map_err(Fault::from),
        _ => return None,
    })
}

type Measure = fn(&GeometryBase, &Waiting) -> Option<Outcome<MassProperties>>;

/// Several shapes as one body.
fn together(shapes: &[GeometryBase], waiting: &Waiting, measure: Measure) -> Outcome<MassProperties> {
    let mut parts = Vec::with_capacity(shapes.len());
    for (i, shape) in shapes.iter().enumerate() {
        let part = measure(shape, waiting);
        parts.push(part.ok_or_else(|| Fault::bad_request(format!("geometry {i} cannot be measured so")))??);
    }
    Ok(MassProperties::together(&parts)?)
}

/// A hatch, by the curves that bound it.
struct Hatched(Vec<Curve>);

impl Read for Hatched {
    fn read(json: &Json) -> Result<Self, Fault> {
        let GeometryBase::Other(object) = GeometryBase::read(json)? else {
            return Err(Fault::bad_request("is no hatch"));
        };
        let katydid_3dm::Object::Hatch(hatch) = *object else {
            return Err(Fault::bad_request("is no hatch"));
        };
        let frame = Xform::plane_to_plane(&Plane::XY, &hatch.plane.frame);
        let curve = |own: &katydid_3dm::HatchLoop| own.curve.to_curve()?.transformed(&frame);
        Ok(Self(hatch.loops.iter().map(curve).collect::<Result<Vec<_>, _>>()?))
    }

    fn type_name() -> String {
        "Hatch".into()
    }
}

/// The regions that the curves of a hatch bound; none where they bound nothing.
fn hatched(hatch: &Hatched, waiting: &Waiting) -> Outcome<MassProperties> {
    let regions = Brep::planar_faces(&hatch.0, &Tolerance::default())?.breps;
    let parts = regions.iter().map(|region| area_of_brep(region, waiting)).collect::<Outcome<Vec<_>>>()?;
    Ok(MassProperties::together(&parts)?)
}

struct Area(MassProperties);

struct Volume(MassProperties);

impl Answer for Area {
    fn name() -> String {
        "Rhino.Geometry.AreaMassProperties".into()
    }

    fn json(self) -> Result<Json, Fault> {
        properties("Area", &self.0)
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(Record::value("AreaMassProperties", measured("Area", "AreaError", &self.0)))
    }
}

impl Read for Volume {
    /// As [`properties`] writes it.
    fn read(json: &Json) -> Result<Self, Fault> {
        let members = Members::of(json)?;
        let triple = |name: &str| members.read::<Vector3>(name);
        let second = triple("CentroidCoordinatesSecondMoments")?;
        let product = triple("CentroidCoordinatesProductMoments")?;
        Ok(Self(MassProperties {
            amount: members.read("Volume")?,
            centroid: members.read("Centroid")?,
            second_moments: [second.x, second.y, second.z, product.x, product.y, product.z],
            error: members.read_or("VolumeError", 0.0)?,
        }))
    }

    fn type_name() -> String {
        "VolumeMassProperties".into()
    }
}

impl Answer for Volume {
    fn name() -> String {
        "Rhino.Geometry.VolumeMassProperties".into()
    }

    fn json(self) -> Result<Json, Fault> {
        properties("Volume", &self.0)
    }

    fn value(self) -> Result<Value, Fault> {
        Ok(Record::value("VolumeMassProperties", measured("Volume", "VolumeError", &self.0)))
    }
}

/// A result of each class, for what it has.
pub(super) fn samples() -> [Record; 2] {
    let nothing = MassProperties {
        amount: 0.0,
        centroid: katydid_geometry::Point3::ORIGIN,
        second_moments: [0.0; 6],
        error: 0.0,
    };
    [
        Record { class: "AreaMassProperties", fields: measured("Area", "AreaError", &nothing) },
        Record { class: "VolumeMassProperties", fields: measured("Volume", "VolumeError", &nothing) },
    ]
}

/// The properties of RhinoCommon's classes.
fn measured(amount: &'static str, error: &'static str, found: &MassProperties) -> Vec<(&'static str, Value)> {
    let origin = katydid_geometry::Point3::ORIGIN;
    let [xx, yy, zz, xy, yz, zx] = found.second_moments_about(origin);
    let [cxx, cyy, czz, cxy, cyz, czx] = found.second_moments;
    let vector = |x, y, z| Value::Vector(Vector3::new(x, y, z));
    vec![
        (amount, Value::Number(found.amount)),
        (error, Value::Number(found.error)),
        ("Centroid", Value::Point(found.centroid)),
        ("WorldCoordinatesFirstMoments", Value::Vector(found.first_moments_about(origin))),
        ("WorldCoordinatesSecondMoments", vector(xx, yy, zz)),
        ("WorldCoordinatesProductMoments", vector(xy, yz, zx)),
        ("WorldCoordinatesMomentsOfInertia", Value::Vector(found.inertia_about(origin))),
        ("WorldCoordinatesRadiiOfGyration", Value::Vector(found.gyration_about(origin))),
        ("CentroidCoordinatesSecondMoments", vector(cxx, cyy, czz)),
        ("CentroidCoordinatesProductMoments", vector(cxy, cyz, czx)),
        ("CentroidCoordinatesMomentsOfInertia", Value::Vector(found.inertia_about(found.centroid))),
        ("CentroidCoordinatesRadiiOfGyration", Value::Vector(found.gyration_about(found.centroid))),
    ]
}

/// The same as JSON.
fn properties(amount: &'static str, found: &MassProperties) -> Result<Json, Fault> {
    let error = if amount == "Area" { "AreaError" } else { "VolumeError" };
    let members = measured(amount, error, found).into_iter();
    members
        .map(|(name, value)| value.to_json(0).map(|json| (name.to_owned(), json)))
        .collect::<Result<Map<_, _>, _>>()
        .map(Json::Object)
}
