//! Type hints of a script's inputs: their names, and the ids by which files keep them.

use katydid_definition::document::{Port, ids};
use uuid::{Uuid, uuid};

/// Hints that the components of Rhino 8 and of before share.
const COMMON: [(&str, Uuid); 15] = [
    ("int", uuid!("48d01794-d3d8-4aef-990e-127168822244")),
    ("bool", uuid!("d60527f5-b5af-4ef6-8970-5f96fe412559")),
    ("Point3d", uuid!("e1937b56-b1da-4c12-8bd8-e34ee81746ef")),
    ("Vector3d", uuid!("15a50725-e3d3-4075-9f7c-142ba5f40747")),
    ("Plane", uuid!("3897522d-58e9-4d60-b38c-978ddacfedd8")),
    ("Line", uuid!("f802a8cd-e699-4a94-97ea-83b5406271de")),
    ("Circle", uuid!("3c5409a1-3293-4181-a6fa-c24c37fc0c32")),
    ("Curve", uuid!("9ba89ec2-5315-435f-a621-b66c5fa2f301")),
    ("Surface", uuid!("f4070a37-c822-410f-9057-100d2e22a22d")),
    ("Brep", uuid!("2ceb0405-fdfe-403d-a4d6-8786da45fb9d")),
    ("Mesh", uuid!("794a1f9d-21d5-4379-b987-9e8bbf433912")),
    ("PointCloud", uuid!("d73c9fb0-365d-458f-9fb5-f4141399311f")),
    ("GeometryBase", uuid!("c37956f4-d39c-49c7-af71-1e87f8031b26")),
    ("Color", uuid!("24b1d1a3-ab79-498c-9e44-c5b14607c4d3")),
    ("Guid", uuid!("5325b8e1-51d7-4d36-837a-d98394626c35")),
];
/// What GhPython calls its own.
const GH_PYTHON: [(&str, Uuid); 4] = [
    ("none", uuid!("35915213-5534-4277-81b8-1bdc9e7383d2")),
    ("ghdoc", uuid!("87f87f55-5b71-41f4-8aea-21d494016f81")),
    ("str", uuid!("37261734-eec7-4f50-b6a8-b8d1f3c4396b")),
    ("float", uuid!("39fbc626-7a01-46ab-a18e-ec1c0c41685b")),
];
/// C# and VB of Grasshopper 1.
const DOT_NET: [(&str, Uuid); 3] = [
    ("object", uuid!("6a184b65-baa3-42d1-a548-3915b401de53")),
    ("str", uuid!("9e93878a-f9c5-4f0a-8a70-584bf09f24bb")),
    ("float", uuid!("19ff81a2-dc4f-4035-8de9-26224c561321")),
];
/// C# of Rhino 8.
const RHINO_8_C_SHARP: [(&str, Uuid); 3] = [
    ("object", uuid!("6a184b65-baa3-42d1-a548-3915b401de53")),
    ("str", uuid!("3aceb454-6dbd-4c5b-9b6b-e71f8c1cdf88")),
    ("float", uuid!("19ff81a2-dc4f-4035-8de9-26224c561321")),
];
/// The other script components of Rhino 8.
const RHINO_8: [(&str, Uuid); 3] = [
    ("object", uuid!("1c282eeb-dd16-439f-94e4-7d92b542fe8b")),
    ("str", uuid!("3aceb454-6dbd-4c5b-9b6b-e71f8c1cdf88")),
    ("float", uuid!("9d51e32e-c038-4352-9554-f4137ca91b9a")),
];

/// The hints that are particular to a script component.
fn particular(component: Uuid) -> &'static [(&'static str, Uuid)] {
    match component {
        ids::GH_PYTHON => &GH_PYTHON,
        ids::C_SHARP | ids::VB | ids::OLD_C_SHARP | ids::OLD_VB => &DOT_NET,
        ids::RHINO_8_C_SHARP => &RHINO_8_C_SHARP,
        _ => &RHINO_8,
    }
}

/// The names of the hints that inputs of a script component can have.
pub(crate) fn names(component: Uuid) -> Vec<String> {
    particular(component).iter().chain(&COMMON).map(|(name, _)| (*name).to_owned()).collect()
}

/// The id of a hint by its name.
pub(crate) fn id(component: Uuid, name: &str) -> Option<Uuid> {
    particular(component).iter().chain(&COMMON).find(|(own, _)| *own == name).map(|(_, id)| *id)
}

/// The name of an input's hint; none where it has none, or one that is not known. The first digits of the ids tell the
/// known ones apart.
pub(crate) fn name(port: &Port) -> Option<&'static str> {
    let digits = port.type_hint?.as_fields().0;
    let all = [&GH_PYTHON[..], &DOT_NET, &RHINO_8_C_SHARP, &RHINO_8, &COMMON];
    all.into_iter().flatten().find(|(_, id)| id.as_fields().0 == digits).map(|(name, _)| *name)
}
