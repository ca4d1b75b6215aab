//! Display / Vector.

use katydid_component::{List, component};
use katydid_data::Colour;
use katydid_geometry::{Point3, Vector3};

/// Draws the number of each point in its list beside it.
#[component(
    "cc14daa5-911a-4fcc-8b3b-1149bf7f2eeb",
    name = "Point List",
    nick = "Points",
    at = "Display/Vector"
)]
fn point_list(
    /// The points.
    #[port("Points", "P", optional)]
    _points: List<Point3>,
    /// The size of the numbers.
    #[port("Size", "S")]
    _size: Option<f64>,
) {
}

/// Draws the number of each point in its list beside it. An early form of the component of the same name.
#[component(
    "1f18e802-4ab9-444f-bf3c-3e7e421a2acf",
    name = "Point List",
    nick = "Points",
    at = "Display/Vector",
    old
)]
fn early_point_list(
    /// The points.
    #[port("Points", "Points", optional)]
    _points: List<Point3>,
    /// Whether to draw the numbers.
    #[port("Tags", "Tags", default = true)]
    _tags: bool,
    /// Whether to draw lines from point to point.
    #[port("Lines", "Lines", default = true)]
    _lines: bool,
    /// The size of the numbers.
    #[port("Size", "Size", default = 1.5)]
    _size: Option<f64>,
) {
}

/// Draws arrows from point to point in the order of a list.
#[component(
    "0ad9f1ab-2204-45bb-b282-474469e2fa7b",
    name = "Point Order",
    nick = "Order",
    at = "Display/Vector"
)]
fn point_order(
    /// The points.
    #[port("Points", "P", optional)]
    _points: List<Point3>,
) {
}

/// Draws vectors as arrows.
#[component(
    "2a3f7078-2e25-4dd4-96f7-0efb491bd61c",
    name = "Vector Display",
    nick = "VDis",
    at = "Display/Vector"
)]
fn vector_display(
    /// Where the arrow begins.
    #[port("Anchor", "A")]
    _anchor: Option<Point3>,
    /// The vector.
    #[port("Vector", "V")]
    _vector: Option<Vector3>,
) {
}

/// Draws vectors as arrows of any colour and width.
#[component(
    "11e95a7b-1e2c-4b66-bd95-fcad51f8662a",
    name = "Vector Display Ex",
    nick = "VDisEx",
    at = "Display/Vector"
)]
fn vector_display_ex(
    /// Where the arrow begins.
    #[port("Point", "P")]
    _point: Option<Point3>,
    /// The vector.
    #[port("Vector", "V")]
    _vector: Option<Vector3>,
    /// The colour of the arrow.
    #[port("Colour", "C", default = Colour::rgb(0, 0, 0))]
    _colour: Option<Colour>,
    /// The width of the arrow in pixels.
    #[port("Width", "W", default = 2)]
    _width: Option<i32>,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Point3;

    #[test]
    fn drawing_gives_no_data() {
        for name in ["Point List", "Point Order", "Vector Display", "Vector Display Ex"] {
            let out = Trial::of(name).list([Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]).run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{name}");
        }
        assert_eq!(katydid_component::registry::by_name("Point List").unwrap().inputs.len(), 2);
    }
}
