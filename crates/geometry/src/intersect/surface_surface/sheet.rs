//! A surface of any kind as far as it reaches: its sides, its poles, and where points lie on it.

use crate::surface::Foot;
use crate::{BoundingBox, Curve, Direction, Point3, Result, Side, Surface, Vector3};

/// A side that bounds a surface.
#[derive(Debug)]
pub(super) struct Border {
    /// The parameter that is constant along it, 0 for u, and whether it is at the end of its domain.
    pub(super) parameter: usize,
    pub(super) at_end: bool,
    pub(super) curve: Curve,
    pub(super) bounds: BoundingBox,
}

/// A surface prepared for curves that lie on it.
pub(super) struct Sheet<'a> {
    pub(super) surface: &'a Surface,
    foot: Foot<'a>,
    /// The sides that are curves, without seams.
    pub(super) borders: Vec<Border>,
    /// The points to which sides collapse.
    pub(super) poles: Vec<Point3>,
}

impl<'a> Sheet<'a> {
    /// # Errors
    /// A number is not finite.
    pub(super) fn new(surface: &'a Surface) -> Result<Self> {
        let (mut borders, mut poles) = (Vec::new(), Vec::new());
        for (d, sides) in
            [(Direction::U, [Side::West, Side::East]), (Direction::V, [Side::South, Side::North])]
        {
            let domain = surface.domain(d);
            for (side, at_end) in sides.into_iter().zip([false, true]) {
                let value = if at_end { domain.end } else { domain.start };
                if surface.is_singular(side) {
                    let other = surface.domain(d.other()).middle();
                    poles.push(match d {
                        Direction::U => surface.point_at(value, other),
                        Direction::V => surface.point_at(other, value),
                    });
                } else if !surface.is_closed(d) {
                    let curve = surface.isocurve(d.other(), value)?;
                    let bounds = curve.bounding_box();
                    borders.push(Border { parameter: d.index(), at_end, curve, bounds });
                }
            }
        }
        Ok(Self { surface, foot: Foot::new(surface)?, borders, poles })
    }

    /// The parameters of the point of the surface that is nearest to `p`, and its distance: on the turn of a closed direction
    /// that is nearest to known parameters, else in the domain.
    ///
    /// # Errors
    /// The work was stopped, or a number is not finite.
    pub(super) fn nearest(&mut self, p: Point3, known: Option<[f64; 2]>) -> Result<([f64; 2], f64)> {
        let mut uv = self.foot.at(p, known)?;
        for (x, d) in uv.iter_mut().zip(Direction::BOTH) {
            let domain = self.surface.domain(d);
            if known.is_none() && self.surface.is_closed(d) && !domain.contains(*x) {
                *x = domain.wrapped(*x);
            }
        }
        Ok((uv, self.point(uv).distance_to(p)))
    }

    /// The point at parameters on any turn.
    pub(super) fn point(&self, uv: [f64; 2]) -> Point3 {
        self.foot.image(Point3::new(uv[0], uv[1], 0.0))
    }

    /// The velocity in parameters of a point that moves on the surface; `None` where the surface is singular.
    pub(super) fn slope(&self, uv: [f64; 2], p: Point3, velocity: Vector3) -> Option<[f64; 2]> {
        self.foot.slope(uv, p.to_vector(), velocity)
    }

    /// The unit normal at parameters; `None` where the surface has none.
    pub(super) fn normal(&self, uv: [f64; 2]) -> Option<Vector3> {
        let [a, b] = [[1.0, 0.0], [0.0, 1.0]].map(|rate| self.foot.velocity(uv, rate));
        a.cross(b).unitized()
    }

    /// Parameters moved from a side inward by a part of the domain.
    pub(super) fn inward(&self, border: &Border, uv: [f64; 2], part: f64) -> [f64; 2] {
        let domain = self.surface.domain(Direction::BOTH[border.parameter]);
        let mut out = uv;
        let x = if border.at_end { 1.0 - part } else { part };
        out[border.parameter] = domain.at(x);
        out
    }
}
