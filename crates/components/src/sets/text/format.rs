//! Sets / Text: texts with values put into them.

use std::sync::Arc;

use katydid_component::{Context, ManyItems, Message, component};
use katydid_data::{Value, formula, text};
use katydid_expression::{Variant, format as formats};

fn formatted(context: &Context<'_>, pattern: &str, data: ManyItems<Value>) -> Result<Arc<str>, Message> {
    let plain = |value: &Value| Variant::text(text::value(value, &context.style()));
    let variant = |value: Option<Value>| match value {
        None => Variant::Null,
        Some(value) => formula::variant(&value).unwrap_or_else(|| plain(&value)),
    };
    let values: Vec<Variant> = data.into_iter().map(variant).collect();
    let result = formats::format(pattern, &values, formats::Dialect::default());
    let result = result.map_err(|error| Message::error(error.to_string()))?;
    context.bytes(result.len())?;
    Ok(result.into())
}

/// Puts values into a text: `{0}` stands for the first, `{1}` for the second, and so on.
///
/// Behind a colon stands how numbers are written, `{0:0.00}` with two decimals; behind a comma the width, `{0,8}`.
/// Missing values are empty. Braces of the text itself are written twice.
#[component("758d91a0-4aec-47f8-9671-16739a8a2c5d", name = "Format", nick = "Format", at = "Sets/Text")]
#[output("Text", "T", "The text with the values in it.")]
fn format(
    context: &Context<'_>,
    /// The text, with places for the values.
    #[port("Format", "F")]
    pattern: Arc<str>,
    /// The language of numbers; only 127, no language, is known.
    #[port("Culture", "C", default = 127)]
    culture: i32,
    /// A value.
    #[port("Data 0", "0", optional)]
    data: ManyItems<Value>,
) -> Result<Arc<str>, Message> {
    if culture != 127 {
        context.warn(format!("Numbers are written without regard to the language {culture}"));
    }
    formatted(context, &pattern, data)
}

/// Puts values into a text: `{0}` stands for the first, `{1}` for the second, and so on. An early form of the
/// component of the same name.
#[component("c8203c3c-6bcd-4f8c-a906-befd92ebf0cb", name = "Format", nick = "Format", at = "Sets/Text", old)]
#[output("Text", "T", "The text with the values in it.")]
fn early_format(
    context: &Context<'_>,
    /// The text, with places for the values.
    #[port("Format", "F")]
    pattern: Arc<str>,
    /// A value.
    #[port("Data 0", "0", optional)]
    data: ManyItems<Value>,
) -> Result<Arc<str>, Message> {
    formatted(context, &pattern, data)
}

/// Every character with its single counterpart; those whose counterpart is several characters stay.
fn mapped<I: ExactSizeIterator<Item = char>>(text: &str, map: impl Fn(char) -> I) -> Arc<str> {
    let single = |c: char| {
        let mut to = map(c);
        match (to.len(), to.next()) {
            (1, Some(to)) => to,
            _ => c,
        }
    };
    text.chars().map(single).collect::<String>().into()
}

/// A text in capital letters and in small ones.
#[component(
    "b1991128-8bf1-4dea-8497-4b7188a64e9d",
    name = "Text Case",
    nick = "Case",
    at = "Sets/Text",
    also("bdd2a14a-1302-4152-a484-7198716d1a11")
)]
#[output("Upper Case", "U", "The text in capital letters.")]
#[output("Lower Case", "L", "The text in small letters.")]
fn text_case(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The language of the text; only 127, no language, is known.
    #[port("Culture", "C", default = 127)]
    _culture: i32,
) -> Result<(Arc<str>, Arc<str>), Message> {
    context.bytes(text.len().saturating_mul(2))?;
    Ok((mapped(&text, char::to_uppercase), mapped(&text, char::to_lowercase)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;
    use katydid_geometry::Point3;

    #[test]
    fn values_in_texts() {
        let format =
            |pattern: &str| Trial::of_guid("758d91a0-4aec-47f8-9671-16739a8a2c5d").item(pattern).default();
        assert_eq!(format("{0} of {1:0.00}").item("a").item(1.0 / 3.0).texts(0), ["{0}: a of 0.33"]);
        assert_eq!(format("{0}{{}}").item(0.1 + 0.2).texts(0), ["{0}: 0.30000000000000004{}"]);
        assert_eq!(format("<{0}|{1}>").tree(Tree::empty()).item(true).texts(0), ["{0}: <|True>"]);
        assert_eq!(format("{0}").item(Point3::new(1.0, 2.5, 0.0)).texts(0), ["{0}: {1, 2.5, 0}"]);
        assert!(format("{3}").item(1).message().contains("{3}"));
        assert_eq!(
            Trial::of_guid("c8203c3c-6bcd-4f8c-a906-befd92ebf0cb").item("{1}").item(1).item(2).texts(0),
            ["{0}: 2"]
        );
    }

    #[test]
    fn capitals() {
        assert_eq!(Trial::of("Text Case").item("Straße é").texts(0), ["{0}: STRAßE É"]);
        assert_eq!(Trial::of("Text Case").item("Straße É").texts(1), ["{0}: straße é"]);
    }
}
