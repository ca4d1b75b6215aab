//! Components of Grasshopper that are known by name and are not here, each with its reason.
//!
//! `katydid check` and the message on such an object say the reason; a test keeps the list whole.

use katydid_component::registry::Unsupported;
use uuid::{Uuid, uuid};

const fn row(guid: Uuid, name: &'static str, reason: &'static str) -> Unsupported {
    Unsupported { guid, name, reason }
}

katydid_component::parts::inventory::submit! { Unsupported::list(&LIST) }

static LIST: [Unsupported; 53] = [
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
    row(
        uuid!("f3c769fd-aa9b-4695-a1ce-3ad4c53d1440"),
        "Test Crash",
        "all it does is to make Grasshopper fail",
    ),
    row(
        uuid!("e1905a16-da43-4705-bd65-41d34328c4e6"),
        "Bar Graph",
        "it draws on the canvas only, and how is not known",
    ),
    row(
        uuid!("54ab3f01-a769-4742-a7bf-cec48a1acb6f"),
        "Image Gallery",
        "it draws on the canvas only, and how is not known",
    ),
    row(
        uuid!("952c2bcc-b5ec-480a-a0d7-27f016632e33"),
        "Pie Chart",
        "it draws on the canvas only, and how is not known",
    ),
    row(
        uuid!("615367b4-c9d0-4cb7-986c-cb861226136f"),
        "Value Tracker",
        "it draws on the canvas only, and how is not known",
    ),
    row(
        uuid!("b78d95bc-dffb-414c-b177-c611c92580b9"),
        "Viewport Display",
        "it shows a viewport on the canvas",
    ),
    row(
        uuid!("b57bf805-046a-4360-ad76-51aeddfe9720"),
        "Boundary Volume",
        "solids are not cut by one another yet",
    ),
    row(uuid!("2d3b6ef3-5c26-4e2f-bcb3-8ffb9fb0f7c3"), "Box Slits", "solids are not cut by one another yet"),
    row(
        uuid!("904e4b56-484a-4814-b35f-aa4baf362117"),
        "Brep | Brep",
        "solids are not cut by one another yet",
    ),
    row(
        uuid!("0feeeaca-8f1f-4d7c-a24a-8e7dd68604a2"),
        "Region Slits",
        "which of two crossing regions is slit from which side, and in what order, is not known",
    ),
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
    row(uuid!("ef6b26f4-f820-48d6-b0c5-85898ef8888b"), "Split Brep", "solids are not cut by one another yet"),
    row(
        uuid!("03f22640-ff80-484e-bb53-a4025c5faa07"),
        "Split Brep Multiple",
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
    row(
        uuid!("1a17d3f0-c8f8-4ee9-8dab-ea1c29db6a49"),
        "Quad Remesh",
        "there is no remeshing with quads that follow the curvature yet",
    ),
    row(
        uuid!("f562505b-4c49-49d1-932d-c8804b3fcec6"),
        "Quad Remesh Settings",
        "there is no remeshing with quads that follow the curvature yet",
    ),
    row(
        uuid!("b7cbe6eb-0608-4038-88e0-50495a559a41"),
        "Quadmesh Settings",
        "there is no remeshing with quads that follow the curvature yet",
    ),
    row(
        uuid!("07a3b2a0-c4d0-4638-9044-39ac4681e782"),
        "Mesh Depth",
        "along which direction depth is measured, and when it is valid, is not known",
    ),
    row(
        uuid!("c9b4ad52-1e01-4317-bbde-3ababcc31bea"),
        "Leader",
        "annotations are kept whole, but not made or taken apart yet",
    ),
    row(
        uuid!("a8da9901-f5fb-49ec-9cd1-dfa7b788263e"),
        "Loft Options",
        "no file at hand shows what it stores on the canvas; the component of the same name has all options",
    ),
    row(
        uuid!("1fae4c7a-d84a-4f04-8400-179e13193381"),
        "Content Cache",
        "it changes the document that is open beside Grasshopper, and there is none",
    ),
    row(
        uuid!("d2a31d0a-8a1c-4ffb-b3c7-96931fee6c34"),
        "PersistentValues",
        "no file at hand shows what it stores or does",
    ),
];
