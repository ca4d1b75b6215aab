//! Surfaces that faces lie on, without ends where their formulas have none.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::curve::Carrier;
use super::entity::{DEEPEST, Record};
use super::place::Space;
use super::spline;
use crate::Result;
use katydid_elementary::Elementary;
use katydid_geometry::{
    Arc, ArcCurve, BoundingBox, Circle, ClosestOnSurface, Curve, Direction, Interval, Line, LineCurve, Plane,
    PlaneSurface, Point3, Quadrant, RevolutionSurface, Side, SumSurface, Surface, Vector3,
};

/// Angles and shares of lengths nearer than this are one.
const SAME: f64 = 1e-9;

/// Loops may stick out of a surface that closes by this part of its period: fitted curves do.
const SLACK: f64 = 1e-4;
/// What is shorter than a whole turn by no more than this part of it is one.
const WHOLE: f64 = 1e-6;

/// A line of the parameter plane that is one point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pole {
    /// The direction that is free there: 0 for u, 1 for v.
    pub(super) free: usize,
    /// Whether it is where the other parameter is greatest.
    pub(super) is_high: bool,
}

impl Pole {
    /// Which way a loop around the surface's inside runs along the pole.
    pub(super) fn sense(self) -> f64 {
        if (self.free == 0) == self.is_high { -1.0 } else { 1.0 }
    }
}

/// A surface by its formula.
pub(super) enum Form {
    Plane(Plane),
    /// Around the plane's normal; the radius grows by the slope for each unit of height.
    Cone {
        plane: Plane,
        radius: f64,
        slope: f64,
    },
    Sphere {
        plane: Plane,
        radius: f64,
    },
    Torus {
        plane: Plane,
        major: f64,
        minor: f64,
    },
    Free {
        surface: Box<Surface>,
        closest: Box<ClosestOnSurface>,
    },
}

/// The support of a face.
pub(super) struct Support {
    pub(super) form: Form,
    /// A bounded part, by whose formula all of it goes on.
    surface: Surface,
    /// How long a parameter is when the surface closes along it.
    pub(super) periods: [Option<f64>; 2],
    /// For u and v the least and the greatest value that are poles.
    pub(super) poles: [[Option<f64>; 2]; 2],
}

impl Support {
    pub(super) fn new(form: Form) -> Result<Self> {
        let round = [Some(TAU), None];
        let (periods, south_north) = match &form {
            Form::Plane(_) => ([None, None], [None, None]),
            Form::Cone { slope, .. } if *slope == 0.0 => (round, [None, None]),
            Form::Cone { radius, slope, .. } => {
                let apex = Some(-radius / slope);
                (round, if *slope > 0.0 { [apex, None] } else { [None, apex] })
            }
            Form::Sphere { .. } => (round, [Some(-FRAC_PI_2), Some(FRAC_PI_2)]),
            Form::Torus { .. } => ([Some(TAU), Some(TAU)], [None, None]),
            Form::Free { surface, .. } => return Self::free(surface.as_ref().clone()),
        };
        let range = match &form {
            Form::Sphere { .. } => [Interval::new(0.0, TAU), Interval::new(-FRAC_PI_2, FRAC_PI_2)],
            // Beside the apex.
            Form::Cone { radius, slope, .. } if *slope != 0.0 => {
                let apex = -radius / slope;
                let far = apex + slope.signum() * radius.max(1.0) / slope.abs().max(1.0);
                [Interval::new(0.0, TAU), Interval::new(apex, far).ordered()]
            }
            _ => [Interval::new(0.0, TAU), Interval::new(0.0, TAU)],
        };
        let surface = bounded(&form, range)?;
        Ok(Self { form, surface, periods, poles: [[None, None], south_north] })
    }

    /// A surface by pieces of its own, which may close.
    pub(super) fn free(surface: Surface) -> Result<Self> {
        let closest = Box::new(ClosestOnSurface::new(&surface)?);
        let periods = Direction::BOTH.map(|d| surface.is_closed(d).then(|| surface.domain(d).length()));
        let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
        let at = |side: Side, t: f64| surface.is_singular(side).then_some(t);
        let poles = [
            [at(Side::West, u.start), at(Side::East, u.end)],
            [at(Side::South, v.start), at(Side::North, v.end)],
        ];
        let form = Form::Free { surface: Box::new(surface.clone()), closest };
        Ok(Self { form, surface, periods, poles })
    }

    /// The parameters of the nearest point.
    pub(super) fn parameters(&self, p: Point3) -> Result<[f64; 2]> {
        let round = |plane: &Plane| {
            let [x, y, z] = plane.coordinates(p);
            (y.arctangent_of(x), x.hypotenuse(y), z)
        };
        Ok(match &self.form {
            Form::Plane(plane) => {
                let [x, y, _] = plane.coordinates(p);
                [x, y]
            }
            Form::Cone { plane, radius, slope } => {
                let (u, r, z) = round(plane);
                [u, (z + slope * (r - radius)) / (1.0 + slope * slope)]
            }
            Form::Sphere { plane, .. } => {
                let (u, r, z) = round(plane);
                [u, z.arctangent_of(r)]
            }
            Form::Torus { plane, major, .. } => {
                let (u, r, z) = round(plane);
                [u, z.arctangent_of(r - major)]
            }
            Form::Free { closest, .. } => {
                let near = closest.nearest(p)?;
                [near.u, near.v]
            }
        })
    }

    /// The value of a parameter where the surface closes, for one near there.
    pub(super) fn on_seam(&self, d: usize, value: f64) -> f64 {
        let (Form::Free { surface, .. }, Some(period)) = (&self.form, self.periods[d]) else { return value };
        let start = surface.domain(Direction::BOTH[d]).start;
        let nearest = start + period * ((value - start) / period).round();
        if (value - nearest).abs() <= 1e-3 * period { nearest } else { value }
    }

    pub(super) fn point(&self, uv: [f64; 2]) -> Point3 {
        let [u, v] = self.within(uv, uv);
        self.surface.point_at(u, v)
    }

    /// The derivatives by u and v, from the side on which another place is.
    pub(super) fn partials(&self, uv: [f64; 2], beside: [f64; 2]) -> [Vector3; 2] {
        let [u, v] = self.within(uv, beside);
        let domain = Direction::BOTH.map(|d| self.surface.domain(d));
        let from_below = |d: usize, t: f64| t > domain[d].start && (t >= domain[d].end || beside[d] < uv[d]);
        let side = Quadrant::new(from_below(0, u), from_below(1, v));
        let d = self.surface.derivatives(u, v, 1, side);
        [d.get(1, 0), d.get(0, 1)]
    }

    /// The same place in the domain of a surface that closes by pieces of its own: its formula goes on elsewhere beyond
    /// the ends. At a seam it is the end on whose side another place is.
    fn within(&self, uv: [f64; 2], beside: [f64; 2]) -> [f64; 2] {
        let Form::Free { surface, .. } = &self.form else { return uv };
        let mut within = uv;
        for (d, direction) in Direction::BOTH.into_iter().enumerate() {
            let Some(period) = self.periods[d] else { continue };
            let domain = surface.domain(direction);
            let turns = |t: f64| ((t - domain.start) / period).floor();
            let at_seam = (uv[d] - domain.start) / period;
            let is_at_seam = (at_seam - at_seam.round()).abs() <= SAME;
            let by = match (is_at_seam, beside[d] < uv[d]) {
                (true, true) => at_seam.round() - 1.0,
                (true, false) if beside[d] > uv[d] => at_seam.round(),
                // Where nothing tells the side, an end stays.
                (true, false) if domain.includes(Interval::new(uv[d], uv[d]), false) => 0.0,
                _ => turns(uv[d]),
            };
            within[d] = domain.clamp(uv[d] - period * by);
        }
        within
    }

    /// The pole that a pair of parameters is at, seen from a distance along the surface.
    pub(super) fn pole(&self, uv: [f64; 2], near: f64) -> Option<Pole> {
        for across in 0..2 {
            for (end, value) in self.poles[across].iter().enumerate() {
                if let Some(value) = value {
                    let mut at = uv;
                    at[across] = *value;
                    if self.point(at).distance_to(self.point(uv)) <= near {
                        return Some(Pole { free: 1 - across, is_high: end == 1 });
                    }
                }
            }
        }
        None
    }

    /// The part between parameters; of a b-spline all of it, with its seam where the part begins if it must be.
    pub(super) fn bounded(&self, ranges: [Interval; 2]) -> Result<Surface> {
        let Form::Free { surface, .. } = &self.form else {
            return bounded(&self.form, self.snapped(ranges));
        };
        let mut surface = surface.as_ref().clone();
        for (d, direction) in Direction::BOTH.into_iter().enumerate() {
            let domain = surface.domain(direction);
            let slack = SLACK * domain.length();
            if let (Some(period), Some(wide)) = (self.periods[d], domain.expanded(slack)) {
                // Whole periods away is the same place.
                let turns = ((domain.middle() - ranges[d].middle()) / period).round();
                let range = ranges[d].shifted(period * turns);
                if !wide.includes(range, false) {
                    let start = domain.start + (range.start - domain.start).rem_euclid(period);
                    surface = surface.with_seam(direction, domain.clamp(start))?;
                }
            }
        }
        Ok(surface)
    }

    /// Ranges that end exactly at poles, and that are a whole turn exactly.
    fn snapped(&self, mut ranges: [Interval; 2]) -> [Interval; 2] {
        for (d, range) in ranges.iter_mut().enumerate() {
            let near = SAME * range.length().max(1.0);
            for pole in self.poles[d].iter().flatten() {
                if (range.start - pole).abs() <= near {
                    range.start = *pole;
                }
                if (range.end - pole).abs() <= near {
                    range.end = *pole;
                }
            }
            if let Some(low) = self.poles[d][0] {
                range.start = range.start.max(low);
            }
            if let Some(high) = self.poles[d][1] {
                range.end = range.end.min(high);
            }
            if let Some(period) = self.periods[d].filter(|period| range.length() > period * (1.0 - WHOLE)) {
                range.end = range.start + period;
            }
        }
        ranges
    }

    /// All of a surface that has no ends.
    pub(super) fn whole(&self) -> Option<Result<Surface>> {
        match &self.form {
            Form::Sphere { .. } => {
                Some(self.bounded([Interval::new(0.0, TAU), Interval::new(-FRAC_PI_2, FRAC_PI_2)]))
            }
            Form::Torus { .. } => Some(self.bounded([Interval::new(0.0, TAU); 2])),
            Form::Free { surface, .. } if surface.is_solid() => Some(Ok(surface.as_ref().clone())),
            _ => None,
        }
    }
}

/// The part of a formula between parameters.
fn bounded(form: &Form, [u, v]: [Interval; 2]) -> Result<Surface> {
    let axis = |plane: &Plane| Line::new(plane.origin, plane.origin + plane.z_axis);
    let side = |plane: &Plane, origin: Point3| Plane {
        origin,
        x_axis: plane.x_axis,
        y_axis: plane.z_axis,
        z_axis: -plane.y_axis,
    };
    let arc = |plane: Plane, radius: f64| -> Result<Curve> {
        let circle = Circle::new(plane, radius)?;
        Ok(ArcCurve { arc: Arc { circle, angle: v }, domain: v }.into())
    };
    let (profile, axis) = match form {
        Form::Plane(plane) => return Ok(PlaneSurface::new(*plane, u, v)?.into()),
        Form::Cone { plane, radius, slope } => {
            let at = |height: f64| {
                let r = radius + slope * height;
                plane.at(if r.abs() <= SAME * radius { 0.0 } else { r }, 0.0, height)
            };
            let line = Line::new(at(v.start), at(v.end));
            (LineCurve { line, domain: v }.into(), axis(plane))
        }
        Form::Sphere { plane, radius } => (arc(side(plane, plane.origin), *radius)?, axis(plane)),
        Form::Torus { plane, major, minor } => {
            (arc(side(plane, plane.at(*major, 0.0, 0.0)), *minor)?, axis(plane))
        }
        Form::Free { surface, .. } => return Ok(surface.as_ref().clone()),
    };
    Ok(RevolutionSurface::with_domain(profile, axis, u, u)?.into())
}

impl Space<'_> {
    /// The support of faces whose edges lie in a box.
    pub(super) fn support(&self, id: u64, hull: Option<BoundingBox>, depth: usize) -> Result<Support> {
        let record = self.file.record(id)?;
        if depth > DEEPEST {
            return Err(record.refuse("surfaces that refer to each other in a circle"));
        }
        if self.file.is_complex(id) || spline::is_surface(record.keyword) {
            return Support::free(spline::surface(self, id)?.into());
        }
        let plane = || self.frame(record.reference(1)?);
        let radius = |place: usize| -> Result<f64> {
            let radius = self.length(&record, place)?;
            if radius > 0.0 && radius.is_finite() {
                Ok(radius)
            } else {
                Err(record.refuse("its radius is not above 0"))
            }
        };
        Support::new(match record.keyword {
            "PLANE" => Form::Plane(plane()?),
            "CYLINDRICAL_SURFACE" => Form::Cone { plane: plane()?, radius: radius(2)?, slope: 0.0 },
            "CONICAL_SURFACE" => {
                let (radius, half) = (self.length(&record, 2)?, self.angle(&record, 3)?);
                if !(radius >= 0.0 && half.abs() > SAME && half.abs() < FRAC_PI_2 - SAME) {
                    return Err(record.refuse("its angle is not between 0 and a right angle"));
                }
                Form::Cone { plane: plane()?, radius, slope: half.tangent() }
            }
            "SPHERICAL_SURFACE" => Form::Sphere { plane: plane()?, radius: radius(2)? },
            "TOROIDAL_SURFACE" => {
                let (major, minor) = (radius(2)?, radius(3)?);
                if major <= minor {
                    return Err(record.refuse("tori that meet themselves are not supported"));
                }
                Form::Torus { plane: plane()?, major, minor }
            }
            "SURFACE_OF_LINEAR_EXTRUSION" => return self.extrusion(&record, hull, depth),
            "SURFACE_OF_REVOLUTION" => return self.revolution(&record, hull, depth),
            "RECTANGULAR_TRIMMED_SURFACE" | "CURVE_BOUNDED_SURFACE" => {
                return self.support(record.reference(1)?, hull, depth + 1);
            }
            _ => return Err(record.refuse("surfaces of this type are not supported")),
        })
    }

    fn extrusion(&self, record: &Record<'_>, hull: Option<BoundingBox>, depth: usize) -> Result<Support> {
        let along = self.vector(record.reference(2)?)?;
        let unit = along.unitized().ok_or_else(|| record.refuse("it has no direction"))?;
        let swept = match self.carrier(record.reference(1)?, depth + 1)? {
            Carrier::Line { point, along: x } => {
                let plane = Plane::from_axes(point, x, along).map_err(|error| record.refuse(error))?;
                return Support::new(Form::Plane(plane));
            }
            carrier => {
                let corners = hull.map_or_else(Vec::new, |hull| hull.corners().to_vec());
                carrier.under(&corners, unit).map_err(|error| record.refuse(error))?
            }
        };
        let hull = hull.ok_or_else(|| record.refuse("nothing tells how far it goes"))?;
        let of = |p: Point3| p.to_vector().dot(unit);
        let own = swept.extent_along(unit);
        let heights = hull.corners().map(of);
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min) - own.max();
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max) - own.min();
        let margin = 0.01 * (high - low);
        let range = Interval::new(low - margin, high + margin);
        let at = |t: f64| Point3::ORIGIN + unit * t;
        let line = Line::new(at(range.start), at(range.end));
        let ruling = LineCurve { line, domain: range }.into();
        let surface = SumSurface::new(swept, ruling, Vector3::ZERO).map_err(|error| record.refuse(error))?;
        Support::free(surface.into())
    }

    fn revolution(&self, record: &Record<'_>, hull: Option<BoundingBox>, depth: usize) -> Result<Support> {
        let axis = self.axis(record.reference(2)?)?;
        let unit = axis.to - axis.from;
        let profile = match self.carrier(record.reference(1)?, depth + 1)? {
            Carrier::Line { point, along } => {
                let hull = hull.ok_or_else(|| record.refuse("nothing tells how far it goes"))?;
                // As far along the line as anything in the box is from where the line begins.
                let reach = 1.01 * hull.max_distance_to(point).max(hull.diagonal().length());
                let along = along.unitized().ok_or_else(|| record.refuse("its line has no direction"))?;
                let arm = (point - axis.from) - unit * (point - axis.from).dot(unit);
                let outward = along - unit * along.dot(unit);
                let meets = arm.cross(outward).length() <= SAME * reach && outward.length() > SAME;
                // A line that meets the axis ends there.
                let zero = -arm.dot(outward) / outward.dot(outward).max(1e-300);
                let (from, to) = match meets {
                    true if zero <= 0.0 => (zero.max(-reach), reach),
                    true => (-reach, zero.min(reach)),
                    false => (-reach, reach),
                };
                let domain = Interval::new(from, to);
                LineCurve { line: Line::new(point + along * from, point + along * to), domain }.into()
            }
            carrier => carrier.whole().map_err(|error| record.refuse(error))?,
        };
        let turn = Interval::new(0.0, TAU);
        let surface = RevolutionSurface::new(profile, axis, turn).map_err(|error| record.refuse(error))?;
        Support::free(surface.into())
    }
}
