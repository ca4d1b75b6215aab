//! Display / Preview: symbols, ways to draw points.

use std::sync::Arc;

use katydid_component::component;
use katydid_data::{Colour, Symbol};
use katydid_geometry::Point3;

const PINK: Colour = Colour::rgb(255, 105, 180);

/// A symbol of one colour, to draw points with.
#[component(
    "79747717-1874-4c34-b790-faef53b50569",
    name = "Symbol (Simple)",
    nick = "SymSim",
    at = "Display/Preview"
)]
#[output("Symbol Display", "D", "The symbol.")]
fn symbol_simple(
    /// The shape: 0 square, 1 control point, 2 active point, 3 cross, 4 circle, 7 triangle, 8 heart and so on.
    #[port("Style", "X", default = 3)]
    style: i32,
    /// The size in pixels.
    #[port("Size", "S", default = 12.0)]
    size: f64,
    /// The turn in radians.
    #[port("Rotation", "R", default = 0.0)]
    rotation: f64,
    /// The colour.
    #[port("Colour", "C", default = PINK)]
    colour: Colour,
) -> Arc<Symbol> {
    Arc::new(Symbol { style, size: [size, size], rotation, fill: colour, edge: colour, ..Symbol::default() })
}

/// A symbol with a fill and an edge, to draw points with.
#[component(
    "e5c82975-8011-412c-b56d-bb7fc9e7f28d",
    name = "Symbol (Advanced)",
    nick = "SymAdv",
    at = "Display/Preview"
)]
#[output("Symbol Display", "D", "The symbol.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn symbol_advanced(
    /// The shape: 0 square, 1 control point, 2 active point, 3 cross, 4 circle, 7 triangle, 8 heart and so on.
    #[port("Style", "X", default = 3)]
    style: i32,
    /// The size in pixels.
    #[port("Size Primary", "S1", default = 12.0)]
    primary: f64,
    /// The size of the inner part, or its offset, where the shape has one.
    #[port("Size Secondary", "S2", default = 6.0)]
    secondary: f64,
    /// The turn in radians.
    #[port("Rotation", "R", default = 0.0)]
    rotation: f64,
    /// The colour inside.
    #[port("Fill", "Cf", default = PINK)]
    fill: Colour,
    /// The colour of the edge.
    #[port("Edge", "Ce", default = Colour::rgb(0, 0, 0))]
    edge: Colour,
    /// The width of the edge in pixels.
    #[port("Width", "W", default = 2.0)]
    width: f64,
    /// Whether the size follows the view.
    #[port("Adjust", "A", default = true)]
    adjust: bool,
) -> Arc<Symbol> {
    Arc::new(Symbol { style, size: [primary, secondary], rotation, fill, edge, width, adjust })
}

/// Draws points as symbols.
#[component(
    "62d5ead4-53c4-4d0b-b5ce-6bd6e0850ab8",
    name = "Symbol Display",
    nick = "Symbol",
    at = "Display/Preview"
)]
fn symbol_display(
    /// Where to draw.
    #[port("Location", "P")]
    _location: Point3,
    /// The symbol.
    #[port("Display", "D")]
    _display: &Symbol,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Colour, Symbol, Value};
    use katydid_geometry::Point3;

    #[test]
    fn symbols_are_data() {
        let red = Colour::rgb(255, 0, 0);
        let out = Trial::of("Symbol (Simple)").item(4).item(9.0).default().item(red).run().outputs;
        assert_eq!(texts(&out[0]), ["{0}: Symbol (4)"]);
        let wanted = Symbol { style: 4, size: [9.0, 9.0], fill: red, edge: red, ..Symbol::default() };
        assert_eq!(out[0].column().get(0), Some(Value::from(wanted)));
        let drawn = Trial::of_guid("62d5ead4-53c4-4d0b-b5ce-6bd6e0850ab8");
        let drawn = drawn.item(Point3::ORIGIN).tree(out[0].clone()).run();
        assert!(drawn.outputs.is_empty() && drawn.messages.is_empty());
        assert_eq!(Trial::of("Symbol (Advanced)").item(7).texts(0), ["{0}: Symbol (7)"]);
        let kept = Trial::of_guid("2bcd153c-c964-4199-b8e4-4a19dfd34967").tree(out[0].clone()).run();
        assert_eq!(texts(&kept.outputs[0]), ["{0}: Symbol (4)"]);
    }
}
