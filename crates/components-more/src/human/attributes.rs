//! Attributes that objects are baked with, and those of objects of the model.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, ModelLayer, ModelMaterial, ModelObject, Value, Visibility};

/// What a group is called that is told by its number.
const GROUP: &str = "Group";

/// Attributes for objects that are baked. Stands for Human's CreateAttributes. Groups get their numbers as names; linetypes and what
/// is for print are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd302",
    name = "CreateAttributes",
    nick = "CreateAtts",
    at = "Human/Creation"
)]
#[output("Object Attributes", "att", "The attributes.", kind = Content)]
fn create(
    context: &Context<'_>,
    /// What the object is called.
    #[port("Name", "name", optional)]
    name: Option<Shared<str>>,
    /// The path of its layer (`Outer::Inner`).
    #[port("Layer Name", "lay", optional)]
    layer: Option<Shared<str>>,
    /// Its colour.
    #[port("Color", "col", optional)]
    colour: Option<Colour>,
    /// The name of its material.
    #[port("Material Name", "mat", optional)]
    material: Option<Shared<str>>,
    /// The name of its linetype; not supported.
    #[port("Linetype Name", "lt", optional)]
    linetype: Option<Shared<str>>,
    /// The numbers of its groups.
    #[port("Group Indices", "grp", optional)]
    groups: List<i32>,
    /// Its width in print, in millimetres; not supported.
    #[port("Plot Weight", "PW", optional)]
    weight: Option<f64>,
    /// Its colour in print; not supported.
    #[port("Plot Color", "PC", optional)]
    print: Option<Colour>,
    /// Whether it is seen.
    #[port("Visibility", "V", optional)]
    is_visible: Option<bool>,
    /// The keys of user texts.
    #[port("UserData Keys", "udk", optional)]
    keys: List<Shared<str>>,
    /// The text under each key.
    #[port("UserData Values", "udv", optional)]
    values: List<Shared<str>>,
) -> Result<Value, Message> {
    if linetype.is_some() || weight.is_some() || print.is_some() {
        context.tell(Message::remark("Linetypes, and widths and colours in print, are not supported"));
    }
    let given = |text: Option<Shared<str>>| text.filter(|text| !text.trim().is_empty());
    let mut object = ModelObject {
        name: name.unwrap_or_default(),
        layer: given(layer).map(|path| Shared::new(ModelLayer::at(path.trim()))),
        colour,
        material: given(material).map(|name| Shared::new(ModelMaterial::named(name.trim()))),
        visibility: if is_visible == Some(false) { Visibility::Hidden } else { Visibility::Normal },
        groups: groups.present().map(|number| format!("{GROUP} {number}").into()).collect(),
        ..ModelObject::default()
    };
    crate::elefront::texts(&mut object, &keys, &values)?;
    Ok(Value::from(object))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Colour;

    #[test]
    fn attributes_there_and_back() {
        let made = Trial::of("CreateAttributes")
            .item("beam")
            .item("Steel::Beams")
            .item(Colour::rgb(1, 2, 3))
            .item("Red paint")
            .default()
            .list([4, 7])
            .default()
            .default()
            .item(false)
            .list(["mark"])
            .list(["B1"])
            .run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        let told = |k: usize| Trial::of("Object Attributes").tree(made.outputs[0].clone()).texts(k);
        assert_eq!(told(0), ["{0}: beam"]);
        assert_eq!(told(1), ["{0}: Beams"]);
        assert_eq!(told(2), ["{0}: Steel::Beams"]);
        assert_eq!(told(3), ["{0}: 1,2,3"]);
        assert_eq!(told(4), ["{0}: Red paint"]);
        assert_eq!(told(6), ["{0;0}: 4, 7"]);
        assert_eq!(told(9), ["{0}: False"]);
        assert_eq!(told(10), ["{0;0}: mark"]);
        assert_eq!(told(11), ["{0;0}: B1"]);
    }
}
