//! Params / Util: objects of the canvas that take no part in a solution.

use katydid_component::{Context, ManyTrees, component};
use katydid_data::Tree;

parameters! {
    /// Data of any type, unchanged. An early form of the data parameter.
    variant, "ba80fd98-91a1-4958-b6a7-a94e40e52bdb", "Variant", "Var", "Params/Util", Generic;

    /// Data of any type, unchanged.
    suirify, "5d4e1eeb-482e-42a7-aa2f-e5deb8a1018e", "Suirify", "Suirify", "Params/Util", Generic;
}

/// Varies sliders to make a number as large or small as it can be, when its user starts it. A single solution takes no
/// notice of it.
#[component(
    "e6dd2904-14bc-455b-8376-948bf2e3a7bc",
    name = "Galapagos",
    nick = "Galapagos",
    at = "Params/Util"
)]
fn galapagos() {}

/// Leads the eye from one place of the canvas to another. It has no data.
#[component("86720a45-ee9e-49d6-b65e-494c06f66e59", name = "Jump", nick = "", at = "Params/Util")]
fn jump() {}

/// A picture on the canvas. It has no data.
#[component("bbb4de00-6316-46f5-bf18-b8b8a61092d7", name = "Oh noes!", nick = "LolCat", at = "Params/Util")]
fn oh_noes() {}

/// A note on the canvas. It has no data.
#[component(
    "5dcad41a-2cc6-4f24-a0e2-fbe949e0a7ee",
    name = "Text Balloon",
    nick = "Balloon",
    at = "Params/Util"
)]
fn text_balloon() {}

/// Hands data to other definitions through a file. Nothing is written here: the component says so and takes its data
/// in.
#[component(
    "dcd23728-8e0e-4241-94b3-7cc3985031dd",
    name = "Data Output",
    nick = "Output",
    at = "Params/Util"
)]
fn data_output(
    context: &Context<'_>,
    /// The data to hand over.
    #[port("Data Input", "A", optional)]
    data: ManyTrees<'_>,
) {
    if data.iter().any(|tree| !tree.is_empty()) {
        context.warn("The data is not written to a file");
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn they_do_nothing() {
        for name in ["Galapagos", "Jump", "Oh noes!", "Text Balloon"] {
            let out = Trial::of(name).run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{name}");
        }
        for name in ["Variant", "Suirify", "Constant", "Mesher Settings", "Mesh Point"] {
            assert_eq!(Trial::of(name).branches([("{2}", [1.5])]).texts(0), ["{2}: 1.5"], "{name}");
        }
        assert_eq!(Trial::of("Geometry Cache").item("1,2,3").texts(0), ["{0}: {1, 2, 3}"]);
        assert_eq!(Trial::of("Location").item("13.4, 52.5").texts(0), ["{0}: 52.5° N, 13.4° E"]);
        assert_eq!(Trial::of("Location").item("13.4, 152.5").texts(0), ["{0}: null"]);
        assert_eq!(Trial::of("Data Output").item(1).item("a").message(), "The data is not written to a file");
        assert!(Trial::of("Data Output").run().messages.is_empty());
    }
}
