//! Objects of which nothing tells what they do, as we read their names and ports.

use katydid_component::{Context, Each, ManyItems, Message, component};
use katydid_data::Tree;
use katydid_geometry::Interval;

parameters! {
    /// Which coordinates Points to Numbers takes, and in which order, such as `XYZ`; as texts.
    coordinate_mask, "bc26bf46-e81b-429a-b168-16d50cc89bd7", "Coordinate Mask", "CMask", "Vector/Point", Text;

    /// Formulas, as texts. What this parameter does with them beyond is not documented.
    expression, "bc6c097c-6cc2-479c-b5aa-af99fbb72b88", "Expression", "Exp", "Params/Util", Text;

    /// Data of any type, unchanged. What a signal of this parameter does is not documented.
    marshalling_signal, "4018985c-f9e8-4a8f-8d4d-518aec276f60", "Marshalling signal parameter", "Data",
        "Params/Primitive", Generic;

    /// A variable of a script: data of any type, unchanged. What else it does is not documented.
    variable, "84fa917c-1ed8-4db3-8be1-7bdc4a6495a2", "Variable", "var", "Maths/Script", Generic;
}

/// A picture on the canvas. What it hands on is not documented: here it has no data, and a remark says so.
#[component("216bccd8-bf29-4d3c-b791-54c89a180db3", name = "Image Resource", nick = "", at = "Params/Input")]
fn image_resource(context: &Context<'_>) {
    context.tell(Message::remark("What an Image Resource hands on is not documented: it has no data here"));
}

/// Numbers that run through their domains while time passes.
///
/// Where the time stands is not documented: here each number is the start of its domain, and a remark says so.
#[component(
    "33eb59b9-5f81-4ef5-8c89-46e6e744522b",
    name = "Timeline",
    nick = "Timeline",
    at = "Params/Special"
)]
#[output("A", "A", "The number as of now.")]
fn timeline(
    context: &Context<'_>,
    /// From where to where the number runs.
    #[port("A", "A")]
    domains: ManyItems<Interval>,
) -> Each<Option<f64>> {
    context.tell(Message::remark(
        "Where a Timeline stands is not documented: each number is the start of its domain",
    ));
    Each(domains.into_iter().map(|domain| domain.map(|domain| domain.start)).collect())
}

/// Fails, to test what becomes of the rest.
///
/// In Grasshopper it takes the program down. Here it is an error on this object alone, by design, and the rest of the
/// definition goes on.
#[component(
    "f3c769fd-aa9b-4695-a1ce-3ad4c53d1440",
    name = "Test Crash",
    nick = "Test Crash",
    at = "Display/Test"
)]
fn test_crash(
    context: &Context<'_>,
    /// Whether to fail.
    #[port("Crash", "C", default = false)]
    crash: bool,
) {
    if crash {
        context.tell(Message::error("This object fails by design: it is a test, and the rest goes on"));
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::Interval;

    #[test]
    fn parameters_hand_on() {
        for name in ["Coordinate Mask", "Marshalling signal parameter", "Variable"] {
            assert_eq!(Trial::of(name).list(["a", "b"]).texts(0), ["{0}: a, b"], "{name}");
        }
    }

    #[test]
    fn a_timeline_stands_at_its_start() {
        let out = Trial::of("Timeline")
            .item(Interval::new(3.0, 9.0))
            .item(Interval::new(-1.0, 1.0))
            .outputs(2)
            .run();
        let shown: Vec<String> = out.outputs.iter().flat_map(texts).collect();
        assert_eq!(shown, ["{0}: 3", "{0}: -1"]);
        assert!(out.messages[0].text.contains("not documented"));
    }

    #[test]
    fn a_crash_is_a_message() {
        assert!(Trial::of("Test Crash").item(true).message().contains("by design"));
        assert!(Trial::of("Test Crash").item(false).run().messages.is_empty());
        assert!(Trial::of("Image Resource").message().contains("not documented"));
    }
}
