//! Components of our own that answer to the objects of plug-ins in files: a folder a plug-in, a function a component.
//!
//! Names, ports and ids are facts from files and from public lists of components. What each computes is our own work from
//! papers, talks and documentation; where nothing tells, the help says that it is our reading. A plug-in whose ids no file at
//! hand shows is told by its name and those of its components ([`katydid_component::stand_in`]).

#![allow(
    clippy::neg_cmp_op_on_partial_ord,
    clippy::type_complexity,
    clippy::too_many_arguments,
    reason = "!(x > limit) refuses a NaN with the too small; a component's signature spells out its ports"
)]

mod anemone;
mod annotations;
mod bison;
mod bitmap_plus;
mod blocks;
mod branches;
mod color_plus;
mod dendro;
mod docofossor;
mod editree;
mod elefront;
mod ghowl;
mod heteroptera;
mod hoopsnake;
mod human;
mod jswan;
mod kangaroo;
mod kept;
mod lunchbox;
mod mesh_edit;
mod model_objects;
mod noise;
mod polygons;
mod pufferfish;
mod tables;
mod telepathy;
mod treefrog;
mod treesloth;
mod voxel_tools;
mod weaverbird;
mod wildcard;

use katydid_component::Plugin;

/// A plug-in with its author.
macro_rules! plugins {
    ($($name:literal by $author:literal as $library:literal;)*) => {
        $(katydid_component::parts::inventory::submit! {
            Plugin { name: $name, author: $author, library: $library, only_notes: false }
        })*
    };
}

plugins! {
    "Anemone" by "Mateusz Zwierzycki" as "anemone";
    "Bison" by "bison.la" as "bison";
    "BitmapPlus" by "David Mans" as "bitmapplus";
    "ColorPlus" by "David Mans" as "colorplus";
    "Dendro" by "ecr labs" as "dendro";
    "Docofossor" by "Mathias Bernhard, Ilmar Hurkxkens" as "docofossor";
    "EdiTree" by "John Ju Hyung Chun" as "editree";
    "EleFront" by "Ramon van der Heijden, Alan Tai" as "elefront";
    "gHowl" by "Luis Fraguada, Damien Alomar, Giulio Piacentino" as "ghowl";
    "Heteroptera" by "Amin Bahrami" as "heteroptera";
    "HoopSnake" by "Yannis Chatzikonstantinou" as "hoopsnake";
    "Human" by "Andrew Heumann" as "human";
    "jSwan" by "Andrew Heumann" as "jswan";
    "Kangaroo2" by "Daniel Piker" as "kangaroo2";
    // The elder one, whose components stand in the same tab.
    "Kangaroo2" by "Daniel Piker" as "kangaroo";
    "LunchBox" by "Proving Ground" as "lunchbox";
    "MeshEdit" by "[uto]" as "meshedit";
    "Noise4D" by "unknown" as "noise4d";
    "Noise4D" by "unknown" as "4dnoise";
    "Pufferfish" by "Michael Pryor" as "pufferfish";
    "Telepathy" by "Andrew Heumann" as "telepathy";
    "TreeFrog" by "Andrew Heumann" as "treefrog";
    // Earlier versions of Human have the same components.
    "TreeFrog" by "Andrew Heumann" as "human";
    "TreeSloth" by "David Stasiuk" as "treesloth";
    "VoxelTools" by "Arend van Waart" as "voxeltools";
    "Weaverbird" by "Giulio Piacentino" as "weaverbird";
}

// Its objects write names beside others on the canvas, and compute nothing.
katydid_component::parts::inventory::submit! {
    Plugin { name: "Bifocals", author: "Andrew Heumann", library: "bifocals", only_notes: true }
}

/// Makes sure that these components are linked into the program, and tells how many plug-ins they stand for.
///
/// ```
/// assert!(katydid_components_more::link() > 1);
/// ```
pub fn link() -> usize {
    katydid_component::plugins().count()
}

#[cfg(test)]
mod tests {
    use katydid_component::parts::Uuid;
    use katydid_component::{registry, stand_in};
    use katydid_data::{Tree, Value};

    /// An id that nobody has.
    const STRANGE: Uuid = Uuid::from_u128(0x7357);

    #[test]
    fn objects_are_found_by_names() {
        let inputs = [("Level", "L"), ("Mesh/Curves", "M"), ("Smooth Naked Edges", "S")];
        let outputs = [("Output Mesh/Curves", "O")];
        let find = |library, name| stand_in(STRANGE, library, name, &inputs, &outputs);
        let found = find(Some("Weaverbird.Gh"), "Weaverbird's Catmull-Clark Subdivision").unwrap();
        assert_eq!(found.component.name, "Catmull-Clark Subdivision");
        // The ports stand in another order in the file.
        assert_eq!([0, 1, 2].map(|k| found.input_place(k)), [Some(1), Some(0), Some(2)]);
        let level = Tree::item(Value::Integer(3));
        let arranged = found.arranged(vec![level.clone(), Tree::empty()]);
        assert_eq!(arranged[1], level);
        assert_eq!(arranged.len(), 3);
        assert!(find(Some("Weaverbird"), "wbCatmullClark").is_some());
        assert!(find(Some("Weaverbird"), "Number").is_none());
        assert!(find(Some("Some Library"), "Catmull-Clark Subdivision").is_none());
        assert!(find(None, "Catmull-Clark Subdivision").is_none());
    }

    #[test]
    fn human_has_the_components_that_went_on_as_treefrog() {
        for name in ["Assign Paths", "Graft By Data", "Match Paths", "Path Description"] {
            for library in ["Human", "TreeFrog"] {
                let found = stand_in(STRANGE, Some(library), name, &[], &[]).unwrap();
                assert_eq!((found.component.name, found.component.tab), (name, "TreeFrog"), "{library}");
            }
        }
        let of = |library: &str, name: &str| stand_in(STRANGE, Some(library), name, &[], &[]);
        assert_eq!(of("Human", "Layer Table").unwrap().component.tab, "Human");
        assert!(of("TreeFrog", "Layer Table").is_none());
    }

    #[test]
    fn inputs_of_any_number_may_stand_before_others() {
        let inputs = [("Data", "L0"), ("Data", "L1"), ("Cull Pattern", "P"), ("Data", "L2")];
        let outputs = [("Data", "L0"), ("Data", "L1"), ("Data", "L2")];
        let found = stand_in(STRANGE, Some("TreeSloth"), "Cull Multiple", &inputs, &outputs).unwrap();
        assert_eq!([0, 1, 2, 3].map(|k| found.input_place(k)), [Some(1), Some(2), Some(0), Some(3)]);
        assert_eq!([0, 1, 2].map(|k| found.output_place(k)), [Some(0), Some(1), Some(2)]);
    }

    #[test]
    fn of_versions_the_one_with_the_same_ports_is_found() {
        let inputs: Vec<(&str, &str)> =
            ["GoalObjects", "Points", "Reset", "Restart", "Parallel", "Threshold", "On"]
                .map(|name| (name, name))
                .to_vec();
        let found = stand_in(STRANGE, Some("Kangaroo2 Components"), "Solver", &inputs, &[]).unwrap();
        assert_eq!(found.component.inputs.len(), 9);
        let known = registry::by_guid(found.component.guid).unwrap();
        assert_eq!(known.name, "Solver");
    }

    #[test]
    fn no_two_components_have_one_id() {
        let mut known = std::collections::HashMap::new();
        for component in registry::all() {
            let ids = [component.guid].into_iter().chain(component.also.iter().copied());
            for id in ids {
                let other = known.insert(id, component.name);
                assert_eq!(other, None, "{} has the id {id}, too", component.name);
            }
        }
    }

    #[test]
    fn every_component_says_whose_it_stands_for() {
        let mut count = 0;
        for component in registry::all() {
            assert!(katydid_component::plugin_of_tab(component.tab).is_some(), "{}", component.name);
            let help: Vec<&str> = component.help.split_whitespace().collect();
            assert!(help.join(" ").contains("Stands for"), "{}", component.name);
            count += 1;
        }
        assert!(count > 120, "{count}");
    }
}
