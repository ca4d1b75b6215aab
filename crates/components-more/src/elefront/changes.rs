//! Attributes of objects that are there: changed, written as JSON, and saved with the objects.

use std::sync::Arc;

use katydid_component::{Baker, Context, List, Message, component};
use katydid_data::cast::Rules;
use katydid_data::{Colour, ModelObject, Tree, Value};

use super::attributes::{defined, texts};
use crate::model_objects::{is_true, object_of, own_object, pairs};

/// The attributes of an object, without its geometry.
fn attributes_of(context: &Context<'_>, value: &Value) -> Result<ModelObject, Message> {
    let own = object_of(context, value);
    let own =
        own.ok_or_else(|| Message::error("The geometry is of no object of the model: it has no attributes"))?;
    Ok(ModelObject { geometry: None, id: None, ..own })
}

/// The attributes of an object, to be put on others or changed. Stands for EleFront's Get Elefront Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd261",
    name = "Get Elefront Attributes",
    nick = "GetAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Attributes", "A", "The attributes.", kind = Content)]
fn get_attributes(
    context: &Context<'_>,
    /// The object, or its geometry.
    #[port("Geometry", "G", kind = Generic)]
    object: Value,
) -> Result<Value, Message> {
    Ok(Value::from(attributes_of(context, &object)?))
}

/// The attributes of an object with user texts put under keys; all others stay. Stands for EleFront's Modify Elefront Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd262",
    name = "Modify Elefront Attributes",
    nick = "ModAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Attributes", "A", "The attributes.", kind = Content)]
fn modify_attributes(
    context: &Context<'_>,
    /// The object, its geometry, or attributes.
    #[port("Referenced Geometry or Elefront Attributes", "A", kind = Generic)]
    object: Value,
    /// The keys of user texts.
    #[port("User Keys", "K", optional)]
    keys: List<Arc<str>>,
    /// The text under each key.
    #[port("User Values", "V", optional)]
    values: List<Arc<str>>,
) -> Result<Value, Message> {
    let mut own = attributes_of(context, &object)?;
    texts(&mut own, &keys, &values)?;
    Ok(Value::from(own))
}

/// Attributes for objects that are baked: name, layer, colour, material, and user texts under keys. Stands for EleFront's Object
/// Attributes, an earlier name of Define Object Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd263",
    name = "Object Attributes",
    nick = "Attributes",
    at = "EleFront/03 Attributes",
    old
)]
#[output("Object Attributes", "A", "The attributes.", kind = Content)]
fn object_attributes(
    /// What the object is called.
    #[port("Name", "N", optional)]
    name: Option<Arc<str>>,
    /// The path of its layer (`Outer::Inner`), or a layer.
    #[port("Layer", "L", kind = Generic, optional)]
    layer: Option<Value>,
    /// Its colour.
    #[port("Color", "C", optional)]
    colour: Option<Colour>,
    /// The name of its material, or a material.
    #[port("Material", "M", kind = Generic, optional)]
    material: Option<Value>,
    /// The keys of user texts.
    #[port("User Keys", "K", optional)]
    keys: List<Arc<str>>,
    /// The text under each key.
    #[port("User Values", "V", optional)]
    values: List<Arc<str>>,
) -> Result<Value, Message> {
    defined(name, layer.as_ref(), colour, material.as_ref(), &keys, &values)
}

/// What a component says that saves so many objects.
fn told(count: usize) -> Tree {
    let told = match count {
        0 => "Nothing is modified".to_owned(),
        1 => "1 object is modified".to_owned(),
        _ => format!("{count} objects are modified"),
    };
    Tree::item(Value::text(told))
}

/// A baker of a component: the objects that it changes, from its inputs.
macro_rules! changes {
    ($guid:literal, $objects:expr) => {
        katydid_component::parts::inventory::submit! {
            Baker { component: katydid_component::parts::Uuid::from_u128($guid), objects: $objects }
        }
    };
}

/// Objects with new attributes, where the third input, if there is one, does not say no.
pub(crate) fn modified(inputs: &[Tree], _: &Rules) -> Vec<Value> {
    let [objects, attributes, switch @ ..] = inputs else { return Vec::new() };
    if attributes.is_empty() || switch.first().is_some_and(|switch| !is_true(Some(switch))) {
        return Vec::new();
    }
    pairs(objects, attributes).into_iter().map(Value::from).collect()
}

changes!(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd264, modified);

/// Objects with their attributes changed: where the new ones say nothing, the old ones stay. The model that was read stays as it is;
/// `katydid run -o MODEL.3dm` saves the changed objects, as what Bake Objects bakes. Stands for EleFront's Modify Attributes, an
/// earlier name of Modify Rhino Object Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd264",
    name = "Modify Attributes",
    nick = "Modify Attributes",
    at = "EleFront/03 Attributes"
)]
#[output("Message", "S", "How many objects are changed.", kind = Text)]
fn modify_objects_when_told(
    /// The objects.
    #[port("Geometry", "G", kind = Generic)]
    objects: &Tree,
    /// The new attributes of each.
    #[port("Attributes", "A", kind = Generic, optional)]
    attributes: &Tree,
    /// Whether to change them.
    #[port("Modify", "M", kind = Boolean, optional)]
    modify: &Tree,
) -> Tree {
    let is_done = is_true(Some(modify)) && !attributes.is_empty();
    told(if is_done { objects.item_count() } else { 0 })
}

changes!(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd265, modified);

/// Objects with their attributes changed: where the new ones say nothing, the old ones stay. The model that was read stays as it is;
/// `katydid run -o MODEL.3dm` saves the changed objects, as what Bake Objects bakes. Stands for EleFront's Modify Rhino Object
/// Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd265",
    name = "Modify Rhino Object Attributes",
    nick = "ModRAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Message", "S", "How many objects are changed.", kind = Text)]
fn modify_objects(
    /// The objects.
    #[port("Referenced Object", "O", kind = Generic)]
    objects: &Tree,
    /// The new attributes of each.
    #[port("Attributes", "A", kind = Generic, optional)]
    attributes: &Tree,
) -> Tree {
    told(if attributes.is_empty() { 0 } else { objects.item_count() })
}

fn bared(inputs: &[Tree], _: &Rules) -> Vec<Value> {
    let [objects, switch, ..] = inputs else { return Vec::new() };
    if !is_true(Some(switch)) {
        return Vec::new();
    }
    let items = (0..objects.item_count()).filter_map(|at| objects.column().get(at));
    let bare = |value: Value| {
        let own = own_object(&value).unwrap_or_else(|| ModelObject::new(value));
        Value::from(ModelObject { user_text: Vec::new(), ..own })
    };
    items.map(bare).collect()
}

changes!(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd266, bared);

/// Objects without their user texts. The model that was read stays as it is; `katydid run -o MODEL.3dm` saves the changed objects, as
/// what Bake Objects bakes. Stands for EleFront's Remove User Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd266",
    name = "Remove User Attributes",
    nick = "RemUA",
    at = "EleFront/03 Attributes"
)]
#[output("Message", "S", "How many objects are changed.", kind = Text)]
fn remove_user_attributes(
    /// The objects.
    #[port("Geometry", "G", kind = Generic)]
    objects: &Tree,
    /// Whether to change them.
    #[port("Acivate", "A", kind = Boolean, optional)]
    switch: &Tree,
) -> Tree {
    told(if is_true(Some(switch)) { objects.item_count() } else { 0 })
}

/// The folder of a file, and its name. Both kinds of slashes part folders. Stands for EleFront's Deconstruct FilePath; that the folder
/// has no slash at its end is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd267",
    name = "Deconstruct FilePath",
    nick = "DecPath",
    at = "EleFront/09 Files"
)]
#[output("Folder", "Fo", "The folder; empty where the path has none.")]
#[output("File Name", "Fn", "The name without what follows its last dot.")]
#[output("File Name with Extension", "Fn+", "The whole name.")]
fn deconstruct_path(
    /// The path of a file.
    #[port("FilePath", "F")]
    path: Arc<str>,
) -> (Arc<str>, Arc<str>, Arc<str>) {
    let path = path.trim();
    let (folder, name) = path.rsplit_once(['/', '\\']).unwrap_or(("", path));
    // A name that begins with its only dot has no extension.
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| if stem.is_empty() { name } else { stem });
    (folder.into(), stem.into(), name.into())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_component::{baker, registry};
    use katydid_data::{Colour, ModelObject, Tree, Value};
    use katydid_geometry::Point3;

    use crate::model_objects::own_object;

    fn wall() -> Value {
        let mut object = ModelObject::new(Point3::new(1.0, 2.0, 3.0).into());
        object.name = "north".into();
        object.set_text("height", "3");
        object.set_text("fire", "yes");
        object.into()
    }

    fn made(trial: Trial) -> ModelObject {
        own_object(&trial.run().outputs[0].column().get(0).unwrap()).unwrap()
    }

    fn text(object: &ModelObject, key: &str) -> Option<String> {
        object.text_of(key).map(|text| text.to_string())
    }

    #[test]
    fn attributes_are_taken_and_changed() {
        let own = made(Trial::of("Get Elefront Attributes").item(wall()));
        assert_eq!((&*own.name, own.user_text.len(), own.geometry.is_none()), ("north", 2, true));
        let changed = Trial::of("Modify Elefront Attributes").item(wall());
        let changed = made(changed.list(["fire", "use"]).list(["no", "shop"]));
        assert_eq!(["height", "fire", "use"].map(|key| text(&changed, key).unwrap()), ["3", "no", "shop"]);
        assert_eq!(&*changed.name, "north");
        let uneven = Trial::of("Modify Elefront Attributes").item(wall()).list(["a"]);
        assert_eq!(uneven.message(), "There are 1 keys and 0 values");
        let bare = Trial::of("Get Elefront Attributes").item(Point3::ORIGIN).message();
        assert!(bare.contains("no object"), "{bare}");
    }

    #[test]
    fn attributes_under_their_earlier_name() {
        let id = "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd263";
        let trial = Trial::of_guid(id).item("north").item("House::Walls").item(Colour::rgb(1, 2, 3));
        let own = made(trial.item("Concrete").list(["fire"]).list(["yes"]));
        assert_eq!((&*own.name, &*own.layer.as_ref().unwrap().path), ("north", "House::Walls"));
        assert_eq!((own.colour, text(&own, "fire")), (Some(Colour::rgb(1, 2, 3)), Some("yes".into())));
    }

    fn saved(name: &str, inputs: &[Tree]) -> Vec<ModelObject> {
        let baker = baker(registry::by_name(name).unwrap().guid).unwrap();
        let objects = (baker.objects)(inputs, &Default::default());
        objects.iter().map(|object| own_object(object).unwrap()).collect()
    }

    #[test]
    fn objects_are_saved_with_changed_attributes() {
        let mut new = ModelObject { name: "south".into(), ..ModelObject::default() };
        new.set_text("fire", "no");
        let (objects, new) = (Tree::item(wall()), Tree::item(Value::from(new)));
        let on = |on: bool| Tree::item(Value::Boolean(on));
        for inputs in [vec![objects.clone(), new.clone(), on(true)], vec![objects.clone(), new.clone()]] {
            let name = if inputs.len() == 3 { "Modify Attributes" } else { "Modify Rhino Object Attributes" };
            let found = saved(name, &inputs);
            assert_eq!(found.len(), 1);
            assert_eq!((&*found[0].name, text(&found[0], "fire")), ("south", Some("no".into())));
            assert_eq!(text(&found[0], "height"), Some("3".into()));
            assert_eq!(found[0].geometry, Some(Point3::new(1.0, 2.0, 3.0).into()));
            let told = inputs.iter().fold(Trial::of(name), |trial, tree| trial.tree(tree.clone()));
            assert_eq!(told.texts(0), ["{0}: 1 object is modified"]);
        }
        assert!(saved("Modify Attributes", &[objects.clone(), new.clone(), on(false)]).is_empty());
        assert!(saved("Modify Attributes", &[objects.clone(), Tree::empty(), on(true)]).is_empty());
        assert!(saved("Modify Rhino Object Attributes", &[objects.clone(), Tree::empty()]).is_empty());
        let off = Trial::of("Modify Attributes").tree(objects.clone()).tree(new);
        assert_eq!(off.texts(0), ["{0}: Nothing is modified"]);
        let bare = saved("Remove User Attributes", &[objects.clone(), on(true)]);
        assert_eq!((&*bare[0].name, bare[0].user_text.len()), ("north", 0));
        assert!(saved("Remove User Attributes", &[objects, on(false)]).is_empty());
    }

    #[test]
    fn paths_are_taken_apart() {
        let part =
            |path: &str| [0, 1, 2].map(|k| Trial::of("Deconstruct FilePath").item(path).texts(k)[0].clone());
        let of = |parts: [&str; 3]| parts.map(|part| format!("{{0}}: {part}").trim_end().to_owned());
        assert_eq!(part("C:\\models\\house.v2.3dm"), of(["C:\\models", "house.v2", "house.v2.3dm"]));
        assert_eq!(part("/srv/house.3dm"), of(["/srv", "house", "house.3dm"]));
        assert_eq!(part("house"), of(["", "house", "house"]));
        assert_eq!(part("a/.hidden"), of(["a", ".hidden", ".hidden"]));
    }
}
