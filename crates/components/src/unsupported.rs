//! Components of Grasshopper that are known by name and are not here, each with its reason.
//!
//! `katydid check` and the message on such an object say the reason; a test keeps the list whole.

use katydid_component::registry::Unsupported;
use uuid::{Uuid, uuid};

const fn row(guid: Uuid, name: &'static str, reason: &'static str) -> Unsupported {
    Unsupported { guid, name, reason }
}

katydid_component::parts::inventory::submit! { Unsupported::list(&LIST) }

static LIST: [Unsupported; 26] = [
    row(
        uuid!("51a2ede9-8f8c-4fdf-a375-999c2062eab7"),
        "Colour Wheel",
        "how its palettes follow from the stored dials is not known",
    ),
    row(
        uuid!("f08233f1-9772-4514-8965-bde4948503df"),
        "Freeform Cloud",
        "how its points lie inside their guides is not known",
    ),
    row(
        uuid!("03b3db66-d7e8-4d2d-bc0c-122913317254"),
        "Sanity XForm",
        "it is a joke that bends geometry at random",
    ),
    row(
        uuid!("b341e2e5-c4b3-49a3-b3a4-b4e6e2054516"),
        "Geometry Pipeline",
        "it looks into the open Rhino model, and there is none here",
    ),
    row(
        uuid!("bc26bf46-e81b-429a-b168-16d50cc89bd7"),
        "Coordinate Mask",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("bc6c097c-6cc2-479c-b5aa-af99fbb72b88"),
        "Expression",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("8ce6a747-6d36-4bd4-8af0-9a1081df417d"),
        "Grid Hexagonal [OBSOLETE]",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("216bccd8-bf29-4d3c-b791-54c89a180db3"),
        "Image Resource",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("4018985c-f9e8-4a8f-8d4d-518aec276f60"),
        "Marshalling signal parameter",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("33eb59b9-5f81-4ef5-8c89-46e6e744522b"),
        "Timeline",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("84fa917c-1ed8-4db3-8be1-7bdc4a6495a2"),
        "Variable",
        "no file at hand shows what it stores or does",
    ),
    row(
        uuid!("410755b1-224a-4c1e-a407-bf32fb45ea7e"),
        "GhPython Script",
        "scripts are kept, but not run yet",
    ),
    row(
        uuid!("ceab6e56-ceec-a646-84d5-363c57440969"),
        "GhPython Script",
        "scripts are kept, but not run yet",
    ),
    row(
        uuid!("d8033e3f-8387-4ffc-ab99-929218e8c740"),
        "Data Input",
        "the layout of .ghdata files is not known",
    ),
    row(
        uuid!("28504f1f-a8d9-40c8-b8aa-529413456258"),
        "Text On Surface",
        "the outlines of the fonts that it uses are not at hand",
    ),
    row(
        uuid!("a9a8ebd2-fff5-4c44-a8f5-739736d129ba"),
        "C# Script",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(
        uuid!("f5e3456b-dcfc-4faa-ac4e-7804cb75ee6d"),
        "C# Script",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(
        uuid!("88c3f2b5-27f7-48a2-9528-1397fad62b93"),
        "DotNET C# Script (LEGACY)",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(
        uuid!("fb6aba99-fead-4e42-b5d8-c6de5ff90ea6"),
        "DotNET VB Script (LEGACY)",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(
        uuid!("079bd9bd-54a0-41d4-98af-db999015f63d"),
        "VB Script",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(
        uuid!("1e9e08fc-c31e-49eb-a36c-90de5e62e5f5"),
        "VB Script",
        "the script is kept, but it needs the .NET runtime",
    ),
    row(uuid!("aa538b89-3df8-436f-9ae4-bc44525984de"), "Import SHP", "there is no reader of shapefiles yet"),
    row(
        uuid!("a80395af-f134-4d6a-9b89-15edf3161619"),
        "Atom",
        "there is no value for atoms, and no reader of PDB files",
    ),
    row(
        uuid!("7b371d04-53e3-47d8-b3dd-7b113c48bc59"),
        "Atom Data",
        "there is no value for atoms, and no reader of PDB files",
    ),
    row(
        uuid!("383929c0-6515-4899-8b4b-3bd0d0b32471"),
        "Import PDB",
        "there is no value for atoms, and no reader of PDB files",
    ),
    row(
        uuid!("e5ff52c5-40df-4f43-ac3b-d2418d05ae32"),
        "Construct Exotic Date",
        "under what name a file stores its calendar is not known",
    ),
];
