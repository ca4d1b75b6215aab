//! The centres of a triangle.

use katydid_component::{Message, component};
use katydid_geometry::{Line, Point3, Vector3};

/// The triangle's normal, as long as twice its area.
fn normal(a: Point3, b: Point3, c: Point3) -> Result<Vector3, Message> {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    // Corners nearer to a line than this part of their distance leave no digits for a centre.
    if normal.length() > 1e-12 * ab.length() * ac.length() {
        return Ok(normal);
    }
    Err(Message::error("The points lie on a line: they make no triangle"))
}

fn middle(a: Point3, b: Point3) -> Point3 {
    a.lerp(b, 0.5)
}

/// The centre of the circle through the corners.
fn around(a: Point3, b: Point3, c: Point3) -> Result<Point3, Message> {
    let n = normal(a, b, c)?;
    let (ab, ac) = (b - a, c - a);
    let sum = n.cross(ab) * ac.length_squared() + ac.cross(n) * ab.length_squared();
    Ok(a + sum / (2.0 * n.length_squared()))
}

/// The point where the medians of a triangle meet: its centre of gravity.
#[component("afbcbad4-2a2a-4954-8040-d999e316d2bd", name = "Centroid", nick = "Centroid", at = "Maths/Trig")]
#[output("Centroid", "C", "The centre of gravity.")]
#[output("Median AB", "AB", "From C to the middle of AB.")]
#[output("Median BC", "BC", "From A to the middle of BC.")]
#[output("Median CA", "CA", "From B to the middle of CA.")]
fn centroid(
    /// A corner.
    #[port("Point A", "A")]
    a: Point3,
    /// A corner.
    #[port("Point B", "B")]
    b: Point3,
    /// A corner.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Point3, Line, Line, Line), Message> {
    normal(a, b, c)?;
    let centre = a + ((b - a) + (c - a)) / 3.0;
    Ok((centre, Line::new(c, middle(a, b)), Line::new(a, middle(b, c)), Line::new(b, middle(c, a))))
}

/// The centre of the circle through the corners of a triangle.
#[component(
    "21d0767c-5340-4087-aa09-398d0e706908",
    name = "Circumcentre",
    nick = "CCentre",
    at = "Maths/Trig"
)]
#[output("Circumcentre", "C", "The centre of the circle.")]
#[output("Bisector AB", "AB", "From the middle of AB to the centre.")]
#[output("Bisector BC", "BC", "From the middle of BC to the centre.")]
#[output("Bisector CA", "CA", "From the middle of CA to the centre.")]
fn circumcentre(
    /// A corner.
    #[port("Point A", "A")]
    a: Point3,
    /// A corner.
    #[port("Point B", "B")]
    b: Point3,
    /// A corner.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Point3, Line, Line, Line), Message> {
    let centre = around(a, b, c)?;
    let to = |side: Point3| Line::new(side, centre);
    Ok((centre, to(middle(a, b)), to(middle(b, c)), to(middle(c, a))))
}

/// The centre of the circle inside a triangle that touches its sides.
#[component("c3342ea2-e181-46aa-a9b9-e438ccbfb831", name = "Incentre", nick = "ICentre", at = "Maths/Trig")]
#[output("Incentre", "I", "The centre of the circle.")]
#[output("Bisector A", "A", "From A to the centre.")]
#[output("Bisector B", "B", "From B to the centre.")]
#[output("Bisector C", "C", "From C to the centre.")]
fn incentre(
    /// A corner.
    #[port("Point A", "A")]
    a: Point3,
    /// A corner.
    #[port("Point B", "B")]
    b: Point3,
    /// A corner.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Point3, Line, Line, Line), Message> {
    normal(a, b, c)?;
    // Each corner weighs as much as the side opposite to it is long.
    let (wa, wb, wc) = (b.distance_to(c), c.distance_to(a), a.distance_to(b));
    let centre = a + ((b - a) * wb + (c - a) * wc) / (wa + wb + wc);
    Ok((centre, Line::new(a, centre), Line::new(b, centre), Line::new(c, centre)))
}

/// The point where the heights of a triangle meet.
#[component(
    "36dd5551-b6bd-4246-bd2f-1fd91eb2f02d",
    name = "Orthocentre",
    nick = "OCentre",
    at = "Maths/Trig"
)]
#[output("Orthocentre", "C", "The point where the heights meet.")]
#[output("Altitude AB", "AB", "From C square to the line AB.")]
#[output("Altitude BC", "BC", "From A square to the line BC.")]
#[output("Altitude CA", "CA", "From B square to the line CA.")]
fn orthocentre(
    /// A corner.
    #[port("Point A", "A")]
    a: Point3,
    /// A corner.
    #[port("Point B", "B")]
    b: Point3,
    /// A corner.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Point3, Line, Line, Line), Message> {
    let o = around(a, b, c)?;
    let centre = o + ((a - o) + (b - o) + (c - o));
    let height = |from: Point3, side: Line| Line::new(from, side.at(side.closest_parameter(from)));
    Ok((centre, height(c, Line::new(a, b)), height(a, Line::new(b, c)), height(b, Line::new(c, a))))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Point3;

    fn centre(name: &str, points: [[f64; 2]; 3]) -> String {
        let points = points.map(|[x, y]| Point3::new(x, y, 0.0));
        let trial = Trial::of(name).item(points[0]).item(points[1]).item(points[2]);
        let out = trial.run();
        match out.messages.first() {
            Some(message) => message.text.clone(),
            None => katydid_component::testing::texts(&out.outputs[0]).concat(),
        }
    }

    #[test]
    fn centres_of_the_triangle_of_three_four_five() {
        let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        assert_eq!(centre("Centroid", triangle), "{0}: {1.333333, 1, 0}");
        assert_eq!(centre("Circumcentre", triangle), "{0}: {2, 1.5, 0}");
        assert_eq!(centre("Incentre", triangle), "{0}: {1, 1, 0}");
        assert_eq!(centre("Orthocentre", triangle), "{0}: {0, 0, 0}");
        for name in ["Centroid", "Circumcentre", "Incentre", "Orthocentre"] {
            assert!(centre(name, [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).contains("on a line"), "{name}");
        }
    }

    #[test]
    fn helper_lines() {
        let out = Trial::of("Orthocentre")
            .item(Point3::new(0.0, 0.0, 0.0))
            .item(Point3::new(10.0, 0.0, 0.0))
            .item(Point3::new(3.0, 5.0, 0.0));
        assert_eq!(out.texts(1), ["{0}: Line(L:5.00 mm)"]);
    }
}
