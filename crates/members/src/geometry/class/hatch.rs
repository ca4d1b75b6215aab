//! Hatches: closed planar curves, filled with a pattern.

use std::sync::Arc;

use katydid_3dm::{CurveForm, Hatch, HatchLoop, Object, StoredPlane};
use katydid_geometry::brep::LoopKind;
use katydid_geometry::{Brep, Curve, Plane, Point2, Point3, Tolerance, Xform, join_curves};

use super::marks::read_object;
use super::of_class;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::{Count, Within};
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape};
use crate::wire::Read;
use crate::{Fault, Value};

type Index = Count<0, 10_000_000>;
type Pattern = Count<0, 1_000_000>;

pub(super) fn enter(table: &mut Endpoints) {
    makers(table);
    properties(table);
    table.member("Hatch.Get3dCurves this outer", |Own(hatch): Own, outer: bool| {
        let frame = Xform::plane_to_plane(&Plane::XY, &hatch.plane.frame);
        let curves = flat_curves(&hatch, outer)?;
        Ok(curves.iter().map(|curve| curve.transformed(&frame)).collect::<Result<Vec<Curve>, _>>()?)
    });
    table.member("Hatch.Get2dCurves this outer", |Own(hatch): Own, outer: bool| flat_curves(&hatch, outer));
    table.member("Hatch.ToBrep this", |Own(hatch): Own| {
        let frame = Xform::plane_to_plane(&Plane::XY, &hatch.plane.frame);
        let all = hatch.loops.iter().map(|own| own.curve.to_curve()?.transformed(&frame));
        let curves: Vec<Curve> = all.collect::<Result<_, _>>()?;
        let found = Brep::planar_faces(&curves, &Tolerance::default())?;
        found.breps.into_iter().next().ok_or_else(|| Fault::failed("the hatch bounds no region"))
    });
}

fn makers(table: &mut Endpoints) {
    table.member(
        "Hatch.Create curves hatchPatternIndex rotationRadians scale tolerance",
        |curves: Vec<Curve>, pattern: Pattern, rotation: f64, scale: f64, t: Within| {
            Filling::new(pattern, rotation, scale)?.inside(&curves, t)
        },
    );
    table.member(
        "Hatch.Create curve hatchPatternIndex rotationRadians scale tolerance",
        |curve: Curve, pattern: Pattern, rotation: f64, scale: f64, t: Within| {
            Filling::new(pattern, rotation, scale)?.inside(&[curve], t)
        },
    );
    // The forms without a tolerance are older; they take that of the document.
    table.member(
        "Hatch.Create curves hatchPatternIndex rotationRadians scale",
        |curves: Vec<Curve>, pattern: Pattern, rotation: f64, scale: f64| {
            Filling::new(pattern, rotation, scale)?.inside(&curves, Within(Tolerance::default().absolute))
        },
    );
    table.member(
        "Hatch.Create curve hatchPatternIndex rotationRadians scale",
        |curve: Curve, pattern: Pattern, rotation: f64, scale: f64| {
            Filling::new(pattern, rotation, scale)?.inside(&[curve], Within(Tolerance::default().absolute))
        },
    );
    table.member(
        "Hatch.Create hatchPlane outerLoop innerLoops hatchPatternIndex rotationRadians scale",
        |plane: Plane, outer: Curve, inner: Vec<Curve>, pattern: Pattern, rotation: f64, scale: f64| {
            Filling::new(pattern, rotation, scale)?.of_loops(&plane, &outer, &inner)
        },
    );
    table.member(
        "Hatch.CreateFromBrep brep brepFaceIndex hatchPatternIndex rotationRadians scale basePoint",
        |brep: Brep, face: Index, pattern: Pattern, rotation: f64, scale: f64, base: Point3| {
            if face.0 >= brep.faces().len() {
                return Err(super::beyond(face.0, brep.faces().len()));
            }
            let part = brep.sub_brep(&[face.0])?;
            let t = Within(Tolerance::default().absolute);
            let Made(Shape::Other(made)) = Filling::new(pattern, rotation, scale)?.of_face(&part, t)? else {
                return Err(Fault::failed("the face makes no hatch"));
            };
            let Object::Hatch(mut hatch) = Arc::unwrap_or_clone(made) else {
                return Err(Fault::failed("the face makes no hatch"));
            };
            hatch.base_point = flat_point(&hatch, base);
            Ok(shape(*hatch))
        },
    );
}

fn properties(table: &mut Endpoints) {
    table.member("Hatch.get_PatternIndex this", |Own(hatch): Own| Ok(hatch.pattern));
    table.member("Hatch.set_PatternIndex &this value", |Own(hatch): Own, index: Pattern| {
        Ok(((), shape(Hatch { pattern: number(index)?, ..hatch })))
    });
    table.member("Hatch.get_PatternRotation this", |Own(hatch): Own| Ok(hatch.rotation));
    table.member("Hatch.set_PatternRotation &this value", |Own(hatch): Own, rotation: f64| {
        Ok(((), shape(Hatch { rotation, ..hatch })))
    });
    table.member("Hatch.get_PatternScale this", |Own(hatch): Own| Ok(hatch.scale));
    table.member("Hatch.set_PatternScale &this value", |Own(hatch): Own, scale: f64| {
        Ok(((), shape(Hatch { scale: sound_scale(scale)?, ..hatch })))
    });
    table.member("Hatch.get_Plane this", |Own(hatch): Own| Ok(hatch.plane.frame));
    table.member("Hatch.set_Plane &this value", |Own(hatch): Own, plane: Plane| {
        Ok(((), shape(Hatch { plane: StoredPlane::from(plane), ..hatch })))
    });
    table.member("Hatch.get_BasePoint this", |Own(hatch): Own| {
        let base = hatch.base_point;
        Ok(hatch.plane.frame.at(base.x, base.y, 0.0))
    });
    table.member("Hatch.set_BasePoint &this value", |Own(hatch): Own, at: Point3| {
        let base_point = flat_point(&hatch, at);
        Ok(((), shape(Hatch { base_point, ..hatch })))
    });
}

/// A point in coordinates of the hatch's plane.
fn flat_point(hatch: &Hatch, point: Point3) -> Point2 {
    let [x, y, _] = hatch.plane.frame.coordinates(point);
    Point2::new(x, y)
}

/// The boundaries of one kind, in coordinates of the plane.
fn flat_curves(hatch: &Hatch, outer: bool) -> Outcome<Vec<Curve>> {
    let own = hatch.loops.iter().filter(|own| own.outer == outer);
    Ok(own.map(|own| own.curve.to_curve()).collect::<Result<_, _>>()?)
}

fn shape(hatch: Hatch) -> Made {
    Made(Shape::Other(Arc::new(Object::Hatch(Box::new(hatch)))))
}

fn number(index: Pattern) -> Outcome<i32> {
    i32::try_from(index.0).map_err(|_| Fault::bad_request("is no index of a pattern"))
}

fn sound_scale(scale: f64) -> Outcome<f64> {
    if scale.is_finite() && scale > 0.0 {
        return Ok(scale);
    }
    Err(Fault::bad_request(format!("scale is {scale}, which must be greater than 0")))
}

of_class! {
    /// A hatch that is handed back.
    Made, "Hatch";
}

/// What a hatch is filled with.
struct Filling {
    pattern: i32,
    rotation: f64,
    scale: f64,
}

impl Filling {
    fn new(pattern: Pattern, rotation: f64, scale: f64) -> Outcome<Self> {
        if !rotation.is_finite() {
            return Err(Fault::bad_request("rotationRadians is no number"));
        }
        Ok(Self { pattern: number(pattern)?, rotation, scale: sound_scale(scale)? })
    }

    /// A hatch for each region that the curves bound, curves inside others being its holes. Curves that bound nothing
    /// make none.
    fn inside(&self, curves: &[Curve], t: Within) -> Outcome<Vec<Made>> {
        let found = Brep::planar_breps(curves, &t.tolerance())?;
        found.breps.iter().map(|region| self.of_face(region, t)).collect()
    }

    /// The hatch of a planar Brep of one face.
    fn of_face(&self, face: &Brep, t: Within) -> Outcome<Made> {
        let surface = face.face_surface(0);
        let plane = surface.and_then(|surface| surface.plane(t.0));
        let plane = plane.ok_or_else(|| Fault::bad_request("the face is not planar"))?;
        let (mut outer, mut inner) = (None, Vec::new());
        for (place, own) in face.loops().iter().enumerate() {
            let joined = join_curves(&face.loop_curves(place)?, t.0, false);
            let Some(curve) = joined.into_iter().next() else { continue };
            if own.kind == LoopKind::Outer {
                outer = Some(curve);
            } else {
                inner.push(curve);
            }
        }
        let outer = outer.ok_or_else(|| Fault::failed("the face has no outer boundary"))?;
        self.of_loops(&plane, &outer, &inner)
    }

    /// The hatch of boundaries that lie in a plane.
    fn of_loops(&self, plane: &Plane, outer: &Curve, inner: &[Curve]) -> Outcome<Made> {
        let flat = Xform::plane_to_plane(plane, &Plane::XY);
        let one = |curve: &Curve, outer: bool| {
            if !curve.is_closed() {
                return Err(Fault::bad_request("a boundary of a hatch is not closed"));
            }
            Ok(HatchLoop { outer, curve: CurveForm::of(&curve.transformed(&flat)?, 2) })
        };
        let mut loops = vec![one(outer, true)?];
        for curve in inner {
            loops.push(one(curve, false)?);
        }
        Ok(shape(Hatch {
            plane: StoredPlane::from(*plane),
            scale: self.scale,
            rotation: self.rotation,
            pattern: self.pattern,
            loops,
            base_point: Point2::ORIGIN,
        }))
    }
}

/// A hatch.
struct Own(Hatch);

read_object!(Own, Hatch, "Hatch", Hatch::clone);
