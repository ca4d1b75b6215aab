//! Control points and vertices drawn towards the middle of their neighbours, along all axes or some.

use katydid_geometry::{Curve, Direction, NurbsCurve, NurbsSurface, Plane, Point3, Surface, Vector3};

use super::answer::Outcome;
use super::argument::Argument;
use super::call::Call;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    for path in [
        "curve/smooth-curve_double_bool_bool_bool_bool_smoothingcoordinatesystem",
        "curve/smooth-curve_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane",
    ] {
        table.add(path, |c: Curve, pull: Pull| smoothed(&c, &pull));
    }
    for path in [
        "surface/smooth-surface_double_bool_bool_bool_bool_smoothingcoordinatesystem",
        "surface/smooth-surface_double_bool_bool_bool_bool_smoothingcoordinatesystem_plane",
    ] {
        table.add(path, |s: Surface, pull: Pull| smoothed_surface(&s, &pull));
    }
}

/// How points are drawn: what all of these functions take after their object.
pub(super) struct Pull {
    /// The share of the way.
    pub(super) strength: f64,
    pub(super) axes: Axes,
    /// Whether ends, sides and naked edges stay.
    pub(super) fixed: bool,
}

impl Argument for Pull {
    fn take(call: &mut Call<'_>) -> Result<Self, Fault> {
        let strength = call.next()?;
        let allowed = [call.next()?, call.next()?, call.next()?];
        let fixed = call.next()?;
        let system = call.next()?;
        // Functions without a plane send none, which reads as missing.
        let plane = call.next()?;
        Ok(Self { strength, axes: Axes::new(allowed, system, plane)?, fixed })
    }

    fn type_names() -> Vec<String> {
        ["Double", "Boolean", "Boolean", "Boolean", "Boolean", "SmoothingCoordinateSystem", "Plane"]
            .map(String::from)
            .to_vec()
    }
}

/// The surface with each control point moved, by a share of the way, towards the middle of the four beside it; at its
/// open sides, unless they are fixed, of the two or three. Weights stay.
fn smoothed_surface(surface: &Surface, pull: &Pull) -> Outcome<Surface> {
    let nurbs = surface.to_nurbs()?;
    let counts = nurbs.counts();
    let places = nurbs.control_points();
    // How many rows are different: the others stand for one of those.
    let different = [0, 1].map(|k| {
        let along = Direction::BOTH[k];
        if nurbs.is_periodic(along) {
            counts[k] - nurbs.degree(along)
        } else {
            counts[k] - usize::from(nurbs.is_closed(along))
        }
    });
    let at = |i: usize, j: usize| {
        let place = (i % different[0]) * counts[1] + j % different[1];
        places.get(place).copied().unwrap_or(Point3::ORIGIN).to_vector()
    };
    let step = |k: usize, i: usize, by: isize| {
        let closes = different[k] < counts[k];
        let next = i.checked_add_signed(by).or_else(|| closes.then(|| different[k] - 1))?;
        (closes || next < counts[k]).then_some(next)
    };
    let mut moved = Vec::with_capacity(places.len());
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            let (here, open) = (at(i, j), [0, 1].map(|k| different[k] == counts[k]));
            let is_side = |k: usize, i: usize| open[k] && (i == 0 || i + 1 == counts[k]);
            if pull.fixed && (is_side(0, i) || is_side(1, j)) {
                moved.push(here.to_point());
                continue;
            }
            let (i, j) = (i % different[0], j % different[1]);
            let beside = [
                step(0, i, -1).map(|i| at(i, j)),
                step(0, i, 1).map(|i| at(i, j)),
                step(1, j, -1).map(|j| at(i, j)),
                step(1, j, 1).map(|j| at(i, j)),
            ];
            let beside: Vec<Vector3> = beside.into_iter().flatten().collect();
            let middle = beside.iter().copied().sum::<Vector3>() / beside.len() as f64;
            moved.push((here + pull.part(middle - here)).to_point());
        }
    }
    let knots = Direction::BOTH.map(|along| nurbs.knots(along).to_vec());
    Ok(if nurbs.is_rational() {
        NurbsSurface::with_weights(nurbs.degrees(), counts, &moved, &nurbs.weights(), knots)?
    } else {
        NurbsSurface::new(nurbs.degrees(), counts, moved, knots)?
    }
    .into())
}

impl Pull {
    /// The move of a point for the way to the middle of its neighbours.
    fn part(&self, way: Vector3) -> Vector3 {
        self.axes.part(way * self.strength)
    }
}

/// `SmoothingCoordinateSystem.CPlane`: the plane that is given with it.
const IN_PLANE: i32 = 1;
/// `SmoothingCoordinateSystem.Object`: other axes at every point.
const OF_OBJECT: i32 = 2;

/// The directions in which points may move.
pub(super) struct Axes(Vec<Vector3>);

impl Axes {
    /// Those of the world, or of the plane when the system says so.
    fn new(allowed: [bool; 3], system: i32, plane: Option<Plane>) -> Outcome<Self> {
        let frame = match (system, plane) {
            _ if allowed == [true; 3] => Plane::XY,
            (OF_OBJECT, _) => {
                return Err(Fault::not_supported("smoothing along some of the object's own axes"));
            }
            (IN_PLANE, Some(plane)) => plane,
            _ => Plane::XY,
        };
        let axes = [frame.x_axis, frame.y_axis, frame.z_axis];
        Ok(Self(
            axes.into_iter().zip(allowed).filter(|(_, allowed)| *allowed).map(|(axis, _)| axis).collect(),
        ))
    }

    /// What of a move is along them.
    pub(super) fn part(&self, way: Vector3) -> Vector3 {
        if self.0.len() == 3 { way } else { self.0.iter().map(|axis| *axis * way.dot(*axis)).sum() }
    }
}

/// The curve with each control point moved, by a share of the way, towards the middle of the two beside it; at open ends
/// towards the one beside it, unless the ends are fixed. Weights stay.
fn smoothed(curve: &Curve, pull: &Pull) -> Outcome<Curve> {
    let nurbs = curve.to_nurbs()?;
    let (places, weights) = (nurbs.control_points(), nurbs.weights());
    // Points that stand for one another: the last ones of a periodic curve for its first, the ends of a closed one.
    let different = if nurbs.is_periodic() {
        places.len() - nurbs.degree()
    } else if curve.is_closed() {
        places.len() - 1
    } else {
        places.len()
    };
    let closes = different < places.len();
    let at = |i: usize| places.get(i % different).copied().unwrap_or(Point3::ORIGIN).to_vector();
    let new = |i: usize| {
        let here = at(i);
        let is_end = !nurbs.is_periodic() && (i == 0 || i + 1 == places.len());
        if is_end && pull.fixed {
            return here;
        }
        let middle = if closes {
            (at(i + different - 1) + at(i + 1)) * 0.5
        } else if i == 0 {
            at(1)
        } else if i + 1 == places.len() {
            at(i - 1)
        } else {
            (at(i - 1) + at(i + 1)) * 0.5
        };
        here + pull.part(middle - here)
    };
    let moved: Vec<Point3> = (0..places.len()).map(|i| new(i).to_point()).collect();
    Ok(if nurbs.is_rational() {
        NurbsCurve::with_weights(nurbs.degree(), &moved, &weights, nurbs.knots().to_vec())?
    } else {
        NurbsCurve::new(nurbs.degree(), moved, nurbs.knots().to_vec())?
    }
    .into())
}
