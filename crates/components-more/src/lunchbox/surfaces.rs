//! LunchBox Util: surfaces and solids: flatness, patches, directions, joins.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::construct::{PatchOptions, patch};
use katydid_geometry::{
    Brep, Curve, Direction, KnotSpacing, NurbsSurface, Plane, Point3, Surface, Tolerance,
};

use super::panel;

/// The most points of a rebuilt surface in one direction.
const MOST: i32 = 1000;

/// The corners of a panel, those in one place once.
fn corners(surface: &Surface) -> Vec<Point3> {
    let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
    let at = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)];
    let mut points: Vec<Point3> = Vec::with_capacity(4);
    for point in at.map(|(s, t)| surface.point_at(s, t)) {
        if points.iter().all(|known| !known.coincides(point)) {
            points.push(point);
        }
    }
    points
}

/// How far panels are from flat, and what they are when they are flat. Stands for LunchBox's Flatness Check; that the plane is the
/// one that fits the corners best, and the deviation the greatest distance of a corner from it, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c66",
    name = "Flatness Check",
    nick = "Flat",
    at = "LunchBox/Util"
)]
#[output("Flat Panels", "F", "The panels between the corners carried onto the planes.")]
#[output("Planes", "P", "The planes that fit the corners best.")]
#[output("Deviations", "D", "The greatest distance of a corner from its plane, in units.")]
fn flatness(
    context: &Context<'_>,
    /// The panels: surfaces, whose four corners count.
    #[port("Panel List", "Panels")]
    panels: List<Shared<Surface>>,
) -> Result<(Vec<Value>, Vec<Plane>, Vec<f64>), Message> {
    context.items(panels.len().saturating_mul(3))?;
    let (mut flat, mut planes, mut deviations) = (Vec::new(), Vec::new(), Vec::new());
    for surface in panels.present() {
        context.check()?;
        let corners = corners(&surface);
        let (plane, deviation) = Plane::fit(&corners)?;
        let carried: Vec<Point3> =
            corners.iter().map(|p| *p - plane.z_axis * plane.signed_distance(*p)).collect();
        flat.push(panel(&carried)?);
        planes.push(plane);
        deviations.push(deviation);
    }
    Ok((flat, planes, deviations))
}

/// A surface near curves, ended where the outermost closed one is. Stands for LunchBox's Patch Surface.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c67",
    name = "Patch Surface",
    nick = "Patch",
    at = "LunchBox/Util"
)]
#[output("Patch Surface", "Patch", "The surface.", kind = Brep)]
fn patch_surface(
    context: &Context<'_>,
    /// The curves along the edge.
    #[port("Edge Curves", "Crvs")]
    curves: List<Shared<Curve>>,
    /// The number of spans along u, from 1 to 100.
    #[port("U", "U", default = 10)]
    u: i32,
    /// The number of spans along v, from 1 to 100.
    #[port("V", "V", default = 10)]
    v: i32,
    /// The tolerance of the trim, in units.
    #[port("Tolerance", "t", default = 0.001)]
    limit: f64,
) -> Result<Value, Message> {
    let mut spans = [0; 2];
    for (slot, n) in spans.iter_mut().zip([u, v]) {
        *slot = usize::try_from(n)
            .ok()
            .filter(|n| (1..=100).contains(n))
            .ok_or_else(|| Message::error("The numbers of spans must be from 1 to 100"))?;
    }
    let curves: Vec<Curve> = curves.present().map(|curve| (*curve).clone()).collect();
    let [m, n] = spans.map(|spans| spans + 3);
    context.bytes(m.saturating_mul(n).saturating_mul(9 * 8 * (m.max(n) + 1)))?;
    let options = PatchOptions { spans, ..PatchOptions::default() };
    Ok(Value::from(patch(&curves, &[], &options, &within(context, limit)?)?))
}

/// The document's tolerance with another distance.
///
/// # Errors
/// It is not greater than 0.
fn within(context: &Context<'_>, limit: f64) -> Result<Tolerance, Message> {
    if limit > 0.0 && limit.is_finite() {
        Ok(Tolerance { absolute: limit, ..context.tolerance() })
    } else {
        Err(Message::error(format!("The tolerance is {limit}: it must be greater than 0")))
    }
}

/// A surface through even points of another. Stands for LunchBox's Rebuild Surface; that the points lie at even parameters is our
/// reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c68",
    name = "Rebuild Surface",
    nick = "RebuildSrf",
    at = "LunchBox/Util"
)]
#[output("Rebuilt Surface", "RebSrf", "The surface, without trims.")]
fn rebuild(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "Srf")]
    surface: &Surface,
    /// The degree along u, from 1 to 11.
    #[port("U Degree", "uDeg", default = 3)]
    u_degree: i32,
    /// The degree along v, from 1 to 11.
    #[port("V Degree", "vDeg", default = 3)]
    v_degree: i32,
    /// The number of points along u, more than the degree.
    #[port("U Number", "U", default = 10)]
    u: i32,
    /// The number of points along v, more than the degree.
    #[port("V Number", "V", default = 10)]
    v: i32,
) -> Result<Shared<Surface>, Message> {
    let (mut degrees, mut counts) = ([0; 2], [0; 2]);
    for (k, (degree, count)) in [(u_degree, u), (v_degree, v)].into_iter().enumerate() {
        let name = ["U", "V"].get(k).copied().unwrap_or_default();
        if !(1..=11).contains(&degree) {
            return Err(Message::error(format!(
                "The degree along {name} is {degree}: it must be from 1 to 11"
            )));
        }
        if !(degree + 1..=MOST).contains(&count) {
            let least = degree + 1;
            return Err(Message::error(format!("{name} is {count}: it must be from {least} to {MOST}")));
        }
        let whole = |n: i32| usize::try_from(n).unwrap_or(0);
        if let (Some(a), Some(b)) = (degrees.get_mut(k), counts.get_mut(k)) {
            (*a, *b) = (whole(degree), whole(count));
        }
    }
    let [m, n] = counts;
    context.bytes(usize::saturating_mul(m, n).saturating_mul(600))?;
    let domains = [Direction::U, Direction::V].map(|d| surface.domain(d));
    let [s, t] = domains;
    let mut points = Vec::with_capacity(m * n);
    for i in 0..m {
        for j in 0..n {
            let at = |k: usize, of: usize| k as f64 / (of - 1) as f64;
            points.push(surface.point_at(s.at(at(i, m)), t.at(at(j, n))));
        }
    }
    let made = NurbsSurface::interpolate(degrees, counts, &points, KnotSpacing::Uniform, [false; 2])?;
    let half = Surface::from(made).with_domain(Direction::U, s)?;
    Ok(Shared::new(half.with_domain(Direction::V, t)?))
}

/// A surface whose directions are turned round. Stands for LunchBox's Reverse Surface Direction.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c69",
    name = "Reverse Surface Direction",
    nick = "RevSrf",
    at = "LunchBox/Util"
)]
#[output("Reversed Surface", "RevSrf", "The surface, without trims.")]
fn reverse(
    /// The surface.
    #[port("Surface", "Srf")]
    surface: &Surface,
    /// 0 nothing, 1 turns u round, 2 turns v round, 3 both.
    #[port("Reverse Option", "R", default = 0)]
    option: i32,
) -> Result<Shared<Surface>, Message> {
    Ok(Shared::new(match option {
        0 => surface.clone(),
        1 => surface.reversed(Direction::U),
        2 => surface.reversed(Direction::V),
        3 => surface.reversed(Direction::U).reversed(Direction::V),
        _ => return Err(Message::error(format!("R is {option}: it must be 0, 1, 2 or 3"))),
    }))
}

/// Joins Breps along edges that run together within a tolerance. Stands for LunchBox's Brep Join with Tolerance.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c6a",
    name = "Brep Join with Tolerance",
    nick = "BrepJoin",
    at = "LunchBox/Util"
)]
#[output("Brep", "Brep", "The joined Breps, and those that nothing could be joined to.", kind = Brep)]
fn join(
    context: &Context<'_>,
    /// The Breps.
    #[port("Brep", "Brep")]
    breps: List<Shared<Brep>>,
    /// How far apart edges may be that are joined, in units.
    #[port("Tolerance", "tol", default = 0.001)]
    limit: f64,
) -> Result<Vec<Value>, Message> {
    let given: Vec<Brep> = breps.present().map(|brep| (*brep).clone()).collect();
    let joined = Brep::join(&given, &within(context, limit)?)?;
    context.items(joined.breps.len())?;
    Ok(joined.breps.into_iter().map(Value::from).collect())
}

/// The coordinates of a point in a plane's axes. Stands for LunchBox's Relative Coordinates.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c6b",
    name = "Relative Coordinates",
    nick = "Relative",
    at = "LunchBox/Util"
)]
#[output("Relative Point", "rPt", "The point with these coordinates in the world's axes.")]
#[output("Relative X", "rX", "The coordinate along the plane's x.")]
#[output("Relative Y", "rY", "The coordinate along its y.")]
#[output("Relative Z", "rZ", "The height over the plane.")]
fn relative(
    /// The plane.
    #[port("Plane", "Pln", default = Plane::XY)]
    plane: Plane,
    /// The point.
    #[port("Point", "Pt")]
    point: Point3,
) -> (Point3, f64, f64, f64) {
    let [x, y, z] = plane.coordinates(point);
    (Point3::new(x, y, z), x, y, z)
}
