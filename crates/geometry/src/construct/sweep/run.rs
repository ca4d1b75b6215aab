//! A rail as runs without kinks, and how a frame moves along them.

use katydid_elementary::Elementary;

use super::section::Frame;
use crate::construct::thresholds::{KINK_ANGLE, NO_TURN, OPPOSITE, UPRIGHT_PART};
use crate::thresholds;
use crate::{Arc, Curve, Error, Interval, Line, Plane, Result, Tolerance, Vector3};

/// Kinks below this angle are none.
const SMOOTH: f64 = 1e-6;
/// What is straight or circular within this part of its size is taken for exactly so.
pub(super) const EXACT: f64 = 1e-10;

/// What kind of curve a run is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    Straight,
    Circular(Arc),
    Free,
}

/// The part of a rail between two kinks, or a line or arc of it.
#[derive(Debug, Clone)]
pub(super) struct Run {
    pub(super) curve: Curve,
    pub(super) kind: Kind,
    /// The lengths of the rail at its start and end.
    pub(super) reach: Interval,
    /// How the frame at its start is turned about the tangent, against the run's own.
    pub(super) turn: f64,
    /// Added turn over the whole run, by share of its domain.
    pub(super) twist: f64,
    /// What the axes of a section change by at the start and the end, in the frame's coordinates.
    pub(super) slants: [[Vector3; 3]; 2],
}

/// Which way frames stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Upright {
    /// Turning about the rail as little as possible.
    Free,
    /// With y as near as possible to a direction.
    Towards(Vector3),
}

/// The lines, arcs and curves without kinks that a rail consists of, in order.
pub(super) fn runs(rail: &Curve) -> Result<Vec<Run>> {
    let mut pieces = Vec::new();
    gather(rail, &mut pieces)?;
    let size = rail.bounding_box().diagonal().length();
    let mut out: Vec<Run> = Vec::with_capacity(pieces.len());
    let mut reached = 0.0;
    for curve in pieces {
        let length = curve.length();
        if !(length > EXACT * size) {
            continue;
        }
        let kind = if curve.is_linear(EXACT * size) {
            Kind::Straight
        } else if let Some(arc) = curve.as_arc(EXACT * size) {
            Kind::Circular(arc)
        } else {
            Kind::Free
        };
        let reach = Interval::new(reached, reached + length);
        reached = reach.end;
        out.push(Run { curve, kind, reach, turn: 0.0, twist: 0.0, slants: [[Vector3::ZERO; 3]; 2] });
    }
    if out.is_empty() {
        return Err(Error::degenerate("rail", "it has no length"));
    }
    Ok(out)
}

fn gather(curve: &Curve, out: &mut Vec<Curve>) -> Result<()> {
    match curve {
        Curve::Poly(c) => c.segments().iter().try_for_each(|segment| gather(segment, out)),
        Curve::Line(_) | Curve::Arc(_) => {
            out.push(curve.clone());
            Ok(())
        }
        _ => {
            if let Some(points) = curve.as_polyline() {
                out.extend(points.windows(2).filter(|w| w[0] != w[1]).map(|w| Line::new(w[0], w[1]).into()));
                return Ok(());
            }
            out.extend(curve.smooth_runs(&Tolerance { absolute: f64::INFINITY, angle: KINK_ANGLE })?);
            Ok(())
        }
    }
}

impl Run {
    pub(super) fn tangent(&self, at_end: bool) -> Result<Vector3> {
        let domain = self.curve.domain();
        self.curve
            .tangent_on_side(if at_end { domain.end } else { domain.start }, at_end)
            .ok_or(Error::degenerate("rail", "it has no direction at an end"))
    }

    /// The frames at increasing parameters of the run, slants included.
    pub(super) fn frames(&self, parameters: &[f64], upright: Upright) -> Result<Vec<Frame>> {
        let planes = self.planes(parameters, upright)?;
        let domain = self.curve.domain();
        Ok(planes
            .iter()
            .zip(parameters)
            .map(|(plane, t)| {
                let share = domain.normalized(*t);
                let own = [Vector3::X, Vector3::Y, Vector3::Z];
                let axes = [0, 1, 2].map(|k| {
                    let a = own[k] + self.slants[0][k] * (1.0 - share) + self.slants[1][k] * share;
                    plane.x_axis * a.x + plane.y_axis * a.y + plane.z_axis * a.z
                });
                Frame { origin: plane.origin, axes }
            })
            .collect())
    }

    /// The right-angled frames, z along the rail.
    pub(super) fn planes(&self, parameters: &[f64], upright: Upright) -> Result<Vec<Plane>> {
        let lost = || Error::degenerate("rail", "it has no direction somewhere");
        let domain = self.curve.domain();
        if let Upright::Towards(up) = upright {
            return parameters
                .iter()
                .map(|t| {
                    let tangent = self.curve.tangent_on_side(*t, *t >= domain.end).ok_or_else(lost)?;
                    upright_plane(self.curve.point_at(*t), tangent, up)
                })
                .collect();
        }
        // The run's own frames begin anywhere; all are turned alike.
        let frames = self.curve.perpendicular_frames(parameters);
        let planes = frames.into_iter().zip(parameters).map(|(frame, t)| {
            let plane = frame.ok_or_else(lost)?;
            Ok(plane.rotated(self.turn + self.twist * domain.normalized(*t)))
        });
        planes.collect()
    }

    /// The right-angled frame at the start or end.
    pub(super) fn end_plane(&self, at_end: bool, upright: Upright) -> Result<Plane> {
        let domain = self.curve.domain();
        let t = if at_end { domain.end } else { domain.start };
        self.planes(&[t], upright)?.pop().ok_or(Error::degenerate("rail", "it has no direction"))
    }
}

/// The frame with z along a tangent and y as near as possible to a direction.
fn upright_plane(origin: crate::Point3, tangent: Vector3, up: Vector3) -> Result<Plane> {
    let y = up
        .rejected_from(tangent)
        .filter(|y| y.length() > UPRIGHT_PART * up.length())
        .and_then(Vector3::unitized)
        .ok_or(Error::degenerate("rail", "it runs along the direction that is kept upright"))?;
    Ok(Plane { origin, x_axis: y.cross(tangent), y_axis: y, z_axis: tangent })
}

/// How sections go round a kink.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Corner {
    /// They do not: the parts end across the rail.
    Open,
    /// They are cut by the plane between both directions.
    Cut,
    /// They stand in the plane between both directions, as they are.
    Turned,
}

/// Turns the frames of each run to go on from the one before, and slants sections at kinks. On a closed rail the last
/// run meets the first, and what the frames lack is made up over the length when `even` is set.
pub(super) fn connect(
    runs: &mut [Run],
    closed: bool,
    upright: Upright,
    corner: Corner,
    even: bool,
) -> Result<()> {
    let count = runs.len();
    for i in 1..count {
        let before = runs[i - 1].end_plane(true, upright)?;
        let carried = carried(&before, runs[i].tangent(false)?);
        set_turn(&mut runs[i], &carried, upright)?;
    }
    if closed && even && upright == Upright::Free {
        let last = runs[count - 1].end_plane(true, upright)?;
        let carried = carried(&last, runs[0].tangent(false)?);
        let first = runs[0].end_plane(false, upright)?;
        let lack = angle_about(&carried, &first);
        let whole = runs[count - 1].reach.end;
        if lack.abs() > thresholds::WHOLE_TURN {
            for run in runs.iter_mut() {
                run.turn += lack * run.reach.start / whole;
                run.twist = lack * run.reach.length() / whole;
            }
        }
    }
    for i in 0..if closed { count } else { count - 1 } {
        let j = (i + 1) % count;
        let [a, b] = [runs[i].tangent(true)?, runs[j].tangent(false)?];
        if a.angle_to(b).is_none_or(|x| x <= SMOOTH) {
            continue;
        }
        let [before, after] = [runs[i].end_plane(true, upright)?, runs[j].end_plane(false, upright)?];
        runs[i].slants[1] = slant(&before, a, b, corner)?;
        runs[j].slants[0] = slant(&after, a, b, corner)?;
    }
    Ok(())
}

/// A frame turned by the smallest rotation so that z points along a tangent.
fn carried(plane: &Plane, tangent: Vector3) -> Plane {
    let axis = plane.z_axis.cross(tangent);
    let angle = axis.length().arctangent_of(plane.z_axis.dot(tangent));
    let turned = |v: Vector3| if axis.length() < NO_TURN { v } else { v.rotated(angle, axis).unwrap_or(v) };
    Plane {
        origin: plane.origin,
        x_axis: turned(plane.x_axis),
        y_axis: turned(plane.y_axis),
        z_axis: tangent,
    }
}

/// The angle by which the first frame must be turned about z to have the second's x axis.
fn angle_about(from: &Plane, to: &Plane) -> f64 {
    to.x_axis.dot(from.y_axis).arctangent_of(to.x_axis.dot(from.x_axis))
}

fn set_turn(run: &mut Run, wanted: &Plane, upright: Upright) -> Result<()> {
    if upright == Upright::Free {
        run.turn = 0.0;
        let own = run.end_plane(false, upright)?;
        run.turn = angle_about(&own, wanted);
    }
    Ok(())
}

/// What the axes of a section change by at a kink from direction `a` to `b`, in the coordinates of a frame there.
fn slant(plane: &Plane, a: Vector3, b: Vector3, corner: Corner) -> Result<[Vector3; 3]> {
    let back = Error::degenerate("rail", "it turns straight back");
    let between = (a + b).unitized().filter(|_| (a + b).length() > OPPOSITE).ok_or(back)?;
    let inner = |v: Vector3| Vector3::new(v.dot(plane.x_axis), v.dot(plane.y_axis), v.dot(plane.z_axis));
    let n = inner(between);
    Ok(match corner {
        Corner::Open => [Vector3::ZERO; 3],
        // Along the rail to the plane between both directions.
        Corner::Cut => {
            [Vector3::new(0.0, 0.0, -n.x / n.z), Vector3::new(0.0, 0.0, -n.y / n.z), n - Vector3::Z]
        }
        Corner::Turned => {
            let turned = carried(&Plane { z_axis: Vector3::Z, ..Plane::XY }, n);
            [turned.x_axis - Vector3::X, turned.y_axis - Vector3::Y, n - Vector3::Z]
        }
    })
}
