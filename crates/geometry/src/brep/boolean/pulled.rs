//! The images of pieces in the parameter plane of a face.

use super::arrangement::Plan;
use super::thresholds::{BESIDE, EXACT, MOST_HALVINGS, PLACES, PULLED, SAME_PARAMETER};
use crate::brep::build::with_ends;
use crate::{Curve, Direction, Interval, Line, Point3, Result, Tolerance, Vector3};

impl Plan<'_> {
    /// The image of a piece in the parameter plane, as near as it can be followed.
    pub(super) fn pulled(&self, curve: &Curve) -> Result<Curve> {
        let mut last = Err(self.refuse(Some(curve.start())));
        for parts in [0, MOST_HALVINGS] {
            for share in PULLED {
                last = self.pulled_within(curve, share * self.all.limit, parts);
                if last.is_ok() || crate::cancellation::was_given_up() {
                    break;
                }
            }
            if last.is_ok() || crate::cancellation::was_given_up() {
                break;
            }
        }
        last.map_err(|why| if why == crate::Error::Stopped { why } else { self.refuse(Some(curve.start())) })
    }

    /// The image of a piece within a distance. One that bends far more quickly in some places than in others is halved up
    /// to so many times, and its halves are followed for themselves.
    fn pulled_within(&self, curve: &Curve, limit: f64, halvings: usize) -> Result<Curve> {
        let tolerance = Tolerance { absolute: limit, ..Tolerance::default() };
        let surface = &self.face.surface;
        let whole = if self.face.is_round() {
            // A formula tells parameters: no search is needed.
            if let Some(flat) = self.straight(curve)? {
                return Ok(flat);
            }
            self.followed(curve, limit).or_else(|_| surface.parameter_curve(curve, &tolerance))
        } else {
            surface.parameter_curve(curve, &tolerance).or_else(|_| self.followed(curve, limit))
        };
        if whole.is_ok() || halvings == 0 || crate::cancellation::was_given_up() {
            return whole;
        }
        let domain = curve.domain();
        let halves = [
            curve.trimmed(Interval::new(domain.start, domain.middle()))?,
            curve.trimmed(Interval::new(domain.middle(), domain.end))?,
        ];
        let first = self.pulled_within(&halves[0], limit, halvings - 1)?;
        let second = self.pulled_within(&halves[1], limit, halvings - 1)?;
        let mut way = first.end() - second.start();
        for d in Direction::BOTH {
            // The second half may lie on another turn; but for that it begins where the first one ends.
            let k = d.index();
            let (period, off) = (self.domain[k].length(), if k == 0 { way.x } else { way.y });
            let turns = if surface.is_closed(d) { period * (off / period).round() } else { 0.0 };
            if k == 0 { way.x = turns } else { way.y = turns }
        }
        let second = second.transformed(&crate::Xform::translation(way))?;
        let second = with_ends(&second, [first.end(), second.end()])?;
        Ok(crate::curve::chained(vec![first, second], 0.0))
    }

    /// The image of a line or an arc along which one parameter stands still and the other runs evenly, as along rulings,
    /// parallels and meridians: a segment.
    fn straight(&self, curve: &Curve) -> Result<Option<Curve>> {
        if !matches!(curve, Curve::Line(_) | Curve::Arc(_)) {
            return Ok(None);
        }
        let domain = curve.domain();
        let ends = [self.parameters_along(curve, domain.start)?, self.parameters_along(curve, domain.end)?];
        let [a, b] = ends.map(|[u, v]| Point3::new(u, v, 0.0));
        for share in PLACES {
            let uv = a.lerp(b, share);
            let off = self.face.surface.point_at(uv.x, uv.y).distance_to(curve.point_at(domain.at(share)));
            if !(off <= EXACT * self.face.size) {
                return Ok(None);
            }
        }
        Ok(Some(Line::new(a, b).into()))
    }

    /// The parameters of a place of a piece, on the turn and, where the surface is a point, in the direction of the
    /// places beside it towards its middle.
    fn parameters_along(&self, curve: &Curve, t: f64) -> Result<[f64; 2]> {
        let mut uv = self.face.parameters(curve.point_at(t))?;
        let at_pole = self.pole(uv);
        let near_side = |k: usize| {
            let domain = self.domain[k];
            let near = SAME_PARAMETER * domain.length();
            (uv[k] - domain.start).abs() <= near || (uv[k] - domain.end).abs() <= near
        };
        let closed = Direction::BOTH.map(|d| self.face.surface.is_closed(d));
        if at_pole.is_none() && !(0..2).any(|k| closed[k] && near_side(k)) {
            return Ok(uv);
        }
        let inner = self.face.parameters(curve.point_at(t + BESIDE * (curve.domain().middle() - t)))?;
        for k in 0..2 {
            if closed[k] {
                let period = self.domain[k].length();
                uv[k] += period * ((inner[k] - uv[k]) / period).round();
            }
        }
        if let Some(side) = at_pole {
            let k = side.along().0.index();
            uv[k] = inner[k];
        }
        Ok(uv)
    }

    /// The image of a piece by its places, with the velocity of the surface's tangent plane: also where its ends lie on
    /// sides of the surface but for rounding.
    fn followed(&self, curve: &Curve, limit: f64) -> Result<Curve> {
        let surface = &self.face.surface;
        let middle = curve.domain().middle();
        let formula = |t: f64, below: bool| -> Result<(Point3, Vector3)> {
            let uv = self.parameters_along(curve, t)?;
            let [_, velocity] = curve.jet_at::<2>(t, below);
            let d = surface.derivatives(uv[0], uv[1], 1, surface.inner_quadrant(uv[0], uv[1]));
            let jet = [d.point().to_vector(), d.get(1, 0), d.get(0, 1)];
            let rate = match crate::chart::Chart::lifted(&jet, velocity).filter(|_| self.pole(uv).is_none()) {
                Some(rate) => rate,
                None => {
                    let step = BESIDE * (middle - t);
                    let beside = self.parameters_along(curve, t + step)?;
                    [0, 1].map(|k: usize| (beside[k] - uv[k]) / step)
                }
            };
            Ok((Point3::new(uv[0], uv[1], 0.0), Vector3::new(rate[0], rate[1], 0.0)))
        };
        let flat = limit / self.scale[0].max(self.scale[1]);
        Ok(crate::brep::trimmed::followed(&curve.smooth_stretches(), flat, formula)?.into())
    }

    /// The curve on the turn of a closed surface on which its middle lies in the domain, its ends on sides exactly.
    pub(super) fn inside(&self, flat: &Curve) -> Result<Curve> {
        let middle = flat.point_at(flat.domain().middle());
        let mut shift = Vector3::ZERO;
        for d in Direction::BOTH {
            let k = d.index();
            let t = if k == 0 { middle.x } else { middle.y };
            let domain = self.domain[k];
            if self.face.surface.is_closed(d) && !domain.contains(t) {
                let by = domain.wrapped(t) - t;
                if k == 0 { shift.x = by } else { shift.y = by }
            }
        }
        let flat = if shift == Vector3::ZERO {
            flat.clone()
        } else {
            flat.transformed(&crate::Xform::translation(shift))?
        };
        let snapped = |p: Point3| {
            let on = |k: usize, t: f64| {
                let domain = self.domain[k];
                let near = SAME_PARAMETER * domain.length();
                [domain.start, domain.end].into_iter().find(|side| (t - side).abs() <= near).unwrap_or(t)
            };
            Point3::new(on(0, p.x), on(1, p.y), 0.0)
        };
        let ends = [flat.start(), flat.end()];
        let want = ends.map(snapped);
        if want == ends { Ok(flat) } else { with_ends(&flat, want) }
    }
}
