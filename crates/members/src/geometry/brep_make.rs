//! Breps made from curves and points: flat ones, patches, offsets.

use katydid_geometry::construct::{PatchOptions, edge_surface, four_point_surface, offset_brep, patch};
use katydid_geometry::{Brep, Curve, Point3, Surface, Tolerance};

use super::answer::Outcome;
use super::argument::{Count, Positive, Some1, Within};
use super::brep_face::Face;
use super::table::Endpoints;
use crate::Fault;
use crate::wire::GeometryBase;

pub(super) fn enter(table: &mut Endpoints) {
    let default = Within(Tolerance::default().absolute);
    table.add("brep/createplanarbreps-curvearray", move |c: Some1<Curve>| planar(&c.0, default));
    table.add("brep/createplanarbreps-curvearray_double", |c: Some1<Curve>, t: Within| planar(&c.0, t));
    table.add("brep/createplanarbreps-curve", move |c: Curve| planar(&[c], default));
    table.add("brep/createplanarbreps-curve_double", |c: Curve, t: Within| planar(&[c], t));
    table.add("brep/createplanarbreps-rhino.collections.curvelist", move |c: Some1<Curve>| {
        planar(&c.0, default)
    });
    table.add("brep/createplanarbreps-rhino.collections.curvelist_double", |c: Some1<Curve>, t: Within| {
        planar(&c.0, t)
    });
    table.add(
        "brep/createfromcornerpoints-point3d_point3d_point3d_double",
        |a: Point3, b: Point3, c: Point3, _: Within| Ok(four_point_surface(a, b, c, None)?),
    );
    table.add(
        "brep/createfromcornerpoints-point3d_point3d_point3d_point3d_double",
        |a: Point3, b: Point3, c: Point3, d: Point3, _: Within| Ok(four_point_surface(a, b, c, Some(d))?),
    );
    table.add("brep/createedgesurface-curvearray", |c: Some1<Curve>| {
        Ok(edge_surface(&c.0, &Tolerance::default())?)
    });
    table.add(
        "brep/createpatch-geometrybasearray_int_int_double",
        |parts: Some1<GeometryBase>, u: Spans, v: Spans, t: Within| {
            let (curves, points) = curves_and_points(parts.0)?;
            let options = PatchOptions { spans: [u.0, v.0], ..PatchOptions::default() };
            Ok(patch(&curves, &points, &options, &t.tolerance())?)
        },
    );
    table.add(
        "brep/createpatch-geometrybasearray_surface_int_int_bool_bool_double_double_double_boolarray_double",
        |parts: Some1<GeometryBase>,
         start: Option<Surface>,
         u: Spans,
         v: Spans,
         trimmed: bool,
         _tangency: bool,
         _spacing: f64,
         flexibility: Positive,
         _pull: f64,
         _fixed: Option<Vec<bool>>,
         t: Within| {
            if start.is_some() {
                return Err(Fault::not_supported("patches that begin from a surface"));
            }
            // Curves and points have no tangents to follow, and without a surface nothing pulls.
            let (curves, points) = curves_and_points(parts.0)?;
            let options = PatchOptions { spans: [u.0, v.0], flexibility: flexibility.0, trimmed };
            Ok(patch(&curves, &points, &options, &t.tolerance())?)
        },
    );
    table.add(
        "brep/createoffsetbrep-brep_double_bool_bool_double_breparray_breparray",
        |b: Brep, d: f64, solid: bool, _: bool, t: Within| {
            if solid {
                return Err(Fault::not_supported("offsets closed to solids"));
            }
            let breps = offset_brep(&b, d, true, &t.tolerance())?;
            Ok((breps, Vec::<Brep>::new(), Vec::<Brep>::new()))
        },
    );
    table.add(
        "brep/createfromoffsetface-brepface_double_double_bool_bool",
        |f: Face, d: f64, t: Within, both: bool, solid: bool| {
            if both || solid {
                return Err(Fault::not_supported("offsets to both sides and closed to solids"));
            }
            Ok(offset_brep(&f.brep(), d, true, &t.tolerance())?.into_iter().next())
        },
    );
}

type Spans = Count<1, 100>;

/// The regions that closed planar curves bound; `None` when there are none.
fn planar(curves: &[Curve], tolerance: Within) -> Outcome<Option<Vec<Brep>>> {
    let breps = Brep::planar_breps(curves, &tolerance.tolerance())?.breps;
    Ok((!breps.is_empty()).then_some(breps))
}

/// What a patch is drawn through.
fn curves_and_points(parts: Vec<GeometryBase>) -> Outcome<(Vec<Curve>, Vec<Point3>)> {
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    for (i, part) in parts.into_iter().enumerate() {
        match part {
            GeometryBase::Curve(curve) => curves.push(curve),
            GeometryBase::Point(point) => points.push(point),
            GeometryBase::Mesh(mesh) => points.extend(mesh.vertices()),
            GeometryBase::Other(object) => match *object {
                katydid_3dm::Object::PointCloud(cloud) => points.extend(cloud.points.iter().copied()),
                _ => return Err(Fault::bad_request(format!("geometry {i} is no curve, point or mesh"))),
            },
            _ => return Err(Fault::bad_request(format!("geometry {i} is no curve, point or mesh"))),
        }
    }
    Ok((curves, points))
}
