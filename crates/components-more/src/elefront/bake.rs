//! Objects put into the model that is saved.

use katydid_component::{Baker, component};
use katydid_data::cast::Rules;
use katydid_data::{Tree, Value};

use crate::model_objects::{first, is_true, pairs};

/// The user text that tells by which name an object was baked.
pub(super) const BAKE_NAME: &str = "BakeName";

katydid_component::parts::inventory::submit! {
    Baker {
        component: katydid_component::parts::Uuid::from_u128(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd20b),
        objects: baked,
    }
}

/// The objects that are baked, with the name they are baked under.
fn baked(inputs: &[Tree], _: &Rules) -> Vec<Value> {
    let [geometry, attributes, name, bake, ..] = inputs else { return Vec::new() };
    if !is_true(Some(bake)) {
        return Vec::new();
    }
    let name = match first(name) {
        Some(Value::Text(name)) => Some(name),
        _ => None,
    };
    let mut objects = pairs(geometry, attributes);
    for object in &mut objects {
        if let Some(name) = name.as_ref().filter(|name| !name.is_empty()) {
            object.set_text(BAKE_NAME, name.clone());
        }
    }
    objects.into_iter().map(Value::from).collect()
}

/// Bakes geometry with attributes: `katydid run -o MODEL.3dm` then saves what is baked so, with its names, layers, colours,
/// materials, groups and user texts, in place of what is previewed. Stands for EleFront's Bake Objects. The name of the bake becomes
/// the user text `BakeName`, which is our reading; objects that were baked before are not looked for.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd20b",
    name = "Bake Objects",
    nick = "Bake",
    at = "EleFront/06 Bake"
)]
#[output("Message", "S", "How many objects are baked.", kind = Text)]
#[output("Guids", "G", "Nothing: objects get their ids when they are saved.", kind = Guid)]
fn bake(
    /// The geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: &Tree,
    /// The attributes of each.
    #[port("Attributes", "A", kind = Generic, optional)]
    _attributes: &Tree,
    /// The name that objects of this bake are known by.
    #[port("BakeName", "N", kind = Text, optional)]
    _name: &Tree,
    /// Whether to bake.
    #[port("Bake", "B", kind = Boolean, optional)]
    bake: &Tree,
) -> (Tree, Tree) {
    if !is_true(Some(bake)) {
        return (Tree::item(Value::text("Nothing is baked")), Tree::empty());
    }
    let count = geometry.item_count();
    let told = if count == 1 { "1 object is baked".to_owned() } else { format!("{count} objects are baked") };
    (Tree::item(Value::text(told)), Tree::empty())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_component::{baker, registry};
    use katydid_data::{ModelObject, Tree, Value};
    use katydid_geometry::Point3;

    use crate::model_objects::own_object;

    #[test]
    fn objects_are_baked_with_their_attributes() {
        let component = registry::by_name("Bake Objects").unwrap();
        let baker = baker(component.guid).unwrap();
        let points = Tree::list(vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]);
        let named = ModelObject { name: "a".into(), ..ModelObject::default() };
        let inputs = |bake: bool| {
            let attributes = Tree::item(Value::from(named.clone()));
            [points.clone(), attributes, Tree::item(Value::text("run")), Tree::item(Value::Boolean(bake))]
        };
        assert!((baker.objects)(&inputs(false), &Default::default()).is_empty());
        let objects = (baker.objects)(&inputs(true), &Default::default());
        assert_eq!(objects.len(), 2);
        for object in &objects {
            let object = own_object(object).unwrap();
            assert_eq!(&*object.name, "a");
            assert_eq!(object.text_of("BakeName").map(|name| &**name), Some("run"));
        }
        let told = |bake: bool| {
            let [a, b, c, d] = inputs(bake);
            Trial::of("Bake Objects").tree(a).tree(b).tree(c).tree(d).texts(0)
        };
        assert_eq!(told(true), ["{0}: 2 objects are baked"]);
        assert_eq!(told(false), ["{0}: Nothing is baked"]);
    }
}
