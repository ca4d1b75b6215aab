//! Display / Dimensions and Graphs: measures, hatches and legends drawn over the model.

use std::sync::Arc;

use katydid_component::{List, component};
use katydid_data::Colour;
use katydid_geometry::{Arc as CircularArc, Circle, Curve, Line, Mesh, Plane, Point3, Rectangle};

/// Draws the distance of two points in a plane, with arrows along it.
#[component(
    "3de3d3a0-1a1b-488c-b3d9-3fba0fdf07a8",
    name = "Aligned Dimension",
    nick = "AlignDim",
    at = "Display/Dimensions"
)]
fn aligned_dimension(
    /// The plane to draw in.
    #[port("Plane", "P", default = Plane::XY)]
    _plane: Plane,
    /// One point.
    #[port("Point A", "A")]
    _a: Point3,
    /// The other point.
    #[port("Point B", "B")]
    _b: Point3,
    /// How far beside the points the arrows lie.
    #[port("Offset", "O", default = 1.0)]
    _offset: f64,
    /// The text, `{0}` standing for the distance.
    #[port("Text", "T", default = "{0:0.00}")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the angle between the ways from one point to two others.
#[component(
    "fc6b519e-df6d-4ce1-a1f4-083f1c217c14",
    name = "Angular Dimension",
    nick = "AngleDim",
    at = "Display/Dimensions"
)]
fn angular_dimension(
    /// The point where both ways begin.
    #[port("Center", "C")]
    _center: Point3,
    /// Where one way leads.
    #[port("Point A", "A")]
    _a: Point3,
    /// Where the other way leads.
    #[port("Point B", "B")]
    _b: Point3,
    /// Whether the larger angle is meant.
    #[port("Reflex", "R", default = false)]
    _reflex: bool,
    /// The text, `{0}` standing for the angle in degrees.
    #[port("Text", "T", default = "{0:0.0}°")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the angles of all corners of a mesh.
#[component(
    "91f3bde5-26e6-432e-a5fe-a2938b2a94f9",
    name = "Angular Dimensions (Mesh)",
    nick = "AngleDimMesh",
    at = "Display/Dimensions"
)]
fn angular_dimensions_of_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    _mesh: &Mesh,
    /// The text, `{0}` standing for the angle in degrees.
    #[port("Text", "T", default = "{0:0.0}°")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
    /// The radius, as a part of the length of an edge.
    #[port("Length Factor", "F", default = 0.2)]
    _factor: f64,
    /// The least angle to draw.
    #[port("Minimum Angle", "A0", default = 0.0)]
    _minimum: f64,
    /// The greatest angle to draw.
    #[port("Maximum Angle", "A1", default = std::f64::consts::TAU)]
    _maximum: f64,
) {
}

/// Draws the angle of an arc.
#[component(
    "1bd97813-4fec-4453-9645-4ac920844f9d",
    name = "Arc Dimension",
    nick = "ArcDim",
    at = "Display/Dimensions"
)]
fn arc_dimension(
    /// The arc.
    #[port("Arc", "A")]
    _arc: CircularArc,
    /// How far outside the arc the arrows lie.
    #[port("Offset", "O", default = 1.0)]
    _offset: f64,
    /// The text, `{0}` standing for the angle in degrees.
    #[port("Text", "T", default = "{0:0.0}°")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the angle of two points seen from the centre of a circle, along the circle.
#[component(
    "7e9489e0-122d-401a-aba8-f1dae0217c40",
    name = "Circular Dimension",
    nick = "CircleDim",
    at = "Display/Dimensions"
)]
fn circular_dimension(
    /// The circle.
    #[port("Circle", "C")]
    _circle: Circle,
    /// One point.
    #[port("Point A", "A")]
    _a: Point3,
    /// The other point.
    #[port("Point B", "B")]
    _b: Point3,
    /// The text, `{0}` standing for the angle in degrees.
    #[port("Text", "T", default = "{0:0.0}°")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the length of a line.
#[component(
    "d78f026a-0109-4bcc-bf91-d08475711466",
    name = "Line Dimension",
    nick = "LineDim",
    at = "Display/Dimensions"
)]
fn line_dimension(
    /// The line.
    #[port("Line", "L")]
    _line: Line,
    /// The text, `{0}` standing for the length.
    #[port("Text", "T", default = "{0:0.00}")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the distance of two points along the direction of a line.
#[component(
    "5018bf8d-8566-4917-a6e3-5a623bda8079",
    name = "Linear Dimension",
    nick = "LinearDim",
    at = "Display/Dimensions"
)]
fn linear_dimension(
    /// The line to draw on.
    #[port("Line", "L")]
    _line: Line,
    /// One point.
    #[port("Point A", "A")]
    _a: Point3,
    /// The other point.
    #[port("Point B", "B")]
    _b: Point3,
    /// The text, `{0}` standing for the distance.
    #[port("Text", "T", default = "{0:0.00}")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws a text at the end of a line.
#[component(
    "c5208969-16f9-48af-8a86-e500c033fb76",
    name = "Marker Dimension",
    nick = "MarkDim",
    at = "Display/Dimensions"
)]
fn marker_dimension(
    /// The line.
    #[port("Line", "L")]
    _line: Line,
    /// The text.
    #[port("Text", "T")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws the distances of points from the first of them, along the direction of a line.
#[component(
    "7dd42002-75bb-4f41-857f-472a140b3b28",
    name = "Serial Dimension",
    nick = "SerialDim",
    at = "Display/Dimensions"
)]
fn serial_dimension(
    /// The line to draw on.
    #[port("Line", "L")]
    _line: Line,
    /// The points.
    #[port("Points", "P")]
    _points: List<Point3>,
    /// The text, `{0}` standing for the distance.
    #[port("Text", "T", default = "{0:0.00}")]
    _text: Arc<str>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws a blend of two colours inside closed curves.
#[component(
    "6ce90407-9eac-4a1a-a81a-949b601f18f3",
    name = "Gradient Hatch",
    nick = "GHatch",
    at = "Display/Dimensions"
)]
fn gradient_hatch(
    /// The outlines.
    #[port("Boundaries", "B")]
    _boundaries: List<Arc<Curve>>,
    /// The way from the first colour to the second.
    #[port("Axis", "A")]
    _axis: Line,
    /// The colour at the start of the axis.
    #[port("Colour 1", "C1", default = Colour::rgb(255, 255, 255))]
    _first: Colour,
    /// The colour at its end.
    #[port("Colour 2", "C2", default = Colour::rgb(0, 0, 0))]
    _second: Colour,
) {
}

/// Draws a pattern of lines inside closed curves.
#[component(
    "5f9e4549-8135-4a90-97c8-8a34bf05e99a",
    name = "Pattern Hatch",
    nick = "PHatch",
    at = "Display/Dimensions"
)]
fn pattern_hatch(
    /// The outlines.
    #[port("Boundaries", "B")]
    _boundaries: List<Arc<Curve>>,
    /// The number of the pattern.
    #[port("Pattern", "P", default = 0)]
    _pattern: i32,
    /// The scale of the pattern.
    #[port("Scale", "S", default = 1.0)]
    _scale: f64,
    /// The turn of the pattern in radians.
    #[port("Angle", "A", default = 0.0)]
    _angle: f64,
) {
}

/// Draws colours with a text beside each.
#[component("f6867cdd-2216-4451-9134-7da94bdcd5af", name = "Legend", nick = "Legend", at = "Display/Graphs")]
fn legend(
    /// The colours.
    #[port("Colour", "C", optional)]
    _colours: List<Colour>,
    /// The texts.
    #[port("Tags", "T", optional)]
    _tags: List<Arc<str>>,
    /// Where to draw; in a corner of the view when nothing is given.
    #[port("Rectangle", "R", optional)]
    _rectangle: Option<Rectangle>,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Line, Plane, Point3};

    #[test]
    fn drawing_gives_no_data() {
        let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let line = || Line::new(a, b);
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        for trial in [
            Trial::of("Aligned Dimension").default().item(a).item(b),
            Trial::of("Angular Dimension").item(a).item(b).item(b),
            Trial::of("Angular Dimensions (Mesh)").list::<f64>([]),
            Trial::of("Arc Dimension").item(circle),
            Trial::of("Circular Dimension").item(circle).item(a).item(b),
            Trial::of("Line Dimension").item(line()),
            Trial::of("Linear Dimension").item(line()).item(a).item(b),
            Trial::of("Marker Dimension").item(line()).item("x"),
            Trial::of("Serial Dimension").item(line()).list([a, b]),
            Trial::of("Gradient Hatch").item(circle).item(line()),
            Trial::of("Pattern Hatch").item(circle),
            Trial::of("Legend").item("1,2,3").item("x"),
        ] {
            let out = trial.run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{:?}", out.messages);
        }
    }
}
