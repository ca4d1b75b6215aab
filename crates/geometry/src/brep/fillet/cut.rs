//! Where a rounded edge ends: across, or along its section with a surface.

use crate::brep::fillet::thresholds::{ALONG_FACE, FLAT_CARRIER};
use crate::thresholds;
use std::cell::RefCell;

use super::newton::{linear, solve};
use super::strip::Strip;
use crate::brep::trimmed::followed;
use crate::{
    ClosestOnSurface, Curve, Direction, Interval, Line, LineCurve, NurbsCurve, Point3, Result, Surface,
    Vector3,
};

/// Places along the edge that differ by less than this part of the size are one.
const SAME: f64 = 1e-12;
/// Surfaces that meet at less than this angle touch.
const TOUCH: f64 = 0.01;
/// Steps from the middle of an end to each rail.
const MARCH: u32 = 8;

/// The end of a strip, from its first rail (w = 0) to its second (w = 1).
pub(super) struct Cut {
    /// In the parameter plane of the strip, over 0…1.
    pub flat: Curve,
    /// In space, over 0…1.
    pub space: Curve,
    /// The least and the greatest place along the edge.
    pub range: Interval,
    /// Where the rails end along the edge.
    pub ends: [f64; 2],
    /// Where the rails end in space.
    pub points: [Point3; 2],
}

const UNIT: Interval = Interval { start: 0.0, end: 1.0 };

impl Cut {
    /// Straight across at one place along the edge.
    pub(super) fn across(strip: &Strip<'_>, t: f64) -> Result<Self> {
        let (direction, domain) = if strip.is_turned() {
            (Direction::V, strip.surface.domain(Direction::U))
        } else {
            (Direction::U, strip.surface.domain(Direction::V))
        };
        let wider =
            if domain.contains(t) { strip.surface.clone() } else { strip.over(domain.including(t))? };
        let space = wider.isocurve(direction, t)?.with_domain(UNIT)?;
        let flat = LineCurve { line: Line::new(strip.place(0.0, t), strip.place(1.0, t)), domain: UNIT };
        let points = [space.start(), space.end()];
        Ok(Self { flat: flat.into(), space, range: Interval::new(t, t), ends: [t; 2], points })
    }

    /// Along the section with a surface, from the place along the edge and the parameters on the surface where the edge
    /// itself ends.
    pub(super) fn by(
        strip: &Strip<'_>,
        surface: &Surface,
        at: f64,
        uv: [f64; 2],
        limit: f64,
    ) -> Result<Self> {
        let size = strip.wedge.size;
        if let (Some(way), Some(plane)) = (strip.straight_way(), surface.plane(FLAT_CARRIER * size)) {
            return Self::of_plane(strip, way, plane.origin, plane.z_axis, at);
        }
        let domains = Direction::BOTH.map(|d| surface.domain(d));
        let closed = Direction::BOTH.map(|d| surface.is_closed(d));
        let inside = |u: f64, v: f64| {
            let place = [u, v];
            std::array::from_fn::<f64, 2, _>(|n| {
                if closed[n] && !domains[n].contains(place[n]) {
                    domains[n].wrapped(place[n])
                } else {
                    place[n]
                }
            })
        };
        let steps = [
            thresholds::DIFFERENCE_STEP * strip.ends.length(),
            thresholds::DIFFERENCE_STEP * domains[0].length(),
            thresholds::DIFFERENCE_STEP * domains[1].length(),
        ];
        let lost = || strip.wedge.refused("its rounding does not run out on the face at its end");
        let start = match touched(strip, surface, at, uv) {
            true => beyond(strip, surface, at).ok_or_else(lost)?,
            false => [at, uv[0], uv[1]],
        };
        let known: RefCell<Vec<(f64, [f64; 3])>> = RefCell::new(vec![(0.5, start)]);
        let found = |w: f64| -> Option<[f64; 3]> {
            // Nearer to the middle, since where surfaces touch at a rail no step leads away.
            let inner =
                |k: &&(f64, [f64; 3])| (k.0 - 0.5) * (w - 0.5) >= 0.0 && (k.0 - 0.5).abs() <= (w - 0.5).abs();
            let near = known
                .borrow()
                .iter()
                .filter(inner)
                .min_by(|a, b| (a.0 - w).abs().total_cmp(&(b.0 - w).abs()))
                .map(|k| k.1)?;
            let x = solve(near, &steps, size, |x| {
                let [u, v] = inside(x[1], x[2]);
                let apart = strip.point(w, x[0]) - surface.point_at(u, v);
                Some([apart.x, apart.y, apart.z])
            })?;
            known.borrow_mut().push((w, x));
            Some(x)
        };
        // From the middle outwards, so that each place has one nearby.
        for n in 0..=MARCH {
            let by = 0.5 * f64::from(n) / f64::from(MARCH);
            crate::cancellation::check()?;
            found(0.5 - by).and_then(|_| found(0.5 + by)).ok_or_else(lost)?;
        }
        // The change of the unknown along the section; none where the surfaces touch.
        let moving = |w: f64, x: &[f64; 3]| -> Option<([Vector3; 2], Option<f64>)> {
            let [across, along] = strip.partials(w, x[0]);
            let [u, v] = inside(x[1], x[2]);
            let d = surface.derivatives(u, v, 1, surface.inner_quadrant(u, v));
            let (a, b) = (d.get(1, 0), d.get(0, 1));
            let normals = [across.cross(along).unitized()?, a.cross(b).unitized()?];
            let row = |f: fn(Vector3) -> f64| [f(along), -f(a), -f(b)];
            let slopes = [row(|v| v.x), row(|v| v.y), row(|v| v.z)];
            let crosses = normals[0].cross(normals[1]).length() > TOUCH;
            let slope = crosses.then(|| linear(slopes, [-across.x, -across.y, -across.z])).flatten();
            Some(([across, along], slope.map(|by| by[0])))
        };
        let slope_at = |w: f64, x: &[f64; 3]| -> Option<([Vector3; 2], f64)> {
            let (partials, slope) = moving(w, x)?;
            if let Some(slope) = slope {
                return Some((partials, slope));
            }
            // Where both touch a third surface, as at a rail, by the parabola through the slopes beside it.
            let step = if w < 0.5 { 2.0 * TOUCH } else { -2.0 * TOUCH };
            let beside = |n: f64| {
                let w = w + n * step;
                moving(w, &found(w)?)?.1
            };
            Some((partials, 3.0 * (beside(1.0)? - beside(2.0)?) + beside(3.0)?))
        };
        let mut range: Option<Interval> = None;
        let mut fastest = 0.0_f64;
        let space = followed(&[UNIT], limit, |w, _| {
            crate::cancellation::check()?;
            let x = found(w).ok_or_else(lost)?;
            let ([across, along], slope) = slope_at(w, &x).ok_or_else(lost)?;
            range = Some(range.map_or(Interval::new(x[0], x[0]), |r| r.including(x[0])));
            fastest = fastest.max(along.length());
            Ok((strip.point(w, x[0]), across + along * slope))
        })?;
        let range = range.ok_or_else(lost)?;
        if range.length() <= SAME * strip.ends.length().max(size) {
            return Self::across(strip, range.middle());
        }
        let flat = followed(&[UNIT], limit / fastest.max(thresholds::LEAST_DIVISOR), |w, _| {
            let x = found(w).ok_or_else(lost)?;
            let (_, slope) = slope_at(w, &x).ok_or_else(lost)?;
            Ok((strip.place(w, x[0]), strip.place(1.0, slope).to_vector()))
        })?;
        let ends = [found(0.0).ok_or_else(lost)?[0], found(1.0).ok_or_else(lost)?[0]];
        let points = [space.point_at(0.0), space.point_at(1.0)];
        Ok(Self { flat: flat.into(), space: space.into(), range, ends, points })
    }

    /// A straight strip and a plane: its section is the section across, moved along the edge, and exact.
    fn of_plane(strip: &Strip<'_>, way: Vector3, origin: Point3, normal: Vector3, at: f64) -> Result<Self> {
        let oblique = || strip.wedge.refused("the face at its end runs along it");
        let columns = strip.straight_columns().ok_or_else(oblique)?;
        let rate = way.dot(normal);
        if rate.abs() < ALONG_FACE {
            return Err(oblique());
        }
        let level = origin.to_vector().dot(normal);
        let places: Vec<f64> = columns
            .iter()
            .map(|c| (level * c[3] - Vector3::new(c[0], c[1], c[2]).dot(normal)) / rate)
            .collect();
        let own = places.iter().zip(&columns).map(|(t, c)| t / c[3]);
        let hull = own.fold(None, |all: Option<Interval>, t| {
            Some(all.map_or(Interval::new(t, t), |range| range.including(t)))
        });
        let hull = hull.ok_or_else(oblique)?;
        if hull.length() <= SAME * strip.wedge.size {
            let t = if (hull.middle() - at).abs() <= SAME * strip.wedge.size { at } else { hull.middle() };
            return Self::across(strip, t);
        }
        let degree = columns.len() - 1;
        let knots = |degree: usize| [vec![0.0; degree], vec![1.0; degree]].concat();
        let lifted = columns
            .iter()
            .zip(&places)
            .map(|(c, t)| [c[0] + way.x * t, c[1] + way.y * t, c[2] + way.z * t, c[3]]);
        let space = NurbsCurve::rational(degree, lifted.collect(), knots(degree))?;
        // w as a curve of its own takes one degree more.
        let share = |j: usize| j as f64 / (degree + 1) as f64;
        let flat = (0..degree + 2).map(|j| {
            let raised = |f: &dyn Fn(usize) -> f64| {
                let low = if j > 0 { share(j) * f(j - 1) } else { 0.0 };
                low + if j <= degree { (1.0 - share(j)) * f(j) } else { 0.0 }
            };
            let across = if j > 0 { share(j) * columns[j - 1][3] } else { 0.0 };
            [across, raised(&|k| places[k]), 0.0, raised(&|k| columns[k][3])]
        });
        let flat = NurbsCurve::rational(degree + 1, flat.collect(), knots(degree + 1))?;
        let (space, flat): (Curve, Curve) = if degree == 1 {
            let line = |c: &NurbsCurve| LineCurve {
                line: Line::new(c.point_at(0.0), c.point_at(1.0)),
                domain: UNIT,
            };
            (line(&space).into(), line(&flat).into())
        } else {
            (space.into(), flat.into())
        };
        let ends = [flat.start().y, flat.end().y];
        let points = [space.start(), space.end()];
        let bounds = flat.bounding_box();
        Ok(Self { flat, space, range: Interval::new(bounds.min.y, bounds.max.y), ends, points })
    }
}

/// Whether a surface touches the strip where its edge ends, as the rounding of another edge of one of its faces does.
fn touched(strip: &Strip<'_>, surface: &Surface, at: f64, uv: [f64; 2]) -> bool {
    let d = surface.derivatives(uv[0], uv[1], 1, surface.inner_quadrant(uv[0], uv[1]));
    let normal = d.get(1, 0).cross(d.get(0, 1)).unitized();
    let way = strip.partials(0.5, at)[1].unitized();
    normal.zip(way).is_some_and(|(normal, way)| normal.dot(way).abs() < TOUCH)
}

/// Where the middle of a strip first goes through a surface beyond the end of its edge, with the parameters there.
fn beyond(strip: &Strip<'_>, surface: &Surface, at: f64) -> Option<[f64; 3]> {
    const LOOKS: u32 = 64;
    let index = ClosestOnSurface::new(surface).ok()?;
    let outward = if at > strip.ends.middle() { 1.0 } else { -1.0 };
    let speed = strip.partials(0.5, at)[1].length();
    let reach = 4.0 * strip.point(0.0, at).distance_to(strip.point(1.0, at)) / speed;
    let mut before: Option<f64> = None;
    for n in 0..=LOOKS {
        let t = at + outward * reach * f64::from(n) / f64::from(LOOKS);
        let p = strip.point(0.5, t);
        let near = index.nearest(p).ok()?;
        let d = surface.derivatives(near.u, near.v, 1, surface.inner_quadrant(near.u, near.v));
        let height = (p - d.point()).dot(d.get(1, 0).cross(d.get(0, 1)));
        if before.is_some_and(|before| before * height <= 0.0) {
            return Some([t, near.u, near.v]);
        }
        before = Some(height);
    }
    None
}
