//! Components of Grasshopper that are known by name and are not here, each with its reason.
//!
//! `katydid check` and the message on such an object say the reason; a test keeps the list whole.

use katydid_component::registry::Unsupported;
use uuid::{Uuid, uuid};

const fn row(guid: Uuid, name: &'static str, reason: &'static str) -> Unsupported {
    Unsupported { guid, name, reason }
}

katydid_component::parts::inventory::submit! { Unsupported::list(&LIST) }

static LIST: [Unsupported; 8] = [
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
];
