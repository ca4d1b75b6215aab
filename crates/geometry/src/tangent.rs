//! Lines that touch circles.

use katydid_elementary::Elementary;

use crate::{Circle, Line, Point3};

impl Circle {
    /// The two lines from a point, projected into the circle's plane, to where they touch the circle: first the one
    /// that touches on the left of the way to the centre. `None` for a point inside.
    pub fn tangents_from(&self, p: Point3) -> Option<[Line; 2]> {
        let [x, y, _] = self.plane.coordinates(p);
        let distance = x.hypotenuse(y);
        if !(distance > self.radius) {
            return None;
        }
        let (toward, half) = (y.arctangent_of(x), (self.radius / distance).arccosine());
        let from = self.plane.at(x, y, 0.0);
        // Seen on the way to the centre, smaller angles about it lie to the left.
        Some([Line::new(from, self.at(toward - half)), Line::new(from, self.at(toward + half))])
    }

    /// The two lines that touch this circle and another, both on the same side: from here to there, first the one on
    /// the left of the way between the centres. The other circle is taken as projected into this one's plane. `None`
    /// when one circle lies inside the other.
    pub fn outer_tangents(&self, other: &Self) -> Option<[Line; 2]> {
        self.common_tangents(other, self.radius - other.radius, other.radius)
    }

    /// The two lines that touch this circle and another on opposite sides, from here to there: they cross between the
    /// circles. First the one that leaves on the left. `None` when the circles meet.
    pub fn inner_tangents(&self, other: &Self) -> Option<[Line; 2]> {
        self.common_tangents(other, self.radius + other.radius, -other.radius)
    }

    /// Both kinds: the touching points lie at the same angle on both circles, or opposite (a negative radius there).
    fn common_tangents(&self, other: &Self, reach: f64, radius: f64) -> Option<[Line; 2]> {
        let [x, y, _] = self.plane.coordinates(other.center());
        let distance = x.hypotenuse(y);
        if !(distance > reach.abs()) {
            return None;
        }
        let (toward, half) = (y.arctangent_of(x), (reach / distance).arccosine());
        let line = |angle: f64| {
            let (sin, cos) = angle.sine_cosine();
            Line::new(self.at(angle), self.plane.at(x + radius * cos, y + radius * sin, 0.0))
        };
        Some([line(toward + half), line(toward - half)])
    }
}
