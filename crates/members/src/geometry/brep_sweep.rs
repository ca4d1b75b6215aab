//! Breps made by moving sections: lofts, sweeps and pipes.

use katydid_geometry::construct::{
    DevelopableOptions, LoftOptions, Miter, SweepFrame, SweepOptions, developable_loft, loft, pipe,
    pipe_variable, sweep_one, sweep_two,
};
use katydid_geometry::{Brep, Curve, Point2, Point3, Tolerance, Vector3};

use super::answer::Outcome;
use super::argument::{Count, Positive, Some1, Turn, Within};
use super::choice::{Cap, Loft, Roadlike, SweepMiter};
use super::table::Endpoints;
use crate::Fault;
use crate::wire::Read;

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "brep/createfromloft-curvearray_point3d_point3d_lofttype_bool",
        |c: Sections, start: Tip, end: Tip, style: Loft, closed: bool| {
            lofted(&c.0, LoftOptions { style: style.0, closed, ..between(start, end) })
        },
    );
    table.add(
        "brep/createfromloft-curvearray_point3d_point3d_bool_bool_breptrim_breptrim_lofttype_bool",
        |c: Sections,
         start: Tip,
         end: Tip,
         from: bool,
         to: bool,
         _: Unread,
         _: Unread,
         style: Loft,
         closed: bool| {
            if from || to {
                return Err(Fault::not_supported("lofts tangent to other surfaces"));
            }
            lofted(&c.0, LoftOptions { style: style.0, closed, ..between(start, end) })
        },
    );
    table.add(
        "brep/createfromloftrebuild-curvearray_point3d_point3d_lofttype_bool_int",
        |c: Sections, start: Tip, end: Tip, style: Loft, closed: bool, n: Count<4, 10_000>| {
            let rebuild = Some(n.0);
            lofted(&c.0, LoftOptions { style: style.0, closed, rebuild, ..between(start, end) })
        },
    );
    table.add(
        "brep/createfromloftrefit-curvearray_point3d_point3d_lofttype_bool_double",
        |c: Sections, start: Tip, end: Tip, style: Loft, closed: bool, t: Within| {
            let refit = Some(t.0);
            lofted(&c.0, LoftOptions { style: style.0, closed, refit, ..between(start, end) })
        },
    );
    table.add(
        "brep/createdevelopableloft-curve_curve_bool_bool_int",
        |first: Curve, second: Curve, turn_first: bool, turn_second: bool, density: Count<0, 10_000>| {
            let [first, second] = [(first, turn_first), (second, turn_second)]
                .map(|(rail, turn)| if turn { rail.reversed() } else { rail });
            let options = DevelopableOptions { density: density.0, ..DevelopableOptions::default() };
            unrollable(&first, &second, &options)
        },
    );
    table.add(
        "brep/createdevelopableloft-nurbscurve_nurbscurve_point2darray",
        |first: Curve, second: Curve, rulings: Vec<Point2>| {
            let fixed = rulings.into_iter().map(|ruling| [ruling.x, ruling.y]).collect();
            unrollable(&first, &second, &DevelopableOptions { fixed, ..DevelopableOptions::default() })
        },
    );
    table.add(
        "brep/createfromsweep-curve_curve_bool_double",
        |rail: Curve, shape: Curve, closed: bool, t: Within| {
            one_rail(&rail, &[shape], closed, SweepOptions::default(), t)
        },
    );
    table.add(
        "brep/createfromsweep-curve_curvearray_bool_double",
        |rail: Curve, shapes: Sections, closed: bool, t: Within| {
            one_rail(&rail, &shapes.0, closed, SweepOptions::default(), t)
        },
    );
    let segmented = SweepOptions { miter: Miter::None, ..SweepOptions::default() };
    table.add(
        "brep/createfromsweepsegmented-curve_curve_bool_double",
        move |rail: Curve, shape: Curve, closed: bool, t: Within| {
            one_rail(&rail, &[shape], closed, segmented, t)
        },
    );
    table.add(
        "brep/createfromsweepsegmented-curve_curvearray_bool_double",
        move |rail: Curve, shapes: Sections, closed: bool, t: Within| {
            one_rail(&rail, &shapes.0, closed, segmented, t)
        },
    );
    table.add(
        "brep/createfromsweep-curve_curvearray_point3d_point3d_sweepframe_vector3d_bool_sweepblend_sweepmiter_double_sweeprebuild_int_double",
        swept_with_all,
    );
    table.add(
        "brep/createfromsweep-curve_curve_curve_bool_double",
        |a: Curve, b: Curve, shape: Curve, closed: bool, t: Within| {
            two_rails(&a, &b, &[shape], closed, false, t)
        },
    );
    table.add(
        "brep/createfromsweep-curve_curve_curvearray_bool_double",
        |a: Curve, b: Curve, shapes: Sections, closed: bool, t: Within| {
            two_rails(&a, &b, &shapes.0, closed, false, t)
        },
    );
    table.add(
        "brep/createfromsweepsegmented-curve_curvearray_point3d_point3d_sweepframe_vector3d_bool_sweepblend_sweepmiter_double_sweeprebuild_int_double",
        swept_with_all,
    );
    table.add(
        "brep/createfromsweep-curve_curve_curvearray_point3d_point3d_bool_double_sweeprebuild_int_double_bool",
        |a: Curve, b: Curve, shapes: Sections, start: Tip, end: Tip, closed: bool, t: Within, rebuild: i32, _: i32, _: f64, height: bool| {
            if has_tips(start, end) || rebuild != 0 {
                return Err(Fault::not_supported("sweeps that begin or end in a point, or with rebuilt sections"));
            }
            two_rails(&a, &b, &shapes.0, closed, height, t)
        },
    );
    table.add(
        "brep/createpipe-curve_double_bool_pipecapmode_bool_double_double",
        |rail: Curve, radius: Positive, _: bool, cap: Cap, _: bool, t: Within, a: Turn| {
            Ok(vec![pipe(&rail, radius.0, cap.0, &a.and(t))?])
        },
    );
    table.add(
        "brep/createpipe-curve_doublearray_doublearray_bool_pipecapmode_bool_double_double",
        |rail: Curve,
         at: Some1<f64>,
         radii: Some1<Positive>,
         _: bool,
         cap: Cap,
         _: bool,
         t: Within,
         a: Turn| {
            if at.0.len() != radii.0.len() {
                return Err(Fault::bad_request("radii are not as many as railRadiiParameters"));
            }
            // Parameters of radii are shares of the rail's domain.
            let share = |(x, radius): (f64, Positive)| (rail.domain().at(x), radius.0);
            let given: Vec<(f64, f64)> = at.0.into_iter().zip(radii.0).map(share).collect();
            Ok(vec![pipe_variable(&rail, &given, cap.0, &a.and(t))?])
        },
    );
}

type Sections = Some1<Curve>;

/// An argument that has no part in what is supported.
struct Unread;

impl Read for Unread {
    fn read(_: &serde_json::Value) -> Result<Self, Fault> {
        Ok(Self)
    }

    fn type_name() -> String {
        "Any".into()
    }
}

/// A point at an end of a loft or sweep; null, or the coordinates of `Point3d.Unset`, for none.
struct Tip(Option<Point3>);

/// What RhinoCommon has for a coordinate that is not set.
const UNSET: f64 = -1.234_321_012_343_21e308;

impl Read for Tip {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        let point: Option<Point3> = Option::read(json)?;
        Ok(Self(point.filter(|p| [p.x, p.y, p.z] != [UNSET; 3])))
    }

    fn type_name() -> String {
        "Point3d".into()
    }
}

/// A loft between two tips. Two at the origin are none: so they are sent by those who have no unset points.
fn between(start: Tip, end: Tip) -> LoftOptions {
    let both = [start.0, end.0];
    let [start, end] = if both == [Some(Point3::ORIGIN); 2] { [None; 2] } else { both };
    LoftOptions { start, end, ..LoftOptions::default() }
}

fn has_tips(start: Tip, end: Tip) -> bool {
    let options = between(start, end);
    options.start.is_some() || options.end.is_some()
}

fn lofted(sections: &[Curve], options: LoftOptions) -> Outcome<Vec<Brep>> {
    Ok(vec![loft(sections, &options, &Tolerance::default())?])
}

fn unrollable(first: &Curve, second: &Curve, options: &DevelopableOptions) -> Outcome<Vec<Brep>> {
    Ok(vec![developable_loft(first, second, options, &Tolerance::default())?.brep])
}

/// Whether a sweep closes is up to its rails.
fn check_closed(rails: &[&Curve], closed: bool) -> Outcome<()> {
    if closed && !rails.iter().all(|rail| rail.is_closed()) {
        return Err(Fault::bad_request("closed is true, but a rail is open"));
    }
    Ok(())
}

fn one_rail(
    rail: &Curve,
    shapes: &[Curve],
    closed: bool,
    options: SweepOptions,
    t: Within,
) -> Outcome<Vec<Brep>> {
    check_closed(&[rail], closed)?;
    Ok(sweep_one(rail, shapes, &options, &t.tolerance())?)
}

fn two_rails(
    a: &Curve,
    b: &Curve,
    shapes: &[Curve],
    closed: bool,
    height: bool,
    t: Within,
) -> Outcome<Vec<Brep>> {
    check_closed(&[a, b], closed)?;
    Ok(sweep_two([a, b], shapes, height, &t.tolerance())?)
}

#[expect(clippy::too_many_arguments, reason = "those of RhinoCommon")]
fn swept_with_all(
    rail: Curve,
    shapes: Sections,
    start: Tip,
    end: Tip,
    frame: Roadlike,
    upright: Vector3,
    closed: bool,
    blend: i32,
    miter: SweepMiter,
    tolerance: Within,
    rebuild: i32,
    _points: i32,
    _refit: f64,
) -> Outcome<Vec<Brep>> {
    if has_tips(start, end) {
        return Err(Fault::not_supported("sweeps that begin or end in a point"));
    }
    if blend != 0 || rebuild != 0 {
        return Err(Fault::not_supported("sweeps with global blending or rebuilt sections"));
    }
    let frame = if frame.0 { SweepFrame::Roadlike(upright) } else { SweepFrame::Freeform };
    one_rail(&rail, &shapes.0, closed, SweepOptions { frame, miter: miter.0 }, tolerance)
}
