//! Toggles, buttons and lists to choose from.

use katydid_component::{Context, Message, component};
use katydid_data::{Tree, Value};
use katydid_definition::archive::Chunk;

use crate::maths::formula;

/// A switch: true or false.
#[component(
    "2e78987b-9dfb-42a2-8b76-3923ac8bd91a",
    name = "Boolean Toggle",
    nick = "Toggle",
    at = "Params/Input",
    also("ad483f40-dc72-40dc-844d-c9e462c7d19f"),
    floating
)]
#[output("Toggle", "Toggle", "The state of the switch.")]
fn boolean_toggle(
    context: &Context<'_>,
    /// Not used: the state is stored in the switch.
    #[port("Toggle", "Toggle", optional, kind = Boolean)]
    _data: &Tree,
) -> bool {
    let state = |name| context.settings().bool(name);
    state("ToggleValue").or_else(|| state("SwitchValue")).unwrap_or(false)
}

/// Gives one value while it is pressed and another otherwise. Without a hand to press it, it is not pressed.
#[component(
    "a8b97322-2d53-47cd-905e-b932c3ccd74e",
    name = "Button",
    nick = "Button",
    at = "Params/Input",
    floating
)]
#[output("Button", "Button", "The value of the button at rest.")]
fn button(
    context: &Context<'_>,
    /// Not used: both values are stored in the button.
    #[port("Button", "Button", optional)]
    _data: &Tree,
) -> Result<Option<Value>, Message> {
    formula::constant(context.settings().str("ExpressionNormal").unwrap_or("False"))
}

/// Named values, of which one is chosen; in a check list any number.
///
/// A value is a formula without variables: a text stands in quotes. One that cannot be computed is null.
#[component(
    "00027467-0d24-4fa7-b178-8dc0ac5f42ec",
    name = "Value List",
    nick = "List",
    at = "Params/Input",
    floating
)]
#[output("List", "List", "The chosen values.")]
fn value_list(
    context: &Context<'_>,
    /// Not used: the values are stored in the list.
    #[port("List", "List", optional)]
    _data: &Tree,
) -> Vec<Option<Value>> {
    let settings = context.settings();
    let items = settings.children("ListItem");
    let chosen = |item: &&Chunk| item.bool("Selected") == Some(true);
    let picked: Vec<&Chunk> = if settings.i32("ListMode") == Some(0) {
        items.into_iter().filter(chosen).collect()
    } else {
        items.iter().copied().find(chosen).or(items.first().copied()).into_iter().collect()
    };
    let value = |item: &Chunk| match formula::constant(item.str("Expression").unwrap_or_default()) {
        Ok(value) => value,
        Err(message) => {
            let name = item.str("Name").unwrap_or_default();
            context.warn(format!("The value of {name} cannot be computed: {}", message.text));
            None
        }
    };
    picked.into_iter().map(value).collect()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::Chunk;

    #[test]
    fn toggles_of_both_kinds() {
        assert_eq!(Trial::of("Boolean Toggle").setting("ToggleValue", true).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Boolean Toggle").setting("SwitchValue", true).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Boolean Toggle").texts(0), ["{0}: False"]);
    }

    #[test]
    fn a_button_is_at_rest() {
        assert_eq!(Trial::of("Button").setting("ExpressionNormal", "2*3").texts(0), ["{0}: 6"]);
        assert_eq!(Trial::of("Button").texts(0), ["{0}: False"]);
    }

    fn list(mode: i32, items: [(&str, bool); 3]) -> Trial {
        let mut settings = Chunk::default();
        settings.set("ListMode", mode);
        for (k, (expression, selected)) in (0..).zip(items) {
            let mut item = Chunk::indexed("ListItem", k);
            item.set("Name", format!("item {k}"));
            item.set("Expression", expression);
            item.set("Selected", selected);
            settings.set_child(item);
        }
        Trial::of("Value List").settings(settings)
    }

    #[test]
    fn value_lists_by_mode() {
        let items = [("1.5", false), ("\"two\"", true), ("2+1", true)];
        assert_eq!(list(1, items).texts(0), ["{0}: two"]);
        assert_eq!(list(0, items).texts(0), ["{0}: two, 3"]);
        assert_eq!(list(0, items.map(|(e, _)| (e, false))).run().outputs[0].item_count(), 0);
        assert_eq!(list(3, items.map(|(e, _)| (e, false))).texts(0), ["{0}: 1.5"]);
        assert_eq!(list(1, [("(1", true), ("", false), ("", false)]).texts(0), ["{0}: null"]);
    }
}
