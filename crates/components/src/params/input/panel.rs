//! The Panel.

use katydid_component::{Context, component};
use katydid_data::{Column, Path, Tree, Value};

/// Shows data as text. Without a wire it is a note: its own text goes out, as one text or as one text a line. Lines
/// with nothing in them are no items.
///
/// What comes over a wire is shown and handed on unchanged.
#[component("59e0b89a-e487-49f8-bab8-b5bab16be14c", name = "Panel", nick = "", at = "Params/Input", floating)]
#[output("Panel", "Panel", "The data shown.")]
fn panel(
    context: &Context<'_>,
    /// Data to show.
    #[port("Panel", "Panel", optional)]
    data: &Tree,
) -> Tree {
    let settings = context.settings();
    if settings.i32("SourceCount").is_some_and(|n| n > 0) || !data.is_empty() {
        return data.clone();
    }
    // Files of Grasshopper 0.6 keep the switch beside the text, under another name.
    let properties = settings.child("PanelProperties").and_then(|chunk| chunk.bool("Multiline"));
    let multiline = properties.or_else(|| settings.bool("MultilineData")).unwrap_or(true);
    let text = settings.str("UserText").unwrap_or_default();
    let mut items: Vec<Value> = if multiline {
        Vec::new()
    } else {
        text.lines().filter(|line| !line.is_empty()).map(Value::from).collect()
    };
    if items.is_empty() {
        items.push(Value::from(text));
    }
    Tree::branch_at(Path::zero(), Column::of_values(items, None))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::Chunk;

    fn settings(text: &str, multiline: bool) -> Chunk {
        let mut properties = Chunk::new("PanelProperties");
        properties.set("Multiline", multiline);
        let mut settings = Chunk::default();
        settings.set("UserText", text);
        settings.set_child(properties);
        settings
    }

    #[test]
    fn its_text_is_one_item_or_one_a_line() {
        let panel = |text, multiline| {
            Trial::of("Panel").settings(settings(text, multiline)).run().outputs[0].item_count()
        };
        assert_eq!((panel("a\r\nb", true), panel("a\r\nb\n\nc", false), panel("", false)), (1, 3, 1));
        assert_eq!(Trial::of("Panel").settings(settings("\r\n1\r\n2", false)).texts(0), ["{0}: 1, 2"]);
        assert_eq!((panel("\n", false), panel(" \n1\n", false)), (1, 2));
    }

    #[test]
    fn data_from_a_wire_passes_unchanged() {
        let trial = Trial::of("Panel").settings(settings("old", true)).branches([("{2;1}", [1, 2])]);
        let tree = &trial.run().outputs[0];
        assert_eq!(tree.column().kind(), katydid_data::Kind::Integer);
        assert_eq!(katydid_component::testing::texts(tree), ["{2;1}: 1, 2"]);
        assert!(Trial::of("Panel").setting("SourceCount", 1).texts(0).is_empty());
    }
}
