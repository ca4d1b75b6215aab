//! Objects put into the model that is saved.

use katydid_component::{Baker, component};
use katydid_data::cast::Rules;
use katydid_data::{Tree, Value};

use crate::elefront::modified;
use crate::model_objects::{is_true, pairs};

katydid_component::parts::inventory::submit! {
    Baker {
        component: katydid_component::parts::Uuid::from_u128(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd304),
        objects: baked,
    }
}

fn baked(inputs: &[Tree], _: &Rules) -> Vec<Value> {
    let [bake, geometry, attributes, ..] = inputs else { return Vec::new() };
    if !is_true(Some(bake)) {
        return Vec::new();
    }
    pairs(geometry, attributes).into_iter().map(Value::from).collect()
}

/// Bakes geometry with attributes: `katydid run -o MODEL.3dm` then saves what is baked so, with its names, layers, colours,
/// materials, groups and user texts, in place of what is previewed. Stands for Human's Bake Geometry.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd304",
    name = "Bake Geometry",
    nick = "Bake",
    at = "Human/Creation"
)]
fn bake(
    /// Whether to bake.
    #[port("Bake?", "bake", kind = Boolean)]
    _bake: &Tree,
    /// The geometry.
    #[port("Geometry", "geo", kind = Generic)]
    _geometry: &Tree,
    /// The attributes of each.
    #[port("Attributes", "att", kind = Generic, optional)]
    _attributes: &Tree,
) {
}

katydid_component::parts::inventory::submit! {
    Baker {
        component: katydid_component::parts::Uuid::from_u128(0x6b1c7c1e_0d4e_4e3a_9d5c_3f0a5a6fd305),
        objects: modified,
    }
}

/// Objects with their attributes changed: where the new ones say nothing, the old ones stay. The model that was read stays as it is;
/// `katydid run -o MODEL.3dm` saves the changed objects, as what Bake Geometry bakes. Stands for Human's Modify Object Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd305",
    name = "Modify Object Attributes",
    nick = "ModAtts",
    at = "Human/Document Modifications"
)]
fn modify_attributes(
    /// The objects.
    #[port("Objects", "O", kind = Generic)]
    _objects: &Tree,
    /// The new attributes of each.
    #[port("Attributes", "A", kind = Generic, optional)]
    _attributes: &Tree,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::{baker, registry};
    use katydid_data::{ModelObject, Tree, TreeBuilder, Value};
    use katydid_geometry::Point3;

    use crate::model_objects::own_object;

    #[test]
    fn the_last_attributes_of_a_branch_are_for_all_that_follow() {
        let baker = baker(registry::by_name("Bake Geometry").unwrap().guid).unwrap();
        let named = |name: &str| Value::from(ModelObject { name: name.into(), ..ModelObject::default() });
        let points = Tree::list(vec![Point3::ORIGIN; 3]);
        let mut attributes = TreeBuilder::<Value>::new();
        ["a", "b"].into_iter().for_each(|name| attributes.push(Some(named(name))));
        let inputs = [Tree::item(Value::Boolean(true)), points.clone(), attributes.finish()];
        let names: Vec<String> = (baker.objects)(&inputs, &Default::default())
            .iter()
            .map(|object| own_object(object).unwrap().name.to_string())
            .collect();
        assert_eq!(names, ["a", "b", "b"]);
        let without = [Tree::item(Value::Boolean(true)), points, Tree::empty()];
        assert_eq!((baker.objects)(&without, &Default::default()).len(), 3);
        assert!((baker.objects)(&[], &Default::default()).is_empty());
    }

    #[test]
    fn attributes_of_objects_are_changed() {
        let baker = baker(registry::by_name("Modify Object Attributes").unwrap().guid).unwrap();
        let mut wall = ModelObject::new(Value::from(Point3::ORIGIN));
        wall.set_text("height", "3");
        let new = ModelObject { name: "north".into(), ..ModelObject::default() };
        let inputs = [Tree::item(Value::from(wall)), Tree::item(Value::from(new))];
        let changed = own_object(&(baker.objects)(&inputs, &Default::default())[0]).unwrap();
        assert_eq!((&*changed.name, changed.user_text.len()), ("north", 1));
        assert!((baker.objects)(&[inputs[0].clone(), Tree::empty()], &Default::default()).is_empty());
    }
}
