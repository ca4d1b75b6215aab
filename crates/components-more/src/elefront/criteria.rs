//! What objects are told apart by: layers, names, types, colours and user texts. How filters are written is our reading.

use std::sync::Arc;

use katydid_component::{List, Message};
use katydid_data::{Colour, ModelObject, Value};

use crate::model_objects::is_of_type;
use crate::wildcard::takes;

/// Whether one of some patterns takes a text.
pub(super) fn any(patterns: &List<'_, Arc<str>>, text: &str) -> bool {
    patterns.iter().flatten().any(|pattern| takes(&pattern, text))
}

/// Whether an object is on one of some layers, told by their paths or their own names.
pub(super) fn on_layers(object: &ModelObject, layers: &List<'_, Arc<str>>) -> bool {
    object.layer.as_deref().is_some_and(|layer| any(layers, &layer.path) || any(layers, layer.name()))
}

/// Whether an item is of one of some types.
pub(super) fn of_types(value: &Value, types: &List<'_, Arc<str>>) -> bool {
    types.present().any(|wanted| is_of_type(value, &wanted))
}

/// The colour an object is seen in.
pub(super) fn colour_of(object: &ModelObject) -> Option<Colour> {
    object.colour.or_else(|| object.layer.as_deref().and_then(|layer| layer.colour))
}

/// Whether an object is seen in one of some colours.
pub(super) fn coloured(object: &ModelObject, colours: &List<'_, Colour>) -> bool {
    colour_of(object).is_some_and(|own| colours.present().any(|colour| colour == own))
}

/// A key and the text under it.
type Pair = (Arc<str>, Arc<str>);

/// Pairs of keys and values.
///
/// # Errors
/// There are not as many of each.
pub(super) fn pairs(keys: &List<'_, Arc<str>>, values: &List<'_, Arc<str>>) -> Result<Vec<Pair>, Message> {
    if keys.len() != values.len() {
        return Err(Message::error(format!("There are {} keys and {} values", keys.len(), values.len())));
    }
    Ok(keys.iter().zip(values.iter()).filter_map(|(key, value)| Some((key?, value?))).collect())
}

/// Whether an object has all of some texts under their keys.
pub(super) fn has_all(pairs: Vec<Pair>) -> impl Fn(&ModelObject) -> bool {
    move |object| {
        let fits = |(key, value): &Pair| object.text_of(key).is_some_and(|text| takes(value, text));
        !pairs.is_empty() && pairs.iter().all(fits)
    }
}
