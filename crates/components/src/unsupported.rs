//! Components of Grasshopper that are known by name and are not here, each with its reason.
//!
//! `katydid check` and the message on such an object say the reason; a test keeps the list whole.

use katydid_component::registry::Unsupported;
use uuid::{Uuid, uuid};

const fn row(guid: Uuid, name: &'static str, reason: &'static str) -> Unsupported {
    Unsupported { guid, name, reason }
}

katydid_component::parts::inventory::submit! { Unsupported::list(&LIST) }

static LIST: [Unsupported; 18] = [
    row(
        uuid!("410755b1-224a-4c1e-a407-bf32fb45ea7e"),
        "GhPython Script",
        "it runs in definitions that hold it, where scripts are allowed; new ones are not made yet",
    ),
    row(
        uuid!("ceab6e56-ceec-a646-84d5-363c57440969"),
        "GhPython Script",
        "it runs in definitions that hold it, where scripts are allowed; new ones are not made yet",
    ),
    row(
        uuid!("a9a8ebd2-fff5-4c44-a8f5-739736d129ba"),
        "C# Script",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("f5e3456b-dcfc-4faa-ac4e-7804cb75ee6d"),
        "C# Script",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("88c3f2b5-27f7-48a2-9528-1397fad62b93"),
        "DotNET C# Script (LEGACY)",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("fb6aba99-fead-4e42-b5d8-c6de5ff90ea6"),
        "DotNET VB Script (LEGACY)",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("079bd9bd-54a0-41d4-98af-db999015f63d"),
        "VB Script",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("1e9e08fc-c31e-49eb-a36c-90de5e62e5f5"),
        "VB Script",
        "it runs in definitions that hold it; new ones are not made yet",
    ),
    row(
        uuid!("b57bf805-046a-4360-ad76-51aeddfe9720"),
        "Boundary Volume",
        "solids are not cut by one another yet",
    ),
    row(uuid!("2d3b6ef3-5c26-4e2f-bcb3-8ffb9fb0f7c3"), "Box Slits", "solids are not cut by one another yet"),
    row(
        uuid!("fab11c30-2d9c-4d15-ab3c-2289f1ae5c21"),
        "Solid Difference",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("5723c845-cafc-442d-a667-8c76532845e6"),
        "Solid Intersection",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("10434a15-da85-4281-bb64-a2b3a995b9c6"),
        "Solid Union",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("4bdc2eb0-24ed-4c90-a27b-a32db069eaef"),
        "Split with Brep",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("5b742537-9bcb-4f06-9613-866da5bf845e"),
        "Split with Breps",
        "solids are not cut by one another yet",
    ),
    row(uuid!("f0b70e8e-7337-4ce4-a7bb-317fc971f918"), "Trim Solid", "solids are not cut by one another yet"),
    row(
        uuid!("3eba04bc-00e8-416d-b58f-a3dc8b3e22e2"),
        "Trim with Brep",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("916e7ebc-524c-47ce-8936-e50a09a7b43c"),
        "Trim with Breps",
        "solids are not cut by one another yet",
    ),
];
