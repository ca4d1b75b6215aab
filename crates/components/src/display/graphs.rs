//! Display / Graphs: data as charts on the canvas. Each hands its data on; the canvas draws it.

use katydid_component::{Context, Message, component};
use katydid_data::Tree;

/// Says what is our own reading of an object that is not documented.
fn reading(context: &Context<'_>, text: &str) {
    context.tell(Message::remark(text));
}

/// Shows numbers as a graph, and hands them on.
#[component(
    "2b69bf71-4e69-43aa-b7be-4f6ce7e45bef",
    name = "Quick Graph",
    nick = "Graph",
    at = "Display/Graphs",
    floating
)]
#[output("Graph", "Graph", "The numbers.", kind = Number)]
fn quick_graph(
    /// The numbers.
    #[port("Graph", "Graph", optional, kind = Number)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// Shows numbers as bars, and hands them on.
///
/// Each number is a bar, from zero up or down; each branch has a colour of its own.
#[component(
    "e1905a16-da43-4705-bd65-41d34328c4e6",
    name = "Bar Graph",
    nick = "Bar Graph",
    at = "Display/Graphs",
    floating
)]
#[output("Bar Graph", "Bar Graph", "The numbers.", kind = Number)]
fn bar_graph(
    /// The numbers.
    #[port("Bar Graph", "Bar Graph", optional, kind = Number)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// Shows data as the sectors of a circle, and hands it on.
///
/// The sector of a number is as large as the number is, whatever its sign. Data of other types has a sector for all items
/// that read the same, as large as there are many of them. Which of both Grasshopper does is not documented.
#[component(
    "952c2bcc-b5ec-480a-a0d7-27f016632e33",
    name = "Pie Chart",
    nick = "Pie",
    at = "Display/Graphs",
    floating
)]
#[output("Pie Chart", "Pie", "The data.", kind = Generic)]
fn pie_chart(
    context: &Context<'_>,
    /// Numbers, or data to be counted.
    #[port("Pie Chart", "Pie", optional, kind = Generic)]
    data: &Tree,
) -> Tree {
    reading(
        context,
        "What the sectors stand for is not documented: numbers have theirs by size, all else by count",
    );
    data.clone()
}

/// Follows numbers from solution to solution, and hands them on.
///
/// Each branch is a line of its numbers, with the last one in figures: in a run in time (`--ticks`) of those of all
/// solutions, the newest 10,000, else of this one.
#[component(
    "615367b4-c9d0-4cb7-986c-cb861226136f",
    name = "Value Tracker",
    nick = "Tracker",
    at = "Display/Graphs",
    floating
)]
#[output("Value Tracker", "Tracker", "The numbers.", kind = Number)]
fn value_tracker(
    /// The numbers to follow.
    #[port("Value Tracker", "Tracker", optional, kind = Number)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// Shows pictures on the canvas, and hands them on.
///
/// Coloured meshes, which Import Image gives, are seen from above, colours fill a frame, and paths of pictures (PNG, JPEG,
/// BMP, GIF) show them small in the studio, as far as the definition may read files. Of anything else the frame has the
/// name, and so it has of files in pictures of the canvas.
#[component(
    "54ab3f01-a769-4742-a7bf-cec48a1acb6f",
    name = "Image Gallery",
    nick = "Gallery",
    at = "Display/Graphs",
    floating
)]
#[output("Image Gallery", "Gallery", "The data.", kind = Generic)]
fn image_gallery(
    context: &Context<'_>,
    /// Coloured meshes, colours or the paths of pictures.
    #[port("Image Gallery", "Gallery", optional, kind = Generic)]
    data: &Tree,
) -> Tree {
    reading(
        context,
        "What data it takes is not documented: pictures, meshes and colours are shown, of all else the name",
    );
    data.clone()
}

/// Shows the model in a window on the canvas.
///
/// Pictures of the canvas have the window below the component, with what the definition makes, seen as in pictures of
/// the result. Left and top, places on a screen, mean nothing there.
#[component(
    "b78d95bc-dffb-414c-b177-c611c92580b9",
    name = "Viewport Display",
    nick = "Viewport Display",
    at = "Display/Viewport"
)]
fn viewport_display(
    context: &Context<'_>,
    /// Whether the window is shown.
    #[port("Visible", "V", default = true)]
    _visible: bool,
    /// How far from the left of the screen, in pixels.
    #[port("Left", "L", default = 0)]
    _left: i32,
    /// How far from its top, in pixels.
    #[port("Top", "T", default = 0)]
    _top: i32,
    /// How wide the window is, in pixels; 40 to 1200.
    #[port("Width", "W", default = 300)]
    _width: i32,
    /// How high it is, in pixels; 40 to 1200.
    #[port("Height", "H", default = 200)]
    _height: i32,
) {
    reading(
        context,
        "Where the window stands is not documented: pictures of the canvas have it below the component",
    );
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};

    #[test]
    fn data_passes() {
        for name in ["Quick Graph", "Bar Graph", "Value Tracker", "Pie Chart"] {
            assert_eq!(Trial::of(name).list([1.5, 2.0]).texts(0), ["{0}: 1.5, 2"], "{name}");
        }
        assert_eq!(Trial::of("Image Gallery").item("a.png").texts(0), ["{0}: a.png"]);
        let remark = |name: &str| Trial::of(name).message();
        assert!(remark("Pie Chart").contains("not documented") && remark("Bar Graph").is_empty());
        let shown = Trial::of("Viewport Display").run();
        assert!(shown.outputs.is_empty() && shown.outputs.iter().flat_map(texts).count() == 0);
    }
}
