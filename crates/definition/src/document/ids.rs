//! The component GUIDs that the document itself has to know.

use uuid::{Uuid, uuid};

/// A frame around objects.
pub const GROUP: Uuid = uuid!("c552a431-af5b-46a9-a8a4-0fcbc27ef596");
/// A text on the canvas.
pub const SCRIBBLE: Uuid = uuid!("7f5c6c55-f846-4a08-9c9a-cfdc285cc6fe");
/// Lines drawn on the canvas.
pub const SKETCH: Uuid = uuid!("2844fec5-142d-4381-bd5d-4cbcef6d6fed");

/// Number Slider.
pub const NUMBER_SLIDER: Uuid = uuid!("57da07bd-ecab-415d-9d86-af36d7073abc");
/// Panel.
pub const PANEL: Uuid = uuid!("59e0b89a-e487-49f8-bab8-b5bab16be14c");
/// Boolean Toggle.
pub const BOOLEAN_TOGGLE: Uuid = uuid!("2e78987b-9dfb-42a2-8b76-3923ac8bd91a");
/// The later Boolean Toggle.
pub const BOOLEAN_TOGGLE_2: Uuid = uuid!("ad483f40-dc72-40dc-844d-c9e462c7d19f");
/// Button.
pub const BUTTON: Uuid = uuid!("a8b97322-2d53-47cd-905e-b932c3ccd74e");
/// Colour Swatch.
pub const COLOUR_SWATCH: Uuid = uuid!("9c53bac0-ba66-40bd-8154-ce9829b9db1a");
/// Colour Picker.
pub const COLOUR_PICKER: Uuid = uuid!("339c0ee1-cf11-444f-8e10-65c9150ea755");
/// Value List.
pub const VALUE_LIST: Uuid = uuid!("00027467-0d24-4fa7-b178-8dc0ac5f42ec");
/// MD Slider.
pub const MD_SLIDER: Uuid = uuid!("318dacd7-9073-4ede-b043-a0c132eb77e0");
/// Control Knob.
pub const CONTROL_KNOB: Uuid = uuid!("bcac2747-348b-4edd-ae1f-77a782cebbdd");
/// Digit Scroller.
pub const DIGIT_SCROLLER: Uuid = uuid!("33bcf975-a0b2-4b54-99fd-585c893b9e88");
/// Calendar.
pub const CALENDAR: Uuid = uuid!("ab898d46-b8b3-4ed5-b28f-4f8047920262");
/// Clock.
pub const CLOCK: Uuid = uuid!("f8a94819-1e2b-4d67-9100-9e983ac493cc");
/// Gene Pool.
pub const GENE_POOL: Uuid = uuid!("21553c44-ea62-475e-a8bb-62b2a3ee5ca5");
/// Graph Mapper.
pub const GRAPH_MAPPER: Uuid = uuid!("bc984576-7aa6-491f-a91d-e444c33675a7");
/// Gradient.
pub const GRADIENT: Uuid = uuid!("6da9f120-3ad0-4b6e-9fe0-f8cde3a649b7");
/// Relay.
pub const RELAY: Uuid = uuid!("b6236720-8d88-4289-93c3-ac4c99f9b97b");
/// Path Mapper.
pub const PATH_MAPPER: Uuid = uuid!("f9b89a46-bc5d-4f7a-9a6f-134f93ac3af9");
/// Param Viewer.
pub const PARAM_VIEWER: Uuid = uuid!("72a29b54-2e48-474b-a400-d2124c4edf79");
/// Data Dam.
pub const DATA_DAM: Uuid = uuid!("65283518-ad00-49d3-87fb-f76823ebb162");
/// Data Recorder.
pub const DATA_RECORDER: Uuid = uuid!("401aa475-997a-4139-991d-f980ffdcf908");
/// Value Tracker.
pub const VALUE_TRACKER: Uuid = uuid!("615367b4-c9d0-4cb7-986c-cb861226136f");
/// Quick Graph.
pub const QUICK_GRAPH: Uuid = uuid!("2b69bf71-4e69-43aa-b7be-4f6ce7e45bef");
/// Bar Graph.
pub const BAR_GRAPH: Uuid = uuid!("e1905a16-da43-4705-bd65-41d34328c4e6");
/// Pie Chart.
pub const PIE_CHART: Uuid = uuid!("952c2bcc-b5ec-480a-a0d7-27f016632e33");
/// Image Gallery.
pub const IMAGE_GALLERY: Uuid = uuid!("54ab3f01-a769-4742-a7bf-cec48a1acb6f");
/// Cherry Picker.
pub const CHERRY_PICKER: Uuid = uuid!("0ab6acbf-40a6-40e1-a14e-cf0c06268e68");
/// Image Sampler.
pub const IMAGE_SAMPLER: Uuid = uuid!("d69a3494-785b-4beb-969b-d2373f65abfd");
/// Geometry Pipeline.
pub const GEOMETRY_PIPELINE: Uuid = uuid!("b341e2e5-c4b3-49a3-b3a4-b4e6e2054516");
/// Expression, with variable inputs.
pub const EXPRESSION: Uuid = uuid!("9df5e896-552d-4c8c-b9ca-4fc147ffa022");
/// Kangaroo 2's Grab, in its versions.
pub const GRABS: [Uuid; 4] = [
    uuid!("ea145d1d-7727-4d52-8db6-c9b7100ab7f9"),
    uuid!("4c90aad1-0748-4800-99db-a27d690bb1e1"),
    uuid!("4c53ba00-f4bd-4ede-8d26-55106278268d"),
    uuid!("3d13a415-6ac5-4b59-9677-3975e4696a85"),
];
/// Trigger, once called Timer.
pub const TRIGGER: Uuid = uuid!("5a2b0735-ba98-4b7d-a7d3-c1dfc04475ad");
/// Galapagos.
pub const GALAPAGOS: Uuid = uuid!("e6dd2904-14bc-455b-8376-948bf2e3a7bc");

/// Cluster.
pub const CLUSTER: Uuid = uuid!("f31d8d7a-7536-4ac8-9c96-fde6ecda4d0a");
/// Where data enters a cluster.
pub const CLUSTER_INPUT: Uuid = uuid!("448de216-3a12-43cf-a135-e3bfafc87744");
/// Where data leaves a cluster.
pub const CLUSTER_OUTPUT: Uuid = uuid!("a4b285fe-2e13-4204-b65c-189aa6704da5");

/// Context Bake: geometry to be baked at the end of a run.
pub const CONTEXT_BAKE: Uuid = uuid!("ae2531b4-bab2-4bb1-b5bf-f2143d10c132");
/// Context Print: text to be printed at the end of a run.
pub const CONTEXT_PRINT: Uuid = uuid!("73215ec5-0eb5-4f85-9e07-b09c4590ce2b");

/// The Data parameter, which takes everything.
pub const DATA: Uuid = uuid!("8ec86459-bf01-4409-baee-174d0d2b13d0");
/// The Geometry parameter, which takes every geometry.
pub const GEOMETRY: Uuid = uuid!("ac2bc2cb-70fb-4dd5-9c78-7e1ea97fe278");

/// GhPython of Rhino 6 and 7.
pub const GH_PYTHON: Uuid = uuid!("410755b1-224a-4c1e-a407-bf32fb45ea7e");
/// C# of Grasshopper 1.
pub const C_SHARP: Uuid = uuid!("a9a8ebd2-fff5-4c44-a8f5-739736d129ba");
/// VB of Grasshopper 1.
pub const VB: Uuid = uuid!("079bd9bd-54a0-41d4-98af-db999015f63d");
/// C# of Grasshopper 0.8.
pub const OLD_C_SHARP: Uuid = uuid!("f5e3456b-dcfc-4faa-ac4e-7804cb75ee6d");
/// VB of Grasshopper 0.8.
pub const OLD_VB: Uuid = uuid!("1e9e08fc-c31e-49eb-a36c-90de5e62e5f5");
/// C# of Rhino 8.
pub const RHINO_8_C_SHARP: Uuid = uuid!("b6ba1144-02d6-4a2d-b53c-ec62e290eeb7");
/// Python 3 of Rhino 8.
pub const RHINO_8_PYTHON: Uuid = uuid!("719467e6-7cf5-4848-99b0-c5dd57e5442c");
/// IronPython of Rhino 8.
pub const RHINO_8_IRON_PYTHON: Uuid = uuid!("97aa26ef-88ae-4ba6-98a6-ed6ddeca11d1");
/// Script of Rhino 8, in any language.
pub const RHINO_8_SCRIPT: Uuid = uuid!("c9b2d725-6f87-4b07-af90-bd9aefef68eb");

/// Whether parameters of this type take values of several types, so that stored values say theirs.
pub(super) fn takes_several(type_id: Uuid) -> bool {
    [DATA, GEOMETRY].contains(&type_id)
}

/// Loop Start of the plug-in Anemone. No file at hand shows the ids of the plug-in's own components: these are ours.
pub const LOOP_START: Uuid = uuid!("a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e01");
/// Loop End.
pub const LOOP_END: Uuid = uuid!("a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e02");
/// Fast Loop Start.
pub const FAST_LOOP_START: Uuid = uuid!("a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e03");
/// Fast Loop End.
pub const FAST_LOOP_END: Uuid = uuid!("a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e04");
/// HoopSnake of the plug-in of that name; the id is ours too.
pub const HOOP_SNAKE: Uuid = uuid!("a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e05");
