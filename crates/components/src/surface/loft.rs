//! Surface / Freeform: surfaces through sections.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{LoftOptions, Value};
use katydid_geometry::construct::{self, LoftStyle};
use katydid_geometry::{
    Brep, Curve, Direction, KnotSpacing, NurbsCurve, NurbsSurface, Surface, clamped_uniform_knots,
    compatible_curves,
};

use super::{shared, warning};

/// A surface through section curves, in the order of the list.
///
/// Every section is used in its own direction; sections that run against each other twist the surface, unless the
/// options adjust them. Through three and more sections it is smooth, unless the options say otherwise. It has a face
/// for each part without a kink.
#[component("a7a41d0a-2188-4f7a-82cc-1a2c4e4ec850", name = "Loft", nick = "Loft", at = "Surface/Freeform")]
#[output("Loft", "L", "The surface: u runs along the sections, v from one to the next.", kind = Brep)]
fn loft(
    context: &Context<'_>,
    /// The sections, at least two.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// How the sections are joined.
    #[port("Options", "O", default = LoftOptions::default())]
    options: LoftOptions,
) -> Result<Value, Message> {
    let sections: Vec<Curve> = curves.present().map(|c| (*c).clone()).collect();
    if sections.len() < 2 {
        return Err(Message::warning("A loft needs at least two sections"));
    }
    let style = match options.kind {
        0 => LoftStyle::Normal,
        1 => LoftStyle::Loose,
        2 => LoftStyle::Tight,
        3 => LoftStyle::Straight,
        4 => LoftStyle::Developable,
        5 => LoftStyle::Uniform,
        other => return Err(Message::error(format!("There is no loft of type {other}"))),
    };
    let controls: usize = sections.iter().map(|c| c.hull_points().len()).sum();
    context.bytes(controls.saturating_mul(sections.len()).saturating_mul(32))?;
    let made = construct::loft(
        &sections,
        &construct::LoftOptions {
            style,
            closed: options.closed,
            adjust: options.adjust,
            rebuild: usize::try_from(options.rebuild).ok().filter(|n| *n > 0),
            refit: Some(options.refit).filter(|t| *t > 0.0),
            ..construct::LoftOptions::default()
        },
        &context.tolerance(),
    );
    let made = made.map_err(warning)?;
    if style == LoftStyle::Developable {
        let turn = turn_along_rulings(&made).to_degrees();
        if turn > 0.1 {
            context.warn(format!("Its rulings twist by up to {turn:.1}°: it cannot be unrolled exactly"));
        }
    }
    Ok(Value::from(made))
}

/// The largest angle between normals near both ends of a line of constant u, in radians.
fn turn_along_rulings(brep: &Brep) -> f64 {
    const PLACES: u32 = 32;
    let of = |surface: Surface| {
        let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
        let at = |k: u32| {
            let t = u.at((f64::from(k) + 0.5) / f64::from(PLACES));
            let (a, b) = (surface.normal_at(t, v.at(0.05))?, surface.normal_at(t, v.at(0.95))?);
            a.angle_to(b)
        };
        (0..PLACES).filter_map(at).fold(0.0, f64::max)
    };
    (0..brep.faces().len())
        .filter_map(|face| brep.face_surface(face))
        .map(|s| of(s.clone()))
        .fold(0.0, f64::max)
}

/// A surface whose control points are those of the sections, in the order of the list.
///
/// It passes near the inner sections, not through them.
#[component(
    "5c270622-ee80-45a4-b07a-bd8ffede92a2",
    name = "Control Point Loft",
    nick = "CPLoft",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along the sections, v from one to the next.")]
fn control_point_loft(
    context: &Context<'_>,
    /// The sections, at least two.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// The degree from section to section; at most one less than there are sections.
    #[port("Degree", "D", default = 3)]
    degree: i32,
) -> Result<Shared<Surface>, Message> {
    let sections = compatible(context, &curves)?;
    let degree = usize::try_from(degree).ok().filter(|d| (1..=11).contains(d));
    let degree = degree.ok_or_else(|| Message::error("The degree is a number from 1 to 11"))?;
    let (Some(first), n) = (sections.first(), sections.len()) else {
        return Err(Message::warning("A loft needs at least two sections"));
    };
    let degrees = [first.degree(), degree.min(n - 1)];
    let counts = [first.point_count(), n];
    let knots = [first.knots().to_vec(), clamped_uniform_knots(degrees[1], n).map_err(warning)?];
    let made = if first.is_rational() {
        NurbsSurface::rational(degrees, counts, net(&sections, NurbsCurve::homogeneous_points), knots)
    } else {
        NurbsSurface::new(degrees, counts, net(&sections, NurbsCurve::control_points), knots)
    };
    Ok(shared(made.map_err(warning)?))
}

/// A surface through sections that are each taken at even lengths, in the order of the list.
///
/// Where the sections have different control points it is lighter than a loft, and off them by a little between the
/// places that are taken.
#[component(
    "342aa574-1327-4bc2-8daf-203da2a45676",
    name = "Fit Loft",
    nick = "FitLoft",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along the sections, v from one to the next.")]
fn fit_loft(
    context: &Context<'_>,
    /// The sections, at least two.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
    /// At how many places a section is taken: more than the degree along it.
    #[port("Count U", "Nu", default = 10)]
    count: i32,
    /// The degree along the sections.
    #[port("Degree U", "Du", default = 3)]
    degree_u: i32,
    /// The degree from section to section; at most one less than there are sections.
    #[port("Degree V", "Dv", default = 3)]
    degree_v: i32,
) -> Result<Shared<Surface>, Message> {
    let sections: Vec<Shared<Curve>> = curves.present().collect();
    if sections.len() < 2 {
        return Err(Message::warning("A loft needs at least two sections"));
    }
    let degree = |d: i32| usize::try_from(d).ok().filter(|d| (1..=11).contains(d));
    let (Some(along), Some(across)) = (degree(degree_u), degree(degree_v)) else {
        return Err(Message::error("A degree is a number from 1 to 11"));
    };
    let count = usize::try_from(count).ok().filter(|n| *n > along);
    let count =
        count.ok_or_else(|| Message::error("The count must be above the degree along the sections"))?;
    context.bytes(count.saturating_mul(sections.len()).saturating_mul(256))?;
    let mut points = Vec::with_capacity(count * sections.len());
    let rows = sections
        .iter()
        .map(|section| {
            context.check()?;
            let mut places = section.divide_by_count(count - 1).map_err(warning)?;
            places.truncate(count - 1);
            places.push(section.domain().end);
            Ok(places.into_iter().map(|t| section.point_at(t)).collect::<Vec<_>>())
        })
        .collect::<Result<Vec<_>, Message>>()?;
    for k in 0..count {
        points.extend(rows.iter().filter_map(|row| row.get(k)).copied());
    }
    let degrees = [along, across.min(sections.len() - 1)];
    let made = NurbsSurface::interpolate(
        degrees,
        [count, sections.len()],
        &points,
        KnotSpacing::Chord,
        [false, false],
    );
    Ok(shared(made.map_err(warning)?))
}

/// The sections with the same degree and knots.
fn compatible(context: &Context<'_>, curves: &List<'_, Shared<Curve>>) -> Result<Vec<NurbsCurve>, Message> {
    let sections = curves.present().map(|c| c.to_nurbs()).collect::<Result<Vec<_>, _>>().map_err(warning)?;
    if sections.len() < 2 {
        return Err(Message::warning("A loft needs at least two sections"));
    }
    let sections = compatible_curves(&sections).map_err(warning)?;
    let controls = sections.first().map_or(0, NurbsCurve::point_count);
    context.bytes(controls.saturating_mul(sections.len()).saturating_mul(32))?;
    Ok(sections)
}

/// One number or point of every control point of every section: all sections of the first control point, then all of
/// the next.
fn net<T>(sections: &[NurbsCurve], of: impl Fn(&NurbsCurve) -> Vec<T>) -> Vec<T> {
    let mut columns: Vec<_> = sections.iter().map(|s| of(s).into_iter()).collect();
    let n = sections.first().map_or(0, NurbsCurve::point_count);
    (0..n).flat_map(|_| columns.iter_mut().filter_map(Iterator::next).collect::<Vec<T>>()).collect()
}

/// How a loft joins its sections.
#[component(
    "45f19d16-1c9f-4b0f-a9a6-45a77f3d206c",
    name = "Loft Options",
    nick = "Loft Opt",
    at = "Surface/Freeform"
)]
#[output("Options", "O", "The options, for Loft.")]
fn loft_options(
    /// Whether the last section is joined to the first.
    #[port("Closed", "Cls", default = false)]
    closed: bool,
    /// Whether open sections that run against the others are turned round.
    #[port("Adjust", "Adj", default = false)]
    adjust: bool,
    /// With how many control points sections are rebuilt; 0 leaves them.
    #[port("Rebuild", "Rbd", default = 0)]
    rebuild: i32,
    /// Within what tolerance sections are refitted; 0 leaves them. Rebuilding goes first.
    #[port("Refit", "Rft", default = 0.0)]
    refit: f64,
    /// 0 smooth, 1 loose (the sections only draw the surface), 2 tight, 3 straight, 5 uniform.
    #[port("Type", "T", default = 0)]
    kind: i32,
) -> Result<LoftOptions, Message> {
    if rebuild < 0 || !(refit >= 0.0) {
        return Err(Message::error("Rebuild and refit must not be negative"));
    }
    Ok(LoftOptions { closed, adjust, kind, rebuild, refit })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{LoftOptions, Value};
    use katydid_geometry::{Brep, Circle, Direction, Line, Plane, Point3, Surface};

    use crate::surface::trial::{breps, mesh_volume};

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    fn rings(n: usize) -> Vec<Circle> {
        let radius = |i: usize| if i.is_multiple_of(2) { 1.0 } else { 2.0 };
        (0..n).map(|i| Circle { plane: Plane::XY.offset(i as f64), radius: radius(i) }).collect()
    }

    fn loft(sections: Vec<Circle>, options: LoftOptions) -> Trial {
        Trial::of("Loft").list(sections).item(options)
    }

    #[test]
    fn two_sections_are_ruled() {
        let cone = surface(loft(rings(2), LoftOptions::default()));
        let exact = 3.0 * std::f64::consts::PI * 2f64.sqrt();
        assert!((cone.area().unwrap().area - exact).abs() < 1e-8);
        let line = |z: f64, x: f64| Line::new(Point3::new(0.0, 0.0, z), Point3::new(x, 0.0, z));
        assert_eq!(Trial::of("Loft").list([line(0.0, 1.0)]).texts(0), ["{0}: null"]);
        assert!(Trial::of("Loft").list([line(0.0, 1.0)]).message().contains("two sections"));
        let there_and_back =
            [line(0.0, 1.0), Line::new(Point3::new(1.0, 0.0, 1.0), Point3::new(0.0, 0.0, 1.0))];
        let adjusted = LoftOptions { adjust: true, ..LoftOptions::default() };
        let flat = surface(Trial::of("Loft").list(there_and_back).item(adjusted));
        assert!((flat.area().unwrap().area - 1.0).abs() < 1e-9);
    }

    #[test]
    fn sections_lie_on_the_surface_but_for_loose_ones() {
        let nearest = |brep: &Brep, p: Point3| {
            let surfaces = (0..brep.faces().len()).filter_map(|face| brep.face_surface(face));
            surfaces.map(|s| s.closest_point(p).unwrap().distance).fold(f64::INFINITY, f64::min)
        };
        for kind in [0, 2, 3, 4, 5] {
            let made = &breps(loft(rings(4), LoftOptions { kind, ..LoftOptions::default() }))[0];
            assert_eq!(made.faces().len(), if matches!(kind, 3 | 4) { 3 } else { 1 });
            for ring in rings(4) {
                for angle in [0.0, 0.7, 2.0, 5.0] {
                    assert!(nearest(made, ring.at(angle)) < 1e-9, "{kind}");
                }
            }
        }
        let loose = &breps(loft(rings(4), LoftOptions { kind: 1, ..LoftOptions::default() }))[0];
        assert!(nearest(loose, rings(4)[1].at(0.7)) > 0.1);
        let message = |kind: i32| loft(rings(3), LoftOptions { kind, ..LoftOptions::default() }).message();
        assert!(message(9).contains("type 9"));
    }

    #[test]
    fn closed_lofts_are_solid() {
        // Four circles round an axis.
        let axes = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        let round = || {
            axes.map(|(x, y)| {
                let (out, up) = ([x, y, 0.0].into(), [0.0, 0.0, 1.0].into());
                let plane = Plane::from_axes(Point3::new(3.0 * x, 3.0 * y, 0.0), out, up).unwrap();
                Circle { plane, radius: 1.0 }
            })
            .to_vec()
        };
        for kind in [0, 1, 3] {
            let made = breps(loft(round(), LoftOptions { closed: true, kind, ..LoftOptions::default() }));
            assert!(made[0].is_solid(), "{kind}");
            assert!(mesh_volume(&made[0]) > 10.0, "{kind}: its normals point outward");
        }
    }

    #[test]
    fn lofts_of_control_points_and_of_places() {
        let loose = surface(Trial::of("Control Point Loft").list(rings(4)).item(2));
        assert_eq!(loose.point_at(0.0, loose.domain(Direction::V).end), rings(4)[3].at(0.0));
        assert!(loose.closest_point(rings(4)[1].at(0.7)).unwrap().distance > 0.1);
        assert!(Trial::of("Control Point Loft").list(rings(4)).item(0).message().contains("1 to 11"));
        let fitted = surface(Trial::of("Fit Loft").list(rings(4)).item(21).item(3).item(3));
        for ring in rings(4) {
            assert!(fitted.closest_point(ring.at(0.7)).unwrap().distance < 1e-3);
        }
        assert!(Trial::of("Fit Loft").list(rings(4)).item(3).item(3).message().contains("above"));
    }

    #[test]
    fn options_go_from_one_to_the_other() {
        let made = Trial::of("Loft Options").item(true).item(false).item(0).item(0.0).item(3).run();
        let out = made.outputs[0].column().get(0);
        assert_eq!(out, Some(Value::from(LoftOptions { closed: true, kind: 3, ..LoftOptions::default() })));
        let rebuilt = loft(rings(3), LoftOptions { rebuild: 12, ..LoftOptions::default() });
        assert_eq!(rebuilt.texts(0), ["{0}: Untrimmed Surface"]);
        assert!(Trial::of("Loft Options").item(true).item(false).item(-1).message().contains("negative"));
    }
}
