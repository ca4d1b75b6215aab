//! Rhino / Content: user text, filters and groups of model content.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Content, Filter, Kind, Tree, TreeBuilder, Value, cast};
use uuid::Uuid;

use super::{content_of, object_of, unfit};

/// The user text of an object, and other texts put into it.
///
/// Keys without a value leave their text as it is; other texts of the object stay. Whether Grasshopper clears texts
/// whose keys are not given is not known.
#[component(
    "3da3fd40-b2fb-483c-8d1a-1b557eba66cd",
    name = "User Text",
    nick = "U-Text",
    at = "Rhino/Content"
)]
#[output("Content", "C", "The object with its texts.", kind = Content)]
#[output("Keys", "K", "The keys, in their order.")]
#[output("Values", "V", "The text under each key.")]
fn user_text(
    context: &Context<'_>,
    /// The object, or geometry.
    #[port("Content", "C")]
    content: Value,
    /// Keys to put texts under.
    #[port("Keys", "K", optional)]
    keys: List<Arc<str>>,
    /// The text for each key.
    #[port("Values", "V", optional)]
    values: List<Value>,
) -> Result<(Value, Vec<Arc<str>>, Vec<Arc<str>>), Message> {
    let mut object = object_of(context, &content)?;
    if values.len() > keys.len() {
        context.warn(format!("{} values have no key", values.len() - keys.len()));
    }
    for (place, key) in keys.iter().enumerate() {
        let (Some(key), Some(value)) = (key, values.get(place)) else { continue };
        if let Some(Value::Text(text)) = cast::value(&value, Kind::Text, context.rules()) {
            object.set_text(&key, text);
        }
    }
    let (keys, texts) = object.user_text.iter().cloned().unzip();
    Ok((Value::from(object), keys, texts))
}

/// What a model knows of its content.
///
/// The path of a layer is that from the outermost layer in; of other content it is the name. Attributes are not
/// supported: how Grasshopper writes them is not known.
#[component(
    "ed9fbfde-1a0d-4469-a03f-feb54ac3e5cf",
    name = "Content Details",
    nick = "Details",
    at = "Rhino/Content"
)]
#[output("Content", "C", "The content.", kind = Content)]
#[output("Id", "Id", "Its identifier in the model.")]
#[output("Path", "P", "Its path or name.")]
#[output("Attributes", "A", "Not supported: no texts.")]
fn content_details(
    context: &Context<'_>,
    /// The content, or geometry.
    #[port("Content", "C")]
    content: Value,
) -> Result<(Value, Option<Uuid>, Option<Arc<str>>, Vec<Arc<str>>), Message> {
    let content = content_of(context, &content).ok_or_else(|| unfit(&content, "content"))?;
    if context.is_wanted(3) {
        context.warn("Not supported: how Grasshopper writes the attributes of content is not known");
    }
    let id = match content.attribute("Id") {
        Some(Value::Guid(id)) => Some(id),
        _ => None,
    };
    let path = content.path().map(Arc::from);
    Ok((Value::Content(content), id, path, Vec::new()))
}

/// Content whose attribute is a value, and content whose attribute is another or none.
///
/// Keys are `Name`, `Path`, `Id`, `Layer`, `Layer.Name`, `Layer.Path`, `Layer.Parent`, `Visibility`, `Display.Color`,
/// and `UserText.` with the key of a user text behind it, or that key alone. Values are compared as the type that is
/// given here.
#[component(
    "2ec65d2f-c274-4ea9-a2a3-cb20e77b533f",
    name = "Equality Filter",
    nick = "Equals",
    at = "Rhino/Content"
)]
#[output("Equal", "=", "Passes what has this value.", kind = Content)]
#[output("Unequal", "≠", "Passes what has not.", kind = Content)]
fn equality_filter(
    /// The key of the attribute.
    #[port("Key", "K", default = "Layer.Name")]
    key: Arc<str>,
    /// The value.
    #[port("Value", "V", default = 0.0, kind = Generic)]
    value: Value,
) -> (Value, Value) {
    let filter = |negated| Value::from(Filter::Equal { key: key.clone(), value: value.clone(), negated });
    (filter(false), filter(true))
}

/// Content whose attribute has a text in it. Keys are those of Equality Filter.
#[component(
    "e59e1368-a7c3-4a35-9f1d-8cf2cf67dc1b",
    name = "Contains Text Filter",
    nick = "Contains",
    at = "Rhino/Content"
)]
#[output("Filter", "F", "Passes what has the text in it.", kind = Content)]
fn contains_text_filter(
    /// The key of the attribute.
    #[port("Key", "K", default = "Name")]
    key: Arc<str>,
    /// The text to look for.
    #[port("Text", "T", default = "")]
    text: Arc<str>,
    /// Whether capital and small letters differ.
    #[port("Case", "C", default = true)]
    case: bool,
    /// Not used: letters are compared as Unicode has them.
    #[port("Culture", "Cu", default = 127)]
    _culture: i32,
) -> Value {
    Value::from(Filter::Contains { key, text, case })
}

/// Content that passes all of several filters.
#[component(
    "4f4fc2ac-98ac-485a-b88b-f23965e16de8",
    name = "Intersection Filter",
    nick = "Intersection",
    at = "Rhino/Content"
)]
#[output("Filter", "F", "Passes what passes all filters.", kind = Content)]
fn intersection_filter(
    /// The filters.
    #[port("Filters", "F", kind = Generic)]
    filters: List<Value>,
) -> Result<Value, Message> {
    let filters = filters.present().map(|value| filter_of(&value)).collect::<Result<Vec<_>, _>>()?;
    Ok(Value::from(Filter::all(filters)))
}

fn filter_of(value: &Value) -> Result<Filter, Message> {
    match value {
        Value::Content(content) => match &**content {
            Content::Filter(filter) => Ok(filter.clone()),
            _ => Err(unfit(value, "filter")),
        },
        _ => Err(unfit(value, "filter")),
    }
}

/// Sorts out the content that passes a filter. Data that is no content, numbers say, never passes.
#[component(
    "d6cb16a3-a3d9-4506-b5c3-f82e48fd20b9",
    name = "Filter Content",
    nick = "Filter",
    at = "Rhino/Content"
)]
#[output("Content", "C", "What passes, unchanged.", kind = Generic)]
#[output("Pass", "P", "For each item whether it passes.")]
#[output("Count", "C", "How many pass.")]
fn filter_content(
    context: &Context<'_>,
    /// The content, or geometry.
    #[port("Content", "C")]
    content: List<Value>,
    /// The filter.
    #[port("Filter", "F", kind = Generic)]
    filter: Value,
) -> Result<(Vec<Value>, Vec<bool>, i32), Message> {
    let filter = filter_of(&filter)?;
    let (mut passed, mut pass) = (Vec::new(), Vec::with_capacity(content.len()));
    for item in content.iter() {
        context.check()?;
        let found = item.as_ref().and_then(|item| content_of(context, item));
        let passes = found.is_some_and(|found| filter.passes(&found, context.rules()));
        pass.push(passes);
        passed.extend(item.filter(|_| passes));
    }
    let count = i32::try_from(passed.len()).unwrap_or(i32::MAX);
    Ok((passed, pass, count))
}

/// Sorts content into branches, one for each value that an attribute has. Keys are those of Equality Filter.
///
/// Branches come in the order in which their values are met first; content without the attribute has a branch of its
/// own. In which order Grasshopper has them is not known.
#[component(
    "709cb378-b1fa-4b92-aff4-8138831b0cdf",
    name = "Group Content",
    nick = "Group",
    at = "Rhino/Content"
)]
#[output(
    "Content",
    "C",
    "The content of each value; the path is one element longer, the number of the value."
)]
#[output("Values", "V", "The values, null for none.")]
fn group_content(
    context: &Context<'_>,
    /// The content, or geometry.
    #[port("Content", "C")]
    content: List<Value>,
    /// The key of the attribute.
    #[port("Key", "K", default = "Layer.Name")]
    key: Arc<str>,
) -> Result<(Tree, Vec<Option<Value>>), Message> {
    let mut groups: Vec<(Option<Value>, Vec<Option<Value>>)> = Vec::new();
    let mut places = std::collections::HashMap::new();
    for item in content.iter() {
        context.check()?;
        let found = item.as_ref().and_then(|item| content_of(context, item));
        let value = found.and_then(|found| found.attribute(&key));
        let text = value.as_ref().map(|value| katydid_data::text::value(value, &context.style()));
        let place = *places.entry(text).or_insert_with(|| {
            groups.push((value, Vec::new()));
            groups.len() - 1
        });
        if let Some((_, members)) = groups.get_mut(place) {
            members.push(item);
        }
    }
    let mut builder = TreeBuilder::<Value>::new();
    let path = context.path();
    let mut values = Vec::with_capacity(groups.len());
    for (place, (value, members)) in groups.into_iter().enumerate() {
        builder.branch(path.child(place));
        members.into_iter().for_each(|member| builder.push(member));
        values.push(value);
    }
    Ok((builder.finish(), values))
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Tree, Value};
    use katydid_geometry::Point3;

    /// Points at x on a layer with a user text.
    fn objects() -> Vec<Value> {
        let layers = vec![Layer::new("Walls"), Layer::new("Roof")];
        let mut model = Model { layers, ..Model::default() };
        for (x, layer, name, floor) in
            [(1.0, 0, "north", "3"), (2.0, 1, "North wing", "4"), (3.0, 0, "", "3.0")]
        {
            let attributes = Attributes {
                layer: Some(layer),
                name: name.to_owned(),
                user_strings: vec![("Floor".to_owned(), floor.to_owned())],
                ..Attributes::default()
            };
            let point = Object::Point(Point3::new(x, 0.0, 0.0));
            model.objects.push(ModelObject { attributes, ..ModelObject::from(point) });
        }
        RhinoModel::new(model).objects().iter().map(|object| object.content.clone()).collect()
    }

    fn equal(key: &str, value: impl Into<Value>, which: usize) -> Tree {
        Trial::of("Equality Filter").item(key).item(value).run().outputs[which].clone()
    }

    fn passes(filter: Tree) -> String {
        let out = Trial::of("Filter Content").list(objects()).tree(filter).run().outputs;
        texts(&out[1])[0].trim_start_matches("{0;0}: ").trim_start_matches("{0}: ").to_owned()
    }

    #[test]
    fn filters_look_at_names_layers_and_user_text() {
        assert_eq!(passes(equal("Layer.Name", "Walls", 0)), "True, False, True");
        assert_eq!(passes(equal("Layer", "Walls", 1)), "False, True, False");
        assert_eq!(passes(equal("UserText.Floor", 3.0, 0)), "True, False, True");
        assert_eq!(passes(equal("Floor", "3", 0)), "True, False, False");
        assert_eq!(passes(equal("Name", "", 1)), "True, True, True");
        let contains = |text: &str, case: bool| {
            Trial::of("Contains Text Filter").item("Name").item(text).item(case).run().outputs[0].clone()
        };
        assert_eq!(passes(contains("north", true)), "True, False, False");
        assert_eq!(passes(contains("north", false)), "True, True, False");
        let both = [equal("Layer.Name", "Walls", 0), contains("n", true)];
        let both = both.map(|tree| tree.column().get(0).unwrap());
        let both = Trial::of("Intersection Filter").list(both).run().outputs[0].clone();
        assert_eq!(passes(both), "True, False, False");
        assert_eq!(Trial::of("Filter Content").list(objects()).item(1.0).message(), "A Number is no filter");
        // What is no content does not pass.
        let numbers = Trial::of("Filter Content").list([1.0]).tree(equal("Name", "a", 1));
        assert_eq!(numbers.texts(1), ["{0;0}: False"]);
    }

    #[test]
    fn groups_have_a_branch_for_each_value() {
        let out = Trial::of("Group Content").list(objects()).run().outputs;
        assert_eq!(texts(&out[0]), ["{0;0}: north, {3, 0, 0}", "{0;1}: North wing"]);
        assert_eq!(texts(&out[1])[0].split_once(": ").unwrap().1, "Walls, Roof");
        let by_name = Trial::of("Group Content").list(objects()).item("Name").run().outputs;
        assert_eq!(texts(&by_name[1])[0].split_once(": ").unwrap().1, "north, North wing, null");
    }

    #[test]
    fn user_text_is_read_and_put_in() {
        let first = objects()[0].clone();
        let out = Trial::of("User Text").item(first).list(["Floor", "Use"]).list(["9", "shop"]).run().outputs;
        assert_eq!(texts(&out[1])[0].split_once(": ").unwrap().1, "Floor, Use");
        assert_eq!(texts(&out[2])[0].split_once(": ").unwrap().1, "9, shop");
        let again = Trial::of("User Text").tree(out[0].clone()).run().outputs;
        assert_eq!(texts(&again[2])[0].split_once(": ").unwrap().1, "9, shop");
        let bare = Trial::of("User Text").item(Point3::ORIGIN).list(["a"]).list([1.5]).run().outputs;
        assert_eq!(texts(&bare[2])[0].split_once(": ").unwrap().1, "1.5");
    }

    #[test]
    fn details_are_id_and_path() {
        let trial = Trial::of("Content Details").item(objects()[1].clone()).run();
        assert_eq!(texts(&trial.outputs[2]), ["{0}: North wing"]);
        assert_eq!(Trial::of("Content Details").item(true).message(), "A Boolean is no content");
    }
}
