//! What is written and drawn over the view. There is no screen of Rhino here: all of it is drawn in the model, at its location.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Value};
use katydid_geometry::{Curve, Mesh, Plane, Point3};

/// What is drawn in where nothing is given; the plug-in's own colour is not known.
const BLACK: Colour = Colour::rgb(0, 0, 0);
/// The same for meshes.
const GREY: Colour = Colour::rgb(150, 150, 150);

/// What is drawn at a location: a component without outputs.
macro_rules! to_screen {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        $port:literal, $short:literal, $thing:ty, $(#[$told:meta])* colour: $colour:expr,
        [$($(#[$($attribute:tt)*])+ $size:ident: $kind:ty)?]
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Human/Display")]
        fn $function(
            /// What to draw, near the world's origin.
            #[port($port, $short)]
            _thing: $thing,
            /// Where it is drawn.
            #[port("Location", "L", default = Point3::ORIGIN)]
            _location: Point3,
            /// What its size is multiplied by.
            #[port("Scale Factor", "S", default = 1.0)]
            _scale: f64,
            $(#[$told])*
            #[port("Color", "C", default = $colour)]
            _colour: Colour,
            $($(#[$($attribute)*])+ $size: $kind,)?
            /// How far in front it is; not supported.
            #[port("Depth", "D", default = 0.5)]
            _depth: f64,
            /// Whether it keeps its direction on the screen; not supported.
            #[port("Fixed", "F", default = true)]
            _fixed: bool,
        ) {
        }
    };
}

to_screen!(
    /// Draws a curve, made larger about the origin and moved to a location. Stands for Human's Render Curve to Screen, which draws at a
    /// place of the screen: here the location is one in the model.
    curve_to_screen, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd341", "Render Curve to Screen", "CrvToScreen",
    "Curve", "Crv", Shared<Curve>,
    /// The colour.
    colour: BLACK,
    [
        /// The width of the line, in pixels.
        #[port("Thickness", "T", default = 1)]
        _size: i32
    ]
);

to_screen!(
    /// Draws a point, moved to a location. Stands for Human's Render Point to Screen, which draws at a place of the screen: here the
    /// location is one in the model.
    point_to_screen, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd342", "Render Point to Screen", "PtToScreen",
    "Point", "P", Point3,
    /// The colour.
    colour: BLACK,
    [
        /// The size on the screen; not supported.
        #[port("Radius", "R", default = 1)]
        _size: i32
    ]
);

to_screen!(
    /// Draws a mesh, made larger about the origin and moved to a location. Stands for Human's Render Mesh to Screen, which draws at a place
    /// of the screen: here the location is one in the model.
    mesh_to_screen, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd343", "Render Mesh to Screen", "MeshToScreen",
    "Mesh", "M", Shared<Mesh>,
    /// The colour, where the mesh has none of its own.
    colour: GREY,
    []
);

/// Draws a mesh, made larger about the origin and moved to a location. Stands for Human's Screen-Oriented Mesh, which turns it with the
/// view: here it keeps its directions in the model. Sizes on the screen and pictures on the mesh are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd347",
    name = "Screen-Oriented Mesh",
    nick = "ScreenMesh",
    at = "Human/Display"
)]
fn screen_oriented_mesh(
    context: &Context<'_>,
    /// What to draw, near the world's origin.
    #[port("Mesh", "M")]
    _mesh: Shared<Mesh>,
    /// Where it is drawn.
    #[port("Location", "L", default = Point3::ORIGIN)]
    _location: Point3,
    /// What its size is multiplied by.
    #[port("Size Factor", "S", default = 1.0)]
    _scale: f64,
    /// The colour, where the mesh has none of its own.
    #[port("Color", "C", default = GREY)]
    _colour: Colour,
    /// How far in front it is; not supported.
    #[port("Depth", "D", optional)]
    _depth: Option<f64>,
    /// Whether the size is one in the model, as it always is here.
    #[port("Absolute", "A", default = true)]
    _absolute: bool,
    /// A picture on the mesh; not supported.
    #[port("Bitmap Texture", "T", optional)]
    picture: Option<Shared<str>>,
) {
    if picture.is_some() {
        context.tell(Message::remark("Pictures on meshes are not supported: it has its colour only"));
    }
}

/// Writes a text that faces the viewer. Stands for Human's Render Text to Screen, which writes at a place of the screen: here the
/// location is one in the model. Fonts are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd344",
    name = "Render Text to Screen",
    nick = "TextToScreen",
    at = "Human/Display"
)]
fn text_to_screen(
    /// The text.
    #[port("Text", "T")]
    _text: Shared<str>,
    /// Where it is written.
    #[port("Location", "L", default = Point3::ORIGIN)]
    _location: Point3,
    /// The height in pixels.
    #[port("Size", "S", default = 20.0)]
    _size: f64,
    /// The colour.
    #[port("Color", "C", default = BLACK)]
    _colour: Colour,
    /// Not supported.
    #[port("Font", "F", optional)]
    _font: Option<Shared<str>>,
) {
}

/// Writes a text that faces the viewer, 12 pixels high times a factor, which is our reading. Stands for Human's Screen-Oriented Text;
/// fonts, justification, depth and sizes in the model are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd345",
    name = "Screen-Oriented Text",
    nick = "ScreenText",
    at = "Human/Display"
)]
fn screen_oriented_text(
    /// The text.
    #[port("Text", "T")]
    _text: Shared<str>,
    /// Not supported.
    #[port("Font", "F", optional)]
    _font: Option<Shared<str>>,
    /// Not supported.
    #[port("Justification", "J", optional)]
    _justification: Option<i32>,
    /// Where it is written.
    #[port("Location", "L", default = Point3::ORIGIN)]
    _location: Point3,
    /// What the height is multiplied by.
    #[port("Size Factor", "S", default = 1.0)]
    _size: f64,
    /// The colour.
    #[port("Color", "C", default = BLACK)]
    _colour: Colour,
    /// How far in front it is; not supported.
    #[port("Depth", "D", optional)]
    _depth: Option<f64>,
    /// Whether the size is one in the model; not supported.
    #[port("Absolute", "A", default = false)]
    _absolute: bool,
) {
}

/// Writes a text on a plane. Stands for Human's JustifiedText3d; fonts and meshes are not supported, and texts are not baked.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd346",
    name = "JustifiedText3d",
    nick = "Justified Text",
    at = "Human/Creation"
)]
fn justified_text(
    context: &Context<'_>,
    /// The plane: along its x axis, letters upright along y.
    #[port("Location", "L")]
    _location: Plane,
    /// The text.
    #[port("Text", "T")]
    _text: Shared<str>,
    /// The height of a letter in units of the model.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
    /// The colour.
    #[port("Color", "C", default = BLACK)]
    _colour: Colour,
    /// 0 begins at the plane's origin, 1 has its middle there, 2 its end.
    #[port("Horizontal Alignment", "A", default = 0)]
    _across: i32,
    /// 0 stands on the plane's origin, 1 has its middle there, 2 hangs from it.
    #[port("Vertical Alginment", "VA", default = 0)]
    _up: i32,
    /// Not supported.
    #[port("Font", "F", optional)]
    _font: Option<Shared<str>>,
    /// Not supported.
    #[port("Use Meshes", "M", default = false)]
    _meshes: bool,
    /// Not used: texts are not baked.
    #[port("Attributes", "att", optional)]
    _attributes: Option<Value>,
    /// Whether to bake, which is not supported.
    #[port("Bake", "B", default = false)]
    bake: bool,
) {
    if bake {
        context.tell(Message::remark("The text is not baked: it is only shown"));
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Plane;

    #[test]
    fn what_is_drawn_gives_no_data() {
        let names = ["Render Point to Screen", "Render Text to Screen", "Screen-Oriented Text"];
        for name in names {
            let out = Trial::of(name).item("{1, 2, 3}").run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{name}");
        }
    }

    #[test]
    fn a_mesh_is_drawn_without_pictures() {
        let mesh = katydid_geometry::Mesh::new(vec![katydid_geometry::Point3::ORIGIN], Vec::new()).unwrap();
        let trial = || Trial::of("Screen-Oriented Mesh").item(mesh.clone());
        let out = trial().run();
        assert!(out.outputs.is_empty() && out.messages.is_empty());
        let trial = trial().default().default().default().default().default();
        assert!(trial.item("brick.png").message().starts_with("Pictures on meshes are not supported"));
    }

    #[test]
    fn texts_are_not_baked() {
        let text = |bake: bool| {
            let trial = Trial::of("JustifiedText3d").item(Plane::XY).item("door");
            let trial = trial.default().default().default().default().default().default().default();
            trial.item(bake).message()
        };
        assert_eq!(text(true), "The text is not baked: it is only shown");
        assert_eq!(text(false), "");
    }
}
