//! The attributes of objects, one by one.

use std::sync::Arc as Shared;

use katydid_component::parts::{EachItems, ListOf, Lists, Row, Uuid, inventory, run};
use katydid_component::{Access, Call, Component, Context, Message, Outcome, Port};
use katydid_data::{Kind, Value, Visibility};

use crate::model_objects::object_of;

const fn port(
    name: &'static str,
    nick: &'static str,
    help: &'static str,
    kind: Kind,
    access: Access,
) -> Port {
    Port { name, nick, help, kind, access, optional: false, many: false, default: None }
}

const NOTHING: &str = "Nothing; not supported.";

// It is put together by hand: the attribute for components knows ten outputs at most.
inventory::submit! {
    Component {
        guid: Uuid::from_u128(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd303),
        also: &[],
        name: "Object Attributes",
        nick: "ObjAtts",
        tab: "Human",
        panel: "Reference",
        help: "The attributes of an object of the Rhino model, or those that are made for one. Stands for Human's Object Attributes. \
               The material is told where it is the object's own; linetypes and what is for print are not supported.",
        floating: false,
        old: false,
        inputs: &[port("Object or Attributes", "A", "The object, its geometry, or attributes.", Kind::Generic, Access::Item)],
        outputs: &OUTPUTS,
        run: expanded,
    }
}

static OUTPUTS: [Port; 12] = [
    port("Name", "name", "The name.", Kind::Text, Access::Item),
    port("Layer Name", "lay", "The layer's own name.", Kind::Text, Access::Item),
    port("Layer Full Path", "FP", "The path of the layer.", Kind::Text, Access::Item),
    port("Color", "col", "Its own colour, else that of its layer.", Kind::Colour, Access::Item),
    port("Material Name", "mat", "The name of its own material.", Kind::Text, Access::Item),
    port("Linetype Name", "lt", NOTHING, Kind::Text, Access::Item),
    port("Group Indices", "grp", "The numbers in the names of its groups.", Kind::Integer, Access::List),
    port("Plot Weight", "PW", NOTHING, Kind::Number, Access::Item),
    port("Plot Color", "PC", NOTHING, Kind::Colour, Access::Item),
    port("Visibility", "V", "Whether it is seen.", Kind::Boolean, Access::Item),
    port("UserData Keys", "udk", "The keys of its user texts.", Kind::Text, Access::List),
    port("UserData Values", "udv", "The text under each key.", Kind::Text, Access::List),
];

/// The outputs that give lists, in the order in which they are made.
const LISTS: [usize; 3] = [6, 10, 11];

type Made = (Lists<i32>, Lists<Shared<str>>, Lists<Shared<str>>, EachItems<Value>);

fn expanded(call: &Call<'_>) -> Outcome {
    let mut outcome = run::<Made>(call, &[Access::Item], |row, context| expand(row, context).map(Some));
    // The lists come first and the items behind them: each list goes to its place among the items.
    let mut items = outcome.outputs.split_off(LISTS.len().min(outcome.outputs.len()));
    for (place, list) in LISTS.into_iter().zip(std::mem::take(&mut outcome.outputs)) {
        items.insert(place.min(items.len()), list);
    }
    outcome.outputs = items;
    outcome
}

type Results = (ListOf<i32>, ListOf<Shared<str>>, ListOf<Shared<str>>, Vec<Option<Value>>);

fn expand(row: &Row<'_>, context: &Context<'_>) -> Result<Results, Message> {
    let object = row.item::<Value>(0).and_then(|object| object_of(context, &object));
    let Some(object) = object else {
        context.warn("The geometry is of no object of the model: it has no attributes");
        return Ok((ListOf::Full(vec![]), ListOf::Full(vec![]), ListOf::Full(vec![]), vec![None; 9]));
    };
    let text = |text: &Shared<str>| Some(Value::Text(text.clone())).filter(|_| !text.is_empty());
    let layer = object.layer.as_deref();
    let number = |group: &Shared<str>| group.rsplit(' ').next().and_then(|number| number.parse().ok());
    let (keys, values) = object.user_text.iter().cloned().unzip();
    let items = vec![
        text(&object.name),
        layer.map(|layer| Value::text(layer.name())),
        layer.map(|layer| Value::Text(layer.path.clone())),
        object.colour.or_else(|| layer.and_then(|layer| layer.colour)).map(Value::Colour),
        object.material.as_ref().and_then(|material| text(&material.name)),
        None,
        None,
        None,
        Some(Value::Boolean(object.visibility != Visibility::Hidden)),
    ];
    let groups = object.groups.iter().filter_map(number).collect();
    Ok((ListOf::Full(groups), ListOf::Full(keys), ListOf::Full(values), items))
}
