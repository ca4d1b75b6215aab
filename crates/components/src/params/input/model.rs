//! Geometry out of Rhino models.

use std::sync::Arc;

use katydid_component::{Context, Message, RhinoModel, component};
use katydid_data::Geometry;

use crate::params::wildcard::Wildcard;

fn import(context: &Context<'_>, file: &str, layer: &str, name: &str) -> Result<Vec<Geometry>, Message> {
    let (layers, names) = (Wildcard::new(layer)?, Wildcard::new(name)?);
    let bytes = context.read_file(file)?;
    let model = RhinoModel::read(&bytes)
        .map_err(|error| Message::error(format!("{file} cannot be read: {error}")))?;
    let mut geometry = Vec::new();
    let mut unknown = 0;
    for object in model.objects() {
        if layers.takes_layer(&object.layer) && names.takes(&object.name) {
            match &object.geometry {
                Some(value) => geometry.push(Geometry(value.clone())),
                None => unknown += 1,
            }
        }
    }
    if unknown > 0 {
        context.warn(format!("{unknown} objects of the model are of kinds that cannot be used yet"));
    }
    context.items(geometry.len())?;
    Ok(geometry)
}

/// Reads the geometry of a Rhino model (.3dm), in the units of the model.
///
/// Filters pick objects by layer and name: `*` stands for any text, `?` for one character. A placed block is one object.
#[component("317f1cb2-820d-4a8f-b5c8-5de3594ddfba", name = "Import 3DM", nick = "3DM", at = "Params/Input")]
#[output("Geometry", "G", "The geometry, in the order of the file.")]
fn import_3dm(
    context: &Context<'_>,
    /// The path of the model; one that is not absolute starts where the definition lies.
    #[port("File", "F")]
    file: Arc<str>,
    /// Which layers to read, by name or by path (`Outer::Inner`).
    #[port("Layer", "L", default = "*")]
    layer: Arc<str>,
    /// Which objects to read, by name.
    #[port("Name", "N", default = "*")]
    name: Arc<str>,
) -> Result<Vec<Geometry>, Message> {
    import(context, &file, &layer, &name)
}

/// Reads the geometry of a Rhino model. An early form of Import 3DM.
#[component(
    "f055c5d7-5d97-4964-90c7-8e9eee9a8a39",
    name = "Import 3DM [OBSOLETE]",
    nick = "3DM",
    at = "Params/Input",
    old
)]
#[output("Geometry", "G", "The geometry, in the order of the file.")]
fn early_import_3dm(
    context: &Context<'_>,
    /// The path of the model; one that is not absolute starts where the definition lies.
    #[port("File", "F")]
    file: Arc<str>,
    /// Which layers to read, by name or by path.
    #[port("Layer", "L", default = "*")]
    layer: Arc<str>,
    /// Which objects to read, by name.
    #[port("Name", "N", default = "*")]
    name: Arc<str>,
) -> Result<Vec<Geometry>, Message> {
    import(context, &file, &layer, &name)
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
    use katydid_component::{Files, testing::Trial};
    use katydid_geometry::Point3;

    #[test]
    fn objects_are_picked_by_layer_and_name() {
        let layers = vec![Layer::new("Walls"), Layer::new("Roof")];
        let mut model = Model { layers, ..Model::default() };
        for (x, layer, name) in [(1.0, 0, "north"), (2.0, 1, "north"), (3.0, 1, "south")] {
            let attributes =
                Attributes { layer: Some(layer), name: name.to_owned(), ..Attributes::default() };
            let geometry = Object::Point(Point3::new(x, 0.0, 0.0));
            model.objects.push(ModelObject { attributes, ..geometry.into() });
        }
        let folder = std::env::temp_dir().join(format!("katydid-model-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("m.3dm"), model.write(70).unwrap()).unwrap();
        std::fs::write(folder.join("bad.3dm"), "no model").unwrap();
        let import = |name: &str| Trial::of(name).files(Files::Inside(folder.clone())).item("m.3dm");
        assert_eq!(import("Import 3DM").texts(0), ["{0;0}: {1, 0, 0}, {2, 0, 0}, {3, 0, 0}"]);
        assert_eq!(import("Import 3DM").item("roof").texts(0), ["{0;0}: {2, 0, 0}, {3, 0, 0}"]);
        assert_eq!(
            import("Import 3DM [OBSOLETE]").item("*").item("n?rth").texts(0),
            ["{0;0}: {1, 0, 0}, {2, 0, 0}"]
        );
        let bad = Trial::of("Import 3DM").files(Files::Inside(folder.clone())).item("bad.3dm").message();
        assert!(bad.starts_with("bad.3dm cannot be read"), "{bad}");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
