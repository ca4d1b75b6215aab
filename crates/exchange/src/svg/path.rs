//! The data of a path: moves, lines, elliptic arcs, quadratic and cubic Béziers.

use katydid_elementary::Elementary;
use katydid_geometry::{ArcCurve, Curve, NurbsCurve, Point3};

use super::cubic::cubics;
use super::ellipse::{Ellipse, conic};
use crate::Result;
use crate::text::Text;

/// A place on the page as SVG has it: y goes down.
pub(super) type Place = [f64; 2];

pub(super) fn place(p: Point3) -> Place {
    // Not −0, which looks odd.
    [p.x + 0.0, 0.0 - p.y]
}

/// A path on its way into a text.
pub(super) struct Path<'t, 'o> {
    text: &'t mut Text<'o>,
    /// Where the pen is, and where it was put down.
    at: Option<Place>,
}

impl<'t, 'o> Path<'t, 'o> {
    pub(super) fn new(text: &'t mut Text<'o>) -> Self {
        Self { text, at: None }
    }

    fn step(&mut self, letter: &str, places: &[Place]) -> Result<()> {
        self.text.push(letter);
        for (i, [x, y]) in places.iter().enumerate() {
            if i > 0 {
                self.text.push(" ");
            }
            self.text.real(*x);
            self.text.push(" ");
            self.text.real(*y);
        }
        self.at = places.last().copied().or(self.at);
        // A place where what was written so far can be sent on.
        self.text.bytes(b"")
    }

    fn move_to(&mut self, p: Place) -> Result<()> {
        if self.at == Some(p) { Ok(()) } else { self.step("M", &[p]) }
    }

    fn close(&mut self) {
        self.text.push("Z");
        self.at = None;
    }

    /// A point: a line without length, which round ends make visible.
    pub(super) fn dot(&mut self, p: Point3) -> Result<()> {
        self.step("M", &[place(p)])?;
        self.text.push("h0");
        Ok(())
    }

    pub(super) fn segment(&mut self, a: Point3, b: Point3) -> Result<()> {
        self.move_to(place(a))?;
        self.step("L", &[place(b)])
    }

    /// A curve of its own, closed where its ends meet.
    pub(super) fn curve(&mut self, curve: &Curve, tolerance: f64) -> Result<()> {
        self.at = None;
        self.part(curve, tolerance)?;
        if curve.is_closed() {
            self.close();
        }
        Ok(())
    }

    fn part(&mut self, curve: &Curve, tolerance: f64) -> Result<()> {
        match curve {
            Curve::Line(line) => {
                self.join(place(line.line.from))?;
                self.step("L", &[place(line.line.to)])
            }
            Curve::Polyline(polyline) => {
                let mut points = polyline.points().iter().map(|p| place(*p));
                points.next().map_or(Ok(()), |first| self.join(first))?;
                points.try_for_each(|p| self.step("L", &[p]))
            }
            Curve::Arc(arc) => self.arc(arc),
            Curve::Nurbs(nurbs) => self.nurbs(nurbs, tolerance),
            Curve::Poly(poly) => poly.segments().iter().try_for_each(|segment| self.part(segment, tolerance)),
        }
    }

    /// The pen goes to the start of the next part, which for most curves is where it is. A gap that rounding left is
    /// drawn over.
    fn join(&mut self, p: Place) -> Result<()> {
        match self.at {
            Some(at) if at == p => Ok(()),
            Some(at) if near(at, p) => Ok(()),
            _ => self.step("M", &[p]),
        }
    }

    fn arc(&mut self, curve: &ArcCurve) -> Result<()> {
        let arc = &curve.arc;
        let (plane, radius) = (&arc.circle.plane, arc.circle.radius);
        let flat = |v: katydid_geometry::Vector3| [v.x * radius, -v.y * radius];
        let ellipse = Ellipse { center: place(plane.origin), u: flat(plane.x_axis), v: flat(plane.y_axis) };
        self.join(place(curve.point_at(curve.domain.start)))?;
        self.elliptic(&ellipse, [arc.angle.start, arc.angle.end], place(curve.point_at(curve.domain.end)))
    }

    /// From where the pen is along an ellipse, between two angles, to a given end.
    fn elliptic(&mut self, ellipse: &Ellipse, [from, to]: [f64; 2], end: Place) -> Result<()> {
        let Some(axes) = ellipse.axes() else {
            // Seen from the side it goes to and fro on a line.
            for angle in ellipse.turns(from, to) {
                self.step("L", &[ellipse.at(angle)])?;
            }
            return self.step("L", &[end]);
        };
        // In parts of a third of a turn at most: half turns would leave the centre to rounding.
        let parts = ((to - from).abs() / (2.0 * std::f64::consts::FRAC_PI_3) - 1e-9).ceil().max(1.0);
        let sweep = (to > from) == (ellipse.turn() > 0.0);
        for i in 1..=parts as u32 {
            let share = f64::from(i) / parts;
            let p = if share == 1.0 { end } else { ellipse.at(from + (to - from) * share) };
            self.text.push("A");
            self.text.real(axes.major);
            self.text.push(" ");
            self.text.real(axes.minor);
            self.text.push(" ");
            self.text.real(axes.degrees);
            self.text.push(if sweep { " 0 1 " } else { " 0 0 " });
            self.step("", &[p])?;
        }
        Ok(())
    }

    fn nurbs(&mut self, curve: &NurbsCurve, tolerance: f64) -> Result<()> {
        // Weights that are all the same are none.
        let plain = curve.to_non_rational();
        let curve = plain.as_ref().unwrap_or(curve);
        let domain = curve.domain();
        self.join(place(curve.point_at(domain.start)))?;
        let Ok(pieces) = curve.bezier_pieces() else { return Ok(()) };
        pieces.iter().try_for_each(|piece| self.bezier(piece, tolerance))
    }

    fn bezier(&mut self, piece: &NurbsCurve, tolerance: f64) -> Result<()> {
        let points: Vec<Place> = piece.control_points().into_iter().map(place).collect();
        match (piece.is_rational(), points.as_slice()) {
            (false, [_, rest @ ..]) if (1..=3).contains(&rest.len()) => {
                let letter = ["L", "Q", "C"].get(rest.len() - 1).copied().unwrap_or("L");
                return self.step(letter, rest);
            }
            // A straight line, however it runs along.
            (true, [_, end]) => return self.step("L", &[*end]),
            (true, &[a, b, c]) => {
                if let Some((ellipse, half)) = conic([a, b, c], &piece.weights()) {
                    return self.elliptic(&ellipse, [-half, half], c);
                }
            }
            _ => {}
        }
        cubics(piece, tolerance).into_iter().try_for_each(|cubic| self.step("C", &cubic))
    }
}

/// Whether two places are the same but for rounding.
fn near(a: Place, b: Place) -> bool {
    let size = a.iter().chain(&b).fold(0.0_f64, |most, x| most.max(x.abs()));
    (a[0] - b[0]).hypotenuse(a[1] - b[1]) <= 1e-9 * size
}
