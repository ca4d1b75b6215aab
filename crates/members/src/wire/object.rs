//! The form of objects: `{"version", "archive3dm", "opennurbs", "data"}`.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_3dm::{AnnotationKind, Limits, ModelObject, Object, RawObject};
use katydid_data::Value;
use katydid_geometry::{Curve, Surface};
use serde_json::{Value as Json, json};

use super::read::{Members, unwrapped};
use crate::Fault;

/// The version of the form itself, which has never changed.
const FORM: i32 = 10_000;
/// The openNURBS version that is assumed where a form does not say: that of the newest archives.
const NEWEST_OPENNURBS: i64 = -1_869_833_980;
/// The archive version that is assumed where a form does not say.
pub(super) const NEWEST_ARCHIVE: i32 = 80;

/// What a request may make of its bytes.
fn limits() -> Limits {
    Limits { inflated: 1 << 30, warnings: 16, ..Limits::default() }
}

/// Whether JSON looks like the form of an object.
pub(super) fn is_object_form(json: &Json) -> bool {
    Members::of(json).is_ok_and(|members| members.get("data").is_some())
}

/// The bytes and versions of an object's form.
fn raw(json: &Json) -> Result<RawObject, Fault> {
    let members = Members::of(json)?;
    if members.get("url").is_some() && members.get("data").is_none() {
        return Err(Fault::refused("names an address; contents are not fetched"));
    }
    let data: String = members.read("data")?;
    let archive = members.read_or("archive3dm", NEWEST_ARCHIVE)?;
    let opennurbs = match members.get("opennurbs") {
        // Some writers have the number unsigned: its 32 bits are meant.
        Some(json) => match json.as_i64().or_else(|| json.as_str().and_then(|text| text.trim().parse().ok()))
        {
            Some(bits) if (i64::from(i32::MIN)..1 << 32).contains(&bits) => bits,
            _ => return Err(Fault::bad_request("its opennurbs is not a whole number of 32 bits")),
        },
        None => NEWEST_OPENNURBS,
    };
    let compact: String = data.chars().filter(|c| !c.is_ascii_whitespace()).collect();
    let bytes = STANDARD
        .decode(compact.as_bytes())
        .map_err(|error| Fault::bad_request(format!("its data is not base64: {error}")))?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "its 32 bits are meant")]
    let opennurbs = opennurbs as u32;
    let (raw, _) = RawObject::read(archive, opennurbs, &bytes, &limits()).map_err(broken)?;
    Ok(raw)
}

fn broken(error: katydid_3dm::Error) -> Fault {
    Fault::bad_request(format!("is no object of Rhino's: {error}"))
}

/// The object of a form, taken apart.
pub(super) fn parsed(json: &Json) -> Result<Object, Fault> {
    raw(&unwrapped(json))?.parse(&limits()).map_err(broken)
}

/// The object of a form as a value that components take.
///
/// # Errors
/// It is not the form of an object, or its bytes are broken; in words that follow the name of an input.
pub fn decode_object(json: &Json) -> Result<Value, Fault> {
    let raw = raw(&unwrapped(json))?;
    let object = raw.parse(&limits()).map_err(broken)?;
    Ok(match object {
        object @ (Object::Brep(_) | Object::Extrusion(_)) => match object.surface() {
            Some(surface) => Value::from(surface.into_owned()),
            None => Value::from(raw),
        },
        object => match Value::from_object(object, &raw.user_data) {
            // What is not computed with stays as it came, user data and all.
            Some(Value::Kept(_)) | None => Value::from(raw),
            Some(value) => value,
        },
    })
}

/// The form of an object for an archive version: 4, 50, 60, 70 or 80.
///
/// # Errors
/// The version cannot carry the object.
pub fn encode_object(object: &ModelObject, archive: i32) -> Result<Json, Fault> {
    let form = object.to_on_data(archive).map_err(|error| Fault::failed(error.to_string()))?;
    Ok(json!({
        "version": FORM,
        "archive3dm": form.archive3dm,
        "opennurbs": form.opennurbs,
        "data": STANDARD.encode(&form.data),
    }))
}

/// A kept object taken apart where that can be done, so that it can be written for any version.
pub(super) fn restated(raw: &RawObject) -> ModelObject {
    match raw.parse(&limits()) {
        Ok(object) if !matches!(object, Object::Kept(_)) => {
            ModelObject { user_data: raw.user_data.clone(), ..object.into() }
        }
        _ => Object::Kept(raw.clone()).into(),
    }
}

/// The name of the .NET type of an object.
pub(crate) fn type_name(object: &Object) -> &'static str {
    match object {
        Object::Point(_) => "Rhino.Geometry.Point",
        Object::PointCloud(_) => "Rhino.Geometry.PointCloud",
        Object::Curve(curve) => curve_type(curve),
        Object::CurveForm(form) => form.to_curve().map_or("Rhino.Geometry.Curve", |curve| curve_type(&curve)),
        Object::Surface(surface) => surface_type(surface),
        Object::SurfaceForm(form) => {
            form.to_surface().map_or("Rhino.Geometry.Surface", |surface| surface_type(&surface))
        }
        Object::Brep(_) => "Rhino.Geometry.Brep",
        Object::Extrusion(_) => "Rhino.Geometry.Extrusion",
        Object::Mesh(_) => "Rhino.Geometry.Mesh",
        Object::SubD(_) => "Rhino.Geometry.SubD",
        Object::TextDot(_) => "Rhino.Geometry.TextDot",
        Object::BlockReference(_) => "Rhino.Geometry.InstanceReferenceGeometry",
        Object::Light(_) => "Rhino.Geometry.Light",
        Object::ClippingPlane(_) => "Rhino.Geometry.ClippingPlaneSurface",
        Object::Hatch(_) => "Rhino.Geometry.Hatch",
        Object::DetailView(_) => "Rhino.Geometry.DetailView",
        Object::MorphControl(_) => "Rhino.Geometry.MorphControl",
        Object::Annotation(annotation) => match annotation.kind {
            AnnotationKind::Text => "Rhino.Geometry.TextEntity",
            AnnotationKind::Leader { .. } => "Rhino.Geometry.Leader",
            AnnotationKind::Linear { .. } => "Rhino.Geometry.LinearDimension",
            AnnotationKind::Angular { .. } => "Rhino.Geometry.AngularDimension",
            AnnotationKind::Radial { .. } => "Rhino.Geometry.RadialDimension",
            AnnotationKind::Ordinate { .. } => "Rhino.Geometry.OrdinateDimension",
            AnnotationKind::CentreMark { .. } => "Rhino.Geometry.Centermark",
        },
        Object::Annotation5(_) | Object::Annotation2(_) => "Rhino.Geometry.AnnotationBase",
        _ => "Rhino.Geometry.GeometryBase",
    }
}

pub(crate) fn curve_type(curve: &Curve) -> &'static str {
    match curve {
        Curve::Line(_) => "Rhino.Geometry.LineCurve",
        Curve::Arc(_) => "Rhino.Geometry.ArcCurve",
        Curve::Polyline(_) => "Rhino.Geometry.PolylineCurve",
        Curve::Nurbs(_) => "Rhino.Geometry.NurbsCurve",
        Curve::Poly(_) => "Rhino.Geometry.PolyCurve",
    }
}

pub(crate) fn surface_type(surface: &Surface) -> &'static str {
    match surface {
        Surface::Plane(_) => "Rhino.Geometry.PlaneSurface",
        Surface::Sum(_) => "Rhino.Geometry.SumSurface",
        Surface::Revolution(_) => "Rhino.Geometry.RevSurface",
        Surface::Nurbs(_) => "Rhino.Geometry.NurbsSurface",
    }
}
